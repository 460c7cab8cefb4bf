//! Points in a plane with their heights, and pieces of the path through them.

use crate::{Vec2, math};

use super::FitMeasure;

/// A part of the points, in the coordinates of a plane. The points of a closed path are repeated once, so that positions
/// can continue past its start.
pub(super) struct PlanarPoints {
    /// The last point of the path.
    last: usize,
    pub(super) at: Vec<Vec2>,
    pub(super) height: Vec<f64>,
    /// Length of the chords up to each point, in the plane, mm.
    pub(super) along: Vec<f64>,
    /// For each point, the index of the next chord that cannot be part of an arc; the number of chords if there is none.
    pub(super) stiff: Vec<usize>,
    /// True for chords whose midpoint may be noticeably farther from an arc than its ends.
    pub(super) deep: Vec<bool>,
}

impl PlanarPoints {
    pub(super) fn new(
        mut at: Vec<Vec2>,
        mut height: Vec<f64>,
        is_closed: bool,
        tolerance: f64,
        measure: FitMeasure,
    ) -> PlanarPoints {
        let last = at.len() - 1;
        if is_closed {
            at.extend_from_within(1..);
            height.extend_from_within(1..);
        }
        let chords = at.len() - 1;
        let mut along = vec![0.0; at.len()];
        for index in 0..chords {
            along[index + 1] = along[index] + at[index].distance(at[index + 1]);
        }
        let turn = |index: usize| {
            if index == 0 || index >= chords {
                return 0.0;
            }
            let (a, b) = (at[index] - at[index - 1], at[index + 1] - at[index]);
            let lengths = (along[index] - along[index - 1]) * (along[index + 1] - along[index]);
            // The sine is accurate enough for the small angles that matter.
            if a.dot(b) > 0.0 { (a.cross(b) / lengths).abs() } else { math::PI }
        };
        let depth = |index: usize| {
            let length = along[index + 1] - along[index];
            // The sagitta of an arc that turns like the path at this chord.
            length * turn(index).max(turn(index + 1)) / 8.0
        };
        let depths: Vec<f64> = (0..chords).map(depth).collect();
        let mut stiff = vec![chords; at.len()];
        for index in (0..chords).rev() {
            let is_stiff = depths[index] > 2.0 * tolerance && measure == FitMeasure::Chords;
            stiff[index] = if is_stiff { index } else { stiff[index + 1] };
        }
        let deep = depths
            .iter()
            .map(|depth| measure == FitMeasure::Chords && *depth > tolerance / 30.0)
            .collect();
        PlanarPoints { last, at, height, along, stiff, deep }
    }

    pub(super) fn last(&self) -> usize {
        self.last
    }

    fn end(&self) -> usize {
        self.at.len() - 1
    }

    pub(super) fn length(&self, from: usize, to: usize) -> f64 {
        self.along[to] - self.along[from]
    }

    /// The point at a position, which is an index of a point plus a fraction of the chord after it.
    pub(super) fn point(&self, place: f64) -> (Vec2, f64) {
        let whole = (place as usize).min(self.end());
        let fraction = place - whole as f64;
        if fraction <= 0.0 || whole == self.end() {
            return (self.at[whole], self.height[whole]);
        }
        let (a, b) = (self.at[whole], self.at[whole + 1]);
        let height = self.height[whole] + (self.height[whole + 1] - self.height[whole]) * fraction;
        (a + (b - a) * fraction, height)
    }

    /// The length along the chords up to a position, mm.
    pub(super) fn length_at(&self, place: f64) -> f64 {
        let whole = (place as usize).min(self.end() - 1);
        self.along[whole] + (place - whole as f64) * self.length(whole, whole + 1)
    }

    /// The position at a length along the chords, mm.
    pub(super) fn place(&self, length: f64) -> f64 {
        let following = self.along.partition_point(|along| *along <= length).min(self.end());
        let (a, b) = (self.along[following - 1], self.along[following]);
        (following - 1) as f64 + part(length, a, b)
    }

