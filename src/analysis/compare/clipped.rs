//! Highlights that are cut off.

use super::tone::Tone;
use super::undoing::Aligned;

/// The share of the pixels that are cut off at white in mine where the expected picture goes on.
pub(super) fn share(aligned: &Aligned, tone: &Tone) -> f64 {
    // What a file's white became when the tone was undone. A cut leaves nothing above it.
    let white = tone.undone(crate::math::Vec3::ONE).x;
    let brightest = aligned.mine.pixels().iter().fold(0.0, |most: f32, pixel| most.max(pixel.max_element()));
    if brightest > 1.01 * white {
        return 0.0;
    }
    let cut = aligned.mine.pixels().iter().zip(aligned.expected.pixels()).filter(|(mine, expected)| {
        (0..3).any(|channel| mine[channel] >= 0.98 * white && expected[channel] > 1.06 * white)
    });
    cut.count() as f64 / aligned.mine.pixels().len().max(1) as f64
}
