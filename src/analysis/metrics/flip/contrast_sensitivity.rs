//! The contrast sensitivity of the eye in the three opponent channels (section 4.1.1 of the paper).

use crate::math::functions::exponential_f64;
use crate::metrics::Plane;
use crate::metrics::gaussian;

/// Pixels a degree of the visual field: a monitor 0.7 m wide with 3840 pixels seen from 0.7 m, as in the paper.
pub const PIXELS_A_DEGREE: f64 = 67.020_643_276_582_25;

const PI: f64 = std::f64::consts::PI;

/// A term `a sqrt(pi / b) exp(-pi^2 r^2 / b)` of a filter, r in degrees (table 1 of the paper).
struct Term {
    a: f64,
    b: f64,
}

const ACHROMATIC: [Term; 1] = [Term { a: 1.0, b: 0.0047 }];
const RED_GREEN: [Term; 1] = [Term { a: 1.0, b: 0.0053 }];
const BLUE_YELLOW: [Term; 2] = [Term { a: 34.1, b: 0.04 }, Term { a: 13.5, b: 0.025 }];

/// The widest term sets the radius of all filters: three of its standard deviations.
const WIDEST: f64 = 0.04;

/// The channels Y, Cx and Cz with what the eye does not resolve filtered away.
pub fn resolved([y, x, z]: &[Plane; 3]) -> [Plane; 3] {
    [filtered(y, &ACHROMATIC), filtered(x, &RED_GREEN), filtered(z, &BLUE_YELLOW)]
}

/// The standard deviation of a term in pixels.
fn deviation(b: f64) -> f64 {
    (b / (2.0 * PI * PI)).sqrt() * PIXELS_A_DEGREE
}

fn radius() -> usize {
    (3.0 * deviation(WIDEST)).ceil() as usize
}

/// The plane under a sum of Gaussians whose integral is 1. Each term is separable, their sum is not.
fn filtered(plane: &Plane, terms: &[Term]) -> Plane {
    let volumes: Vec<f64> = terms.iter().map(volume).collect();
    let total: f64 = volumes.iter().sum();
    let mut sum: Option<Plane> = None;
    for (term, volume) in terms.iter().zip(&volumes) {
        let kernel = gaussian(deviation(term.b), radius());
        let share = (volume / total) as f32;
        let weighted: Vec<f32> = kernel.iter().map(|weight| weight * share).collect();
        let part = plane.filtered(&kernel, &weighted);
        sum = Some(match sum {
            None => part,
            Some(sum) => sum.zip(&part, |a, b| a + b),
        });
    }
    sum.expect("a filter has terms")
}

/// The sum of a term over the window.
fn volume(Term { a, b }: &Term) -> f64 {
    let reach = radius() as i32;
    let weight = |offset: i32| {
        let degrees = f64::from(offset) / PIXELS_A_DEGREE;
        exponential_f64(-PI * PI * degrees * degrees / b)
    };
    let line: f64 = (-reach..=reach).map(weight).sum();
    a * (PI / b).sqrt() * line * line
}
