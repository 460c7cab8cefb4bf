//! Writes word-address programs from what a program does.

use chordal::control::{
    Action, AxisMask, Control, Coolant, DrilledHole, FeedMode, PathMode, PostedKind, PostedProgram,
    PostedStep, ProgramWriter, SpindleState, StartingModes, TappedHole, Units, WriterNote,
    WriterOptions, WrittenLine, WrittenProgram,
};
use chordal::control::{ModeCode, Position, ReadingCode, WorkName};
use chordal::geometry::Plane;
use chordal::machine::AXES;
use chordal::{CommandKind, Effect};

use super::super::codes;
use super::super::emit::{CommandEmitter, WRITTEN_STYLE, WrittenCycle};
use super::super::structure::program_name;

/// The axis of the tool length.
const TOOL_AXIS: usize = 2;

/// Writes programs for a word-address control.
pub(super) struct WordAddressWriter<'c> {
    pub control: &'c Control,
}

impl ProgramWriter for WordAddressWriter<'_> {
    fn write(&self, program: &PostedProgram, options: &WriterOptions) -> WrittenProgram {
        let start = program.start;
        let mut run = RunWriter {
            emitter: CommandEmitter::of_run(
                self.control,
                start,
                options.tolerance_mm,
                options.digits,
            ),
            control: self.control,
            program,
            options,
            written: WrittenProgram::default(),
            step: 0,
            place: [0.0; AXES],
            modes: ActiveState::of(program),
            cycle: None,
            approach: None,
        };
        run.begin();
        for (at, step) in program.steps.iter().enumerate() {
            run.step = at;
            if let Err(reason) = run.one(step) {
                run.written.refusals.push(WriterNote { step: at, words: String::new(), reason });
            }
            run.take_lines(Some(at));
        }
        run.finish();
        run.written
    }

    fn comment(&self, text: &str) -> String {
        format!("({})", text.replace('(', "[").replace(')', "]"))
    }
}

/// What is active in the program that is written.
struct ActiveState {
    units: Units,
    /// What the next move needs.
    desired: MovingModes,
    /// What is written.
    written: MovingModes,
    coolant: Coolant,
    spindle: (SpindleState, f64),
    /// The tool length that the program wants, and the one that is written.
    lengths: [Option<u32>; 2],
    /// The length must be written again.
    is_length_due: bool,
}

impl ActiveState {
    fn of(program: &PostedProgram) -> ActiveState {
        ActiveState {
            units: program.start.units,
            desired: MovingModes::of(program),
            written: MovingModes::of(program),
            coolant: Coolant::default(),
            spindle: (SpindleState::Off, 0.0),
            lengths: [None; 2],
            is_length_due: false,
        }
    }
}

/// Modes that act on moves alone: they are written with the next move, each once.
#[derive(Clone, Copy)]
struct MovingModes {
    plane: Plane,
    feed_mode: FeedMode,
    work: WorkName,
    path_mode: Option<PathMode>,
}

impl MovingModes {
    fn of(program: &PostedProgram) -> MovingModes {
        let start = program.start;
        MovingModes {
            plane: start.plane,
            feed_mode: start.feed_mode,
            work: starting_work(start).unwrap_or(WorkName::Machine),
            path_mode: None,
        }
    }
}

/// The work coordinate system at the first step; `None` for machine coordinates.
fn starting_work(start: StartingModes) -> Option<WorkName> {
    u16::try_from(start.work).ok().and_then(WorkName::of_ordinal)
}

struct RunWriter<'a> {
    emitter: CommandEmitter<'a>,
    control: &'a Control,
    program: &'a PostedProgram,
    options: &'a WriterOptions,
    written: WrittenProgram,
    step: usize,
    /// Where the tool is.
    place: Position,
    modes: ActiveState,
    cycle: Option<WrittenCycle>,
    /// The place before a rapid to a hole that its cycle makes.
    approach: Option<Position>,
}

