//! Tools and their parts as solids of revolution with two ends.

use super::element::ConvexElement;
use crate::{CutterProfile, Ring, RingElement, Undercut};

/// Chords of a part of a torus that is not a whole quarter.
const ARC_CHORDS: u32 = 12;
/// Dimensions that differ by less than this are equal, mm.
const EQUAL_MM: f64 = 1e-9;
/// By how much neighbours overlap, so that no gap opens between them when they shrink, mm.
const OVERLAP_MM: f64 = 1.0;
/// The length of the longest part of a solid as a share of its diameter, and the least such length, mm. What is long
/// moves far when it turns.
const LONGEST_SHARE: f64 = 1.0;
const LEAST_LENGTH_MM: f64 = 4.0;

/// A solid of revolution about the axis of a tool: edges, shank, holder. Heights are above the tip, mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AxialSolid {
    elements: Vec<ConvexElement>,
}

/// A part of an outline: heights and radii of its ends.
#[derive(Clone, Copy, Debug)]
struct OutlineSection {
    heights: [f64; 2],
    radii: [f64; 2],
    /// By how much the true outline exceeds it, mm.
    swell: f64,
}

impl OutlineSection {
    fn slope(&self) -> f64 {
        (self.radii[1] - self.radii[0]) / self.length()
    }

    fn length(&self) -> f64 {
        self.heights[1] - self.heights[0]
    }

    fn radius_at(&self, height: f64) -> f64 {
        self.radii[0] + self.slope() * (height - self.heights[0])
    }
}

impl AxialSolid {
    /// The edges of a cutter up to a height, mm. A cutter whose edges end on its lower side ends there.
    pub fn of_cutter(cutter: &CutterProfile, end: f64) -> AxialSolid {
        let mut solid = AxialSolid::default();
        let mut outline = Vec::new();
        solid.add_side(cutter.rings(), end, &mut outline);
        let (side, radius) = (cutter.side(), cutter.radius());
        if end > side {
            outline.push(OutlineSection { heights: [side, end], radii: [radius; 2], swell: 0.0 });
        }
        cut_off(&mut outline, end);
        solid.add(&outline);
        solid
    }

    /// Undercuts, each with the height of its lower end above the tip, mm.
    pub fn of_undercuts(undercuts: &[(f64, Undercut)]) -> AxialSolid {
        let mut solid = AxialSolid::default();
        for (lift, undercut) in undercuts {
            let (height, radius) = (undercut.height(), undercut.radius());
            let is_ball = |side: &CutterProfile| match side.rings() {
                [Ring { element: RingElement::Torus { round, middle, .. }, .. }] => {
                    *middle == 0.0 && (round - radius).abs() < EQUAL_MM
                }
                _ => false,
            };
            if is_ball(undercut.lower())
                && is_ball(undercut.upper())
                && (height - 2.0 * radius).abs() < EQUAL_MM
            {
                solid.elements.push(ConvexElement::ball(lift + radius, radius, f64::INFINITY));
                continue;
            }
            let mut outline = chords(undercut.lower().rings());
            let (low, high) = (undercut.lower().side(), height - undercut.upper().side());
            if high > low {
                outline.push(OutlineSection {
                    heights: [low, high],
                    radii: [radius; 2],
                    swell: 0.0,
                });
            }
            let mirrored = chords(undercut.upper().rings()).into_iter().rev();
            outline.extend(mirrored.map(|part| OutlineSection {
                heights: [height - part.heights[1], height - part.heights[0]],
                radii: [part.radii[1], part.radii[0]],
                ..part
            }));
            for part in &mut outline {
                part.heights = part.heights.map(|at| at + lift);
            }
            solid.add(&outline);
        }
        solid
    }

    /// Stacked cylinders and cones from a height on, each as length, lower and upper diameter, mm.
    pub fn stack(height: f64, segments: &[[f64; 3]]) -> AxialSolid {
        let mut at = height;
        let mut outline = Vec::new();
        for &[length, lower, upper] in segments {
            let next = at + length.max(0.0);
            let radii = [0.5 * lower, 0.5 * upper];
            outline.push(OutlineSection { heights: [at, next], radii, swell: 0.0 });
            at = next;
        }
        let mut solid = AxialSolid::default();
        solid.add(&outline);
        solid
    }

    /// Whether there is nothing of it.
    pub fn is_empty(&self) -> bool {
        self.elements.is_empty()
    }

    /// The same solid higher above the tip, mm.
    #[must_use]
    pub fn raised(mut self, by: f64) -> AxialSolid {
        for element in &mut self.elements {
            element.reference += by;
        }
        self
    }

    /// Both solids together.
    #[must_use]
    pub fn and(mut self, other: AxialSolid) -> AxialSolid {
        self.elements.extend(other.elements);
        self
    }

    pub(crate) fn elements(&self) -> &[ConvexElement] {
        &self.elements
    }

