//! The sheet: caption, views, legend.

use chordal::geometry::{Aabb, Vec3};
use resvg::tiny_skia::Pixmap;

use super::frame::{self, GridSteps, INCH};
use super::lathe_stock::TurnedStockPlot;
use super::layout::{MARGIN_UNITS, SheetLayout};
use super::palette::Palette;
use super::pen::ViewPaths;
use super::relief::DrawnRelief;
use super::store::{CutGroup, CutStroke, PathStore};
use super::text::{escape, label, px};
use super::view::{PixelRect, ViewPanel};
use super::{PlotError, PlotOptions, draw_onto, png_of, usvg_options};

/// Rows of the legend; tools for which there is no room are counted.
const LEGEND_ROWS: usize = 3;
/// Height of a row of the legend, units.
const ROW: f64 = 25.0;

/// Bytes of path data of one view beyond which it is drawn coarser.
const MAX_BYTES: usize = 3 << 20;

/// A sheet in layers: what lies under the stock, the stock, and what lies over it.
pub(super) struct SheetLayers {
    /// The root element with its definitions.
    head: String,
    under: String,
    stock: Vec<DrawnRelief>,
    over: String,
}

const END: &str = "</svg>\n";

impl SheetLayers {
    /// All in one.
    pub fn svg(self) -> String {
        let stock: String = self.stock.iter().map(DrawnRelief::svg).collect();
        [self.head, self.under, stock, self.over, END.to_string()].concat()
    }

    /// All in one as PNG.
    pub fn pixels(self, width: u32, height: u32) -> Result<Vec<u8>, PlotError> {
        let mut pixmap = Pixmap::new(width, height).ok_or(PlotError::Size(width, height))?;
        let options = usvg_options();
        let SheetLayers { head, under, stock, over } = self;
        if stock.is_empty() {
            draw_onto(&mut pixmap, &[&head, &under, &over, END].concat(), &options)?;
            return png_of(&pixmap);
        }
        draw_onto(&mut pixmap, &[&head, &under, END].concat(), &options)?;
        for picture in &stock {
            picture.paint(&mut pixmap);
        }
        draw_onto(&mut pixmap, &[&head, &over, END].concat(), &options)?;
        png_of(&pixmap)
    }
}

/// The whole sheet.
pub(super) fn layers(
    store: &PathStore,
    turned: Option<&TurnedStockPlot>,
    inch: bool,
    options: &PlotOptions,
) -> SheetLayers {
    let colors = Palette::of(options.dark);
    let (width, height) =
        (f64::from(options.width_px.max(200)), f64::from(options.height_px.max(200)));
    let unit = SheetLayout::unit(width, height);
    let legend = SheetLegend::new(store, inch, width, unit);
    let bounds = match (store.extent(), turned) {
        (Some(bounds), Some(turned)) => Some(turned.around(bounds)),
        (bounds, _) => bounds,
    };
    let drawn = bounds.unwrap_or(Aabb { min: Vec3::ZERO, max: Vec3::ZERO });
    let layout = match turned {
        Some(_) => SheetLayout::turned(width, height, &drawn, legend.height()),
        None => SheetLayout::new(width, height, &drawn, legend.height()),
    };
    let grid = GridSteps::new(&layout.panels[0], unit, inch, &drawn);

    let (mut head, mut under, mut over) = (String::new(), String::new(), String::new());
    open(&mut head, &layout, options);
    sheet(&mut under, &layout, colors);
    caption(&mut under, store, &layout, &grid, inch, options, colors);
    let mut stock = Vec::new();
    match bounds {
        Some(bounds) => {
            for (index, panel) in layout.panels.iter().enumerate() {
                ground(&mut under, panel, index, &grid, &bounds, unit, colors);
                if let Some(turned) = turned.filter(|_| panel.view.doubled) {
                    under_path(&mut under, &turned.svg(panel, unit, colors), index);
                }
                stock.extend(store.stock.as_ref().and_then(|of| of.draw(panel, options.dark)));
                view(&mut over, store, panel, index, unit, MAX_BYTES, colors);
            }
            legend.draw(&mut over, &layout, colors);
        }
        None => nothing(&mut over, store, &layout, colors),
    }
    SheetLayers { head, under, stock, over }
}

