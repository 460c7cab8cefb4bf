//! STL of both forms, whole and hostile.

use chordal_geometry::Vec3;
use chordal_stock::mesh::write::write_stl;
use chordal_stock::mesh::{LengthUnit, Mesh, StlError, StlForm, StlOptions, TextProblem, read_stl};
use proptest::prelude::*;

const OPTIONS: StlOptions =
    StlOptions { unit: LengthUnit::Millimetre, weld: 0.0, limit: 1_000_000 };

fn tetrahedron() -> Mesh {
    let vertices = vec![Vec3::ZERO, Vec3::X * 2.0, Vec3::Y * 3.0, Vec3::Z * 4.0];
    Mesh::new(vertices, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]).unwrap()
}

fn text_of(mesh: &Mesh) -> String {
    let mut text = String::from("solid a part of 2 facets\n");
    for triangle in 0..mesh.triangles().len() {
        text.push_str("  facet normal nan 0 0\n    outer loop\n");
        for corner in mesh.corners(triangle) {
            text.push_str(&format!("      vertex {:e} {} {}\n", corner.x, corner.y, corner.z));
        }
        text.push_str("    endloop\n  endfacet\n");
    }
    text + "endsolid a part of 2 facets\n"
}

#[test]
fn both_forms_give_the_same_mesh() {
    let mesh = tetrahedron();
    let binary = read_stl(&write_stl(&mesh, LengthUnit::Millimetre).unwrap(), &OPTIONS).unwrap();
    let text = read_stl(text_of(&mesh).as_bytes(), &OPTIONS).unwrap();
    assert_eq!((binary.form, text.form), (StlForm::Binary, StlForm::Text));
    assert_eq!(binary.mesh, text.mesh);
    assert_eq!(binary.mesh.vertices().len(), 4);
    assert!(binary.mesh.edges().are_paired());
    assert!((binary.mesh.volume() - 4.0).abs() < 1e-12);
    let loud = text_of(&mesh).to_uppercase().replace("NAN", "nan").replace('\n', "\r\n");
    assert_eq!(read_stl(loud.as_bytes(), &OPTIONS).unwrap().mesh, text.mesh);
}

#[test]
fn the_unit_is_the_callers() {
    let bytes = write_stl(&tetrahedron(), LengthUnit::Inch).unwrap();
    let inches = StlOptions { unit: LengthUnit::Inch, ..OPTIONS };
    // 1/25.4 has no exact float, so corners come back within its rounding.
    let back = read_stl(&bytes, &inches).unwrap().mesh;
    assert!((back.volume() - 4.0).abs() < 1e-5);
    assert!(
        (read_stl(&bytes, &OPTIONS).unwrap().mesh.volume() - 4.0 / 25.4_f64.powi(3)).abs() < 1e-9
    );
}

#[test]
fn a_binary_file_may_begin_with_solid() {
    let mut bytes = write_stl(&tetrahedron(), LengthUnit::Millimetre).unwrap();
    bytes[..80].fill(b' ');
    bytes[..11].copy_from_slice(b"solid facet");
    assert_eq!(read_stl(&bytes, &OPTIONS).unwrap().form, StlForm::Binary);
    bytes.pop();
    let error = read_stl(&bytes, &OPTIONS).unwrap_err();
    assert_eq!(error, StlError::Size { declared: 4, needed: 284, size: 283 });
}

#[test]
fn declared_triangles_take_no_memory() {
    let mut bytes = vec![0; 84];
    bytes[80..].copy_from_slice(&1_000_000_000_u32.to_le_bytes());
    let error = read_stl(&bytes, &OPTIONS).unwrap_err();
    let needed = 50_000_000_084;
    assert_eq!(error, StlError::Size { declared: 1_000_000_000, needed, size: 84 });
    let four = write_stl(&tetrahedron(), LengthUnit::Millimetre).unwrap();
    let few = StlOptions { limit: 3, ..OPTIONS };
    let error = read_stl(&four, &few).unwrap_err();
    assert_eq!(error, StlError::TooMany { declared: Some(4), limit: 3 });
    assert!(error.to_string().contains("has 4 triangles"));
    let error = read_stl(text_of(&tetrahedron()).as_bytes(), &few).unwrap_err();
    assert_eq!(error, StlError::TooMany { declared: None, limit: 3 });
}

#[test]
fn nothing_and_almost_nothing() {
    assert_eq!(read_stl(b"", &OPTIONS), Err(StlError::Empty));
    assert_eq!(read_stl(b"G0 X0\n", &OPTIONS), Err(StlError::NoHead { size: 6 }));
    assert_eq!(read_stl(&[0; 84], &OPTIONS), Err(StlError::NoTriangle));
    assert_eq!(read_stl(b"solid x\nendsolid x", &OPTIONS), Err(StlError::NoTriangle));
    let weld = StlOptions { weld: f64::NAN, ..OPTIONS };
    assert!(matches!(read_stl(&[0; 84], &weld), Err(StlError::Weld { .. })));
}

