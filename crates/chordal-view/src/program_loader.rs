//! A text with its machine and its subprograms, as every page opens it.

use std::path::Path;

use chordal::Machine;
use chordal::control::table;
use chordal_editor::{EditorProgram, EditorSetup};
use chordal_load::{LoadError, Loader, MachineReason, ProgramInput, ProgramText};

use crate::program::ProgramRefusal;

/// Opens a text as the program of an input. `named_in` says in words where a machine file is that its folder names.
/// Where another machine was chosen on the page, `set_up` loads the one that the program has without that: its tools,
/// its stock and what else its setup says count on the other one, too.
///
/// # Errors
/// A machine that cannot be used, a program that is not there.
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
        // Errors of its machine are reported where that is used.
        loader.load_text(text, input).ok().map(|loaded| loaded.into_parts().1)
    });
    let text = ProgramText::of(name, text).map_err(|error| refusal(&error))?;
    let loaded = loader.load_text(text, input).map_err(|error| refusal(&error))?;
    // Of a machine that is not named only the control is known: its axes and its maker are those of the
    // file that is used instead.
    let is_guess = loaded.chosen.is_guess();
    let foreign = loaded.not_read().and(loaded.chosen.recognition());
    let title = match foreign {
        Some(found) => found.chosen().title.to_string(),
        None if is_guess => table(loaded.machine().control).title.to_string(),
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

/// Gives a machine the tools and the setup of another one, as far as it has none of its own. A lathe has those of
/// lathes.
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

/// Why nothing was loaded, as a page shows it.
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
