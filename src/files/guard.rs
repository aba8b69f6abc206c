//! Guards against decoders that panic on a file.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

use crate::error::{Error, Result};

thread_local! {
    /// True while a panic of this thread is an answer and not a message on the terminal.
    static GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// What the work on a file gives; an error with advice if it panics. The file is to blame: decoders are written for files that
/// others wrote, and some have cases that nobody thought of.
pub fn guarded<T>(help: &str, work: impl FnOnce() -> Result<T>) -> Result<T> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |panic| {
            if !GUARDED.get() {
                usual(panic);
            }
        }));
    });
    let before = GUARDED.replace(true);
    let result = catch_unwind(AssertUnwindSafe(|| {
        #[cfg(test)]
        tests::panic_if_wanted();
        work()
    }));
    GUARDED.set(before);
    result.unwrap_or_else(|_| {
        Err(Error::new("this file cannot be decoded: its variant is unknown to the decoder, or it is damaged")
            .help(help)
            .of_damage())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::archive::Archive;
    use crate::document::Document;
    use crate::picture::{Format, PixelLoops, Stretch, decode, encode_openexr, exr_environment};

    thread_local! {
        /// True while every guarded work panics, as if its decoder did.
        static WANTED: Cell<bool> = const { Cell::new(false) };
    }

    pub(super) fn panic_if_wanted() {
        assert!(!WANTED.get(), "a decoder fails");
    }

    #[test]
    fn a_panic_becomes_an_error() {
        assert_eq!(guarded("", || Ok(1)), Ok(1));
        let nested = guarded("", || {
            assert!(guarded("", || -> Result<()> { panic!("inner") }).is_err());
            assert!(GUARDED.get(), "the outer work is still guarded");
            Ok([1, 2, 3].get(7).copied().expect("outer"))
        });
        assert!(nested.unwrap_err().problem().contains("cannot be decoded"));
        assert!(!GUARDED.get());
    }

    /// What optimised packages supply; no decoder comes that far here.
    struct NoLoops;

    impl PixelLoops for NoLoops {
        fn decoder<'a>(&self, _: Format, _: &'a [u8]) -> Option<image::ImageResult<Box<dyn image::ImageDecoder + 'a>>> {
            None
        }

        fn damage(&self, _: Format, _: &[u8]) -> Option<String> {
            None
        }

        fn store(&self, _: &Stretch, _: &mut [[f32; 3]]) {}
    }

    fn failing<T>(work: impl FnOnce() -> T) -> T {
        WANTED.set(true);
        let result = work();
        WANTED.set(false);
        result
    }

    #[test]
    fn files_at_which_a_decoder_fails_are_named() {
        let named = |name: &str, error: Error| {
            let text = error.to_string();
            assert!(text.contains(name) && text.contains("help: ") && error.is_damage(), "{text}");
        };
        let starts: [&[u8]; 11] = [
            b"\xFF\xD8\xFF",
            b"\x89PNG\r\n\x1A\n",
            b"BM",
            b"II*\0",
            b"MM\0+",
            b"#?RADIANCE",
            b"\x76\x2F\x31\x01",
            b"RIFF\0\0\0\0WEBP",
            b"P6 1 1 255",
            b"PF 1 1 -1",
            b"\0\0\x02\0\0\0\0\0\0\0\0\0\x01\0\x01\0\x18\0.tga",
        ];
        for start in starts {
            named("a.tga", failing(|| decode(start, "a.tga".as_ref(), &NoLoops)).unwrap_err());
        }
        let exr = encode_openexr((1, 1), vec![("Y".to_owned(), vec![0.0])], None).unwrap();
        assert_eq!(failing(|| exr_environment(&exr)), None);

        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.zip");
        let mut file = zip::ZipWriter::new(std::fs::File::create(&path).unwrap());
        file.start_file("posx.png", zip::write::SimpleFileOptions::default()).unwrap();
        file.finish().unwrap();
        named("a.zip", failing(|| Archive::open(&path)).err().unwrap());
        let entry = Archive::open(&path).unwrap().entry(0);
        named("posx.png", failing(|| entry.read(None)).unwrap_err());

        let document = Document::new("a.toml", "a = 1");
        named("a.toml", failing(|| document.parse()).unwrap_err());
    }
}
