//! `brdfgen rom`.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;

use super::source::Source;
use super::{Verdict, say, say_json, write_to};
use crate::core::Design;
use crate::emit::package;
use crate::emit::rom::{self, RomFormat, RomImage};
use crate::fixed::Table;
use crate::platform::error::{Error, refuse};
use crate::platform::input;
use crate::spec::CoreSpec;

#[derive(Args)]
pub(super) struct Arguments {
    /// Formats to write [default: all]; with --check the format of FILE, whatever its name is
    #[arg(long, value_enum, value_delimiter = ',', value_name = "FORMATS")]
    format: Vec<RomFormat>,

    /// Directory to write to; - writes one format of one memory to standard output [default: rom]
    #[arg(long, short, value_name = "DIR", conflicts_with = "check")]
    out: Option<PathBuf>,

    /// Compare a ROM file of any format with the core's; exit 1 and say the first word that differs if one does
    #[arg(long, value_name = "FILE")]
    check: Option<PathBuf>,

    /// Only this memory of the core, by its name in the datasheet [default: all; with --check the one that FILE is of]
    #[arg(long, value_name = "MEMORY")]
    memory_name: Option<String>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    source: Source,
}

pub(super) fn run(arguments: Arguments) -> Result<Verdict, Error> {
    let design = arguments.source.design()?;
    let spec = &design.spec;
    refuse!(
        design.tables().is_empty(),
        format!("the core {} has no ROM", spec.name),
        "its method computes everything from in_n and the operand"
    );
    let tables = tables(&design, arguments.memory_name.as_deref())?;
    if let Some(path) = &arguments.check {
        return check(&arguments, path, spec, &tables);
    }
    let formats = if arguments.format.is_empty() { RomFormat::ALL.to_vec() } else { arguments.format };
    let out = arguments.out.unwrap_or_else(|| PathBuf::from("rom"));
    let to_stdout = out.as_os_str() == "-";
    if to_stdout && formats.len() != 1 {
        return Err(Error::input("several formats do not fit on standard output", "choose one with --format"));
    }
    if to_stdout && tables.len() != 1 {
        return Err(Error::input(
            format!("the core {} has {} memories", spec.name, tables.len()),
            format!(
                "several do not fit on standard output: choose one with --memory-name {}",
                names(&tables).join(" or ")
            ),
        ));
    }
    if !to_stdout {
        let files = tables.iter().flat_map(|table| formats.iter().map(|format| format.file_name(&spec.name, table)));
        let files: Vec<String> = files.collect();
        arguments.source.paths().writes_in("--out", &out, files.iter().map(String::as_str)).check()?;
    }
    let mut memories = Vec::new();
    let mut written = Vec::new();
    for table in tables {
        let mut files = Vec::new();
        for &format in &formats {
            let path = if to_stdout { out.clone() } else { out.join(format.file_name(&spec.name, table)) };
            write_to(&path, &package::rom_file(&design, table, format).bytes)?;
            files.push(path.display().to_string());
        }
        memories.push(json!({
            "name": table.name, "depth": table.depth(), "word_bits": table.word_bits(), "files": files,
        }));
        written.extend(files);
    }
    if arguments.json && !to_stdout {
        say_json(&json!({ "memories": memories, "files": written }));
    } else if !to_stdout {
        written.iter().for_each(say);
    }
    Ok(Verdict::Done)
}

/// The memories of a core, or the one of this name.
fn tables<'a>(design: &'a Design, name: Option<&str>) -> Result<Vec<&'a Table>, Error> {
    let all: Vec<&Table> = design.tables().iter().collect();
    let Some(name) = name else { return Ok(all) };
    match all.iter().find(|table| table.name == name) {
        Some(table) => Ok(vec![table]),
        None => Err(Error::input(
            format!("the core {} has no memory {name}", design.spec.name),
            format!("it has {}", names(&all).join(" and ")),
        )),
    }
}

fn names<'a>(tables: &[&'a Table]) -> Vec<&'a str> {
    tables.iter().map(|table| table.name).collect()
}

/// Compares a file with the memory that it is of: that of its name, or else the one with most of its words.
fn check(arguments: &Arguments, path: &Path, spec: &CoreSpec, tables: &[&Table]) -> Result<Verdict, Error> {
    let format = match *arguments.format {
        [] => RomFormat::of_file(path)?,
        [format] => format,
        _ => return Err(Error::input("a file is of one format", "give one with --format")),
    };
    let bytes = input::read(path, input::MAX_TEXT)?;
    let shown = path.display().to_string();
    let read = |table: &Table| rom::read(&bytes, format, &shown, table.word_bits());
    let named = |table: &&&Table| path.file_name().is_some_and(|name| *name == *format.file_name(&spec.name, table));
    let images: Vec<(&Table, RomImage)> = tables.iter().filter_map(|&table| Some((table, read(table).ok()?))).collect();
    let same = |(table, image): &&(&Table, RomImage)| rom::first_difference(table, image).is_none();
    let by_name =
        || tables.iter().find(named).and_then(|named| images.iter().find(|(table, _)| table.name == named.name));
    // Of several with as many equal words the first.
    let nearest = || images.iter().rev().max_by_key(|(table, image)| rom::equal_words(table, image));
    let Some((table, image)) = images.iter().find(same).or_else(by_name).or_else(nearest) else {
        // Refused for each: the widest words allow the most.
        let widest = tables.iter().rev().max_by_key(|table| table.word_bits());
        let refused = widest.map(|table| read(table)).unwrap_or_else(|| Err(Error::input("no memory", "")));
        return refused.map(|_| Verdict::Differs);
    };
    let difference = rom::first_difference(table, image);
    if arguments.json {
        let first = difference.as_ref().map(ToString::to_string);
        say_json(&json!({
            "file": shown, "memory": table.name, "kind": image.kind, "words": image.words.len(),
            "first_difference": first,
        }));
    } else {
        let kind = image.kind.map(|kind| format!(" ({kind})")).unwrap_or_default();
        // Named where there is a choice.
        let memory = if tables.len() > 1 { format!(" of the memory {}", table.name) } else { String::new() };
        match &difference {
            Some(difference) if memory.is_empty() => say(format!("{shown}{kind}: {difference}")),
            Some(difference) => say(format!("{shown}{kind}: as the words{memory}: {difference}")),
            None => say(format!("{shown}{kind}: all {} words{memory} are as they should be", table.depth())),
        }
    }
    Ok(Verdict::of(difference.is_none()))
}
