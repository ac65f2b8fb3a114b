use glam::{Vec4, Vec4Swizzles};
use phenomenon_compiler::effects::Effect;
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Field, State};

use super::arithmetic::Arithmetic;
use super::asking::Asking;
use super::pointwise::{Parameter, PointShader};

/// `graphs/floor/checker_floor.json` by hand: tiles smaller than a pixel become their mean.
#[derive(Clone, Debug)]
pub struct CheckerFloor {
    /// Colour of the odd tiles.
    pub dark: Vec4,
    /// Colour of the even tiles.
    pub light: Vec4,
    /// Edge of a tile in scene units.
    pub size: f32,
    /// Light from the sky.
    pub ambient: Vec4,
}

impl Default for CheckerFloor {
    fn default() -> Self {
        Self {
            dark: Vec4::new(0.22, 0.2, 0.18, 1.0),
            light: Vec4::new(0.62, 0.6, 0.56, 1.0),
            size: 1.0,
            ambient: Vec4::new(0.3, 0.34, 0.4, 1.0),
        }
    }
}

impl PointShader for CheckerFloor {
    const ROOTS: &'static [(RootKind, &'static [Effect])] =
        &[(RootKind::Material, &[Effect::LightColor])];

    const FIELDS: &'static [Field] = &[Field::DpDx, Field::DpDy];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "dark" => Parameter::Color(&mut self.dark),
            "light" => Parameter::Color(&mut self.light),
            "size" => Parameter::Scalar(&mut self.size),
            "ambient" => Parameter::Color(&mut self.ambient),
            _ => return None,
        })
    }

    #[inline(always)]
    fn shade_point<A: Arithmetic>(
        &self,
        _: RootKind,
        point: &State,
        asking: &mut Asking<'_>,
    ) -> Shaded {
        let [x, _, z] = point.point;
        let [long_x, _, long_z] = asking.look_up::<3>(Field::DpDx, point);
        let [short_x, _, short_z] = asking.look_up::<3>(Field::DpDy, point);
        let across = A::mean_sign(x / self.size, [long_x / self.size, short_x / self.size]);
        let along = A::mean_sign(z / self.size, [long_z / self.size, short_z / self.size]);
        let odd = (across * along * -0.5 + 0.5).clamp(0.0, 1.0);
        let tile = A::mix(self.light, self.dark, odd);
        let lit = asking.matt::<A>(point, tile.xyz());
        let color = tile.xyz() * self.ambient.xyz() + lit;
        Shaded { color: color.extend(tile.w).into(), ok: true }
    }
}
