//! What the readers share: the text with its places, its lines and tokens, and the words collected by address.

use std::collections::BTreeMap;

use num_bigint::BigUint;

use super::{MAX_DEPTH, RomImage};
use crate::platform::error::Error;
use crate::platform::input;

/// A place in the text: its byte offset and its length.
pub(super) type Span = (usize, usize);

/// The text of a file.
pub(super) struct Source<'a> {
    /// The file's name, for messages.
    pub file: &'a str,
    /// The file's bytes.
    pub bytes: &'a [u8],
    /// The text as [`input::plain`] has it; bytes that are not UTF-8 are replaced, as they do no harm in a comment.
    pub text: String,
    /// What the format allows, for messages.
    pub allowed: &'static str,
    /// The width of the words of this ROM.
    pub word_bits: u32,
}

/// The comments of a format.
pub(super) struct Comments {
    /// Begins a comment that ends with the line.
    pub line: Option<&'static str>,
    /// A character of meaning behind which the rest of the line is a comment.
    pub behind: Option<char>,
    /// The two ends of a comment that may span lines.
    pub block: Option<(&'static str, &'static str)>,
}

impl Comments {
    /// A line's comment and one that may span lines.
    pub const fn of(line: &'static str, block: (&'static str, &'static str)) -> Self {
        Self { line: Some(line), behind: None, block: Some(block) }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    /// Letters, digits and underscores.
    Word,
    /// What stands between double quotes.
    Quoted,
    /// Any other character.
    Symbol,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Token<'s> {
    pub kind: Kind,
    pub text: &'s str,
    pub span: Span,
}

impl Token<'_> {
    pub fn is_symbol(&self, symbol: &str) -> bool {
        self.kind == Kind::Symbol && self.text == symbol
    }

    pub fn is_word(&self, word: &str) -> bool {
        self.kind == Kind::Word && self.text.eq_ignore_ascii_case(word)
    }

    pub fn end(&self) -> usize {
        self.span.0 + self.span.1
    }
}

/// A text in a message: long ones are cut and control characters are escaped.
pub(super) fn shown(text: &str) -> String {
    const LONGEST: usize = 40;
    let mut shown: String = text.chars().take(LONGEST).flat_map(char::escape_debug).collect();
    if text.chars().nth(LONGEST).is_some() {
        shown.push_str("...");
    }
    format!("`{shown}`")
}

/// The non-empty lines of a text without what follows one of the comments' beginnings, with their places.
pub(super) fn lines<'s>(text: &'s str, comments: &'static [&'static str]) -> impl Iterator<Item = (&'s str, Span)> {
    let offset = |part: &str| part.as_ptr() as usize - text.as_ptr() as usize;
    let bare = move |line: &'s str| {
        let end = comments.iter().filter_map(|comment| line.find(*comment)).min().unwrap_or(line.len());
        line[..end].trim()
    };
    text.lines().map(bare).filter(|line| !line.is_empty()).map(move |line| (line, (offset(line), line.len())))
}

impl<'a> Source<'a> {
    pub fn new(bytes: &'a [u8], file: &'a str, allowed: &'static str, word_bits: u32) -> Self {
        let text = input::plain(&String::from_utf8_lossy(bytes)).into_owned();
        Self { file, bytes, text, allowed, word_bits }
    }

    /// An error at a place, with what is allowed there.
    pub fn error(&self, what: impl Into<String>, allowed: impl Into<String>, span: Span) -> Error {
        Error::text(what, allowed, self.file, &self.text, span)
    }

    /// An error at a place, with what the format allows.
    pub fn wrong(&self, what: impl Into<String>, span: Span) -> Error {
        self.error(what, self.allowed, span)
    }

    /// An error at the end of the text.
    pub fn cut_off(&self, what: impl Into<String>) -> Error {
        self.wrong(what, (self.text.len(), 0))
    }

    /// Reads digits (underscores between them are skipped) as a word of this ROM.
    pub fn word(&self, digits: &str, radix: u32, span: Span) -> Result<BigUint, Error> {
        self.number(digits, radix, self.word_bits, span)
    }

    /// Reads digits (underscores between them are skipped) as a number of at most `bits` bits.
    pub fn number(&self, digits: &str, radix: u32, bits: u32, span: Span) -> Result<BigUint, Error> {
        let digits: Vec<u8> = digits.bytes().filter(|&c| c != b'_').collect();
        if digits.is_empty() || !digits.iter().all(|&c| char::from(c).is_digit(radix)) {
            let what = format!("{} is not a number of radix {radix}", shown(&self.text[span.0..span.0 + span.1]));
            return Err(self.wrong(what, span));
        }
        let leading_zeros = digits.iter().take_while(|&&c| c == b'0').count();
        let significant = &digits[leading_zeros..];
        // A digit after the zeros is at least one bit: an absurdly long number is not worth reading.
        let number = (significant.len() <= bits as usize)
            .then(|| BigUint::parse_bytes(significant, radix).unwrap_or_default())
            .filter(|number| number.bits() <= u64::from(bits));
        number.ok_or_else(|| {
            let what = format!("{} is too wide", shown(&self.text[span.0..span.0 + span.1]));
            self.error(what, format!("a number of at most {bits} bits belongs here"), span)
        })
    }

