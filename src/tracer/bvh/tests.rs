//! The shape of the tree, and that both builders give one that finds everything.

use super::binary::{BinaryNode, BinaryTree};
use super::hierarchy::DEPTH_LIMIT;
use super::node::WIDTH;
use super::{FloatBox, Hierarchy, LEAF_CAPACITY, Visit};
use crate::math::{Bounds, DVec3, Vec3};

/// Boxes of side 1/2 around the points of a grid.
fn grid(side: usize) -> Vec<FloatBox> {
    let point =
        |index: usize| Vec3::new((index % side) as f32, (index / side % side) as f32, (index / side / side) as f32);
    let cell = |index| FloatBox { minimum: point(index) - 0.25, maximum: point(index) + 0.25 };
    (0..side.pow(3)).map(cell).collect()
}

/// Every box is in one leaf, and no leaf holds too many.
fn check_leaves(hierarchy: &Hierarchy, count: usize) {
    let leaves = 0..hierarchy.leaf_count() as u32;
    assert!(leaves.clone().all(|leaf| (1..=LEAF_CAPACITY).contains(&hierarchy.leaf(leaf).len())));
    let mut members: Vec<u32> = leaves.flat_map(|leaf| hierarchy.leaf(leaf).to_vec()).collect();
    members.sort_unstable();
    assert!(members.into_iter().eq(0..count as u32));
}

/// The boxes in the leaves that a ray visits.
fn visited(hierarchy: &Hierarchy, origin: DVec3, direction: DVec3, t_max: f64) -> Vec<u32> {
    let Some(ray) = hierarchy.ray(origin, direction) else { return vec![] };
    let mut found = Vec::new();
    hierarchy.traverse(
        &ray,
        t_max,
        |_| {},
        |leaf| {
            found.extend_from_slice(hierarchy.leaf(leaf));
            Visit::Continue
        },
    );
    found
}

#[test]
fn holds_every_box_once_whatever_their_number() {
    for count in [0, 1, 2, 3, 4, 5, 9, 1000] {
        let boxes = &grid(10)[..count];
        check_leaves(&Hierarchy::build(boxes), count);
        check_leaves(&Hierarchy::merged(BinaryTree::balanced(boxes)).unwrap(), count);
    }
}

#[test]
fn visits_all_boxes_that_a_ray_touches_even_in_the_plane_of_their_sides() {
    let boxes = grid(6);
    for hierarchy in [Hierarchy::build(&boxes), Hierarchy::merged(BinaryTree::balanced(&boxes)).unwrap()] {
        for (y, z) in [(2.0, 3.0), (2.25, 3.0), (1.75, 2.75), (0.25, -0.25)] {
            let found = visited(&hierarchy, DVec3::new(-1e7, y, z), DVec3::X * 3.0, f64::INFINITY);
            let touches = |b: &FloatBox| {
                (f64::from(b.minimum.y)..=f64::from(b.maximum.y)).contains(&y)
                    && (f64::from(b.minimum.z)..=f64::from(b.maximum.z)).contains(&z)
            };
            let expected = (0..boxes.len()).filter(|&number| touches(&boxes[number]));
            assert!(expected.clone().count() >= 6);
            expected.for_each(|number| assert!(found.contains(&(number as u32)), "{number} at {y} {z}"));
        }
    }
}

#[test]
fn stops_at_the_limit() {
    let hierarchy = Hierarchy::build(&grid(8));
    assert!(visited(&hierarchy, DVec3::splat(-10.0), DVec3::ONE, 1.0).is_empty());
    let first = visited(&hierarchy, DVec3::new(-3.0, 0.0, 0.0), DVec3::X, 2.9);
    assert!(first.contains(&0) && first.len() < 64, "{first:?}");
}

#[test]
fn leaves_come_from_near_to_far() {
    let row = |count: usize| -> Vec<FloatBox> {
        let cell = |x: f32| FloatBox { minimum: Vec3::new(x, -0.25, -0.25), maximum: Vec3::new(x + 0.5, 0.25, 0.25) };
        (0..count).map(|x| cell(x as f32)).collect()
    };
    for count in [2, 7, 30, 100, 1000] {
        let hierarchy = Hierarchy::build(&row(count));
        for (origin, direction) in [(-1.0, DVec3::X), (2000.0, DVec3::NEG_X)] {
            let ray = hierarchy.ray(DVec3::new(origin, 0.0, 0.0), direction).unwrap();
            let mut found = Vec::new();
            hierarchy.traverse(
                &ray,
                f64::INFINITY,
                |_| {},
                |leaf| {
                    found.push(hierarchy.leaf(leaf).iter().min().copied().unwrap());
                    Visit::Continue
                },
            );
            assert_eq!(found.len(), hierarchy.leaf_count());
            assert!(found.is_sorted() || found.iter().rev().is_sorted(), "{found:?}");
            assert_eq!(found[0] == 0, origin < 0.0);
        }
    }
}

