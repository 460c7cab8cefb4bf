//! The geometric truth of cutter compensation: where the tool would cut into the programmed
//! contour, and up to which radius it would not.
//!
//! Nothing here knows a control. The programmed blocks and the path of the tool centre come in as
//! lines and arcs of the compensation plane; the tool centre gouges where it comes nearer to the
//! contour of the part than its radius, anywhere on the whole path, links and leads included.

mod chain;
mod closing;
mod distance;
mod material;
mod nested;
mod open_chain;
mod outside;
mod range;
mod search;
mod shape;
mod throat;
mod tree;
mod walls;

use chordal_geometry::Vec2;

pub use distance::{NearestPair, nearest};
pub use material::PartContour;
pub use range::{
    LeadArc, LimitReason, OffsetRange, OutsideCornerRule, RadiusInterval, RadiusLimit, intervals,
    range,
};
use search::{GougeCluster, GougeHit, GougeSearch, SearchAim};
pub use shape::GougeCurve;

/// On which side of the programmed blocks the tool is, looking along them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToolSide {
    /// The tool is left of the contour (G41 with a positive offset).
    Left,
    /// The tool is right of the contour (G42 with a positive offset).
    Right,
}

impl ToolSide {
    /// +1 on the left, −1 on the right.
    #[must_use]
    pub fn sign(self) -> f64 {
        match self {
            ToolSide::Left => 1.0,
            ToolSide::Right => -1.0,
        }
    }
}

/// What a block is to its contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GougeRole {
    /// Turns compensation on: brings the tool to the contour.
    LeadIn,
    /// Runs in offset mode. Which of these bound the part is found by [`PartContour::of`].
    Offset,
    /// Bounds the part because the user says so; with one such mark nothing else does.
    Part,
    /// Bounds nothing here: a rapid, or the neighbour of this chain at another height.
    Passing,
    /// Turns compensation off: takes the tool away.
    LeadOut,
}

/// A programmed block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContourBlock {
    /// Its curve.
    pub curve: GougeCurve,
    /// The caller's number of the block. Tags that rise along the chain make the search fast.
    pub tag: u32,
    /// What it is to the contour.
    pub role: GougeRole,
}

/// Programmed blocks between compensation on and off, in the order they run.
#[derive(Clone, Debug)]
pub struct Contour {
    /// The blocks.
    pub blocks: Vec<ContourBlock>,
    /// The side of the tool.
    pub side: ToolSide,
    /// The radius of the tool, mm.
    pub radius: f64,
}

/// A move of the tool centre. Links belong to the block before them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CenterMove {
    /// Its curve.
    pub curve: GougeCurve,
    /// The tag of its block.
    pub tag: u32,
}

/// Tolerances and bounds of the check.
#[derive(Clone, Copy, Debug)]
pub struct GougeOptions {
    /// Depth that is not yet a gouge, mm: the largest of 2 µm, the largest difference of an arc's
    /// start and end radius, and two least increments.
    pub epsilon: f64,
    /// Points nearer than this are one vertex, mm.
    pub vertex: f64,
    /// Turns smaller than this are tangent joints, rad.
    pub tangent: f64,
    /// So many gouges are reported, the deepest first.
    pub most: usize,
    /// So many pairs of nodes and curves are looked at before the search gives up and says so.
    pub budget: u64,
}

impl Default for GougeOptions {
    fn default() -> Self {
        Self { epsilon: 0.002, vertex: 0.005, tangent: 0.02, most: 32, budget: 1_000_000_000 }
    }
}

/// Where a gouge is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GougeKind {
    /// Into the contour of the part.
    Contour,
    /// By a lead, within a tool radius of an open end of the contour. Programs often begin and end
    /// off the part, where this cuts nothing.
    AtLead,
}

/// A place where the tool cuts into the contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gouge {
    /// How far the contour lies inside the tool, mm; the whole radius where the centre crosses it.
    pub depth: f64,
    /// The tool centre, mm.
    pub center: Vec2,
    /// The point of the contour that is cut into deepest, mm.
    pub point: Vec2,
    /// The block that cuts.
    pub cutting: u32,
    /// The block that is cut into.
    pub cut: u32,
    /// Into the part, or at a lead only.
    pub kind: GougeKind,
}

/// What the check found.
#[derive(Clone, Debug, Default)]
pub struct GougeReport {
    /// The gouges, the deepest of all first. Those within a tool diameter of each other along path
    /// and contour are one. With more than were asked for, the others are any of them.
    pub gouges: Vec<Gouge>,
    /// There are more than were reported.
    pub more: bool,
    /// The budget sufficed: what is not reported is not there.
    pub complete: bool,
    /// Pairs of blocks that run along one curve in opposite directions.
    pub ambiguous: Vec<(u32, u32)>,
}

