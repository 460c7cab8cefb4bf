//! Parallels of lines and arcs.

use crate::{Arc, Line, ParamCurve, Vec3};

impl Line {
    /// The parallel `distance` mm to the left of travel, seen against `normal` (any length);
    /// to the right when negative. A line that is not square to `normal` is moved as its projection
    /// is. `None` when that projection has no direction.
    #[must_use]
    pub fn offset(&self, normal: Vec3, distance: f64) -> Option<Line> {
        let left = normal.normalized()?.cross(self.tangent_at(0.0)).normalized()?;
        Some(Line { start: self.start + left * distance, end: self.end + left * distance })
    }
}

impl Arc {
    /// The parallel `distance` mm to the left of travel, seen against `self.w`; to the right when
    /// negative. `None` when the radius would not stay above zero. A helix stays one, with the same
    /// rise.
    #[must_use]
    pub fn offset(&self, distance: f64) -> Option<Arc> {
        // Left is towards the centre when turning counter-clockwise.
        let outward = if self.sweep < 0.0 { distance } else { -distance };
        let radius = self.radius + outward;
        if radius.is_nan() || radius <= 0.0 {
            return None;
        }
        let (to_end, _) = self.winding().radial(1.0);
        Some(Arc {
            radius,
            start: self.start + self.u * outward,
            end: self.end + to_end * outward,
            ..*self
        })
    }
}
