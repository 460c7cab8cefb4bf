//! The tools of a lathe as outlines in the half plane.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};

use chordal_geometry::Vec2;
use chordal_machine::{
    Cutter as Shape, HolderSegment, InsertLetter, Tool, ToolFacing, ToolShape, mirrored_tip,
};
use chordal_stock::lathe::{
    Blade, BladeFacing, BladePoint, Insert, InsertShape, Tip, ToolError, ToolOutline as Outline,
};

use crate::job::Job;
use crate::stock::tools::lacking;
use crate::tool_comments::known_tools;

/// The length that is taken for a shank or body of unknown length, mm: longer than any.
const UNKNOWN_BODY_MM: f64 = 1000.0;
/// The block above a blade is at least this much wider on each side, mm.
const BLOCK: f64 = 0.5;
/// A thread's depth as a share of its pitch (ISO 68-1).
const THREAD_DEPTH: f64 = 0.541_265_877_365_274_2;

/// The outlines of a tool: the edges that cut, and the bodies that must not touch.
#[derive(Clone, Debug)]
pub(super) struct LatheTool {
    /// True for a drill whose point angle nobody gives.
    pub has_assumed_point_angle: bool,
    pub edges: Outline,
    pub kind: TurningToolKind,
    /// The length of the cutting edges, or the cutting depth of a blade, mm.
    pub reach: f64,
    /// Direction from the programmed point into the tool; zero where there is none.
    pub body: Vec2,
    /// The block above a blade; `None` for other tools, and for blades in a bore.
    pub above: Option<Outline>,
    pub shank: Option<Outline>,
    pub holder: Option<Outline>,
    /// True where each revolution leaves a groove instead of a round surface.
    pub threads: bool,
}

/// The kind of a turning tool, with the dimensions that checks depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum TurningToolKind {
    /// A nose between two flanks: its radius, mm, the directions of the flanks and the approach angle, rad.
    /// `centered` where the centre of the nose is the programmed point (tip 0 or 9).
    Insert { nose: f64, flanks: [f64; 2], centered: bool, approach: Option<f64> },
    /// A round insert.
    Round,
    /// A front edge, with its ends relative to the programmed point along the axis of its width, mm.
    Blade { facing: BladeFacing, from: f64, to: f64 },
    /// A tool on the axis.
    Drill,
}

/// Why a tool has no outline.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct NoOutline(pub String);

impl From<ToolError> for NoOutline {
    fn from(error: ToolError) -> NoOutline {
        NoOutline(error.to_string())
    }
}

/// The tools that a program may use, by number.
pub(super) fn tools_of(job: &Job) -> BTreeMap<u32, Result<LatheTool, NoOutline>> {
    // Some controls number tips with X mirrored.
    let mirrored = job.rules().turning.tips_mirrored;
    let outline = |mut tool: Tool| {
        tool.tip = tool.tip.map(|tip| if mirrored { mirrored_tip(tip) } else { tip });
        lathe_tool(&tool)
    };
    known_tools(job).into_iter().map(|(number, known)| (number, outline(known.tool))).collect()
}

fn missing(key: &str, what: &str) -> NoOutline {
    NoOutline(format!("`{key}` ({what}) is not given"))
}

fn lathe_tool(tool: &Tool) -> Result<LatheTool, NoOutline> {
    let shape = tool.shape.ok_or_else(|| NoOutline("its shape is not known".into()))?;
    match shape {
        ToolShape::Insert => insert(tool),
        ToolShape::Groove => blade(tool),
        _ => on_axis(tool, shape),
    }
}

fn tip_of(tool: &Tool) -> Result<Tip, NoOutline> {
    let number = tool.tip.ok_or_else(|| missing("tip", "the direction of its tip"))?;
    Ok(Tip::new(u8::try_from(number).unwrap_or(u8::MAX))?)
}

