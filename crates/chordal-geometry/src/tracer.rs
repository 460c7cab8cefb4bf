//! Curves made ready to be asked at many places.

use crate::winding::Winding;
use crate::{Curve, Line, ParamCurve, Spiral, Vec3};

/// A curve with all that does not change along it worked out: it answers what
/// [`ParamCurve::jet_at`] answers, to the last bit, in less time.
#[derive(Clone, Copy, Debug)]
pub struct Tracer {
    start: Vec3,
    end: Vec3,
    length: f64,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Straight { line: Line, tangent: Vec3 },
    Round { winding: Winding },
    Growing { spiral: Spiral },
}

impl Tracer {
    /// Makes a curve ready.
    #[must_use]
    pub fn new(curve: &Curve) -> Tracer {
        let kind = match curve {
            Curve::Line(line) => Kind::Straight { line: *line, tangent: line.tangent_at(0.0) },
            Curve::Arc(arc) => Kind::Round { winding: arc.winding() },
            Curve::Spiral(spiral) => Kind::Growing { spiral: *spiral },
        };
        Tracer { start: curve.start(), end: curve.end(), length: curve.length(), kind }
    }

    /// The point at `s` mm from the start, mm, and its first three derivatives by `s`.
    #[must_use]
    #[inline]
    pub fn jet_at(&self, s: f64) -> [Vec3; 4] {
        match &self.kind {
            Kind::Straight { line, tangent } => {
                let point =
                    self.end_at(s).unwrap_or_else(|| line.start.lerp(line.end, s / self.length));
                [point, *tangent, Vec3::ZERO, Vec3::ZERO]
            }
            Kind::Round { winding } => {
                let t = if s <= 0.0 {
                    0.0
                } else if s >= self.length {
                    1.0
                } else {
                    s / self.length
                };
                let (point, derivatives) = winding.jet(t);
                derivatives.behind(self.end_at(s).unwrap_or(point))
            }
            Kind::Growing { spiral } => spiral.jet_at(s),
        }
    }

    /// The end as it was given, at and beyond it.
    fn end_at(&self, s: f64) -> Option<Vec3> {
        if s <= 0.0 {
            Some(self.start)
        } else if s >= self.length {
            Some(self.end)
        } else {
            None
        }
    }
}
