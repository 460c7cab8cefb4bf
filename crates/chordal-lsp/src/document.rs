//! An open document.

use std::sync::Arc;

use chordal::Source;
use chordal_editor::{EditorProgram, RunMoves};
use lsp_types::{Range, TextDocumentContentChangeEvent};

use crate::place::offset_of;

/// An open document with its text and its newest run.
#[derive(Debug)]
pub struct OpenDocument {
    /// The editor's version number of the text.
    pub version: i32,
    /// The text with its machine; `None` when no machine could be found.
    pub program: Option<Arc<EditorProgram>>,
    /// The current text when there is no program.
    text: Vec<u8>,
    /// The newest run and its version; `None` before the first run.
    pub ran: Option<(i32, Arc<RunMoves>)>,
    /// The version whose run ended with a panic; `None` without one.
    pub failed: Option<i32>,
}

impl OpenDocument {
    /// A document without a machine yet.
    pub fn new(version: i32, text: Vec<u8>) -> OpenDocument {
        OpenDocument { version, program: None, text, ran: None, failed: None }
    }

    /// The text.
    pub fn text(&self) -> &[u8] {
        self.program.as_ref().map_or(&self.text, |program| program.text())
    }

    /// Sets or removes the program with its machine.
    pub fn set_program(&mut self, program: Option<EditorProgram>) {
        if program.is_none() {
            self.text = self.text().to_vec();
        }
        self.program = program.map(Arc::new);
        (self.ran, self.failed) = (None, None);
    }

    /// Applies the editor's changes in order.
    pub fn change(&mut self, version: i32, changes: Vec<TextDocumentContentChangeEvent>) {
        self.version = version;
        let mut newest: Option<Source<'static>> = None;
        for change in changes {
            let text = match (&newest, &self.program) {
                (Some(source), _) => changed(source, change),
                (None, Some(program)) => changed(program.source(), change),
                (None, None) => changed(&Source::new("", self.text.as_slice()), change),
            };
            newest = Some(Source::new("", text));
        }
        let Some(newest) = newest else { return };
        let text = newest.into_text().into_owned();
        match &self.program {
            Some(program) => self.program = Some(Arc::new(program.with_text(text))),
            None => self.text = text,
        }
    }

    /// Whether a run of the current text is still outstanding.
    pub fn is_running(&self) -> bool {
        self.program.is_some() && self.current().is_none() && self.failed != Some(self.version)
    }

    /// The run of the current text; `None` when the text has changed since.
    pub fn current(&self) -> Option<&Arc<RunMoves>> {
        self.ran.as_ref().filter(|(version, _)| *version == self.version).map(|(_, ran)| ran)
    }
}

/// A text after one change.
fn changed(source: &Source<'_>, change: TextDocumentContentChangeEvent) -> Vec<u8> {
    let Some(Range { start, end }) = change.range else { return change.text.into_bytes() };
    let from = offset_of(source, start) as usize;
    let to = (offset_of(source, end) as usize).max(from);
    let old = source.text();
    let mut text = Vec::with_capacity(old.len() + change.text.len());
    text.extend_from_slice(&old[..from]);
    text.extend_from_slice(change.text.as_bytes());
    text.extend_from_slice(&old[to..]);
    text
}
