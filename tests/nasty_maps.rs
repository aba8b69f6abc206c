//! Maps with the faults and oddities of real ones: what must be found, and what must not be called broken.

mod common;
#[path = "damage/pictures.rs"]
mod pictures;
#[path = "support/random.rs"]
mod random;

use pictures::{Map, Storage, computed, display, laid, right_maps};
use random::Random;
use skycube::envmap::{Face, FacePoint, Laying, Preset};
use skycube::math::Vec3;
use skycube::picture::Picture;
use skycube::validate::{Check, Names, Reason, Verdict};

const SIZE: usize = 256;

/// A map computed from the direction, rounded to whole codes with or without noise.
fn from_directions(noise: f64, colour: impl Fn(Vec3) -> [f32; 3]) -> Map {
    let lookup = Preset::Opengl.lookup();
    let picture = |face: Face| {
        let mut random = Random(face.index() as u64 + 1);
        let mut dither = Vec::new();
        dither.resize_with(3 * SIZE * SIZE, || (random.unit() + random.unit() + random.unit() - 1.5) * noise);
        computed(SIZE, |x, y| {
            let centre = |index: usize| (index as f32 + 0.5) / SIZE as f32;
            let direction = lookup.direction(FacePoint { face, u: centre(x), v: centre(y) }).normalize();
            let channels = colour(direction);
            std::array::from_fn(|channel| channels[channel] + dither[3 * (y * SIZE + x) + channel] as f32)
        })
    };
    Map::new(Face::ALL.map(picture))
}

fn stars(count: usize) -> Map {
    let mut random = Random(5);
    let mut faces = Vec::new();
    for _ in Face::ALL {
        let mut bright = vec![0.0_f32; SIZE * SIZE];
        for _ in 0..count {
            bright[random.below(SIZE * SIZE)] = 60.0 + 195.0 * random.unit() as f32;
        }
        faces.push(computed(SIZE, |x, y| [bright[y * SIZE + x]; 3]));
    }
    Map::new(faces.try_into().unwrap())
}

fn changed(picture: &Picture, change: impl Fn(usize, usize, [f32; 3]) -> [f32; 3]) -> Picture {
    computed(picture.width(), |x, y| change(x, y, display(picture, x, y)))
}

fn with(map: &Map, face: usize, picture: Picture) -> Map {
    let mut pictures = map.pictures().clone();
    pictures[face] = picture;
    Map::new(pictures)
}

fn say(what: &str, check: &Check) {
    let foreign: Vec<String> = check.foreign.iter().map(|f| format!("{} {:?}", f.face.name(), f.reason)).collect();
    let fixes: Vec<String> = check
        .fix
        .faces
        .iter()
        .map(|f| {
            format!(
                "{}{}{}",
                f.image.name(),
                f.laying.image_operation(skycube::envmap::VOrigin::Top).name().replace("none", ""),
                if f.decided { "" } else { "?" }
            )
        })
        .collect();
    println!(
        "{what:60} {:11} margin {:4.1} changes {} {foreign:?} {}",
        check.verdict.name(),
        check.fix.margin,
        check.fix.changes,
        fixes.join(" ")
    );
}

