//! The tool radii for which a contour can be cut without a gouge, and what limits them.

use chordal_geometry::{Circle2, Line2, Vec2, circle_circle, line_circle, line_line};

use super::material::PartContour;
use super::shape::{GougeCurve, angle_of, unit, within, wrapped};
use super::throat::ThroatWalls;
use super::tree::unwrapped_tangents;
use super::{CenterMove, Contour, GougeOptions, GougeRole, check_against};

/// There is no corner between lines that turn by less, rad.
const STRAIGHT_RAD: f64 = 1e-9;

/// How the tool goes round an outside corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutsideCornerRule {
    /// Along the extended offsets: one vertex, or two if the corner is acute.
    Linear,
    /// On an arc about the corner.
    Circular,
}

/// Why the radius cannot be larger.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitReason {
    /// There is no limit.
    Unlimited,
    /// The tool is inside an arc of this radius.
    InsideArc,
    /// A block between inside corners is too short: the offsets of its neighbours leave nothing of it.
    ShortBlock,
    /// Two opposite walls of the contour are twice this radius apart.
    Throat,
    /// A sharp inside corner, which no tool can cut completely.
    InsideCorner,
    /// The tool is inside a lead-in or lead-out arc of this radius.
    LeadArc,
    /// The lead-in has this length.
    LeadLength,
    /// The lead-in begins at this distance from the first wall: a larger tool would cut into it.
    LeadIntoWall,
}

/// The largest radius that one condition allows.
#[derive(Clone, Debug, PartialEq)]
pub struct RadiusLimit {
    /// The radius, mm; infinite without a limit.
    pub radius: f64,
    /// What limits it.
    pub reason: LimitReason,
    /// The tags of the blocks that limit it, in the order of the chain.
    pub blocks: Vec<u32>,
    /// The point where it is limited, mm.
    pub at: Vec2,
}

impl RadiusLimit {
    fn none() -> RadiusLimit {
        RadiusLimit {
            radius: f64::INFINITY,
            reason: LimitReason::Unlimited,
            blocks: Vec::new(),
            at: Vec2::ZERO,
        }
    }

    fn lower(&mut self, radius: f64, reason: LimitReason, blocks: &[u32], at: Vec2) {
        if radius < self.radius {
            *self = RadiusLimit { radius, reason, blocks: blocks.to_vec(), at };
        }
    }

    /// The smaller of two limits.
    #[must_use]
    pub fn min(self, o: RadiusLimit) -> RadiusLimit {
        if o.radius < self.radius { o } else { self }
    }
}

/// The arc that leads to the contour, and how close the line before it passes its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeadArc {
    /// The tag of its block.
    pub block: u32,
    /// Its radius, mm: for a tool of this radius, the arc of the tool centre shrinks to a point.
    pub radius: f64,
    /// The distance of its centre from the line before it, mm; `None` if no line is before it.
    pub line_distance: Option<f64>,
}

/// The tool radii for which a contour can be cut. The smallest is always zero: a tool that touches without cutting into
/// the part contains every smaller tool that touches at the same point.
#[derive(Clone, Debug)]
pub struct OffsetRange {
    /// Up to this radius no block of the part is cut into.
    pub no_gouge: RadiusLimit,
    /// Up to this radius every point of the part is also cut completely.
    pub every_edge: RadiusLimit,
    /// Up to this radius the leads are possible: their offset arcs keep a radius, their lines are long enough.
    pub leads: RadiusLimit,
    /// Up to this radius the lead-in does not cut into the first wall; zero or less if it always does.
    pub lead_clear: RadiusLimit,
    /// The lead arc with the smallest radius, if there is one.
    pub lead_arc: Option<LeadArc>,
    /// The smallest radius of each kind at which the contour or its leads change, mm, in ascending order. If the range
    /// may have gaps, [`intervals`] tests a radius between each two of them.
    pub events: Vec<f64>,
    /// The contour is one chain. If it is not, radii above an impossible one may be possible again: see [`intervals`].
    pub simple: bool,
    /// The search for opposite walls was completed within its budget.
    pub complete: bool,
}

impl OffsetRange {
    /// The smallest limit by gouges and by leads.
    #[must_use]
    pub fn largest(&self) -> RadiusLimit {
        self.no_gouge.clone().min(self.leads.clone())
    }
}

