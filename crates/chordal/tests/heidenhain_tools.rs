//! Tools that a program defines (TOOL DEF) cut the stock as cylinders of their radius, which is said.

use chordal::stock::{StockOptions, StockReport};
use chordal::{Job, Machine, Source, SourceMap};

/// A slot of a tool of 5 mm radius, 5 mm deep, across a block of 100 by 60 by 20 mm.
fn slot(tools: &str, machine: &str) -> StockReport {
    let text = format!(
        "BEGIN PGM A MM\nBLK FORM 0.1 Z X+0 Y+0 Z-20\nBLK FORM 0.2 X+100 Y+60 Z+0\n{tools}\nTOOL CALL 1 Z S2000\nL X-20 Y+30 R0 FMAX M3\nL Z-5 FMAX\nL X+120 F400\nL Z+50 FMAX M30\nEND PGM A MM\n"
    );
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = format!("inherits = 'heidenhain-mill'\n{machine}");
    let machine = Machine::from_toml("a.toml", &machine, &none).expect("a machine");
    let mut sources = SourceMap::new();
    sources.add(Source::new("a.h", text.into_bytes()));
    let job = Job::new(sources, machine).expect("a job");
    let options = StockOptions { resolution_mm: Some(0.5), ..StockOptions::default() };
    job.stock(&options, &|name| Err(format!("no file {name}"))).expect("a stock")
}

fn codes(report: &StockReport) -> Vec<&'static str> {
    report.report.diagnostics.iter().map(|found| found.code.info().id).collect()
}

#[test]
fn a_tool_of_tool_def_is_a_cylinder() {
    let found = slot("TOOL DEF 1 L+80 R+5", "");
    // The slot: 100 mm long, 10 mm wide, 5 mm deep.
    let removed = found.removed_mm3;
    assert!(removed.least <= 5_000.0 && 5_000.0 <= removed.most, "{removed:?}");
    assert!(removed.most - removed.least < 1_500.0, "{removed:?}");
    let assumed: Vec<_> =
        found.report.diagnostics.iter().filter(|own| own.code.info().id == "CH634").collect();
    assert_eq!(assumed.len(), 1, "{:?}", codes(&found));
    assert!(assumed[0].message.contains("tool 1"), "{}", assumed[0].message);
    assert!(assumed[0].message.contains("a cylinder of 10 mm"), "{}", assumed[0].message);
    assert!(!codes(&found).contains(&"CH628"));
}

#[test]
fn a_shape_of_the_machine_file_counts() {
    let ball = slot("TOOL DEF 1 L+80 R+5", "[tools.1]\nshape = 'ball'\ndiameter = '10 mm'\n");
    assert!(!codes(&ball).contains(&"CH634"), "{:?}", codes(&ball));
    // Half a circle of 10 mm: 39.27 mm2 across.
    assert!(ball.removed_mm3.least <= 3_927.0 && 3_927.0 <= ball.removed_mm3.most);
}

#[test]
fn tools_whose_radius_is_not_one_number_have_no_shape() {
    for tools in ["TOOL DEF 1 L+80 R+5\nTOOL DEF 1 L+80 R+6", "Q1 = 5\nTOOL DEF 1 L+80 R+Q1"] {
        let found = slot(tools, "");
        assert!(codes(&found).contains(&"CH628"), "{:?}", codes(&found));
        assert!(!codes(&found).contains(&"CH634"));
    }
}
