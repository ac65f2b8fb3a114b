//! Balls of glass under a sky, in 64 bits: every ray is bent or mirrored at the balls it meets, and mirrored rays see the
//! sky alone.

use serde_json::Value;

use crate::bounds::ROUNDING;
use crate::grazing::dielectric;
use crate::scenes::dot;

type Vector = [f64; 3];

/// Roundings by which a direction is nudged at each boundary: those of the ray, the normal and what is made of them.
const NUDGE: f64 = 4.0 * ROUNDING;

/// A ball.
#[derive(Debug)]
struct Ball {
    center: Vector,
    radius: f64,
    inside: f64,
    outside: f64,
}

/// The balls and the sky of a scene's text, and how often light is bent on its way.
#[derive(Debug)]
pub struct World {
    balls: Vec<Ball>,
    sky: [Vector; 3],
    bends: usize,
}

/// Where light is nudged: at which boundary, along which axis, which way. The fourth axis is the cosine, which shaders
/// are given in 32 bits: next to 1 it tells little of a small angle, and glass of the index 100 lives of small angles.
type Nudge = (usize, usize, f64);

fn rounded(value: &Value) -> f64 {
    f64::from(value.as_f64().expect("a number") as f32)
}

fn vector(value: &Value) -> Vector {
    [0, 1, 2].map(|axis| rounded(&value[axis]))
}

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

fn along(from: Vector, direction: Vector, far: f64) -> Vector {
    [0, 1, 2].map(|axis| from[axis] + direction[axis] * far)
}

impl World {
    /// Of a scene whose balls all are `furnace_glass.json`.
    pub fn of(scene: &Value) -> Self {
        let ball = |object: &Value| {
            let (sphere, set) = (&object["sphere"], &object["material"]["set"]);
            let index = |name: &str, otherwise: f64| match &set[name] {
                Value::Null => otherwise,
                value => rounded(value),
            };
            let center = sphere.get("center").map_or([0.0; 3], vector);
            let (inside, outside) = (index("ior", 1.5), index("outside", 1.0));
            Ball { center, radius: rounded(&sphere["radius"]), inside, outside }
        };
        let sky = &scene["environment"]["gradient"];
        Self {
            balls: scene["objects"].as_array().unwrap().iter().map(ball).collect(),
            sky: ["ground", "horizon", "zenith"].map(|name| vector(&sky[name])),
            bends: scene["options"]["trace_depth"][1].as_u64().unwrap() as usize,
        }
    }

    fn sky(&self, direction: Vector) -> Vector {
        let height = unit(direction)[1];
        let end = self.sky[if height < 0.0 { 0 } else { 2 }];
        [0, 1, 2].map(|k| self.sky[1][k] + (end[k] - self.sky[1][k]) * height.abs())
    }

    /// The nearest ball along a ray but the place it starts at, how far it is, and whether it is met from inside.
    fn meet(&self, from: Vector, direction: Vector) -> Option<(&Ball, f64, bool)> {
        let mut nearest: Option<(&Ball, f64, bool)> = None;
        for ball in &self.balls {
            let to = along(from, ball.center, -1.0);
            let way = -dot(to, direction);
            let closest = along(to, direction, way);
            let rest = ball.radius * ball.radius - dot(closest, closest);
            if rest <= 0.0 {
                continue;
            }
            for (far, inside) in [(way - rest.sqrt(), false), (way + rest.sqrt(), true)] {
                if far > 1e-9 && nearest.is_none_or(|(_, found, _)| far < found) {
                    nearest = Some((ball, far, inside));
                }
            }
        }
        nearest
    }

