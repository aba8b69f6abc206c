//! Which channels of an OpenEXR file are the colour.

use exr::meta::attribute::{ChannelList, SampleType};

use crate::error::{Error, Result};
use crate::picture::SampleKind;

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
                .help("save it again as RGB"));
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

    /// Which components of the colour are read from a channel.
    pub fn components(self, channel: usize) -> [bool; 3] {
        self.0.map(|source| source == channel)
    }
}

/// How the samples of a channel are stored.
pub fn kind_of(kind: SampleType) -> SampleKind {
    match kind {
        SampleType::F16 => SampleKind::Half,
        SampleType::F32 => SampleKind::Float,
        SampleType::U32 => SampleKind::Unsigned,
    }
}
