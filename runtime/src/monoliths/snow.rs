use glam::{Vec3, Vec4, Vec4Swizzles};
use phenomenon_compiler::effects::{Effect, Trace};
use phenomenon_compiler::engine::Shaded;
use phenomenon_compiler::graph::RootKind;
use phenomenon_compiler::state::{Field, State};

use super::arithmetic::{Arithmetic, Facing};
use super::asking::Asking;
use super::optics::{media, refract};
use super::pointwise::{Parameter, PointShader};
use super::site::Site;

const THROUGH: Site = Site::of("thin/through");

/// Distance over which slopes of the grain are taken.
const STEP: f32 = 0.004;
/// How far crystals are tilted.
const TILT: f32 = 0.8;
/// Exponent of a flash.
const SHINY: f32 = 50.0;

/// `graphs/snow/snow.json` by hand, with `graphs/snow/glitter.json` in it.
#[derive(Clone, Debug)]
pub struct Snow {
    /// Colour of the snow.
    pub base_color: Vec4,
    /// Colour at large angles.
    pub back_color: Vec4,
    /// Light from the sky.
    pub ambient_color: Vec4,
    /// Colour of the crystals' flashes.
    pub specular_color: Vec4,
    /// Share of the surface that crystals cover.
    pub glitter: f32,
    /// Room a crystal takes, in scene units.
    pub crystal: f32,
    /// Height of the grain, in scene units.
    pub grain: f32,
    /// Width of its largest lumps, in scene units.
    pub grain_size: f32,
    /// What shows through where the snow is thinnest.
    pub transparency: f32,
    /// Thickness at which nothing shows through, in scene units.
    pub depth: f32,
    /// Index of refraction.
    pub ior: f32,
}

impl Default for Snow {
    fn default() -> Self {
        Self {
            base_color: Vec4::new(0.86, 0.88, 0.9, 1.0),
            back_color: Vec4::new(0.45, 0.62, 0.95, 1.0),
            ambient_color: Vec4::new(0.2, 0.27, 0.4, 1.0),
            specular_color: Vec4::new(3.0, 3.0, 3.0, 1.0),
            glitter: 0.6,
            crystal: 0.012,
            grain: 0.006,
            grain_size: 0.08,
            transparency: 0.5,
            depth: 0.6,
            ior: 1.31,
        }
    }
}

impl PointShader for Snow {
    const ROOTS: &'static [(RootKind, &'static [Effect])] =
        &[(RootKind::Material, &[Effect::TraceRefraction, Effect::LightColor])];

    const FIELDS: &'static [Field] =
        &[Field::WorldToObject, Field::DerivativeU, Field::DerivativeV, Field::DpDx];

    fn parameter(&mut self, name: &str) -> Option<Parameter<'_>> {
        Some(match name {
            "base_color" => Parameter::Color(&mut self.base_color),
            "back_color" => Parameter::Color(&mut self.back_color),
            "ambient_color" => Parameter::Color(&mut self.ambient_color),
            "specular_color" => Parameter::Color(&mut self.specular_color),
            "glitter" => Parameter::Scalar(&mut self.glitter),
            "crystal" => Parameter::Scalar(&mut self.crystal),
            "grain" => Parameter::Scalar(&mut self.grain),
            "grain_size" => Parameter::Scalar(&mut self.grain_size),
            "transparency" => Parameter::Scalar(&mut self.transparency),
            "depth" => Parameter::Scalar(&mut self.depth),
            "ior" => Parameter::Scalar(&mut self.ior),
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
        Shaded { color: self.material::<A>(point, asking).into(), ok: true }
    }
}

