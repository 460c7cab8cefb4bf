//! Thread milling: the way of the tool, and the program for it.
//!
//! A right-hand thread rises counter-clockwise. A tool that turns clockwise (M3) climbs when the
//! material is on its right: counter-clockwise in a hole, clockwise around a boss. So a right-hand
//! thread is climb cut upwards in a hole (G3) and downwards on a boss (G2), as the Fadal manual
//! (section 13) and the Haas manual (thread milling) have it; a left-hand thread, or conventional
//! cutting, turns Z around.

mod plan;
mod program;

use chordal_machine::ControlName;

use crate::calculation::{QuantityKind, WorkedCalculation};
use crate::error::CalcError;
use crate::figure::{Figure, LineStyle};
use crate::math::{FRAC_PI_2, PI, atan2, unit};
use crate::numbers::AnswerUnit;
use crate::thread::{ThreadHand, ThreadLocation, ThreadSize};
use chordal_geometry::Vec2;
use plan::ThreadMillPlan;

/// How the teeth meet the material, with a tool that turns clockwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MillingDirection {
    /// The chip begins thick.
    Climb,
    /// The chip begins thin.
    Conventional,
}

/// The tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThreadMillCutter {
    /// Teeth of the pitch all along: one turn cuts the whole thread.
    Hob,
    /// One row of teeth: a turn for each pitch.
    Single,
}

/// How much of a turn the tool takes to come in, and to go out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RampSweep {
    /// An eighth: Z changes by an eighth of the lead.
    Eighth,
    /// A quarter.
    Quarter,
}

impl RampSweep {
    const fn share(self) -> f64 {
        match self {
            RampSweep::Eighth => 0.125,
            RampSweep::Quarter => 0.25,
        }
    }

    const fn text(self) -> &'static str {
        match self {
            RampSweep::Eighth => "1/8",
            RampSweep::Quarter => "1/4",
        }
    }
}

/// A thread to mill.
#[derive(Clone, Debug, PartialEq)]
pub struct ThreadMill {
    /// The thread; one start.
    pub thread: ThreadSize,
    /// In a hole or on a boss.
    pub place: ThreadLocation,
    /// Its hand.
    pub hand: ThreadHand,
    /// The tool.
    pub cutter: ThreadMillCutter,
    /// Climb or conventional.
    pub cut: MillingDirection,
    /// Share of a turn for coming in; without it the one that suits.
    pub ramp: Option<RampSweep>,
    /// Root diameter of an outside thread when it is not that of the basic profile, mm.
    pub root: Option<f64>,
    /// Diameter over the teeth, mm.
    pub tool_diameter: f64,
    /// How far below Z0 the thread reaches, mm.
    pub depth: f64,
    /// Feed of the teeth along the thread's diameter, mm/s.
    pub feed: f64,
    /// Speed of the spindle, rpm.
    pub spindle: f64,
    /// Largest wear that D may hold, mm: the path is then written with G41 or G42.
    pub wear: Option<f64>,
    /// Number of the tool, its H and its D.
    pub tool: u32,
    /// Number of the program.
    pub number: u32,
    /// Height above Z0 at which the tool moves in rapid, mm.
    pub clearance: f64,
    /// Who reads the program.
    pub control: ControlName,
    /// Units of the program.
    pub units: AnswerUnit,
}

/// A program with its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct MillProgram {
    /// The program.
    pub text: String,
    /// How its numbers came about, with the figure.
    pub worked: WorkedCalculation,
}

/// The program that mills a thread.
///
/// The path is that of the tool's centre. It comes in and goes out on arcs that touch the thread's
/// circle, with the slope of the thread, and every turn has its Z in absolute numbers.
///
/// # Errors
/// When the tool does not fit, or a number is none.
pub fn thread_mill(ask: &ThreadMill) -> Result<MillProgram, CalcError> {
    let plan = ThreadMillPlan::new(ask)?;
    Ok(MillProgram { text: program::write(ask, &plan), worked: worked(ask, &plan) })
}

