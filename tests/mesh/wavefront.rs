//! OBJ and MTL files.

use skycube::math::{DVec3, Vec3};
use skycube::shapes::mesh::{ObjFile, ObjMap, ObjMaterial, ObjMaterials};

const MATERIALS: &str =
    "newmtl red\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 20\nNi 1.5\nd 0.25\nillum 2\nmap_Kd tex/a b.png\nnewmtl plain\n";

const OBJECT: &str = "# two squares\nmtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
    vn 0 0 1\nf 1 2 3 4\nusemtl red\nf 1/1/1 2/2/1 3/3/1 4/4/1\nusemtl plain\nf -4 -3 -2\nusemtl red\nf 1/1/1 2/2/1 4/4/1\n";

/// Reads an object with these materials beside it; the error has the folder taken out.
fn read(object: &[u8], materials: Option<&str>) -> Result<(ObjFile, ObjMaterials), String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("o.obj");
    std::fs::write(&path, object).unwrap();
    if let Some(text) = materials {
        std::fs::write(folder.path().join("m.mtl"), text).unwrap();
    }
    let shorten =
        |error: skycube::error::Error| error.to_string().replace(&format!("{}/", folder.path().display()), "");
    let file = ObjFile::read(&path).map_err(shorten)?;
    let mut materials = file.materials().map_err(shorten)?;
    for map in materials.groups.iter_mut().flatten().filter_map(|material| material.diffuse_map.as_mut()) {
        map.file = map.file.strip_prefix(&folder).unwrap().into();
    }
    Ok((file, materials))
}

fn refusal(object: &str, materials: Option<&str>) -> String {
    read(object.as_bytes(), materials).unwrap_err()
}

/// The area of all triangles.
fn area(file: &ObjFile) -> f64 {
    let geometry = file.mesh.geometry();
    (0..geometry.triangles.len() as u32).map(|triangle| geometry.area_vector(triangle).length() / 2.0).sum()
}

#[test]
fn reads_groups_materials_and_polygons() {
    let (file, materials) = read(OBJECT.as_bytes(), Some(MATERIALS)).unwrap();
    assert_eq!(file.mesh.geometry().materials, [0, 0, 1, 1, 2, 1]);
    assert_eq!(materials.groups[0], None);
    let red = ObjMaterial {
        name: "red".into(),
        diffuse: Some(Vec3::X),
        specular: Some(Vec3::splat(0.5)),
        shininess: Some(20.0),
        index_of_refraction: Some(1.5),
        dissolve: Some(0.25),
        illumination: Some(2),
        diffuse_map: Some(ObjMap { file: "tex/a b.png".into(), repeat: [1.0, 1.0] }),
        ..ObjMaterial::default()
    };
    assert_eq!(materials.groups[1].as_ref(), Some(&red));
    assert_eq!(materials.groups[2].as_ref().unwrap().name, "plain");
    let corner = file.mesh.surface(3, [0.0, 0.0, 1.0]);
    assert_eq!((corner.position, corner.texture_coordinates.to_array()), (DVec3::Y, [0.0, 1.0]));
    assert_eq!(corner.geometric_normal, DVec3::Z);
}

