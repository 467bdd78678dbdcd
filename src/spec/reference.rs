//! The reference page of a spec's keys.

use askama::Template;
use clap::builder::PossibleValue;
use clap::{Arg, Args, Command};

use super::SpecFields;
use crate::method::keys::{Fields, Key};
use crate::method::{About, METHODS};

/// What the page says of a key.
struct KeyRow {
    name: &'static str,
    flag: String,
    heading: String,
    values: String,
    default: String,
    applies: String,
    meaning: String,
    /// The words that it may be and what they mean; none for a key of other values.
    words: Vec<(String, String)>,
}

impl KeyRow {
    fn new(key: Key, arg: &Arg) -> Self {
        let help = arg.get_help().map(ToString::to_string).unwrap_or_default();
        let words = arg.get_possible_values();
        // Help says no default of a flag that is there or not.
        let stands_alone = arg.get_num_args().is_some_and(|values| values.min_values() == 0);
        let none = if stands_alone { "false]" } else { "none]" };
        let (meaning, default) = help.split_once(" [default: ").unwrap_or((&help, none));
        let values = match (words.as_slice(), arg.get_value_names()) {
            ([], None) => code([key.name.to_uppercase()]),
            ([], Some(names)) => code(names.iter().flat_map(|name| name.split('|'))),
            (words, _) => code(words.iter().map(PossibleValue::get_name)),
        };
        let told = |word: &PossibleValue| Some((word.get_name().to_owned(), cell(&word.get_help()?.to_string())));
        Self {
            name: key.name,
            flag: arg.get_long().unwrap_or_default().to_owned(),
            heading: arg.get_help_heading().unwrap_or_default().to_owned(),
            values,
            default: default.trim_end_matches(']').to_owned(),
            applies: applies(key),
            meaning: cell(meaning),
            words: words.iter().filter_map(told).collect(),
        }
    }
}

/// Where a key applies: what its table says, or the methods that have it.
fn applies(key: Key) -> String {
    let has = |about: &&About| about.has(key.name) || (key.name == "coefficients" && !about.coefficients.is_empty());
    let methods = code(METHODS.iter().copied().flatten().filter(has).map(|about| about.name));
    match key.applies {
        "" if methods.is_empty() => "all".to_owned(),
        "" => methods,
        applies => applies.to_owned(),
    }
}

/// Text of a cell, which no bar in it ends.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

/// Words as code in a cell of a table.
fn code(words: impl IntoIterator<Item = impl AsRef<str>>) -> String {
    words.into_iter().map(|word| format!("`{}`", word.as_ref())).collect::<Vec<_>>().join(", ")
}

#[derive(Template)]
#[template(path = "spec/spec.md")]
struct Page {
    rows: Vec<KeyRow>,
}

/// The reference page of a spec's keys, `docs/spec.md`, in Markdown.
///
/// # Panics
/// Never: every key is a flag, and a template of texts can be filled in.
#[must_use]
pub fn reference() -> String {
    let mut command = SpecFields::augment_args(Command::new(""));
    command.build();
    let row = |(key, _): (Key, _)| {
        let arg = command.get_arguments().find(|arg| arg.get_long() == Some(&key.flag())).expect("every key is a flag");
        KeyRow::new(key, arg)
    };
    let page = Page { rows: SpecFields::default().values().into_iter().map(row).collect() };
    page.render().expect("a template of texts").trim().to_owned() + "\n"
}