    /// The error that something has not the width of this ROM's words.
    pub fn wrong_width(&self, what: impl Into<String>, span: Span) -> Error {
        self.error(what, format!("the words of this ROM have {} bits", self.word_bits), span)
    }

    /// Refuses a width that the file states and that is not this ROM's.
    pub fn check_width(&self, stated: usize, span: Span) -> Result<(), Error> {
        if stated == self.word_bits as usize {
            return Ok(());
        }
        Err(self.wrong_width(format!("the file states words of {stated} bits"), span))
    }

    /// Refuses a word that is wider than this ROM's.
    pub fn refuse_wide(&self, word: &BigUint, span: Span) -> Result<(), Error> {
        if word.bits() <= u64::from(self.word_bits) {
            return Ok(());
        }
        Err(self.wrong_width(format!("the word 0x{word:x} is too wide"), span))
    }

    /// Reads an address.
    pub fn address(&self, digits: &str, radix: u32, span: Span) -> Result<usize, Error> {
        let address = self.number(digits, radix, 64, span)?;
        usize::try_from(address).ok().filter(|&address| address < MAX_DEPTH).ok_or_else(|| {
            let what = format!("the address {} is out of range", shown(digits));
            self.error(what, format!("a ROM has at most {MAX_DEPTH} words"), span)
        })
    }

    /// Splits the text into tokens.
    pub fn tokens(&self, comments: &Comments) -> Result<Cursor<'_>, Error> {
        let text = self.text.as_str();
        let mut tokens: Vec<Token<'_>> = Vec::new();
        let mut at = 0;
        while let Some(c) = text[at..].chars().next() {
            let rest = &text[at..];
            if c.is_whitespace() {
                at += c.len_utf8();
                continue;
            }
            if comments.line.is_some_and(|line| rest.starts_with(line)) {
                at += rest.find('\n').unwrap_or(rest.len());
                continue;
            }
            if let Some((open, close)) = comments.block
                && rest.starts_with(open)
            {
                let Some(length) = rest[open.len()..].find(close) else {
                    let what = format!("the file ends within the comment that begins here with {open}");
                    return Err(self.error(what, format!("a comment ends with {close}"), (at, open.len())));
                };
                at += open.len() + length + close.len();
                continue;
            }
            // A grammar with comments behind a character has no quoted text.
            let token = if c == '"' && comments.behind.is_none() {
                let Some(length) = rest[1..].find('"') else {
                    let what = "the file ends within the literal that begins here";
                    return Err(self.error(what, "a literal ends with a double quote", (at, 1)));
                };
                Token { kind: Kind::Quoted, text: &rest[1..=length], span: (at, length + 2) }
            } else {
                let is_word = |c: char| c == '_' || c.is_ascii_alphanumeric();
                let length = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
                let (kind, length) = if length > 0 { (Kind::Word, length) } else { (Kind::Symbol, c.len_utf8()) };
                Token { kind, text: &rest[..length], span: (at, length) }
            };
            at = token.end();
            if comments.behind == Some(c) {
                at += text[at..].find('\n').unwrap_or(text.len() - at);
            }
            tokens.push(token);
        }
        Ok(Cursor { source: self, tokens, next: 0 })
    }
}

/// A walk over the tokens of a text.
pub(super) struct Cursor<'s> {
    source: &'s Source<'s>,
    pub tokens: Vec<Token<'s>>,
    /// The position of the next token.
    pub next: usize,
}

