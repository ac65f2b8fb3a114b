//! What reflectances keep to: they are reciprocal and not negative, reflect at most all light where their
//! authors say so, and where they do not the violation is pinned; directions drawn for them are as dense as
//! their density says, and densities integrate to 1.

mod code;
mod models;

use code::{Code, Given};
use models::{MODELS, Reflectance, SAMPLERS, Sampler};
use phenomenon_compiler::testing::random::Random;

type Direction = [f64; 3];

/// A surface that is not in line with any axis.
const NORMAL: Direction = [0.36, 0.48, 0.8];
const TANGENT: Direction = [0.8, -0.6, 0.0];

fn cross(a: Direction, b: Direction) -> Direction {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The direction at this cosine from the normal, turned from the tangent.
fn direction(cosine: f64, turn: f64) -> Direction {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let across = cross(NORMAL, TANGENT);
    let (x, y) = (sine * turn.cos(), sine * turn.sin());
    [0, 1, 2].map(|k| TANGENT[k] * x + across[k] * y + NORMAL[k] * cosine)
}

fn single(direction: Direction) -> [f32; 3] {
    direction.map(|x| x as f32)
}

fn dot(a: Direction, b: Direction) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The node at that surface.
fn at_surface(name: &str, settings: code::Settings<'_>) -> Code {
    let mut code = Code::of(name, settings);
    code.set_if_there("normal", &single(NORMAL));
    code.set_if_there("tangent", &single(TANGENT));
    code
}

fn value(code: &mut Code, light: Direction, viewer: Direction) -> f64 {
    code.set("direction", &single(light));
    code.set("ray", &single(viewer.map(|x| -x)));
    code.run();
    code.number("value", 0)
}

#[test]
fn light_and_viewer_may_be_exchanged_and_nothing_is_negative() {
    for Reflectance { node, settings, .. } in MODELS {
        let mut code = at_surface(node, settings);
        let mut random = Random::new(7);
        let (mut worst, mut lit) = (0.0_f64, 0);
        for _ in 0..600 {
            let mut unit = || f64::from(random.unit());
            let (cosine, turn) = (unit().powi(2).max(1e-4), unit() * std::f64::consts::TAU);
            // The other is anywhere, or not far from the mirror direction.
            let (other, beside) = match unit() < 0.5 {
                true => (unit().powi(2).max(1e-4), unit() * std::f64::consts::TAU),
                false => {
                    ((cosine + 0.2 * (unit() - 0.5)).clamp(1e-4, 1.0), turn + 3.0 + 0.3 * unit())
                }
            };
            let (a, b) = (direction(cosine, turn), direction(other, beside));
            let (there, back) = (value(&mut code, a, b), value(&mut code, b, a));
            assert!(
                there >= 0.0 && there.is_finite() && back >= 0.0,
                "{node} {settings:?}: {there}"
            );
            lit += u32::from(there > 1e-6);
            if there.max(back) > 1e-6 {
                worst = worst.max((there - back).abs() / there.max(back));
            }
        }
        assert!(lit > 100, "{node}: it was dark nearly everywhere");
        assert!(worst < 2e-4, "{node} {settings:?}: off by {worst:e}");
    }
}

/// Share of light from a direction that is reflected, or towards it: stratified over the sampler's numbers.
fn albedo(model: &Reflectance, cosine: f64) -> f64 {
    const SIDE: usize = 48;
    let mut code = at_surface(model.node, model.settings);
    let mut sampler = at_surface(model.sampler, model.sampler_settings);
    let viewer = direction(cosine, 0.7);
    sampler.set_if_there("ray", &single(viewer.map(|x| -x)));
    let mut sum = 0.0;
    for first in 0..SIDE {
        for second in 0..SIDE {
            sampler.set("first", &[(first as f32 + 0.5) / SIDE as f32]);
            sampler.set("second", &[(second as f32 + 0.5) / SIDE as f32]);
            sampler.run();
            let light = [0, 1, 2].map(|k| sampler.number("direction", k));
            let density = sampler.number("density", 0);
            if density > 0.0 {
                sum += value(&mut code, light, viewer) * dot(NORMAL, light).max(0.0) / density;
            }
        }
    }
    sum / (SIDE * SIDE) as f64
}

/// Cosines at which albedos are taken: head on, and to 89 degrees.
const COSINES: [f64; 6] = [1.0, 0.8, 0.5, 0.2, 0.0523, 0.01745];

#[test]
fn no_more_light_is_reflected_than_the_models_say() {
    let mut found = String::new();
    for model in MODELS {
        let albedos = COSINES.map(|cosine| albedo(model, cosine));
        let most = albedos.iter().copied().fold(0.0, f64::max);
        println!("{} {:?}: {albedos:.3?}", model.node, model.settings);
        if (most - model.most).abs() > 0.02 * model.most.max(0.1) {
            found +=
                &format!("{} {:?}: {most:.3}, not {:.3}\n", model.node, model.settings, model.most);
        }
        if model.bounded && most > 1.005 {
            found += &format!("{} {:?}: {most:.3} is more than all\n", model.node, model.settings);
        }
    }
    assert!(found.is_empty(), "{found}");
}

/// Bins of the sphere: by height, and by turn.
const BINS: usize = 16;

/// The direction in the middle of a cell of a grid over the sphere, all of equal solid angle.
fn cell(side: usize, row: usize, column: usize) -> Direction {
    let cosine = (row as f64 + 0.5) / side as f64 * 2.0 - 1.0;
    direction(cosine, (column as f64 + 0.5) / side as f64 * std::f64::consts::TAU)
}

/// The density summed over the cells of each bin.
fn shares(sampler: &Sampler, viewer: Direction) -> Vec<f64> {
    const FINE: usize = 14;
    let side = BINS * FINE;
    let mut code = at_surface(sampler.density, sampler.settings);
    code.set_if_there("ray", &single(viewer.map(|x| -x)));
    let mut shares = vec![0.0; BINS * BINS];
    let solid = 4.0 * std::f64::consts::PI / (side * side) as f64;
    for row in 0..side {
        for column in 0..side {
            code.set("direction", &single(cell(side, row, column)));
            code.run();
            shares[row / FINE * BINS + column / FINE] += code.number("density", 0) * solid;
        }
    }
    shares
}

fn bin(light: Direction) -> usize {
    let across = cross(NORMAL, TANGENT);
    let row = ((dot(NORMAL, light) + 1.0) / 2.0 * BINS as f64) as usize;
    let turn = dot(across, light).atan2(dot(TANGENT, light)) / std::f64::consts::TAU;
    let column = (turn.rem_euclid(1.0) * BINS as f64) as usize;
    row.min(BINS - 1) * BINS + column.min(BINS - 1)
}

/// Pearson's statistic over bins of which each expects at least ten, in standard deviations above its mean.
fn excess(shares: &[f64], counts: &[u32], drawn: f64) -> f64 {
    let (mut statistic, mut bins) = (0.0, 0.0);
    let (mut rare, mut seen) = (0.0, 0.0);
    for (share, &count) in shares.iter().zip(counts) {
        let expected = share * drawn;
        if expected < 10.0 {
            rare += expected;
            seen += f64::from(count);
        } else {
            statistic += (f64::from(count) - expected).powi(2) / expected;
            bins += 1.0;
        }
    }
    if rare >= 10.0 {
        statistic += (seen - rare).powi(2) / rare;
        bins += 1.0;
    } else {
        assert!(seen < rare + 8.0 * rare.sqrt() + 8.0, "{seen} where {rare} are expected");
    }
    let freedom: f64 = bins - 1.0;
    (statistic - freedom) / (2.0 * freedom).sqrt()
}

#[test]
fn directions_are_as_dense_as_their_density_says() {
    const DRAWN: u32 = 20_000;
    for sampler in SAMPLERS {
        for cosine in [0.9, 0.5] {
            let viewer = direction(cosine, 0.7);
            let shares = shares(sampler, viewer);
            let total: f64 = shares.iter().sum();
            assert!(
                (total - 1.0).abs() < 0.01,
                "{} {:?}: {total}",
                sampler.density,
                sampler.settings
            );
            let mut code = at_surface(sampler.sample, sampler.settings);
            let mut density = at_surface(sampler.density, sampler.settings);
            code.set_if_there("ray", &single(viewer.map(|x| -x)));
            density.set_if_there("ray", &single(viewer.map(|x| -x)));
            let mut random = Random::new(11);
            let mut counts = vec![0; BINS * BINS];
            for _ in 0..DRAWN {
                code.set("first", &[random.unit()]);
                code.set("second", &[random.unit()]);
                code.run();
                let light = [0, 1, 2].map(|k| code.number("direction", k));
                counts[bin(light)] += 1;
                density.set("direction", &single(light));
                density.run();
                let (a, b) = (code.number("density", 0), density.number("density", 0));
                assert!((a - b).abs() <= 1e-3 * a.max(b), "{}: {a} and {b}", sampler.sample);
            }
            let excess = excess(&shares, &counts, DRAWN.into());
            println!("{} {:?} at {cosine}: {excess:.2}", sampler.sample, sampler.settings);
            assert!(excess < 5.0, "{} {:?}: {excess}", sampler.sample, sampler.settings);
        }
    }
}

/// A sampler that is a little off is caught: the phong lobe against the density of a narrower one.
#[test]
fn another_density_is_told_apart() {
    let viewer = direction(0.9, 0.7);
    let right = Sampler {
        sample: "phong_sample",
        density: "phong_density",
        settings: &[("exponent", Given::Number(20.0))],
    };
    let wrong = Sampler { settings: &[("exponent", Given::Number(23.0))], ..right };
    let shares = shares(&wrong, viewer);
    let mut code = at_surface(right.sample, right.settings);
    code.set("ray", &single(viewer.map(|x| -x)));
    let mut random = Random::new(11);
    let mut counts = vec![0; BINS * BINS];
    for _ in 0..20_000 {
        code.set("first", &[random.unit()]);
        code.set("second", &[random.unit()]);
        code.run();
        counts[bin([0, 1, 2].map(|k| code.number("direction", k)))] += 1;
    }
    assert!(excess(&shares, &counts, 20_000.0) > 10.0);
}
