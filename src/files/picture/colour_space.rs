//! The colour space of a file: a curve for each channel and a matrix.

use glam::{DMat3, DVec3};
use moxcms::{ColorProfile, DataColorSpace};

/// How samples become linear light with the primaries of Rec. 709.
#[derive(Debug, Clone, PartialEq)]
pub struct ColourSpace {
    /// Linear light of each code, for red, green and blue; `None` if the samples are linear.
    pub curves: Option<[Vec<f32>; 3]>,
    /// Rows for red, green and blue of Rec. 709.
    pub matrix: [[f32; 3]; 3],
}

/// A colour space, `None` for the usual one of the format; or a note on what is ignored.
pub type Found = Result<Option<ColourSpace>, String>;

/// Chromaticities x, y of red, green, blue and white.
pub type Primaries = [[f64; 2]; 4];

pub const REC_709: Primaries = [[0.64, 0.33], [0.3, 0.6], [0.15, 0.06], [0.3127, 0.329]];

/// Matrices this near to the identity stand for Rec. 709: files round its numbers differently.
const SAME_COLOUR: f64 = 0.01;

/// The usual curve is kept where no 8-bit code differs by more.
const SAME_CODE: f64 = 1.0 / 255.0;

impl ColourSpace {
    /// Samples with other primaries and a curve that gives linear light; `None` where that is sRGB.
    fn with_curve(matrix: DMat3, codes: usize, curve: impl Fn(f64) -> f64) -> Option<Self> {
        let code = |code: usize| code as f64 / (codes - 1) as f64;
        let usual = (0..256).all(|step| {
            let code = f64::from(step) / 255.0;
            (encode_srgb(curve(code)) - code).abs() <= SAME_CODE
        });
        if usual && is_identity(matrix) {
            return None;
        }
        let table: Vec<f32> = (0..codes).map(|step| curve(code(step)) as f32).collect();
        Some(Self { curves: Some([table.clone(), table.clone(), table]), matrix: rows(matrix) })
    }

    /// Linear samples; `None` where they are those of Rec. 709.
    pub fn linear(primaries: Primaries, factor: f64) -> Found {
        let matrix = factor * to_rec_709(primaries).ok_or("its primaries are not valid colours: they are ignored")?;
        Ok((!is_identity(matrix)).then(|| Self { curves: None, matrix: rows(matrix) }))
    }

    /// From an ICC profile, for samples of this number of codes.
    pub fn of_profile(profile: &[u8], codes: usize, grey: bool) -> Found {
        let unread = |why: &str| Err(format!("its colour profile is ignored ({why}): it is read as sRGB"));
        let Ok(profile) = ColorProfile::new_from_slice(profile) else { return unread("it cannot be read") };
        let tables = |curves: [Option<Vec<f32>>; 3]| match curves {
            [Some(red), Some(green), Some(blue)] => Some([red, green, blue]),
            _ => None,
        };
        let (curves, matrix) = match profile.color_space {
            DataColorSpace::Gray if grey => {
                let curve = table(codes, |wide| match wide {
                    false => profile.build_gray_linearize_table::<u8, 256, 8>().ok().map(|table| table.to_vec()),
                    true => profile.build_gray_linearize_table::<u16, 65536, 16>().ok().map(|table| table.to_vec()),
                });
                (tables([curve.clone(), curve.clone(), curve]), DMat3::IDENTITY)
            }
            // Where a profile has tables, too, curves and matrix say the same more coarsely.
            DataColorSpace::Rgb if !grey && profile.red_trc.is_some() => {
                let curves = [
                    table(codes, |wide| match wide {
                        false => profile.build_r_linearize_table::<u8, 256, 8>(true).ok().map(|table| table.to_vec()),
                        true => {
                            profile.build_r_linearize_table::<u16, 65536, 16>(true).ok().map(|table| table.to_vec())
                        }
                    }),
                    table(codes, |wide| match wide {
                        false => profile.build_g_linearize_table::<u8, 256, 8>(true).ok().map(|table| table.to_vec()),
                        true => {
                            profile.build_g_linearize_table::<u16, 65536, 16>(true).ok().map(|table| table.to_vec())
                        }
                    }),
                    table(codes, |wide| match wide {
                        false => profile.build_b_linearize_table::<u8, 256, 8>(true).ok().map(|table| table.to_vec()),
                        true => {
                            profile.build_b_linearize_table::<u16, 65536, 16>(true).ok().map(|table| table.to_vec())
                        }
                    }),
                ];
                let matrix = profile.transform_matrix(&ColorProfile::new_srgb()).v;
                (tables(curves), DMat3::from_cols_array_2d(&matrix).transpose())
            }
            DataColorSpace::Rgb if !grey => return unread("it consists of tables"),
            _ => return unread("it describes other channels than those of the picture"),
        };
        let Some(curves) = curves else { return unread("it has no curves") };
        let usual = |curve: &Vec<f32>| {
            let last = (codes - 1) as f64;
            let same =
                |(code, &value): (usize, &f32)| (encode_srgb(f64::from(value)) - code as f64 / last).abs() <= SAME_CODE;
            curve.iter().enumerate().step_by((codes / 256).max(1)).all(same)
        };
        let known = is_identity(matrix) && curves.iter().all(usual);
        Ok((!known).then(|| Self { curves: Some(curves), matrix: rows(matrix) }))
    }