impl Snow {
    #[inline(always)]
    fn material<A: Arithmetic>(&self, point: &State, asking: &mut Asking<'_>) -> Vec4 {
        // What lets no ray in lets none out.
        let (mut behind, mut thinness) = (Vec4::W, 0.0);
        if self.transparency != 0.0 {
            let (direction, _) = refract::<A>(point, self.ior);
            let seen = asking.trace(Trace::Refraction, point, direction, THROUGH);
            behind = seen.color.into();
            thinness = if seen.hit { 1.0 - A::share(seen.distance, self.depth) } else { 0.0 };
        }
        // The far side only lets the ray out.
        if point.inv_normal || self.transparency == 1.0 && thinness == 1.0 {
            return behind;
        }
        let surface = self.surface::<A>(point, asking);
        A::mix(surface, A::mix(surface, behind, thinness), self.transparency)
    }

    /// Light of the sky and of all lights from the grain, and the flashes of crystals.
    #[inline(always)]
    fn surface<A: Arithmetic>(&self, point: &State, asking: &mut Asking<'_>) -> Vec4 {
        let grain = self.grain::<A>(point, asking);
        let grain_color = self.color::<A>(point, A::dot(grain, point.direction.into()));
        let (crystal, flash) = self.crystal::<A>(point, asking);
        let [mut matt, mut glitter] = [Vec3::ZERO; 2];
        for number in 0..asking.lights() {
            let Some(light) = asking.light(point, number) else { continue };
            let cosine = A::dot(grain, light.direction);
            let facing =
                Facing { normal: crystal, light: light.direction, ray: point.direction.into() };
            let may_flash = A::is_lit(&facing);
            if cosine > 0.0 || may_flash {
                let light = asking.light_color(point, &light);
                if cosine > 0.0 {
                    matt += A::lambert(grain_color, light, cosine);
                }
                if may_flash && flash != Vec3::ZERO {
                    glitter += A::phong(&facing, SHINY, flash, light);
                }
            }
        }
        let sky = self.ambient_color.xyz() * self.color::<A>(point, point.dot_nd);
        (sky + matt + glitter).extend(self.ambient_color.w)
    }

    /// The colour of snow that the ray meets at an angle of this cosine, which is at most 0.
    #[inline(always)]
    fn color<A: Arithmetic>(&self, point: &State, dot_nd: f32) -> Vec3 {
        let (n1, n2) = media(point, self.ior);
        A::mix(self.base_color, self.back_color, A::fresnel(n1, n2, -dot_nd)).xyz()
    }

    /// The normal of the grain: lumps in the space of the object.
    #[inline(always)]
    fn grain<A: Arithmetic>(&self, point: &State, asking: &Asking<'_>) -> Vec3 {
        let to_object = asking.look_up::<16>(Field::WorldToObject, point);
        let derivatives = [Field::DerivativeU, Field::DerivativeV]
            .map(|field| asking.look_up::<3>(field, point).into());
        let (here, normal) = (Vec3::from(point.point), point.normal.into());
        let [u, v] = A::ways(derivatives, normal);
        let mut heights = [0.0; 3];
        for (height, place) in heights.iter_mut().zip([here, here + u * STEP, here + v * STEP]) {
            let place = A::point_through(&to_object, place) * (1.0 / self.grain_size);
            *height = A::perlin_octaves(place, 3, 0.6) * self.grain;
        }
        let (direction, surface) = (point.direction.into(), point.normal_geom.into());
        A::bumped([u, v], heights, STEP, normal, direction, surface)
    }

    /// The normal of the crystal there, and how brightly it flashes. None is smaller than what a pixel covers:
    /// farther away they double in size, in whole steps, and flash as much less. Where there is no crystal it
    /// is the surface's normal, and black.
    #[inline(always)]
    fn crystal<A: Arithmetic>(&self, point: &State, asking: &Asking<'_>) -> (Vec3, Vec3) {
        let covered = A::length(asking.look_up::<3>(Field::DpDx, point).into());
        let doubled = A::doubled(covered / self.crystal);
        let to_object = asking.look_up::<16>(Field::WorldToObject, point);
        let own = A::point_through(&to_object, point.point.into());
        let normal = point.normal.into();
        match A::flake(own / (self.crystal * doubled), self.glitter, TILT, normal) {
            Some(tilted) => (tilted, self.specular_color.xyz() * (1.0 / doubled)),
            None => (normal, Vec3::ZERO),
        }
    }
}
