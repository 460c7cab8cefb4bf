//! The way of the tool, in least increments of the program, so that what is written is exact.

use super::{MillingDirection, RampSweep, ThreadMill, ThreadMillCutter};
use crate::error::{CalcError, bounded};
use crate::math::{FRAC_PI_2, PI};
use crate::numbers::AnswerUnit;
use crate::thread::{ThreadHand, ThreadLocation};

/// Turns beyond which a thread is a slip of the keyboard.
const MAX_TURNS: f64 = 2000.0;

/// The finest pitch, in least increments: its ramp of an eighth is still some of them.
const FINEST_PITCH: f64 = 40.0;

/// Where the tool goes. Lengths are in least increments unless they say mm.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ThreadMillPlan {
    /// Least increment, mm.
    pub step: f64,
    /// Diameter that the points of the teeth cut to, mm.
    pub cut_diameter: f64,
    /// Radius of the tool's centre before rounding, mm.
    pub radius_mm: f64,
    /// The same, rounded.
    pub radius: f64,
    /// Radius of the arcs in and out.
    pub lead_in: f64,
    /// X of the centre of both arcs; Y is 0.
    pub lead_center: f64,
    /// 1 counter-clockwise, −1 clockwise: the turns.
    pub sense: f64,
    /// The same of the arcs in and out.
    pub lead_sense: f64,
    /// Angle of each of these arcs, rad.
    pub lead_sweep: f64,
    /// Where the tool goes down and comes up.
    pub start: [f64; 2],
    /// Where the arc in begins.
    pub arc_in: [f64; 2],
    /// Where the arc out ends.
    pub arc_out: [f64; 2],
    /// Number of turns.
    pub turns: u32,
    /// Share of a turn for coming in.
    pub ramp: RampSweep,
    /// Z at the start of the arc in, after it and after each turn, and after the arc out.
    pub heights: Vec<f64>,
    /// Feed of the tool's centre, mm/s.
    pub feed: f64,
}

impl ThreadMillPlan {
    pub fn new(ask: &ThreadMill) -> Result<ThreadMillPlan, CalcError> {
        check_numbers(ask)?;
        let inside = ask.place == ThreadLocation::Inside;
        let step = step(ask.units);
        let cut_diameter = match ask.place {
            ThreadLocation::Inside => ask.thread.major,
            ThreadLocation::Outside => ask.root.unwrap_or_else(|| ask.thread.minor_outside()),
        };
        let tool = if inside { -ask.tool_diameter } else { ask.tool_diameter };
        let radius_mm = (cut_diameter + tool) / 2.0;
        let radius = (radius_mm / step).round();
        let ramp = ask.ramp.unwrap_or(match (inside, ask.wear) {
            (true, None) => RampSweep::Quarter,
            _ => RampSweep::Eighth,
        });
        let lead_in =
            if !inside && ramp == RampSweep::Quarter { radius } else { (radius / 2.0).round() };
        let sense = if inside == (ask.cut == MillingDirection::Climb) { 1.0 } else { -1.0 };
        let mut plan = ThreadMillPlan {
            step,
            cut_diameter,
            radius_mm,
            radius,
            lead_in,
            lead_center: if inside { radius - lead_in } else { radius + lead_in },
            sense,
            lead_sense: if inside { sense } else { -sense },
            lead_sweep: if inside && ramp == RampSweep::Quarter { PI } else { FRAC_PI_2 },
            start: [0.0; 2],
            arc_in: [0.0; 2],
            arc_out: [0.0; 2],
            turns: turns(ask)?,
            ramp,
            heights: Vec::new(),
            feed: ask.feed * 2.0 * radius_mm / cut_diameter,
        };
        plan.place_ends(ask);
        plan.heights = plan.heights(ask);
        plan.check_ends(ask)?;
        Ok(plan)
    }

    /// A length in increments, in mm.
    pub fn to_mm(&self, increments: f64) -> f64 {
        increments * self.step
    }

