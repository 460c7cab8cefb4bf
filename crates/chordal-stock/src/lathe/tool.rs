//! Lathe tools as outlines in the half plane.
//!
//! An outline is relative to the programmed point at z 0, r 0: z to the right, r up, the work below an outside tool.
//! It is a union of convex parts of lines and arcs, whose sweeps along lines and arcs are exact.

use core::f64::consts::{FRAC_PI_2, PI};

use chordal_geometry::Vec2;

use super::convex::ConvexOutline;
use super::polygon::triangles;
use super::region::RegionError;
use super::segment::OutlineSegment;

/// Most chords into which a concave arc is divided.
const MAX_CHORDS: f64 = 1024.0;

/// Why a tool's dimensions do not give an outline.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ToolError {
    /// A dimension is not above zero, or not finite.
    #[error("the {what} must be above zero, it is {value}")]
    NotPositive {
        /// What it is.
        what: &'static str,
        /// Its value, mm or rad.
        value: f64,
    },
    /// A dimension is too large for the others.
    #[error("the {what} is {value}; {most} is the most that fits")]
    TooLarge {
        /// What it is.
        what: &'static str,
        /// Its value, mm or rad.
        value: f64,
        /// The largest possible, mm or rad.
        most: f64,
    },
    /// A tip number is not between 0 and 9.
    #[error("tip directions are 0 to 9, not {0}")]
    Tip(u8),
    /// The outline crosses itself or encloses nothing.
    #[error("the outline of the tool crosses itself or encloses no area")]
    NotSimple,
    /// A segment of the outline is not valid.
    #[error(transparent)]
    Outline(#[from] RegionError),
}

/// The direction of the programmed point from the centre of the nose, as the tip number of the offset table, 0 to 9,
/// seen with z to the right and r up (Fanuc and Haas; LinuxCNC numbers with r mirrored).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tip(u8);

impl Tip {
    /// The tip direction with this number.
    pub fn new(number: u8) -> Result<Tip, ToolError> {
        if number <= 9 { Ok(Tip(number)) } else { Err(ToolError::Tip(number)) }
    }

    /// Its number.
    #[must_use]
    pub fn number(self) -> u8 {
        self.0
    }

    /// The vector from the programmed point to the centre of the nose, (z, r) in nose radii.
    #[must_use]
    pub fn to_center(self) -> Vec2 {
        let (z, r) = match self.0 {
            1 => (-1.0, -1.0),
            2 => (1.0, -1.0),
            3 => (1.0, 1.0),
            4 => (-1.0, 1.0),
            5 => (-1.0, 0.0),
            6 => (0.0, -1.0),
            7 => (1.0, 0.0),
            8 => (0.0, 1.0),
            _ => (0.0, 0.0),
        };
        Vec2::new(z, r)
    }
}

/// The cutting corner of an insert: a nose between two straight flanks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Insert {
    /// Radius of the nose, mm; zero is an ideal point.
    pub nose: f64,
    /// Which point is programmed.
    pub tip: Tip,
    /// Directions of the two flanks from the tip into the insert, rad from +z towards +r. The insert is between the
    /// first and the second, which is counter-clockwise from the first by less than half a turn.
    pub flanks: [f64; 2],
    /// Length of the flanks from the sharp tip, mm.
    pub length: f64,
    /// The shape between the ends of the flanks.
    pub shape: InsertShape,
}

/// The far side of an insert.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InsertShape {
    /// Parallels to both flanks: rhombic and square inserts.
    Parallelogram,
    /// A straight line: triangular inserts.
    Triangle,
}

/// The direction in which a blade's body extends from its front edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BladeFacing {
    /// Towards +r: it cuts from outside towards the axis.
    Outside,
    /// Towards the axis: it cuts in a bore.
    Inside,
    /// Towards +z: it cuts into a face towards −z.
    Face,
    /// Towards −z: it cuts into a face towards +z.
    BackFace,
}

/// Which point of a blade's front edge is programmed, along z (along r for a blade that cuts faces).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BladePoint {
    /// The corner at the lesser coordinate.
    Lower,
    /// The middle of the edge.
    Middle,
    /// The corner at the greater coordinate.
    Upper,
}

