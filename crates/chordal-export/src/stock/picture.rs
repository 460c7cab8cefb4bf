//! The stock from above, shaded, with its heights in colours.

use chordal::stock::StockReport;
use resvg::tiny_skia::{Pixmap, PremultipliedColorU8};

use crate::plot::PlotError;

/// The longer side of the picture, pixels.
const MAX_SIDE_PX: u32 = 1200;
/// Light from the upper left, over the shoulder.
const LIGHT: [f64; 3] = [-0.5, 0.6, 0.62];
/// What the shade leaves of the colour where no light falls.
const AMBIENT: f64 = 0.35;
/// Colours from the lowest to the highest place, as blue, green, sand.
const RAMP: [[f64; 3]; 4] =
    [[44.0, 77.0, 128.0], [61.0, 139.0, 143.0], [164.0, 190.0, 150.0], [226.0, 214.0, 190.0]];
/// The background, where no stock is.
const EMPTY: [u8; 3] = [255, 255, 255];

/// A PNG of what is left, seen along the tool axis: each pixel is the height in the middle of a column.
///
/// # Errors
/// When the picture cannot be made.
pub fn stock_png(found: &StockReport) -> Result<Vec<u8>, PlotError> {
    let grid = found.stock.grid();
    let [columns, rows] = grid.cells();
    let tops = found.tops();
    let bounds = grid.bounds();
    let scale = f64::from(MAX_SIDE_PX) / f64::from(columns.max(rows)).max(1.0);
    let size = |cells: u32| ((f64::from(cells) * scale).round() as u32).max(1);
    let (width, height) = (size(columns), size(rows));
    let mut pixmap = Pixmap::new(width, height).ok_or(PlotError::Size(width, height))?;
    let at = |x: i64, y: i64| {
        let x = x.clamp(0, i64::from(columns) - 1) as usize;
        let y = y.clamp(0, i64::from(rows) - 1) as usize;
        tops[y * columns as usize + x]
    };
    let span = (bounds.max.z - bounds.min.z).max(1e-9);
    let lowest = tops.iter().copied().fold(bounds.max.z, f64::min);
    let shown = (bounds.max.z - lowest).max(0.05 * span);
    let steep = 1.0 / grid.resolution();
    for row in 0..height {
        for column in 0..width {
            let x = (f64::from(column) / scale) as i64;
            // Y goes up in the picture.
            let y = (f64::from(height - 1 - row) / scale) as i64;
            let here = at(x, y);
            let color = if here <= bounds.min.z {
                EMPTY
            } else {
                let slope = [
                    0.5 * (at(x + 1, y) - at(x - 1, y)) * steep,
                    0.5 * (at(x, y + 1) - at(x, y - 1)) * steep,
                ];
                let size = (slope[0] * slope[0] + slope[1] * slope[1] + 1.0).sqrt();
                let lit = (-slope[0] * LIGHT[0] - slope[1] * LIGHT[1] + LIGHT[2]) / size;
                let shade = AMBIENT + (1.0 - AMBIENT) * lit.clamp(0.0, 1.0) / LIGHT[2].max(0.7);
                ramp((here - lowest) / shown).map(|part| (part * shade).clamp(0.0, 255.0) as u8)
            };
            let [red, green, blue] = color;
            if let Some(pixel) = PremultipliedColorU8::from_rgba(red, green, blue, 255) {
                pixmap.pixels_mut()[(row * width + column) as usize] = pixel;
            }
        }
    }
    pixmap.encode_png().map_err(|error| PlotError::Render(error.to_string()))
}

fn ramp(share: f64) -> [f64; 3] {
    let last = RAMP.len() - 1;
    let at = share.clamp(0.0, 1.0) * last as f64;
    let index = (at as usize).min(last - 1);
    let part = at - index as f64;
    std::array::from_fn(|k| RAMP[index][k] + part * (RAMP[index + 1][k] - RAMP[index][k]))
}
