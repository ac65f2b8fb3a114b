//! Going through the nodes of a graph after it was specialised.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::effects::{Asked, Effect, LightMode, NamedLights, Sampling};
use crate::graph::{Graph, Root};
use crate::nodes::Kind;
use crate::specialise::views::{Resolved, Views};
use crate::specialise::{SpecialiseError, Specialised};
use crate::state::{Field, Iterated, RayType};
use crate::values::Literal;

use super::cause::Settled;
use super::part::{Fate, Named, Needed, Part, TOLD_REASONS};
use super::pruned::Pruned;

impl Specialised {
    /// What each node of `graph` has the renderer do, and why the others have not. `root`, `ray_type` and `values`
    /// are what it was specialised for, `words` its uniform words. Of what no point asks for, the first node of each
    /// kind is told of. Takes time and memory in proportion to the graph.
    ///
    /// # Errors
    /// The graph is not the one that was specialised.
    pub fn account(
        &self,
        graph: &Graph,
        root: &Root,
        ray_type: RayType,
        values: &[Literal],
        words: &[u32],
    ) -> Result<Vec<Part>, SpecialiseError> {
        let views = Views::new(graph, root)?;
        let folds = self.decisions.folds.iter().map(|fold| ((fold.view, fold.input), fold));
        let expressions = graph.expressions.iter().map(|of| (of.name.as_str(), of.text.as_str()));
        let (folds, expressions) = (folds.collect(), expressions.collect());
        let settled = Settled { graph, views: &views, ray_type, values, words, folds, expressions };
        let look = Look {
            specialised: self,
            pruned: Pruned::of(&views, &self.decisions),
            implying: implying(&views, graph.nodes.len()),
            readers: self.decisions.readers.iter().copied().collect(),
            about_nothing: self.decisions.about_nothing.iter().copied().collect(),
            settled,
        };
        Ok(look.parts())
    }
}

/// A specialised graph that is looked at.
struct Look<'a> {
    specialised: &'a Specialised,
    settled: Settled<'a>,
    pruned: Pruned,
    /// Of each node that defaults imply, the inputs whose default it is.
    implying: FxHashMap<usize, Vec<(usize, usize)>>,
    /// Fields of the state in use, each with the nodes that read it.
    readers: FxHashSet<(Field, usize)>,
    /// Requests that ask nothing.
    about_nothing: FxHashSet<usize>,
}

/// What became of a node; [`Fate`] without the words.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Left {
    Asked,
    /// Its own input is never evaluated.
    InputOut,
    /// It is out itself.
    Out,
    AboutNothing,
    Unconnected,
}

