//! The validator on maps with every known fault, and on right ones.

#[path = "../common/mod.rs"]
mod common;
mod made_up;
mod pictures;
mod recovery;

mod check_time;
mod damage_and_recover;
mod known_maps;
mod nasty_maps;
mod outliers;
mod plain_skies;
mod stories;
