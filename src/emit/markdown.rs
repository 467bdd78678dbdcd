//! Text of the user in Markdown: names stand as they were given, whatever they hold.

/// Text that stands in a line, or in a cell of a table: nothing in it is markup or HTML, and it stays one line of one
/// cell.
#[must_use]
pub fn text(text: &str) -> String {
    let characters: Vec<char> = text.chars().collect();
    let mut escaped = String::with_capacity(text.len());
    for (place, &c) in characters.iter().enumerate() {
        let word =
            |place: Option<usize>| place.and_then(|place| characters.get(place)).is_some_and(|c| c.is_alphanumeric());
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            // Inside a word it is no emphasis.
            '_' if word(place.checked_sub(1)) && word(Some(place + 1)) => escaped.push(c),
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '|' | '~' | '$' => escaped.extend(['\\', c]),
            // At the start of a line they begin headings, lists and rules.
            '#' | '+' | '-' | '=' | '!' if place == 0 => escaped.extend(['\\', c]),
            '.' | ')'
                if place > 0
                    && characters[..place].iter().all(char::is_ascii_digit)
                    && characters.get(place + 1).is_none_or(|next| next.is_whitespace()) =>
            {
                escaped.extend(['\\', c]);
            }
            c if c.is_control() => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}

/// Text as code in a line; not for a table, which a `|` in it would divide.
#[must_use]
pub fn code(text: &str) -> String {
    let plain: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let runs = plain.split(|c| c != '`').map(str::len);
    // As many as enclose it: one more than stand together inside.
    let longest = runs.max().unwrap_or(0);
    let fence = "`".repeat(longest + 1);
    let room = if plain.starts_with('`') || plain.ends_with('`') { " " } else { "" };
    format!("{fence}{room}{plain}{room}{fence}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_names() {
        for plain in ["red plastic", "red_plastic", "steel-2", "n = 1.5", "a (b)", "Material #25", "1..=8"] {
            assert_eq!(text(plain), plain);
        }
        assert_eq!(text("<b>&\"m|x"), "&lt;b&gt;&amp;\"m\\|x");
        assert_eq!(text("_a_ *b* `c` [d](e) \\"), "\\_a\\_ \\*b\\* \\`c\\` \\[d\\](e) \\\\");
        assert_eq!(text("a\nb\r| c |"), "a b \\| c \\|");
        assert_eq!(text("# a"), "\\# a");
        assert_eq!(text("1. a"), "1\\. a");
        assert_eq!(text("12)"), "12\\)");
        assert_eq!(code("a b"), "`a b`");
        assert_eq!(code("a `b` c"), "``a `b` c``");
        assert_eq!(code("``a"), "``` ``a ```");
    }
}
