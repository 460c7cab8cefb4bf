//! Draws the pieces of a path into SVG path data, no finer than the sheet shows.

use std::collections::HashSet;
use std::f64::consts::{PI, TAU};

use chordal::geometry::{Arc, Curve, ParamCurve, Placement, Vec3};

use super::store::{PathStore, StoredPiece};
use super::text::push_px;
use super::view::{PixelRect, ViewPanel};

type PenPoint = (f64, f64);

/// Lines shorter than this are left out, px: a printer shows no more.
const FINEST_PX: f64 = 0.35;
/// How far chords leave a curve, px.
const CHORD_PX: f64 = 0.08;
/// Larger circles are drawn as chords: viewers compute with 32 bits.
const MAX_RADIUS_PX: f64 = 4_000.0;
/// Chords of one curve beyond which they are made longer.
const MAX_CHORDS: u64 = 20_000;
/// The longest turn of one SVG arc.
const MAX_TURN: f64 = 0.75 * PI;
/// Radius of a cut seen end on, units.
const DOT_PX: f64 = 2.6;
/// The coarsest a view is drawn, px.
const COARSEST_PX: f64 = 8.0;

/// The paths of a view.
#[derive(Debug)]
pub(super) struct ViewPaths {
    pub rapids: String,
    /// By the index of the tool.
    pub tools: Vec<String>,
}

impl ViewPaths {
    /// Draws a path as finely as the sheet shows it, or coarser when that takes more than so
    /// many bytes.
    pub fn of(store: &PathStore, panel: &ViewPanel, unit: f64, most_bytes: usize) -> ViewPaths {
        let mut resolution = FINEST_PX * unit.max(1.0);
        loop {
            let paths = ViewPaths::at(store, panel, unit, resolution);
            let bytes = paths.rapids.len() + paths.tools.iter().map(String::len).sum::<usize>();
            if bytes <= most_bytes || resolution >= COARSEST_PX {
                return paths;
            }
            resolution *= 2.0;
        }
    }

    fn at(store: &PathStore, panel: &ViewPanel, unit: f64, resolution: f64) -> ViewPaths {
        let mut rapids = PanelPen::new(panel, unit, resolution);
        let groups = store.groups();
        let mut tools: Vec<PanelPen> =
            groups.list.iter().map(|_| PanelPen::new(panel, unit, resolution)).collect();
        for (run, pieces) in store.runs() {
            let pen = match run.tool {
                Some(index) => &mut tools[groups.of_tool[index]],
                None => &mut rapids,
            };
            pen.begin(run.start);
            for piece in pieces {
                match piece {
                    StoredPiece::To(point) => pen.line_to(panel.place(*point)),
                    StoredPiece::Curve(number) => pen.curve(store.curve(*number)),
                }
            }
            pen.end(run.tool.is_some());
        }
        ViewPaths { rapids: rapids.data, tools: tools.into_iter().map(|pen| pen.data).collect() }
    }
}

struct PanelPen<'p> {
    panel: &'p ViewPanel,
    clip: PixelRect,
    /// px for each unit of the sheet.
    unit: f64,
    resolution: f64,
    data: String,
    /// Where the path data ends, if a line may go on from there.
    at: Option<PenPoint>,
    /// How far of the path is drawn.
    drawn: PenPoint,
    /// Where the path is.
    here: PenPoint,
    /// Nothing of this run was drawn yet.
    empty: bool,
    /// What was drawn already, in steps of the resolution: a contour milled at ten depths is
    /// one line from above.
    seen: HashSet<[u16; 6]>,
}