/// Finds the tool radii for which the contour has no gouge. The radius in `contour` is ignored.
#[must_use]
pub fn range(contour: &Contour, corners: OutsideCornerRule, options: &GougeOptions) -> OffsetRange {
    let material = PartContour::of(contour, options);
    let tangents = unwrapped_tangents(material.curves.iter());
    let side = contour.side.sign();
    let chain = ContourChain { material: &material, tangents: &tangents, side, corners, options };
    let arcs = chain.inside_arcs();
    let short = chain.short_blocks(arcs.radius);
    let known = arcs.radius.min(short.radius);
    let mut walls = ThroatWalls::new(&material, &tangents, side, options.budget);
    let throat = throat(&material, &mut walls, 2.0 * known);
    let (leads, lead_clear, lead_arc) = leads(contour, &material);
    let mut events: Vec<f64> =
        [&arcs, &short, &throat, &leads, &lead_clear].iter().map(|l| l.radius).collect();
    events.retain(|r| *r > 0.0 && r.is_finite());
    events.sort_by(f64::total_cmp);
    events.dedup();
    let no_gouge = arcs.clone().min(short).min(throat.clone());
    OffsetRange {
        every_edge: chain.inside_corners().min(no_gouge.clone()),
        no_gouge,
        leads,
        lead_clear,
        lead_arc,
        events,
        simple: !material.breaks.contains(&true),
        complete: walls.budget > 0,
    }
}

fn throat(material: &PartContour, walls: &mut ThroatWalls, limit: f64) -> RadiusLimit {
    let mut found = RadiusLimit::none();
    if material.curves.is_empty() {
        return found;
    }
    if let Some(throat) = walls.narrowest(limit) {
        let blocks = [material.tags[throat.first], material.tags[throat.second]];
        let middle = (throat.near.first + throat.near.second) * 0.5;
        found.lower(0.5 * throat.near.square.sqrt(), LimitReason::Throat, &blocks, middle);
    }
    found
}

/// The contour of the part with its tangents.
struct ContourChain<'a> {
    material: &'a PartContour,
    tangents: &'a [(f64, f64)],
    side: f64,
    corners: OutsideCornerRule,
    options: &'a GougeOptions,
}

