//! Scene files: what the documentation promises, and what users get to read when a file is wrong.

use std::path::{Path, PathBuf};

use skycube::scene::Scene;

fn lessons() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons")
}

/// The error for a scene whose camera is right and whose rest is given.
fn error(rest: &str) -> String {
    let text = format!("[camera]\nposition = [0, -5, 1]\ntarget = [0, 0, 0]\n{rest}");
    Scene::from_text(&text, Path::new("scene.toml")).map(|_| ()).unwrap_err().to_string()
}

#[test]
fn every_example_of_the_documentation_is_a_scene() {
    let text = std::fs::read_to_string(lessons().join("scenes.md")).unwrap();
    let examples: Vec<&str> = text.split("```toml\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert_eq!(examples.len(), 4);
    for example in examples {
        Scene::from_text(example, &lessons().join("scenes.md")).unwrap_or_else(|error| panic!("{error}\n{example}"));
    }
}

#[test]
fn every_scene_of_the_lessons_is_read() {
    let mut count = 0;
    for lesson in std::fs::read_dir(lessons()).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir())
    {
        for file in std::fs::read_dir(lesson).unwrap().map(|entry| entry.unwrap().path()) {
            let describes_the_lesson = file.file_name().is_some_and(|name| name == "lesson.toml");
            if file.extension().is_some_and(|extension| extension == "toml") && !describes_the_lesson {
                Scene::read(&file).unwrap_or_else(|error| panic!("{error}"));
                count += 1;
            }
        }
    }
    assert!(count >= 3);
}

