use brdfgen::emit::rom::RomFormat;

use super::{refused, words};

#[test]
fn coe_of_other_tools() {
    let text = "; a comment\nMemory_Initialization_Radix = 2 ;\n;another\nmemory_initialization_vector = 01 10,\n; \
     inside\n11\n;\n";
    assert_eq!(words(text, RomFormat::Coe, 8), Ok(vec![1, 2, 3]));
    let vector = "memory_initialization_radix=10;\nmemory_initialization_vector=1,2";
    assert_eq!(words(&format!("{vector}55;"), RomFormat::Coe, 8), Ok(vec![1, 255]));
    assert_eq!(refused(&format!("{vector}56;"), RomFormat::Coe, 8), "`256` is too wide");
    assert_eq!(refused(vector, RomFormat::Coe, 8), "the file ends where `,` or `;` is expected");
    assert_eq!(refused(&vector.replace("10", "7"), RomFormat::Coe, 8), "the radix `7` is not allowed");
}

/// By AMD UG896: text behind a semicolon is a comment, keywords are in any case, and those behind the vector are
/// not read.
#[test]
fn coe_as_its_manual_has_it() {
    let words = |text: &str| words(text, RomFormat::Coe, 8);
    for text in [
        "MEMORY_INITIALIZATION_RADIX = 8 ; octal; = \"words, (\nMEMORY_INITIALIZATION_VECTOR = 1, 17, 377; the end, 5",
        "memory_initialization_radix=16; hex\nmemory_initialization_vector=\n1,\nf,\nff;\nPATTERN = 5, \
         6;\nany=thing \"",
        "; = \nRadix = 10 ; all of it\n\n; more\nMemory_initialization_vector = 1 15\n; a line\n255; \
         memory_initialization_vector=7;",
        "memory_initialization_radix=2;\r\nmemory_initialization_vector=\r\n1\r\n1111\r\n11111111\r\n;\r\n",
    ] {
        assert_eq!(words(text), Ok(vec![1, 15, 255]), "{text}");
    }
    let vector = "memory_initialization_radix=16;\nmemory_initialization_vector=";
    assert_eq!(
        words(&format!("{vector}1;\n2;\n")),
        Err("`2` stands where a keyword with `=` or the end of the file is expected".to_owned())
    );
    assert_eq!(
        words("memory_initialization_vector=1;\nmemory_initialization_radix=16;"),
        Err("memory_initialization_radix must stand before the words".to_owned())
    );
    assert_eq!(
        words("radix=10;\ncoefdata=1,2;"),
        Err("`coefdata` is for filters and other cores, and this is a memory".to_owned())
    );
    assert_eq!(
        words("; only\n"),
        Err("the file ends where memory_initialization_radix or memory_initialization_vector is expected".to_owned())
    );
}
