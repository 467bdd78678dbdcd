//! Scenes: what a picture asks of the lobe, and the core that this picture needs.
//!
//! - [`file`](mod@file): scene files, read and checked;
//! - [`mesh`]: triangle meshes from OBJ and PLY;
//! - [`mtl`]: the materials of OBJ files;
//! - [`frame`]: a picture as the lobes that it asks for, and with their values as codes of its channels;
//! - [`highlight`]: those values: exact, by the bit-exact model of a core, or by the compiled core itself;
//! - [`trace`]: what a ray of sight meets, and which lights shine there;
//! - [`difference`]: two pictures compared, in output steps;
//! - [`reflectance`]: materials drawn by their reflectance, exactly or through sphere images;
//! - [`require`]: what a scene requires of a core;
//! - [`survey`]: where on their lobes its pictures' samples lie;
//! - [`choice`]: the cheapest core that keeps the scene's budget;
//! - [`shade`]: the whole shader around it;
//! - `cores`: the cores that a picture is drawn through;
//! - `drawing`: a picture exact and otherwise, judged;
//! - [`simplify`]: what that core leaves out, and what this saves;
//! - [`inspect`]: all of it;
//! - [`document`]: the same in files beside the core;
//! - [`picture`]: pictures as files: PNG and OpenEXR;
//! - [`sheet`]: pages of pictures with what is to be said of them.

mod candidates;
pub mod choice;
pub(crate) mod cores;
pub mod difference;
pub mod document;
pub(crate) mod drawing;
pub mod file;
pub mod frame;
pub mod highlight;
pub mod inspect;
pub mod mesh;
pub mod mtl;
mod obj;
pub mod picture;
mod ply;
mod ray;
pub mod reflectance;
pub mod require;
pub mod shade;
pub mod sheet;
pub mod simplify;
mod slots;
pub mod survey;
mod text;
pub mod trace;

pub use difference::Difference;
pub use file::{Budget, Camera, CoreConstraints, Light, LightKind, Object, Scene, Shape};
pub use frame::{Frame, Picture};
pub use highlight::{Codes, Compiled, CoreModel, Exact, Highlights};
pub use inspect::SceneInspection;
pub use picture::Pixels;
pub use require::Requirements;
pub use trace::{Hit, Lit, Tracer};
