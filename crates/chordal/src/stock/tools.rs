//! The tools of a machine as bodies that turn: what cuts, and what must not touch.

use std::collections::BTreeMap;

use chordal_machine::{Cutter as Shape, Solid, Tool, ToolShape};
use chordal_stock::{Body, Cutter, CutterError, Undercut};

use crate::job::Job;
use crate::tool_comments::known_tools;

/// A thread's depth as a share of its pitch: 5/8 of the height of the sharp triangle, which is √3/2 of the
/// pitch (ISO 68-1).
const THREAD_DEPTH: f64 = 0.541_265_877_365_274_2;
/// The flat of a thread's tooth as a share of its pitch, and the angle of its flanks to the plane across the axis
/// (ISO 68-1: 60° between them).
const CREST: f64 = 0.125;
const FLANK: f64 = std::f64::consts::FRAC_PI_6;
/// A shank of which only the diameter is known has no end below this height, mm.
const LONG: f64 = 1000.0;

/// A tool as a body.
#[derive(Clone, Debug)]
pub(super) struct ToolBody {
    pub cutter: Cutter,
    /// What cuts instead of it where it is only the hull of edges above its widest place: each with the height of
    /// its lower end above the tip, mm.
    pub undercuts: Vec<(f64, Undercut)>,
    /// `None`: another shape than those.
    dimensions: Option<Dimensions>,
    /// Pieces above the edges, the lowest first, each with its height above the tip, mm.
    pub shank: Vec<Piece>,
    pub holder: Vec<Piece>,
}

/// A cutter of which a smaller one inside is known, by its dimensions, mm and rad.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Dimensions {
    Flat {
        diameter: f64,
    },
    Ball {
        diameter: f64,
    },
    Bull {
        diameter: f64,
        corner: f64,
    },
    Pointed {
        diameter: f64,
        tip: f64,
        angle: f64,
    },
    /// An undercut: a disc of a thickness.
    Disc {
        diameter: f64,
        thickness: f64,
    },
    /// An undercut: a whole ball.
    Lollipop {
        diameter: f64,
    },
}

impl Dimensions {
    /// The part of it that cuts.
    fn body(self) -> Result<Body, CutterError> {
        // Whatever bears it is a part of the shank.
        let neck = |diameter: f64| 0.5 * diameter;
        let undercut = match self {
            Dimensions::Disc { diameter, thickness } => {
                Undercut::t_slot(diameter, thickness, neck(diameter))?
            }
            Dimensions::Lollipop { diameter } => Undercut::lollipop(diameter, neck(diameter))?,
            Dimensions::Flat { .. }
            | Dimensions::Ball { .. }
            | Dimensions::Bull { .. }
            | Dimensions::Pointed { .. } => return Ok(Body::of_cutter(&self.cutter()?)),
        };
        Ok(Body::of_undercuts(&[(0.0, undercut)]))
    }

