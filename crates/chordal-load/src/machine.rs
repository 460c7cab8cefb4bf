//! Loads machines by name and from files, and chooses the machine of a program: the one that the caller or the folder
//! names, or the one recognized from the text.

use std::ffi::OsStr;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chordal::Machine;
use chordal::control::dump::{self, DumpSetting};
use chordal::control::{
    COMMON_SETTINGS, CONTROLS, ControlTable, EvidenceStrength, Recognition, SettingError, Units,
    configured_control, control_profile, control_title, recognize, table,
};
use chordal::machine::{ControlName, MachineError, ValueLocation, builtin, read_tool_tbl};

use crate::assumption::assume;
use crate::error::LoadError;
use crate::files::FileAccess;
use crate::input::ProgramInput;
use crate::machine_reason::MachineReason;
use crate::readings::{ReadingPremise, apply_settings, machine_name, settle};
use crate::request::{BlockDeleteSwitch, Request, RequestedMachine};

/// The file that names the machine of a folder.
const FOLDER_FILE: &str = "chordal.toml";

/// The machine that a request names, with the settings of the request applied; `None` when it names none.
pub(crate) fn requested_machine(request: &Request) -> Result<Option<Machine>, LoadError> {
    let machine = match &request.machine {
        None => return Ok(None),
        Some(RequestedMachine::Name(name)) => named_of(&request.files, name)?,
        Some(RequestedMachine::Control(control)) => typical(*control),
        Some(RequestedMachine::Machine(machine)) => machine.as_ref().clone(),
    };
    finish(machine, request).map(Some)
}

/// The machine of a program when the request does not name one.
pub(crate) fn choose(
    input: &ProgramInput,
    text: &[u8],
    request: &Request,
) -> Result<(Machine, MachineReason, Option<ReadingPremise>), LoadError> {
    if let Some(file) = folder_file(input, request) {
        let machine = file_of(&request.files, &file)?;
        return Ok((finish(machine, request)?, MachineReason::Folder(file), None));
    }
    if request.settings.is_some() {
        return Ok((finish(typical(dumped()), request)?, MachineReason::Requested, None));
    }
    let recognition = recognize(text);
    let ending = input.path.as_ref().and_then(|path| path.extension());
    let (machine, chosen, premise) = match ending {
        // Other extensions do not identify a control.
        Some(ending)
            if recognition.strength() == EvidenceStrength::Assumed
                && ending.eq_ignore_ascii_case("ngc") =>
        {
            (typical(ControlName::Linuxcnc), MachineReason::Ending, None)
        }
        Some(ending) if is_part_program(ending, &recognition) => {
            let control = match control_profile(recognition.chosen().control)
                .is_some_and(|profile| profile.turns)
            {
                true => ControlName::SinumerikLathe,
                false => ControlName::Sinumerik,
            };
            (typical(control), MachineReason::Ending, None)
        }
        _ => {
            let (settled, premise) = settle(recognition, text, &request.set);
            let usual = Machine::from_builtin(machine_name(settled.chosen()));
            let usual = usual.unwrap_or_else(|_| typical(settled.control()));
            let (mut machine, moved) = assume(usual, text);
            let assumed = premise.as_ref().map_or(&[][..], ReadingPremise::settings);
            apply_settings(&mut machine, assumed);
            (machine, MachineReason::Recognized(settled, moved), premise)
        }
    };
    Ok((finish(machine, request)?, chosen, premise))
}

/// The least weight of the signs of another control that outweigh the file extension of a Sinumerik.
const AGAINST_ENDING: i32 = 12;

/// Whether a file is one of a Sinumerik by its extension, and its text does not say otherwise.
fn is_part_program(ending: &OsStr, found: &Recognition) -> bool {
    let is_ending = ["mpf", "spf"].iter().any(|own| ending.eq_ignore_ascii_case(own));
    let chosen = found.chosen();
    let is_own = matches!(chosen.control, ControlName::Sinumerik | ControlName::SinumerikLathe);
    is_ending && !is_own && chosen.weight < AGAINST_ENDING
}

/// The `chordal.toml` that applies to a program.
fn folder_file(input: &ProgramInput, request: &Request) -> Option<PathBuf> {
    let mut files = folders(input).into_iter().map(|folder| folder.join(FOLDER_FILE));
    files.find(|file| request.files.is_file(file))
}