impl ContourChain<'_> {
    fn neighbour_before(&self, k: usize) -> Option<usize> {
        match k {
            0 if self.material.is_closed() => Some(self.tangents.len() - 1),
            0 => None,
            _ if self.material.breaks[k] => None,
            _ => Some(k - 1),
        }
    }

    fn neighbour_after(&self, k: usize) -> Option<usize> {
        let next = if k + 1 < self.tangents.len() { k + 1 } else { 0 };
        self.neighbour_before(next).map(|_| next)
    }

    /// The turn towards the tool between two curves, rad: positive at an inside corner.
    fn inward(&self, before: usize, after: usize) -> f64 {
        self.side * wrapped(self.tangents[after].0 - self.tangents[before].1)
    }

    fn inside_arcs(&self) -> RadiusLimit {
        let mut limit = RadiusLimit::none();
        for (curve, tag) in self.material.curves.iter().zip(&self.material.tags) {
            if let GougeCurve::Arc { center, radius, sweep, .. } = *curve
                && sweep * self.side > 0.0
            {
                limit.lower(radius, LimitReason::InsideArc, &[*tag], center);
            }
        }
        limit
    }

    fn inside_corners(&self) -> RadiusLimit {
        let mut limit = RadiusLimit::none();
        for k in 0..self.tangents.len() {
            if let Some(before) = self.neighbour_before(k)
                && self.inward(before, k) > self.options.tangent
            {
                let blocks = [self.material.tags[before], self.material.tags[k]];
                limit.lower(
                    0.0,
                    LimitReason::InsideCorner,
                    &blocks,
                    self.material.curves[k].from(),
                );
                break;
            }
        }
        limit
    }

    fn short_blocks(&self, below: f64) -> RadiusLimit {
        let mut limit = RadiusLimit::none();
        for k in 0..self.tangents.len() {
            let (before, after) = (self.neighbour_before(k), self.neighbour_after(k));
            let starts = before.map_or(0.0, |b| self.inward(b, k));
            let ends = after.map_or(0.0, |a| self.inward(k, a));
            if starts <= STRAIGHT_RAD && ends <= STRAIGHT_RAD {
                continue;
            }
            let radius = self.vanishes(k, before, after, limit.radius.min(below));
            if radius < limit.radius {
                let mut blocks = vec![self.material.tags[k]];
                if let (Some(b), true) = (before, starts > STRAIGHT_RAD) {
                    blocks.insert(0, self.material.tags[b]);
                }
                if let (Some(a), true) = (after, ends > STRAIGHT_RAD) {
                    blocks.push(self.material.tags[a]);
                }
                let at = self.material.curves[k].at(0.5);
                limit.lower(radius, LimitReason::ShortBlock, &blocks, at);
            }
        }
        limit
    }

    /// The radius at which the offset of a block has no length left, mm; infinite if it is not below `below`.
    fn vanishes(&self, k: usize, before: Option<usize>, after: Option<usize>, below: f64) -> f64 {
        let is_line = |k: Option<usize>| {
            k.is_none_or(|k| matches!(self.material.curves[k], GougeCurve::Line { .. }))
        };
        if is_line(Some(k)) && is_line(before) && is_line(after) {
            let lost = before.map_or(0.0, |b| self.lost_per_radius(self.inward(b, k)))
                + after.map_or(0.0, |a| self.lost_per_radius(self.inward(k, a)));
            let length = self.material.curves[k].length();
            return if lost > 1e-12 { length / lost } else { f64::INFINITY };
        }
        let left = |r: f64| self.left_over(k, before, after, r);
        // A radius above every limit that can occur in practice.
        let mut high = below.min(1e3 * self.material.curves[k].length());
        if left(high) >= 0.0 {
            return f64::INFINITY;
        }
        let mut low = 0.0;
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if left(middle) >= 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }

    /// How much shorter a line gets at a corner per mm of radius; negative at an outside corner that makes it longer.
    fn lost_per_radius(&self, inward: f64) -> f64 {
        if inward.abs() <= STRAIGHT_RAD {
            0.0
        } else if inward > 0.0 {
            libm::tan(0.5 * inward)
        } else {
            match self.corners {
                OutsideCornerRule::Circular => 0.0,
                OutsideCornerRule::Linear => -libm::tan(-0.5 * inward).min(1.0),
            }
        }
    }

    /// What the corners at both ends leave of a block: a length in mm, or a sweep in rad.
    fn left_over(&self, k: usize, before: Option<usize>, after: Option<usize>, r: f64) -> f64 {
        let curve = &self.material.curves[k];
        let whole = match *curve {
            GougeCurve::Line { .. } => curve.length(),
            GougeCurve::Arc { sweep, .. } => sweep.abs(),
        };
        let at_start = before.map_or(Some(0.0), |b| {
            let turned = self.material.curves[b].reversed();
            self.lost(&curve.reversed(), &turned, self.inward(b, k), r, -self.side)
        });
        let at_end = after.map_or(Some(0.0), |a| {
            self.lost(curve, &self.material.curves[a], self.inward(k, a), r, self.side)
        });
        match (at_start, at_end) {
            (Some(start), Some(end)) => whole - start - end,
            _ => -1.0,
        }
    }

    /// What a block loses at the corner at its end, mm or rad; `None` if the offsets do not intersect.
    fn lost(
        &self,
        curve: &GougeCurve,
        next: &GougeCurve,
        inward: f64,
        r: f64,
        side: f64,
    ) -> Option<f64> {
        let of_lines = matches!((curve, next), (GougeCurve::Line { .. }, GougeCurve::Line { .. }));
        if of_lines || inward <= STRAIGHT_RAD {
            return match curve {
                GougeCurve::Line { .. } => Some(r * self.lost_per_radius(inward)),
                GougeCurve::Arc { .. } => Some(0.0),
            };
        }
        // At a tangent joint with an arc the offsets may miss each other only because of rounding.
        if inward <= self.options.tangent {
            return Some(0.0);
        }
        let meet = meeting(
            &offset_support(curve, side * r)?,
            &offset_support(next, side * r)?,
            curve.to(),
        )?;
        match *curve {
            GougeCurve::Line { from, to } => {
                let along = (to - from).normalized()?;
                Some((to - meet).dot(along))
            }
            GougeCurve::Arc { center, start, sweep, .. } => {
                let course = sweep.signum();
                let angle = angle_of(meet - center);
                // An intersection within its sweep shortens the arc; one outside leaves nothing of it.
                within(start, sweep, angle).then(|| {
                    wrapped((start + sweep - angle) * course).rem_euclid(core::f64::consts::TAU)
                })
            }
        }
    }
}

/// The line or circle on which an offset curve lies.
enum OffsetSupport {
    Line(Line2),
    Circle(Circle2),
}

fn offset_support(curve: &GougeCurve, signed: f64) -> Option<OffsetSupport> {
    Some(match *curve {
        GougeCurve::Line { from, to } => {
            let direction = (to - from).normalized()?;
            OffsetSupport::Line(Line2 { point: from + direction.turned_left() * signed, direction })
        }
        GougeCurve::Arc { center, radius, sweep, .. } => {
            let radius = radius - signed * sweep.signum();
            if radius < 0.0 {
                return None;
            }
            OffsetSupport::Circle(Circle2 { center, radius })
        }
    })
}

