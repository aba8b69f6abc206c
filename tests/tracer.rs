//! The tracer against closed forms, and its promises: what the plan leaves out, and the same bytes on any threads.

use std::path::Path;

use glam::{DVec3, Vec3};
use skycube::integrators::{Integrator, RayCounts};
use skycube::math::Ray;
use skycube::picture;
use skycube::render::{Rendering, Silent, render};
use skycube::sampling::PixelSampler;
use skycube::scene::{Plan, Scene};

const COMPASS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/envmaps/compass");

fn scene(text: &str) -> Scene {
    let camera = "camera = { position = [0, -5, 0], target = [0, 0, 0], size = [48, 32] }\n";
    Scene::from_text(&format!("{camera}{text}"), Path::new("test.toml")).unwrap_or_else(|error| panic!("{error}"))
}

fn rendering(scene: &Scene) -> Rendering {
    render(scene, &Plan::new(scene), &Silent).unwrap()
}

fn along(scene: &Scene, origin: DVec3, direction: DVec3) -> Vec3 {
    let ray = Ray::new(origin, direction.normalize());
    let plan = Plan::new(scene);
    let integrator = Integrator::new(scene, &plan).unwrap();
    let media = integrator.media_around(origin);
    integrator.radiance(&ray, &media, &mut PixelSampler::new(0, 0, 0), &mut RayCounts::default())
}

/// A sequence of numbers in `[0, 1)` without pattern.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let point = DVec3::new(self.next(), self.next(), self.next()) * 2.0 - 1.0;
            if (0.01..1.0).contains(&point.length_squared()) {
                return point.normalize();
            }
        }
    }
}

/// The texel that a direction reads under the lookup `course`, written out by hand from the table in
/// `envmap/conventions.md`.
fn texel_by_hand(d: DVec3, size: f64) -> (usize, usize, usize) {
    let m = d.abs().max_element();
    let (face, u, v) = if d.x.abs() == m {
        if d.x > 0.0 { (0, -d.y, d.z) } else { (1, d.y, d.z) }
    } else if d.y.abs() == m {
        if d.y > 0.0 { (2, d.x, d.z) } else { (3, -d.x, d.z) }
    } else if d.z > 0.0 {
        (4, d.x, -d.y)
    } else {
        (5, d.x, d.y)
    };
    let texel = |coordinate: f64| ((coordinate / m + 1.0) / 2.0 * size) as usize;
    // v = 0 is the bottom row.
    (face, texel(u).min(size as usize - 1), texel(-v).min(size as usize - 1))
}

#[test]
fn a_mirror_sphere_reflects_the_texel_computed_by_hand() {
    let scene = scene(&format!(
        "environment = {{ kind = \"cube-map\", map = {COMPASS:?}, lookup = \"course\", filter = \"nearest\" }}\n\
         materials.mirror = {{ kind = \"mirror\" }}\n\
         [[shapes]]\nkind = \"sphere\"\ncentre = [0.5, -0.25, 2]\nradius = 1.5\nmaterial = \"mirror\"\n"
    ));
    let images = ["posx", "negx", "posy", "negy", "posz", "negz"]
        .map(|name| picture::read(&Path::new(COMPASS).join(name).with_extension("png")).unwrap());
    let (centre, radius) = (DVec3::new(0.5, -0.25, 2.0), 1.5);
    let mut numbers = Numbers(1);
    let (mut seen, mut near_borders) = ([0; 6], 0);
    for _ in 0..10_000 {
        let point = centre + numbers.direction() * radius;
        let normal = (point - centre) / radius;
        let mut away = numbers.direction();
        away *= if away.dot(normal) < 0.0 { -1.0 } else { 1.0 };
        if away.dot(normal) < 1e-3 {
            continue;
        }
        let reflected = -away + normal * (2.0 * away.dot(normal));
        let (face, column, row) = texel_by_hand(reflected, 512.0);
        seen[face] += 1;
        // At the border between two texels f32 and f64 may fall to different sides.
        let nudged = |shift: DVec3| texel_by_hand(reflected + shift, 512.0);
        let near_border =
            [DVec3::X, DVec3::Y, DVec3::Z].iter().any(|&axis| nudged(axis * 1e-6) != nudged(axis * -1e-6));
        near_borders += i32::from(near_border);
        let found = along(&scene, point + away * 3.0, -away);
        assert!(found == images[face].texel(column, row) || near_border, "direction {reflected}: {found}");
    }
    assert!(seen.iter().all(|&count| count > 1000), "every face: {seen:?}");
    // A nudge by 2e-6 moves either of the two coordinates by 512 * 1e-6 / m texels, where m, the largest component of a unit
    // vector, is 1 / sqrt(3) or more. So at most this many directions are near borders, plus five standard deviations.
    let expected = 10_000.0 * 2.0 * 512.0 * 1e-6 * 3.0_f64.sqrt();
    assert!(f64::from(near_borders) < expected + 5.0 * expected.sqrt(), "{near_borders} of 10 000 near borders");
}

