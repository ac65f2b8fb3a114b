//! A graph compiled for an engine.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, OnceLock, Weak};
use std::time::Instant;

use crate::effects::{EffectSet, Renderer};
use crate::graph::{BindError, Graph, Root, RootKind};
use crate::schedule::{Schedule, schedule};
use crate::specialise::{
    Account, InstanceKind, SpecialiseError, Specialised, Uniforms, expand_asking,
};
use crate::state::{FieldSet, RayType, State};
use crate::values::{Literal, Texture};

use super::evaluations::Evaluations;
use super::execute::{Program, UniformWords, WordsId};
use super::jit::{Generator, JitError, Pieces, Plan, worker};
use super::links::{FirstLinks, Links};
use super::memory::with_memory;
use super::options::{Engine, Options};
use super::runner::Runner;
use super::shade::{Shade, Shaded};
use super::walk;

/// Why a graph could not be compiled, or a parameter not be set.
#[derive(Debug, thiserror::Error)]
pub enum ShaderError {
    /// See [`SpecialiseError`].
    #[error(transparent)]
    Specialise(#[from] SpecialiseError),
    /// The jit was asked for and cannot run here.
    #[error(transparent)]
    Jit(#[from] JitError),
    /// The value does not suit the parameter, or there is none of that name.
    #[error(transparent)]
    Bind(#[from] BindError),
}

/// A graph compiled for an engine, with values for its parameters.
#[derive(Debug)]
pub struct Shader {
    graph: Arc<Graph>,
    values: Vec<Literal>,
    options: Options,
    /// Who makes the machine code, if there is to be any.
    generator: Option<Generator>,
    programs: Vec<Compiled>,
    /// Nanoseconds it took to compile, the jit of `auto` aside.
    compile_nanoseconds: AtomicU64,
    counts: Counts,
}

/// What engines did.
#[derive(Debug, Default)]
struct Counts {
    walk: Count,
    batch: Count,
    jit: Count,
}

/// What one engine did.
#[derive(Debug, Default)]
struct Count {
    points: AtomicU64,
    wanted: AtomicU64,
    done: AtomicU64,
}

/// One root for one ray type, or for all if it does not look at the ray type.
#[derive(Debug)]
struct Compiled {
    root: RootKind,
    ray_type: Option<RayType>,
    uniforms: Uniforms,
    links: FirstLinks,
    /// The uniform words and what the plan's code reads besides, once points were shaded under these values.
    words: OnceLock<(Vec<u32>, WordsId)>,
    code: Arc<RootCode>,
}

#[derive(Debug)]
struct RootCode {
    specialised: Specialised,
    /// For the walk.
    walk: Option<walk::Code>,
    /// For the other engines.
    schedule: Option<Schedule>,
    /// Made when the first point is shaded; see [`Shader::plan`].
    plan: OnceLock<Result<Plan, JitError>>,
    /// Whether the background was asked for the plan.
    asked: AtomicBool,
}

impl Shader {
    /// Compiles `graph` with `values` for some of its parameters.
    pub fn new(
        graph: Arc<Graph>,
        values: &[(String, Literal)],
        options: Options,
    ) -> Result<Self, ShaderError> {
        let defaults = graph.parameters.iter().map(|parameter| parameter.default.clone());
        let mut shader = Self {
            values: defaults.collect(),
            graph,
            options,
            generator: None,
            programs: Vec::new(),
            compile_nanoseconds: AtomicU64::new(0),
            counts: Counts::default(),
        };
        for (name, value) in values {
            shader.take(name, value)?;
        }
        shader.compile()?;
        Ok(shader)
    }

    /// Sets a parameter. Compiles again only if a condition that shaped the code now falls
    /// otherwise (a weight becomes 0, a switch turns); machine code is kept otherwise. After an error all
    /// is as it was.
    pub fn set(&mut self, name: &str, value: &Literal) -> Result<(), ShaderError> {
        let before = self.values.clone();
        self.take(name, value)?;
        let values = &self.values;
        // Light lists are part of the code.
        let in_code = value.value_type().is_in_code();
        if !in_code && self.programs.iter_mut().all(|program| program.uniforms.rebind(values)) {
            for program in &mut self.programs {
                program.words.take();
            }
            return Ok(());
        }
        let compiled = self.compile();
        if compiled.is_err() {
            // The programs were decided under these values, so they take them back.
            for program in &mut self.programs {
                let _ = program.uniforms.rebind(&before);
            }
            self.values = before;
        }
        compiled
    }

    /// The graph.
    pub fn graph(&self) -> &Graph {
        &self.graph
    }

    /// Time spent compiling, in milliseconds; what `auto` compiles in the background aside.
    pub fn compile_milliseconds(&self) -> f64 {
        self.compile_nanoseconds.load(Ordering::Relaxed) as f64 * 1e-6
    }

    /// The plans made so far: one for each root and ray type of which points were shaded.
    pub fn plans(&self) -> impl Iterator<Item = &Plan> {
        self.programs.iter().filter_map(|program| program.code.plan.get()?.as_ref().ok())
    }

    /// Why points for which the jit was asked were shaded by kernels, with the same results; none if all
    /// went well. `auto` asks for nothing.
    pub fn jit_failure(&self) -> Option<&JitError> {
        let asked = self.options.engine == Engine::Jit;
        let mut programs = self.programs.iter().filter(|_| asked);
        programs.find_map(|program| program.code.plan.get()?.as_ref().err())
    }

    /// Points shaded so far, by the engine that shaded them.
    pub fn points(&self) -> [(&'static str, u64); 3] {
        let count = |of: &Count| of.points.load(Ordering::Relaxed);
        let Counts { walk, batch, jit } = &self.counts;
        [("walk", count(walk)), ("batch", count(batch)), ("jit", count(jit))]
    }

    /// Evaluations of nodes so far, by engine, if [`Options::count`] asked for that; else none.
    pub fn evaluations(&self) -> [(&'static str, Evaluations); 3] {
        let count = |of: &Count| Evaluations {
            wanted: of.wanted.load(Ordering::Relaxed),
            done: of.done.load(Ordering::Relaxed),
        };
        let Counts { walk, batch, jit } = &self.counts;
        [("walk", count(walk)), ("batch", count(batch)), ("jit", count(jit))]
    }

    /// What each root asks of a renderer, node by node, and why it does not ask for the rest.
    ///
    /// # Errors
    /// None, for a graph that was compiled.
    pub fn accounts(&self) -> Result<Vec<Account>, ShaderError> {
        let account = |program: &Compiled| {
            let Some(root) = self.graph.root(program.root) else { return Ok(None) };
            let ray_type = program.ray_type;
            // A root that does not look at the ray type is the same for all.
            let of = ray_type.unwrap_or(program.root.ray_types()[0]);
            let words = program.uniforms.values();
            let specialised = &program.code.specialised;
            let parts = specialised.account(&self.graph, root, of, &self.values, words)?;
            Ok(Some(Account { root: program.root, ray_type, parts }))
        };
        self.programs.iter().filter_map(|program| account(program).transpose()).collect()
    }

    /// The schedules of all roots, as text.
    pub fn print(&self) -> String {
        self.print_with(|schedule, _| schedule.to_string())
    }

    /// What the jit makes of the schedules of all roots, as text: operations, and steps that stay kernels.
    pub fn print_pieces(&self) -> String {
        let Options { batch, generator, .. } = self.options;
        let generator = generator.unwrap_or(Generator::Native);
        self.print_with(|schedule, uniforms| {
            Pieces::of(schedule, uniforms, batch, generator, &[]).to_string()
        })
    }

    fn print_with(&self, text: impl Fn(&Schedule, usize) -> String) -> String {
        let print = |program: &Compiled| {
            let uniforms = program.uniforms.values().len();
            let schedule = program.code.schedule.as_ref().map(|schedule| text(schedule, uniforms));
            let ray_type = program.ray_type.map_or(String::new(), |of| format!(" for {of:?} rays"));
            format!("{}{ray_type}\n{}", program.root.name(), schedule.unwrap_or_default())
        };
        self.programs.iter().map(print).collect::<Vec<_>>().join("\n")
    }

    fn take(&mut self, name: &str, value: &Literal) -> Result<(), ShaderError> {
        let value = self.graph.bind_literal(name, value)?;
        if let Some(at) = self.graph.parameter(name) {
            self.values[at] = value;
        }
        Ok(())
    }

    fn compile(&mut self) -> Result<(), ShaderError> {
        let start = Instant::now();
        self.generator = self.generator()?;
        let mut programs: Vec<Compiled> = Vec::new();
        let mut links = FirstLinks::default();
        for root in self.graph.roots.iter().filter(|root| self.options.roots.contains(&root.kind)) {
            let ray_types = match self.options.called_rays_only {
                true => root.kind.ray_types(),
                false => &RayType::ALL,
            };
            for (at, &ray_type) in ray_types.iter().enumerate() {
                let program = self.compile_root(root, ray_type, links)?;
                links.light_list += program.code.specialised.light_lists.len();
                links.texture += program.code.specialised.textures.len();
                if at == 0 && !program.code.specialised.reads_ray_type {
                    programs.push(program);
                    break;
                }
                programs.push(Compiled { ray_type: Some(ray_type), ..program });
            }
        }
        self.programs = programs;
        self.count_compiling(start);
        Ok(())
    }

    /// Who makes the machine code; none where kernels are to do without.
    fn generator(&self) -> Result<Option<Generator>, JitError> {
        let Options { engine, generator: asked, .. } = self.options;
        match (engine, Generator::chosen(asked)) {
            (Engine::Walk | Engine::Batch, _) => Ok(None),
            (_, Ok(generator)) => Ok(Some(generator)),
            // Who asks for one by name is told.
            (Engine::Auto, Err(_)) if asked.is_none() => Ok(None),
            (_, Err(error)) => Err(error),
        }
    }

    fn count_compiling(&self, since: Instant) {
        let nanoseconds = since.elapsed().as_nanos() as u64;
        self.compile_nanoseconds.fetch_add(nanoseconds, Ordering::Relaxed);
    }

    /// The plan by which a program is to be run, if it is to be run by one.
    ///
    /// With `jit`, whoever shades the first points makes it, and others wait for it. With `auto`, the first
    /// points are shaded by kernels, and it is made in the background meanwhile. Where it cannot be
    /// made, kernels run on, with the same bits; see [`Shader::jit_failure`].
    fn plan<'a>(&self, code: &'a Arc<RootCode>, schedule: &Schedule) -> Option<&'a Plan> {
        let generator = self.generator?;
        let plan = if self.options.engine == Engine::Jit {
            Some(code.plan.get_or_init(|| {
                let start = Instant::now();
                let plan = code.new_plan(schedule, self.options, generator);
                self.count_compiling(start);
                plan
            }))
        } else {
            let plan = code.plan.get();
            if plan.is_none() && !code.asked.swap(true, Ordering::Relaxed) {
                plan_in_background(Arc::downgrade(code), self.options, generator);
            }
            plan
        };
        plan.and_then(|plan| plan.as_ref().ok())
    }

    fn compile_root(
        &self,
        root: &Root,
        ray_type: RayType,
        links: FirstLinks,
    ) -> Result<Compiled, ShaderError> {
        let Options { engine, simd, asking, .. } = self.options;
        let specialised = expand_asking(&self.graph, root, ray_type, &self.values, asking)?;
        let uniforms = specialised.uniforms.clone();
        let walk = (engine == Engine::Walk).then(|| walk::Code::new(&specialised, simd));
        let schedule = (engine != Engine::Walk).then(|| schedule(&specialised));
        let (plan, asked) = (OnceLock::new(), AtomicBool::new(false));
        let code = Arc::new(RootCode { specialised, walk, schedule, plan, asked });
        let words = OnceLock::new();
        Ok(Compiled { root: root.kind, ray_type: None, uniforms, links, words, code })
    }

    fn program(&self, root: RootKind, ray_type: RayType) -> Option<&Compiled> {
        self.programs.iter().find(|program| {
            program.root == root && program.ray_type.is_none_or(|of| of == ray_type)
        })
    }
}

impl Count {
    fn add(&self, points: usize, evaluations: Option<Evaluations>) {
        self.points.fetch_add(points as u64, Ordering::Relaxed);
        if let Some(Evaluations { wanted, done }) = evaluations {
            self.wanted.fetch_add(wanted, Ordering::Relaxed);
            self.done.fetch_add(done, Ordering::Relaxed);
        }
    }
}

impl RootCode {
    fn new_plan(
        &self,
        schedule: &Schedule,
        options: Options,
        generator: Generator,
    ) -> Result<Plan, JitError> {
        let Options { simd, batch, count, .. } = options;
        let uniforms = self.specialised.uniforms.values().len();
        // Who wants what is found from the words of guards.
        let kept = count.then(|| self.specialised.guard_words());
        Plan::new(schedule, uniforms, simd, batch, generator, kept.as_deref())
    }
}

/// Makes a plan while kernels run already, unless the program is gone when its turn comes.
fn plan_in_background(code: Weak<RootCode>, options: Options, generator: Generator) {
    worker::enqueue(move || {
        if let Some(code) = code.upgrade()
            && let Some(schedule) = &code.schedule
        {
            code.plan.get_or_init(|| code.new_plan(schedule, options, generator));
        }
    });
}

impl Shade for Shader {
    fn has_root(&self, root: RootKind) -> bool {
        self.options.roots.contains(&root) && self.graph.root(root).is_some()
    }

    fn effects(&self, root: RootKind) -> EffectSet {
        let programs = self.programs.iter().filter(|program| program.root == root);
        let instances = programs.flat_map(|program| program.code.specialised.instances.values());
        instances
            .filter_map(|instance| match instance.kind {
                InstanceKind::Request { effect, .. } => Some(effect),
                InstanceKind::Plain(_) | InstanceKind::Loop { .. } => None,
            })
            .collect()
    }

    fn fields(&self, root: RootKind) -> FieldSet {
        let programs = self.programs.iter().filter(|program| program.root == root);
        let fields = programs.flat_map(|program| &program.code.specialised.fields);
        fields.map(|(field, _)| *field).collect()
    }

    fn textures(&self) -> BTreeSet<Texture> {
        let programs = self.programs.iter();
        programs.flat_map(|program| program.code.specialised.textures.values().cloned()).collect()
    }

    fn filtered_textures(&self) -> BTreeSet<Texture> {
        let programs = self.programs.iter().map(|program| &program.code.specialised);
        programs.flat_map(|specialised| specialised.filtered_textures().cloned()).collect()
    }

    fn link(&self, renderer: &mut dyn Renderer) -> Links {
        let mut links = Links::default();
        for program in &self.programs {
            let Specialised { light_lists, textures, .. } = &program.code.specialised;
            let lists = light_lists.values().map(|of| renderer.light_list(&of.names, of.mode));
            links.light_lists.extend(lists);
            links.textures.extend(textures.values().map(|texture| renderer.texture(texture)));
        }
        links
    }

    fn shade_linked(
        &self,
        root: RootKind,
        points: &[State],
        links: &Links,
        renderer: &mut dyn Renderer,
        results: &mut [Shaded],
    ) {
        let Some(first) = points.first() else { return };
        let Some(program) = self.program(root, first.ray_type) else {
            results.fill(Shaded::default());
            return;
        };
        let RootCode { walk, schedule, specialised, .. } = &*program.code;
        let uniforms = program.uniforms.values();
        let links = links.from(program.links);
        let Options { simd, batch, count, .. } = self.options;
        if let Some(walk) = walk {
            let evaluations = with_memory(|memory| {
                walk.run(uniforms, points, links, renderer, results, &mut memory.walk)
            });
            self.counts.walk.add(points.len(), count.then_some(evaluations));
        }
        let Some(schedule) = schedule else { return };
        let (runner, schedule, uniforms, counts) = match self.plan(&program.code, schedule) {
            Some(plan) => {
                let new = || (plan.uniform_words(uniforms), WordsId::unique());
                let (words, id) = program.words.get_or_init(new);
                let uniforms = UniformWords { words, id: Some(*id) };
                (Runner::Jit(plan), plan.schedule(schedule), uniforms, &self.counts.jit)
            }
            None => {
                let uniforms = UniformWords { words: uniforms, id: None };
                (Runner::Kernels(simd), schedule, uniforms, &self.counts.batch)
            }
        };
        let counted = count.then_some(specialised);
        let program = Program { schedule, uniforms, runner, batch, counted };
        let evaluations =
            with_memory(|memory| program.run(points, links, renderer, results, &mut memory.batch));
        counts.add(points.len(), count.then_some(evaluations));
    }
}
