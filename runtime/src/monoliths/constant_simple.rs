use glam::Vec4;
use phenomenon_compiler::effects::Effect;
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{RayType, State};

use super::arithmetic::Arithmetic;
use super::asking::Asking;
use super::pointwise::{Parameter, PointShader};

/// `graphs/constant/constant_simple.json` by hand.
#[derive(Clone, Debug)]
pub struct ConstantSimple {
    /// The colour.
    pub color: Vec4,
}

impl Default for ConstantSimple {
    fn default() -> Self {
        Self { color: Vec4::new(0.8, 0.3, 0.1, 1.0) }
    }
}

impl PointShader for ConstantSimple {
    const ROOTS: &'static [(RootKind, &'static [Effect])] = &[(RootKind::Material, &[])];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        match name {
            "color" => Some(Parameter::Color(&mut self.color)),
            _ => None,
        }
    }

    #[inline(always)]
    fn shade_point<A: Arithmetic>(&self, _: RootKind, point: &State, _: &mut Asking<'_>) -> Shaded {
        let ok = !matches!(point.ray_type, RayType::Shadow | RayType::Displace);
        Shaded { color: self.color.into(), ok }
    }
}