fn open(out: &mut String, layout: &SheetLayout, options: &PlotOptions) {
    let (width, height) = (px(layout.width), px(layout.height));
    out.push_str(&format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"Ubuntu, 'Helvetica Neue', Helvetica, \
         Arial, sans-serif\" font-weight=\"400\">\n<title>{}</title>\n",
        escape(&options.title)
    ));
    out.push_str("<defs>\n");
    for (index, panel) in layout.panels.iter().enumerate() {
        clip(out, panel, index);
    }
    out.push_str("</defs>\n");
}

fn sheet(out: &mut String, layout: &SheetLayout, colors: &Palette) {
    let (width, height) = (px(layout.width), px(layout.height));
    out.push_str(&format!(
        "<rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>\n",
        colors.sheet
    ));
}

/// The clip path of a view.
pub(super) fn clip(out: &mut String, panel: &ViewPanel, index: usize) {
    let PixelRect { x, y, width, height } = panel.rect;
    out.push_str(&format!(
        "<clipPath id=\"view{index}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\
         </clipPath>\n",
        px(x),
        px(y),
        px(width),
        px(height)
    ));
}

/// File, machine, extents.
fn caption(
    out: &mut String,
    store: &PathStore,
    layout: &SheetLayout,
    grid: &GridSteps,
    inch: bool,
    options: &PlotOptions,
    colors: &Palette,
) {
    let unit = layout.unit;
    let (left, right) = (MARGIN_UNITS * unit, layout.width - MARGIN_UNITS * unit);
    let room = layout.width / unit - 2.0 * MARGIN_UNITS;
    let is_turned = layout.panels[0].view.doubled;
    let lines = extents(store, is_turned, grid, inch);
    let side = lines.iter().map(|line| text_width(line, 14.0)).fold(0.0, f64::max) + 30.0;
    let title = shorten(&options.title, 27.0, room - side);
    let subtitle = shorten(&options.subtitle, 16.0, room - side);
    let mut line = |x: f64, y: f64, size: f64, color: &str, anchor: &str, text: &str| {
        if !text.is_empty() {
            out.push_str(&format!(
                "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{color}\" \
                 text-anchor=\"{anchor}\">{}</text>\n",
                px(x),
                px(y * unit),
                px(size * unit),
                escape(text)
            ));
        }
    };
    line(left, MARGIN_UNITS + 22.0, 27.0, colors.text, "start", &title);
    line(left, MARGIN_UNITS + 48.0, 16.0, colors.faint, "start", &subtitle);
    for (index, text) in lines.iter().enumerate() {
        let y = MARGIN_UNITS + 14.0 + 19.0 * index as f64;
        line(right, y, 14.0, colors.faint, "end", text);
    }
}

/// The extents of the cuts and the step of the grid.
fn extents(store: &PathStore, is_turned: bool, grid: &GridSteps, inch: bool) -> Vec<String> {
    let mut lines = Vec::new();
    let (factor, word, decimals) = if inch { (INCH, "in", 4) } else { (1.0, "mm", 3) };
    if let Some(cuts) = store.cut_extent() {
        let (low, high) = (cuts.min.to_array(), cuts.max.to_array());
        let axes: Vec<String> = ["X", "Y", "Z"]
            .iter()
            .enumerate()
            .filter(|(axis, _)| !is_turned || *axis != 1)
            .map(|(axis, letter)| {
                // X of a lathe is a diameter.
                let written = if is_turned && axis == 0 { 2.0 } else { 1.0 };
                let number = |value: f64| trimmed(written * value / factor, decimals);
                format!("{letter} {} to {}", number(low[axis]), number(high[axis]))
            })
            .collect();
        lines.push(format!("{} {word}", axes.join("  ·  ")));
    }
    if store.extent().is_some() {
        lines.push(format!("grid {}", grid.text()));
    }
    if store.has_unknown() && store.extent().is_some() {
        lines.push("cuts at unknown positions are left out".into());
    }
    lines.extend(store.remarks());
    lines
}

