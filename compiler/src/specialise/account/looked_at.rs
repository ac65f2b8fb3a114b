//! Going through the nodes of a graph after it was specialised.

use crate::effects::{Asked, Effect, LightMode, NamedLights, Sampling};
use crate::graph::{Graph, Root};
use crate::nodes::Kind;
use crate::specialise::decisions::Fold;
use crate::specialise::views::{Resolved, Views};
use crate::specialise::{SpecialiseError, Specialised};
use crate::state::{Field, Iterated, RayType};
use crate::values::Literal;

use super::cause::Settled;
use super::part::{Fate, Needed, Part, Reason};

impl Specialised {
    /// What each node of `graph` has the renderer do, and why the others have not. `root`, `ray_type` and `values`
    /// are what it was specialised for, `words` its uniform words.
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
        let folds = &self.folds_apart()[..];
        let settled = Settled { graph, views: &views, ray_type, values, words, folds };
        let below: Vec<Vec<bool>> =
            folds.iter().map(|fold| below(&views, views.source(fold.view, fold.input))).collect();
        let connected = below_root(&views);
        let look = Look { specialised: self, settled, below, connected };
        let asking = (0..views.len()).flat_map(|view| look.asking(view));
        let fields = Field::ALL.iter().filter_map(|&field| look.field(field));
        Ok(asking.chain(fields).collect())
    }

    /// The folds, each input once.
    fn folds_apart(&self) -> Vec<&Fold> {
        let mut folds: Vec<&Fold> = self.decisions.folds.iter().collect();
        folds.sort_by_key(|fold| (fold.view, fold.input));
        folds.dedup_by_key(|fold| (fold.view, fold.input));
        folds
    }
}

/// The nodes below one, itself included.
fn below(views: &Views<'_>, top: Option<usize>) -> Vec<bool> {
    let mut found = vec![false; views.len()];
    let mut stack: Vec<usize> = top.into_iter().collect();
    while let Some(view) = stack.pop() {
        if !std::mem::replace(&mut found[view], true) {
            stack.extend((0..views.inputs(view)).filter_map(|input| views.source(view, input)));
        }
    }
    found
}

fn below_root(views: &Views<'_>) -> Vec<bool> {
    below(views, Some(views.root()))
}

/// A specialised graph that is looked at.
struct Look<'a> {
    specialised: &'a Specialised,
    settled: Settled<'a>,
    /// Of each fold, the nodes that it leaves out, unless something else asks for them.
    below: Vec<Vec<bool>>,
    /// Which nodes the root is connected to.
    connected: Vec<bool>,
}

impl Look<'_> {
    /// What a node asks for itself.
    fn asking(&self, view: usize) -> Option<Part> {
        let views = self.settled.views;
        let needed = match views.signature(view).kind {
            Kind::Request(effect) => Needed::Request(effect),
            Kind::Loop(iterated, _) => Needed::Turns(iterated),
            Kind::Plain | Kind::Fields(_) | Kind::Scope(_) | Kind::List(_) => return None,
        };
        let decisions = &self.specialised.decisions;
        let fate = match decisions.built[view] {
            true if decisions.about_nothing.contains(&view) => Fate::AboutNothing,
            true => Fate::Asked,
            false => self.left_out(view),
        };
        Some(Part { fate, ..self.part(needed, view) })
    }

    /// What a field of the state is asked for by; none where the graph knows nothing of it.
    fn field(&self, field: Field) -> Option<Part> {
        let needed = Needed::Field(field);
        let readers = &self.specialised.decisions.readers;
        if let Some((_, view)) = readers.iter().find(|(of, _)| *of == field) {
            return Some(self.part(needed, *view));
        }
        // Fields that a scope or a loop gives are not the state's.
        if field.of_loop().is_some() || field == Field::RayType {
            return None;
        }
        let views = self.settled.views;
        let mut readers = (0..views.len()).filter_map(|view| {
            let input = (0..views.inputs(view)).find(|&input| reads(views, view, input, field))?;
            Some((view, input))
        });
        let (view, input) = readers.next()?;
        let built = self.specialised.decisions.built[view];
        let fold = self.settled.folds.iter().find(|fold| (fold.view, fold.input) == (view, input));
        let fate = match (fold, built) {
            (Some(fold), true) => Fate::Folded(vec![self.settled.reason(fold)]),
            (None, true) => return None,
            (_, false) => self.left_out(view),
        };
        Some(Part { fate, ..self.part(needed, view) })
    }

    /// Why a node was left out that is not asked.
    fn left_out(&self, view: usize) -> Fate {
        if !self.connected[view] {
            return Fate::Unconnected;
        }
        let folds = self.settled.folds.iter().zip(&self.below).filter(|(_, below)| below[view]);
        let reasons: Vec<Reason> = folds.map(|(fold, _)| self.settled.reason(fold)).collect();
        Fate::Folded(reasons)
    }

    /// A node that is asked.
    fn part(&self, needed: Needed, view: usize) -> Part {
        let mut part = Part {
            needed,
            node: self.settled.named(view),
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

/// Whether an input is a field of the state.
fn reads(views: &Views<'_>, view: usize, input: usize, field: Field) -> bool {
    match views.resolve(view, input) {
        Resolved::State(read) => read == field,
        Resolved::Node { view: source, output } => match &views.signature(source).kind {
            Kind::Fields(fields) => fields[output] == field,
            _ => false,
        },
        Resolved::Literal(_) | Resolved::Parameter(_) => false,
    }
}