/// A tool for grooving or parting off: a front edge between two corners, and two parallel sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blade {
    /// Width, mm.
    pub width: f64,
    /// Radii of the corners at the lesser and the greater coordinate along the width, mm.
    pub corners: [f64; 2],
    /// Largest depth of cut, mm.
    pub length: f64,
    /// Lead angle of the front edge, rad: the end at the greater coordinate is set back by width·tan(lead).
    pub lead: f64,
    /// The direction in which the body extends.
    pub facing: BladeFacing,
    /// Which point is programmed along the width. Across it, the foremost point of the front edge is programmed.
    pub point: BladePoint,
}

/// The outline of a tool or a holder.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolOutline {
    parts: Vec<ConvexOutline>,
    bound: f64,
}

impl Insert {
    /// An insert as mounted in a holder. `approach` is the angle (rad) between the main cutting edge and the feed
    /// along z, κ of ISO 3002 (95° for a PCLNL holder: the edge leans back from a shoulder by 5°); `included` is the
    /// corner angle (rad, 80° for a CNMG). Tips 3 and 4 cut from outside towards −z and +z, tips 2 and 1 in a bore.
    pub fn mounted(
        tip: Tip,
        nose: f64,
        approach: f64,
        included: f64,
        length: f64,
    ) -> Result<Insert, ToolError> {
        let most = 3.0 * FRAC_PI_2;
        if !(approach > 0.0 && approach + included <= most) {
            return Err(ToolError::TooLarge { what: "approach angle", value: approach, most });
        }
        let (main, minor) = (PI - approach, PI - approach - included);
        let flanks = match tip.number() {
            3 => [minor, main],
            4 => [PI - main, PI - minor],
            2 => [-main, -minor],
            1 => [PI + minor, PI + main],
            _ => return Err(ToolError::Tip(tip.number())),
        };
        let shape = InsertShape::Parallelogram;
        Ok(Insert { nose, tip, flanks, length, shape })
    }

    /// The ideal point that worked examples and drawings of cycles use: the tool fills the quadrant behind the
    /// programmed point that belongs to its tip (1 to 4), up to `length` (mm).
    pub fn ideal_point(tip: Tip, length: f64) -> Result<Insert, ToolError> {
        let quadrant = match tip.number() {
            3 => 0.0,
            4 => 1.0,
            1 => 2.0,
            2 => 3.0,
            number => return Err(ToolError::Tip(number)),
        };
        let first = quadrant * FRAC_PI_2;
        let shape = InsertShape::Parallelogram;
        Ok(Insert { nose: 0.0, tip, flanks: [first, first + FRAC_PI_2], length, shape })
    }

    /// Its outline.
    pub fn outline(&self) -> Result<ToolOutline, ToolError> {
        let [first, second] = self.flanks;
        let included = second - first;
        let (nose, length) =
            (not_negative("nose radius", self.nose)?, positive("length", self.length)?);
        if positive("included angle", included)? >= PI {
            return Err(ToolError::TooLarge { what: "included angle", value: included, most: PI });
        }
        let [a, b] = self.flanks.map(unit);
        // Distance from the sharp tip to the start of the nose.
        let tangent = nose / libm::tan(0.5 * included);
        if tangent >= length {
            let most = length * libm::tan(0.5 * included);
            return Err(ToolError::TooLarge { what: "nose radius", value: nose, most });
        }
        let center = a * tangent + a.turned_left() * nose;
        let mut outline = vec![OutlineSegment::line(a * tangent, a * length)];
        let corners = match self.shape {
            InsertShape::Parallelogram => vec![a * length, (a + b) * length, b * length],
            InsertShape::Triangle => vec![a * length, b * length],
        };
        outline.extend(corners.windows(2).map(|two| OutlineSegment::line(two[0], two[1])));
        outline.push(OutlineSegment::line(b * length, b * tangent));
        if nose > 0.0 {
            outline.push(OutlineSegment::arc(b * tangent, a * tangent, center, true));
        }
        // The tip number gives the programmed point relative to the centre.
        let point = center - self.tip.to_center() * nose;
        ToolOutline::convex(&outline, -point)
    }
}

