//! Holes as canned cycles.

use chordal::control::table::DwellWord;
use chordal::control::{
    Action, CycleKind, DrilledHole, FeedMode, HoleForm, ModeCode, Position, is_same_level,
};
use chordal::geometry::Plane;

use super::{CommandEmitter, EmitRefusal};
use crate::convert::numbers;

/// A canned cycle that is active.
#[derive(Clone, Debug)]
pub(in crate::convert) struct WrittenCycle {
    hole: DrilledHole,
    /// The level before its first hole, to which G98 returns.
    initial_mm: f64,
    returns_to_r: bool,
}

impl WrittenCycle {
    /// Another hole needs a place only.
    pub(in crate::convert) fn goes_on(&self, hole: &DrilledHole) -> bool {
        self.hole.is_like(hole)
            && (self.returns_to_r || is_same_level(self.initial_mm, hole.retract_mm))
    }
}

impl CommandEmitter<'_> {
    /// The cycle of this control that may make a hole; the comparison of both runs decides whether it does.
    pub(in crate::convert) fn cycle_of(&self, hole: &DrilledHole) -> Option<WrittenCycle> {
        let returns_to_r = is_same_level(hole.retract_mm, hole.start_mm);
        let returns = returns_to_r || is_same_level(hole.retract_mm, hole.initial_mm);
        let is_downward = hole.bottom_mm < hole.start_mm && hole.start_mm <= hole.initial_mm;
        let is_kept = hole.plane == Plane::Xy && self.plane == Plane::Xy && returns && is_downward;
        let kind = self.kind_of(hole)?;
        self.code(Action::Cycle(kind))?;
        is_kept.then(|| WrittenCycle {
            hole: hole.clone(),
            initial_mm: hole.initial_mm,
            returns_to_r,
        })
    }

    fn kind_of(&self, hole: &DrilledHole) -> Option<CycleKind> {
        let rules = &self.to.parameters.rules;
        Some(match hole.form()? {
            HoleForm::Drilled { dwell_s: 0.0 } => CycleKind::Drill,
            HoleForm::Drilled { .. } => CycleKind::DrillDwell,
            HoleForm::FedOut { feed_out, .. } if feed_out != hole.feed.value => return None,
            HoleForm::FedOut { dwell_s: 0.0, .. } => CycleKind::BoreFeedOut,
            HoleForm::FedOut { .. } => CycleKind::BoreDwell,
            HoleForm::Pecked { is_full: true, back_mm, .. } => {
                is_same_level(back_mm, rules.peck_clearance_mm).then_some(CycleKind::Peck)?
            }
            HoleForm::Pecked { is_full: false, back_mm, .. } => {
                is_same_level(back_mm, rules.chip_break_mm).then_some(CycleKind::ChipBreak)?
            }
        })
    }

    /// The block that begins a cycle with its first hole at a place.
    pub(in crate::convert) fn begin_cycle(
        &mut self,
        cycle: &WrittenCycle,
        place: &Position,
    ) -> Result<(), EmitRefusal> {
        let hole = &cycle.hole;
        let kind = self.kind_of(hole).ok_or("no cycle for this hole")?;
        let back = match cycle.returns_to_r {
            true => ModeCode::ReturnToR,
            false => ModeCode::ReturnInitial,
        };
        self.flush();
        let back = self.due(Action::Mode(back))?;
        self.motion = None;
        let mut words = self.head(Action::Cycle(kind))?;
        words.insert(0, back);
        words.push(format!("X{}", self.place(0, place[0])));
        words.push(format!("Y{}", self.length(place[1])));
        words.push(format!("Z{}", self.length(hole.bottom_mm)));
        words.push(self.level_word(hole.start_mm));
        match hole.form() {
            Some(HoleForm::Drilled { dwell_s } | HoleForm::FedOut { dwell_s, .. })
                if dwell_s > 0.0 =>
            {
                let rules = &self.to.parameters.rules.cycles;
                let word = DwellWord {
                    letter: b'P',
                    integer_s: rules.dwell_integer_s,
                    point_s: rules.dwell_point_s,
                    takes_point: true,
                };
                words.push(numbers::time_word(dwell_s, word));
            }
            Some(HoleForm::Pecked { first_mm, .. }) => {
                words.push(format!("Q{}", self.length(first_mm)));
            }
            Some(HoleForm::Drilled { .. } | HoleForm::FedOut { .. }) | None => {}
        }
        let unit = self.units.mm();
        let value = match hole.feed.mode {
            FeedMode::PerTime => hole.feed.value * 60.0 / unit,
            FeedMode::PerRevolution => hole.feed.value / unit,
            FeedMode::InverseTime => return Err("a canned cycle in inverse time".into()),
        };
        self.feed = None;
        self.feed(&mut words, &hole.feed, value);
        self.line(&words);
        Ok(())
    }

    /// The next hole of the active cycle.
    pub(in crate::convert) fn next_hole(&mut self, from: &Position, to: &Position) {
        let mut words = Vec::new();
        for (axis, letter) in [(0, 'X'), (1, 'Y')] {
            if from[axis] != to[axis] || (axis == 0 && from[..2] == to[..2]) {
                words.push(format!("{letter}{}", self.place(axis, to[axis])));
            }
        }
        self.line(&words);
    }

    /// Ends the active cycle.
    pub(in crate::convert) fn end_cycle(&mut self) -> Result<(), EmitRefusal> {
        let end = self.due(Action::Mode(ModeCode::CancelCycle))?;
        self.line(&[end]);
        self.motion = None;
        Ok(())
    }

    fn level_word(&self, mm: f64) -> String {
        let level = self.length(mm);
        match (self.to.table.lexicon.registers, level.starts_with('-')) {
            (false, _) => format!("R{level}"),
            (true, true) => format!("R0{level}"),
            (true, false) => format!("R0+{level}"),
        }
    }
}
