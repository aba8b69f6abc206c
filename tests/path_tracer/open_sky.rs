//! The sky over flat surfaces, of which only what is hidden is found by rays.

use glam::{DVec3, Vec3};
use skycube::integrators::{Integrator, RayCounts};
use skycube::math::Ray;
use skycube::picture::{Raster, WriteOptions, write};
use skycube::sampling::{PixelSampler, SamplerKind, Sampling};
use skycube::scene::{Plan, Scene, Strategy};

use crate::support::{assert_agrees, mean_of_pictures, rendering, scene};

const GRADIENT: &str =
    "environment = { kind = \"gradient\", zenith = [0.3, 0.5, 0.9], horizon = [1, 0.9, 0.8], nadir = 0.2 }\n";

/// The radiance of independent samples along a ray down to a point of the floor.
fn samples_at(scene: &Scene, point: DVec3, count: u32) -> Vec<Vec3> {
    let plan = Plan::new(scene);
    let integrator = Integrator::new(scene, &plan).unwrap();
    let ray = Ray::new(point + DVec3::new(0.002, 0.001, 0.005), DVec3::new(-0.002, -0.001, -0.005).normalize());
    let media = integrator.media_around(ray.origin);
    let sampling = Sampling { sampler: SamplerKind::Independent, ..Sampling::default() };
    let sample = |index| {
        let sampler = PixelSampler::chosen(sampling, 1, 2, index);
        integrator.radiance(&ray, &media, sampler, &mut RayCounts::default())
    };
    (0..count).map(sample).collect()
}

fn mean_and_error(samples: &[Vec3]) -> (f64, f64) {
    let count = samples.len() as f64;
    let values = || samples.iter().map(|radiance| f64::from(radiance.element_sum()) / 3.0);
    let mean = values().sum::<f64>() / count;
    let variance = values().map(|value| (value - mean) * (value - mean)).sum::<f64>() / count;
    (mean, (variance / count).sqrt())
}

#[test]
fn a_floor_under_nothing_has_no_noise() {
    let scene = scene(&format!(
        "{GRADIENT}materials.floor = {{ kind = \"lambert\", colour = 0.5 }}\n\
         shapes = [{{ kind = \"rectangle\", size = [4, 4], material = \"floor\" }}]\n"
    ));
    // The cosine times h + (z - h) cosine over the hemisphere: pi h + 2/3 pi (z - h).
    let (horizon, zenith) = (Vec3::new(1.0, 0.9, 0.8), Vec3::new(0.3, 0.5, 0.9));
    let expected = 0.5 * (horizon + (zenith - horizon) * (2.0 / 3.0));
    for radiance in samples_at(&scene, DVec3::ZERO, 64) {
        assert!((radiance - expected).abs().max_element() < 1e-5, "{radiance} {expected}");
    }
}

#[test]
fn a_black_ball_takes_the_share_of_the_sky_that_it_fills() {
    // A ball of radius r at the distance d, in the direction of the cosine c, fills the share c (r / d)^2.
    let (height, radius): (f64, f64) = (1.5, 0.8);
    let mut scene = scene(&format!(
        "environment = {{ kind = \"constant\", radiance = 1 }}\nmaterials.floor = {{ kind = \"lambert\", colour = 0.5 }}\n\
         materials.black = {{ kind = \"lambert\", colour = 0 }}\n\
         shapes = [{{ kind = \"plane\", material = \"floor\" }},\n\
                   {{ kind = \"sphere\", centre = [0, 0, {height}], radius = {radius}, material = \"black\" }}]\n"
    ));
    // Rays to a small share of the sky are not left out at random.
    scene.integrator.weight_cutoff = 0.0;
    for distance in [0.0, 0.5, 1.0, 3.0, 20.0] {
        let shown = mean_and_error(&samples_at(&scene, DVec3::new(distance, 0.0, 0.0), 20_000));
        let square = height * height + distance * distance;
        let share = height / square.sqrt() * radius * radius / square;
        assert_agrees(shown, 0.5 * (1.0 - share), &format!("at {distance}"));
        // Most of what noise there is comes from the cosine within the cone.
        assert!(shown.1 * 20_000.0_f64.sqrt() < share, "at {distance}: {shown:?}, share {share}");
    }
}

/// Shapes above a floor: balls that touch it, sink into it, hide each other, boxes that stand around a place, glass, a
/// second floor in the air, which is seen from both sides.
const SCENES: [(&str, &str); 11] = [
    ("a ball on the floor", "{ kind = \"sphere\", centre = [0, 0, 0.5], radius = 0.5, material = \"mirror\" }"),
    ("a ball sunk into the floor", "{ kind = \"sphere\", centre = [0, 0, -0.3], radius = 0.7, material = \"dull\" }"),
    (
        "balls that hide each other",
        "{ kind = \"sphere\", centre = [0, 0, 0.5], radius = 0.5, material = \"dull\" },\n\
         { kind = \"sphere\", centre = [0.3, 1.2, 0.7], radius = 0.7, material = \"mirror\" }",
    ),
    ("a box", "{ kind = \"box\", minimum = [-0.5, -0.5, 0], maximum = [0.5, 0.5, 1], material = \"dull\" }"),
    ("glass", "{ kind = \"sphere\", centre = [0, 0, 0.6], radius = 0.5, material = \"glass\" }"),
    (
        "a floor in the air",
        "{ kind = \"rectangle\", centre = [0, 0, 1], size = [1.5, 1.5], material = \"dull\" },\n\
         { kind = \"sphere\", centre = [0, 0, 1.6], radius = 0.4, material = \"dull\" }",
    ),
    (
        "shapes that cast no shadows of lights",
        "{ kind = \"sphere\", centre = [0, 0, 0.6], radius = 0.5, material = \"dull\", casts_shadow = false }",
    ),
    (
        "a tilted disc",
        "{ kind = \"disc\", centre = [0, 0, 0.7], normal = [1, 0.5, 1], radius = 0.8, material = \"dull\" }",
    ),
    (
        "a tilted ellipsoid",
        "{ kind = \"sphere\", scale = [1.2, 0.2, 0.4], rotate = [0, 40, 0], translate = [0, 0, 1], \
         material = \"dull\" }",
    ),
    (
        "glass without an inside",
        "{ kind = \"rectangle\", centre = [0, 0, 0.7], size = [1.5, 1.5], material = \"glass\" },\n\
         { kind = \"rectangle\", centre = [1, 1, 0.5], normal = [0, 0, -1], size = [1, 1], material = \"glass\" }",
    ),
    ("a ball under the floor", "{ kind = \"sphere\", centre = [0, 0, -2], radius = 0.5, material = \"dull\" }"),
];

