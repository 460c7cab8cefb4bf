//! `chordal view`: the page that shows a program and its path.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;

use chordal::Machine;
use chordal::machine::builtin_names;
use chordal_compare::ComparisonOptions;
use chordal_editor::EditorProgram;
use chordal_load::{
    FileAccess, LoadError, Loader, ProgramInput, ProgramText, RequestedMachine, reason,
};
use chordal_server::{
    ComparedProgram, ListedMachine, PageServer, PageServerError, ProgramRefusal, ProgramSource,
    save,
};
use chordal_view::{ChosenMachine, builtin_machines, refusal};

use crate::compare::{length_mm, sides};
use crate::failure::{CommandFailure, ExitVerdict};
use crate::options::CommonArgs;
use crate::programs::load_one;
use crate::terminal::{TerminalSupport, say};

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
    common: CommonArgs,
}

pub fn run(args: Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let Args { file, setup, against, machines, tolerance, no_browser, port, mut common } = args;
    common.set_up(setup.as_deref());
    let program = match sides(&file, against.as_ref(), &machines, &common)? {
        None => ViewedProgram::new(&file, &common)?,
        Some([_, (other, _)])
            if against.is_some() && [&file, other].iter().all(|it| is_stdin(it)) =>
        {
            return Err(CommandFailure::wrong(
                "both programs are standard input",
                "give a file name for one of the two",
            ));
        }
        Some([(a, on_a), (b, on_b)]) => {
            let options =
                ComparisonOptions { tolerance_mm: tolerance, ..ComparisonOptions::default() };
            let other = if against.is_some() {
                ViewedProgram::new(b, &on_b)?
            } else {
                ViewedProgram::named(b, &on_b)?
            };
            let own_text = against.is_none();
            ViewedProgram::new(a, &on_a)?.against(ComparedProgram {
                programs: Arc::new(other),
                own_text,
                options,
            })
        }
    };
    serve(program, !no_browser, port, terminal)?;
    Ok(ExitVerdict::Clean)
}

fn is_stdin(file: &Path) -> bool {
    file.as_os_str() == "-"
}

/// What a command made of a program.
pub struct GeneratedProgram<'a> {
    /// How, in a word before the program's name.
    pub how: &'a str,
    /// The file that it was written to; it is looked at as any.
    pub file: Option<&'a Path>,
    /// Its text, which the page shows where there is no file.
    pub text: Vec<u8>,
    /// What it runs on.
    pub machine: Machine,
    /// What counts as a difference.
    pub options: ComparisonOptions,
}

/// Shows a program, and next to it what was made of it, until the process ends.
pub fn show_pair(
    file: &Path,
    text: &[u8],
    common: &CommonArgs,
    made: GeneratedProgram<'_>,
    terminal: TerminalSupport,
) -> Result<(), CommandFailure> {
    let mut old = ViewedProgram::named(file, common)?;
    if is_stdin(file) {
        old.bytes = Some(text.to_vec());
    }
    let mut new = ViewedProgram::named(made.file.unwrap_or(file), common)?;
    new.loader = new.loader.on_exactly(made.machine);
    if made.file.is_none() {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        new.title = Some(format!("{} {name}", made.how));
        new.bytes = Some(made.text);
    }
    let against =
        ComparedProgram { programs: Arc::new(new), own_text: false, options: made.options };
    serve(old.against(against), true, 0, terminal)
}

/// Shows a program until the process ends.
fn serve(
    program: ViewedProgram,
    opens: bool,
    port: u16,
    terminal: TerminalSupport,
) -> Result<(), CommandFailure> {
    let server = PageServer::listen(port).map_err(failed)?;
    let url = server.url();
    say(&format!("{url}\n"))?;
    if opens && let Err(reason) = open_browser(&url) {
        terminal
            .write_error(&format!("cannot open a browser ({reason}): open the address above\n"));
    }
    server.serve(Arc::new(program)).map_err(failed)
}

fn failed(error: PageServerError) -> CommandFailure {
    let help = matches!(error, PageServerError::Listen { .. })
        .then(|| "leave --port out to use any free port".to_string());
    CommandFailure::Use { message: error.to_string(), help }
}

/// The program of the command line, with what the command line says of it.
struct ViewedProgram {
    input: ProgramInput,
    /// What standard input held, or what has no file yet; a file is read anew each time.
    bytes: Option<Vec<u8>>,
    /// The name for people, where it is not that of the file.
    title: Option<String>,
    loader: Loader,
    against: Option<Arc<ComparedProgram>>,
}

impl ViewedProgram {
    /// Reads the program once, so that what is wrong is reported before a browser opens.
    fn new(file: &Path, common: &CommonArgs) -> Result<ViewedProgram, CommandFailure> {
        if is_stdin(file) {
            let shown = ViewedProgram::named(file, common)?;
            let retained = Some(ProgramText::read(&shown.input)?.bytes().to_vec());
            return Ok(ViewedProgram { bytes: retained, ..shown });
        }
        if file.is_dir() {
            return Err(load_one(&file.to_path_buf(), common).err().unwrap_or_else(|| {
                CommandFailure::wrong(format!("{} is a folder", file.display()), "give one program")
            }));
        }
        std::fs::File::open(file)
            .map_err(|error| CommandFailure::read(file.to_string_lossy(), &error))?;
        ViewedProgram::named(file, common)
    }

    /// A program whose text comes from elsewhere.
    fn named(file: &Path, common: &CommonArgs) -> Result<ViewedProgram, CommandFailure> {
        let loader = Loader::new(common.request())?;
        let path = (!is_stdin(file)).then(|| file.to_path_buf());
        let input = ProgramInput { path, root: None };
        Ok(ViewedProgram { input, bytes: None, title: None, loader, against: None })
    }

    fn against(self, against: ComparedProgram) -> ViewedProgram {
        ViewedProgram { against: Some(Arc::new(against)), ..self }
    }
}

impl ViewedProgram {
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

impl ProgramSource for ViewedProgram {
    fn path(&self) -> Option<PathBuf> {
        self.input.path.clone().filter(|_| self.bytes.is_none())
    }

    fn name(&self) -> String {
        self.title.clone().unwrap_or_else(|| self.input.name().into_owned())
    }

    fn read(&self) -> Result<Vec<u8>, ProgramRefusal> {
        match (&self.bytes, &self.input.path) {
            (Some(bytes), _) => Ok(bytes.clone()),
            (None, Some(path)) => FileAccess::Disk
                .bytes(path)
                .map_err(|error| refusal(&LoadError::read(path.to_string_lossy(), &error))),
            (None, None) => Ok(Vec::new()),
        }
    }

    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<EditorProgram, ProgramRefusal> {
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
            Some(chosen) => self
                .loader
                .on(RequestedMachine::Name(chosen.name.to_string()), chosen.assignments()),
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
        FileAccess::Disk.bytes(Path::new(name)).map_err(|error| reason(&error))
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
