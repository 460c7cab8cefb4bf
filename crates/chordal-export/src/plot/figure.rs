//! A calculation's figure: the drawing on the left, the formulas on the right.

use std::f64::consts::{FRAC_PI_2, TAU};

use chordal::geometry::Vec2;
use chordal_calc::{Figure, FigureElement, LineStyle, WorkedCalculation};

use super::figure_labels::{LabelBox, PixelPoint, extent, place};
use super::palette::Palette;
use super::text::{escape, px};
use super::{PlotError, PlotOptions, render};

/// The least sheet, px.
const MIN_SHEET_PX: f64 = 200.0;
/// A sheet of this height has texts of the sizes below, px.
const HEIGHT: f64 = 800.0;
const LABEL: f64 = 16.0;
const FORMULA: f64 = 15.0;
const LINE: f64 = 21.0;
/// Smaller texts than this share are no help.
const MIN_TEXT_SHARE: f64 = 0.8;
const MARGIN_PX: f64 = 28.0;
const HEAD: f64 = 58.0;
/// Room around the drawing for its texts.
const AROUND: f64 = 46.0;
/// Distance of the points by which a stroke is known to the texts.
const SAMPLE: f64 = 4.0;
const ARROW: f64 = 9.0;

/// The sheet of a calculation as SVG. Sides below 200 px are drawn as 200.
pub fn figure_svg(worked: &WorkedCalculation, options: &PlotOptions) -> String {
    FigureSheet::new(worked, options).draw()
}

/// The sheet of a calculation as PNG.
///
/// # Errors
/// When the sheet has no reasonable size.
pub fn figure_png(worked: &WorkedCalculation, options: &PlotOptions) -> Result<Vec<u8>, PlotError> {
    render(options.width_px, options.height_px, || figure_svg(worked, options))
}

struct FigureSheet<'a> {
    worked: &'a WorkedCalculation,
    colors: &'static Palette,
    width: f64,
    height: f64,
    /// px of a unit.
    unit: f64,
    /// The drawing's room.
    room: LabelBox,
    scale: f64,
    /// The middle of what is drawn, mm.
    middle: Vec2,
    out: String,
    strokes: Vec<PixelPoint>,
    names: Vec<(String, PixelPoint)>,
}

impl<'a> FigureSheet<'a> {
    fn new(worked: &'a WorkedCalculation, options: &PlotOptions) -> FigureSheet<'a> {
        let (width, height) = (
            f64::from(options.width_px).max(MIN_SHEET_PX),
            f64::from(options.height_px).max(MIN_SHEET_PX),
        );
        let unit = (height / HEIGHT).min(width / 1.4 / HEIGHT).max(0.25);
        let room = LabelBox {
            left: MARGIN_PX * unit,
            top: (MARGIN_PX + HEAD) * unit,
            width: width * 0.62 - MARGIN_PX * unit,
            height: height - (2.0 * MARGIN_PX + HEAD) * unit,
        };
        let (low, high) = bounds(&worked.figure);
        let (wide, high_mm) = ((high.a - low.a).max(1e-9), (high.b - low.b).max(1e-9));
        let inside = 2.0 * AROUND * unit;
        let scale = ((room.width - inside).max(20.0) / wide)
            .min((room.height - inside).max(20.0) / high_mm);
        FigureSheet {
            worked,
            colors: Palette::of(options.dark),
            width,
            height,
            unit,
            room,
            scale,
            middle: (low + high) * 0.5,
            out: String::new(),
            strokes: Vec::new(),
            names: Vec::new(),
        }
    }

    fn draw(mut self) -> String {
        let (width, height) = (px(self.width), px(self.height));
        self.out.push_str(&format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"Ubuntu, 'Helvetica Neue', Helvetica, \
             Arial, sans-serif\">\n<title>{}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>\n",
            escape(&self.worked.title),
            self.colors.sheet
        ));
        let LabelBox { left, top, width, height } = self.room;
        self.out.push_str(&format!(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n",
            px(left),
            px(top),
            px(width),
            px(height),
            self.colors.panel,
            self.colors.border
        ));
        for mark in &self.worked.figure.marks {
            self.mark(mark);
        }
        self.labels();
        self.formulas();
        self.out.push_str("</svg>\n");
        self.out
    }

    fn at(&self, point: Vec2) -> PixelPoint {
        let middle = self.room.middle();
        (
            middle.0 + (point.a - self.middle.a) * self.scale,
            middle.1 - (point.b - self.middle.b) * self.scale,
        )
    }

