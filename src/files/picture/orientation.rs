//! The orientation flag of a picture: cameras store the pixels of the sensor, with a flag for the rotation.

use image::ImageDecoder;

use super::Samples;

/// The flag of EXIF and TIFF, from 1 (as stored) to 8.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Orientation(u8);

impl Orientation {
    /// What a file says; as stored if it says nothing that can be read.
    pub fn of(decoder: &mut dyn ImageDecoder) -> Self {
        Self(decoder.orientation().map_or(1, |orientation| orientation.to_exif()))
    }

    /// Width and height as seen, from those as stored.
    pub fn size(self, [width, height]: [usize; 2]) -> [usize; 2] {
        if self.exchanges_sides() { [height, width] } else { [width, height] }
    }

    fn exchanges_sides(self) -> bool {
        self.0 >= 5
    }

    /// What a user should know.
    pub fn note(self) -> Option<String> {
        (self.0 != 1).then(|| format!("it is turned according to its orientation flag ({})", self.0))
    }

    /// The samples as seen.
    pub fn applied(self, samples: Samples, stored: [usize; 2]) -> Samples {
        match samples {
            samples if self.0 == 1 => samples,
            Samples::Bytes(channels, values) => Samples::Bytes(channels, self.turned(&values, channels, stored)),
            Samples::Words(channels, values) => Samples::Words(channels, self.turned(&values, channels, stored)),
            Samples::Floats(channels, values) => Samples::Floats(channels, self.turned(&values, channels, stored)),
        }
    }

    fn turned<T: Copy>(self, values: &[T], channels: usize, [width, height]: [usize; 2]) -> Vec<T> {
        let [columns, rows] = self.size([width, height]);
        let mut turned = Vec::with_capacity(values.len());
        for (y, x) in (0..rows).flat_map(|y| (0..columns).map(move |x| (y, x))) {
            let (column, row) = match self.0 {
                2 => (width - 1 - x, y),
                3 => (width - 1 - x, height - 1 - y),
                4 => (x, height - 1 - y),
                5 => (y, x),
                6 => (y, height - 1 - x),
                7 => (width - 1 - y, height - 1 - x),
                8 => (width - 1 - y, x),
                _ => (x, y),
            };
            let start = (row * width + column) * channels;
            turned.extend_from_slice(&values[start..start + channels]);
        }
        turned
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_turn_as_viewers_do() {
        // 1 2 3
        // 4 5 6
        let stored: Vec<u8> = (1..=6).collect();
        let seen = |flag: u8| Orientation(flag).turned(&stored, 1, [3, 2]);
        assert_eq!(seen(1), stored);
        assert_eq!(seen(2), [3, 2, 1, 6, 5, 4]);
        assert_eq!(seen(3), [6, 5, 4, 3, 2, 1]);
        assert_eq!(seen(4), [4, 5, 6, 1, 2, 3]);
        assert_eq!(seen(5), [1, 4, 2, 5, 3, 6]);
        assert_eq!(seen(6), [4, 1, 5, 2, 6, 3]);
        assert_eq!(seen(7), [6, 3, 5, 2, 4, 1]);
        assert_eq!(seen(8), [3, 6, 2, 5, 1, 4]);
        assert_eq!((Orientation(6).size([3, 2]), Orientation(3).size([3, 2])), ([2, 3], [3, 2]));
    }
}
