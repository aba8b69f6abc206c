//! What happened to the files: an order in which they are named or stored, and a few faults on top of it.
//!
//! Seams leave many repairs that close equally well. The fix is the one with the shortest story: files exchanged are
//! cheaper than files edited, a turned file is cheaper than a flipped one, and one cause for all six files is one
//! order.

use std::fmt;

use super::search::arrangement::Arrangement;
use super::search::convention::{Convention, Order};
use super::thresholds::story::{
    DIAGONAL, EXCHANGE, EXCHANGE_OF_FREE_NAMES, EXCHANGE_OF_OPPOSITES, FLIP, MOST_FAULTS, TURN,
};
use crate::envmap::{Face, Orientation};

/// An order, and the faults on top of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Story {
    /// The naming order that the files follow; `None` for the order of the lookup.
    pub order: Option<Convention>,
    /// Files in each other's place, by the names they have: two, or a ring in which each takes the picture of the next.
    pub exchanged: Vec<Vec<Face>>,
    /// Faces whose file is turned or flipped.
    pub edited: Vec<Face>,
    pub(crate) cost: u32,
}

impl Story {
    /// The shortest story that ends in this arrangement.
    pub fn of(arrangement: &Arrangement, orders: &[Order], free_names: bool) -> Self {
        let order = orders.iter().min_by_key(|order| cost_on(order, arrangement, free_names));
        let order = order.expect("the order of the lookup is always one of them");
        let edit = |face: &Face| edit_at(order, arrangement, *face);
        Self {
            order: order.convention,
            cost: cost_on(order, arrangement, free_names),
            edited: Face::ALL.into_iter().filter(|face| edit(face) > 0).collect(),
            exchanged: rings(&order.arrangement.images, &arrangement.images),
        }
    }

    /// How many things happened: the order if it is not that of the lookup, exchanges, and files edited.
    pub fn faults(&self) -> usize {
        let exchanges: usize = self.exchanged.iter().map(|ring| ring.len() - 1).sum();
        usize::from(self.order.is_some()) + exchanges + self.edited.len()
    }

    /// What the shortest story of an arrangement costs.
    pub fn cost_of(arrangement: &Arrangement, orders: &[Order], free_names: bool) -> u32 {
        orders.iter().map(|order| cost_on(order, arrangement, free_names)).min().unwrap_or(0)
    }
}

/// What it costs to tell an arrangement as an order and faults on top of it.
fn cost_on(order: &Order, arrangement: &Arrangement, free_names: bool) -> u32 {
    let edits = Face::ALL.map(|face| edit_at(order, arrangement, face));
    let edited = edits.iter().filter(|&&edit| edit > 0).count();
    let has_too_many = |faults: usize| order.convention.is_some() && faults > MOST_FAULTS;
    if has_too_many(edited) {
        return u32::MAX;
    }
    let rings = rings(&order.arrangement.images, &arrangement.images);
    if has_too_many(edited + rings.len()) {
        return u32::MAX;
    }
    order.cost + rings.iter().map(|ring| exchange_cost(ring, free_names)).sum::<u32>() + edits.iter().sum::<u32>()
}

fn edit_at(order: &Order, arrangement: &Arrangement, face: Face) -> u32 {
    edit_cost(order.arrangement.orientation(face), arrangement.orientation(face))
}

/// What it costs to bring the files of a ring into their places: one exchange less than there are files.
fn exchange_cost(ring: &[Face], free_names: bool) -> u32 {
    let exchanges = ring.len() as u32 - 1;
    if free_names {
        return EXCHANGE_OF_FREE_NAMES * exchanges;
    }
    let opposites = ring.iter().filter(|one| ring.contains(&(-one.signed_axis()).face())).count() as u32 / 2;
    let easy = opposites.min(exchanges);
    EXCHANGE_OF_OPPOSITES * easy + EXCHANGE * (exchanges - easy)
}

/// What it costs to bring a file from one orientation to another.
fn edit_cost(from: Orientation, to: Orientation) -> u32 {
    let edit = to.after(from.inverse());
    let flips = edit.swaps ^ edit.inverts_u ^ edit.inverts_v;
    match (edit == Orientation::IDENTITY, flips, edit.swaps) {
        (true, ..) => 0,
        (_, false, _) => TURN,
        (_, true, false) => FLIP,
        (_, true, true) => DIAGONAL,
    }
}

/// The images that are read in other places in the second table than in the first, as rings: the face that used to read one
/// reads the next.
pub fn rings(from: &[Face; 6], to: &[Face; 6]) -> Vec<Vec<Face>> {
    let mut seen = [false; 6];
    let mut rings = Vec::new();
    for start in 0..6 {
        let mut ring = Vec::new();
        let mut face = start;
        while !seen[face] {
            seen[face] = true;
            ring.push(from[face]);
            // The face that used to read what this one reads now.
            face = from.iter().position(|&image| image == to[face]).unwrap_or(face);
        }
        if ring.len() > 1 {
            let first = (0..ring.len()).min_by_key(|&index| ring[index]).unwrap_or(0);
            ring.rotate_left(first);
            rings.push(ring);
        }
    }
    rings
}

