//! Comments about tools and stock: whatever stands in them, a tool with numbers that can be one, or nothing.

#![no_main]

use chordal::tool_comments::{StockPlace, commented_stock, known_tools, read_tool_comment};
use chordal::{Job, Machine, Source, SourceMap};
use libfuzzer_sys::fuzz_target;

const MACHINES: [&str; 5] = ["haas-vf2", "fanuc-lathe", "linuxcnc-mill", "fadal-4020", "grbl"];

fuzz_target!(|text: &str| {
    for line in text.lines() {
        for (inch, turns) in [(false, false), (true, false), (false, true), (true, true)] {
            for called in [None, Some(1)] {
                if let Some(said) = read_tool_comment(line, inch, called, turns) {
                    assert!(said.diameter_mm.is_none_or(|mm| mm > 0.0 && mm.is_finite()));
                    assert!(said.pitch_mm.is_none_or(f64::is_finite));
                    assert!(said.nose_radius_mm.is_none_or(f64::is_finite));
                }
            }
        }
    }
    // The same in a program: a comment a line, with calls between them.
    let mut program = String::from("%\nO1\nG21\n");
    for (index, line) in text.lines().take(40).enumerate() {
        program += &format!("({line})\n");
        if index % 3 == 1 {
            program += &format!("T{} M6 ({line})\n", index + 1);
        }
    }
    program += "G0 X1. Y1. Z1.\nM30\n%\n";
    for name in MACHINES {
        let mut sources = SourceMap::new();
        sources.add(Source::new("fuzz.nc", program.as_bytes()));
        let machine = Machine::from_builtin(name).expect("a built-in machine");
        let job = Job::new(sources, machine).expect("a good machine");
        for known in known_tools(&job).values() {
            assert!(known.tool.diameter_mm.is_none_or(f64::is_finite));
        }
        if let Some(stock) = commented_stock(&job)
            && let StockPlace::Size(size) = stock.place
        {
            assert!(size.iter().all(|side| side.is_finite() && *side > 0.0));
        }
    }
});
