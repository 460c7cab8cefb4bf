//! The half section of a turned part as a drawing: Z to the right, the section above the axis, the part seen from
//! outside below, dimensions as diameters.

use chordal::geometry::Vec2;
use chordal::stock::TurnedReport;
use chordal::stock::section::{OutlineSegment, Region};

use super::lathe_stock::{path_data, segment_data};
use super::palette::Palette;
use super::sheet::{shorten, text_width};
use super::text::{escape, label, px};
use super::{PlotError, PlotOptions, render};

const INCH: f64 = 25.4;
/// Measures of the sheet, units.
const LEFT: f64 = 60.0;
const ABOVE: f64 = 110.0;
const RIGHT: f64 = 150.0;
const BELOW: f64 = 130.0;
const TEXT: f64 = 14.0;
/// Dimensions along one side; more do not fit.
const MAX_DIMENSIONS: usize = 36;
/// Places this near are one, mm.
const COINCIDENT_SECTION_MM: f64 = 1e-6;
/// Shorter lines of the outline have no dimension, mm.
const MIN_DIMENSIONED_MM: f64 = 0.05;

/// The drawing as SVG. Sides below 200 px are drawn as 200.
pub fn section_svg(found: &TurnedReport, options: &PlotOptions) -> String {
    let (width, height) =
        (f64::from(options.width_px.max(200)), f64::from(options.height_px.max(200)));
    let sheet = SectionSheet::new(found, width, height, options);
    sheet.svg(found, options)
}

/// The drawing as PNG.
///
/// # Errors
/// When the sheet has no reasonable size.
pub fn section_png(found: &TurnedReport, options: &PlotOptions) -> Result<Vec<u8>, PlotError> {
    render(options.width_px, options.height_px, || section_svg(found, options))
}

/// Units of a drawing for a page, px: its texts are as large as those of the page.
const PAGE_UNIT: f64 = 0.86;
/// Above the drawing of a page there is no caption, units.
const PAGE_ABOVE: f64 = 34.0;

/// The drawing for a page that has a caption of its own, as SVG. Its colours are names, which
/// [`Plot::page_colors`](super::Plot::page_colors) explains. Sides below 200 px are drawn as 200.
pub fn page_section(found: &TurnedReport, width_px: u32, height_px: u32) -> String {
    let (width, height) = (f64::from(width_px.max(200)), f64::from(height_px.max(200)));
    let sheet =
        SectionSheet::fitted(found, [width, height], PAGE_UNIT, PAGE_ABOVE, Palette::page());
    let mut out = format!(
        "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Half section of what is left\">\n",
        px(width),
        px(height)
    );
    sheet.drawing(&mut out, found);
    out.push_str("</svg>\n");
    out
}

struct SectionSheet {
    width: f64,
    height: f64,
    unit: f64,
    /// px for each mm.
    scale: f64,
    /// Where z 0 and the axis are, px.
    zero: (f64, f64),
    /// The largest radius, mm.
    top: f64,
    colors: &'static Palette,
    inch: bool,
}

impl SectionSheet {
    fn new(found: &TurnedReport, width: f64, height: f64, options: &PlotOptions) -> SectionSheet {
        let unit = (width * height / (1600.0 * 1131.0)).sqrt().min(width / 900.0).max(0.5);
        SectionSheet::fitted(found, [width, height], unit, ABOVE, Palette::of(options.dark))
    }

    /// The part as large as it can be with so many units above it.
    fn fitted(
        found: &TurnedReport,
        [width, height]: [f64; 2],
        unit: f64,
        above: f64,
        colors: &'static Palette,
    ) -> SectionSheet {
        let (low, high) = bounds(found);
        let room_x = (width - (LEFT + RIGHT) * unit).max(40.0);
        let room_y = (height - (above + BELOW) * unit).max(40.0);
        let (long, top) = ((high.a - low.a).max(1e-3), high.b.max(1e-3));
        let scale = (room_x / long).min(room_y / (2.0 * top));
        let left = LEFT * unit + 0.5 * (room_x - long * scale);
        let axis = above * unit + 0.5 * room_y;
        SectionSheet {
            width,
            height,
            unit,
            scale,
            zero: (left - low.a * scale, axis),
            top,
            colors,
            inch: found.report.summary.inch,
        }
    }

    fn place(&self, p: Vec2) -> (f64, f64) {
        (self.zero.0 + p.a * self.scale, self.zero.1 - p.b * self.scale)
    }

    fn below(&self, p: Vec2) -> (f64, f64) {
        self.place(Vec2::new(p.a, -p.b))
    }

    fn number(&self, mm: f64) -> String {
        let (value, decimals) = if self.inch { (mm / INCH, 4) } else { (mm, 3) };
        let text = label(value, decimals);
        if text.contains('.') {
            text.trim_end_matches('0').trim_end_matches('.').into()
        } else {
            text
        }
    }