    /// The position, close to `near`, where the path crosses the line through a point perpendicular to a direction;
    /// `None` if it does not.
    pub(super) fn foot(&self, near: f64, point: Vec2, direction: Vec2) -> Option<f64> {
        let ahead = |index: usize| (self.at[index] - point).dot(direction);
        let start = (near as usize).min(self.end() - 1);
        let (mut low, mut high, mut step) = (start, start, 1);
        if ahead(start) <= 0.0 {
            while ahead(high) <= 0.0 {
                if high == self.end() {
                    return (ahead(high) == 0.0).then_some(high as f64);
                }
                (low, high) = (high, (high + step).min(self.end()));
                step *= 2;
            }
        } else {
            while ahead(low) > 0.0 {
                if low == 0 {
                    return None;
                }
                (low, high) = (low.saturating_sub(step), low);
                step *= 2;
            }
        }
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if ahead(middle) <= 0.0 { low = middle } else { high = middle }
        }
        let (before, following) = (ahead(low), ahead(high));
        Some(low as f64 + before / (before - following))
    }

    /// Passes positions between two others to `see`: those of all points, or if there are more than `count`, about
    /// `count`.
    pub(super) fn probes(&self, from: f64, to: f64, count: usize, mut see: impl FnMut(f64)) {
        let (first, last) = (math::ceil(from) as usize, to as usize);
        if first >= last {
            return see(0.5 * (from + to));
        }
        let mut look = |index: usize| {
            see(index as f64);
            if index < last && self.deep[index] {
                see(index as f64 + 0.5);
            }
        };
        if last - first <= count {
            return (first..=last).for_each(look);
        }
        let (start, end) = (self.along[first], self.along[last]);
        let mut index = first;
        for probe in 0..=count {
            let length = start + (end - start) * (probe as f64 / count as f64);
            let following = &self.along[index..=last];
            index += following.partition_point(|along| *along < length).min(following.len() - 1);
            look(index);
        }
    }
}

/// The fraction of the interval from `a` to `b` at `level`, 0..=1.
pub(super) fn part(level: f64, a: f64, b: f64) -> f64 {
    if b > a { ((level - a) / (b - a)).clamp(0.0, 1.0) } else { 0.0 }
}

/// A line or an arc between two points, and the range of the points that it replaces.
#[derive(Clone, Copy, Debug)]
pub(super) struct FittedPiece {
    pub(super) ends: [Vec2; 2],
    pub(super) heights: [f64; 2],
    pub(super) shape: FittedShape,
    pub(super) span: [f64; 2],
    pub(super) deviation: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FittedShape {
    Line,
    Arc {
        center: Vec2,
        /// The angle of the arc, rad, positive counter-clockwise.
        sweep: f64,
    },
}

impl FittedPiece {
    /// The line or arc from one point to another whose direction turns by twice `half`, rad, positive counter-clockwise.
    pub(super) fn between(flat: &PlanarPoints, from: usize, to: usize, half: f64) -> FittedPiece {
        let ends = [flat.at[from], flat.at[to]];
        FittedPiece {
            ends,
            heights: [flat.height[from], flat.height[to]],
            shape: shape(ends, half),
            span: [from as f64, to as f64],
            deviation: 0.0,
        }
    }

    pub(super) fn chord(&self) -> Vec2 {
        self.ends[1] - self.ends[0]
    }

    /// Half of the angle by which the direction turns, rad.
    pub(super) fn half(&self) -> f64 {
        match self.shape {
            FittedShape::Line => 0.0,
            FittedShape::Arc { sweep, .. } => sweep / 2.0,
        }
    }

    /// The direction at the start, with the length of the chord.
    pub(super) fn direction(&self) -> Vec2 {
        let (sin, cos) = math::sin_cos(-self.half());
        self.chord() * cos + self.chord().turned_left() * sin
    }

    pub(super) fn is_line(&self) -> bool {
        self.shape == FittedShape::Line
    }
}

/// The arc between two points that turns by twice `half`, rad; a line if that is zero.
pub(super) fn shape(ends: [Vec2; 2], half: f64) -> FittedShape {
    if half == 0.0 {
        return FittedShape::Line;
    }
    let chord = ends[1] - ends[0];
    let (sin, cos) = math::sin_cos(half);
    let middle = (ends[0] + ends[1]) * 0.5;
    FittedShape::Arc { center: middle + chord.turned_left() * (0.5 * cos / sin), sweep: 2.0 * half }
}
