//! The machine that brdfgen runs on: the user's files, other programs, what is temporary, and the error that is told.
//!
//! - [`error`]: what went wrong, where, and what is allowed;
//! - [`input`]: the user's files, read within limits and as other programs write them;
//! - [`paths`]: which files a command reads and writes: nothing is written over what is read;
//! - [`tool`]: external programs: where they are, how they are run; only this room starts any;
//! - [`transient`]: temporary files and started programs: none outlives a run.

pub mod error;
pub mod input;
pub mod paths;
pub mod tool;
pub mod transient;

/// Serde for a type that is written as its `Display` says and read as its `FromStr` does.
macro_rules! as_text {
    ($kind:ty) => {
        impl serde::Serialize for $kind {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_str(self)
            }
        }
        impl<'de> serde::Deserialize<'de> for $kind {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                <String as serde::Deserialize>::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
            }
        }
    };
}
pub(crate) use as_text;
