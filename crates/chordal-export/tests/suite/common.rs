//! Jobs to write out.

use chordal::{Job, Machine, Source, SourceMap};

/// A job of one text.
pub fn job<'a>(machine: &str, name: &str, text: &'a [u8]) -> Job<'a> {
    let mut sources = SourceMap::new();
    sources.add(Source::new(name, text));
    Job::new(sources, Machine::from_builtin(machine).unwrap()).unwrap()
}
