//! Points in a plane with their heights, and pieces of path among them.

use crate::{Vec2, math};

use super::Measure;

/// A part of the points, in the coordinates of a plane.
pub(super) struct Flat {
    pub(super) at: Vec<Vec2>,
    pub(super) height: Vec<f64>,
    /// Length of the chords up to a point, in the plane.
    pub(super) along: Vec<f64>,
    /// For every point, the next chord from there on that no arc may take in; one behind the last
    /// chord where there is none.
    pub(super) stiff: Vec<usize>,
    /// Chords whose middle may lie noticeably deeper than its ends.
    pub(super) deep: Vec<bool>,
}

impl Flat {
    pub(super) fn new(at: Vec<Vec2>, height: Vec<f64>, tolerance: f64, measure: Measure) -> Flat {
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
            math::atan2(a.cross(b), a.dot(b)).abs()
        };
        let depth = |index: usize| {
            let length = along[index + 1] - along[index];
            // The sagitta of an arc that turns as the path does beside this chord.
            length * turn(index).max(turn(index + 1)) / 8.0
        };
        let depths: Vec<f64> = (0..chords).map(depth).collect();
        let mut stiff = vec![chords; at.len()];
        for index in (0..chords).rev() {
            let is_stiff = depths[index] > 2.0 * tolerance && measure == Measure::Chords;
            stiff[index] = if is_stiff { index } else { stiff[index + 1] };
        }
        let deep = depths
            .iter()
            .map(|depth| measure == Measure::Chords && *depth > tolerance / 30.0)
            .collect();
        Flat { at, height, along, stiff, deep }
    }

    pub(super) fn last(&self) -> usize {
        self.at.len() - 1
    }

    pub(super) fn length(&self, from: usize, to: usize) -> f64 {
        self.along[to] - self.along[from]
    }

    /// The point at a place: a whole number is a point, a fraction lies on the chord behind it.
    pub(super) fn point(&self, place: f64) -> (Vec2, f64) {
        let whole = (place as usize).min(self.last());
        let fraction = place - whole as f64;
        if fraction <= 0.0 || whole == self.last() {
            return (self.at[whole], self.height[whole]);
        }
        let (a, b) = (self.at[whole], self.at[whole + 1]);
        let height = self.height[whole] + (self.height[whole + 1] - self.height[whole]) * fraction;
        (a + (b - a) * fraction, height)
    }
}

/// A line or an arc between two points, and the part of the points that it stands for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) ends: [Vec2; 2],
    pub(super) heights: [f64; 2],
    pub(super) shape: Shape,
    pub(super) span: [f64; 2],
    pub(super) deviation: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    Line,
    Arc {
        center: Vec2,
        /// Positive counter-clockwise, radians.
        sweep: f64,
    },
}

impl Piece {
    /// The line or arc from one point of the row to another whose direction turns by twice `half`
    /// (radians, positive counter-clockwise).
    pub(super) fn between(flat: &Flat, from: usize, to: usize, half: f64) -> Piece {
        let ends = [flat.at[from], flat.at[to]];
        Piece {
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

    /// Half of the angle by which the direction turns.
    pub(super) fn half(&self) -> f64 {
        match self.shape {
            Shape::Line => 0.0,
            Shape::Arc { sweep, .. } => sweep / 2.0,
        }
    }

    pub(super) fn is_line(&self) -> bool {
        self.shape == Shape::Line
    }
}

/// The arc between two points that turns by twice `half`; a line where that is zero.
pub(super) fn shape(ends: [Vec2; 2], half: f64) -> Shape {
    if half == 0.0 {
        return Shape::Line;
    }
    let chord = ends[1] - ends[0];
    let (sin, cos) = math::sin_cos(half);
    let middle = (ends[0] + ends[1]) * 0.5;
    Shape::Arc { center: middle + chord.turned_left() * (0.5 * cos / sin), sweep: 2.0 * half }
}
