//! The hierarchy of lesson 10 against the fast one, and both against a loop over all shapes.

use std::path::{Path, PathBuf};

use skycube::bvh::TextbookHierarchy;
use skycube::math::{Bounds, DVec3, Ray, Transform, Vec3};
use skycube::render::{Silent, render};
use skycube::scene::{Aggregate, Plan, Scene};
use skycube::shapes::mesh::{Mesh, MeshGeometry, ShearedRay};
use skycube::shapes::{Geometry, Hit, MaterialChoice, Outline, Primitive};
use skycube::stress::Random;

/// Shapes of all simple kinds, turned and stretched; every third casts no shadow. Some have no extent along an axis.
fn shapes(count: usize, size: f64, random: &mut Random) -> Vec<Primitive> {
    let kinds = [Geometry::Sphere, Geometry::Cuboid, Geometry::Flat(Outline::Disc), Geometry::Flat(Outline::Rectangle)];
    let shape = |number: usize| {
        let turned = if number.is_multiple_of(2) { DVec3::ZERO } else { random.in_ball() * 180.0 };
        let scale = DVec3::splat(0.3 * size) * (1.0 + 0.9 * random.in_ball() * f64::from(u8::from(number % 5 > 1)));
        let transform = Transform::from_parts(random.in_ball() * size, turned, scale).unwrap();
        Primitive::new(kinds[random.below(4)].clone(), transform, MaterialChoice::Whole(0), !number.is_multiple_of(3))
    };
    let mut shapes: Vec<_> = (0..count).map(shape).collect();
    let floor = Transform::from_parts(DVec3::new(0.0, 0.0, -2.0 * size), DVec3::ZERO, DVec3::ONE).unwrap();
    shapes.push(Primitive::new(Geometry::Flat(Outline::Plane), floor, MaterialChoice::Whole(0), true));
    shapes
}

/// The nearest hit by trying every shape.
fn nearest_of_all(shapes: &[Primitive], ray: &Ray) -> Option<Hit> {
    let hits = (0..).zip(shapes).filter_map(|(number, shape)| shape.intersect(ray, number, f64::INFINITY));
    hits.min_by(|a, b| a.t.total_cmp(&b.t))
}

/// Rays of all kinds through a scene of a certain size: from inside and outside, some along an axis, some far away.
fn rays(count: usize, size: f64, random: &mut Random) -> Vec<Ray> {
    let ray = |number: usize| {
        let target = random.in_ball() * size;
        let origin = match number % 4 {
            0 => target - [DVec3::X, DVec3::NEG_Y, DVec3::NEG_Z][number / 4 % 3] * 3.0 * size,
            1 => random.in_ball() * size,
            2 => random.direction() * 2.0 * size,
            _ => random.direction() * 1000.0 * size,
        };
        Ray::new(origin, (target - origin).normalize())
    };
    (0..count).map(ray).collect()
}

/// Asserts that both hierarchies find what the loop finds; returns how many rays hit something.
fn compare(shapes: &[Primitive], rays: &[Ray]) -> usize {
    let textbook = Aggregate::with_hierarchy(shapes.to_vec(), true);
    let fast = Aggregate::new(shapes.to_vec());
    assert!(textbook.has_hierarchy() && fast.has_hierarchy());
    let mut hits = 0;
    for ray in rays {
        let (found, expected) = (textbook.intersect(ray), nearest_of_all(shapes, ray));
        assert_eq!(fast.intersect(ray), found, "{ray:?}");
        assert_eq!(found, expected, "{ray:?}");
        let distance = expected.map_or(1.0, |hit| hit.t);
        for limit in [distance, distance.next_up(), 2.0 * distance, f64::INFINITY] {
            let within = |shape: &Primitive, number| shape.intersect(ray, number, limit).is_some();
            let blocked = (0..).zip(shapes).any(|(number, shape)| within(shape, number));
            let occluded = (0..).zip(shapes).any(|(number, shape)| shape.casts_shadow && within(shape, number));
            assert_eq!([textbook.blocked(ray, limit), fast.blocked(ray, limit)], [blocked; 2], "{ray:?}, {limit}");
            assert_eq!([textbook.occluded(ray, limit), fast.occluded(ray, limit)], [occluded; 2], "{ray:?}, {limit}");
        }
        hits += usize::from(expected.is_some());
    }
    hits
}

#[test]
fn both_find_what_trying_every_shape_finds() {
    let mut random = Random(11);
    for size in [1e-6, 1.0, 1e6] {
        // So many that spheres and flat shapes are under the hierarchy, too.
        for count in [50, 70, 150] {
            let shapes = shapes(count, size, &mut random);
            let hits = compare(&shapes, &rays(2000, size, &mut random));
            assert!(hits > 500, "{hits} hits among {count} shapes of size {size}");
        }
    }
}

