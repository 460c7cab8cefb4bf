//! The labelled set `tests/posts`, each program on every control of its label.

use chordal::Machine;
use chordal::machine::ControlName;
use chordal_load::{Loaded, Request, RequestedMachine, text};

use crate::post_set;

/// A program of the set on one of the controls that it may be for.
pub struct LabelledProgram {
    /// The file of its source and its own title.
    pub title: String,
    pub control: ControlName,
    /// Its label names this control first: it was written for it.
    pub is_own: bool,
    pub text: String,
}

impl LabelledProgram {
    /// The program on a machine of its control: that which the text itself names, as one with G70 and G71 for the units or
    /// a lathe with system B, or else the typical one.
    pub fn load(&self) -> Loaded {
        let own = load(&self.text, None);
        match own.not_read().is_none() && own.machine().control == self.control {
            true => load_on(&self.text, own.machine()),
            false => load(&self.text, Some(RequestedMachine::Control(self.control))),
        }
    }
}

/// A text on a machine, or on that which the text itself names.
pub fn load(program: &str, machine: Option<RequestedMachine>) -> Loaded {
    let request = Request { machine, ..Request::default() };
    text("part", program.as_bytes().to_vec(), &request).expect("a program")
}

/// A text on the machine of another one.
pub fn load_on(program: &str, machine: &Machine) -> Loaded {
    load(program, Some(RequestedMachine::Machine(Box::new(machine.clone()))))
}

/// Every program of a control that is read, once for each control of its label.
pub fn programs() -> Vec<LabelledProgram> {
    post_set::programs().iter().flat_map(on_controls).collect()
}

/// Languages that are not read, and texts of which nobody can tell, have no control.
fn on_controls(program: &post_set::PostProgram) -> Vec<LabelledProgram> {
    let controls = program.controls.iter().enumerate();
    let on_control = |(index, name): (usize, &String)| {
        Some(LabelledProgram {
            title: format!("{}: {}", program.source, program.title),
            control: name.parse().ok()?,
            is_own: index == 0,
            text: program.text.clone(),
        })
    };
    controls.filter_map(on_control).collect()
}
