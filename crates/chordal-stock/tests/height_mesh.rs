//! The surface of a height field: closed, each edge with two triangles, the volume of its columns.

use std::collections::BTreeMap;

use chordal_geometry::Vec3;
use chordal_stock::mesh::write::write_stl;
use chordal_stock::mesh::{
    HeightField, HeightFieldError, HeightMesh, LayerField, LengthUnit, Mesh, SolidIntervals,
    StlOptions, read_stl,
};
use proptest::prelude::*;

fn field(columns: usize, heights: &[f32]) -> HeightField<'_> {
    let rows = heights.len().checked_div(columns).unwrap_or(0);
    HeightField {
        origin: Vec3::new(-3.0, 7.0, 20.0),
        cell: 0.5,
        columns,
        rows,
        size: [0.5 * columns as f64, 0.5 * rows as f64],
        heights,
        floor: -2.0,
    }
}

/// Whether each edge has two triangles in opposite directions, and the triangles around each vertex
/// are one ring: counted here by other means than those of the crate.
fn is_manifold(mesh: &Mesh) -> bool {
    let mut uses: BTreeMap<(u32, u32), usize> = BTreeMap::new();
    let mut around: BTreeMap<u32, BTreeMap<u32, u32>> = BTreeMap::new();
    for &[a, b, c] in mesh.triangles() {
        for (from, to, third) in [(a, b, c), (b, c, a), (c, a, b)] {
            *uses.entry((from, to)).or_default() += 1;
            // Around `from` the ring goes on from `to` to `third`.
            around.entry(from).or_default().insert(to, third);
        }
    }
    let paired = uses.iter().all(|(&(a, b), &count)| count == 1 && uses.get(&(b, a)) == Some(&1));
    paired
        && around.len() == mesh.vertices().len()
        && around.values().all(|ring| {
            let start = *ring.keys().next().unwrap();
            let mut at = start;
            let mut length = 0;
            loop {
                at = ring[&at];
                length += 1;
                if at == start || length > ring.len() {
                    return length == ring.len();
                }
            }
        })
}

fn check(field: &HeightField, tolerance: f64) -> HeightMesh {
    let made = field.mesh(tolerance).unwrap();
    assert!(made.deviation <= tolerance);
    // Joined faces have heights in steps of 2⁻¹⁶ mm, and what that leaves is at most half a step over one face.
    let area = (field.columns * field.rows) as f64 * field.cell * field.cell;
    let rounding = if tolerance > 0.0 { area / 131_072.0 } else { 0.0 };
    is_whole(made, field.volume(), rounding)
}

/// A closed surface with a volume, also after it was a file without shared vertices.
fn is_whole(made: HeightMesh, volume: f64, rounding: f64) -> HeightMesh {
    let off = (made.mesh.volume() - volume).abs();
    assert!(off <= 1e-10 * (1.0 + volume) + rounding, "{off}");
    if volume > 0.0 {
        assert!(made.mesh.edges().are_paired(), "{:?}", made.mesh.edges());
        assert!(is_manifold(&made.mesh));
        // Through a form without shared vertices.
        let bytes = write_stl(&made.clone().parted(1e-4), LengthUnit::Millimetre).unwrap();
        let unit = LengthUnit::Millimetre;
        let back = read_stl(&bytes, &StlOptions { unit, weld: 0.0, limit: usize::MAX }).unwrap();
        assert!(back.mesh.edges().are_paired(), "{:?}", back.mesh.edges());
        assert!((back.mesh.volume() - volume).abs() <= 1e-3 * volume + rounding);
    } else {
        assert!(made.mesh.triangles().is_empty());
    }
    made
}

