//! What a run goes over: axes of spec keys, expanded to cores.
//!
//! A sweep file holds `[[sweep]]` blocks, each a table of keys of the core spec, and `family`. A list is an axis: every
//! one of its values is combined with every one of the other axes'; a value that is itself a list is written as a list
//! in the list. The value `default` leaves the key out, so that `coefficients = ["default", "minimax"]` also reaches
//! methods that have none. Where a block does not say it, the methods are all, the shininess is `1..=1000` and the
//! family `ecp5`.
//!
//! ```toml
//! [[sweep]]
//! method = ["quadratic", "cubic"]
//! coefficients = ["paper", "minimax"]
//! output_fraction = [8, 12, 16]
//!
//! [[sweep]]
//! method = "schlick"
//! divider = ["digit", "reciprocal"]
//! shininess = ["1..=1000", [5, 12.5, 80]]
//! family = ["ecp5", "ice40"]
//! ```

use std::collections::{BTreeMap, BTreeSet};

use clap::ValueEnum;
use serde::Deserialize;
use sha2::{Digest, Sha256};
use toml::{Table, Value};

use crate::method::word;
use crate::platform::error::{Error, refuse};
use crate::platform::input;
use crate::spec::{BlockKind, CoreSpec, MethodName, SpecFields, hex};
use crate::target::Family;

/// The most combinations of a run; a synthesis takes seconds, so that a larger number is a slip.
pub const MOST: usize = 100_000;

/// The word that leaves a key out.
const DEFAULT: &str = "default";

/// The keys that a core is built for, and not from.
const FAMILY: &str = "family";

/// What a run goes over: blocks of axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sweep(Vec<Axes>);

/// The values of each key of a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axes(BTreeMap<String, Vec<Value>>);

/// A core for a family.
#[derive(Clone, Debug, PartialEq)]
pub struct Core {
    /// 16 hexadecimal digits that stand for the spec and the family.
    pub id: String,
    /// The family.
    pub family: Family,
    /// The core.
    pub spec: CoreSpec,
}

/// The cores of a sweep.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plan {
    /// The cores, each once, by id.
    pub cores: Vec<Core>,
    /// How many combinations the axes have.
    pub combinations: usize,
    /// How many of them gave a core that another one had given.
    pub repeated: usize,
    /// Why combinations are no core, each reason with the number of them.
    pub invalid: BTreeMap<String, usize>,
}

impl Core {
    /// A core for a family.
    #[must_use]
    pub fn new(spec: CoreSpec, family: Family) -> Self {
        let text = format!("{}\nfamily {}", spec.to_toml(), word(&family));
        Self { id: hex(&Sha256::digest(text))[..16].to_owned(), family, spec }
    }
}

impl Axes {
    /// Sets the values of an axis, which has none yet.
    ///
    /// # Errors
    /// A key that a core spec does not have or that is set already, a value that the key does not take, or no value.
    pub fn set(&mut self, key: &str, values: Vec<Value>) -> Result<(), Error> {
        refuse!(values.is_empty(), format!("the axis {key} has no value"), "give one or more, or leave it out");
        refuse!(
            self.0.contains_key(key),
            format!("the axis {key} is given twice"),
            "give all of its values at once, as in output_fraction=6,8"
        );
        for value in &values {
            check(key, value)?;
        }
        self.0.insert(key.to_owned(), values);
        Ok(())
    }

    /// As [`Axes::set`], with each value as it is written in TOML, where a word needs no quotes.
    ///
    /// # Errors
    /// As [`Axes::set`].
    pub fn set_written(&mut self, key: &str, values: &[String]) -> Result<(), Error> {
        #[derive(Deserialize)]
        struct Line {
            value: Value,
        }
        let value = |text: &String| match toml::from_str::<Line>(&format!("value = {text}")) {
            Ok(Line { value }) if !matches!(value, Value::Datetime(_)) => value,
            _ => Value::String(text.clone()),
        };
        self.set(key, values.iter().map(value).collect())
    }

    /// Sets the shininesses, each set as a flag of a core gives it: `1..=1000` or `5,12.5,80`.
    ///
    /// # Errors
    /// As [`Axes::set`].
    pub fn set_sets(&mut self, sets: &[String]) -> Result<(), Error> {
        self.set("shininess", sets.iter().cloned().map(Value::String).collect())
    }

    /// The values of a key, or these.
    fn or(&mut self, key: &str, values: impl IntoIterator<Item = String>) {
        self.0.entry(key.to_owned()).or_insert_with(|| values.into_iter().map(Value::String).collect());
    }

    /// Takes the combinations of all values into the plan.
    fn expand(mut self, plan: &mut Plan, seen: &mut BTreeSet<String>) -> Result<(), Error> {
        self.or("method", MethodName::value_variants().iter().map(word));
        if !self.0.contains_key("material") {
            self.or("shininess", ["1..=1000".to_owned()]);
        }
        self.or(FAMILY, [Family::default().name.to_owned()]);
        let axes: Vec<(&String, &Vec<Value>)> = self.0.iter().collect();
        let count = axes.iter().try_fold(1usize, |count, (_, values)| count.checked_mul(values.len()));
        let count = count.filter(|&count| plan.combinations.saturating_add(count) <= MOST).ok_or_else(|| {
            Error::input("the sweep has too many combinations", format!("a run goes over at most {MOST} of them"))
        })?;
        plan.combinations += count;
        for place in 0..count {
            let mut table = Table::new();
            let mut rest = place;
            for (key, values) in &axes {
                let value = &values[rest % values.len()];
                rest /= values.len();
                if value.as_str() != Some(DEFAULT) {
                    table.insert((*key).clone(), value.clone());
                }
            }
            let family = match table.remove(FAMILY) {
                Some(value) => family(&value)?,
                None => Family::default(),
            };
            let resolved = table.try_into::<SpecFields>().map_err(|error| Error::input(error.message(), ""));
            match resolved.and_then(SpecFields::resolve) {
                Ok(spec) => {
                    let core = Core::new(spec, family);
                    if seen.insert(core.id.clone()) {
                        plan.cores.push(core);
                    } else {
                        plan.repeated += 1;
                    }
                }
                Err(error) => *plan.invalid.entry(error.to_string()).or_default() += 1,
            }
        }
        Ok(())
    }
}

