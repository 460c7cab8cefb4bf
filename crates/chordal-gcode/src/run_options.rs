//! How a run is done: its budgets, who is asked, and which side it takes where nobody knows.

use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

use chordal_diagnostics::{Diagnostic, FileId};

use crate::custom_codes::ShopCodes;

/// True when a run should end early. It is asked about every thousand blocks.
pub type InterruptCheck = Arc<dyn Fn() -> bool + Send + Sync>;

/// How a run is done.
#[derive(Clone)]
pub struct RunOptions {
    /// Most blocks carried out in calls, repeats and jumps. Blocks that are simply read one
    /// after the other are not counted: their number is that of the text.
    pub max_repeated_blocks: u64,
    /// Who knows the codes and programs of the shop that nothing else knows.
    pub shop_codes: Option<Arc<dyn ShopCodes>>,
    /// Ends the run early.
    pub interrupt: Option<InterruptCheck>,
    /// Nobody named the machine: its limits of travel, feed and speed are a guess.
    pub assumed_machine: bool,
    /// The text is in a language that is not read: this is said of it, and nothing is run.
    pub not_read: Option<Arc<Diagnostic>>,
    /// What else is to be reported of the program before its first block: what was assumed of it, lines of files
    /// next to it that cannot be read.
    pub notes: Arc<[Diagnostic]>,
    /// Another run has taken the usual sides: what this one finds is added to it.
    pub is_other_side: bool,
    /// Both ways of block delete are asked for, whatever the blocks do.
    pub both_block_deletes: bool,
    /// The conditions of which nobody knows whether they are fulfilled, and that are taken as fulfilled: their files
    /// and where they begin. The others are taken as not fulfilled.
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
