//! `light.json` as one body.

use glam::Vec3A;
use phenomenon_compiler::emit::{Body, Color, Emit, One, Sink, Words, write_color};
use phenomenon_compiler::state::Field;

use super::shade::Fused;
use super::values::{Fields, Nodes};
use crate::commands::bench::workloads::light::{LAYERS, Layer, TURNS};

/// The workload.
pub struct Light;

impl Fused for Light {
    const FIELDS: &'static [Field] = &[Field::U, Field::V, Field::Time, Field::Dist];
}

#[inline(always)]
fn dimmed<E: Emit>(
    nodes: Nodes<E>,
    color: Color<E::Real>,
    layer: &Layer,
    share: One<E::Real>,
) -> Color<E::Real> {
    let tinted = nodes.multiply(color, nodes.color(layer.tint));
    let lit = nodes.add(tinted, nodes.color(layer.glow));
    let rest = nodes.one_minus(share);
    let layered = nodes.mix(share, lit, nodes.color(layer.color));
    nodes.scale(layered, rest)
}

/// What a layer has of a blend, between 0 and 1.
#[inline(always)]
fn share<E: Emit>(
    nodes: Nodes<E>,
    turned: One<E::Real>,
    from: One<E::Real>,
    turns: f32,
) -> One<E::Real> {
    nodes.fraction(nodes.add(nodes.multiply(turned, nodes.number(turns)), from))
}

#[inline(always)]
fn held<E: Emit>(
    nodes: Nodes<E>,
    color: Color<E::Real>,
    layer: &Layer,
    share: One<E::Real>,
) -> Color<E::Real> {
    let clear = nodes.subtract(dimmed(nodes, color, layer, share), nodes.color(layer.dust));
    nodes.maximum(clear, nodes.color(Vec3A::splat(0.02)))
}

#[inline(always)]
fn dusty<E: Emit>(
    nodes: Nodes<E>,
    color: Color<E::Real>,
    layer: &Layer,
    share: One<E::Real>,
) -> Color<E::Real> {
    let dusty = nodes.screen(dimmed(nodes, color, layer, share), nodes.color(layer.dust));
    nodes.minimum(dusty, nodes.color(Vec3A::splat(0.95)))
}

impl Body for Light {
    const OUTPUTS: usize = 4;

    #[inline(always)]
    fn run<E: Emit>(emit: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
        let nodes = Nodes(emit);
        let mut here = Fields::new(words);
        let u = here.number::<E>();
        let (v, time, dist) = (here.number::<E>(), here.number::<E>(), here.number::<E>());
        let (g, b, one) = (nodes.number(0.4), nodes.number(0.3), nodes.number(1.0));
        let mut color = nodes.combine_color(time, g, b, one);
        // One by one, so that rustc knows the numbers of each, as the jit does.
        macro_rules! all {
            ($($group:literal)+) => { $(
                let (turns, layers) = (&TURNS[$group], &LAYERS[$group]);
                color = held(nodes, color, &layers[0], share(nodes, v, u, turns.x));
                color = held(nodes, color, &layers[1], share(nodes, time, v, turns.y));
                color = held(nodes, color, &layers[2], share(nodes, dist, time, turns.z));
                color = dusty(nodes, color, &layers[3], share(nodes, u, dist, turns.w));
            )+ };
        }
        all!(0 1 2 3);
        write_color(sink, 0, color);
    }
}