fn worked(ask: &ThreadMill, plan: &ThreadMillPlan) -> WorkedCalculation {
    let units = ask.units;
    let length = QuantityKind::Length;
    let mut worked = WorkedCalculation::new(format!("Thread mill: {}", program::title(ask)), units);
    worked.input("D", "major diameter", length, ask.thread.major);
    worked.input("P", "pitch, the lead of one start", length, ask.thread.pitch);
    worked.input("d", "diameter of the tool", length, ask.tool_diameter);
    worked.input("T", "depth of the thread", length, ask.depth);
    let d = units.number(ask.tool_diameter);
    let (major, pitch) = (units.number(ask.thread.major), units.number(ask.thread.pitch));
    match ask.place {
        ThreadLocation::Inside => {
            let hole = ask.thread.minor_inside();
            let filled = format!("{major} − 1.082532·{pitch}");
            worked.intermediate(
                "D1",
                "the hole before threading",
                length,
                hole,
                "D − 1.082532·P",
                filled,
            );
            let filled = format!("({major} − {d})/2");
            worked.result(
                "R",
                "radius of the tool's centre",
                length,
                plan.radius_mm,
                "(D − d)/2",
                filled,
            );
        }
        ThreadLocation::Outside => {
            let root = plan.cut_diameter;
            match ask.root {
                Some(_) => worked.input("d3", "root diameter", length, root),
                None => {
                    let filled = format!("{major} − 1.226869·{pitch}");
                    worked.intermediate(
                        "d3",
                        "root diameter",
                        length,
                        root,
                        "D − 1.226869·P",
                        filled,
                    );
                }
            }
            let filled = format!("({} + {d})/2", units.number(root));
            worked.result(
                "R",
                "radius of the tool's centre",
                length,
                plan.radius_mm,
                "(d3 + d)/2",
                filled,
            );
        }
    }
    let turns = f64::from(plan.turns);
    match ask.cutter {
        ThreadMillCutter::Hob => {
            worked.result("N", "turns", QuantityKind::Number, turns, "1", "1".into());
        }
        ThreadMillCutter::Single => {
            let filled = format!("({} + {pitch})/{pitch}, rounded up", units.number(ask.depth));
            worked.result(
                "N",
                "turns: the last one ends above Z0",
                QuantityKind::Number,
                turns,
                "(T + P)/P",
                filled,
            );
        }
    }
    worked.result(
        "r",
        "radius of the arcs in and out",
        length,
        plan.to_mm(plan.lead_in),
        if plan.lead_in == plan.radius { "R" } else { "R/2" },
        units.number(plan.radius_mm) + if plan.lead_in == plan.radius { "" } else { "/2" },
    );
    let share = plan.ramp.text();
    worked.result(
        "z",
        "Z on the way in, and out",
        length,
        ask.thread.pitch * plan.ramp.share(),
        &format!("{share}·P"),
        format!("{share}·{pitch}"),
    );
    worked.note(program::direction(ask, plan));
    if let Some(note) = program::small_hole(ask) {
        worked.note(note);
    }
    worked.figure = figure(ask, plan);
    worked
}

/// The path seen from above.
fn figure(ask: &ThreadMill, plan: &ThreadMillPlan) -> Figure {
    let units = ask.units;
    let mut figure = Figure::default();
    let zero = Vec2::ZERO;
    let radius = plan.to_mm(plan.radius);
    let (inner, outer) = match ask.place {
        ThreadLocation::Inside => (ask.thread.minor_inside(), ask.thread.major),
        ThreadLocation::Outside => (plan.cut_diameter, ask.thread.major),
    };
    figure.circle(zero, inner / 2.0, LineStyle::Part);
    figure.circle(zero, outer / 2.0, LineStyle::Part);
    figure.circle(zero, radius, LineStyle::Path);
    let point = |at: [f64; 2]| Vec2::new(plan.to_mm(at[0]), plan.to_mm(at[1]));
    let (from, to) = (point(plan.arc_in), point(plan.arc_out));
    let (begin, touch) = (point(plan.start), Vec2::new(radius, 0.0));
    figure.line(begin, from, LineStyle::Path);
    let end = match ask.place {
        ThreadLocation::Inside => begin,
        ThreadLocation::Outside => Vec2::new(begin.a, to.b),
    };
    figure.line(to, end, LineStyle::Path);
    let center = point([plan.lead_center, 0.0]);
    let lead_in = plan.to_mm(plan.lead_in);
    let angle = |at: Vec2| atan2(at.b - center.b, at.a - center.a);
    let sweep = plan.lead_sense * plan.lead_sweep;
    figure.arc(center, lead_in, angle(from), sweep, LineStyle::Path);
    figure.arc(center, lead_in, angle(touch), sweep, LineStyle::Path);
    for quarter in [1.0, 2.0, 3.0] {
        let direction = quarter * FRAC_PI_2;
        figure.arrow(unit(direction) * radius, direction + plan.sense * FRAC_PI_2);
    }
    figure.circle(touch, ask.tool_diameter / 2.0, LineStyle::Cutter);
    let spoke = unit(1.25 * PI) * radius;
    figure.line(zero, spoke, LineStyle::Helper);
    figure.text(spoke * 0.6, format!("R {}", units.number(plan.radius_mm)));
    figure.point(zero, "");
    figure.point(from, "in");
    figure.point(to, "out");
    let reach = outer.max(2.0 * radius + ask.tool_diameter) / 2.0;
    let dimension = |figure: &mut Figure, diameter: f64, y: f64, name: &str| {
        let half = Vec2::new(diameter / 2.0, 0.0);
        figure.width(half * -1.0, half, y, format!("{name} {}", units.number(diameter)));
    };
    let (small, large) = match ask.place {
        ThreadLocation::Inside => ("D1", "D"),
        ThreadLocation::Outside => ("d3", "D"),
    };
    dimension(&mut figure, inner, -reach * 1.12, small);
    dimension(&mut figure, outer, -reach * 1.32, large);
    let half = Vec2::new(ask.tool_diameter / 2.0, 0.0);
    figure.width(
        touch - half,
        touch + half,
        reach * 1.12,
        format!("d {}", units.number(ask.tool_diameter)),
    );
    figure
}