/// Of a contour of so few blocks leads are told from walls at once: to check it twice costs more.
const SMALL_CONTOUR_BLOCKS: usize = 64;

/// Checks the path of the tool centre against the contour of the part.
///
/// A long one first against all that could be the part, which costs little to know. Only what is found there
/// makes it worth while to tell leads from walls block by block.
#[must_use]
pub fn check(contour: &Contour, path: &[CenterMove], options: &GougeOptions) -> GougeReport {
    if contour.blocks.len() <= SMALL_CONTOUR_BLOCKS {
        return check_against(&PartContour::of(contour, options), contour, path, options);
    }
    let most = PartContour::at_most(contour, options);
    let report = check_against(&most, contour, path, options);
    if report.gouges.is_empty() && report.ambiguous.is_empty() {
        return report;
    }
    let material = PartContour::of(contour, options);
    if material.curves == most.curves {
        report
    } else {
        check_against(&material, contour, path, options)
    }
}

/// As [`check`], with the contour of the part already found.
#[must_use]
pub fn check_against(
    material: &PartContour,
    contour: &Contour,
    path: &[CenterMove],
    options: &GougeOptions,
) -> GougeReport {
    let mut report = GougeReport { ambiguous: material.ambiguous.clone(), ..Default::default() };
    let limit = contour.radius - options.epsilon;
    if limit <= 0.0 {
        report.complete = true;
        return report;
    }
    let mut search = GougeSearch::new(contour, material, path, options.epsilon, options.budget);
    let reach = 2.0 * contour.radius;
    let around = |hit: &GougeHit| GougeCluster::around(hit, path, &material.curves, reach);
    let mut clusters: Vec<GougeCluster> = Vec::new();
    let mut aim = SearchAim::Deepest;
    while let Some(hit) = search.nearest(limit, &clusters, aim) {
        if report.gouges.len() >= options.most {
            report.more = true;
            break;
        }
        // What was found first is somewhere in its gouge: the deepest place of it is looked for.
        let deepest = match aim {
            SearchAim::Any => search.nearest(limit, &clusters, SearchAim::DeepestIn(around(&hit))),
            _ => Some(hit),
        };
        let hit = deepest.unwrap_or(hit);
        let noted = gouge(&hit, material, contour, path);
        // The lead at the mouth of a slot may hide that the slot itself is too narrow, or that the lead cuts
        // its other wall.
        if noted.kind == GougeKind::AtLead {
            for aim in [SearchAim::DeepestOfPart, SearchAim::DeepestOffEnds] {
                let Some(hit) = search.nearest(limit, &clusters, aim(around(&hit))) else {
                    continue;
                };
                report.gouges.push(gouge(&hit, material, contour, path));
                clusters.push(around(&hit));
            }
        }
        clusters.push(around(&hit));
        report.gouges.push(noted);
        aim = SearchAim::Any;
    }
    report.gouges.sort_by(|a, b| b.depth.total_cmp(&a.depth));
    report.complete = search.budget > 0;
    report
}

fn gouge(hit: &GougeHit, material: &PartContour, contour: &Contour, path: &[CenterMove]) -> Gouge {
    let step = &path[hit.of_path];
    let point = hit.near.second;
    let by_lead = !material.has(step.tag);
    let at_end = material.open_ends.iter().any(|e| e.distance(point) <= contour.radius);
    Gouge {
        depth: contour.radius - hit.near.square.sqrt(),
        center: hit.near.first,
        point,
        cutting: step.tag,
        cut: material.tags[hit.of_contour],
        kind: if by_lead && at_end { GougeKind::AtLead } else { GougeKind::Contour },
    }
}

/// The nearest that the tool centre comes to the contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    /// Distance less the radius, mm: negative is the depth of a gouge.
    pub clearance: f64,
    /// The tool centre, mm.
    pub center: Vec2,
    /// The block of the contour.
    pub block: u32,
}

/// The least clearance between tool and contour over the whole path; none without path or contour.
#[must_use]
pub fn clearance(
    contour: &Contour,
    path: &[CenterMove],
    options: &GougeOptions,
) -> Option<Clearance> {
    let material = PartContour::of(contour, options);
    let mut search = GougeSearch::new(contour, &material, path, options.epsilon, options.budget);
    let hit = search.nearest(f64::INFINITY, &[], SearchAim::Clearance)?;
    Some(Clearance {
        clearance: hit.near.square.sqrt() - contour.radius,
        center: hit.near.first,
        block: material.tags[hit.of_contour],
    })
}
