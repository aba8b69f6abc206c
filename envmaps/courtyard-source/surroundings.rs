//! What lies around the yard: the land and its trees.

use skycube::math::{Vec2, Vec3};

use crate::ground::{build_land, land_height};
use crate::model::Model;
use crate::noise::Random;
use crate::plants::{Tree, build_tree};

pub fn surroundings() -> Model {
    let mut model = Model::default();
    let mut random = Random::new(3);
    build_land(&mut model);
    let near = [
        (-11.0, 1.2, 9.0),
        (-12.5, -6.5, 8.0),
        (5.6, -14.0, 8.5),
        (10.5, 7.8, 9.5),
        (-1.0, 14.0, 8.0),
        (4.6, 16.0, 10.0),
        (-10.0, -13.5, 7.0),
        (2.8, -19.0, 9.0),
        (-16.0, 6.0, 10.0),
    ];
    for (number, (x, z, height)) in near.into_iter().enumerate() {
        let foot = Vec3::new(x, -0.1, z);
        let tree = Tree { foot, height, levels: 5, leaf: 0.12, leaves: 15, tint: 3 * number };
        build_tree(&mut model, &tree, &mut random);
    }
    let mut planted = 0;
    while planted < 90 {
        let place = 160.0 * Vec2::new(random.range(-1.0, 1.0), random.range(-1.0, 1.0));
        if place.length() > 26.0 {
            let foot = Vec3::new(place.x, land_height(place) - 0.2, place.y);
            let height = random.range(5.0, 10.0);
            let tree = Tree { foot, height, levels: 3, leaf: 0.42, leaves: 26, tint: random.index(8) };
            build_tree(&mut model, &tree, &mut random);
            planted += 1;
        }
    }
    model
}
