//! The image-based block: texels of a reflectance, looked up for every light of a sample and multiplied by n·l.
//!
//! What is stored are codes of `√(f/cap)`: over θh and θd, a row of texels and a cap for each θd
//! ([`ImageForm::Bivariate`]), or slices about the half vector, one for each angle of the light ([`ImageForm::Half`]).
//! A directional light has one θd for all normals, so that a light record names one of these *bands*, its blend with
//! the next, and a gain a channel: the light's intensity, both caps and the exposure. Of a sample are left a scalar
//! product, an address, the blend of neighbouring texels, its square and two products; texels lie in memories by the
//! parities of their places, and all that are blended are read in one clock.

pub mod datapath;
mod model;
mod options;
mod record;
mod texels;

pub use model::ImageModel;
pub use options::{Image, ImageForm, ImageWidths};
pub use record::LightRecord;
pub use texels::{Banks, OctaveAxis};
