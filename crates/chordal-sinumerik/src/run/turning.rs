//! Carries out the turning cycles.

use chordal_diagnostics::{Code, TextRange};
use chordal_kernel::{ContourProfile, RoughWords};

use super::interpreter::Interpreter;
use super::words::{BlockStatementView, BlockWords};
use crate::cycles::{CycleArguments, ThreadStep, thread_moves};
use crate::values::SinumerikValue;

/// Places of the parameters of CYCLE95.
const MAX_INFEED: usize = 1;
const ALLOWANCE_Z: usize = 2;
const ALLOWANCE_X: usize = 3;
const ALLOWANCE: usize = 4;
const ROUGH_FEED: usize = 5;
const FINISH_FEED: usize = 7;
const VARIANT: usize = 8;
const LIFT: usize = 11;

/// How far the tool lifts from the contour where the program does not say it, mm (Cycles 11/2006, CYCLE95).
const LIFT_MM: f64 = 1.0;

const X: usize = 0;
const Z: usize = 2;

impl Interpreter<'_> {
    /// Carries out CYCLE95 or CYCLE97.
    pub(super) fn run_turning(
        &mut self,
        name: &str,
        arguments: &[Option<SinumerikValue>],
        numbers: &CycleArguments,
        range: TextRange,
    ) {
        if !self.kernel.machine.turns() {
            let what = format!("{name} is not followed: this machine is no lathe");
            return self.not_followed(range, what);
        }
        if !self.has_edge_for_cycle(name, range) {
            return;
        }
        match name {
            "CYCLE95" => self.remove_stock(arguments, numbers, range),
            _ => self.turn_thread(numbers, range),
        }
    }

    /// CYCLE97: each pass from the run-in to the run-out.
    fn turn_thread(&mut self, numbers: &CycleArguments, range: TextRange) {
        let steps = match thread_moves(numbers) {
            Ok(steps) => steps,
            Err(fault) => return self.report_cycle(fault, range),
        };
        self.report_assumed_path("CYCLE97", range);
        let state = &self.kernel.state;
        if state.rpm <= 0.0 && state.surface_speed.is_none() && !state.unknown.speed {
            let message = "a thread, and the spindle has no speed";
            self.alarm(10900, Code::SpindleStopped, range, message);
        }
        let unit = self.unit_mm();
        let words = BlockWords::default();
        let view = BlockStatementView { span: self.span(range), words: &words };
        self.kernel.origin.cycle = true;
        for step in steps {
            let mut place = self.programmed_position();
            match step {
                ThreadStep::Rapid([x, z]) => {
                    (place[X], place[Z]) = (x * unit, z * unit);
                    self.rapid_to(place);
                }
                ThreadStep::Cut { to: [x, z], lead_mm } => {
                    (place[X], place[Z]) = (x * unit, z * unit);
                    let target = self.mapped(place);
                    self.kernel.turned_thread(&view, target, [lead_mm, 0.0]);
                }
            }
        }
        self.kernel.origin.cycle = false;
    }

    /// CYCLE95: roughing in passes, finishing along the contour, or both.
    fn remove_stock(
        &mut self,
        arguments: &[Option<SinumerikValue>],
        numbers: &CycleArguments,
        range: TextRange,
    ) {
        let Some(Some(SinumerikValue::Text(name))) = arguments.first() else {
            let message = "CYCLE95 needs the name of its contour";
            return self.alarm(14020, Code::MissingWord, range, message);
        };
        let variant = numbers.get(VARIANT).unwrap_or(0.0).round() as i64;
        if !(1..=12).contains(&variant) {
            let message = format!("VARI is {variant}: it must be 1 to 12");
            return self.alarm(61002, Code::BadArgument, range, message);
        }
        let Some(commands) = self.record_contour(&name.clone(), range) else { return };
        let profile = ContourProfile::of(&commands).filter(|profile| !profile.edges.is_empty());
        let Some(profile) = profile else {
            let message = format!("the contour {name} has no moves");
            return self.alarm(61605, Code::BadArgument, range, message);
        };
        self.report_assumed_path("CYCLE95", range);
        let unit = self.unit_mm();
        let number = |place: usize| numbers.get(place).unwrap_or(0.0).abs() * unit;
        let feed = |place: usize| numbers.get(place).filter(|feed| *feed > 0.0);
        let lift = if number(LIFT) > 0.0 { number(LIFT) } else { LIFT_MM };
        let all = number(ALLOWANCE);
        let allowance = [number(ALLOWANCE_X).max(all), number(ALLOWANCE_Z).max(all)];
        // The ones of the variant: along Z or X, outside or inside; then roughing, finishing, both.
        let (form, work) = ((variant - 1) % 4, (variant - 1) / 4);
        let is_inside = form >= 2;
        let start = start_of(&profile, allowance, lift, is_inside);
        let words = BlockWords::default();
        let view = BlockStatementView { span: self.span(range), words: &words };
        let mut place = self.kernel.state.position;
        (place[X], place[Z]) = (start[0], start[1]);
        let mut named = chordal_command::AxisMask::NONE;
        named.insert(X);
        named.insert(Z);
        self.kernel.rapid_to(place, named);
        if work != 1 {
            if number(MAX_INFEED) <= 0.0 {
                let message = "MID, the depth of a pass, is missing";
                return self.alarm(61112, Code::BadArgument, range, message);
            }
            let left = if work == 2 || work == 0 { allowance } else { [0.0; 2] };
            let rough = RoughWords {
                along_x: form % 2 == 1,
                allowance: if is_inside { [-left[0], left[1]] } else { left },
                depth: number(MAX_INFEED),
                retract: lift,
                rough_allowance: [0.0; 2],
                pockets: true,
            };
            self.with_cycle_feed(feed(ROUGH_FEED), |own| {
                own.kernel.rough(&view, &rough, &profile);
            });
        }
        if work != 0 {
            self.with_cycle_feed(feed(FINISH_FEED), |own| {
                own.kernel.follow_contour(&view, &profile, start);
            });
        }
    }
}

/// Where the passes begin: beyond the contour on both axes.
fn start_of(profile: &ContourProfile, allowance: [f64; 2], lift: f64, is_inside: bool) -> [f64; 2] {
    let radii = profile.edges.iter().map(|edge| edge.to[0]).chain([profile.start[0]]);
    let forth = if profile.end()[1] < profile.start[1] { 1.0 } else { -1.0 };
    let x = if is_inside {
        radii.fold(f64::INFINITY, f64::min) - allowance[0] - lift
    } else {
        radii.fold(f64::NEG_INFINITY, f64::max) + allowance[0] + lift
    };
    [x, profile.start[1] + forth * (allowance[1] + lift)]
}