#[test]
fn both_agree_on_every_lesson_scene() {
    let lessons = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
    let folder = |path: PathBuf| std::fs::read_dir(path).into_iter().flatten().map(|entry| entry.unwrap().path());
    let files = folder(lessons).flat_map(folder).filter(|file| file.extension().is_some_and(|kind| kind == "toml"));
    let mut scenes = 0;
    for file in files.filter(|file| !file.ends_with("lesson.toml")) {
        let scene = Scene::read(&file).unwrap();
        let [textbook, fast] =
            [true, false].map(|textbook| Aggregate::with_hierarchy(scene.shapes.primitives().to_vec(), textbook));
        let camera = scene.camera.resized([60, 40]);
        let mut hits = 0;
        for (x, y) in (0..2400).map(|pixel| (f64::from(pixel % 60) + 0.5, f64::from(pixel / 60) + 0.5)) {
            let ray = camera.ray(x, y);
            let found = fast.intersect(&ray);
            // Of two surfaces in the same place either may show.
            let distance = |hit: Option<Hit>| hit.map(|hit| hit.t);
            assert_eq!(distance(textbook.intersect(&ray)), distance(found), "{} at {x}, {y}", file.display());
            hits += usize::from(found.is_some());
        }
        assert!(hits > 0 || scene.shapes.primitives().is_empty(), "{}: {hits} hits", file.display());
        scenes += 1;
    }
    assert!(scenes > 20, "{scenes} scenes");
}

#[test]
fn a_scene_chooses_the_textbook_and_looks_the_same() {
    let spheres: String = (0..30)
        .map(|number| {
            let (x, z) = (number % 6 * 2 - 5, number / 6 * 2 - 4);
            format!("[[shapes]]\nkind = \"sphere\"\ncentre = [{x}, {}, {z}]\nmaterial = \"a\"\n", number * 7 % 5)
        })
        .collect();
    let picture = |hierarchy: &str| {
        let text = format!(
            "camera = {{ position = [0, -12, 1], target = [0, 0, 0], size = [60, 60] }}\n\
             integrator = {{ kind = \"whitted\", hierarchy = \"{hierarchy}\" }}\n\
             lights = [{{ kind = \"point\", position = [5, -9, 8], intensity = 200 }}]\n\
             materials.a = {{ kind = \"mirror\", colour = 0.8 }}\n\
             materials.b = {{ kind = \"lambert\", colour = 0.8 }}\n{}",
            spheres.replacen("\"a\"", "\"b\"", 15)
        );
        let scene = Scene::from_text(&text, Path::new("test.toml")).unwrap();
        let plan = Plan::new(&scene);
        (plan.hierarchy, format!("{:?}", render(&scene, &plan, &Silent).unwrap().raster))
    };
    let textbook = picture("textbook");
    assert!(textbook.0);
    assert!(textbook.1 == picture("auto").1);
}

/// The shapes that a ray is tested against, with nothing ever hit.
fn tested(hierarchy: &TextbookHierarchy, origin: DVec3, direction: DVec3, limit: f64) -> Vec<u32> {
    let (mut nearest, mut any) = (Vec::new(), Vec::new());
    hierarchy.intersect(origin, direction, limit, |shape| {
        nearest.push(shape);
        limit
    });
    hierarchy.occluded(origin, direction, limit, |shape| {
        any.push(shape);
        false
    });
    let sorted = |list: &[u32]| {
        let mut list = list.to_vec();
        list.sort_unstable();
        list
    };
    assert_eq!(sorted(&nearest), sorted(&any));
    nearest
}

fn cube(corner: DVec3, size: DVec3) -> Bounds {
    Bounds { minimum: corner, maximum: corner + size }
}

