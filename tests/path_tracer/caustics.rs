//! Light by known ways through glass and mirrors: searched for and by chance, it is the same on average.

use skycube::scene::{Caustics, Plan, Scene};

use crate::support::{mean_of_pictures, scene};

/// A floor in the light of a lamp, large enough that chance finds it, too; what is between them differs.
fn lit_through(shapes: &str) -> Scene {
    scene(&format!(
        "camera = {{ position = [0, -4, 2.5], target = [0, 0, 0.2], size = [16, 12], samples = 256 }}\n\
         materials.floor = {{ kind = \"lambert\", colour = 0.6 }}\nmaterials.lamp = {{ kind = \"light\", radiance = 8 }}\n\
         materials.glass = {{ kind = \"glass\" }}\nmaterials.same = {{ kind = \"glass\", index = 1 }}\n\
         materials.dense = {{ kind = \"glass\", index = 2.4, absorption = [0.4, 0.1, 0] }}\n\
         materials.mirror = {{ kind = \"mirror\", colour = [0.9, 0.5, 0.0] }}\n\
         materials.gold = {{ kind = \"metal\", metal = \"gold\", roughness = 0 }}\n\
         shapes = [\n{{ kind = \"plane\", material = \"floor\" }},\n\
         {{ kind = \"sphere\", centre = [1.5, 1, 3.5], radius = 0.9, material = \"lamp\" }},\n{shapes}]\n"
    ))
}

/// What light meets on its way, with each what could go wrong.
const BETWEEN: [(&str, &str); 7] = [
    ("a ball of glass", "{ kind = \"sphere\", centre = [0, 0, 0.8], radius = 0.7, material = \"glass\" }"),
    (
        "a prism that reflects totally",
        "{ kind = \"box\", minimum = [-0.6, -0.6, 0.2], maximum = [0.6, 0.6, 1.2], rotate = [0, 45, 0], material = \"dense\" }",
    ),
    ("glass that does not refract", "{ kind = \"sphere\", centre = [0, 0, 0.8], radius = 0.7, material = \"same\" }"),
    ("a mirror of a colour", "{ kind = \"sphere\", centre = [-0.8, 0, 0.7], radius = 0.7, material = \"mirror\" }"),
    (
        "smooth metal",
        "{ kind = \"rectangle\", centre = [-1, 0, 0.8], normal = [1, 0, 0.2], size = [2, 1.5], material = \"gold\" }",
    ),
    (
        "glass in glass",
        "{ kind = \"sphere\", centre = [0, 0, 0.9], radius = 0.8, material = \"glass\" },\n\
         { kind = \"sphere\", centre = [0, 0, 0.9], radius = 0.4, material = \"dense\" }",
    ),
    (
        "a mirror and glass",
        "{ kind = \"sphere\", centre = [-0.9, 0, 0.7], radius = 0.6, material = \"mirror\" },\n\
         { kind = \"sphere\", centre = [0.6, 0.2, 0.7], radius = 0.6, material = \"glass\" }",
    ),
];

#[test]
fn light_that_is_searched_for_is_as_much_as_chance_finds() {
    for (name, shapes) in BETWEEN {
        let mut scene = lit_through(shapes);
        assert!(Plan::new(&scene).caustics, "{name}");
        let (mean, error) = mean_of_pictures(&mut scene, 8);
        scene.integrator.caustics = Caustics::Off;
        let (expected, other) = mean_of_pictures(&mut scene, 8);
        let bound = 4.0 * error.hypot(other);
        assert!((mean - expected).abs() < bound, "{name}: {mean} and {expected} differ by more than {bound}");
        assert!(bound < 0.025 * expected, "{name}: {bound} of {expected} is too much noise to tell");
    }
}
