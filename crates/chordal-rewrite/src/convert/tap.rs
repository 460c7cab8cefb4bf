//! Taps from what they do: a cycle of the new control for each thread, since plain moves would leave the
//! spindle behind.

use chordal::control::Action;
use chordal::control::CycleKind;
use chordal::control::{Control, Feed, FeedMode, SpindleState, TapFeed, TappedHole, Units};
use chordal::{Command, CommandKind};

use super::numbers;
use crate::source::WordStyle;

/// A thread that was tapped, along Z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TappedThread {
    pub kind: CycleKind,
    /// Where the tap begins, mm.
    from: [f64; 3],
    depth: f64,
    feed: Feed,
    dwell_s: f64,
}

/// How many commands of a block are a tap, its overrides at both ends included; 0 where none begins.
pub(crate) fn length(commands: &[Command]) -> usize {
    let is = |command: &Command, on: bool| match command.kind {
        CommandKind::Overrides(overrides) => command.origin.cycle && overrides.feed == on,
        _ => false,
    };
    if !commands.first().is_some_and(|command| is(command, false)) {
        return 0;
    }
    commands.iter().position(|command| is(command, true)).map_or(commands.len(), |end| end + 1)
}

impl TappedThread {
    /// The thread that commands cut.
    pub fn of(commands: &[Command]) -> Result<TappedThread, String> {
        let mut cuts = Vec::new();
        let (mut turns, mut dwell_s) = (Vec::new(), 0.0);
        for command in commands {
            match &command.kind {
                CommandKind::Line { motion, feed } => cuts.push((motion, feed)),
                CommandKind::Dwell { seconds, .. } if cuts.len() == 1 => dwell_s = *seconds,
                CommandKind::Dwell { .. } => return Err("a tap with a dwell at its start".into()),
                CommandKind::Spindle { state, .. } => turns.push((cuts.len(), *state)),
                _ => {}
            }
        }
        let [(down, feed), (up, out)] = cuts.as_slice() else {
            return Err("a tap in several steps".into());
        };
        if up.to[..3] != down.from[..3] {
            return Err(
                "a tap that feeds out further than it went in: the spindle would not follow".into(),
            );
        }
        let along_z = down.from[..2] == down.to[..2] && down.from[3..] == down.to[3..];
        if feed.value != out.value {
            return Err("a tap that feeds out at a different speed than in".into());
        }
        if !along_z || !down.from_known.has(2) {
            return Err("a tap that does not go along Z from a known level".into());
        }
        let back = turns.iter().find(|(cut, state)| *cut == 1 && *state != SpindleState::Off);
        let kind = match back {
            Some((_, SpindleState::Ccw)) => CycleKind::Tap,
            Some((_, SpindleState::Cw)) => CycleKind::LeftTap,
            _ => return Err("a tap without a reversal of the spindle".into()),
        };
        let from = [down.from[0], down.from[1], down.from[2]];
        Ok(TappedThread { kind, from, depth: down.to[2], feed: **feed, dwell_s })
    }

    /// The thread of a program that is written from its run.
    pub fn of_hole(hole: &TappedHole) -> TappedThread {
        let [x, y, z, ..] = hole.start;
        TappedThread {
            kind: if hole.is_left { CycleKind::LeftTap } else { CycleKind::Tap },
            from: [x, y, z],
            depth: hole.bottom_mm,
            feed: Feed { spindle_rev_per_s: hole.rpm / 60.0, ..hole.feed },
            dwell_s: hole.dwell_s,
        }
    }

    /// The words after the code, for a tool that stands where the tap begins; nothing where F cannot be
    /// said.
    pub fn words(
        &self,
        to: &Control,
        units: Units,
        style: WordStyle,
        length: impl Fn(f64) -> String,
    ) -> Option<Vec<String>> {
        let unit = units.mm();
        let rpm = self.feed.spindle_rev_per_s * 60.0;
        let per_minute = match self.feed.mode {
            FeedMode::PerRevolution => self.feed.value * rpm / unit,
            _ => self.feed.value * 60.0 / unit,
        };
        let [x, y, z] = self.from.map(&length);
        let mut words = vec![format!("X{x}"), format!("Y{y}"), format!("Z{}", length(self.depth))];
        words.push(match (to.table.lexicon.registers, z.starts_with('-')) {
            (false, _) => format!("R{z}"),
            (true, true) => format!("R0{z}"),
            (true, false) => format!("R0+{z}"),
        });
        let rules = to.parameters.rules.cycles;
        if self.dwell_s > 0.0 || rules.tap.keeps_dwell {
            let count = self.dwell_s / rules.dwell_point_s;
            words.push(format!("P{}", numbers::plain(count, 3, style)));
        }
        let has_speed = rpm > 0.0;
        match rules.tap.feed {
            TapFeed::Programmed if self.feed.mode == FeedMode::PerRevolution => {
                words.push(format!("F{}", numbers::feed(self.feed.value / unit, style)));
            }
            TapFeed::Programmed => words.push(format!("F{}", numbers::feed(per_minute, style))),
            TapFeed::Lead if has_speed => {
                words.push(format!("F{}", numbers::plain(per_minute / rpm, 6, style)));
            }
            TapFeed::SpeedWithLeadQ if has_speed => {
                words.push(format!("F{}", numbers::plain(rpm, 3, style)));
                words.push(format!("Q{}", numbers::plain(per_minute / rpm, 6, style)));
            }
            _ => return None,
        }
        Some(words)
    }

    /// The bottom along Z and the lead, mm, for a cut in step with the spindle there and back; nothing for a tap that waits
    /// or turns the other way.
    pub fn in_step(&self) -> Option<(f64, f64)> {
        let plain = self.dwell_s == 0.0 && self.kind == CycleKind::Tap;
        let lead = match self.feed.mode {
            FeedMode::PerRevolution => self.feed.value,
            _ => self.feed.value / self.feed.spindle_rev_per_s,
        };
        (plain && lead.is_finite() && lead > 0.0).then_some((self.depth, lead))
    }

    pub fn action(&self) -> Action {
        Action::Cycle(self.kind)
    }
}
