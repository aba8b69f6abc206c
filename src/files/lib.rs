//! Files: reading and writing bytes, numbers and texts.
//!
//! This package depends on the codecs of external file formats. It is compiled with little optimisation, which saves
//! most of its compile time; a loop over pixels that must be fast belongs to the tracer.

pub mod error;
pub mod memory;
mod memory_budget;

mod atomic_file;
mod guard;
mod notes;
mod plain_file;
mod standard_stream;
mod text_file;

pub mod archive;
pub mod choice;
pub mod document;
pub mod picture;

pub use atomic_file::{
    between_writes, check_folder_target, check_target, folder_of, make_folder, write_atomically, write_if_absent,
    write_together,
};
pub use guard::guarded;
pub use notes::{note, take_notes};
pub use plain_file::{PlainFile, check_plain, open_file, read_plain_file};
pub use standard_stream::{is_standard_stream, standard_input};
