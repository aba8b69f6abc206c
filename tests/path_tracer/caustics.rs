//! Light by known ways through glass and mirrors: searched for and by chance, it is the same on average.

use glam::DVec3;
use skycube::scene::{Caustics, Plan, Scene};

use crate::support::{along, assert_agrees, mean_of_pictures, scene};

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

#[test]
fn the_probability_of_a_way_counts_in_the_weights() {
    // The lamp lies in the floor and lights it only by way of the pane above, which reflects a little:
    //
    //     ------ pane ------
    //        /        \
    //   ---x---------=====---      x: where the floor is looked at
    let mut scene = scene(
        "materials.floor = { kind = \"lambert\", colour = 0.6 }\nmaterials.lamp = { kind = \"light\", radiance = 8 }\n\
         materials.glass = { kind = \"glass\" }\n\
         shapes = [{ kind = \"rectangle\", size = [9, 9], material = \"floor\" },\n\
                   { kind = \"rectangle\", centre = [2, 0, 1e-6], size = [3, 3], material = \"lamp\" },\n\
                   { kind = \"rectangle\", centre = [0, 0, 1], normal = [0, 0, -1], size = [9, 9], material = \"glass\" }]\n",
    );
    scene.integrator.depth = 2;
    let shown = along(&scene, DVec3::new(0.01, 0.0, 0.5), DVec3::new(-0.01, 0.0, -0.5), 1_600_000);
    // Over the lamp's image at the height 2: reflectance times both cosines over the square of the distance.
    let steps = 300;
    let place = |start: f64, step: u32| start + 3.0 * (f64::from(step) + 0.5) / f64::from(steps);
    let mut sum = 0.0;
    for (column, row) in (0..steps).flat_map(|column| (0..steps).map(move |row| (column, row))) {
        let (x, y) = (place(0.5, column), place(-1.5, row));
        let square = 4.0 + x * x + y * y;
        let cosine = 2.0 / square.sqrt();
        sum += reflectance(cosine) * cosine * cosine / square;
    }
    let area = 9.0 / f64::from(steps * steps);
    let expected = 0.6 / std::f64::consts::PI * 8.0 * sum * area;
    assert!(shown.1 < 2e-3 * expected, "{shown:?}: too much noise to tell");
    assert_agrees(shown, expected, "light by way of the pane");
}

#[test]
fn rays_to_a_caustic_go_to_the_image_of_the_lamp_and_hardly_beside_it() {
    // A small lamp and its image in a plane mirror; a black screen keeps its direct light away:
    //
    //     lamp *
    //         --- screen
    //                     mirror |         * image
    //     ----------------x------|
    let scene = scene(
        "integrator = { kind = \"path\", depth = 2 }\n\
         materials.floor = { kind = \"lambert\", colour = 0.6 }\nmaterials.lamp = { kind = \"light\", radiance = 400 }\n\
         materials.mirror = { kind = \"mirror\" }\nmaterials.black = { kind = \"lambert\", colour = 0 }\n\
         shapes = [{ kind = \"plane\", material = \"floor\" },\n\
                   { kind = \"sphere\", centre = [-2, 0, 3], radius = 0.1, material = \"lamp\" },\n\
                   { kind = \"rectangle\", centre = [2, 0, 1], normal = [-1, 0, 0], size = [2, 2], material = \"mirror\" },\n\
                   { kind = \"rectangle\", centre = [-1.61, 0, 2.55], size = [0.5, 0.5], material = \"black\" }]\n",
    );
    let samples = 20_000;
    let (mean, error) = along(&scene, DVec3::new(0.6, -2.0, 2.0), DVec3::new(0.0, 2.0, -2.0), samples);
    // The image lies at (6, 0, 3): irradiance pi L r^2 / d^2 cos, of a sphere above the horizon.
    let square = 5.4 * 5.4 + 9.0_f64;
    let expected = 0.6 * 400.0 * 0.01 / square * 3.0 / square.sqrt();
    assert_agrees((mean, error), expected, "light by way of the mirror");
    // In units of the image's radius, one photon draws with the density 1 / (pi (1 + s)^2), s the squared distance from the
    // place of the image where its own light came from. Over two independent places of the disc E[s] = 1, E[s^2] = 5/3,
    // so E[(1 + s)^2] = 14/3 is the mean square of a sample; several photons do better.
    let square = 1.0 + f64::from(samples) * (error / mean).powi(2);
    assert!(square < 14.0 / 3.0, "{square}");
}

/// Fresnel's reflectance of glass of index 1.5, by the cosine of the angle of incidence.
fn reflectance(cosine: f64) -> f64 {
    let transmitted = (1.0 - (1.0 - cosine * cosine) / 2.25).sqrt();
    let parallel = (1.5 * cosine - transmitted) / (1.5 * cosine + transmitted);
    let perpendicular = (cosine - 1.5 * transmitted) / (cosine + 1.5 * transmitted);
    (parallel * parallel + perpendicular * perpendicular) / 2.0
}
