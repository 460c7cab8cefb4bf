//! `chordal view`: the page that shows a program and its path.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;

use chordal::Machine;
use chordal::machine::builtin_names;
use chordal_editor::{Program, Setup};
use chordal_server::{MachineChoice, Programs, Refusal, ServeError, Server};

use crate::beside::Folders;
use crate::failure::{Failure, Verdict};
use crate::input::{Input, Text};
use crate::machine::{self, Chosen};
use crate::options::Common;
use crate::session::{load_one, load_text};
use crate::terminal::{Terminal, say};

const EXAMPLES: &str = "\
Examples:
  chordal view part.nc
  chordal view part.nc --machine haas-vf2
  chordal view part.nc --no-browser --port 8137

Serves a page on this machine alone, under an address that nobody can guess, until Ctrl-C. What is
typed is run as you type; the file is written only when you save.";

/// Shows a program and its path in the browser, live
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Only prints the address
    #[arg(long)]
    no_browser: bool,

    /// The port on 127.0.0.1; without it, one that is free
    #[arg(long, default_value_t = 0, hide_default_value = true)]
    port: u16,

    #[command(flatten)]
    common: Common,
}

pub fn run(args: Args, terminal: Terminal) -> Result<Verdict, Failure> {
    let Args { file, no_browser, port, common } = args;
    let program = Shown::new(&file, common)?;
    let server = Server::listen(port).map_err(failed)?;
    let url = server.url();
    say(&format!("{url}\n"))?;
    if !no_browser && let Err(reason) = open_browser(&url) {
        terminal.tell(&format!("cannot open a browser ({reason}): open the address above\n"));
    }
    server.serve(Arc::new(program)).map_err(failed)?;
    Ok(Verdict::Clean)
}

fn failed(error: ServeError) -> Failure {
    let help = matches!(error, ServeError::Listen { .. })
        .then(|| "leave --port out to take one that is free".to_string());
    Failure::Use { message: error.to_string(), help }
}

/// The program of the command line, with what the command line says of it.
struct Shown {
    input: Input,
    /// What standard input held; a file is read anew each time.
    held: Option<Vec<u8>>,
    given: Option<Machine>,
    common: Common,
}

impl Shown {
    /// Reads the program once, so that what is wrong is told before a browser opens.
    fn new(file: &Path, common: Common) -> Result<Shown, Failure> {
        let given = machine::given(&common)?;
        if file.as_os_str() == "-" {
            let input = Input { path: None, root: None };
            let held = Some(Text::read(&input)?.bytes().to_vec());
            return Ok(Shown { input, held, given, common });
        }
        if file.is_dir() {
            return Err(load_one(&file.to_path_buf(), &common).err().unwrap_or_else(|| {
                Failure::wrong(format!("{} is a folder", file.display()), "name one program")
            }));
        }
        let input = Input { path: Some(file.to_path_buf()), root: None };
        std::fs::File::open(file).map_err(|error| Failure::read(file.to_string_lossy(), &error))?;
        Ok(Shown { input, held: None, given, common })
    }

    fn load(&self, text: Vec<u8>, machine: Option<&str>) -> Result<Program, Failure> {
        let chosen = match machine {
            Some(name) => Some(machine::finish(machine::named(name)?, &self.common)?),
            None => self.given.clone(),
        };
        let text = Text::of(&self.input.name(), text)?;
        let mut folders = Folders::default();
        let loaded = load_text(text, &self.input, chosen.as_ref(), &self.common, &mut folders)?;
        let title = loaded.machine().title.clone();
        let why = match &loaded.chosen {
            Chosen::Folder(path) => Some(format!("{} says so", path.display())),
            chosen => chosen.why(&title),
        };
        let program = loaded.program;
        let (mut texts, machine, options) = loaded.into_parts();
        // The first is the text itself.
        let beside = texts.split_off(1);
        let (name, text) = texts.pop().unwrap_or_default();
        let setup = Setup { machine, why, options, program, beside };
        Program::set_up(name, text, setup).map_err(|errors| {
            Failure::wrong("settings of the machine are not known", format!("{errors:?}"))
        })
    }
}

impl Programs for Shown {
    fn path(&self) -> Option<PathBuf> {
        self.input.path.clone()
    }

    fn name(&self) -> String {
        self.input.name().into_owned()
    }

    fn read(&self) -> Result<Vec<u8>, Refusal> {
        match (&self.held, &self.input.path) {
            (Some(held), _) => Ok(held.clone()),
            (None, Some(path)) => std::fs::read(path)
                .map_err(|error| refusal(&Failure::read(path.to_string_lossy(), &error))),
            (None, None) => Ok(Vec::new()),
        }
    }

    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<Program, Refusal> {
        self.load(text, machine).map_err(|failure| refusal(&failure))
    }

    fn machines(&self) -> Vec<MachineChoice> {
        let mut choices = Vec::new();
        for name in builtin_names() {
            let title = Machine::from_builtin(name).map_or_else(|_| (*name).into(), |it| it.title);
            choices.push(MachineChoice { name: (*name).into(), title });
        }
        choices
    }
}

/// A failure as the page shows it.
fn refusal(failure: &Failure) -> Refusal {
    match failure {
        Failure::Machine(errors) => {
            let told: Vec<String> = errors
                .iter()
                .map(|error| chordal_export::machine_error_text(error, false))
                .collect();
            Refusal { message: told.concat().trim_end().to_string(), help: None }
        }
        Failure::Use { message, help } => Refusal { message: message.clone(), help: help.clone() },
        other => Refusal { message: other.to_string(), help: None },
    }
}

/// Asks the system to show an address.
fn open_browser(url: &str) -> Result<(), String> {
    let mut command = if cfg!(target_os = "windows") {
        let mut command = Command::new("rundll32");
        command.arg("url.dll,FileProtocolHandler");
        command
    } else {
        Command::new(if cfg!(target_os = "macos") { "open" } else { "xdg-open" })
    };
    command.arg(url).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().map(drop).map_err(|error| error.to_string())
}