/// The arrangements that at most [`MOST_FAULTS`] faults make of an order.
pub fn with_faults(order: &Arrangement, may_rename: bool) -> Vec<Arrangement> {
    let once = with_one_fault(order, may_rename);
    let twice: Vec<Arrangement> = once.iter().flat_map(|faulty| with_one_fault(faulty, may_rename)).collect();
    [vec![*order], once, twice].concat()
}

fn with_one_fault(order: &Arrangement, may_rename: bool) -> Vec<Arrangement> {
    let pairs = (0..6).flat_map(|one| (one + 1..6).map(move |other| (one, other))).filter(|_| may_rename);
    let exchanges = pairs.map(|(one, other)| {
        let mut exchanged = *order;
        exchanged.images.swap(one, other);
        exchanged
    });
    let edits = Face::ALL.into_iter().flat_map(|face| (0..8).map(move |orientation| (face, orientation)));
    let edits = edits.filter(|&(face, orientation)| order.orientations[face.index()] != orientation);
    exchanges.chain(edits.map(|(face, orientation)| order.with_orientation(face, orientation))).collect()
}

impl Story {
    /// What happened to all six and which files are in each other's place, as sentences.
    pub fn sentences(&self) -> Vec<String> {
        let order = self.order.iter().map(ToString::to_string);
        order.chain(self.exchanged.iter().map(|ring| exchange(ring))).collect()
    }
}

impl fmt::Display for Story {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut parts = self.sentences();
        if !self.edited.is_empty() {
            let names: Vec<&str> = self.edited.iter().map(|face| face.name()).collect();
            parts.push(format!("turn or flip {}", names.join(", ")));
        }
        if parts.is_empty() {
            parts.push("nothing to change".to_owned());
        }
        formatter.write_str(&parts.join("; "))
    }
}

/// As its sentence.
impl serde::Serialize for Story {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// What to exchange, and who mixes these two up.
fn exchange(ring: &[Face]) -> String {
    let names: Vec<&str> = ring.iter().map(|face| face.name()).collect();
    match names[..] {
        [one, other] => match exchange_reason(ring) {
            Some(why) => format!("exchange {one} and {other}: {why}"),
            None => format!("exchange {one} and {other}"),
        },
        _ => format!("exchange {} in a cycle: each takes the picture of the next", names.join(", ")),
    }
}

/// What two images are that people mix up, and who does.
pub fn exchange_reason(ring: &[Face]) -> Option<&'static str> {
    match ring {
        [Face::PosX, Face::NegX] => Some("left and right, as in sets made for Unity or Godot"),
        [Face::PosY, Face::NegY] => Some("top and bottom"),
        [Face::PosZ, Face::NegZ] => Some("front and back, as in right-handed sets"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn own() -> Order {
        Order { convention: None, arrangement: Arrangement::given(Face::ALL), cost: 0 }
    }

    fn cost(change: impl Fn(&mut Arrangement)) -> u32 {
        let mut arrangement = own().arrangement;
        change(&mut arrangement);
        Story::of(&arrangement, &[own()], false).cost
    }

    #[test]
    fn exchanging_is_cheaper_than_turning_and_turning_than_flipping() {
        let exchange = cost(|arrangement| arrangement.images.swap(0, 4));
        let turns = [3, 4, 5].map(|turn| cost(|arrangement| arrangement.orientations[2] = turn));
        let flips = [1, 2, 6, 7].map(|flip| cost(|arrangement| arrangement.orientations[2] = flip));
        assert!(turns.iter().all(|&turn| exchange < turn && flips.iter().all(|&flip| turn < flip)));
        assert_eq!(cost(|_| ()), 0);
    }

    #[test]
    fn a_ring_of_files_is_told_as_one() {
        let mut arrangement = own().arrangement;
        arrangement.images = [Face::PosZ, Face::NegX, Face::PosY, Face::NegY, Face::NegZ, Face::PosX];
        let story = Story::of(&arrangement, &[own()], false);
        assert_eq!(
            (story.exchanged, story.cost),
            (vec![vec![Face::PosX, Face::PosZ, Face::NegZ]], EXCHANGE_OF_OPPOSITES + EXCHANGE)
        );
    }

    #[test]
    fn faults_are_told_on_top_of_the_order_that_leaves_fewest() {
        let mut upside_down = own().arrangement;
        upside_down.orientations = [2; 6];
        let orders = [
            own(),
            Order { convention: Some(Convention::BottomUp), arrangement: upside_down, cost: EXCHANGE_OF_OPPOSITES },
        ];
        let story = Story::of(&upside_down.with_orientation(Face::NegY, 0), &orders, false);
        assert_eq!((story.order, story.edited), (Some(Convention::BottomUp), vec![Face::NegY]));
    }
}
