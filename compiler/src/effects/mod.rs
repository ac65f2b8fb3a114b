//! What a shader may ask of the renderer, and the trait through which it asks.

mod effect;
mod lights;
mod no_scene;
mod points;
mod rays;
mod renderer;
mod sampling;

pub use effect::{Asked, Effect, EffectSet, Part};
pub use lights::{LightList, LightMode, LightSample, NamedLights};
pub use no_scene::NoScene;
pub use points::Points;
pub use rays::{Answer, Ray, Trace};
pub use renderer::{Renderer, TextureId};
pub use sampling::{Filter, Lookup, Sampling, Wrap};
