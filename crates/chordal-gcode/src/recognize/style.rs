//! The writing style of a whole text: its number format, and whether it stays within what a small control reads.

use super::line::{SampleLine, SampleWord, bit};

/// The axes whose number format shows how a postprocessor writes numbers.
const AXES: &[u8] = b"XYZ";

/// From this many words like `X5.` on, the trailing point is the postprocessor's format and not an accident.
const MIN_TRAILING_POINTS: u32 = 3;

/// Whole numbers from here on are probably thousandths: X1000 is 1 mm.
const THOUSANDTHS_FROM: f64 = 1000.0;

/// The style found in a text so far; each offset is that of the line of the first occurrence.
#[derive(Debug, Default)]
pub struct TextStyle {
    /// By axis: a whole number without a point.
    whole: [Option<usize>; 3],
    /// By axis: a number with decimals.
    decimal: [Option<usize>; 3],
    /// An axis has a whole number that is probably in thousandths.
    has_thousandths: bool,
    trailing_points: u32,
    first_trailing_point: Option<usize>,
    /// The text contains what small controls do not read: macros, calls, offsets or canned cycles.
    exceeds_small_control: bool,
    /// The first G1.
    first_feed: Option<usize>,
    /// The text has a `%` or an O number.
    has_program_markers: bool,
    /// The first G43 with H.
    first_g43_h: Option<usize>,
}

impl TextStyle {
    /// Records the style of the line that begins at a byte offset.
    pub fn record_line(&mut self, text: &[u8], line: &SampleLine, offset: usize) {
        self.has_program_markers |= text.trim_ascii_start().first() == Some(&b'%');
        self.exceeds_small_control |= line.macros;
        let has = |letter: u8| line.letters & bit(letter) != 0;
        self.has_program_markers |= has(b'O');
        self.exceeds_small_control |= has(b'O') || has(b'H') || has(b'D') || has(b'L');
        for word in &line.words {
            match word.letter {
                b'G' => self.record_code(word, has(b'H'), offset),
                // M97 to M99: subprogram calls and returns.
                b'M' => self.exceeds_small_control |= matches!(word.value as i64, 97..=99),
                letter => {
                    if let Some(axis) = AXES.iter().position(|axis| *axis == letter) {
                        self.record_number(word, axis, offset);
                    }
                }
            }
        }
    }

    fn record_code(&mut self, word: &SampleWord, has_h: bool, offset: usize) {
        if word.value == 1.0 {
            self.first_feed.get_or_insert(offset);
        }
        let value = word.value;
        let is_cycle =
            (81.0..=89.0).contains(&value) || value == 73.0 || value == 74.0 || value == 76.0;
        // G41 to G43: compensations; G65: macro call.
        self.exceeds_small_control |= is_cycle || matches!(value, 41.0..=43.0) || value == 65.0;
        if value == 43.0 && has_h {
            self.first_g43_h.get_or_insert(offset);
        }
    }

    fn record_number(&mut self, word: &SampleWord, axis: usize, offset: usize) {
        if word.value == 0.0 || word.value.is_nan() {
            return;
        }
        match word.decimals {
            None if word.value.abs() < THOUSANDTHS_FROM => {
                self.whole[axis].get_or_insert(offset);
            }
            None => self.has_thousandths = true,
            Some(0) => {
                self.trailing_points += 1;
                self.first_trailing_point.get_or_insert(offset);
            }
            Some(_) => {
                self.decimal[axis].get_or_insert(offset);
            }
        }
    }

    /// The offset of the line with a whole number of an axis that has decimals elsewhere; `None` without one.
    pub fn mixed_numbers(&self) -> Option<usize> {
        if self.trailing_points >= MIN_TRAILING_POINTS {
            return None;
        }
        let pairs = self.whole.iter().zip(&self.decimal);
        pairs.filter_map(|(whole, decimal)| whole.filter(|_| decimal.is_some())).min()
    }

    /// True when axes have whole numbers without a point, and nothing shows that they count least increments: a text
    /// that writes the point of whole numbers, or has numbers of a thousand and more, is for a control that does.
    pub fn leaves_whole_numbers_open(&self) -> bool {
        let has_whole = self.whole.iter().any(Option::is_some);
        has_whole && !self.has_thousandths && self.trailing_points < MIN_TRAILING_POINTS
    }

    /// The offset of the line with the first of several words like `X5.`; `None` when there are too few.
    pub fn trailing_points(&self) -> Option<usize> {
        self.first_trailing_point.filter(|_| self.trailing_points >= MIN_TRAILING_POINTS)
    }

    /// The offset of the line with the first G1 of a text that small controls can read; `None` for other texts.
    pub fn small_control_evidence(&self) -> Option<usize> {
        self.first_feed.filter(|_| !self.exceeds_small_control)
    }

    /// The offset of the line with the first G43 H of a text with neither `%` nor an O number; `None` for other texts.
    pub fn length_without_tape(&self) -> Option<usize> {
        self.first_g43_h.filter(|_| !self.has_program_markers)
    }
}
