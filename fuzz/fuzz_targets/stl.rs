//! STL of any bytes: an answer, never a crash; and what was read can be checked, made a shape, asked for its
//! cells, written and read again.

#![no_main]

use chordal_geometry::Vec3;
use chordal_stock::mesh::write::write_stl;
use chordal_stock::mesh::{LengthUnit, StlOptions, read_stl};
use chordal_stock::shape::{CellGrid, Frustum, RoundBody, SolidShape};
use libfuzzer_sys::fuzz_target;

/// Small bodies, so that all of it is quick.
const LIMIT: usize = 64;

fuzz_target!(|input: (u8, &[u8])| {
    let (choice, bytes) = input;
    let weld = if choice & 1 == 0 { 0.0 } else { 1e-3 };
    let unit = if choice & 2 == 0 { LengthUnit::Millimetre } else { LengthUnit::Inch };
    let options = StlOptions { unit, weld, limit: LIMIT };
    let stl = match read_stl(bytes, &options) {
        Ok(stl) => stl,
        Err(error) => {
            assert!(!error.to_string().is_empty());
            return;
        }
    };
    assert!(stl.mesh.triangles().len() + stl.left_out <= LIMIT);
    assert!(stl.mesh.vertices().iter().all(|vertex| vertex.is_finite()));
    let edges = stl.mesh.edges();
    let bounds = stl.mesh.bounds();
    let exact = StlOptions { unit, weld: 0.0, limit: LIMIT };
    let again = read_stl(&write_stl(&stl.mesh, unit).expect("few triangles"), &exact);
    // Rounding to floats may leave triangles out, and it opens nothing.
    if let (Ok(again), true) = (again, edges.are_closed()) {
        assert!(again.mesh.triangles().is_empty() || again.mesh.edges().are_closed());
    }
    let Ok(shape) = SolidShape::surface(stl.mesh) else { return };
    let size = bounds.size();
    let cell = size.x.max(size.y).max(1e-3) / 7.0;
    let origin = [bounds.min.x - 0.3 * cell, bounds.min.y - 0.4 * cell];
    let grid = CellGrid { origin, cell, columns: 9, rows: 9, grow: 0.0 };
    if let Ok(cells) = shape.cells(&grid) {
        let height = |from: usize| {
            let spans = |at: usize| {
                let of = if from == 0 {
                    cells.outer(at % 9, at / 9)
                } else {
                    cells.inner(at % 9, at / 9)
                };
                assert!(of.windows(2).all(|two| two[0].to < two[1].from));
                of.iter().map(|span| span.to - span.from).sum::<f64>()
            };
            (0..81).map(spans).sum::<f64>()
        };
        assert!(height(1) <= height(0));
    }
    let part = Frustum { from: 0.0, to: 20.0, lower: 1.0, upper: 3.0 };
    let body = RoundBody::new(vec![part]).expect("a cone");
    let tip = bounds.max + Vec3::new(1.0, -2.0, 0.5);
    let found = shape.distance(&body, tip, 1e-6);
    assert!(found.lower <= found.upper && found.upper.is_finite());
});