#[test]
fn triangles_are_found_as_by_the_mesh() {
    let mut random = Random(5);
    let mut geometry = MeshGeometry::default();
    for number in 0..3000 {
        let centre = random.in_ball();
        let corner = |random: &mut Random| (centre + random.in_ball() * 0.1).as_vec3() * Vec3::new(1.0, 2.0, 0.5);
        geometry.positions.extend([corner(&mut random), corner(&mut random), corner(&mut random)]);
        geometry.triangles.push([3 * number, 3 * number + 1, 3 * number + 2]);
    }
    let corners = |triangle: u32| geometry.corners(triangle).map(|corner| corner.as_dvec3());
    let boxes: Vec<Bounds> = (0..3000).map(|triangle| Bounds::around(corners(triangle))).collect();
    let (textbook, mesh) = (TextbookHierarchy::build(&boxes), Mesh::new(geometry.clone()).unwrap());
    let (mut hits, mut tests) = (0, 0);
    for _ in 0..3000 {
        let (origin, direction) = (random.direction() * 3.0, random.direction() * 5.0 - random.in_ball());
        let direction = if random.unit() < 0.5 { direction } else { -origin + random.in_ball() };
        let ray = ShearedRay::new(origin, direction);
        let test = |triangle: u32| ray.intersect(corners(triangle).map(|corner| corner.to_array()));
        let mut nearest = (f64::INFINITY, u32::MAX);
        textbook.intersect(origin, direction, f64::INFINITY, |triangle| {
            tests += 1;
            if let Some(hit) = test(triangle).filter(|hit| hit.t > 0.0) {
                nearest = if (hit.t, triangle) < nearest { (hit.t, triangle) } else { nearest };
            }
            nearest.0
        });
        let found = mesh.intersect(origin, direction, f64::INFINITY, None).map(|hit| (hit.t, hit.triangle));
        assert_eq!((nearest.0 < f64::INFINITY).then_some(nearest), found);
        let any = textbook
            .occluded(origin, direction, f64::INFINITY, |triangle| test(triangle).is_some_and(|hit| hit.t > 0.0));
        assert_eq!(any, found.is_some());
        hits += usize::from(found.is_some());
    }
    assert!(hits > 1000 && tests < 3000 * 60, "{hits} hits, {tests} tests of 3000 x 3000");
}

#[test]
fn equal_flat_single_and_missing_boxes() {
    let unit = cube(DVec3::ZERO, DVec3::ONE);
    let through = |boxes: &[Bounds]| {
        let hierarchy = TextbookHierarchy::build(boxes);
        tested(&hierarchy, DVec3::new(0.5, 0.5, -2.0), DVec3::Z, f64::INFINITY).len()
    };
    assert_eq!(through(&[]), 0);
    assert_eq!(through(&[unit]), 1);
    assert_eq!(through(&vec![unit; 10_000]), 10_000);
    // Without thickness, without area, a single point.
    for size in [DVec3::new(1.0, 1.0, 0.0), DVec3::new(0.0, 0.0, 1.0), DVec3::ZERO] {
        let corner = DVec3::new(0.5, 0.5, 0.0);
        assert_eq!(through(&[cube(corner, size); 9]), 9, "{size}");
        assert_eq!(through(&(0..9).map(|k| cube(corner.with_z(f64::from(k)), size)).collect::<Vec<_>>()), 9, "{size}");
    }
    // In the plane of a side, along either direction of the axis, a component of the direction 0 or -0.
    let hierarchy = TextbookHierarchy::build(&[unit; 3]);
    for (zero, x) in [0.0, -0.0].into_iter().flat_map(|zero| [(zero, 0.0), (zero, 1.0)]) {
        let from = |z: f64, direction: f64| {
            tested(&hierarchy, DVec3::new(x, 0.5, z), DVec3::new(zero, zero, direction), f64::INFINITY).len()
        };
        assert_eq!([from(-1.0, 1.0), from(2.0, -1.0), from(2.0, 1.0), from(-1.0, -1.0)], [3, 3, 0, 0]);
    }
    // Each box half the size of the last: the deepest tree.
    let nested: Vec<Bounds> = (0..2000).map(|k| cube(DVec3::ZERO, DVec3::splat(0.5_f64.powi(k - 1000)))).collect();
    let hierarchy = TextbookHierarchy::build(&nested);
    assert_eq!(tested(&hierarchy, DVec3::splat(-1.0), DVec3::ONE, f64::INFINITY).len(), 2000);
}

#[test]
fn few_boxes_are_tested_the_near_ones_first() {
    let corner = |k: usize| DVec3::new((k % 20) as f64, (k / 20 % 20) as f64, (k / 400) as f64);
    let boxes: Vec<Bounds> = (0..8000).map(|k| cube(corner(k), DVec3::splat(0.5))).collect();
    let hierarchy = TextbookHierarchy::build(&boxes);
    let along_x =
        |x: f64, direction: f64, limit: f64| tested(&hierarchy, DVec3::new(x, 3.25, 7.25), DVec3::X * direction, limit);
    let row: Vec<u32> = (0..20).map(|x| x + 20 * 3 + 400 * 7).collect();
    assert_eq!(along_x(-1.0, 1.0, f64::INFINITY), row);
    assert_eq!(along_x(-1.0, 2.0, 3.1), row[..6]);
    assert_eq!(along_x(25.0, -1.0, f64::INFINITY), row.iter().rev().copied().collect::<Vec<_>>());
    assert_eq!(along_x(12.25, 1.0, f64::INFINITY), row[12..]);
    // What is hit spares what lies behind.
    let mut tests = 0;
    hierarchy.intersect(DVec3::new(-1.0, 3.25, 7.25), DVec3::X, f64::INFINITY, |_| {
        tests += 1;
        1.0
    });
    assert_eq!(tests, 1);
}