impl<'p> PanelPen<'p> {
    fn new(panel: &'p ViewPanel, unit: f64, resolution: f64) -> PanelPen<'p> {
        let reach = 4.0;
        let rect = panel.rect;
        let clip = PixelRect {
            x: rect.x - reach,
            y: rect.y - reach,
            width: rect.width + 2.0 * reach,
            height: rect.height + 2.0 * reach,
        };
        PanelPen {
            panel,
            clip,
            unit,
            resolution,
            data: String::new(),
            at: None,
            drawn: (0.0, 0.0),
            here: (0.0, 0.0),
            empty: true,
            seen: HashSet::new(),
        }
    }

    fn begin(&mut self, start: Vec3) {
        self.drawn = self.panel.place(start);
        self.here = self.drawn;
        self.empty = true;
    }

    fn line_to(&mut self, to: PenPoint) {
        self.here = to;
        if distance(self.drawn, to) >= self.resolution {
            self.flush();
        }
    }

    /// Draws what was left out so far.
    fn flush(&mut self) {
        if self.here != self.drawn {
            self.line(self.drawn, self.here);
            self.drawn = self.here;
        }
    }

    fn line(&mut self, from: PenPoint, to: PenPoint) {
        self.empty = false;
        let Some((from, to)) = self.clip.clip(from, to) else { return };
        if !self.is_new(from, to, (0.0, 0.0)) {
            return;
        }
        self.start_at(from);
        self.data.push('L');
        self.point(to);
        self.at = Some(to);
    }

    fn start_at(&mut self, from: PenPoint) {
        if self.at != Some(from) {
            self.data.push('M');
            self.point(from);
        }
    }

    fn point(&mut self, (x, y): PenPoint) {
        push_px(&mut self.data, x);
        if y >= 0.0 {
            self.data.push(' ');
        }
        push_px(&mut self.data, y);
    }

    /// A small circle.
    fn dot(&mut self, (x, y): PenPoint) {
        let radius = DOT_PX * self.unit;
        self.data.push('M');
        self.point((x - radius, y));
        for course in [2.0 * radius, -2.0 * radius] {
            self.data.push('a');
            self.point((radius, radius));
            self.data.push_str(" 0 0 0 ");
            self.point((course, 0.0));
        }
        self.at = None;
    }

    /// A cut that goes straight towards the eye is a dot: a drilled hole seen from above.
    fn end(&mut self, cuts: bool) {
        if distance(self.drawn, self.here) > 0.05 {
            self.flush();
        }
        let here = self.here;
        if self.empty && cuts && self.clip.holds(here, 0.0) && self.is_new(here, here, here) {
            self.dot(here);
        }
    }

    /// True the first time something between these points is drawn.
    fn is_new(&mut self, a: PenPoint, b: PenPoint, via: PenPoint) -> bool {
        let step = self.resolution.max(0.5);
        let (x, y) = (self.clip.x, self.clip.y);
        let cell = |p: PenPoint| [((p.0 - x) / step) as u16, ((p.1 - y) / step) as u16];
        let (mut a, mut b, via) = (cell(a), cell(b), cell(via));
        if a > b {
            std::mem::swap(&mut a, &mut b);
        }
        self.seen.insert([a[0], a[1], b[0], b[1], via[0], via[1]])
    }

    fn curve(&mut self, curve: &Curve) {
        match curve {
            Curve::Line(line) => self.line_to(self.panel.place(line.end)),
            Curve::Arc(arc) if self.is_circle(arc) => self.circle(arc),
            other => self.chords(other),
        }
    }

    /// True when the arc is seen along its axis, and is of a size that viewers draw well.
    fn is_circle(&self, arc: &Arc) -> bool {
        let radius = arc.radius * self.panel.scale;
        let flat = arc.w.cross(self.panel.view.eye()).length() < 1e-9;
        flat && radius > 2.0 * self.resolution && radius < MAX_RADIUS_PX
    }

    fn circle(&mut self, arc: &Arc) {
        self.flush();
        let end = self.panel.place(arc.end);
        // Further turns of a helix lie on the first.
        let turn = arc.sweep.abs().min(TAU);
        let parts = (turn / MAX_TURN).ceil().max(1.0);
        let ccw = (arc.sweep > 0.0) == (arc.w.dot(self.panel.view.eye()) > 0.0);
        let v = arc.w.cross(arc.u);
        let on_circle = |share: f64| {
            let angle = share * turn.copysign(arc.sweep);
            self.panel.place(arc.center + (arc.u * angle.cos() + v * angle.sin()) * arc.radius)
        };
        let whole = turn < arc.sweep.abs();
        let corners: Vec<(PenPoint, PenPoint)> = (0..parts as usize)
            .map(|part| {
                let middle = on_circle((part as f64 + 0.5) / parts);
                let last = part + 1 == parts as usize && !whole;
                (middle, if last { end } else { on_circle((part as f64 + 1.0) / parts) })
            })
            .collect();
        let radius = arc.radius * self.panel.scale;
        let mut from = self.here;
        for (middle, to) in corners {
            self.arc(from, to, middle, radius, ccw);
            from = to;
        }
        self.here = end;
        self.drawn = end;
    }

    fn arc(&mut self, from: PenPoint, to: PenPoint, middle: PenPoint, radius: f64, ccw: bool) {
        self.empty = false;
        let reach = 2.0 * MAX_RADIUS_PX;
        if !(self.clip.holds(from, reach) && self.clip.holds(to, reach)) {
            return;
        }
        if !self.is_new(from, to, middle) {
            return;
        }
        self.start_at(from);
        self.data.push('A');
        self.point((radius, radius));
        // The sheet's y goes down: counter-clockwise is what SVG calls negative.
        self.data.push_str(if ccw { " 0 0 0 " } else { " 0 0 1 " });
        self.point(to);
        self.at = Some(to);
    }

    fn chords(&mut self, curve: &Curve) {
        let mut tolerance = CHORD_PX.max(0.5 * self.resolution - 0.1) / self.panel.scale;
        let mut chords = curve.chords(tolerance, Placement::Inscribed);
        while chords.as_ref().is_ok_and(|chords| chords.chord_count() > MAX_CHORDS) {
            tolerance *= 4.0;
            chords = curve.chords(tolerance, Placement::Inscribed);
        }
        match chords {
            Ok(chords) => chords.skip(1).for_each(|corner| self.line_to(self.panel.place(corner))),
            Err(_) => self.line_to(self.panel.place(curve.end())),
        }
    }
}

fn distance(a: PenPoint, b: PenPoint) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}
