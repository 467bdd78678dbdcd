use brdfgen::emit::rom::RomFormat;

use super::{refused, words};

#[test]
fn vhdl_of_other_tools() {
    let package =
        |words: &str| format!("package p is\n constant N : positive := 2;\n constant C : t := ({words});\nend;");
    let text = package(
        "x\"0F\", -- first\n 1 => 8x\"1_1\", 3 => \"0000\" & b\"0011\", 2 => 2x\"1\" & \"0\" & UX\"1\" & o\"0\"",
    );
    let text = text.replace("o\"0\"", "\"0\"");
    assert_eq!(words(&text, RomFormat::Vhdl, 8), Ok(vec![15, 17, 0b0100_0010, 3]));
    assert_eq!(refused(&package("\"0101\""), RomFormat::Vhdl, 8), "the word has 4 bits");
    assert_eq!(refused(&package("x\"0f\" & \"1\""), RomFormat::Vhdl, 8), "the word has more than 8 bits");
    assert_eq!(refused(&package("\"0000000X\""), RomFormat::Vhdl, 8), "`0000000X` is not a number of radix 2");
    assert_eq!(
        refused("package p is end;", RomFormat::Vhdl, 8),
        "the file has no constant array, which begins with `:= (`"
    );
}
