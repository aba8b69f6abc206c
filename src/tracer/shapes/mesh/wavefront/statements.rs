//! The statements of an OBJ or MTL file: a keyword and words, one statement per line.

use std::borrow::Cow;
use std::path::Path;

use skycube_files::read_plain_file;

use crate::error::Result;

/// A name in a file and the line where it stands first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mention {
    pub name: String,
    pub line: usize,
}

/// The text of a file, with every statement on one line.
pub(super) fn read_text(path: &Path, expected: &str) -> Result<String> {
    let text = decode(read_plain_file(path, expected)?);
    Ok(if text.contains('\\') { with_joined_lines(&text) } else { text })
}

/// UTF-8, UTF-16, or the bytes of old files as Latin-1, so that names that differ stay different.
fn decode(bytes: Vec<u8>) -> String {
    if let Some(rest) = bytes.strip_prefix(b"\xEF\xBB\xBF") {
        return decode(rest.to_vec());
    }
    let wide = |unit: fn([u8; 2]) -> u16, bytes: &[u8]| {
        let units: Vec<u16> = bytes.as_chunks().0.iter().map(|&pair| unit(pair)).collect();
        String::from_utf16_lossy(&units).trim_start_matches('\u{feff}').to_owned()
    };
    // The first character of a text is ASCII, so one of its two bytes is zero.
    match bytes.as_slice() {
        [0xFF, 0xFE, ..] | [1..=u8::MAX, 0, 1..=u8::MAX, 0, ..] => wide(u16::from_le_bytes, &bytes),
        [0xFE, 0xFF, ..] | [0, 1..=u8::MAX, 0, 1..=u8::MAX, ..] => wide(u16::from_be_bytes, &bytes),
        _ => String::from_utf8(bytes)
            .unwrap_or_else(|error| error.as_bytes().iter().map(|&byte| char::from(byte)).collect()),
    }
}

/// A line that ends in a backslash goes on in the next one; the line breaks follow, so that later lines keep their numbers.
/// A comment ends with its line: paths in it end in backslashes, too.
fn with_joined_lines(text: &str) -> String {
    let mut joined = String::with_capacity(text.len());
    let mut owed = 0;
    for line in lines(text) {
        let line = line.trim_ascii_end();
        match line.strip_suffix('\\').filter(|line| owed > 0 || !line.trim_ascii_start().starts_with('#')) {
            Some(part) => {
                joined.extend([part, " "]);
                owed += 1;
            }
            None => {
                joined.push_str(line);
                (0..=std::mem::take(&mut owed)).for_each(|_| joined.push('\n'));
            }
        }
    }
    joined
}

/// The lines of a text, whether they end in LF, CR and LF, or CR alone.
fn lines(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let bytes = rest.as_bytes();
        let end = bytes.iter().position(|&byte| byte == b'\n' || byte == b'\r').unwrap_or(bytes.len());
        let next = if bytes[end..].starts_with(b"\r\n") { end + 2 } else { (end + 1).min(bytes.len()) };
        let line = &rest[..end];
        rest = &rest[next..];
        Some(line)
    })
}

/// The lines that say something: number from 1, keyword, the rest.
pub(super) fn statements(text: &str) -> impl Iterator<Item = (usize, &str, &str)> {
    lines(text).enumerate().filter_map(|(index, line)| {
        let line = line.trim_ascii();
        let end = line.bytes().position(|byte| byte.is_ascii_whitespace()).unwrap_or(line.len());
        let (keyword, rest) = line.split_at(end);
        (!keyword.is_empty() && !keyword.starts_with('#')).then(|| (index + 1, keyword, rest.trim_ascii_start()))
    })
}

/// The words of a statement up to a comment.
pub(super) fn words(rest: &str) -> impl Iterator<Item = &str> {
    rest.split_ascii_whitespace().take_while(|word| !word.starts_with('#'))
}

/// A name without the comment behind it. Names may hold blanks and `#`; where both readings are possible, the whole is tried
/// first.
pub(super) fn without_comment(name: &str) -> &str {
    name.find(" #").or_else(|| name.find("\t#")).map_or(name, |end| name[..end].trim_ascii_end())
}

/// A number, and whether it had to be read with goodwill: `1.0.` is 1.
pub(super) fn number(word: &str) -> Option<(f64, bool)> {
    let trimmed = || word.trim_end_matches(['.', ',', ';']).parse().ok();
    word.parse().ok().map(|number| (number, false)).or_else(|| trimmed().map(|number| (number, true)))
}

/// A text for an error or remark: of bounded length.
pub(super) fn shortened(text: &str) -> Cow<'_, str> {
    const MOST: usize = 80;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => Cow::Owned(format!("{}...", &text[..end])),
        None => Cow::Borrowed(text),
    }
}

/// Names as a list: the first few, and how many more there are.
pub(super) fn listed<Name: AsRef<str>>(names: &[Name]) -> String {
    const MOST: usize = 8;
    let shown: Vec<_> = names.iter().take(MOST).map(|name| shortened(name.as_ref())).collect();
    match names.len().saturating_sub(MOST) {
        0 => shown.join(", "),
        more => format!("{} and {more} more", shown.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbered(bytes: &[u8]) -> Vec<(usize, String)> {
        let text = with_joined_lines(&decode(bytes.to_vec()));
        statements(&text).map(|(line, keyword, rest)| (line, format!("{keyword}|{rest}"))).collect()
    }

    #[test]
    fn lines_end_in_every_way_and_keep_their_numbers() {
        let expected = [(1, "v|1 2 3".to_owned()), (3, "f|1 2 3".to_owned())];
        for end in ["\n", "\r\n", "\r"] {
            assert_eq!(numbered(format!("v 1 2 3{end}# comment{end} f\t1 2 3").as_bytes()), expected, "{end:?}");
        }
        let expected = [(1, "f|1 2  3 4"), (3, "g|a")].map(|(line, text)| (line, text.to_owned()));
        assert_eq!(numbered(b"f 1 2 \\\n3 4\ng a\n# C:\\\\"), expected);
        assert_eq!(numbered(b"# C:\\models\\\r\ng a"), [(2, "g|a".to_owned())]);
    }

    #[test]
    fn encodings_are_found_from_the_content() {
        let text = "v 1 2 3\nusemtl h\u{fc}gel";
        let wide = |order: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(order).collect::<Vec<u8>>();
        let expected = numbered(text.as_bytes());
        let files = [
            [b"\xEF\xBB\xBF", text.as_bytes()].concat(),
            [b"\xFF\xFE".as_slice(), &wide(u16::to_le_bytes)].concat(),
            [b"\xFE\xFF".as_slice(), &wide(u16::to_be_bytes)].concat(),
            wide(u16::to_le_bytes),
            wide(u16::to_be_bytes),
            text.chars().map(|letter| letter as u8).collect(),
        ];
        for file in files {
            assert_eq!(numbered(&file), expected);
        }
    }

    #[test]
    fn numbers_with_a_dot_too_many_are_read() {
        assert_eq!([number("1.0"), number("-.5e1")], [Some((1.0, false)), Some((-5.0, false))]);
        assert_eq!([number("1.0."), number("2,")], [Some((1.0, true)), Some((2.0, true))]);
        assert_eq!([number("0,5"), number("1.#IND"), number("."), number("x")], [None; 4]);
    }
}
