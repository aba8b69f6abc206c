//! The page of `skycube view`, in headless Chromium: its lookup is the tracer's, its buttons work, and it says no error.
//! Skipped where there is no Chromium.

mod common;

use std::path::Path;
use std::process::Command;

use skycube::colour::encode_srgb8;
use skycube::envmap::source::Skybox;
use skycube::envmap::{CubeFilter, CubeMap, Preset};
use skycube::math::Vec3;
use skycube::picture;
use tempfile::TempDir;

/// Added to the page: collects what goes wrong, then tells what it does, as lines in an element that `--dump-dom` prints.
const COLLECT: &str =
    "<script>const faults = []; window.onerror = (text) => faults.push(text); console.error = window.onerror;</script>";
const REPORT: &str = include_str!("view_page/report.js");

/// The page as Chromium leaves it, or `None` where there is no Chromium.
fn dumped(page: &Path, folder: &Path) -> Option<String> {
    let mut command = Command::new("chromium");
    command.args(["--headless", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking"]);
    command.args(["--disable-component-update", "--disable-sync", "--use-angle=swiftshader"]);
    command.args([
        "--enable-unsafe-swiftshader",
        "--window-size=1000,900",
        "--virtual-time-budget=60000",
        "--dump-dom",
    ]);
    command.arg(format!("--user-data-dir={}", folder.join("profile").display()));
    let output = command.arg(format!("file://{}", page.display())).output().ok()?;
    Some(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// The lines of the report in a page.
fn lines(page: &str) -> Vec<String> {
    let start = page.find("<pre id=\"report\">").unwrap_or_else(|| panic!("the page did not report: {page:.2000}"));
    let report = &page[start + "<pre id=\"report\">".len()..];
    let report = &report[..report.find("</pre>").expect("the element ends")];
    report.lines().map(|line| line.replace("&gt;", ">").replace("&amp;", "&")).collect()
}

/// The hall with one face turned.
fn hall_with_a_turned_face(folder: &Path) {
    let hall = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/hall");
    for file in std::fs::read_dir(hall).expect("the hall is there").flatten() {
        std::fs::copy(file.path(), folder.join(file.file_name())).expect("it can be copied");
    }
    let path = folder.join("negx.png");
    let picture = picture::read(&path).expect("it is a picture");
    let last = picture.width() - 1;
    let (turned, _) = picture.rearranged(|x, y| (last - y, x)).encode_lossless().expect("it can be encoded");
    std::fs::write(&path, turned).expect("it can be written");
}

#[test]
fn the_page_looks_up_as_the_tracer_does() {
    let folder = TempDir::new().unwrap();
    let map = folder.path().join("map");
    std::fs::create_dir(&map).unwrap();
    hall_with_a_turned_face(&map);
    let page = folder.path().join("page.html");
    let (code, _, said) = common::outcome(folder.path(), &["view", "map", "--world-up", "+y", "-o", "page.html"]);
    assert_eq!(code, Some(0), "{said}");
    let text = std::fs::read_to_string(&page).unwrap();
    assert!(text.len() < 4_000_000 && !text.contains("http://") && !text.contains("https://"));
    // What to do is said without scripts.
    assert!(text.contains("turn 90° clockwise"), "{text:.3000}");
    let watched = text.replacen("<body>", &format!("<body>{COLLECT}"), 1);
    std::fs::write(&page, watched.replace("</body>", &format!("<script>{REPORT}</script></body>"))).unwrap();
    let Some(dumped) = dumped(&page, folder.path()) else {
        println!("skipped: there is no chromium");
        return;
    };
    let lines = lines(&dumped);
    let skybox = Skybox::open(&map).unwrap();
    let given = CubeMap::from_skybox(&skybox, Preset::Opengl.lookup(), CubeFilter::Bilinear);
    let mut worst = 0;
    for line in &lines[..1000] {
        let numbers: Vec<f64> = line.split(' ').map(|number| number.parse().unwrap()).collect();
        let direction = Vec3::new(numbers[0] as f32, numbers[1] as f32, numbers[2] as f32);
        for (&said, light) in numbers[3..].iter().zip(given.sample(direction).to_array()) {
            worst = worst.max((said as i32 - i32::from(encode_srgb8(light))).abs());
        }
    }
    assert!(worst <= 1, "a colour differs by {worst}");
    // The repaired table is another one: it must not look the same.
    assert_ne!(lines[..1000], lines[1000..2000]);
    let of = |key: &str| lines.iter().filter_map(|line| line.strip_prefix(key)).next_back().unwrap().trim().to_owned();
    assert!(of("canvas ").parse::<u32>().unwrap() <= 1, "{}", of("canvas "));
    assert!(of("found ").starts_with("Seam -x") && of("found ").contains("turn 90°"), "{}", of("found "));
    assert_eq!(of("table "), "after");
    assert!(of("probe ").contains("is the largest"));
    assert_eq!(of("faults"), "");
}
