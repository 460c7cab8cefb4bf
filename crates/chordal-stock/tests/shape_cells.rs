//! What shapes fill over cells: the truth lies between the bounds.

mod common;

use chordal_geometry::{Transform, Vec3};
use chordal_stock::SolidShape;
use chordal_stock::mesh::Mesh;
use chordal_stock::shape::{CellGrid, EDGE, HeightSpan, ShapeAxis, ShapeError};
use proptest::prelude::*;

/// A shape and whether a place is in it, by definition; within `blur` of its surface either answer is right.
struct Known {
    shape: SolidShape,
    inside: Box<dyn Fn(Vec3) -> bool>,
    volume: f64,
}

impl std::fmt::Debug for Known {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.shape.fmt(f)
    }
}

fn round(axis: ShapeAxis, middle: Vec3, radii: [f64; 2], [from, to]: [f64; 2]) -> Known {
    let [outer, inner] = radii;
    let shape = if inner > 0.0 {
        SolidShape::tube(axis, middle, [2.0 * outer, 2.0 * inner], from, to).unwrap()
    } else {
        SolidShape::cylinder(axis, middle, 2.0 * outer, from, to).unwrap()
    };
    let inside = move |place: Vec3| {
        let off = place - middle;
        let (along, u, v) = match axis {
            ShapeAxis::X => (place.x, off.y, off.z),
            ShapeAxis::Y => (place.y, off.x, off.z),
            ShapeAxis::Z => (place.z, off.x, off.y),
        };
        let distance = (u * u + v * v).sqrt();
        from <= along && along <= to && inner <= distance && distance <= outer
    };
    let volume = shape.volume();
    Known { shape, inside: Box::new(inside), volume }
}

fn meshed(mesh: Mesh) -> Known {
    let shape = SolidShape::solid(mesh.clone()).unwrap();
    let volume = mesh.volume().abs();
    let inside = move |place| common::winding(&mesh, place).abs() > 0.5;
    Known { shape, inside: Box::new(inside), volume }
}

fn place(turn: [f64; 3]) -> Transform {
    Transform::rotation_about(Vec3::ZERO, Vec3::new(turn[0], turn[1], 0.3), turn[2] * 3.0)
        .then(&Transform::translation(Vec3::new(turn[1], turn[2], turn[0])))
}

fn known() -> impl Strategy<Value = Known> {
    let number = || -2.0..2.0_f64;
    let three = || [number(), number(), number()];
    let axis = prop_oneof![Just(ShapeAxis::X), Just(ShapeAxis::Y), Just(ShapeAxis::Z)];
    let bore = prop_oneof![Just(0.0), 0.1..0.95_f64];
    let cylinders = (axis, three(), 0.5..3.0_f64, bore, number(), 0.1..4.0_f64).prop_map(
        |(axis, middle, outer, bore, from, length)| {
            round(axis, Vec3::from_array(middle), [outer, bore * outer], [from, from + length])
        },
    );
    let boxes = (three(), [0.1..4.0_f64, 0.1..4.0_f64, 0.1..4.0_f64]).prop_map(|(low, size)| {
        let (low, size) = (Vec3::from_array(low), Vec3::from_array(size));
        let high = low + size;
        let shape = SolidShape::cuboid(high, low).unwrap();
        let inside = move |place: Vec3| {
            (0..3).all(|axis| {
                low.component(axis) <= place.component(axis)
                    && place.component(axis) <= high.component(axis)
            })
        };
        Known { shape, inside: Box::new(inside), volume: size.x * size.y * size.z }
    });
    let tori = (1.0..2.5_f64, 0.2..0.9_f64, 3..12_usize, 3..9_usize, three()).prop_map(
        |(ring, tube, around, along, turn)| {
            meshed(common::torus(ring, tube, [around, along], &place(turn)))
        },
    );
    let balls = (0.5..3.0_f64, 0.0..0.6_f64, 3..12_usize, 2..8_usize, three(), any::<bool>())
        .prop_map(|(radius, dent, around, rings, turn, turned)| {
            let mesh = common::ball(radius, dent, [around, rings], &place(turn));
            meshed(if turned { mesh.turned() } else { mesh })
        });
    prop_oneof![cylinders, boxes, tori, balls]
}

