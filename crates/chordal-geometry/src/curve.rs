//! The enum of all curves.

use crate::{
    Aabb, Arc, ChordError, Chords, Line, Nearest, ParamCurve, Placement, Spiral, SplinePiece,
    Transform, Vec3,
};

/// Any of the exact curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// A straight line.
    Line(Line),
    /// A circular arc, or a helix.
    Arc(Arc),
    /// An Archimedean spiral, or such a curve on a cone.
    Spiral(Spiral),
    /// One polynomial span of a spline.
    Spline(SplinePiece),
}

impl From<SplinePiece> for Curve {
    fn from(c: SplinePiece) -> Self {
        Curve::Spline(c)
    }
}

impl From<Line> for Curve {
    fn from(c: Line) -> Self {
        Curve::Line(c)
    }
}

impl From<Arc> for Curve {
    fn from(c: Arc) -> Self {
        Curve::Arc(c)
    }
}

impl From<Spiral> for Curve {
    fn from(c: Spiral) -> Self {
        Curve::Spiral(c)
    }
}

macro_rules! each {
    ($self:expr, $c:ident => $value:expr) => {
        match $self {
            Curve::Line($c) => $value,
            Curve::Arc($c) => $value,
            Curve::Spiral($c) => $value,
            Curve::Spline($c) => $value,
        }
    };
}

impl ParamCurve for Curve {
    fn start(&self) -> Vec3 {
        each!(self, c => c.start())
    }

    fn end(&self) -> Vec3 {
        each!(self, c => c.end())
    }

    fn length(&self) -> f64 {
        each!(self, c => c.length())
    }

    fn point_at(&self, s: f64) -> Vec3 {
        each!(self, c => c.point_at(s))
    }

    fn tangent_at(&self, s: f64) -> Vec3 {
        each!(self, c => c.tangent_at(s))
    }

    fn curvature_at(&self, s: f64) -> Vec3 {
        each!(self, c => c.curvature_at(s))
    }

    fn curvature_derivative_at(&self, s: f64) -> Vec3 {
        each!(self, c => c.curvature_derivative_at(s))
    }

    fn jet_at(&self, s: f64) -> [Vec3; 4] {
        each!(self, c => c.jet_at(s))
    }

    fn bounds(&self) -> Aabb {
        each!(self, c => c.bounds())
    }

    fn reversed(&self) -> Self {
        each!(self, c => c.reversed().into())
    }

    fn split_at(&self, s: f64) -> (Self, Self) {
        each!(self, c => {
            let (before, after) = c.split_at(s);
            (before.into(), after.into())
        })
    }

    fn subsegment(&self, s0: f64, s1: f64) -> Self {
        each!(self, c => c.subsegment(s0, s1).into())
    }

    fn transformed(&self, transform: &Transform) -> Self {
        each!(self, c => c.transformed(transform).into())
    }

    fn nearest(&self, p: Vec3) -> Nearest {
        each!(self, c => c.nearest(p))
    }

    fn max_curvature(&self) -> f64 {
        each!(self, c => c.max_curvature())
    }

    fn chords(&self, tolerance: f64, placement: Placement) -> Result<Chords, ChordError> {
        each!(self, c => c.chords(tolerance, placement))
    }
}
