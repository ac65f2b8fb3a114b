use crate::nodes::Kind;
use crate::state::{Iterated, Reduction};

node! {
    /// Evaluates `body` once for each of `count` samples, and yields the mean: the sum in the order of the
    /// samples, in 32 bits, divided by how many there are. Nodes that read the sample, directly or through
    /// others, are evaluated anew for each; all others once. Of a colour the alpha is 1.
    sample_loop in samples structural [Kind::Loop(Iterated::Samples, Reduction::Mean)],
    source "mental ray manual, mi_sample",
    inputs {
        /// How many samples; 0 and less yield zero, more than 65536 count as that.
        count: integer = 16, in 0.0..=65_536.0;
    }
    scoped {
        /// What one sample yields; may read the outputs of `sample`, which nodes that draw a direction do by default.
        body: generic = 0.0;
    }
    outputs {
        /// The mean.
        result: generic;
    }
}
