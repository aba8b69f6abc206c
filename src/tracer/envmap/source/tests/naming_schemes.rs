//! How programs and sites name the six faces: every scheme is read in the order that its document gives.

use super::listing::{Naming, find_faces};

/// Where the scheme is documented, and its names in the order +X -X +Y -Y +Z -Z: right, left, up, down, front, back.
///
/// The order is that of the names alone. A comment above a row says where its document puts the pictures elsewhere: z up, or
/// left on +X. The validator finds that by the pictures. A path without a site is one of a repository on GitHub.
type Scheme = (&'static str, [&'static str; 6]);

#[rustfmt::skip]
const SCHEMES: &[Scheme] = &[
    // Axes.
    ("https://threejs.org/docs/pages/CubeTextureLoader.html", ["px.png", "nx.png", "py.png", "ny.png", "pz.png", "nz.png"]),
    ("https://doc.babylonjs.com/features/featuresDeepDive/environment/skybox", ["skybox_px.jpg", "skybox_nx.jpg", "skybox_py.jpg", "skybox_ny.jpg", "skybox_pz.jpg", "skybox_nz.jpg"]),
    ("google/filament tools/cmgen/src/cmgen.cpp: iblRoughnessPrefilter", ["m0_px.hdr", "m0_nx.hdr", "m0_py.hdr", "m0_ny.hdr", "m0_pz.hdr", "m0_nz.hdr"]),
    ("tn-mai/exr2png README.md: \"_[pn][xyz]\"", ["sky_px.png", "sky_nx.png", "sky_py.png", "sky_ny.png", "sky_pz.png", "sky_nz.png"]),
    // Doom 3's axes: z is up.
    ("dhewm/dhewm3 neo/renderer/Image_files.cpp: axisSides", ["sky_px.tga", "sky_nx.tga", "sky_py.tga", "sky_ny.tga", "sky_pz.tga", "sky_nz.tga"]),
    // Axes of the equator: z is the north pole.
    ("CesiumGS/cesium packages/engine/Source/Scene/SkyBox.js: createEarthSkyBox", ["tycho2t3_80_px.jpg", "tycho2t3_80_mx.jpg", "tycho2t3_80_py.jpg", "tycho2t3_80_my.jpg", "tycho2t3_80_pz.jpg", "tycho2t3_80_mz.jpg"]),
    ("https://jeux.developpez.com/tutoriels/ios-opengl-es-2/?page=page_6", ["skyboxName_xp.jpg", "skyboxName_xn.jpg", "skyboxName_yp.jpg", "skyboxName_yn.jpg", "skyboxName_zp.jpg", "skyboxName_zn.jpg"]),
    // The issue reports that the tool writes +X and -X exchanged.
    ("https://github.com/podgorskiy/EnvMapTooL/issues/3", ["xp_.png", "xm_.png", "yp_.png", "ym_.png", "zp_.png", "zm_.png"]),
    // Humus; its front is negz.
    ("https://lovr.org/docs/v0.18.0/Environment/Skybox", ["posx.jpg", "negx.jpg", "posy.jpg", "negy.jpg", "posz.jpg", "negz.jpg"]),
    ("https://docs.pyvista.org/api/core/_autosummary/pyvista.cubemap", ["skybox2-posx.jpg", "skybox2-negx.jpg", "skybox2-posy.jpg", "skybox2-negy.jpg", "skybox2-posz.jpg", "skybox2-negz.jpg"]),
    ("https://doc.qt.io/qt-6/qml-qt3d-extras-skyboxentity.html", ["skybox_posx.png", "skybox_negx.png", "skybox_posy.png", "skybox_negy.png", "skybox_posz.png", "skybox_negz.png"]),
    ("https://webgl2fundamentals.org/webgl/resources/images/computer-history-museum/", ["pos-x.jpg", "neg-x.jpg", "pos-y.jpg", "neg-y.jpg", "pos-z.jpg", "neg-z.jpg"]),
    // z is up.
    ("pandorabox-io/skybox README.md", ["sky_pos_x.png", "sky_neg_x.png", "sky_pos_y.png", "sky_neg_y.png", "sky_pos_z.png", "sky_neg_z.png"]),
    ("google/santa-tracker-web static/scenes/snowbox/js/components/SceneSubjects/Sky/config.js", ["xpos.jpg", "xneg.jpg", "ypos.jpg", "yneg.jpg", "zpos.jpg", "zneg.jpg"]),
    ("laurence6/WebGL-demo texture_sky.js", ["positive-x.jpg", "negative-x.jpg", "positive-y.jpg", "negative-y.jpg", "positive-z.jpg", "negative-z.jpg"]),
    ("vojtahaj/pgrf3_projekt1 src/oglutils/OGLTextureCube.java: SUFFICES_POSITIVE_NEGATIVE", ["snow_positive_x.jpg", "snow_negative_x.jpg", "snow_positive_y.jpg", "snow_negative_y.jpg", "snow_positive_z.jpg", "snow_negative_z.jpg"]),
    // The pictures stand on their heads.
    ("mosra/magnum-examples src/cubemap/README.md", ["+x.jpg", "-x.jpg", "+y.jpg", "-y.jpg", "+z.jpg", "-z.jpg"]),
    ("https://openexr.com/en/latest/bin/exrenvmap.html: %", ["env+X.exr", "env-X.exr", "env+Y.exr", "env-Y.exr", "env+Z.exr", "env-Z.exr"]),
    ("https://manual.tinman3d.com/STABLE-PREVIEW/api/Tinman.Engine.Rendering.TextureHandle.html: FileCube", ["texture.X+.txb", "texture.X-.txb", "texture.Y+.txb", "texture.Y-.txb", "texture.Z+.txb", "texture.Z-.txb"]),
    // Words.
    ("JoeyDeVries/LearnOpenGL src/4.advanced_opengl/6.1.cubemaps_skybox/cubemaps_skybox.cpp", ["right.jpg", "left.jpg", "top.jpg", "bottom.jpg", "front.jpg", "back.jpg"]),
    ("Kitware/vtk-js Sources/IO/Misc/SkyboxReader/api.md", ["right.jpg", "left.jpg", "up.jpg", "down.jpg", "front.jpg", "back.jpg"]),
    ("cyberbotics/webots-doc reference/cubemap.md", ["noon_sunny_empty_right.jpg", "noon_sunny_empty_left.jpg", "noon_sunny_empty_top.jpg", "noon_sunny_empty_bottom.jpg", "noon_sunny_empty_front.jpg", "noon_sunny_empty_back.jpg"]),
    ("https://github.com/daid/EmptyEpsilon/wiki/Adding-skyboxes", ["right.png", "left.png", "top.png", "bottom.png", "front.png", "back.png"]),
    ("RodrigoRoldan18/3DGraphicsICA 3GP_ModelLoading_Start/ThreeGPStart/Skybox.cpp", ["SkyBox_Right.tga", "SkyBox_Left.tga", "SkyBox_Top.tga", "SkyBox_Bottom.tga", "SkyBox_Front.tga", "SkyBox_Back.tga"]),
    ("minetest-mods/skybox README.md", ["DarkStormyRight.jpg", "DarkStormyLeft.jpg", "DarkStormyUp.jpg", "DarkStormyDown.jpg", "DarkStormyFront.jpg", "DarkStormyBack.jpg"]),
    // Forward is +X, left is +Y, z is up; the pictures are turned as they are loaded.
    ("dhewm/dhewm3 neo/renderer/Image_files.cpp: cameraSides", ["sky_right.tga", "sky_left.tga", "sky_up.tga", "sky_down.tga", "sky_forward.tga", "sky_back.tga"]),
    ("https://wiki.eduke32.com/wiki/Skybox_(DEF): its keywords", ["right.png", "left.png", "ceiling.png", "floor.png", "front.png", "back.png"]),
    // "Left [+X]", "Right [-X]".
    ("https://docs.unity3d.com/Manual/shader-skybox-6sided.html", ["Day_RightTex.png", "Day_LeftTex.png", "Day_UpTex.png", "Day_DownTex.png", "Day_FrontTex.png", "Day_BackTex.png"]),
    // Left is given as +X.
    ("cocos2d/cocos2d-x-docs en/3d/cubemap.md", ["skybox/right.jpg", "skybox/left.jpg", "skybox/top.jpg", "skybox/bottom.jpg", "skybox/front.jpg", "skybox/back.jpg"]),
    ("https://docs.worldviz.com/vizard/latest/commands/viz/addEnvironmentMap.htm: _right", ["sky_right.jpg", "sky_left.jpg", "sky_up.jpg", "sky_down.jpg", "sky_front.jpg", "sky_back.jpg"]),
    // Quake and its heirs.
    // rt is +X, ft is -Y and z is up: facing ft, rt is on the left.
    ("id-Software/Quake-2 ref_gl/gl_warp.c: suf", ["env/unit1_rt.tga", "env/unit1_lf.tga", "env/unit1_up.tga", "env/unit1_dn.tga", "env/unit1_ft.tga", "env/unit1_bk.tga"]),
    ("https://valvedev.info/guides/custom-2d-skyboxes-and-the-light-environment-entity", ["desertrt.tga", "desertlf.tga", "desertup.tga", "desertdn.tga", "desertft.tga", "desertbk.tga"]),
    ("https://developer.valvesoftware.com/wiki/Skybox_(2D)", ["skynameRT.tga", "skynameLF.tga", "skynameUP.tga", "skynameDN.tga", "skynameFT.tga", "skynameBK.tga"]),
    ("OGRECave/ogre OgreMain/src/OgreTexture.cpp: CUBEMAP_SUFFIXES", ["cloudy_noon_rt.jpg", "cloudy_noon_lf.jpg", "cloudy_noon_up.jpg", "cloudy_noon_dn.jpg", "cloudy_noon_fr.jpg", "cloudy_noon_bk.jpg"]),
    ("http://www.neoaxis.com/dynwiki/Documentation/Entity_Types/Base/SkyBox.type", ["sky_rt.jpg", "sky_lf.jpg", "sky_up.jpg", "sky_dn.jpg", "sky_fr.jpg", "sky_bk.jpg"]),
    ("scut09/Scar Code/Scar/Scar/ModelManager.cpp: the media of Irrlicht", ["irrlicht2_rt.jpg", "irrlicht2_lf.jpg", "irrlicht2_up.jpg", "irrlicht2_dn.jpg", "irrlicht2_ft.jpg", "irrlicht2_bk.jpg"]),
    ("damocles-minetest/epic_skybox skyboxes.lua", ["mars_rt.jpg", "mars_lf.jpg", "mars_up.jpg", "mars_dn.jpg", "mars_ft.jpg", "mars_bk.jpg"]),
    ("https://create.roblox.com/docs/reference/engine/classes/Sky", ["sky512_rt.tex", "sky512_lf.tex", "sky512_up.tex", "sky512_dn.tex", "sky512_ft.tex", "sky512_bk.tex"]),
    // Initials.
    ("https://krpano.com/docu/xml/#image: pano_%s.jpg", ["pano_r.jpg", "pano_l.jpg", "pano_u.jpg", "pano_d.jpg", "pano_f.jpg", "pano_b.jpg"]),
    ("https://krpano.com/docu/panoformats/", ["basecube_r.jpg", "basecube_l.jpg", "basecube_u.jpg", "basecube_d.jpg", "basecube_f.jpg", "basecube_b.jpg"]),
    ("google/marzipano src/geometries/Cube.js: faceList", ["r.jpg", "l.jpg", "u.jpg", "d.jpg", "f.jpg", "b.jpg"]),
    ("mpetroff/pannellum utils/multires/generate.py: fallback", ["fallback/r.jpg", "fallback/l.jpg", "fallback/u.jpg", "fallback/d.jpg", "fallback/f.jpg", "fallback/b.jpg"]),
    ("mpetroff/pannellum utils/multires/generate.py: tiles", ["1/r0_0.jpg", "1/l0_0.jpg", "1/u0_0.jpg", "1/d0_0.jpg", "1/f0_0.jpg", "1/b0_0.jpg"]),
    // A compass whose north is the front.
    ("https://www.curseforge.com/minecraft/mc-mods/skybox-loader", ["east.png", "west.png", "up.png", "down.png", "north.png", "south.png"]),
    ("https://env3d.sourceforge.net/javadoc/env3d/advanced/EnvSkyRoom.html", ["east.png", "west.png", "top.png", "bottom.png", "north.png", "south.png"]),
    ("Vidarin/adminspace src/main/java/com/vidarin/adminspace/util/skyrenderer/SkyRendererCustomTexture.java", ["sky_e.png", "sky_w.png", "sky_u.png", "sky_d.png", "sky_n.png", "sky_s.png"]),
    // Numbers with a documented order: Minecraft's 0 to 5 are front, right, back, left, up, down; CubeMapGen's +X -X +Y -Y +Z -Z.
    ("https://minecraft.wiki/w/Panorama; Vivecraft/VivecraftMod VREffectsHelper.java: CUBE_FRONT", ["panorama_1.png", "panorama_3.png", "panorama_4.png", "panorama_5.png", "panorama_0.png", "panorama_2.png"]),
    ("gscept/CubeMapGen CCubeMapProcessor.h: CP_FACE_X_POS; %s_m%02d_c%02d.tga", ["OutputCubemap_m00_c00.tga", "OutputCubemap_m00_c01.tga", "OutputCubemap_m00_c02.tga", "OutputCubemap_m00_c03.tga", "OutputCubemap_m00_c04.tga", "OutputCubemap_m00_c05.tga"]),
];

