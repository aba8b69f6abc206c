//! How programs and sites name the six faces: every scheme is read as the order that its document gives.

use super::listing::{Naming, find_faces};

/// The document, and the names in the order +X -X +Y -Y +Z -Z: right, left, up, down, front, back as seen from inside.
type Scheme = (&'static str, [&'static str; 6]);

#[rustfmt::skip]
const SCHEMES: &[Scheme] = &[
    // Axes.
    ("Humus, humus.name/Textures", ["posx.jpg", "negx.jpg", "posy.jpg", "negy.jpg", "posz.jpg", "negz.jpg"]),
    ("three.js, CubeTextureLoader", ["px.png", "nx.png", "py.png", "ny.png", "pz.png", "nz.png"]),
    ("Poly Haven, HDRI-to-CubeMap exports", ["studio_px.jpg", "studio_nx.jpg", "studio_py.jpg", "studio_ny.jpg", "studio_pz.jpg", "studio_nz.jpg"]),
    ("Babylon.js, CubeTexture", ["skybox_px.jpg", "skybox_nx.jpg", "skybox_py.jpg", "skybox_ny.jpg", "skybox_pz.jpg", "skybox_nz.jpg"]),
    ("Cesium, SkyBox: tycho2t3_80", ["tycho2t3_80_px.jpg", "tycho2t3_80_mx.jpg", "tycho2t3_80_py.jpg", "tycho2t3_80_my.jpg", "tycho2t3_80_pz.jpg", "tycho2t3_80_mz.jpg"]),
    ("Humus, older sets", ["+x.jpg", "-x.jpg", "+y.jpg", "-y.jpg", "+z.jpg", "-z.jpg"]),
    ("cmft, -outputNum faces", ["sky_posx.tga", "sky_negx.tga", "sky_posy.tga", "sky_negy.tga", "sky_posz.tga", "sky_negz.tga"]),
    ("Blender add-ons, axes spelled out", ["Positive_X.png", "Negative_X.png", "Positive_Y.png", "Negative_Y.png", "Positive_Z.png", "Negative_Z.png"]),
    ("Filament, cmgen --deploy", ["m0_px.rgbe", "m0_nx.rgbe", "m0_py.rgbe", "m0_ny.rgbe", "m0_pz.rgbe", "m0_nz.rgbe"]),
    ("Substance, cube faces", ["env_x_plus.png", "env_x_minus.png", "env_y_plus.png", "env_y_minus.png", "env_z_plus.png", "env_z_minus.png"]),
    ("RenderMan, txmake -envcube", ["env.xp.tif", "env.xn.tif", "env.yp.tif", "env.yn.tif", "env.zp.tif", "env.zn.tif"]),
    ("Vulkan samples, axes behind a dash", ["cube-x+.png", "cube-x-.png", "cube-y+.png", "cube-y-.png", "cube-z+.png", "cube-z-.png"]),
    ("Godot 3, axes with a sign word", ["plus_x.png", "minus_x.png", "plus_y.png", "minus_y.png", "plus_z.png", "minus_z.png"]),
    ("sky_pos_x, Luanti skybox_extended", ["sky_pos_x.png", "sky_neg_x.png", "sky_pos_y.png", "sky_neg_y.png", "sky_pos_z.png", "sky_neg_z.png"]),
    // Words.
    ("LearnOpenGL, Cubemaps", ["right.jpg", "left.jpg", "top.jpg", "bottom.jpg", "front.jpg", "back.jpg"]),
    ("Unity, 6 Sided skybox", ["Day_RightTex.png", "Day_LeftTex.png", "Day_UpTex.png", "Day_DownTex.png", "Day_FrontTex.png", "Day_BackTex.png"]),
    ("Unity asset store, names run together", ["PurpleRight.png", "PurpleLeft.png", "PurpleTop.png", "PurpleBottom.png", "PurpleFront.png", "PurpleBack.png"]),
    ("Lugaru, Data/Textures/Skybox", ["Right.jpg", "Left.jpg", "Up.jpg", "Down.jpg", "Front.jpg", "Back.jpg"]),
    ("Doom 3, cameraCubeMap", ["sky_right.tga", "sky_left.tga", "sky_up.tga", "sky_down.tga", "sky_forward.tga", "sky_back.tga"]),
    ("Hugin and panorama tools, zenith and nadir", ["right.tif", "left.tif", "zenith.tif", "nadir.tif", "front.tif", "back.tif"]),
    ("Interiors", ["room-right.png", "room-left.png", "room-ceiling.png", "room-floor.png", "room-front.png", "room-back.png"]),
    ("Roblox, Sky", ["sky_right.png", "sky_left.png", "sky_up.png", "sky_down.png", "sky_front.png", "sky_back.png"]),
    ("OpenSceneGraph, numbers before words", ["1 right.jpg", "2 left.jpg", "3 top.jpg", "4 bottom.jpg", "5 front.jpg", "6 back.jpg"]),
    ("Photographs of a rear camera", ["right.jpg", "left.jpg", "top.jpg", "bottom.jpg", "front.jpg", "rear.jpg"]),
    // Quake and its heirs.
    ("Quake 2, env/", ["env/unit1_rt.tga", "env/unit1_lf.tga", "env/unit1_up.tga", "env/unit1_dn.tga", "env/unit1_ft.tga", "env/unit1_bk.tga"]),
    ("Half-Life, gfx/env, names run together", ["desertrt.tga", "desertlf.tga", "desertup.tga", "desertdn.tga", "desertft.tga", "desertbk.tga"]),
    ("OGRE, Sky Boxes", ["cloudy_noon_rt.jpg", "cloudy_noon_lf.jpg", "cloudy_noon_up.jpg", "cloudy_noon_dn.jpg", "cloudy_noon_fr.jpg", "cloudy_noon_bk.jpg"]),
    ("Terragen scripts", ["terragen_rt.bmp", "terragen_lf.bmp", "terragen_up.bmp", "terragen_dn.bmp", "terragen_ft.bmp", "terragen_bk.bmp"]),
    ("Irrlicht, media/irrlicht2", ["irrlicht2_rt.jpg", "irrlicht2_lf.jpg", "irrlicht2_up.jpg", "irrlicht2_dn.jpg", "irrlicht2_ft.jpg", "irrlicht2_bk.jpg"]),
    // Initials.
    ("krpano, cube tags pano_%s", ["pano_r.jpg", "pano_l.jpg", "pano_u.jpg", "pano_d.jpg", "pano_f.jpg", "pano_b.jpg"]),
    ("Marzipano, tiles b d f l r u", ["r.jpg", "l.jpg", "u.jpg", "d.jpg", "f.jpg", "b.jpg"]),
    ("Pannellum, generate.py fallback", ["fallback/r.jpg", "fallback/l.jpg", "fallback/u.jpg", "fallback/d.jpg", "fallback/f.jpg", "fallback/b.jpg"]),
    ("Pano2VR, _r_0 ends in a suffix", ["c_r_0.jpg", "c_l_0.jpg", "c_u_0.jpg", "c_d_0.jpg", "c_f_0.jpg", "c_b_0.jpg"]),
    // A compass whose north is the front.
    ("Nuit, Awesome-Skies", ["sky_east.png", "sky_west.png", "sky_top.png", "sky_bottom.png", "sky_north.png", "sky_south.png"]),
    ("OpenSimulator and Second Life, up and down", ["east.png", "west.png", "up.png", "down.png", "north.png", "south.png"]),
    ("Celestia add-ons, initials", ["map_e.png", "map_w.png", "map_u.png", "map_d.png", "map_n.png", "map_s.png"]),
    // Numbers with a documented order: Minecraft's 0 to 5 are front, right, back, left, up, down.
    ("Minecraft, title panorama", ["panorama_1.png", "panorama_3.png", "panorama_4.png", "panorama_5.png", "panorama_0.png", "panorama_2.png"]),
    ("CubeMapGen, exported faces", ["sky_c00.bmp", "sky_c01.bmp", "sky_c02.bmp", "sky_c03.bmp", "sky_c04.bmp", "sky_c05.bmp"]),
    // Other languages.
    ("German", ["rechts.jpg", "links.jpg", "oben.jpg", "unten.jpg", "vorne.jpg", "hinten.jpg"]),
    ("Czech", ["vpravo.jpg", "vlevo.jpg", "nahoře.jpg", "dole.jpg", "vpředu.jpg", "vzadu.jpg"]),
    ("Czech without accents", ["obloha_prava.png", "obloha_leva.png", "obloha_horni.png", "obloha_dolni.png", "obloha_predni.png", "obloha_zadni.png"]),
    ("French", ["droite.jpg", "gauche.jpg", "haut.jpg", "bas.jpg", "devant.jpg", "derrière.jpg"]),
    ("French, before and behind", ["ciel-droite.png", "ciel-gauche.png", "ciel-haut.png", "ciel-bas.png", "ciel-avant.png", "ciel-arriere.png"]),
    ("Spanish", ["derecha.jpg", "izquierda.jpg", "arriba.jpg", "abajo.jpg", "delante.jpg", "detrás.jpg"]),
    ("Italian", ["destra.jpg", "sinistra.jpg", "sopra.jpg", "sotto.jpg", "davanti.jpg", "dietro.jpg"]),
];

