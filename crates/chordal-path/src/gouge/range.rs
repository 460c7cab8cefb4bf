//! The radii for which a contour can be run without a gouge, and what limits them.

use chordal_geometry::{Circle2, Line2, Vec2, circle_circle, line_circle, line_line};

use super::material::PartContour;
use super::shape::{GougeCurve, angle_of, unit, within, wrapped};
use super::throat::ThroatWalls;
use super::tree::unwrapped_tangents;
use super::{CenterMove, Contour, GougeOptions, GougeRole, check_against};

/// Lines that turn by less have no corner between them, rad.
const STRAIGHT_RAD: f64 = 1e-9;

/// How the tool goes round an outside corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutsideCornerRule {
    /// Along the prolonged offsets: a vertex, or two where the corner is acute.
    Linear,
    /// On an arc about the corner.
    Circular,
}

/// What keeps the radius from being larger.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitReason {
    /// Nothing: every radius will do.
    Unlimited,
    /// An arc with the tool inside; the tool cannot be larger than it.
    InsideArc,
    /// A block between inside corners is used up by the offsets of its neighbours.
    ShortBlock,
    /// Two walls of the contour face each other at twice this radius.
    Throat,
    /// A sharp inside corner, which no tool touches to the bottom.
    InsideCorner,
    /// An arc that leads in or out with the tool inside it.
    LeadArc,
    /// The lead-in is a line of this length.
    LeadLength,
    /// The lead-in begins only so far away from the first wall: a larger tool cuts into it on
    /// the way.
    LeadIntoWall,
}

/// The largest radius that one condition allows.
#[derive(Clone, Debug, PartialEq)]
pub struct RadiusLimit {
    /// The radius, mm; infinite without a limit.
    pub radius: f64,
    /// Why.
    pub reason: LimitReason,
    /// The blocks that make it so, in the order of the chain.
    pub blocks: Vec<u32>,
    /// Where, mm.
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

    /// The stricter of two.
    #[must_use]
    pub fn min(self, o: RadiusLimit) -> RadiusLimit {
        if o.radius < self.radius { o } else { self }
    }
}

/// The arc that leads to the contour, and how near the lead line passes its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeadArc {
    /// The block.
    pub block: u32,
    /// Its radius, mm: the arc vanishes at this radius of the tool.
    pub radius: f64,
    /// Distance of its centre from the line that leads to it, mm, if a line does.
    pub line_distance: Option<f64>,
}

/// The radii for which a contour can be run.
#[derive(Clone, Debug)]
pub struct OffsetRange {
    /// Up to here no block of the part is cut into. Zero is the smallest radius: a disc that
    /// touches without cutting contains every smaller one that touches there.
    pub no_gouge: RadiusLimit,
    /// Up to here every point of the part is touched too.
    pub every_edge: RadiusLimit,
    /// Up to here the leads can be run: their arcs keep a radius, their lines are long enough.
    pub leads: RadiusLimit,
    /// Up to here the lead-in stays clear of the first wall; zero or less where it never does.
    pub lead_clear: RadiusLimit,
    /// The lead arc that limits, if one does.
    pub lead_arc: Option<LeadArc>,
    /// Every radius at which something of the contour or its leads changes, the least of each
    /// kind, in rising order: the places to test between where the range may have gaps.
    pub events: Vec<f64>,
    /// The contour is one chain. Otherwise radii above a forbidden one may be allowed again: see
    /// [`intervals`].
    pub simple: bool,
    /// The search for facing walls came to its end.
    pub complete: bool,
}

impl OffsetRange {
    /// The condition that limits first, gouges and leads together.
    #[must_use]
    pub fn largest(&self) -> RadiusLimit {
        self.no_gouge.clone().min(self.leads.clone())
    }
}

/// Finds the radii for which the contour has no gouge, from its own radius only the side.
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

/// The contour of the part with its turns.
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

    /// The turn between two curves towards the tool, rad: positive inside.
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

    /// The radius at which the offset of a block has no length left, if below `below`.
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
        // No inside corner of a finite contour takes more than this of a block.
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

    /// How much of a line is lost at a corner for each mm of radius; outside something is gained.
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

    /// What is left of a block in addition to the corners at both ends: a length, or a sweep in rad.
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

    /// What a block loses at its end to the next; `None` when the offsets do not meet.
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
        // The offsets of a tangent joint with an arc may miss each other by rounding alone.
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
                // Inside its own sweep the meeting point leaves the rest; beyond, nothing.
                within(start, sweep, angle).then(|| {
                    wrapped((start + sweep - angle) * course).rem_euclid(core::f64::consts::TAU)
                })
            }
        }
    }
}

/// The line or circle of an offset.
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

/// The meeting point of two offsets nearest to the corner.
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

/// What the blocks off the part allow: lead arcs and lengths, and the way past the first wall.
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

/// The distance of a point from the line that a block runs along.
fn line_distance(curve: &GougeCurve, p: Vec2) -> Option<f64> {
    let GougeCurve::Line { from, to } = *curve else { return None };
    Some((to - from).normalized()?.cross(p - from).abs())
}

/// A stretch of radii in which a path was tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadiusInterval {
    /// Above this radius, mm.
    pub from: f64,
    /// Up to this radius, mm; infinite for the last.
    pub to: f64,
    /// The path could be made and has no gouge but at a lead.
    pub clear: bool,
}

/// Tries a radius in every gap between events, for contours where a forbidden radius may be followed
/// by allowed ones. `path_of` makes the path of a radius in mm, or `None` when the control alarms.
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