impl<'s> Cursor<'s> {
    /// The token `ahead` of the next one.
    pub fn peek(&self, ahead: usize) -> Option<Token<'s>> {
        self.tokens.get(self.next + ahead).copied()
    }

    /// Takes the next token if it is the given symbol.
    pub fn take_symbol(&mut self, symbol: &str) -> bool {
        let is_it = self.peek(0).is_some_and(|token| token.is_symbol(symbol));
        self.next += usize::from(is_it);
        is_it
    }

    pub fn expect_symbol(&mut self, symbol: &str) -> Result<(), Error> {
        if self.take_symbol(symbol) { Ok(()) } else { Err(self.unexpected(&format!("`{symbol}`"))) }
    }

    /// Takes the next token, which must be a word; `what` names it.
    pub fn expect_word(&mut self, what: &str) -> Result<Token<'s>, Error> {
        match self.peek(0) {
            Some(token) if token.kind == Kind::Word => {
                self.next += 1;
                Ok(token)
            }
            _ => Err(self.unexpected(what)),
        }
    }

    /// The place of the tokens from the given position up to the last one taken.
    pub fn span_from(&self, begin: usize) -> Span {
        let start = self.tokens[begin].span.0;
        (start, self.tokens[self.next - 1].end() - start)
    }

    /// Nothing may follow.
    pub fn expect_end(&self) -> Result<(), Error> {
        if self.peek(0).is_none() { Ok(()) } else { Err(self.unexpected("the end of the file")) }
    }

    /// The error that the next token, or the end of the file, is not `what` belongs there.
    pub fn unexpected(&self, what: &str) -> Error {
        match self.peek(0) {
            Some(token) => {
                let found = format!("{} stands where {what} is expected", shown(token.text));
                self.source.wrong(found, token.span)
            }
            None => self.source.cut_off(format!("the file ends where {what} is expected")),
        }
    }
}

/// An image of words alone.
pub(super) fn image(words: Vec<BigUint>) -> RomImage {
    RomImage { words, kind: None, width: None, codes: Vec::new() }
}

/// The words of a file, collected in any order.
pub(super) struct Words<'s> {
    source: &'s Source<'s>,
    words: BTreeMap<usize, (BigUint, Span)>,
    /// Of each word that was read from digits, and where the last one stands.
    digit_counts: Vec<usize>,
    last: Span,
}

impl<'s> Words<'s> {
    pub fn new(source: &'s Source<'s>) -> Self {
        Self { source, words: BTreeMap::new(), digit_counts: Vec::new(), last: (0, 0) }
    }

    /// Whether there is none yet.
    pub fn is_empty(&self) -> bool {
        self.words.is_empty()
    }

    /// Reads digits as the next word of the file.
    pub fn read(&mut self, digits: &str, radix: u32, span: Span) -> Result<BigUint, Error> {
        self.digit_counts.push(digits.len());
        self.last = span;
        self.source.word(digits, radix, span)
    }

    /// Puts a word at an address, which must be free and less than `depth`.
    pub fn place(&mut self, address: usize, word: BigUint, span: Span, depth: usize) -> Result<(), Error> {
        if address >= depth {
            let what = format!("this word's address, {address}, is out of range");
            return Err(self.source.error(
                what,
                format!("the addresses here are 0 to {}", depth.saturating_sub(1)),
                span,
            ));
        }
        if self.words.insert(address, (word, span)).is_some() {
            let what = format!("a second word for the address {address}");
            return Err(self.source.error(what, "each address has one word", span));
        }
        Ok(())
    }

    /// Refuses a last word that the end of the file seems to cut: with nothing behind it, not even a line feed,
    /// it has fewer digits than all the others have.
    fn refuse_cut_word(&self) -> Result<(), Error> {
        let [first, between @ .., cut] = &*self.digit_counts else {
            return Ok(());
        };
        let is_last_text = self.last.0 + self.last.1 == self.source.text.len();
        if is_last_text && cut < first && between.iter().all(|count| count == first) {
            let what = format!("the file ends within a word: it has fewer than the {first} digits of the others");
            return Err(self.source.error(
                what,
                "a line feed after the last word, or words of equal length",
                self.last,
            ));
        }
        Ok(())
    }

    /// The words by address up to `depth`, which they all are below; those that are not there are 0.
    pub fn filled(self, depth: usize) -> Result<Vec<BigUint>, Error> {
        self.refuse_cut_word()?;
        let mut filled = vec![BigUint::ZERO; depth];
        for (address, (word, _)) in self.words {
            filled[address] = word;
        }
        Ok(filled)
    }

    /// All words by address; every address up to the last one, or up to `depth`, must have one.
    pub fn finish(self, depth: Option<usize>) -> Result<Vec<BigUint>, Error> {
        const ALLOWED: &str = "every address has a word, from 0 to the last";
        self.refuse_cut_word()?;
        for (expected, (&address, &(_, span))) in self.words.iter().enumerate() {
            if address != expected {
                let what = format!("there is no word for the address {expected}; the next one is for {address}");
                return Err(self.source.error(what, ALLOWED, span));
            }
        }
        let found = self.words.len();
        match depth {
            Some(depth) if found < depth => Err(self.source.error(
                format!("there is no word for the address {found}: the file says that it has {depth} words"),
                ALLOWED,
                (self.source.text.len(), 0),
            )),
            None if found == 0 => Err(self.source.cut_off("the file has no words")),
            _ => Ok(self.words.into_values().map(|(word, _)| word).collect()),
        }
    }
}