impl Look<'_> {
    fn parts(&self) -> Vec<Part> {
        let mut parts = Vec::new();
        // A graph may leave out any number of nodes: the first of each kind is enough.
        let mut told = FxHashSet::default();
        for (view, input, needed) in self.needs() {
            let Some(left) = self.left(view, input, needed) else { continue };
            let mut part = self.part(needed, view);
            if left != Left::Asked
                && !told.insert((needed, part.texture.clone(), part.filtered, left))
            {
                continue;
            }
            part.fate = self.fate(view, input, left);
            for node in self.names(view, left) {
                parts.push(Part { node, ..part.clone() });
            }
        }
        parts
    }

    /// What nodes have the renderer do by their declaration; with fields of the state the input that reads them.
    fn needs(&self) -> Vec<(usize, usize, Needed)> {
        let views = self.settled.views;
        let mut needs = Vec::new();
        for view in 0..views.len() {
            match views.signature(view).kind {
                Kind::Request(effect) => needs.push((view, 0, Needed::Request(effect))),
                Kind::Loop(iterated, _) => needs.push((view, 0, Needed::Turns(iterated))),
                Kind::Plain | Kind::Fields(_) | Kind::Scope(_) | Kind::List(_) => {}
            }
            let first = needs.len();
            for input in 0..views.inputs(view) {
                let Some(field) = field_read(views, view, input) else { continue };
                let needed = Needed::Field(field);
                if needs[first..].iter().all(|(.., known)| *known != needed) {
                    needs.push((view, input, needed));
                }
            }
        }
        needs
    }

    /// What became of a node; none where it has nothing of the renderer.
    fn left(&self, view: usize, input: usize, needed: Needed) -> Option<Left> {
        let decisions = &self.specialised.decisions;
        let is_built = decisions.built[view];
        if let Needed::Field(field) = needed {
            if self.readers.contains(&(field, view)) {
                return Some(Left::Asked);
            }
            // Fields that a scope or a loop gives are not the state's.
            if field.of_loop().is_some() || field == Field::RayType {
                return None;
            }
            if is_built {
                let is_out = self.settled.folds.contains_key(&(view, input));
                return is_out.then_some(Left::InputOut);
            }
        }
        Some(match is_built {
            true if self.about_nothing.contains(&view) => Left::AboutNothing,
            true => Left::Asked,
            false if self.pruned.is_connected(view) => Left::Out,
            false => Left::Unconnected,
        })
    }

    fn fate(&self, view: usize, input: usize, left: Left) -> Fate {
        let inputs = match left {
            Left::Asked => return Fate::Asked,
            Left::AboutNothing => return Fate::AboutNothing,
            Left::Unconnected => return Fate::Unconnected,
            Left::InputOut => &[(view, input)][..],
            Left::Out => self.pruned.inputs(view),
        };
        let folds = inputs.iter().filter_map(|at| self.settled.folds.get(at));
        let reasons = folds.take(TOLD_REASONS).map(|fold| self.settled.reason(fold));
        Fate::Folded { reasons: reasons.collect(), more: inputs.len() > TOLD_REASONS }
    }

    /// What a node is called: one that defaults imply by the nodes whose defaults they are.
    fn names(&self, view: usize, left: Left) -> Vec<Named> {
        if !self.implying.contains_key(&view) {
            return vec![self.settled.named(view)];
        }
        let built = &self.specialised.decisions.built;
        let (mut seen, mut stack) = (FxHashSet::default(), vec![view]);
        let mut names = Vec::new();
        while let Some(implied) = stack.pop() {
            for &(by, input) in self.implying.get(&implied).into_iter().flatten() {
                let asks = built[by] && !self.settled.folds.contains_key(&(by, input));
                if (left == Left::Asked && !asks) || !seen.insert(by) {
                    continue;
                }
                match self.implying.contains_key(&by) {
                    true => stack.push(by),
                    false => names.push(self.settled.named(by)),
                }
            }
        }
        if left != Left::Asked {
            names.truncate(1);
        }
        let node_type = &self.settled.views.signature(view).name;
        names.iter_mut().for_each(|named| named.implied = Some(node_type.to_string()));
        match names.is_empty() {
            true => vec![self.settled.named(view)],
            false => names,
        }
    }

    /// A node that is asked.
    fn part(&self, needed: Needed, view: usize) -> Part {
        let mut part = Part {
            needed,
            node: Named::default(),
            texture: None,
            filtered: false,
            lights: None,
            samples: None,
            fate: Fate::Asked,
        };
        match needed {
            Needed::Request(effect) => self.about(effect, view, &mut part),
            Needed::Turns(Iterated::Lights) => part.lights = Some(self.lights(view)),
            Needed::Turns(Iterated::Samples) => {
                part.samples = self.given(view).find_map(|literal| match literal {
                    Literal::Integer(number) => Some(number),
                    _ => None,
                });
            }
            Needed::Field(_) => {}
        }
        part
    }

    fn about(&self, effect: Effect, view: usize, part: &mut Part) {
        match effect.asked() {
            Asked::Texels | Asked::TextureSize => {
                part.texture = self.given(view).find_map(|literal| match literal {
                    Literal::Texture(texture) => texture,
                    _ => None,
                });
                let sampling = Sampling::from_numbers(&self.fixed(view));
                part.filtered = effect.asked() == Asked::Texels && sampling.is_filtered();
            }
            Asked::Rays(_) | Asked::LightColors | Asked::LightDensity => {}
        }
    }

    fn lights(&self, view: usize) -> NamedLights {
        let names = self.given(view).find_map(|literal| match literal {
            Literal::Lights(names) => Some(names),
            Literal::Light(name) => Some(vec![name]),
            _ => None,
        });
        let mode = self.fixed(view).first().copied().map(LightMode::from_number);
        NamedLights::new(names.unwrap_or_default(), mode.unwrap_or_default())
    }

    /// What a node is given that is known before shading.
    fn fixed(&self, view: usize) -> Vec<i32> {
        let words = self.settled.views.fixed_words(view).into_iter();
        let number = |(input, _)| match self.known(view, input) {
            Some(Literal::Integer(number)) => Some(number),
            _ => None,
        };
        words.filter_map(number).collect()
    }

    /// What the inputs of a node are given by literals and parameters.
    fn given(&self, view: usize) -> impl Iterator<Item = Literal> {
        let inputs = 0..self.settled.views.inputs(view);
        inputs.filter_map(move |input| self.known(view, input))
    }

    fn known(&self, view: usize, input: usize) -> Option<Literal> {
        match self.settled.views.resolve(view, input) {
            Resolved::Literal(literal) => Some(literal),
            Resolved::Parameter(parameter) => Some(self.settled.values[parameter].clone()),
            Resolved::State(_) | Resolved::Node { .. } => None,
        }
    }
}

/// The field of the state that an input reads, if it reads one.
fn field_read(views: &Views<'_>, view: usize, input: usize) -> Option<Field> {
    match views.resolve(view, input) {
        Resolved::State(field) => Some(field),
        Resolved::Node { view: source, output } => match &views.signature(source).kind {
            Kind::Fields(fields) => Some(fields[output]),
            _ => None,
        },
        Resolved::Literal(_) | Resolved::Parameter(_) => None,
    }
}

/// Of each node that is none of the graph's `nodes` the inputs whose default implies it.
fn implying(views: &Views<'_>, nodes: usize) -> FxHashMap<usize, Vec<(usize, usize)>> {
    let mut implying: FxHashMap<usize, Vec<(usize, usize)>> = FxHashMap::default();
    for view in 0..views.len() {
        for input in 0..views.inputs(view) {
            if let Some(source) = views.source(view, input).filter(|source| *source >= nodes) {
                implying.entry(source).or_default().push((view, input));
            }
        }
    }
    implying
}
