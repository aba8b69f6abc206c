//! Rays through a mesh of a million triangles: `cargo bench --bench mesh_rays`.
//!
//! The rays are those of the reference measurements: 1024 x 1024 camera rays, as many random rays from inside, and
//! as many shadow rays; threads as rayon sets them (`RAYON_NUM_THREADS`).

#[path = "../support/icosphere.rs"]
mod icosphere;

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use rayon::prelude::*;
use skycube::math::DVec3;
use skycube::shapes::mesh::Mesh;
use skycube::stress::Random;

const SIDE: usize = 1024;

type Rays = Vec<(DVec3, DVec3)>;

/// A pinhole at (0, 0, 3) that looks along -z, 36 degrees wide, row by row.
fn primary_rays() -> Rays {
    let half = 18.0_f64.to_radians().tan();
    let pixel = |index: usize| (2.0 * (index as f64 + 0.5) / SIDE as f64 - 1.0) * half;
    let ray = |index: usize| {
        let direction = DVec3::new(pixel(index % SIDE), -pixel(index / SIDE), -1.0).normalize();
        (DVec3::new(0.0, 0.0, 3.0), direction)
    };
    (0..SIDE * SIDE).map(ray).collect()
}

/// From points in the ball of radius 1/2, in all directions.
fn incoherent_rays() -> Rays {
    let mut random = Random(1);
    (0..SIDE * SIDE).map(|_| (random.in_ball() * 0.5, random.direction())).collect()
}

fn count(rays: &Rays, hit: impl Fn(DVec3, DVec3) -> bool + Sync) -> usize {
    rays.par_chunks(4096).map(|chunk| chunk.iter().filter(|ray| hit(ray.0, ray.1)).count()).sum()
}

fn mesh_rays(criterion: &mut Criterion) {
    let geometry = icosphere::icosphere(224, icosphere::bumps);
    assert_eq!(geometry.triangles.len(), 1_003_520);
    let mesh = Mesh::new(geometry.clone()).expect("the icosphere is a mesh");
    let mut group = criterion.benchmark_group("million_triangles");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(4))
        .throughput(Throughput::Elements((SIDE * SIDE) as u64));
    let (primary, incoherent) = (primary_rays(), incoherent_rays());
    let closest = |origin, direction| mesh.intersect(origin, direction, f64::INFINITY, None).is_some();
    let any = |origin, direction| mesh.occluded(origin, direction, f64::INFINITY, None);
    assert_eq!(count(&incoherent, closest), incoherent.len(), "a closed mesh does not leak");
    group.bench_function("primary", |bencher| bencher.iter(|| black_box(count(&primary, closest))));
    group.bench_function("incoherent", |bencher| bencher.iter(|| black_box(count(&incoherent, closest))));
    group.bench_function("primary_shadow", |bencher| bencher.iter(|| black_box(count(&primary, any))));
    group.bench_function("incoherent_shadow", |bencher| bencher.iter(|| black_box(count(&incoherent, any))));
    group.finish();
    let mut group = criterion.benchmark_group("build");
    group.sample_size(10);
    group.bench_function("million_triangles", |bencher| bencher.iter(|| Mesh::new(geometry.clone())));
    group.finish();
}

criterion_group!(benches, mesh_rays);
criterion_main!(benches);
