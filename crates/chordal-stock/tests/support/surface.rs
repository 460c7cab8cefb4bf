//! Finishing a wavy surface: a raster of lines along X, there and back.

use chordal_stock::TipMove;

/// The side of the surface, mm.
pub const SIDE: f64 = 60.0;
/// The radius of the ball, mm.
pub const RADIUS: f64 = 3.0;
/// From row to row, mm.
pub const STEP: f64 = 0.3;

fn height(x: f64, y: f64) -> f64 {
    // Slopes up to 0.5.
    -4.0 + 1.6 * libm::sin(0.22 * x) + 0.9 * libm::sin(0.3 * y)
}

/// The moves of the whole surface, in lines of about one length, mm.
pub fn raster(length: f64) -> Vec<TipMove> {
    raster_of([SIDE, SIDE], length)
}

/// The same on so much along X and Y, mm.
pub fn raster_of([width, depth]: [f64; 2], length: f64) -> Vec<TipMove> {
    let rows = (depth / STEP).round() as u32;
    let lines = (width / length).round() as u32;
    let mut corners = Vec::new();
    for row in 0..=rows {
        let y = STEP * f64::from(row);
        for n in 0..=lines {
            let n = if row % 2 == 0 { n } else { lines - n };
            let x = width * f64::from(n) / f64::from(lines);
            corners.push([x, y, height(x, y)]);
        }
    }
    super::path(&corners)
}