#[test]
fn a_slab_of_glass_transmits_what_the_closed_form_says() {
    // Seen straight on, with reflections to and fro: T = (1 - R) a (1 - R) / (1 - R^2 a^2), R = 0.04.
    let scene = scene(
        "environment = { kind = \"gradient\", zenith = 0, horizon = 0, nadir = 0 }\nintegrator.depth = 60\n\
         integrator.weight_cutoff = 0\n\
         materials.glass = { kind = \"glass\", index = 1.5, absorption = [0, 0.5, 2] }\n\
         materials.lamp = { kind = \"lambert\", colour = 1 }\n\
         lights = [{ kind = \"ambient\", radiance = 1 }]\n\
         [[shapes]]\nkind = \"box\"\nminimum = [-9, 0, -9]\nmaximum = [9, 0.7, 9]\nmaterial = \"glass\"\n\
         [[shapes]]\nkind = \"rectangle\"\ncentre = [0, 3, 0]\nnormal = [0, -1, 0]\nsize = [50, 50]\nmaterial = \"lamp\"\n",
    );
    let found = along(&scene, DVec3::new(0.1, -5.0, 0.2), DVec3::Y);
    for (channel, absorption) in [0.0, 0.5, 2.0_f64].into_iter().enumerate() {
        let (reflectance, way) = (0.04, (-absorption * 0.7).exp());
        let expected = (1.0_f64 - reflectance).powi(2) * way / (1.0 - (reflectance * way).powi(2));
        assert!((f64::from(found[channel]) - expected).abs() < 1e-6, "{found} {expected}");
    }
}

#[test]
fn a_glass_in_a_glass_of_the_same_index_is_invisible() {
    let text = |inner: &str| {
        format!(
            "environment = {{ kind = \"cube-map\", map = {COMPASS:?} }}\nintegrator = {{ depth = 30, weight_cutoff = 0 }}\n\
             materials.outer = {{ kind = \"glass\", index = 1.5 }}\nmaterials.inner = {{ kind = \"glass\", index = 1.5 }}\n\
             [[shapes]]\nkind = \"sphere\"\nradius = 1\nmaterial = \"outer\"\n{inner}"
        )
    };
    let plain = rendering(&scene(&text("")));
    let nested = rendering(&scene(&text(
        "[[shapes]]\nkind = \"sphere\"\nradius = 0.5\ncentre = [0.2, 0, 0]\nmaterial = \"inner\"\n",
    )));
    let worst = difference(&plain, &nested);
    assert!(worst < 1e-6, "{worst}");
}

#[test]
fn a_camera_inside_of_glass_knows_what_it_is_in() {
    // Index 1.0 throughout, so only absorption is seen: e^-way in the green channel, by the way through each glass.
    let scene = scene(
        "environment = { kind = \"constant\", radiance = 1 }\nintegrator.weight_cutoff = 0\n\
         materials.outer = { kind = \"glass\", index = 1.0, absorption = [0, 1, 0] }\n\
         materials.inner = { kind = \"glass\", index = 1.0, absorption = [0, 0, 1] }\n\
         [[shapes]]\nkind = \"box\"\nminimum = [-3, -3, -3]\nmaximum = [3, 3, 3]\nmaterial = \"outer\"\n\
         [[shapes]]\nkind = \"sphere\"\nradius = 0.5\nmaterial = \"inner\"\n",
    );
    let expect = |origin: DVec3, green: f64, blue: f64| {
        let found = along(&scene, origin, DVec3::Y);
        let expected = Vec3::new(1.0, (-green).exp() as f32, (-blue).exp() as f32);
        assert!((found - expected).abs().max_element() < 1e-6, "from {origin}: {found} {expected}");
    };
    // From the middle of the ball; from the box in front of it; from outside of both; past the ball.
    expect(DVec3::ZERO, 2.5, 0.5);
    expect(DVec3::new(0.0, -2.0, 0.0), 4.0, 1.0);
    expect(DVec3::new(0.0, -5.0, 0.0), 5.0, 1.0);
    expect(DVec3::new(1.0, 0.0, 0.0), 3.0, 0.0);
}

