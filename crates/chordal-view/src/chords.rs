//! The chords that replace arcs within a tolerance, as computed by the library.

use chordal::Job;
use chordal::geometry::{Arc, ChordError, Curve, ParamCurve, Placement, Vec3};
use serde_json::{Value, json};

use crate::frame::ColumnFrame;
use crate::request::ChordRequest;

/// The most chords that are sent.
const MAX_CHORDS: u64 = 1_000_000;

/// Divides every arc of a job into chords within a tolerance.
///
/// # Errors The tolerance is not above zero.
pub fn chords(job: &Job, request: &ChordRequest) -> Result<Vec<u8>, ChordError> {
    let placement = if request.balanced { Placement::Balanced } else { Placement::Inscribed };
    let own = job.own_chords().filter(|_| request.as_control);
    let (tolerance_mm, placement) = own.unwrap_or((request.tolerance_mm, placement));
    let is_positive = tolerance_mm > 0.0;
    if !is_positive {
        return Err(ChordError::Tolerance(tolerance_mm));
    }
    let mut gathered = ChordCollector::default();
    job.path(|segment| {
        if !matches!(segment.curve, Curve::Line(_)) && segment.is_drawn() {
            // A curve that cannot be divided does not prevent the others from being shown.
            if gathered.curve(&segment.curve, tolerance_mm, placement).is_err() {
                gathered.left_out += 1;
            }
        }
    });
    Ok(gathered.frame(tolerance_mm))
}

#[derive(Default)]
struct ChordCollector {
    origin: Option<Vec3>,
    points: Vec<f32>,
    curves: u64,
    chords: u64,
    left_out: u64,
    /// The largest distance between a chord and its arc, mm.
    error_mm: f64,
    /// The number of curves that are not arcs: their chords are within the tolerance, but the exact distance is
    /// unknown.
    inexact_curves: u64,
}

impl ChordCollector {
    fn curve(
        &mut self,
        curve: &Curve,
        tolerance: f64,
        placement: Placement,
    ) -> Result<(), ChordError> {
        let corners = curve.chords(tolerance, placement)?;
        let count = corners.chord_count();
        self.curves += 1;
        self.chords += count;
        if self.points.len() as u64 / 6 + count > MAX_CHORDS {
            self.left_out += count;
            return Ok(());
        }
        let origin = *self.origin.get_or_insert(curve.start());
        match curve {
            Curve::Arc(arc) => self.error_mm = self.error_mm.max(error_of(arc, corners.clone())),
            _ => self.inexact_curves += 1,
        }
        let mut before: Option<[f32; 3]> = None;
        for corner in corners {
            let d = corner - origin;
            let at = [d.x as f32, d.y as f32, d.z as f32];
            if let Some(before) = before.replace(at) {
                self.points.extend(before);
                self.points.extend(at);
            }
        }
        Ok(())
    }

    fn frame(self, tolerance_mm: f64) -> Vec<u8> {
        let origin = self.origin.unwrap_or(Vec3::ZERO);
        let mut frame = ColumnFrame::default();
        frame.column("points", &self.points);
        let header: Value = json!({
            "type": "chords",
            "tolerance_mm": tolerance_mm,
            "curves": self.curves,
            "chords": self.chords,
            "left_out": self.left_out,
            "error_mm": (self.inexact_curves == 0 && self.curves > 0).then_some(self.error_mm),
            "origin": crate::answer::point(origin),
        });
        frame.finish(header)
    }
}

/// The largest distance from an arc's circle of the end points and the midpoints of its chords, mm.
fn error_of(arc: &Arc, corners: impl Iterator<Item = Vec3>) -> f64 {
    let distance = |at: Vec3| {
        let arm = at - arc.center;
        let along = arc.w * arm.dot(arc.w);
        ((arm - along).length() - arc.radius).abs()
    };
    let mut before: Option<Vec3> = None;
    let mut most = 0.0_f64;
    for corner in corners {
        most = most.max(distance(corner));
        if let Some(before) = before.replace(corner) {
            most = most.max(distance((before + corner) * 0.5));
        }
    }
    most
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_of_a_quarter_in_two_chords_is_that_of_their_middles() {
        let arc = Arc::through(
            Vec3::new(10.0, 0.0, 0.0),
            Vec3::new(7.071_067_811_865_476, 7.071_067_811_865_476, 0.0),
            Vec3::new(0.0, 10.0, 0.0),
        )
        .expect("three points of a circle");
        let corners = [arc.start, arc.point_at(arc.length() / 2.0), arc.end];
        // r − r·cos(45°/2) = 0.761 mm
        let error = error_of(&arc, corners.into_iter());
        assert!((error - 0.761_204_67).abs() < 1e-6, "{error}");
    }

    #[test]
    fn balanced_chords_leave_the_circle_by_the_tolerance_on_both_sides() {
        let (start, end) = (Vec3::new(10.0, 0.0, 0.0), Vec3::new(0.0, 10.0, 0.0));
        let via = Vec3::new(7.071_067_811_865_476, 7.071_067_811_865_476, 0.0);
        let arc = Arc::through(start, via, end).expect("three points of a circle");
        for placement in [Placement::Inscribed, Placement::Balanced] {
            let corners = Curve::Arc(arc).chords(0.01, placement).expect("chords");
            let error = error_of(&arc, corners);
            assert!(error > 0.005 && error <= 0.01 + 1e-9, "{placement:?}: {error}");
        }
    }
}