#[test]
fn needs_no_materials_where_none_are_used() {
    let (file, _) = read(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", None).unwrap();
    assert_eq!(file.groups, [None]);
    assert!(file.mesh.geometry().normals.is_empty());
    // Those that are named but missing are nobody's business until somebody asks for them.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("o.obj");
    std::fs::write(&path, OBJECT).unwrap();
    let file = ObjFile::read(&path).unwrap();
    assert!(file.materials().is_err());
}

#[test]
fn reads_what_programs_write() {
    let square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n";
    let wide: Vec<u8> = square.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let files: [&[u8]; 12] = [
        square.as_bytes(),
        &square.replace('\n', "\r").into_bytes(),
        &square.replace('\n', "\r\n").into_bytes(),
        &[b"\xEF\xBB\xBF", square.as_bytes()].concat(),
        &[b"\xFF\xFE", &wide[..]].concat(),
        &square.replace("f 1 2", "f 1 2 \\\n").into_bytes(),
        &square.replace("0\n", "0 # zero\n").into_bytes(),
        &square.replace("2 2 0", "2. 2.0. 0.").into_bytes(),
        // Homogeneous coordinates, and the colours of some vertices.
        &square.replace("2 2 0", "1 1 0 0.5").into_bytes(),
        &square.replace("2 2 0", "2 2 0 1 0.5 0").into_bytes(),
        &format!("{square}l 1 2 99\np 1\n").into_bytes(),
        &square.replace("f 1 2 3 4", "vn nan nan nan\nf -4//1 -3//1 -2//1\nf 1 3 4").into_bytes(),
    ];
    for file in files {
        let text = String::from_utf8_lossy(file).into_owned();
        let (file, _) = read(file, None).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!(area(&file), 4.0, "{text}");
        assert_eq!(file.mesh.bounds().maximum, DVec3::new(2.0, 2.0, 0.0), "{text}");
    }
}

#[test]
fn what_is_left_out_is_said() {
    let (file, _) =
        read(b"v 0 0 0 1 0 0\nv 1. 0 0. 1 1 1\nv 0 1. 0\nv 0 0 2 0.5\nl 1 2\nl 2 3\nf 1 2 3", None).unwrap();
    insta::assert_snapshot!(file.remarks.join("\n"), @r"
    homogeneous coordinates x y z w are divided by w (line 4)
    points and lines are not drawn (2 times, first in line 5)
    ");
    let (_, materials) = read(
        b"mtllib m.mtl gone.mtl\nmtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red # comment\nf 1 2 3\nusemtl None\nf 1 2 3",
        Some("Kd 1 2 3\nnewmtl red\nKs 1.0. 1 1\nKa 1 1 1\nTf 1 1 1\nmap_Kd -s 2 3 1 -mm 0 1 a b.png\nmap_Bump x.png\nPs 0\n"),
    )
    .unwrap();
    let red = materials.groups[0].as_ref().unwrap();
    assert_eq!(red.diffuse_map, Some(ObjMap { file: "a b.png".into(), repeat: [2.0, 3.0] }));
    assert_eq!(red.unread.iter().collect::<Vec<_>>(), ["Ka", "map_Bump", "map_Kd -mm"]);
    assert_eq!((red.specular, &materials.groups[1]), (Some(Vec3::ONE), &None));
    let remarks = materials.remarks.join("\n");
    assert!(
        remarks.contains("m.mtl:3: \"Ks 1.0. 1 1\"") && remarks.contains("gone.mtl: the file does not exist"),
        "{remarks}"
    );
}

#[test]
fn libraries_are_found_where_exporters_put_them() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    std::fs::create_dir(at("sub")).unwrap();
    for file in ["sub/a.mtl", "a b.mtl", "c.mtl"] {
        std::fs::write(at(file), "newmtl red\nKd 1 0 0\nmap_Kd tex\\a.png\n").unwrap();
    }
    for (line, folder) in
        [("sub\\a.mtl", "sub"), (".\\sub/a.mtl", "sub"), ("a b.mtl", ""), ("\"a b.mtl\"", ""), ("C:\\x\\c.mtl", "")]
    {
        std::fs::write(at("o.obj"), format!("mtllib {line}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n"))
            .unwrap();
        let materials = ObjFile::read(at("o.obj")).unwrap().materials().unwrap();
        let map = materials.groups[0].as_ref().unwrap().diffuse_map.as_ref().unwrap();
        assert_eq!(
            map.file.components().collect::<Vec<_>>(),
            at(folder).join("tex/a.png").components().collect::<Vec<_>>()
        );
        assert_eq!(materials.remarks.len(), usize::from(line.starts_with('C')), "{:?}", materials.remarks);
    }
}

#[test]
fn what_lies_far_from_the_origin_keeps_its_form() {
    let place = DVec3::new(5_400_000.0, 470_000.0, 300.0);
    let vertex = |x: f64, y: f64| format!("v {} {} {}\n", place.x + x, place.y + y, place.z);
    let text = [vertex(0.0, 0.0), vertex(0.01, 0.0), vertex(0.01, 0.02), "f 1 2 3\n".to_owned()].concat();
    let (file, _) = read(text.as_bytes(), None).unwrap();
    assert!((area(&file) - 1e-4).abs() < 1e-9, "{}", area(&file));
    assert!((file.centre - place - DVec3::new(0.005, 0.01, 0.0)).length() < 1e-8, "{}", file.centre);
}

#[test]
fn vertices_are_shared_where_all_their_parts_are() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 2//2 3//2\nf 3//1 2//1 1//2\n";
    let (file, _) = read(text.as_bytes(), None).unwrap();
    let geometry = file.mesh.geometry();
    assert_eq!(geometry.triangles, [[0, 1, 2], [3, 4, 5], [2, 1, 3]]);
    assert_eq!(geometry.normals, [Vec3::Z, Vec3::Z, Vec3::Z, Vec3::Y, Vec3::Y, Vec3::Y]);
}

