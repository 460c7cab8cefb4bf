//! The engagement of a cutter along a move: width and depth of cut, chip thickness, removed volume.
//!
//! A point of the cutter's surface with the outward normal n takes a chip of thickness f·(u·n) where it is in
//! material, with u the direction of the feed and f the feed per tooth. All results here are for f = 1, and the
//! caller multiplies by the feed: [`EngagementSlice::chip`] is u·n.
//!
//! The surface is divided into patches ([`patches`]), the move into slices. On a slice a patch passes over some
//! cells: the material that may be on any of them gives the upper bound of the engagement, the material that is
//! certainly on all of them the lower bound. So no point between two samples is missed. The stock is that before a
//! piece of the move: on a line a convex cutter does not come back to where it was, and on a curve only where the
//! chip is thinner than the turn of the piece, which does not count for the lower bound.

mod patches;
mod slice;

use chordal_geometry::{Curve, Line, ParamCurve, Vec3};

use crate::columns::HeightWindow;
use crate::sweep::TipMove;
use crate::{ColumnStock, CutterProfile, VolumeInterval};

pub use slice::{BoundedValue, EngagementSlice, engagement_angle};

use patches::CutterPatches;
use slice::CutterPose;

/// Largest turn of a piece of a curve, rad; for the next piece the stock is read again.
const TURN: f64 = 0.2;

/// Least length of a piece, in cells: each piece reads all cells around the cutter.
const MIN_PIECE_CELLS: f64 = 4.0;

/// Largest length of a piece of a line, in diameters of the cutter, so that few cells are near it.
const DIAMETERS: f64 = 2.0;

/// Least depth below which contacts are ignored, mm: heights of cells are rounded to a hundredth of it.
const MIN_GRAZE_MM: f64 = 1e-3;

/// Directions whose Z components differ by less than this are equally steep: rounding.
const LEVEL: f64 = 1e-9;

/// The options of a measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasureOptions {
    /// Length of a slice, mm; about the side of a cell is fine enough.
    pub spacing: f64,
    /// Contacts no deeper than this are ignored, mm. On curves it is at least the deviation of chords, since the
    /// floors of columns are not known better.
    pub graze: f64,
}

/// What a move has removed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RemovedVolume {
    /// Its bounds, mm³. The uncertainty of a cell counts for every move that changes the cell.
    pub bounds: VolumeInterval,
    /// By the middle between the bounds of each cell, mm³; the sum over all moves is what they remove together.
    pub middle: f64,
}

/// A cutter whose engagement is measured.
#[derive(Clone, Debug)]
pub struct EngagementMeter {
    cutter: CutterProfile,
    patches: CutterPatches,
    measuring: MeasureOptions,
}

impl EngagementMeter {
    /// A cutter for stock with this resolution, mm.
    pub fn new(
        cutter: CutterProfile,
        resolution: f64,
        measuring: MeasureOptions,
    ) -> EngagementMeter {
        let graze = measuring.graze.max(MIN_GRAZE_MM);
        let spacing = if measuring.spacing > 0.0 { measuring.spacing } else { resolution };
        EngagementMeter {
            patches: CutterPatches::new(&cutter, resolution),
            measuring: MeasureOptions { spacing, graze },
            cutter,
        }
    }
}

impl ColumnStock {
    /// Removes what a cutter sweeps on a move, and calls `see` for every slice on which the cutter may be in
    /// material.
    pub fn cut_measuring(
        &mut self,
        meter: &EngagementMeter,
        path: &TipMove,
        see: &mut dyn FnMut(&EngagementSlice),
    ) -> RemovedVolume {
        let mut removed = RemovedVolume::default();
        let length = path.curve.length();
        if !length.is_finite() || !path.curve.start().is_finite() || !path.curve.end().is_finite() {
            return removed;
        }
        let bend = path.curve.max_curvature();
        let radius = meter.cutter.radius();
        let longest = (DIAMETERS * 2.0 * radius).min(TURN / bend.max(f64::MIN_POSITIVE));
        let longest = longest.max(MIN_PIECE_CELLS * self.grid().resolution());
        let count = (length / longest).ceil().clamp(1.0, MAX_PIECES) as u64;
        let ends = |k: u64| [k, k + 1].map(|k| length * k as f64 / count as f64);
        let piece = |k: u64| {
            let [from, to] = ends(k);
            if count == 1 { path.curve } else { path.curve.subsegment(from, to) }
        };
        let margin = radius + self.grid().resolution();
        if let Curve::Line(line) = &path.curve {
            // A line does not come back to what it has cut, so all of it is measured before the cut.
            let windows: Vec<HeightWindow> = (0..count)
                .map(|k| {
                    let piece = piece(k);
                    let window = self.window_around(&piece, margin);
                    measure(meter, &window, &piece, ends(k)[0], [0.0, meter.measuring.graze], see);
                    window
                })
                .collect();
            self.cut(&meter.cutter, core::slice::from_ref(path));
            let shares = LineShares::new(line, count);
            for (k, before) in (0..count).zip(&windows) {
                let after = self.window_around(&piece(k), margin);
                removed.add(before.removed(&after, |place| shares.of(place) == k));
            }
            return removed;
        }
        // Floors of curves are known only up to the deviation of chords.
        let off = self.options().chord_share * self.grid().resolution();
        let graze = meter.measuring.graze.max(off + MIN_GRAZE_MM);
        for k in 0..count {
            let piece = piece(k);
            let before = self.window_around(&piece, margin);
            measure(meter, &before, &piece, ends(k)[0], [bend, graze], see);
            self.cut(&meter.cutter, &[TipMove { curve: piece, tag: path.tag }]);
            removed.add(before.removed(&self.window_around(&piece, margin), |_| true));
        }
        removed
    }

