//! The tables against quadratures a hundred times as fine, on cosines that are no nodes.

use std::time::Instant;

use super::conductor::MetalReflectance;
use super::{Coat, Metal, RoughGlass};
use crate::math::Vec3;

const ROUGHNESSES: [f64; 9] = [1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 0.6, 1.0];

fn cosines() -> impl Iterator<Item = f64> {
    (1..60)
        .map(|step| {
            let x = f64::from(step) / 60.0 + 0.003;
            x * x * x
        })
        .chain([1e-5, 1e-4, 1e-3, 0.7453, 0.7459])
}

#[test]
fn tables_are_exact_to_a_ten_thousandth() {
    for roughness in ROUGHNESSES {
        let start = Instant::now();
        let metal = Metal::new(MetalReflectance::Schlick { normal: Vec3::ONE }, roughness);
        let t1 = start.elapsed();
        let start = Instant::now();
        let coat = Coat::new(1.5, roughness);
        let t2 = start.elapsed();
        let start = Instant::now();
        let glass = RoughGlass::new(1.5, roughness);
        let t3 = start.elapsed();
        let worst = |error: &dyn Fn(f64) -> f64| {
            cosines().map(|mu| (error(mu).abs(), mu)).fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a })
        };
        let (m, c) = (worst(&|mu| metal.table_error(mu)), worst(&|mu| coat.table_error(mu)));
        let g = [0, 1].map(|side| worst(&|mu| glass.table_error(side, mu)));
        println!(
            "{roughness} metal {:.1e} at {:.4} {t1:.1?}, coat {:.1e} at {:.4} {t2:.1?}, glass {:.1e} at {:.4}, {:.1e} at {:.4} {t3:.1?}",
            m.0, m.1, c.0, c.1, g[0].0, g[0].1, g[1].0, g[1].1
        );
        for (error, _) in [m, c, g[0], g[1]] {
            assert!(error < 1e-4, "{roughness}");
        }
    }
}
