//! The examples of `explain` run on their controls.

use chordal::control::{Action, CycleKind};
use chordal::diagnostics::Source;
use chordal::{Job, Machine, Severity, SourceMap};
use chordal_editor::meaning::{ControlView, codes, example};

/// The example after the head of a usual program, with what it may call.
/// For a control that takes one command a line.
fn lines(example: &str, spindle: &str) -> String {
    format!("G90\n{spindle} S500\nG0 X0 Y0 F900\nG0 Z30.\nG1 Z10. F200.\n{example}\n")
}

fn program(example: &str, spindle: &str, turns: bool, stations: bool, small: bool) -> String {
    if turns && !stations {
        return format!(
            "%\nO1\nG7 G18 G40 G94\nT1 M6\nG43\nS500 {spindle}\nG0 X66. Z10.\nG1 Z5. F200.\n{example}\nM2\nO1000\nM99\n%\n"
        );
    }
    if turns {
        return format!(
            "%\nO1\nG18 G40 G98\nT0101\nS500 {spindle}\nG0 X66. Z10.\nG1 Z5. F200.\n{example}\nM30\nN100 M99\nO1000\nM99\n%\n"
        );
    }
    if small {
        return format!(
            "G17 G40 G49 G90\nS500 {spindle}\nG0 X0 Y0\nG0 Z30.\nG1 Z10. F200.\n{example}\nM30\nO1000\nM99\n"
        );
    }
    format!(
        "%\nO1\nG17 G40 G49 G80 G90\nT1 M6\nS500 {spindle}\nG0 X0 Y0\nG43 H1 Z30.\nG1 Z10. F200.\n{example}\nM30\nN100 M99\nO1000\nM99\n%\n"
    )
}

#[test]
fn every_example_runs_without_an_error() {
    let mut count = 0;
    let mut wrong = Vec::new();
    for view in ControlView::all() {
        for letter in [b'G', b'M'] {
            for row in codes(view.table, letter) {
                let Some(example) = example(letter, row, &view) else { continue };
                count += 1;
                let mut machine = Machine::from_builtin(view.table.default_machine).unwrap();
                machine.set("tools.1.diameter=\"6 mm\"").unwrap();
                // Not every control has a code for it.
                machine.set("settings.units=\"mm\"").unwrap();
                // Codes that not every build of a firmware has are there.
                for setting in view.table.settings {
                    if setting.field.is_build_option() {
                        machine.set(&format!("settings.\"{}\"=\"on\"", setting.name)).unwrap();
                    }
                }
                // A left-hand tap turns the other way.
                let left = row.action == Action::Cycle(CycleKind::LeftTap);
                let turns = machine.turns();
                // Others than LinuxCNC have T0101.
                let stations = !view.parameters.increments.is_empty();
                // Its firmware has no program numbers, tool lengths and cycles.
                let small = view.table.firmware.is_some();
                let spindle = if left { "M4" } else { "M3" };
                let text = match view.table.command_line {
                    Some(_) => lines(&example, spindle),
                    None => program(&example, spindle, turns, stations, small),
                };
                let mut sources = SourceMap::new();
                sources.add(Source::new("example.nc", text.into_bytes()));
                let report = Job::new(sources, machine).unwrap().report();
                let errors =
                    report.diagnostics.iter().filter(|found| found.severity == Severity::Error);
                for found in errors {
                    let (control, code) = (view.table.name, found.code.id());
                    wrong.push(format!("{control}: {example}: {code} {}", found.message));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {count}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(count > 150, "{count}");
}
