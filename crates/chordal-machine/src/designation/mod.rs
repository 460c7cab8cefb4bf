//! Designations of turning tools as catalogues and boxes have them: inserts (ISO 1832, ANSI B212.4),
//! holders with a square shank (ISO 5608) and boring bars (ISO 6261).

mod edge;
mod holder;
mod insert;
mod letters;

use std::ops::Range;

use crate::error::ValueLocation;

pub use self::holder::{HolderDesignation, HolderKind, ToolHand};
pub use self::insert::InsertDesignation;
pub use self::letters::{InsertLetter, clearance_degrees};

/// A designation as written.
#[derive(Clone, Debug)]
pub struct WrittenDesignation<T> {
    /// Its text.
    pub text: String,
    /// What it says.
    pub value: T,
    /// Where it was written.
    pub location: Option<ValueLocation>,
}

impl<T: PartialEq> PartialEq for WrittenDesignation<T> {
    /// Designations that say the same are equal, wherever they were written.
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text && self.value == other.value
    }
}

/// Why a text is no designation.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct DesignationError {
    /// What is wrong.
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

/// A designation read from left to right, upper case, over spaces and dashes between its parts.
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

    /// The next character, upper case, if it is a letter.
    fn letter(&mut self) -> Option<char> {
        let letter = self.rest().chars().next()?;
        if !letter.is_ascii_alphabetic() {
            return None;
        }
        self.at += 1;
        Some(letter.to_ascii_uppercase())
    }

    /// The next characters that pass.
    fn run(&mut self, passes: impl Fn(char) -> bool) -> &'t str {
        let rest = self.rest();
        let length = rest.find(|c: char| !passes(c)).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    /// So many ASCII characters.
    fn take(&mut self, count: usize) -> Option<&'t str> {
        let taken = self.rest().get(..count).filter(|taken| taken.is_ascii())?;
        self.at += count;
        Some(taken)
    }

    /// What is wrong with the last `count` bytes that were read.
    fn wrong(&self, count: usize, message: String, help: impl Into<String>) -> DesignationError {
        DesignationError::new(message, self.at.saturating_sub(count)..self.at, help)
    }
}

#[cfg(test)]
mod tests;
