//! A tree of photons, for the few photons near a point.

use super::photon::Photon;
use crate::math::{Bounds, DVec3};

/// The most photons of one box.
pub(super) const HANDFUL: usize = 8;

/// By how many times its longest side a box is widened.
const MARGIN: f64 = 2.0;

/// Of forecasts that hold nowhere else.
const LARGEST_DRIFT: f64 = 1e6;

/// A tree of boxes over the photons, halved along the longest side until few are left in each (Bentley,
/// Multidimensional Binary Search Trees, 1975).
#[derive(Debug)]
pub(super) struct PhotonTree {
    photons: Vec<Photon>,
    nodes: Vec<Node>,
}

#[derive(Debug)]
enum Node {
    /// Places below `place` on the axis are in the next node, the others in `above`.
    Split { axis: usize, place: f64, above: u32 },
    /// Photons `first..last`, and the box around them, widened.
    Leaf { first: u32, last: u32, bounds: Bounds },
}

impl PhotonTree {
    pub fn new(mut photons: Vec<Photon>) -> Self {
        let mut nodes = Vec::new();
        let count = photons.len();
        if count > 0 {
            split(&mut photons, 0, &mut nodes);
        }
        Self { photons, nodes }
    }

    /// The same photons, each with what its neighbours tell of its forecast.
    pub fn with_drift(mut self) -> Self {
        for node in &self.nodes {
            if let Node::Leaf { first, last, .. } = node {
                learn_drift(&mut self.photons[*first as usize..*last as usize]);
            }
        }
        self
    }

    /// The photons around a place; empty where there are none.
    #[inline]
    pub fn near(&self, point: DVec3) -> &[Photon] {
        let mut index = 0;
        while let Some(node) = self.nodes.get(index) {
            match node {
                Node::Split { axis, place, above } => {
                    index = if point[*axis] < *place { index + 1 } else { *above as usize };
                }
                Node::Leaf { first, last, bounds } => {
                    let inside = point.cmpge(bounds.minimum).all() && point.cmple(bounds.maximum).all();
                    return if inside { &self.photons[*first as usize..*last as usize] } else { &[] };
                }
            }
        }
        &[]
    }
}

/// Adds the nodes of photons whose first one has number `first`.
fn split(photons: &mut [Photon], first: u32, nodes: &mut Vec<Node>) {
    let bounds = Bounds::around(photons.iter().map(|photon| photon.position));
    let extent = bounds.extent();
    if photons.len() <= HANDFUL {
        // Around few photons the light does not end at the last one.
        let margin = DVec3::splat(MARGIN * extent.max_element() + 1e-9);
        let bounds = Bounds { minimum: bounds.minimum - margin, maximum: bounds.maximum + margin };
        nodes.push(Node::Leaf { first, last: first + photons.len() as u32, bounds });
        return;
    }
    let axis = (0..3).max_by(|&a, &b| extent[a].total_cmp(&extent[b])).unwrap_or(0);
    let middle = photons.len() / 2;
    photons.select_nth_unstable_by(middle, |a, b| a.position[axis].total_cmp(&b.position[axis]));
    let place = photons[middle].position[axis];
    let node = nodes.len();
    nodes.push(Node::Split { axis, place, above: 0 });
    let (below, above) = photons.split_at_mut(middle);
    split(below, first, nodes);
    let start = nodes.len() as u32;
    if let Node::Split { above, .. } = &mut nodes[node] {
        *above = start;
    }
    split(above, first + middle as u32, nodes);
}

/// Learns from neighbours how soon a photon's forecast goes wrong: by the middle one of their misses. The nearest miss alone
/// trusts forecasts too far, and what they miss then is found by chance only.
fn learn_drift(photons: &mut [Photon]) {
    let known = photons.to_vec();
    for (index, photon) in photons.iter_mut().enumerate() {
        let straight = Photon { drift: 0.0, ..*photon };
        let misses = known.iter().enumerate().filter(|(other, _)| *other != index).filter_map(|(_, other)| {
            let squared = (other.position - photon.position).length_squared();
            let miss =
                straight.miss(&straight.forecast(other.position), other.towards) - photon.half[0].max(photon.half[1]);
            (squared > 0.0).then(|| miss.max(0.0) / squared)
        });
        let mut misses: Vec<f64> = misses.collect();
        misses.sort_by(f64::total_cmp);
        photon.drift = match known.len() {
            1 => 0.0,
            _ => misses.get(misses.len() / 2).map_or(LARGEST_DRIFT, |drift| drift.min(LARGEST_DRIFT)),
        };
    }
}
