//! The table of what may be asked: arguments, answers, the state it reads.

use crate::state::Field;
use crate::values::Type;

use super::rays::Trace;

/// A named value that goes to the renderer, or comes back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Name in graph files.
    pub name: &'static str,
    /// Its type.
    pub value_type: Type,
}

/// Which call of the renderer answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    /// [`Renderer::trace`](super::Renderer::trace).
    Rays(Trace),
    /// [`Renderer::light_colors`](super::Renderer::light_colors), for the sample of the innermost loop
    /// over lights. Each is asked for once, whoever asks.
    LightColors,
    /// [`Renderer::light_density`](super::Renderer::light_density).
    LightDensity,
    /// [`Renderer::read_texture`](super::Renderer::read_texture), of the texture among the arguments.
    Texels,
    /// [`Renderer::texture_size`](super::Renderer::texture_size), of the texture among the arguments.
    TextureSize,
}

/// Declares the effects: what goes to the renderer, what comes back, which state fields may matter.
macro_rules! effects {
    ($($(#[doc = $doc:literal])+ $variant:ident $name:literal asks $asked:expr,
        takes [$($argument:ident : $takes:ident),*],
        yields [$($answer:ident : $yields:ident),+],
        reads [$($field:ident),*];)+) => {
        /// Anything a node asks of the renderer.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Effect { $($(#[doc = $doc])+ $variant,)+ }

        impl Effect {
            /// Every effect.
            pub const ALL: [Effect; [$($name),+].len()] = [$(Effect::$variant),+];

            /// Name in reports.
            pub fn name(self) -> &'static str {
                match self { $(Effect::$variant => $name,)+ }
            }

            /// Which call of the renderer answers it.
            pub fn asked(self) -> Asked {
                match self { $(Effect::$variant => $asked,)+ }
            }

            /// What goes to the renderer besides the state: the inputs of a node that asks.
            pub fn arguments(self) -> &'static [Part] {
                match self { $(Effect::$variant => {
                    &[$(Part { name: stringify!($argument), value_type: Type::$takes }),*]
                })+ }
            }

            /// What comes back; a node that asks has some of it as its outputs.
            pub fn answers(self) -> &'static [Part] {
                match self { $(Effect::$variant => {
                    &[$(Part { name: stringify!($answer), value_type: Type::$yields }),+]
                })+ }
            }

            /// State fields that may matter to the answer, besides the arguments; a scope that
            /// changes one of them asks anew. Where there are any, all of the state goes to the renderer.
            pub fn reads(self) -> &'static [Field] {
                match self { $(Effect::$variant => &[$(Field::$field),*],)+ }
            }
        }
    };
}

effects! {
    /// Trace a reflection ray.
    TraceReflection "trace_reflection" asks Asked::Rays(Trace::Reflection),
        takes [direction: Vector],
        yields [color: Color, ok: Boolean, hit: Boolean, distance: Scalar],
        reads [Point, NormalGeom, Ior, IorIn, Time];
    /// Trace a refraction ray.
    TraceRefraction "trace_refraction" asks Asked::Rays(Trace::Refraction),
        takes [direction: Vector],
        yields [color: Color, ok: Boolean, hit: Boolean, distance: Scalar],
        reads [Point, NormalGeom, Ior, IorIn, Time];
    /// Trace on along the ray, unbent.
    TraceTransparent "trace_transparent" asks Asked::Rays(Trace::Transparent),
        takes [],
        yields [color: Color, ok: Boolean, hit: Boolean, distance: Scalar],
        reads [Point, NormalGeom, Direction, Ior, IorIn, Time];
    /// Ask the environment, without geometry.
    TraceEnvironment "trace_environment" asks Asked::Rays(Trace::Environment),
        takes [direction: Vector],
        yields [color: Color, ok: Boolean, hit: Boolean, distance: Scalar],
        reads [Point, Time];
    /// Intersect only, call no shader.
    TraceProbe "trace_probe" asks Asked::Rays(Trace::Probe),
        takes [direction: Vector, origin: Vector],
        yields [color: Color, ok: Boolean, hit: Boolean, distance: Scalar],
        reads [Point, NormalGeom, Time];
    /// The colour a light sample sends to the point, after shadows. Only inside a light loop.
    LightColor "light_color" asks Asked::LightColors,
        takes [],
        yields [color: Color],
        reads [Point, NormalGeom, InvNormal, LightDirection, LightDistance];
    /// How densely the environment light draws a direction.
    LightDensity "light_density" asks Asked::LightDensity,
        takes [direction: Vector],
        yields [density: Scalar],
        reads [];
    /// The colour of a texture.
    ReadTexture "read_texture" asks Asked::Texels,
        takes [texture: Texture, u: Scalar, v: Scalar, wrap_u: Integer, wrap_v: Integer, filter: Integer,
            default: Color, du_dx: Scalar, dv_dx: Scalar, du_dy: Scalar, dv_dy: Scalar],
        yields [color: Color, ok: Boolean],
        reads [];
    /// How many pixels a texture has.
    TextureSize "texture_size" asks Asked::TextureSize,
        takes [texture: Texture],
        yields [width: Integer, height: Integer],
        reads [];
}

