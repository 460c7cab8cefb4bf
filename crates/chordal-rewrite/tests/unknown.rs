//! Programs that go several ways, changed in place and carried over: nothing is written from the way that one run
//! happens to take.

use chordal::{Job, Machine, Source, SourceMap};
use chordal_compare::ComparisonVerdict;
use chordal_rewrite::convert::{Conversion, ConversionOptions, convert};
use chordal_rewrite::{TransformRefusal, TransformStep, TransformedProgram, transform};

fn job(machine: &str, given: &[&str], text: &str) -> Job<'static> {
    let mut machine = Machine::from_builtin(machine).expect("a built-in machine");
    for assignment in given {
        machine.set(assignment).unwrap_or_else(|error| panic!("{assignment}: {error}"));
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    Job::new(sources, machine).expect("a job")
}

fn transformed(text: &str, step: TransformStep) -> Result<TransformedProgram, TransformRefusal> {
    transform(&job("fanuc-0i", &[], text), &[step])
}

fn converted(text: &str, from: &str, to: &str, given: &[&str]) -> Conversion {
    let target = Machine::from_builtin(to).expect("a built-in machine");
    convert(&job(from, given, text), &target, &ConversionOptions::default())
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A subprogram that runs only where an input is on.
const ON_INPUT: &str = "%\nO1\nG21 G17 G40 G80 G90\nG0 X0 Y0 Z25.4\nIF[#1000EQ0]GOTO5\nM98 P3\nN5 G0 Z50.8\nM30\n\
                        O3\nG0 Z-25.4\nM99\n%\n";

#[test]
fn blocks_on_both_sides_of_a_condition_are_changed() {
    let inch = transformed(ON_INPUT, TransformStep::of("inch", &[]).unwrap()).expect("a change");
    let new = text(&inch.text);
    assert!(new.contains("G20"), "{new}");
    assert!(new.contains("Z-1."), "{new}");
    assert!(!new.contains("25.4"), "{new}");
    let comparison = &inch.certificate.comparison;
    assert_eq!(comparison.verdict, ComparisonVerdict::NotVerified, "{:#?}", comparison.differences);
    assert!(
        inch.notes.iter().any(|note| note.contains("both sides of a condition")),
        "{:?}",
        inch.notes
    );
    let moved = transformed(ON_INPUT, TransformStep::Shift([0.0, 0.0, 5.0])).expect("a change");
    assert!(text(&moved.text).contains("Z-20.4"), "{}", text(&moved.text));
    let scaled = transformed(ON_INPUT, TransformStep::Scale(2.0)).expect("a change");
    assert!(text(&scaled.text).contains("Z-50.8"), "{}", text(&scaled.text));
}

#[test]
fn a_mode_behind_block_delete_is_not_shifted_away() {
    let program = "G21 G17 G90\nG0 X0 Y0 Z5.\n/G91\nG0 X5.\nG90\nM30\n";
    let refused = transformed(program, TransformStep::Shift([5.0, 0.0, 0.0]));
    assert!(refused.as_ref().is_err_and(|refusal| refusal.line == 4), "{refused:?}");
    // A mode that is said again is read in one way.
    let program = "G21 G17 G90\nG0 X0 Y0 Z5.\n/G91 X1.\nG90 X5.\nM30\n";
    let shifted = transformed(program, TransformStep::Shift([5.0, 0.0, 0.0])).expect("a change");
    assert_eq!(
        shifted.certificate.comparison.verdict,
        ComparisonVerdict::Same,
        "{:?}",
        shifted.notes
    );
    assert!(shifted.notes.iter().any(|note| note.contains("block delete on and off")));
}

#[test]
fn what_one_run_assumed_is_not_written_out() {
    let branch = "G21 G17 G90\nG0 X0 Y0\nIF[#500GT5]GOTO5\nX[10.+#500]\nN5 Y1.\nM30\n";
    let input = "G21 G17 G90\nG0 X0 Y0\nIF[#1000GT0]GOTO5\nX10.\nN5 Y1.\nM30\n";
    let value = "G21 G17 G90\nG0 X0 Y0\nX[10.+#500]\nY1.\nM30\n";
    for program in [branch, input, value] {
        for to in ["linuxcnc-mill", "fadal-4020", "mach3-mill", "grblhal"] {
            let conversion = converted(program, "fanuc-0i", to, &[]);
            assert!(!conversion.holds(), "{to}:\n{program}\n{}", conversion.text);
        }
        // With the values it is a program like any other.
        let given = ["#500=6", "#1000=1"];
        let conversion = converted(program, "fanuc-0i", "linuxcnc-mill", &given);
        assert!(conversion.holds(), "{:?}\n{}", conversion.refusals, conversion.text);
    }
}

#[test]
fn return_levels_behind_block_delete_are_compared_both_ways() {
    let program =
        "G21 G17 G90 S1000 M3\nG0 X0 Y0 Z50.\n/G99\nG81 X10. Y0 Z-5. R2. F100.\nX20.\nG80\nM30\n";
    let conversion = converted(program, "fanuc-0i", "linuxcnc-mill", &[]);
    let verdict = conversion.certificate.as_ref().map(|certificate| certificate.comparison.verdict);
    // Either both ways are the same, or it is refused.
    let deletes = conversion.text.lines().any(|line| line.starts_with('/') && line.contains("G99"));
    assert!(deletes || !conversion.holds(), "{verdict:?}\n{}", conversion.text);
}