#[test]
fn explore() {
    let sky = |a: f32| {
        move |d: Vec3| [100.0 + a * d.y + 0.3 * a * d.x, 120.0 + a * d.y + 0.2 * a * d.z, 180.0 + 0.5 * a * d.y]
    };
    for amplitude in [1.0, 3.0, 10.0] {
        for noise in [0.0, 0.5, 2.0] {
            let map = from_directions(noise, sky(amplitude));
            say(&format!("gradient {amplitude} noise {noise}"), &map.check(Names::Auto));
            for storage in [Storage::png(SIZE), Storage::jpeg(SIZE)] {
                let map = map.stored(&storage);
                say(&format!("  stored {}", storage.name()), &map.check(Names::Auto));
                let mut layings = [Laying::IDENTITY; 6];
                layings[2] = Laying::ALL[4];
                say("  top turned", &map.damaged(&[0, 1, 2, 3, 4, 5], &layings).check(Names::Auto));
            }
        }
    }
    for count in [20, 200, 2000] {
        let map = stars(count);
        say(&format!("stars {count}"), &map.check(Names::Auto));
        say("  jpeg", &map.stored(&Storage::jpeg(SIZE)).check(Names::Auto));
    }
    let maps: Vec<(&str, Map)> = right_maps().into_iter().map(|(n, m)| (n, m.stored(&Storage::jpeg(SIZE)))).collect();
    // six unrelated
    let mut random = Random(3);
    for trial in 0..20 {
        let pictures: Vec<Picture> = (0..6)
            .map(|f| {
                let m = &maps[(trial + f * (1 + trial % 3)) % maps.len()].1;
                laid(&m.pictures()[random.below(6)], Laying::ALL[random.below(8)])
            })
            .collect();
        say(&format!("unrelated {trial}"), &Map::new(pictures.try_into().unwrap()).check(Names::Auto));
    }
    for (index, (name, map)) in maps.iter().enumerate() {
        say(name, &map.check(Names::Auto));
        for face in 0..6 {
            let grey = computed(SIZE, |_, _| [128.0; 3]);
            say(&format!("{name} grey {face}"), &with(map, face, grey).check(Names::Auto));
            let black = computed(SIZE, |_, _| [0.0; 3]);
            say(&format!("{name} black {face}"), &with(map, face, black).check(Names::Auto));
            let copy = map.pictures()[(face + 2) % 6].clone();
            say(&format!("{name} copy {face} of {}", (face + 2) % 6), &with(map, face, copy).check(Names::Auto));
            let copy = map.pictures()[face ^ 1].clone();
            say(&format!("{name} copy {face} of {}", face ^ 1), &with(map, face, copy).check(Names::Auto));
            let other = maps[(index + 1) % maps.len()].1.pictures()[face].clone();
            say(&format!("{name} other scene {face}"), &with(map, face, other).check(Names::Auto));
        }
        let exposed = std::array::from_fn(|face| {
            let factor = [0.9, 1.1, 1.0, 0.95, 1.05, 0.9][face];
            changed(&map.pictures()[face], |_, _, c| c.map(|v| v * factor))
        });
        say(&format!("{name} exposed 10 %"), &Map::new(exposed).check(Names::Auto));
        let exposed = std::array::from_fn(|face| {
            let factor = [0.7, 1.2, 1.0, 0.8, 1.3, 0.6][face];
            changed(&map.pictures()[face], |_, _, c| c.map(|v| v * factor))
        });
        say(&format!("{name} exposed 40 %"), &Map::new(exposed).check(Names::Auto));
        let framed = std::array::from_fn(|face| {
            changed(&map.pictures()[face], |x, y, c| {
                if x == 0 || y == 0 || x == SIZE - 1 || y == SIZE - 1 { [10.0; 3] } else { c }
            })
        });
        let framed = Map::new(framed);
        let check = framed.check(Names::Auto);
        say(&format!("{name} framed ({} notes)", check.notes.len()), &check);
        let vignette = std::array::from_fn(|face| {
            changed(&map.pictures()[face], |x, y, c| {
                let r = |i: usize| (i as f32 / SIZE as f32 - 0.5).powi(2);
                c.map(|v| v * (1.0 - 0.5 * (r(x) + r(y))))
            })
        });
        say(&format!("{name} vignette"), &Map::new(vignette).check(Names::Auto));
        // panorama slightly different resampling: each face shifted by one texel
        let shifted = std::array::from_fn(|face| {
            let p = &map.pictures()[face];
            computed(SIZE, |x, y| display(p, (x + 2).min(SIZE - 1), (y + 1).min(SIZE - 1)))
        });
        say(&format!("{name} shifted"), &Map::new(shifted).check(Names::Auto));
    }
    let _ = (Reason::Flat, Verdict::Fits);
}