/// The intersection of two offsets that is nearest to the corner.
fn meeting(first: &OffsetSupport, second: &OffsetSupport, corner: Vec2) -> Option<Vec2> {
    let met = match (first, second) {
        (OffsetSupport::Line(a), OffsetSupport::Line(b)) => {
            return line_line(*a, *b, 0.0).map(|x| x.point);
        }
        (OffsetSupport::Line(line), OffsetSupport::Circle(circle))
        | (OffsetSupport::Circle(circle), OffsetSupport::Line(line)) => {
            line_circle(*line, *circle, 0.0)
        }
        (OffsetSupport::Circle(a), OffsetSupport::Circle(b)) => circle_circle(*a, *b, 0.0),
    };
    met.nearest_to(corner)
}

/// The limits by the blocks that are not part of the contour: by lead arcs and lead lengths, and by the distance from
/// the first wall. Also the smallest lead arc.
fn leads(contour: &Contour, material: &PartContour) -> (RadiusLimit, RadiusLimit, Option<LeadArc>) {
    let side = contour.side.sign();
    let mut leads = RadiusLimit::none();
    let mut clear = RadiusLimit::none();
    let mut lead_arc: Option<LeadArc> = None;
    for (k, block) in contour.blocks.iter().enumerate() {
        match (block.role, block.curve) {
            (GougeRole::Offset, GougeCurve::Arc { center, radius, sweep, .. })
                if sweep * side > 0.0 && !material.has(block.tag) =>
            {
                leads.lower(radius, LimitReason::LeadArc, &[block.tag], center);
                if lead_arc.is_none_or(|l| radius < l.radius) {
                    let line_distance = k
                        .checked_sub(1)
                        .and_then(|before| line_distance(&contour.blocks[before].curve, center));
                    lead_arc = Some(LeadArc { block: block.tag, radius, line_distance });
                }
            }
            (GougeRole::LeadIn, curve) => {
                let end = curve.to();
                leads.lower(curve.from().distance(end), LimitReason::LeadLength, &[block.tag], end);
                if let Some(next) = contour.blocks.get(k + 1)
                    && material.has(next.tag)
                {
                    let normal = unit(next.curve.tangent_angles().0).turned_left() * side;
                    let away = (curve.from() - end).dot(normal);
                    let blocks = [block.tag, next.tag];
                    clear.lower(away, LimitReason::LeadIntoWall, &blocks, end);
                }
            }
            _ => {}
        }
    }
    (leads, clear, lead_arc)
}

/// The distance of a point from the line of a block, mm; `None` for an arc.
fn line_distance(curve: &GougeCurve, p: Vec2) -> Option<f64> {
    let GougeCurve::Line { from, to } = *curve else { return None };
    Some((to - from).normalized()?.cross(p - from).abs())
}

/// An interval of radii in which a path was tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadiusInterval {
    /// The lower end, mm; the interval does not include it.
    pub from: f64,
    /// The upper end, mm; infinite for the last interval.
    pub to: f64,
    /// There is a path for these radii, and it has no gouges except at a lead.
    pub clear: bool,
}

/// Tries one radius between each two events, for contours where a radius above an impossible one may be possible again.
/// `path_of` returns the path of the tool centre for a radius in mm, or `None` if the control stops with an alarm.
pub fn intervals(
    contour: &Contour,
    events: &[f64],
    options: &GougeOptions,
    path_of: &mut dyn FnMut(f64) -> Option<Vec<CenterMove>>,
) -> Vec<RadiusInterval> {
    let material = PartContour::of(contour, options);
    let mut from = 0.0;
    let mut all: Vec<RadiusInterval> = Vec::new();
    for to in events.iter().copied().chain([f64::INFINITY]) {
        if to <= from {
            continue;
        }
        let radius = if to.is_finite() { 0.5 * (from + to) } else { 1.25 * from + options.epsilon };
        let clear = path_of(radius).is_some_and(|path| {
            let tried = Contour { radius, ..contour.clone() };
            let report = check_against(&material, &tried, &path, options);
            report.gouges.iter().all(|g| g.kind == super::GougeKind::AtLead)
        });
        match all.last_mut() {
            Some(last) if last.clear == clear => last.to = to,
            _ => all.push(RadiusInterval { from, to, clear }),
        }
        from = to;
    }
    all
}
