//! Meshes in every form, and their volumes, for `tools/check_meshes.py`.
//!
//!     cargo run --release -p chordal-stock --example meshes -- FOLDER

#![allow(
    clippy::disallowed_methods,
    reason = "an example is a shell: it reads its arguments and writes files"
)]

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use chordal_geometry::Vec3;
use chordal_stock::mesh::write::{write_glb, write_stl, write_threemf};
use chordal_stock::mesh::{HeightField, LengthUnit};

const COLUMNS: usize = 160;
const ROWS: usize = 120;
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
            heights: &heights,
            floor: -20.0,
        };
        for tolerance in [0.0, 0.05, 0.5] {
            let made = field.mesh(tolerance)?;
            let colours: Vec<[u8; 4]> = made
                .mesh
                .vertices()
                .iter()
                .map(|vertex| [200, (vertex.z * 5.0) as u8, 90, 255])
                .collect();
            let name = format!("{}-{tolerance}", if touching { "touching" } else { "pocket" });
            let glb = write_glb(&made.mesh, "stock & \"more\"", Some(&colours))?;
            fs::write(folder.join(format!("{name}.glb")), glb)?;
            let threemf = write_threemf(&made.mesh, "stock & \"more\"")?;
            fs::write(folder.join(format!("{name}.3mf")), threemf)?;
            rows.push(format!(
            "{{\"name\":\"{name}\",\"touching\":{touching},\"volume\":{},\"triangles\":{},\"vertices\":{},\"deviation\":{}}}",
            field.volume(),
            made.mesh.triangles().len(),
            made.mesh.vertices().len(),
            made.deviation
            ));
            let parted = write_stl(&made.parted(GAP), LengthUnit::Millimetre)?;
            fs::write(folder.join(format!("{name}.stl")), parted)?;
        }
    }
    fs::write(folder.join("meshes.json"), format!("[{}]\n", rows.join(",\n")))?;
    Ok(())
}