impl Blade {
    /// Its outline.
    pub fn outline(&self) -> Result<ToolOutline, ToolError> {
        let (width, length) = (positive("width", self.width)?, positive("length", self.length)?);
        let [lower, upper] = self.corners;
        not_negative("corner radius", lower)?;
        not_negative("corner radius", upper)?;
        let lean = self.lead;
        if lean.is_nan() || lean.abs() >= FRAC_PI_2 {
            return Err(ToolError::TooLarge { what: "lead", value: lean, most: FRAC_PI_2 });
        }
        let rise = width * libm::tan(lean);
        // Coordinates: along the width from 0, and from the front into the body.
        let (front_lower, front_upper) = (Vec2::new(0.0, 0.0), Vec2::new(width, rise));
        let along = unit(lean);
        // Distance of the corner arcs' ends from the sharp corners, along the front edge and the sides.
        let reach = |radius: f64, angle: f64| radius / libm::tan(0.5 * angle);
        let tangents = [reach(lower, FRAC_PI_2 - lean), reach(upper, FRAC_PI_2 + lean)];
        let front = front_lower.distance(front_upper);
        if tangents[0] + tangents[1] > front * (1.0 + f64::EPSILON * 8.0) {
            let (value, most) = (lower + upper, width);
            return Err(ToolError::TooLarge { what: "sum of corner radii", value, most });
        }
        if tangents[0] >= length || tangents[1] >= length - rise {
            let (value, most) = (lower.max(upper), length);
            return Err(ToolError::TooLarge { what: "corner radius", value, most });
        }
        let up = Vec2::new(0.0, 1.0);
        let centers = [Vec2::new(lower, tangents[0]), Vec2::new(width - upper, rise + tangents[1])];
        let (from, to) = (front_lower + along * tangents[0], front_upper - along * tangents[1]);
        let sides = [front_lower + up * tangents[0], front_upper + up * tangents[1]];
        let top = [Vec2::new(width, length), Vec2::new(0.0, length)];
        let mut outline = Vec::new();
        if from.distance(to) > width * 1e-12 {
            outline.push(OutlineSegment::line(from, to));
        }
        if upper > 0.0 {
            outline.push(OutlineSegment::arc(to, sides[1], centers[1], true));
        }
        outline.push(OutlineSegment::line(sides[1], top[0]));
        outline.push(OutlineSegment::line(top[0], top[1]));
        outline.push(OutlineSegment::line(top[1], sides[0]));
        if lower > 0.0 {
            outline.push(OutlineSegment::arc(sides[0], from, centers[0], true));
        }
        let at = match self.point {
            BladePoint::Lower => 0.0,
            BladePoint::Middle => 0.5 * width,
            BladePoint::Upper => width,
        };
        // The programmed point is at the foremost height, as the tool is touched off.
        let foremost = if lean >= 0.0 { centers[0].b - lower } else { centers[1].b - upper };
        let point = Vec2::new(at, foremost);
        let placed: Vec<OutlineSegment> =
            outline.iter().map(|segment| faced(segment, point, self.facing)).collect();
        let placed = match self.facing {
            BladeFacing::Outside | BladeFacing::BackFace => placed,
            // Mirrored, so the sense is reversed.
            BladeFacing::Inside | BladeFacing::Face => turned_round(&placed),
        };
        ToolOutline::convex(&placed, Vec2::ZERO)
    }
}

impl ToolOutline {
    /// A round insert of this radius, mm; `tip` says which point is programmed.
    pub fn round(radius: f64, tip: Tip) -> Result<ToolOutline, ToolError> {
        positive("radius", radius)?;
        let right = Vec2::new(radius, 0.0);
        let circle = OutlineSegment::arc(right, right, Vec2::ZERO, true);
        ToolOutline::convex(&[circle], tip.to_center() * radius)
    }

    /// A drill on the axis that cuts towards −z, with its diameter (mm), point angle (rad, π is flat) and length
    /// (mm). The tip at r 0 is programmed.
    pub fn drill(diameter: f64, point_angle: f64, length: f64) -> Result<ToolOutline, ToolError> {
        let (diameter, length) = (positive("diameter", diameter)?, positive("length", length)?);
        if positive("point angle", point_angle)? > PI {
            return Err(ToolError::TooLarge { what: "point angle", value: point_angle, most: PI });
        }
        let radius = 0.5 * diameter;
        let flat = point_angle == PI;
        let cone = if flat { 0.0 } else { radius / libm::tan(0.5 * point_angle) };
        if cone >= length {
            return Err(ToolError::TooLarge {
                what: "height of the point",
                value: cone,
                most: length,
            });
        }
        let corners = [(0.0, 0.0), (length, 0.0), (length, radius), (cone, radius)].map(Vec2::from);
        ToolOutline::polygon(&corners)
    }