/// Names that mean what they say, though no program is known to document them.
#[rustfmt::skip]
const PLAIN_WORDS: &[Scheme] = &[
    ("axis and sign", ["env_x_plus.png", "env_x_minus.png", "env_y_plus.png", "env_y_minus.png", "env_z_plus.png", "env_z_minus.png"]),
    ("sign and axis", ["plus_x.png", "minus_x.png", "plus_y.png", "minus_y.png", "plus_z.png", "minus_z.png"]),
    ("zenith and nadir", ["right.tif", "left.tif", "zenith.tif", "nadir.tif", "front.tif", "back.tif"]),
    ("rear", ["right.jpg", "left.jpg", "top.jpg", "bottom.jpg", "front.jpg", "rear.jpg"]),
    ("numbers before words", ["1 right.jpg", "2 left.jpg", "3 top.jpg", "4 bottom.jpg", "5 front.jpg", "6 back.jpg"]),
    ("German", ["rechts.jpg", "links.jpg", "oben.jpg", "unten.jpg", "vorne.jpg", "hinten.jpg"]),
    ("Czech", ["vpravo.jpg", "vlevo.jpg", "nahoře.jpg", "dole.jpg", "vpředu.jpg", "vzadu.jpg"]),
    ("Czech without accents", ["obloha_prava.png", "obloha_leva.png", "obloha_horni.png", "obloha_dolni.png", "obloha_predni.png", "obloha_zadni.png"]),
    ("French", ["droite.jpg", "gauche.jpg", "haut.jpg", "bas.jpg", "devant.jpg", "derrière.jpg"]),
    ("French, before and behind", ["ciel-droite.png", "ciel-gauche.png", "ciel-haut.png", "ciel-bas.png", "ciel-avant.png", "ciel-arriere.png"]),
    ("Spanish", ["derecha.jpg", "izquierda.jpg", "arriba.jpg", "abajo.jpg", "delante.jpg", "detrás.jpg"]),
    ("Portuguese", ["direita.jpg", "esquerda.jpg", "cima.jpg", "baixo.jpg", "frente.jpg", "trás.jpg"]),
    ("a French compass", ["est.jpg", "ouest.jpg", "haut.jpg", "bas.jpg", "nord.jpg", "sud.jpg"]),
    ("initials of a compass, top and bottom", ["sky_E.png", "sky_W.png", "sky_T.png", "sky_B.png", "sky_N.png", "sky_S.png"]),
    ("Italian", ["destra.jpg", "sinistra.jpg", "sopra.jpg", "sotto.jpg", "davanti.jpg", "dietro.jpg"]),
];

/// Names that number six pictures without saying how. Three documents give three orders for them.
#[rustfmt::skip]
const NUMBERED: &[(&str, [&str; 6])] = &[
    // +Z +X -Z -X +Y -Y.
    ("https://github.com/mpetroff/pannellum/issues/1215", ["pano0.png", "pano1.png", "pano2.png", "pano3.png", "pano4.png", "pano5.png"]),
    // Front, right, back, left, up, down.
    ("https://metacpan.org/pod/jpeg2qtvr", ["foo_0.jpg", "foo_1.jpg", "foo_2.jpg", "foo_3.jpg", "foo_4.jpg", "foo_5.jpg"]),
    // Front, back, up, down, left, right.
    ("mpetroff/pannellum utils/multires/generate.py: nona's files", ["face0000.tif", "face0001.tif", "face0002.tif", "face0003.tif", "face0004.tif", "face0005.tif"]),
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
    for (document, names) in SCHEMES.iter().chain(PLAIN_WORDS) {
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
