use glam::{Vec3, Vec4, Vec4Swizzles};
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Field, State};

use super::arithmetic::{Arithmetic, Facing};
use super::asking::Asking;
use super::pointwise::{Parameter, PointShader};
use super::site::{Site, turns};

const AROUND: Site = Site::of("around");
const MIRROR: Site = Site::of("around/mirror");

/// `graphs/aniso/aniso_brdf.json` by hand.
#[derive(Clone, Debug)]
pub struct AnisoBrdf {
    /// Colour of the matt ground.
    pub surface_color: Vec4,
    /// Colour of the coat.
    pub specular_color: Vec4,
    /// Share of light the coat reflects head on.
    pub specular_reflectance: f32,
    /// Exponent along the brushing.
    pub ru: f32,
    /// Exponent across the brushing.
    pub rv: f32,
    /// 0 where the brush ran along the direction, 1 around it, 2 outwards from the centre.
    pub brush: i32,
    /// The direction of the brush, or the axis it ran around, in the space of the object.
    pub direction: Vec3,
    /// A point of the axis, in the space of the object.
    pub center: Vec3,
    /// Rays for each point that is not seen in a mirror.
    pub samples: i32,
}

impl Default for AnisoBrdf {
    fn default() -> Self {
        Self {
            surface_color: Vec4::new(0.12, 0.125, 0.135, 1.0),
            specular_color: Vec4::new(0.97, 0.96, 0.94, 1.0),
            specular_reflectance: 0.55,
            ru: 900.0,
            rv: 14.0,
            brush: 1,
            direction: Vec3::Y,
            center: Vec3::ZERO,
            samples: 4,
        }
    }
}

impl PointShader for AnisoBrdf {
    const ROOTS: &'static [(RootKind, &'static [Effect])] =
        &[(RootKind::Material, &[Effect::TraceReflection, Effect::LightColor])];

    const FIELDS: &'static [Field] = &[Field::ObjectToWorld];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "surface_color" => Parameter::Color(&mut self.surface_color),
            "specular_color" => Parameter::Color(&mut self.specular_color),
            "specular_reflectance" => Parameter::Scalar(&mut self.specular_reflectance),
            "ru" => Parameter::Scalar(&mut self.ru),
            "rv" => Parameter::Scalar(&mut self.rv),
            "brush" => Parameter::Integer(&mut self.brush),
            "direction" => Parameter::Vector(&mut self.direction),
            "center" => Parameter::Vector(&mut self.center),
            "samples" => Parameter::Integer(&mut self.samples),
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
        let tangent = self.brushed::<A>(point, asking);
        let mut color = self.lit::<A>(point, tangent, asking);
        if self.specular_reflectance != 0.0 {
            let mirrored = self.specular_color.xyz() * self.mirrored::<A>(point, tangent, asking);
            color += A::mix(Vec3::ZERO, mirrored, self.specular_reflectance);
        }
        Shaded { color: color.extend(1.0).into(), ok: true }
    }
}

impl AnisoBrdf {
    /// The way the brush went, at right angles to the normal.
    #[inline(always)]
    fn brushed<A: Arithmetic>(&self, point: &State, asking: &Asking<'_>) -> Vec3 {
        let to_world = asking.look_up(Field::ObjectToWorld, point);
        let axis = A::vector_through(&to_world, self.direction);
        let from_center = Vec3::from(point.point) - A::point_through(&to_world, self.center);
        let along = match self.brush {
            0 => axis,
            1 => A::cross(A::normalised(axis), A::normalised(from_center)),
            _ => from_center,
        };
        A::tangent_along(along, A::normalised(point.normal.into()))
    }

    /// The matt part and the highlights of all lights.
    #[inline(always)]
    fn lit<A: Arithmetic>(&self, point: &State, tangent: Vec3, asking: &mut Asking<'_>) -> Vec3 {
        let (normal, ray) = (point.normal.into(), point.direction.into());
        let frame = A::frame_along(normal, tangent);
        let specular = self.specular_color * self.specular_reflectance;
        let mut sum = Vec3::ZERO;
        for number in 0..asking.lights() {
            let Some(sample) = asking.light(point, number) else { continue };
            let facing = Facing { normal, light: sample.direction, ray };
            if A::is_lit(&facing) {
                let light = asking.light_color(point, &sample);
                let exponents = [self.ru, self.rv];
                let (coat, ground) = (specular, self.surface_color);
                sum += A::ashikhmin_shirley(&facing, &frame, exponents, coat, ground, light);
            }
        }
        sum
    }

    /// What the brushed coat mirrors, smeared.
    #[inline(always)]
    fn mirrored<A: Arithmetic>(
        &self,
        point: &State,
        tangent: Vec3,
        asking: &mut Asking<'_>,
    ) -> Vec3 {
        let (direction, normal) = (point.direction.into(), point.normal.into());
        let roughness = [self.ru, self.rv].map(|exponent| (2.0 / (exponent + 1.0)).sqrt());
        // What is seen in a mirror is not worth as many rays again.
        let count = if point.reflection_level == 0 { turns(self.samples) } else { 1 };
        let mut sum = Vec3::ZERO;
        for sample in 0..count {
            let numbers = AROUND.numbers(point, sample);
            let facet = A::facet(direction, normal, tangent, roughness, numbers);
            let to = A::reflect(direction, facet, point.normal_geom.into());
            sum += asking.see(Trace::Reflection, point, to, MIRROR.turn(sample)).xyz();
        }
        sum / count.max(1) as f32
    }
}
