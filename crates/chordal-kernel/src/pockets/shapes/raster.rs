//! Clears a region: once round its border, then row by row, without leaving it.

use chordal_geometry::Vec2;

use super::Step;
use super::outline::{COINCIDENT_POINT_MM, Outline, OutlineElement};

/// Shorter rows and links, mm, are ignored.
const MIN_ROW_MM: f64 = 1e-3;

/// The axis along which rows step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RasterAlong {
    /// Rows run parallel to the second axis and step along the first.
    First,
    /// Rows run parallel to the first axis and step along the second.
    Second,
}

/// Why a region cannot be cleared.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ClearError {
    /// More rows than the limit.
    TooManyRows,
}

/// One connected part of the region of a tool centre, with a start point in it.
#[derive(Clone, Debug)]
pub struct PocketRegion<'a> {
    outline: &'a Outline,
    border: &'a Outline,
    /// Distance that the centre keeps from the outline, mm.
    distance: f64,
    start: Vec2,
    /// Length of the border before each element, and of all.
    before: Vec<f64>,
    /// The point of the border nearest to the start, mm along it.
    entry: f64,
}

/// A row within the region; both of its ends lie on the border.
#[derive(Clone, Copy, Debug)]
struct RasterRow {
    line: usize,
    /// Positions on the border, mm along it, and their points.
    ends: [(f64, Vec2); 2],
}

