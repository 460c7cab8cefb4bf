//! The writing style of a whole text: its numbers, and features it does not use.

use super::line::{SampleLine, SampleWord, bit};

/// The axes whose numbers show how a postprocessor writes them.
const AXES: &[u8] = b"XYZ";

/// With this many words like `X5.`, they are a habit.
const TRAILING_POINTS_NEEDED: u32 = 3;

/// Whole numbers from here on are probably meant as thousandths.
const THOUSANDTHS_FROM: f64 = 1000.0;

/// The style found in a text; offsets are of the first occurrence.
#[derive(Debug, Default)]
pub struct TextStyle {
    /// By axis: a whole number without a point.
    whole: [Option<usize>; 3],
    decimal: [Option<usize>; 3],
    trailing_points: u32,
    first_trailing_point: Option<usize>,
    /// The text contains something that simple controls do not read.
    needs_more: bool,
    first_feed: Option<usize>,
    has_tape: bool,
    first_length: Option<usize>,
}

impl TextStyle {
    /// Adds a line at an offset.
    pub fn line(&mut self, text: &[u8], line: &SampleLine, at: usize) {
        self.has_tape |= text.trim_ascii_start().first() == Some(&b'%');
        self.needs_more |= line.macros;
        let has = |letter: u8| line.letters & bit(letter) != 0;
        self.has_tape |= has(b'O');
        self.needs_more |= has(b'O') || has(b'H') || has(b'D') || has(b'L');
        for word in &line.words {
            match word.letter {
                b'G' => self.code(word, has(b'H'), at),
                b'M' => self.needs_more |= matches!(word.value as i64, 97..=99),
                letter => {
                    if let Some(axis) = AXES.iter().position(|axis| *axis == letter) {
                        self.number(word, axis, at);
                    }
                }
            }
        }
    }

    fn code(&mut self, word: &SampleWord, has_h: bool, at: usize) {
        if word.value == 1.0 {
            self.first_feed.get_or_insert(at);
        }
        let value = word.value;
        let cycle =
            (81.0..=89.0).contains(&value) || value == 73.0 || value == 74.0 || value == 76.0;
        self.needs_more |= cycle || matches!(value, 41.0..=43.0) || value == 65.0;
        if value == 43.0 && has_h {
            self.first_length.get_or_insert(at);
        }
    }

    fn number(&mut self, word: &SampleWord, axis: usize, at: usize) {
        if word.value == 0.0 || word.value.is_nan() {
            return;
        }
        match word.decimals {
            None if word.value.abs() < THOUSANDTHS_FROM => {
                self.whole[axis].get_or_insert(at);
            }
            None => {}
            Some(0) => {
                self.trailing_points += 1;
                self.first_trailing_point.get_or_insert(at);
            }
            Some(_) => {
                self.decimal[axis].get_or_insert(at);
            }
        }
    }

    /// The offset of a whole number of an axis that has decimals elsewhere; `None` without one.
    pub fn mixed_numbers(&self) -> Option<usize> {
        if self.trailing_points >= TRAILING_POINTS_NEEDED {
            return None;
        }
        let both = self.whole.iter().zip(&self.decimal);
        both.filter_map(|(whole, decimal)| whole.filter(|_| decimal.is_some())).min()
    }

    /// The offset of the first of several words like `X5.`; `None` when there are too few.
    pub fn trailing_points(&self) -> Option<usize> {
        self.first_trailing_point.filter(|_| self.trailing_points >= TRAILING_POINTS_NEEDED)
    }

    /// The offset of the first feed move in a text that simple controls can read; `None` for other texts.
    pub fn small_control(&self) -> Option<usize> {
        self.first_feed.filter(|_| !self.needs_more)
    }

    /// The offset of the first G43 in a text without `%` and O number; `None` otherwise.
    pub fn length_without_tape(&self) -> Option<usize> {
        self.first_length.filter(|_| !self.has_tape)
    }
}