fn over_a_floor(shapes: &str, camera: &str) -> Scene {
    scene(&format!(
        "{GRADIENT}camera = {{ position = {camera}, target = [0, 0, 0.4], size = [24, 16], samples = 64 }}\n\
         materials.floor = {{ kind = \"lambert\", colour = {{ checker = [0.9, 0.3] }} }}\n\
         materials.dull = {{ kind = \"lambert\", colour = [0.8, 0.5, 0.3] }}\nmaterials.mirror = {{ kind = \"mirror\" }}\n\
         materials.glass = {{ kind = \"glass\", absorption = [0.5, 0.1, 0] }}\n\
         shapes = [{{ kind = \"rectangle\", size = [6, 6], material = \"floor\" }},\n{shapes}]\n"
    ))
}

#[test]
fn pictures_are_the_same_on_average_with_and_without_it() {
    for (name, shapes) in SCENES {
        // From below, too: the floor has a back.
        for camera in ["[1, -4, 2]", "[1, -4, -2]"] {
            let mut scene = over_a_floor(shapes, camera);
            assert!(Plan::new(&scene).open_sky);
            let (mean, error) = mean_of_pictures(&mut scene, 8);
            scene.integrator.strategy = Strategy::Bsdf;
            assert!(!Plan::new(&scene).open_sky);
            let (expected, other) = mean_of_pictures(&mut scene, 8);
            let bound = 4.0 * error.hypot(other) + 1e-5;
            assert!((mean - expected).abs() < bound, "{name} from {camera}: {mean} and {expected}, {bound}");
            assert!(error < other.max(1e-4), "{name} from {camera}: {error} is no less noise than {other}");
        }
    }
}

#[test]
fn a_floor_under_glass_takes_its_light_through_the_glass() {
    // From below, within the glass that the surface of the water bounds: a ray meets the surface from inside.
    let surface = "{ kind = \"rectangle\", centre = [0, 0, 1], size = [1, 1], material = \"glass\" }";
    for (depth, camera) in [(1, "[0, -1, 0.8]"), (2, "[0, -1, 0.8]"), (64, "[0, -1, 0.8]"), (64, "[0.2, -0.3, 3]")] {
        let mut scene = over_a_floor(surface, camera);
        scene.integrator.depth = depth;
        let (mean, error) = mean_of_pictures(&mut scene, 8);
        scene.integrator.strategy = Strategy::Bsdf;
        let (expected, other) = mean_of_pictures(&mut scene, 8);
        let bound = 4.0 * error.hypot(other) + 1e-5;
        assert!((mean - expected).abs() < bound, "depth {depth}, {camera}: {mean} and {expected}");
    }
}

#[test]
fn a_picture_with_a_texel_that_is_no_number_harms_its_own_pixels_alone() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("texels.exr");
    let mut raster = Raster::filled(4, 4, Vec3::splat(0.5));
    raster.pixels_mut()[5] = Vec3::new(f32::INFINITY, 0.5, 0.5);
    raster.pixels_mut()[10] = Vec3::NAN;
    write(&raster, &file, &WriteOptions::default()).unwrap();
    let scene = scene(&format!(
        "{GRADIENT}camera = {{ position = [0, -0.01, 4], target = [0, 0, 0], size = [16, 16], samples = 2 }}\n\
         materials.floor = {{ kind = \"lambert\", colour = {{ image = \"{}\" }} }}\n\
         shapes = [{{ kind = \"rectangle\", size = [2, 2], material = \"floor\" }}]\n",
        file.display()
    ));
    let raster = rendering(&scene).raster;
    let finite = raster.pixels().iter().filter(|pixel| pixel.is_finite()).count();
    assert!((128..256).contains(&finite), "{finite}");
}

#[test]
fn it_is_left_out_where_it_cannot_serve() {
    let ball = "{ kind = \"sphere\", centre = [0, 0, 0.5], radius = 0.5, material = \"mirror\" }";
    let many = [ball; Plan::MOST_OBSTACLES + 1].join(",\n");
    assert!(!Plan::new(&over_a_floor(&many, "[1, -4, 2]")).open_sky, "too many shapes");
    let plane = "{ kind = \"plane\", normal = [1, 0, 0], material = \"mirror\" }";
    let planes = format!("{plane}, {plane}");
    assert!(!Plan::new(&over_a_floor(&planes, "[1, -4, 2]")).open_sky, "planes have no end");
    let told = |scene: &Scene| {
        let plan = Plan::new(scene);
        Integrator::new(scene, &plan).unwrap().left_out().iter().any(|item| item.contains("open sky"))
    };
    let mut scene = over_a_floor(ball, "[1, -4, 2]");
    assert!(told(&scene));
    scene.integrator.strategy = Strategy::Mis;
    assert!(!told(&scene));
}
