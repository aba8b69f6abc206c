mod damaged_files;
mod foreign_files;
mod image_formats;
mod openexr_files;
mod pictures;
mod sampling;
mod written_files;
