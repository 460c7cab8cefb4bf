//! The rows of the motion table: programs, and the times of LinuxCNC.

#![allow(clippy::disallowed_methods, clippy::disallowed_types, reason = "reads the programs")]

use std::fmt::Write;
use std::path::PathBuf;

/// A program of the table.
#[derive(Clone, Copy)]
pub struct Row {
    /// Its name; where it has no formula, the name of its file too.
    pub name: &'static str,
    /// For the table.
    pub title: &'static str,
    /// Where it is computed.
    pub formula: Option<fn() -> String>,
    /// What LinuxCNC takes, s: 2.9, 2.10 with trapezoids, 2.10 with S-curves at the same jerk.
    /// Measured on its commanded positions at 1 kHz.
    pub linuxcnc_s: [f64; 3],
    /// The time that was asked of Chordal, s.
    pub most_s: Option<f64>,
    /// Whether the reference is cheap enough to be found in each test.
    pub reference: bool,
}

/// All of them.
pub const ROWS: [Row; 11] = [
    Row::file("line100_g61", "line 100 mm, F6000", [1.052, 1.052, 1.073]),
    Row::file("square_f3000_g611", "square 50 mm, F3000, G61.1", [4.102, 4.102, 4.182]),
    Row::file("square_f3000_g64p001", "square 50 mm, F3000, G64 P0.01", [4.121, 4.099, 4.321]),
    Row::file("square_f3000_g64p01", "square 50 mm, F3000, G64 P0.1", [4.098, 4.080, 4.317]),
    Row::file("square_f9000_g64p001", "square 50 mm, F9000, G64 P0.01", [1.706, 1.633, 1.699]),
    Row {
        most_s: Some(1.36),
        ..Row::file("circle20_g61", "circle R20, F6000, G61", [1.359, 1.359, 2.854])
    },
    Row {
        most_s: Some(1.25),
        ..Row::file("circle2x5_g61", "circle R2 × 5 turns, F6000, G61", [1.129, 1.129, 4.469])
    },
    Row::file("helix10x3_g61", "helix R10 × 3 turns, F6000, G61", [1.993, 1.945, 3.367]),
    Row::file("rrect_g61", "rounded rectangle, F6000, G61", [2.106, 2.106, 3.571]),
    Row {
        formula: Some(spiral),
        reference: false,
        ..Row::file(
            "spiral2000_g64p001",
            "spiral of 2000 lines, F3000, G64 P0.01",
            [13.25, 13.24, 23.24],
        )
    },
    Row {
        formula: Some(raster),
        reference: false,
        ..Row::file(
            "raster4000_g64p001",
            "raster of 4000 lines, F3000, G64 P0.01",
            [8.81, 8.80, 14.91],
        )
    },
];

/// Where the programs and their machine are.
pub fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../tests/motion")
}

impl Row {
    const fn file(name: &'static str, title: &'static str, linuxcnc_s: [f64; 3]) -> Row {
        Row { name, title, formula: None, linuxcnc_s, most_s: None, reference: true }
    }

    /// The program.
    pub fn text(&self) -> String {
        match self.formula {
            Some(formula) => formula(),
            None => {
                let path = folder().join(self.name).with_extension("ngc");
                std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
            }
        }
    }
}

const HEAD: &str = "G21 G17 G90 G94 G40 G49 G54\nG64 P0.01\nF3000\n";

/// Ten turns in 2000 chords, from 1 mm to 20 mm about X-1 Y0.
fn spiral() -> String {
    let mut text = String::from(HEAD);
    for chord in 1..=2000 {
        let radius = 1.0 + 0.0095 * f64::from(chord);
        let (sin, cos) = (f64::from(chord) * std::f64::consts::PI / 100.0).sin_cos();
        writeln!(text, "G1 X{:.4} Y{:.4}", radius * cos - 1.0, radius * sin).unwrap();
    }
    text + "M2\n"
}

/// A wavy face in ten rows there and back, half a millimetre apart, in steps of 0.1 mm.
fn raster() -> String {
    let mut text = String::from(HEAD);
    for row in 0..10 {
        for step in 0..=400 {
            let x = 0.1 * f64::from(if row % 2 == 0 { step } else { 400 - step });
            let y = 0.5 * f64::from(row);
            // The first place is where the axes are.
            if (row, step) != (0, 0) {
                let z = 2.0 * (0.3 * x).sin() * (0.4 * y).cos();
                writeln!(text, "G1 X{x:.4} Y{y:.4} Z{z:.4}").unwrap();
            }
        }
    }
    text + "M2\n"
}