fn insert(tool: &Tool) -> Result<LatheTool, NoOutline> {
    let tip = tip_of(tool)?;
    let nose = tool.nose_radius_mm.ok_or_else(|| missing("nose_radius", "of the insert"))?;
    if tool.turning.insert == Some(InsertLetter::R) {
        return Ok(LatheTool {
            has_assumed_point_angle: tool.has_assumed_point_angle(),
            edges: Outline::round(nose, tip)?,
            kind: TurningToolKind::Round,
            reach: 2.0 * nose,
            body: tip.to_center(),
            above: None,
            shank: bar(tool, tip, 2.0 * nose)?,
            holder: holder(tool)?,
            threads: false,
        });
    }
    let corner = tool
        .turning
        .corner_rad()
        .ok_or_else(|| missing("insert", "the letter of its ISO code; or `insert_angle`"))?;
    let reach = tool
        .flute_length_mm
        .ok_or_else(|| missing("flute_length", "the length of the cutting edges of the insert"))?;
    let triangle = tool.turning.insert.is_some_and(InsertLetter::is_triangle);
    let far = if triangle { InsertShape::Triangle } else { InsertShape::Parallelogram };
    let mounted = match tip.number() {
        1..=4 => {
            let approach = tool.turning.approach_angle_rad.ok_or_else(|| {
                missing("approach_angle", "between its main edge and the feed along Z")
            })?;
            Insert { shape: far, ..Insert::mounted(tip, nose, approach, corner, reach)? }
        }
        5..=8 => {
            let to = tip.to_center();
            let middle = libm::atan2(to.b, to.a);
            let flanks = [middle - 0.5 * corner, middle + 0.5 * corner];
            Insert { nose, tip, flanks, length: reach, shape: far }
        }
        _ => {
            let why = "the tip is 0 or 9, which says nothing of where an insert lies; give 1 to 8, or `insert = \"R\"`";
            return Err(NoOutline(why.to_string()));
        }
    };
    let middle = 0.5 * (mounted.flanks[0] + mounted.flanks[1]);
    let (sine, cosine) = libm::sincos(middle);
    Ok(LatheTool {
        has_assumed_point_angle: tool.has_assumed_point_angle(),
        edges: mounted.outline()?,
        kind: TurningToolKind::Insert {
            nose,
            flanks: mounted.flanks,
            centered: false,
            approach: tool.turning.approach_angle_rad,
        },
        reach,
        body: Vec2::new(cosine, sine),
        above: None,
        shank: bar(tool, tip, reach)?,
        holder: holder(tool)?,
        threads: tool.pitch_mm.is_some(),
    })
}

fn facing_of(tool: &Tool, tip: Tip) -> Result<BladeFacing, NoOutline> {
    Ok(match (tool.turning.facing, tip.number()) {
        (Some(ToolFacing::Outside), _) | (None, 3 | 4 | 8) => BladeFacing::Outside,
        (Some(ToolFacing::Inside), _) | (None, 1 | 2 | 6) => BladeFacing::Inside,
        (Some(ToolFacing::Face), _) | (None, 7) => BladeFacing::Face,
        (Some(ToolFacing::BackFace), _) | (None, 5) => BladeFacing::BackFace,
        (None, _) => {
            return Err(missing("facing", "where it cuts, which the tip 0 or 9 does not say"));
        }
    })
}

/// Which corner of the edge is the programmed point: the one towards the tip.
fn point_of(facing: BladeFacing, tip: Tip) -> BladePoint {
    let to = tip.to_center();
    let along = match facing {
        BladeFacing::Outside | BladeFacing::Inside => to.a,
        BladeFacing::Face | BladeFacing::BackFace => to.b,
    };
    match along {
        along if along > 0.0 => BladePoint::Lower,
        along if along < 0.0 => BladePoint::Upper,
        _ => BladePoint::Middle,
    }
}

fn blade(tool: &Tool) -> Result<LatheTool, NoOutline> {
    let tip = tip_of(tool)?;
    let width = tool.turning.width_mm.ok_or_else(|| missing("width", "of the front edge"))?;
    let length = tool
        .flute_length_mm
        .ok_or_else(|| missing("flute_length", "how deep the blade reaches"))?;
    let facing = facing_of(tool, tip)?;
    let point = point_of(facing, tip);
    let corner = tool.corner_radius_mm.or(tool.nose_radius_mm).unwrap_or(0.0);
    let lead = tool.turning.lead_angle_rad.unwrap_or(0.0);
    let edges = Blade { width, corners: [corner; 2], length, lead, facing, point }.outline()?;
    let from = match point {
        BladePoint::Lower => 0.0,
        BladePoint::Middle => -0.5 * width,
        BladePoint::Upper => -width,
    };
    let to = from + width;
    // A point by its coordinates along the width and into the body.
    let place = |across: f64, depth: f64| match facing {
        BladeFacing::Outside => Vec2::new(across, depth),
        BladeFacing::Inside => Vec2::new(across, -depth),
        BladeFacing::Face => Vec2::new(depth, across),
        BladeFacing::BackFace => Vec2::new(-depth, across),
    };
    // The block that holds the blade is wider than the blade.
    let (left, right) = (from - BLOCK, to + BLOCK);
    let above = [
        place(left, length),
        place(right, length),
        place(right, length + UNKNOWN_BODY_MM),
        place(left, length + UNKNOWN_BODY_MM),
    ];
    Ok(LatheTool {
        has_assumed_point_angle: tool.has_assumed_point_angle(),
        edges,
        kind: TurningToolKind::Blade { facing, from, to },
        reach: length,
        body: place(0.0, 1.0),
        // In a bore the body of the blade is a bar, whose size is not known.
        above: match facing {
            BladeFacing::Inside => None,
            _ => Some(Outline::polygon(&above)?),
        },
        shank: bar(tool, tip, to)?,
        holder: holder(tool)?,
        threads: tool.pitch_mm.is_some(),
    })
}

