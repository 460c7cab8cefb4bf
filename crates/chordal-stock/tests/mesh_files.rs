//! GLB and 3MF: what is in the bytes. `tools/check_meshes.py` opens them with another program.

mod common;

use chordal_geometry::Vec3;
use chordal_stock::Mesh;
use chordal_stock::mesh::write::{WriteError, write_glb, write_threemf};
use serde_json::Value;

fn word(bytes: &[u8], at: usize) -> usize {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize
}

fn half(bytes: &[u8], at: usize) -> usize {
    usize::from(u16::from_le_bytes(bytes[at..at + 2].try_into().unwrap()))
}

/// The chunks of a GLB: JSON and numbers.
fn glb(bytes: &[u8]) -> (Value, &[u8]) {
    assert_eq!(&bytes[..4], b"glTF");
    assert_eq!((word(bytes, 4), word(bytes, 8)), (2, bytes.len()));
    let json = word(bytes, 12);
    assert_eq!((json % 4, &bytes[16..20]), (0, &b"JSON"[..]));
    let document = serde_json::from_slice(&bytes[20..20 + json]).unwrap();
    let rest = &bytes[20 + json..];
    if rest.is_empty() {
        return (document, rest);
    }
    assert_eq!((word(rest, 0), &rest[4..8]), (rest.len() - 8, &b"BIN\0"[..]));
    (document, &rest[8..])
}

#[test]
fn a_glb_has_its_vertices_in_metres_with_y_up() {
    let mesh = common::cuboid(Vec3::new(1.0, 2.0, 3.0), Vec3::new(11.1, 22.0, 33.0));
    let colours: Vec<[u8; 4]> = (0..8).map(|corner| [corner, 10, 20, 255]).collect();
    let name = "a \"part\" \\ \n é";
    let bytes = write_glb(&mesh, name, Some(&colours)).unwrap();
    let (document, numbers) = glb(&bytes);
    assert_eq!(document["nodes"][0]["name"], name);
    assert_eq!(document["buffers"][0]["byteLength"], numbers.len());
    let views = document["bufferViews"].as_array().unwrap();
    let accessors = document["accessors"].as_array().unwrap();
    let ends = views.iter().fold(0, |end, view| {
        assert_eq!(view["byteOffset"], end);
        assert_eq!(end % 4, 0);
        end + view["byteLength"].as_u64().unwrap()
    });
    assert_eq!(ends as usize, numbers.len());
    let counts: Vec<u64> = accessors.iter().map(|row| row["count"].as_u64().unwrap()).collect();
    assert_eq!(counts, [8, 36, 8]);

    let float = |at: usize| f32::from_le_bytes(numbers[at..at + 4].try_into().unwrap());
    for (corner, vertex) in mesh.vertices().iter().enumerate() {
        let at = corner * 12;
        let expected = [vertex.x / 1e3, vertex.z / 1e3, -vertex.y / 1e3];
        let found = [0, 4, 8].map(|axis| float(at + axis));
        assert_eq!(found, expected.map(|value| value as f32));
    }
    // The bounds are the numbers themselves.
    let first = &accessors[0];
    for axis in 0..3 {
        let of = |corner: usize| f64::from(float(corner * 12 + 4 * axis));
        let low = (0..8).map(of).fold(f64::INFINITY, f64::min);
        let high = (0..8).map(of).fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(first["min"][axis].as_f64(), Some(low));
        assert_eq!(first["max"][axis].as_f64(), Some(high));
    }
    let indices: Vec<u32> = (0..36).map(|at| word(numbers, 96 + 4 * at) as u32).collect();
    assert_eq!(indices, mesh.triangles().as_flattened());
    assert_eq!(&numbers[96 + 144..], colours.as_flattened());
}

#[test]
fn colours_are_one_for_each_vertex_or_none() {
    let mesh = common::cuboid(Vec3::ZERO, Vec3::new(1.0, 1.0, 1.0));
    let error = write_glb(&mesh, "", Some(&[[0; 4]; 7])).unwrap_err();
    assert_eq!(error, WriteError::Colours { colours: 7, vertices: 8 });
    let bytes = write_glb(&mesh, "", None).unwrap();
    let (plain, _) = glb(&bytes);
    assert!(plain["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"].is_null());
    let bytes = write_glb(&Mesh::default(), "", None).unwrap();
    let (empty, numbers) = glb(&bytes);
    assert!(empty["meshes"].is_null() && numbers.is_empty());
}

#[test]
fn a_threemf_is_an_archive_with_a_model_in_millimetres() {
    let mesh = common::cuboid(Vec3::new(-0.0, 0.1, 1.0 / 3.0), Vec3::new(1.0, 2.0, 3.0));
    let bytes = write_threemf(&mesh, "<&\"> \u{1}").unwrap();
    // From the end: the directory, and by it each file.
    let end = bytes.len() - 22;
    assert_eq!((word(&bytes, end), half(&bytes, end + 10)), (0x0605_4B50, 3));
    let mut at = word(&bytes, end + 16);
    assert_eq!(at + word(&bytes, end + 12), end);
    let mut files = Vec::new();
    while at < end {
        assert_eq!(word(&bytes, at), 0x0201_4B50);
        let (size, length, start) =
            (word(&bytes, at + 20), half(&bytes, at + 28), word(&bytes, at + 42));
        let name = std::str::from_utf8(&bytes[at + 46..at + 46 + length]).unwrap();
        assert_eq!((word(&bytes, start), half(&bytes, start + 26)), (0x0403_4B50, length));
        assert_eq!(bytes[start + 4..start + 30], bytes[at + 6..at + 32]);
        assert_eq!(&bytes[start + 30..start + 30 + length], name.as_bytes());
        let content = &bytes[start + 30 + length..][..size];
        assert_eq!(word(&bytes, at + 16), crc32fast::hash(content) as usize);
        files.push((name, std::str::from_utf8(content).unwrap()));
        at += 46 + length;
    }
    let names: Vec<&str> = files.iter().map(|file| file.0).collect();
    assert_eq!(names, ["[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"]);
    let model = files[2].1;
    assert!(model.contains("unit=\"millimeter\""));
    assert!(model.contains("name=\"&lt;&amp;&quot;&gt; \""));
    let corner = format!("<vertex x=\"0\" y=\"0.1\" z=\"{}\"/>", 1.0 / 3.0);
    assert!(model.contains(&corner), "{model}");
    assert_eq!(model.matches("<vertex ").count(), 8);
    assert_eq!(model.matches("<triangle ").count(), 12);
}