/// What lies under everything in a view.
pub(super) fn ground(
    out: &mut String,
    panel: &ViewPanel,
    index: usize,
    grid: &GridSteps,
    bounds: &Aabb,
    unit: f64,
    colors: &Palette,
) {
    frame::under(out, panel, grid, unit, colors);
    if !panel.view.along_axes {
        out.push_str(&format!("<g clip-path=\"url(#view{index})\" fill=\"none\">\n"));
        frame::floor(out, panel, grid, bounds, unit, colors);
        out.push_str("</g>\n");
    }
}

/// A drawing between the ground and the path of a view.
pub(super) fn under_path(out: &mut String, drawn: &str, index: usize) {
    out.push_str(&format!("<g clip-path=\"url(#view{index})\" fill=\"none\">\n{drawn}</g>\n"));
}

/// A view with everything in it that lies over the ground and the stock.
pub(super) fn view(
    out: &mut String,
    store: &PathStore,
    panel: &ViewPanel,
    index: usize,
    unit: f64,
    most_bytes: usize,
    colors: &Palette,
) {
    out.push_str(&format!("<g clip-path=\"url(#view{index})\" fill=\"none\">\n"));
    paths(out, store, panel, unit, most_bytes, colors);
    frame::origin(out, panel, unit, colors);
    ends(out, store, panel, unit, colors);
    out.push_str("</g>\n");
    frame::over(out, panel, unit, colors);
}

fn paths(
    out: &mut String,
    store: &PathStore,
    panel: &ViewPanel,
    unit: f64,
    most_bytes: usize,
    colors: &Palette,
) {
    let paths = ViewPaths::of(store, panel, unit, most_bytes);
    if !paths.rapids.is_empty() {
        out.push_str(&format!(
            "<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{} {}\"/>\n",
            paths.rapids,
            colors.rapid,
            px(0.9 * unit),
            px(6.0 * unit),
            px(4.0 * unit)
        ));
    }
    let stroke = stroke_width(store, panel, unit);
    let groups = store.groups();
    for (index, data) in paths.tools.iter().enumerate().filter(|(_, data)| !data.is_empty()) {
        let group = &groups.list[index];
        // Of two programs the first is a band in which the second runs.
        let is_band = store.overlay.is_some() && group.id == "tool-1";
        let stroke = px(if is_band { stroke * 3.5 } else { stroke });
        out.push_str(&format!(
            "<path id=\"view-{}-{}\" d=\"{data}\" stroke=\"{}\" \
             stroke-width=\"{stroke}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"{}/>\n",
            panel.view.title.to_lowercase(),
            group.id,
            stroke_color(colors, group.stroke),
            stroke_dash(colors, group.stroke, unit)
        ));
    }
}

/// The colour of a group of cuts.
fn stroke_color(colors: &Palette, stroke: CutStroke) -> &'static str {
    match stroke {
        CutStroke::Tool(index) => colors.tool(index),
        CutStroke::Off => colors.rapid,
        CutStroke::Step(step) => colors.step(step),
    }
}

fn stroke_dash(colors: &Palette, stroke: CutStroke, unit: f64) -> String {
    match stroke {
        CutStroke::Tool(index) => tool_dash(colors, index, unit),
        CutStroke::Off | CutStroke::Step(_) => String::new(),
    }
}

/// Tools beyond the last colour have the same colours again, dashed.
pub(super) fn tool_dash(colors: &Palette, index: usize, unit: f64) -> String {
    let (line, gap) = match colors.round(index) {
        0 => return String::new(),
        1 => (10.0, 5.0),
        _ => (2.0, 5.0),
    };
    format!(" stroke-dasharray=\"{} {}\"", px(line * unit), px(gap * unit))
}

