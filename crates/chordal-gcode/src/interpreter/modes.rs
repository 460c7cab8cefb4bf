//! The modes that a block sets: those that change how its numbers are read, those that its motion uses, and what
//! follows the motion.

use chordal_command::{CommandKind, CompensationSide, FeedMode, SpindleState, Units, WorkName};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_dialect::{
    Action, AfterCode, BeforeCode, BlockStep, CallCode, LengthCode, ModeCode, OnceCode, ReadingCode,
};
use chordal_dialect::{CodeGroup, CodeRow, LiteralScale, PlaneCodes, code_number};
use chordal_geometry::Plane;
use chordal_kernel::LengthOffset;
use chordal_kernel::rules::{ArcCenter, LengthWithoutNumber};
use chordal_machine::Axis;
use chordal_syntax::Block;

use super::{BlockFlow, EndReason, Interpreter};

const Z: usize = Axis::Z as usize;

impl Interpreter<'_> {
    fn take_reading_mode(&mut self, action: Action) {
        let Action::Reading(code) = action else { return };
        let by_place = self.control.table.distance_left_to_right;
        match code {
            ReadingCode::Inch => self.set_units_by_code(Units::Inch),
            ReadingCode::Millimetre => self.set_units_by_code(Units::Millimetre),
            ReadingCode::Absolute if by_place => {}
            ReadingCode::Incremental if by_place => {}
            ReadingCode::Absolute => self.kernel.set_incremental(false),
            ReadingCode::Incremental => self.kernel.set_incremental(true),
            ReadingCode::ArcCenterAbsolute => {
                self.kernel.state.arc_center = ArcCenter::Absolute;
            }
            ReadingCode::ArcCenterIncremental => {
                self.kernel.state.arc_center = ArcCenter::FromStart;
            }
            ReadingCode::FeedPerTime => self.kernel.set_feed_mode_by_code(FeedMode::PerTime),
            ReadingCode::FeedInverseTime => {
                self.kernel.set_feed_mode_by_code(FeedMode::InverseTime)
            }
            ReadingCode::FeedPerRevolution => {
                self.kernel.set_feed_mode_by_code(FeedMode::PerRevolution)
            }
            ReadingCode::SurfaceSpeed => self.kernel.keep_surface_speed(),
            ReadingCode::SpindleRpm => self.kernel.keep_spindle_speed(),
            ReadingCode::Diameters => self.per_word[0] = 0.5,
            ReadingCode::Radii => self.per_word[0] = 1.0,
        }
    }

    /// Sets the units by a code of the program.
    fn set_units_by_code(&mut self, units: Units) {
        self.units_programmed = true;
        self.set_units(units);
    }

    pub(super) fn set_units(&mut self, units: Units) {
        self.kernel.set_units(units);
        self.scale = LiteralScale::new(units, &self.control.parameters);
    }

    /// Carries out E, F, S, T, D, and what is switched before the motion.
    pub(super) fn take_letters(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        let letters = block.letters();
        if letters.has(b'F') && !self.feed_is_tap_speed(codes) {
            self.take_feed(block);
        }
        self.units_of_feed = None;
        let surface = codes.iter().find(|(row, _)| {
            row.action == Action::Reading(ReadingCode::SurfaceSpeed) && row.words.has(b'D')
        });
        if let Some((_, at)) = surface {
            self.limit_of_surface_speed(block, *at);
        }
        let limits = self.control.parameters.preset_limits_speed
            && codes.iter().any(|(row, _)| row.action == Action::Once(OnceCode::PresetPosition));
        if letters.has(b'S') && limits {
            self.take_speed_limit(block);
        } else if letters.has(b'S') && !speed_is_of_code(codes) {
            self.take_speed(block);
        }
        if let Some(letter) = self.control.parameters.power_letter
            && letters.has(letter)
            && codes.iter().any(|(row, _)| starts_spindle(row))
        {
            self.take_power(block, letter);
        }
        if letters.has(b'T') {
            self.take_tool_word(block);
        }
        if letters.has(b'E') && self.control.table.work_names.by_e {
            self.take_e_word(block);
        }
        let by_diameter = |row: &CodeRow| {
            row.action == Action::Mode(ModeCode::CompensationLeftByDiameter)
                || row.action == Action::Mode(ModeCode::CompensationRightByDiameter)
        };
        let turns = |row: &CodeRow| matches!(row.action, Action::Once(OnceCode::Turning(_)));
        let largest = self.control.parameters.largest_numbers.offset;
        if letters.has(b'D')
            && surface.is_none()
            && !codes.iter().any(|(row, _)| turns(row))
            && !codes.iter().any(|(row, _)| by_diameter(row))
            && let Some(number) = self.count_up_to(block, b'D', largest)
        {
            self.kernel.state.unknown.radius_offset = false;
            let before = self.kernel.state.radius_offset.replace(number);
            // A G41 or G42 in the same block emits the offset itself.
            if self.kernel.state.side != CompensationSide::Off
                && before != Some(number)
                && !codes.iter().any(|(row, _)| row.group == CodeGroup::Compensation)
            {
                self.change_compensation_offset(block);
            }
        }
        self.take_switches(block, codes);
    }

    /// Carries out what is switched before the motion, in the order of the control.
    pub(super) fn take_switches(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        self.take_kinematics(block, codes);
        let order = &self.control.table.order;
        let rank = |row: &CodeRow| Some(order.rank(BlockStep::of_switch(row.action)?));
        if codes.iter().all(|(row, _)| rank(row).is_none()) {
            return;
        }
        for step in 0..order.rank(BlockStep::Motion) {
            for (row, at) in codes.iter().filter(|(row, _)| rank(row) == Some(step)) {
                if let Action::Before(code) = row.action {
                    self.take_before_motion(block, code, *at);
                } else if let Action::After(code) = row.action {
                    self.switch_off(block, code);
                }
            }
        }
    }

    /// Stops spindle or coolant.
    fn switch_off(&mut self, block: &Block, code: AfterCode) {
        match code {
            AfterCode::SpindleStop if self.names_live_tool(block) => {
                self.kernel.set_live_tool(None);
            }
            AfterCode::SpindleStop => self.kernel.set_spindle(SpindleState::Off),
            AfterCode::LiveToolStop => self.kernel.set_live_tool(None),
            AfterCode::CoolantOff => self.kernel.set_coolant(|c| *c = Default::default()),
            AfterCode::CoolantThroughToolOff => self.kernel.set_coolant(|c| c.through_tool = false),
            // No switch.
            AfterCode::ProgramStop
            | AfterCode::OptionalStop
            | AfterCode::ProgramEnd { .. }
            | AfterCode::ProgramAgain
            | AfterCode::ShopCode
            | AfterCode::RunCycleHere => {}
        }
    }

    fn is_switched_before(&self, row: &CodeRow) -> bool {
        let order = &self.control.table.order;
        let step = BlockStep::of_switch(row.action);
        step.is_some_and(|step| order.is_before(step, BlockStep::Motion))
    }

    /// The previous units if the control reads F before the units that the block changes; `None` otherwise.
    fn units_of_feed(&self, block: &Block, codes: &[(&'static CodeRow, usize)]) -> Option<Units> {
        if !self.units_programmed || !block.letters().has(b'F') {
            return None;
        }
        let before = self.kernel.state.units;
        let changes =
            codes.iter().any(|(row, _)| row.action.units().is_some_and(|to| to != before));
        let order = &self.control.table.order;
        (changes && order.is_before(BlockStep::Feed, BlockStep::Units)).then_some(before)
    }

    /// Sets the modes that change how the numbers of this block are read.
    pub(super) fn take_reading_modes(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
    ) {
        self.units_of_feed = self.units_of_feed(block, codes);
        for (row, _) in codes {
            self.take_reading_mode(row.action);
        }
    }

    /// Carries out a tool, spindle or coolant code.
    fn take_before_motion(&mut self, block: &Block, code: BeforeCode, at: usize) {
        match code {
            BeforeCode::ToolChange => self.tool_change(block, at),
            BeforeCode::SetToolNumber => {
                // A negative number was reported with the words of the code.
                let below_zero = block.last(b'Q').and_then(|word| self.literal(word));
                let below_zero = below_zero.is_some_and(|number| number.mantissa < 0);
                if block.letters().has(b'Q')
                    && !below_zero
                    && let Some(number) = self.count_of(block, b'Q')
                {
                    self.kernel.set_tool_number(number);
                }
            }
            BeforeCode::SpindleCw => self.start_spindle(block, SpindleState::Cw),
            BeforeCode::SpindleCcw => self.start_spindle(block, SpindleState::Ccw),
            BeforeCode::LiveToolCw => self.start_live_tool(block, at, SpindleState::Cw),
            BeforeCode::LiveToolCcw => self.start_live_tool(block, at, SpindleState::Ccw),
            BeforeCode::CAxisOn => self.kernel.set_spindle(SpindleState::Off),
            BeforeCode::SpindleOrient => self.kernel.set_spindle(SpindleState::Oriented),
            BeforeCode::CoolantMist => self.kernel.set_coolant(|c| c.mist = true),
            BeforeCode::CoolantFlood => self.kernel.set_coolant(|c| c.flood = true),
            BeforeCode::CoolantThroughTool => self.kernel.set_coolant(|c| c.through_tool = true),
            // Carried out before all codes, or after all modes.
            BeforeCode::SaveModes { .. } | BeforeCode::ForgetModes | BeforeCode::RestoreModes => {}
        }
    }

    /// Sets a mode that the motion of this block uses.
    pub(super) fn take_mode(&mut self, block: &Block, row: &'static CodeRow, at: usize) {
        if row.action == Action::NotSimulated {
            return self.not_simulated(&block.words[at], row);
        }
        if row.action == Action::NotFollowed {
            return self.not_followed(&block.words[at], row.title);
        }
        let Some(code) = row.action.mode() else { return };
        match code {
            ModeCode::PlaneXy => self.set_plane(block, at, Plane::Xy),
            ModeCode::PlaneZx => self.set_plane(block, at, Plane::Zx),
            ModeCode::PlaneYz => self.set_plane(block, at, Plane::Yz),
            ModeCode::CompensationOff => self.set_compensation(block, at, CompensationSide::Off),
            ModeCode::CompensationLeft => self.set_compensation(block, at, CompensationSide::Left),
            ModeCode::CompensationRight => {
                self.set_compensation(block, at, CompensationSide::Right)
            }
            ModeCode::CompensationLeftByDiameter => {
                self.compensation_by_diameter(block, at, CompensationSide::Left)
            }
            ModeCode::CompensationRightByDiameter => {
                self.compensation_by_diameter(block, at, CompensationSide::Right);
            }
            ModeCode::StoreReference { second } => self.store_reference(second),
            ModeCode::CornerArc => self.corner_arc(block, false),
            ModeCode::WorkOffset(_) if self.numbers_by_p(block, row, at) => {
                self.select_extended_work(block, at);
            }
            ModeCode::WorkOffset(number) => self.change_work(block, at, WorkName::G(number)),
            ModeCode::WorkOffsetPoint(number) => {
                self.change_work(block, at, WorkName::G59(number));
            }
            ModeCode::WorkOffsetNumbered(number) => {
                self.warn_of_work_change(block, at, WorkName::Extended(number));
                self.kernel.select_work(WorkName::Extended(number));
            }
            ModeCode::WorkOffsetExtended => self.select_extended_work(block, at),
            ModeCode::FixtureError => self.select_fixture_error(block, at),
            ModeCode::WorkOffsetByOrdinal => self.select_work_by_ordinal(block, at),
            ModeCode::Path(code) => self.take_path_mode(block, row, code, at),
            ModeCode::Overrides { on, rapid } => {
                self.kernel.set_overrides(Some(on), rapid.then_some(on));
            }
            ModeCode::OverridesByP => self.take_overrides_by_p(block),
            ModeCode::ReturnInitial => self.kernel.state.return_to_r = false,
            ModeCode::ReturnToR => self.kernel.state.return_to_r = true,
            ModeCode::RotationOff => {
                self.kernel.end_rotation(&self.at(block));
                self.kernel.set_tilted_plane(None);
            }
            ModeCode::ScalingOff => self.kernel.end_scaling(),
            ModeCode::Polar { on } => self.kernel.set_polar(on),
            ModeCode::CancelCycle => self.kernel.cancel_cycle(),
            ModeCode::ModalSubroutine => self.begin_modal_subroutine(block, at),
            ModeCode::ModalCallOff => self.end_modal_call(),
            ModeCode::DataLinesOff => self.data_lines = false,
            ModeCode::ThreadExit { on } => self.kernel.state.turning.without_exit = !on,
        }
    }

    fn change_work(&mut self, block: &Block, at: usize, name: WorkName) {
        self.warn_of_work_change(block, at, name);
        self.select_work(name);
    }

    /// Warns of a change of the work coordinate system while a frame is active.
    pub(super) fn warn_of_work_change(&mut self, block: &Block, at: usize, name: WorkName) {
        let other = name != self.kernel.state.offsets.active();
        // A code in the same block may end the frame.
        let ends = block.all(b'G').any(|word| {
            let row =
                word.number().and_then(code_number).and_then(|code| self.control.g_code(code));
            row.is_some_and(|row| {
                row.action == Action::Mode(ModeCode::RotationOff)
                    || row.action == Action::Mode(ModeCode::ScalingOff)
            })
        });
        if other && !ends && !self.control.parameters.rules.frames.work_change {
            let code = self.code_text(block, at);
            self.kernel.warn_of_frames(self.span(block.words[at].range), &code);
        }
    }

    pub(super) fn select_work(&mut self, name: WorkName) {
        if name != self.kernel.state.offsets.active() {
            self.take_written_offsets();
        }
        self.kernel.select_work(name);
    }

    /// M50: feed and rapid overrides by P.
    fn take_overrides_by_p(&mut self, block: &Block) {
        let on = !block.letters().has(b'P') || self.count_of(block, b'P') != Some(0);
        self.kernel.set_overrides(Some(on), Some(on));
    }

    fn set_plane(&mut self, block: &Block, at: usize, plane: Plane) {
        let swapped = self.control.parameters.plane_codes == PlaneCodes::Swapped;
        let plane = match plane {
            Plane::Zx if swapped => Plane::Yz,
            Plane::Yz if swapped => Plane::Zx,
            other => other,
        };
        if self.plane_on_surface(plane) {
            return;
        }
        self.kernel.set_plane(self.span(block.words[at].range), plane);
    }

    /// Carries out G43, G44, G49 and H.
    pub(super) fn take_length(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        let length_code = codes.iter().rev().find(|(row, _)| row.group == CodeGroup::ToolLength);
        let by_code = length_code.map(|(row, _)| row.action);
        // On lathes H is an increment of C.
        let moves = self.control.parameters.increments.iter().any(|(letter, _)| *letter == b'H');
        if by_code.is_none() && (moves || !block.letters().has(b'H')) {
            return;
        }
        let writes = codes.iter().any(|(row, _)| row.action == Action::Once(OnceCode::SetData));
        if writes && by_code == Some(Action::Length(LengthCode::Cancel)) {
            let none = LengthOffset { number: None, minus: false };
            return self.kernel.set_length(&self.at(block), none);
        }
        let called = codes.iter().any(|(row, _)| row.group == CodeGroup::Calling) || writes;
        if called {
            return;
        }
        if by_code.is_some() {
            // Any code of the group ends tool centre point control.
            self.kernel.end_tool_center();
        }
        if by_code == Some(Action::Length(LengthCode::Cancel)) {
            let none = LengthOffset { number: None, minus: false };
            self.kernel.set_length(&self.at(block), none);
            if block.letters().has(b'H') {
                self.kernel.state.named_length = self.count_of(block, b'H');
            }
            return;
        }
        if by_code == Some(Action::Length(LengthCode::FromAxes)) {
            let values = self.axis_words(block);
            return self.kernel.set_tool_offsets(&values, false);
        }
        if by_code == Some(Action::Length(LengthCode::Add)) {
            return self.add_tool_offsets(block);
        }
        let active = self.kernel.state.offsets.length();
        let minus = match by_code {
            Some(Action::Length(LengthCode::Minus)) => true,
            Some(_) => false,
            None => active.minus,
        };
        // H alone changes the length on some controls, and on all while a length is active.
        let applies = by_code.is_some()
            || self.control.parameters.length_by_h_alone
            || active.number.is_some();
        if !applies {
            // The next G43 without an H uses it.
            self.kernel.state.named_length = self.count_of(block, b'H');
            return;
        }
        let number = match block.letters().has(b'H') {
            true => {
                let largest = self.control.parameters.largest_numbers.offset;
                let number = self.count_up_to(block, b'H', largest);
                let is_of_tool = number == Some(0)
                    && self.control.parameters.rules.length.zero_is_of_tool
                    && by_code.is_some();
                if is_of_tool { Some(self.kernel.state.tool) } else { number }
            }
            false => self.length_without_number(block, length_code),
        };
        self.kernel.state.named_length = None;
        let commanded = self.kernel.state.position[Z];
        match number {
            Some(0) => {
                self.kernel.set_length(&self.at(block), LengthOffset { number: None, minus: false })
            }
            Some(number) => {
                self.check_length_number(block, number);
                self.kernel
                    .set_length(&self.at(block), LengthOffset { number: Some(number), minus });
            }
            None => {}
        }
        if let Some(Action::Length(
            code @ (LengthCode::ToolCenter | LengthCode::ToolCenterByVector),
        )) = by_code
        {
            self.begin_tool_center(block, length_code, code == LengthCode::ToolCenterByVector);
        }
        if let Some((row, at)) = length_code
            && row.action == Action::Length(LengthCode::AlongTool)
        {
            self.begin_length_along_tool(block, *at);
        }
        let adds = self.control.parameters.rules.length.adds_to_increment;
        let is_once = codes.iter().any(|(row, _)| matches!(row.action, Action::Once(_)));
        if adds && self.kernel.state.incremental && block.letters().has(b'Z') && !is_once {
            // The increment of Z starts at the previous coordinate, and the length is added to its end: from Z0 of
            // the machine, with a length of -4 mm, `G91 G43 Z-32. H1` ends at -36.
            let mut assumed = self.kernel.state.position;
            assumed[Z] = commanded;
            self.kernel.state.control_position = Some(assumed);
        }
    }

    /// The output that switches the kinematics (LinuxCNC, switchkins: `M68 E3`).
    fn take_kinematics(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        let Some(starting) = self.machine.starting_kinematics else { return };
        let Some(output) = self.control.parameters.kinematics_output else { return };
        let is_output = |(row, at): &&(&CodeRow, usize)| {
            row.code == output.m_code && block.words[*at].letter == b'M'
        };
        let Some(&(_, at)) = codes.iter().find(is_output) else { return };
        if self.count_of(block, b'E') != Some(output.number) || !block.letters().has(b'Q') {
            return;
        }
        match self.count_of(block, b'Q').and_then(|number| starting.follow_tip(number)) {
            Some(follow_tip) => self.kernel.switch_kinematics(follow_tip),
            None => self
                .not_followed(&block.words[at], "kinematics that the machine file does not give"),
        }
    }

    /// The number of the length that G43 or G44 without H activates.
    fn length_without_number(
        &mut self,
        block: &Block,
        code: Option<&(&'static CodeRow, usize)>,
    ) -> Option<u32> {
        if self.control.parameters.rules.length.without_number == LengthWithoutNumber::OfTool {
            return Some(self.kernel.state.tool);
        }
        let active = self.kernel.state.offsets.length().number;
        let number = active.or(self.kernel.state.named_length);
        if let (None, Some((_, at))) = (number, code) {
            let name = self.code_text(block, *at);
            let span = self.span(block.words[*at].range);
            let message =
                format!("{name} without H: the offset in force is H0, and no length acts");
            self.kernel.report(
                Diagnostic::new(Code::MissingWord, span, message)
                    .severity(Severity::Warning)
                    .help("write H and the number of the tool's offset"),
            );
        }
        Some(number.unwrap_or(0))
    }

    /// Sets G90, G91 and the motion code of a block whose axis words belong to another code (`taker`): they stay active
    /// and decide between rapid and feed.
    pub(super) fn modes_with_one_shot(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
        taker: &CodeRow,
    ) {
        for (row, at) in codes {
            if let Some(incremental) = row.action.incremental() {
                self.kernel.set_incremental(incremental);
            }
            // The others do not depend on axis words.
            let Some(code) = row.action.motion() else { continue };
            if code.is_curve() && self.has_arc_words(block) {
                self.arc_left_out(block, *at, row, taker);
            } else {
                self.kernel.end_cycle_if(self.control.parameters.rules.cycles.cancel.by_motion);
            }
            self.take_motion_code(code);
        }
    }

    /// Reports G2 or G3 with a centre in the block of a code that uses the axis words.
    fn arc_left_out(&mut self, block: &Block, at: usize, arc: &CodeRow, taker: &CodeRow) {
        let (arc, taker) = (arc.name(b'G'), taker.name(b'G'));
        self.kernel.report(
            Diagnostic::new(
                Code::SameGroup,
                self.span(block.words[at].range),
                format!("{arc} makes no arc in the block of {taker}, which uses the axis words"),
            )
            .severity(match self.control.parameters.one_code_takes_axes {
                Some(_) => Severity::Error,
                None => Severity::Warning,
            })
            .label("the arc is skipped")
            .help("write the arc in a separate block"),
        );
    }

    /// Carries out what follows the motion: spindle and coolant off, stops, ends, calls and returns.
    pub(super) fn take_after_motion(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
    ) -> BlockFlow {
        if self.kernel.state.path.once {
            self.kernel.end_exact_stop_once();
        }
        self.emit_codes(block, codes);
        for (row, at) in codes {
            // If they act from left to right, the last one stays active, even in a block without axis words.
            if let Some(incremental) = row.action.incremental() {
                self.kernel.set_incremental(incremental);
            } else if let Action::After(code) = row.action
                && !self.is_switched_before(row)
                && let end @ BlockFlow::End(_) =
                    self.take_code_after_motion(block, codes, code, *at)
            {
                return end;
            } else if row.action == Action::Call(CallCode::Return) {
                return self.return_from_program(block, *at);
            } else if let Action::Call(code) = row.action {
                self.take_call(block, code, *at);
            }
        }
        BlockFlow::Next
    }

    fn take_code_after_motion(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
        code: AfterCode,
        at: usize,
    ) -> BlockFlow {
        match code {
            AfterCode::SpindleStop
            | AfterCode::LiveToolStop
            | AfterCode::CoolantOff
            | AfterCode::CoolantThroughToolOff => self.switch_off(block, code),
            AfterCode::ProgramStop => self.kernel.emit(CommandKind::Stop { optional: false }),
            AfterCode::OptionalStop => self.kernel.emit(CommandKind::Stop { optional: true }),
            AfterCode::ProgramEnd { .. } => {
                self.drop_open_spline(block);
                self.kernel.set_live_tool(None);
                self.kernel.set_spindle(SpindleState::Off);
                self.kernel.emit(CommandKind::End);
                return BlockFlow::End(EndReason::ProgramEnd);
            }
            AfterCode::ProgramAgain => {
                let span = self.span(block.words[at].range);
                let name = self.code_text(block, at);
                self.report_repeat(span, &name);
                return BlockFlow::End(EndReason::Repeats);
            }
            AfterCode::ShopCode => self.carry_out_shop_code(block, codes, at),
            AfterCode::RunCycleHere => self.run_cycle_here(block, at),
        }
        BlockFlow::Next
    }

    fn take_call(&mut self, block: &Block, code: CallCode, at: usize) {
        match code {
            CallCode::CallProgram => self.call_program(block, at),
            CallCode::CallLabel => self.call_label(block, at),
            CallCode::SubroutineEnd => self.return_from_subroutine(block, at),
            // The block ends with it.
            CallCode::Return => {}
            // Carried out before the words of their block, which are arguments.
            CallCode::MacroCall | CallCode::ModalMacroCall { .. } => {}
        }
    }
}

/// True when S is a word of the code itself: a time or an angle.
fn speed_is_of_code(codes: &[(&'static CodeRow, usize)]) -> bool {
    codes.iter().any(|(row, _)| {
        let takes = row.action.is_left_out()
            || row.action == Action::NoEffect
            || row.action == Action::Once(OnceCode::Dwell)
            || row.action == Action::After(AfterCode::ProgramStop);
        takes && row.words.has(b'S')
    })
}

fn starts_spindle(row: &CodeRow) -> bool {
    row.action == Action::Before(BeforeCode::SpindleCw)
        || row.action == Action::Before(BeforeCode::SpindleCcw)
}
