//! Meshes in every form, and their volumes, for `tools/check_meshes.py`.
//!
//!     cargo run --release -p chordal-stock --example meshes -- FOLDER

#![allow(
    clippy::disallowed_methods,
    reason = "an example is a shell: it reads its arguments and writes files"
)]

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use chordal_geometry::Vec3;
use chordal_stock::mesh::write::{write_glb, write_stl, write_threemf};
use chordal_stock::mesh::{HeightField, LayerField, LengthUnit, Mesh, SolidIntervals};

const COLUMNS: usize = 160;
const ROWS: usize = 120;
/// Along X and Y, mm.
const SIZE: [f64; 2] = [0.25 * COLUMNS as f64, 0.25 * ROWS as f64];
/// How far columns that touch in an edge are moved apart in STL, mm: ten steps of a float of 100 mm.
const GAP: f64 = 1e-4;

/// A pocket with a round bottom, an island, a hole through it, and if asked for corners that touch.
fn height(column: usize, row: usize, touching: bool) -> f32 {
    let (x, y) = (column as f64 - 60.0, row as f64 - 55.0);
    let from_middle = (x * x + y * y).sqrt();
    let depth = if from_middle < 10.0 {
        30.0
    } else if from_middle < 20.0 {
        0.0
    } else if from_middle < 50.0 {
        10.0 - 0.002 * from_middle * from_middle
    } else if touching && column > 130 && (column / 4 + row / 4).is_multiple_of(2) {
        5.0
    } else {
        0.0
    };
    -depth as f32
}

/// A block with a bent T-slot, a ball hollowed out of its bottom, and slabs that touch in their edges.
fn layers(column: usize, row: usize) -> Vec<[f64; 2]> {
    let (x, y) = (column as f64, row as f64 - 0.004 * (column * column) as f64);
    let ball = 400.0 - (x - 110.0).powi(2) - (row as f64 - 95.0).powi(2);
    if ball > 0.0 {
        return vec![[0.5 * ball.sqrt(), 20.0]];
    }
    if column > 135 && row < 60 {
        let is_odd = (column / 6 + row / 6) % 2 == 1;
        return if is_odd { vec![[0.0, 4.0], [8.0, 12.0]] } else { vec![[4.0, 8.0], [12.0, 20.0]] };
    }
    match (y - 30.0).abs() {
        far if far < 10.0 => vec![[0.0, 8.0]],
        far if far < 20.0 => vec![[0.0, 8.0], [12.0, 20.0]],
        _ => vec![[0.0, 20.0]],
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("a folder is needed")?);
    fs::create_dir_all(&folder)?;
    let mut rows = Vec::new();
    for touching in [false, true] {
        let heights: Vec<f32> = (0..COLUMNS * ROWS)
            .map(|cell| height(cell % COLUMNS, cell / COLUMNS, touching))
            .collect();
        let field = HeightField {
            origin: Vec3::new(-12.5, 100.0, 40.0),
            cell: 0.25,
            columns: COLUMNS,
            rows: ROWS,
            size: SIZE,
            heights: &heights,
            floor: -20.0,
        };
        for tolerance in [0.0, 0.05, 0.5] {
            let name = format!("{}-{tolerance}", if touching { "touching" } else { "pocket" });
            let steps = field.mesh(tolerance)?;
            let parted = |_: &Mesh| steps.clone().parted(GAP);
            rows.push(write(&folder, &name, &steps.mesh, field.volume(), parted)?);
            let smooth = field.smooth(tolerance)?;
            // Its walls are as wide as a cell: its volume is its own.
            let name = format!("{name}-smooth");
            rows.push(write(&folder, &name, &smooth, smooth.volume(), Mesh::clone)?);
        }
    }
    for tolerance in [0.0, 0.05, 0.5] {
        let mut intervals = SolidIntervals::default();
        for cell in 0..COLUMNS * ROWS {
            intervals.push(layers(cell % COLUMNS, cell / COLUMNS));
        }
        let origin = Vec3::new(-12.5, 100.0, 40.0);
        let field = LayerField {
            origin,
            cell: 0.25,
            columns: COLUMNS,
            rows: ROWS,
            size: SIZE,
            intervals: &intervals,
        };
        let steps = field.mesh(tolerance)?;
        let parted = |_: &Mesh| steps.clone().parted(GAP);
        let name = format!("layers-{tolerance}");
        rows.push(write(&folder, &name, &steps.mesh, steps.mesh.volume(), parted)?);
    }
    fs::write(folder.join("meshes.json"), format!("[{}]\n", rows.join(",\n")))?;
    Ok(())
}

/// Writes a mesh in every form, and gives what is known of it; `for_stl` gives that of the form that shares no vertices.
fn write(
    folder: &Path,
    name: &str,
    mesh: &Mesh,
    volume: f64,
    for_stl: impl Fn(&Mesh) -> Mesh,
) -> Result<String, Box<dyn Error>> {
    let colour = |vertex: &Vec3| [200, (vertex.z * 5.0) as u8, 90, 255];
    let colours: Vec<[u8; 4]> = mesh.vertices().iter().map(colour).collect();
    let title = "stock & \"more\"";
    fs::write(folder.join(format!("{name}.glb")), write_glb(mesh, title, Some(&colours))?)?;
    fs::write(folder.join(format!("{name}.3mf")), write_threemf(mesh, title)?)?;
    let stl = write_stl(&for_stl(mesh), LengthUnit::Millimetre)?;
    fs::write(folder.join(format!("{name}.stl")), stl)?;
    Ok(format!(
        "{{\"name\":\"{name}\",\"volume\":{volume},\"triangles\":{},\"vertices\":{}}}",
        mesh.triangles().len(),
        mesh.vertices().len(),
    ))
}
