//! The points that are shaded.

use glam::Vec3;
use phenomenon_compiler::state::{RayType, State};
use phenomenon_runtime::sampling::mixed;

/// Points of a pass over all of them.
pub const STATES: usize = 1024;

/// Points of one ray type in a row: whoever shades fewer at once shades one type at a time.
const IN_A_ROW: usize = STATES / RAY_TYPES.len();

const RAY_TYPES: [RayType; 4] =
    [RayType::Eye, RayType::Reflection, RayType::Refraction, RayType::Transparent];

/// Points all over a room, seen from all sides and from inside, in no order: neighbours have nothing in
/// common, so no branch can be foreseen.
pub fn states() -> Vec<State> {
    (0..STATES).map(state).collect()
}

fn state(number: usize) -> State {
    let draw = |nth: u64| (mixed(number as u64 * 64 + nth) >> 40) as f32 / (1 << 24) as f32;
    let within = |nth: u64, low: f32, high: f32| low + draw(nth) * (high - low);
    let vector = |nth: u64| Vec3::from([0, 1, 2].map(|axis| within(nth + axis, -1.0, 1.0)));
    let direction = vector(0).normalize_or(Vec3::NEG_Z);
    let outwards = vector(3).normalize_or(Vec3::Z);
    // On the side the ray came from.
    let normal = if outwards.dot(direction) > 0.0 { -outwards } else { outwards };
    let (point, dist) = (vector(6) * 4.0, within(9, 0.5, 10.0));
    let level = |nth: u64| (draw(nth) * 4.0) as i32;
    State {
        origin: (point - direction * dist).into(),
        direction: direction.into(),
        point: point.into(),
        normal: normal.into(),
        normal_geom: normal.into(),
        dot_nd: normal.dot(direction).clamp(-1.0, 0.0),
        dist,
        inv_normal: draw(10) < 0.5,
        ior: within(11, 1.0, 2.0),
        ior_in: within(12, 1.0, 2.0),
        uv: [draw(13), draw(14)],
        time: draw(15),
        raster: [within(16, 0.0, 512.0), within(17, 0.0, 512.0)],
        ray_type: RAY_TYPES[number / IN_A_ROW],
        reflection_level: level(18),
        refraction_level: level(19),
        incoming: [draw(20), draw(21), draw(22), draw(23)],
        ..State::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_of_every_kind_and_as_a_renderer_builds_them() {
        let states = states();
        for points in states.chunks(IN_A_ROW) {
            assert!(points.iter().all(|point| point.ray_type == points[0].ray_type));
            let inside = points.iter().filter(|point| point.inv_normal).count();
            let left = points.iter().filter(|point| point.uv[0] < 0.5).count();
            for count in [inside, left] {
                assert!((IN_A_ROW / 3..IN_A_ROW * 2 / 3).contains(&count), "{count}");
            }
        }
        for point in &states {
            for unit in [point.direction, point.normal] {
                assert!((Vec3::from(unit).length() - 1.0).abs() < 1e-6);
            }
            assert!((-1.0..=0.0).contains(&point.dot_nd));
            assert!((0..4).contains(&point.reflection_level));
        }
    }
}