/// A grid around the shape, not aligned with it.
fn grid_around(shape: &SolidShape, cell: f64, off: f64, grow: f64) -> CellGrid {
    let bounds = shape.bounds();
    let origin = [bounds.min.x - off * cell, bounds.min.y - (1.0 - off) * cell];
    let count = |from: f64, to: f64| ((to - from) / cell).ceil() as usize + 1;
    let (columns, rows) = (count(origin[0], bounds.max.x), count(origin[1], bounds.max.y));
    CellGrid { origin, cell, columns, rows, grow }
}

fn within(spans: &[HeightSpan], z: f64) -> bool {
    spans.iter().any(|span| span.from <= z && z <= span.to)
}

fn height(spans: &[HeightSpan]) -> f64 {
    spans.iter().map(|span| span.to - span.from).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn the_truth_lies_between_the_bounds(
        known in known(),
        cell in 0.05..0.8_f64,
        off in 0.0..1.0_f64,
        grow in prop_oneof![Just(0.0), 0.0..0.1_f64],
        places in proptest::collection::vec([0.0..1.0_f64, 0.0..1.0, 0.0..1.0, 0.0..1.0, 0.0..1.0], 100),
    ) {
        let grid = grid_around(&known.shape, cell, off, grow);
        let cells = known.shape.cells(&grid).unwrap();
        let bounds = known.shape.bounds();
        let (mut outer, mut inner) = (0.0, 0.0);
        for row in 0..grid.rows {
            for column in 0..grid.columns {
                for spans in [cells.outer(column, row), cells.inner(column, row)] {
                    prop_assert!(spans.iter().all(|span| span.from <= span.to));
                    prop_assert!(spans.windows(2).all(|two| two[0].to < two[1].from));
                }
                outer += height(cells.outer(column, row)) * cell * cell;
                inner += height(cells.inner(column, row)) * cell * cell;
            }
        }
        let rounding = 1e-6 * (1.0 + known.volume);
        prop_assert!(inner <= known.volume + rounding && known.volume <= outer + rounding);
        for [column, row, x, y, z] in places {
            let at = |part: f64, count: usize| (part * count as f64) as usize;
            let (column, row) = (at(column, grid.columns), at(row, grid.rows));
            let reach = |part: f64, number: usize| {
                (number as f64 + part) * cell + (2.0 * part - 1.0) * (grow - EDGE).max(0.0)
            };
            let (x, y) = (grid.origin[0] + reach(x, column), grid.origin[1] + reach(y, row));
            let outer = cells.outer(column, row);
            let inner = cells.inner(column, row);
            // Anywhere, and beside the ends of the spans.
            let mut heights = vec![bounds.min.z - 0.1 + z * (bounds.max.z - bounds.min.z + 0.2)];
            for span in outer.iter().chain(inner) {
                heights.extend([span.from - 1e-5, span.from + 1e-5, span.to - 1e-5, span.to + 1e-5]);
            }
            for z in heights {
                let inside = (known.inside)(Vec3::new(x, y, z));
                if inside {
                    prop_assert!(within(outer, z), "{x} {y} {z} is inside, not in {outer:?}");
                } else {
                    let surely = inner.iter().any(|span| span.from + 1e-9 < z && z < span.to - 1e-9);
                    prop_assert!(!surely, "{x} {y} {z} is outside, but in {inner:?}");
                }
            }
        }
    }

    #[test]
    fn a_mesh_of_a_box_fills_what_the_box_does(
        low in [-3..3_i32, -3..3_i32, -3..3_i32],
        size in [1..5_i32, 1..5_i32, 1..5_i32],
        off in [0..4_i32, 0..4_i32],
        grow in prop_oneof![Just(0.0), Just(0.01)],
    ) {
        // In quarters, so that walls lie in the edges of cells.
        let quarters = |values: [i32; 3]| Vec3::from_array(values.map(f64::from)) * 0.25;
        let (low, high) = (quarters(low), quarters(low) + quarters(size));
        let shape = SolidShape::cuboid(low, high).unwrap();
        let mesh = SolidShape::solid(common::cuboid(low, high)).unwrap();
        let off = off.map(|off| f64::from(off) * 0.125);
        let origin = [low.x - off[0], low.y - off[1]];
        let grid = CellGrid { origin, cell: 0.25, columns: 8, rows: 8, grow };
        let cells = shape.cells(&grid).unwrap();
        prop_assert_eq!(&cells, &mesh.cells(&grid).unwrap());
        if grow == 0.0 && off == [0.0; 2] {
            for row in 0..8 {
                for column in 0..8 {
                    prop_assert_eq!(cells.outer(column, row), cells.inner(column, row));
                }
            }
        }
    }
}