    /// Adds the whole quarters of tori on the lower side of a cutter, and the rest of it to its outline.
    fn add_side(&mut self, rings: &[Ring], end: f64, outline: &mut Vec<OutlineSection>) {
        for ring in rings {
            let is_whole = match ring.element {
                RingElement::Torus { round, middle, .. } => {
                    (ring.from - middle).abs() < EQUAL_MM
                        && (ring.to - middle - round).abs() < EQUAL_MM
                }
                _ => false,
            };
            match ring.element {
                RingElement::Torus { height, round, middle } if is_whole => {
                    let center = height + round;
                    self.elements.push(match middle > EQUAL_MM {
                        true => ConvexElement::torus(center, middle, round, end),
                        false => ConvexElement::ball(center, round, end),
                    });
                }
                _ => outline.extend(chords(core::slice::from_ref(ring))),
            }
        }
    }

    /// Adds what is inside of an outline, from below.
    fn add(&mut self, outline: &[OutlineSection]) {
        let mut parts: Vec<OutlineSection> = Vec::new();
        for part in outline {
            let widest = part.radii[0].max(part.radii[1]);
            let right = part.length() > EQUAL_MM && widest > 0.0 && part.length().is_finite();
            if !right || part.radii.iter().any(|radius| *radius < 0.0 || radius.is_nan()) {
                continue;
            }
            let longest = (2.0 * LONGEST_SHARE * widest).max(LEAST_LENGTH_MM);
            let count = (part.length() / longest).ceil();
            let at = |n: f64| match n {
                _ if n == count => part.heights[1],
                _ => part.heights[0] + part.length() * n / count,
            };
            for n in 0..count as u32 {
                let heights = [at(f64::from(n)), at(f64::from(n + 1))];
                let radii = heights.map(|height| part.radius_at(height).max(0.0));
                parts.push(OutlineSection { heights, radii, ..*part });
            }
        }
        for (n, part) in parts.iter().enumerate() {
            let slope = part.slope();
            let mut rims = Vec::new();
            let joins = |a: &OutlineSection, b: &OutlineSection| {
                (a.heights[1] - b.heights[0]).abs() < EQUAL_MM
            };
            let below = n
                .checked_sub(1)
                .map(|at| &parts[at])
                .filter(|below| joins(below, part) && below.radii[1] >= part.radii[0] - EQUAL_MM);
            if let Some(below) = below {
                let width = OVERLAP_MM.min(0.5 * below.length());
                let height = part.heights[0] - width;
                let radius = below.radius_at(height).min(part.radii[0] - slope * width);
                if radius >= 0.0 {
                    rims.push([height, radius]);
                }
            }
            rims.extend([0, 1].map(|end| [part.heights[end], part.radii[end]]));
            let above = parts
                .get(n + 1)
                .filter(|above| joins(part, above) && above.radii[0] >= part.radii[1] - EQUAL_MM);
            if let Some(above) = above {
                let width = OVERLAP_MM.min(0.5 * above.length());
                let height = part.heights[1] + width;
                let radius = above.radius_at(height).min(part.radii[1] + slope * width);
                if radius >= 0.0 {
                    rims.push([height, radius]);
                }
            }
            self.elements.push(ConvexElement::chain(&rims, part.swell));
        }
    }
}

/// The sides of rings as straight parts inside of the solid; discs have none.
fn chords(rings: &[Ring]) -> Vec<OutlineSection> {
    let mut found = Vec::new();
    for ring in rings {
        let count = match ring.element {
            RingElement::Disc { .. } => continue,
            RingElement::Cone { .. } => 1,
            RingElement::Torus { .. } => ARC_CHORDS,
        };
        // Equal angles of an arc, equal radii otherwise.
        let angle = |radius: f64| match ring.element {
            RingElement::Torus { round, middle, .. } => {
                libm::asin(((radius - middle) / round).clamp(-1.0, 1.0))
            }
            _ => radius,
        };
        let (from, to) = (angle(ring.from), angle(ring.to));
        let place = |n: u32| {
            let share = f64::from(n) / f64::from(count);
            let at = from + share * (to - from);
            let radius = match ring.element {
                RingElement::Torus { round, middle, .. } => middle + round * libm::sin(at),
                _ => at,
            };
            let radius = match n {
                0 => ring.from,
                _ if n == count => ring.to,
                _ => radius.clamp(ring.from, ring.to),
            };
            [ring.height_at(radius), radius]
        };
        let swell = match ring.element {
            RingElement::Torus { round, .. } => {
                let half = 0.5 * (to - from).abs() / f64::from(count);
                round * (1.0 - libm::cos(half)) + EQUAL_MM
            }
            _ => 0.0,
        };
        for n in 0..count {
            let (low, high) = (place(n), place(n + 1));
            let (heights, radii) = ([low[0], high[0]], [low[1], high[1]]);
            found.push(OutlineSection { heights, radii, swell });
        }
    }
    found
}

/// Removes what is above a height.
fn cut_off(outline: &mut Vec<OutlineSection>, end: f64) {
    outline.retain(|part| part.heights[0] < end);
    for part in outline {
        if part.heights[1] > end {
            part.radii[1] = part.radius_at(end);
            part.heights[1] = end;
        }
    }
}
