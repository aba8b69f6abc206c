//! `CubeMap::sample` in six images of 2048 x 2048 texels on one core, and decoding of six such images on two.
//!
//! `cargo bench --bench cube_map`

#[path = "../common/mod.rs"]
mod common;

use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use skycube::envmap::{CubeFilter, CubeMap, LazyImage, Preset};
use skycube::math::Vec3;
use skycube::memory::zeros_on_large_pages;
use skycube::picture::{Format, Header, Picture, Texels, decode};
use skycube::stress::Random;

const SIZE: usize = 2048;
const LOOKUPS: usize = 1 << 20;

fn cube_map(filter: CubeFilter) -> CubeMap {
    let images = std::array::from_fn(|image| {
        // As decoded pictures are.
        let mut bytes = zeros_on_large_pages(0, SIZE * SIZE * 3);
        bytes.iter_mut().enumerate().for_each(|(index, byte)| *byte = (index * (image + 7)) as u8);
        let header = Header { width: SIZE, height: SIZE, format: Format::Png, bit_depth: 8, alpha: false };
        LazyImage::ready(Picture::new(header, Texels::Srgb8(bytes)))
    });
    CubeMap::new(images, Preset::Course.lookup(), filter)
}

/// Directions of a 90 degree camera in scan line order, two texels apart.
fn coherent() -> Vec<Vec3> {
    let side = LOOKUPS.isqrt();
    let place = |index: usize| (index as f32 + 0.5) / side as f32 * 2.0 - 1.0;
    (0..LOOKUPS).map(|index| Vec3::new(1.0, place(index % side), place(index / side))).collect()
}

fn scattered() -> Vec<Vec3> {
    let mut random = Random(2);
    (0..LOOKUPS).map(|_| random.direction().as_vec3()).collect()
}

fn lookups(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("cube map");
    group.throughput(Throughput::Elements(LOOKUPS as u64));
    group.sample_size(20).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
    for filter in [CubeFilter::Bilinear, CubeFilter::Nearest, CubeFilter::Seamless] {
        let map = cube_map(filter);
        for (order, directions) in [("coherent", coherent()), ("random", scattered())] {
            group.bench_function(format!("{filter:?}, {order}"), |bencher| {
                bencher.iter(|| directions.iter().fold(Vec3::ZERO, |sum, &direction| sum + map.sample(direction)));
            });
        }
    }
    group.finish();
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
