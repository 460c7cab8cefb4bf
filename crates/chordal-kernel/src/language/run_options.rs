//! The options of a run: its budgets, its hooks, and how unknown conditions are assumed.

use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

use chordal_diagnostics::{Diagnostic, FileId};

use super::custom_codes::ShopCodes;

/// Returns true to end a run early; called about every thousand blocks.
pub type InterruptCheck = Arc<dyn Fn() -> bool + Send + Sync>;

/// The options of a run.
#[derive(Clone)]
pub struct RunOptions {
    /// Largest number of blocks carried out in calls, repeats and backward jumps. Blocks in the order of the text are not
    /// counted, as the text limits their number.
    pub max_repeated_blocks: u64,
    /// Answers custom codes and programs; `None` without such a hook.
    pub shop_codes: Option<Arc<dyn ShopCodes>>,
    /// Ends the run early; `None` to run to the end.
    pub interrupt: Option<InterruptCheck>,
    /// The user did not choose the machine: its limits of travel, feed and speed are assumed.
    pub assumed_machine: bool,
    /// The problem to report for a text in a language that is not read; then nothing is run.
    pub not_read: Option<Arc<Diagnostic>>,
    /// Problems to report before the first block: assumptions about the program, unreadable lines of files next to it.
    pub notes: Arc<[Diagnostic]>,
    /// Another run has assumed the conditions as usual; the findings of this one are added to it.
    pub is_other_side: bool,
    /// Both positions of the block delete switch are checked, whatever the deletable blocks do.
    pub both_block_deletes: bool,
    /// The unknown conditions that are assumed to be fulfilled, by file and offset; all others are assumed not to be.
    pub fulfilled: Arc<BTreeSet<(FileId, u32)>>,
}

impl Default for RunOptions {
    fn default() -> RunOptions {
        RunOptions {
            max_repeated_blocks: 1_000_000,
            shop_codes: None,
            interrupt: None,
            assumed_machine: false,
            not_read: None,
            notes: Arc::new([]),
            is_other_side: false,
            both_block_deletes: false,
            fulfilled: Arc::default(),
        }
    }
}

impl fmt::Debug for RunOptions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RunOptions")
            .field("max_repeated_blocks", &self.max_repeated_blocks)
            .field("shop_codes", &self.shop_codes.is_some())
            .field("interrupt", &self.interrupt.is_some())
            .field("assumed_machine", &self.assumed_machine)
            .field("not_read", &self.not_read.is_some())
            .field("notes", &self.notes.len())
            .field("is_other_side", &self.is_other_side)
            .field("both_block_deletes", &self.both_block_deletes)
            .field("fulfilled", &self.fulfilled)
            .finish()
    }
}
