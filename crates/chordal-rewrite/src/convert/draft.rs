//! A block while it is written anew: words replaced where they stand, spaces kept.

use chordal::diagnostics::TextRange;
use chordal::syntax::Block;

use crate::Change;

/// Why a block cannot be kept: its moves are written out instead.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct NeedsExpansion(pub String);

/// A block and what becomes of it.
#[derive(Clone, Debug)]
pub(crate) struct BlockDraft<'a> {
    text: &'a [u8],
    pub block: &'a Block,
    words: Vec<Option<String>>,
    comments: Vec<Option<String>>,
    /// Words after N and before the others.
    pub front: Vec<String>,
    /// Words after the last one.
    pub back: Vec<String>,
    /// Lines of their own.
    pub before: Vec<String>,
    pub after: Vec<String>,
    /// Comments that go to the end of the line.
    pub trailing: Vec<String>,
    /// Other lines in the place of the block.
    pub instead: Option<Vec<String>>,
    /// How often the line is written.
    pub times: u32,
    pub changes: Vec<Change>,
    spaced: bool,
}

impl<'a> BlockDraft<'a> {
    pub fn new(text: &'a [u8], block: &'a Block, spaced: bool) -> BlockDraft<'a> {
        BlockDraft {
            text,
            block,
            words: vec![None; block.words.len()],
            comments: vec![None; block.comments.len()],
            front: Vec::new(),
            back: Vec::new(),
            before: Vec::new(),
            after: Vec::new(),
            trailing: Vec::new(),
            instead: None,
            times: 1,
            changes: Vec::new(),
            spaced,
        }
    }

    /// The first word of a letter.
    pub fn place(&self, letter: u8) -> Option<usize> {
        self.block.words.iter().position(|word| word.letter == letter)
    }

    /// The word as it was written.
    pub fn written(&self, word: usize) -> String {
        self.slice(self.block.words[word].range)
    }

    pub fn slice(&self, range: TextRange) -> String {
        String::from_utf8_lossy(range.slice(self.text)).into_owned()
    }

    /// The word as it is now.
    pub fn now(&self, word: usize) -> String {
        self.words[word].clone().unwrap_or_else(|| self.written(word))
    }

    pub fn is_changed(&self, word: usize) -> bool {
        self.words[word].is_some()
    }

    pub fn is_gone(&self, word: usize) -> bool {
        self.words[word].as_ref().is_some_and(String::is_empty)
    }

    /// Puts another word in the place of one.
    pub fn replace(&mut self, word: usize, new: impl Into<String>, reason: impl Into<String>) {
        let new = new.into();
        let before = self.written(word);
        if new == before {
            return;
        }
        self.words[word] = Some(new.clone());
        self.note(before, new, reason);
    }

    /// The same without a word about it, as part of another change.
    pub fn set(&mut self, word: usize, new: impl Into<String>) {
        self.words[word] = Some(new.into());
    }

    pub fn remove(&mut self, word: usize, reason: impl Into<String>) {
        self.replace(word, "", reason);
    }

    pub fn set_comment(&mut self, comment: usize, new: impl Into<String>) {
        self.comments[comment] = Some(new.into());
    }

    /// Puts a word in front of the others.
    pub fn lead(&mut self, word: impl Into<String>, reason: impl Into<String>) {
        let word = word.into();
        self.note(String::new(), word.clone(), reason);
        self.front.push(word);
    }

    /// Puts a word after the others.
    pub fn append(&mut self, word: impl Into<String>, reason: impl Into<String>) {
        let word = word.into();
        self.note(String::new(), word.clone(), reason);
        self.back.push(word);
    }

    pub fn note(&mut self, before: String, after: String, reason: impl Into<String>) {
        let change = Change { line: self.block.line, before, after, reason: reason.into() };
        self.changes.push(change);
    }

    /// The lines as they are now; none where nothing is left.
    pub fn lines(&self) -> Vec<String> {
        if let Some(lines) = &self.instead {
            return lines.clone();
        }
        let mut lines = self.before.clone();
        let mut line = self.line();
        if !self.slice(self.block.range).starts_with([' ', '\t']) {
            line = line.trim_start().to_string();
        }
        if !line.trim().is_empty() {
            lines.extend(std::iter::repeat_n(line, self.times as usize));
        }
        lines.extend(self.after.iter().cloned());
        lines
    }

    fn line(&self) -> String {
        let mut tokens: Vec<(TextRange, Option<String>, bool)> = Vec::new();
        let words = self.block.words.iter().zip(&self.words);
        tokens.extend(words.map(|(word, new)| (word.range, new.clone(), true)));
        let comments = self.block.comments.iter().zip(&self.comments);
        tokens.extend(comments.map(|(range, new)| (*range, new.clone(), false)));
        tokens.sort_by_key(|token| token.0.start);
        // N stays first; a program's head too.
        let first = self.block.words.iter().find(|word| !matches!(word.letter, b'N' | b'O'));
        let last_word = self.block.words.last().map(|word| word.range.end);
        let mut out = String::new();
        let mut at = self.block.range.start;
        let mut led = self.front.is_empty();
        for (range, new, is_word) in tokens {
            let gap = self.slice(TextRange::new(at, range.start));
            at = range.end;
            if new.as_ref().is_some_and(String::is_empty) {
                if !out.is_empty() && !out.ends_with(' ') && !gap.is_empty() {
                    out.push_str(&gap);
                }
            } else {
                let joined = if out.ends_with(' ') { gap.trim_start_matches(' ') } else { &gap };
                out.push_str(joined);
                if !led && is_word && first.is_some_and(|word| word.range == range) {
                    self.push_all(&mut out, &self.front);
                    led = true;
                    if self.spaced && !out.ends_with(' ') {
                        out.push(' ');
                    }
                }
                out.push_str(&new.unwrap_or_else(|| self.slice(range)));
            }
            if !led && is_word && first.is_some_and(|word| word.range == range) {
                self.push_all(&mut out, &self.front);
                led = true;
            }
            if is_word && Some(range.end) == last_word {
                self.push_all(&mut out, &self.back);
            }
        }
        out.push_str(self.slice(TextRange::new(at, self.block.range.end)).trim_end());
        if !led {
            self.push_all(&mut out, &self.front);
        }
        if last_word.is_none() {
            self.push_all(&mut out, &self.back);
        }
        for comment in &self.trailing {
            if !out.is_empty() && !out.ends_with(' ') {
                out.push(' ');
            }
            out.push_str(comment);
        }
        out.trim_end().to_string()
    }

    fn push_all(&self, out: &mut String, words: &[String]) {
        for word in words {
            if self.spaced && !out.is_empty() && !out.ends_with([' ', '/']) {
                out.push(' ');
            }
            out.push_str(word);
        }
    }
}
