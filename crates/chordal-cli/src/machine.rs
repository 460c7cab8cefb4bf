//! Which machine runs a program: the command line's, the folder's, or the one that the text
//! speaks for.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chordal::Machine;
use chordal::control::{COMMON_SETTINGS, Control, Recognition, SettingError, Units, recognize};
use chordal::machine::{ControlName, Location, MachineError, builtin, read_tool_tbl};
use toml::de::{DeTable, DeValue};

use crate::failure::Failure;
use crate::input::Input;
use crate::options::Common;

/// The file that says a folder's machine.
const FOLDER_FILE: &str = "chordal.toml";

/// Why this machine.
#[derive(Clone, Debug)]
pub enum Chosen {
    /// The command line says so.
    Given,
    /// `chordal.toml` says so.
    Folder(PathBuf),
    /// Nothing in the text says so, and the file extension is LinuxCNC's own.
    Ending,
    /// The program looks like one of this control.
    Recognized(Recognition),
}

impl Chosen {
    /// What was recognized and by what, in a line; nothing where the user said the machine.
    pub fn told(&self, file: &str, title: &str) -> Option<String> {
        self.why(title).map(|why| format!("{file}: {why}; --machine chooses another\n"))
    }

    /// The same without the file and what to do.
    pub fn why(&self, title: &str) -> Option<String> {
        Some(match self {
            Chosen::Given | Chosen::Folder(_) => return None,
            Chosen::Ending => format!("assumed {title} because of the file extension"),
            Chosen::Recognized(found) => match found.evidence.first() {
                Some((line, reason)) => format!("recognized as {title} by line {line} ({reason})"),
                None => {
                    format!("assumed {title}: nothing in the text says which control it is for")
                }
            },
        })
    }
}

/// The machine of `--machine`, with everything else the command line says of it.
pub fn given(common: &Common) -> Result<Option<Machine>, Failure> {
    let machine = common.machine.as_deref().map(named).transpose()?;
    machine.map(|machine| finish(machine, common)).transpose()
}

/// The machine of a program when the command line does not name one.
pub fn choose(input: &Input, text: &[u8], common: &Common) -> Result<(Machine, Chosen), Failure> {
    for folder in folders(input) {
        let file = folder.join(FOLDER_FILE);
        if file.is_file() {
            return Ok((finish(of_folder(&file)?, common)?, Chosen::Folder(file)));
        }
    }
    let recognition = recognize(text);
    let ending = input.path.as_ref().and_then(|path| path.extension());
    let (control, chosen) = match ending {
        // Other endings mean nothing.
        Some(ending) if recognition.evidence.is_empty() && ending.eq_ignore_ascii_case("ngc") => {
            (ControlName::Linuxcnc, Chosen::Ending)
        }
        _ => (recognition.control, Chosen::Recognized(recognition)),
    };
    Ok((finish(builtin_of(control), common)?, chosen))
}

/// A built-in machine, or the machine of a file.
pub fn named(name: &str) -> Result<Machine, Failure> {
    let path = Path::new(name);
    if builtin(name).is_none() && (path.is_file() || name.ends_with(".toml")) {
        return from_file(path);
    }
    Machine::from_builtin(name).map_err(|mut errors| match errors.pop() {
        // A wrong name on the command line: there is no file to draw.
        Some(error) if builtin(name).is_none() => {
            Failure::Use { message: error.message, help: error.help }
        }
        last => Failure::Machine(errors.into_iter().chain(last).collect()),
    })
}

/// The folders whose `chordal.toml` counts: the program's, and those above it up to the one
/// that the command line names.
fn folders(input: &Input) -> Vec<PathBuf> {
    let Some(path) = &input.path else { return Vec::new() };
    let mut folders: Vec<PathBuf> = Vec::new();
    for folder in path.ancestors().skip(1) {
        folders.push(if folder.as_os_str().is_empty() { ".".into() } else { folder.into() });
        if input.root.as_deref().is_none_or(|root| root == folder) {
            break;
        }
    }
    folders
}

/// What a program is run on when only its control is known.
pub(crate) fn builtin_of(control: ControlName) -> Machine {
    let name = builtin_name(control);
    Machine::from_builtin(name).unwrap_or_else(|_| Machine::new(name, control))
}

/// The name of that machine.
pub(crate) fn builtin_name(control: ControlName) -> &'static str {
    match control {
        ControlName::Fadal => "fadal-4020",
        ControlName::Haas => "haas-vf2",
        ControlName::Fanuc => "fanuc-30i",
        ControlName::Mitsubishi => "mitsubishi-m700",
        ControlName::Linuxcnc => "linuxcnc-mill",
    }
}