    /// A polygon in either sense: a holder, a bar, a simple form.
    pub fn polygon(corners: &[Vec2]) -> Result<ToolOutline, ToolError> {
        let count = corners.len();
        let sides: Vec<OutlineSegment> = (0..count)
            .map(|at| OutlineSegment::line(corners[at], corners[(at + 1) % count]))
            .collect();
        ToolOutline::form(&sides, 1.0)
    }

    /// Any closed outline in either sense: a form tool. Convex arcs of up to half a turn are exact; concave arcs
    /// become chords on the side of the work within `chord_error` (mm), and [`bound`](Self::bound) gives their
    /// deviation.
    pub fn form(outline: &[OutlineSegment], chord_error: f64) -> Result<ToolOutline, ToolError> {
        positive("chord error", chord_error)?;
        for side in [outline.to_vec(), turned_round(outline)] {
            if let Some(convex) = ConvexOutline::of(&side)? {
                return Ok(ToolOutline { parts: vec![convex], bound: 0.0 });
            }
        }
        let clockwise = signed_area(outline) < 0.0;
        let outline = if clockwise { turned_round(outline) } else { outline.to_vec() };
        let (mut parts, mut corners, mut bound) = (Vec::new(), Vec::new(), 0.0_f64);
        for segment in &outline {
            corners.push(segment.start);
            let Some(bend) = segment.bend else { continue };
            let sweep = segment.sweep().abs();
            let (pieces, off) = match bend.counterclockwise {
                // Quarter turns, so that the polygon of chords does not meet other sides.
                true => ((sweep / FRAC_PI_2).ceil().max(1.0), 0.0),
                false => chords(sweep, bend.radius, chord_error),
            };
            bound = bound.max(off);
            let mut from = segment.start;
            for piece in 1..=pieces as u32 {
                let last = f64::from(piece) == pieces;
                let part = f64::from(piece) / pieces * segment.sweep();
                let to = if last { segment.end } else { turned(segment.start, bend.center, part) };
                if bend.counterclockwise {
                    let arc = OutlineSegment::arc(from, to, bend.center, true);
                    let cap = ConvexOutline::of(&[arc, OutlineSegment::line(to, from)])?;
                    parts.push(cap.ok_or(ToolError::NotSimple)?);
                }
                if !last {
                    corners.push(to);
                }
                from = to;
            }
        }
        for triangle in triangles(&corners).ok_or(ToolError::NotSimple)? {
            let sides =
                [0, 1, 2].map(|at| OutlineSegment::line(triangle[at], triangle[(at + 1) % 3]));
            parts.extend(ConvexOutline::of(&sides)?);
        }
        Ok(ToolOutline { parts, bound })
    }

    fn convex(outline: &[OutlineSegment], by: Vec2) -> Result<ToolOutline, ToolError> {
        let convex = ConvexOutline::of(outline)?.ok_or(ToolError::NotSimple)?;
        Ok(ToolOutline { parts: vec![convex.moved(by)], bound: 0.0 })
    }

    /// Both outlines as one tool.
    #[must_use]
    pub fn with(mut self, other: &ToolOutline) -> ToolOutline {
        self.parts.extend(other.parts.iter().cloned());
        self.bound = self.bound.max(other.bound);
        self
    }

    /// The outline moved by (z, r), mm, as for another programmed point.
    #[must_use]
    pub fn moved(self, by: Vec2) -> ToolOutline {
        ToolOutline { parts: self.parts.into_iter().map(|part| part.moved(by)).collect(), ..self }
    }

    /// Mirrored along the axis, for a second spindle.
    pub fn mirrored(&self) -> Result<ToolOutline, ToolError> {
        self.flipped(true)
    }

