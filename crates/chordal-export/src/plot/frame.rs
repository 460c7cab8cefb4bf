//! The frame of a view: grid, numbers, origin, axes.

use chordal::geometry::{Aabb, Vec3};

use super::palette::Palette;
use super::text::{label, px};
use super::view::{PixelRect, ViewPanel};

/// Millimetres of an inch.
pub(super) const INCH: f64 = 25.4;
const LETTERS: [&str; 3] = ["X", "Y", "Z"];
/// More lines than this are no help.
const MAX_TICKS: f64 = 200.0;

/// The steps of the grid, the same in all views.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct GridSteps {
    /// Distance of lines, mm.
    pub step: f64,
    inch: bool,
    /// Millimetres of a unit of the numbers.
    unit_mm: f64,
    decimals: usize,
}

impl GridSteps {
    /// A step of 1, 2 or 5 times a power of ten of which the numbers have room.
    pub fn new(panel: &ViewPanel, unit: f64, inch: bool, bounds: &Aabb) -> GridSteps {
        let unit_mm = if inch { INCH } else { 1.0 };
        let scale = panel.scale * unit_mm;
        let largest = [bounds.min, bounds.max]
            .iter()
            .flat_map(|corner| corner.to_array())
            .fold(0.0f64, |largest, value| largest.max(value.abs() / unit_mm));
        let mut power = (30.0 * unit / scale).log10().floor() as i32;
        loop {
            for factor in [1.0, 2.0, 5.0] {
                let step = factor * 10f64.powi(power);
                let decimals = (-power).clamp(0, 12) as usize;
                let digits = largest.max(1.0).log10().floor() + 2.0;
                let characters = digits + decimals as f64 + if decimals > 0 { 1.0 } else { 0.0 };
                let room = (characters * 7.4 + 16.0).max(44.0) * unit;
                if step * scale >= room || power > 15 {
                    return GridSteps { step: step * unit_mm, inch, unit_mm, decimals };
                }
            }
            power += 1;
        }
    }

    /// The step as people say it.
    pub fn text(&self) -> String {
        let unit = if self.inch { "in" } else { "mm" };
        format!("{} {unit}", label(self.step / self.unit_mm, self.decimals))
    }

    /// The lines between two places, mm.
    fn lines(&self, low: f64, high: f64) -> Vec<f64> {
        let (first, last) = ((low / self.step).ceil(), (high / self.step).floor());
        // Beyond this the numbers of neighbours are the same double.
        let distinct = first.abs().max(last.abs()) < 1e12;
        if !distinct || last - first > MAX_TICKS {
            return Vec::new();
        }
        (0..=(last - first).max(-1.0) as i64).map(|n| (first + n as f64) * self.step).collect()
    }

    fn number(&self, mm: f64) -> String {
        label(mm / self.unit_mm, self.decimals)
    }
}

/// Draws what lies under the path: ground, grid, numbers and axes.
pub(super) fn under(
    out: &mut String,
    panel: &ViewPanel,
    grid: &GridSteps,
    unit: f64,
    colors: &Palette,
) {
    let PixelRect { x, y, width, height } = panel.rect;
    out.push_str(&format!(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
        px(x),
        px(y),
        px(width),
        px(height),
        colors.panel
    ));
    if panel.view.along_axes {
        lines(out, panel, grid, unit, colors);
        numbers(out, panel, grid, unit, colors);
    }
    triad(out, panel, unit, colors);
}

fn lines(out: &mut String, panel: &ViewPanel, grid: &GridSteps, unit: f64, colors: &Palette) {
    let rect = panel.rect;
    let (mut thin, mut zero) = (String::new(), String::new());
    for (mm, at) in across(panel, grid) {
        let data = if mm == 0.0 { &mut zero } else { &mut thin };
        data.push_str(&format!("M{} {}V{}", px(at), px(rect.y), px(rect.bottom())));
    }
    for (mm, at) in down(panel, grid) {
        let data = if mm == 0.0 { &mut zero } else { &mut thin };
        data.push_str(&format!("M{} {}H{}", px(rect.x), px(at), px(rect.right())));
    }
    for (data, color) in [(thin, colors.grid), (zero, colors.zero)] {
        if !data.is_empty() {
            let stroke = px(unit.max(0.6));
            out.push_str(&format!(
                "<path d=\"{data}\" stroke=\"{color}\" stroke-width=\"{stroke}\" fill=\"none\"/>\n"
            ));
        }
    }
}

/// Numbers below and to the left.
fn numbers(out: &mut String, panel: &ViewPanel, grid: &GridSteps, unit: f64, colors: &Palette) {
    let rect = panel.rect;
    let size = px(13.0 * unit);
    let fill = colors.faint;
    out.push_str(&format!("<g font-size=\"{size}\" fill=\"{fill}\" text-anchor=\"middle\">\n"));
    let below = px(rect.bottom() + 17.0 * unit);
    for (mm, at) in across(panel, grid) {
        let text = grid.number(mm);
        out.push_str(&format!("<text x=\"{}\" y=\"{below}\">{text}</text>\n", px(at)));
    }
    out.push_str("</g>\n");
    out.push_str(&format!("<g font-size=\"{size}\" fill=\"{fill}\" text-anchor=\"end\">\n"));
    let left = px(rect.x - 7.0 * unit);
    let factor = if panel.view.doubled { 2.0 } else { 1.0 };
    for (mm, at) in down(panel, grid) {
        let text = grid.number(factor * mm);
        out.push_str(&format!("<text x=\"{left}\" y=\"{}\">{text}</text>\n", px(at + 4.5 * unit)));
    }
    out.push_str("</g>\n");
}

