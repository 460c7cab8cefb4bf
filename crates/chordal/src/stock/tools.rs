//! The tools of a machine as bodies that turn: what cuts, and what must not touch.

use std::collections::BTreeMap;

use chordal_machine::{Cutter as Shape, Solid, Tool, ToolShape};
use chordal_stock::{Cutter, CutterError};

use crate::job::Job;
use crate::tool_comments::known_tools;

/// A thread's depth as a share of its pitch: 5/8 of the height of the sharp triangle, which is √3/2 of the
/// pitch (ISO 68-1).
const THREAD_DEPTH: f64 = 0.541_265_877_365_274_2;
/// A shank of which only the diameter is known has no end below this height, mm.
const LONG: f64 = 1000.0;

/// A tool as a body.
#[derive(Clone, Debug)]
pub(super) struct ToolBody {
    pub cutter: Cutter,
    /// `None`: another shape than those.
    dimensions: Option<Dimensions>,
    /// Pieces above the edges, the lowest first, each with its height above the tip, mm.
    pub shank: Vec<Piece>,
    pub holder: Vec<Piece>,
}

/// A cutter of which a smaller one inside is known, by its dimensions, mm and rad.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Dimensions {
    Flat { diameter: f64 },
    Ball { diameter: f64 },
    Bull { diameter: f64, corner: f64 },
    Pointed { diameter: f64, tip: f64, angle: f64 },
}

impl Dimensions {
    fn cutter(self) -> Result<Cutter, CutterError> {
        match self {
            Dimensions::Flat { diameter } => Cutter::flat(diameter),
            Dimensions::Ball { diameter } => Cutter::ball(diameter),
            Dimensions::Bull { diameter, corner } => Cutter::bull(diameter, corner),
            Dimensions::Pointed { diameter, tip, angle } => Cutter::pointed(diameter, tip, angle),
        }
    }

    /// The same everywhere so much smaller, mm, and how much higher its tip is.
    fn inside(self, depth: f64) -> (Dimensions, f64) {
        let less = |diameter: f64| diameter - 2.0 * depth;
        match self {
            Dimensions::Bull { diameter, corner } if corner > depth => {
                (Dimensions::Bull { diameter: less(diameter), corner: corner - depth }, depth)
            }
            Dimensions::Flat { diameter } | Dimensions::Bull { diameter, .. } => {
                (Dimensions::Flat { diameter: less(diameter) }, depth)
            }
            Dimensions::Ball { diameter } => (Dimensions::Ball { diameter: less(diameter) }, depth),
            Dimensions::Pointed { diameter, tip, angle } => {
                // The side of the cone moves inward by depth/cos, measured across the axis.
                let (sine, cosine) = libm::sincos(angle / 2.0);
                let rise = sine / cosine;
                let at_lift = |lift: f64| tip / 2.0 + lift * rise - depth / cosine;
                let lift =
                    if at_lift(depth) < 0.0 { (depth / cosine - tip / 2.0) / rise } else { depth };
                let tip = 2.0 * at_lift(lift).max(0.0);
                (Dimensions::Pointed { diameter: less(diameter), tip, angle }, lift)
            }
        }
    }
}

impl ToolBody {
    /// The cutter that lies everywhere at least `depth` inside of this one, and how much higher its tip is, mm;
    /// `None` where it is not known, or nothing is left of it.
    pub fn inside(&self, depth: f64) -> Option<(Cutter, f64)> {
        let (dimensions, lift) = self.dimensions?.inside(depth);
        Some((dimensions.cutter().ok()?, lift))
    }

    /// The highest known place of cutter, shank and holder above the tip, mm.
    pub fn top(&self) -> f64 {
        let ends = self.shank.iter().chain(&self.holder).map(|piece| piece.from + piece.height);
        ends.fold(self.cutter.flutes().unwrap_or(LONG), f64::max)
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
pub(super) struct Piece {
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
    Incomplete(ToolShape),
    /// A shape that cuts no stock on a mill.
    Turning,
    /// Dimensions that do not fit each other.
    Wrong(CutterError),
}

impl NoBody {
    pub fn why(&self) -> String {
        match self {
            NoBody::Unknown => "its shape is not known".to_string(),
            NoBody::Incomplete(shape) => {
                format!("a tool of the shape `{}` lacks a dimension", shape.as_str())
            }
            NoBody::Turning => "it is a turning tool".to_string(),
            NoBody::Wrong(error) => error.to_string(),
        }
    }
}

/// The tools that a program may use, by number.
pub(super) fn tools_of(job: &Job) -> BTreeMap<u32, Result<ToolBody, NoBody>> {
    known_tools(job).into_iter().map(|(number, known)| (number, body_of(&known.tool))).collect()
}

fn body_of(tool: &Tool) -> Result<ToolBody, NoBody> {
    let shape = tool.shape.ok_or(NoBody::Unknown)?;
    let (mut dimensions, mut other) = (None, None);
    match tool.cutter().ok_or(NoBody::Incomplete(shape))? {
        Shape::Flat { diameter_mm } => {
            dimensions = Some(Dimensions::Flat { diameter: diameter_mm });
        }
        Shape::Ball { diameter_mm } => {
            dimensions = Some(Dimensions::Ball { diameter: diameter_mm });
        }
        Shape::Bull { diameter_mm, corner_radius_mm } => {
            dimensions = Some(Dimensions::Bull { diameter: diameter_mm, corner: corner_radius_mm });
        }
        Shape::Chamfer { diameter_mm, tip_diameter_mm: tip, point_angle_rad: angle } => {
            dimensions = Some(Dimensions::Pointed { diameter: diameter_mm, tip, angle });
        }
        Shape::Drill { diameter_mm, point_angle_rad: angle } => {
            dimensions = Some(Dimensions::Pointed { diameter: diameter_mm, tip: 0.0, angle });
        }
        // Their core: the thread itself is finer than the columns.
        Shape::Tap { diameter_mm, pitch_mm } | Shape::ThreadMill { diameter_mm, pitch_mm, .. } => {
            other = Some(Cutter::flat(diameter_mm - 2.0 * THREAD_DEPTH * pitch_mm));
        }
        Shape::Form { profile } => other = Some(Cutter::outline(profile)),
        Shape::Insert { .. } => return Err(NoBody::Turning),
    }
    let cutter = other.or_else(|| dimensions.map(Dimensions::cutter)).ok_or(NoBody::Unknown)?;
    let cutter = cutter.map_err(NoBody::Wrong)?.with_flutes(tool.flute_length_mm);
    // Where the edges end is not known: neither is where the shank begins.
    let Some(flutes) = tool.flute_length_mm else {
        return Ok(ToolBody { cutter, dimensions, shank: Vec::new(), holder: Vec::new() });
    };
    let mut at = flutes;
    let mut shank = stacked(&tool.shank, &mut at);
    if let (true, Some(diameter)) = (shank.is_empty(), tool.shank_diameter_mm) {
        let height = if tool.holder.is_empty() { LONG } else { 0.0 };
        shank.push(Piece { from: at, height, lower: diameter, upper: diameter });
        at += height;
    }
    let holder = stacked(&tool.holder, &mut at);
    Ok(ToolBody { cutter, dimensions, shank, holder })
}

fn stacked(solids: &[Solid], at: &mut f64) -> Vec<Piece> {
    let piece = |solid: &Solid| {
        let from = *at;
        *at += solid.height_mm;
        let Solid { height_mm, lower_mm, upper_mm } = *solid;
        Piece { from, height: height_mm, lower: lower_mm, upper: upper_mm }
    };
    solids.iter().map(piece).collect()
}
