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
#[cfg(test)]
mod lit_from_above;

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
    Avoid, BLACK, DefaultValue, FINITE, Implied, Input, Kind, ListForm, NOT_NEGATIVE, Output,
    POSITIVE, Signature, WHITE, avoidable, node, required, state,
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
        absolute, add, arc_tangent2, average, ceiling, clamp, cosine, cube_root, divide, exponential,
        floor, fraction, inverse_square_root, logarithm, logarithm2, logarithm10, logarithm_to_base,
        maximum, minimum, modulo, multiply, multiply_add, negate, one_minus, power, power_of_two,
        ratio, round, safe_power, scale, sign, sine, smooth_maximum, smooth_minimum, smooth_step,
        snap, square_root, subtract, truncate, truncated_modulo,
    }
    /// Angles in radians, and functions of them; `sine`, `cosine` and `arc_tangent2` are with arithmetic.
    trigonometry {
        arc_cosine, arc_sine, arc_tangent, degrees_to_radians, hyperbolic_cosine, hyperbolic_sine,
        hyperbolic_tangent, radians_to_degrees, tangent,
    }
    /// Changes of range, steps, and waves.
    ranges {
        bias, gain, linear_step, ping_pong, range, remap, smoother_step, step, triangle_wave, wrap,
    }
    /// Whole numbers of 32 bits: made of scalars, and computed exactly.
    integers {
        integer_absolute, integer_add, integer_clamp, integer_divide, integer_maximum, integer_minimum,
        integer_modulo, integer_multiply, integer_negate, integer_subtract, to_integer,
    }
    /// Values given once and used in many places.
    constants {
        constant_boolean, constant_color, constant_integer, constant_scalar, constant_vector,
    }
    /// Directions, points and their products.
    vector {
        color_to_vector, combine_vector, cross, distance, dot, face_forward, length,
        maximum_component, minimum_component, normalize, project, reflect, refract, rotate, rotate_2d,
        split_vector, transform_normal, transform_point, transform_vector, vector_to_color,
    }
    /// Transforms made, joined and taken apart. Points are rows: the rows of a transform are where it takes
    /// the axes, and the last is where it takes the origin.
    transforms {
        compose, determinant, inverse, rotation, scaling, transform_axes, transform_from_axes,
        translation, transpose,
    }
    /// Converting and grading colours.
    color {
        adjust_hsv, blackbody, color_correct, combine_color, contrast, decode_color, exposure, gamma,
        hsl_to_rgb, hsv_to_rgb, linear_to_srgb, luminance, mix, overlay, rgb_to_hsl, rgb_to_hsv,
        saturation, screen, split_color, srgb_to_linear, wavelength_to_color,
    }
    /// Layers: blend modes, and pictures joined by alpha.
    compositing {
        blend, blend_hue, color_mix, composite, inside, outside, premultiply, unpremultiply,
    }
    /// Patterns that look like chance, the same at every look.
    noise {
        cell_noise, fractal_noise, gradient_noise, perlin_2002, perlin_noise, random_color,
        random_scalar, worley_noise,
    }
    /// Figures and tiles over u and v, or in space.
    patterns {
        bricks, checker, checker_3d, circle, cloverleaf, crosshatch, flakes, grid, hexagon,
        hexagon_tiles, line, split_left_right, split_top_bottom, stripes, tiled_shapes,
    }
    /// From one value to another over a distance.
    ramps { curve, gradient, ramp, ramp4, ramp_left_right, ramp_segment, ramp_top_bottom }
    /// Comparing and choosing.
    logic {
        and, between, equal, greater, greater_equal, less, less_equal, nearly_equal, not, not_equal,
        or, select, string_equal, switch, xor,
    }
    /// Over lists of any length.
    lists { element, sum }
    /// Light at the boundary of two media.
    fresnel {
        beer_absorption, fresnel_conductor, fresnel_dielectric, fresnel_reflection, fresnel_schlick,
        ior_pair, radiance_scaling, thin_film,
    }
    /// Rays: directions, and requests to the renderer.
    rays {
        call_shader, fallback, image_size, light_color, light_density, ray_is, ray_switch, reflection_direction, refraction_direction,
        texture_lookup,
        trace_environment, trace_probe, trace_reflection, trace_refraction, trace_transparent,
    }
    /// Where to read pictures.
    textures {
        bump_normal, cylindrical_projection, hex_tile_blend, hex_tile_places, latlong_projection, normal_from_map, place_2d, planar_projection,
        slope, spherical_projection, triplanar_blend, triplanar_places,
    }
    /// What surfaces do with the light of one sample.
    shading {
        ashikhmin_shirley, blinn, burley, cook_torrance, ggx, lambert, oren_nayar, phong, schlick_anisotropic,
        sheen, torrance_sparrow, ward,
    }
    /// Reflectances of surfaces for two directions, and directions drawn to suit them.
    brdf {
        ashikhmin_shirley_brdf, ashikhmin_shirley_density, ashikhmin_shirley_sample, burley_brdf, cook_torrance_brdf,
        ggx_brdf, ggx_density, ggx_sample, lambert_brdf, lambert_density, lambert_sample,
        microfacet_density, microfacet_distribution, microfacet_sample, oren_nayar_brdf, phong_brdf,
        phong_density, phong_sample, schlick_anisotropic_brdf, schlick_phase, sheen_brdf,
        torrance_sparrow_brdf, ward_brdf, ward_density, ward_sample,
    }
    /// Nodes that evaluate an input under a changed state, or many times.
    scopes {
        at_point, at_uv, bump, chain, light_loop, normal_map, perturb_normal, shifted_u, shifted_v,
        shifted_x, shifted_y,
    }
    /// Tangent, bitangent and normal: directions in a surface.
    frames {
        frame_from_derivatives, frame_from_direction, frame_from_normal, vector_from_frame, vector_to_frame,
    }
    /// Loops over samples, and what is drawn in them.
    samples {
        direction_cone, direction_hemisphere, direction_sphere, glossy_reflection_direction,
        glossy_refraction_direction, point_on_disc, power_heuristic, sample_loop, stratified_sample,
    }
    /// The spaces of objects, scene, camera and picture.
    spaces { screen_to_world, transform_space, world_to_screen }
    /// What is known about the point that is shaded.
    state { camera_space, light, object, object_space, sample, state }
}
