//! Measured and analytic reflectance, and the image-based method that draws it from a few pictures of a sphere; knows
//! no cores.
//!
//! The source is A. Mihálik and R. Ďurikovič, "Image-based BRDF Representation": pictures of the unit sphere of a
//! material, lit from a few angles, are looked up and blended in place of the reflectance itself. [`paper`] is their
//! method; [`half`] and [`bivariate`] are two forms that store slices of the reflectance about the half vector instead.
//! docs/reflectance.md tells them apart for users.
//!
//! | module | what it holds |
//! | --- | --- |
//! | [`vector`] | the frame of the camera, lights as angles, the angles about the half vector |
//! | [`table`] | the tabulated form over those angles; [`merl`] reads and writes it |
//! | [`analytic`] | reflectance models with named parameters, and presets |
//! | [`texels`] | codes of texels and how they are looked up |
//! | [`paper`], [`half`], [`bivariate`] | the three forms; [`form`] is any of them, and a matcap |
//! | [`matcap`] | a picture of a sphere with its light in it |
//! | [`measure`] | the exposure, pictures of the sphere, the signal-to-noise ratio |
//! | [`info`] | albedo and reciprocity |
//! | [`images`], [`directory`], [`source`] | sphere images as PNG and OpenEXR, their directory; whatever a user names |
//! | [`points`] | points to evaluate at, as CSV |
//! | [`classical`] | the nearest diffuse and cos^n material |
//! | [`trade`] | memory against error |
//! | [`extremes`] | the forms where they degenerate |
//!
//! # Conventions
//!
//! The camera looks along -Z and is orthographic, so the direction to the viewer is v = (0, 0, 1) everywhere. A light
//! is given by its polar angle φ from +Z, 0 to 180 degrees, and its azimuth γ about Z: l = Rz(γ)(sin φ, 0, cos φ).
//! Radiance is E f max(n·l, 0), with the exposure E and the reflectance f per steradian. Colours are linear; red, green
//! and blue in this order.

pub mod analytic;
pub mod bivariate;
pub mod classical;
pub mod directory;
pub mod extremes;
mod family;
pub mod form;
pub mod half;
pub mod images;
pub mod info;
pub mod matcap;
pub mod measure;
pub mod merl;
pub mod paper;
pub mod points;
pub mod source;
pub mod table;
pub mod texels;
pub mod trade;
pub mod vector;

pub use analytic::Model;
pub use form::{Form, FormKind, FormSpec, Record};
pub use source::Source;
pub use table::{Lookup, Table};
pub use texels::Texel;
pub use vector::{Light, Vector};

/// Red, green and blue, linear.
pub type Rgb = [f64; 3];

/// An isotropic reflectance.
pub trait Reflectance: Sync {
    /// The reflectance in 1/sr for unit vectors to the light, to the viewer and along the surface's normal; 0 where the
    /// light or the viewer is not above the surface. Never negative, and finite.
    fn at(&self, l: Vector, v: Vector, n: Vector) -> Rgb;

    /// The radiance E f max(n·l, 0) that an orthographic camera at +Z sees of a normal.
    fn radiance(&self, light: Light, n: Vector, exposure: f64) -> Rgb {
        let l = light.direction();
        let cosine = n.dot(&l);
        if cosine <= 0.0 {
            return [0.0; 3];
        }
        self.at(l, Vector::z(), n).map(|f| exposure * f * cosine)
    }
}
