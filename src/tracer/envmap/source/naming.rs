//! How downloads name the faces of a cube.

use crate::envmap::Face;

/// A naming scheme of faces. A download uses one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// `posx`, `neg_y`, `positive-z`, `xpos`, `x_plus`
    PositiveNegative,
    /// `px`, `ny`, `mx`, `xp`
    Letters,
    /// `+x`, `y-`
    Signs,
    /// `right`, `top`, `front`
    Words,
    /// `rt`, `up`, `ft`
    Quake,
    /// `r`, `u`, `f`
    Initials,
    /// `east`, `up`, `north`
    Compass,
    /// `e`, `u`, `n`
    CompassInitials,
    German,
    Czech,
    French,
    Spanish,
    Italian,
    Portuguese,
}

impl Family {
    /// True for single letters: some of six names have one of them by chance, a.png to f.png say.
    pub fn is_of_initials(self) -> bool {
        matches!(self, Self::Initials | Self::CompassInitials)
    }
}

/// Every spelling of the six faces, in the order +X -X +Y -Y +Z -Z.
///
/// This is the naming only. Words are put on axes as most OpenGL tools do it: right is +X, front is +Z (some engines call -Z
/// the front, Unity +X the left); Quake's names after them, and a compass whose north is the front. Whether the pictures fit
/// so is for the lookup and the validator to say.
#[rustfmt::skip]
const SPELLINGS: &[(Family, [&str; 6])] = &[
    (Family::PositiveNegative, ["posx", "negx", "posy", "negy", "posz", "negz"]),
    (Family::PositiveNegative, ["pos_x", "neg_x", "pos_y", "neg_y", "pos_z", "neg_z"]),
    (Family::PositiveNegative, ["pos-x", "neg-x", "pos-y", "neg-y", "pos-z", "neg-z"]),
    (Family::PositiveNegative, ["positivex", "negativex", "positivey", "negativey", "positivez", "negativez"]),
    (Family::PositiveNegative, ["positive_x", "negative_x", "positive_y", "negative_y", "positive_z", "negative_z"]),
    (Family::PositiveNegative, ["positive-x", "negative-x", "positive-y", "negative-y", "positive-z", "negative-z"]),
    (Family::PositiveNegative, ["xpos", "xneg", "ypos", "yneg", "zpos", "zneg"]),
    (Family::PositiveNegative, ["x_pos", "x_neg", "y_pos", "y_neg", "z_pos", "z_neg"]),
    (Family::PositiveNegative, ["x-pos", "x-neg", "y-pos", "y-neg", "z-pos", "z-neg"]),
    (Family::PositiveNegative, ["xplus", "xminus", "yplus", "yminus", "zplus", "zminus"]),
    (Family::PositiveNegative, ["x_plus", "x_minus", "y_plus", "y_minus", "z_plus", "z_minus"]),
    (Family::PositiveNegative, ["x-plus", "x-minus", "y-plus", "y-minus", "z-plus", "z-minus"]),
    (Family::PositiveNegative, ["plusx", "minusx", "plusy", "minusy", "plusz", "minusz"]),
    (Family::PositiveNegative, ["plus_x", "minus_x", "plus_y", "minus_y", "plus_z", "minus_z"]),
    (Family::PositiveNegative, ["plus-x", "minus-x", "plus-y", "minus-y", "plus-z", "minus-z"]),
    (Family::Letters, ["px", "nx", "py", "ny", "pz", "nz"]),
    (Family::Letters, ["px", "mx", "py", "my", "pz", "mz"]),
    (Family::Letters, ["xp", "xn", "yp", "yn", "zp", "zn"]),
    (Family::Letters, ["xp", "xm", "yp", "ym", "zp", "zm"]),
    (Family::Signs, ["+x", "-x", "+y", "-y", "+z", "-z"]),
    (Family::Signs, ["x+", "x-", "y+", "y-", "z+", "z-"]),
    (Family::Words, ["right", "left", "top", "bottom", "front", "back"]),
    (Family::Words, ["right", "left", "up", "down", "forward", "backward"]),
    (Family::Words, ["right", "left", "ceiling", "floor", "front", "rear"]),
    (Family::Words, ["right", "left", "ceil", "bot", "fwd", "bwd"]),
    (Family::Words, ["right", "left", "zenith", "nadir", "ahead", "behind"]),
    (Family::Words, ["right", "left", "above", "below", "front", "back"]),
    (Family::Quake, ["rt", "lf", "up", "dn", "ft", "bk"]),
    (Family::Quake, ["rt", "lf", "up", "dn", "fr", "bk"]),
    (Family::Quake, ["rt", "lt", "up", "dn", "fd", "bk"]),
    (Family::Initials, ["r", "l", "u", "d", "f", "b"]),
    (Family::Compass, ["east", "west", "up", "down", "north", "south"]),
    (Family::Compass, ["east", "west", "top", "bottom", "north", "south"]),
    (Family::Compass, ["east", "west", "zenith", "nadir", "north", "south"]),
    (Family::Compass, ["est", "ouest", "haut", "bas", "nord", "sud"]),
    (Family::Compass, ["ost", "west", "oben", "unten", "nord", "süd"]),
    (Family::CompassInitials, ["e", "w", "u", "d", "n", "s"]),
    (Family::CompassInitials, ["e", "w", "t", "b", "n", "s"]),
    (Family::German, ["rechts", "links", "oben", "unten", "vorne", "hinten"]),
    (Family::German, ["rechts", "links", "decke", "boden", "vorn", "hinten"]),
    (Family::Czech, ["vpravo", "vlevo", "nahoře", "dole", "vpředu", "vzadu"]),
    (Family::Czech, ["vpravo", "vlevo", "nahore", "dole", "vpredu", "vzadu"]),
    (Family::Czech, ["pravá", "levá", "horní", "dolní", "přední", "zadní"]),
    (Family::Czech, ["prava", "leva", "horni", "dolni", "predni", "zadni"]),
    (Family::Czech, ["vpravo", "vlevo", "strop", "podlaha", "vpředu", "vzadu"]),
    (Family::French, ["droite", "gauche", "haut", "bas", "devant", "derrière"]),
    (Family::French, ["droite", "gauche", "dessus", "dessous", "avant", "derriere"]),
    (Family::French, ["droite", "gauche", "plafond", "sol", "avant", "arrière"]),
    (Family::French, ["droite", "gauche", "haut", "bas", "avant", "arriere"]),
    (Family::Spanish, ["derecha", "izquierda", "arriba", "abajo", "delante", "detrás"]),
    (Family::Spanish, ["derecha", "izquierda", "techo", "suelo", "frente", "detras"]),
    (Family::Spanish, ["derecha", "izquierda", "arriba", "abajo", "frente", "atrás"]),
    (Family::Spanish, ["derecha", "izquierda", "arriba", "abajo", "frente", "atras"]),
    (Family::Italian, ["destra", "sinistra", "sopra", "sotto", "davanti", "dietro"]),
    (Family::Portuguese, ["direita", "esquerda", "cima", "baixo", "frente", "trás"]),
    (Family::Portuguese, ["direita", "esquerda", "cima", "baixo", "frente", "tras"]),
];

