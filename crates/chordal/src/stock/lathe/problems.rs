//! Collects the problems of turned stock and words their diagnostics. X is given as a diameter.

use chordal_command::{Origin, Units};
use chordal_diagnostics::{Code, Diagnostic, SourceMap};
use chordal_geometry::{Vec2, Vec3};
use chordal_stock::VolumeInterval;

use super::super::problems::StockProblem;

/// Most problems that are kept of a run.
const MAX_PROBLEMS: usize = 1000;

/// What a message needs in addition to the depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum MessageDetail<'a> {
    Nothing,
    /// The name of a fixture and its clearance, mm.
    Fixture(&'a str, f64),
    /// The width of a ridge, mm.
    Ridge(f64),
    /// The pip is on the part that was cut off.
    Off,
    /// The part is still held by a ring around a bore.
    Ring,
    /// Why the move was not cut.
    Why(&'a str),
}

/// Where a problem is.
#[derive(Clone, Copy, Debug)]
pub(super) struct ProblemLocation {
    pub origin: Origin,
    pub tool: u32,
    /// Z and radius, mm.
    pub place: Vec2,
}

/// Collects the problems of a run.
pub(super) struct TurnedProblems<'a> {
    pub list: Vec<StockProblem>,
    pub diagnostics: Vec<Diagnostic>,
    pub more: u64,
    pub hits: u64,
    pub undecided: u64,
    pub units: Units,
    pub sources: &'a SourceMap<'a>,
    /// The block, kind and fixture of the last problem: the next problem with the same is merged into it.
    last: Option<(Origin, Code, String)>,
}

impl<'a> TurnedProblems<'a> {
    pub fn new(units: Units, sources: &'a SourceMap<'a>) -> TurnedProblems<'a> {
        TurnedProblems {
            list: Vec::new(),
            diagnostics: Vec::new(),
            more: 0,
            hits: 0,
            undecided: 0,
            units,
            sources,
            last: None,
        }
    }

    /// Adds a problem, or widens the last one where it is of the same block.
    pub fn push(&mut self, code: Code, depth: f64, at: &ProblemLocation, more: MessageDetail<'_>) {
        match code {
            Code::NotProved => self.undecided += 1,
            // These are warnings: material that is left may be an allowance.
            Code::NoseLeaves | Code::MaterialLeft => {}
            _ => self.hits += 1,
        }
        let name = if let MessageDetail::Fixture(name, _) = more { name } else { "" };
        let is_same = self.last.as_ref().is_some_and(|(origin, known, of)| {
            (*origin, *known, of.as_str()) == (at.origin, code, name)
        });
        if is_same
            && let (Some(last), Some(reported)) =
                (self.list.last_mut(), self.diagnostics.last_mut())
        {
            if depth > last.depth_mm.most {
                last.depth_mm = VolumeInterval { least: depth, most: depth };
                last.at = Vec3::new(at.place.b, 0.0, at.place.a);
                *reported = diagnostic(code, depth, at, more, self.units);
            }
            return;
        }
        self.last = Some((at.origin, code, name.to_string()));
        if self.list.len() >= MAX_PROBLEMS {
            self.more += 1;
            return;
        }
        let file = self.sources.get(at.origin.span.file).map_or("", |source| source.name());
        self.list.push(StockProblem {
            code,
            file: file.to_string(),
            line: at.origin.line,
            tool: at.tool,
            depth_mm: VolumeInterval { least: depth, most: depth },
            at: Vec3::new(at.place.b, 0.0, at.place.a),
        });
        self.diagnostics.push(diagnostic(code, depth, at, more, self.units));
    }
}

