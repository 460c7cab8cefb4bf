//! What Chordal says of one cell for each line that it reads, for `tools/check_bounds.py`.
//!
//!     cargo run --release -p chordal-stock --example enclose < CASES > ANSWERS
//!
//! A case is numbers with spaces between them, lengths in mm, angles in radians:
//!
//! | numbers | what |
//! |---|---|
//! | 5 | shape (0 flat, 1 ball, 2 bull, 3 pointed, 4 T-slot, 5 lollipop, 6 thread disc), diameter, three more dimensions |
//! | 8 | 0 and a line: start and end; or 1, 2, 3 and an arc about X, Y, Z: centre, radius, first angle, sweep, rise |
//! | 5 | the middle of the cell, its side, the bottom and the top of the stock |
//!
//! The angle of an arc about X counts from Y to Z, about Y from Z to X, about Z from X to Y. An answer is, for shapes
//! up to 3, the outer and the inner height of the cell that the columns have, and the upper and the lower bound of the floor in
//! double precision; for the others the spans that are surely removed, `|`, and those that may be.

#![allow(clippy::disallowed_methods, reason = "an example is a shell: it reads and writes")]

use std::error::Error;
use std::fmt::Write as _;
use std::io::{BufRead as _, Write as _, stdin, stdout};

use chordal_geometry::{Aabb, Arc, Curve, Frame, Line, Vec3};
use chordal_stock::{
    ColumnOptions, ColumnStock, CutterProfile, CutterSweep, RemovedSpan, TipMove, Undercut,
};

/// Numbers of a case.
const NUMBERS: usize = 18;
/// Cells along the sides of a stock; the cell that is asked is at another place of it in every case.
const CELLS: usize = 16;
/// The gap of bounds where there is no closed form, mm.
const GAP: f64 = 1e-6;
const BUDGET: u64 = 1 << 20;

enum Tool {
    Plain(CutterProfile),
    Undercut(Undercut),
}

fn tool(shape: u32, [diameter, a, b, _]: [f64; 4]) -> Result<Tool, Box<dyn Error>> {
    Ok(match shape {
        0 => Tool::Plain(CutterProfile::flat(diameter)?),
        1 => Tool::Plain(CutterProfile::ball(diameter)?),
        2 => Tool::Plain(CutterProfile::bull(diameter, a)?),
        3 => Tool::Plain(CutterProfile::pointed(diameter, a, b)?),
        4 => Tool::Undercut(Undercut::t_slot(diameter, a, b)?),
        5 => Tool::Undercut(Undercut::lollipop(diameter, a)?),
        6 => Tool::Undercut(Undercut::thread_disc(diameter, a, b, diameter / 2.0)?),
        _ => return Err("no such shape".into()),
    })
}

fn curve(kind: u32, n: &[f64]) -> Result<Curve, Box<dyn Error>> {
    let at = Vec3::new(n[0], n[1], n[2]);
    let (axis, first, second) = match kind {
        0 => return Ok(Line::new(at, Vec3::new(n[3], n[4], n[5])).into()),
        1 => (Vec3::X, Vec3::Y, Vec3::Z),
        2 => (Vec3::Y, Vec3::Z, Vec3::X),
        _ => (Vec3::Z, Vec3::X, Vec3::Y),
    };
    let (sine, cosine) = libm::sincos(n[4]);
    let towards = first * cosine + second * sine;
    let frame = Frame::from_normal(at, axis, towards).ok_or("no frame")?;
    Ok(Arc::new(frame, n[3], n[5], n[6]).into())
}

/// Heights of the cell after the move, by the columns of a small stock.
fn columns(
    cutter: &CutterProfile,
    curve: Curve,
    n: &[f64],
    case: usize,
) -> Result<[f64; 2], Box<dyn Error>> {
    let [x, y, side, bottom, top] = [n[0], n[1], n[2], n[3], n[4]];
    let cell = [case % CELLS, case / CELLS % CELLS];
    let corner = |middle: f64, at: usize| middle - side * (at as f64 + 0.5);
    let min = Vec3::new(corner(x, cell[0]), corner(y, cell[1]), bottom);
    let size = side * CELLS as f64;
    let max = Vec3::new(min.x + size, min.y + size, top);
    let mut stock = ColumnStock::new(Aabb { min, max }, ColumnOptions::new(side, BUDGET))?;
    stock.cut(cutter, &[TipMove { curve, tag: 1 }]);
    let heights = stock.heights_at(cell[0] as u32, cell[1] as u32).ok_or("no such cell")?;
    Ok([heights.outer, heights.inner])
}

fn answer(case: usize, line: &str) -> Result<String, Box<dyn Error>> {
    let numbers: Vec<f64> = line.split_whitespace().map(str::parse).collect::<Result<_, _>>()?;
    if numbers.len() != NUMBERS {
        return Err(format!("{} numbers, not {NUMBERS}", numbers.len()).into());
    }
    let tool = tool(numbers[0] as u32, [numbers[1], numbers[2], numbers[3], numbers[4]])?;
    let curve = curve(numbers[5] as u32, &numbers[6..13])?;
    let (middle, side) = ([numbers[13], numbers[14]], numbers[15]);
    let mut text = String::new();
    match tool {
        Tool::Plain(cutter) => {
            let [outer, inner] = columns(&cutter, curve, &numbers[13..], case)?;
            let floor = CutterSweep::new(&cutter, &curve, GAP).cell_floor(middle, side);
            write!(text, "{outer:e} {inner:e} {:e} {:e}", floor.upper, floor.lower)?;
        }
        Tool::Undercut(cutter) => {
            let (mut surely, mut maybe) = (Vec::new(), Vec::new());
            let sweep = CutterSweep::of_undercut(&cutter, &curve, GAP);
            sweep.cell_spans(middle, side, &mut surely, &mut maybe);
            let mut put = |spans: &[RemovedSpan]| {
                spans.iter().try_for_each(|span| write!(text, "{:e} {:e} ", span.floor, span.top))
            };
            put(&surely)?;
            let at = text.len();
            let mut rest = String::from("| ");
            for span in &maybe {
                write!(rest, "{:e} {:e} ", span.floor, span.top)?;
            }
            text.insert_str(at, &rest);
        }
    }
    Ok(text)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = std::io::BufWriter::new(stdout().lock());
    for (case, line) in stdin().lock().lines().enumerate() {
        let line = line?;
        let text = answer(case, &line).map_err(|error| format!("line {}: {error}", case + 1))?;
        writeln!(out, "{text}")?;
    }
    Ok(())
}
