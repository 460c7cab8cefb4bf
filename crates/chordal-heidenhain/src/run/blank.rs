//! The blank of BLK FORM, and rapids that go into it where nothing has been cut.

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_kernel::ModalMotion;

use super::blank_record::CutLine;
use super::block_values::BlockValues;
use super::interpreter::KlartextInterpreter;
use crate::geometry::ContourElement;
use crate::syntax::PathWords;

/// Points that are looked at on a rapid.
const POINTS_OF_RAPID: usize = 33;

/// Chords of an arc.
const CHORDS_OF_ARC: usize = 24;

/// A cut that ends so many times the height of the blank below it is a mistake.
const BLANK_HEIGHTS: f64 = 3.0;

/// The same for a flat blank, mm.
const MIN_DEPTH_BELOW_MM: f64 = 80.0;

/// The radius of a tool whose radius is not given, so that no rapid is reported for what is not known, mm.
const UNKNOWN_RADIUS_MM: f64 = 30.0;

fn linear(place: &Position) -> [f64; 3] {
    [place[0], place[1], place[2]]
}

impl KlartextInterpreter<'_> {
    /// BLK FORM 0.1 and 0.2: the corners of the blank.
    pub(super) fn blank(&mut self, corner: Option<u8>, words: &PathWords) {
        let range = self.here;
        let Some(corner) = corner else { return };
        let Some(values) = self.values(words) else { return };
        if corner == 1 {
            let least = [0, 1, 2].map(|axis| values.axes[axis].map(|value| value.value));
            self.modes.blank = Some(least);
            return;
        }
        let Some(least) = self.modes.blank else {
            let message = "the blank has a largest point and no smallest: BLK FORM 0.1 is missing";
            return self.problem(Code::MissingWord, range, message);
        };
        self.largest_corner(least, &values);
    }

    fn largest_corner(&mut self, least: [Option<f64>; 3], values: &BlockValues) {
        let range = self.here;
        let mut corners = [[0.0; 3]; 2];
        let mut is_complete = true;
        for (axis, letter) in ["X", "Y", "Z"].iter().enumerate() {
            let (Some(least), Some(largest)) = (least[axis], values.axes[axis]) else {
                is_complete = false;
                continue;
            };
            let largest = largest.from(least);
            (corners[0][axis], corners[1][axis]) = (least, largest);
            if largest <= least {
                is_complete = false;
                let [one, other] = [least, largest].map(|mm| self.kernel.length_text(mm));
                let message = format!(
                    "the largest point of the blank is not above the smallest: {letter} goes from {one} to {other}"
                );
                let diagnostic = Diagnostic::new(Code::BadWordValue, self.span(range), message);
                let help = "BLK FORM 0.1 has the smallest coordinates, 0.2 the largest";
                self.kernel.report(diagnostic.severity(Severity::Error).help(help));
            }
        }
        // In shifted or turned coordinates the blank is not followed.
        let is_plain = self.modes.chain == Default::default() && !self.kernel.has_tilted_plane();
        self.modes.blank_record.corners = (is_complete && is_plain).then_some(corners);
    }

    /// After a move that began at a known position of the preset: a cut is remembered, a rapid is checked.
    pub(super) fn follow_blank(&mut self, from: &Position, element: &ContourElement) {
        let state = &self.kernel.state;
        let is_known = state.part_frame.is_none() && state.known.covers(AxisMask::LINEAR);
        if !self.modes.blank_record.is_checked() || !is_known {
            return;
        }
        let (from, to) = (linear(from), linear(&state.position));
        let tool_axis = self.tool_axis();
        if state.motion != ModalMotion::Rapid {
            self.check_depth(to[tool_axis], tool_axis);
            return self.remember_cut(from, to, element);
        }
        // Across, and out, the rapids of a cycle go where it has cut.
        if self.kernel.origin.cycle && to[tool_axis] >= from[tool_axis] {
            return;
        }
        let record = &self.modes.blank_record;
        let hit = (0..POINTS_OF_RAPID).map(|index| {
            let part = index as f64 / (POINTS_OF_RAPID - 1) as f64;
            [0, 1, 2].map(|axis| from[axis] + (to[axis] - from[axis]) * part)
        });
        let mut hits = hit.filter(|point| record.contains(*point));
        let Some(point) = hits.find(|point| !record.was_cut(*point, tool_axis)) else { return };
        self.modes.blank_record.is_reported = true;
        let place = point.map(|mm| self.kernel.length_text(mm));
        let message = format!(
            "this rapid goes into the blank where nothing has been cut: near X {}, Y {}, Z {}",
            place[0], place[1], place[2]
        );
        let diagnostic = Diagnostic::new(Code::RapidIntoPart, self.span(self.here), message)
            .label("inside BLK FORM")
            .help("go down with a feed F, or correct the position or BLK FORM");
        self.kernel.report(diagnostic);
    }

    /// Reports a cut that goes so far through the blank that its depth, or the blank, must be wrong.
    fn check_depth(&mut self, level: f64, tool_axis: usize) {
        let record = &mut self.modes.blank_record;
        let Some([least, largest]) = record.corners.filter(|_| !record.is_depth_reported) else {
            return;
        };
        let (bottom, height) = (least[tool_axis], largest[tool_axis] - least[tool_axis]);
        let below = bottom - level;
        if below <= (BLANK_HEIGHTS * height).max(MIN_DEPTH_BELOW_MM) {
            return;
        }
        record.is_depth_reported = true;
        let [below, height] = [below, height].map(|mm| self.kernel.length_text(mm));
        let message = format!("this cut ends {below} below the blank, which is {height} high");
        let diagnostic = Diagnostic::new(Code::StockCommentDoubted, self.span(self.here), message);
        self.kernel.report(diagnostic.help("check the depth and BLK FORM"));
    }

    fn remember_cut(&mut self, from: [f64; 3], to: [f64; 3], element: &ContourElement) {
        let tool = self.kernel.state.tool;
        let radius = self.kernel.state.offsets.radius_mm(tool).unwrap_or(UNKNOWN_RADIUS_MM);
        let cuts = &mut self.modes.blank_record.cuts;
        let ContourElement::Arc { plane, center, sweep_rad, .. } = element else {
            cuts.push(CutLine { from, to, radius });
            return;
        };
        if self.modes.chain != Default::default() {
            cuts.push(CutLine { from, to, radius });
            return;
        }
        let (a, b, normal) = plane.axes();
        let mut last = from;
        for index in 1..=CHORDS_OF_ARC {
            let part = index as f64 / CHORDS_OF_ARC as f64;
            let turned =
                crate::geometry::turned_about([from[a], from[b]], *center, sweep_rad * part);
            let mut next = from;
            (next[a], next[b]) = (turned[0], turned[1]);
            next[normal] = from[normal] + (to[normal] - from[normal]) * part;
            cuts.push(CutLine { from: last, to: next, radius });
            last = next;
        }
    }
}
