//! Baking is the inverse of sampling.

use std::path::Path;

use skycube::envmap::{Face, Preset};
use skycube::picture;
use skycube::render::{Silent, bake_face};
use skycube::scene::{Plan, Scene};

const COMPASS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/envmaps/compass");

#[test]
fn every_texel_of_a_map_comes_back_through_bake_and_sample() {
    for preset in Preset::ALL {
        let text = format!(
            "camera = {{ position = [0, 0, 0], target = [1, 0, 0] }}\n\
             environment = {{ kind = \"cube-map\", map = {COMPASS:?}, lookup = {:?}, filter = \"nearest\" }}\n",
            preset.name()
        );
        let scene = Scene::from_text(&text, Path::new("test.toml")).unwrap();
        let lookup = preset.lookup();
        for face in Face::ALL {
            let baked =
                bake_face(&scene, &Plan::new(&scene), &lookup, face, 512, glam::DVec3::new(3.0, 1.0, -2.0), &Silent);
            let image = lookup.row(face).image;
            let original = picture::read(&Path::new(COMPASS).join(image.name()).with_extension("png")).unwrap();
            let (baked, original) = (baked.unwrap().raster, original.to_raster());
            let wrong = baked.pixels().iter().zip(original.pixels()).filter(|(a, b)| a != b).count();
            assert_eq!(wrong, 0, "{} {}: of 262144 texels", preset.name(), face.name());
        }
    }
}