#[test]
fn bounds_close_in_on_finer_grids() {
    let mesh = common::torus(8.0, 3.0, [48, 24], &Transform::translation(Vec3::new(0.1, 0.2, 5.0)));
    let volume = mesh.volume();
    let shape = SolidShape::solid(mesh).unwrap();
    let mut last = f64::INFINITY;
    for cell in [1.0, 0.5, 0.25] {
        let grid = grid_around(&shape, cell, 0.3, 0.0);
        let cells = shape.cells(&grid).unwrap();
        let sum = |of: &dyn Fn(usize, usize) -> f64| -> f64 {
            (0..grid.rows * grid.columns)
                .map(|at| of(at % grid.columns, at / grid.columns) * cell * cell)
                .sum()
        };
        let outer = sum(&|column, row| height(cells.outer(column, row)));
        let inner = sum(&|column, row| height(cells.inner(column, row)));
        assert!(inner < volume && volume < outer);
        assert!(outer - inner < 0.6 * last, "{inner} {volume} {outer}");
        last = outer - inner;
    }
}

#[test]
fn a_column_may_have_several_spans() {
    // A ring on edge, and a tube that lies: two walls over its middle.
    let turn = Transform::rotation_about(Vec3::ZERO, Vec3::X, std::f64::consts::FRAC_PI_2);
    let ring = SolidShape::solid(common::torus(5.0, 1.0, [40, 20], &turn)).unwrap();
    let tube = SolidShape::tube(ShapeAxis::Y, Vec3::ZERO, [12.0, 8.0], -1.0, 1.0).unwrap();
    let grid = CellGrid { origin: [-0.1, -0.1], cell: 0.2, columns: 1, rows: 1, grow: 0.0 };
    for shape in [ring, tube] {
        let cells = shape.cells(&grid).unwrap();
        assert_eq!((cells.outer(0, 0).len(), cells.inner(0, 0).len()), (2, 2));
        assert!((height(cells.inner(0, 0)) - 4.0).abs() < 0.1);
    }
}

#[test]
fn dimensions_that_are_none() {
    assert!(SolidShape::cuboid(Vec3::ZERO, Vec3::new(1.0, 0.0, 1.0)).is_err());
    assert!(SolidShape::cuboid(Vec3::ZERO, Vec3::new(1.0, f64::NAN, 1.0)).is_err());
    for (diameter, from, to) in [
        (0.0, 0.0, 1.0),
        (1.0, 1.0, 1.0),
        (f64::NAN, 0.0, 1.0),
        (1.0, f64::NAN, 1.0),
        (1.0, 0.0, f64::INFINITY),
    ] {
        assert!(SolidShape::cylinder(ShapeAxis::X, Vec3::ZERO, diameter, from, to).is_err());
    }
    assert!(SolidShape::tube(ShapeAxis::Z, Vec3::ZERO, [2.0, 2.0], 0.0, 1.0).is_err());
    let mesh = common::cuboid(Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0));
    let open = Mesh::new(mesh.vertices().to_vec(), mesh.triangles()[1..].to_vec()).unwrap();
    let error = SolidShape::solid(open.clone()).unwrap_err();
    assert!(error.to_string().contains("open at 3 of"), "{error}");
    assert!(matches!(SolidShape::solid(Mesh::default()), Err(ShapeError::NoTriangle)));
    let grid = CellGrid { origin: [0.0; 2], cell: 0.1, columns: 3, rows: 3, grow: 0.0 };
    assert!(matches!(
        SolidShape::surface(open).unwrap().cells(&grid),
        Err(ShapeError::Open { .. })
    ));
    let shape = SolidShape::solid(mesh).unwrap();
    for cell in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(shape.cells(&CellGrid { cell, ..grid }).is_err());
    }
    assert!(shape.cells(&CellGrid { columns: usize::MAX, ..grid }).is_err());
    assert!(shape.cells(&CellGrid { columns: 0, ..grid }).is_ok());
}