impl Effect {
    /// Words of the answer.
    pub fn answer_words(self) -> usize {
        self.answers().iter().map(|part| part.value_type.width()).sum()
    }

    /// First word of the part of the answer called `name`.
    pub fn answer_offset(self, name: &str) -> Option<usize> {
        let at = self.answers().iter().position(|part| part.name == name)?;
        Some(self.answers()[..at].iter().map(|part| part.value_type.width()).sum())
    }

    /// The answer where nothing can be asked: no texture is given, or no loop runs over lights (which
    /// the checker refuses). Zero, and of light an opaque black.
    pub fn unasked(self) -> Vec<u32> {
        let mut words = vec![0; self.answer_words()];
        if self.asked() == Asked::LightColors {
            words[3] = 1.0_f32.to_bits();
        }
        words
    }
}

impl From<Trace> for Effect {
    fn from(trace: Trace) -> Self {
        match trace {
            Trace::Reflection => Effect::TraceReflection,
            Trace::Refraction => Effect::TraceRefraction,
            Trace::Transparent => Effect::TraceTransparent,
            Trace::Environment => Effect::TraceEnvironment,
            Trace::Probe => Effect::TraceProbe,
        }
    }
}

/// A set of effects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EffectSet(u32);

const _: () = assert!(Effect::ALL.len() <= u32::BITS as usize, "a bit for each effect");

impl EffectSet {
    /// No effect.
    pub const NONE: EffectSet = EffectSet(0);

    /// Whether `effect` is in it.
    pub fn contains(self, effect: Effect) -> bool {
        self.0 & (1 << effect as u32) != 0
    }
}

impl FromIterator<Effect> for EffectSet {
    fn from_iter<I: IntoIterator<Item = Effect>>(effects: I) -> Self {
        EffectSet(effects.into_iter().fold(0, |set, effect| set | 1 << effect as u32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_to_follow_a_ray_is_an_effect_that_asks_for_it() {
        for trace in Trace::ALL {
            assert_eq!(Effect::from(trace).asked(), Asked::Rays(trace));
        }
        let rays = Effect::ALL.iter().filter(|it| matches!(it.asked(), Asked::Rays(_)));
        assert_eq!(rays.count(), Trace::ALL.len());
    }

    #[test]
    fn words_of_answers_lie_one_after_another() {
        let effect = Effect::TraceReflection;
        let offsets = effect.answers().iter().map(|part| effect.answer_offset(part.name));
        assert_eq!(offsets.collect::<Vec<_>>(), [Some(0), Some(4), Some(5), Some(6)]);
        assert_eq!(effect.answer_words(), 7);
        assert_eq!(effect.answer_offset("depth"), None);
    }

    #[test]
    fn a_set_holds_what_was_put_in() {
        let set: EffectSet = [Effect::TraceProbe, Effect::ReadTexture].into_iter().collect();
        let held = Effect::ALL.into_iter().filter(|effect| set.contains(*effect));
        assert_eq!(held.collect::<Vec<_>>(), [Effect::TraceProbe, Effect::ReadTexture]);
        assert_eq!([].into_iter().collect::<EffectSet>(), EffectSet::NONE);
    }
}
