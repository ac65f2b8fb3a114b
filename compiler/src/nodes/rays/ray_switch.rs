use super::ray_is::is;
use crate::emit::{Color, Mask};
use crate::nodes::{BLACK, state};
use crate::state::{Field, RayType};

node! {
    /// One colour for each type of ray; only the one taken is evaluated, and it passes unchanged.
    ray_switch in rays,
    source "mental ray manual, miState; shaders that test state->type",
    inputs {
        /// The type of the ray, as in the state.
        ray_type: integer = state(Field::RayType), in 0.0..=6.0;
        /// The colour for rays from the camera.
        eye: color = BLACK, when is(e, i.ray_type, RayType::Eye);
        /// The colour for rays of `trace_reflection`.
        reflection: color = BLACK, when is(e, i.ray_type, RayType::Reflection);
        /// The colour for rays of `trace_refraction`.
        refraction: color = BLACK, when is(e, i.ray_type, RayType::Refraction);
        /// The colour for rays of `trace_transparent`.
        transparent: color = BLACK, when is(e, i.ray_type, RayType::Transparent);
        /// The colour for rays from lights.
        shadow: color = BLACK, when is(e, i.ray_type, RayType::Shadow);
        /// The colour for rays of `trace_environment`.
        environment: color = BLACK, when is(e, i.ray_type, RayType::Environment);
        /// The colour for rays for displacement.
        displace: color = BLACK, when is(e, i.ray_type, RayType::Displace);
    }
    outputs {
        /// The colour taken; black for a type there is not.
        color: color;
    }
    body |e, i| {
        let (zero, one) = (e.real(0.0), e.real(1.0));
        let mut color = Color { r: zero, g: zero, b: zero, a: one };
        color = is(e, i.ray_type, RayType::Eye).select(i.eye, color);
        color = is(e, i.ray_type, RayType::Reflection).select(i.reflection, color);
        color = is(e, i.ray_type, RayType::Refraction).select(i.refraction, color);
        color = is(e, i.ray_type, RayType::Transparent).select(i.transparent, color);
        color = is(e, i.ray_type, RayType::Shadow).select(i.shadow, color);
        color = is(e, i.ray_type, RayType::Environment).select(i.environment, color);
        color = is(e, i.ray_type, RayType::Displace).select(i.displace, color);
        Outputs { color }
    }
}

#[cfg(test)]
mod tests {
    fn switch(ray_type: i32) -> Vec<f32> {
        numbers!(
            ray_type = ray_type,
            eye = [0.0, 0.0, 0.0, 0.5],
            reflection = [1.0, 0.0, 0.0, 0.5],
            refraction = [2.0, 0.0, 0.0, 0.5],
            transparent = [3.0, 0.0, 0.0, 0.5],
            shadow = [4.0, 0.0, 0.0, 0.5],
            environment = [5.0, 0.0, 0.0, 0.5],
            displace = [6.0, 0.0, 0.0, 0.5]
                => color
        )
    }

    #[test]
    fn takes_the_colour_of_the_type() {
        for ray_type in 0..7 {
            assert_eq!(switch(ray_type), [ray_type as f32, 0.0, 0.0, 0.5]);
        }
        for nonsense in [-1, 7, i32::MIN, i32::MAX] {
            assert_eq!(switch(nonsense), [0.0, 0.0, 0.0, 1.0]);
        }
    }

    #[test]
    fn demands_that_colour_alone() {
        for ray_type in -1..8 {
            let demands = [
                demanded!(ray_type = ray_type => eye),
                demanded!(ray_type = ray_type => reflection),
                demanded!(ray_type = ray_type => refraction),
                demanded!(ray_type = ray_type => transparent),
                demanded!(ray_type = ray_type => shadow),
                demanded!(ray_type = ray_type => environment),
                demanded!(ray_type = ray_type => displace),
            ];
            assert_eq!(demands, std::array::from_fn(|at| at as i32 == ray_type), "{ray_type}");
        }
    }
}
