//! Work, length and radius offsets: the words that bring them into force, and the data that a program sets.

use chordal::CommandKind;
use chordal::control::table::DataTarget;
use chordal::control::{Action, LengthCode, ModeCode, OnceCode, ReadingCode};
use chordal::control::{CompensationSide, Control, WorkName};

use super::codes;
use super::context::ConvertContext;
use super::draft::{BlockDraft, NeedsExpansion};
use super::translate::LENGTHS;
use crate::source::whole;

impl ConvertContext<'_> {
    /// E, H and D where they act by themselves.
    pub(super) fn offsets(&self, draft: &mut BlockDraft, at: usize) -> Result<(), NeedsExpansion> {
        let title = self.to.table.title;
        if self.from.table.work_names.by_e && !self.to.table.work_names.by_e {
            let e = draft.place(b'E');
            if let Some(e) = e {
                let number = whole(Some(&draft.block.words[e]));
                let number = number.and_then(|number| u16::try_from(number).ok());
                match number {
                    Some(0) => draft.remove(e, "E0 is the machine zero: G53 for its moves"),
                    Some(number) => {
                        let name = WorkName::E(number);
                        let new = codes::work_offset(name, self.to, self.style());
                        let new =
                            new.ok_or_else(|| NeedsExpansion(format!("{title} has no E{number}")))?;
                        draft.replace(e, new.clone(), format!("E{number} is {new} on {title}"));
                    }
                    None => {
                        return Err(NeedsExpansion(
                            "the number of the work offset is computed".into(),
                        ));
                    }
                }
            }
            let in_machine = self.run(at).is_some_and(|run| run.after.work == WorkName::Machine);
            if in_machine
                && draft.block.letters().meets(LENGTHS)
                && let Some(code) =
                    codes::name(Action::Once(OnceCode::MachineCoordinates), self.to, self.style())
            {
                draft.lead(code, "the move goes to machine coordinates (E0)");
            }
        }
        let by_h = self.from.parameters.length_by_h_alone;
        if by_h && !self.to.parameters.length_by_h_alone {
            self.length(draft, at);
        }
        self.radius_number(draft, at);
        self.machine_move(draft, at);
        self.written_data(draft, at)
    }

    /// G53 in G91, where the new control does not move then.
    fn machine_move(&self, draft: &mut BlockDraft, at: usize) {
        let needs = |control: &Control| {
            let parameters = &control.parameters;
            parameters.rules.machine_move_needs_absolute || parameters.strict_words
        };
        let Some(run) = self.run(at).filter(|_| needs(self.to) && !needs(self.from)) else {
            return;
        };
        let machine = Action::Once(OnceCode::MachineCoordinates);
        if !run.after.incremental || !self.source.has_action(at, self.from, |own| own == machine) {
            return;
        }
        let style = self.style();
        let code = |code: ReadingCode| codes::name(Action::Reading(code), self.to, style);
        if let (Some(absolute), Some(incremental)) =
            (code(ReadingCode::Absolute), code(ReadingCode::Incremental))
        {
            let does = match self.to.parameters.rules.machine_move_needs_absolute {
                true => "ignores",
                false => "refuses",
            };
            draft.lead(absolute, format!("{} {does} G53 in G91", self.to.table.title));
            draft.after.push(incremental);
        }
    }

    /// What G10 writes: L and P by what they mean.
    fn written_data(&self, draft: &mut BlockDraft, at: usize) -> Result<(), NeedsExpansion> {
        if !self
            .source
            .has_action(at, self.from, |action| action == Action::Once(OnceCode::SetData))
        {
            return Ok(());
        }
        let place = |letter| draft.place(letter);
        let (l, p) = (place(b'L'), place(b'P'));
        let number = |at: Option<usize>| whole(at.map(|at| &draft.block.words[at]));
        let (Some(l), Some(code)) = (l, number(l)) else { return Ok(()) };
        let of = |control: &Control, code: u32| {
            let row = control.table.set_data.iter().find(|row| u32::from(row.0) == code);
            row.map(|row| row.1)
        };
        let Some(target) = of(self.from, code) else { return Ok(()) };
        let there = |target: DataTarget| {
            self.to.table.set_data.iter().find(|row| row.1 == target).map(|row| row.0)
        };
        let title = self.to.table.title;
        let extended = number(p).filter(|_| target == DataTarget::ExtendedWorkOffset);
        let by_e = number(p).filter(|number| {
            target == DataTarget::WorkOffset && self.from.table.work_names.by_e && *number > 6
        });
        if let (Some(number), Some(p)) = (extended, p)
            && there(DataTarget::ExtendedWorkOffset).is_none()
            && let Some(new) = there(DataTarget::WorkOffset)
        {
            draft.replace(
                l,
                format!("L{new}"),
                format!("{title} numbers all work offsets in one series"),
            );
            draft.replace(p, format!("P{}", number + 6), "the same work offset");
        } else if let (Some(number), Some(p)) = (by_e, p)
            && let Some(new) = there(DataTarget::ExtendedWorkOffset)
        {
            draft.replace(
                l,
                format!("L{new}"),
                format!("{title} numbers work offsets from E7 on in a second series"),
            );
            draft.replace(p, format!("P{}", number - 6), "the same work offset");
        } else if of(self.to, code) != Some(target) {
            let new = there(target);
            let has_form =
                !matches!(target, DataTarget::Other | DataTarget::IntoRegister | DataTarget::Lines);
            let Some(new) = new.filter(|_| has_form) else {
                return Err(NeedsExpansion(format!("{title} has no G10 L{code}")));
            };
            draft.replace(l, format!("L{new}"), format!("{title} uses another L for this"));
        }
        let radius = matches!(
            target,
            DataTarget::Tool(
                chordal::control::ToolValue::Radius | chordal::control::ToolValue::RadiusWear
            )
        );
        if radius
            && self.from.parameters.rules.radius_offsets != self.to.parameters.rules.radius_offsets
        {
            return Err(NeedsExpansion(format!(
                "{title} stores the other value (diameter or radius)"
            )));
        }
        Ok(())
    }

    /// `H1` brings the length into force by itself on one control, by G43 on the others.
    fn length(&self, draft: &mut BlockDraft, at: usize) {
        let own = self.source.has_action(at, self.from, |action| {
            matches!(
                action,
                Action::Length(LengthCode::Plus)
                    | Action::Length(LengthCode::Minus)
                    | Action::Length(LengthCode::Cancel)
                    | Action::Once(OnceCode::SetData)
            )
        });
        let Some(h) = draft.place(b'H') else { return };
        let Some(number) = whole(Some(&draft.block.words[h])).filter(|_| !own) else { return };
        let title = self.to.table.title;
        let written = draft.written(h);
        if number == 0 && !codes::has_lengths(self.to) {
            draft.remove(h, codes::without_lengths(self.to));
        } else if number == 0 {
            let Some(code) = codes::name(Action::Length(LengthCode::Cancel), self.to, self.style())
            else {
                return;
            };
            draft.replace(
                h,
                code,
                format!(
                    "{written} alone cancels the length offset only on {}",
                    self.from.table.title
                ),
            );
        } else if let Some(code) =
            codes::name(Action::Length(LengthCode::Plus), self.to, self.style())
        {
            let gap = self.style().gap();
            draft.replace(h, format!("{code}{gap}{written}"), format!("{title} needs G43 with H"));
        } else {
            draft.remove(h, codes::without_lengths(self.to));
        }
    }

    /// The number of the radius offset, where H or T gives it on the old control.
    fn radius_number(&self, draft: &mut BlockDraft, at: usize) {
        let Some(run) = self.run(at) else { return };
        let has_d = draft.block.letters().has(b'D');
        let is_off =
            run.before.side == CompensationSide::Off && run.after.side == CompensationSide::Off;
        if is_off
            && self.to.parameters.strict_words
            && !self.same_control()
            && let Some(d) = draft.place(b'D')
        {
            let title = self.to.table.title;
            return draft.remove(d, format!("{title} takes D only in the block of G41 and G42"));
        }
        for command in self.trace.commands_of(run) {
            let CommandKind::Compensation { number: Some(number), side, .. } = command.kind else {
                continue;
            };
            let is_on = side != CompensationSide::Off;
            let own = self.source.has_action(at, self.from, |action| {
                matches!(
                    action,
                    Action::Mode(ModeCode::CompensationLeft)
                        | Action::Mode(ModeCode::CompensationRight)
                )
            });
            if is_on && own && !has_d && !self.same_control() && !self.turns() {
                draft.append(
                    format!("D{number}"),
                    format!("{} needs the offset number with G41 and G42", self.to.table.title),
                );
            }
        }
    }
}
