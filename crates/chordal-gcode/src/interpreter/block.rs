//! One block: its codes are collected, checked, and carried out in the order of the control.

use chordal_command::AxisMask;
use chordal_dialect::table::{LineRepeat, SubroutineForm};
use chordal_dialect::{Action, BeforeCode, LengthCode, OnceCode};
use chordal_dialect::{CodeGroup, CodeRow, UnitCodes, code_number};
use chordal_machine::AXIS_LETTERS;
use chordal_syntax::{Block, Letters, Word};

use super::conflicts::ALWAYS;
use super::{BlockFlow, EndReason, Interpreter};

/// Letters of a block that only moves: no mode, no offset table, no call.
const PLAIN: Letters = Letters::of("NXYZABCFIJKG");

const AXES: Letters = Letters::of(AXIS_LETTERS);

impl Interpreter<'_> {
    /// Carries out the words of a block.
    pub(super) fn carry_out(&mut self, block: &Block) -> BlockFlow {
        if block.channel.is_some() {
            self.check_channel(block);
        }
        self.check_numbers(block);
        if self.plain_motion(block) {
            return BlockFlow::Next;
        }
        if let Some(flow) = self.macro_call(block) {
            return flow;
        }
        let active = self.macros.active;
        let mut codes = std::mem::take(&mut self.codes);
        self.gather(block, &mut codes);
        if self.shop.takes_words {
            // The axis words belong to the custom code and do not move.
            self.take_switches(block, &codes);
            let flow = self.take_after_motion(block, &codes);
            self.codes = codes;
            return flow;
        }
        let flow = self.carry_out_codes(block, &codes);
        codes.clear();
        self.codes = codes;
        // The block that starts a modal call does not make it.
        if active > 0 && self.macros.active > 0 { self.modal_call_after(block, flow) } else { flow }
    }

    /// Carries out a block that contains only a move, as most blocks do. False, without any effect, when the block
    /// contains more.
    #[inline]
    fn plain_motion(&mut self, block: &Block) -> bool {
        let letters = block.letters();
        if !letters.within(PLAIN)
            || self.kernel.state.cycle.is_some()
            || self.kernel.state.surface.is_some()
            || self.open_plane.is_some()
            || self.kernel.state.tool_by_vector
            || self.macros.active > 0
            || block.repeated() != Letters::NONE
            || block.commas
            || !block.polar.is_empty()
        {
            return false;
        }
        let explicit = match block.word(b'G') {
            None => None,
            Some(word) => {
                let code = word.number().and_then(code_number);
                let row = code.and_then(|code| self.control.g_code(code));
                let Some(row) = row else { return false };
                let Action::Motion(motion) = row.action else { return false };
                // `G2.0` is checked with the codes.
                if word.number().is_some_and(|number| number.scale > 0) {
                    return false;
                }
                Some((row, motion))
            }
        };
        if self.control.parameters.corner_words_in_g1
            && letters.meets(Letters::of("IKR"))
            && self.cuts_line(block)
        {
            return false;
        }
        if !letters.within(ALWAYS) {
            let words = match explicit {
                Some((row, _)) => self.words_of(row),
                None => self.modal_arc_words().unwrap_or(Letters::NONE),
            };
            if !letters.within(ALWAYS.union(words)) {
                return false;
            }
        }
        if letters.has(b'F') {
            self.take_feed(block);
        }
        self.motion_block(block, explicit.map(|(_, motion)| motion));
        true
    }

    /// Finds the rows of all G and M words and checks that they may be in one block.
    fn gather(&mut self, block: &Block, codes: &mut Vec<(&'static CodeRow, usize)>) {
        codes.clear();
        self.shop.begin_block();
        self.check_repeated_words(block);
        for (at, word) in block.words.iter().enumerate() {
            if !matches!(word.letter, b'G' | b'M') {
                continue;
            }
            let Some(number) = self.literal(word) else { continue };
            let row = code_number(number).and_then(|code| match word.letter {
                b'G' => {
                    let own = self.control.g_code(code).filter(|row| self.has_unit_code(row));
                    own.or_else(|| self.row_of_other_system(word, code))
                }
                _ => self.m_row(block, at, code),
            });
            let row = row.or_else(|| self.open_m_code(block, at, number));
            match row {
                Some(row) => {
                    if number.scale > 0 {
                        self.check_written_with_zero(word, row);
                    }
                    codes.push((row, at));
                }
                None => {
                    self.emit_unknown_code(word);
                    self.unknown_code(word);
                }
            }
        }
        self.check_groups(block, codes);
    }

    /// The row of a feed mode (G95) that only another code system of the control contains: carried out with a warning,
    /// since nothing else can be meant. Other codes depend on their system: with G91 of system B, G90 of system A would
    /// never end it.
    fn row_of_other_system(&mut self, word: &Word, code: u16) -> Option<&'static CodeRow> {
        let systems = self.control.table.systems;
        let (name, row) = systems.iter().find_map(|system| {
            let mut rows = system.codes.iter();
            let row = rows.find(|row| row.code == code && row.group == CodeGroup::FeedMode)?;
            Some((system.name, row))
        })?;
        self.report_other_system(word, row, name);
        Some(row)
    }

    /// The row of an M code. One that the table does not contain or does not carry out may be a custom code.
    fn m_row(&mut self, block: &Block, at: usize, code: u16) -> Option<&'static CodeRow> {
        let row = self.control.m_code(code);
        match row {
            Some(row) if !row.action.is_left_out() => Some(row),
            _ => self.shop_row(block, at, code).or(row),
        }
    }

    /// False for a unit code that the settings disable: units by G20 and G21, by G70 and G71, or by both.
    fn has_unit_code(&self, row: &CodeRow) -> bool {
        let by_g70 = row.code >= 700;
        match self.control.parameters.unit_codes {
            _ if row.group != CodeGroup::Units => true,
            UnitCodes::Both => true,
            UnitCodes::G20 => !by_g70,
            UnitCodes::G70 => by_g70,
        }
    }

    fn carry_out_codes(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) -> BlockFlow {
        // What an unknown code does with the words is not known; the tool still moves to the end point
        // that they give.
        let code_words = block.all(b'G').count() + block.all(b'M').count();
        if codes.len() < code_words {
            self.take_reading_modes(block, codes);
            self.take_letters(block, codes);
            self.check_comma_words(block);
            self.take_corner(block);
            let (target, named) = self.target(block);
            if named != AxisMask::NONE {
                self.kernel.straight(&self.at(block), target, named);
            }
            return self.take_after_motion(block, codes);
        }
        let claims = self.claims(block, codes);
        if let Some(flow) = self.repeat_or_call_by_l(block, codes, claims) {
            return flow;
        }
        self.check_unused(block, claims);
        if self.kernel.state.surface.is_some() && !self.check_surface_codes(block, codes) {
            return self.take_after_motion(block, codes);
        }
        self.block_without_repeats(block, codes)
    }

    /// Carries out a block once; a line repeat calls this for each pass.
    pub(super) fn block_without_repeats(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
    ) -> BlockFlow {
        for (row, at) in codes {
            if let Action::Before(code) = row.action {
                self.keep_modes(block, code, *at);
            }
        }
        self.take_reading_modes(block, codes);
        if self.open_plane.is_some() {
            self.close_plane(block, codes);
        }
        self.watch_spatial(block, codes);
        self.check_word_rules(block, codes);
        self.check_multiplied_words(block, codes);
        self.take_registers(block);
        self.take_letters(block, codes);
        // G41 in the block of a pocket gives its side; the cycle itself offsets.
        let own_side =
            codes.iter().any(|(row, _)| row.action == Action::Once(OnceCode::GeneralPocket));
        for (row, at) in codes {
            if !(own_side && row.group == CodeGroup::Compensation) {
                self.take_mode(block, row, *at);
            }
        }
        self.take_length(block, codes);
        if codes.iter().any(|(row, _)| row.action == Action::Before(BeforeCode::RestoreModes)) {
            self.restore_modes(block);
        }
        if !block.polar.is_empty() && !self.check_polar(block, codes) {
            return self.take_after_motion(block, codes);
        }
        let dwells = self.control.parameters.dwell_with_motion;
        let leaves = |row: &CodeRow| row.action.leaves_axes(dwells);
        let adds_axes = |row: &CodeRow| {
            row.action == Action::Length(LengthCode::Add) && !block.letters().has(b'H')
        };
        let one_shot = codes
            .iter()
            .rev()
            .find(|(row, _)| (row.takes_axes() || adds_axes(row)) && !leaves(row));
        let moves = block.letters().meets(AXES);
        let waits = |row: &CodeRow| {
            moves
                && self.control.parameters.preset_cleared_after_motion
                && matches!(row.action, Action::Once(OnceCode::ClearPreset { .. }))
        };
        let after = codes.iter().find(|(row, _)| waits(row));
        if let Some((row, at)) = codes.iter().find(|(row, _)| leaves(row)) {
            if after.is_none() {
                row.action.once().into_iter().for_each(|code| self.one_shot(block, code, *at));
            }
            if !moves && block.polar.is_empty() {
                let motion = codes.iter().rev().find_map(|(row, _)| row.action.motion());
                motion.into_iter().for_each(|code| self.take_motion_code(code));
                return self.take_after_motion(block, codes);
            }
        }
        match one_shot {
            Some((row, at)) => {
                self.modes_with_one_shot(block, codes, row);
                // A code that is not carried out was reported with the modes; its axis words have no effect either.
                if let Some(code) = row.action.once() {
                    self.one_shot(block, code, *at);
                } else if matches!(row.action, Action::NoEffect | Action::NotSimulated) {
                    self.unused_axes(block, |_, letter| row.words.has(letter));
                }
            }
            None => {
                let motion = codes.iter().rev().find_map(|(row, _)| row.action.motion());
                let radial = self.control.table.radial_cycles;
                let cycle = codes
                    .iter()
                    .rev()
                    .find_map(|(row, _)| Some((row.action.cycle()?, radial.contains(&row.code))));
                self.take_corner(block);
                self.motion_or_cycle(block, motion, cycle);
            }
        }
        if let Some((row, at)) = after {
            row.action.once().into_iter().for_each(|code| self.one_shot(block, code, *at));
        }
        self.take_after_motion(block, codes)
    }

    /// L without a code that uses it: a line repeat, or on a Fadal a call.
    fn repeat_or_call_by_l(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
        claims: Letters,
    ) -> Option<BlockFlow> {
        let table = self.control.table;
        let calls = table.subroutines == SubroutineForm::LetterL;
        let taken = claims.has(b'L') && !(calls && self.cycle_counts_in_l(block, codes));
        if taken || !block.letters().has(b'L') {
            return None;
        }
        let word = *block.last(b'L')?;
        let count = self.count(&word)?;
        // Below 100, L repeats the hole of the active cycle.
        if claims.has(b'L') && count < 100 {
            return None;
        }
        if table.subroutines == SubroutineForm::LetterL && count >= 100 {
            let mut claims = claims;
            claims.insert(b'L');
            self.check_unused(block, claims);
            self.take_registers(block);
            self.take_letters(block, codes);
            if self.fixed_routine(block, &word, count) {
                return Some(BlockFlow::Next);
            }
            if self.kernel.state.cycle.is_some() {
                self.next_hole_with_call(block);
            } else {
                let (target, named) = self.target(block);
                if named != AxisMask::NONE {
                    self.kernel.straight(&self.at(block), target, named);
                }
            }
            self.call_subroutine(&word, count);
            return Some(BlockFlow::Next);
        }
        if table.line_repeat == LineRepeat::None {
            return None;
        }
        let mut claims = claims;
        claims.insert(b'L');
        self.check_unused(block, claims);
        let times = self.allowed_repeats(&word, count);
        if !self.reads_incremental(block) {
            self.check_repeated_height(block, &word, times);
        }
        self.warn_of_repeated_modal_subroutine(block, times);
        for pass in 0..times {
            if pass > 0 && !self.kernel.count_repeated() {
                return Some(BlockFlow::End(EndReason::Budget));
            }
            if let end @ BlockFlow::End(_) = self.block_without_repeats(block, codes) {
                return Some(end);
            }
        }
        Some(BlockFlow::Next)
    }
}
