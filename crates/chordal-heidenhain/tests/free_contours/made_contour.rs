//! Contours that are made forwards, and described by some of their values.

use chordal_geometry::TurnDirection;
use chordal_heidenhain::geometry::{
    FreeContourFault, FreeContourRequest, FreeElementValues, FreeReference, FreeSolutionOrder,
    FreeValue, SolvedFreeElement, solve_free_contour,
};

use super::support::NumberSequence;

/// How far values may be off each other, mm.
pub const TOLERANCE_MM: f64 = 0.01;

/// FPOL of all contours.
pub const POLE: [f64; 2] = [3.0, -7.0];

/// A contour while it is made.
pub struct MadeContour {
    pub numbers: NumberSequence,
    pub start: [f64; 2],
    pub entry_deg: f64,
    pub place: [f64; 2],
    /// The direction there, degrees.
    pub heading_deg: f64,
    pub values: Vec<FreeElementValues>,
    pub expected: Vec<SolvedFreeElement>,
    /// The direction in which each element ends, degrees.
    pub ends_deg: Vec<f64>,
}

pub fn absolute(value: f64) -> Option<FreeValue> {
    Some(FreeValue::from(value))
}

pub fn both(point: [f64; 2]) -> [Option<FreeValue>; 2] {
    point.map(absolute)
}

pub fn polar(point: [f64; 2]) -> [Option<FreeValue>; 2] {
    let [x, y] = [point[0] - POLE[0], point[1] - POLE[1]];
    both([x.hypot(y), y.atan2(x).to_degrees()])
}

pub fn cos_sin(degrees: f64) -> [f64; 2] {
    [degrees.to_radians().cos(), degrees.to_radians().sin()]
}

pub fn ahead(place: [f64; 2], degrees: f64, by: f64) -> [f64; 2] {
    let [cos, sin] = cos_sin(degrees);
    [place[0] + cos * by, place[1] + sin * by]
}

pub fn distance(one: [f64; 2], other: [f64; 2]) -> f64 {
    (one[0] - other[0]).hypot(one[1] - other[1])
}

pub fn nothing() -> FreeElementValues {
    FreeElementValues { pole: Some(POLE), ..FreeElementValues::default() }
}

pub fn turn_of(sign: f64) -> Option<TurnDirection> {
    Some(if sign > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw })
}

/// An arc that was made.
pub struct MadeArc {
    pub sign: f64,
    pub center: [f64; 2],
    pub radius: f64,
    pub sweep_deg: f64,
    pub end: [f64; 2],
    pub entry_deg: f64,
}

impl MadeArc {
    /// A point of the circle, some degrees after its start.
    pub fn point(&self, after_deg: f64) -> [f64; 2] {
        let degrees = self.entry_deg + self.sign * (after_deg - 90.0);
        ahead(self.center, degrees, self.radius)
    }
}

