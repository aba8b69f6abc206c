//! Makes the scene that `envmaps/courtyard` is baked from: `cargo run --release --example make-courtyard FOLDER`.
//!
//! Writes meshes (OBJ, MTL), textures, the sky and `courtyard.toml`. All of it is computed, nothing is read.

#[path = "courtyard-source/buildings.rs"]
mod buildings;
#[path = "courtyard-source/facades.rs"]
mod facades;
#[path = "courtyard-source/furniture.rs"]
mod furniture;
#[path = "courtyard-source/ground.rs"]
mod ground;
#[path = "courtyard-source/model.rs"]
mod model;
#[path = "courtyard-source/noise.rs"]
mod noise;
#[path = "courtyard-source/paint.rs"]
mod paint;
#[path = "courtyard-source/plants.rs"]
mod plants;
#[path = "courtyard-source/sky.rs"]
mod sky;
#[path = "courtyard-source/surroundings.rs"]
mod surroundings;
#[path = "courtyard-source/textures.rs"]
mod textures;
#[path = "courtyard-source/yard.rs"]
mod yard;

use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) else {
        return Err("usage: cargo run --release --example make-courtyard FOLDER".into());
    };
    std::fs::create_dir_all(&folder)?;
    textures::write(&folder)?;
    let models =
        [("buildings", yard::buildings()), ("yard", yard::yard()), ("surroundings", surroundings::surroundings())];
    for (name, model) in &models {
        model.write(&folder, name)?;
        println!("{name}: {} triangles", model.triangle_count());
    }
    std::fs::write(folder.join("courtyard.toml"), include_str!("courtyard-source/courtyard.toml"))?;
    println!("wrote {}", folder.join("courtyard.toml").display());
    Ok(())
}
