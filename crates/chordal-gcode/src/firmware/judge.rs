//! A block is judged as a whole. The mistakes of its words come first, in their order; then those of the block, in
//! the order in which the firmware looks for them.

use chordal_diagnostics::TextRange;
use chordal_dialect::firmware::{Firmware, Refusal};
use chordal_dialect::{Action, CodeRow, Control, Group, LengthCode, OnceCode};
use chordal_syntax::{Decimal, Letters};

use super::codes::{
    AxisUse, axis_use, byte, ends_motion, in_inch, is_machine_move, tenths, whole_number,
};
use super::line::{Fault, Line, ReadWord};
use super::memory::{FirmwareMotion, Memory, Modes};

const MM_PER_INCH: f32 = 25.4;
/// Letters whose values are not below zero.
const NOT_NEGATIVE: Letters = Letters::of("FNPST");
/// Letters that need no code.
const STORED: Letters = Letters::of("NFST");
const AXES: Letters = Letters::of("XYZ");
const CENTRES: Letters = Letters::of("IJK");
/// Letters that a jog may have with its axes, and its G codes, ten times the number.
const JOG: Letters = Letters::of("FNXYZ");
const JOG_CODES: [u16; 5] = [200, 210, 530, 900, 910];

/// A block that the firmware carries out.
#[derive(Debug)]
pub(super) struct Accepted {
    /// What acts, with the numbers that the firmware takes.
    pub words: Vec<ReadWord>,
    /// Words that pass, and that nothing uses.
    pub dropped: Vec<ReadWord>,
    /// What it remembers then.
    pub after: Memory,
}

/// A block while it is judged.
struct Judged<'a> {
    control: &'a Control,
    firmware: &'a Firmware,
    before: &'a Memory,
    words: Vec<ReadWord>,
    written: Letters,
    /// Words that nothing has used yet.
    left: Letters,
    modes: Modes,
    axis_use: Option<AxisUse>,
    once: Option<OnceCode>,
    stores: Option<usize>,
    length: Option<LengthCode>,
    ends: bool,
    groups: Vec<Group>,
    whole: TextRange,
}

/// Judges a line of words; `jog` where it follows `$J=`.
///
/// # Errors
/// Its first mistake.
pub(super) fn judge(
    line: &mut Line,
    whole: TextRange,
    control: &Control,
    firmware: &Firmware,
    before: &Memory,
    jog: bool,
) -> Result<Accepted, Fault> {
    let mut judged = Judged {
        control,
        firmware,
        before,
        words: Vec::new(),
        written: Letters::NONE,
        left: Letters::NONE,
        modes: before.modes,
        axis_use: None,
        once: None,
        stores: None,
        length: None,
        ends: false,
        groups: Vec::new(),
        whole,
    };
    if jog {
        (judged.modes.motion, judged.modes.inverse) = (FirmwareMotion::Linear, false);
    }
    while let Some(word) = line.word() {
        judged.word(word?)?;
    }
    judged.block(jog)
}

