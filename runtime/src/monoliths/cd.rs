use glam::{Vec3, Vec4, Vec4Swizzles};
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Field, State};

use super::arithmetic::{Arithmetic, Facing};
use super::asking::Asking;
use super::optics::reflect;
use super::pointwise::{Parameter, PointShader};
use super::site::Site;

const MIRROR: Site = Site::of("mirror");

/// `graphs/cd/cd.json` by hand.
#[derive(Clone, Debug)]
pub struct Cd {
    /// Matt colour of the disc.
    pub base_color: Vec4,
    /// Colour of the spectra.
    pub specular_color: Vec4,
    /// Share of the mirror image head on.
    pub reflectivity: Vec4,
    /// Wavelengths between grooves.
    pub dispersion: f32,
    /// Saturation of the spectra.
    pub purity: f32,
    /// Roughness along the grooves.
    pub along: f32,
    /// Roughness across them.
    pub across: f32,
    /// Radius within which there are no grooves.
    pub hub: f32,
    /// The axis of the grooves, in the space of the object.
    pub axis: Vec3,
    /// The middle, in the space of the object.
    pub center: Vec3,
}

impl Default for Cd {
    fn default() -> Self {
        Self {
            base_color: Vec4::new(0.05, 0.05, 0.055, 1.0),
            specular_color: Vec4::ONE,
            reflectivity: Vec4::new(0.5, 0.52, 0.55, 1.0),
            dispersion: 2.8,
            purity: 0.85,
            along: 0.07,
            across: 0.9,
            hub: 0.42,
            axis: Vec3::Y,
            center: Vec3::ZERO,
        }
    }
}

impl PointShader for Cd {
    const ROOTS: &'static [(RootKind, &'static [Effect])] =
        &[(RootKind::Material, &[Effect::TraceReflection, Effect::LightColor])];

    const FIELDS: &'static [Field] = &[Field::ObjectToWorld];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "base_color" => Parameter::Color(&mut self.base_color),
            "specular_color" => Parameter::Color(&mut self.specular_color),
            "reflectivity" => Parameter::Color(&mut self.reflectivity),
            "dispersion" => Parameter::Scalar(&mut self.dispersion),
            "purity" => Parameter::Scalar(&mut self.purity),
            "along" => Parameter::Scalar(&mut self.along),
            "across" => Parameter::Scalar(&mut self.across),
            "hub" => Parameter::Scalar(&mut self.hub),
            "axis" => Parameter::Vector(&mut self.axis),
            "center" => Parameter::Vector(&mut self.center),
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
        let lit = self.lit::<A>(point, asking);
        let fresnel = A::schlick(self.reflectivity.xyz(), -point.dot_nd);
        let mirrored = asking.see(Trace::Reflection, point, reflect::<A>(point), MIRROR);
        Shaded { color: (lit + fresnel * mirrored.xyz()).extend(1.0).into(), ok: true }
    }
}

impl Cd {
    /// Light of all lights: from the matt disc, and drawn out by the grooves.
    #[inline(always)]
    fn lit<A: Arithmetic>(&self, point: &State, asking: &mut Asking<'_>) -> Vec3 {
        let to_world = asking.look_up::<16>(Field::ObjectToWorld, point);
        let axle = A::vector_through(&to_world, self.axis);
        let from_middle = Vec3::from(point.point) - A::point_through(&to_world, self.center);
        let is_grooved = A::length(from_middle) >= self.hub;
        let around = A::cross(A::normalised(axle), A::normalised(from_middle));
        let (normal, ray) = (point.normal.into(), point.direction.into());
        let [groove, outwards] = A::brushed(normal, around);
        let frame = A::square(normal, groove);
        let mut sum = Vec3::ZERO;
        for number in 0..asking.lights() {
            let Some(light) = asking.light(point, number) else { continue };
            let facing = Facing { normal, light: light.direction, ray };
            let cosine = A::dot(normal, light.direction);
            if cosine > 0.0 {
                let light = asking.light_color(point, &light);
                let mut color = A::lambert(self.base_color.xyz(), light, cosine);
                if is_grooved && A::is_lit(&facing) {
                    let spectrum = self.spectrum::<A>(&facing, outwards);
                    color += A::ward(&facing, &frame, [self.along, self.across], spectrum, light);
                }
                sum += color;
            }
        }
        sum
    }

    /// The colour of light that grooves spread: by the path between two of them, in wavelengths.
    #[inline(always)]
    fn spectrum<A: Arithmetic>(&self, facing: &Facing, outwards: Vec3) -> Vec3 {
        let order = A::dot(facing.light - facing.ray, outwards).abs() * self.dispersion;
        // The mirror image is not dispersed.
        let apart = A::smooth_step(order, 0.05, 0.4);
        A::of_hue(-order, apart * self.purity, 1.0) * self.specular_color.xyz()
    }
}
