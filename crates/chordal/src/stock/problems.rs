//! Collects touches block by block, and words their diagnostics.

use chordal_command::{Origin, Units};
use chordal_diagnostics::{Code, Diagnostic, SourceMap};
use chordal_geometry::Vec3;
use chordal_stock::{ContactDepth, TouchAnswer, VolumeInterval};

use super::tools::ToolBody;

/// A touch, or one that cannot be excluded.
#[derive(Clone, Debug, PartialEq)]
pub struct StockProblem {
    /// What kind of touch it is.
    pub code: Code,
    /// The file of the block.
    pub file: String,
    /// Its line, from 1.
    pub line: u32,
    /// Number of the tool.
    pub tool: u32,
    /// Its depth, mm: at least and at most.
    pub depth_mm: VolumeInterval,
    /// Its deepest point, in the frame of the run, mm.
    pub at: Vec3,
}

/// The diagnostic that moves of a tool remove nothing: its shape is not known, or the moves are not simulated.
pub(super) fn not_cut(code: Code, origin: &Origin, tool: u32, why: &str) -> Diagnostic {
    let (message, help) = if code == Code::ToolWithoutShape {
        (
            format!("what tool {tool} removes is not known: {why}"),
            "give its shape with all dimensions in the setup or machine file",
        )
    } else {
        (
            format!("this move of tool {tool} is not cut from the stock: {why}"),
            "nothing after it is proved",
        )
    };
    Diagnostic::new(code, origin.span, message).help(help)
}

/// What was assumed of a tool, at its first cut or where the program defines it.
pub(super) fn assumed_dimensions(
    body: &ToolBody,
    origin: &Origin,
    tool: u32,
) -> impl Iterator<Item = Diagnostic> + use<> {
    let angle = body.has_assumed_point_angle.then(|| assumed_point_angle(origin, tool));
    let shape = body.assumed_by.map(|span| {
        let diameter = (2.0 * body.cutter.radius() * 1000.0).round() / 1000.0;
        let message = format!("the shape of tool {tool} is not given: a cylinder of {diameter} mm is taken");
        Diagnostic::new(Code::AssumedShape, span, message)
            .help(format!("give `[tools.{tool}] shape` with its dimensions in the setup or machine file, if it has another one"))
    });
    angle.into_iter().chain(shape)
}

/// The diagnostic for a drill whose point angle nobody gives.
pub(super) fn assumed_point_angle(origin: &Origin, tool: u32) -> Diagnostic {
    let message = format!("tool {tool} is a drill without a point angle: 118° are taken");
    Diagnostic::new(Code::AssumedShape, origin.span, message)
        .help(format!("give `[tools.{tool}] point_angle` in the setup or machine file"))
}

/// Most problems that are kept of a run.
const MAX_PROBLEMS: usize = 1000;

/// Collects the problems of a run.
#[derive(Debug, Default)]
pub(super) struct StockProblems {
    pub list: Vec<StockProblem>,
    pub diagnostics: Vec<Diagnostic>,
    pub more: u64,
    pub hits: u64,
    pub undecided: u64,
    /// The block, kind and fixture of the last problem: the next problem with the same is merged into it.
    last: Option<(Origin, Code, String)>,
}

/// The circumstances of a touch.
#[derive(Clone, Copy, Debug)]
pub(super) struct ContactReport<'a> {
    pub origin: Origin,
    pub tool: u32,
    pub units: Units,
    pub sources: &'a SourceMap<'a>,
    /// The spindle is oriented: the tool is at most as wide as its shape of revolution, and nobody knows how much
    /// narrower.
    pub is_aside: bool,
    /// The fixture that is touched; `None` for the stock.
    pub fixture: Option<FixtureClearance<'a>>,
}

/// A fixture, and the distance that the tool must keep from it, mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct FixtureClearance<'a> {
    pub name: &'a str,
    pub clearance: f64,
}

impl FixtureClearance<'_> {
    /// What the tool does to the fixture, for a message.
    fn tool_phrase(&self, units: Units) -> String {
        let FixtureClearance { name, clearance } = *self;
        if clearance > 0.0 {
            let clearance = units.length_text(clearance);
            format!("comes nearer to `{name}` than its clearance of {clearance}")
        } else {
            format!("touches `{name}`")
        }
    }
}

impl StockProblems {
    /// Takes the contacts of the bodies of a tool on a move. The first certain touch is reported, since the others
    /// follow from it; without one, the deepest that cannot be excluded.
    pub fn touches(
        &mut self,
        contacts: impl Iterator<Item = (Code, ContactDepth)>,
        tolerance: f64,
        place: &ContactReport<'_>,
    ) {
        let mut open: Option<(VolumeInterval, [f64; 3])> = None;
        for (code, contact) in contacts {
            match contact.touch(tolerance) {
                TouchAnswer::Clean => {}
                TouchAnswer::Hit { most, at, .. } if place.is_aside => {
                    if open.is_none_or(|(known, _)| most > known.most) {
                        open = Some((VolumeInterval { least: 0.0, most }, at));
                    }
                }
                TouchAnswer::Hit { least, most, at } => {
                    self.hits += 1;
                    self.push(code, VolumeInterval { least, most }, vector(at), place);
                    return;
                }
                TouchAnswer::Undecided { most, at } => {
                    if open.is_none_or(|(known, _)| most > known.most) {
                        open = Some((VolumeInterval { least: 0.0, most }, at));
                    }
                }
            }
        }
        if let Some((depth, at)) = open {
            self.undecided += 1;
            self.push(Code::NotProved, depth, vector(at), place);
        }
    }

