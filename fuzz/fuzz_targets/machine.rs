//! Machine files and tool tables of any text: an answer, never a crash.

#![no_main]

use chordal::machine::{Machine, read_tool_tbl};
use chordal::{Job, SourceMap};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let _ = read_tool_tbl(text, true);
    let loader = |_: &str| Err("there are no other files".to_string());
    if let Ok(machine) = Machine::from_toml("fuzz.toml", text, &loader) {
        let again = Machine::from_toml("again.toml", &machine.to_toml(), &loader);
        assert_eq!(again.as_ref().map(|m| &m.axes), Ok(&machine.axes));
        let _ = Job::new(SourceMap::new(), machine);
    }
    let mut machine = Machine::from_builtin("haas-vf2").expect("a built-in machine");
    let _ = machine.set(text);
});
