//! The tools of a machine as bodies that turn: what cuts, and what must not touch.

use std::collections::BTreeMap;

use chordal_machine::{Cutter as Shape, HolderSegment, Tool, ToolShape};
use chordal_stock::{CutterError, CutterProfile, Undercut};

use super::inside::{CutterDimensions, InnerCutter};
use super::teeth::{ThreadMillTeeth, core};
use crate::job::Job;
use crate::tool_comments::known_tools;

/// A shank of which only the diameter is known has no end below this height, mm.
const UNKNOWN_SHANK_MM: f64 = 1000.0;

/// A tool as a body.
#[derive(Clone, Debug)]
pub(super) struct ToolBody {
    pub cutter: CutterProfile,
    /// What it surely removes, where that is less than it may: the core of a tap, whose groove winds nobody knows how.
    pub core: Option<CutterProfile>,
    /// What cuts instead of it where it is only the hull of edges above its widest place: each with the height of
    /// its lower end above the tip, mm.
    pub undercuts: Vec<(f64, Undercut)>,
    dimensions: CutterDimensions,
    /// A drill whose point angle nobody gives.
    pub has_assumed_point_angle: bool,
    /// Pieces above the edges, the lowest first, each with its height above the tip, mm.
    pub shank: Vec<ShankPiece>,
    pub holder: Vec<ShankPiece>,
}

impl ToolBody {
    /// What lies everywhere at least `depth` inside of the cutter, mm; `None` where nothing does, or it is not known.
    pub fn inside(&self, depth: f64) -> Option<InnerCutter> {
        self.dimensions.inside(depth)
    }

    /// What it surely removes.
    pub fn removes(&self) -> &CutterProfile {
        self.core.as_ref().unwrap_or(&self.cutter)
    }

    /// The highest known place of cutter, shank and holder above the tip, mm.
    pub fn top(&self) -> f64 {
        let ends = self.shank.iter().chain(&self.holder).map(|piece| piece.from + piece.height);
        ends.fold(self.cutter.flutes().unwrap_or(UNKNOWN_SHANK_MM), f64::max)
    }

    /// Nowhere it is narrower than below. Above the edges it counts as wide as they are: what is there is asked as a
    /// cut that is deeper than the edges are long.
    pub fn widens(&self) -> bool {
        let edges = 2.0 * self.cutter.radius();
        let mut widest = edges;
        self.undercuts.is_empty()
            && self.shank.iter().chain(&self.holder).all(|piece| {
                let (lower, upper) = (piece.lower.max(edges), piece.upper.max(edges));
                let goes_on = lower >= widest && upper >= lower;
                widest = upper;
                goes_on
            })
    }

    /// The largest radius of all, mm.
    pub fn radius(&self) -> f64 {
        let pieces = self.shank.iter().chain(&self.holder);
        pieces.fold(self.cutter.radius(), |most, piece| {
            most.max(piece.lower / 2.0).max(piece.upper / 2.0)
        })
    }
}

/// A cylinder or cone above the edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ShankPiece {
    /// Its lower end above the tip, mm.
    pub from: f64,
    pub height: f64,
    /// The diameters at its lower and its upper end, mm.
    pub lower: f64,
    pub upper: f64,
}

/// Why a tool has no body.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum NoBody {
    /// No machine file and no comment says what it is.
    Unknown,
    /// A shape without all of its dimensions.
    Incomplete(ToolShape, Vec<&'static str>),
    /// A shape that cuts no stock on a mill.
    Turning,
    /// Dimensions that do not fit each other.
    Wrong(CutterError),
}

impl NoBody {
    pub fn why(&self) -> String {
        match self {
            NoBody::Unknown => "its shape is not known".to_string(),
            NoBody::Incomplete(shape, missing) => lacking(*shape, missing),
            NoBody::Turning => "it is a turning tool".to_string(),
            NoBody::Wrong(error) => error.to_string(),
        }
    }
}

/// Which dimensions a tool lacks, by their keys.
pub(super) fn lacking(shape: ToolShape, missing: &[&str]) -> String {
    let keys: Vec<String> = missing.iter().map(|key| format!("`{key}`")).collect();
    format!("a tool of the shape `{}` needs {}", shape.as_str(), keys.join(" and "))
}

/// The tools that a program may use, by number.
pub(super) fn tools_of(job: &Job) -> BTreeMap<u32, Result<ToolBody, NoBody>> {
    known_tools(job).into_iter().map(|(number, known)| (number, body_of(&known.tool))).collect()
}

fn body_of(tool: &Tool) -> Result<ToolBody, NoBody> {
    let shape = tool.shape.ok_or(NoBody::Unknown)?;
    let lacks = || NoBody::Incomplete(shape, tool.missing_dimensions());
    let edges = edges_of(tool.cutter().ok_or_else(lacks)?)?;
    // Where the edges end is not known: neither is where the shank begins.
    let flutes = match edges.top {
        Some(top) => Some(tool.flute_length_mm.map_or(top, |flutes| flutes.max(top))),
        None => tool.flute_length_mm,
    };
    let CuttingEdges { cutter, undercuts, dimensions, top, neck } = edges;
    let cutter = cutter.with_flutes(flutes);
    let core = dimensions.core().map(|cutter| cutter.with_flutes(flutes));
    let mut body = ToolBody {
        cutter,
        core,
        undercuts,
        dimensions,
        has_assumed_point_angle: tool.has_assumed_point_angle(),
        shank: Vec::new(),
        holder: Vec::new(),
    };
    let Some(flutes) = flutes else { return Ok(body) };
    let mut at = flutes;
    body.shank = stacked(&tool.shank, &mut at);
    if let (true, Some(diameter)) = (body.shank.is_empty(), tool.shank_diameter_mm) {
        let height = if tool.holder.is_empty() { UNKNOWN_SHANK_MM } else { 0.0 };
        body.shank.push(ShankPiece { from: at, height, lower: diameter, upper: diameter });
        at += height;
    }
    if let Some(from) = top.filter(|top| *top < flutes) {
        // The neck between undercuts and shank.
        let neck = ShankPiece { from, height: flutes - from, lower: neck, upper: neck };
        body.shank.insert(0, neck);
    }
    body.holder = stacked(&tool.holder, &mut at);
    Ok(body)
}