/// Names that number six pictures without saying how.
const NUMBERED: &[(&str, [&str; 6])] = &[
    ("Pannellum's example", ["pano0.png", "pano1.png", "pano2.png", "pano3.png", "pano4.png", "pano5.png"]),
    ("face0 and so on", ["face0.png", "face1.png", "face2.png", "face3.png", "face4.png", "face5.png"]),
    ("counted from one", ["sky-1.jpg", "sky-2.jpg", "sky-3.jpg", "sky-4.jpg", "sky-5.jpg", "sky-6.jpg"]),
    ("frames of an animation", ["0001.png", "0002.png", "0003.png", "0004.png", "0005.png", "0006.png"]),
    ("nothing but digits", ["0.jpg", "1.jpg", "2.jpg", "3.jpg", "4.jpg", "5.jpg"]),
];

/// The six names as they are chosen among other files that lie beside them.
fn chosen(names: &[&str; 6]) -> (Vec<String>, Naming) {
    let others = ["readme.txt", "preview.jpg", "thumb.jpg"].map(str::to_owned);
    let paths: Vec<String> = names.iter().rev().map(|name| (*name).to_owned()).chain(others).collect();
    let located = find_faces(&paths).unwrap_or_else(|error| panic!("{names:?}: {error}"));
    (located.six.map(|file| paths[file].clone()).to_vec(), located.naming)
}

