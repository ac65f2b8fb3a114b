//! The nodes, one file each, and the list that makes them known.

#[macro_use]
mod macros;

#[cfg(any(test, feature = "testing"))]
#[macro_use]
pub mod harness;
#[cfg(test)]
mod adding_a_node;
#[cfg(test)]
mod agreement;
#[cfg(test)]
mod fixed_inputs;

pub mod finite;
mod library;
mod paragraph;
pub mod ports;
pub mod reference;
mod signature;
mod soundness;
mod standard;
mod turn_reads;

pub use library::{Definition, Group, NodeLibrary, NodeType, Overload};
pub use paragraph::paragraph;
pub use signature::{
    Avoid, BLACK, DefaultValue, FINITE, Input, Kind, ListForm, NOT_NEGATIVE, Output, POSITIVE,
    Signature, WHITE, avoidable, node, required, state,
};
pub use soundness::DefinitionError;
pub use turn_reads::{is_of_turn, reads_turn};

/// Declares the folders and files of nodes, and the list [`NodeLibrary::standard`] is made from.
macro_rules! nodes {
    ($($(#[doc = $doc:literal])+ $group:ident { $($node:ident),+ $(,)? })+) => {
        $($(#[doc = $doc])+ pub mod $group { $(#[doc = concat!("The node `", stringify!($node), "`.")] pub mod $node;)+ })+

        /// Every node there is, by group.
        fn definitions() -> Vec<Definition> {
            vec![$($($group::$node::definition(),)+)+]
        }

        /// The groups with their descriptions, in order.
        const GROUPS: &[(&str, &str)] = &[$((stringify!($group), concat!($($doc),+)),)+];
    };
}

nodes! {
    /// Arithmetic on numbers, vectors and colours.
    arithmetic {
        absolute, add, arc_tangent2, clamp, cosine, divide, exponential, floor, fraction,
        logarithm, maximum, minimum, modulo, multiply, negate, one_minus, power, ratio, scale, sine,
        smooth_step, square_root, subtract,
    }
    /// Values given once and used in many places.
    constants {
        constant_boolean, constant_color, constant_integer, constant_scalar, constant_vector,
    }
    /// Directions, points and their products.
    vector {
        combine_vector, cross, dot, length, normalize, split_vector, transform_normal,
        transform_point, transform_vector,
    }
    /// Blending and converting colours.
    color { combine_color, hsv_to_rgb, luminance, mix, overlay, screen, split_color }
    /// Patterns that look like chance, the same at every look.
    noise { perlin_noise }
    /// Comparing and choosing.
    logic { and, equal, less, less_equal, not, or, select, string_equal, switch }
    /// Over lists of any length.
    lists { element, sum }
    /// Light at the boundary of two media.
    fresnel { fresnel_dielectric, fresnel_reflection, ior_pair }
    /// Rays: directions, and requests to the renderer.
    rays {
        call_shader, fallback, image_size, light_color, ray_is, ray_switch, reflection_direction, refraction_direction,
        texture_lookup,
        trace_environment, trace_probe, trace_reflection, trace_refraction, trace_transparent,
    }
    /// Where to read pictures.
    textures {
        cylindrical_projection, latlong_projection, place_2d, planar_projection, spherical_projection,
        triplanar_blend, triplanar_places,
    }
    /// What surfaces do with the light of one sample.
    shading { lambert }
    /// Nodes that evaluate an input under a changed state, or many times.
    scopes { at_point, at_uv, chain, light_loop, perturb_normal }
    /// What is known about the point that is shaded.
    state { light, state }
}