/// The height of the surface over a place inside a cell, by the triangle that faces up there.
fn top(mesh: &Mesh, x: f64, y: f64) -> Option<f64> {
    (0..mesh.triangles().len()).find_map(|triangle| {
        let [a, b, c] = mesh.corners(triangle);
        let side = |a: Vec3, b: Vec3| (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
        let area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        let inside = side(a, b) >= 0.0 && side(b, c) >= 0.0 && side(c, a) >= 0.0;
        (area > 0.0 && inside).then_some(a.z)
    })
}

#[test]
fn one_block_is_twelve_triangles() {
    let heights = [1.0; 600];
    let made = check(&field(20, &heights), 0.0);
    assert_eq!((made.mesh.triangles().len(), made.mesh.vertices().len()), (12, 8));
    let bounds = made.mesh.bounds();
    assert_eq!(bounds.min, Vec3::new(-3.0, 7.0, 18.0));
    assert_eq!(bounds.max, Vec3::new(7.0, 22.0, 21.0));
}

#[test]
fn columns_that_touch_in_an_upright_edge_only() {
    // Every way for four columns to have four heights or none.
    const HEIGHTS: [f32; 4] = [-2.0, 0.0, 1.0, 2.0];
    for which in 0..256 {
        let heights: [f32; 4] = std::array::from_fn(|cell| HEIGHTS[which >> (2 * cell) & 3]);
        check(&field(2, &heights), 0.0);
    }
}

#[test]
fn the_last_cells_end_with_the_body() {
    let heights = [1.0, 1.0, 3.0, 1.0, -2.0, 3.0, 2.0, 2.0, 3.0];
    // Narrower ones than a hundredth of a cell are that wide.
    for (size, widest) in [([1.5, 1.2], 0.5), ([1.1, 1.49], 0.5), ([1.000_001, 1.5], 0.495)] {
        let own = HeightField { size, ..field(3, &heights) };
        let made = check(&own, 0.0);
        let bounds = made.mesh.bounds();
        let far = bounds.max - bounds.min;
        assert!((far.x - size[0]).abs() < 1e-12 && (far.y - size[1]).abs() < 1e-12, "{far:?}");
        let begins = -3.0 + 0.5 + widest;
        assert!(made.mesh.vertices().iter().any(|vertex| (vertex.x - begins).abs() < 2e-6));
    }
    // By hand: columns of 0.5, 0.5 and 0.1 wide, rows of 0.5, 0.5 and 0.2, 2 above the bottom at -2.
    let own = HeightField { size: [1.1, 1.2], ..field(3, &heights) };
    let by_hand = 0.5 * (0.5 * 3.0 + 0.5 * 3.0 + 0.1 * 5.0)
        + 0.5 * (0.5 * 3.0 + 0.1 * 5.0)
        + 0.2 * (0.5 * 4.0 + 0.5 * 4.0 + 0.1 * 5.0);
    assert!((own.volume() - by_hand).abs() < 1e-12, "{}", own.volume());
}

#[test]
fn holes_and_walls() {
    let mut heights = [3.0; 35];
    heights[8] = -2.0;
    heights[16] = -5.0;
    heights[17] = f32::NEG_INFINITY;
    heights[25] = 0.5;
    check(&field(7, &heights), 0.0);
    check(&field(7, &[-2.0; 35]), 0.0);
    check(&field(0, &[]), 0.0);
}

#[test]
fn joining_keeps_the_volume_and_says_how_far_it_went() {
    // A slope, and a step of 1 mm that stays.
    let heights: Vec<f32> = (0..60 * 40)
        .map(|cell| (cell % 60) as f32 * 0.01 + (cell / 60) as f32 * 0.003)
        .map(|height| if height > 0.4 { height + 1.0 } else { height })
        .collect();
    let field = field(60, &heights);
    let exact = check(&field, 0.0).mesh.triangles().len();
    let joined = check(&field, 0.02);
    assert!(joined.deviation > 0.0);
    assert!(joined.mesh.triangles().len() * 3 < exact, "{} {exact}", joined.mesh.triangles().len());
    let empty_band = |z: f64| !(20.43..21.37).contains(&z);
    assert!(joined.mesh.vertices().iter().all(|vertex| empty_band(vertex.z)));
}

#[test]
fn grids_and_heights_that_are_none() {
    let good = field(2, &[0.0; 4]);
    let mesh = |field: HeightField| field.mesh(0.0).map(|_| ());
    assert!(matches!(
        mesh(HeightField { rows: 3, size: [1.0, 1.5], ..good }),
        Err(HeightFieldError::Count { found: 4, columns: 2, rows: 3 })
    ));
    for height in [f32::NAN, f32::INFINITY] {
        let heights = [0.0, 0.0, 0.0, height];
        let error = mesh(field(2, &heights)).unwrap_err();
        assert!(matches!(error, HeightFieldError::Height { column: 1, row: 1, .. }), "{error}");
    }
    for cell in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(mesh(HeightField { cell, ..good }).is_err());
    }
    for width in [0.0, 0.5, 1.1, f64::NAN, f64::INFINITY] {
        assert!(mesh(HeightField { size: [width, 1.0], ..good }).is_err());
        assert!(mesh(HeightField { size: [1.0, width], ..good }).is_err());
    }
    assert!(mesh(HeightField { floor: f32::NAN, ..good }).is_err());
    assert!(mesh(HeightField { origin: Vec3::X * f64::NAN, ..good }).is_err());
    assert!(good.mesh(-1.0).is_err() && good.mesh(f64::NAN).is_err());
}

