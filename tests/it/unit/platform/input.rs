use brdfgen::platform::error::Error;
use brdfgen::platform::input::*;

#[test]
fn a_byte_order_mark_and_line_ends_are_no_content() {
    for text in ["a\nb\n", "\u{feff}a\nb\n", "a\r\nb\r\n", "a\rb\r", "\u{feff}a\r\nb\r"] {
        assert_eq!(plain(text), "a\nb\n", "{text:?}");
    }
    // Only in front.
    assert_eq!(plain("a\u{feff}"), "a\u{feff}");
}

#[test]
fn wide_text_is_named() {
    let encode = |text: &str, little: bool| -> Vec<u8> {
        text.encode_utf16().flat_map(|unit| if little { unit.to_le_bytes() } else { unit.to_be_bytes() }).collect()
    };
    for little in [true, false] {
        for text in ["\u{feff}method", "method = 1"] {
            let error = refuse_wide_text(&encode(text, little), "a.toml").unwrap_err().to_string();
            assert_eq!(error, "a.toml is UTF-16 text");
        }
    }
    let error = refuse_wide_text(&[0xff, 0xfe, 0, 0, b'a', 0, 0, 0], "a.toml").unwrap_err().to_string();
    assert_eq!(error, "a.toml is UTF-32 text");
    for bytes in ["".as_bytes(), b"a", b"method = 1", "\u{feff}ä = 1".as_bytes(), &[0; 16]] {
        assert!(refuse_wide_text(bytes, "a").is_ok(), "{bytes:?}");
    }
}

#[test]
fn other_separators_are_named() {
    for (text, name) in
        [("a;b\n0,5;1\n", "semicolons"), ("\na\tb\n", "tabs"), ("sep=;\na;b\n", "semicolons"), ("a|b", "bars")]
    {
        let error = check_separator(text, "t.csv").unwrap_err().to_string();
        assert_eq!(error, format!("columns are separated by commas and this has {name}"));
    }
    for text in ["", "\n", "a", "a,b\n1;2\n", "a,b,\"c;d\"\n"] {
        assert!(check_separator(text, "t.csv").is_ok(), "{text:?}");
    }
}

#[test]
fn toml_numbers_are_finite() {
    for (text, shown) in [
        ("a = inf", "inf"),
        ("b = 1\na = [1.0, -nan]", "-nan"),
        ("[t]\n[[t.u]]\nx = { y = [[+inf]] }", "+inf"),
        ("a = 1e999", "1e999"),
        ("a = -1_0.0e9_99", "-1_0.0e9_99"),
    ] {
        match check_toml_numbers(text, "t.toml").unwrap_err() {
            Error::Text { what, at, .. } => {
                assert_eq!(what, format!("{shown} is no number that can be used"));
                assert_eq!(&text[at.offset()..at.offset() + at.len()], shown);
            }
            other => panic!("{other}"),
        }
    }
    for text in ["a = 1e308\nb = 'inf'\nc = 1\nd = [0.0, 1_0.5e-999]", "not toml", ""] {
        assert!(check_toml_numbers(text, "t.toml").is_ok(), "{text}");
    }
}