    /// Takes a move that comes too near to a fixture, or may do so. `missing` is the part of the clearance that is
    /// missing, mm.
    pub fn fixture(
        &mut self,
        code: Code,
        fixture: &FixtureClearance<'_>,
        missing: VolumeInterval,
        at: Vec3,
        place: &ContactReport<'_>,
    ) {
        if code == Code::NotProved {
            self.undecided += 1;
        } else {
            self.hits += 1;
        }
        self.push(code, missing, at, &ContactReport { fixture: Some(*fixture), ..*place });
    }

    /// Adds a problem, or widens the last one where it is of the same block.
    fn push(&mut self, code: Code, depth_mm: VolumeInterval, at: Vec3, place: &ContactReport<'_>) {
        let name = place.fixture.map_or("", |fixture| fixture.name);
        let is_same = self.last.as_ref().is_some_and(|(origin, known, of)| {
            (*origin, *known, of.as_str()) == (place.origin, code, name)
        });
        if is_same
            && let (Some(last), Some(reported)) =
                (self.list.last_mut(), self.diagnostics.last_mut())
        {
            if depth_mm.most > last.depth_mm.most {
                last.depth_mm.most = depth_mm.most;
                last.at = at;
            }
            last.depth_mm.least = last.depth_mm.least.max(depth_mm.least);
            *reported = diagnostic(code, last, place);
            return;
        }
        self.last = Some((place.origin, code, name.to_string()));
        if self.list.len() >= MAX_PROBLEMS {
            self.more += 1;
            return;
        }
        let file = place.sources.get(place.origin.span.file).map_or("", |source| source.name());
        let problem = StockProblem {
            code,
            file: file.to_string(),
            line: place.origin.line,
            tool: place.tool,
            depth_mm,
            at,
        };
        self.diagnostics.push(diagnostic(code, &problem, place));
        self.list.push(problem);
    }
}

fn vector([x, y, z]: [f64; 3]) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A depth between two bounds, for a message.
fn between(depth: VolumeInterval, units: Units) -> String {
    let [least, most] = [depth.least, depth.most].map(|mm| units.length_text(mm));
    if least == most { most } else { format!("{least} to {most}") }
}

fn diagnostic(code: Code, problem: &StockProblem, place: &ContactReport<'_>) -> Diagnostic {
    let units = place.units;
    let depth = between(problem.depth_mm, units);
    let tool = problem.tool;
    let [x, y, z] = [problem.at.x, problem.at.y, problem.at.z].map(|mm| units.length_text(mm));
    let (message, label, help) = match (code, &place.fixture) {
        (Code::RapidThroughStock, _) => (
            format!("a rapid goes {depth} deep through material"),
            "at rapid speed",
            "lift the tool first, or use G1 if this is a cut",
        ),
        (Code::DeeperThanFlutes, _) => (
            format!("the cut of tool {tool} reaches {depth} above its cutting edges"),
            "deeper than the edges are long",
            "cut in more levels, or use a tool with longer edges",
        ),
        (Code::ShankInStock, _) => (
            format!("the shank of tool {tool} goes {depth} deep into material"),
            "the shank touches",
            "use a longer tool, or remove the material first",
        ),
        (Code::HolderInStock, _) => (
            format!("the holder of tool {tool} goes {depth} deep into material"),
            "the holder touches",
            "use a longer tool, or remove the material first",
        ),
        (Code::CutsWithoutSpindle, _) => (
            format!("tool {tool} cuts {depth} deep, and the spindle is stopped"),
            "no spindle",
            "start the spindle with M3 or M4 before the cut",
        ),
        (Code::Gouge, _) => (
            format!("tool {tool} cuts {depth} deep into the part"),
            "below the surface of the target",
            "check the offset, the tool and this block",
        ),
        (Code::FixtureHit, Some(fixture)) => (
            format!("tool {tool} or its holder {}", fixture.tool_phrase(units)),
            "too near",
            "lift the tool before this move, or move the fixture",
        ),
        (_, Some(fixture)) => (
            format!("tool {tool} or its holder may come too near to `{}`", fixture.name),
            "not proved",
            "lift the tool before this move, or move the fixture",
        ),
        _ if place.is_aside => (
            format!(
                "tool {tool} goes down beside the axis of its hole, with the spindle at its mark"
            ),
            "not proved: its shape says how wide it is when it turns",
            "look whether the bar goes through the hole",
        ),
        _ => (
            format!(
                "the tool may touch material here, at most {} deep",
                units.length_text(problem.depth_mm.most)
            ),
            "not proved at this resolution",
            "a smaller resolution proves it where the tool has room; one as wide as what it goes into stays open",
        ),
    };
    Diagnostic::new(code, place.origin.span, message)
        .label(label)
        .note(format!("the deepest place is at X{x} Y{y} Z{z}"))
        .help(help)
}
