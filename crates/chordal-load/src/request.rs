//! What the caller specifies about loading a program: machine, settings and files.

use std::path::PathBuf;
use std::sync::Arc;

use chordal::Machine;
use chordal::ShopCodes;
use chordal::control::InterruptCheck;
use chordal::machine::ControlName;

use crate::files::FileAccess;

/// The machine that a caller requests.
#[derive(Clone, Debug)]
pub enum RequestedMachine {
    /// A built-in machine of this name or, when there is none, a machine file.
    Name(String),
    /// The default machine of a control.
    Control(ControlName),
    /// A machine that is already loaded.
    Machine(Box<Machine>),
}

/// The position of the block delete switch.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug)]
pub enum BlockDeleteSwitch {
    /// As in the machine file; off when the file does not set it.
    #[default]
    AsMachine,
    /// The blocks that start with `/` are skipped.
    On,
    /// The program is run with the switch as in the machine file, and once more with the opposite position.
    Both,
}

impl From<bool> for BlockDeleteSwitch {
    fn from(is_on: bool) -> BlockDeleteSwitch {
        if is_on { BlockDeleteSwitch::On } else { BlockDeleteSwitch::AsMachine }
    }
}

/// The machine to run on, and changes to its settings. By default the folder's `chordal.toml` names the machine, or
/// it is recognized from the text.
#[derive(Clone, Default)]
pub struct Request {
    /// The machine; `None`: from the folder's `chordal.toml`, or recognized from the text.
    pub machine: Option<RequestedMachine>,
    /// Where machine files, tool tables and subprograms are read from.
    pub files: FileAccess,
    /// Assignments to keys of the machine, such as `tools.5.diameter="0.5 in"`.
    pub set: Vec<String>,
    /// A file with the settings that a firmware (GRBL) printed for `$$`. They are applied before the assignments.
    pub settings: Option<PathBuf>,
    /// A LinuxCNC tool table file, in the machine's units at power-on.
    pub tools: Option<PathBuf>,
    /// Runs only the program of this number in the file; `None` runs the file from its beginning.
    pub program: Option<u32>,
    /// Whether blocks that start with `/` are skipped.
    pub block_delete: BlockDeleteSwitch,
    /// The limit on blocks executed in calls, repeats and jumps; `None`: the default.
    pub max_blocks: Option<u64>,
    /// Expands the shop's own codes. It is called once for each use, while the program is loaded.
    pub shop_codes: Option<Arc<dyn ShopCodes>>,
    /// Interrupts these calls early.
    pub interrupt: Option<InterruptCheck>,
}
