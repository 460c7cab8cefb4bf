//! Half sections as SVG: under the path of a lathe, and in drawings.

use chordal::geometry::{Aabb, Vec2, Vec3};
use chordal::stock::TurnedReport;
use chordal::stock::section::{OutlineSegment, Region};

use super::palette::Palette;
use super::text::{push_px, px};
use super::view::ViewPanel;

/// What is left, what was there, and where threads are whose grooves are not known.
#[derive(Debug, Default)]
pub(super) struct TurnedStockPlot {
    before: Vec<Vec<OutlineSegment>>,
    left: Vec<Vec<OutlineSegment>>,
    threads: Vec<Vec<OutlineSegment>>,
    bounds: Option<(Vec2, Vec2)>,
}

impl TurnedStockPlot {
    pub fn of(found: &TurnedReport) -> TurnedStockPlot {
        TurnedStockPlot {
            before: found.before.shape(),
            left: found.threaded_sections().iter().flat_map(Region::shape).collect(),
            threads: found
                .threads
                .iter()
                .filter(|thread| thread.grooves.is_none())
                .flat_map(|thread| thread.section.shape())
                .collect(),
            bounds: found.before.bounds(),
        }
    }

    /// A box and the stock in it, without what is behind the cuts: a long bar stays outside.
    pub fn around(&self, cuts: Aabb) -> Aabb {
        let Some((low, high)) = self.bounds else { return cuts };
        let size = cuts.size();
        let beyond = 0.25 * size.z.max(size.x).max(1.0);
        let from = low.a.max(cuts.min.z - beyond);
        let stock = Aabb {
            min: Vec3::new(0.0, cuts.min.y, from),
            max: Vec3::new(high.b, cuts.max.y, high.a),
        };
        cuts.union(stock)
    }

    /// The half section in a view, X up.
    pub fn svg(&self, panel: &ViewPanel, unit: f64, colors: &Palette) -> String {
        let place = |p: Vec2| panel.place(Vec3::new(p.b, 0.0, p.a));
        let mut out = String::new();
        let mut path = |loops: &[Vec<OutlineSegment>], style: &str| {
            if !loops.is_empty() {
                let data = path_data(loops, panel.scale, place, false);
                out.push_str(&format!("<path d=\"{data}\" {style}/>\n"));
            }
        };
        let (thin, wide) = (px(0.9 * unit), px(1.6 * unit));
        let dash = format!("{} {}", px(5.0 * unit), px(4.0 * unit));
        path(
            &self.left,
            &format!(
                "fill=\"{}\" fill-opacity=\"0.16\" fill-rule=\"evenodd\" stroke=\"{}\" stroke-width=\"{wide}\" stroke-linejoin=\"round\"",
                colors.faint, colors.text
            ),
        );
        path(
            &self.before,
            &format!(
                "stroke=\"{}\" stroke-width=\"{thin}\" stroke-dasharray=\"{dash}\"",
                colors.faint
            ),
        );
        path(&self.threads, &format!("stroke=\"{}\" stroke-width=\"{thin}\"", colors.faint));
        let axis = panel.down(0.0);
        if axis >= panel.rect.y && axis <= panel.rect.bottom() {
            out.push_str(&format!(
                "<path d=\"M{} {}H{}\" stroke=\"{}\" stroke-width=\"{thin}\" stroke-dasharray=\"{} {} {} {}\"/>\n",
                px(panel.rect.x),
                px(axis),
                px(panel.rect.right()),
                colors.faint,
                px(16.0 * unit),
                px(4.0 * unit),
                px(3.0 * unit),
                px(4.0 * unit)
            ));
        }
        out
    }
}

/// Loops as the data of a path; `scale` is px for each mm. Mirrored at the axis the senses of arcs turn round.
pub(super) fn path_data(
    loops: &[Vec<OutlineSegment>],
    scale: f64,
    place: impl Fn(Vec2) -> (f64, f64),
    mirrored: bool,
) -> String {
    let mut data = String::new();
    for outline in loops {
        let Some(first) = outline.first() else { continue };
        point(&mut data, 'M', place(first.start));
        for segment in outline {
            segment_data(&mut data, segment, scale, &place, mirrored);
        }
        data.push('Z');
    }
    data
}

fn point(data: &mut String, letter: char, at: (f64, f64)) {
    data.push(letter);
    push_px(data, at.0);
    data.push(' ');
    push_px(data, at.1);
}

/// A segment after the point where it begins.
pub(super) fn segment_data(
    data: &mut String,
    segment: &OutlineSegment,
    scale: f64,
    place: &impl Fn(Vec2) -> (f64, f64),
    mirrored: bool,
) {
    let Some(bend) = segment.bend else { return point(data, 'L', place(segment.end)) };
    // Counter-clockwise with X up is so on a sheet whose y goes down, too: flag 0.
    let flag = u8::from(bend.counterclockwise == mirrored);
    let radius = px(bend.radius * scale);
    let sweep = segment.sweep();
    // Two halves, so that no arc is a whole circle.
    let (sine, cosine) = (0.5 * sweep).sin_cos();
    let to = segment.start - bend.center;
    let middle = bend.center + to * cosine + to.turned_left() * sine;
    for end in [middle, segment.end] {
        data.push_str(&format!("A{radius} {radius} 0 0 {flag} "));
        let (x, y) = place(end);
        push_px(data, x);
        data.push(' ');
        push_px(data, y);
    }
}
