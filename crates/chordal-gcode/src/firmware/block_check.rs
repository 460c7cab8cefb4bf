//! A block is judged as a whole. The mistakes of its words come first, in their order; then those of the block, in
//! the order in which the firmware looks for them.

use chordal_command::AxisMask;
use chordal_diagnostics::TextRange;
use chordal_dialect::firmware::{Firmware, FirmwareError, NeededWords};
use chordal_dialect::{
    Action, BeforeCode, CodeGroup, CodeRow, Control, LengthCode, MotionCode, OnceCode, ToolChanger,
};
use chordal_machine::AXIS_LETTERS;
use chordal_syntax::{Decimal, Letters};

use super::codes::{
    AxisUse, axis_use, byte, ends_motion, in_inch, is_machine_move, tenths, whole_number,
};
use super::line::{LineFault, ReadWord};
use super::memory::{FirmwareMemory, FirmwareModes, FirmwareMotion};

pub(super) const MM_PER_INCH: f32 = 25.4;
/// Letters whose values are not below zero.
const NOT_NEGATIVE: Letters = Letters::of("FNPST");
/// Letters that need no code.
const STORED: Letters = Letters::of("NFST");
/// The axes that each build has.
const AXES: Letters = Letters::of("XYZ");
const CENTRES: Letters = Letters::of("IJK");
/// Letters that a jog may have with its axes, and its G codes, ten times the number.
const JOG: Letters = Letters::of("FN");
const JOG_CODES: [u16; 5] = [200, 210, 530, 900, 910];

/// A block that the firmware carries out.
#[derive(Debug)]
pub(super) struct AcceptedBlock {
    /// What acts, with the numbers that the firmware takes.
    pub words: Vec<ReadWord>,
    /// Words that pass, and that nothing uses.
    pub dropped: Vec<ReadWord>,
    /// What it remembers then.
    pub after: FirmwareMemory,
}

/// A block while it is judged.
pub(super) struct BlockCheck<'a> {
    pub control: &'a Control,
    pub firmware: &'a Firmware,
    pub before: &'a FirmwareMemory,
    pub words: Vec<ReadWord>,
    /// The letter of each code and its row.
    pub codes: Vec<(u8, &'static CodeRow)>,
    pub written: Letters,
    /// Words that nothing has used yet.
    pub left: Letters,
    pub modes: FirmwareModes,
    pub axis_use: Option<AxisUse>,
    pub once: Option<OnceCode>,
    pub stores: Option<usize>,
    pub length: Option<LengthCode>,
    pub groups: Vec<CodeGroup>,
    pub whole: TextRange,
}

/// Judges a line of words; `jog` where it follows `$J=`.
///
/// # Errors
/// Its first mistake.
pub(super) fn judge(
    words: impl Iterator<Item = Result<ReadWord, LineFault>>,
    whole: TextRange,
    control: &Control,
    firmware: &Firmware,
    before: &FirmwareMemory,
    jog: bool,
) -> Result<AcceptedBlock, LineFault> {
    let mut judged = BlockCheck {
        control,
        firmware,
        before,
        words: Vec::new(),
        codes: Vec::new(),
        written: Letters::NONE,
        left: Letters::NONE,
        modes: before.modes,
        axis_use: None,
        once: None,
        stores: None,
        length: None,
        groups: Vec::new(),
        whole,
    };
    if jog {
        (judged.modes.motion, judged.modes.inverse) = (FirmwareMotion::Linear, false);
    }
    for word in words {
        judged.word(word?)?;
    }
    judged.block(jog)
}

