//! Comments and block numbers of the old text, whatever its language.

use std::collections::{BTreeMap, BTreeSet};

use chordal::Job;
use chordal::control::TokenClass;
use chordal::diagnostics::{FileId, TextRange};

/// What stands on the lines of the first text in addition to what is carried out.
#[derive(Debug, Default)]
pub(super) struct SourceRemarks {
    /// The comments of each line.
    comments: BTreeMap<u32, String>,
    /// Lines with words.
    with_words: BTreeSet<u32>,
    /// The block numbers.
    numbers: BTreeMap<u32, u32>,
    /// The first line with a block that block delete may leave out.
    pub deletable: Option<u32>,
    /// The lines of the main program.
    main: std::ops::Range<u32>,
}

impl SourceRemarks {
    /// Of the program with this index among those of the job.
    pub fn of(job: &Job, program: usize) -> SourceRemarks {
        let mut remarks = SourceRemarks::default();
        let Some(source) = job.sources().get(FileId(0)) else { return remarks };
        let text = source.text();
        let programs = job.program_set();
        let range = programs
            .programs()
            .get(program)
            .map_or(TextRange::new(0, text.len() as u32), |place| place.range);
        remarks.main = source.line_of(range.start)..source.line_of(range.end.saturating_sub(1)) + 1;
        for token in programs.tokens(TextRange::new(0, text.len() as u32)) {
            let line = source.line_of(token.range.start);
            let words = String::from_utf8_lossy(token.range.slice(text)).trim().to_string();
            match token.class {
                TokenClass::Comment => {
                    let inner = bare(&words);
                    if !inner.is_empty() {
                        let own = remarks.comments.entry(line).or_default();
                        if !own.is_empty() {
                            own.push(' ');
                        }
                        own.push_str(inner);
                    }
                }
                TokenClass::Mark if words.starts_with('/') => {
                    remarks.deletable.get_or_insert(line);
                }
                TokenClass::Mark | TokenClass::Program => {}
                TokenClass::Label => {
                    remarks.with_words.insert(line);
                    let number =
                        words.strip_prefix(['N', 'n']).and_then(|digits| digits.parse().ok());
                    if let Some(number) = number {
                        remarks.numbers.entry(line).or_insert(number);
                    }
                }
                _ => {
                    remarks.with_words.insert(line);
                }
            }
        }
        remarks
    }

    /// The number of the block on a line.
    pub fn number(&self, line: u32) -> Option<u32> {
        self.numbers.get(&line).copied()
    }

    /// The comment of a line with words.
    pub fn at_line_end(&self, line: u32) -> Option<&str> {
        let comment = self.comments.get(&line)?;
        self.with_words.contains(&line).then_some(comment)
    }

    /// The comments that stand after a line and before another one, on lines of their own: those of lines that are not
    /// carried out are left out.
    pub fn between(&self, after: u32, before: u32, carried_out: &BTreeSet<u32>) -> Vec<&str> {
        let lines = (after + 1).max(self.main.start)..before.min(self.main.end);
        if lines.is_empty() {
            return Vec::new();
        }
        let belongs_here = |line: u32| {
            if self.with_words.contains(&line) {
                return carried_out.contains(&line);
            }
            // A comment belongs to the words after it.
            let next = self.with_words.range(line..).next();
            next.is_none_or(|next| *next >= before || carried_out.contains(next))
        };
        self.comments
            .range(lines)
            .filter(|(line, _)| belongs_here(**line))
            .map(|(_, comment)| comment.as_str())
            .collect()
    }
}

/// A comment without its marks.
fn bare(comment: &str) -> &str {
    let inner = match comment.strip_prefix('(') {
        Some(inner) => inner.strip_suffix(')').unwrap_or(inner),
        None => comment.trim_start_matches([';', '*', '\'']),
    };
    inner.trim_end_matches('*').trim()
}
