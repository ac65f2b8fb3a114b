//! Colours, shapes and sizes of a drawing.

use crate::values::Type;

use super::text::Font;

/// The page.
pub(super) const PAGE: &str = "#f7f7f5";
/// Inside of a box.
pub(super) const PAPER: &str = "#ffffff";
/// Outline of a box.
pub(super) const OUTLINE: &str = "#9aa0a6";
/// Text.
pub(super) const INK: &str = "#1f2328";
/// Text that matters less.
pub(super) const MUTED: &str = "#6a7078";
/// Text of a default.
pub(super) const FAINT: &str = "#868c94";
/// Name of a parameter where it is used.
pub(super) const PARAMETER: &str = "#1a5fb4";
/// Header of an ordinary node.
pub(super) const HEADER: &str = "#e9ebee";
/// Header of a root.
pub(super) const ROOT: &str = "#2f3640";
/// Inside of the pill of a default that is evaluated.
pub(super) const PILL: &str = "#f0f1f3";
/// The same where it is a field of the state.
pub(super) const STATE_PILL: &str = "#efeef9";
/// A cross over what constants rule out.
pub(super) const RULED_OUT: &str = "#c01c28";
/// Inside of a parameter's box.
pub(super) const PARAMETER_BOX: &str = "#eaf2fc";

/// Names of boxes.
pub(super) const TITLE: Font = Font { size: 12.0, bold: true };
/// Types, badges, notes.
pub(super) const SMALL: Font = Font { size: 9.5, bold: false };
/// Badges.
pub(super) const BADGE: Font = Font { size: 9.0, bold: true };
/// Names and values of sockets.
pub(super) const ROW: Font = Font { size: 10.5, bold: false };
/// Name of the graph.
pub(super) const HEADING: Font = Font { size: 17.0, bold: true };
/// What a viewer is asked to write in.
pub(super) const FAMILY: &str =
    "Helvetica Neue, Helvetica, Arial, Liberation Sans, DejaVu Sans, sans-serif";

/// Shape of a socket; with the colour it tells the type, also to those who see few colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// For numbers.
    Circle,
    /// For directions.
    Diamond,
    /// For yes and no.
    Square,
    /// For counts.
    Triangle,
    /// For lists.
    Hexagon,
}

/// Fill of sockets and wires of a type.
pub(super) fn color(value_type: Type) -> &'static str {
    match value_type {
        Type::Scalar | Type::Generic => "#80868e",
        Type::Color => "#e0a800",
        Type::Vector => "#5b5bd6",
        Type::Boolean => "#d1549b",
        Type::Integer => "#00866b",
        Type::Transform => "#2f7fb8",
        Type::String => "#8a6d3b",
        Type::Texture => "#b0568f",
        Type::Shader => "#4f9a3d",
        Type::Light | Type::Lights => "#e05a00",
    }
}

/// Shape of sockets of a type.
pub(super) fn shape(value_type: Type) -> Shape {
    match value_type {
        Type::Scalar | Type::Color | Type::Shader | Type::Generic => Shape::Circle,
        Type::Vector | Type::Transform => Shape::Diamond,
        Type::Boolean | Type::String => Shape::Square,
        Type::Integer => Shape::Triangle,
        Type::Texture | Type::Light | Type::Lights => Shape::Hexagon,
    }
}

/// Fill of the header of a node that asks something of the renderer, or opens a scope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Accent {
    /// Casts a ray.
    Ray,
    /// Asks a light.
    Light,
    /// Evaluates an input under another state, or many times.
    Scope,
    /// Reads the state.
    State,
}

impl Accent {
    /// Header and badge.
    pub fn colors(self) -> (&'static str, &'static str) {
        match self {
            Accent::Ray => ("#f6d5cc", "#b3361a"),
            Accent::Light => ("#fbe6b8", "#8a5a00"),
            Accent::Scope => ("#d5ebe4", "#12694f"),
            Accent::State => ("#e2e0f4", "#4c4797"),
        }
    }
}

/// An sRGB colour for a linear one; what is not a number shows as black.
pub(super) fn srgb(linear: [f32; 3]) -> String {
    let encoded = linear.map(|x| {
        let x = if x > 0.0 { f64::from(x.min(1.0)) } else { 0.0 };
        let y = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
        (y * 255.0).round() as u8
    });
    format!("#{:02x}{:02x}{:02x}", encoded[0], encoded[1], encoded[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_encoded_and_clamped() {
        assert_eq!(srgb([0.0, 1.0, 0.5]), "#00ffbc");
        assert_eq!(srgb([f32::NAN, f32::INFINITY, -1.0]), "#00ff00");
    }
}