impl BlockCheck<'_> {
    fn word(&mut self, word: ReadWord) -> Result<(), LineFault> {
        let number = match word.letter {
            b'G' | b'M' => tenths(self.code(&word)?.code),
            letter => {
                self.value(&word, letter)?;
                word.number
            }
        };
        self.words.push(ReadWord { number, ..word });
        Ok(())
    }

    fn value(&mut self, word: &ReadWord, letter: u8) -> Result<(), LineFault> {
        let refuse = |refusal| Err(LineFault::new(refusal, word.range));
        if !self.firmware.line.letters.union(self.axis_letters()).has(letter) {
            return refuse(FirmwareError::Unknown);
        }
        if letter == b'T' && word.value > self.firmware.largest[1] as f32 {
            return refuse(FirmwareError::ToolNumber);
        }
        if self.written.has(letter) {
            return refuse(FirmwareError::Repeated);
        }
        if NOT_NEGATIVE.has(letter) && word.value < 0.0 {
            // A way to a control point goes in either direction; which motion it is is known at the end of the block.
            if letter != b'P' || !self.has_splines() {
                return refuse(FirmwareError::Negative);
            }
        }
        self.written.insert(letter);
        self.left.insert(letter);
        Ok(())
    }

    fn has_splines(&self) -> bool {
        let is_spline = |row: &CodeRow| matches!(row.action.motion(), Some(MotionCode::Spline(_)));
        self.control.table.g_codes.iter().any(is_spline)
    }

    fn code(&mut self, word: &ReadWord) -> Result<&'static CodeRow, LineFault> {
        let refuse = |refusal| Err(LineFault::new(refusal, word.range));
        let row = self.row(word);
        // Motions and lengths ask for the axis words before their fraction is looked at.
        let axis_use = match &row {
            Ok(row) => axis_use(row),
            Err(_) => self.kin(word).and_then(axis_use).filter(|of| *of != AxisUse::Once),
        };
        if axis_use.is_some() {
            if self.axis_use.is_some() && !self.passes_reference(&row) {
                return refuse(FirmwareError::AxisConflict);
            }
            self.axis_use = if self.axis_use.is_some() { Some(AxisUse::Once) } else { axis_use };
        }
        let row = row?;
        // G38.2 and its like are motions here, and G80 is none of them.
        let is_motion = axis_use == Some(AxisUse::Motion) || ends_motion(row);
        let group = if is_motion { CodeGroup::Motion } else { row.group };
        if self.groups.contains(&group) && group != CodeGroup::Auxiliary {
            return refuse(FirmwareError::SameGroup);
        }
        self.groups.push(group);
        self.codes.push((word.letter, row));
        if let Action::Length(code) = row.action {
            self.length = Some(code);
        }
        self.once = self.once.or(row.action.once().filter(|_| axis_use != Some(AxisUse::Motion)));
        self.stores = self.stores.or(row.stored_reference());
        self.modes.take(row);
        Ok(row)
    }

    /// A motion and a return to a stored point in one block, where the point takes the axis words.
    fn passes_reference(&self, row: &Result<&'static CodeRow, LineFault>) -> bool {
        let returns =
            |row: &CodeRow| matches!(row.action.once(), Some(OnceCode::ReturnToReference { .. }));
        let moves = |row: &CodeRow| row.action.is_plain_motion();
        let is_pair =
            |new: &CodeRow, old: &CodeRow| returns(new) && moves(old) || moves(new) && returns(old);
        self.firmware.block.reference_with_motion
            && row.as_ref().is_ok_and(|new| self.codes.iter().any(|(_, old)| is_pair(new, old)))
    }

    /// A code with the same whole number, where one with this fraction is not known.
    fn kin(&self, word: &ReadWord) -> Option<&'static CodeRow> {
        let same = |row: &&CodeRow| row.code / 10 == whole_number(word.value);
        self.control.table.g_codes.iter().find(same).filter(|_| word.letter == b'G')
    }

    /// The row of a code, whose number counts in hundredths.
    fn row(&self, word: &ReadWord) -> Result<&'static CodeRow, LineFault> {
        let number = whole_number(word.value);
        let any = word.letter == b'G' && self.firmware.any_fraction.contains(&number);
        let part = if any { 0.0 } else { word.value - word.value.trunc() };
        let hundredths = (100.0 * part).round() as i32;
        let of = |code: u16| match word.letter {
            b'G' => self.control.g_code(code),
            _ => self.control.m_code(code),
        };
        // `G0.999` has a hundred of them, and is not G1; nor is `G-0.3` a code.
        let is_code = hundredths % 10 == 0 && (0..100).contains(&hundredths);
        let row = if is_code { of(number * 10 + hundredths as u16 / 10) } else { None };
        let takes_fractions = word.letter == b'G' && self.firmware.with_fractions.contains(&number);
        let is_known = word.letter == b'M' || of(number * 10).is_some() && !takes_fractions;
        match row {
            Some(row) if self.is_left_out(row) => {
                Err(LineFault::new(FirmwareError::Unknown, word.range))
            }
            Some(row) => Ok(row),
            None if hundredths != 0 && is_known => {
                Err(LineFault::new(FirmwareError::Fraction, word.range))
            }
            None => Err(LineFault::new(FirmwareError::Unknown, word.range)),
        }
    }

    /// A tool change, where nobody changes tools.
    fn is_left_out(&self, row: &CodeRow) -> bool {
        self.control.parameters.tool_change == ToolChanger::Nobody
            && row.group == CodeGroup::ToolChange
    }

    pub fn number(&self, letter: u8) -> Option<f32> {
        self.words.iter().find(|word| word.letter == letter).map(|word| word.value)
    }

    /// Where a letter is written, or the whole block.
    pub fn place(&self, letters: &str) -> TextRange {
        let has = |word: &&ReadWord| letters.contains(char::from(word.letter));
        self.words.iter().find(has).map_or(self.whole, |word| word.range)
    }

    pub fn refuse<T>(&self, refusal: FirmwareError, letters: &str) -> Result<T, LineFault> {
        Err(LineFault::new(refusal, self.place(letters)))
    }

    pub fn refuse_measured<T>(
        &self,
        refusal: FirmwareError,
        letters: &str,
        measured: String,
    ) -> Result<T, LineFault> {
        Err(LineFault { measured: Some(measured), ..LineFault::new(refusal, self.place(letters)) })
    }

    pub fn use_up(&mut self, letters: Letters) {
        self.left = self.left.without(letters);
    }

    pub fn has_axes(&self) -> bool {
        self.written.meets(self.axis_letters())
    }

    /// The axes of this machine.
    pub fn axis_letters(&self) -> Letters {
        let mut letters = AXES;
        if self.firmware.line.further_axes {
            let rotary = self.control.axes().and(AxisMask::ROTARY);
            let has = |axis: &usize| rotary.has(*axis);
            (0..chordal_machine::AXES)
                .filter(has)
                .for_each(|axis| letters.insert(AXIS_LETTERS.as_bytes()[axis]));
        }
        letters
    }

    fn block(mut self, jog: bool) -> Result<AcceptedBlock, LineFault> {
        if self.has_axes() && self.axis_use.is_none() {
            self.axis_use = Some(AxisUse::Motion);
        }
        if self.number(b'N').is_some_and(|n| n.trunc() > self.firmware.largest[0] as f32) {
            return self.refuse(FirmwareError::LineNumber, "N");
        }
        let is_spline = matches!(self.modes.motion, FirmwareMotion::Spline(_));
        if !is_spline && self.number(b'P').is_some_and(|p| p < 0.0) {
            return self.refuse(FirmwareError::Negative, "P");
        }
        let feed = self.feed(jog)?;
        if self.once == Some(OnceCode::Dwell) {
            if !self.written.has(b'P') {
                return self.refuse(FirmwareError::NoValue, "G");
            }
            self.use_up(Letters::of("P"));
        }
        self.needed_words()?;
        let mut after = self.before.clone();
        (after.modes, after.feed) = (self.modes, feed);
        self.take_length(&mut after)?;
        let target = self.once_codes(&mut after)?;
        self.motion(&mut after, target, feed)?;
        self.use_up(STORED);
        if self.control.parameters.build.expressions {
            // The head of what M98 calls.
            self.use_up(Letters::of("O"));
        }
        if self.axis_use.is_some() {
            self.use_up(self.axis_letters());
        }
        if self.left != Letters::NONE {
            let letters: String = self.left.iter().collect();
            return self.refuse(FirmwareError::Unused, &letters);
        }
        if jog {
            self.check_jog()?;
            (after.modes, after.feed) = (self.before.modes, self.before.feed);
        }
        if self.codes.iter().any(|(_, row)| row.ends_program()) {
            after.end_program();
        }
        self.keep_modes(&mut after);
        Ok(self.accepted(after))
    }

    /// Words that codes cannot be without, and those that they take.
    fn needed_words(&mut self) -> Result<(), LineFault> {
        for (letter, row) in self.codes.clone() {
            let is_own = |(of, code, _): &&NeededWords| *of == letter && *code == row.code;
            if let Some((_, _, words)) = self.firmware.needs.iter().find(is_own)
                && !Letters::of(words).within(self.written)
            {
                return self.refuse(FirmwareError::NoValue, if letter == b'G' { "G" } else { "M" });
            }
            // What moves or writes asks for its words itself.
            let by_itself = row.action.motion().is_some()
                || row.action.cycle().is_some()
                || row.action.once().is_some();
            if !by_itself {
                self.use_up(row.words);
            }
        }
        Ok(())
    }

    fn take_length(&self, after: &mut FirmwareMemory) -> Result<(), LineFault> {
        match self.length {
            Some(LengthCode::Cancel) => after.length = [0.0; 3],
            Some(LengthCode::FromAxes) => {
                let axes = self.firmware.block.length_axes;
                let others = self.axis_letters().without(axes);
                if !self.written.meets(axes) || self.written.meets(others) {
                    let letters: String = others.iter().chain(['G']).collect();
                    return self.refuse(FirmwareError::LengthAxis, &letters);
                }
                for (axis, length) in after.length.iter_mut().enumerate() {
                    *length = self.axis(axis).unwrap_or(*length);
                }
            }
            // The tool table says it.
            Some(
                LengthCode::Plus
                | LengthCode::Minus
                | LengthCode::Add
                | LengthCode::ToolCenter
                | LengthCode::ToolCenterByVector
                | LengthCode::AlongTool,
            )
            | None => {}
        }
        Ok(())
    }

    /// M70 to M73.
    fn keep_modes(&self, after: &mut FirmwareMemory) {
        for (_, row) in &self.codes {
            if let Action::Before(BeforeCode::SaveModes { .. }) = row.action {
                after.kept = Some((self.before.modes, self.before.feed));
            } else if row.action == Action::Before(BeforeCode::ForgetModes) {
                after.kept = None;
            } else if row.action == Action::Before(BeforeCode::RestoreModes)
                && let Some((modes, feed)) = after.kept
            {
                after.modes = FirmwareModes { motion: after.modes.motion, ..modes };
                after.feed = feed;
            }
        }
    }

    /// The words that act.
    fn accepted(self, after: FirmwareMemory) -> AcceptedBlock {
        let unused = self.unused();
        // Next to a tool length nothing moves, and G53 has nothing to say.
        let stays = self.axis_use == Some(AxisUse::Length);
        let control = self.control;
        let is_unused =
            |word: &ReadWord| unused.has(word.letter) || stays && is_machine_move(control, word);
        let writes = self.once == Some(OnceCode::SetData);
        let in_mm = self.modes.inch && self.leaves_inverse();
        let implied = self.implied_code();
        let (mut dropped, mut words): (Vec<ReadWord>, Vec<ReadWord>) =
            self.words.into_iter().partition(is_unused);
        // A zero, as posts write it, says nothing.
        dropped.retain(|word| !CENTRES.has(word.letter) || word.value != 0.0);
        words.splice(0..0, implied);
        for word in &mut words {
            match word.letter {
                // Numbers of offsets are cut to whole ones, and L to a byte.
                b'L' if writes => word.number = Decimal::integer(i64::from(byte(word.value))),
                b'P' if writes => word.number = Decimal::integer(word.value.trunc() as i64),
                b'F' if in_mm => word.number = in_inch(word.value),
                _ => {}
            }
        }
        AcceptedBlock { words, dropped, after }
    }

    /// Letters of words that pass and have no effect: axes next to G49, a centre outside the plane.
    fn unused(&self) -> Letters {
        if self.length == Some(LengthCode::Cancel) {
            return self.axis_letters();
        }
        let is_arc = self.modes.motion == FirmwareMotion::Arc;
        if is_arc && self.axis_use == Some(AxisUse::Motion) && !self.written.has(b'R') {
            let [a, b] = self.modes.plane_axes();
            let mut letters = Letters::NONE;
            letters.insert(b"IJK"[3 - a - b]);
            return letters;
        }
        Letters::NONE
    }

    /// The code of a probe move or a spline, in a block that only has its words: elsewhere they are not modal.
    fn implied_code(&self) -> Option<ReadWord> {
        let code = match self.modes.motion {
            FirmwareMotion::Probe(code) | FirmwareMotion::Spline(code) => code,
            FirmwareMotion::Rapid
            | FirmwareMotion::Linear
            | FirmwareMotion::Arc
            | FirmwareMotion::Cycle
            | FirmwareMotion::None => return None,
        };
        let is_written = self.groups.contains(&CodeGroup::Motion);
        if is_written || self.axis_use != Some(AxisUse::Motion) {
            return None;
        }
        let number = tenths(code);
        let (value, range) = (number.to_f64() as f32, self.place("XYZ"));
        Some(ReadWord { letter: b'G', value, number, range })
    }

    fn check_jog(&self) -> Result<(), LineFault> {
        for word in &self.words {
            let is_code = word.letter == b'G' && JOG_CODES.contains(&((word.value * 10.0) as u16));
            if !is_code
                && (matches!(word.letter, b'G' | b'M')
                    || !JOG.union(self.axis_letters()).has(word.letter))
            {
                return Err(LineFault::new(FirmwareError::JogWords, word.range));
            }
        }
        if self.has_axes() { Ok(()) } else { self.refuse(FirmwareError::JogWords, "") }
    }

    /// The feed in force, mm/min or 1/min: nothing is kept in and after G93.
    fn feed(&self, jog: bool) -> Result<f32, LineFault> {
        let own = self.number(b'F');
        if self.modes.inverse {
            let cuts = !matches!(self.modes.motion, FirmwareMotion::None | FirmwareMotion::Rapid);
            if self.axis_use == Some(AxisUse::Motion) && cuts && own.is_none() {
                return self.refuse(FirmwareError::NoFeed, "G");
            }
            return Ok(own.unwrap_or(0.0));
        }
        let unit = if self.modes.inch && !self.leaves_inverse() { MM_PER_INCH } else { 1.0 };
        let kept = if self.before.modes.inverse || jog { 0.0 } else { self.before.feed };
        Ok(own.map_or(kept, |feed| feed * unit))
    }

    /// The block that changes from G93 to G94: its F is mm/min, also in inch.
    fn leaves_inverse(&self) -> bool {
        self.before.modes.inverse && !self.modes.inverse
    }

    /// An axis word, mm.
    pub fn axis(&self, axis: usize) -> Option<f32> {
        let value = self.number(b"XYZ"[axis])?;
        Some(if self.modes.inch { value * MM_PER_INCH } else { value })
    }
}