/// Sum of the areas of the wide nodes of a hierarchy, without the root.
fn area_of_nodes(hierarchy: &Hierarchy) -> f64 {
    let bounds = |index: usize, slot: usize| {
        let plane = |axis: usize| hierarchy.nodes[index].planes[axis][slot / 4][slot % 4];
        let corner = |first: usize| Vec3::new(plane(first), plane(first + 1), plane(first + 2));
        FloatBox { minimum: corner(0), maximum: corner(3) }
    };
    let slots = (0..hierarchy.nodes.len()).flat_map(|index| (0..WIDTH).map(move |slot| (index, slot)));
    let inner = slots.filter(|&(index, slot)| {
        bounds(index, slot) != FloatBox::EMPTY && hierarchy.nodes[index].children[slot].leaf_number().is_none()
    });
    inner.map(|(index, slot)| bounds(index, slot).half_area()).sum()
}

/// The least sum of areas of wide nodes below a binary node that is one itself, by trying all choices.
fn least_area(tree: &BinaryTree, binary: usize) -> f64 {
    fn least(tree: &BinaryTree, mut open: Vec<usize>, kept: usize) -> f64 {
        let Some(binary) = open.pop() else { return 0.0 };
        let BinaryNode::Inner { left, right } = tree.nodes[binary].1 else { return least(tree, open, kept + 1) };
        let whole = tree.nodes[binary].0.half_area() + least_area(tree, binary) + least(tree, open.clone(), kept + 1);
        open.extend([left, right]);
        if open.len() + kept > WIDTH { whole } else { whole.min(least(tree, open, kept)) }
    }
    match tree.nodes[binary].1 {
        BinaryNode::Leaf { .. } => 0.0,
        BinaryNode::Inner { left, right } => least(tree, vec![left, right], 0),
    }
}

#[test]
fn wide_nodes_are_the_best_that_the_binary_tree_allows() {
    for count in [40, 50, 64] {
        // Boxes of all sizes, so that the areas of subtrees are not all alike.
        let sized = |(number, b): (usize, FloatBox)| FloatBox {
            maximum: b.maximum + Vec3::new((number * 7 % 11) as f32, (number * 5 % 13) as f32, (number % 3) as f32),
            ..b
        };
        let boxes: Vec<FloatBox> = grid(4).into_iter().take(count).enumerate().map(sized).collect();
        let tree = BinaryTree::balanced(&boxes);
        let least = least_area(&tree, 0);
        let found = area_of_nodes(&Hierarchy::merged(tree).unwrap());
        assert!(least > 0.0 && (found - least).abs() < 1e-3 * least, "{count} boxes: {found}, not {least}");
    }
}

#[test]
fn many_boxes_in_one_place_do_not_make_a_deep_tree() {
    let boxes = vec![FloatBox { minimum: Vec3::ZERO, maximum: Vec3::ONE }; 20_000];
    check_leaves(&Hierarchy::build(&boxes), boxes.len());
    // Each box half the size of the last: the worst case for clustering.
    let nested: Vec<FloatBox> =
        (0..120).map(|k| FloatBox { minimum: Vec3::ZERO, maximum: Vec3::splat(0.5_f32.powi(k)) }).collect();
    check_leaves(&Hierarchy::build(&nested), nested.len());
    assert!(BinaryTree::balanced(&boxes).depth() <= DEPTH_LIMIT);
}

#[test]
fn is_the_same_whenever_it_is_built() {
    let (first, second) = (Hierarchy::build(&grid(12)), Hierarchy::build(&grid(12)));
    assert_eq!(format!("{first:?}"), format!("{second:?}"));
}

#[test]
fn boxes_round_outwards() {
    let bounds = Bounds { minimum: DVec3::splat(0.1), maximum: DVec3::splat(0.7) };
    let rounded = FloatBox::containing(&bounds).to_bounds();
    assert!(rounded.minimum.cmple(bounds.minimum).all() && rounded.maximum.cmpge(bounds.maximum).all());
    assert!((rounded.extent() - bounds.extent()).abs().max_element() < 1e-6);
}
