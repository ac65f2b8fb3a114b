//! Requests as words: what both ways of running a graph write to the renderer and read from it.

use crate::effects::{Answer, Effect, Ray};
use crate::specialise::mix_key;
use crate::state::State;

/// The key of a request with one more loop round it.
pub(super) fn iteration_key(key: u64, iteration: usize) -> u64 {
    mix_key(key ^ mix_key(iteration as u64 + 1))
}

/// The ray of a request from its argument words: direction, then origin, as far as it has them.
pub(super) fn ray(effect: Effect, state: State, words: [u32; 6], site: u64) -> Ray {
    let [dx, dy, dz, ox, oy, oz] = words.map(f32::from_bits);
    let (origin, direction) = match effect {
        Effect::TraceProbe => ([ox, oy, oz], [dx, dy, dz]),
        Effect::TraceTransparent => (state.point, state.direction),
        _ => (state.point, [dx, dy, dz]),
    };
    Ray { state, origin, direction, site }
}

/// The output words of a texture request.
pub(super) fn texture_words(color: Option<[f32; 4]>) -> [u32; 5] {
    let [r, g, b, a] = color.unwrap_or_default().map(f32::to_bits);
    [r, g, b, a, if color.is_some() { u32::MAX } else { 0 }]
}

/// The output words of a trace request.
pub(super) fn answer_words(answer: &Answer) -> [u32; 7] {
    let truth = |value: bool| if value { u32::MAX } else { 0 };
    let [r, g, b, a] = answer.color.map(f32::to_bits);
    [r, g, b, a, truth(answer.ok), truth(answer.hit), answer.distance.to_bits()]
}
