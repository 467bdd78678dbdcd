use brdfgen::emit::rom::RomFormat;

use super::{refused, words};

#[test]
fn c_of_other_tools() {
    let text = "#pragma once\nunsigned t[] = { 0x1F, 31u, 0b11, 017L };";
    assert_eq!(words(text, RomFormat::C, 8), Ok(vec![31, 31, 3, 15]));
    assert_eq!(words("int t[N][2]={{1,0,},{0xFFFFFFFF,0}};", RomFormat::C, 40), Ok(vec![1, u32::MAX]));
    assert_eq!(refused("int t[]={{1,1}};", RomFormat::C, 32), "the word 0x100000001 is too wide");
    assert_eq!(
        refused("int t[3]={1,2};", RomFormat::C, 8),
        "there is no word for the address 2: the file says that it has 3 words"
    );
    assert_eq!(refused("int t[1]={1,2};", RomFormat::C, 8), "this word's address, 1, is out of range");
}