#[test]
fn overlapping_glasses_absorb_as_one_where_they_are_of_one_kind() {
    let scene = scene(
        "environment = { kind = \"constant\", radiance = 1 }\nintegrator.weight_cutoff = 0\n\
         materials.glass = { kind = \"glass\", index = 1.0, absorption = [0, 1, 0] }\n\
         [[shapes]]\nkind = \"box\"\nminimum = [-1, 0, -1]\nmaximum = [1, 1.2, 1]\nmaterial = \"glass\"\n\
         [[shapes]]\nkind = \"box\"\nminimum = [-1, 1, -1]\nmaximum = [1, 2, 1]\nmaterial = \"glass\"\n",
    );
    let found = along(&scene, DVec3::new(0.1, -3.0, 0.2), DVec3::Y);
    assert!((found.y - (-2.0_f32).exp()).abs() < 1e-6, "{found}");
}

fn difference(one: &Rendering, other: &Rendering) -> f32 {
    let pairs = one.raster.pixels().iter().zip(other.raster.pixels());
    pairs.map(|(a, b)| (*a - *b).abs().max_element()).fold(0.0, f32::max)
}

#[test]
fn random_cuts_leave_the_mean_as_it_is() {
    let text = |cutoff: &str| {
        format!(
            "environment = {{ kind = \"constant\", radiance = 1 }}\nintegrator = {{ depth = 12, weight_cutoff = {cutoff} }}\n\
             materials.glass = {{ kind = \"glass\" }}\n\
             [[shapes]]\nkind = \"sphere\"\nradius = 1.5\nmaterial = \"glass\"\n"
        )
    };
    let mean = |cutoff: &str| {
        let mut scene = scene(&text(cutoff));
        scene.samples = 64;
        let raster = rendering(&scene).raster;
        raster.pixels().iter().map(|pixel| f64::from(pixel.x)).sum::<f64>() / raster.pixels().len() as f64
    };
    let (all, cut) = (mean("0"), mean("0.3"));
    // 1536 pixels of 64 samples, each off by at most 0.3 at random where glass is seen.
    assert!((all - cut).abs() < 1e-3, "{all} {cut}");
    assert!(all > 0.999, "all light of a uniform environment comes through clear glass: {all}");
}