proptest! {
    #[test]
    fn any_field_is_closed_and_within_the_tolerance(
        columns in 1..9_usize,
        // Few heights, so that many are equal, and none at all.
        cells in proptest::collection::vec((0..5_u8, 0.0..0.2_f32), 1..80),
        tolerance in prop_oneof![Just(0.0), 0.0..0.3_f64],
        level in any::<bool>(),
    ) {
        let rows = cells.len() / columns;
        let heights: Vec<f32> = cells[..rows * columns]
            .iter()
            .map(|&(step, rest)| f32::from(step) - 2.0 + if level || step == 0 { 0.0 } else { rest })
            .collect();
        let field = field(columns, &heights);
        let made = check(&field, tolerance);
        for (cell, &height) in heights.iter().enumerate() {
            let [x, y] = [cell % columns, cell / columns].map(|at| (at as f64 + 0.37) * field.cell);
            match top(&made.mesh, field.origin.x + x, field.origin.y + y) {
                Some(z) => {
                    let off = (z - field.origin.z - f64::from(height)).abs();
                    prop_assert!(off <= tolerance + 1e-12, "{off}");
                }
                None => prop_assert!(height <= field.floor),
            }
        }
    }

    #[test]
    fn any_layers_are_closed(
        columns in 1..7_usize,
        // Which of six slabs of 1 mm are there, and how much less of each.
        cells in proptest::collection::vec((0..64_u8, 0.0..0.2_f64), 1..60),
        tolerance in prop_oneof![Just(0.0), 0.0..0.1_f64],
        level in any::<bool>(),
    ) {
        let rows = cells.len() / columns;
        let column = |&(slabs, rest): &(u8, f64)| -> Column {
            let rest = if level { 0.0 } else { rest };
            let mut column = Column::new();
            for slab in (0..6_u8).filter(|slab| slabs & 1 << slab != 0) {
                let [from, to] = [f64::from(slab), f64::from(slab) + 1.0];
                match column.last_mut() {
                    Some(last) if last[1] > from - 0.5 => last[1] = to - rest,
                    _ => column.push([if slab > 0 { from + rest } else { 0.0 }, to - rest]),
                }
            }
            column
        };
        layered(columns, &cells[..rows * columns].iter().map(column).collect::<Vec<_>>(), tolerance);
    }
}

/// A column of a few stretches.
type Column = Vec<[f64; 2]>;

fn layered(columns: usize, cells: &[Column], tolerance: f64) -> HeightMesh {
    let mut intervals = SolidIntervals::default();
    cells.iter().for_each(|cell| intervals.push(cell.iter().copied()));
    let field = LayerField {
        origin: Vec3::new(-3.0, 7.0, 20.0),
        cell: 0.5,
        columns,
        rows: cells.len() / columns,
        size: [0.5 * columns as f64, 0.5 * (cells.len() / columns) as f64],
        intervals: &intervals,
    };
    let made = field.mesh(tolerance).unwrap();
    let ends = intervals.length() / 0.5;
    // Every end is at most so far off, and thin gaps are filled.
    let off = 4.0 * (tolerance + 1.0 / 1024.0);
    let area = cells.iter().map(|cell| 2 * cell.len()).sum::<usize>() as f64 * 0.25;
    let rounding = if ends > 0.0 { off * area } else { 0.0 };
    assert!(made.deviation <= tolerance + 1.0 / 1024.0);
    is_whole(made, field.volume(), rounding)
}

#[test]
fn columns_with_gaps_that_touch_in_every_way() {
    // Undersides are half a step above the tops that they would touch.
    let columns: [Column; 7] = [
        vec![],
        vec![[0.0, 3.0]],
        vec![[0.0, 1.0]],
        vec![[0.0, 1.0], [2.0, 3.0]],
        vec![[2.0, 3.0]],
        vec![[1.0, 2.0]],
        vec![[0.0, 0.5], [1.0, 2.0], [2.5, 3.0]],
    ];
    for which in 0..7_usize.pow(4) {
        let cells = [1, 7, 49, 343].map(|power| columns[which / power % 7].clone());
        layered(2, &cells, 0.0);
    }
}

#[test]
fn a_t_slot_is_a_few_faces_with_its_volume() {
    // 100 × 60 mm, 20 high; the slot 10 wide, and 20 wide from 8 to 12.
    let cells: Vec<Column> = (0..120 * 200)
        .map(|cell| match (cell / 200) as f64 * 0.5 + 0.25 - 30.0 {
            y if y.abs() < 5.0 => vec![[0.0, 8.0]],
            y if y.abs() < 10.0 => vec![[0.0, 8.0], [12.0, 20.0]],
            _ => vec![[0.0, 20.0]],
        })
        .collect();
    let made = layered(200, &cells, 0.0);
    // Half a step off an underside of 1000 mm².
    let volume = 100.0 * (60.0 * 20.0 - 10.0 * 12.0 - 10.0 * 4.0);
    assert!((made.mesh.volume() - volume).abs() < 1000.0 / 2048.0 + 1e-6);
    assert!(made.mesh.triangles().len() < 100, "{}", made.mesh.triangles().len());
}

#[test]
fn layers_of_no_grid_and_no_number_are_refused() {
    let mut intervals = SolidIntervals::default();
    intervals.push([[0.0, f64::NAN]]);
    let origin = Vec3::ZERO;
    let field = LayerField {
        origin,
        cell: 1.0,
        columns: 1,
        rows: 1,
        size: [1.0; 2],
        intervals: &intervals,
    };
    assert!(matches!(field.mesh(0.0), Err(HeightFieldError::Height { .. })));
    let wrong = LayerField { rows: 2, size: [1.0, 2.0], ..field };
    assert!(matches!(wrong.mesh(0.0), Err(HeightFieldError::Count { .. })));
}