/// A drill, reamer or tap on the axis.
fn on_axis(tool: &Tool, shape: ToolShape) -> Result<LatheTool, NoOutline> {
    let lacks = || NoOutline(lacking(shape, &tool.missing_dimensions()));
    let (diameter, angle) = match tool.cutter().ok_or_else(lacks)? {
        Shape::Drill { diameter_mm, point_angle_rad } => (diameter_mm, point_angle_rad),
        Shape::Chamfer { diameter_mm, tip_diameter_mm: 0.0, point_angle_rad } => {
            (diameter_mm, point_angle_rad)
        }
        Shape::Flat { diameter_mm } => (diameter_mm, PI),
        Shape::Tap { diameter_mm, pitch_mm } => (diameter_mm - 2.0 * THREAD_DEPTH * pitch_mm, PI),
        _ => {
            let why = format!("a tool of the shape `{}` does not turn a part", shape.as_str());
            return Err(NoOutline(why));
        }
    };
    let length = tool.flute_length_mm.unwrap_or(UNKNOWN_BODY_MM);
    let mut at = length;
    let shank = match tool.shank_diameter_mm.filter(|_| tool.shank.is_empty()) {
        Some(diameter) => stack(
            &[HolderSegment { height_mm: UNKNOWN_BODY_MM, lower_mm: diameter, upper_mm: diameter }],
            &mut at,
        )?,
        None => stack(&tool.shank, &mut at)?,
    };
    Ok(LatheTool {
        has_assumed_point_angle: tool.has_assumed_point_angle(),
        edges: Outline::drill(diameter, angle, length)?,
        kind: TurningToolKind::Drill,
        reach: length,
        body: Vec2::new(1.0, 0.0),
        above: None,
        shank,
        holder: stack(&tool.holder, &mut at)?,
        threads: false,
    })
}

/// Cylinders and cones on the axis, one after the other towards +z.
fn stack(solids: &[HolderSegment], at: &mut f64) -> Result<Option<Outline>, NoOutline> {
    let mut all: Option<Outline> = None;
    for solid in solids.iter().filter(|solid| solid.height_mm > 0.0) {
        let (from, to) = (*at, *at + solid.height_mm);
        *at = to;
        let corners = [
            Vec2::new(from, 0.0),
            Vec2::new(to, 0.0),
            Vec2::new(to, 0.5 * solid.upper_mm),
            Vec2::new(from, 0.5 * solid.lower_mm),
        ];
        let piece = Outline::polygon(&corners)?;
        all = Some(match all {
            Some(known) => known.with(&piece),
            None => piece,
        });
    }
    Ok(all)
}

/// The round shank of a boring bar, which extends along Z from the end of the edges; `None` for other tools.
fn bar(tool: &Tool, tip: Tip, from: f64) -> Result<Option<Outline>, NoOutline> {
    let is_inside = matches!(tip.number(), 1 | 2 | 6);
    let Some(diameter) = tool.shank_diameter_mm.filter(|_| is_inside) else { return Ok(None) };
    let offset = tool.turning.bar_offset_mm.unwrap_or(0.5 * diameter);
    let (low, high) = (-offset - 0.5 * diameter, -offset + 0.5 * diameter);
    let ends = if tip.number() == 1 {
        [-from - UNKNOWN_BODY_MM, -from]
    } else {
        [from, from + UNKNOWN_BODY_MM]
    };
    let corners = [
        Vec2::new(ends[0], low),
        Vec2::new(ends[1], low),
        Vec2::new(ends[1], high),
        Vec2::new(ends[0], high),
    ];
    Ok(Some(Outline::polygon(&corners)?))
}

fn holder(tool: &Tool) -> Result<Option<Outline>, NoOutline> {
    let corners: Vec<Vec2> =
        tool.turning.holder_outline.iter().map(|[x, z]| Vec2::new(*z, *x)).collect();
    if corners.is_empty() {
        return Ok(None);
    }
    let outline = Outline::polygon(&corners);
    Ok(Some(outline.map_err(|error| NoOutline(format!("`holder_outline`: {error}")))?))
}

impl LatheTool {
    /// The outward normals of the two flanks; `None` for tools without an insert.
    pub fn flank_normals(&self) -> Option<[Vec2; 2]> {
        let TurningToolKind::Insert { flanks: [first, second], .. } = self.kind else {
            return None;
        };
        let out = |angle: f64| {
            let (sine, cosine) = libm::sincos(angle);
            Vec2::new(cosine, sine)
        };
        Some([out(first - FRAC_PI_2), out(second + FRAC_PI_2)])
    }
}
