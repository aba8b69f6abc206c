//! Drawing from the environment and from shapes: nanoseconds a call on one core, and how long tables take to build.
//!
//! `cargo bench --bench emitters`

#[path = "../support/icosphere.rs"]
mod icosphere;

use std::sync::Arc;
use std::time::Duration;

use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main, measurement::WallTime};
use skycube::envmap::{
    CubeFilter, CubeMap, Environment, EnvironmentKind, EnvironmentSampler, Equirectangular, LazyImage, Preset,
    SignedAxis,
};
use skycube::math::{DVec3, Transform, Vec3};
use skycube::picture::{Format, Header, Picture, Texels};
use skycube::shapes::mesh::Mesh;
use skycube::shapes::{Geometry, MaterialChoice, Outline, Primitive, ShapeSampler};
use skycube::stress::Random;

const DRAWS: usize = 1 << 16;

fn picture(width: usize, height: usize) -> Picture {
    let header = Header { width, height, format: Format::Exr, bit_depth: 32, alpha: false };
    let mut random = Random(width as u64);
    let texels = (0..width * height).map(|_| Vec3::splat(random.unit().powi(8) as f32 + 0.1)).collect();
    Picture::new(header, Texels::Linear(texels))
}

fn cube_map(size: usize) -> Environment {
    let images = std::array::from_fn(|_| LazyImage::ready(picture(size, size)));
    let map = CubeMap::new(images, Preset::Course.lookup(), CubeFilter::Bilinear);
    Environment { kind: EnvironmentKind::CubeMap(Box::new(map)), scale: 1.0 }
}

fn panorama(width: usize) -> Environment {
    let image = LazyImage::ready(picture(width, width / 2));
    let kind = EnvironmentKind::Equirectangular(Equirectangular { image, up: SignedAxis::POS_Z, turns: 0.0 });
    Environment { kind, scale: 1.0 }
}

fn group<'a>(criterion: &'a mut Criterion, name: &str, throughput: u64) -> BenchmarkGroup<'a, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(throughput));
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    group
}

fn environments(criterion: &mut Criterion) {
    let maps = [("cube 512", cube_map(512)), ("cube 1024", cube_map(1024)), ("panorama 2048", panorama(2048))];
    let mut random = Random(1);
    let places: Vec<[f64; 2]> = (0..DRAWS).map(|_| [random.unit(), random.unit()]).collect();
    let directions: Vec<DVec3> = (0..DRAWS).map(|_| random.direction()).collect();
    let mut group = group(criterion, "environment", DRAWS as u64);
    for (name, map) in &maps {
        let sampler = EnvironmentSampler::new(map).unwrap();
        group.bench_function(format!("{name}, sample"), |bencher| {
            bencher.iter(|| places.iter().map(|&place| sampler.sample(place).unwrap().1).sum::<f64>());
        });
        group.bench_function(format!("{name}, density"), |bencher| {
            bencher.iter(|| directions.iter().map(|&direction| sampler.density(direction)).sum::<f64>());
        });
    }
}

fn tables(criterion: &mut Criterion) {
    let mut group = group(criterion, "tables", 1);
    for size in [256, 1024, 2048] {
        let map = cube_map(size);
        group.bench_function(format!("cube {size}"), |bencher| bencher.iter(|| EnvironmentSampler::new(&map).unwrap()));
    }
}

fn shapes(criterion: &mut Criterion) {
    let slanted = Transform::from_parts(DVec3::ZERO, DVec3::new(10.0, 20.0, 30.0), DVec3::new(1.0, 2.0, 0.5)).unwrap();
    let ball = Arc::new(Mesh::new(icosphere::icosphere(70, |_| 1.0)).unwrap());
    let lights = [
        ("sphere", Geometry::Sphere, Transform::IDENTITY),
        ("ellipsoid", Geometry::Sphere, slanted),
        ("rectangle", Geometry::Flat(Outline::Rectangle), slanted),
        ("disc", Geometry::Flat(Outline::Disc), slanted),
        ("box", Geometry::Cuboid, slanted),
        ("mesh of 98000 triangles", Geometry::Mesh(ball), slanted),
    ];
    let mut random = Random(1);
    let places: Vec<_> =
        (0..DRAWS).map(|_| (random.direction() * 4.0, [random.unit(), random.unit()], random.unit())).collect();
    let mut group = group(criterion, "shapes", DRAWS as u64);
    for (name, geometry, transform) in lights {
        let primitive = Primitive::new(geometry, transform, MaterialChoice::Whole(0), true);
        let sampler = ShapeSampler::new(&primitive, |_| true);
        let density =
            |point, place, choice| sampler.sample_towards(point, place, choice).map_or(0.0, |sample| sample.density);
        group.bench_function(format!("{name}, sample"), |bencher| {
            bencher.iter(|| places.iter().map(|&(point, place, choice)| density(point, place, choice)).sum::<f64>());
        });
        let hits: Vec<_> = places
            .iter()
            .filter_map(|&(point, place, choice)| Some((point, sampler.sample_towards(point, place, choice)?)))
            .collect();
        group.bench_function(format!("{name}, density"), |bencher| {
            bencher.iter(|| {
                let told = hits.iter().map(|(point, hit)| {
                    sampler.density_towards(*point, hit.to_shape, hit.position, hit.normal, hit.id_part)
                });
                told.sum::<f64>()
            });
        });
    }
}

criterion_group!(benches, environments, tables, shapes);
criterion_main!(benches);
