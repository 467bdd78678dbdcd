//! The golden file's text.

use std::fmt::Write;

use super::{Golden, RowDigest, Vector};
use crate::core::Design;
use crate::core::Direction;
use crate::fixed::Format;
use crate::platform::error::Error;
use crate::spec::Block;

const ALLOWED: &str = "a golden file holds `v` lines (the codes of the inputs and of the outputs in hexadecimal; idle, stall in \
                       decimal), `d` lines (the first input's code, digest), one `c` line (the number of vectors) and comments that begin with `#`";

impl Golden {
    /// The file's text.
    #[must_use]
    pub fn to_text(&self, design: &Design) -> String {
        let digits = |format: Format| format.width().div_ceil(4) as usize;
        let (inputs, outputs) = (design.numbers(Direction::In), design.numbers(Direction::Out));
        let ports: Vec<String> = inputs
            .iter()
            .chain(&outputs)
            .map(|(name, format)| format!("{name} ({format}{})", if format.signed { ", two's complement" } else { "" }))
            .collect();
        let count: usize = self.groups.iter().map(|(_, vectors)| vectors.len()).sum();
        let mut text = format!(
            "# brdfgen golden vectors\n\
             # core {}\n\
             # spec {}\n\
             # v {} in hexadecimal; in decimal: idle, the\n\
             #   clocks without a valid input before the vector; stall, the clocks with ce low while it waits\n\
             c {count}\n",
            self.core,
            self.spec_digest,
            ports.join(", "),
        );
        for (heading, vectors) in &self.groups {
            let _ = writeln!(text, "# {heading}");
            for vector in vectors {
                text.push('v');
                let codes = vector.inputs.iter().chain(&vector.outputs);
                for (&(_, format), &code) in inputs.iter().chain(&outputs).zip(codes) {
                    let _ = write!(text, " {:0digits$x}", format.bits(code.into()), digits = digits(format));
                }
                let _ = writeln!(text, " {} {}", vector.idle, vector.stall);
            }
        }
        let (index, index_format) = inputs[0];
        let ni = digits(index_format);
        let shown: Vec<&str> = outputs.iter().map(|&(name, _)| name).collect();
        let over = match design.spec.block {
            Block::Lobe => format!("all {} codes of {}, the least first", 1u64 << inputs[1].1.width(), inputs[1].0),
            Block::Shader(_) => format!("the {} samples of its stream", super::shader::STREAM),
        };
        let _ = writeln!(text, "# d {index}, XXH3-64 over {} for {over}, 4 little-endian bytes each", shown.join(", "));
        for d in &self.digests {
            let _ = writeln!(text, "d {:0ni$x} {:016x}", d.index, d.digest);
        }
        text
    }
}

/// Reads a golden file of a design; `file` names it in messages.
///
/// # Errors
/// Text that is no golden file, one of another core or spec, a malformed line, a count that does not match.
pub fn parse(design: &Design, text: &str, file: &str) -> Result<Golden, Error> {
    let (inputs, outputs) = (design.numbers(Direction::In), design.numbers(Direction::Out));
    let ports = inputs.len() + outputs.len();
    let mut golden =
        Golden { core: String::new(), spec_digest: String::new(), groups: Vec::new(), digests: Vec::new() };
    let whole = |what: String, allowed: &str| Error::input(format!("{file}: {what}"), allowed);
    let (core, spec) = (&design.spec.name, design.spec.digest());
    let of_another = |its_core: &str, its_spec: &str| {
        whole(
            format!("these are the vectors of core {its_core} with spec {its_spec}"),
            &format!("vectors of core {core} with spec {spec} are wanted; `brdfgen golden` makes them"),
        )
    };
    // First, as the codes of another core may not fit this one's ports.
    let stated = |key: &str| text.lines().find_map(|line| line.strip_prefix(key)).map(str::trim);
    if let (Some(its_core), Some(its_spec)) = (stated("# core "), stated("# spec "))
        && (its_core, its_spec) != (core.as_str(), spec.as_str())
    {
        return Err(of_another(its_core, its_spec));
    }
    let mut declared = None;
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        let start = offset;
        offset += line.len();
        let line = line.trim_end();
        let wrong = |what: String| Error::text(what, ALLOWED, file, text, (start, line.len()));
        let mut words = line.split_ascii_whitespace();
        let kind = words.next();
        let words: Vec<&str> = words.collect();
        match (kind, words.as_slice()) {
            (None, _) => {}
            (Some("#"), ["core", name]) => golden.core = (*name).to_owned(),
            (Some("#"), ["spec", digest]) => golden.spec_digest = (*digest).to_owned(),
            (Some("#"), rest) => golden.groups.push((rest.join(" "), Vec::new())),
            (Some("c"), [count]) => {
                declared = Some(count.parse::<usize>().map_err(|_| wrong(format!("`{count}` is not a count")))?);
            }
            (Some("v"), [codes @ .., idle, stall]) if codes.len() == ports => {
                let code = |(word, &(_, format)): (&&str, &(&str, Format))| {
                    let code = u64::from_str_radix(word, 16).ok().filter(|&code| code >> format.width() == 0);
                    let width = format.width();
                    code.map(|code| format.wrap(code.into()) as i64)
                        .ok_or_else(|| wrong(format!("`{word}` is not a {width}-bit code")))
                };
                let (given, expected) = codes.split_at(inputs.len());
                let clocks =
                    |word: &str| word.parse().map_err(|_| wrong(format!("`{word}` is not a number of clocks")));
                let vector = Vector {
                    inputs: given.iter().zip(&inputs).map(code).collect::<Result<_, _>>()?,
                    outputs: expected.iter().zip(&outputs).map(code).collect::<Result<_, _>>()?,
                    idle: clocks(idle)?,
                    stall: clocks(stall)?,
                };
                match golden.groups.last_mut() {
                    Some((_, vectors)) => vectors.push(vector),
                    None => golden.groups.push((String::new(), vec![vector])),
                }
            }
            (Some("d"), [n, digest]) => {
                let whole = digest.len() == 16;
                let parsed =
                    u32::from_str_radix(n, 16).ok().zip(u64::from_str_radix(digest, 16).ok()).filter(|_| whole);
                let (index, digest) = parsed.ok_or_else(|| wrong("the digest line is malformed".to_owned()))?;
                golden.digests.push(RowDigest { index, digest });
            }
            _ => return Err(wrong("this line is malformed".to_owned())),
        }
    }
    let found = golden.vectors().len();
    match declared {
        None => return Err(whole("this is no golden file: it has no `c` line".to_owned(), ALLOWED)),
        Some(declared) if declared != found => {
            return Err(whole(
                format!("{declared} vectors are announced and {found} are there"),
                "the file is truncated or edited",
            ));
        }
        Some(_) => {}
    }
    if (&golden.core, &golden.spec_digest) != (core, &spec) {
        return Err(of_another(&golden.core, &golden.spec_digest));
    }
    let digests = super::digest_rows(design).len();
    if golden.digests.len() != digests {
        return Err(whole(
            format!("{digests} digests are wanted and {} are there", golden.digests.len()),
            "the file is truncated or edited",
        ));
    }
    Ok(golden)
}
