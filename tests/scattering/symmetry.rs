//! Reciprocity, and the limits of roughness and index.

use skycube::math::DVec3;
use skycube::stress::Random;

use crate::subjects::{glass, gold, phong, scattering, view, white_coated, white_metal};

fn upwards(random: &mut Random) -> DVec3 {
    let direction = random.direction();
    DVec3::new(direction.x, direction.y, direction.z.abs().max(1e-3)).normalize()
}

#[test]
fn reflection_is_reciprocal() {
    let mut random = Random(1);
    for roughness in [1e-3, 0.1, 0.5, 1.0] {
        let glass = glass(1.5, roughness);
        for material in [white_metal(roughness), gold(roughness), white_coated(roughness), phong(20.0)] {
            let scattering = scattering(&material, 1.0);
            for _ in 0..2000 {
                let (one, other) = (upwards(&mut random), upwards(&mut random));
                let there = f64::from(scattering.evaluate(one, other).value.x) / other.z;
                let back = f64::from(scattering.evaluate(other, one).value.x) / one.z;
                assert!(
                    (there - back).abs() < 1e-5 * (there + back) + 1e-30,
                    "{roughness} {one} {other}: {there} {back}"
                );
            }
        }
        for index in [1.5, 1.0 / 1.5] {
            let scattering = scattering(&glass, index);
            for _ in 0..2000 {
                let (one, other) = (upwards(&mut random), upwards(&mut random));
                let there = f64::from(scattering.evaluate(one, other).value.x) / other.z;
                let back = f64::from(scattering.evaluate(other, one).value.x) / one.z;
                assert!(
                    (there - back).abs() < 1e-5 * (there + back) + 1e-30,
                    "{roughness} {one} {other}: {there} {back}"
                );
            }
        }
    }
}

#[test]
fn transmission_is_reciprocal_with_the_squares_of_the_indices() {
    let mut random = Random(2);
    for roughness in [1e-3, 0.1, 0.5, 1.0] {
        let glass = glass(1.5, roughness);
        let (outside, inside) = (scattering(&glass, 1.0 / 1.5), scattering(&glass, 1.5));
        let mut seen = 0;
        for _ in 0..4000 {
            let (above, below) = (upwards(&mut random), upwards(&mut random));
            // The frame of the other side is turned about x: z and y change their signs.
            let turned = |direction: DVec3| DVec3::new(direction.x, -direction.y, -direction.z);
            let there = f64::from(outside.evaluate(above, turned(below)).value.x) / below.z;
            let back = f64::from(inside.evaluate(below, turned(above)).value.x) / above.z;
            let (there, back) = (there, 1.5 * 1.5 * back);
            assert!(
                (there - back).abs() < 1e-5 * (there + back) + 1e-30,
                "{roughness} {above} {below}: {there} {back}"
            );
            seen += usize::from(there > 0.0);
        }
        assert!(seen > 1000);
    }
}

/// The same random numbers lead the same way, but for a few whose choice falls close to the reflectance.
#[test]
fn slight_roughness_agrees_with_none() {
    let mut random = Random(3);
    for relative_index in [1.0 / 1.5, 1.5] {
        let (smooth, rough) = (glass(1.5, 0.0), glass(1.5, 1e-4));
        let (smooth, rough) = (scattering(&smooth, relative_index), scattering(&rough, relative_index));
        for cosine in [0.1, 0.5, 0.7, 0.8, 1.0] {
            let view = view(cosine);
            let (mut agreeing, mut transmitted) = (0, [0, 0]);
            for _ in 0..10_000 {
                let (place, choice) = ([random.unit(), random.unit()], random.unit());
                let one = smooth.sample(view, place, choice).unwrap();
                let Some(other) = rough.sample(view, place, choice) else { continue };
                agreeing += usize::from(one.direction.dot(other.direction) > 0.9999);
                transmitted[0] += i32::from(one.transmitted);
                transmitted[1] += i32::from(other.transmitted);
            }
            assert!(agreeing > 9900, "{relative_index} {cosine}: {agreeing}");
            assert!((transmitted[0] - transmitted[1]).abs() < 100, "{relative_index} {cosine}: {transmitted:?}");
        }
    }
}

#[test]
fn equal_indices_are_invisible() {
    for roughness in [0.0, 0.1, 1.0] {
        let material = glass(1.5, roughness);
        let scattering = scattering(&material, 1.0);
        let sample = scattering.sample(view(0.3), [0.2, 0.7], 0.1).unwrap();
        assert_eq!((sample.direction, sample.specular, sample.transmitted), (-view(0.3), true, true));
        assert!(scattering.is_specular());
    }
}
