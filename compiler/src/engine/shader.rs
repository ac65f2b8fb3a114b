//! A graph compiled for an engine.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::Instant;

use crate::effects::{EffectSet, Renderer};
use crate::graph::{BindError, Graph, Root, RootKind};
use crate::schedule::{Schedule, schedule};
use crate::specialise::{InstanceKind, SpecialiseError, Specialised, Uniforms, expand};
use crate::state::{RayType, State};
use crate::values::{Literal, Texture};

use super::evaluations::Evaluations;
use super::execute::Program;
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
    /// The jit was asked for and cannot run here, or failed.
    #[error("the jit cannot run this graph: {0}; the batch engine can")]
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
    programs: Vec<Compiled>,
    /// Nanoseconds it took to compile, the jit of `auto` aside.
    compile_nanoseconds: u64,
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
    code: Arc<RootCode>,
}

#[derive(Debug)]
struct RootCode {
    specialised: Specialised,
    /// For the walk.
    walk: Option<walk::Code>,
    /// For the other engines.
    schedule: Option<Schedule>,
    plan: OnceLock<Option<Plan>>,
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
            programs: Vec::new(),
            compile_nanoseconds: 0,
            counts: Counts::default(),
        };
        for (name, value) in values {
            shader.take(name, value)?;
        }
        shader.compile()?;
        Ok(shader)
    }

    /// Sets a parameter. Compiles again only if a condition that shaped the code now falls
    /// otherwise (a weight becomes 0, a switch turns). After an error all is as it was.
    pub fn set(&mut self, name: &str, value: &Literal) -> Result<(), ShaderError> {
        let before = self.values.clone();
        self.take(name, value)?;
        let values = &self.values;
        // Light lists are part of the code.
        let in_code = value.value_type().is_in_code();
        if !in_code && self.programs.iter_mut().all(|program| program.uniforms.rebind(values)) {
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
        self.compile_nanoseconds as f64 * 1e-6
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

    /// The schedules of all roots, as text.
    pub fn print(&self) -> String {
        self.print_with(Schedule::to_string)
    }

    /// What the jit makes of the schedules of all roots, as text: operations, and steps that stay kernels.
    pub fn print_pieces(&self) -> String {
        let Options { batch, generator, .. } = self.options;
        let generator = generator.unwrap_or(Generator::Native);
        self.print_with(|schedule| Pieces::of(schedule, batch, generator, &[]).to_string())
    }

    fn print_with(&self, text: impl Fn(&Schedule) -> String) -> String {
        let print = |program: &Compiled| {
            let schedule = program.code.schedule.as_ref().map(&text);
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
        if self.options.engine == Engine::Auto {
            match Generator::chosen(self.options.generator) {
                Ok(generator) => self.plan_in_background(generator),
                // Who asks for one by name is told; else kernels do.
                Err(error) if self.options.generator.is_some() => return Err(error.into()),
                Err(_) => {}
            }
        }
        self.compile_nanoseconds += start.elapsed().as_nanos() as u64;
        Ok(())
    }

    /// Compiles machine code while kernels run already, unless the program is gone when its turn
    /// comes. A plan that fails leaves the kernels running: same bits.
    fn plan_in_background(&self, generator: Generator) {
        let options = self.options;
        for program in &self.programs {
            let code = Arc::downgrade(&program.code);
            worker::enqueue(move || {
                if let Some(code) = code.upgrade() {
                    code.plan.get_or_init(|| code.plan(options, generator).ok().flatten());
                }
            });
        }
    }

    fn compile_root(
        &self,
        root: &Root,
        ray_type: RayType,
        links: FirstLinks,
    ) -> Result<Compiled, ShaderError> {
        let specialised = expand(&self.graph, root, ray_type, &self.values)?;
        let uniforms = specialised.uniforms.clone();
        let Options { engine, simd, .. } = self.options;
        let walk = (engine == Engine::Walk).then(|| walk::Code::new(&specialised, simd));
        let schedule = (engine != Engine::Walk).then(|| schedule(&specialised));
        let code = Arc::new(RootCode { specialised, walk, schedule, plan: OnceLock::new() });
        match engine {
            Engine::Jit => {
                let generator = Generator::chosen(self.options.generator)?;
                if let Some(plan) = code.plan(self.options, generator)? {
                    // Nobody else holds this code yet, so the lock is empty.
                    let _ = code.plan.set(Some(plan));
                }
            }
            Engine::Auto | Engine::Walk | Engine::Batch => {}
        }
        Ok(Compiled { root: root.kind, ray_type: None, uniforms, links, code })
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
    fn plan(&self, options: Options, generator: Generator) -> Result<Option<Plan>, JitError> {
        let Options { simd, batch, count, .. } = options;
        let uniforms = self.specialised.uniforms.values().len();
        // Who wants what is found from the words of guards.
        let kept = if count { self.specialised.guard_words() } else { Vec::new() };
        let plan = |schedule| Plan::new(schedule, uniforms, simd, batch, generator, &kept);
        self.schedule.as_ref().map(plan).transpose()
    }
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

    fn textures(&self) -> BTreeSet<Texture> {
        let programs = self.programs.iter();
        programs.flat_map(|program| program.code.specialised.textures.values().cloned()).collect()
    }

    fn link(&self, renderer: &mut dyn Renderer) -> Links {
        let mut links = Links::default();
        for program in &self.programs {
            let Specialised { light_lists, textures, .. } = &program.code.specialised;
            let lists = light_lists.values().map(|names| renderer.light_list(names));
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
        let RootCode { walk, schedule, plan, specialised } = &*program.code;
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
        let (runner, counts) = match plan.get() {
            Some(Some(plan)) => (Runner::Jit(plan), &self.counts.jit),
            _ => (Runner::Kernels(simd), &self.counts.batch),
        };
        let counted = count.then_some(specialised);
        let program = Program { schedule, uniforms, runner, batch, counted };
        let evaluations =
            with_memory(|memory| program.run(points, links, renderer, results, &mut memory.batch));
        counts.add(points.len(), count.then_some(evaluations));
    }
}
