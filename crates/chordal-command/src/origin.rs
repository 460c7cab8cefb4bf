//! Which block a command comes from, and the calls it was reached through.

use chordal_diagnostics::{Span, TextShift};

/// Which chain of calls a block was reached through; 0 is the main program.
/// [`CallPaths`] resolves it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash, PartialOrd, Ord)]
pub struct CallPath(pub u32);

/// The block that a command comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Origin {
    /// The whole block.
    pub span: Span,
    /// Its line in the file, from 1.
    pub line: u32,
    /// The calls it was reached through.
    pub call: CallPath,
    /// Made by a canned cycle that the block set off.
    pub cycle: bool,
}

impl Origin {
    /// The same in a text that has changed elsewhere; `None` where the block went.
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
    /// The path that `block`, itself reached through `parent`, leads to by its call.
    pub fn enter(&mut self, parent: CallPath, block: Span) -> CallPath {
        // The newest entries are the likely ones: a loop of calls finds its own at once.
        let known = self.paths.iter().rposition(|entry| *entry == (parent, block));
        let index = known.unwrap_or_else(|| {
            self.paths.push((parent, block));
            self.paths.len() - 1
        });
        CallPath(index as u32 + 1)
    }

    /// How many chains there are.
    pub fn count(&self) -> usize {
        self.paths.len()
    }

    /// Makes them the chains of a text that has changed elsewhere; `None` where a call went.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        for (_, block) in &mut self.paths {
            *block = shift.span(*block)?;
        }
        Some(())
    }

    /// The calling blocks, innermost first.
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
