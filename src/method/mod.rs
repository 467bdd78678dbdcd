//! The methods to approximate the lobe: one folder each, named as the user names it.
//!
//! A folder holds all there is of its method: what is known of it whatever its options ([`About`]), its options
//! ([`Method`], what `configure` makes of those of a spec), `lobe.rs`, its real numbers; `datapath.rs`, its graph; and
//! `model.rs`, its bits, which know nothing of each other. What several methods share stands beside the folders.
//! [`METHODS`] lists them, and everything that goes over methods goes over that list.

pub mod cubic;
pub mod cubic_min_zero;
pub mod cubic_rational;
pub mod cubic_three_point;
pub mod divide;
mod exponent;
pub mod gaussian;
pub mod harris;
mod interface;
pub(crate) mod keys;
pub mod log_exp;
pub mod lyon;
mod model;
mod monotone;
mod options;
pub mod polynomial;
mod ports;
pub mod power;
mod powers;
pub mod quadratic;
mod rows;
pub mod schlick;
pub mod segmented;
mod shininess;
pub mod squaring;
pub mod table;
mod variant;
pub(crate) mod width;

use std::fmt;
use std::sync::{Arc, LazyLock};

use clap::ValueEnum;
use clap::builder::PossibleValue;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

pub use interface::{INPUT_FRACTION, InputRange, Interface, OUTPUT_FRACTION, Operand};
pub use model::{Inputs, Model};
pub(crate) use monotone::Row;
pub use monotone::{Check, Falls, are_falling};
pub use options::{Coefficients, Form, Options, Source};
pub(crate) use options::{method_keys, within, word};
pub use shininess::{Colour, MAX_ROWS, Material, Shininess};
pub use variant::{Use, Variant, variants};

use crate::datapath::Architecture;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

/// The methods, in the order in which they are listed to users; a folder with an option in its name has several.
pub static METHODS: &[&[About]] = &[
    &quadratic::METHODS,
    &cubic::METHODS,
    &cubic_rational::METHODS,
    &cubic_three_point::METHODS,
    &cubic_min_zero::METHODS,
    &schlick::METHODS,
    &lyon::METHODS,
    &power::METHODS,
    &segmented::METHODS,
    &log_exp::METHODS,
    &gaussian::METHODS,
    &squaring::METHODS,
    &harris::METHODS,
    &table::METHODS,
];

/// What makes a method of what is known of it and the options of a spec.
pub type Configure = fn(&'static About, &Options) -> Result<Arc<dyn Method>, Error>;

/// What is known of a method whatever its options.
#[derive(Debug)]
pub struct About {
    /// The name, as users write it.
    pub name: &'static str,
    /// What the lobe is, for the help.
    pub help: &'static str,
    /// The lobe's formula, for headers and datasheets.
    pub formula: &'static str,
    /// What a core is called whose spec has no name, where the method's name will not do.
    pub core_name: Option<&'static str>,
    /// The options that it has, by their keys: `coefficients` and `objective` go without saying where
    /// [`About::coefficients`] says so.
    pub options: &'static [&'static str],
    /// The coefficients that it can have, the default first; none for a method without any.
    pub coefficients: &'static [Coefficients],
    /// Whether coefficients may be interpolated between the ROM's rows.
    pub interpolates: bool,
    /// Whether the core computes with n itself, which the port of a range gives it, so that it needs no ROM for it.
    pub computes_with_shininess: bool,
    /// Whether it serves only shininesses that are powers of two.
    pub powers_of_two: bool,
    /// Whether it is there to be compared with: published by others, or what an engineer would build without this
    /// crate.
    pub is_baseline: bool,
    /// The options that tests, tables and benches run it with.
    pub variants: &'static [Variant],
    /// The method with the options of a spec.
    pub configure: Configure,
}

impl About {
    /// A method that is none of what else may be said of one.
    const fn new(name: &'static str, help: &'static str, formula: &'static str, configure: Configure) -> Self {
        Self {
            name,
            help,
            formula,
            core_name: None,
            options: &[],
            coefficients: &[],
            interpolates: false,
            computes_with_shininess: false,
            powers_of_two: false,
            is_baseline: false,
            variants: &[],
            configure,
        }
    }

    /// Whether it has the option of this key.
    #[must_use]
    pub fn has(&self, key: &str) -> bool {
        self.options.contains(&key)
    }
}

/// A method with its options.
pub trait Method: fmt::Debug + Send + Sync {
    /// Its options, all given.
    fn options(&self) -> Options {
        Options::default()
    }

    /// Refuses formats that the options do not go with.
    ///
    /// # Errors
    /// Says what is wrong and what is allowed.
    fn check(&self, interface: &Interface) -> Result<(), Error> {
        let _ = interface;
        Ok(())
    }

    /// What can be chosen of its hardware, what that costs, and how it is built.
    ///
    /// # Errors
    /// A shininess or level that the method refuses.
    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error>;

    /// The output, before it is rounded down to its last bit.
    fn model(&self, inputs: &Inputs) -> Wide;
}

/// A method with its options, as a spec holds it.
#[derive(Clone)]
pub struct Configured {
    about: &'static About,
    method: Arc<dyn Method>,
}

impl Configured {
    /// The method with the options of a spec.
    ///
    /// # Errors
    /// An option that the method does not have, or a value out of range.
    pub fn new(method: MethodName, options: &Options) -> Result<Self, Error> {
        let about = method.about();
        options.check(about)?;
        Ok(Self { about, method: (about.configure)(about, options)? })
    }

    /// What is known of it whatever its options.
    #[must_use]
    pub fn about(&self) -> &'static About {
        self.about
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> MethodName {
        MethodName(self.about)
    }

    /// The form in which it is evaluated.
    #[must_use]
    pub fn form(&self) -> Form {
        self.options().form.unwrap_or(Form::Stable)
    }
}

impl std::ops::Deref for Configured {
    type Target = dyn Method;

    fn deref(&self) -> &Self::Target {
        &*self.method
    }
}

impl fmt::Debug for Configured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.method.fmt(f)
    }
}

impl PartialEq for Configured {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name() && self.options() == other.options()
    }
}

/// One of [`METHODS`], by its name.
#[derive(Clone, Copy)]
pub struct MethodName(&'static About);

static NAMES: LazyLock<Vec<MethodName>> = LazyLock::new(|| METHODS.iter().copied().flatten().map(MethodName).collect());

impl MethodName {
    /// The method of this name, if there is one.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        NAMES.iter().copied().find(|method| method.0.name == name)
    }

    /// What is known of it.
    #[must_use]
    pub fn about(self) -> &'static About {
        self.0
    }
}

impl fmt::Debug for MethodName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.name)
    }
}

impl PartialEq for MethodName {
    fn eq(&self, other: &Self) -> bool {
        self.0.name == other.0.name
    }
}

impl Eq for MethodName {}

impl ValueEnum for MethodName {
    fn value_variants<'a>() -> &'a [Self] {
        &NAMES
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.0.name).help(self.0.help))
    }
}

impl Serialize for MethodName {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.0.name)
    }
}

impl<'de> Deserialize<'de> for MethodName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        static KNOWN: LazyLock<Vec<&'static str>> =
            LazyLock::new(|| NAMES.iter().map(|method| method.0.name).collect());
        let name = String::deserialize(deserializer)?;
        Self::named(&name).ok_or_else(|| serde::de::Error::unknown_variant(&name, &KNOWN))
    }
}
