//! How a text is written as a whole: its numbers, and what it does without.

use super::line::{SampleLine, SampleWord, bit};

/// The letters of axes whose numbers show how a post writes them.
const AXES: &[u8] = b"XYZ";

/// So many words like `X5.` are a habit.
const TRAILING_POINTS_NEEDED: u32 = 3;

/// Whole numbers from here on are read as thousandths by whoever writes them.
const THOUSANDTHS_FROM: f64 = 1000.0;

/// What was seen of the writing of a text.
#[derive(Debug, Default)]
pub struct TextStyle {
    /// By axis: where a whole number without a point stands first, and where one with digits after it.
    whole: [Option<usize>; 3],
    decimal: [Option<usize>; 3],
    trailing_points: u32,
    first_trailing_point: Option<usize>,
    /// Something that small controls do not read.
    needs_more: bool,
    first_feed: Option<usize>,
    has_tape: bool,
    first_length: Option<usize>,
}

impl TextStyle {
    /// Takes a line.
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

    /// Where a whole number stands on an axis that has decimals elsewhere.
    pub fn mixed_numbers(&self) -> Option<usize> {
        if self.trailing_points >= TRAILING_POINTS_NEEDED {
            return None;
        }
        let both = self.whole.iter().zip(&self.decimal);
        both.filter_map(|(whole, decimal)| whole.filter(|_| decimal.is_some())).min()
    }

    /// Where the first of several words like `X5.` stands.
    pub fn trailing_points(&self) -> Option<usize> {
        self.first_trailing_point.filter(|_| self.trailing_points >= TRAILING_POINTS_NEEDED)
    }

    /// The first move in feed of a text that a small control reads.
    pub fn small_control(&self) -> Option<usize> {
        self.first_feed.filter(|_| !self.needs_more)
    }

    /// The first G43 of a text that is no tape.
    pub fn length_without_tape(&self) -> Option<usize> {
        self.first_length.filter(|_| !self.has_tape)
    }
}