    fn mark(&mut self, mark: &FigureElement) {
        match mark {
            FigureElement::Line { from, to, style } => {
                let (from, to) = (self.at(*from), self.at(*to));
                self.stroke(&[from, to], &self.look(*style));
            }
            FigureElement::Arc { center, radius, start, sweep, style } => {
                let look = self.look(*style);
                self.arc(*center, *radius, *start, *sweep, &look);
            }
            FigureElement::Point { at, label } => self.point(*at, label),
            FigureElement::Arrow { at, direction } => {
                let color = self.colors.tool(0);
                let at = self.at(*at);
                self.head(at, *direction, color, 1.25);
            }
            FigureElement::Dimension { from, to, direction, through, text } => {
                self.dimension(*from, *to, *direction, *through, text);
            }
            FigureElement::Angle { vertex, radius, start, sweep, text } => {
                let look = self.thin();
                self.arc(*vertex, *radius, *start, *sweep, &look);
                let middle = *vertex + unit(start + sweep / 2.0) * *radius;
                let arm = *vertex + unit(start + sweep) * *radius;
                let tip = self.at(arm);
                if sweep.abs() * radius * self.scale > 3.0 * ARROW * self.unit {
                    let along = start + sweep + FRAC_PI_2.copysign(*sweep);
                    self.head(tip, along, self.colors.faint, 0.8);
                }
                let middle = self.at(middle);
                self.names.push((text.clone(), middle));
            }
            FigureElement::Text { at, text } => {
                let at = self.at(*at);
                self.names.push((text.clone(), at));
            }
        }
    }

    /// The attributes of a kind of line.
    fn look(&self, style: LineStyle) -> String {
        let (color, width, dash) = match style {
            LineStyle::Part => (self.colors.text, 2.6, ""),
            LineStyle::Path => (self.colors.tool(0), 2.0, "9 5"),
            LineStyle::Cutter => (self.colors.tool(1), 1.8, ""),
            LineStyle::Helper => (self.colors.faint, 1.0, "4 4"),
        };
        let dash: Vec<String> = dash
            .split_whitespace()
            .filter_map(|part| part.parse().ok())
            .map(|part: f64| px(part * self.unit))
            .collect();
        format!(
            "stroke=\"{color}\" stroke-width=\"{}\" fill=\"none\"{}",
            px(width * self.unit),
            if dash.is_empty() {
                String::new()
            } else {
                format!(" stroke-dasharray=\"{}\"", dash.join(" "))
            }
        )
    }

    fn thin(&self) -> String {
        format!("stroke=\"{}\" stroke-width=\"{}\" fill=\"none\"", self.colors.faint, px(self.unit))
    }

    /// A line through points, and what the texts have to know of it.
    fn stroke(&mut self, points: &[PixelPoint], look: &str) {
        let mut data = String::new();
        for (index, (x, y)) in points.iter().enumerate() {
            data.push_str(&format!("{}{} {}", if index == 0 { 'M' } else { 'L' }, px(*x), px(*y)));
        }
        self.out.push_str(&format!("<path d=\"{data}\" {look}/>\n"));
        for pair in points.windows(2) {
            let ((x, y), (to_x, to_y)) = (pair[0], pair[1]);
            let steps = ((to_x - x).hypot(to_y - y) / SAMPLE).ceil().clamp(1.0, 2000.0);
            for step in 0..=steps as u32 {
                let share = f64::from(step) / steps;
                self.strokes.push((x + (to_x - x) * share, y + (to_y - y) * share));
            }
        }
    }

    fn arc(&mut self, center: Vec2, radius: f64, start: f64, sweep: f64, look: &str) {
        // Chords of a figure: a tenth of a pixel from the arc.
        let pixels = (radius * self.scale).max(1.0);
        let step = 2.0 * (2.0 * 0.1 / pixels).sqrt();
        let count = (sweep.abs() / step).ceil().clamp(2.0, 2000.0);
        let points: Vec<PixelPoint> = (0..=count as u32)
            .map(|index| {
                let angle = start + sweep * f64::from(index) / count;
                self.at(center + unit(angle) * radius)
            })
            .collect();
        self.stroke(&points, look);
    }

