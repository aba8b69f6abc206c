//! Files: what is read from them and written to them, as bytes, numbers and texts.
//!
//! Here is the code of the foreign formats. It is compiled with little optimisation, which is most of what it would cost
//! otherwise: a loop over pixels that has to be fast belongs to the tracer.

pub mod error;
pub mod memory;
mod memory_budget;

mod atomic_file;
mod notes;
mod plain_file;
mod text_file;

pub mod archive;
pub mod choice;
pub mod document;
pub mod picture;

pub use atomic_file::{
    check_folder_target, check_target, folder_of, make_folder, write_atomically, write_if_absent, write_together,
};
pub use notes::{note, take_notes};
pub use plain_file::{check_plain, read_plain_file};
