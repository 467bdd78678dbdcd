//! Names of cores: identifiers of both languages and names of files.

use crate::platform::error::Error;

/// Words that cannot name a module, entity or file scope: the reserved words of Verilog-2005, SystemVerilog-2017 (as
/// which most tools read Verilog), Verilog-AMS, VHDL-2008 with PSL and VHDL-AMS, and names that the generated text
/// itself uses.
const RESERVED: &str = include_str!("data/reserved.txt");

/// Names that the text of cores, wrappers and benches uses for something else; whatever else it does is told apart
/// where it is written.
const USED: &str = include_str!("data/used.txt");

/// Names that Windows keeps for devices, whatever follows them behind a dot; `com` and `lpt` with a digit are others.
const DEVICES: [&str; 4] = ["aux", "con", "nul", "prn"];

/// The most letters of a name: the longest names of files, such as those of a memory's, stay far below the 255 bytes of
/// file systems.
const NAME_LETTERS: usize = 64;

/// Whether a name is an identifier of both languages that files can be named by.
fn is_name(name: &str) -> bool {
    let numbered = name.strip_prefix("com").or(name.strip_prefix("lpt"));
    let is_device =
        DEVICES.contains(&name) || numbered.is_some_and(|rest| rest.len() == 1 && rest.as_bytes()[0].is_ascii_digit());
    name.len() <= NAME_LETTERS
        && name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
        && !name.ends_with('_')
        && !name.contains("__")
        && !is_device
        && [RESERVED, USED].iter().all(|words| words.split_ascii_whitespace().all(|word| word != name))
}

/// A name that is allowed, as near to this one as may be.
fn allowed_name(name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let mapped: String = name.chars().map(plain).collect();
    let parts: Vec<&str> = mapped.split('_').filter(|part| !part.is_empty()).collect();
    let joined = parts.join("_");
    let joined = if joined.starts_with(|c: char| c.is_ascii_lowercase()) { joined } else { format!("lobe_{joined}") };
    let cut = |name: &str, letters: usize| name[..letters.min(name.len())].trim_end_matches('_').to_owned();
    let whole = cut(&joined, NAME_LETTERS);
    if is_name(&whole) { whole } else { cut(&joined, NAME_LETTERS - 5) + "_core" }
}

/// Refuses a name that is not an identifier of both languages, or that no file can have everywhere.
pub(crate) fn check_name(name: &str) -> Result<(), Error> {
    if is_name(name) {
        return Ok(());
    }
    Err(Error::input(
        format!("the name `{name}` is not allowed"),
        format!(
            "`{}` would be: a name is an identifier of both languages and of files, up to {NAME_LETTERS} lower-case \
             letters, digits and single underscores, a letter first, no underscore last, no reserved word, no port, no \
             device of Windows",
            allowed_name(name)
        ),
    ))
}
