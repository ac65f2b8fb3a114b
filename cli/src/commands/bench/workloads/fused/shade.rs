//! A body over the fields of the state as something that shades batches.

use std::cell::RefCell;

use phenomenon_compiler::emit::Body;
use phenomenon_compiler::engine::{Shade, Shaded};
use phenomenon_compiler::kernels::BodyForms;
use phenomenon_compiler::state::{Field, State};
use phenomenon_compiler::storage::{FileShape, LANES, Lanes, Placement, Source, stride};

use crate::commands::bench::workloads::batches::Batches;

/// A whole material as one body.
pub trait Fused: Body {
    /// The fields it reads, in the order of its words. It yields a colour.
    const FIELDS: &'static [Field];
}

/// Words of a colour.
const COLOR: usize = 4;

thread_local! {
    static FILE: RefCell<Vec<Lanes>> = const { RefCell::new(Vec::new()) };
}

/// What shades by the eight-lane form of a body.
struct OneBody {
    code: BodyForms,
    /// Each with the first of its slots.
    fields: Vec<(Field, usize)>,
    sources: Vec<Source>,
}

/// The material of a body.
pub fn shader<B: Fused>() -> Box<dyn Shade> {
    let (mut fields, mut words) = (Vec::new(), 0);
    for &field in B::FIELDS {
        fields.push((field, words));
        words += field.value_type().width();
    }
    let sources = (0..words as u32).map(Source::Slot).collect();
    let body = OneBody { code: BodyForms::of::<B>(), fields, sources };
    Box::new(Batches(move |points: &[State], results: &mut [Shaded]| {
        FILE.with_borrow_mut(|file| body.run(points, results, file));
    }))
}

impl OneBody {
    fn run(&self, points: &[State], results: &mut [Shaded], file: &mut Vec<Lanes>) {
        let output = self.sources.len() as u32;
        let shape = FileShape { uniforms: 0, slots: stride(output + COLOR as u32) };
        let blocks = points.len().div_ceil(LANES);
        file.resize(shape.words(blocks).max(file.len()), Lanes::default());
        for (block, states) in points.chunks(LANES).enumerate() {
            for &(field, slot) in &self.fields {
                let at = shape.slot(slot as u32, block);
                field.gather(states, &mut file[at..at + field.value_type().width()]);
            }
        }
        self.code
            .wide(file, &Placement { shape, first: 0, blocks, sources: &self.sources, output });
        for (block, results) in results.chunks_mut(LANES).enumerate() {
            let at = shape.slot(output, block);
            let words = &file[at..at + COLOR];
            for (lane, result) in results.iter_mut().enumerate() {
                let color = [0, 1, 2, 3].map(|word| f32::from_bits(words[word].0[lane]));
                *result = Shaded { color, ok: true };
            }
        }
    }
}