    fn svg(&self, found: &TurnedReport, options: &PlotOptions) -> String {
        let (w, h) = (px(self.width), px(self.height));
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" \
             font-family=\"Ubuntu, 'Helvetica Neue', Helvetica, Arial, sans-serif\" font-weight=\"400\">\n\
             <title>{}</title>\n<rect width=\"{w}\" height=\"{h}\" fill=\"{}\"/>\n",
            escape(&options.title),
            self.colors.sheet
        );
        self.caption(&mut out, options);
        self.drawing(&mut out, found);
        out.push_str("</svg>\n");
        out
    }

    /// The part with its dimensions.
    fn drawing(&self, out: &mut String, found: &TurnedReport) {
        let gap = px(7.0 * self.unit);
        out.push_str(&format!(
            "<defs><pattern id=\"hatch\" width=\"{gap}\" height=\"{gap}\" \
             patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><path d=\"M0 0V{gap}\" \
             stroke=\"{}\" stroke-width=\"{}\"/></pattern></defs>\n",
            self.colors.faint,
            px(0.8 * self.unit)
        ));
        self.part(out, found);
        self.diameters(out, found);
        self.lengths(out, found);
        self.radii(out, found);
    }

    fn text(
        &self,
        out: &mut String,
        (x, y): (f64, f64),
        size: f64,
        anchor: &str,
        color: &str,
        text: &str,
    ) {
        out.push_str(&format!(
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{color}\" text-anchor=\"{anchor}\">{}</text>\n",
            px(x),
            px(y),
            px(size * self.unit),
            escape(text)
        ));
    }

    fn caption(&self, out: &mut String, options: &PlotOptions) {
        let unit = self.unit;
        let room = self.width / unit - 60.0;
        let (title, subtitle) =
            (shorten(&options.title, 27.0, room), shorten(&options.subtitle, 16.0, room));
        self.text(out, (30.0 * unit, 52.0 * unit), 27.0, "start", self.colors.text, &title);
        self.text(out, (30.0 * unit, 78.0 * unit), 16.0, "start", self.colors.faint, &subtitle);
    }

    /// The section above the axis, the part from outside below, the stock before as a dashed line.
    fn part(&self, out: &mut String, found: &TurnedReport) {
        let (unit, scale, colors) = (self.unit, self.scale, self.colors);
        let up = |p: Vec2| self.place(p);
        let down = |p: Vec2| self.below(p);
        let mut draw = |data: String, style: String| {
            if !data.is_empty() {
                out.push_str(&format!("<path d=\"{data}\" {style}/>\n"));
            }
        };
        let (thin, wide) = (px(0.9 * unit), px(2.0 * unit));
        let line = |color: &str, width: &str, more: &str| {
            format!(
                "fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{more}"
            )
        };
        let dash = format!(" stroke-dasharray=\"{} {}\"", px(6.0 * unit), px(4.0 * unit));
        let before = found.before.shape();
        draw(path_data(&before, scale, up, false), line(colors.rapid, &thin, &dash));
        draw(path_data(&before, scale, down, true), line(colors.rapid, &thin, &dash));
        for section in &found.threaded_sections() {
            let loops = section.shape();
            let data = path_data(&loops, scale, up, false);
            draw(data.clone(), "fill=\"url(#hatch)\" fill-rule=\"evenodd\"".into());
            draw(data, line(colors.text, &wide, ""));
            let (fill, edges) = self.outside(section, &loops);
            draw(fill, format!("fill=\"{}\" fill-opacity=\"0.12\"", colors.faint));
            draw(edges, line(colors.text, &wide, ""));
        }
        for thread in found.threads.iter().filter(|thread| thread.grooves.is_none()) {
            let loops = thread.section.shape();
            draw(path_data(&loops, scale, up, false), line(colors.tool(0), &thin, ""));
            draw(path_data(&loops, scale, down, true), line(colors.tool(0), &thin, ""));
        }
        if let Some(target) = &found.target_section {
            draw(
                path_data(&target.shape(), scale, up, false),
                line(colors.tool(3), &px(1.3 * unit), ""),
            );
        }
        let (low, high) = bounds(found);
        let over = 14.0 * unit;
        let data =
            format!("M{} {}H{}", px(up(low).0 - over), px(self.zero.1), px(up(high).0 + over));
        let chain = format!(
            " stroke-dasharray=\"{} {} {} {}\"",
            px(18.0 * unit),
            px(4.0 * unit),
            px(3.0 * unit),
            px(4.0 * unit)
        );
        draw(data, line(colors.faint, &px(1.1 * unit), &chain));
    }

    /// What is seen of a part from outside, below the axis: its silhouette, and its edges.
    fn outside(&self, section: &Region, loops: &[Vec<OutlineSegment>]) -> (String, String) {
        let (mut fill, mut edges) = (String::new(), String::new());
        let at = |p: Vec2| {
            let (x, y) = self.below(p);
            format!("{} {}", px(x), px(y))
        };
        for segment in loops.iter().flatten() {
            let middle = middle(segment);
            let on_axis = |p: Vec2| Vec2::new(p.a, 0.0);
            let is_wall = (segment.start.a - segment.end.a).abs() <= COINCIDENT_SECTION_MM
                && segment.bend.is_none();
            let is_top = !is_wall
                && section
                    .highest_at(middle.a)
                    .is_some_and(|top| top <= middle.b + 1e-6 * self.top);
            if is_top {
                fill.push_str(&format!("M{}L{}", at(on_axis(segment.start)), at(segment.start)));
                segment_data(&mut fill, segment, self.scale, &|p| self.below(p), true);
                fill.push_str(&format!("L{}Z", at(on_axis(segment.end))));
                edges.push_str(&format!("M{}", at(segment.start)));
                segment_data(&mut edges, segment, self.scale, &|p| self.below(p), true);
                for end in [segment.start, segment.end] {
                    edges.push_str(&format!("M{}L{}", at(end), at(on_axis(end))));
                }
            } else if is_wall {
                // Where a wall is seen from outside it reaches up to the silhouette.
                let tops = section.highest_at(segment.start.a).unwrap_or(0.0);
                if tops <= segment.start.b.max(segment.end.b) + 1e-6 * self.top {
                    edges.push_str(&format!("M{}L{}", at(segment.start), at(segment.end)));
                }
            }
        }
        (fill, edges)
    }

    /// Diameters along the right side.
    fn diameters(&self, out: &mut String, found: &TurnedReport) {
        let mut places: Vec<(f64, f64, f64)> = Vec::new();
        for segment in found.sections().flat_map(Region::shape).flatten() {
            let (low, high) =
                (segment.start.a.min(segment.end.a), segment.start.a.max(segment.end.a));
            let is_level = segment.bend.is_none()
                && (segment.start.b - segment.end.b).abs() <= COINCIDENT_SECTION_MM;
            if !is_level
                || high - low < MIN_DIMENSIONED_MM
                || segment.start.b <= COINCIDENT_SECTION_MM
            {
                continue;
            }
            match places
                .iter_mut()
                .find(|(r, ..)| (*r - segment.start.b).abs() <= COINCIDENT_SECTION_MM)
            {
                Some(known) => (known.1, known.2) = (known.1.max(high), known.2 + high - low),
                None => places.push((segment.start.b, high, high - low)),
            }
        }
        // The longest ones, where there are too many.
        places.sort_by(|x, y| y.2.total_cmp(&x.2));
        places.truncate(MAX_DIMENSIONS);
        places.sort_by(|x, y| y.0.total_cmp(&x.0));
        let ends: Vec<(f64, f64)> =
            places.iter().map(|(r, z, _)| self.place(Vec2::new(*z, *r))).collect();
        let desired: Vec<f64> = ends.iter().map(|end| end.1).collect();
        let rows = spread(&desired, 18.0 * self.unit);
        let x = self.place(bounds(found).1).0 + 46.0 * self.unit;
        for (((r, ..), end), y) in places.iter().zip(&ends).zip(rows) {
            self.leader(out, &[*end, (x - 20.0 * self.unit, end.1), (x - 4.0 * self.unit, y)]);
            let text = format!("Ø{}", self.number(2.0 * r));
            self.text(out, (x, y + 5.0 * self.unit), TEXT, "start", self.colors.text, &text);
        }
    }

    /// Z of walls along the lower side.
    fn lengths(&self, out: &mut String, found: &TurnedReport) {
        let mut places: Vec<(f64, f64)> = Vec::new();
        for segment in found.sections().flat_map(Region::shape).flatten() {
            let long = segment.start.distance(segment.end);
            for end in [segment.start, segment.end] {
                match places.iter_mut().find(|(z, _)| (*z - end.a).abs() <= COINCIDENT_SECTION_MM) {
                    Some(known) => known.1 = known.1.max(long),
                    None => places.push((end.a, long)),
                }
            }
        }
        places.sort_by(|x, y| y.1.total_cmp(&x.1));
        places.truncate(MAX_DIMENSIONS);
        places.sort_by(|x, y| x.0.total_cmp(&y.0));
        let under = self.zero.1 + self.top * self.scale + 8.0 * self.unit;
        let desired: Vec<f64> =
            places.iter().map(|(z, _)| self.place(Vec2::new(*z, 0.0)).0).collect();
        let columns = spread(&desired, 17.0 * self.unit);
        let y = under + 34.0 * self.unit;
        for (((z, _), from), x) in places.iter().zip(&desired).zip(columns) {
            self.leader(
                out,
                &[(*from, under), (*from, under + 10.0 * self.unit), (x, y - 4.0 * self.unit)],
            );
            let text = escape(&format!("Z{}", self.number(*z)));
            let (tx, ty) = (px(x + 5.0 * self.unit), px(y));
            out.push_str(&format!(
                "<text transform=\"translate({tx} {ty}) rotate(-90)\" font-size=\"{}\" fill=\"{}\" \
                 text-anchor=\"end\">{text}</text>\n",
                px(TEXT * self.unit),
                self.colors.text
            ));
        }
    }

    /// Radii of arcs, next to them.
    fn radii(&self, out: &mut String, found: &TurnedReport) {
        let size = TEXT - 1.0;
        let mut taken: Vec<(f64, f64)> = Vec::new();
        for segment in found.sections().flat_map(Region::shape).flatten() {
            let Some(bend) = segment.bend else { continue };
            let text = format!("R{}", self.number(bend.radius));
            let long = segment.sweep().abs() * bend.radius * self.scale;
            if long < 12.0 * self.unit {
                continue;
            }
            let middle = middle(&segment);
            let away = (middle - bend.center).normalized().unwrap_or(Vec2::new(0.0, 1.0));
            // Outside of the part.
            let away = if bend.counterclockwise { away } else { -away };
            let (x, y) = self.place(middle);
            let reach = 13.0 * self.unit;
            let at = (
                x + away.a * (reach + 0.5 * text_width(&text, size) * self.unit),
                y - away.b * reach + 4.5 * self.unit,
            );
            let room = 16.0 * self.unit;
            if taken.iter().any(|(x, y)| (x - at.0).abs() < 3.0 * room && (y - at.1).abs() < room) {
                continue;
            }
            taken.push(at);
            self.text(out, at, size, "middle", self.colors.text, &text);
        }
    }

    fn leader(&self, out: &mut String, corners: &[(f64, f64)]) {
        let data: Vec<String> =
            corners.iter().map(|(x, y)| format!("{} {}", px(*x), px(*y))).collect();
        out.push_str(&format!(
            "<path d=\"M{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n",
            data.join("L"),
            self.colors.border,
            px(0.9 * self.unit)
        ));
    }
}

