//! Drilling cycles: kept where they make the same moves as the hole.

use chordal_command::{CommandKind, SpindleState};
use chordal_kernel::{
    DrilledHole, HoleForm, HoleMotion, PostedKind, TappedHole, are_same_motions, plain_number,
};

use super::block_writer::{BlockWriter, WordGroup};
use crate::cycles::{CycleArguments, HoleContext, HoleStep, drilling_moves};

/// The number of arguments before DTB, which all drilling cycles share: RTP, RFP, SDIS, DP, DPR.
const LEVELS: usize = 5;

/// A drilling cycle with its arguments.
#[derive(Clone, PartialEq, Debug)]
struct CycleWords {
    name: &'static str,
    arguments: Vec<Option<f64>>,
}

impl CycleWords {
    /// A cycle with the levels and further arguments, from DTB or FDEP on.
    fn new(name: &'static str, levels: [f64; 3], more: &[Option<f64>]) -> CycleWords {
        let [retract, start, bottom] = levels.map(Some);
        let mut arguments = vec![retract, start, Some(0.0), bottom, None];
        arguments.extend_from_slice(more);
        while arguments.len() > LEVELS - 1 && arguments.last() == Some(&None) {
            arguments.pop();
        }
        CycleWords { name, arguments }
    }

    fn text(&self) -> String {
        let argument =
            |value: &Option<f64>| value.map_or_else(String::new, |value| plain_number(value, 6));
        let arguments: Vec<String> = self.arguments.iter().map(argument).collect();
        format!("{}({})", self.name, arguments.join(","))
    }
}

