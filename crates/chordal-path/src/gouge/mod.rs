//! Finds where a tool would really cut into the programmed contour, and up to which radius it would not, by geometry
//! alone.
//!
//! This module is independent of the control. It takes the programmed blocks and the path of the tool centre as lines
//! and arcs in the compensation plane. The tool gouges where its centre comes nearer to the contour of the part than
//! its radius, anywhere on the path, including links and leads.

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

/// On which side of the programmed blocks the tool is, seen in their direction.
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

/// The role of a block in its contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GougeRole {
    /// Compensation starts in it: it brings the tool to the contour.
    LeadIn,
    /// It runs with compensation. [`PartContour::of`] finds which of these blocks bound the part.
    Offset,
    /// The user marked it as a boundary of the part; if there is one such block, no unmarked block is one.
    Part,
    /// It is no boundary here: a rapid, or the neighbour of this chain at another height.
    Passing,
    /// Compensation ends in it: it moves the tool away.
    LeadOut,
}

/// A programmed block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContourBlock {
    /// Its curve.
    pub curve: GougeCurve,
    /// A number that the caller gives the block. The search is faster if tags increase along the chain.
    pub tag: u32,
    /// Its role in the contour.
    pub role: GougeRole,
}

/// Programmed blocks between compensation on and off, in the order in which they run.
#[derive(Clone, Debug)]
pub struct Contour {
    /// The blocks.
    pub blocks: Vec<ContourBlock>,
    /// The side of the tool.
    pub side: ToolSide,
    /// The radius of the tool, mm.
    pub radius: f64,
}

/// A move of the tool centre. A link has the tag of the block before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CenterMove {
    /// Its curve.
    pub curve: GougeCurve,
    /// The tag of its block.
    pub tag: u32,
}

/// Tolerances and limits of the check.
#[derive(Clone, Copy, Debug)]
pub struct GougeOptions {
    /// A depth up to this is not a gouge, mm: the maximum of 2 µm, the largest difference between the start and end
    /// radius of an arc, and two least increments.
    pub epsilon: f64,
    /// Points nearer than this are one vertex, mm.
    pub vertex: f64,
    /// Turns smaller than this are tangent joints, rad.
    pub tangent: f64,
    /// The largest number of gouges that are reported.
    pub most: usize,
    /// The largest number of pairs of nodes and curves that the search compares before it ends incomplete.
    pub budget: u64,
}

impl Default for GougeOptions {
    fn default() -> Self {
        Self { epsilon: 0.002, vertex: 0.005, tangent: 0.02, most: 32, budget: 1_000_000_000 }
    }
}

/// Where a gouge is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GougeKind {
    /// In the contour of the part.
    Contour,
    /// Made by a lead, within a tool radius of an open end of the contour. Contours often begin and end outside of the
    /// part, where this cuts nothing.
    AtLead,
}

/// A point where the tool cuts into the contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gouge {
    /// How far the contour is inside the tool, mm; the radius if the tool centre crosses it.
    pub depth: f64,
    /// The tool centre, mm.
    pub center: Vec2,
    /// The point of the contour that is cut into deepest, mm.
    pub point: Vec2,
    /// The tag of the block that cuts.
    pub cutting: u32,
    /// The tag of the block that is cut into.
    pub cut: u32,
    /// Whether it is in the part or made by a lead at an open end.
    pub kind: GougeKind,
}

/// The result of the check.
#[derive(Clone, Debug, Default)]
pub struct GougeReport {
    /// The gouges, the deepest first. Gouges within a tool diameter of each other along path and contour are one. If
    /// there are more than requested, the deepest is among these, and the others are an arbitrary selection.
    pub gouges: Vec<Gouge>,
    /// There are more gouges than reported.
    pub more: bool,
    /// The search was completed within its budget, so there are no other gouges unless `more` is set.
    pub complete: bool,
    /// Pairs of tags of blocks that follow one curve in opposite directions.
    pub ambiguous: Vec<(u32, u32)>,
}

/// For a contour of at most this many blocks leads and walls are distinguished at once, which is cheaper than checking
/// twice.
const SMALL_CONTOUR_BLOCKS: usize = 64;

/// Checks the path of the tool centre against the contour of the part.
///
/// A long contour is checked first against all blocks that could be the part, which are cheap to find. Only if that
/// finds a gouge, leads and walls are distinguished block by block.
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
        // The first hit is somewhere in its gouge: this finds the deepest point of it.
        let deepest = match aim {
            SearchAim::Any => search.nearest(limit, &clusters, SearchAim::DeepestIn(around(&hit))),
            _ => Some(hit),
        };
        let hit = deepest.unwrap_or(hit);
        let found = gouge(&hit, material, contour, path);
        // A gouge of the lead at the open end of a slot may hide that the slot itself is too narrow, or that the lead
        // cuts the opposite wall.
        if found.kind == GougeKind::AtLead {
            for aim in [SearchAim::DeepestOfPart, SearchAim::DeepestOffEnds] {
                let Some(hit) = search.nearest(limit, &clusters, aim(around(&hit))) else {
                    continue;
                };
                report.gouges.push(gouge(&hit, material, contour, path));
                clusters.push(around(&hit));
            }
        }
        clusters.push(around(&hit));
        report.gouges.push(found);
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

/// The smallest clearance between tool and contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    /// The distance of the tool centre minus the radius, mm: negative for a gouge.
    pub clearance: f64,
    /// The tool centre, mm.
    pub center: Vec2,
    /// The tag of the block of the contour.
    pub block: u32,
}

/// The smallest clearance between tool and contour over the whole path; `None` without a path or a contour.
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
