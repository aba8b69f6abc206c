//! Zip archives as downloaded, and damaged ones.

use std::fs;
use std::io::{Cursor, Write};

use tempfile::TempDir;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::*;

fn zip_bytes(entries: &[(String, Vec<u8>)]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries {
        writer.start_file(name.as_str(), SimpleFileOptions::default()).unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// A folder with the archive `sky.zip`.
fn zip_file(bytes: &[u8]) -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("sky.zip"), bytes).unwrap();
    folder
}

/// The entries of a set of six in a folder of an archive.
fn six_entries(folder: &str) -> Vec<(String, Vec<u8>)> {
    NAMES.iter().enumerate().map(|(index, name)| (format!("{folder}{name}"), plain(4, 4, index))).collect()
}

fn zip_of(entries: &[(String, Vec<u8>)]) -> TempDir {
    zip_file(&zip_bytes(entries))
}

#[test]
fn an_archive_opens_in_place() {
    let mut entries = six_entries("Sky/");
    entries.push(("__MACOSX/Sky/._posx.png".to_owned(), vec![0; 8]));
    entries.push(("Sky/readme.txt".to_owned(), b"by nobody".to_vec()));
    let folder = zip_of(&entries);
    let skybox = Skybox::open(&folder.path().join("sky.zip")).unwrap();
    assert_eq!(skybox.images[5].name(), "sky.zip/Sky/negz.png");
    assert_eq!(first_texels(&skybox), [0, 1, 2, 3, 4, 5].map(paint));
    assert_eq!(skybox.images[2].encoded_bytes().unwrap(), Some(plain(4, 4, 2)));
    assert_eq!(skybox.passed_over, ["Sky/readme.txt", "__MACOSX/Sky/._posx.png"]);
}

#[test]
fn a_set_of_an_archive_is_chosen_by_the_prefix_of_its_files() {
    let folder = zip_of(&[six_entries("day_"), six_entries("night_")].concat());
    for chosen in ["sky.zip/night", "sky.zip/night_"] {
        let skybox = Skybox::open(&folder.path().join(chosen)).unwrap();
        assert_eq!(skybox.images[0].name(), "sky.zip/night_posx.png");
    }
    assert!(error_at(&folder, "sky.zip").contains("2 complete sets of six faces"));
    assert!(error_at(&folder, "sky.zip/noon").contains("the archive has no folder noon"));
}

#[test]
fn a_subfolder_of_an_archive_is_named_after_a_slash() {
    let folder = zip_of(&[six_entries("Day/"), six_entries("Night/")].concat());
    insta::assert_snapshot!(error_at(&folder, "sky.zip"), @r"
        [folder]/sky.zip: 2 subfolders hold six faces each
          Day
          Night
          expected: one set of six faces
          help: name the subfolder after a slash, as in .../Day
        ");
    let skybox = Skybox::open(&folder.path().join("sky.zip/Night")).unwrap();
    assert_eq!(skybox.images[0].name(), "sky.zip/Night/posx.png");
    insta::assert_snapshot!(error_at(&folder, "sky.zip/Noon"), @r"
        [folder]/sky.zip: the archive has no folder Noon
        ");
}

#[test]
fn damaged_archives_are_refused() {
    insta::assert_snapshot!(error_at(&zip_file(b"PK but no archive"), "sky.zip"), @r"
        [folder]/sky.zip: invalid Zip archive: Could not find EOCD
          help: the archive is damaged or incomplete; download it again
        ");
    let whole = zip_bytes(&six_entries(""));
    for length in (0..whole.len()).step_by(37) {
        let error = error_at(&zip_file(&whole[..length]), "sky.zip");
        assert!(error.starts_with("[folder]/sky.zip"), "{length}: {error}");
    }
}

#[test]
fn a_byte_changed_in_an_archive_never_yields_another_picture() {
    let whole = zip_bytes(&six_entries(""));
    for place in 0..whole.len() {
        let mut damaged = whole.clone();
        damaged[place] ^= 0xff;
        let folder = zip_file(&damaged);
        let Ok(skybox) = Skybox::open_lenient(&folder.path().join("sky.zip")) else { continue };
        for (index, image) in skybox.images.iter().enumerate() {
            let Ok(bytes) = image.encoded_bytes() else { continue };
            assert_eq!(bytes, Some(plain(4, 4, index)), "byte {place}");
        }
    }
}

#[test]
fn an_entry_with_a_wrong_checksum_is_refused() {
    let mut entries = six_entries("");
    entries.truncate(5);
    let marked = [b"MARK".as_slice(), &[0; 64]].concat();
    let options = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries.iter().map(|(name, bytes)| (name.as_str(), bytes)).chain([("negz.png", &marked)]) {
        writer.start_file(name, options).unwrap();
        writer.write_all(bytes).unwrap();
    }
    let mut bytes = writer.finish().unwrap().into_inner();
    let place = bytes.windows(4).position(|window| window == b"MARK").unwrap();
    bytes[place] = b'B';
    insta::assert_snapshot!(error_at(&zip_file(&bytes), "sky.zip"), @r"
        [folder]/sky.zip/negz.png: cannot be unpacked: Invalid checksum
          help: the archive is damaged or incomplete; download it again
        ");
}

#[test]
fn an_encrypted_archive_says_so() {
    let mut bytes = zip_bytes(&six_entries(""));
    // The lowest bit of the general flags, in the local headers and the central directory.
    for (signature, flags) in [(b"PK\x03\x04", 6), (b"PK\x01\x02", 8)] {
        let places: Vec<usize> = (0..bytes.len() - 4).filter(|&at| bytes[at..].starts_with(signature)).collect();
        places.into_iter().for_each(|at| bytes[at + flags] |= 1);
    }
    let error = error_at(&zip_file(&bytes), "sky.zip");
    assert_eq!(error.matches("is encrypted").count(), 6, "{error}");
}

#[test]
fn an_entry_that_would_fill_the_memory_is_refused() {
    let mut bytes = zip_bytes(&six_entries(""));
    // The unpacked size in every central directory entry.
    let places: Vec<usize> = (0..bytes.len() - 4).filter(|&at| bytes[at..].starts_with(b"PK\x01\x02")).collect();
    places.into_iter().for_each(|at| bytes[at + 24..at + 28].copy_from_slice(&0x7fff_ffff_u32.to_le_bytes()));
    let error = error_at(&zip_file(&bytes), "sky.zip");
    assert_eq!(error.matches("would be 2147483647 bytes unpacked").count(), 6, "{error}");
}

#[test]
fn archives_written_with_backslashes_open() {
    let mut entries = six_entries("Sky\\");
    entries.push(("Sky\\readme.txt".to_owned(), Vec::new()));
    let folder = zip_of(&entries);
    let skybox = Skybox::open(&folder.path().join("sky.zip")).unwrap();
    assert_eq!(skybox.images[0].name(), "sky.zip/Sky/posx.png");
    assert_eq!(first_texels(&skybox), [0, 1, 2, 3, 4, 5].map(paint));
}