impl BlockWriter<'_> {
    /// Before a move after which a hole is drilled: makes its cycle active, or ends the one that is.
    pub fn prepare_cycle(&mut self, command: &CommandKind) {
        if command.motion().is_none() {
            return;
        }
        let next = self.step + 1;
        let Some(PostedKind::Hole(hole)) = self.program.steps.get(next).map(|step| &step.kind)
        else {
            return self.end_modal_call();
        };
        let Some(words) = self.kept_cycle(hole, next) else { return self.end_modal_call() };
        let text = words.text();
        if self.modal_call.as_ref() != Some(&text) {
            self.end_modal_call();
            self.alone(format!("MCALL {text}"));
            self.modal_call = Some(text);
        }
        self.wait_for_feed(hole);
        self.edge_of_hole();
    }

    /// A hole: by the active cycle, by a call, or as moves.
    pub fn hole(&mut self, hole: &DrilledHole) -> Result<(), String> {
        let before = self.step.checked_sub(1).and_then(|before| self.program.steps.get(before));
        let is_after_move = before.is_some_and(|step| match &step.kind {
            PostedKind::Command(command) => command.motion().is_some(),
            PostedKind::MachineMove { .. } | PostedKind::Hole(_) | PostedKind::Tap(_) => false,
        });
        if let Some(words) = self.kept_cycle(hole, self.step) {
            let text = words.text();
            if !(is_after_move && self.modal_call.as_ref() == Some(&text)) {
                self.end_modal_call();
                self.wait_for_feed(hole);
                self.edge_of_hole();
                self.alone(text.clone());
            }
            self.note(text, "the cycle with the same steps");
            return Ok(());
        }
        self.end_modal_call();
        self.note("", "a hole that is written out as moves: no cycle has the same steps");
        for command in &hole.written_out {
            self.command(command)?;
        }
        Ok(())
    }

    /// A thread: CYCLE84, which leads the tap in step with the spindle.
    pub fn tap(&mut self, tap: &TappedHole) -> Result<(), String> {
        self.end_modal_call();
        if self.edge.desired != Some(self.tool) || self.tool == 0 {
            return Err("a tap without the length of its tool: CYCLE84 needs D".into());
        }
        if tap.plane != self.plane {
            return Err("a tap that is not along the normal of the plane".into());
        }
        let lead = tap.lead_mm().ok_or("a tap without a lead")?;
        let (_, _, normal) = tap.plane.axes();
        let unit = self.lengths.units.mm();
        let level = |mm: f64| self.lengths.rounded(mm) / unit;
        let (start, bottom) = (level(tap.start[normal]), level(tap.bottom_mm));
        let after = match tap.spindle[1] {
            SpindleState::Cw => 3.0,
            SpindleState::Ccw => 4.0,
            SpindleState::Off | SpindleState::Oriented => 5.0,
        };
        let hand = if tap.is_left { -1.0 } else { 1.0 };
        let more = [
            (tap.dwell_s > 0.0).then_some(tap.dwell_s),
            Some(after),
            None,
            Some(hand * lead / unit),
            Some(0.0),
            Some(tap.rpm),
            (tap.out_factor != 1.0).then_some(tap.rpm * tap.out_factor),
        ];
        let words = CycleWords::new("CYCLE84", [start, start, bottom], &more).text();
        self.edge_of_hole();
        self.alone(words.clone());
        self.spindle.0 = tap.spindle[1];
        self.note(
            words,
            "the tap in step with the spindle: it needs a spindle in position control",
        );
        Ok(())
    }

    /// F of a hole, where another one is active.
    fn wait_for_feed(&mut self, hole: &DrilledHole) {
        if let Some(word) = self.cycle_feed(&hole.feed) {
            self.wait(WordGroup::Feed, word);
        }
    }

    /// The edge before a hole, whose moves go along the tool. A kept cycle has a length of this control.
    fn edge_of_hole(&mut self) {
        if self.edge.is_due
            && let Ok(word) = self.set_edge()
        {
            word.into_iter().for_each(|word| self.wait(WordGroup::Edge, word));
        }
    }

    /// The cycle that makes exactly this hole.
    fn kept_cycle(&self, hole: &DrilledHole, at: usize) -> Option<CycleWords> {
        // Without an edge the control drills no cycle.
        let has_edge = self.edge.desired == Some(self.tool) && self.tool > 0;
        let is_kept = has_edge
            && !self.options.written_out.contains(&at)
            && hole.plane == self.plane
            && hole.feed.value.is_finite()
            && hole.feed.value > 0.0;
        if !is_kept {
            return None;
        }
        self.candidates(hole)?.into_iter().find(|words| self.makes(words, hole))
    }

    /// Cycles that may make this hole.
    fn candidates(&self, hole: &DrilledHole) -> Option<Vec<CycleWords>> {
        let unit = self.lengths.units.mm();
        let levels = [hole.retract_mm, hole.start_mm, hole.bottom_mm]
            .map(|level| self.lengths.rounded(level) / unit);
        let time = |value: f64| (value > 0.0).then_some(value);
        Some(match hole.form()? {
            HoleForm::Drilled { dwell_s: 0.0 } => vec![CycleWords::new("CYCLE81", levels, &[])],
            HoleForm::Drilled { dwell_s } => {
                vec![CycleWords::new("CYCLE82", levels, &[time(dwell_s)])]
            }
            HoleForm::FedOut { dwell_s, feed_out } => {
                let [inward, outward] =
                    [hole.feed.value, feed_out].map(|value| self.feed_argument(&hole.feed, value));
                let ream = [time(dwell_s), Some(inward), Some(outward)];
                let bore = CycleWords::new("CYCLE89", levels, &[time(dwell_s)]);
                let ream = CycleWords::new("CYCLE85", levels, &ream);
                if dwell_s > 0.0 { vec![bore, ream] } else { vec![ream, bore] }
            }
            HoleForm::Pecked { is_full, first_mm, back_mm, dwell_s } => {
                let first = first_mm / unit;
                let back = Some(back_mm / unit);
                let (lift, reentry) = if is_full { (None, back) } else { (back, None) };
                // Equal steps whose last one is halved, and equal steps that end at the bottom.
                let steps = [(0.0, None), (-1.0, None)];
                let deep = |(amount, least): (f64, Option<f64>)| {
                    let variant = if is_full { 1.0 } else { 0.0 };
                    let more = [
                        None,
                        Some(first),
                        Some(amount),
                        time(dwell_s),
                        None,
                        None,
                        Some(variant),
                        None,
                        least,
                        lift,
                        None,
                        reentry,
                    ];
                    CycleWords::new("CYCLE83", levels, &more)
                };
                steps.into_iter().map(deep).collect()
            }
        })
    }

    /// Whether a cycle makes the steps of a hole.
    fn makes(&self, words: &CycleWords, hole: &DrilledHole) -> bool {
        let unit_mm = self.lengths.units.mm();
        let context = HoleContext {
            current_level: hole.initial_mm / unit_mm,
            unit_mm,
            ..HoleContext::default()
        };
        let arguments = CycleArguments::new(&words.arguments);
        let Ok(steps) = drilling_moves(words.name, &arguments, &context) else { return false };
        let modal = hole.feed.value;
        let argument = self.feed_argument(&hole.feed, 1.0);
        let motion = |step: HoleStep| match step {
            HoleStep::Rapid(level) => Some(HoleMotion::Rapid(level * unit_mm)),
            HoleStep::Feed { to, factor } => {
                Some(HoleMotion::Cut { to_mm: to * unit_mm, feed: modal * factor })
            }
            HoleStep::FeedAt { to, feed } => {
                Some(HoleMotion::Cut { to_mm: to * unit_mm, feed: feed / argument })
            }
            HoleStep::Dwell { seconds } => Some(HoleMotion::Dwell(seconds)),
            HoleStep::DwellRevolutions { .. }
            | HoleStep::SpindleStop
            | HoleStep::SpindleReverse
            | HoleStep::SpindleRestore(_)
            | HoleStep::Orient { .. }
            | HoleStep::RapidInPlane { .. }
            | HoleStep::Stop
            | HoleStep::TapIn { .. }
            | HoleStep::TapOut { .. } => None,
        };
        let made: Option<Vec<HoleMotion>> = steps.into_iter().map(motion).collect();
        made.is_some_and(|made| are_same_motions(&made, &hole.motions))
    }
}
