//! Magma: a colour map of uniformly increasing lightness, for heat maps (van der Walt and Smith, 2015, CC0).

/// Every sixteenth of the range, sRGB-encoded.
const MAGMA: [[u8; 3]; 17] = [
    [0, 0, 4],
    [10, 8, 34],
    [29, 17, 71],
    [52, 16, 106],
    [81, 18, 124],
    [106, 28, 129],
    [131, 38, 129],
    [157, 47, 127],
    [183, 55, 121],
    [209, 65, 113],
    [230, 82, 99],
    [245, 107, 91],
    [252, 137, 97],
    [254, 168, 115],
    [254, 198, 138],
    [253, 226, 163],
    [252, 253, 191],
];

/// The colour of a value in `[0, 1]`; values outside are clamped, NaN is the lowest.
fn magma(value: f32) -> [u8; 3] {
    let place = if value > 0.0 { value.min(1.0) } else { 0.0 } * (MAGMA.len() - 1) as f32;
    let first = (place as usize).min(MAGMA.len() - 2);
    let share = place - first as f32;
    [0, 1, 2].map(|channel| {
        let (a, b) = (f32::from(MAGMA[first][channel]), f32::from(MAGMA[first + 1][channel]));
        (a + share * (b - a)).round() as u8
    })
}

/// The colours of many values, four bytes each: red, green, blue and full opacity.
pub fn magma_bytes(values: &[f32]) -> Vec<u8> {
    let pixel = |&value: &f32| {
        let [red, green, blue] = magma(value);
        [red, green, blue, 255]
    };
    values.iter().flat_map(pixel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grows_lighter_all_the_way() {
        let lightness = |value: f32| {
            let [red, green, blue] = magma(value).map(f32::from);
            0.2126 * red + 0.7152 * green + 0.0722 * blue
        };
        for step in 0..100 {
            assert!(lightness(step as f32 / 100.0) < lightness((step + 1) as f32 / 100.0), "{step}");
        }
        assert_eq!(magma(f32::NAN), magma(0.0));
    }
}
