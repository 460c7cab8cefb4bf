//! Datum tables and the preset table of HEIDENHAIN controls next to a program.

use chordal::control::Command;
use chordal::{Diagnostic, Job, Machine, RunSink, Sink, Source, SourceMap};

const PLATE: &str = "BEGIN PLATE.D MM VERSION:1.0\r\n\
    D      X        Y        Z        A        B        C        DOC\r\n\
    0      +0       +0       +0       +0       +0       +0\r\n\
    1      +10,5    -20      +1.25    +0       +0       +0       FIRST VICE\r\n\
    12     +100     +50      +0       +0       +0       +30      TURNED\r\n\
    [END]\r\n";

const INCHES: &str = "BEGIN SMALL .D INCH\nD    X    Y    Z    DOC\n3    +1   +2   -0.5\n[END]\n";

#[derive(Default)]
struct DatumMoveRecord {
    places: Vec<[f64; 3]>,
    found: Vec<Diagnostic>,
}

impl Sink for DatumMoveRecord {
    fn command(&mut self, command: &Command) {
        if let Some(motion) = command.kind.motion() {
            self.places.push([motion.to[0], motion.to[1], motion.to[2]]);
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.found.push(diagnostic);
    }
}

impl RunSink for DatumMoveRecord {}

/// The last position of a program in coordinates of the preset, and what is reported.
fn run(blocks: &str, tables: &[(&str, &str)]) -> ([f64; 3], Vec<Diagnostic>) {
    let mut machine = Machine::from_builtin("heidenhain-mill").expect("a built-in machine");
    let offset = machine.work_offsets.entry("G54".to_string()).or_default();
    offset.values = [Some(0.0); 6];
    let text = format!(
        "BEGIN PGM T MM\nTOOL CALL 1 Z S100\n{blocks}\nL X+1 Y+2 Z+3 R0 FMAX\nM30\nEND PGM T MM\n"
    );
    let mut sources = SourceMap::new();
    sources.add(Source::new("T.H", text.into_bytes()));
    for (name, table) in tables {
        sources.add(Source::new(name.to_string(), table.as_bytes().to_vec()));
    }
    let mut ends = DatumMoveRecord::default();
    Job::new(sources, machine).expect("a job").run(&mut ends);
    (*ends.places.last().expect("a move"), ends.found)
}

fn shifted(blocks: &str, tables: &[(&str, &str)], expected: [f64; 3]) {
    let (place, found) = run(blocks, tables);
    let near = (0..3).all(|axis| (place[axis] - expected[axis]).abs() < 1e-9);
    assert!(near, "{blocks}: {place:?} is not {expected:?}");
    assert!(found.iter().all(|own| own.alarm.is_none()), "{blocks}: {found:?}");
}

/// What a run reports with the words of the control.
fn alarm(blocks: &str, tables: &[(&str, &str)]) -> (String, String) {
    let (place, found) = run(blocks, tables);
    assert_eq!(place, [1.0, 2.0, 3.0], "the datum stays");
    let own = found.iter().find(|own| own.alarm.is_some()).expect("an alarm");
    (own.alarm.clone().unwrap_or_default(), own.message.clone())
}

#[test]
fn lines_of_tables_shift_the_datum() {
    let both = [("PLATE.D", PLATE), ("small.d", INCHES)];
    let one = [("PLATE.D", PLATE)];
    let first = "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 #1";
    shifted(first, &one, [11.5, -18.0, 4.25]);
    shifted("Q5 = 1\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 #Q5", &one, [11.5, -18.0, 4.25]);
    shifted(&format!("{first}\nCYCL DEF 7.0\nCYCL DEF 7.1 #0"), &one, [1.0, 2.0, 3.0]);
    shifted(&format!("{first}\nTRANS DATUM RESET"), &one, [1.0, 2.0, 3.0]);
    // A line replaces the shift; I of cycle 7 adds to it.
    shifted(&format!("CYCL DEF 7.0\nCYCL DEF 7.1 X+99\n{first}"), &one, [11.5, -18.0, 4.25]);
    shifted(&format!("{first}\nCYCL DEF 7.0\nCYCL DEF 7.1 IX+5"), &one, [16.5, -18.0, 4.25]);
    let select = "SEL TABLE \"TNC:\\PARTS\\SMALL.D\"";
    shifted(&format!("{select}\nCYCL DEF 7.0\nCYCL DEF 7.1 #3"), &both, [26.4, 52.8, -9.7]);
    shifted("TRANS DATUM TABLE TABLINE1", &one, [11.5, -18.0, 4.25]);
    shifted("TRANS DATUM TABLE TABLINE 3 \"SMALL\"", &both, [26.4, 52.8, -9.7]);
    shifted(&format!("Q1 = 3\n{select}\nTRANS DATUM TABLE TABLINE Q1"), &both, [26.4, 52.8, -9.7]);
}

#[test]
fn a_missing_table_or_line_is_an_error() {
    let line = "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 #4";
    let (shown, message) = alarm(line, &[]);
    assert!(shown.ends_with("DATUM TABLE ?"), "{shown}");
    assert_eq!(message, "a line of a datum table is needed, and there is no table");
    let (shown, message) = alarm(line, &[("PLATE.D", PLATE), ("SMALL.D", INCHES)]);
    assert!(shown.ends_with("DATUM TABLE ?"), "{shown}");
    assert_eq!(message, "a line of a datum table is needed, and none of 2 tables is selected");
    let (shown, message) = alarm(line, &[("PLATE.D", PLATE)]);
    assert!(shown.ends_with("DATUM NUMBER NOT FOUND"), "{shown}");
    assert_eq!(message, "the datum table PLATE has no line 4");
    let (_, message) = alarm("SEL TABLE \"TNC:\\OTHER.D\"", &[("PLATE.D", PLATE)]);
    assert_eq!(message, "there is no datum table TNC:\\OTHER.D");
    let (_, message) = alarm("TRANS DATUM TABLE TABLINE2.5", &[("PLATE.D", PLATE)]);
    assert_eq!(message, "the datum table PLATE has no line 2.5");
}

#[test]
fn a_rotary_datum_is_said() {
    let (place, found) = run("CYCL DEF 7.0\nCYCL DEF 7.1 #12", &[("PLATE.D", PLATE)]);
    assert_eq!(place, [101.0, 52.0, 3.0]);
    assert!(found.iter().any(|own| own.message.contains("rotary axis")), "{found:?}");
}