#[test]
fn without_depth_the_path_tracer_leaves_out_for_that_reason() {
    let lit = scene(
        "environment = { kind = \"constant\", radiance = 1 }\nintegrator = { kind = \"path\", depth = 0 }\n\
         materials.a = { kind = \"lambert\", colour = 1 }\nmaterials.b = { kind = \"mirror\" }\n\
         shapes = [{ kind = \"sphere\", material = \"a\" }, { kind = \"sphere\", material = \"b\" }]\n",
    );
    insta::assert_snapshot!(Plan::new(&lit).left_out(&lit).join("\n"), @r"
    no point, spot or directional light: no shadow rays to them
    depth 0: no shadow rays to area lights and environment
    depth 0: no photon pass
    depth 0: no reflected or refracted rays
    no environment picture: nothing to decode
    2 shapes, too few: no hierarchy over them
    ");
}

#[test]
fn the_plan_leaves_out_what_the_scene_does_not_need() {
    let matt =
        scene("materials.a = { kind = \"lambert\", colour = 1 }\nshapes = [{ kind = \"sphere\", material = \"a\" }]\n");
    let plan = Plan::new(&matt);
    assert!(!plan.shadow_rays && !plan.reflection && !plan.refraction && !plan.hierarchy && !plan.environment_map);
    let counts = rendering(&matt).counts;
    assert_eq!((counts.shadow, counts.reflected, counts.refracted), (0, 0, 0));
    insta::assert_snapshot!(plan.left_out(&matt).join("\n"), @r"
    no lights: no direct light, no shadow rays
    no mirror and no glass: no reflected rays
    no environment picture: nothing to decode
    1 shape, too few: no hierarchy over them
    ");

    let mirror = scene(
        "materials.a = { kind = \"mirror\" }\nshapes = [{ kind = \"sphere\", material = \"a\" }]\n\
         lights = [{ kind = \"point\", position = [0, -3, 3], intensity = 1 }]\n",
    );
    assert!(!Plan::new(&mirror).shadow_rays && Plan::new(&mirror).reflection && !Plan::new(&mirror).refraction);
    let counts = rendering(&mirror).counts;
    assert!(counts.reflected > 0 && counts.shadow == 0 && counts.refracted == 0);
}

#[test]
fn faces_that_no_ray_reaches_are_never_decoded() {
    let scene = scene(&format!("environment = {{ kind = \"cube-map\", map = {COMPASS:?}, lookup = \"course\" }}\n"));
    rendering(&scene);
    let looked_at: Vec<&str> =
        scene.environment.cube_map().unwrap().looked_at().into_iter().map(|face| face.name()).collect();
    // The camera looks along +y with 45 degrees.
    assert_eq!(looked_at, ["posy"]);
}

#[test]
fn a_face_that_cannot_be_decoded_fails_only_when_it_is_seen() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["posx", "negx", "posy", "negy", "posz", "negz"] {
        let bytes = std::fs::read(Path::new(COMPASS).join(name).with_extension("png")).unwrap();
        let kept = if name == "negy" { bytes.len() / 2 } else { bytes.len() };
        std::fs::write(folder.path().join(name).with_extension("png"), &bytes[..kept]).unwrap();
    }
    let map = folder.path();
    let looking = |target: &str| {
        let text = format!(
            "camera = {{ position = [0, 0, 0], target = {target}, size = [16, 16] }}\n\
             environment = {{ kind = \"cube-map\", map = {map:?}, lookup = \"course\" }}\n"
        );
        let scene = Scene::from_text(&text, Path::new("test.toml")).unwrap();
        render(&scene, &Plan::new(&scene), &Silent)
    };
    assert!(looking("[0, 1, 0]").is_ok());
    let error = looking("[0, -1, 0]").unwrap_err().to_string();
    assert!(error.contains("negy.png"), "{error}");
}

#[test]
fn the_picture_is_the_same_on_any_number_of_threads() {
    let lesson = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons/06-environment-map/glass-and-mirror.toml");
    let on = |threads: usize| {
        let mut scene = Scene::read(&lesson).unwrap();
        scene.camera = scene.camera.resized([96, 60]);
        scene.samples = 2;
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| rendering(&scene))
    };
    let one = on(1);
    assert_eq!(one, on(2));
    assert_eq!(one, on(7));
}

#[test]
fn instances_share_a_mesh_and_many_shapes_get_a_hierarchy() {
    let knot = concat!(env!("CARGO_MANIFEST_DIR"), "/lessons/06-environment-map/knot.obj");
    let copies: String = (0..20)
        .map(|index| {
            format!(
                "[[shapes]]\nkind = \"mesh\"\nfile = {knot:?}\nmaterial = \"a\"\nscale = 0.4\ntranslate = [{}, {}, {}]\n",
                index % 5 - 2,
                index,
                index % 3 - 1
            )
        })
        .collect();
    let scene = scene(&format!("materials.a = {{ kind = \"normals\" }}\n{copies}"));
    assert!(scene.shapes.has_hierarchy());
    let meshes: Vec<_> = scene
        .shapes
        .primitives()
        .iter()
        .map(|primitive| match &primitive.geometry {
            skycube::shapes::Geometry::Mesh(mesh) => std::sync::Arc::as_ptr(mesh),
            _ => unreachable!("the scene has meshes only"),
        })
        .collect();
    assert!(meshes.windows(2).all(|pair| pair[0] == pair[1]));
    assert_hierarchy_agrees_with_trying_all(&scene);
}

fn assert_hierarchy_agrees_with_trying_all(scene: &Scene) {
    let mut numbers = Numbers(7);
    let mut hits = 0;
    for _ in 0..2000 {
        let origin = DVec3::new(numbers.next() - 0.5, -6.0, numbers.next() - 0.5) * 2.0;
        let ray = Ray::new(origin, (DVec3::Y * 8.0 + numbers.direction()).normalize());
        let found = scene.shapes.intersect(&ray).map(|hit| hit.t);
        let primitives = scene.shapes.primitives().iter().enumerate();
        let one_by_one = primitives
            .filter_map(|(shape, primitive)| primitive.intersect(&ray, shape as u32, f64::INFINITY))
            .map(|hit| hit.t)
            .reduce(f64::min);
        assert_eq!(found, one_by_one);
        assert_eq!(scene.shapes.occluded(&ray, f64::INFINITY), found.is_some());
        hits += usize::from(found.is_some());
    }
    assert!(hits > 100, "{hits}");
}
