//! The names that a text declares: none twice in one scope, and none of them the core's.
//!
//! It reads texts as the templates write them, one declaration a line, and not any Verilog or VHDL.

use std::collections::HashMap;

use crate::platform::error::{Error, refuse};
use crate::spec::Language;

/// A name that a text declares.
struct Declared {
    name: String,
    /// The scope, by the number of the line that opened it.
    scope: usize,
    line: usize,
}

/// The text, unless it declares a name twice in one scope, or uses the name of `core` for something else.
/// Errors: names what clashes, and a name for the core that does not where that is the reason.
pub(super) fn checked(language: Language, core: &str, text: String) -> Result<String, Error> {
    let mut seen: HashMap<(usize, String), usize> = HashMap::new();
    for Declared { name, scope, line } in declared(language, &text) {
        let folded = name.to_ascii_lowercase();
        refuse!(
            folded == core,
            format!("a core cannot be named `{core}`: its {language} has another `{name}`"),
            format!("another name works: --name {core}_core")
        );
        let key = if language == Language::Vhdl { folded } else { name.clone() };
        if let Some(before) = seen.insert((scope, key), line) {
            return Err(Error::input(
                format!("the {language} of {core} would declare `{name}` twice, in lines {before} and {line}"),
                "this is a fault of brdfgen: please report it with the spec; another --pipeline may do until then",
            ));
        }
    }
    Ok(text)
}

/// What a text declares, but for the module or entity itself.
fn declared(language: Language, text: &str) -> Vec<Declared> {
    let comment = if language == Language::Verilog { "//" } else { "--" };
    let mut found = Vec::new();
    let mut scopes = vec![0];
    for (line, text) in text.lines().enumerate().map(|(place, text)| (place + 1, text)) {
        // Rows of memories, nearly all of a long text, declare nothing.
        if text.trim_start().starts_with(|c: char| c.is_ascii_digit()) {
            continue;
        }
        let code = without_strings(text);
        let code = code.split_once(comment).map_or(code.as_str(), |(code, _)| code).trim();
        let words: Vec<&str> = code.split(|c: char| !is_part(c)).filter(|word| !word.is_empty()).collect();
        let Some(&first) = words.first() else { continue };
        let ends = first == "end" || first == "endtask";
        if ends {
            let closes = ["endtask", "process", "function", "procedure", "record"];
            if scopes.len() > 1 && words.iter().any(|word| closes.contains(word)) {
                scopes.pop();
            }
            continue;
        }
        let names = match language {
            Language::Verilog => verilog_names(code),
            Language::Vhdl => vhdl_names(code, &words),
        };
        // A subprogram's name belongs to what surrounds it, its parameters to itself.
        let opens = match language {
            Language::Verilog => first == "task",
            Language::Vhdl => {
                ["impure", "function", "procedure"].contains(&first)
                    || words.contains(&"process")
                    || words.ends_with(&["is", "record"])
            }
        };
        let mut names = names.into_iter();
        if opens {
            found.extend(names.next().map(|name| Declared { name, scope: scopes[scopes.len() - 1], line }));
            scopes.push(line);
        }
        found.extend(names.map(|name| Declared { name, scope: scopes[scopes.len() - 1], line }));
    }
    found
}

/// Whether a letter may be part of a name or number.
fn is_part(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_'
}

/// A line with its strings emptied.
fn without_strings(line: &str) -> String {
    line.split('"').step_by(2).collect::<Vec<_>>().join("\"\"")
}

/// The name that a line of Verilog declares: behind the keywords and the range.
fn verilog_names(code: &str) -> Vec<String> {
    const KEYWORDS: [&str; 11] =
        ["input", "output", "wire", "reg", "integer", "localparam", "parameter", "task", "signed", "time", "genvar"];
    // An attribute stands in front.
    let mut rest = code.split_once("*) ").map_or(code, |(_, rest)| rest).trim_start();
    let mut any = false;
    while let Some(keyword) =
        KEYWORDS.iter().find(|keyword| rest.strip_prefix(**keyword).is_some_and(|rest| rest.starts_with([' ', '['])))
    {
        any = true;
        rest = rest[keyword.len()..].trim_start();
        if rest.starts_with('[') {
            rest = rest.split_once(']').map_or("", |(_, rest)| rest).trim_start();
        }
    }
    if any {
        return rest
            .split(|c: char| !is_part(c))
            .next()
            .filter(|name| !name.is_empty())
            .map(str::to_owned)
            .into_iter()
            .collect();
    }
    // An instance: its name and an open parenthesis end the line.
    let instance = code.strip_suffix(" (").and_then(|before| before.rsplit_once(' '));
    let is_name =
        |name: &&str| name.chars().all(is_part) && !["module", "if", "case"].iter().any(|word| code.starts_with(word));
    instance.map(|(_, name)| name).filter(is_name).map(str::to_owned).into_iter().collect()
}

