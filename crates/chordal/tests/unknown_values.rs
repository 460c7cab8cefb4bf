//! Values that nobody gave: a run with the values given equals the program with the numbers written in, and a
//! run without them says from where on it is not verified.

use chordal::{Code, Command, Job, Machine, Report, Source, SourceMap};

fn on<T>(machine: &str, set: &[&str], text: &str, ask: impl FnOnce(&Job<'_>) -> T) -> T {
    let mut machine = Machine::from_builtin(machine).expect("a built-in machine");
    for assignment in set {
        machine.set(assignment).unwrap_or_else(|error| panic!("{assignment}: {error}"));
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("program.nc", text.as_bytes()));
    ask(&Job::new(sources, machine).expect("a job"))
}

fn report(machine: &str, set: &[&str], text: &str) -> Report {
    on(machine, set, text, |job| job.report())
}

/// What a run does, without the places in its text.
fn kinds(machine: &str, set: &[&str], text: &str) -> Vec<String> {
    on(machine, set, text, |job| {
        let mut kinds = Vec::new();
        // What a program writes is not what it does.
        job.report_of_commands(|command: &Command| {
            if !command.kind.is_effect() {
                kinds.push(format!("{:?}", command.kind));
            }
        });
        kinds
    })
}

fn line(report: &Report, text: &str) -> Option<usize> {
    let span = report.not_verified_from?;
    let before = &text.as_bytes()[..span.range.start as usize];
    Some(1 + before.iter().filter(|byte| **byte == b'\n').count())
}

/// Programs with a place for each value: `{500}` is the variable or the number.
const TEMPLATES: [(&str, &str); 6] = [
    ("fanuc-30i", "G21 G17 G90 G94 S1000 M3\nG0 X0 Y0 Z0\nG1 X{500} Y{501} F{502}\nM30\n"),
    (
        "fanuc-30i",
        "G21 G17 G90 G94 S1000 M3\nG0 X0 Y0 Z0\nG2 X{500} Y0 I[{500}/2] J0 F{502}\nG4 P{501}\nM30\n",
    ),
    (
        "fanuc-30i",
        "G21 G17 G90 G94 S1000 M3\nG0 X0 Y0 Z5.\nG81 X1. Y2. Z-{501} R{500} F{502}\nX{502}\nG80\nM30\n",
    ),
    (
        "haas-vf2",
        "G20 G17 G90 G94 S1000 M3\nG0 X0 Y0 Z0\nIF [ {500} GT {501} ] THEN X3.\nG1 X{501} F{502}\nM30\n",
    ),
    (
        "mitsubishi-m700",
        "G21 G17 G90 G94 S1000 M3\nG0 X0 Y0 Z0\n#1=0\nWHILE[#1LT{501}]DO1\nX[#1*{500}]\n#1=#1+1\nEND1\nM30\n",
    ),
    ("linuxcnc-mill", "G21 G17 G90 G94 S1000 M3\nG0 X0 Y0 Z0\nG1 X[{500}*{501}] F{502}\nM2\n"),
];

fn filled(template: &str, value: impl Fn(&str) -> String) -> String {
    ["500", "501", "502"].into_iter().fold(template.to_string(), |text, number| {
        text.replace(&format!("{{{number}}}"), &value(number))
    })
}

#[test]
fn given_values_do_what_written_numbers_do() {
    for (machine, template) in TEMPLATES {
        for values in [[2.5, 1.0, 100.0], [4.0, 3.0, 250.0], [0.5, 2.0, 60.0]] {
            let of =
                |number: &str| format!("[{:?}]", values[number.parse::<usize>().unwrap() - 500]);
            let set: Vec<String> =
                (0..3).map(|at| format!("#{}={:?}", 500 + at, values[at])).collect();
            let set: Vec<&str> = set.iter().map(String::as_str).collect();
            let by_variable = filled(template, |number| format!("#{number}"));
            let by_number = filled(template, of);
            let given = kinds(machine, &set, &by_variable);
            assert_eq!(given, kinds(machine, &[], &by_number), "{machine}: {by_variable}");
            assert!(report(machine, &set, &by_variable).verified(), "{by_variable}");
            // A program that sets them itself does the same.
            let own: String =
                (0..3).map(|at| format!("#{}={:?}\n", 500 + at, values[at])).collect();
            assert_eq!(given, kinds(machine, &[], &format!("{own}{by_variable}")), "{by_variable}");
        }
    }
}

#[test]
fn without_values_nothing_is_an_error() {
    for (machine, template) in TEMPLATES {
        let report = report(machine, &[], &filled(template, |number| format!("#{number}")));
        assert_eq!(
            (report.counts.errors, report.counts.warnings),
            (0, 0),
            "{:#?}",
            report.diagnostics
        );
        let named = report.diagnostics.iter().filter(|said| said.code == Code::UnknownVariable);
        assert_eq!(named.count(), 1, "{template}");
        assert!(!report.verified(), "{template}");
    }
}

#[test]
fn the_line_from_which_a_run_is_not_verified() {
    let head = "G21 G17 G90 G94 S1000 M3\nG0 X0 Y0 Z0\nG1 X1. F100.\n";
    for (block, lost) in [
        ("X#500", Some(4)),
        ("G2 X2. Y0 R#500", Some(4)),
        ("IF[#500EQ1]GOTO9", Some(4)),
        ("M98 P#500", Some(4)),
        ("#[#500]=1", Some(4)),
        ("F#500 X2.", Some(4)),
        ("S#500", Some(4)),
        ("#1=#500", None),
        ("DPRNT[#500[40]]", None),
    ] {
        let text = format!("{head}{block}\nN9 G1 X3.\nM30\n");
        let report = report("fanuc-30i", &[], &text);
        assert_eq!(line(&report, &text), lost, "{block}: {:#?}", report.diagnostics);
        let is_rate = block.starts_with(['F', 'S']);
        assert_eq!(report.is_path_verified(), is_rate || lost.is_none(), "{block}");
        assert_eq!(report.counts.errors, 0, "{block}: {:#?}", report.diagnostics);
    }
    let text = format!("O9100\n{}M99\n", "G0 X#24 Y#25\n");
    let alone = report("fanuc-30i", &[], &text);
    assert_eq!((line(&alone, &text), alone.summary.rapids), (Some(1), 0));
}

/// The time of a cut whose feed is not known is not counted, and the count says so.
#[test]
fn the_time_of_an_unknown_feed_is_not_counted() {
    let text =
        "G21 G17 G90 G94 S1000 M3\nG0 X0 Y0 Z0\nG1 X60. F60.\nX120. F#500\nX180. F60.\nM30\n";
    let unknown = report("fanuc-30i", &[], text).summary;
    assert_eq!(unknown.cuts_without_time, 1);
    assert!((unknown.feed_time_s - 120.0).abs() < 1e-9, "{}", unknown.feed_time_s);
    let given = report("fanuc-30i", &["#500=60"], text).summary;
    assert_eq!(given.cuts_without_time, 0);
    assert!((given.feed_time_s - 180.0).abs() < 1e-9, "{}", given.feed_time_s);
}
