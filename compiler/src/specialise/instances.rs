//! The data of a specialised graph.

use cranelift_entity::PrimaryMap;

use crate::effects::{Effect, NamedLights, Sampling};
use crate::kernels::BodyForms;
use crate::state::{Field, Reduction};
use crate::storage::Source;
use crate::values::{Texture, Type};

use super::decisions::Decisions;
use super::{EpochId, Epochs, InstanceId, LightListId, LightTableId, TexturePosition, Uniforms};

/// One evaluation of a node: at most once per point and pass through its epoch.
#[derive(Clone, Debug)]
pub struct Instance {
    /// The node's name, with the scopes round it.
    pub name: String,
    /// How it is evaluated.
    pub kind: InstanceKind,
    /// The epoch it belongs to.
    pub epoch: EpochId,
    /// Instances it may demand, in order.
    pub demands: Vec<Demand>,
    /// Where its input words come from.
    pub words: Vec<Source>,
    /// First slot of its output words.
    pub output: u32,
    /// Number of output words.
    pub outputs: u32,
}

/// How an instance is evaluated.
#[derive(Clone, Debug)]
pub enum InstanceKind {
    /// By a body.
    Plain(BodyForms),
    /// By the renderer.
    Request {
        /// What is asked.
        effect: Effect,
        /// State fields that scopes round it changed.
        context: Context,
        /// Key of its random numbers: a hash of its path of names.
        site: u64,
        /// Loop epochs round it, outermost first: their iterations go into the key too.
        loops: Vec<EpochId>,
        /// What it is about.
        subject: Subject<EpochId>,
    },
    /// By running a body in every turn. The body is none of its demands.
    Loop {
        /// Epoch of the body.
        epoch: EpochId,
        /// What it runs over.
        turns: Turns<EpochId>,
        /// How the body's values become one.
        reduction: Reduction,
        /// Type of the body's values, and of what they become.
        value_type: Type,
        /// First of the slots of the fields a turn provides.
        fields: u32,
        /// The body's instance, if it is computed at all.
        body: Option<InstanceId>,
        /// The body's words.
        words: Vec<Source>,
        /// State fields that scopes round it changed.
        context: Context,
    },
}

/// What a loop runs over, with what it takes. Loops are named by `L`: by their epochs in a specialised
/// graph, by their positions in a schedule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Turns<L> {
    /// The samples of lights.
    Lights {
        /// The lights.
        list: LightListId,
    },
    /// Samples.
    Samples {
        /// How many.
        count: Source,
        /// Key of their random numbers: a hash of the loop's path of names.
        site: u64,
        /// Loops round it, outermost first, as in [`InstanceKind::Request`].
        loops: Vec<L>,
    },
}

/// What a request is about, besides the point that asks. Loops are named by `L`, as in [`Turns`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject<L> {
    /// Nothing else.
    Point,
    /// A texture, and how it is read.
    Texture(TexturePosition, Sampling),
    /// The sample of a loop over lights.
    Light {
        /// The loop.
        of: L,
        /// Where answers are kept.
        table: LightTableId,
    },
}

/// State fields with the words that replace them.
pub type Context = Vec<(Field, Vec<Source>)>;

/// An instance that may be demanded.
#[derive(Clone, Debug)]
pub struct Demand {
    /// Which.
    pub source: InstanceId,
    /// Only where this holds.
    pub guard: Option<Guard>,
}

/// The condition of a demand, over words that are ready before it.
#[derive(Clone, Debug)]
pub struct Guard {
    /// One word, a mask.
    pub code: BodyForms,
    /// Its input words.
    pub words: Vec<Source>,
}

/// Light colours already asked for, shared by all loops over the same lights in the same epoch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LightTable {
    /// The lights.
    pub list: LightListId,
    /// Passing through this epoch anew empties the table.
    pub epoch: EpochId,
}

/// A graph made concrete for one root and ray type.
#[derive(Clone, Debug)]
pub struct Specialised {
    /// Evaluations, demanded ones first; the last is the root's.
    pub instances: PrimaryMap<InstanceId, Instance>,
    /// Epochs.
    pub epochs: Epochs,
    /// Uniform words.
    pub uniforms: Uniforms,
    /// State fields in use, each with the first of its slots.
    pub fields: Vec<(Field, u32)>,
    /// Whether anything depends on the ray type it was specialised for.
    pub reads_ray_type: bool,
    /// Slots in use.
    pub slots: u32,
    /// The lights loops run over.
    pub light_lists: PrimaryMap<LightListId, NamedLights>,
    /// Tables of light colours.
    pub tables: PrimaryMap<LightTableId, LightTable>,
    /// Textures that are read.
    pub textures: PrimaryMap<TexturePosition, Texture>,
    /// What was left out.
    pub decisions: Decisions,
}

impl Specialised {
    /// The root: four words of colour, then ok.
    ///
    /// # Panics
    /// If there is no instance; the root is always one.
    pub fn root(&self) -> InstanceId {
        let (root, _) = self.instances.last().expect("the root is an instance");
        root
    }

    /// Textures that are read by footprints.
    pub fn filtered_textures(&self) -> impl Iterator<Item = &Texture> {
        self.instances.values().filter_map(|instance| match instance.kind {
            InstanceKind::Request { subject: Subject::Texture(texture, sampling), .. }
                if sampling.is_filtered() =>
            {
                Some(&self.textures[texture])
            }
            _ => None,
        })
    }

    /// Every word that a guard reads.
    pub fn guard_words(&self) -> Vec<Source> {
        let demands = self.instances.values().flat_map(|instance| &instance.demands);
        let guards = demands.filter_map(|demand| demand.guard.as_ref());
        guards.flat_map(|guard| guard.words.iter().copied()).collect()
    }
}
