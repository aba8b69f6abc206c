//! How downloads name the faces of a cube.

use crate::envmap::Face;

/// A way of naming faces. A download keeps to one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// `posx`, `neg_y`, `positive-z`, `xpos`
    PositiveNegative,
    /// `px`, `ny`
    Letters,
    /// `+x`, `y-`
    Signs,
    /// `right`, `top`, `front`
    Words,
    /// `rt`, `up`, `ft`
    Quake,
}

/// Every spelling of the six faces, in the order +X -X +Y -Y +Z -Z.
///
/// This is the naming only. Words are laid on axes as OpenGL tools do it, and Quake's names after them (rt = +X,
/// ft = +Z); whether the pictures fit so is for the lookup and the validator to say.
#[rustfmt::skip]
const SPELLINGS: [(Family, [&str; 6]); 14] = [
    (Family::PositiveNegative, ["posx", "negx", "posy", "negy", "posz", "negz"]),
    (Family::PositiveNegative, ["pos_x", "neg_x", "pos_y", "neg_y", "pos_z", "neg_z"]),
    (Family::PositiveNegative, ["pos-x", "neg-x", "pos-y", "neg-y", "pos-z", "neg-z"]),
    (Family::PositiveNegative, ["positivex", "negativex", "positivey", "negativey", "positivez", "negativez"]),
    (Family::PositiveNegative, ["positive_x", "negative_x", "positive_y", "negative_y", "positive_z", "negative_z"]),
    (Family::PositiveNegative, ["positive-x", "negative-x", "positive-y", "negative-y", "positive-z", "negative-z"]),
    (Family::PositiveNegative, ["xpos", "xneg", "ypos", "yneg", "zpos", "zneg"]),
    (Family::PositiveNegative, ["x_pos", "x_neg", "y_pos", "y_neg", "z_pos", "z_neg"]),
    (Family::Letters, ["px", "nx", "py", "ny", "pz", "nz"]),
    (Family::Signs, ["+x", "-x", "+y", "-y", "+z", "-z"]),
    (Family::Signs, ["x+", "x-", "y+", "y-", "z+", "z-"]),
    (Family::Words, ["right", "left", "top", "bottom", "front", "back"]),
    (Family::Words, ["right", "left", "up", "down", "front", "back"]),
    (Family::Quake, ["rt", "lf", "up", "dn", "ft", "bk"]),
];

/// One way to read a file name as that of a face.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Reading {
    pub family: Family,
    pub face: Face,
    /// What stands before and after the face's name, in lower case, without the file extension.
    pub prefix: String,
    pub suffix: String,
    /// True if the face's name stands by itself, as in `sky_ft`; false if it is run together, as in `desertft`.
    pub separate: bool,
}

/// Every way to read a file name (without directories) as that of a face, in the order of the table.
pub(super) fn readings(file_name: &str) -> Vec<Reading> {
    let original = stem(file_name);
    let lower = original.to_ascii_lowercase();
    let mut readings = Vec::new();
    for (family, names) in SPELLINGS {
        for (face, name) in Face::ALL.into_iter().zip(names) {
            for (start, _) in lower.match_indices(name) {
                let end = start + name.len();
                let separate = is_boundary(original, start) && is_boundary(original, end);
                let (prefix, suffix) = (lower[..start].to_owned(), lower[end..].to_owned());
                let reading = Reading { family, face, prefix, suffix, separate };
                if !readings.contains(&reading) {
                    readings.push(reading);
                }
            }
        }
    }
    readings
}

/// The file name without its extension. A name that starts with its only dot has none.
fn stem(file_name: &str) -> &str {
    match file_name.rfind('.') {
        Some(dot) if dot > 0 => &file_name[..dot],
        _ => file_name,
    }
}

/// The extension of a file name in lower case, empty if there is none.
pub(super) fn extension(file_name: &str) -> String {
    file_name[stem(file_name).len()..].trim_start_matches('.').to_ascii_lowercase()
}

/// True if a word may begin or end at this byte of the name: at its ends, beside anything but a letter or digit, at the
/// border of letters and digits (`sky01ft`), and where a small letter is followed by a capital (`skyFront`).
fn is_boundary(name: &str, position: usize) -> bool {
    let (Some(before), Some(after)) = (name[..position].chars().next_back(), name[position..].chars().next()) else {
        return true;
    };
    let word = |letter: char| letter.is_alphanumeric();
    !word(before)
        || !word(after)
        || before.is_ascii_digit() != after.is_ascii_digit()
        || (before.is_lowercase() && after.is_uppercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The faces a name stands for by itself.
    fn faces(name: &str) -> Vec<&'static str> {
        readings(name).into_iter().filter(|reading| reading.separate).map(|reading| reading.face.name()).collect()
    }

    #[test]
    fn reads_names_with_prefix_suffix_and_any_case() {
        let cases = [
            ("posx.jpg", "posx"),
            ("sky-NEGZ.large.PNG", "negz"),
            ("Positive_X.jpeg", "posx"),
            ("ypos", "posy"),
            ("studio_garden_ny.jpg", "negy"),
            ("+x.jpg", "posx"),
            ("-z.jpg", "negz"),
            ("cube_y-.png", "negy"),
            ("storm+x.png", "posx"),
            ("skyboxBack.png", "negz"),
            ("Sky 01 (left).webp", "negx"),
            ("miramar_dn.tga", "negy"),
            ("sky12ft.bmp", "posz"),
            ("ft.jpg", "posz"),
        ];
        for (name, face) in cases {
            assert_eq!(faces(name), [face], "{name}");
        }
    }

    #[test]
    fn does_not_read_parts_of_words() {
        for name in ["update.jpg", "stop.png", "leftover.png", "soft.jpg", "readme.txt", "spx.png", ".png"] {
            assert_eq!(faces(name), [""; 0], "{name}");
        }
    }

    #[test]
    fn every_spelling_is_read_as_its_face() {
        for (family, names) in SPELLINGS {
            for (face, name) in Face::ALL.into_iter().zip(names) {
                let found = readings(&format!("sky_{name}.png"));
                assert!(found.iter().any(|reading| (reading.family, reading.face) == (family, face)), "{name}");
            }
        }
    }
}