fn diagnostic(
    code: Code,
    depth: f64,
    at: &ProblemLocation,
    more: MessageDetail<'_>,
    units: Units,
) -> Diagnostic {
    let tool = at.tool;
    let length = |mm: f64| units.length_text(mm);
    let depth_text = length(depth);
    let (message, label, help) = match (code, more) {
        (Code::RapidThroughStock, _) => (
            format!("a rapid goes {depth_text} deep through material"),
            "at rapid speed",
            "move away first, or use G1 if this is a cut",
        ),
        (Code::DeeperThanFlutes, _) => (
            format!("the cut of tool {tool} is {depth_text} deeper than its edges reach"),
            "deeper than the edges are long",
            "cut in more passes, or use a tool with longer edges",
        ),
        (Code::ShankInStock, _) => (
            format!("the shank of tool {tool} goes {depth_text} deep into material"),
            "the shank touches",
            "use a thinner bar or a longer tool, or remove the material first",
        ),
        (Code::HolderInStock, _) => (
            format!("the holder of tool {tool} goes {depth_text} deep into material"),
            "the holder touches",
            "stop before the shoulder, use another holder, or remove the material first",
        ),
        (Code::CutsWithoutSpindle, _) => (
            format!("tool {tool} cuts {depth_text} deep, and the spindle is stopped"),
            "no spindle",
            "start the spindle with M3 or M4 before the cut",
        ),
        (Code::Gouge, _) => (
            format!("tool {tool} cuts {depth_text} deep into the part"),
            "below the surface of the target",
            "check the offset, the tool and this block",
        ),
        (Code::MaterialLeft, _) => (
            format!("after the program {depth_text} are left on the part"),
            "the last move",
            "check the finishing passes, or the tolerance of the target",
        ),
        (Code::FixtureHit, MessageDetail::Fixture(name, clearance)) => (
            if clearance > 0.0 {
                let clearance = length(clearance);
                format!(
                    "tool {tool} comes nearer to `{name}` than its clearance of {clearance}, by {depth_text}"
                )
            } else {
                format!("tool {tool} goes {depth_text} deep into `{name}`")
            },
            "too near",
            "stop before it, or move the fixture",
        ),
        (Code::GrooveRidge, MessageDetail::Ridge(width)) => (
            format!(
                "a ridge {} wide and {depth_text} high is left next to this plunge",
                length(width)
            ),
            "the step is wider than the tool",
            "use a smaller step (Q of G75), or enter the true width of the tool",
        ),
        (Code::PartOffPip, MessageDetail::Off) => (
            format!("the part is cut off with a pip of diameter {} on it", length(2.0 * depth)),
            "leaves a pip",
            "feed past the axis by the corner radius of the tool",
        ),
        (Code::PartOffPip, MessageDetail::Ring) => (
            format!("the part is not cut off: a ring {depth_text} thick holds it"),
            "ends before the bore",
            "feed further, into the bore",
        ),
        (Code::PartOffPip, _) => (
            format!("the part is not cut off: a pip of diameter {} holds it", length(2.0 * depth)),
            "ends before the axis",
            "feed to X0, and past it by the corner radius of the tool",
        ),
        (Code::FlankGouge, _) => (
            format!(
                "the flank of tool {tool} cuts {depth_text} deep into the contour before this move"
            ),
            "steeper than the insert is free",
            "use an insert with a smaller corner angle, or cut this slope from the other side",
        ),
        (Code::NoseGouge, _) => (
            format!(
                "without compensation the nose of tool {tool} cuts {depth_text} below the programmed contour"
            ),
            "no G41 or G42",
            "switch nose radius compensation on, or program the contour with the nose in it",
        ),
        (Code::NoseLeaves, _) => (
            format!(
                "without compensation the nose of tool {tool} leaves {depth_text} on the programmed contour"
            ),
            "no G41 or G42",
            "switch nose radius compensation on, if this is not an allowance",
        ),
        (_, MessageDetail::Why(why)) => (
            format!("this move of tool {tool} could not be cut exactly: {why}"),
            "not proved",
            "nothing after it is proved; check its coordinates",
        ),
        _ => (
            format!("tool {tool} may touch material here, at most {depth_text} deep"),
            "not proved",
            "check this block",
        ),
    };
    let (x, z) = (length(2.0 * at.place.b), length(at.place.a));
    Diagnostic::new(code, at.origin.span, message)
        .label(label)
        .note(format!("the place is X{x} Z{z} (X a diameter)"))
        .help(help)
}
