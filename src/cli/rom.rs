//! `brdfgen rom`.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use super::source::Source;
use super::{Verdict, say, say_json, write_to};
use crate::error::Error;
use crate::input;
use crate::rom::{self, RomFormat, Table};

#[derive(Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// Formats to write [default: all]
    #[arg(long, value_enum, value_delimiter = ',', value_name = "FORMATS")]
    format: Vec<RomFormat>,

    /// Directory to write to; - writes one format to standard output [default: rom]
    #[arg(long, short, value_name = "DIR", conflicts_with = "check")]
    out: Option<PathBuf>,

    /// Compare a ROM file of any format with the core's; exit 1 and say the first word that differs if one does
    #[arg(long, value_name = "FILE", conflicts_with = "format")]
    check: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: Arguments) -> Result<Verdict, Error> {
    let design = arguments.source.design()?;
    let spec = &design.spec;
    if design.tables().is_empty() {
        return Err(Error::input(
            format!("the core {} has no ROM", spec.name),
            "its method computes everything from in_n and the operand",
        ));
    }
    if let Some(path) = &arguments.check {
        let format = RomFormat::of_file(path)?;
        let bytes = input::read(path, input::MAX_TEXT)?;
        // By its name, if that is one of the core's memories' names; the coefficients else.
        let named = |table: &&Table| path.file_name().is_some_and(|name| *name == *format.file_name(&spec.name, table));
        let table = design.tables().iter().find(named).unwrap_or(&design.tables()[0]);
        let image = rom::read(&bytes, format, &path.display().to_string(), table.word_bits())?;
        let difference = rom::first_difference(table, &image);
        if arguments.json {
            let first = difference.as_ref().map(ToString::to_string);
            say_json(
                &json!({ "file": path.display().to_string(), "words": image.words.len(), "first_difference": first }),
            );
        } else {
            match &difference {
                Some(difference) => say(format!("{}: {difference}", path.display())),
                None => say(format!("{}: all {} words are as they should be", path.display(), table.depth())),
            }
        }
        return Ok(Verdict::of(difference.is_none()));
    }
    let formats = if arguments.format.is_empty() { RomFormat::ALL.to_vec() } else { arguments.format };
    let out = arguments.out.unwrap_or_else(|| PathBuf::from("rom"));
    let to_stdout = out.as_os_str() == "-";
    if to_stdout && formats.len() != 1 {
        return Err(Error::input("several formats do not fit on standard output", "choose one with --format"));
    }
    if to_stdout && design.tables().len() != 1 {
        return Err(Error::input(
            format!("the core {} has {} memories", spec.name, design.tables().len()),
            "several do not fit on standard output: give a directory",
        ));
    }
    let mut memories = Vec::new();
    let mut written = Vec::new();
    for table in design.tables() {
        let mut files = Vec::new();
        for &format in &formats {
            let path = if to_stdout { out.clone() } else { out.join(format.file_name(&spec.name, table)) };
            let name = rom::memory_name(&spec.name, table);
            write_to(&path, &rom::write(table, format, &name, &spec.digest(), &spec.command()))?;
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
