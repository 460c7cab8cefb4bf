use chordal::diagnostics::{Applicability, Fix};
use chordal::{Code, Diagnostic, Machine, Report, Source, SourceMap, Span};
use chordal::diagnostics::FileId;
use chordal_export::{machine_error_text, report};

use crate::common::job;

const WRONG: &[u8] = b"%\nO100 (WRONG)\nG20 G90 S900 M3\nG1 X0 Y0 F10.\nG3 X1. Y1.2 I0. J1.\nG2 X3. Y1. R0.5\nM98 P200\nM30\n%\n";

#[test]
fn look() {
    let job = job("haas-vf2", "wrong.nc", WRONG);
    let report = job.report();
    println!("{}", report::text(&report, job.sources(), false));
    let mut sources = SourceMap::new();
    let mut text = b"O1\nM98 P2\n".to_vec();
    text.extend(vec![b'('; 500]);
    text.extend(b") G1 X10 Y\xD810. F5");
    sources.add(Source::new("a.nc", text));
    let d = Diagnostic::new(Code::MissingDecimalPoint, Span::new(FileId(0), 515, 518), "`X10` is 0.001 in")
        .label("ten increments").also(Span::new(FileId(0), 519, 524), "here it has one").also(Span::new(FileId(0), 3, 6), "reached from here")
        .note("a note").help("write a point").fix(Fix { title: "write `X10.`".into(), span: Span::new(FileId(0), 515, 518), replacement: "X10.".into(), applicability: Applicability::Safe});
    let mut d2 = d.clone();
    d2.calls.push(Span::new(FileId(0), 3, 9));
    println!("{}", report::one(&d2, &sources, false));
    println!("{}", report::one(&d2, &sources, true));
    let d3 = Diagnostic::new(Code::EmptyProgram, Span::default(), "there is no block to run").help("x");
    println!("{}", report::one(&d3, &sources, false));
    let e = Machine::from_toml("m.toml", "inherits = 'haas-vf2'\n[feed]\nmax = 300\n", &|_: &str| Err("no".to_string())).unwrap_err();
    for e in e { println!("{}", machine_error_text(&e, false)); }
}
