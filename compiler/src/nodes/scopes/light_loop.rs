use crate::effects::LightMode;
use crate::nodes::{BLACK, Kind, NOT_NEGATIVE};
use crate::state::{Iterated, Reduction};

node! {
    #[doc = "Evaluates `body` once for every light sample that can reach the point and sums the \
             colours, in the order of the lights, then of their samples, in 32 bits. A sample's \
             colour is that of its light divided by the light's number of samples. Alpha is 1."]
    light_loop in scopes structural [Kind::Loop(Iterated::Lights, Reduction::Sum)],
    source "mental ray manual, mi_sample_light; mental ray base shaders, mode",
    inputs {
        /// The lights that are named; what they stand for, `mode` says.
        lights: lights = Vec::new(), in NOT_NEGATIVE;
        /// `listed` runs over the lights in the order they are named in, and over all of the scene where none
        /// is named; `inclusive` over those of the scene that are named, in its order, and over none where none
        /// is named; `exclusive` over those of the scene that are not named; `all` over every light of the
        /// scene, whatever is named. They are mental ray's modes 0, 1, 2 and 4.
        mode: choice = 0, of LightMode::NAMES;
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
