//! Pages: templates and text in them.

use html_escape::encode_text;

/// A text as it stands in a page: nothing in it is a tag, and control characters, which names of files may hold, are replaced.
pub(super) fn text(text: &str) -> String {
    encode_text(&harmless(text)).into_owned()
}

/// A text without control characters.
pub(super) fn harmless(text: &str) -> String {
    text.replace(|letter: char| letter.is_control() && letter != '\n', "\u{fffd}")
}

/// The template with its parts; what the parts contain is not looked at again.
pub(super) fn filled(template: &str, parts: &[(&str, String)]) -> String {
    let mut page = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once("{{") {
        let (name, after) = after.split_once("}}").expect("the template closes what it opens");
        let (_, part) = parts.iter().find(|(known, _)| *known == name).expect("the template names a part");
        page.push_str(before);
        page.push_str(part);
        rest = after;
    }
    page + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_not_looked_at_again_and_text_is_no_tag() {
        let parts = [("a", "{{b}}".to_owned()), ("b", text("<b>\u{1b}[2J"))];
        assert_eq!(filled("{{a}} {{b}} {{a}}", &parts), "{{b}} &lt;b&gt;\u{fffd}[2J {{b}}");
    }
}
