//! Loads programs as the command does, for other shells: the machine that a folder's
//! `chordal.toml` says or the text speaks for, subprograms in the folder of the file, tool tables.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chordal::Machine;
use chordal::control::{Interrupt, ShopCodes};
use chordal::machine::ControlName;

use crate::beside::Folders;
use crate::input::{Input, Text};
use crate::machine;
use crate::options::Common;
use crate::session;

pub use crate::archive::Disk;
pub use crate::failure::Failure;
pub use crate::machine::Chosen;
pub use crate::session::Loaded;

/// What a program is to run on, and what is otherwise than its machine says. Nothing said: the
/// folder's `chordal.toml` says the machine, or the text does.
#[derive(Clone, Default)]
pub struct Request {
    /// The machine.
    pub machine: Option<Machine>,
    /// The control whose typical machine to take, where no machine is given.
    pub control: Option<ControlName>,
    /// Assignments to keys of the machine, as `tools.5.diameter="0.5 in"`.
    pub set: Vec<String>,
    /// A LinuxCNC tool table, in the machine's units at power-on.
    pub tools: Option<PathBuf>,
    /// Runs only this program of the file.
    pub program: Option<u32>,
    /// Leaves out the blocks that start with `/`.
    pub block_delete: bool,
    /// Most blocks carried out in calls, repeats and jumps.
    pub max_blocks: Option<u64>,
    /// Who knows the codes of the shop's own. It is asked once about each, while the program is
    /// loaded.
    pub shop_codes: Option<Arc<dyn ShopCodes>>,
    /// Ends that asking early.
    pub interrupt: Option<Interrupt>,
}

impl Request {
    /// What a command line says, but for the machine.
    pub(crate) fn of(common: Common) -> Request {
        let Common { machine: _, set, tools, program, block_delete, max_blocks } = common;
        Request { set, tools, program, block_delete, max_blocks, ..Request::default() }
    }

    pub(crate) fn common(&self) -> Common {
        Common {
            machine: None,
            set: self.set.clone(),
            tools: self.tools.clone(),
            program: self.program,
            block_delete: self.block_delete,
            max_blocks: self.max_blocks,
        }
    }

    /// The machine, where one is said.
    pub(crate) fn given(&self, common: &Common) -> Result<Option<Machine>, Failure> {
        let typical = || self.control.map(machine::builtin_of);
        let machine = self.machine.clone().or_else(typical);
        machine.map(|machine| machine::finish(machine, common)).transpose()
    }
}

/// Loads a file.
///
/// # Errors
/// A file that cannot be read, a machine that cannot be used, a program that is not there.
pub fn file(path: &Path, request: &Request) -> Result<Loaded, Failure> {
    let input = Input { path: Some(path.to_path_buf()), root: None };
    load(Text::read(&input)?, &input, request)
}

/// Loads a text, under a name that messages show.
///
/// # Errors
/// A machine that cannot be used, a program that is not there.
pub fn text(name: &str, bytes: Vec<u8>, request: &Request) -> Result<Loaded, Failure> {
    load(Text::of(name, bytes)?, &Input { path: None, root: None }, request)
}

/// Loads the text of an editor, which lies or will lie at a path.
///
/// # Errors
/// A machine that cannot be used, a program that is not there.
pub fn unsaved(path: Option<&Path>, bytes: Vec<u8>, request: &Request) -> Result<Loaded, Failure> {
    let input = Input { path: path.map(Path::to_path_buf), root: None };
    load(Text::of(&input.name(), bytes)?, &input, request)
}

/// A machine by its built-in name, or of a file.
///
/// # Errors
/// A name that nothing has; the help lists the built-in ones.
pub fn machine(name: &str) -> Result<Machine, Failure> {
    machine::named(name)
}

/// A machine of a file.
///
/// # Errors
/// A file that cannot be read, and everything that is wrong in it.
pub fn machine_file(path: &Path) -> Result<Machine, Failure> {
    machine::from_file(path)
}

/// A machine of a TOML text, under a name that messages show.
///
/// # Errors
/// Everything that is wrong in it.
pub fn machine_text(name: &str, text: &str) -> Result<Machine, Failure> {
    machine::of_text(name, text)
}

fn load(text: Text, input: &Input, request: &Request) -> Result<Loaded, Failure> {
    let common = request.common();
    let given = request.given(&common)?;
    let mut loaded =
        session::load_text(text, input, given.as_ref(), &common, &mut Folders::default())?;
    if let Some(shop) = &request.shop_codes {
        loaded.ask_shop(shop.clone(), request.interrupt.clone())?;
    }
    Ok(loaded)
}
