use glam::{Vec3, Vec4, Vec4Swizzles};
use phenomenon_compiler::effects::Effect;
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Field, State};

use super::arithmetic::{Arithmetic, Facing, Frame};
use super::asking::Asking;
use super::pointwise::{Parameter, PointShader};

/// Roughness along a thread, of that across it.
const NARROW: f32 = 0.35;

/// `graphs/silk/silk.json` by hand.
#[derive(Clone, Debug)]
pub struct Silk {
    /// Colour of the dye.
    pub base_color: Vec4,
    /// Colour of the threads along v, and of their lustre.
    pub metallic_color: Vec4,
    /// Colour of the lustre of the threads along u.
    pub specular_color: Vec4,
    /// Light from everywhere.
    pub ambient_color: Vec4,
    /// How far a lustre is drawn out.
    pub spread: f32,
    /// Share of the threads along v.
    pub metallic: f32,
    /// Threads a turn of u or v.
    pub threads: f32,
    /// How uneven the threads are.
    pub unevenness: f32,
}

impl Default for Silk {
    fn default() -> Self {
        Self {
            base_color: Vec4::new(0.13, 0.002, 0.014, 1.0),
            metallic_color: Vec4::new(0.85, 0.32, 0.04, 1.0),
            specular_color: Vec4::new(0.75, 0.17, 0.27, 1.0),
            ambient_color: Vec4::new(0.3, 0.3, 0.34, 1.0),
            spread: 0.32,
            metallic: 0.5,
            threads: 500.0,
            unevenness: 0.35,
        }
    }
}

impl PointShader for Silk {
    const ROOTS: &'static [(RootKind, &'static [Effect])] =
        &[(RootKind::Material, &[Effect::LightColor])];

    const FIELDS: &'static [Field] = &[Field::U, Field::V, Field::DerivativeU];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "base_color" => Parameter::Color(&mut self.base_color),
            "metallic_color" => Parameter::Color(&mut self.metallic_color),
            "specular_color" => Parameter::Color(&mut self.specular_color),
            "ambient_color" => Parameter::Color(&mut self.ambient_color),
            "spread" => Parameter::Scalar(&mut self.spread),
            "metallic" => Parameter::Scalar(&mut self.metallic),
            "threads" => Parameter::Scalar(&mut self.threads),
            "unevenness" => Parameter::Scalar(&mut self.unevenness),
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
        let [u, v] = point.uv;
        let warp = self.thread::<A>(u, v);
        let weft = if self.metallic != 0.0 { self.thread::<A>(v, u) } else { 0.0 };
        // Of the matt colour the threads along v take little.
        let crossed = A::mix(self.base_color, self.metallic_color, weft * 0.08);
        let cloth = A::mix(self.base_color, crossed, self.metallic).xyz() * warp;
        let edge = A::power(point.dot_nd + 1.0, 5.0);
        let matt = cloth + self.specular_color.xyz() * edge;
        let ambient = self.ambient_color.xyz() * cloth;
        let [lit, lustre] = self.lit::<A>(point, matt, [warp, weft], asking);
        Shaded { color: (ambient + lit + lustre).extend(self.ambient_color.w).into(), ok: true }
    }
}

impl Silk {
    /// How much of a thread shows: a noise drawn out along it, about 1.
    #[inline(always)]
    fn thread<A: Arithmetic>(&self, along: f32, across: f32) -> f32 {
        let place = Vec3::new(along * 5.0, across * self.threads, 0.37);
        (A::perlin_octaves(place, 2, 0.5) * self.unevenness + 1.0).clamp(0.0, 2.0)
    }

    /// Light of all lights from the matt cloth, and from the lustre of its threads.
    #[inline(always)]
    fn lit<A: Arithmetic>(
        &self,
        point: &State,
        matt: Vec3,
        [warp, weft]: [f32; 2],
        asking: &mut Asking<'_>,
    ) -> [Vec3; 2] {
        let (normal, ray) = (point.normal.into(), point.direction.into());
        let derivative = asking.look_up::<3>(Field::DerivativeU, point).into();
        let [along_u, along_v] = A::brushed(normal, derivative).map(|way| A::square(normal, way));
        let (warp, weft) = (self.specular_color.xyz() * warp, self.metallic_color.xyz() * weft);
        let [mut lit, mut along, mut across] = [Vec3::ZERO; 3];
        for number in 0..asking.lights() {
            let Some(light) = asking.light(point, number) else { continue };
            let facing = Facing { normal, light: light.direction, ray };
            let cosine = A::dot(normal, light.direction);
            if cosine > 0.0 {
                let light = asking.light_color(point, &light);
                lit += A::lambert(matt, light, cosine);
                along += self.lustre::<A>(&facing, &along_u, warp, light, 1.0 - self.metallic);
                across += self.lustre::<A>(&facing, &along_v, weft, light, self.metallic);
            }
        }
        [lit, A::mix(along, across, self.metallic)]
    }

    /// The lustre of threads that run along a frame: narrow along them and wide across.
    #[inline(always)]
    fn lustre<A: Arithmetic>(
        &self,
        facing: &Facing,
        frame: &Frame,
        color: Vec3,
        light: Vec3,
        share: f32,
    ) -> Vec3 {
        if share == 0.0 || !A::is_lit(facing) {
            return Vec3::ZERO;
        }
        A::ward(facing, frame, [self.spread * NARROW, self.spread], color, light)
    }
}