/// Thinner lines where they lie close together, so that they do not run into one another.
fn stroke_width(store: &PathStore, panel: &ViewPanel, unit: f64) -> f64 {
    let area = panel.rect.width * panel.rect.height;
    let covered = store.cut_mm() * panel.scale * 2.0 * unit / area;
    let width = 2.0 - 1.3 * ((covered - 0.12) / 0.6).clamp(0.0, 1.0);
    width * unit
}

/// Begin and end of the path.
fn ends(out: &mut String, store: &PathStore, panel: &ViewPanel, unit: f64, colors: &Palette) {
    let Some((start, end)) = store.ends() else { return };
    let (start, end) = (panel.place(start), panel.place(end));
    if panel.rect.holds(end, 0.0) {
        end_mark(out, end, unit, colors);
    }
    if panel.rect.holds(start, 0.0) {
        start_mark(out, start, unit, colors);
    }
}

fn start_mark(out: &mut String, at: (f64, f64), unit: f64, colors: &Palette) {
    out.push_str(&format!(
        "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\"/>\n",
        px(at.0),
        px(at.1),
        px(3.3 * unit),
        colors.sheet,
        colors.start,
        px(1.6 * unit)
    ));
}

fn end_mark(out: &mut String, at: (f64, f64), unit: f64, colors: &Palette) {
    let half = 5.0 * unit;
    out.push_str(&format!(
        "<rect x=\"{}\" y=\"{}\" width=\"{size}\" height=\"{size}\" fill=\"{}\"/>\n",
        px(at.0 - half),
        px(at.1 - half),
        colors.start,
        size = px(2.0 * half)
    ));
}

/// The sheet of a program that does not move.
fn nothing(out: &mut String, store: &PathStore, layout: &SheetLayout, colors: &Palette) {
    let unit = layout.unit;
    let text = if store.has_unknown() {
        "no motion at a known position relative to the part"
    } else {
        "no motion"
    };
    let (x, y) = (MARGIN_UNITS * unit, (MARGIN_UNITS + 72.0) * unit);
    out.push_str(&format!(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n\
         <text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"middle\">{text}\
         </text>\n",
        px(x),
        px(y),
        px(layout.width - 2.0 * x),
        px(layout.height - y - MARGIN_UNITS * unit),
        colors.panel,
        colors.border,
        px(0.5 * layout.width),
        px(0.5 * (layout.height + y)),
        px(22.0 * unit),
        colors.faint
    ));
}

/// What a sign of the legend is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum LegendSign {
    Cut(CutStroke),
    Rapid,
    Start,
    End,
    None,
}

#[derive(Debug)]
struct LegendEntry {
    sign: LegendSign,
    text: String,
    /// From the left, units.
    x: f64,
    row: usize,
}

#[derive(Debug)]
struct SheetLegend {
    entries: Vec<LegendEntry>,
}

/// Width of a sign with its gap, units.
const SIGN: f64 = 38.0;
const LEGEND_TEXT: f64 = 15.0;

impl SheetLegend {
    fn new(store: &PathStore, inch: bool, width: f64, unit: f64) -> SheetLegend {
        let mut legend = SheetLegend { entries: Vec::new() };
        if store.extent().is_none() {
            return legend;
        }
        let length = |mm: f64| {
            if inch { format!("{} in", measure(mm / INCH)) } else { format!("{} mm", measure(mm)) }
        };
        let room = width / unit - 2.0 * MARGIN_UNITS;
        legend.add(LegendSign::Start, "start".into(), room);
        legend.add(LegendSign::End, "end".into(), room);
        if let Some(mm) = store.rapid_mm() {
            legend.add(LegendSign::Rapid, format!("rapid {}", length(mm)), room);
        }
        let groups: Vec<CutGroup> = store.groups().list.into_iter().filter(is_listed).collect();
        for (index, group) in groups.iter().enumerate() {
            let text = format!("{}  {}", group.name, length(group.cut_mm));
            if !legend.add(LegendSign::Cut(group.stroke), text, room - 140.0) {
                let text = format!("and {} more tools", groups.len() - index);
                legend.add(LegendSign::None, text, f64::INFINITY);
                break;
            }
        }
        legend
    }