#[test]
fn glass_knows_whether_it_has_an_inside() {
    let cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\n\
        f 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let outside = |text: &str| read(text.as_bytes(), None).unwrap().0.mesh.geometry().outside_of(|_| true);
    assert_eq!((outside(cube).open_edges, outside(cube).problem()), (0, None));
    assert!((outside(cube).volume - 1.0).abs() < 1e-12);
    assert_eq!(outside(&cube.replace("f 4 1 5 8\n", "")).open_edges, 4);
    let turned = cube.replace("f ", "f -1 ").replace("f -1 4 3 2 1", "f 1 2 3 4");
    let turned = ["5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"].iter().fold(turned, |text, face| {
        let reversed: Vec<&str> = face.split(' ').rev().collect();
        text.replace(&format!("f -1 {face}"), &format!("f {}", reversed.join(" ")))
    });
    assert!(outside(&turned).problem().unwrap().contains("inwards"));
}

#[test]
fn names_the_line_that_is_wrong() {
    let face = |line: &str| refusal(&format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{line}\n"), None);
    insta::assert_snapshot!(face("f 1 2 4"), @r#"
    o.obj:4: the corner "4" has vertex 4
      expected: 1 to 3, or -1 to -3: 3 are defined before this line
    "#);
    insta::assert_snapshot!(face("f 1 2 0"), @r#"
    o.obj:4: the corner "0" has vertex 0
      expected: 1 to 3, or -1 to -3: 3 are defined before this line
    "#);
    insta::assert_snapshot!(face("f 1/1 2/1 3/1"), @r#"
    o.obj:4: the corner "1/1" has texture coordinate 1
      expected: none: no line of this kind comes before it
    "#);
    insta::assert_snapshot!(face("f 1 two 3"), @r#"
    o.obj:4: found the corner "two"
      expected: v, v/vt, v//vn or v/vt/vn
    "#);
    insta::assert_snapshot!(face("f 1 2"), @r#"
    o.obj:4: a face of 2 corners
      expected: at least three
    "#);
    insta::assert_snapshot!(face("vn 0 0 1\nf 1//1 2 3"), @r#"
    o.obj:5: found "f 1//1 2 3"
      expected: the same parts at all corners of the face
    "#);
    insta::assert_snapshot!(face("v 1 2"), @r#"
    o.obj:4: found "1 2"
      expected: 3 finite numbers
    "#);
    insta::assert_snapshot!(face("usemtl red\nf 1 2 3"), @r#"
    o.obj:4: no material "red"
      expected: a `mtllib` line for a file with this material
      help: put the MTL file where the `mtllib` line of the OBJ file points, or give the shape a `material` of the scene
    "#);
    insta::assert_snapshot!(face(""), @r#"
    o.obj: the mesh has no triangles
      expected: at least one triangle
    "#);
}

#[test]
fn names_the_material_file_that_is_wrong() {
    insta::assert_snapshot!(refusal(OBJECT, None), @r#"
    m.mtl: the file does not exist
      help: put the MTL file where the `mtllib` line of the OBJ file points, or give the shape a `material` of the scene
    "#);
    insta::assert_snapshot!(refusal(OBJECT, Some("newmtl plain\n")), @r#"
    o.obj:13: no material "red"
      expected: one of plain
      help: put the MTL file where the `mtllib` line of the OBJ file points, or give the shape a `material` of the scene
    "#);
    insta::assert_snapshot!(refusal(OBJECT, Some("newmtl red\nKd 1 0\n")), @r#"
    m.mtl:2: found "Kd 1 0"
      expected: three numbers
      help: put the MTL file where the `mtllib` line of the OBJ file points, or give the shape a `material` of the scene
    "#);
}

#[test]
fn a_file_that_is_not_there_is_an_error() {
    assert!(ObjFile::read("no/such.obj").unwrap_err().to_string().starts_with("no/such.obj: the file does not exist"));
}
