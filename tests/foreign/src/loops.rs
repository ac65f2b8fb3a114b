//! Loops over samples, one for each way their values become one, and a loop over lights that is no sum.

use phenomenon_compiler::nodes::Definition;

/// Loops over samples of colours.
macro_rules! over_samples {
    ($($name:ident $reduction:ident $what:literal),+) => { $(
        #[doc = concat!("The node `", stringify!($name), "`.")]
        pub mod $name {
            use phenomenon_compiler::node;
            use phenomenon_compiler::nodes::{BLACK, Kind};
            use phenomenon_compiler::state::{Iterated, Reduction};

            node! {
                /// Evaluates `body` once for every sample.
                $name in foreign structural [Kind::Loop(Iterated::Samples, Reduction::$reduction)],
                source "",
                inputs {
                    /// How many samples.
                    count: integer = 4;
                }
                scoped {
                    /// What a sample yields.
                    body: color = BLACK;
                }
                outputs {
                    #[doc = $what]
                    color: color;
                }
            }
        }
    )+ };
}

over_samples!(
    sample_sum Sum "Their sum.",
    sample_mean Mean "Their mean.",
    sample_maximum Maximum "The greatest of each component.",
    sample_over Over "All laid over one another."
);

/// The node `mean_over_lights`.
pub mod mean_over_lights {
    use phenomenon_compiler::effects::LightMode;
    use phenomenon_compiler::node;
    use phenomenon_compiler::nodes::Kind;
    use phenomenon_compiler::state::{Iterated, Reduction};

    node! {
        /// The mean of a number over lights.
        mean_over_lights in foreign structural [Kind::Loop(Iterated::Lights, Reduction::Mean)],
        source "",
        inputs {
            /// Which.
            lights: lights = Vec::new();
            /// What they stand for.
            mode: choice = 0, of LightMode::NAMES;
        }
        scoped {
            /// What a light yields.
            body: scalar = 0.0;
        }
        outputs {
            /// Their mean.
            value: scalar;
        }
    }
}

/// The nodes.
pub fn definitions() -> [Definition; 5] {
    [
        sample_sum::definition(),
        sample_mean::definition(),
        sample_maximum::definition(),
        sample_over::definition(),
        mean_over_lights::definition(),
    ]
}
