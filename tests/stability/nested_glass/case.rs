//! Five shells of glass in one another, of indices that rise and fall: what light goes through is known at each, and
//! none is made or lost.

use crate::scenes::{furnace, pixels, scene, text};

#[test]
fn shells_of_glass_in_a_white_world_are_not_seen() {
    let text = text("nested_glass");
    let found = pixels(24, 1, |options| scene("nested_glass", &text, options));
    let mut worst = 0.0_f64;
    for (at, pixel) in found.iter().enumerate() {
        let off = pixel.map(|x| (f64::from(x) - 1.0).abs()).into_iter().fold(0.0, f64::max);
        worst = worst.max(off);
        assert!(off <= furnace(12), "pixel {at}: {pixel:?}");
    }
    println!("nested_glass: off white by {worst:e}, {:e} allowed", furnace(12));
}

/// The same shells, all of the index of air.
#[test]
fn shells_of_no_index_leave_no_trace() {
    let shells = text("nested_glass");
    let mut shells: serde_json::Value = serde_json::from_str(&shells).unwrap();
    let sky = serde_json::json!({ "gradient": {
        "zenith": [2, 1, 0.1], "horizon": [0, 0.5, 1], "ground": [0.3, 0, 2] } });
    shells["environment"] = sky;
    let mut none = shells.clone();
    none["objects"] = serde_json::json!([]);
    for shell in shells["objects"].as_array_mut().unwrap() {
        shell["material"]["set"] = serde_json::json!({ "ior": 1.25, "outside": 1.25 });
    }
    // Ten boundaries, none of which mirrors.
    shells["options"]["trace_depth"] = serde_json::json!([0, 10, 10]);
    let seen = |value: &serde_json::Value| {
        let text = value.to_string();
        pixels(24, 1, |options| scene("nested_glass", &text, options))
    };
    assert!(seen(&shells) == seen(&none));
}

#[test]
fn light_is_bent_at_each_of_them() {
    crate::glass::hold("nested_glass", 24, 10);
}
