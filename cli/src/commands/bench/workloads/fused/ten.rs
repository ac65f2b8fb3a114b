//! `ten.json` as one body.

use phenomenon_compiler::emit::{Body, Emit, Sink, Words, write_color};
use phenomenon_compiler::state::Field;

use super::shade::Fused;
use super::values::{Fields, Nodes};
use crate::commands::bench::workloads::ten::{DUST, GLOW, HIGH, LOW, VEIL};

/// The workload.
pub struct Ten;

impl Fused for Ten {
    const FIELDS: &'static [Field] = &[Field::DotNd, Field::Point, Field::U];
}

impl Body for Ten {
    const OUTPUTS: usize = 4;

    #[inline(always)]
    fn run<E: Emit>(emit: E, words: &impl Words<E>, sink: &mut impl Sink<E>) {
        let nodes = Nodes(emit);
        let mut here = Fields::new(words);
        let (dot_nd, point, u) = (here.number::<E>(), here.vector::<E>(), here.number::<E>());
        let front = nodes.absolute(dot_nd);
        let rim = nodes.one_minus(front);
        let soft = nodes.multiply(rim, rim);
        let toward = nodes.normalize(point);
        let up = nodes.split_vector_y(toward);
        let height = nodes.smooth_step(up, nodes.number(-0.4), nodes.number(0.6));
        let depth = nodes.length(point);
        let far = nodes.add(depth, nodes.number(1.5));
        let fade = nodes.divide(nodes.number(2.0), far);
        let ground = nodes.mix(height, nodes.color(LOW), nodes.color(HIGH));
        let veiled = nodes.mix(soft, ground, nodes.color(VEIL));
        let glow = nodes.scale(nodes.color(GLOW), fade);
        let lit = nodes.add(veiled, glow);
        let film = nodes.hsv_to_rgb(front, nodes.number(0.7), nodes.number(0.9));
        let filmed = nodes.overlay(lit, film);
        let dust = nodes.screen(filmed, nodes.color(DUST));
        let share = nodes.fraction(u);
        write_color(sink, 0, nodes.mix(share, dust, lit));
    }
}
