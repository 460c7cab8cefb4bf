//! The block that a command comes from, and the chain of calls that led to it.

use chordal_diagnostics::{Span, TextShift};

/// The index of a chain of calls in [`CallPaths`]; 0 is the main program, without calls.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash, PartialOrd, Ord)]
pub struct CallPath(pub u32);

/// The block that a command comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Origin {
    /// The bytes of the whole block.
    pub span: Span,
    /// Its line in the file, from 1.
    pub line: u32,
    /// The chain of calls that led to it.
    pub call: CallPath,
    /// Whether a canned cycle of the block made the command.
    pub cycle: bool,
}

impl Origin {
    /// The same block in an edited text; `None` if the edit has removed it.
    pub fn shifted(&self, shift: &TextShift) -> Option<Origin> {
        let mut moved = Origin { span: shift.span(self.span)?, ..*self };
        if moved.span != self.span {
            moved.line = shift.place(self.span.range.start, self.line)?.1;
        }
        Some(moved)
    }
}

/// The chains of calls of a run, each stored once.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CallPaths {
    paths: Vec<(CallPath, Span)>,
}

impl CallPaths {
    /// The chain of `parent` and a call in `block`, stored if it is new.
    pub fn enter(&mut self, parent: CallPath, block: Span) -> CallPath {
        // From the end, since a call in a loop finds its own entry there at once.
        let known = self.paths.iter().rposition(|entry| *entry == (parent, block));
        let index = known.unwrap_or_else(|| {
            self.paths.push((parent, block));
            self.paths.len() - 1
        });
        CallPath(index as u32 + 1)
    }

    /// The number of chains, that of the main program included.
    pub fn count(&self) -> usize {
        self.paths.len()
    }

    /// Makes them the chains of an edited text; `None` if the edit has removed a call.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        for (_, block) in &mut self.paths {
            *block = shift.span(*block)?;
        }
        Some(())
    }

    /// The calling blocks of a chain, innermost first.
    pub fn resolve(&self, mut path: CallPath) -> Vec<Span> {
        let mut blocks = Vec::new();
        while let Some((parent, block)) =
            path.0.checked_sub(1).and_then(|index| self.paths.get(index as usize))
        {
            blocks.push(*block);
            path = *parent;
        }
        blocks
    }
}
