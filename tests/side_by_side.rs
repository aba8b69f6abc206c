//! Rays that are traced side by side give the same bits as the textbook's recursion, and whatever saves work on their way
//! changes no result.

#[path = "support/scenes.rs"]
mod scenes;

use std::path::Path;
use std::sync::atomic::{AtomicU32, Ordering};

use glam::{DVec3, Vec3};
use proptest::prelude::*;
use skycube::math::{Departure, Ray, Side, SurfaceId, Transform};
use skycube::picture::Raster;
use skycube::render::{Budget, Progress, Renderer, Rendering, Silent, render, render_progressively};
use skycube::sampling::PixelFilter;
use skycube::scene::{Aggregate, IntegratorKind, Plan, Scene, Wing};
use skycube::shapes::{Geometry, MaterialChoice, Primitive};

fn scene(text: &str) -> Scene {
    Scene::from_text(text, Path::new("test.toml")).unwrap_or_else(|error| panic!("{error}"))
}

/// Renders a scene side by side and by the textbook: every bit of the picture and every count of rays is the same.
fn assert_same_as_textbook(mut scene: Scene, what: &str) {
    let plan = Plan::new(&scene);
    let mut renderer = Renderer::with_layers(&scene, &plan).unwrap();
    renderer.add_samples(scene.samples, &Silent).unwrap();
    let fast = renderer.rendering(false);
    drop(renderer);
    let plan = scenes::textbook_plan(&mut scene);
    let mut renderer = Renderer::with_layers(&scene, &plan).unwrap();
    renderer.add_samples(scene.samples, &Silent).unwrap();
    let textbook = renderer.rendering(false);
    assert_eq!((fast.wing, textbook.wing), (Wing::SideBySide, Wing::Textbook), "{what}");
    let bits =
        |raster: &Raster| raster.pixels().iter().map(|pixel| pixel.to_array().map(f32::to_bits)).collect::<Vec<_>>();
    assert_eq!(bits(&fast.raster), bits(&textbook.raster), "{what}");
    assert_eq!(fast.counts, textbook.counts, "{what}");
    assert_eq!(layers(&fast).map(bits), layers(&textbook).map(bits), "{what}");
}

#[test]
fn every_scene_of_the_lessons_is_as_in_the_textbook() {
    let traced = |scene: &Scene| matches!(scene.integrator.kind, IntegratorKind::Phong | IntegratorKind::Whitted);
    let lessons: Vec<_> = scenes::of_lessons().into_iter().filter(|(_, scene)| traced(scene)).collect();
    assert!(lessons.len() > 12, "{}", lessons.len());
    for (file, scene) in lessons {
        assert_same_as_textbook(scene, &file.display().to_string());
    }
}

#[test]
fn random_scenes_are_as_in_the_textbook() {
    for seed in 0..scenes::RANDOM_SCENES {
        assert_same_as_textbook(scenes::random_whitted(seed), &format!("scene {seed}"));
    }
}

/// Spheres, given by centre and radius, tried one by one.
fn spheres_of(spheres: &[([f64; 3], f64)]) -> Aggregate {
    let ball = |&(centre, radius): &([f64; 3], f64)| {
        let transform = Transform::from_parts(DVec3::from(centre), DVec3::ZERO, DVec3::splat(radius)).unwrap();
        Primitive::new(Geometry::Sphere, transform, MaterialChoice::Whole(0), true)
    };
    Aggregate::without_hierarchy(spheres.iter().map(ball).collect())
}

