//! A VHDL core as Verilog, by GHDL's synthesis: for tools that read Verilog only.

use std::path::Path;

use crate::platform::error::Error;
use crate::platform::tool::{self, GHDL};

/// A VHDL core, the entity `top` in the file `source`, as Verilog by GHDL's synthesis. `directory` is the core's: a ROM
/// file is read at elaboration by its path relative to that. Errors: if GHDL is not installed or does not take the
/// file.
pub(crate) fn as_verilog(top: &str, directory: &Path, source: &Path) -> Result<Vec<u8>, Error> {
    let scratch = tool::scratch()?;
    let source = std::path::absolute(source).map_err(|error| Error::io("cannot find", source, error))?;
    let mut command = GHDL.command(directory);
    command.args(["--synth", "--std=08", "--out=verilog"]).arg(format!("--workdir={}", scratch.path().display()));
    command.arg(source).args(["-e", top]);
    Ok(with_wide_constants(&GHDL.succeed(&mut command)?))
}

/// GHDL 2.0 writes a constant of more than 32 bits as the string of its digits, as VHDL has it; in Verilog that is the
/// number of the string's letters. Returns the netlist with `N'b` literals in their stead. Comments, attributes, and
/// the parameters of a module or an instance stay as they are: there a string is a string.
fn with_wide_constants(netlist: &[u8]) -> Vec<u8> {
    /// The bytes up to the end of what `end` ends, from `at` on.
    fn up_to(text: &[u8], at: usize, end: &[u8]) -> usize {
        let found = text[at..].windows(end.len()).position(|bytes| bytes == end);
        found.map_or(text.len(), |place| at + place + end.len())
    }
    let mut made = Vec::with_capacity(netlist.len());
    // Open parentheses since the `#` of a list of parameters; none outside of one.
    let mut parameters: Option<u32> = None;
    let mut at = 0;
    while at < netlist.len() {
        let rest = &netlist[at..];
        let end = if rest.starts_with(b"//") {
            up_to(netlist, at, b"\n")
        } else if rest.starts_with(b"/*") {
            up_to(netlist, at + 2, b"*/")
        } else if rest.starts_with(b"(*") && !rest.starts_with(b"(*)") {
            up_to(netlist, at + 2, b"*)")
        } else if rest[0] == b'\\' {
            // An escaped name.
            rest.iter().position(u8::is_ascii_whitespace).map_or(netlist.len(), |length| at + length)
        } else if rest[0] == b'"' {
            let mut end = at + 1;
            while end < netlist.len() && netlist[end] != b'"' {
                end += if netlist[end] == b'\\' { 2 } else { 1 };
            }
            (end + 1).min(netlist.len())
        } else {
            at + 1
        };
        let token = &netlist[at..end];
        match (token, &mut parameters) {
            (b"#", none @ None) => *none = Some(0),
            (b"(", Some(depth)) => *depth += 1,
            (b")", Some(depth)) => *depth = depth.saturating_sub(1),
            _ => {}
        }
        // The list has ended, or `#` was followed by a delay.
        if parameters == Some(0) && !matches!(token, [b'#'] | [b' ' | b'\t' | b'\n' | b'\r']) {
            parameters = None;
        }
        match token {
            [b'"', digits @ .., b'"'] if parameters.is_none() && digits.len() > 32 && digits.iter().all(is_digit) => {
                made.extend(format!("{}'b", digits.len()).bytes());
                made.extend(digits);
            }
            _ => made.extend(token),
        }
        at = end;
    }
    made
}

fn is_digit(letter: &u8) -> bool {
    b"01XZ".contains(letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_constants_are_numbers_and_strings_stay() {
        let digits = "10".repeat(17);
        let with = |constant: &str| {
            format!(
                "/* a \"{digits}\" */\n(* note = \"{digits}\" *)\nmodule m #(parameter P = \"{digits}\") (input a);\n  \
                 // \"{digits}\"\n\
                 \x20 assign y = a ? {constant} : x + {constant};\n  always @(*) #1 z <= {constant};\n\
                 \x20 sub #(.P((\"{digits}\")), .Q(1)) \\odd\"name  (.a ({constant}));\n  initial \
                 $display(\"0101\", \"\\\"{digits}\");\nendmodule\n"
            )
        };
        let made = with_wide_constants(with(&format!("\"{digits}\"")).as_bytes());
        assert_eq!(String::from_utf8(made).expect("text"), with(&format!("34'b{digits}")));
    }
}
