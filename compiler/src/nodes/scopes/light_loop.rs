use crate::nodes::{BLACK, Kind, NOT_NEGATIVE};
use crate::state::{Iterated, Reduction};

node! {
    #[doc = "Evaluates `body` once for every light sample that can reach the point and sums the \
             colours, in the order of the lights, then of their samples, in 32 bits. A sample's \
             colour is that of its light divided by the light's number of samples. Alpha is 1."]
    light_loop in scopes structural [Kind::Loop(Iterated::Lights, Reduction::Sum)],
    source "mental ray manual, mi_sample_light",
    inputs {
        /// The lights to run over; none given: every light of the scene.
        lights: lights = Vec::new(), in NOT_NEGATIVE;
    }
    scoped {
        /// What one light sample adds; may read the outputs of `light` and `light_color`.
        body: color = BLACK, in NOT_NEGATIVE;
    }
    outputs {
        /// The sum.
        color: color, in NOT_NEGATIVE;
    }
}