#[test]
fn every_scheme_is_read_in_its_order() {
    assert!(SCHEMES.len() >= 40);
    for (document, names) in SCHEMES {
        assert_eq!(chosen(names), (names.map(str::to_owned).to_vec(), Naming::Faces), "{document}");
    }
}

#[test]
fn numbers_without_a_documented_order_are_kept_in_theirs() {
    for (document, names) in NUMBERED {
        assert_eq!(chosen(names), (names.map(str::to_owned).to_vec(), Naming::Numbers), "{document}");
    }
}

#[test]
fn six_pictures_of_any_names_are_taken_as_they_sort() {
    let names = ["hills", "lake", "meadow", "road", "sun", "trees"].map(|name| format!("{name}.png"));
    assert_eq!(chosen(&names.each_ref().map(String::as_str)), (names.to_vec(), Naming::Nothing));
}

#[test]
fn several_sets_are_told_apart_by_their_beginnings() {
    let of = |time: &str| ["px", "nx", "py", "ny", "pz", "nz"].map(|face| format!("{time}_{face}.png"));
    let paths = [of("day"), of("night")].concat();
    let sets = super::listing::sets(&paths);
    let found: Vec<(&str, &str)> =
        sets.iter().map(|(prefix, located)| (prefix.as_str(), paths[located.six[2]].as_str())).collect();
    assert_eq!(found, [("day", "day_py.png"), ("night", "night_py.png")]);
}
