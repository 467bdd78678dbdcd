//! The options that tests, tables and benches run the methods with.

use super::{About, METHODS};

/// What goes over variants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Use {
    /// The table of methods, docs/methods.md.
    Table,
    /// Model, datapath and real-valued method against each other, in many formats and for many sets of shininesses.
    Exactness,
    /// Of these the smallest formats alone, for a method whose other tests are its own.
    Smallest,
    /// The times of a core's arithmetic.
    Bench,
}

/// A method with options that change its datapath or its coefficients.
#[derive(Debug)]
pub struct Variant {
    /// What distinguishes it from the method's other variants; empty for the options that it has unless told otherwise.
    pub name: &'static str,
    /// The lines of a spec that give the options.
    pub options: &'static str,
    /// What goes over it.
    pub uses: &'static [Use],
}

impl Variant {
    pub(super) const fn new(name: &'static str, options: &'static str, uses: &'static [Use]) -> Self {
        Self { name, options, uses }
    }

    /// What it is called among those of all methods.
    #[must_use]
    pub fn full_name(&self, about: &About) -> String {
        if self.name.is_empty() { about.name.to_owned() } else { format!("{}, {}", about.name, self.name) }
    }

    /// The lines of a spec that give the method and the options.
    #[must_use]
    pub fn spec(&self, about: &About) -> String {
        format!("method = '{}'\n{}", about.name, self.options)
    }
}

/// The variants of all methods for a use, in the order of [`METHODS`].
pub fn variants(of: Use) -> impl Iterator<Item = (&'static About, &'static Variant)> {
    let all =
        METHODS.iter().copied().flatten().flat_map(|about| about.variants.iter().map(move |variant| (about, variant)));
    let covers = move |used: &Use| *used == of || *used == Use::Exactness && of == Use::Smallest;
    all.filter(move |(_, variant)| variant.uses.iter().any(covers))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_is_compared_with_its_model() {
        let compared: Vec<&str> = variants(Use::Smallest).map(|(about, _)| about.name).collect();
        for about in METHODS.iter().copied().flatten() {
            assert!(compared.contains(&about.name), "{}", about.name);
        }
    }
}
