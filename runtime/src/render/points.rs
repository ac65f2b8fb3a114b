//! From rays and hits to shading points.

use glam::DVec3;
use phenomenon_compiler::effects::Ray;
use phenomenon_compiler::state::{Cone, Hit, RayType, State};

use crate::geometry::{PreparedRay, RawHit, Surface, double, single};
use crate::sampling::child_path;
use crate::scene::Scene;

/// A ray that waits for its point to be shaded.
#[derive(Clone, Copy, Debug)]
pub(super) struct Waiting {
    /// Position of the ray in its queue.
    pub(super) slot: u32,
    /// Material it hit.
    pub(super) material: u32,
    /// Where the ray starts.
    pub(super) origin: DVec3,
    /// Its unit direction.
    pub(super) direction: [f32; 3],
    /// Where it hit.
    pub(super) hit: RawHit,
}

/// The direction at unit length; none for one that is zero or not finite.
#[inline]
pub(super) fn unit_direction(direction: [f32; 3]) -> Option<[f32; 3]> {
    let long = double(direction);
    let length = long.length();
    (length > 0.0 && length.is_finite()).then(|| single(long / length))
}

/// The point of a state in double precision.
#[inline]
pub(super) fn precise_point(state: &State) -> DVec3 {
    let position = DVec3::from(state.hit.position);
    if single(position) == state.point { position } else { double(state.point) }
}

/// The ray asked for at a point: it leaves the surface if it starts at the point, else it starts in
/// space as given. None where the start is not finite.
#[inline]
pub(super) fn prepared(state: &State, ray: &Ray, direction: [f32; 3]) -> Option<PreparedRay> {
    if !ray.origin.iter().all(|x| x.is_finite()) {
        return None;
    }
    Some(match ray.origin == state.point {
        true => PreparedRay::leaving(precise_point(state), state.normal_geom, double(direction)),
        false => PreparedRay::new(ray.origin, direction),
    })
}

/// What a ray from a point hands on to the point it hits, levels and path already counted up.
#[inline]
pub(super) fn child(from: &State, ray: &Ray, ray_type: RayType) -> State {
    let mut state = *from;
    state.ray_type = ray_type;
    // The shader there starts a list of its own.
    state.incoming = [0.0; 4];
    match ray_type {
        RayType::Eye => return state,
        RayType::Reflection => state.reflection_level = state.reflection_level.saturating_add(1),
        RayType::Refraction | RayType::Transparent => {
            state.refraction_level = state.refraction_level.saturating_add(1);
        }
        RayType::Shadow | RayType::Environment | RayType::Displace => {}
    }
    state.path = child_path(state.path, ray.site);
    state
}

/// Puts a surface, turned to the side the ray came from, into a state.
#[inline]
pub(super) fn place(state: &mut State, surface: &Surface, inside: bool, direction: [f32; 3]) {
    let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let turned = |normal: [f32; 3]| if inside { normal.map(|x| -x) } else { normal };
    state.direction = direction;
    state.point = surface.point;
    state.normal = turned(surface.normal);
    state.normal_geom = turned(surface.normal_geom);
    let cosine = dot(state.normal, direction);
    // An interpolated normal may lean away from the ray.
    state.dot_nd = if cosine < 0.0 { if cosine > -1.0 { cosine } else { -1.0 } } else { 0.0 };
    state.inv_normal = inside;
    state.uv = surface.uv;
}

/// The state at the point a ray hit.
#[inline]
pub(super) fn hit_state(
    scene: &Scene,
    from: &State,
    ray: &Ray,
    ray_type: RayType,
    waiting: &Waiting,
) -> State {
    let surface = scene.surface(waiting.origin, double(waiting.direction), &waiting.hit);
    let mut state = child(from, ray, ray_type);
    place(&mut state, &surface, waiting.hit.inside, waiting.direction);
    state.origin = single(waiting.origin);
    state.dist = waiting.hit.t as f32;
    let cone = match scene.called_for.footprints {
        true => widened(scene, from, ray_type, waiting.hit.t as f32),
        false => Cone::default(),
    };
    state.hit = Hit { cone, ..note(scene, &waiting.hit, &surface) };
    state
}

/// The cone of a ray at the end of its way. A mirror that is curved spreads it by twice the angle its normal turns
/// by across it; refraction is taken to keep it.
#[inline]
fn widened(scene: &Scene, from: &State, ray_type: RayType, distance: f32) -> Cone {
    let Cone { width, mut spread } = from.hit.cone;
    if ray_type == RayType::Reflection {
        let curvature = scene.curvature(&from.hit);
        spread += 2.0 * width * if from.inv_normal { -curvature } else { curvature };
    }
    // Past the focus of a hollow mirror it widens again.
    Cone { width: (width + spread * distance).abs(), spread }
}

/// What the renderer notes of a hit.
#[inline]
pub(super) fn note(scene: &Scene, hit: &RawHit, surface: &Surface) -> Hit {
    let id = scene.tree.id(hit.slot);
    let position = surface.position.to_array();
    Hit { instance: id.object, primitive: id.primitive, position, cone: Cone::default() }
}

/// The state of an environment lookup.
pub(super) fn environment_state(from: &State, ray: &Ray, direction: [f32; 3]) -> State {
    let mut state = child(from, ray, RayType::Environment);
    state.origin = from.point;
    state.direction = direction;
    state.point = from.point;
    state.normal = direction.map(|x| -x);
    state.normal_geom = state.normal;
    state.dot_nd = -1.0;
    state.dist = 0.0;
    state.inv_normal = false;
    state.uv = [0.0; 2];
    state.hit = Hit::default();
    state
}
