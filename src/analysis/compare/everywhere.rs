//! Differences all over the picture.

use serde::Serialize;

use super::finding::{Finding, Kind};
use super::subject::Left;

/// What is left is all over the picture, and nothing else explains it.
#[derive(Serialize)]
struct Everywhere {}

impl Kind for Everywhere {
    const NAME: &'static str = "everywhere";

    fn sentence(&self) -> String {
        "The content is the same, but it differs in many places, and no flip, shift, gamma or exposure explains the \
         difference."
            .to_owned()
    }
}

pub(super) fn found(_: &Left) -> Option<Finding> {
    Some(Everywhere {}.into())
}
