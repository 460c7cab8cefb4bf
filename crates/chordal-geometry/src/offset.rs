//! Offset curves of lines and arcs.

use crate::{Arc, Line, ParamCurve, Vec3};

impl Line {
    /// The parallel line `distance` mm to the left, seen against `normal` (of any length); to the right if negative. A
    /// line that is not perpendicular to `normal` is moved like its projection. `None` if that projection has no
    /// direction.
    #[must_use]
    pub fn offset(&self, normal: Vec3, distance: f64) -> Option<Line> {
        let left = normal.normalized()?.cross(self.tangent_at(0.0)).normalized()?;
        Some(Line { start: self.start + left * distance, end: self.end + left * distance })
    }
}

impl Arc {
    /// The concentric arc `distance` mm to the left, seen against `self.w`; to the right if negative. `None` if its
    /// radius would not be above zero. The offset of a helix is a helix with the same rise.
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
