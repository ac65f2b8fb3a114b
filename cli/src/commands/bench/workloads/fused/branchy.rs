//! `branchy.json` as one body.

use phenomenon_compiler::emit::{Body, Color, Emit, Sink, Vector, Words, write_color};
use phenomenon_compiler::state::Field;

use super::shade::Fused;
use super::values::{Fields, Nodes};
use crate::commands::bench::workloads::branchy::{
    EVEN, INNER, LEFT, LOWER, ODD, OUTER, RIGHT, Side, UPPER,
};

/// The workload.
pub struct Branchy;

impl Fused for Branchy {
    const FIELDS: &'static [Field] = &[
        Field::Point,
        Field::U,
        Field::V,
        Field::InvNormal,
        Field::ReflectionLevel,
        Field::Incoming,
    ];
}

#[inline(always)]
fn side<E: Emit>(
    nodes: Nodes<E>,
    side: &Side,
    color: Color<E::Real>,
    point: Vector<E::Real>,
) -> Color<E::Real> {
    let swirl = nodes.add(point, nodes.vector(side.shift));
    let toward = nodes.normalize(swirl);
    let angle = nodes.dot(toward, nodes.vector(side.frequencies));
    let wave = nodes.sine(angle);
    let growth = nodes.exponential(wave);
    let tone = nodes.power(growth, nodes.number(side.exponents[0]));
    let hue = nodes.hsv_to_rgb(wave, nodes.number(side.saturation), tone);
    let depth = nodes.length(swirl);
    let far = nodes.exponential(depth);
    let fade = nodes.divide(tone, far);
    let grain = nodes.power(fade, nodes.number(side.exponents[1]));
    let lit = nodes.scale(hue, grain);
    nodes.mix(nodes.number(side.weight), color, lit)
}

impl Body for Branchy {
    const OUTPUTS: usize = 4;

    #[inline(always)]
    fn run<E: Emit>(emit: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
        let nodes = Nodes(emit);
        let mut here = Fields::new(words);
        let point = here.vector::<E>();
        let (u, v) = (here.number::<E>(), here.number::<E>());
        let (inside, level) = (here.truth::<E>(), here.whole::<E>());
        let start = here.color::<E>();
        let is_left = nodes.less(u, nodes.number(0.5));
        let (left, right) = (side(nodes, &LEFT, start, point), side(nodes, &RIGHT, start, point));
        let across = nodes.select(is_left, left, right);
        let inner = side(nodes, &INNER, across, point);
        let outer = side(nodes, &OUTER, across, point);
        let through = nodes.select(inside, inner, outer);
        let (even, odd) = (side(nodes, &EVEN, through, point), side(nodes, &ODD, through, point));
        let bounced = nodes.switch(level, even, odd, even, odd);
        let lower = side(nodes, &LOWER, bounced, point);
        let upper = side(nodes, &UPPER, bounced, point);
        let half = nodes.number(0.5);
        let is_upper = nodes.smooth_step(v, half, half);
        let along = nodes.mix(is_upper, lower, upper);
        write_color(sink, 0, nodes.scale(along, nodes.number(0.8)));
    }
}
