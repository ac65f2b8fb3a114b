//! A camera 10^7 from the origin, where neighbouring numbers of 32 bits are 1 apart: what stands there looks as at the
//! origin, and a distant camera sees the same.

use crate::sphere_sizes::Seen;

#[test]
fn spheres_far_from_the_origin_are_round() {
    let mut worst = 0.0_f64;
    for center in [[1e7, 0.0, 0.0], [-1e7, 1e7, 1e7], [0.0; 3]] {
        for away in [[0.0, 0.0, 64.0], [24.0, 32.0, 48.0]] {
            worst = worst.max(Seen { center, radius: 16.0, away, degrees: 40.0 }.hold());
        }
    }
    // 10^7 away from what it sees.
    let away = [0.0, 6e6, 8e6];
    let degrees = (2.0 * (1.5 * 16.0 / 1e7_f64).atan()).to_degrees();
    worst = worst.max(Seen { center: [0.0; 3], radius: 16.0, away, degrees }.hold());
    println!("far_camera: at most {worst:.2} of what is allowed");
}