pub(crate) fn from_file(path: &Path) -> Result<Machine, Failure> {
    let name = path.to_string_lossy();
    let text = read_text(path).map_err(|error| Failure::read(&*name, &error))?;
    of_text(&name, &text)
}

pub(crate) fn of_text(name: &str, text: &str) -> Result<Machine, Failure> {
    let load = |file: &str| read_text(Path::new(file)).map_err(|error| error.to_string());
    Machine::from_toml(name, text, &load).map_err(Failure::Machine)
}

/// A text file; the byte order mark that some editors write is none of the text.
fn read_text(path: &Path) -> std::io::Result<String> {
    let text = fs::read_to_string(path)?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_string).unwrap_or(text))
}

/// `chordal.toml` is a machine file, or says with `machine = "…"` which one to take.
fn of_folder(path: &Path) -> Result<Machine, Failure> {
    let name = path.to_string_lossy();
    let text = read_text(path).map_err(|error| Failure::read(&*name, &error))?;
    let (document, _) = DeTable::parse_recoverable(&text);
    let Some(value) = document.get_ref().get("machine") else {
        return of_text(&name, &text);
    };
    let wrong = |span, message: String, help: &str| {
        let (file, text) = (name.to_string(), Arc::from(text.as_str()));
        let help = Some(help.to_string());
        Failure::Machine(vec![MachineError { message, help, file, span: Some(span), text }])
    };
    if let Some((key, _)) = document.get_ref().iter().find(|(key, _)| key.get_ref() != "machine") {
        return Err(wrong(
            key.span(),
            format!("`{}` has no meaning together with `machine`", key.get_ref()),
            "write `inherits = \"…\"` instead of `machine = \"…\"`: then this file describes a machine \
             itself",
        ));
    }
    let DeValue::String(machine) = value.get_ref() else {
        let message = "`machine` needs the name of a machine or of a file".to_string();
        return Err(wrong(value.span(), message, "write `machine = \"haas-vf2\"`"));
    };
    if builtin(machine).is_some() {
        return named(machine);
    }
    let file = path.with_file_name(machine.as_ref());
    if !file.is_file() {
        return Err(wrong(
            value.span(),
            format!("`{machine}` is neither a built-in machine nor a file in this folder"),
            "`chordal machines` lists the built-in ones",
        ));
    }
    from_file(&file)
}

/// Everything that the command line says of a machine, whichever it is.
pub(crate) fn finish(mut machine: Machine, common: &Common) -> Result<Machine, Failure> {
    let assign = |machine: &mut Machine| {
        let errors: Vec<MachineError> =
            common.set.iter().filter_map(|assignment| machine.set(assignment).err()).collect();
        if errors.is_empty() { Ok(()) } else { Err(Failure::Machine(errors)) }
    };
    assign(&mut machine)?;
    check_settings(&machine)?;
    if let Some(path) = &common.tools {
        let name = path.to_string_lossy();
        let text = read_text(path).map_err(|error| Failure::read(&*name, &error))?;
        let (control, _) = Control::of(&machine);
        let millimetres = control.parameters.units == Units::Millimetre;
        let tools = read_tool_tbl(&text, millimetres).map_err(|mut errors| {
            errors.iter_mut().for_each(|error| error.file = name.to_string());
            Failure::Machine(errors)
        })?;
        machine.tools.extend(tools);
        // A tool on the command line comes before the table's, and the table's units were only
        // known after the assignments: once more.
        assign(&mut machine)?;
    }
    if common.block_delete {
        machine.switches.block_delete = [true; 10];
    }
    Ok(machine)
}

/// Draws the settings that the control does not know where they were written.
fn check_settings(machine: &Machine) -> Result<(), Failure> {
    let (control, errors) = Control::of(machine);
    if errors.is_empty() {
        return Ok(());
    }
    let drawn = errors.into_iter().map(|error| {
        let location = machine.settings.get(&error.name).and_then(|given| given.location.as_ref());
        MachineError {
            span: location.map(|at| place_of(&error, at, &control)),
            message: error.message,
            help: error.help,
            file: location.map_or_else(|| machine.name.clone(), |at| at.file.to_string()),
            text: location.map_or_else(|| Arc::from(""), |at| at.text.clone()),
        }
    });
    Err(Failure::Machine(drawn.collect()))
}

/// A location is that of the value; where the name is wrong, the name before it on its line.
fn place_of(error: &SettingError, at: &Location, control: &Control) -> Range<usize> {
    let known = control.table.settings.iter().chain(COMMON_SETTINGS);
    if known.into_iter().any(|setting| setting.name.eq_ignore_ascii_case(&error.name)) {
        return at.span.clone();
    }
    let before = at.text.get(..at.span.start).unwrap_or_default();
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    match before[line..].find(&error.name) {
        Some(column) => line + column..line + column + error.name.len(),
        None => at.span.clone(),
    }
}