    fn point(&mut self, at: Vec2, label: &str) {
        let (x, y) = self.at(at);
        self.out.push_str(&format!(
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n",
            px(x),
            px(y),
            px(3.6 * self.unit),
            self.colors.text
        ));
        let reach = 3.0 * self.unit;
        for (dx, dy) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)] {
            self.strokes.push((x + dx * reach, y + dy * reach));
        }
        if !label.is_empty() {
            self.names.push((label.into(), (x, y)));
        }
    }

    /// An arrow head with its tip here.
    fn head(&mut self, (x, y): PixelPoint, direction: f64, color: &str, size: f64) {
        let length = ARROW * self.unit * size;
        let (sin, cos) = direction.sin_cos();
        // The sheet's y goes down.
        let corner =
            |back: f64, aside: f64| (x - cos * back - sin * aside, y + sin * back - cos * aside);
        let (left, right) = (corner(length, length * 0.36), corner(length, -length * 0.36));
        self.out.push_str(&format!(
            "<path d=\"M{} {}L{} {}L{} {}Z\" fill=\"{color}\"/>\n",
            px(x),
            px(y),
            px(left.0),
            px(left.1),
            px(right.0),
            px(right.1)
        ));
        self.strokes.extend([left, right, (x, y)]);
    }

    fn dimension(&mut self, from: Vec2, to: Vec2, direction: f64, through: Vec2, text: &str) {
        let along = unit(direction);
        let foot = |point: Vec2| through + along * (point - through).dot(along);
        let (a, b) = (self.at(foot(from)), self.at(foot(to)));
        let look = self.thin();
        // From what is measured to a little beyond the dimension line.
        for (point, end) in [(self.at(from), a), (self.at(to), b)] {
            let length = (end.0 - point.0).hypot(end.1 - point.1);
            if length > 1.0 {
                let more = 1.0 + 6.0 * self.unit / length;
                let tip = (point.0 + (end.0 - point.0) * more, point.1 + (end.1 - point.1) * more);
                self.stroke(&[point, tip], &look);
            }
        }
        let length = (b.0 - a.0).hypot(b.1 - a.1);
        let forward = (foot(to) - foot(from)).dot(along) >= 0.0;
        let (toward_b, toward_a) = if forward {
            (direction, direction + std::f64::consts::PI)
        } else {
            (direction + std::f64::consts::PI, direction)
        };
        let (color, size) = (self.colors.faint, 0.9);
        if length > 3.2 * ARROW * self.unit {
            self.stroke(&[a, b], &look);
            self.head(a, toward_a, color, size);
            self.head(b, toward_b, color, size);
        } else {
            // No room between: the arrows come from outside.
            let tail = 20.0 * self.unit / length.max(1e-9);
            let beyond =
                |p: PixelPoint, q: PixelPoint| (p.0 + (p.0 - q.0) * tail, p.1 + (p.1 - q.1) * tail);
            if length > 1e-9 {
                self.stroke(&[beyond(a, b), beyond(b, a)], &look);
            }
            self.head(a, toward_b, color, size);
            self.head(b, toward_a, color, size);
        }
        self.names.push((text.into(), ((a.0 + b.0) / 2.0, (a.1 + b.1) / 2.0)));
    }

    fn labels(&mut self) {
        let size = LABEL * self.unit;
        let labels = place(&self.names, &self.strokes, &self.room, size);
        for label in &labels {
            if let Some((x, y)) = label.leader() {
                self.out.push_str(&format!(
                    "<path d=\"M{} {}L{} {}\" stroke=\"{}\" stroke-width=\"{}\" fill=\"none\"/>\n",
                    px(label.anchor.0),
                    px(label.anchor.1),
                    px(x),
                    px(y),
                    self.colors.border,
                    px(self.unit)
                ));
            }
        }
        for label in &labels {
            let (x, y) = label.block.middle();
            self.out.push_str(&format!(
                "<text class=\"label\" x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"middle\" \
                 fill=\"{}\">{}</text>\n",
                px(x),
                px(y + 0.35 * size),
                px(size),
                self.colors.text,
                escape(&label.text)
            ));
        }
    }

    /// Title, what is given, and each formula with its numbers.
    fn formulas(&mut self) {
        let unit = self.unit;
        let left = self.room.left + self.room.width + MARGIN_PX * unit;
        let width = self.width - left - MARGIN_PX * unit;
        let title = escape(&self.worked.title);
        let letters = self.worked.title.chars().count().max(1) as f64;
        let size = (25.0 * unit).min((self.width - 2.0 * MARGIN_PX * unit) / (0.56 * letters));
        self.text(MARGIN_PX * unit, (MARGIN_PX + 26.0) * unit, size, self.colors.text, &title);
        // With everything; where that is too much, closer together, or the results alone.
        let room = self.room.height;
        let all = self.lines(width / unit, true);
        let close: Vec<_> = all.iter().filter(|(text, _)| !text.is_empty()).cloned().collect();
        let shrink = |lines: &[(String, bool)]| room / (lines.len() as f64 * LINE * unit);
        let lines = [all, close]
            .into_iter()
            .find(|lines| shrink(lines) >= MIN_TEXT_SHARE)
            .unwrap_or_else(|| self.lines(width / unit, false));
        let shrink = shrink(&lines).min(1.0);
        let mut y = self.room.top + FORMULA * unit * shrink;
        for (text, strong) in lines {
            let color = if strong { self.colors.text } else { self.colors.faint };
            self.text(left, y, FORMULA * unit * shrink, color, &escape(&text));
            y += LINE * unit * shrink;
        }
    }

    fn text(&mut self, x: f64, y: f64, size: f64, color: &str, escaped: &str) {
        if escaped.is_empty() {
            return;
        }
        self.out.push_str(&format!(
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{color}\" \
             xml:space=\"preserve\">{escaped}</text>\n",
            px(x),
            px(y),
            px(size)
        ));
    }

    /// The lines of the right side; true for those that stand out.
    fn lines(&self, width: f64, all: bool) -> Vec<(String, bool)> {
        let worked = self.worked;
        let most = (width / extent("m", FORMULA).0).max(12.0) as usize;
        let mut lines = Vec::new();
        for provided in &worked.inputs {
            let text = format!("{} = {}", provided.symbol, provided.text(worked.units));
            lines.extend(wrap(&text, most).into_iter().map(|line| (line, false)));
        }
        for step in worked.steps.iter().filter(|step| all || step.result) {
            let quantity = &step.quantity;
            lines.push((String::new(), false));
            let formula = format!("{} = {}", quantity.symbol, step.formula);
            lines.extend(wrap(&formula, most).into_iter().map(|line| (line, true)));
            if all && step.filled != step.formula {
                let filled = format!("   = {}", step.filled);
                lines.extend(wrap(&filled, most).into_iter().map(|line| (line, false)));
            }
            lines.push((format!("   = {}", quantity.text(worked.units)), true));
        }
        for note in &worked.notes {
            lines.push((String::new(), false));
            lines.extend(wrap(note, most).into_iter().map(|line| (line, false)));
        }
        lines
    }
}

