//! A page that shows pairs of pictures in any browser, with yours over the expected one behind a slider. One file, nothing from
//! the network.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::super::html::{filled, text};
use super::pairs::{FolderReport, PairReport};

const PAGE: &str = include_str!("page.html");

impl FolderReport<'_> {
    /// The page. Pairs that are as they should be are listed; the others are shown first.
    pub fn page(&self, mine: &str, expected: &str) -> String {
        let (right, wrong): (Vec<&PairReport>, Vec<&PairReport>) =
            self.0.iter().partition(|pair| pair.verdict.is_right());
        let pairs: String = wrong.into_iter().chain(right).map(section).collect();
        let parts =
            [("mine", text(mine)), ("expected", text(expected)), ("summary", text(&self.summary())), ("pairs", pairs)];
        filled(PAGE, &parts)
    }
}

fn section(pair: &PairReport) -> String {
    let sentences: String =
        pair.sentences.iter().map(|sentence| format!("      <li>{}</li>\n", text(sentence))).collect();
    let (class, name) = (pair.verdict.name(), text(&pair.name));
    format!(
        "  <section class=\"{class}\">\n    <h2>{name} <span>{class}</span></h2>\n    <ul>\n{sentences}    </ul>\n{}  </section>\n",
        pictures(pair)
    )
}

/// Yours over the expected picture with the slider, and the difference beside them.
fn pictures(pair: &PairReport) -> String {
    let Some(pictures) = &pair.pictures else { return String::new() };
    let [mine, expected, difference] =
        pictures.each_ref().map(|bytes| format!("data:image/png;base64,{}", STANDARD.encode(bytes)));
    format!(
        "    <div class=\"row\">\n      <div class=\"slider\">\n        <img src=\"{expected}\" alt=\"expected\">\n        \
         <img src=\"{mine}\" alt=\"yours\">\n        <input type=\"range\" value=\"50\" aria-label=\"yours on the left, expected \
         on the right\">\n      </div>\n      <img src=\"{difference}\" alt=\"the difference\">\n    </div>\n"
    )
}