/// What cuts.
struct CuttingEdges {
    cutter: CutterProfile,
    undercuts: Vec<(f64, Undercut)>,
    dimensions: CutterDimensions,
    /// How far up they reach, where the shape says it, mm.
    top: Option<f64>,
    /// The diameter of what bears undercuts, mm.
    neck: f64,
}

fn edges_of(shape: Shape<'_>) -> Result<CuttingEdges, NoBody> {
    let known = |dimensions: CutterDimensions| {
        let cutter = dimensions.cutter()?;
        Ok(CuttingEdges { cutter, undercuts: Vec::new(), dimensions, top: None, neck: 0.0 })
    };
    let found: Result<CuttingEdges, CutterError> = match shape {
        Shape::Flat { diameter_mm } => known(CutterDimensions::Flat { diameter: diameter_mm }),
        Shape::Ball { diameter_mm } => known(CutterDimensions::Ball { diameter: diameter_mm }),
        Shape::Bull { diameter_mm, corner_radius_mm } => {
            known(CutterDimensions::Bull { diameter: diameter_mm, corner: corner_radius_mm })
        }
        Shape::Chamfer { diameter_mm, tip_diameter_mm: tip, point_angle_rad: angle } => {
            known(CutterDimensions::Pointed { diameter: diameter_mm, tip, angle })
        }
        Shape::Drill { diameter_mm, point_angle_rad: angle } => {
            known(CutterDimensions::Pointed { diameter: diameter_mm, tip: 0.0, angle })
        }
        Shape::Tap { diameter_mm, pitch_mm } => {
            known(CutterDimensions::Tap { diameter: diameter_mm, pitch: pitch_mm })
        }
        Shape::ThreadMill { diameter_mm, pitch_mm, teeth } => threads(diameter_mm, pitch_mm, teeth),
        Shape::TSlot { diameter_mm, thickness_mm, neck_mm } => {
            let disc = Undercut::t_slot(diameter_mm, thickness_mm, neck_mm);
            let dimensions =
                CutterDimensions::Disc { diameter: diameter_mm, thickness: thickness_mm };
            disc.and_then(|disc| below(dimensions, disc))
        }
        Shape::Lollipop { diameter_mm, neck_mm } => {
            let ball = Undercut::lollipop(diameter_mm, neck_mm);
            ball.and_then(|ball| below(CutterDimensions::Lollipop { diameter: diameter_mm }, ball))
        }
        Shape::Form { profile } => known(CutterDimensions::Outline(profile.to_vec())),
        Shape::Insert { .. } | Shape::Groove { .. } => return Err(NoBody::Turning),
    };
    found.map_err(NoBody::Wrong)
}

/// One undercut with its dimensions.
fn below(dimensions: CutterDimensions, undercut: Undercut) -> Result<CuttingEdges, CutterError> {
    let (top, neck) = (Some(undercut.height()), undercut.neck());
    let cutter = dimensions.cutter()?;
    Ok(CuttingEdges { cutter, undercuts: vec![(0.0, undercut)], dimensions, top, neck })
}

/// Teeth above each other, with the core that bears them.
fn threads(diameter: f64, pitch: f64, teeth: u32) -> Result<CuttingEdges, CutterError> {
    let ThreadMillTeeth { undercuts, top, .. } = ThreadMillTeeth::new(diameter, pitch, teeth)?;
    let dimensions = CutterDimensions::Threads { diameter, pitch, teeth };
    let (cutter, neck) = (dimensions.cutter()?, core(diameter, pitch));
    Ok(CuttingEdges { cutter, undercuts, dimensions, top: Some(top), neck })
}

fn stacked(solids: &[HolderSegment], at: &mut f64) -> Vec<ShankPiece> {
    let piece = |solid: &HolderSegment| {
        let from = *at;
        *at += solid.height_mm;
        let HolderSegment { height_mm, lower_mm, upper_mm } = *solid;
        ShankPiece { from, height: height_mm, lower: lower_mm, upper: upper_mm }
    };
    solids.iter().map(piece).collect()
}

/// A body of a cutter with a holder: its height, and its diameters below and above.
#[cfg(test)]
pub(super) fn body_for_tests(cutter: CutterProfile, holder: Option<[f64; 3]>) -> ToolBody {
    let dimensions = CutterDimensions::Flat { diameter: 2.0 * cutter.radius() };
    let from = cutter.flutes().unwrap_or(0.0);
    let piece = |[height, lower, upper]: [f64; 3]| ShankPiece { from, height, lower, upper };
    let holder = holder.map(piece).into_iter().collect();
    ToolBody {
        cutter,
        core: None,
        undercuts: Vec::new(),
        dimensions,
        has_assumed_point_angle: false,
        shank: Vec::new(),
        holder,
    }
}