/// Whether a `chordal.toml`, printed settings or an assignment name the control of a program.
pub(crate) fn is_named(input: &ProgramInput, request: &Request) -> bool {
    let control = |assignment: &String| assignment.trim_start().starts_with("control");
    request.settings.is_some()
        || request.set.iter().any(control)
        || folder_file(input, request).is_some()
}

/// The built-in machine of this name or, when there is none, the machine of this file.
///
/// # Errors There is no such machine (the help lists the built-in ones), or the file is wrong.
pub fn named(name: &str) -> Result<Machine, LoadError> {
    named_of(&FileAccess::Disk, name)
}

/// [`named`] with another file access.
///
/// # Errors As [`named`].
pub fn named_of(files: &FileAccess, name: &str) -> Result<Machine, LoadError> {
    let path = Path::new(name);
    if builtin(name).is_none() && (files.is_file(path) || name.ends_with(".toml")) {
        return file_of(files, path);
    }
    Machine::from_builtin(name).map_err(|mut errors| match errors.pop() {
        // A wrong name in a request: there is no file to show.
        Some(error) if builtin(name).is_none() => {
            LoadError::Request { message: error.message, help: error.help }
        }
        last => LoadError::Machine(errors.into_iter().chain(last).collect()),
    })
}

/// The folders whose `chordal.toml` applies: the program's, and its parents up to the folder that the caller named.
fn folders(input: &ProgramInput) -> Vec<PathBuf> {
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

/// The default machine of a control, used when only the control is known.
pub fn typical(control: ControlName) -> Machine {
    let name = typical_name(control);
    Machine::from_builtin(name).unwrap_or_else(|_| Machine::new(name, control))
}

/// The control whose firmware prints its settings for `$$`.
pub fn dumped() -> ControlName {
    let has_dump = |table: &&&ControlTable| table.firmware.is_some_and(|f| !f.dump.is_empty());
    let name = CONTROLS.iter().find(has_dump).and_then(|table| table.name.parse().ok());
    name.unwrap_or(ControlName::Grbl)
}

/// Applies the settings that a firmware printed for `$$` to a machine.
///
/// # Errors The file cannot be read or is wrong, or the machine's control prints no settings.
pub fn set_dump(machine: &mut Machine, path: &Path) -> Result<(), LoadError> {
    set_dump_of(&FileAccess::Disk, machine, path)
}

fn set_dump_of(files: &FileAccess, machine: &mut Machine, path: &Path) -> Result<(), LoadError> {
    let name = path.to_string_lossy();
    let text = files.text(path).map_err(|error| LoadError::read(&*name, &error))?;
    let firmware = table(machine.control).and_then(|table| table.firmware);
    let Some(rows) = firmware.map(|firmware| firmware.dump) else {
        let title = control_title(machine.control);
        let message = format!("{title} is no control that prints its settings for `$$`");
        let help = format!("leave out --machine, or name a machine of {}", control_title(dumped()));
        return Err(LoadError::wrong(message, help));
    };
    let settings = dump::read(&name, &text, rows).map_err(LoadError::Machine)?;
    let text: Arc<str> = text.into();
    let wrong = |setting: DumpSetting| {
        let error = machine.set(&setting.assignment).err()?;
        let (file, text) = (name.to_string(), text.clone());
        Some(MachineError { file, text, span: Some(setting.span), ..error })
    };
    let errors: Vec<MachineError> = settings.into_iter().filter_map(wrong).collect();
    if errors.is_empty() { Ok(()) } else { Err(LoadError::Machine(errors)) }
}

/// The name of the default machine of a control.
pub fn typical_name(control: ControlName) -> &'static str {
    control_profile(control).map_or(control.as_str(), |profile| profile.default_machine)
}

/// Reads a machine file.
///
/// # Errors The file cannot be read, or all problems found in it.
pub fn from_file(path: &Path) -> Result<Machine, LoadError> {
    file_of(&FileAccess::Disk, path)
}

fn file_of(files: &FileAccess, path: &Path) -> Result<Machine, LoadError> {
    let name = path.to_string_lossy();
    let text = files.text(path).map_err(|error| LoadError::read(&*name, &error))?;
    text_of(files, &name, &text)
}

