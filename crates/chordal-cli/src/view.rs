//! `chordal view`: the page that shows a program and its path.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;

use chordal::Machine;
use chordal::machine::builtin_names;
use chordal_compare::Options;
use chordal_editor::Program;
use chordal_load::{Files, Given, Input, LoadError, Loader, Text, reason};
use chordal_server::{
    ComparedProgram, ListedMachine, PageServer, PageServerError, ProgramRefusal, ProgramSource,
    save,
};
use chordal_view::{ChosenMachine, builtin_machines, refusal};

use crate::compare::{length_mm, sides};
use crate::failure::{Failure, Verdict};
use crate::options::Common;
use crate::programs::load_one;
use crate::terminal::{Terminal, say};

const EXAMPLES: &str = "\
Examples:
  chordal view part.nc
  chordal view part.nc --machine haas-vf2
  chordal view part.nc --setup op1.toml                 the stock is cut as the program plays
  chordal view part.nc --no-browser --port 8137
  chordal view part.nc --against returned.nc            both paths, and the differences
  chordal view fadal.nc --against haas.nc --as fadal-4020 --as haas-vf2
  chordal view part.nc --as fadal-4020 --as haas-vf2    one program on two machines

Serves a page that only this computer can open, under an address that nobody can guess, until Ctrl-C.
The program runs again while you type; the file is written only when you save.";

/// Shows a program and its path in the browser, live
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// The machine, the stock and the tools: the stock is shown as it is cut
    #[arg(long, value_name = "SETUP.toml", conflicts_with_all = ["machine", "machines"])]
    setup: Option<PathBuf>,

    /// Another program to compare it with: both paths are drawn, and the differences are listed
    #[arg(long, value_name = "FILE")]
    against: Option<PathBuf>,

    /// The machine of a program: give it once for each program, in their order; twice for one program on two machines
    #[arg(long = "as", value_name = "NAME|FILE.toml", conflicts_with = "machine")]
    machines: Vec<String>,

    /// How far apart the two paths may be, such as 0.01mm or 0.0005in; the page can change it
    #[arg(long, value_name = "LENGTH", value_parser = length_mm, default_value = "0mm")]
    tolerance: f64,

    /// Prints the address and does not open the browser
    #[arg(long)]
    no_browser: bool,

    /// The port on 127.0.0.1; without it, any free port
    #[arg(long, default_value_t = 0, hide_default_value = true)]
    port: u16,

    #[command(flatten)]
    common: Common,
}

pub fn run(args: Args, terminal: Terminal) -> Result<Verdict, Failure> {
    let Args { file, setup, against, machines, tolerance, no_browser, port, mut common } = args;
    common.set_up(setup.as_deref());
    let program = match sides(&file, against.as_ref(), &machines, &common)? {
        None => Shown::new(&file, &common)?,
        Some([_, (other, _)])
            if against.is_some() && [&file, other].iter().all(|it| is_stdin(it)) =>
        {
            return Err(Failure::wrong(
                "both programs are standard input",
                "give a file name for one of the two",
            ));
        }
        Some([(a, on_a), (b, on_b)]) => {
            let options = Options { tolerance_mm: tolerance, ..Options::default() };
            let other =
                if against.is_some() { Shown::new(b, &on_b)? } else { Shown::named(b, &on_b)? };
            let own_text = against.is_none();
            Shown::new(a, &on_a)?.against(ComparedProgram {
                programs: Arc::new(other),
                own_text,
                options,
            })
        }
    };
    serve(program, !no_browser, port, terminal)?;
    Ok(Verdict::Clean)
}

fn is_stdin(file: &Path) -> bool {
    file.as_os_str() == "-"
}

/// What a command made of a program.
pub struct Made<'a> {
    /// How, in a word before the program's name.
    pub how: &'a str,
    /// The file that it was written to; it is looked at as any.
    pub file: Option<&'a Path>,
    /// Its text, which the page shows where there is no file.
    pub text: Vec<u8>,
    /// What it runs on.
    pub machine: Machine,
    /// What counts as a difference.
    pub options: Options,
}

/// Shows a program, and next to it what was made of it, until the process ends.
pub fn beside(
    file: &Path,
    text: &[u8],
    common: &Common,
    made: Made<'_>,
    terminal: Terminal,
) -> Result<(), Failure> {
    let mut old = Shown::named(file, common)?;
    if is_stdin(file) {
        old.held = Some(text.to_vec());
    }
    let mut new = Shown::named(made.file.unwrap_or(file), common)?;
    new.loader = new.loader.on_exactly(made.machine);
    if made.file.is_none() {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        new.title = Some(format!("{} {name}", made.how));
        new.held = Some(made.text);
    }
    let against =
        ComparedProgram { programs: Arc::new(new), own_text: false, options: made.options };
    serve(old.against(against), true, 0, terminal)
}

