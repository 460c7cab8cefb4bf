//! The chords that stand for arcs within a tolerance, as the library cuts them.

use chordal::Job;
use chordal::geometry::{ChordError, Curve, ParamCurve, Placement, Vec3};
use serde_json::{Value, json};

use crate::frame::Frame;

/// Chords that are sent at most.
const MOST: u64 = 1_000_000;

/// Cuts every arc of a job into chords within a tolerance, mm.
///
/// # Errors
/// A tolerance that is not above zero.
pub fn chords(job: &Job, tolerance_mm: f64, balanced: bool) -> Result<Vec<u8>, ChordError> {
    let placement = if balanced { Placement::Balanced } else { Placement::Inscribed };
    let is_positive = tolerance_mm > 0.0;
    if !is_positive {
        return Err(ChordError::Tolerance(tolerance_mm));
    }
    let mut gathered = Gathered::default();
    job.path(|segment| {
        if !matches!(segment.curve, Curve::Line(_)) && segment.known {
            // One curve that cannot be cut says nothing of the others.
            if gathered.curve(&segment.curve, tolerance_mm, placement).is_err() {
                gathered.left_out += 1;
            }
        }
    });
    Ok(gathered.frame(tolerance_mm))
}

#[derive(Default)]
struct Gathered {
    origin: Option<Vec3>,
    points: Vec<f32>,
    curves: u64,
    chords: u64,
    left_out: u64,
}

impl Gathered {
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
        if self.points.len() as u64 / 6 + count > MOST {
            self.left_out += count;
            return Ok(());
        }
        let origin = *self.origin.get_or_insert(curve.start());
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
        let mut frame = Frame::default();
        frame.column("points", &self.points);
        let header: Value = json!({
            "type": "chords",
            "tolerance_mm": tolerance_mm,
            "curves": self.curves,
            "chords": self.chords,
            "left_out": self.left_out,
            "origin": crate::answer::point(origin),
        });
        frame.finish(header)
    }
}