/// Breaks a text at its spaces.
fn wrap(text: &str, most: usize) -> Vec<String> {
    let indent: String = text.chars().take_while(|c| *c == ' ').collect();
    let mut lines = vec![indent.clone()];
    let mut empty = true;
    for word in text.split_whitespace() {
        let last = lines.last().map_or(0, |line| line.chars().count());
        if !empty && last + 1 + word.chars().count() > most {
            lines.push(format!("{indent}   {word}"));
        } else if let Some(line) = lines.last_mut() {
            if !empty {
                line.push(' ');
            }
            line.push_str(word);
        }
        empty = false;
    }
    lines
}

fn unit(angle: f64) -> Vec2 {
    let (sin, cos) = angle.sin_cos();
    Vec2::new(cos, sin)
}

/// What the drawing needs of the plane, mm.
fn bounds(figure: &Figure) -> (Vec2, Vec2) {
    let mut low = Vec2::new(f64::INFINITY, f64::INFINITY);
    let mut high = Vec2::new(f64::NEG_INFINITY, f64::NEG_INFINITY);
    let mut take = |point: Vec2| {
        low = Vec2::new(low.a.min(point.a), low.b.min(point.b));
        high = Vec2::new(high.a.max(point.a), high.b.max(point.b));
    };
    for mark in &figure.marks {
        match mark {
            FigureElement::Line { from, to, .. } => {
                take(*from);
                take(*to);
            }
            FigureElement::Arc { center, radius, start, sweep, .. }
            | FigureElement::Angle { vertex: center, radius, start, sweep, .. } => {
                let sweep = sweep.clamp(-TAU, TAU);
                for index in 0..=64 {
                    take(*center + unit(start + sweep * f64::from(index) / 64.0) * *radius);
                }
            }
            FigureElement::Point { at, .. }
            | FigureElement::Arrow { at, .. }
            | FigureElement::Text { at, .. } => take(*at),
            FigureElement::Dimension { from, to, direction, through, .. } => {
                let along = unit(*direction);
                for point in [*from, *to] {
                    take(*through + along * (point - *through).dot(along));
                }
            }
        }
    }
    if low.a > high.a { (Vec2::ZERO, Vec2::new(1.0, 1.0)) } else { (low, high) }
}