fn across(panel: &ViewPanel, grid: &GridSteps) -> Vec<(f64, f64)> {
    let half = 0.5 * panel.rect.width / panel.scale;
    let middle = panel.middle.0;
    grid.lines(middle - half, middle + half).into_iter().map(|mm| (mm, panel.across(mm))).collect()
}

fn down(panel: &ViewPanel, grid: &GridSteps) -> Vec<(f64, f64)> {
    let half = 0.5 * panel.rect.height / panel.scale;
    let middle = panel.middle.1;
    grid.lines(middle - half, middle + half).into_iter().map(|mm| (mm, panel.down(mm))).collect()
}

/// A net on the floor of the isometric view.
pub(super) fn floor(
    out: &mut String,
    panel: &ViewPanel,
    grid: &GridSteps,
    bounds: &Aabb,
    unit: f64,
    colors: &Palette,
) {
    let z = bounds.min.z;
    let snap = |low: f64, high: f64| {
        ((low / grid.step).floor() * grid.step, (high / grid.step).ceil() * grid.step)
    };
    let (x0, x1) = snap(bounds.min.x, bounds.max.x);
    let (y0, y1) = snap(bounds.min.y, bounds.max.y);
    let mut data = String::new();
    let mut line = |from: Vec3, to: Vec3| {
        let (from, to) = (panel.place(from), panel.place(to));
        data.push_str(&format!("M{} {}L{} {}", px(from.0), px(from.1), px(to.0), px(to.1)));
    };
    let near = 1e-6 * grid.step;
    for x in grid.lines(x0 - near, x1 + near) {
        line(Vec3::new(x, y0, z), Vec3::new(x, y1, z));
    }
    for y in grid.lines(y0 - near, y1 + near) {
        line(Vec3::new(x0, y, z), Vec3::new(x1, y, z));
    }
    out.push_str(&format!(
        "<path d=\"{data}\" stroke=\"{}\" stroke-width=\"{}\" fill=\"none\"/>\n",
        colors.grid,
        px(unit.max(0.6))
    ));
}

/// Draws what lies over the path: border and title.
pub(super) fn over(out: &mut String, panel: &ViewPanel, unit: f64, colors: &Palette) {
    let PixelRect { x, y, width, height } = panel.rect;
    out.push_str(&format!(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{}\" \
         stroke-width=\"{}\"/>\n",
        px(x),
        px(y),
        px(width),
        px(height),
        colors.border,
        px(unit.max(0.7))
    ));
    out.push_str(&format!(
        "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\">{}</text>\n",
        px(x),
        px(y - 9.0 * unit),
        px(15.0 * unit),
        colors.text,
        panel.view.title
    ));
}

/// The axes with their letters, in the corner and under the path.
fn triad(out: &mut String, panel: &ViewPanel, unit: f64, colors: &Palette) {
    let length = 34.0 * unit;
    let view = &panel.view;
    let directions = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| view.project(axis));
    let low = directions.iter().fold(0.0f64, |low, direction| low.min(direction.1));
    let foot = (panel.rect.x + 14.0 * unit, panel.rect.bottom() - 14.0 * unit + low * length);
    for (letter, (right, up)) in LETTERS.iter().zip(directions) {
        let size = right.hypot(up);
        if size < 0.1 {
            continue;
        }
        let tip = (foot.0 + right * length, foot.1 - up * length);
        let (dx, dy) = (right / size, -up / size);
        arrow(out, foot, tip, (dx, dy), unit, colors.text);
        let at = (tip.0 + dx * 9.0 * unit, tip.1 + dy * 9.0 * unit + 4.6 * unit);
        out.push_str(&format!(
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"middle\">\
             {letter}</text>\n",
            px(at.0),
            px(at.1),
            px(13.0 * unit),
            colors.text
        ));
    }
}

fn arrow(
    out: &mut String,
    from: (f64, f64),
    to: (f64, f64),
    (dx, dy): (f64, f64),
    unit: f64,
    color: &str,
) {
    let (long, wide) = (8.0 * unit, 2.8 * unit);
    let neck = (to.0 - dx * long, to.1 - dy * long);
    out.push_str(&format!(
        "<path d=\"M{} {}L{} {}\" stroke=\"{color}\" stroke-width=\"{}\"/>\
         <path d=\"M{} {}L{} {}L{} {}Z\" fill=\"{color}\"/>\n",
        px(from.0),
        px(from.1),
        px(neck.0),
        px(neck.1),
        px(1.3 * unit),
        px(to.0),
        px(to.1),
        px(neck.0 - dy * wide),
        px(neck.1 + dx * wide),
        px(neck.0 + dy * wide),
        px(neck.1 - dx * wide),
    ));
}

/// The zero point of the program, where the view holds it: a circle with two black quarters.
pub(super) fn origin(out: &mut String, panel: &ViewPanel, unit: f64, colors: &Palette) {
    let at = panel.place(Vec3::ZERO);
    let radius = 6.5 * unit;
    if !panel.rect.holds(at, -radius) {
        return;
    }
    let (x, y, r) = (px(at.0), px(at.1), px(radius));
    let (left, right) = (px(at.0 - radius), px(at.0 + radius));
    let (above, below) = (px(at.1 - radius), px(at.1 + radius));
    out.push_str(&format!(
        "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"{}\" fill-opacity=\"0.75\" \
         stroke=\"{color}\" stroke-width=\"{}\"/>\
         <path d=\"M{x} {y}V{above}A{r} {r} 0 0 1 {right} {y}Z\
         M{x} {y}V{below}A{r} {r} 0 0 1 {left} {y}Z\" fill=\"{color}\"/>\n",
        colors.panel,
        px(1.1 * unit),
        color = colors.faint,
    ));
}
