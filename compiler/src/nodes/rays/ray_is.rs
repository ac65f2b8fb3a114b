use crate::emit::{Emit, Int};
use crate::nodes::state;
use crate::state::{Field, RayType};

node! {
    /// Whether the ray is of one of the types marked.
    ray_is in rays,
    source "mental ray manual, miState",
    inputs {
        /// The type of the ray, as in the state.
        ray_type: integer = state(Field::RayType), in 0.0..=6.0;
        /// Whether rays from the camera count.
        eye: boolean = false;
        /// Whether rays of `trace_reflection` count.
        reflection: boolean = false;
        /// Whether rays of `trace_refraction` count.
        refraction: boolean = false;
        /// Whether rays of `trace_transparent` count.
        transparent: boolean = false;
        /// Whether rays from lights count.
        shadow: boolean = false;
        /// Whether rays of `trace_environment` count.
        environment: boolean = false;
        /// Whether rays for displacement count.
        displace: boolean = false;
    }
    outputs {
        /// Whether it is.
        result: boolean;
    }
    body |e, i| {
        let result = (i.eye & is(e, i.ray_type, RayType::Eye))
            | (i.reflection & is(e, i.ray_type, RayType::Reflection))
            | (i.refraction & is(e, i.ray_type, RayType::Refraction))
            | (i.transparent & is(e, i.ray_type, RayType::Transparent))
            | (i.shadow & is(e, i.ray_type, RayType::Shadow))
            | (i.environment & is(e, i.ray_type, RayType::Environment))
            | (i.displace & is(e, i.ray_type, RayType::Displace));
        Outputs { result }
    }
}

/// Whether a number is that of a type of ray.
#[inline(always)]
pub fn is<E: Emit>(e: E, number: E::Int, ray_type: RayType) -> E::Mask {
    number.equal(e.int(ray_type as i32))
}

#[cfg(test)]
mod tests {
    #[test]
    fn any_of_the_marked() {
        let marked =
            |ray_type: i32| truth!(ray_type = ray_type, shadow = true, displace = true => result);
        let answers = [-1, 0, 1, 2, 3, 4, 5, 6, 7].map(marked);
        assert_eq!(answers, [false, false, false, false, false, true, false, true, false]);
        assert!(truth!(eye = true => result));
        for ray_type in -1..8 {
            assert!(!truth!(ray_type = ray_type => result));
        }
    }
}