    /// From the chunks of a PNG file but the profile: `cICP`, `sRGB`, or `gAMA` and `cHRM`. `None` if none of them is there.
    pub fn of_png(encoded: &[u8], codes: usize) -> Option<Found> {
        let chunk = |kind: &[u8; 4]| png_chunk(encoded, kind);
        if let Some(&[primaries, curve, _, _]) = chunk(b"cICP").and_then(|data| data.first_chunk()) {
            return Some(of_code_points(primaries, curve, codes));
        }
        if chunk(b"sRGB").is_some() || chunk(b"iCCP").is_some() {
            return None;
        }
        let number = |bytes: &[u8; 4]| f64::from(u32::from_be_bytes(*bytes)) / 1e5;
        let gamma = chunk(b"gAMA").and_then(|data| data.first_chunk()).map(number).filter(|&gamma| gamma > 0.0);
        let primaries = chunk(b"cHRM").and_then(|data| {
            let mut numbers = data.as_chunks::<4>().0.iter().map(number);
            let mut pair = || Some([numbers.next()?, numbers.next()?]);
            let (white, red, green, blue) = (pair()?, pair()?, pair()?, pair()?);
            Some([red, green, blue, white])
        });
        if gamma.is_none() && primaries.is_none() {
            return None;
        }
        let Some(matrix) = to_rec_709(primaries.unwrap_or(REC_709)) else {
            return Some(Err("its primaries (cHRM) are not valid colours: they are ignored".to_owned()));
        };
        Some(Ok(match gamma {
            // 1 / 2.2 is what programs write for sRGB.
            Some(gamma) if (gamma - 0.45455).abs() > 0.005 => {
                Self::with_curve(matrix, codes, |code| code.powf(1.0 / gamma))
            }
            _ => Self::with_curve(matrix, codes, decode_srgb),
        }))
    }
}

/// A table for 8 or 16 bits.
fn table(codes: usize, build: impl Fn(bool) -> Option<Vec<f32>>) -> Option<Vec<f32>> {
    build(codes > 256)
}

