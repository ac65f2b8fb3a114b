//! The reflectances with their settings, and the samplers.

use crate::code::Given::{self, Choice, Grey, Number};

/// A reflectance.
#[derive(Clone, Copy, Debug)]
pub struct Reflectance {
    /// The node.
    pub node: &'static str,
    /// Its inputs.
    pub settings: &'static [(&'static str, Given)],
    /// What draws directions for it.
    pub sampler: &'static str,
    /// The inputs of that.
    pub sampler_settings: &'static [(&'static str, Given)],
    /// Whether it is to reflect at most all light.
    pub bounded: bool,
    /// The largest albedo measured.
    pub most: f64,
}

/// A sampler with its density.
#[derive(Clone, Copy, Debug)]
pub struct Sampler {
    /// Draws directions.
    pub sample: &'static str,
    /// Says how dense they are.
    pub density: &'static str,
    /// Inputs of both.
    pub settings: &'static [(&'static str, Given)],
}

macro_rules! models {
    ($($node:ident [$($input:ident $given:expr),*] by $sampler:ident [$($of:ident $value:expr),*], $bounded:ident $most:literal;)+) => {
        &[$(Reflectance {
            node: stringify!($node),
            settings: &[$((stringify!($input), $given)),*],
            sampler: stringify!($sampler),
            sampler_settings: &[$((stringify!($of), $value)),*],
            bounded: models!(@$bounded),
            most: $most,
        }),+]
    };
    (@at_most_all) => { true };
    (@more) => { false };
}

/// With mirrors that reflect all, where that can be said.
pub const MODELS: &[Reflectance] = models! {
    lambert_brdf [] by lambert_sample [], at_most_all 1.0;
    oren_nayar_brdf [sigma Number(0.5)] by lambert_sample [], more 1.007;
    oren_nayar_brdf [sigma Number(1.0)] by lambert_sample [], at_most_all 0.912;
    oren_nayar_brdf [sigma Number(1.0), model Choice(1)] by lambert_sample [], at_most_all 0.819;
    burley_brdf [roughness Number(0.0)] by lambert_sample [], at_most_all 0.976;
    burley_brdf [] by lambert_sample [], more 1.025;
    burley_brdf [roughness Number(1.0)] by lambert_sample [], more 1.523;
    phong_brdf [kind Choice(0), exponent Number(1.0)] by lambert_sample [], more 2.094;
    phong_brdf [kind Choice(1), exponent Number(10.0)] by phong_sample [exponent Number(4.0)], more 0.855;
    phong_brdf [exponent Number(1.0)] by lambert_sample [], at_most_all 1.0;
    phong_brdf [exponent Number(50.0)] by phong_sample [exponent Number(50.0)], at_most_all 1.0;
    torrance_sparrow_brdf [roughness Number(0.3)] by microfacet_sample [roughness Number(0.3)], at_most_all 0.450;
    torrance_sparrow_brdf [roughness Number(0.3), distribution Choice(1), geometry Choice(1)]
        by microfacet_sample [roughness Number(0.3), distribution Choice(1)], at_most_all 0.154;
    torrance_sparrow_brdf [roughness Number(0.3), distribution Choice(2), geometry Choice(2)]
        by microfacet_sample [roughness Number(0.3), distribution Choice(2)], at_most_all 0.176;
    torrance_sparrow_brdf [roughness Number(0.1), distribution Choice(3)]
        by microfacet_sample [roughness Number(0.1)], at_most_all 0.661;
    cook_torrance_brdf [roughness Number(0.3)] by microfacet_sample [roughness Number(0.3)], at_most_all 0.95;
    schlick_anisotropic_brdf [roughness Number(0.1), f0 Grey(1.0)]
        by microfacet_sample [roughness Number(0.31622776), distribution Choice(1)], more 1.220;
    schlick_anisotropic_brdf [roughness Number(0.1), isotropy Number(0.5), f0 Grey(1.0)]
        by microfacet_sample [roughness Number(0.31622776), distribution Choice(1)], more 1.166;
    ward_brdf [form Choice(0)] by ward_sample [], at_most_all 0.9;
    ward_brdf [form Choice(1)] by ward_sample [], more 3.377;
    ward_brdf [form Choice(2)] by ward_sample [], at_most_all 0.960;
    ward_brdf [form Choice(2), roughness_u Number(0.05), roughness_v Number(0.4)]
        by ward_sample [roughness_u Number(0.05), roughness_v Number(0.4)], at_most_all 0.919;
    ward_brdf [form Choice(3)] by ward_sample [], at_most_all 0.9;
    ashikhmin_shirley_brdf [specular Grey(1.0)] by ashikhmin_shirley_sample [], at_most_all 0.823;
    ashikhmin_shirley_brdf [specular Grey(0.0), diffuse Grey(1.0)] by lambert_sample [], at_most_all 0.969;
    ggx_brdf [f0 Grey(1.0)] by ggx_sample [], at_most_all 0.974;
    ggx_brdf [f0 Grey(1.0), roughness_u Number(0.1), roughness_v Number(0.8)]
        by ggx_sample [roughness_u Number(0.1), roughness_v Number(0.8)], at_most_all 0.956;
    sheen_brdf [] by lambert_sample [], at_most_all 0.773;
    sheen_brdf [roughness Number(0.05)] by lambert_sample [], more 1.429;
    sheen_brdf [roughness Number(1.0)] by lambert_sample [], at_most_all 0.578;
};

macro_rules! samplers {
    ($($sample:ident $density:ident [$($input:ident $given:expr),*];)+) => {
        &[$(Sampler {
            sample: stringify!($sample),
            density: stringify!($density),
            settings: &[$((stringify!($input), $given)),*],
        }),+]
    };
}

/// Lobes wide enough for the grid of the test.
pub const SAMPLERS: &[Sampler] = samplers! {
    lambert_sample lambert_density [];
    phong_sample phong_density [exponent Number(0.0)];
    phong_sample phong_density [exponent Number(20.0)];
    ward_sample ward_density [roughness_u Number(0.3), roughness_v Number(0.6)];
    ashikhmin_shirley_sample ashikhmin_shirley_density [exponent_u Number(4.0), exponent_v Number(30.0)];
    ggx_sample ggx_density [roughness_u Number(0.3), roughness_v Number(0.7)];
    microfacet_sample microfacet_density [roughness Number(0.4)];
    microfacet_sample microfacet_density [roughness Number(0.4), distribution Choice(1)];
    microfacet_sample microfacet_density [roughness Number(0.4), distribution Choice(2)];
};