impl RunWriter<'_> {
    fn take_lines(&mut self, step: Option<usize>) {
        let lines = std::mem::take(&mut self.emitter.lines);
        self.written.lines.extend(lines.into_iter().map(|text| WrittenLine { text, step }));
    }

    fn frame_line(&mut self, text: String) {
        self.written.lines.push(WrittenLine { text, step: None });
    }

    fn note(&mut self, words: &str, reason: &str) {
        let (words, reason) = (words.to_string(), reason.to_string());
        self.written.notes.push(WriterNote { step: self.step, words, reason });
    }

    /// Whether the text has a tape: its number stands there.
    fn number(&self) -> Option<u32> {
        let numbers = self.control.table.program_numbers;
        let own = self.program.number.filter(|number| (1..=numbers.largest).contains(number));
        match numbers.required {
            true => Some(own.unwrap_or(1)),
            false => own,
        }
    }

    fn begin(&mut self) {
        let own = self.number().map(|number| program_name(number, self.control));
        if let Some(own) = &own {
            self.frame_line("%".into());
            self.frame_line(own.clone());
        }
        if let Some(name) = self.program.name.as_ref().filter(|name| own.as_ref() != Some(name)) {
            self.frame_line(format!("({name})"));
        }
        let start = self.program.start;
        let actions = [
            Action::from(start.units),
            Action::from(start.plane),
            Action::Reading(ReadingCode::Absolute),
            Action::Mode(ModeCode::CompensationOff),
            Action::Mode(ModeCode::CancelCycle),
            Action::from(start.feed_mode),
        ];
        let names = actions
            .into_iter()
            .filter_map(|action| codes::name(action, self.control, WRITTEN_STYLE));
        let mut words: Vec<String> = names.collect();
        words.extend(
            starting_work(start)
                .and_then(|name| codes::work_offset(name, self.control, WRITTEN_STYLE)),
        );
        self.frame_line(words.join(" "));
    }

    fn finish(&mut self) {
        self.emitter.finish();
        self.take_lines(None);
        if self.number().is_some() {
            self.frame_line("%".into());
        }
    }

    fn one(&mut self, step: &PostedStep) -> Result<(), String> {
        match &step.kind {
            PostedKind::Hole(hole) => self.hole(hole),
            PostedKind::Tap(tap) => self.tap(tap),
            PostedKind::MachineMove { place, axes } => {
                self.end_cycle()?;
                if axes.has(TOOL_AXIS) {
                    self.modes.is_length_due = self.modes.lengths[0].is_some();
                }
                self.emitter.machine_rapid(place, *axes)
            }
            PostedKind::Command(command) => self.command(command),
        }
    }

    /// A thread, with the spindle turning into it before and as it was after.
    fn tap(&mut self, tap: &TappedHole) -> Result<(), String> {
        self.end_cycle()?;
        if tap.out_factor != 1.0 {
            return Err("a tap that feeds out at a different speed than in".into());
        }
        let rpm = tap.rpm;
        let inward = if tap.is_left { SpindleState::Ccw } else { SpindleState::Cw };
        self.mode(&CommandKind::Spindle { state: inward, rpm })?;
        self.write_modes(true)?;
        self.write_length()?;
        self.emitter.tapped_hole(tap)?;
        let words = self.emitter.lines.iter().rev().nth(1).cloned().unwrap_or_default();
        self.note(
            &words,
            "the tap of this control: look whether it is one in step with the spindle",
        );
        match tap.spindle[1] {
            after if after == inward => Ok(()),
            state @ (SpindleState::Cw | SpindleState::Ccw) => {
                self.mode(&CommandKind::Spindle { state, rpm })
            }
            SpindleState::Off | SpindleState::Oriented => {
                self.mode(&CommandKind::Spindle { state: SpindleState::Off, rpm: 0.0 })
            }
        }
    }

    fn end_cycle(&mut self) -> Result<(), String> {
        match self.cycle.take() {
            Some(_) => self.emitter.end_cycle(),
            None => Ok(()),
        }
    }

    fn command(&mut self, command: &CommandKind) -> Result<(), String> {
        if let Some(motion) = command.motion() {
            if self.waits_for_hole(command) {
                self.approach = Some(motion.from);
                self.place = motion.to;
                return Ok(());
            }
            self.end_cycle()?;
            self.write_modes(command.feed().is_some())?;
            if motion.from[TOOL_AXIS] != motion.to[TOOL_AXIS] {
                self.write_length()?;
            }
            self.place = motion.to;
            return self.emitter.step(command);
        }
        if matches!(
            command,
            CommandKind::Idle | CommandKind::FeedRate { .. } | CommandKind::Message(_)
        ) {
            return Ok(());
        }
        self.end_cycle()?;
        self.mode(command)
    }

    /// A command that does not move.
    fn mode(&mut self, command: &CommandKind) -> Result<(), String> {
        if let CommandKind::Units(units) = command {
            if std::mem::replace(&mut self.modes.units, *units) != *units {
                self.emitter.step(command)?;
                // F of a block may be read before its units: they stand alone.
                self.emitter.finish();
            }
            return Ok(());
        }
        let modes = &mut self.modes;
        let is_new = match command {
            CommandKind::Plane(plane) => {
                modes.desired.plane = *plane;
                false
            }
            CommandKind::FeedMode(mode) => {
                modes.desired.feed_mode = *mode;
                false
            }
            CommandKind::PathMode(mode) => {
                modes.desired.path_mode = Some(*mode);
                false
            }
            CommandKind::WorkOffset { name, turned, .. } => {
                if *turned != 0.0 {
                    return Err("a work coordinate system that is rotated".into());
                }
                modes.desired.work = *name;
                false
            }
            CommandKind::Spindle { state, rpm } => {
                let turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
                let now = (*state, if turns { *rpm } else { 0.0 });
                std::mem::replace(&mut modes.spindle, now) != now
            }
            CommandKind::ToolLength { number, is_subtracted, offset, .. } => {
                let is_own = number.is_none() && offset.iter().any(|value| *value != 0.0);
                if *is_subtracted || is_own {
                    return Err(
                        "a tool length that is subtracted, or that the program gives itself".into(),
                    );
                }
                modes.lengths[0] = *number;
                // It is written with the next move along the tool.
                false
            }
            CommandKind::Dwell { seconds, .. } => *seconds > 0.0,
            CommandKind::Coolant(coolant) => return self.coolant(*coolant),
            CommandKind::Tool { .. } => return self.change_tool(command),
            CommandKind::Effect(effect) => return effect_refusal(effect),
            CommandKind::Output { .. } => true,
            CommandKind::ToolNumber { .. }
            | CommandKind::ToolSelect { .. }
            | CommandKind::Compensation { .. }
            | CommandKind::Stop { .. }
            | CommandKind::End
            | CommandKind::Overrides(_)
            | CommandKind::CornerArc { .. }
            | CommandKind::CornerMode { .. }
            | CommandKind::Surface { .. }
            | CommandKind::PartFrame { .. }
            | CommandKind::Probed { .. } => true,
            // Moves and units are written before, and the rest does nothing.
            CommandKind::Rapid { .. }
            | CommandKind::Line { .. }
            | CommandKind::Arc { .. }
            | CommandKind::Spiral { .. }
            | CommandKind::Spline { .. }
            | CommandKind::Units(_)
            | CommandKind::FeedRate { .. }
            | CommandKind::Idle
            | CommandKind::Message(_) => false,
        };
        if matches!(command, CommandKind::Compensation { .. }) {
            self.write_plane_before_compensation()?;
        }
        if is_new { self.emitter.step(command) } else { Ok(()) }
    }

    /// Compensation is active in the plane that it finds: the plane stands in a block before it.
    fn write_plane_before_compensation(&mut self) -> Result<(), String> {
        let plane = self.modes.desired.plane;
        if std::mem::replace(&mut self.modes.written.plane, plane) != plane {
            self.emitter.step(&CommandKind::Plane(plane))?;
            self.emitter.finish();
        }
        Ok(())
    }

    /// What the next move needs; the feed mode where it cuts.
    fn write_modes(&mut self, is_cut: bool) -> Result<(), String> {
        let desired = self.modes.desired;
        let written = &mut self.modes.written;
        let mut commands = Vec::new();
        if std::mem::replace(&mut written.plane, desired.plane) != desired.plane {
            commands.push(CommandKind::Plane(desired.plane));
        }
        if std::mem::replace(&mut written.path_mode, desired.path_mode) != desired.path_mode {
            commands.extend(desired.path_mode.map(CommandKind::PathMode));
        }
        if is_cut
            && std::mem::replace(&mut written.feed_mode, desired.feed_mode) != desired.feed_mode
        {
            commands.push(CommandKind::FeedMode(desired.feed_mode));
        }
        commands.iter().try_for_each(|command| self.emitter.step(command))?;
        if self.modes.written.work.ordinal() != desired.work.ordinal() {
            self.modes.written.work = desired.work;
            self.emitter.work_system(desired.work)?;
        }
        Ok(())
    }

    fn change_tool(&mut self, command: &CommandKind) -> Result<(), String> {
        self.modes.is_length_due = self.modes.lengths[0].is_some();
        self.emitter.step(command)
    }

    /// Codes of coolant open valves: what is to be closed alone is closed with all others first.
    fn coolant(&mut self, coolant: Coolant) -> Result<(), String> {
        let before = std::mem::replace(&mut self.modes.coolant, coolant);
        let closes = before.mist && !coolant.mist
            || before.flood && !coolant.flood
            || before.through_tool && !coolant.through_tool;
        if closes && coolant != Coolant::default() {
            self.emitter.step(&CommandKind::Coolant(Coolant::default()))?;
        }
        self.emitter.step(&CommandKind::Coolant(coolant))
    }

    /// The tool length, where another one is written.
    fn write_length(&mut self) -> Result<(), String> {
        let [desired, written] = self.modes.lengths;
        if desired == written && !self.modes.is_length_due {
            return Ok(());
        }
        self.modes.lengths = [desired; 2];
        self.modes.is_length_due = false;
        if !codes::has_lengths(self.control) {
            self.note("", &codes::without_lengths(self.control));
        }
        self.emitter.step(&CommandKind::ToolLength {
            number: desired,
            length_mm: None,
            is_subtracted: false,
            offset: [0.0; AXES],
            known: AxisMask::NONE,
        })
    }

    /// The hole after this step, where a cycle makes it.
    fn next_hole(&self) -> Option<&DrilledHole> {
        let next = self.step + 1;
        let PostedKind::Hole(hole) = &self.program.steps.get(next)?.kind else { return None };
        self.is_kept(hole, next).then_some(hole)
    }

    fn is_kept(&self, hole: &DrilledHole, at: usize) -> bool {
        let [desired, written] = self.modes.lengths;
        let has_length = desired == written && !self.modes.is_length_due;
        let goes_on = self.cycle.as_ref().is_some_and(|cycle| cycle.goes_on(hole));
        has_length
            && !self.options.written_out.contains(&at)
            && (goes_on || self.emitter.cycle_of(hole).is_some())
    }

    /// A rapid in the plane to a hole whose cycle makes it.
    fn waits_for_hole(&self, command: &CommandKind) -> bool {
        let CommandKind::Rapid { motion, .. } = command else { return false };
        let is_in_plane = (TOOL_AXIS..AXES).all(|axis| motion.from[axis] == motion.to[axis]);
        is_in_plane && self.next_hole().is_some()
    }

    fn hole(&mut self, hole: &DrilledHole) -> Result<(), String> {
        let approach = self.approach.take();
        if !self.is_kept(hole, self.step) {
            self.end_cycle()?;
            self.note("", "a hole that is written out as moves: no cycle has the same steps");
            for command in &hole.written_out {
                self.command(command)?;
            }
            return Ok(());
        }
        let from = approach.unwrap_or(self.place);
        match &self.cycle {
            Some(cycle) if cycle.goes_on(hole) => self.emitter.next_hole(&from, &self.place),
            _ => {
                self.end_cycle()?;
                self.write_modes(true)?;
                let cycle = self.emitter.cycle_of(hole).ok_or("no cycle for this hole")?;
                self.emitter.begin_cycle(&cycle, &self.place)?;
                self.cycle = Some(cycle);
                let words = self.emitter.lines.last().cloned().unwrap_or_default();
                self.note(&words, "the cycle with the same steps");
            }
        }
        self.place[TOOL_AXIS] = hole.retract_mm;
        Ok(())
    }
}

/// Why an effect has no words here.
fn effect_refusal(effect: &Effect) -> Result<(), String> {
    match effect {
        Effect::Code(_) | Effect::Variable { .. } => Ok(()),
        Effect::Written { name, .. } => {
            Err(format!("a value that the control keeps is written ({name})"))
        }
        Effect::Alarm { .. } => Err("the program stops itself with an alarm".into()),
        Effect::Deletable { .. } => Err("a block that block delete may leave out".into()),
    }
}
