//! Highlights that are cut off.

use serde::Serialize;

use super::finding::{Finding, Kind};
use super::tone::Tone;
use super::undoing::Aligned;
use crate::digits::digits;
use crate::math::Vec3;

/// The share of the pixels whose highlights are cut off, if that is worth saying.
const NOTABLE: f64 = 0.002;

/// This share of the pixels is cut off at white where the expected picture goes on.
#[derive(Serialize)]
struct ClippedHighlights {
    #[serde(serialize_with = "digits::<4, _>")]
    share: f64,
}

impl Kind for ClippedHighlights {
    const NAME: &'static str = "clipped_highlights";

    fn sentence(&self) -> String {
        format!(
            "Highlights are cut off: {:.1} % of your pixels are white at the limit of the file where the expected picture \
             goes on. What is cut off cannot be compared.",
            100.0 * self.share
        )
    }
}

pub(super) fn found(aligned: &Aligned, tone: &Tone) -> Option<Finding> {
    let share = share(aligned, tone);
    (share >= NOTABLE).then(|| ClippedHighlights { share }.into())
}

fn share(aligned: &Aligned, tone: &Tone) -> f64 {
    // What a file's white became when the tone was undone. A cut leaves nothing above it.
    let white = tone.undone(Vec3::ONE).x;
    let brightest = aligned.mine.pixels().iter().fold(0.0, |most: f32, pixel| most.max(pixel.max_element()));
    if brightest > 1.01 * white {
        return 0.0;
    }
    let cut = aligned.mine.pixels().iter().zip(aligned.expected.pixels()).filter(|(mine, expected)| {
        (0..3).any(|channel| mine[channel] >= 0.98 * white && expected[channel] > 1.06 * white)
    });
    cut.count() as f64 / aligned.mine.pixels().len().max(1) as f64
}