impl<'a> PocketRegion<'a> {
    /// The part that contains the start; `None` when no part does.
    pub fn around(
        outline: &'a Outline,
        borders: &'a [Outline],
        distance: f64,
        start: Vec2,
    ) -> Option<PocketRegion<'a>> {
        if outline.distance(start) < distance - COINCIDENT_POINT_MM {
            return None;
        }
        let nearest = |border: &Outline| border.distance(start) <= 2.0 * MIN_ROW_MM;
        let border = borders
            .iter()
            .find(|border| border.contains(start))
            .or_else(|| borders.iter().find(|border| nearest(border)))?;
        let mut before = vec![0.0];
        for element in border.elements() {
            let sum = before[before.len() - 1] + element.length();
            before.push(sum);
        }
        let mut region = PocketRegion { outline, border, distance, start, before, entry: 0.0 };
        region.entry = region.nearest_place(start);
        Some(region)
    }

    /// Distance of a point from the border of the part, mm.
    pub fn distance_of_border(&self, p: Vec2) -> f64 {
        self.border.distance(p)
    }

    /// From the start to the border, once round it, and back to the start.
    pub fn round(&self) -> Vec<Step> {
        let mut steps = Vec::new();
        self.go(&mut steps, self.start, self.point(self.entry));
        self.walk(self.entry, self.once_round(), &mut steps);
        self.go(&mut steps, self.point(self.entry), self.start);
        steps
    }

    /// From the start once round the border, then every row, then back to the start. `step` is
    /// the distance of the rows, mm.
    pub fn clear(
        &self,
        along: RasterAlong,
        step: f64,
        limit: usize,
    ) -> Result<Vec<Step>, ClearError> {
        let mut rows = self.rows(along, step, limit)?;
        let mut steps = Vec::new();
        self.go(&mut steps, self.start, self.point(self.entry));
        self.walk(self.entry, self.once_round(), &mut steps);
        let mut place = self.entry;
        let mut first = true;
        while !rows.is_empty() {
            let (index, end) = self.next_row(&rows, first, place);
            let row = rows.swap_remove(index);
            self.link(&mut steps, place, row.ends[end]);
            steps.push(Step::Line { to: row.ends[1 - end].1 });
            place = row.ends[1 - end].0;
            first = false;
        }
        let here = self.point(place);
        if self.is_clear(here, self.start) {
            self.go(&mut steps, here, self.start);
        } else {
            self.walk_to(place, self.entry, &mut steps);
            self.go(&mut steps, self.point(self.entry), self.start);
        }
        Ok(steps)
    }

    /// The next row and the end to enter it at: first a row of the first line, then always the nearest end, so that
    /// an arm is finished before the next one.
    fn next_row(&self, rows: &[RasterRow], first: bool, place: f64) -> (usize, usize) {
        let here = self.point(place);
        let mut best = (usize::MAX, f64::INFINITY, 0, 0);
        for (index, row) in rows.iter().enumerate() {
            let line = if first { row.line } else { 0 };
            for (end, (_, point)) in row.ends.iter().enumerate() {
                let path = here.distance(*point);
                if line < best.0 || line == best.0 && path < best.1 - COINCIDENT_POINT_MM {
                    best = (line, path, index, end);
                }
            }
        }
        (best.2, best.3)
    }

    fn rows(
        &self,
        along: RasterAlong,
        step: f64,
        limit: usize,
    ) -> Result<Vec<RasterRow>, ClearError> {
        let level = |p: Vec2| if along == RasterAlong::First { p.a } else { p.b };
        let other = |p: Vec2| if along == RasterAlong::First { p.b } else { p.a };
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
        for element in self.border.elements() {
            for p in element.extremes() {
                low = low.min(level(p));
                high = high.max(level(p));
                left = left.min(other(p));
                right = right.max(other(p));
            }
        }
        let count = ((high - low) / step).ceil();
        if count > limit as f64 {
            return Err(ClearError::TooManyRows);
        }
        let place = |at: f64, level: f64| match along {
            RasterAlong::First => Vec2::new(level, at),
            RasterAlong::Second => Vec2::new(at, level),
        };
        let mut rows = Vec::new();
        for line in 1..=count as usize {
            let at = low + step * line as f64;
            let scan =
                OutlineElement::Line { from: place(left - 1.0, at), to: place(right + 1.0, at) };
            self.rows_of_line(line, &scan, &mut rows);
            if rows.len() > limit {
                return Err(ClearError::TooManyRows);
            }
        }
        Ok(rows)
    }

    fn rows_of_line(&self, line: usize, scan: &OutlineElement, rows: &mut Vec<RasterRow>) {
        let mut ends: Vec<(f64, f64, Vec2)> = Vec::new();
        for (index, element) in self.border.elements().iter().enumerate() {
            for point in element.crossings(scan, COINCIDENT_POINT_MM) {
                let on_scan = scan.fraction(point, COINCIDENT_POINT_MM);
                let on_border = element.fraction(point, COINCIDENT_POINT_MM);
                if let (Some(t), Some(s)) = (on_scan, on_border) {
                    ends.push((t, self.before[index] + s * element.length(), point));
                }
            }
        }
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        for pair in ends.windows(2) {
            let (a, b) = (pair[0].2, pair[1].2);
            if a.distance(b) < MIN_ROW_MM || !self.holds((a + b) * 0.5) {
                continue;
            }
            rows.push(RasterRow { line, ends: [(pair[0].1, a), (pair[1].1, b)] });
        }
    }

    /// True for points inside this part.
    fn holds(&self, p: Vec2) -> bool {
        self.outline.distance(p) >= self.distance - COINCIDENT_POINT_MM && self.border.contains(p)
    }

    /// True when the straight line stays in the region.
    fn is_clear(&self, from: Vec2, to: Vec2) -> bool {
        let path = OutlineElement::Line { from, to };
        if path.length() < MIN_ROW_MM {
            return true;
        }
        let separate = |p: &Vec2| p.distance(from) > MIN_ROW_MM && p.distance(to) > MIN_ROW_MM;
        let crossed = self
            .border
            .elements()
            .iter()
            .any(|element| element.crossings(&path, COINCIDENT_POINT_MM).iter().any(separate));
        let far =
            |t: f64| self.outline.distance(path.point(t)) >= self.distance - 2.0 * ON_BORDER_MM;
        !crossed && [0.25, 0.5, 0.75].into_iter().all(far) && self.holds_or_borders(path.point(0.5))
    }

    /// Inside, or on the border itself.
    fn holds_or_borders(&self, p: Vec2) -> bool {
        self.border.contains(p) || self.border.distance(p) < COINCIDENT_POINT_MM
    }

    /// Moves to the end of a row: straight if that stays inside, otherwise along the border.
    fn link(&self, steps: &mut Vec<Step>, place: f64, end: (f64, Vec2)) {
        let here = self.point(place);
        if self.is_clear(here, end.1) {
            self.go(steps, here, end.1);
        } else {
            self.walk_to(place, end.0, steps);
            self.go(steps, self.point(end.0), end.1);
        }
    }

    fn go(&self, steps: &mut Vec<Step>, from: Vec2, to: Vec2) {
        if from != to {
            steps.push(Step::Line { to });
        }
    }

    /// The length of the border, mm, negative when the outline was given clockwise.
    fn once_round(&self) -> f64 {
        if self.outline.was_clockwise() { -self.total() } else { self.total() }
    }

    fn total(&self) -> f64 {
        self.before[self.before.len() - 1]
    }

    /// The element at a position of the border (mm along it), and the fraction on it.
    fn locate(&self, place: f64) -> (usize, f64) {
        let place = place.clamp(0.0, self.total());
        let index = self.before.partition_point(|b| *b <= place).saturating_sub(1);
        let index = index.min(self.border.elements().len() - 1);
        let length = self.before[index + 1] - self.before[index];
        (index, if length > 0.0 { (place - self.before[index]) / length } else { 0.0 })
    }

    fn point(&self, place: f64) -> Vec2 {
        let (index, t) = self.locate(place);
        self.border.elements()[index].point(t)
    }

    /// The position on the border nearest to a point, mm along it.
    fn nearest_place(&self, p: Vec2) -> f64 {
        let mut best = (f64::INFINITY, 0.0);
        for (index, element) in self.border.elements().iter().enumerate() {
            let foot = match *element {
                OutlineElement::Line { .. } => element.fraction(p, 0.0),
                OutlineElement::Arc { center, .. } if center == p => Some(0.0),
                OutlineElement::Arc { .. } => element.fraction(p, 0.0),
            };
            for t in [Some(0.0), foot].into_iter().flatten() {
                let distance = element.point(t).distance(p);
                if distance < best.0 - COINCIDENT_POINT_MM {
                    best = (distance, self.before[index] + t * element.length());
                }
            }
        }
        best.1
    }

    /// Follows the border in the shorter direction.
    fn walk_to(&self, from: f64, to: f64, steps: &mut Vec<Step>) {
        let total = self.total();
        let ahead = (to - from).rem_euclid(total);
        if ahead <= 0.5 * total {
            self.walk(from, ahead, steps);
        } else {
            self.walk(from, ahead - total, steps);
        }
    }

    /// Follows the border by a signed length, mm.
    fn walk(&self, from: f64, by: f64, steps: &mut Vec<Step>) {
        let elements = self.border.elements();
        let (mut index, mut t) = self.locate(from);
        let mut rest = by.abs();
        // One full round passes every element once, and the first one twice.
        for _ in 0..=elements.len() + 1 {
            if rest <= COINCIDENT_POINT_MM {
                return;
            }
            let element = elements[index];
            let length = element.length();
            let ahead = if by > 0.0 { (1.0 - t) * length } else { t * length };
            let go = ahead.min(rest);
            let end = match (go == ahead, by > 0.0) {
                (true, true) => 1.0,
                (true, false) => 0.0,
                (false, true) => t + go / length,
                (false, false) => t - go / length,
            };
            if go > COINCIDENT_POINT_MM {
                let part = element.part(t.min(end), t.max(end));
                steps.push(step_of(&if by > 0.0 { part } else { part.reversed() }));
            }
            rest -= go;
            let count = elements.len();
            (index, t) = if by > 0.0 {
                ((index + 1) % count, 0.0)
            } else {
                ((index + count - 1) % count, 1.0)
            };
        }
    }
}

/// Links may run along the border itself, whose points are off by rounding, mm.
const ON_BORDER_MM: f64 = 1e-7;

fn step_of(element: &OutlineElement) -> Step {
    match *element {
        OutlineElement::Line { to, .. } => Step::Line { to },
        OutlineElement::Arc { to, center, sweep, .. } => Step::Arc { to, center, sweep },
    }
}
