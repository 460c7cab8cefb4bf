//! What the tests share.
#![allow(dead_code, reason = "each test uses some of it")]

use chordal_machine::{Machine, MachineError};

/// No file can be read.
pub fn no_files(name: &str) -> Result<String, String> {
    Err(format!("there is no file {name}"))
}

/// The machine of a text that must be good.
pub fn machine(text: &str) -> Machine {
    match Machine::from_toml("shop/mine.toml", text, &no_files) {
        Ok(machine) => machine,
        Err(errors) => panic!("{}", shown(&errors)),
    }
}

/// The errors of a text that must be bad, as [`shown`] has them.
pub fn errors(text: &str) -> String {
    match Machine::from_toml("mine.toml", text, &no_files) {
        Ok(_) => panic!("no error in\n{text}"),
        Err(errors) => shown(&errors),
    }
}

/// Each error as `file:line: message`, the underlined text and the help.
pub fn shown(errors: &[MachineError]) -> String {
    let shown: Vec<String> = errors
        .iter()
        .map(|error| {
            let help = error.help.as_ref().map_or(String::new(), |help| format!("\n  = {help}"));
            let under = match &error.span {
                Some(_) => format!("\n  ^ {}", error.underlined()),
                None => String::new(),
            };
            format!("{error}{under}{help}")
        })
        .collect();
    shown.join("\n")
}