#[test]
fn coordinates_that_are_none() {
    for (value, as_read) in [(f32::NAN, None), (f32::INFINITY, None), (2e5, Some(2e5))] {
        let mut bytes = write_stl(&tetrahedron(), LengthUnit::Millimetre).unwrap();
        // The second coordinate of the second corner of the third triangle.
        let corner = 84 + 2 * 50 + 12 + 12;
        bytes[corner + 4..corner + 8].copy_from_slice(&value.to_le_bytes());
        match read_stl(&bytes, &OPTIONS) {
            Err(StlError::Coordinate { triangle: 3, offset, value }) => {
                assert_eq!(offset, corner);
                assert!(as_read.is_none_or(|read: f64| read.to_bits() == value.to_bits()));
            }
            other => panic!("{other:?}"),
        }
    }
    let text = text_of(&tetrahedron()).replacen("vertex 0e0", "vertex 1e999", 1);
    match read_stl(text.as_bytes(), &OPTIONS) {
        Err(StlError::Coordinate { triangle: 1, offset, .. }) => {
            assert!(text[offset..].starts_with("vertex 1e999"));
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn text_that_does_not_follow_the_form() {
    let good = text_of(&tetrahedron());
    let problem = |text: &str| match read_stl(text.as_bytes(), &OPTIONS) {
        Err(StlError::Text { line, offset, problem }) => (line, offset, problem),
        other => panic!("{other:?}"),
    };
    let (line, offset, what) = problem(&good.replacen("0 3 0", "0 3,0 0", 1));
    assert_eq!((line, what), (5, TextProblem::Number { found: "3,0".into() }));
    assert_eq!(offset, good.find("3 0\n").unwrap());
    let (line, _, what) = problem(&good.replacen("outer", "inner", 1));
    assert_eq!(line, 3);
    assert_eq!(what, TextProblem::Word { expected: "outer", found: "inner".into() });
    let (line, offset, what) = problem(&good[..good.len() / 2]);
    assert!(matches!(what, TextProblem::End { .. } | TextProblem::Word { .. }), "{what:?}");
    assert!(line > 10 && offset <= good.len() / 2);
    let end = good.find("endsolid").unwrap();
    assert_eq!(problem(&good[..end]).2, TextProblem::End { expected: "endsolid" });
    assert_eq!(problem(&(good.clone() + "more")).0, 31);
    // A fourth corner is no triangle.
    let four = good.replacen("    endloop", "vertex 1 1 1\n    endloop", 1);
    assert_eq!(problem(&four).2, TextProblem::Word { expected: "endloop", found: "vertex".into() });
    // A second solid is.
    let two = read_stl((good.clone() + &good).as_bytes(), &OPTIONS).unwrap();
    assert_eq!(two.mesh.triangles().len(), 8);
}

#[test]
fn thin_triangles_are_left_out_and_open_nothing() {
    // One edge of the body in two parts, the second with a triangle that has no area left.
    let mesh = tetrahedron();
    let near = Vec3::new(1e-7, 0.0, 0.0);
    let mut vertices = mesh.vertices().to_vec();
    vertices.push(near);
    let triangles = vec![[4, 2, 1], [4, 1, 3], [1, 2, 3], [0, 3, 2], [0, 2, 4], [0, 4, 3]];
    let split = Mesh::new(vertices, triangles).unwrap();
    assert!(split.edges().are_paired());
    let bytes = write_stl(&split, LengthUnit::Millimetre).unwrap();
    let whole = read_stl(&bytes, &OPTIONS).unwrap();
    assert_eq!((whole.left_out, whole.mesh.vertices().len()), (0, 5));
    let welded = read_stl(&bytes, &StlOptions { weld: 1e-6, ..OPTIONS }).unwrap();
    assert_eq!((welded.left_out, welded.mesh.vertices().len()), (2, 4));
    assert!(welded.mesh.edges().are_paired());
    // A triangle of one place far away leaves nothing behind.
    let mut far = bytes;
    let count: u32 = 7;
    far[80..84].copy_from_slice(&count.to_le_bytes());
    far.extend([0; 12]);
    for _ in 0..9 {
        far.extend(500.0_f32.to_le_bytes());
    }
    far.extend([0; 2]);
    let read = read_stl(&far, &OPTIONS).unwrap();
    assert_eq!((read.left_out, read.mesh), (1, whole.mesh));
}

proptest! {
    #[test]
    fn any_bytes_get_an_answer(
        changes in proptest::collection::vec((0.0..1.0_f64, any::<u8>()), 0..8),
        cut in 0.0..1.2_f64,
        text in any::<bool>(),
    ) {
        let mesh = tetrahedron();
        let mut bytes = if text {
            text_of(&mesh).into_bytes()
        } else {
            write_stl(&mesh, LengthUnit::Millimetre).unwrap()
        };
        let size = bytes.len() as f64;
        for (at, byte) in changes {
            bytes[(at * size) as usize] = byte;
        }
        bytes.truncate((cut * size) as usize);
        if let Ok(stl) = read_stl(&bytes, &OPTIONS) {
            prop_assert!(stl.mesh.vertices().iter().all(|vertex| vertex.is_finite()));
            prop_assert_eq!(stl.mesh.triangles().len() + stl.left_out, 4);
            prop_assert!(stl.mesh.volume().is_finite());
            // What was read can be written and read again.
            let again = read_stl(&write_stl(&stl.mesh, LengthUnit::Millimetre).unwrap(), &OPTIONS);
            prop_assert!(again.is_ok() || stl.mesh.triangles().is_empty());
        }
    }
}