/// One reading of a file name as the name of a face.
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

/// All readings of a file name (without directories) as the name of a face, in the order of the table.
pub(super) fn readings(file_name: &str) -> Vec<Reading> {
    let original = &without_marks(stem(file_name));
    // Letters of the same length in both cases, so that places in one are places in the other.
    let lower = Some(original.to_lowercase()).filter(|lower| lower.len() == original.len());
    let lower = lower.unwrap_or_else(|| original.to_ascii_lowercase());
    let mut readings = Vec::new();
    for &(family, names) in SPELLINGS {
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

/// A name without combining accents: macOS writes `nahoře` as `nahore` and a caron after the r. The plain spelling is known.
fn without_marks(name: &str) -> String {
    name.chars().filter(|letter| !('\u{300}'..='\u{36f}').contains(letter)).collect()
}

/// The last number in a file name, with what stands before and after it: `sky_`, 03, `` of `sky_03.png`.
pub(super) fn number(file_name: &str) -> Option<(&str, u32, &str)> {
    let stem = stem(file_name);
    let end = stem.rfind(|letter: char| letter.is_ascii_digit())? + 1;
    let start = stem[..end]
        .rfind(|letter: char| !letter.is_ascii_digit())
        .map_or(0, |before| before + stem[before..].chars().next().map_or(0, char::len_utf8));
    Some((&stem[..start], stem[start..end].parse().ok()?, &stem[end..]))
}

/// Where the six faces stand in a numbering that is documented for names with this prefix: `panorama_0` to `panorama_5` of
/// Minecraft are front, right, back, left, up, down; `_c00` to `_c05` of CubeMapGen +X -X +Y -Y +Z -Z.
pub(super) fn numbered_order(prefix: &str) -> Option<[usize; 6]> {
    let prefix = prefix.to_ascii_lowercase();
    match () {
        () if prefix.ends_with("panorama_") => Some([1, 3, 4, 5, 0, 2]),
        () if prefix.ends_with("_c") => Some([0, 1, 2, 3, 4, 5]),
        () => None,
    }
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
    fn reads_names_with_combining_accents() {
        for (name, face) in
            [("nahor\u{30c}e.png", "posy"), ("zadni\u{301}.png", "negz"), ("derrie\u{300}re.png", "negz")]
        {
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
        for &(family, names) in SPELLINGS {
            for (face, name) in Face::ALL.into_iter().zip(names) {
                for name in [name.to_string(), name.to_uppercase()] {
                    let found = readings(&format!("sky_{name}.png"));
                    assert!(found.iter().any(|reading| (reading.family, reading.face) == (family, face)), "{name}");
                }
            }
        }
    }
}
