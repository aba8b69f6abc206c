//! Files that are not pictures: the error says what they are, however they are named.

use std::path::Path;

use crate::picture::{decode, read, read_header};

fn refused(bytes: &[u8]) -> String {
    let name = Path::new("posx.jpg");
    let error = decode(bytes, name).unwrap_err();
    assert_eq!(read_header(bytes, name).unwrap_err(), error);
    error.to_string()
}

#[test]
fn say_what_they_are() {
    insta::assert_snapshot!(refused(b"\n<!DOCTYPE html><html><head><title>404"), @r"
    posx.jpg: this is a web page (HTML), not a picture
      expected: a JPEG, PNG, TGA, BMP, WebP, TIFF, HDR, OpenEXR or PPM picture
      help: the link led to a page about the file; open it in a browser and download the picture itself
    ");
    insta::assert_snapshot!(refused(b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a2146\nsize 12345\n"), @r"
    posx.jpg: this is a git-lfs pointer, not the picture itself
      expected: a JPEG, PNG, TGA, BMP, WebP, TIFF, HDR, OpenEXR or PPM picture
      help: run `git lfs pull` in the repository it came from, then copy the file again
    ");
    insta::assert_snapshot!(refused(b""), @r"
    posx.jpg: the file is empty
      expected: a JPEG, PNG, TGA, BMP, WebP, TIFF, HDR, OpenEXR or PPM picture
      help: write it again if your own program did, otherwise download it again
    ");
    assert!(refused(&[0; 1000]).contains("only zero bytes"));
    assert!(refused(b"PK\x03\x04....").contains("zip archive"));
    assert!(refused(b"GIF89a").contains("GIF"));
    assert!(refused(b"Hello, this is the readme.").contains("text file"));
    assert!(refused(&[7, 200, 3, 0, 99]).contains("unknown picture format"));
}

#[test]
fn missing_files_and_folders_are_named() {
    let folder = tempfile::tempdir().unwrap();
    assert!(read(&folder.path().join("none.png")).unwrap_err().problem().contains("does not exist"));
    assert!(read(folder.path()).unwrap_err().problem().contains("folder"));
}