    /// Adds an entry, on the next row where this one is full; false when there is no row.
    fn add(&mut self, sign: LegendSign, text: String, room: f64) -> bool {
        let (mut x, mut row) = match self.entries.last() {
            Some(last) => (last.x + SIGN + text_width(&last.text, LEGEND_TEXT) + 26.0, last.row),
            None => (0.0, 0),
        };
        let wide = SIGN + text_width(&text, LEGEND_TEXT);
        let last_row = LEGEND_ROWS - 1;
        let limit = if row == last_row { room } else { room + 140.0 };
        if x + wide > limit && x > 0.0 {
            if row == last_row {
                return false;
            }
            (x, row) = (0.0, row + 1);
        }
        self.entries.push(LegendEntry { sign, text, x, row });
        true
    }

    /// Units.
    fn height(&self) -> f64 {
        self.entries.last().map_or(0.0, |last| 14.0 + ROW * (last.row + 1) as f64)
    }

    fn draw(&self, out: &mut String, layout: &SheetLayout, colors: &Palette) {
        let unit = layout.unit;
        let top = layout.height - (MARGIN_UNITS + self.height() - 20.0) * unit;
        for entry in &self.entries {
            let x = (MARGIN_UNITS + entry.x) * unit;
            let y = top + (entry.row as f64 + 0.5) * ROW * unit;
            sign(out, entry.sign, (x, y), unit, colors);
            let offset = if entry.sign == LegendSign::None { 0.0 } else { SIGN };
            out.push_str(&format!(
                "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\">{}</text>\n",
                px(x + offset * unit),
                px(y + 5.2 * unit),
                px(LEGEND_TEXT * unit),
                colors.text,
                escape(&entry.text)
            ));
        }
    }
}

/// Steps of power that nothing was cut with are not listed.
fn is_listed(group: &CutGroup) -> bool {
    group.cut_mm > 0.0 || matches!(group.stroke, CutStroke::Tool(_))
}

fn sign(out: &mut String, sign: LegendSign, (x, y): (f64, f64), unit: f64, colors: &Palette) {
    let middle = (x + 20.0 * unit, y);
    let line = |color: &str, width: f64, dash: &str| {
        format!(
            "<path d=\"M{} {}h{}\" stroke=\"{color}\" stroke-width=\"{}\" fill=\"none\" \
             stroke-linecap=\"butt\"{dash}/>\n",
            px(x),
            px(y),
            px(28.0 * unit),
            px(width * unit)
        )
    };
    match sign {
        LegendSign::Cut(stroke) => {
            let color = stroke_color(colors, stroke);
            out.push_str(&line(color, 3.5, &stroke_dash(colors, stroke, unit)));
        }
        LegendSign::Rapid => {
            let dash = format!(" stroke-dasharray=\"{} {}\"", px(6.0 * unit), px(4.0 * unit));
            out.push_str(&line(colors.rapid, 1.2, &dash));
        }
        LegendSign::Start => start_mark(out, middle, unit, colors),
        LegendSign::End => end_mark(out, middle, unit, colors),
        LegendSign::None => {}
    }
}

/// About how wide a text is: its font is not known to every viewer.
pub(super) fn text_width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * size * 0.53
}

/// The text as far as it fits.
pub(super) fn shorten(text: &str, size: f64, room: f64) -> String {
    let most = (room / (size * 0.53)).max(8.0) as usize;
    if text.chars().count() <= most {
        return text.into();
    }
    text.chars().take(most - 1).chain(['…']).collect()
}

/// A length with three or four digits that count.
fn measure(value: f64) -> String {
    let decimals = match value.abs() {
        v if v >= 1000.0 => 0,
        v if v >= 100.0 => 1,
        v if v >= 10.0 => 2,
        v if v >= 0.01 || v == 0.0 => 3,
        _ => 6,
    };
    label(value, decimals)
}

/// A number of at most so many decimals without zeros at its end.
fn trimmed(value: f64, decimals: usize) -> String {
    let text = label(value, decimals);
    if !text.contains('.') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').into()
}
