//! Which channels of an OpenEXR file are the colour.

use exr::meta::attribute::{ChannelList, SampleType};
use exr::prelude::f16;

use crate::error::{Error, Result};
use crate::math::Vec3;

/// Where the colour of a layer is: the index of the channel for red, green and blue, in the order of the file.
/// A grey picture has the same index three times.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColourChannels([usize; 3]);

impl ColourChannels {
    /// Finds `R`, `G` and `B`, or `Y` alone.
    pub fn find(channels: &ChannelList) -> Result<Self> {
        let index = |name: &str| channels.list.iter().position(|channel| channel.name == *name);
        if let (Some(red), Some(green), Some(blue)) = (index("R"), index("G"), index("B")) {
            return Ok(Self([red, green, blue]));
        }
        if index("RY").is_some() || index("BY").is_some() {
            return Err(Error::new("the colour is stored as luminance and chroma (Y, RY, BY)")
                .expected("channels R, G and B, or Y alone")
                .help("save it anew as RGB"));
        }
        if let Some(grey) = index("Y") {
            return Ok(Self([grey; 3]));
        }
        let names: Vec<String> = channels.list.iter().map(|channel| channel.name.to_string()).collect();
        Err(Error::new(format!("the first layer has no colour, its channels are {}", names.join(", ")))
            .expected("channels R, G and B, or Y alone"))
    }

    /// True if the colour is read from this channel.
    pub fn contain(self, channel: usize) -> bool {
        self.0.contains(&channel)
    }

    /// Most bits a sample of the three channels.
    pub fn bit_depth(self, channels: &ChannelList) -> u8 {
        let bits = |index: usize| 8 * channels.list[index].sample_type.bytes_per_sample() as u8;
        self.0.into_iter().map(bits).max().unwrap_or(0)
    }

    /// Stores a sample of one channel in every component of `colour` that is read from it.
    #[inline]
    pub fn store(self, channel: usize, sample: f32, colour: &mut Vec3) {
        for (component, &source) in self.0.iter().enumerate() {
            if source == channel {
                colour[component] = sample;
            }
        }
    }
}

/// The samples of a line as floats, from their bytes in the order of this machine.
pub fn samples(bytes: &[u8], kind: SampleType) -> Box<dyn Iterator<Item = f32> + '_> {
    let words = |bytes: &[u8]| [bytes[0], bytes[1], bytes[2], bytes[3]];
    match kind {
        SampleType::F16 => Box::new(bytes.chunks_exact(2).map(|half| f16::from_ne_bytes([half[0], half[1]]).to_f32())),
        SampleType::F32 => Box::new(bytes.chunks_exact(4).map(move |word| f32::from_ne_bytes(words(word)))),
        SampleType::U32 => Box::new(bytes.chunks_exact(4).map(move |word| u32::from_ne_bytes(words(word)) as f32)),
    }
}
