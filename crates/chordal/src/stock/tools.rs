//! The tools of a machine as bodies of revolution: the parts that cut, and the parts that must not touch.

use std::collections::BTreeMap;

use chordal_diagnostics::Span;
use chordal_machine::{Cutter as Shape, HolderSegment, Tool, ToolShape};
use chordal_stock::{AxialSolid, CutterError, CutterProfile, Undercut};

use super::inside::{CutterDimensions, InnerCutter};
use super::teeth::{ThreadMillTeeth, core};
use crate::job::Job;
use crate::tool_comments::{KnownTool, known_tools};

/// The length that is taken for a shank of unknown length, mm: longer than any.
pub(super) const UNKNOWN_SHANK_MM: f64 = 1000.0;

/// A tool as a body.
#[derive(Clone, Debug)]
pub(super) struct ToolBody {
    pub cutter: CutterProfile,
    /// What it certainly removes, where that is less than what it may remove: the core of a tap, since nobody knows
    /// at which angle its thread starts.
    pub core: Option<CutterProfile>,
    /// The undercuts that cut in place of `cutter`, where that is only the hull of edges above its widest point: each
    /// with the height of its lower end above the tip, mm.
    pub undercuts: Vec<(f64, Undercut)>,
    dimensions: CutterDimensions,
    /// A drill whose point angle nobody gives.
    pub has_assumed_point_angle: bool,
    /// The block of the program that defines it, where its shape is assumed.
    pub assumed_by: Option<Span>,
    /// Pieces above the edges, the lowest first, each with its height above the tip, mm.
    pub shank: Vec<ShankPiece>,
    pub holder: Vec<ShankPiece>,
}

impl ToolBody {
    /// The cutter inset by `depth`, mm; `None` where nothing is left of it, or the inset is not known.
    pub fn inside(&self, depth: f64) -> Option<InnerCutter> {
        self.dimensions.inside(depth)
    }

    /// The edges inset by `depth` as a solid, mm; `None` where nothing is left of them, or the inset is not known.
    pub fn inside_solid(&self, depth: f64) -> Option<AxialSolid> {
        let (cutter, lift) = self.dimensions.inset_profile(depth)?;
        let end = self.cutter.flutes().unwrap_or(UNKNOWN_SHANK_MM) - depth;
        let solid = AxialSolid::of_cutter(&cutter, end - lift).raised(lift);
        (!solid.is_empty()).then_some(solid)
    }

    /// What it certainly removes.
    pub fn removes(&self) -> &CutterProfile {
        self.core.as_ref().unwrap_or(&self.cutter)
    }

    /// The highest known point of cutter, shank and holder above the tip, mm.
    pub fn top(&self) -> f64 {
        let ends = self.shank.iter().chain(&self.holder).map(|piece| piece.from + piece.height);
        ends.fold(self.cutter.flutes().unwrap_or(UNKNOWN_SHANK_MM), f64::max)
    }

    /// Whether the tool is nowhere narrower than further down. Above the edges it counts as wide as they are: what
    /// touches there is reported as a cut deeper than the edges are long.
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

/// A cylinder or cone of shank or holder, above the edges.
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

/// Says which dimensions a tool lacks, by their keys.
pub(super) fn lacking(shape: ToolShape, missing: &[&str]) -> String {
    let keys: Vec<String> = missing.iter().map(|key| format!("`{key}`")).collect();
    format!("a tool of the shape `{}` needs {}", shape.as_str(), keys.join(" and "))
}

/// The tools that a program may use, by number.
pub(super) fn tools_of(job: &Job) -> BTreeMap<u32, Result<ToolBody, NoBody>> {
    let body = |known: KnownTool| {
        body_of(&known.tool).map(|body| ToolBody { assumed_by: known.assumed, ..body })
    };
    known_tools(job).into_iter().map(|(number, known)| (number, body(known))).collect()
}

fn body_of(tool: &Tool) -> Result<ToolBody, NoBody> {
    let shape = tool.shape.ok_or(NoBody::Unknown)?;
    let lacks = || NoBody::Incomplete(shape, tool.missing_dimensions());
    let edges = edges_of(tool.cutter().ok_or_else(lacks)?)?;
    // Without the end of the edges, the start of the shank is not known either.
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
        assumed_by: None,
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

/// The part of a tool that cuts.
struct CuttingEdges {
    cutter: CutterProfile,
    undercuts: Vec<(f64, Undercut)>,
    dimensions: CutterDimensions,
    /// The height to which they reach, mm; `None` where the shape does not give it.
    top: Option<f64>,
    /// The diameter of the neck above undercuts, mm.
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

/// The edges of a tool with one undercut.
fn below(dimensions: CutterDimensions, undercut: Undercut) -> Result<CuttingEdges, CutterError> {
    let (top, neck) = (Some(undercut.height()), undercut.neck());
    let cutter = dimensions.cutter()?;
    Ok(CuttingEdges { cutter, undercuts: vec![(0.0, undercut)], dimensions, top, neck })
}

/// The edges of a thread mill: teeth one above the other, and their core.
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

/// A tool of a cutter and a holder, given as height, lower and upper diameter.
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
        assumed_by: None,
        shank: Vec::new(),
        holder,
    }
}
