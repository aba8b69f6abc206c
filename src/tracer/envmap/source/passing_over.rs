//! Files of a download to ignore: they are not faces, despite their names.

use super::naming::extension;

/// Extensions of the picture formats that are read.
const READABLE: [&str; 17] = [
    "jpg", "jpeg", "jpe", "jfif", "png", "tga", "bmp", "dib", "webp", "tif", "tiff", "hdr", "rgbe", "pic", "exr",
    "vda", "icb",
];

/// Extensions of files that hold no picture.
const NO_PICTURE: [&str; 31] = [
    "txt", "md", "html", "htm", "url", "ini", "db", "json", "xml", "pdf", "doc", "docx", "rtf", "zip", "7z", "rar",
    "gz", "mtl", "mat", "material", "shader", "cfg", "toml", "yaml", "yml", "meta", "csv", "log", "sha256", "md5",
    "bat",
];

/// Words in the names of small pictures shown beside a download, and of its papers.
const NO_FACE: [&str; 12] = [
    "thumb",
    "thumbs",
    "thumbnail",
    "thumbnails",
    "preview",
    "previews",
    "screenshot",
    "readme",
    "license",
    "licence",
    "copying",
    "credits",
];

/// True if the path of a file inside a folder or archive (parts separated by `/`) cannot be a face: hidden files, what
/// macOS adds to archives, texts, thumbnails.
pub fn is_passed_over(path: &str) -> bool {
    let hidden = path.split('/').any(|part| part.starts_with('.') || part == "__MACOSX");
    let file_name = path.rsplit('/').next().unwrap_or(path);
    hidden || NO_PICTURE.contains(&extension(file_name).as_str()) || has_word_of_no_face(file_name)
}

fn has_word_of_no_face(file_name: &str) -> bool {
    let lower = file_name.to_ascii_lowercase();
    lower.split(|letter: char| !letter.is_ascii_alphabetic()).any(|word| NO_FACE.contains(&word))
}

/// True if the extension is that of a picture format that is read.
pub(super) fn is_readable_format(file_name: &str) -> bool {
    READABLE.contains(&extension(file_name).as_str())
}

/// The paths that are not among the given ones, sorted.
pub(super) fn all_but(paths: &[String], used: &[usize]) -> Vec<String> {
    let others = paths.iter().enumerate().filter(|(index, _)| !used.contains(index));
    let mut others: Vec<String> = others.map(|(_, path)| path.clone()).collect();
    others.sort_unstable();
    others.dedup();
    others
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_over_what_is_no_face() {
        for path in [
            "readme.txt",
            ".DS_Store",
            "Thumbs.db",
            "__MACOSX/._posx.jpg",
            "Sky/._posx.jpg",
            "posx_thumb.jpg",
            "LICENSE",
            "front-preview.png",
            "posx.html",
        ] {
            assert!(is_passed_over(path), "{path}");
        }
        for path in ["posx.jpg", "Sky/posx", "thumbelina_px.png"] {
            assert!(!is_passed_over(path), "{path}");
        }
    }
}
