//! `mixed.json` as one body.

use phenomenon_compiler::emit::{Body, Color, Emit, Sink, Vector, Words, write_color};
use phenomenon_compiler::state::Field;

use super::shade::Fused;
use super::values::{Fields, Nodes};
use crate::commands::bench::workloads::mixed::{LAYERS, Layer};

/// The workload.
pub struct Mixed;

impl Fused for Mixed {
    const FIELDS: &'static [Field] = &[Field::Normal, Field::Incoming];
}

#[inline(always)]
fn layer<E: Emit>(
    nodes: Nodes<E>,
    layer: &Layer,
    (toward, color): (Vector<E::Real>, Color<E::Real>),
) -> (Vector<E::Real>, Color<E::Real>) {
    let swirl = nodes.add(toward, nodes.vector(layer.shift));
    let toward = nodes.normalize(swirl);
    let angle = nodes.dot(toward, nodes.vector(layer.frequencies));
    let wave = nodes.sine(angle);
    let growth = nodes.exponential(wave);
    let tone = nodes.power(growth, nodes.number(layer.exponent));
    let hue = nodes.hsv_to_rgb(wave, nodes.number(layer.saturation), tone);
    (toward, nodes.mix(nodes.number(layer.weight), color, hue))
}

impl Body for Mixed {
    const OUTPUTS: usize = 4;

    #[inline(always)]
    fn run<E: Emit>(emit: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
        let nodes = Nodes(emit);
        let mut here = Fields::new(words);
        let mut layers = (here.vector::<E>(), here.color::<E>());
        // One by one, so that rustc knows the numbers of each, as the jit does.
        macro_rules! all {
            ($($at:literal)+) => { $(layers = layer(nodes, &LAYERS[$at], layers);)+ };
        }
        all!(0 1 2 3 4 5 6 7 8 9 10 11);
        write_color(sink, 0, layers.1);
    }
}
