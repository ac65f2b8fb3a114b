//! Surfaces in one place: the first is seen at every pixel, whatever they are made of, and rays that leave it do not
//! meet the others.

use crate::scenes::{pixels, scene, text};

/// The scene with its objects in this order.
fn seen(order: &[&str]) -> Vec<[f32; 3]> {
    let mut value: serde_json::Value = serde_json::from_str(&text("coincident")).unwrap();
    let all = value["objects"].as_array().unwrap().clone();
    let named = |name: &&str| all.iter().find(|object| object["name"] == **name).unwrap().clone();
    value["objects"] = order.iter().map(named).collect();
    let text = value.to_string();
    pixels(24, 2, |options| scene("coincident", &text, options))
}

const RED: [f32; 3] = [1.0, 0.0, 0.0];
const GREEN: [f32; 3] = [0.0, 1.0, 0.0];

#[test]
fn the_first_of_floors_is_seen() {
    assert!(seen(&["red_floor", "green_floor"]).iter().all(|pixel| *pixel == RED));
    assert!(seen(&["green_floor", "red_floor"]).iter().all(|pixel| *pixel == GREEN));
}

#[test]
fn the_first_of_balls_is_seen() {
    assert!(seen(&["red_ball", "green_ball"]).iter().all(|pixel| *pixel == RED));
    assert!(seen(&["green_ball", "red_ball"]).iter().all(|pixel| *pixel == GREEN));
}

/// The sky is white: a mirror or a pane that met what lies in it would be red or green.
#[test]
fn rays_that_leave_the_first_do_not_meet_the_others() {
    for first in ["mirror_floor", "glass_floor"] {
        let found = seen(&[first, "red_floor", "green_floor"]);
        for pixel in found {
            let off = pixel.map(|x| (x - 1.0).abs());
            let allowed = crate::scenes::furnace(2) as f32;
            assert!(off.iter().all(|off| *off <= allowed), "{first}: {pixel:?}");
        }
    }
    for ball in ["mirror_ball", "glass_ball"] {
        let found = seen(&[ball, "red_ball"]);
        let is_grey = |pixel: &[f32; 3]| pixel[1] == pixel[2] && pixel[0] == pixel[1];
        match ball {
            "mirror_ball" => assert!(found.iter().all(|pixel| *pixel == [1.0; 3])),
            // The far side of the first is that of the others too, and the first counts there.
            _ => assert!(found.iter().all(is_grey), "{found:?}"),
        }
    }
}
