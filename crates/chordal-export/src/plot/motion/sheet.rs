//! The sheet: caption, legend, four charts.

use chordal::machine::{AXES, AXIS_NAMES, PerAxis};

use super::super::PlotOptions;
use super::super::frame::INCH;
use super::super::layout::{MARGIN_UNITS, SheetLayout};
use super::super::palette::Palette;
use super::super::sheet::{shorten, text_width};
use super::super::text::{escape, px};
use super::super::view::PixelRect;
use super::chart::{AxisScale, ChartArea, ChartSeries};
use super::{ACCELERATION, ALONG_ACCELERATION, ALONG_JERK, JERK, MotionPlot, SPEED};

/// Units: room for the caption and the legend.
const HEADER: f64 = 98.0;
/// Room to the left of the charts for numbers, and to their right for units.
const LEFT: f64 = 62.0;
const RIGHT: f64 = 26.0;
/// Room above a chart for its title, and below each for numbers, and lines under two of them.
const ABOVE: f64 = 26.0;
const BELOW: [f64; 4] = [50.0, 30.0, 30.0, 38.0];
/// Heights of the charts, as shares.
const SHARES: [f64; 4] = [1.15, 1.0, 1.0, 1.0];
/// A limit that is farther above all values than this is reported, but not drawn.
const MAX_LIMIT_RATIO: f64 = 1.7;