    /// Mirrored at the axis, for a tool at negative diameters.
    pub fn across(&self) -> Result<ToolOutline, ToolError> {
        self.flipped(false)
    }

    fn flipped(&self, along_axis: bool) -> Result<ToolOutline, ToolError> {
        let parts: Option<Vec<ConvexOutline>> =
            self.parts.iter().map(|part| part.mirrored(along_axis)).collect();
        Ok(ToolOutline { parts: parts.ok_or(ToolError::NotSimple)?, bound: self.bound })
    }

    /// Largest deviation of the outline from the given one, mm; 0 where it is exact.
    #[must_use]
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// The outlines of the convex parts.
    #[must_use]
    pub fn outlines(&self) -> Vec<Vec<OutlineSegment>> {
        self.parts.iter().map(ConvexOutline::outline).collect()
    }

    pub(crate) fn parts(&self) -> &[ConvexOutline] {
        &self.parts
    }
}

fn unit(angle: f64) -> Vec2 {
    // Exact along the axes, where most edges are.
    let quarters = angle / FRAC_PI_2;
    let whole = libm::round(quarters);
    if (quarters - whole).abs() < 1e-14 {
        let axes = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        return Vec2::from(axes[whole.rem_euclid(4.0) as usize % 4]);
    }
    let (sin, cos) = libm::sincos(angle);
    Vec2::new(cos, sin)
}

fn positive(what: &'static str, value: f64) -> Result<f64, ToolError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(ToolError::NotPositive { what, value })
    }
}

fn not_negative(what: &'static str, value: f64) -> Result<f64, ToolError> {
    if value == 0.0 { Ok(value) } else { positive(what, value) }
}

/// Transforms a segment of a blade, drawn with its body up, to its facing and its programmed point.
fn faced(segment: &OutlineSegment, point: Vec2, facing: BladeFacing) -> OutlineSegment {
    let place = |p: Vec2| {
        let p = p - point;
        match facing {
            BladeFacing::Outside => p,
            BladeFacing::Inside => Vec2::new(p.a, -p.b),
            BladeFacing::Face => Vec2::new(p.b, p.a),
            BladeFacing::BackFace => Vec2::new(-p.b, p.a),
        }
    };
    let mirrored = matches!(facing, BladeFacing::Inside | BladeFacing::Face);
    match segment.bend {
        None => OutlineSegment::line(place(segment.start), place(segment.end)),
        Some(bend) => {
            let sense = bend.counterclockwise != mirrored;
            OutlineSegment::arc(place(segment.start), place(segment.end), place(bend.center), sense)
        }
    }
}

/// The outline in the opposite sense.
fn turned_round(outline: &[OutlineSegment]) -> Vec<OutlineSegment> {
    let back = |segment: &OutlineSegment| match segment.bend {
        None => OutlineSegment::line(segment.end, segment.start),
        Some(bend) => {
            OutlineSegment::arc(segment.end, segment.start, bend.center, !bend.counterclockwise)
        }
    };
    outline.iter().rev().map(back).collect()
}

/// Twice the signed area within an outline.
fn signed_area(outline: &[OutlineSegment]) -> f64 {
    let part = |segment: &OutlineSegment| {
        let bulge = segment.bend.map_or(0.0, |bend| {
            let sweep = segment.sweep();
            bend.radius * bend.radius * (sweep - libm::sin(sweep))
        });
        segment.start.cross(segment.end) + bulge
    };
    outline.iter().map(part).sum()
}

/// The number of chords of an arc, and their largest distance from it, mm.
fn chords(sweep: f64, radius: f64, error: f64) -> (f64, f64) {
    let off = |pieces: f64| radius * (1.0 - libm::cos(0.5 * sweep / pieces));
    // The sagitta r(1 − cos φ) is at most rφ²/2, with φ half the angle of a chord.
    let pieces = (0.5 * sweep * (0.5 * radius / error).sqrt()).ceil().max(sweep / FRAC_PI_2).ceil();
    let pieces = pieces.clamp(1.0, MAX_CHORDS);
    (pieces, off(pieces))
}

fn turned(p: Vec2, center: Vec2, angle: f64) -> Vec2 {
    let (sin, cos) = libm::sincos(angle);
    let to = p - center;
    center + to * cos + to.turned_left() * sin
}