    /// The cells around a curve, with a margin, mm.
    fn window_around(&self, curve: &Curve, margin: f64) -> HeightWindow {
        let bounds = curve.bounds();
        self.window(
            [bounds.min.x - margin, bounds.min.y - margin],
            [bounds.max.x + margin, bounds.max.y + margin],
        )
    }
}

impl RemovedVolume {
    fn add(&mut self, (bounds, middle): (VolumeInterval, f64)) {
        self.bounds = self.bounds.plus(bounds);
        self.middle += middle;
    }
}

/// Assigns positions to the pieces of a line, so that no cell counts twice.
struct LineShares {
    start: Vec3,
    /// Direction of the line in plan, in pieces per mm.
    along: [f64; 2],
    count: u64,
}

impl LineShares {
    fn new(line: &Line, count: u64) -> LineShares {
        let course = line.end - line.start;
        let square = course.x * course.x + course.y * course.y;
        let scale = if square > 0.0 { count as f64 / square } else { 0.0 };
        LineShares { start: line.start, along: [course.x * scale, course.y * scale], count }
    }

    fn of(&self, place: [f64; 2]) -> u64 {
        let (x, y) = (place[0] - self.start.x, place[1] - self.start.y);
        let share = x * self.along[0] + y * self.along[1];
        share.clamp(0.0, (self.count - 1) as f64) as u64
    }
}

/// Most pieces of one move, so that a curve far larger than any machine takes little time.
const MAX_PIECES: f64 = 1e6;

/// Measures the slices of a piece that begins at `begin` mm along its move. `bend` is its largest curvature, 1/mm;
/// contacts no deeper than `graze` mm are ignored.
fn measure(
    meter: &EngagementMeter,
    window: &HeightWindow,
    piece: &Curve,
    begin: f64,
    [bend, graze]: [f64; 2],
    see: &mut dyn FnMut(&EngagementSlice),
) {
    if window.highest() <= piece.bounds().min.z + meter.measuring.graze {
        return;
    }
    let length = piece.length();
    let count = (length / meter.measuring.spacing).ceil().clamp(1.0, MAX_PIECES);
    let half = 0.5 * length / count;
    let convex = meter.cutter.is_convex();
    for k in 0..count as u64 {
        let at = half * (2 * k + 1) as f64;
        let direction = direction(piece, at);
        let rises = [at - half, at, at + half].map(|at| self::direction(piece, at).z);
        let tilts = (rises[0] - rises[1]).abs().max((rises[2] - rises[1]).abs()) > LEVEL;
        let place = CutterPose {
            tip: piece.point_at(at),
            direction,
            half,
            turn: bend * half,
            tilt: if tilts { bend * half } else { 0.0 },
            // The piece itself may have removed the material before.
            taken: if convex { bend * length } else { f64::INFINITY },
            sag: 0.5 * bend * half * half,
            graze,
            fine: meter.measuring.graze,
        };
        if window.highest() <= place.lowest() + place.fine {
            continue;
        }
        if let Some(slice) = slice::look(&meter.patches, window, &place, begin + at) {
            see(&slice);
        }
    }
}

/// The direction of the feed; −Z where there is none.
fn direction(piece: &Curve, at: f64) -> Vec3 {
    let along = piece.tangent_at(at);
    let length = along.length();
    if length > 0.0 && length.is_finite() { along * (1.0 / length) } else { -Vec3::Z }
}
