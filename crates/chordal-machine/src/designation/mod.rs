//! Designations of turning tools, as in catalogues: inserts (ISO 1832, ANSI B212.4), holders with a square shank (ISO
//! 5608) and boring bars (ISO 6261).

mod edge;
mod holder;
mod insert;
mod letters;

use std::ops::Range;

use crate::error::ValueLocation;

pub use self::holder::{HolderDesignation, HolderKind, ToolHand};
pub use self::insert::InsertDesignation;
pub use self::letters::{InsertLetter, clearance_degrees};

/// A designation in a file.
#[derive(Clone, Debug)]
pub struct WrittenDesignation<T> {
    /// Its text.
    pub text: String,
    /// The data in it.
    pub value: T,
    /// Its position in the file.
    pub location: Option<ValueLocation>,
}

impl<T: PartialEq> PartialEq for WrittenDesignation<T> {
    /// The position does not matter for equality.
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text && self.value == other.value
    }
}

/// Why a text is not a designation.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct DesignationError {
    /// The problem, for users.
    pub message: String,
    /// The bytes of the text that are wrong.
    pub part: Range<usize>,
    /// What to write.
    pub help: String,
}

impl DesignationError {
    fn new(message: String, part: Range<usize>, help: impl Into<String>) -> DesignationError {
        DesignationError { message, part, help: help.into() }
    }
}

/// Reads a designation from left to right, in upper case, and skips spaces and dashes between its parts.
#[derive(Clone)]
struct DesignationReader<'t> {
    text: &'t str,
    at: usize,
}

impl<'t> DesignationReader<'t> {
    fn new(text: &'t str) -> DesignationReader<'t> {
        DesignationReader { text, at: 0 }
    }

    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn skip_gaps(&mut self) {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start_matches([' ', '-']).len();
    }

    /// Consumes the next character if it is a letter, in upper case.
    fn letter(&mut self) -> Option<char> {
        let letter = self.rest().chars().next()?;
        if !letter.is_ascii_alphabetic() {
            return None;
        }
        self.at += 1;
        Some(letter.to_ascii_uppercase())
    }

    /// Consumes the next characters for which `passes` is true.
    fn run(&mut self, passes: impl Fn(char) -> bool) -> &'t str {
        let rest = self.rest();
        let length = rest.find(|c: char| !passes(c)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    /// Consumes this number of ASCII characters; `None` if there are fewer.
    fn take(&mut self, count: usize) -> Option<&'t str> {
        let taken = self.rest().get(..count).filter(|taken| taken.is_ascii())?;
        self.at += count;
        Some(taken)
    }

    /// An error for the last `count` bytes that were read.
    fn wrong(&self, count: usize, message: String, help: impl Into<String>) -> DesignationError {
        // What was read may have other characters than ASCII before it.
        let start = (0..=self.at.saturating_sub(count)).rev();
        let start = start.into_iter().find(|at| self.text.is_char_boundary(*at)).unwrap_or(0);
        DesignationError::new(message, start..self.at, help)
    }
}

#[cfg(test)]
mod tests;