#[test]
fn unknown_keys_are_refused_with_the_known_ones() {
    insta::assert_snapshot!(error("[[lights]]\nkind = \"ambient\"\nradiance = 1\ncolor = 2\n"), @r"
    scene.toml:7: lights[0].color: unknown key
      expected: one of kind, radiance
    ");
    insta::assert_snapshot!(error("[enviroment]\nkind = \"constant\"\n"), @r"
    scene.toml:4: enviroment: unknown key
      expected: one of camera, environment, integrator, lights, materials, mtl_colours, output, shapes
    ");
}

#[test]
fn misspelt_keys_are_named() {
    insta::assert_snapshot!(error("[materials.ball]\nkind = \"lambert\"\ncolor = 0.5\n"), @r#"
    scene.toml:6: materials.ball.color: unknown key
      help: did you mean "colour"?
    "#);
}

#[test]
fn missing_keys_are_named() {
    insta::assert_snapshot!(error("[[shapes]]\nkind = \"sphere\"\n"), @r#"scene.toml:4: shapes[0]: the key "material" is missing"#);
    insta::assert_snapshot!(Scene::from_text("", Path::new("scene.toml")).unwrap_err(), @r#"scene.toml:1: the key "camera" is missing"#);
}

#[test]
fn wrong_values_say_what_was_expected() {
    insta::assert_snapshot!(error("[materials.ball]\nkind = \"glass\"\nindex = \"high\"\n"), @r#"
    scene.toml:6: materials.ball.index: found "high"
      expected: an index of refraction, from 0.1 to 100
    "#);
    insta::assert_snapshot!(error("[integrator]\nmistake = \"gamma\"\n"), @r#"
    scene.toml:5: integrator.mistake: found "gamma"
      expected: one of shadow-acne
    "#);
    insta::assert_snapshot!(error("[output]\nencode = \"rec709\"\n"), @r#"
    scene.toml:5: output.encode: found "rec709"
      expected: one of srgb, linear
    "#);
    insta::assert_snapshot!(error("[materials.ball]\nkind = \"lambert\"\ncolour = [0.5, 2, 0]\n"), @r"
    scene.toml:6: materials.ball.colour: a surface cannot reflect more light than arrives
      expected: channels from 0 to 1
    ");
    insta::assert_snapshot!(error("[integrator]\nkind = \"raytrace\"\n"), @r#"
    scene.toml:5: integrator.kind: found "raytrace"
      expected: one of normals, phong, whitted, path
    "#);
    insta::assert_snapshot!(error("[integrator]\ndepth = 1.5\n"), @r"
    scene.toml:5: integrator.depth: found 1.5
      expected: a whole number from 0 to 1000
    ");
    insta::assert_snapshot!(error("[[lights]]\nkind = \"ambient\"\nradiance = [1, -1, 1]\n"), @r"
    scene.toml:6: lights[0].radiance: found a list of length 3
      expected: a colour: one number, or [red, green, blue], none negative
    ");
}

/// The error for a material given by its keys.
fn material_error(keys: &str) -> String {
    error(&format!("[materials.ball]\n{keys}\n"))
}

#[test]
fn roughness_is_smooth_or_in_range() {
    for keys in ["kind = \"metal\"\nmetal = \"gold\"", "kind = \"glass\"", "kind = \"coated\"\ncolour = 0.5"] {
        let text = material_error(&format!("{keys}\nroughness = 0.00001"));
        assert!(text.contains("materials.ball.roughness: found 0.00001\n  expected: 0 for smooth"), "{text}");
    }
    insta::assert_snapshot!(material_error("kind = \"glass\"\nroughness = 1.5"), @r"
    scene.toml:6: materials.ball.roughness: found 1.5
      expected: 0 for smooth, or a roughness from 0.0001 to 1
    ");
}

#[test]
fn a_metal_is_described_in_one_way() {
    insta::assert_snapshot!(material_error("kind = \"metal\"\nmetal = \"gold\"\nreflectance = 1"), @r#"
    scene.toml:4: materials.ball: there must be one description of the metal
      expected: either "metal", or "index" and "extinction", or "reflectance"
    "#);
    insta::assert_snapshot!(material_error("kind = \"metal\"\nindex = [1, 1, 1]"), @r#"scene.toml:4: materials.ball: the key "extinction" is missing"#);
    insta::assert_snapshot!(material_error("kind = \"metal\"\nmetal = \"tin\""), @r#"
    scene.toml:6: materials.ball.metal: found "tin"
      expected: one of gold, silver, copper, aluminium, iron, chromium
    "#);
    insta::assert_snapshot!(material_error("kind = \"metal\"\nmetal = \"gold\"\nextinction = 1"), @r"
    scene.toml:7: materials.ball.extinction: unknown key
      expected: one of index, kind, metal, reflectance, roughness
    ");
}

#[test]
fn a_surface_reflects_no_more_than_arrives() {
    insta::assert_snapshot!(material_error("kind = \"phong\"\ndiffuse = { checker = [0.2, 0.8] }\nspecular = 0.3"), @r"
    scene.toml:7: materials.ball.specular: diffuse and specular together reflect more light than arrives
      expected: sums of at most 1 in every channel
    ");
    insta::assert_snapshot!(material_error("kind = \"coated\"\ncolour = 0.5\nindex = 0.9"), @r"
    scene.toml:7: materials.ball.index: found 0.9
      expected: an index of refraction, from 1 to 100
    ");
}

#[test]
fn lights_among_the_materials_shine() {
    let scene = |text: &str| {
        let text = format!("camera = {{ position = [0, -5, 1], target = [0, 0, 0] }}\n[materials]\n{text}");
        Scene::from_text(&text, Path::new("scene.toml")).unwrap_or_else(|error| panic!("{error}"))
    };
    let materials = scene("lamp = { kind = \"light\", radiance = [30, 20, 10] }").materials;
    assert_eq!(materials[0].emission(), skycube::math::Vec3::new(30.0, 20.0, 10.0));
    assert!(materials[0].scattering(Default::default(), 1.0).is_none());
}

#[test]
fn names_that_do_not_exist_are_errors() {
    insta::assert_snapshot!(error("[materials.red]\nkind = \"normals\"\n[[shapes]]\nkind = \"plane\"\nmaterial = \"blue\"\n"), @r#"
    scene.toml:8: shapes[0].material: there is no material "blue"
      expected: one of red
    "#);
    insta::assert_snapshot!(error("[environment]\nkind = \"cube-map\"\nmap = \"nowhere.zip\"\n"), @r"
    scene.toml:6: environment.map: nowhere.zip: the file or folder does not exist
    ");
}

#[test]
fn impossible_geometry_is_refused() {
    insta::assert_snapshot!(error("[materials.a]\nkind = \"normals\"\n[[shapes]]\nkind = \"sphere\"\nradius = 0\nmaterial = \"a\"\n"), @r"
    scene.toml:8: shapes[0].radius: found 0
      expected: a number more than 0
    ");
    insta::assert_snapshot!(error("[materials.a]\nkind = \"normals\"\n[[shapes]]\nkind = \"sphere\"\nscale = [1, 0, 1]\nmaterial = \"a\"\n"), @r"
    scene.toml:6: shapes[0]: a scale is zero
      expected: scales that are not zero
    ");
    insta::assert_snapshot!(Scene::from_text("[camera]\nposition = [0, 0, 5]\ntarget = [0, 0, 0]\n", Path::new("scene.toml")).unwrap_err(), @r"
    scene.toml:1: camera: the camera's orientation is undefined
      expected: a target away from the position, and an up that is not parallel to the view
    ");
}

#[test]
fn a_lookup_whose_axes_do_not_span_the_face_is_refused() {
    let rows = "posx = { u = \"+x\", v = \"+z\" }\nnegx = { u = \"+y\", v = \"+z\" }\nposy = { u = \"+x\", v = \"+z\" }\n\
                negy = { u = \"-x\", v = \"+z\" }\nposz = { u = \"+x\", v = \"-y\" }\nnegz = { u = \"+x\", v = \"+y\" }\n";
    let map = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/compass");
    let text = format!(
        "[environment]\nkind = \"cube-map\"\nmap = {map:?}\n[environment.lookup]\nv_origin = \"bottom\"\n{rows}"
    );
    insta::assert_snapshot!(error(&text), @r"
    scene.toml:7: environment.lookup: posx: u = +x and v = +z do not span the face: use both other axes, once each
    ");
}

#[test]
fn text_that_is_not_toml_names_the_line() {
    assert!(error("[[lights]\n").starts_with("scene.toml:4: not valid TOML"));
}