/// The code points of ITU-T H.273 for primaries and curve.
fn of_code_points(primaries: u8, curve: u8, codes: usize) -> Found {
    let unread = |what: &str, code: u8| format!("its {what} (cICP {code}) is ignored: it is read as sRGB");
    let d65 = REC_709[3];
    let primaries = match primaries {
        1 => REC_709,
        5 => [[0.64, 0.33], [0.29, 0.6], [0.15, 0.06], d65],
        6 | 7 => [[0.63, 0.34], [0.31, 0.595], [0.155, 0.07], d65],
        9 => [[0.708, 0.292], [0.17, 0.797], [0.131, 0.046], d65],
        11 => [[0.68, 0.32], [0.265, 0.69], [0.15, 0.06], [0.314, 0.351]],
        12 => [[0.68, 0.32], [0.265, 0.69], [0.15, 0.06], d65],
        other => return Err(unread("choice of primaries", other)),
    };
    let matrix = to_rec_709(primaries).unwrap_or(DMat3::IDENTITY);
    Ok(match curve {
        4 => ColourSpace::with_curve(matrix, codes, |code| code.powf(2.2)),
        5 => ColourSpace::with_curve(matrix, codes, |code| code.powf(2.8)),
        8 => ColourSpace::with_curve(matrix, codes, |code| code),
        // The curves of television are those of cameras; screens show them as sRGB.
        1 | 6 | 13..=15 => ColourSpace::with_curve(matrix, codes, decode_srgb),
        16 => ColourSpace::with_curve(matrix, codes, perceptual_quantizer),
        other => return Err(unread("curve", other)),
    })
}

/// SMPTE ST 2084 in units of the white of paper, 203 cd/m^2 (ITU-R BT.2408).
fn perceptual_quantizer(code: f64) -> f64 {
    let power = code.powf(1.0 / 78.84375);
    let light = ((power - 0.835_937_5).max(0.0) / (18.851_562_5 - 18.6875 * power)).powf(1.0 / 0.159_301_757_812_5);
    light * 10_000.0 / 203.0
}

fn decode_srgb(code: f64) -> f64 {
    if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

fn encode_srgb(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

/// The content of a chunk before the pixels.
pub fn png_chunk<'a>(encoded: &'a [u8], wanted: &[u8; 4]) -> Option<&'a [u8]> {
    let mut rest = encoded.get(8..)?;
    while let Some((length, behind)) = rest.split_first_chunk::<4>() {
        let (kind, content) = behind.split_first_chunk::<4>()?;
        let length = u32::from_be_bytes(*length) as usize;
        if kind == wanted {
            return content.get(..length);
        }
        if kind == b"IDAT" {
            return None;
        }
        rest = content.get(length.checked_add(4)?..)?;
    }
    None
}

/// From linear light with these primaries to that of Rec. 709, with white kept white (Bradford's adaptation).
fn to_rec_709(primaries: Primaries) -> Option<DMat3> {
    let bradford = DMat3::from_cols_array(&[0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296]);
    let cones = |white| bradford * colour(white);
    let adaptation = bradford.inverse() * DMat3::from_diagonal(cones(REC_709[3]) / cones(primaries[3])) * bradford;
    let matrix = to_xyz(REC_709).inverse() * adaptation * to_xyz(primaries);
    let usable = matrix.is_finite() && matrix.to_cols_array().iter().all(|entry| entry.abs() < 100.0);
    usable.then_some(matrix)
}

/// The matrix from red, green and blue, which together are white, to X, Y and Z.
fn to_xyz(primaries: Primaries) -> DMat3 {
    let [red, green, blue, white] = primaries.map(colour);
    let unscaled = DMat3::from_cols(red, green, blue);
    unscaled * DMat3::from_diagonal(unscaled.inverse() * white)
}

/// X, Y and Z of a chromaticity, with Y = 1.
fn colour([x, y]: [f64; 2]) -> DVec3 {
    DVec3::new(x / y, 1.0, (1.0 - x - y) / y)
}

fn is_identity(matrix: DMat3) -> bool {
    (matrix - DMat3::IDENTITY).to_cols_array().iter().all(|entry| entry.abs() <= SAME_COLOUR)
}

fn rows(matrix: DMat3) -> [[f32; 3]; 3] {
    matrix.transpose().to_cols_array_2d().map(|row| row.map(|entry| entry as f32))
}

#[cfg(test)]
mod tests {
    use moxcms::{LutDataType, LutStore, LutType, LutWarehouse};

    use super::*;