/// Reads a machine from a TOML text; messages show `name`.
///
/// # Errors All problems found in the text.
pub fn from_text(name: &str, text: &str) -> Result<Machine, LoadError> {
    text_of(&FileAccess::Disk, name, text)
}

fn text_of(files: &FileAccess, name: &str, text: &str) -> Result<Machine, LoadError> {
    let load = |file: &str| files.text(Path::new(file)).map_err(|error| error.to_string());
    Machine::from_toml(name, text, &load).map_err(LoadError::Machine)
}

/// The text of a machine file to start from. The machine's notes become comments at the top, because they no longer
/// hold once the values are changed.
pub fn own_file(mut machine: Machine) -> String {
    let mut text = format!("# Copied from {}: put in the figures of your machine.\n", machine.name);
    for note in std::mem::take(&mut machine.notes) {
        text.push_str(&format!("# There, {note}.\n"));
    }
    text + &machine.to_toml()
}

/// Applies the settings of a request to a machine.
fn finish(mut machine: Machine, request: &Request) -> Result<Machine, LoadError> {
    let assign = |machine: &mut Machine| {
        let errors: Vec<MachineError> =
            request.set.iter().filter_map(|assignment| machine.set(assignment).err()).collect();
        if errors.is_empty() { Ok(()) } else { Err(LoadError::Machine(errors)) }
    };
    if let Some(path) = &request.settings {
        set_dump_of(&request.files, &mut machine, path)?;
    }
    assign(&mut machine)?;
    check_settings(&machine)?;
    if let Some(path) = &request.tools {
        let name = path.to_string_lossy();
        let text = request.files.text(path).map_err(|error| LoadError::read(&*name, &error))?;
        let control = configured_control(&machine).map(|(control, _)| control);
        let millimetres = control.is_some_and(|control| control.rules().units == Units::Millimetre);
        let tools = read_tool_tbl(&text, millimetres).map_err(|mut errors| {
            errors.iter_mut().for_each(|error| error.file = name.to_string());
            LoadError::Machine(errors)
        })?;
        machine.tools.extend(tools);
        // The assignments are applied twice: before the tool table, whose units they may set, and after it, because a
        // tool from an assignment takes precedence over the table.
        assign(&mut machine)?;
    }
    if request.block_delete == BlockDeleteSwitch::On {
        machine.switches.block_delete = [true; 10];
    }
    Ok(machine)
}

/// Reports the settings that the control does not know, at the location where they were written.
fn check_settings(machine: &Machine) -> Result<(), LoadError> {
    let errors = configured_control(machine).map_or_else(Vec::new, |(_, errors)| errors);
    if errors.is_empty() {
        return Ok(());
    }
    let drawn = errors.into_iter().map(|error| {
        let setting =
            machine.settings.get(&error.name).and_then(|setting| setting.location.as_ref());
        let location = setting.or_else(|| code_place(machine, &error.name));
        MachineError {
            span: location.map(|at| place_of(&error, at, machine.control)),
            message: error.message,
            help: error.help,
            file: location.map_or_else(|| machine.name.clone(), |at| at.file.to_string()),
            text: location.map_or_else(|| Arc::from(""), |at| at.text.clone()),
        }
    });
    Err(LoadError::Machine(drawn.collect()))
}

/// The location of a custom code by its name in errors, such as `shop_codes.M48`.
fn code_place<'m>(machine: &'m Machine, name: &str) -> Option<&'m ValueLocation> {
    let code = name.strip_prefix("shop_codes.")?;
    let number = code.get(1..)?.parse::<u32>().ok()?;
    let code = match code.as_bytes()[0] {
        b'M' => machine.shop_codes.get(&u16::try_from(number).ok()?),
        _ => machine.shop_programs.get(&number),
    };
    code?.location.as_ref()
}

/// The range to mark for an error: the value, or the setting's name before it on the line when the name is unknown.
fn place_of(error: &SettingError, at: &ValueLocation, control: ControlName) -> Range<usize> {
    let own = table(control).map_or(&[][..], |table| table.settings);
    if own
        .iter()
        .chain(COMMON_SETTINGS)
        .any(|setting| setting.name.eq_ignore_ascii_case(&error.name))
    {
        return at.span.clone();
    }
    let before = at.text.get(..at.span.start).unwrap_or_default();
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    match before[line..].find(&error.name) {
        Some(column) => line + column..line + column + error.name.len(),
        None => at.span.clone(),
    }
}
