//! The labelled set `tests/posts`, each program on every control of its label.

use std::fs;
use std::path::Path;

use chordal::Machine;
use chordal::machine::ControlName;
use chordal_load::{Given, Loaded, Request, text};

/// A program of the set on one of the controls that it may be for.
pub struct PostProgram {
    /// The file of its source and its own title.
    pub title: String,
    pub control: ControlName,
    /// Its label names this control first: it was written for it.
    pub is_own: bool,
    pub text: String,
}

impl PostProgram {
    /// The program on a machine of its control: that which the text itself names, as one with G70 and G71 for the units or
    /// a lathe with system B, or else the typical one.
    pub fn load(&self) -> Loaded {
        let own = load(&self.text, None);
        match own.not_read().is_none() && own.machine().control == self.control {
            true => load_on(&self.text, own.machine()),
            false => load(&self.text, Some(Given::Control(self.control))),
        }
    }
}

/// A text on a machine, or on that which the text itself names.
pub fn load(program: &str, machine: Option<Given>) -> Loaded {
    let request = Request { machine, ..Request::default() };
    text("part", program.as_bytes().to_vec(), &request).expect("a program")
}

/// A text on the machine of another one.
pub fn load_on(program: &str, machine: &Machine) -> Loaded {
    load(program, Some(Given::Machine(Box::new(machine.clone()))))
}

/// Every program of a control that is read, once for each control of its label.
pub fn programs() -> Vec<PostProgram> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/posts");
    let entries = fs::read_dir(folder).expect("the set");
    let mut files: Vec<_> = entries.map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    files.iter().flat_map(|path| programs_of(path)).collect()
}

/// Each program begins after `=== controls | units | X Y Z | title`.
fn programs_of(path: &Path) -> Vec<PostProgram> {
    let source = path.file_stem().expect("a name").to_string_lossy();
    let all = fs::read_to_string(path).expect("a text");
    let mut programs = Vec::new();
    for part in all.split("\n=== ").skip(1) {
        let (head, text) = part.split_once('\n').expect("a program");
        let mut fields = head.split(" | ").map(str::trim);
        let controls = fields.next().expect("the controls");
        let title = fields.last().expect("a title");
        // Languages that are not read, and texts of which nobody can tell, have no control.
        for (index, name) in controls.split(',').enumerate() {
            let Ok(control) = name.parse() else { continue };
            programs.push(PostProgram {
                is_own: index == 0,
                title: format!("{source}: {title}"),
                control,
                text: format!("{}\n", text.trim_end_matches('\n')),
            });
        }
    }
    programs
}