/// Words and factors of the program's units.
struct ChartUnits {
    speed: (&'static str, f64),
    acceleration: (&'static str, f64),
    jerk: (&'static str, f64),
    distance: (&'static str, f64),
}

impl ChartUnits {
    fn of(inch: bool, path_mm: f64) -> ChartUnits {
        if inch {
            let per = 1.0 / INCH;
            ChartUnits {
                speed: ("in/min", 60.0 * per),
                acceleration: ("in/s²", per),
                jerk: ("in/s³", per),
                distance: ("in", per),
            }
        } else {
            ChartUnits {
                speed: ("mm/min", 60.0),
                acceleration: ("mm/s²", 1.0),
                jerk: ("m/s³", 1e-3),
                distance: if path_mm > 20_000.0 { ("m", 1e-3) } else { ("mm", 1.0) },
            }
        }
    }
}

/// The unit of the time axis.
fn time_unit(seconds: f64) -> (&'static str, f64) {
    match seconds {
        s if s <= 300.0 => ("s", 1.0),
        s if s <= 18_000.0 => ("min", 1.0 / 60.0),
        _ => ("h", 1.0 / 3600.0),
    }
}

/// The whole sheet.
pub(super) fn svg(plot: &MotionPlot, options: &PlotOptions) -> String {
    let (width, height) =
        (f64::from(options.width_px.max(200)), f64::from(options.height_px.max(200)));
    let sheet = MotionSheet {
        plot,
        colors: Palette::of(options.dark),
        words: ChartUnits::of(plot.inch, plot.distance_mm),
        width,
        height,
        unit: SheetLayout::unit(width, height),
    };
    let mut out = String::new();
    sheet.open(&mut out, options);
    sheet.legend(&mut out);
    sheet.charts(&mut out);
    out.push_str("</svg>\n");
    out
}

struct MotionSheet<'p> {
    plot: &'p MotionPlot,
    colors: &'static Palette,
    words: ChartUnits,
    width: f64,
    height: f64,
    unit: f64,
}

/// A chart over time of the axes and of the path.
struct OfAxes {
    title: &'static str,
    unit: (&'static str, f64),
    /// The first axis and the path in a cell.
    axes: usize,
    along: usize,
    limits: PerAxis<f64>,
}

impl MotionSheet<'_> {
    fn open(&self, out: &mut String, options: &PlotOptions) {
        let (width, height, unit) = (px(self.width), px(self.height), self.unit);
        out.push_str(&format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"Ubuntu, 'Helvetica Neue', Helvetica, \
             Arial, sans-serif\" font-weight=\"400\">\n<title>{}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>\n",
            escape(&options.title),
            self.colors.sheet
        ));
        let room = self.width / unit - 2.0 * MARGIN_UNITS;
        for (text, size, below, color) in [
            (&options.title, 27.0, 22.0, self.colors.text),
            (&options.subtitle, 16.0, 48.0, self.colors.faint),
        ] {
            out.push_str(&format!(
                "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{color}\">{}</text>\n",
                px(MARGIN_UNITS * unit),
                px((MARGIN_UNITS + below) * unit),
                px(size * unit),
                escape(&shorten(text, size, room))
            ));
        }
    }

    /// Whether an axis ever moved.
    fn moves(&self, axis: usize) -> bool {
        self.plot.time.extent(JERK + axis).is_some_and(|(low, high)| low < 0.0 || high > 0.0)
    }

    fn legend(&self, out: &mut String) {
        let unit = self.unit;
        let y = (MARGIN_UNITS + 76.0) * unit;
        let mut x = MARGIN_UNITS * unit;
        let mut entries = vec![("along the path".to_string(), self.colors.faint, 3.0, "")];
        for axis in (0..AXES).filter(|axis| self.moves(*axis)) {
            let name = AXIS_NAMES[axis];
            let name = if axis < 3 { name.into() } else { format!("{name} in degrees") };
            entries.push((name, self.colors.tool(axis), 2.0, ""));
        }
        entries.push(("limit of an axis".into(), self.colors.faint, 1.1, "7 5"));
        if !self.plot.tools.is_empty() {
            entries.push(("tool change".into(), self.colors.rapid, 1.1, "2 3"));
        }
        for (text, color, stroke, dash) in entries {
            out.push_str(&format!(
                "<path d=\"M{} {}h{}\" stroke=\"{color}\" stroke-width=\"{}\" \
                 stroke-dasharray=\"{dash}\" fill=\"none\"/>\n\
                 <text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\">{text}</text>\n",
                px(x),
                px(y),
                px(28.0 * unit),
                px(stroke * unit),
                px(x + 36.0 * unit),
                px(y + 5.0 * unit),
                px(15.0 * unit),
                self.colors.text
            ));
            x += (36.0 + text_width(&text, 15.0) + 26.0) * unit;
        }
    }

    fn charts(&self, out: &mut String) {
        let rects = self.rects();
        let (word, factor) = time_unit(self.plot.time.end());
        let time = AxisScale::new(0.0, (self.plot.time.end() * factor).max(1e-9), 12.0, false);
        self.speed(out, rects[0], &time, (word, factor));
        let limits = &self.plot.limits;
        let charts = [
            OfAxes {
                title: "Acceleration",
                unit: self.words.acceleration,
                axes: ACCELERATION,
                along: ALONG_ACCELERATION,
                limits: limits.acceleration(),
            },
            OfAxes {
                title: "Jerk",
                unit: self.words.jerk,
                axes: JERK,
                along: ALONG_JERK,
                limits: limits.jerk(),
            },
        ];
        for (chart, rect) in charts.iter().zip(&rects[1..]) {
            self.of_axes(out, *rect, &time, (word, factor), chart);
        }
        self.along_the_path(out, rects[3]);
    }

    fn rects(&self) -> [PixelRect; 4] {
        let unit = self.unit;
        let room = self.height / unit
            - 2.0 * MARGIN_UNITS
            - HEADER
            - 4.0 * ABOVE
            - BELOW.iter().sum::<f64>()
            + 12.0;
        let whole: f64 = SHARES.iter().sum();
        let mut top = MARGIN_UNITS + HEADER;
        std::array::from_fn(|chart| {
            let (share, below) = (SHARES[chart], BELOW[chart]);
            let height = (room * share / whole).max(20.0);
            let rect = PixelRect {
                x: (MARGIN_UNITS + LEFT) * unit,
                y: (top + ABOVE) * unit,
                width: self.width - (2.0 * MARGIN_UNITS + LEFT + RIGHT) * unit,
                height: height * unit,
            };
            top += ABOVE + height + below;
            rect
        })
    }

    fn speed(
        &self,
        out: &mut String,
        rect: PixelRect,
        time: &AxisScale,
        (word, factor): (&str, f64),
    ) {
        let (unit, scale) = self.words.speed;
        let high = self.plot.time.extent(SPEED).map_or(0.0, |extent| extent.1) * scale;
        let y = AxisScale::new(0.0, high.max(1e-9) * 1.12, 5.0, false);
        let chart = ChartArea { rect, x: time.clone(), y, unit: self.unit };
        chart.frame(out, &format!("Speed over time, {unit}"), word, self.colors);
        self.tools(out, &chart, factor, true);
        let color = self.colors.faint;
        let series = ChartSeries { value: SPEED, factor: scale, color, stroke: 1.8 };
        chart.curve(out, &self.plot.time, factor, &series);
        self.lines(out, &chart, |x| self.plot.time.line_at(x / factor));
    }

    fn of_axes(
        &self,
        out: &mut String,
        rect: PixelRect,
        time: &AxisScale,
        (word, factor): (&str, f64),
        what: &OfAxes,
    ) {
        let (unit, scale) = what.unit;
        let axes: Vec<usize> = (0..AXES).filter(|axis| self.moves(*axis)).collect();
        // A rotary axis has degrees where the others have the chart's unit.
        let factor_of = |axis: usize| if axis < 3 { scale } else { 1f64.to_degrees() };
        let values = axes.iter().map(|axis| (what.axes + axis, factor_of(*axis)));
        let largest = values
            .chain([(what.along, scale)])
            .filter_map(|(value, factor)| {
                let (low, high) = self.plot.time.extent(value)?;
                Some(high.max(-low) * factor)
            })
            .fold(1e-9, f64::max);
        let limits: Vec<(usize, f64)> = axes
            .iter()
            .map(|axis| (*axis, what.limits[*axis] * factor_of(*axis)))
            .filter(|(_, limit)| limit.is_finite())
            .collect();
        let drawn = limits.iter().filter(|(_, limit)| *limit <= MAX_LIMIT_RATIO * largest);
        let high = drawn.clone().map(|(_, limit)| *limit).fold(largest, f64::max) * 1.04;
        let y = AxisScale::new(-high, high, 6.0, false);
        let chart = ChartArea { rect, x: time.clone(), y, unit: self.unit };
        let title = format!("{} over time, {unit}{}", what.title, limits_text(&limits, &chart.y));
        chart.frame(out, &title, word, self.colors);
        self.tools(out, &chart, factor, false);
        let faint = self.colors.faint;
        let along = ChartSeries { value: what.along, factor: scale, color: faint, stroke: 2.6 };
        chart.curve(out, &self.plot.time, factor, &along);
        for axis in axes {
            let color = self.colors.tool(axis);
            let value = what.axes + axis;
            let series = ChartSeries { value, factor: factor_of(axis), color, stroke: 1.2 };
            chart.curve(out, &self.plot.time, factor, &series);
        }
        let mut seen: Vec<f64> = Vec::new();
        for (_, limit) in drawn {
            if !seen.contains(limit) {
                seen.push(*limit);
                chart.limit(out, *limit, faint);
                chart.limit(out, -*limit, faint);
            }
        }
    }

    fn along_the_path(&self, out: &mut String, rect: PixelRect) {
        let (course, factor) = self.words.distance;
        let (unit, scale) = self.words.speed;
        let x = AxisScale::new(0.0, (self.plot.by_distance.end() * factor).max(1e-9), 12.0, false);
        let high = self.plot.by_distance.extent(0).map_or(0.0, |extent| extent.1) * scale;
        let y = AxisScale::new(0.0, high.max(1e-9) * 1.06, 5.0, false);
        let chart = ChartArea { rect, x, y, unit: self.unit };
        chart.frame(out, &format!("Speed along the path, {unit}"), course, self.colors);
        let color = self.colors.faint;
        chart.curve(
            out,
            &self.plot.by_distance,
            factor,
            &ChartSeries { value: 0, factor: scale, color, stroke: 1.8 },
        );
        self.lines(out, &chart, |x| self.plot.by_distance.line_at(x / factor));
    }

    /// Tool changes where there is room.
    fn tools(&self, out: &mut String, chart: &ChartArea, factor: f64, named: bool) {
        let mut free = f64::NEG_INFINITY;
        for (time_s, tool) in &self.plot.tools {
            let x = chart.across(time_s * factor);
            if x < free {
                continue;
            }
            out.push_str(&format!(
                "<path d=\"M{} {}v{}\" stroke=\"{}\" stroke-width=\"{}\" \
                 stroke-dasharray=\"{} {}\" fill=\"none\"/>\n",
                px(x),
                px(chart.rect.y),
                px(chart.rect.height),
                self.colors.rapid,
                px(1.1 * self.unit),
                px(2.0 * self.unit),
                px(3.0 * self.unit)
            ));
            if named {
                let at = (x + 4.0 * self.unit, chart.rect.y + 14.0 * self.unit);
                chart.text(out, at, "start", self.colors.faint, &format!("T{tool}"));
            }
            free = x + 34.0 * self.unit;
        }
    }

    /// The lines of the program under the numbers.
    fn lines(&self, out: &mut String, chart: &ChartArea, line_at: impl Fn(f64) -> Option<u32>) {
        let y = chart.rect.bottom() + 32.0 * self.unit;
        let mut free = f64::NEG_INFINITY;
        for tick in chart.x.ticks() {
            let x = chart.across(tick);
            let Some(line) = line_at(tick).filter(|_| x >= free) else { continue };
            let text = format!("line {line}");
            chart.text(out, (x, y), "middle", self.colors.rapid, &text);
            free = x + (text_width(&text, 13.0) + 14.0) * self.unit;
        }
    }
}

/// `; limits X Y 3,000, Z 2,000`.
fn limits_text(limits: &[(usize, f64)], scale: &AxisScale) -> String {
    let mut groups: Vec<(f64, String)> = Vec::new();
    for (axis, limit) in limits {
        match groups.iter_mut().find(|(value, _)| value == limit) {
            Some((_, names)) => names.push_str(&format!(" {}", AXIS_NAMES[*axis])),
            None => groups.push((*limit, AXIS_NAMES[*axis].to_string())),
        }
    }
    let texts: Vec<String> =
        groups.iter().map(|(limit, names)| format!("{names} {}", scale.number(*limit))).collect();
    if texts.is_empty() { String::new() } else { format!("; limits {}", texts.join(", ")) }
}
