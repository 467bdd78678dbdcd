//! The inner widths of a core.

use std::ops::Index;

use serde::Serialize;
use serde::ser::SerializeMap;

/// The handle of an inner width: its name, as reports and manifests have it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Width(pub &'static str);

/// The inner widths of a core, as the error analysis chose them: fraction bits each.
///
/// They follow from the spec and are no part of it. The datapath and the model are both built from them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Widths(Vec<(Width, i32)>);

impl Widths {
    /// These widths with their values.
    #[must_use]
    pub fn new(entries: Vec<(Width, i32)>) -> Self {
        Self(entries)
    }
}

impl Index<Width> for Widths {
    type Output = i32;

    /// The fraction bits of a quantity.
    ///
    /// # Panics
    /// If there is no such width here: which there are is fixed by the method.
    fn index(&self, width: Width) -> &i32 {
        self.0.iter().find(|(entry, _)| *entry == width).map(|(_, bits)| bits).expect("a width of this method")
    }
}

impl Serialize for Widths {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (Width(name), bits) in &self.0 {
            map.serialize_entry(name, bits)?;
        }
        map.end()
    }
}
