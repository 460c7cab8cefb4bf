//! What a program is to run on, and how.

use std::path::PathBuf;
use std::sync::Arc;

use chordal::Machine;
use chordal::control::{InterruptCheck, ShopCodes};
use chordal::machine::ControlName;

use crate::files::FileAccess;

/// The machine that a caller wants.
#[derive(Clone, Debug)]
pub enum RequestedMachine {
    /// That of a built-in name or, where there is none of it, of a file.
    Name(String),
    /// The typical machine of a control.
    Control(ControlName),
    /// One that is loaded already.
    Machine(Box<Machine>),
}

/// How the switch of block delete stands.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug)]
pub enum BlockDeleteSwitch {
    /// As the machine file has it; off, where it says nothing.
    #[default]
    AsMachine,
    /// The blocks that start with `/` are left out.
    On,
    /// The program is run as the machine file has it, and once more the other way.
    Both,
}

impl From<bool> for BlockDeleteSwitch {
    fn from(is_on: bool) -> BlockDeleteSwitch {
        if is_on { BlockDeleteSwitch::On } else { BlockDeleteSwitch::AsMachine }
    }
}

/// What a program is to run on, and what is otherwise than its machine says. Nothing said: the
/// folder's `chordal.toml` says the machine, or the text does.
#[derive(Clone, Default)]
pub struct Request {
    /// The machine.
    pub machine: Option<RequestedMachine>,
    /// Where machine files, tool tables and subprograms are.
    pub files: FileAccess,
    /// Assignments to keys of the machine, as `tools.5.diameter="0.5 in"`.
    pub set: Vec<String>,
    /// What a firmware printed for `$$` (GRBL): its settings, before the assignments.
    pub settings: Option<PathBuf>,
    /// A LinuxCNC tool table, in the machine's units at power-on.
    pub tools: Option<PathBuf>,
    /// Runs only this program of the file.
    pub program: Option<u32>,
    /// What becomes of the blocks that start with `/`.
    pub block_delete: BlockDeleteSwitch,
    /// Most blocks carried out in calls, repeats and jumps.
    pub max_blocks: Option<u64>,
    /// Who knows the codes of the shop's own. It is asked once about each, while the program is
    /// loaded.
    pub shop_codes: Option<Arc<dyn ShopCodes>>,
    /// Ends that asking early.
    pub interrupt: Option<InterruptCheck>,
}