/// A number of either sign, of any magnitude from 10^-10 to 1.
fn tilt() -> impl Strategy<Value = f64> {
    (-10.0..0.0_f64, any::<bool>()).prop_map(|(exponent, up)| libm::pow(10.0, exponent) * if up { 1.0 } else { -1.0 })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    /// View cones spare tests; what is met stays the same. Rays start beside a ball or on it and leave it to either side, most
    /// of them nearly along its surface, in places where rounding puts their origins far beside it; the point that they go
    /// to and come from is near or far.
    #[test]
    fn view_cones_change_nothing(
        spheres in prop::collection::vec((prop::array::uniform3(-3.0..3.0_f64), -3.0..0.5_f64), 1..5),
        normal in prop::array::uniform3(-1.0..1.0_f64),
        aside in prop::array::uniform3(-1.0..1.0_f64),
        tilt in tilt(),
        far in -2.0..7.0_f64,
        leaving in any::<prop::sample::Index>(),
        side in prop_oneof![Just(None), Just(Some(Side::Front)), Just(Some(Side::Back))],
        offset in prop_oneof![Just(0.0), 3.0..9.0_f64],
    ) {
        let offset = DVec3::new(1.0, -0.7, 0.4) * if offset > 0.0 { libm::pow(10.0, offset) } else { 0.0 };
        let placed = |&(centre, size): &([f64; 3], f64)| {
            ((offset + DVec3::from(centre)).to_array(), libm::pow(10.0, size))
        };
        let spheres: Vec<_> = spheres.iter().map(placed).collect();
        let shapes = spheres_of(&spheres);
        let shape = leaving.index(spheres.len());
        let (centre, radius) = (DVec3::from(spheres[shape].0), spheres[shape].1);
        let normal = DVec3::from(normal).normalize();
        let along = normal.cross(DVec3::from(aside)).normalize() + normal * tilt;
        let start = centre + normal * radius;
        let point = start + along * radius * libm::pow(10.0, far);
        let distance = (point - start).length();
        prop_assume!(along.is_finite() && distance > 0.0);
        let cones = shapes.view_cones(point).unwrap();
        // Towards the point, as shadow rays go to a light.
        let departure = side.map(|side| Departure { surface: SurfaceId { shape: shape as u32, part: 0 }, side });
        let towards = Ray { origin: start, direction: (point - start) / distance, departure };
        let occluded = shapes.occluded(&towards, distance);
        prop_assert_eq!(shapes.occluded_from(Some(&cones), &towards, distance), occluded);
        // From the point, as rays leave a camera.
        let from = Ray::new(point, -towards.direction);
        let mut hits = Vec::new();
        shapes.intersect_all(Some(&cones), [&from].into_iter(), &mut hits);
        prop_assert_eq!(hits, [shapes.intersect(&from)]);
    }
}

#[test]
fn no_ray_leaves_a_closed_mirror_ball_far_out() {
    for width in [1, 16] {
        let scene = scene(&format!(
            "camera = {{ position = [10000000, 10000000.9, 10000000], target = [10000001, 10000000.95, 10000000], up = [0, 0, 1], \
             size = [{width}, 40], samples = 4 }}\n\
             environment = {{ kind = \"constant\", radiance = 1 }}\n\
             integrator = {{ depth = 60, weight_cutoff = 0 }}\n\
             materials.mirror = {{ kind = \"mirror\", colour = 1 }}\n\
             shapes = [{{ kind = \"sphere\", centre = [10000000, 10000000, 10000000], material = \"mirror\" }}]\n"
        ));
        let counts = render(&scene, &Plan::new(&scene), &Silent).unwrap().counts;
        assert_eq!((counts.environment, counts.cut_by_depth), (0, 160 * width), "{counts:?}");
    }
}

#[test]
fn of_two_shapes_at_the_same_distance_the_first_shows() {
    let folder = tempfile::tempdir().unwrap();
    let square = "v -5 -5 0\nv 5 -5 0\nv 5 5 0\nv -5 5 0\nf 1 2 3 4\n";
    std::fs::write(folder.path().join("square.obj"), square).unwrap();
    let mesh = "{ kind = \"mesh\", file = \"square.obj\", material = \"first\" }";
    let plane = |material: &str| format!("{{ kind = \"plane\", normal = [0, 0, 1], material = \"{material}\" }}");
    for shapes in
        [format!("{mesh}, {}", plane("second")), format!("{}, {}", plane("first"), mesh.replace("first", "second"))]
    {
        let text = format!(
            "camera = {{ position = [0, 0, 4], target = [0, 0, 0], up = [0, 1, 0], size = [1, 1] }}\n\
             integrator = {{ kind = \"phong\" }}\nlights = [{{ kind = \"ambient\", radiance = 1 }}]\n\
             materials.first = {{ kind = \"lambert\", colour = [1, 0, 0] }}\n\
             materials.second = {{ kind = \"lambert\", colour = [0, 1, 0] }}\nshapes = [{shapes}]\n"
        );
        let scene =
            Scene::from_text(&text, &folder.path().join("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
        let rendering = render(&scene, &Plan::new(&scene), &Silent).unwrap();
        assert_eq!(rendering.raster.pixels(), [Vec3::X], "{shapes}");
    }
}

/// A scene whose film keeps all it can: uneven weights and layers, and a size that streams do not fill.
fn demanding() -> Scene {
    let mut scene = scene(
        "camera = { position = [0, 1, 6], target = [0, 1, 0], up = [0, 1, 0], size = [35, 18], samples = 11 }\n\
         environment = { kind = \"gradient\", zenith = [0.2, 0.4, 0.9], horizon = [1, 0.9, 0.8], up = \"+y\" }\n\
         materials.floor = { kind = \"lambert\", colour = { checker = [0.3, 0.6], repeat = 1 } }\n\
         materials.glass = { kind = \"glass\" }\n\
         lights = [{ kind = \"point\", position = [-4, 6, 5], intensity = 40 }]\n\
         shapes = [{ kind = \"plane\", normal = [0, 1, 0], material = \"floor\" },\n\
         { kind = \"sphere\", centre = [0, 1, 0], material = \"glass\" }]\n",
    );
    scene.sampling.filter = PixelFilter::Gaussian;
    scene
}

fn layers(rendering: &Rendering) -> [&Raster; 4] {
    let layers = rendering.layers.as_ref().unwrap();
    [&layers.normal, &layers.albedo, &layers.depth, &layers.variance]
}

#[test]
fn passes_change_neither_uneven_weights_nor_layers() {
    let scene = demanding();
    let plan = Plan::new(&scene);
    let mut renderer = Renderer::with_layers(&scene, &plan).unwrap();
    renderer.add_samples(11, &Silent).unwrap();
    let whole = renderer.rendering(false);
    let renderer = Renderer::with_layers(&scene, &plan).unwrap();
    let passes = render_progressively(renderer, Budget::Samples(11), &Silent).unwrap();
    assert_eq!((&passes.raster, passes.counts), (&whole.raster, whole.counts));
    assert_eq!(layers(&passes), layers(&whole));
}

/// Cancels after it was asked so many times by threads that render.
struct After(AtomicU32);

impl Progress for After {
    fn advance(&self, _samples: u64, _rays: u64) {}

    fn cancelled(&self) -> bool {
        rayon::current_thread_index().is_some()
            && self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1)).is_err()
    }
}

