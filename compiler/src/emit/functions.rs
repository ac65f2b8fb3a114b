//! Transcendental functions of the standard tier, composed of [`super::Real`] operations.
