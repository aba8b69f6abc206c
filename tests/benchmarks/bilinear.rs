//! Bilinear lookups in six pictures of 2048 x 2048 texels on one core, and decoding of six such pictures on two.
//!
//! `cargo bench --bench bilinear`

#[path = "../common/mod.rs"]
mod common;
mod tiles;

use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use skycube::math::Vec3;
use skycube::picture::{Format, Header, Picture, Texels, decode};
use tiles::Tiles;

const SIZE: usize = 2048;
const LOOKUPS: usize = 1 << 20;

/// A point of one of six pictures, in texels.
type Point = (u32, f32, f32);

/// Numbers without pattern (SplitMix64, Steele et al. 2014).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// In `[0, SIZE)`.
    fn coordinate(&mut self) -> f32 {
        (self.bits() >> 40) as f32 * (SIZE as f32 / (1 << 24) as f32)
    }
}

fn faces() -> Vec<Picture> {
    let mut random = Random(1);
    (0..6)
        .map(|_| {
            let bytes = (0..SIZE * SIZE * 3 / 8).flat_map(|_| random.bits().to_le_bytes()).collect();
            let header = Header { width: SIZE, height: SIZE, format: Format::Png, bit_depth: 8, alpha: false };
            Picture::new(header, Texels::Srgb8(bytes))
        })
        .collect()
}

/// Points of one face in scan line order, about 1.5 texels apart, as a camera sees them.
fn coherent() -> Vec<Point> {
    let side = LOOKUPS.isqrt();
    let place = |index: usize| index as f32 * 1.5 + 3.3;
    (0..LOOKUPS).map(|index| (index as u32 / 200_000, place(index % side), place(index / side))).collect()
}

fn random() -> Vec<Point> {
    let mut random = Random(2);
    (0..LOOKUPS).map(|_| ((random.bits() % 6) as u32, random.coordinate(), random.coordinate())).collect()
}

fn lookups(criterion: &mut Criterion) {
    let faces = faces();
    let tiled: Vec<Tiles> = faces.iter().map(Tiles::new).collect();
    let mut group = criterion.benchmark_group("bilinear");
    group.throughput(Throughput::Elements(LOOKUPS as u64));
    group.sample_size(20).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
    for (order, points) in [("coherent", coherent()), ("random", random())] {
        group.bench_function(format!("rows of RGB8, {order}"), |bencher| {
            bencher.iter(|| sum(&points, |face, x, y| faces[face].bilinear(x, y)));
        });
        group.bench_function(format!("tiles of RGBA8, {order}"), |bencher| {
            bencher.iter(|| sum(&points, |face, x, y| tiled[face].bilinear(x, y)));
        });
    }
    group.finish();
    let mut group = criterion.benchmark_group("tiles");
    group.sample_size(10).measurement_time(Duration::from_secs(1));
    group.bench_function("six faces from rows into tiles", |bencher| {
        bencher.iter(|| faces.iter().map(Tiles::new).collect::<Vec<_>>());
    });
    group.finish();
}

#[inline(always)]
fn sum(points: &[Point], lookup: impl Fn(usize, f32, f32) -> Vec3) -> Vec3 {
    points.iter().fold(Vec3::ZERO, |sum, &(face, x, y)| sum + lookup(face as usize, x, y))
}

fn decoding(criterion: &mut Criterion) {
    let Some(folder) = common::shared_map("meadow") else { return };
    let names = ["posx", "negx", "posy", "negy", "posz", "negz"].map(|name| folder.join(name).with_extension("jpg"));
    let files = names.map(|path| std::fs::read(path).expect("the map is readable"));
    let mut group = criterion.benchmark_group("decode");
    group.sample_size(20).measurement_time(Duration::from_secs(3));
    group.bench_function("six JPEGs of 2048 x 2048, two threads", |bencher| {
        bencher.iter(|| decode_on_two_threads(&files));
    });
    group.finish();
}

fn decode_on_two_threads(files: &[Vec<u8>; 6]) {
    let next = std::sync::atomic::AtomicUsize::new(0);
    let work = || {
        while let Some(file) = files.get(next.fetch_add(1, std::sync::atomic::Ordering::Relaxed)) {
            black_box(decode(file, Path::new("face.jpg")).expect("the map decodes"));
        }
    };
    std::thread::scope(|scope| {
        scope.spawn(work);
        work();
    });
}

criterion_group!(benches, lookups, decoding);
criterion_main!(benches);