#[test]
fn a_cancelled_pass_leaves_every_row_right_by_itself() {
    let scene = demanding();
    let plan = Plan::new(&scene);
    let of = |samples: u32| {
        let mut renderer = Renderer::with_layers(&scene, &plan).unwrap();
        renderer.add_samples(samples, &Silent).unwrap();
        renderer.rendering(false)
    };
    let (before, between, after) = (of(3), of(4), of(5));
    let mut renderer = Renderer::with_layers(&scene, &plan).unwrap();
    renderer.add_samples(3, &Silent).unwrap();
    // It is asked before each of the two streams of a row, for two samples: rows 0 to 15 are finished, row 16 has one sample
    // and a part of another, row 17 is not begun.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    pool.install(|| renderer.add_samples(2, &After(AtomicU32::new(67)))).unwrap_err();
    let shown = renderer.rendering(true);
    let pixel = |rendering: &Rendering, number: usize| layers(rendering).map(|layer| layer.pixels()[number]);
    let mut kinds = [0; 3];
    for number in 0..35 * 18 {
        let colour = shown.raster.pixels()[number];
        let same = |rendering: &&Rendering| {
            (rendering.raster.pixels()[number], pixel(rendering, number)) == (colour, pixel(&shown, number))
        };
        // Where several are the same, the row's own.
        let row = [&after, &between, &before][(number / 35).saturating_sub(15).min(2)];
        assert!(same(&row), "pixel {number}");
        kinds[(number / 35).saturating_sub(15).min(2)] += 1;
    }
    assert_eq!(kinds, [16 * 35, 35, 35]);
    assert_eq!(shown.counts.camera, 35 * (16 * 5 + 4 + 3));
}

/// Cancels once the picture is there coarsely.
struct Coarsely(AtomicU32);

impl Progress for Coarsely {
    fn advance(&self, _samples: u64, _rays: u64) {}

    fn cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed) == 2
    }

    fn presentable(&self) {
        self.0.fetch_add(1, Ordering::Relaxed);
    }
}

#[test]
fn a_picture_stopped_in_its_first_pass_shows_the_sample_in_the_middle_of_each_square() {
    let scene = demanding();
    let plan = Plan::new(&scene);
    let renderer = Renderer::with_layers(&scene, &plan).unwrap();
    let shown = render_progressively(renderer, Budget::Samples(11), &Coarsely(AtomicU32::new(0))).unwrap();
    let mut renderer = Renderer::with_layers(&scene, &plan).unwrap();
    renderer.add_samples(1, &Silent).unwrap();
    let whole = renderer.rendering(false);
    assert_eq!((shown.stopped, shown.samples, shown.coarse_rows), (true, 0, 18));
    for (x, y) in (0..18).flat_map(|y| (0..35).map(move |x| (x, y))) {
        let [middle_x, middle_y] = [(x / 16 * 16 + 8).min(34), (y / 16 * 16 + 8).min(17)];
        let pixels = |rendering: &Rendering, x: usize, y: usize| {
            let [normal, albedo, depth, variance] = layers(rendering);
            [&rendering.raster, normal, albedo, depth, variance].map(|raster| raster.pixels()[35 * y + x])
        };
        assert_eq!(pixels(&shown, x, y), pixels(&whole, middle_x, middle_y), "pixel {x}, {y}");
    }
}
