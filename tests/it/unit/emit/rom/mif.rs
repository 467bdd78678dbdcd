use brdfgen::emit::rom::RomFormat;

use super::{refused, words};

#[test]
fn mif_of_other_tools() {
    let settings = "% a\ncomment % width=8; depth=8; address_radix=uns; data_radix=dec;\ncontent\nbegin\n";
    let text = format!("{settings}[0..3] : 1 -1; -- a range\n4 : 5 6 7;7:-128;\nEND;");
    assert_eq!(words(&text, RomFormat::Mif, 8), Ok(vec![1, 255, 1, 255, 5, 6, 7, 128]));
    let content = |lines: &str| refused(&format!("{settings}{lines} END;"), RomFormat::Mif, 8);
    assert_eq!(content("[0..7]:1; 7:2;"), "a second word for the address 7");
    assert_eq!(content("[0..8]:1;"), "this word's address, 8, is out of range");
    assert_eq!(content("[0..6]:1;"), "there is no word for the address 7: the file says that it has 8 words");
    assert_eq!(content("[0..7]:-129;"), "`-129` is out of range");
    assert_eq!(refused(settings, RomFormat::Mif, 9), "the file states words of 8 bits");
    assert_eq!(refused("WIDTH=8; CONTENT BEGIN 0:1; END;", RomFormat::Mif, 8), "DEPTH is not given before CONTENT");
}

#[test]
fn xilinx_mif_is_told_by_its_digits() {
    let words = |text: &str| words(text, RomFormat::Mif, 4);
    assert_eq!(words("0001\n1010\r\n\n1111"), Ok(vec![1, 10, 15]));
    assert_eq!(words("0001\n101\n"), Err("this word has 3 binary digits".to_owned()));
    assert_eq!(words("0001\n10100\n"), Err("`10100` is too wide".to_owned()));
    assert_eq!(words("0001\n0201\n"), Err("`0201` is not a number of radix 2".to_owned()));
}