/// The box around what is left and what was there.
fn bounds(found: &TurnedReport) -> (Vec2, Vec2) {
    let all = found.sections().chain([&found.before]).filter_map(Region::bounds);
    let none = (Vec2::ZERO, Vec2::new(1.0, 1.0));
    all.reduce(|(low, high), (from, to)| {
        (
            Vec2::new(low.a.min(from.a), low.b.min(from.b)),
            Vec2::new(high.a.max(to.a), high.b.max(to.b)),
        )
    })
    .unwrap_or(none)
}

fn middle(segment: &OutlineSegment) -> Vec2 {
    let Some(bend) = segment.bend else { return (segment.start + segment.end) * 0.5 };
    let (sine, cosine) = (0.5 * segment.sweep()).sin_cos();
    let to = segment.start - bend.center;
    bend.center + to * cosine + to.turned_left() * sine
}

/// Places in ascending order, moved as little as needed to be `gap` apart.
fn spread(desired: &[f64], gap: f64) -> Vec<f64> {
    // Groups that touch lie around the middle of what their members want.
    let mut groups: Vec<(f64, usize)> = Vec::new();
    for place in desired {
        groups.push((*place, 1));
        while let [.., (before, count), (after, more)] = groups[..] {
            let (half, other) = (0.5 * gap * count as f64, 0.5 * gap * more as f64);
            if before + half <= after - other {
                break;
            }
            let all = count + more;
            // Each group's middle counts as often as it has members.
            let middle = (before * count as f64 + after * more as f64) / all as f64;
            groups.truncate(groups.len() - 2);
            groups.push((middle, all));
        }
    }
    groups
        .into_iter()
        .flat_map(|(middle, count)| {
            (0..count).map(move |at| middle + gap * (at as f64 - 0.5 * (count - 1) as f64))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_apart_and_near_their_places() {
        assert_eq!(spread(&[0.0, 50.0], 10.0), [0.0, 50.0]);
        assert_eq!(spread(&[0.0, 0.0, 0.0], 10.0), [-10.0, 0.0, 10.0]);
        let places = spread(&[0.0, 4.0, 5.0, 30.0], 10.0);
        assert!(places.windows(2).all(|pair| pair[1] - pair[0] >= 10.0 - 1e-9), "{places:?}");
    }
}