    /// What a ray sees.
    fn seen(&self, from: Vector, direction: Vector, bent: usize, nudge: Option<Nudge>) -> Vector {
        let (mut direction, mut factor) = (direction, 1.0);
        match nudge {
            Some((at, 3, by)) if at == bent => factor += by,
            Some((at, axis, by)) if at == bent => {
                direction[axis] += by;
                direction = unit(direction);
            }
            _ => {}
        }
        let hit = self.meet(from, direction).filter(|_| bent <= self.bends);
        let Some((ball, far, is_inside)) = hit else { return self.sky(direction) };
        let place = along(from, direction, far);
        let side = if is_inside { -1.0 } else { 1.0 };
        let normal = unit([0, 1, 2].map(|k| (place[k] - ball.center[k]) * side));
        let cosine = (-dot(direction, normal) * factor).min(1.0);
        let (n1, n2) = match is_inside {
            true => (ball.inside, ball.outside),
            false => (ball.outside, ball.inside),
        };
        let share = if n1 == n2 { 0.0 } else { dielectric(cosine, n1, n2) };
        let mirrored = self.sky(along(direction, normal, 2.0 * cosine));
        let squared = (n2 - n1) * (n2 + n1) + n1 * n1 * cosine * cosine;
        if squared <= 0.0 {
            return mirrored;
        }
        let bend = (n1 * cosine - squared.sqrt()) / n1;
        let beyond = unit(along(direction, normal, bend));
        let through = self.seen(place, beyond, bent + 1, nudge);
        [0, 1, 2].map(|k| mirrored[k] * share + through[k] * (1.0 - share))
    }

    /// What a camera's ray sees, and how far 32 bits may be off: a few units in the last place, and what it changes by
    /// when the ray, or its cosine, is nudged at each boundary, both ways.
    pub fn seen_from(&self, from: Vector, direction: Vector) -> (Vector, Vector) {
        let direction = unit(direction);
        let here = self.seen(from, direction, 0, None);
        let mut allowed = here.map(|x| 16.0 * ROUNDING * x.abs() + ROUNDING);
        for boundary in 0..=self.bends {
            for axis in 0..4 {
                let changes = [NUDGE, -NUDGE].map(|by| {
                    let nudged = self.seen(from, direction, 0, Some((boundary, axis, by)));
                    [0, 1, 2].map(|k| (nudged[k] - here[k]).abs())
                });
                for (k, allowed) in allowed.iter_mut().enumerate() {
                    *allowed += changes[0][k].max(changes[1][k]);
                }
            }
        }
        (here, allowed)
    }
}

/// Renders a scene of glass under a sky of colours, light mirrored seeing the sky alone, and compares each pixel.
pub fn hold(case: &str, side: u32, bends: u32) {
    use phenomenon_runtime::camera::Camera;

    let mut scene: Value = serde_json::from_str(&crate::scenes::text(case)).unwrap();
    scene["environment"] = serde_json::json!({ "gradient": {
        "zenith": [2, 1, 0.1], "horizon": [0, 0.5, 1], "ground": [0.3, 0, 2] } });
    scene["options"]["trace_depth"] = serde_json::json!([0, bends, bends]);
    let numbers = |name: &str| [0, 1, 2].map(|k| scene["camera"][name][k].as_f64().unwrap());
    let degrees = scene["camera"]["field_of_view"].as_f64().unwrap();
    let camera =
        Camera::new(numbers("position"), numbers("look_at"), [0.0, 1.0, 0.0], degrees).unwrap();
    let (world, text) = (World::of(&scene), scene.to_string());
    let pixels =
        crate::scenes::pixels(side, 1, |options| crate::scenes::scene(case, &text, options));
    let (mut worst, mut loose) = (0.0_f64, 0);
    for (at, (from, direction)) in crate::scenes::rays(&camera, side).into_iter().enumerate() {
        let (expected, allowed) = world.seen_from(from, direction);
        // Nearly all pixels are told to 10^-4; others look through the edge of a ball.
        loose += u32::from(allowed.iter().any(|allowed| *allowed > 1e-4));
        for k in 0..3 {
            let off = (f64::from(pixels[at][k]) - expected[k]).abs();
            worst = worst.max(off / allowed[k]);
            assert!(off <= allowed[k], "{case}, pixel {at}: {:?} for {expected:?}", pixels[at]);
        }
    }
    println!("{case}: at most {worst:.2} of what is allowed; {loose} pixels are ill-conditioned");
    assert!(loose * 10 < side * side, "{loose} of the pixels say nothing");
}
