//! Why rays are cast.

/// Declares the ray types with their names; their numbers follow the order.
macro_rules! ray_types {
    ($($(#[doc = $doc:literal])+ $variant:ident $name:literal = $number:literal;)+) => {
        /// Why a ray was cast.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(i32)]
        pub enum RayType { $($(#[doc = $doc])+ $variant = $number,)+ }

        impl RayType {
            /// Every ray type, in the order of their numbers.
            pub const ALL: [RayType; [$($number),+].len()] = [$(RayType::$variant),+];

            /// Name on the command line.
            pub fn name(self) -> &'static str {
                match self { $(RayType::$variant => $name,)+ }
            }
        }
    };
}

ray_types! {
    /// From the camera.
    Eye "eye" = 0;
    /// By `trace_reflection`.
    Reflection "reflection" = 1;
    /// By `trace_refraction`.
    Refraction "refraction" = 2;
    /// By `trace_transparent`.
    Transparent "transparent" = 3;
    /// From a light to the point it may light.
    Shadow "shadow" = 4;
    /// To the environment only.
    Environment "environment" = 5;
    /// For displacement; no engine runs it yet.
    Displace "displace" = 6;
}

impl RayType {
    /// The ray type of a number; an eye ray if there is none.
    pub fn from_number(number: i32) -> Self {
        let at = usize::try_from(number).ok();
        at.and_then(|at| RayType::ALL.get(at)).copied().unwrap_or(RayType::Eye)
    }
}