/// Shows a program until the process ends.
fn serve(program: Shown, opens: bool, port: u16, terminal: Terminal) -> Result<(), Failure> {
    let server = PageServer::listen(port).map_err(failed)?;
    let url = server.url();
    say(&format!("{url}\n"))?;
    if opens && let Err(reason) = open_browser(&url) {
        terminal.tell(&format!("cannot open a browser ({reason}): open the address above\n"));
    }
    server.serve(Arc::new(program)).map_err(failed)
}

fn failed(error: PageServerError) -> Failure {
    let help = matches!(error, PageServerError::Listen { .. })
        .then(|| "leave --port out to use any free port".to_string());
    Failure::Use { message: error.to_string(), help }
}

/// The program of the command line, with what the command line says of it.
struct Shown {
    input: Input,
    /// What standard input held, or what has no file yet; a file is read anew each time.
    held: Option<Vec<u8>>,
    /// The name for people, where it is not that of the file.
    title: Option<String>,
    loader: Loader,
    against: Option<Arc<ComparedProgram>>,
}

impl Shown {
    /// Reads the program once, so that what is wrong is reported before a browser opens.
    fn new(file: &Path, common: &Common) -> Result<Shown, Failure> {
        if is_stdin(file) {
            let shown = Shown::named(file, common)?;
            let held = Some(Text::read(&shown.input)?.bytes().to_vec());
            return Ok(Shown { held, ..shown });
        }
        if file.is_dir() {
            return Err(load_one(&file.to_path_buf(), common).err().unwrap_or_else(|| {
                Failure::wrong(format!("{} is a folder", file.display()), "give one program")
            }));
        }
        std::fs::File::open(file).map_err(|error| Failure::read(file.to_string_lossy(), &error))?;
        Shown::named(file, common)
    }

    /// A program whose text comes from elsewhere.
    fn named(file: &Path, common: &Common) -> Result<Shown, Failure> {
        let loader = Loader::new(common.request())?;
        let path = (!is_stdin(file)).then(|| file.to_path_buf());
        let input = Input { path, root: None };
        Ok(Shown { input, held: None, title: None, loader, against: None })
    }

    fn against(self, against: ComparedProgram) -> Shown {
        Shown { against: Some(Arc::new(against)), ..self }
    }
}

impl Shown {
    /// Where the machine is named: a file of the program's own folder without the folder.
    fn named_in(&self, file: &Path) -> String {
        let folder = self.input.path.as_deref().and_then(|path| path.canonicalize().ok());
        let own = folder.as_deref().and_then(Path::parent);
        match (file.file_name(), file.parent()) {
            (Some(name), Some(parent)) if Some(parent) == own => {
                format!("named in {} of the same folder", name.to_string_lossy())
            }
            _ => format!("named in {}", file.display()),
        }
    }
}

impl ProgramSource for Shown {
    fn path(&self) -> Option<PathBuf> {
        self.input.path.clone().filter(|_| self.held.is_none())
    }

    fn name(&self) -> String {
        self.title.clone().unwrap_or_else(|| self.input.name().into_owned())
    }

    fn read(&self) -> Result<Vec<u8>, ProgramRefusal> {
        match (&self.held, &self.input.path) {
            (Some(held), _) => Ok(held.clone()),
            (None, Some(path)) => Files::Disk
                .bytes(path)
                .map_err(|error| refusal(&LoadError::read(path.to_string_lossy(), &error))),
            (None, None) => Ok(Vec::new()),
        }
    }

    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<Program, ProgramRefusal> {
        let loader = match machine.map(ChosenMachine::of) {
            // The page may choose from what it was offered, and name no file.
            Some(chosen) if !builtin_names().contains(&chosen.name) => {
                return Err(ProgramRefusal {
                    message: format!("{} is not a machine of the list", chosen.name),
                    help: Some(
                        "choose one from the list, or start `chordal view` with --machine".into(),
                    ),
                });
            }
            Some(chosen) => {
                self.loader.on(Given::Name(chosen.name.to_string()), chosen.assignments())
            }
            None => Ok(self.loader.again()),
        };
        let loader = loader.map_err(|error| refusal(&error))?;
        let set_up = machine.is_some().then(|| self.loader.again());
        let named_in = |file: &Path| self.named_in(file);
        chordal_view::open_program(loader, set_up, &self.input, &self.name(), text, named_in)
    }

    fn write(&self, bytes: &[u8]) -> Result<(), ProgramRefusal> {
        match ProgramSource::path(self) {
            Some(path) => save(&path, bytes),
            None => Err(ProgramRefusal { message: "there is no file to write".into(), help: None }),
        }
    }

    fn named_file(&self, name: &str) -> Result<Vec<u8>, String> {
        Files::Disk.bytes(Path::new(name)).map_err(|error| reason(&error))
    }

    fn compared_program(&self) -> Option<Arc<ComparedProgram>> {
        self.against.clone()
    }

    fn machines(&self) -> Vec<ListedMachine> {
        builtin_machines()
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