/// The names that a line of VHDL declares: what stands in front of a colon, or behind the word for a type or a
/// subprogram; the latter first.
fn vhdl_names(code: &str, words: &[&str]) -> Vec<String> {
    let mut names = Vec::new();
    for pair in words.windows(2).take(2) {
        if ["type", "subtype", "function", "procedure", "attribute"].contains(&pair[0]) && pair[1] != "of" {
            names.push(pair[1].to_owned());
            break;
        }
    }
    if words.first() == Some(&"attribute") {
        // What it is of is declared already.
        return if words.get(2) == Some(&"of") { Vec::new() } else { names };
    }
    for (place, _) in code.match_indices(':').filter(|(place, _)| !code[place + 1..].starts_with('=')) {
        let before = code[..place].trim_end();
        let name: String =
            before.chars().rev().take_while(|&c| is_part(c)).collect::<Vec<_>>().into_iter().rev().collect();
        names.extend(Some(name).filter(|name| !name.is_empty()));
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(language: Language, core: &str, text: &str) -> String {
        checked(language, core, text.to_owned()).expect_err(text).to_string()
    }

    #[test]
    fn a_name_is_declared_once_in_a_scope() {
        let verilog = "module m (\n    input  wire clk,\n    output wire [3:0] out_y\n);\n    wire [3:0] m_0 = 4'd0; \
         // wire m_0\n";
        assert!(checked(Language::Verilog, "m", verilog.to_owned()).is_ok());
        for twice in ["    wire m_0 = 1'b1;", "    reg [7:0] m_0;", "    integer clk = 0;", "    x #(\n    ) m_0 ("] {
            let message = refused(Language::Verilog, "m", &format!("{verilog}{twice}\n"));
            assert!(message.contains("twice, in lines"), "{message}");
        }
        let case = format!("{verilog}    wire M_0 = 1'b1;\n");
        assert!(checked(Language::Verilog, "m", case).is_ok());
        let task = format!("{verilog}    task t;\n        input clk;\n    endtask\n");
        assert!(checked(Language::Verilog, "m", task.clone()).is_ok());
        assert!(refused(Language::Verilog, "m", &format!("{task}    reg t = 0;\n")).contains("`t` twice"));

        let vhdl = "entity m is\n    port (\n        clk : in  std_logic\n    );\narchitecture rtl of m is\n    signal \
         m_0 : std_logic; -- x : y\n";
        assert!(checked(Language::Vhdl, "m", vhdl.to_owned()).is_ok());
        for twice in [
            "constant M_0 : natural := 0;",
            "type m_0 is array (0 to 1) of bit;",
            "Clk : process is",
            "procedure clk is",
        ] {
            let message = refused(Language::Vhdl, "m", &format!("{vhdl}    {twice}\n"));
            assert!(message.contains("twice, in lines"), "{message}");
        }
        let inner = "    function f(m_0 : string) return x is\n        variable clk : bit := m_0(1);\n    begin\n    \
         end function;\n    m_0 <= m_0;\n    m_0 := m_0;\n";
        assert!(checked(Language::Vhdl, "m", format!("{vhdl}{inner}")).is_ok());
        assert!(refused(Language::Vhdl, "m", &format!("{vhdl}{inner}{inner}")).contains("`f` twice"));
    }

    #[test]
    fn the_cores_name_is_nothing_elses() {
        let text = "module dut_tb;\n    localparam NAME = \"dut\";\n    dut dut (\n    );\n";
        assert!(refused(Language::Verilog, "dut", text).contains("cannot be named `dut`"));
        assert!(refused(Language::Verilog, "name", text).contains("has another `NAME`"));
        assert!(refused(Language::Vhdl, "x", "    signal X : bit;\n").contains("cannot be named `x`"));
    }
}