impl MadeContour {
    pub fn new(seed: u64) -> MadeContour {
        let mut numbers = NumberSequence(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        let start = [numbers.between(-50.0, 50.0), numbers.between(-50.0, 50.0)];
        let heading_deg = numbers.between(-180.0, 180.0);
        MadeContour {
            numbers,
            start,
            entry_deg: heading_deg,
            place: start,
            heading_deg,
            values: Vec::new(),
            expected: Vec::new(),
            ends_deg: Vec::new(),
        }
    }

    pub fn turn(&mut self, is_tangent: bool) {
        if !is_tangent {
            self.heading_deg = self.numbers.between(-180.0, 180.0);
        }
    }

    pub fn line_end(&mut self) -> ([f64; 2], f64) {
        let length = self.numbers.between(5.0, 50.0);
        (ahead(self.place, self.heading_deg, length), length)
    }

    pub fn add(&mut self, values: FreeElementValues, end: [f64; 2], center: Option<[f64; 2]>) {
        self.values.push(values);
        self.expected.push(SolvedFreeElement { end, center });
        self.ends_deg.push(self.heading_deg);
        self.place = end;
    }

    /// A reference to an element before the next one, where it ends, and the direction there.
    pub fn reference(&mut self) -> (FreeReference, [f64; 2], f64) {
        let at = self.numbers.below(self.values.len() as u32 + 1) as usize;
        match at.checked_sub(1) {
            None => (FreeReference::Start, self.start, self.entry_deg),
            Some(own) => (FreeReference::Own(own), self.expected[own].end, self.ends_deg[own]),
        }
    }

    /// A point as distances from the end of another element.
    pub fn relative(&mut self, point: [f64; 2]) -> [Option<FreeValue>; 2] {
        let (reference, from, _) = self.reference();
        [0, 1]
            .map(|axis| Some(FreeValue { value: point[axis] - from[axis], from: Some(reference) }))
    }

    /// An angle from the direction of another element.
    pub fn relative_angle(&mut self, degrees: f64) -> Option<FreeValue> {
        let (reference, _, direction) = self.reference();
        Some(FreeValue { value: degrees - direction, from: Some(reference) })
    }

    pub fn line(&mut self) {
        let is_tangent = self.numbers.below(2) == 0;
        self.turn(is_tangent);
        let (end, length) = self.line_end();
        let known = FreeElementValues { is_tangent, ..nothing() };
        let angle = absolute(self.heading_deg).filter(|_| !is_tangent);
        let across = cos_sin(self.heading_deg).map(f64::abs);
        let values = match self.numbers.below(4) {
            0 => FreeElementValues { end: both(end), ..known },
            1 => FreeElementValues { angle, length: Some(length), ..known },
            2 if across[0] > 0.2 => {
                FreeElementValues { angle, end: [absolute(end[0]), None], ..known }
            }
            2 => FreeElementValues { angle, end: [None, absolute(end[1])], ..known },
            _ => FreeElementValues { polar: polar(end), ..known },
        };
        self.add(values, end, None);
    }

    /// An arc from the present place and heading.
    pub fn made_arc(&mut self) -> MadeArc {
        let sign = if self.numbers.below(2) == 0 { 1.0 } else { -1.0 };
        let radius = self.numbers.between(5.0, 40.0);
        let sweep_deg = self.numbers.between(15.0, 300.0);
        let entry_deg = self.heading_deg;
        let center = ahead(self.place, entry_deg + sign * 90.0, radius);
        self.heading_deg += sign * sweep_deg;
        let end = ahead(center, self.heading_deg - sign * 90.0, radius);
        MadeArc { sign, center, radius, sweep_deg, end, entry_deg }
    }

    pub fn arc(&mut self) {
        let is_tangent = self.numbers.below(2) == 0;
        self.turn(is_tangent);
        let MadeArc { sign, center, radius, end, .. } = self.made_arc();
        let known = FreeElementValues { turn: turn_of(sign), is_tangent, ..nothing() };
        let values = match (is_tangent, self.numbers.below(3)) {
            (true, 0) => FreeElementValues { radius: Some(radius), end: both(end), ..known },
            (true, 1) => FreeElementValues { end: both(end), ..known },
            (_, 2) => FreeElementValues {
                center: both(center),
                radius: Some(radius),
                polar: polar(end),
                ..known
            },
            _ => FreeElementValues { center: both(center), end: both(end), ..known },
        };
        self.add(values, end, Some(center));
    }

    /// Two lines, of which the first has its angle alone.
    pub fn corner(&mut self) {
        self.turn(false);
        let (end, _) = self.line_end();
        let first = FreeElementValues { angle: absolute(self.heading_deg), ..nothing() };
        self.add(first, end, None);
        self.heading_deg += self.numbers.between(20.0, 160.0);
        let (end, _) = self.line_end();
        let angle = absolute(self.heading_deg);
        self.add(FreeElementValues { angle, end: both(end), ..nothing() }, end, None);
    }

    /// A line, an arc of a radius and a line, of which the angles and the last end are known.
    pub fn rounding(&mut self) {
        self.turn(false);
        let (end, _) = self.line_end();
        let angle = absolute(self.heading_deg);
        self.add(FreeElementValues { angle, ..nothing() }, end, None);
        let sign = if self.numbers.below(2) == 0 { 1.0 } else { -1.0 };
        let radius = self.numbers.between(2.0, 20.0);
        let center = ahead(self.place, self.heading_deg + sign * 90.0, radius);
        self.heading_deg += sign * self.numbers.between(20.0, 160.0);
        let end = ahead(center, self.heading_deg - sign * 90.0, radius);
        let arc = FreeElementValues {
            turn: turn_of(sign),
            is_tangent: true,
            radius: Some(radius),
            ..nothing()
        };
        self.add(arc, end, Some(center));
        let (end, _) = self.line_end();
        let angle = absolute(self.heading_deg);
        let line = FreeElementValues { is_tangent: true, angle, end: both(end), ..nothing() };
        self.add(line, end, None);
    }

    /// An arc, a tangent line of which nothing is known, and another arc; both centres and radii are known.
    pub fn belt(&mut self) {
        self.turn(false);
        let first = self.made_arc();
        let of = |arc: &MadeArc| FreeElementValues {
            turn: turn_of(arc.sign),
            center: both(arc.center),
            radius: Some(arc.radius),
            ..nothing()
        };
        self.add(of(&first), first.end, Some(first.center));
        let (end, _) = self.line_end();
        self.add(FreeElementValues { is_tangent: true, ..nothing() }, end, None);
        let last = self.made_arc();
        let values = FreeElementValues { is_tangent: true, end: both(last.end), ..of(&last) };
        self.add(values, last.end, Some(last.center));
    }

    // ---- Words that refer to points and other elements ----

    /// A line with relative words, points on it and next to it, or parallel to another one.
    pub fn related_line(&mut self) {
        self.turn(false);
        let (end, length) = self.line_end();
        let values = match self.numbers.below(5) {
            0 => FreeElementValues { end: self.relative(end), ..nothing() },
            1 => {
                let angle = self.relative_angle(self.heading_deg);
                FreeElementValues { angle, length: Some(length), ..nothing() }
            }
            2 => {
                // A point on the line or on its extension.
                let by = self.numbers.between(-30.0, 60.0);
                let point = ahead(self.place, self.heading_deg, by);
                let axis = usize::from(cos_sin(self.heading_deg)[0].abs() < 0.5);
                let mut values = nothing();
                values.auxiliary[0] = Some(point);
                values.end[axis] = absolute(end[axis]);
                values
            }
            3 => {
                let along = ahead(self.place, self.heading_deg, self.numbers.between(0.0, 50.0));
                let off = self.numbers.between(2.0, 9.0);
                let point = ahead(along, self.heading_deg + 90.0, off);
                let distance_point = Some((point, off));
                FreeElementValues { distance_point, length: Some(length), ..nothing() }
            }
            _ => return self.parallel_line(),
        };
        self.add(values, end, None);
    }

    /// A line parallel to an earlier one; the earlier one is made first.
    pub fn parallel_line(&mut self) {
        self.turn(false);
        let (end, length) = self.line_end();
        let angle = absolute(self.heading_deg);
        self.add(FreeElementValues { angle, length: Some(length), ..nothing() }, end, None);
        let (own, along) = (self.values.len() - 1, self.heading_deg);
        self.heading_deg = along + 90.0;
        let distance = self.numbers.between(5.0, 20.0);
        let angle = Some(FreeValue { value: 90.0, from: Some(FreeReference::Own(own)) });
        let end = ahead(self.place, self.heading_deg, distance);
        self.add(FreeElementValues { angle, length: Some(distance), ..nothing() }, end, None);
        self.heading_deg = if self.numbers.below(2) == 0 { along } else { along + 180.0 };
        let (end, length) = self.line_end();
        let values = FreeElementValues {
            parallel_to: Some(FreeReference::Own(own)),
            parallel_distance: Some(distance),
            length: Some(length),
            ..nothing()
        };
        self.add(values, end, None);
    }

    /// An arc with relative words, points on it, its chord or its angle.
    pub fn related_arc(&mut self) {
        let is_tangent = self.numbers.below(2) == 0;
        self.turn(is_tangent);
        // The references are to elements before it.
        let count = self.values.len();
        let arc = self.made_arc();
        let known = FreeElementValues { turn: turn_of(arc.sign), is_tangent, ..nothing() };
        let mut values = match self.numbers.below(6) {
            0 => FreeElementValues { center: self.relative(arc.center), ..known },
            1 if is_tangent => {
                let center_angle_deg = Some(arc.sweep_deg);
                FreeElementValues { radius: Some(arc.radius), center_angle_deg, ..known }
            }
            2 => {
                let points =
                    [60.0, 110.0, 160.0].map(|part| arc.point(arc.sweep_deg * part / 200.0));
                FreeElementValues { auxiliary: points.map(Some), ..known }
            }
            3 if is_tangent => {
                let mut values = FreeElementValues { polar: polar(arc.end), ..known };
                values.auxiliary[1] = Some(arc.point(arc.sweep_deg / 2.0));
                values
            }
            4 => {
                let off = self.numbers.between(1.0, 4.0);
                let radial = arc.entry_deg + arc.sign * (arc.sweep_deg / 2.0 - 90.0);
                // Outside of the circle or inside.
                let side = if self.numbers.below(2) == 0 { off } else { -off };
                let point = ahead(arc.center, radial, arc.radius + side);
                let distance_point = Some((point, off));
                FreeElementValues { radius: Some(arc.radius), distance_point, ..known }
            }
            _ => FreeElementValues { center_polar: polar(arc.center), ..known },
        };
        if !is_tangent && self.numbers.below(2) == 0 {
            values.angle = absolute(arc.entry_deg);
        }
        let has_end = values.center_angle_deg.is_some() || values.polar[0].is_some();
        if !has_end {
            match self.numbers.below(3) {
                0 => values.length = Some(distance(self.place, arc.end)),
                1 => values.center_angle_deg = Some(arc.sweep_deg),
                _ => values.end = both(arc.end),
            }
        }
        assert_eq!(self.values.len(), count);
        self.add(values, arc.end, Some(arc.center));
    }

    /// An arc whose end is where a line of a known angle crosses it, of which a point is known, and its end.
    pub fn crossing(&mut self) {
        self.turn(false);
        let arc = self.made_arc();
        let values =
            FreeElementValues { turn: turn_of(arc.sign), center: both(arc.center), ..nothing() };
        self.add(values, arc.end, Some(arc.center));
        self.heading_deg = self.numbers.between(-180.0, 180.0);
        let (end, _) = self.line_end();
        let off = self.numbers.between(1.0, 9.0);
        let side = if self.numbers.below(2) == 0 { 90.0 } else { -90.0 };
        let point = ahead(ahead(end, self.heading_deg, -3.0), self.heading_deg + side, off);
        let axis = usize::from(cos_sin(self.heading_deg)[0].abs() < 0.5);
        let angle = absolute(self.heading_deg);
        let mut line = FreeElementValues { angle, distance_point: Some((point, off)), ..nothing() };
        line.end[axis] = absolute(end[axis]);
        self.add(line, end, None);
    }

    pub fn request<'r>(
        &'r self,
        selections: &'r [(usize, u32)],
        entry: &'r [f64; 2],
    ) -> FreeContourRequest<'r> {
        FreeContourRequest {
            elements: &self.values,
            before: &[],
            start: self.start,
            entry: Some(*entry),
            selections,
            order: FreeSolutionOrder::Turning,
            tolerance_mm: TOLERANCE_MM,
        }
    }

    pub fn solve(
        &self,
        selections: &[(usize, u32)],
    ) -> Result<Vec<SolvedFreeElement>, FreeContourFault> {
        solve_free_contour(&self.request(selections, &cos_sin(self.entry_deg)))
    }
}