fn family(value: &Value) -> Result<Family, Error> {
    let named = value.as_str().and_then(|text| Family::from_str(text, false).ok());
    named.ok_or_else(|| {
        let all = Family::names(|_| true).join(", ");
        Error::input(format!("there is no family {value}"), format!("the families are {all}"))
    })
}

/// Refuses a value that its key does not take whatever the other keys are.
fn check(key: &str, value: &Value) -> Result<(), Error> {
    if value.as_str() == Some(DEFAULT) {
        return Ok(());
    }
    if key == FAMILY {
        return family(value).map(|_| ());
    }
    let text = Table::from_iter([(key.to_owned(), value.clone())]).to_string();
    if let Err(Error::Text { what, allowed, .. }) = input::check_toml_numbers(&text, "sweep") {
        return Err(Error::input(format!("{key}: {what}"), allowed));
    }
    let fields = SpecFields::parse(&text, "sweep").map_err(|error| match error {
        Error::Text { what, allowed, .. } => Error::input(format!("{key}: {what}"), allowed),
        other => other,
    })?;
    match fields.block {
        None | Some(BlockKind::Lobe) => Ok(()),
        Some(BlockKind::Shader) => {
            Err(Error::input("a sweep cannot go over shaders", "it goes over lobes; see method"))
        }
        Some(BlockKind::Image) => {
            Err(Error::input("a sweep cannot go over image-based blocks", "it goes over lobes; see method"))
        }
    }
}

impl Sweep {
    /// A sweep of one block.
    #[must_use]
    pub fn of(axes: Axes) -> Self {
        Self(vec![axes])
    }

    /// Reads a sweep file; `file` names it in messages.
    ///
    /// # Errors
    /// Text that is no TOML, no block, an unknown key or a value that its key does not take, with its place.
    pub fn parse(text: &str, file: &str) -> Result<Self, Error> {
        const ALLOWED: &str = "a sweep file holds [[sweep]] blocks of spec keys, each with a value or a list of values";
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Written {
            sweep: Vec<Table>,
        }
        let written: Written = toml::from_str(text).map_err(|error| {
            let span = error.span().unwrap_or(0..0);
            Error::text(error.message(), ALLOWED, file, text, (span.start, span.len()))
        })?;
        refuse!(written.sweep.is_empty(), format!("{file} has no [[sweep]] block"), ALLOWED);
        // The place of a block: its heading is on a line of its own.
        let headings = text.match_indices("[[").map(|(at, _)| at).chain([text.len()]).collect::<Vec<_>>();
        let block = |(number, table): (usize, Table)| {
            let mut axes = Axes::default();
            for (key, value) in table {
                let values = match value {
                    Value::Array(values) => values,
                    one => vec![one],
                };
                axes.set(&key, values).map_err(|error| match error {
                    Error::Input { what, allowed } => {
                        let from = headings.get(number).copied().unwrap_or_default();
                        let at = text[from..].find(&key).map_or(from, |offset| from + offset);
                        Error::text(what, allowed, file, text, (at, key.len()))
                    }
                    other => other,
                })?;
            }
            Ok(axes)
        };
        written.sweep.into_iter().enumerate().map(block).collect::<Result<_, _>>().map(Self)
    }

    /// The same with these axes in every block, in place of those that the block has for the same keys.
    #[must_use]
    pub fn with(mut self, axes: &Axes) -> Self {
        for block in &mut self.0 {
            // The two ways to give the shininesses exclude each other.
            if axes.0.contains_key("shininess") || axes.0.contains_key("material") {
                block.0.retain(|key, _| key != "shininess" && key != "material");
            }
            block.0.extend(axes.0.clone());
        }
        self
    }

    /// The cores of all valid combinations.
    ///
    /// # Errors
    /// More than [`MOST`] combinations, or none that is valid.
    pub fn expand(self) -> Result<Plan, Error> {
        let (mut plan, mut seen) = (Plan::default(), BTreeSet::new());
        for axes in self.0 {
            axes.expand(&mut plan, &mut seen)?;
        }
        if plan.cores.is_empty() {
            let reasons: Vec<String> = plan.invalid.keys().cloned().collect();
            return Err(Error::input(
                format!("none of the {} combinations is a core", plan.combinations),
                reasons.join("; "),
            ));
        }
        plan.cores.sort_by(|a, b| a.id.cmp(&b.id));
        Ok(plan)
    }
}

/// A part of a plan: every `of`th core by id, from the `index`th, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which part, from 1.
    pub index: usize,
    /// Of how many.
    pub of: usize,
}

impl std::str::FromStr for Shard {
    type Err = String;

    /// Reads `I/N`.
    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/').and_then(|(index, of)| Some((index.parse().ok()?, of.parse().ok()?)));
        match parts {
            Some((index, of)) if (1..=of).contains(&index) => Ok(Self { index, of }),
            _ => Err("a shard is written I/N with I from 1 to N, as in 2/8".to_owned()),
        }
    }
}

impl Shard {
    /// The cores of this part.
    #[must_use]
    pub fn of(self, cores: Vec<Core>) -> Vec<Core> {
        cores.into_iter().skip(self.index - 1).step_by(self.of).collect()
    }
}
