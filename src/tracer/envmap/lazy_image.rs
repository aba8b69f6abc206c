//! A picture that is decoded at its first use.

use std::sync::OnceLock;

use crate::error::{Error, Result};
use crate::picture::Picture;

/// Decodes a picture on demand.
pub type Decoder = Box<dyn Fn() -> Result<Picture> + Send + Sync>;

/// A picture decoded on first use, once, however many threads ask; the others wait for it.
pub struct LazyImage {
    decoder: Decoder,
    decoded: OnceLock<Result<Picture>>,
}

impl LazyImage {
    /// An image that the decoder will deliver.
    pub fn new(decoder: Decoder) -> Self {
        Self { decoder, decoded: OnceLock::new() }
    }

    /// An image that is there already.
    pub fn ready(picture: Picture) -> Self {
        Self { decoder: Box::new(|| Err(Error::new("decoded already"))), decoded: OnceLock::from(Ok(picture)) }
    }

    /// The picture; `None` if it cannot be decoded (then [`LazyImage::error`] says why).
    #[inline]
    pub fn picture(&self) -> Option<&Picture> {
        match self.decoded.get() {
            Some(decoded) => decoded.as_ref().ok(),
            None => self.first_look(),
        }
    }

    /// Decodes, or waits for the thread that does.
    #[cold]
    #[inline(never)]
    fn first_look(&self) -> Option<&Picture> {
        self.try_picture().ok()
    }

    /// The picture, or why there is none.
    pub fn try_picture(&self) -> Result<&Picture> {
        self.decoded.get_or_init(|| (self.decoder)()).as_ref().map_err(Clone::clone)
    }

    /// True once the picture is in use.
    pub fn looked_at(&self) -> bool {
        self.decoded.get().is_some()
    }

    /// Why the picture could not be decoded, if it was tried.
    pub fn error(&self) -> Option<&Error> {
        self.decoded.get()?.as_ref().err()
    }
}

impl std::fmt::Debug for LazyImage {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("LazyImage").field("looked_at", &self.looked_at()).finish_non_exhaustive()
    }
}
