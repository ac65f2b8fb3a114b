//! Spheres of radius 10^-4 to 10^6, seen from near and far: their normals, and the edge of their picture.

use phenomenon_compiler::engine::Options;
use phenomenon_runtime::camera::Camera;
use phenomenon_runtime::geometry::Transform;
use phenomenon_runtime::lights::Environment;
use phenomenon_runtime::scene::{Scene, SceneBuilder};

use crate::bounds::ROUNDING;
use crate::scenes::{dot, pixels, rays, shader};

/// The unit roundoff of 64 bits.
const U: f64 = f64::EPSILON / 2.0;
const SIDE: u32 = 24;
/// What rays see that miss.
const SKY: f32 = 4.0;

/// A sphere, and a camera that looks at it.
pub struct Seen {
    /// Middle of the sphere.
    pub center: [f64; 3],
    /// Its radius.
    pub radius: f64,
    /// Where the camera stands, from the middle.
    pub away: [f64; 3],
    /// Its field of view.
    pub degrees: f64,
}

impl Seen {
    fn camera(&self) -> Camera {
        let position = [0, 1, 2].map(|k| self.center[k] + self.away[k]);
        Camera::new(position, self.center, [0.0, 1.0, 0.0], self.degrees).unwrap()
    }

    fn scene(&self, options: Options) -> Scene {
        let mut builder = SceneBuilder::new(self.camera());
        let material = builder.material(shader("normals.json", options));
        builder.sphere(self.center, self.radius, &Transform::default(), material).unwrap();
        builder.environment(Environment::Constant([SKY; 4]));
        builder.build().unwrap()
    }

    /// Half the normal and one half where a ray meets the sphere as it stands in 32 bits, and how far off that may
    /// be; none where 64 bits cannot tell whether it does.
    fn normal(&self, [origin, direction]: [[f64; 3]; 2]) -> Option<Option<([f64; 3], f64)>> {
        let center = self.center.map(|x| f64::from(x as f32));
        let radius = f64::from(self.radius as f32);
        let from = [0, 1, 2].map(|k| origin[k] - center[k]);
        let a = dot(direction, direction);
        let along = -dot(from, direction) / a;
        let closest = [0, 1, 2].map(|k| from[k] + direction[k] * along);
        let rest = 1.0 - dot(closest, closest) / (radius * radius);
        // The closest point is known to some roundings of how far the camera is, in radii.
        let away = dot(from, from).sqrt() / radius;
        if rest.abs() < 64.0 * U * away {
            return None;
        }
        if rest < 0.0 {
            return Some(None);
        }
        let cosine = rest.sqrt();
        let normal = [0, 1, 2].map(|k| closest[k] / radius - direction[k] * cosine / a.sqrt());
        // What the place of the hit is off by, over the cosine, then four roundings to 32 bits.
        let place = center.iter().chain(&origin).map(|x| x.abs()).fold(0.0, f64::max) / radius;
        let off = 64.0 * U * (away + place) / cosine + 4.0 * ROUNDING;
        Some(Some((normal.map(|x| 0.5 * x + 0.5), off)))
    }

    /// Renders it and compares all pixels; the largest share of what is allowed.
    pub fn hold(&self) -> f64 {
        let found = pixels(SIDE, 1, |options| self.scene(options));
        let (mut met, mut worst) = (0, 0.0_f64);
        for (pixel, (origin, direction)) in found.iter().zip(rays(&self.camera(), SIDE)) {
            match self.normal([origin, direction]) {
                None => {}
                Some(None) => assert_eq!(*pixel, [SKY; 3], "radius {}", self.radius),
                Some(Some((normal, allowed))) => {
                    met += 1;
                    for component in 0..3 {
                        let off = (f64::from(pixel[component]) - normal[component]).abs();
                        worst = worst.max(off / allowed);
                        assert!(off <= allowed, "radius {}: {pixel:?} {normal:?}", self.radius);
                    }
                }
            }
        }
        assert!(met > 20, "radius {}: it is hardly seen: {met}", self.radius);
        worst
    }
}

#[test]
fn spheres_of_every_size_are_round() {
    let mut worst = 0.0_f64;
    for radius in [1e-4, 1e-2, 1.0, 1e3, 1e6] {
        for (distance, degrees) in [(1.0 + 1e-3, 100.0), (3.0, 45.0), (1e4, 0.015)] {
            let away = [0.36, 0.48, 0.8].map(|x| x * radius * distance);
            worst = worst.max(Seen { center: [0.0; 3], radius, away, degrees }.hold());
        }
    }
    println!("sphere_sizes: at most {worst:.2} of what is allowed");
}
