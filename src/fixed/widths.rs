//! The inner widths of a core.

use serde::Serialize;
use serde::ser::SerializeMap;

/// The inner widths of a core by name, as the error analysis chose them: fraction bits each.
///
/// They follow from the spec and are no part of it. The datapath and the model are both built from them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Widths(Vec<(&'static str, i32)>);

impl Widths {
    /// Widths with these names and values.
    #[must_use]
    pub fn new(entries: Vec<(&'static str, i32)>) -> Self {
        Self(entries)
    }

    /// The fraction bits of the named quantity.
    ///
    /// # Panics
    /// If there is none of that name: the names are fixed by the method.
    #[must_use]
    pub fn get(&self, name: &str) -> i32 {
        self.0.iter().find(|(entry, _)| *entry == name).map(|&(_, bits)| bits).expect("a width of this method")
    }

    /// All of them, in order.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, i32)> + '_ {
        self.0.iter().copied()
    }
}

impl Serialize for Widths {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, bits) in &self.0 {
            map.serialize_entry(name, bits)?;
        }
        map.end()
    }
}