    #[test]
    fn primaries_become_those_of_rec_709() {
        assert!(is_identity(to_rec_709(REC_709).unwrap()));
        // Display P3 (the published matrix has 1.2249, -0.2249, 0, -0.0420, 1.0420, 0, -0.0196, -0.0786, 1.0983).
        let p3 = to_rec_709([[0.68, 0.32], [0.265, 0.69], [0.15, 0.06], [0.3127, 0.329]]).unwrap();
        let published = [1.2249, -0.0420, -0.0196, -0.2249, 1.0420, -0.0786, 0.0, 0.0, 1.0983];
        assert!(p3.to_cols_array().iter().zip(published).all(|(a, b)| (a - b).abs() < 2e-4), "{p3}");
        // White stays white whatever its colour was.
        let aces = to_rec_709([[0.7347, 0.2653], [0.0, 1.0], [0.0001, -0.077], [0.32168, 0.33767]]).unwrap();
        assert!((aces * DVec3::ONE - DVec3::ONE).length() < 1e-9);
        assert!(to_rec_709([[0.3, 0.3]; 4]).is_none());
    }

    #[test]
    fn the_usual_space_needs_no_table() {
        assert_eq!(ColourSpace::with_curve(DMat3::IDENTITY, 256, decode_srgb), None);
        assert!(ColourSpace::with_curve(DMat3::IDENTITY, 256, |code| code.powf(1.8)).is_some());
        let srgb = ColorProfile::new_srgb().encode().unwrap();
        assert_eq!(ColourSpace::of_profile(&srgb, 256, false), Ok(None));
        let p3 = ColorProfile::new_display_p3().encode().unwrap();
        let space = ColourSpace::of_profile(&p3, 256, false).unwrap().unwrap();
        assert!((space.matrix[0][0] - 1.2249).abs() < 2e-3 && (space.matrix[0][1] + 0.2249).abs() < 2e-3, "{space:?}");
        let adobe = ColorProfile::new_adobe_rgb().encode().unwrap();
        let space = ColourSpace::of_profile(&adobe, 65536, false).unwrap().unwrap();
        let half = space.curves.unwrap()[0][32768];
        assert!((half - 0.5_f32.powf(2.2)).abs() < 1e-3, "{half}");
        assert!(ColourSpace::of_profile(b"no profile", 256, false).is_err());
    }

    #[test]
    fn profiles_of_tables_are_read_by_their_curves_or_named() {
        let table = LutDataType {
            num_input_channels: 3,
            num_output_channels: 3,
            num_clut_grid_points: 2,
            matrix: moxcms::Matrix3d::IDENTITY,
            num_input_table_entries: 256,
            num_output_table_entries: 256,
            input_table: LutStore::Store8((0..=255).collect::<Vec<u8>>().repeat(3)),
            clut_table: LutStore::Store8(vec![128; 24]),
            output_table: LutStore::Store8((0..=255).collect::<Vec<u8>>().repeat(3)),
            lut_type: LutType::Lut8,
        };
        let mut profile = ColorProfile::new_srgb();
        profile.lut_a_to_b_perceptual = Some(LutWarehouse::Lut(table));
        assert_eq!(ColourSpace::of_profile(&profile.encode().unwrap(), 256, false), Ok(None));
        (profile.red_trc, profile.green_trc, profile.blue_trc, profile.cicp) = (None, None, None, None);
        let note = ColourSpace::of_profile(&profile.encode().unwrap(), 256, false).unwrap_err();
        assert!(note.contains("tables") && note.contains("read as sRGB"), "{note}");
    }

    #[test]
    fn code_points_are_read() {
        let linear = of_code_points(1, 8, 256).unwrap().unwrap();
        assert_eq!(linear.curves.unwrap()[0][128], 128.0 / 255.0);
        assert_eq!(of_code_points(1, 13, 256), Ok(None));
        assert!((perceptual_quantizer(1.0) - 10_000.0 / 203.0).abs() < 1e-6);
        assert!((perceptual_quantizer(0.58) - 1.0).abs() < 0.01, "{}", perceptual_quantizer(0.58));
        assert!(of_code_points(1, 99, 256).is_err() && of_code_points(99, 13, 256).is_err());
    }
}