    /// Above 0 when the tool rises.
    pub fn rises(&self, ask: &ThreadMill) -> bool {
        // A right-hand helix rises counter-clockwise.
        (self.sense > 0.0) == (ask.hand == ThreadHand::Right)
    }

    fn place_ends(&mut self, ask: &ThreadMill) {
        let (center, lead_in) = (self.lead_center, self.lead_in);
        match (ask.place, self.ramp) {
            (ThreadLocation::Inside, RampSweep::Quarter) => {
                // Half a circle from the axis: the rounded half may miss it by an increment.
                self.arc_in = [center - lead_in, 0.0];
                self.arc_out = self.arc_in;
                self.start = self.arc_in;
            }
            (ThreadLocation::Inside, RampSweep::Eighth) => {
                self.arc_in = [center, -self.sense * lead_in];
                self.arc_out = [center, self.sense * lead_in];
                self.start = [0.0, 0.0];
            }
            (ThreadLocation::Outside, _) => {
                self.arc_in = [center, -self.sense * lead_in];
                self.arc_out = [center, self.sense * lead_in];
                let clear = (ask.thread.major + ask.tool_diameter) / 2.0 + ask.clearance;
                let straight = 2.0 * ask.wear.unwrap_or(0.0);
                let x = (clear / self.step).ceil().max(center + (straight / self.step).ceil());
                self.start = [x, self.arc_in[1]];
            }
        }
    }

    fn heights(&self, ask: &ThreadMill) -> Vec<f64> {
        let lead = ask.thread.pitch;
        let rise = if self.rises(ask) { lead } else { -lead };
        let turns = f64::from(self.turns);
        let first = if rise > 0.0 { -ask.depth } else { -ask.depth + turns * lead };
        let ramp = rise * self.ramp.share();
        let along = (0..=self.turns).map(|turn| first + f64::from(turn) * rise);
        let last = first + turns * rise + ramp;
        std::iter::once(first - ramp)
            .chain(along)
            .chain(std::iter::once(last))
            .map(|z| (z / self.step).round())
            .collect()
    }

    /// The start is clear of the part, and the leads have room for the wear.
    fn check_ends(&self, ask: &ThreadMill) -> Result<(), CalcError> {
        let units = ask.units;
        if ask.place == ThreadLocation::Inside && self.ramp == RampSweep::Eighth {
            let [x, y] = self.arc_in.map(|value| self.to_mm(value));
            let reach = 2.0 * (x * x + y * y).sqrt() + ask.tool_diameter;
            let hole = ask.thread.minor_inside();
            if reach > hole {
                return Err(CalcError::new(
                    format!(
                        "before an arc of 1/8 turn the tool with diameter {} would already cut to a diameter of {}; the hole has {}",
                        units.length(ask.tool_diameter),
                        units.length(reach),
                        units.length(hole)
                    ),
                    "use --ramp 1/4 without --compensation, or a smaller tool",
                ));
            }
        }
        let Some(wear) = ask.wear else { return Ok(()) };
        if ask.place == ThreadLocation::Inside && self.ramp == RampSweep::Quarter {
            return Err(CalcError::new(
                "compensation needs a straight lead-in, and a ramp of 1/4 turn in a hole is an arc from its axis",
                "take --ramp 1/8",
            ));
        }
        let straight = (self.arc_in[0] - self.start[0]).hypot(self.arc_in[1] - self.start[1]);
        let room = self.to_mm(straight.min(self.lead_in));
        if wear >= room {
            return Err(CalcError::new(
                format!(
                    "a wear of {} does not fit: the lead-in is a line of {} and an arc of {}",
                    units.length(wear),
                    units.length(self.to_mm(straight)),
                    units.length(self.to_mm(self.lead_in))
                ),
                "D holds only the wear of the tool: the program already gives the path of the tool centre",
            ));
        }
        Ok(())
    }
}

/// Least increment of a program's coordinates, mm.
fn step(units: AnswerUnit) -> f64 {
    units.mm() / f64::from(10u32.pow(units.word_decimals() as u32))
}

