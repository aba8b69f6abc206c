//! The whole experiment on one scene.

use super::curve::Curve;
use super::protocol::Protocol;
use super::reference::{self, Reference, ReferenceFacts};
use super::variation::Variant;
use super::watch::Watch;
use crate::error::{Error, Result};
use crate::scene::Scene;

/// The result for one scene.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Convergence {
    /// By the numbers that curves hold.
    pub references: Vec<ReferenceFacts>,
    /// One of every variant that was begun, with the steps that were finished.
    pub curves: Vec<Curve>,
    /// True if it was stopped before all was measured.
    #[serde(skip)]
    pub stopped: bool,
}

/// Measures all variants of a scene. Asked to stop, gives the finished steps; an error if there are none.
///
/// The scene is changed on the way and left with the settings of the last variant.
pub fn converge(
    scene: &mut Scene,
    variants: &[Variant],
    protocol: &Protocol,
    watch: &impl Watch,
) -> Result<Convergence> {
    let (aims, numbers) = reference::aims(variants);
    let mut references = Vec::new();
    for (index, aim) in aims.iter().enumerate() {
        let what = if aims.len() > 1 { format!("reference {}", index + 1) } else { "reference".to_owned() };
        references.push(Reference::obtain(scene, *aim, protocol, watch, &what)?);
    }
    let mut curves = Vec::new();
    for (variant, &number) in variants.iter().zip(&numbers) {
        if watch.cancelled() {
            break;
        }
        variant.configuration.apply(scene);
        let curve = Curve::measure(scene, variant, number, &references[number], protocol, watch)?;
        if !curve.steps.is_empty() {
            curves.push(curve);
        }
    }
    if curves.is_empty() {
        return Err(Error::new("stopped before the first step was finished: nothing was written"));
    }
    let references = references.into_iter().map(|reference| reference.facts).collect();
    Ok(Convergence { references, curves, stopped: watch.cancelled() })
}
