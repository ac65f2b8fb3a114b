//! Glass of the index of what is round it is not there; glass of the next index is nearly not.

use phenomenon_runtime::camera::Camera;

use crate::bounds::ROUNDING;
use crate::grazing::dielectric;
use crate::scenes::{dot, pixels, rays, scene, text};

const SIDE: u32 = 40;

/// The scene with balls of an index, or without.
fn seen(ior: Option<f32>) -> Vec<[f32; 3]> {
    let text = text("equal_indices");
    let text = match ior {
        Some(ior) => text.replace("\"ior\": 1,", &format!("\"ior\": {:?},", f64::from(ior))),
        None => {
            let (start, end) =
                (text.find("\"objects\": [").unwrap(), text.find("\"environment\"").unwrap());
            format!("{}\"objects\": [], {}", &text[..start], &text[end..])
        }
    };
    pixels(SIDE, 1, |options| scene("equal_indices", &text, options))
}

#[test]
fn equal_indices_leave_no_trace() {
    let (with, without) = (seen(Some(1.0)), seen(None));
    assert!(with == without);
    assert!(without.iter().any(|pixel| *pixel != without[0]), "the world has one colour");
}

/// The camera of the scene.
fn camera() -> Camera {
    Camera::new([0.0, 0.4, 4.0], [0.0; 3], [0.0, 1.0, 0.0], 40.0).unwrap()
}

/// What may differ where a ray meets the ball at a cosine: colours change by at most 2 over a unit of height, the
/// way in and the way out bend the ray by the same angle, and at most twice the reflectance is mirrored.
fn difference(cosine: f64, ior: f64) -> f64 {
    let sine = (1.0 - cosine * cosine).sqrt();
    let beyond = (1.0 - (sine / ior).powi(2)).sqrt();
    // The angle between both directions.
    let bent = (sine * beyond - cosine * sine / ior).abs().min(1.0).asin();
    2.0 * 2.0 * bent + 2.0 * 2.0 * dielectric(cosine, 1.0, ior)
}

#[test]
fn nearly_equal_indices_bend_light_as_little_as_they_should() {
    let ior = 1.0_f32.next_up();
    let (with, without) = (seen(Some(ior)), seen(None));
    let mut worst = 0.0_f64;
    for (at, (origin, direction)) in rays(&camera(), SIDE).into_iter().enumerate() {
        let (along, squared) = (dot(origin, direction), dot(origin, origin));
        let closest = squared - along * along;
        let allowed = match closest < 1.0 {
            true => difference((1.0 - closest).sqrt(), ior.into()),
            false => 0.0,
        };
        for component in 0..3 {
            let (a, b) = (f64::from(with[at][component]), f64::from(without[at][component]));
            // A mix, and a direction rounded twice.
            let allowed = allowed + 16.0 * ROUNDING;
            worst = worst.max((a - b).abs() / allowed);
            assert!((a - b).abs() <= allowed, "pixel {at}: {a} for {b}, {allowed:e} allowed");
        }
    }
    println!("equal_indices: at most {worst:.2} of what is allowed");
    assert!(with != without);
}
