//! Opens a text with its machine and its subprograms, for all kinds of pages.

use std::path::Path;

use chordal::Machine;
use chordal::control::control_title;
use chordal_editor::{EditorProgram, EditorSetup};
use chordal_load::{LoadError, Loader, MachineReason, ProgramInput, ProgramText};

use crate::program::ProgramRefusal;

/// Opens a text as the program of an input. `named_in` describes in words the machine file of a folder. When another
/// machine was chosen on the page, `set_up` loads the machine that the program has without that choice: its tools and
/// its setup, such as the stock, are used on the chosen machine too.
///
/// # Errors The machine cannot be used, or the requested program number does not exist.
pub fn open_program(
    mut loader: Loader,
    set_up: Option<Loader>,
    input: &ProgramInput,
    name: &str,
    text: Vec<u8>,
    named_in: impl Fn(&Path) -> String,
) -> Result<EditorProgram, ProgramRefusal> {
    let own = set_up.and_then(|mut loader| {
        let text = ProgramText::of(name, text.clone()).ok()?;
        // Errors of that machine are ignored here: they are reported when it is used.
        loader.load_text(text, input).ok().map(|loaded| loaded.into_parts().1)
    });
    let text = ProgramText::of(name, text).map_err(|error| refusal(&error))?;
    let loaded = loader.load_text(text, input).map_err(|error| refusal(&error))?;
    // When the machine is a guess, only the control is certain: the axes and the manufacturer are those of the
    // assumed machine file.
    let is_guess = loaded.chosen.is_guess();
    let foreign = loaded.not_read().and(loaded.chosen.recognition());
    let title = match foreign {
        Some(found) => found.chosen().title.to_string(),
        None if is_guess => control_title(loaded.machine().control).to_string(),
        None => loaded.machine().title.clone(),
    };
    let why = match &loaded.chosen {
        MachineReason::Folder(path) => Some(named_in(path)),
        chosen if foreign.is_some() => chosen.why(&title),
        chosen => chosen
            .why(&title)
            .map(|why| format!("{why}; machine not named, its limits are typical")),
    };
    let (program, readings) = (loaded.program, loaded.choices());
    let (mut texts, mut machine, options) = loaded.into_parts();
    if is_guess {
        machine.title = title;
    }
    if let Some(own) = own {
        keep_setup(&mut machine, own);
    }
    // The first text is the program, the others are its subprograms.
    let others = texts.split_off(1);
    let (name, text) = texts.pop().unwrap_or_default();
    let setup = EditorSetup { machine, why, readings, options, program, subprogram_texts: others };
    EditorProgram::set_up(name, text, setup).map_err(|errors| ProgramRefusal {
        message: "the control does not know settings of the machine".into(),
        help: Some(format!("{errors:?}")),
    })
}

/// Copies the tools and the setup of another machine that this one lacks. Nothing is copied between a lathe and a
/// mill.
fn keep_setup(machine: &mut Machine, own: Machine) {
    if machine.turns() != own.turns() {
        return;
    }
    for (number, tool) in own.tools {
        machine.tools.entry(number).or_insert(tool);
    }
    if machine.setup.is_empty() {
        machine.setup = own.setup;
    }
}

/// A load error as a page shows it.
pub fn refusal(error: &LoadError) -> ProgramRefusal {
    match error {
        LoadError::Machine(errors) => {
            let texts_of_errors: Vec<String> = errors
                .iter()
                .map(|error| chordal_export::machine_error_text(error, false))
                .collect();
            ProgramRefusal { message: texts_of_errors.concat().trim_end().to_string(), help: None }
        }
        LoadError::Request { message, help } => {
            ProgramRefusal { message: message.clone(), help: help.clone() }
        }
        other @ LoadError::Read { .. } => ProgramRefusal { message: other.to_string(), help: None },
    }
}
