//! How maps are encoded: format, bits, quality, tone map.

use std::path::Path;

use clap::Args;

use super::terminal::remark;
use crate::choice::name_of;
use crate::colour::ToneMap;
use crate::error::{Error, Result};
use crate::picture::{Header, OutputFormat, Picture, PngDepth, Texels, WriteOptions};

/// How files are encoded.
#[derive(Debug, Args)]
pub struct EncodingOptions {
    /// The format of six files [default: the map's, if its files are copied; else one without loss: PNG, HDR or EXR]
    #[arg(long, value_enum)]
    format: Option<OutputFormat>,
    /// Bits per channel in PNG [default: 8 for maps of 8 bits, else 16]
    #[arg(long, value_name = "BITS", value_parser = ["8", "16"])]
    bits: Option<String>,
    /// JPEG quality, 1 to 100 [default: 92]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=100))]
    quality: Option<u8>,
    /// How radiance above 1 is mapped into range in PNG and JPEG [default: clamp]
    #[arg(long, value_enum)]
    tone_map: Option<ToneMap>,
}

impl EncodingOptions {
    /// True if files with these headers may be copied: nothing else is wanted of them.
    pub fn keep_files(&self, headers: &[Header]) -> bool {
        let format = headers[0].format;
        let wanted = self.format.is_none_or(|wanted| wanted.extension() == format.extension());
        let encoded_anew = self.bits.is_some() || self.quality.is_some() || self.tone_map.is_some();
        wanted && !encoded_anew && headers.iter().all(|header| header.format == format)
    }

    /// The format of the files: that of the option or of the name of the picture, else one without loss.
    pub fn format(&self, picture: Option<&Path>, headers: &[Header]) -> Result<OutputFormat> {
        let Some(picture) = picture else { return Ok(self.format.unwrap_or(OutputFormat::lossless_for(headers))) };
        let named = OutputFormat::of_path(picture)?;
        match self.format {
            Some(format) if format != named => {
                Err(Error::new(format!("the name contradicts --format {}", name_of(format)))
                    .in_file(picture)
                    .help("leave out --format: the extension names the format"))
            }
            _ => Ok(named),
        }
    }

    /// The options of the writer; an error if one is given that the format does not have. `bytes` tells whether the map holds
    /// 8 bits.
    pub fn write_options(&self, format: OutputFormat, pictures: &[Picture], bytes: bool) -> Result<WriteOptions> {
        let (png, jpeg) = (format == OutputFormat::Png, format == OutputFormat::Jpeg);
        let refuse = |option: &str, given: bool, formats: &str| match given {
            true => Err(Error::new(format!("{option} has no effect on {} files", format.extension()))
                .expected(format!("{option} with {formats} alone"))),
            false => Ok(()),
        };
        refuse("--bits", self.bits.is_some() && !png, "PNG")?;
        refuse("--quality", self.quality.is_some() && !jpeg, "JPEG")?;
        refuse("--tone-map", self.tone_map.is_some() && !png && !jpeg, "PNG and JPEG")?;
        let above_one = |picture: &Picture| match picture.texels() {
            Texels::Srgb8(_) => false,
            Texels::Linear(colours) => colours.iter().any(|colour| colour.max_element() > 1.0),
        };
        if (png || jpeg) && self.tone_map.is_none() && pictures.iter().any(above_one) {
            remark(format_args!(
                "note: radiance above 1 is cut off; HDR and EXR hold it, --tone-map reinhard maps it into range\n"
            ));
        }
        let eight = self.bits.as_deref().map_or(bytes, |bits| bits == "8");
        Ok(WriteOptions {
            tone_map: self.tone_map.unwrap_or_default(),
            png_depth: if eight { PngDepth::Eight } else { PngDepth::Sixteen },
            jpeg_quality: self.quality.unwrap_or(WriteOptions::default().jpeg_quality),
            ..WriteOptions::default()
        })
    }
}
