//! The JSON of commands that take several programs: one object, whether there is one file or many.

use chordal_export::report::Reading;
use chordal_load::Loaded;

/// On what a program was read.
pub fn reading(loaded: &Loaded) -> Reading<'_> {
    let machine = Some(loaded.machine().name.as_str()).filter(|_| loaded.not_read().is_none());
    Reading {
        machine,
        control: loaded.control(),
        from: loaded.chosen.from(),
        recognition: loaded.chosen.recognition(),
    }
}

/// The objects of all files under the name of their schema.
pub fn join(schema: &str, objects: &[String]) -> String {
    let objects: Vec<&str> = objects.iter().map(|object| object.trim_end()).collect();
    format!("{{\"schema\":\"{schema}\",\"files\":[\n{}\n]}}\n", objects.join(",\n"))
}