impl Judged<'_> {
    fn word(&mut self, word: ReadWord) -> Result<(), Fault> {
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

    fn value(&mut self, word: &ReadWord, letter: u8) -> Result<(), Fault> {
        let refuse = |refusal| Err(Fault::new(refusal, word.range));
        if !self.firmware.letters.has(letter) {
            return refuse(Refusal::Unknown);
        }
        if letter == b'T' && word.value > self.firmware.largest[1] as f32 {
            return refuse(Refusal::ToolNumber);
        }
        if self.written.has(letter) {
            return refuse(Refusal::Repeated);
        }
        if NOT_NEGATIVE.has(letter) && word.value < 0.0 {
            return refuse(Refusal::Negative);
        }
        self.written.insert(letter);
        self.left.insert(letter);
        Ok(())
    }

    fn code(&mut self, word: &ReadWord) -> Result<&'static CodeRow, Fault> {
        let refuse = |refusal| Err(Fault::new(refusal, word.range));
        let row = self.row(word);
        // Motions and lengths ask for the axis words before their fraction is looked at.
        let axis_use = match &row {
            Ok(row) => axis_use(row),
            Err(_) => self.kin(word).and_then(axis_use).filter(|of| *of != AxisUse::Once),
        };
        if axis_use.is_some() {
            if self.axis_use.is_some() {
                return refuse(Refusal::AxisConflict);
            }
            self.axis_use = axis_use;
        }
        let row = row?;
        // G38.2 and its like are motions here, and G80 is none of them.
        let is_motion = axis_use == Some(AxisUse::Motion) || ends_motion(row);
        let group = if is_motion { Group::Motion } else { row.group };
        if self.groups.contains(&group) {
            return refuse(Refusal::SameGroup);
        }
        self.groups.push(group);
        if let Action::Length(code) = row.action {
            self.length = Some(code);
        }
        self.once = self.once.or(row.action.once().filter(|_| axis_use != Some(AxisUse::Motion)));
        self.ends |= row.ends_program();
        self.stores = self.stores.or(row.stored_reference());
        self.modes.take(row);
        Ok(row)
    }

    /// A code with the same whole number, where one with this fraction is not known.
    fn kin(&self, word: &ReadWord) -> Option<&'static CodeRow> {
        let same = |row: &&CodeRow| row.code / 10 == whole_number(word.value);
        self.control.table.g_codes.iter().find(same).filter(|_| word.letter == b'G')
    }

    /// The row of a code, whose number counts in hundredths.
    fn row(&self, word: &ReadWord) -> Result<&'static CodeRow, Fault> {
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
        let by_sender = self.control.parameters.sender_changes_tools;
        match row {
            Some(row) if row.group == Group::ToolChange && !by_sender => {
                Err(Fault::new(Refusal::Unknown, word.range))
            }
            Some(row) => Ok(row),
            None if hundredths != 0 && is_known => Err(Fault::new(Refusal::Fraction, word.range)),
            None => Err(Fault::new(Refusal::Unknown, word.range)),
        }
    }

    fn number(&self, letter: u8) -> Option<f32> {
        self.words.iter().find(|word| word.letter == letter).map(|word| word.value)
    }

    /// Where a letter is written, or the whole block.
    fn place(&self, letters: &str) -> TextRange {
        let has = |word: &&ReadWord| letters.contains(char::from(word.letter));
        self.words.iter().find(has).map_or(self.whole, |word| word.range)
    }

    fn refuse<T>(&self, refusal: Refusal, letters: &str) -> Result<T, Fault> {
        Err(Fault::new(refusal, self.place(letters)))
    }

    fn refuse_measured<T>(
        &self,
        refusal: Refusal,
        letters: &str,
        measured: String,
    ) -> Result<T, Fault> {
        Err(Fault { measured: Some(measured), ..Fault::new(refusal, self.place(letters)) })
    }

    fn use_up(&mut self, letters: Letters) {
        self.left = self.left.without(letters);
    }

    fn has_axes(&self) -> bool {
        self.written.meets(AXES)
    }

    fn block(mut self, jog: bool) -> Result<Accepted, Fault> {
        if self.has_axes() && self.axis_use.is_none() {
            self.axis_use = Some(AxisUse::Motion);
        }
        if self.number(b'N').is_some_and(|n| n.trunc() > self.firmware.largest[0] as f32) {
            return self.refuse(Refusal::LineNumber, "N");
        }
        let feed = self.feed(jog)?;
        if self.once == Some(OnceCode::Dwell) {
            if !self.written.has(b'P') {
                return self.refuse(Refusal::NoValue, "G");
            }
            self.use_up(Letters::of("P"));
        }
        let only_z = self.written.has(b'Z') && !self.written.meets(Letters::of("XY"));
        if self.length == Some(LengthCode::FromAxes) && !only_z {
            return self.refuse(Refusal::LengthAxis, "XYG");
        }
        let mut after = self.before.clone();
        (after.modes, after.feed) = (self.modes, feed);
        if let Some(code) = self.length {
            after.length = match code {
                LengthCode::Cancel => 0.0,
                LengthCode::FromAxes => self.axis(2).unwrap_or(0.0),
                LengthCode::Plus | LengthCode::Minus | LengthCode::Add => after.length,
            };
        }
        let target = self.once_codes(&mut after)?;
        self.motion(&mut after, target, feed)?;
        self.use_up(STORED);
        if self.axis_use.is_some() {
            self.use_up(AXES);
        }
        if self.left != Letters::NONE {
            let letters: String = self.left.iter().collect();
            return self.refuse(Refusal::Unused, &letters);
        }
        if jog {
            self.check_jog()?;
            (after.modes, after.feed) = (self.before.modes, self.before.feed);
        }
        if self.ends {
            after.end_program();
        }
        Ok(self.accepted(after))
    }

    /// The words that act.
    fn accepted(self, after: Memory) -> Accepted {
        let unused = self.unused();
        // Next to a tool length nothing moves, and G53 has nothing to say.
        let stays = self.axis_use == Some(AxisUse::Length);
        let control = self.control;
        let is_unused =
            |word: &ReadWord| unused.has(word.letter) || stays && is_machine_move(control, word);
        let writes = self.once == Some(OnceCode::SetData);
        let in_mm = self.modes.inch && self.leaves_inverse();
        let probe = self.implied_probe();
        let (mut dropped, mut words): (Vec<ReadWord>, Vec<ReadWord>) =
            self.words.into_iter().partition(is_unused);
        // A zero, as posts write it, says nothing.
        dropped.retain(|word| !CENTRES.has(word.letter) || word.value != 0.0);
        words.splice(0..0, probe);
        for word in &mut words {
            match word.letter {
                // Numbers of offsets are cut to whole ones, and L to a byte.
                b'L' if writes => word.number = Decimal::integer(i64::from(byte(word.value))),
                b'P' if writes => word.number = Decimal::integer(word.value.trunc() as i64),
                b'F' if in_mm => word.number = in_inch(word.value),
                _ => {}
            }
        }
        Accepted { words, dropped, after }
    }

    /// Letters of words that pass and have no effect: axes next to G49, a centre outside the plane.
    fn unused(&self) -> Letters {
        if self.length == Some(LengthCode::Cancel) {
            return AXES;
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

    /// The code of a probe move, in a block that only has its axes.
    fn implied_probe(&self) -> Option<ReadWord> {
        let FirmwareMotion::Probe(code) = self.modes.motion else { return None };
        let is_written = self.groups.contains(&Group::Motion);
        if is_written || self.axis_use != Some(AxisUse::Motion) {
            return None;
        }
        let number = tenths(code);
        let (value, range) = (number.to_f64() as f32, self.place("XYZ"));
        Some(ReadWord { letter: b'G', value, number, range })
    }

    fn check_jog(&self) -> Result<(), Fault> {
        for word in &self.words {
            let is_code = word.letter == b'G' && JOG_CODES.contains(&((word.value * 10.0) as u16));
            if !is_code && (matches!(word.letter, b'G' | b'M') || !JOG.has(word.letter)) {
                return Err(Fault::new(Refusal::JogWords, word.range));
            }
        }
        if self.has_axes() { Ok(()) } else { self.refuse(Refusal::JogWords, "") }
    }

    /// The feed in force, mm/min or 1/min: nothing is kept in and after G93.
    fn feed(&self, jog: bool) -> Result<f32, Fault> {
        let own = self.number(b'F');
        if self.modes.inverse {
            let cuts = !matches!(self.modes.motion, FirmwareMotion::None | FirmwareMotion::Rapid);
            if self.axis_use == Some(AxisUse::Motion) && cuts && own.is_none() {
                return self.refuse(Refusal::NoFeed, "G");
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
    fn axis(&self, axis: usize) -> Option<f32> {
        let value = self.number(b"XYZ"[axis])?;
        Some(if self.modes.inch { value * MM_PER_INCH } else { value })
    }

    /// Codes that take the axis words, and those that store a place; where the block goes.
    fn once_codes(&mut self, after: &mut Memory) -> Result<[f32; 3], Fault> {
        if self.once == Some(OnceCode::SetData) {
            self.set_data(after)?;
            return Ok(after.position);
        }
        if self.once == Some(OnceCode::PresetPosition) {
            if !self.has_axes() {
                return self.refuse(Refusal::NoAxes, "G");
            }
            for axis in 0..3 {
                if let Some(value) = self.axis(axis) {
                    after.preset[axis] =
                        after.position[axis] - after.system()[axis] - value - after.length_of(axis);
                }
            }
            return Ok(after.position);
        }
        let mut target = after.position;
        if self.axis_use != Some(AxisUse::Length) {
            for (axis, target) in target.iter_mut().enumerate() {
                let Some(value) = self.axis(axis) else { continue };
                *target = if self.once == Some(OnceCode::MachineCoordinates) {
                    value
                } else if self.modes.incremental {
                    after.position[axis] + value
                } else {
                    value + (after.system()[axis] + after.preset[axis]) + after.length_of(axis)
                };
            }
        }
        if let Some(OnceCode::ReturnToReference { second }) = self.once {
            let stored = after.stored[usize::from(second)];
            for (axis, stored) in stored.into_iter().enumerate() {
                if !self.has_axes() || self.axis(axis).is_some() {
                    after.position[axis] = stored;
                }
            }
        }
        if let Some(number) = self.stores {
            after.stored[number] = after.position;
        }
        if let Some(OnceCode::ClearPreset { .. }) = self.once {
            after.preset = [0.0; 3];
        }
        let cuts_straight =
            matches!(self.modes.motion, FirmwareMotion::Rapid | FirmwareMotion::Linear);
        if self.once == Some(OnceCode::MachineCoordinates) && !cuts_straight {
            return self.refuse(Refusal::MachineMotion, "G");
        }
        Ok(target)
    }

    fn set_data(&mut self, after: &mut Memory) -> Result<(), Fault> {
        if !self.has_axes() {
            return self.refuse(Refusal::NoAxes, "G");
        }
        if !self.written.meets(Letters::of("PL")) {
            return self.refuse(Refusal::NoValue, "G");
        }
        let system = self.number(b'P').unwrap_or(0.0).trunc();
        if system > self.firmware.largest[2] as f32 {
            return self.refuse(Refusal::WorkOffset, "P");
        }
        let kind = byte(self.number(b'L').unwrap_or(0.0));
        let from_position = kind == 20;
        if kind != 2 && !from_position || kind == 2 && self.written.has(b'R') {
            return self.refuse(Refusal::Unknown, "LG");
        }
        self.use_up(Letters::of("PL"));
        let index = match system as usize {
            0 => after.modes.system,
            number => number - 1,
        };
        for axis in 0..3 {
            let Some(value) = self.axis(axis) else { continue };
            after.systems[index][axis] = match from_position {
                true => after.position[axis] - after.preset[axis] - value - after.length_of(axis),
                false => value,
            };
        }
        Ok(())
    }

    /// The motion in force, and the position after it.
    fn motion(&mut self, after: &mut Memory, target: [f32; 3], feed: f32) -> Result<(), Fault> {
        let motion = self.modes.motion;
        if motion == FirmwareMotion::None {
            return if self.has_axes() {
                self.refuse(Refusal::AxesWithoutMotion, "XYZ")
            } else {
                Ok(())
            };
        }
        if self.axis_use != Some(AxisUse::Motion) {
            return Ok(());
        }
        if motion != FirmwareMotion::Rapid && feed == 0.0 {
            return self.refuse(Refusal::NoFeed, "GXYZ");
        }
        match motion {
            FirmwareMotion::None => {}
            FirmwareMotion::Rapid | FirmwareMotion::Linear => {
                if !self.has_axes() {
                    self.axis_use = None;
                    return Ok(());
                }
            }
            FirmwareMotion::Arc => self.arc(after.position, target)?,
            FirmwareMotion::Probe(_) => {
                if !self.has_axes() {
                    return self.refuse(Refusal::NoAxes, "G");
                }
                if target == after.position {
                    return self.refuse(Refusal::SamePlace, "XYZ");
                }
            }
        }
        after.position = target;
        Ok(())
    }

    fn arc(&mut self, from: [f32; 3], to: [f32; 3]) -> Result<(), Fault> {
        if !self.has_axes() {
            return self.refuse(Refusal::NoAxes, "G");
        }
        let [a, b] = self.modes.plane_axes();
        let letters = |of: &[u8; 3]| {
            let mut letters = Letters::NONE;
            [a, b].into_iter().for_each(|axis| letters.insert(of[axis]));
            letters
        };
        if !self.written.meets(letters(b"XYZ")) {
            return self.refuse(Refusal::NoPlaneAxes, "XYZ");
        }
        let unit = if self.modes.inch { MM_PER_INCH } else { 1.0 };
        let (x, y) = (to[a] - from[a], to[b] - from[b]);
        if let Some(radius) = self.number(b'R') {
            self.use_up(Letters::of("R"));
            if from == to {
                return self.refuse(Refusal::SamePlace, "R");
            }
            let radius = radius * unit;
            if 4.0 * radius * radius - x * x - y * y < 0.0 {
                let half = 0.5 * (x * x + y * y).sqrt();
                let measured = format!("R is {radius} mm, and half the distance {half} mm");
                return self.refuse_measured(Refusal::Radius, "R", measured);
            }
            return Ok(());
        }
        if !self.written.meets(letters(b"IJK")) {
            return self.refuse(Refusal::NoCenter, "IJKG");
        }
        self.use_up(Letters::of("IJK"));
        let center = |axis: usize| self.number(b"IJK"[axis]).unwrap_or(0.0) * unit;
        let size = |x: f32, y: f32| (x * x + y * y).sqrt();
        let radius = size(center(a), center(b));
        let at_end = size(x - center(a), y - center(b));
        let off = (at_end - radius).abs();
        let [always, most, share] = self.firmware.arc;
        if off > always && (off > most || off > share * radius) {
            let allowed = always.max(most.min(share * radius));
            let measured = format!(
                "the radius is {radius} mm at the start and {at_end} mm at the end: {off} mm apart, and {allowed} \
                 mm are allowed"
            );
            return self.refuse_measured(Refusal::OffCircle, "IJK", measured);
        }
        Ok(())
    }
}
