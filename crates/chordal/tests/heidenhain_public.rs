//! What programs of other shops showed: forms of the language that posts and hands write, and what is not known.

use chordal::{Command, Diagnostic, Job, Machine, RunSink, Sink, Source, SourceMap};

/// The end points of the moves, and the problems with their lines.
#[derive(Default)]
struct KlartextOutcome {
    ends: Vec<[f64; 3]>,
    problems: Vec<(u32, &'static str)>,
    messages: Vec<String>,
}

/// Takes a run down; the lines are those of one text.
struct OutcomeSink<'t>(KlartextOutcome, &'t str);

impl Sink for OutcomeSink<'_> {
    fn command(&mut self, command: &Command) {
        if let Some(motion) = command.kind.motion() {
            self.0.ends.push([motion.to[0], motion.to[1], motion.to[2]]);
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        let start = diagnostic.primary.span.range.start as usize;
        let line = self.1[..start].matches('\n').count() as u32 + 1;
        self.0.problems.push((line, diagnostic.code.id()));
        self.0.messages.push(diagnostic.message);
    }
}

impl RunSink for OutcomeSink<'_> {}

fn run_on(machine: Machine, file: &str, text: &str) -> KlartextOutcome {
    let mut sources = SourceMap::new();
    sources.add(Source::new(file, text.as_bytes()));
    let job = Job::new(sources, machine).expect("settings");
    let mut sink = OutcomeSink(KlartextOutcome::default(), text);
    job.run(&mut sink);
    sink.0
}

fn run(file: &str, text: &str) -> KlartextOutcome {
    run_on(Machine::from_builtin("heidenhain-mill").expect("a built-in machine"), file, text)
}

fn tool_10() -> Machine {
    let mut machine = Machine::from_builtin("heidenhain-mill").expect("a built-in machine");
    let tool = machine.tools.entry(1).or_default();
    (tool.diameter_mm, tool.offset[2]) = (Some(10.0), Some(0.0));
    machine
}

#[test]
fn a_comment_goes_on_in_the_next_line() {
    let text = "BEGIN PGM A MM\n1 ;A LONG COMMENT ~\n  L X+99 Y+99 FMAX ~\n  OF THE SHOP\n2 L X+1 Y+2 Z+3 R0 FMAX\nM30\n\
                END PGM A MM\n";
    let found = run("a.h", text);
    assert_eq!(found.ends, [[1.0, 2.0, 3.0]]);
    assert!(found.problems.iter().all(|(_, code)| *code != "CH301"), "{:?}", found.problems);
}

#[test]
fn din_iso_programs_calculate_with_formulas() {
    let text = "%A G71 *\nN10 Q1 = 3 * SIN 30 + 2 *\nN20 Q2 = - ( Q1 - 1 ) *\nN30 G00 G90 X+Q1 Y+Q2 Z+5 *\n\
                N99999999 %A G71 *\n";
    let found = run("a.i", text);
    assert_eq!(found.ends, [[3.5, -2.5, 5.0]]);
    assert!(found.problems.is_empty(), "{:?}", found.problems);
}

#[test]
fn values_that_only_the_control_has_are_no_alarm() {
    // The radius of a tool, a value of an earlier program, and a result of probing.
    let text = "BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F500\nL X+0 Y+0 Z+5 R0 FMAX M3\nQ1 = 10 / Q108\nL X+Q1\nL X+QR3\nL X+Q150\nQ2 = 5\n\
                L X+Q2 Y+3 FAUTO\nM30\nEND PGM A MM\n";
    let found = run("a.h", text);
    let own: Vec<_> = found.problems.iter().filter(|(line, _)| *line > 2).copied().collect();
    assert_eq!(own, [(4, "CH727"), (5, "CH727"), (6, "CH727"), (7, "CH727")]);
    assert_eq!(found.ends.last(), Some(&[5.0, 3.0, 5.0]));
    let known = run_on(tool_10(), "a.h", &text.replace("L X+QR3\nL X+Q150\n", ""));
    assert_eq!(known.ends[1], [2.0, 0.0, 5.0]);
    assert!(known.problems.is_empty(), "{:?}", known.problems);
}

#[test]
fn a_parameter_of_the_program_that_is_not_set_is_an_alarm() {
    let text = "BEGIN PGM A MM\nL X+Q5 FMAX\nM30\nEND PGM A MM\n";
    assert_eq!(run("a.h", text).problems, [(2, "CH705")]);
}

#[test]
fn a_rapid_from_an_unknown_place_is_not_one_into_the_blank() {
    let text = "BEGIN PGM A MM\nBLK FORM 0.1 Z X+0 Y+0 Z-20\nBLK FORM 0.2 X+100 Y+100 Z+0\nTOOL CALL 1 Z S800 F100\n\
                L Z-15 R0 FMAX M91\nL X+20 Y+20 FMAX M3\nL Z+25 FMAX\nM30\nEND PGM A MM\n";
    let mut machine = tool_10();
    assert!(run_on(machine.clone(), "a.h", text).problems.is_empty());
    // With a preset it is known: machine Z-15 is Z-5 of the program.
    machine.work_offsets.entry("G54".into()).or_default().values = [Some(-10.0); 6];
    let found = run_on(machine, "a.h", text);
    assert!(found.problems.contains(&(6, "CH602")), "{:?} {:?}", found.problems, found.messages);
}
