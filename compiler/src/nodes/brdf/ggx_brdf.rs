use std::f64::consts::PI;

use crate::emit::functions::distributions::roughness;
use crate::emit::functions::facets::lit;
use crate::emit::functions::frames::Frame;
use crate::emit::functions::reflected::shown;
use crate::emit::{Real, Vector};
use crate::nodes::finite::UNIT;
use crate::nodes::fresnel::fresnel_schlick::schlick_color;
use crate::nodes::{NOT_NEGATIVE, WHITE, node, state};
use crate::state::Field;

node! {
    /// Reflectance of small mirrors whose normals are spread as those of ellipsoids (Trowbridge and Reitz, GGX),
    /// with Smith's share of visible ones, heights towards light and viewer correlated, and Schlick's Fresnel
    /// term. With `k = (s·u / a)^2 + (s·v / b)^2 + (s·n)^2`, `s = l + v`, and `|x|'` the length of x once `u` is scaled
    /// by a and `v` by b: `(|s|^2 / k)^2 / (pi a b) F / (2 ((n·l) |v|' + (n·v) |l|'))`. Draw directions by `ggx_sample`.
    ///
    /// The roughness is alpha; Disney's, MaterialX's `roughness` of standard surfaces and Blender's are its square
    /// root. Reciprocal, and at most all light is reflected; what mirrors send to each other is lost. A
    /// roughness below 10^-6 counts as that.
    ggx_brdf in brdf,
    source "Walter and others 2007, Microfacet Models for Refraction; Heitz 2014, Understanding the Masking-Shadowing Function",
    inputs {
        /// Shading normal, unit length.
        normal: vector = state(Field::Normal), in -1.0..=1.0;
        /// Direction towards the light, unit length.
        direction: vector = state(Field::LightDirection), in -1.0..=1.0;
        /// Direction of the ray, towards the surface, unit length.
        ray: vector = state(Field::Direction), in -1.0..=1.0;
        /// Direction along the surface that `roughness_u` goes by, by default that of u; put at right
        /// angles to the normal. Any is taken where this is zero or along the normal.
        tangent: vector = node("frame_from_derivatives"), in -1.0..=1.0;
        /// Roughness alpha along the tangent.
        roughness_u: scalar = 0.2, in UNIT;
        /// Roughness alpha across it.
        roughness_v: scalar = 0.2, in UNIT;
        /// Reflectance head on.
        f0: color = [0.04, 0.04, 0.04, 1.0], in UNIT;
        /// Reflectance at grazing angles.
        f90: color = WHITE, in UNIT;
    }
    outputs {
        /// The reflectance, per steradian; alpha is 1.
        value: color, in NOT_NEGATIVE;
    }
    body |e, i| {
        let frame = Frame::along(i.normal, i.tangent);
        let ggx = Ggx::of(&frame, i.direction, i.ray, i.roughness_u, i.roughness_v);
        let fresnel = schlick_color(i.f0, i.f90, ggx.cosine_half());
        Outputs { value: shown(lit(i.normal, i.direction, i.ray), fresnel * ggx.specular()) }
    }
}

/// Two directions in the frame of the surface, and their sum.
pub struct Ggx<R: Real> {
    /// Towards the light.
    light: Vector<R>,
    /// Towards the viewer.
    viewer: Vector<R>,
    /// Of both, in the frame.
    sum: Vector<R>,
    /// Roughness along both axes.
    roughness: [R; 2],
}

impl<R: Real> Ggx<R> {
    /// Of a direction towards the light and a ray towards the surface.
    #[inline(always)]
    pub fn of(frame: &Frame<R>, light: Vector<R>, ray: Vector<R>, u: R, v: R) -> Self {
        Self {
            light: frame.local(light),
            viewer: -frame.local(ray),
            sum: frame.local(light - ray),
            roughness: [roughness(u), roughness(v)],
        }
    }

    /// Cosine between the half vector and either direction.
    #[inline(always)]
    pub fn cosine_half(&self) -> R {
        (self.sum.dot(self.sum).sqrt() * 0.5).saturate()
    }

    /// The distribution at the half vector.
    #[inline(always)]
    fn distribution(&self) -> R {
        let [a, b] = self.roughness;
        let (x, y) = (self.sum.x / a, self.sum.y / b);
        let stretched = x.mul_add(x, y.mul_add(y, self.sum.z * self.sum.z));
        let share = self.sum.dot(self.sum) / stretched;
        share / a * (share / b) * (1.0 / PI)
    }

    /// Length of a direction once it is scaled by the roughness.
    #[inline(always)]
    fn stretched(&self, direction: Vector<R>) -> R {
        let [a, b] = self.roughness;
        let (x, y) = (direction.x * a, direction.y * b);
        x.mul_add(x, y.mul_add(y, direction.z * direction.z)).sqrt()
    }

    /// The reflectance of perfect mirrors, where light and viewer are above the surface.
    #[inline(always)]
    pub fn specular(&self) -> R {
        let (light, viewer) = (self.stretched(self.light), self.stretched(self.viewer));
        let crossed = self.light.z.mul_add(viewer, self.viewer.z * light);
        self.distribution() * 0.5 / crossed
    }

    /// Density of the light's direction among those mirrored at visible facets.
    #[inline(always)]
    pub fn density(&self) -> R {
        self.distribution() * 0.5 / (self.viewer.z + self.stretched(self.viewer))
    }

    /// Whether the half vector, and the viewer, are above the surface.
    #[inline(always)]
    pub fn upright(&self) -> R::Mask {
        let zero = self.sum.z.same(0.0);
        self.sum.z.greater(zero) & self.viewer.z.greater(zero)
    }
}

#[cfg(test)]
mod tests {
    const UP: [f32; 3] = [0.0, 0.0, 1.0];
    /// Values times cosine of others.
    #[test]
    fn known_values() {
        for (outer, inner, turn, expected) in
            [(60.0, 60.0, 170.0, 0.4228253), (75.0, 80.0, 180.0, 0.474614)]
        {
            let at = |angle: f64, turn: f64| {
                let (angle, turn): (f64, f64) = (angle.to_radians(), turn.to_radians());
                [angle.sin() * turn.cos(), angle.sin() * turn.sin(), angle.cos()]
            };
            let ray = at(outer, 0.0).map(|x| -x as f32);
            let direction = at(inner, turn).map(|x| x as f32);
            let white = [1.0; 4];
            let value = number!(normal = UP, direction = direction, ray = ray, roughness_u = 0.5, roughness_v = 0.5, f0 = white => value);
            let both = [inner, outer].map(|angle: f64| f64::from(value) * angle.to_radians().cos());
            let near = both.map(|value| (value - expected).abs() < 3e-6 * expected);
            assert!(near[0] || near[1], "{both:?} for {expected}");
        }
    }
}