fn turns(ask: &ThreadMill) -> Result<u32, CalcError> {
    if ask.cutter == ThreadMillCutter::Hob {
        return Ok(1);
    }
    // One pitch more than the depth, so that the thread runs out above the part; what rounding
    // adds is no turn.
    let turns = ((ask.depth + ask.thread.pitch) / ask.thread.pitch - 1e-6).ceil();
    if turns <= MAX_TURNS {
        return Ok(turns.max(1.0) as u32);
    }
    Err(CalcError::new(
        format!(
            "a thread {} deep with a pitch of {} has {turns} turns; at most {MAX_TURNS} are written",
            ask.units.length(ask.depth),
            ask.units.length(ask.thread.pitch)
        ),
        "check depth and pitch",
    ))
}

fn check_numbers(ask: &ThreadMill) -> Result<(), CalcError> {
    let units = ask.units;
    ask.thread.check(units)?;
    let (root, wear) = (ask.root.unwrap_or(0.0), ask.wear.unwrap_or(0.0));
    bounded(&[ask.tool_diameter, ask.depth, ask.clearance, root, wear], &[], units)?;
    if ask.thread.starts != 1 {
        return Err(CalcError::new(
            format!("no program is written for a thread with {} starts", ask.thread.starts),
            "give one start; for each further start run the same program with Z0 higher by the pitch",
        ));
    }
    positive("the diameter", units.length(ask.thread.major), ask.thread.major)?;
    let finest = FINEST_PITCH * step(units);
    if ask.thread.pitch < finest {
        return Err(CalcError::new(
            format!(
                "a pitch of {} is too fine for a program with an increment of {}",
                units.length(ask.thread.pitch),
                units.length(step(units))
            ),
            format!("give a pitch of at least {}", units.length(finest)),
        ));
    }
    positive("the tool", units.length(ask.tool_diameter), ask.tool_diameter)?;
    positive("the depth", units.length(ask.depth), ask.depth)?;
    positive("the clearance", units.length(ask.clearance), ask.clearance)?;
    positive("the spindle", format!("{} rpm", ask.spindle), ask.spindle)?;
    positive("the feed", format!("{}/min", units.length(ask.feed * 60.0)), ask.feed)?;
    if let Some(wear) = ask.wear {
        positive("the wear", units.length(wear), wear)?;
    }
    fits(ask, units)
}

fn positive(what: &str, text: String, value: f64) -> Result<(), CalcError> {
    if value > 0.0 && value.is_finite() && value < 1e6 {
        return Ok(());
    }
    Err(CalcError::new(format!("{what} is {text}"), "give a number above zero"))
}

/// The tool goes into the hole, and the root is below the crest.
fn fits(ask: &ThreadMill, units: AnswerUnit) -> Result<(), CalcError> {
    match (ask.place, ask.root) {
        (ThreadLocation::Inside, Some(_)) => Err(CalcError::new(
            "a root diameter is for an outside thread; inside, the tool cuts to the major diameter",
            "leave --root out",
        )),
        (ThreadLocation::Inside, None) => {
            let hole = ask.thread.minor_inside();
            if ask.tool_diameter < hole {
                return Ok(());
            }
            Err(CalcError::new(
                format!(
                    "the tool with diameter {} does not fit into the hole of {} (thread {} less 1.082532·{})",
                    units.length(ask.tool_diameter),
                    units.length(hole),
                    units.length(ask.thread.major),
                    units.number(ask.thread.pitch)
                ),
                "use a smaller tool",
            ))
        }
        (ThreadLocation::Outside, None) => Ok(()),
        (ThreadLocation::Outside, Some(root)) => {
            // The sharp profile is the deepest there is.
            let sharp = ask.thread.sharp_root();
            if root > sharp.max(0.0) && root < ask.thread.major {
                return Ok(());
            }
            Err(CalcError::new(
                format!(
                    "a root diameter of {} is not between the major diameter of {} and {}, where a \
                     60° profile comes to a point",
                    units.length(root),
                    units.length(ask.thread.major),
                    units.length(sharp)
                ),
                "give the diameter at the bottom of the thread",
            ))
        }
    }
}
