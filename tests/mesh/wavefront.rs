//! OBJ and MTL files.

use skycube::math::{DVec3, Vec3};
use skycube::shapes::mesh::{ObjFile, ObjMaterial};

const MATERIALS: &str =
    "newmtl red\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 20\nNi 1.5\nd 0.25\nillum 2\nmap_Kd tex/a b.png\nnewmtl plain\n";

const OBJECT: &str = "# two squares\nmtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
    vn 0 0 1\nf 1 2 3 4\nusemtl red\nf 1/1/1 2/2/1 3/3/1 4/4/1\nusemtl plain\nf -4 -3 -2\nusemtl red\nf 1/1/1 2/2/1 4/4/1\n";

/// Reads an object with these materials beside it; the error has the folder taken out.
fn read(object: &str, materials: Option<&str>) -> Result<ObjFile, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("o.obj");
    std::fs::write(&path, object).unwrap();
    if let Some(text) = materials {
        std::fs::write(folder.path().join("m.mtl"), text).unwrap();
    }
    let shorten =
        |error: skycube::error::Error| error.to_string().replace(&format!("{}/", folder.path().display()), "");
    ObjFile::read(&path).map_err(shorten).map(|mut file| {
        for material in file.groups.iter_mut().flatten() {
            material.diffuse_map = material.diffuse_map.as_ref().map(|p| p.strip_prefix(&folder).unwrap().into());
        }
        file
    })
}

fn refusal(object: &str, materials: Option<&str>) -> String {
    read(object, materials).unwrap_err()
}

#[test]
fn reads_groups_materials_and_polygons() {
    let file = read(OBJECT, Some(MATERIALS)).unwrap();
    assert_eq!(file.mesh.geometry().materials, [0, 0, 1, 1, 2, 1]);
    assert_eq!(file.groups[0], None);
    let red = ObjMaterial {
        name: "red".into(),
        diffuse: Some(Vec3::X),
        specular: Some(Vec3::splat(0.5)),
        shininess: Some(20.0),
        index_of_refraction: Some(1.5),
        dissolve: Some(0.25),
        illumination: Some(2),
        diffuse_map: Some("tex/a b.png".into()),
    };
    assert_eq!(file.groups[1].as_ref(), Some(&red));
    assert_eq!(file.groups[2].as_ref().unwrap().name, "plain");
    let corner = file.mesh.surface(3, [0.0, 0.0, 1.0]);
    assert_eq!((corner.position, corner.texture_coordinates.to_array()), (DVec3::Y, [0.0, 1.0]));
    assert_eq!(corner.geometric_normal, DVec3::Z);
}

#[test]
fn needs_no_materials_where_none_are_used() {
    let file = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", None).unwrap();
    assert_eq!(file.groups, [None]);
    assert!(file.mesh.geometry().normals.is_empty());
}

#[test]
fn names_the_line_that_is_wrong() {
    let face = |line: &str| refusal(&format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{line}\n"), None);
    insta::assert_snapshot!(face("f 1 2 4"), @r#"
    o.obj:4: the corner "4" has vertex 4
      expected: 1 to 3, or -1 to -3: so many are defined before this line
    "#);
    insta::assert_snapshot!(face("f 1 2 0"), @r#"
    o.obj:4: the corner "0" has vertex 0
      expected: 1 to 3, or -1 to -3: so many are defined before this line
    "#);
    insta::assert_snapshot!(face("f 1/1 2/1 3/1"), @r#"
    o.obj:4: the corner "1/1" has texture coordinate 1
      expected: none: no such line comes before it
    "#);
    insta::assert_snapshot!(face("f 1 two 3"), @r#"
    o.obj:4: found the corner "two"
      expected: v, v/vt, v//vn or v/vt/vn
    "#);
    insta::assert_snapshot!(face("f 1 2"), @r#"
    o.obj:4: a face of 2 corners
      expected: at least three
    "#);
    insta::assert_snapshot!(face("f 1//1 2 3"), @r#"
    o.obj:4: found "f 1//1 2 3"
      expected: the same parts at all corners of the face
    "#);
    insta::assert_snapshot!(face("v 1 2"), @r#"
    o.obj:4: found "1 2"
      expected: 3 finite numbers
    "#);
    insta::assert_snapshot!(face("usemtl red"), @r#"
    o.obj:4: no material "red"
      expected: a `mtllib` line before it that names a file with this material
      help: put the MTL file where the OBJ file's `mtllib` line says, or remove its `mtllib` and `usemtl` lines
    "#);
    insta::assert_snapshot!(face(""), @r#"
    o.obj: the mesh has no triangles
      expected: at least one triangle
    "#);
}

#[test]
fn names_the_material_file_that_is_wrong() {
    insta::assert_snapshot!(refusal(OBJECT, None), @r#"
    m.mtl: cannot be read: No such file or directory (os error 2)
      help: put the MTL file where the OBJ file's `mtllib` line says, or remove its `mtllib` and `usemtl` lines
    "#);
    insta::assert_snapshot!(refusal(OBJECT, Some("newmtl plain\n")), @r#"
    o.obj:13: no material "red"
      expected: one of plain
      help: put the MTL file where the OBJ file's `mtllib` line says, or remove its `mtllib` and `usemtl` lines
    "#);
    insta::assert_snapshot!(refusal(OBJECT, Some("newmtl red\nKd 1 0\n")), @r#"
    m.mtl:2: found "Kd 1 0"
      expected: three numbers
      help: put the MTL file where the OBJ file's `mtllib` line says, or remove its `mtllib` and `usemtl` lines
    "#);
}

#[test]
fn a_file_that_is_not_there_is_an_error() {
    assert!(ObjFile::read("no/such.obj").unwrap_err().to_string().starts_with("no/such.obj: cannot be read"));
}