    /// Its lower side.
    fn cutter(self) -> Result<Cutter, CutterError> {
        match self {
            Dimensions::Disc { diameter, .. } => Cutter::flat(diameter),
            Dimensions::Lollipop { diameter } => Cutter::ball(diameter),
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
            Dimensions::Disc { diameter, thickness } => {
                let thickness = thickness - 2.0 * depth;
                (Dimensions::Disc { diameter: less(diameter), thickness }, depth)
            }
            Dimensions::Lollipop { diameter } => {
                (Dimensions::Lollipop { diameter: less(diameter) }, depth)
            }
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
    /// What lies everywhere at least `depth` inside of the cutter, and how much higher its tip is, mm;
    /// `None` where it is not known, or nothing is left of it.
    pub fn inside(&self, depth: f64) -> Option<(Body, f64)> {
        let (dimensions, lift) = self.dimensions?.inside(depth);
        Some((dimensions.body().ok()?, lift))
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
    let edges = edges_of(tool.cutter().ok_or(NoBody::Incomplete(shape))?)?;
    // Where the edges end is not known: neither is where the shank begins.
    let flutes = match edges.top {
        Some(top) => Some(tool.flute_length_mm.map_or(top, |flutes| flutes.max(top))),
        None => tool.flute_length_mm,
    };
    let Edges { cutter, undercuts, dimensions, top, neck } = edges;
    let cutter = cutter.with_flutes(flutes);
    let mut body =
        ToolBody { cutter, undercuts, dimensions, shank: Vec::new(), holder: Vec::new() };
    let Some(flutes) = flutes else { return Ok(body) };
    let mut at = flutes;
    body.shank = stacked(&tool.shank, &mut at);
    if let (true, Some(diameter)) = (body.shank.is_empty(), tool.shank_diameter_mm) {
        let height = if tool.holder.is_empty() { LONG } else { 0.0 };
        body.shank.push(Piece { from: at, height, lower: diameter, upper: diameter });
        at += height;
    }
    if let Some(from) = top.filter(|top| *top < flutes) {
        // The neck between undercuts and shank.
        let neck = Piece { from, height: flutes - from, lower: neck, upper: neck };
        body.shank.insert(0, neck);
    }
    body.holder = stacked(&tool.holder, &mut at);
    Ok(body)
}

/// What cuts.
struct Edges {
    cutter: Cutter,
    undercuts: Vec<(f64, Undercut)>,
    dimensions: Option<Dimensions>,
    /// How far up they reach, where the shape says it, mm.
    top: Option<f64>,
    /// The diameter of what bears undercuts, mm.
    neck: f64,
}

fn edges_of(shape: Shape<'_>) -> Result<Edges, NoBody> {
    let known = |dimensions: Dimensions| {
        let cutter = dimensions.cutter()?;
        let dimensions = Some(dimensions);
        Ok(Edges { cutter, undercuts: Vec::new(), dimensions, top: None, neck: 0.0 })
    };
    let other = |cutter: Cutter| Edges {
        cutter,
        undercuts: Vec::new(),
        dimensions: None,
        top: None,
        neck: 0.0,
    };
    let found: Result<Edges, CutterError> = match shape {
        Shape::Flat { diameter_mm } => known(Dimensions::Flat { diameter: diameter_mm }),
        Shape::Ball { diameter_mm } => known(Dimensions::Ball { diameter: diameter_mm }),
        Shape::Bull { diameter_mm, corner_radius_mm } => {
            known(Dimensions::Bull { diameter: diameter_mm, corner: corner_radius_mm })
        }
        Shape::Chamfer { diameter_mm, tip_diameter_mm: tip, point_angle_rad: angle } => {
            known(Dimensions::Pointed { diameter: diameter_mm, tip, angle })
        }
        Shape::Drill { diameter_mm, point_angle_rad: angle } => {
            known(Dimensions::Pointed { diameter: diameter_mm, tip: 0.0, angle })
        }
        // Its core: a thread of a pitch a turn stands in the hole.
        Shape::Tap { diameter_mm, pitch_mm } => {
            Cutter::flat(core(diameter_mm, pitch_mm)).map(other)
        }
        Shape::ThreadMill { diameter_mm, pitch_mm, teeth } => threads(diameter_mm, pitch_mm, teeth),
        Shape::TSlot { diameter_mm, thickness_mm, neck_mm } => {
            let disc = Undercut::t_slot(diameter_mm, thickness_mm, neck_mm);
            let dimensions = Dimensions::Disc { diameter: diameter_mm, thickness: thickness_mm };
            disc.and_then(|disc| below(dimensions, disc))
        }
        Shape::Lollipop { diameter_mm, neck_mm } => {
            let ball = Undercut::lollipop(diameter_mm, neck_mm);
            ball.and_then(|ball| below(Dimensions::Lollipop { diameter: diameter_mm }, ball))
        }
        Shape::Form { profile } => Cutter::outline(profile).map(other),
        Shape::Insert { .. } | Shape::Groove { .. } => return Err(NoBody::Turning),
    };
    found.map_err(NoBody::Wrong)
}

/// One undercut with its dimensions.
fn below(dimensions: Dimensions, undercut: Undercut) -> Result<Edges, CutterError> {
    let (top, neck) = (Some(undercut.height()), undercut.neck());
    let (cutter, dimensions) = (dimensions.cutter()?, Some(dimensions));
    Ok(Edges { cutter, undercuts: vec![(0.0, undercut)], dimensions, top, neck })
}

/// The diameter of a thread tool below its teeth, mm.
fn core(diameter: f64, pitch: f64) -> f64 {
    diameter - 2.0 * THREAD_DEPTH * pitch
}

/// Teeth above each other, with the core that bears them.
fn threads(diameter: f64, pitch: f64, teeth: u32) -> Result<Edges, CutterError> {
    let core = core(diameter, pitch);
    let tooth = Undercut::thread_disc(diameter, pitch * CREST, FLANK, core)?;
    let height = pitch * f64::from(teeth);
    let mut undercuts = vec![(0.0, Undercut::t_slot(core, height.max(tooth.height()), core)?)];
    undercuts.extend((0..teeth).map(|n| (pitch * f64::from(n), tooth.clone())));
    let top = Some(height.max(tooth.height()));
    Ok(Edges { cutter: Cutter::flat(diameter)?, undercuts, dimensions: None, top, neck: core })
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
