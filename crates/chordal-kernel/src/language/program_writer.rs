//! Writers of programs: what a program does goes in, a text of the language comes out.

use std::collections::BTreeSet;

use super::posted_program::PostedProgram;

/// How a program is written.
#[derive(Clone, Debug, Default)]
pub struct WriterOptions {
    /// Steps whose cycle is written out as moves.
    pub written_out: BTreeSet<usize>,
    /// Digits after the point of lengths; `None` for those that the control keeps.
    pub digits: Option<usize>,
    /// How far from the path a curve may be that must be written as other curves, mm.
    pub tolerance_mm: f64,
}

/// A line of a written program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct WrittenLine {
    /// Its text, without a block number; several lines where the language has blocks of several lines.
    pub text: String,
    /// The step that it carries out; `None` for the frame of the program.
    pub step: Option<usize>,
}

/// What became of a step, for people.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct WriterNote {
    /// The step.
    pub step: usize,
    /// What is written for it; empty where nothing is.
    pub words: String,
    /// Why.
    pub reason: String,
}

/// A program in its new language.
#[derive(Clone, Debug, Default)]
pub struct WrittenProgram {
    /// Its lines.
    pub lines: Vec<WrittenLine>,
    /// Steps that are written in another way than step by step, and those that are left out.
    pub notes: Vec<WriterNote>,
    /// Steps that the language has no words for: the text is not the program.
    pub refusals: Vec<WriterNote>,
}

/// Writes programs in the language of a control.
pub trait ProgramWriter {
    /// Writes a program.
    fn write(&self, program: &PostedProgram, options: &WriterOptions) -> WrittenProgram;

    /// A comment of the language.
    fn comment(&self, text: &str) -> String;

    /// What stands before a block: the number of the block in the old text, or one of the language's own. `block` counts the
    /// blocks of the new text from 0.
    fn block_start(&self, old: Option<u32>, block: usize) -> String {
        let _ = block;
        old.map_or_else(String::new, |number| format!("N{number} "))
    }
}
