//! Stock and tools from the comments of a program: the answers are those of the same stock and tools in a setup
//! file, and say where they come from.

use chordal::stock::{
    StockOptions, StockReport, StockRunError, StockVerdict, TurnedOptions, TurnedReport,
};
use chordal::{Job, Machine, Source, SourceMap};
use proptest::prelude::*;

fn job(setup: &str, program: &str) -> Job<'static> {
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("setup.toml", setup, &none).expect("a good setup");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.as_bytes().to_vec()));
    Job::new(sources, machine).expect("settings of the control")
}

fn mill(setup: &str, program: &str) -> Result<StockReport, StockRunError> {
    let setup = format!("control = 'grbl'\n{setup}");
    let options = StockOptions { resolution_mm: Some(0.5), ..StockOptions::default() };
    job(&setup, program).stock(&options, &|name| Err(format!("no file {name}")))
}

fn turn(setup: &str, program: &str) -> TurnedReport {
    let job = job(&format!("machine = 'fanuc-lathe'\n{setup}"), program);
    let files = |name: &str| Err(format!("no file {name}"));
    job.turned_stock(&TurnedOptions::default(), &files).expect("stock")
}

fn codes(report: &chordal::Report) -> Vec<&'static str> {
    report.diagnostics.iter().map(|found| found.code.info().id).filter(|id| *id > "CH670").collect()
}

/// A slot of 6 mm width and 1 mm depth across 100 mm.
const SLOT: &str = "G21 G90 G17
(TOOL/MILL, 6, 0, 20, 0)
T1 M6
S10000 M3
G0 X-10 Y30 Z5
G0 Z-1
G1 X110 F600
G0 Z5
M30
";

const BLOCK: &str = "(STOCK/BLOCK, 100, 60, 10, 0, 0, 10)\n";

#[test]
fn the_stock_of_a_comment_is_cut() {
    let found = mill("", &format!("{BLOCK}{SLOT}")).expect("stock");
    let removed = found.removed_mm3;
    assert!(removed.least <= 600.0 && 600.0 <= removed.most, "{removed:?}");
    assert!(found.left_mm3.least <= 59_400.0 && 59_400.0 <= found.left_mm3.most);
    assert_eq!(codes(&found.report), ["CH672"]);
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
    let note = &found.report.diagnostics[0];
    assert_eq!(
        note.message,
        "the stock is taken from this comment: X 0 to 100, Y 0 to 60, Z -10 to 0 mm"
    );
    // The same in a setup file says nothing of a comment.
    let setup = "[stock]\nshape = 'box'\nfrom = { X = '0 mm', Y = '0 mm', Z = '-10 mm' }\n\
                 to = { X = '100 mm', Y = '60 mm', Z = '0 mm' }";
    let given = mill(setup, SLOT).expect("stock");
    assert_eq!((given.removed_mm3, given.left_mm3), (found.removed_mm3, found.left_mm3));
    assert!(codes(&given.report).is_empty());
    // A setup comes first.
    let other = "[stock]\nshape = 'box'\nfrom = { X = '0 mm', Y = '0 mm', Z = '-20 mm' }\n\
                 to = { X = '100 mm', Y = '60 mm', Z = '0 mm' }";
    let given = mill(other, &format!("{BLOCK}{SLOT}")).expect("stock");
    assert!(given.left_mm3.least > 100_000.0 && codes(&given.report).is_empty());
}

#[test]
fn the_tube_of_a_comment_has_its_bore() {
    // A slot of 6 mm along the whole of a tube of 40 mm with a bore of 20 mm, 1 mm deep from its end.
    let slot = SLOT.replace("X-10 Y30", "X-30 Y0").replace("X110", "X30");
    let tube = "(WORKPIECE,TUBE,ZMIN=-10,ZMAX=0,DIAMETER=40,INNER_DIAMETER=20)\n";
    let found = mill("", &format!("{tube}{slot}")).expect("stock");
    let whole = std::f64::consts::PI * (20.0_f64.powi(2) - 10.0_f64.powi(2)) * 10.0;
    // The area of a strip of 6 mm about the middle of a circle.
    let strip = |r: f64| 2.0 * (3.0 * (r * r - 9.0_f64).sqrt() + r * r * (3.0 / r).asin());
    let removed = strip(20.0) - strip(10.0);
    let holds = |least: f64, most: f64, value: f64| least <= value && value <= most;
    assert!(holds(found.removed_mm3.least, found.removed_mm3.most, removed), "{removed}");
    let left = whole - removed;
    assert!(holds(found.left_mm3.least, found.left_mm3.most, left), "{left}");
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
    // A bar along X, 20 mm thick, whose middle is 10 mm below Z0.
    let bar = "(WORKPIECE,CYLINDER,AXIS=X,XMIN=0,XMAX=100,Y=30,Z=-10,DIAMETER=20)\n";
    let found = mill("", &format!("{bar}{SLOT}")).expect("stock");
    let whole = std::f64::consts::PI * 100.0 * 100.0;
    let least = found.removed_mm3.least + found.left_mm3.least;
    let most = found.removed_mm3.most + found.left_mm3.most;
    assert!(holds(least, most, whole), "{whole} is not in {least} to {most}");
    // Half a cell on each side of a bar that is 40 cells thick.
    assert!(least > 0.95 * whole && most < 1.05 * whole, "{least} to {most} for {whole}");
    // A bore that is wider than the tube.
    let wide = tube.replace("INNER_DIAMETER=20", "INNER_DIAMETER=50");
    assert_eq!(mill("", &format!("{wide}{slot}")).expect_err("no stock"), StockRunError::NoStock);
}

#[test]
fn what_is_no_stock_is_not_cut() {
    assert_eq!(mill("", SLOT).expect_err("no stock"), StockRunError::NoStock);
    let allowance = format!("(XY STOCK TO LEAVE - .25)\n{SLOT}");
    assert_eq!(mill("", &allowance).expect_err("no stock"), StockRunError::NoStock);
    // A size without its zero.
    let sized = mill("", &format!("(BLANK SIZE: X100, Y60, Z10)\n{SLOT}")).expect_err("no zero");
    assert_eq!(sized, StockRunError::StockNotPlaced([100.0, 60.0, 10.0]));
    assert!(sized.to_string().contains("100 × 60 × 10 mm"), "{sized}");
    // Nothing but a surface.
    let flat = format!("(STOCK/BLOCK, 100, 60, 0, 0, 0, 0)\n{SLOT}");
    assert_eq!(mill("", &flat).expect_err("no stock"), StockRunError::NoStock);
    // Two comments of different stocks: one of them is old.
    let two = format!("{BLOCK}(STOCK/BLOCK, 100, 60, 20, 0, 0, 20)\n{SLOT}");
    assert_eq!(mill("", &two).expect_err("no stock"), StockRunError::NoStock);
    // The name of the point is not where the numbers are.
    let wrong = "(@F360|STOCK|id=box|width=100|depth=60|height=10)
(@F360|ORIGIN|type_name=topFrontLeft|x=50|y=-30|z=5)\n";
    let wrong = mill("", &format!("{wrong}{SLOT}")).expect_err("no zero");
    assert!(matches!(wrong, StockRunError::StockNotPlaced(_)), "{wrong}");
    // A zero outside of the stock, as one post writes with the wrong sign.
    let sign = format!("(STOCK/BLOCK, 100, 60, 10, -50, -30, 10)\n{SLOT}");
    let sign = mill("", &sign).expect_err("no zero");
    assert!(matches!(sign, StockRunError::StockNotPlaced(_)), "{sign}");
}

#[test]
fn a_stock_that_no_cut_meets_is_doubted() {
    let moved = SLOT.replace("X-10", "X390").replace("X110", "X510");
    let found = mill("", &format!("{BLOCK}{moved}")).expect("stock");
    assert_eq!(codes(&found.report), ["CH672", "CH673"]);
    assert_eq!(found.verdict, StockVerdict::NotProved);
}

const TURNED: &str = "G21 G18 G40 G99 G97 S800 M3
T0101
G0 X36. Z2.
G1 Z-20. F.2
G1 X42.
G0 X60. Z5.
M30
";

#[test]
fn a_bar_and_an_insert_of_comments_are_those_of_a_setup() {
    let comments = "(Zmin:-60 Zmax:0 Diametro:40)
(T1 = 80* DIAMOND, INSERT: CNMG120408, HOLDER: PCLNR2525M12, TOOL TIP: 3)\n";
    let found = turn("", &format!("{comments}{TURNED}"));
    let setup = "[stock]\nshape = 'cylinder'\ndiameter = '40 mm'\nfrom.Z = '-60 mm'\nto.Z = '0 mm'\n\
                 [tools.1]\nshape = 'insert'\ninsert = 'C'\nnose_radius = '0.8 mm'\ntip = 3\n\
                 approach_angle = '95 deg'\nflute_length = '12.89581687 mm'\n";
    let given = turn(setup, TURNED);
    let near = |one: f64, other: f64| (one - other).abs() < 1e-6;
    assert!(near(found.removed_mm3.least, given.removed_mm3.least), "{:?}", found.removed_mm3);
    // A tube from 40 to 36 mm over 20 mm, and a fillet of the nose at its end.
    let tube = std::f64::consts::PI * (20.0_f64.powi(2) - 18.0_f64.powi(2)) * 20.0;
    assert!(found.removed_mm3.most < tube && found.removed_mm3.least > 0.99 * tube);
    assert_eq!(codes(&found.report), ["CH672"]);
    assert_eq!(found.verdict, given.verdict);
}

#[test]
fn designations_of_a_setup_are_those_of_its_keys() {
    let stock =
        "[stock]\nshape = 'cylinder'\ndiameter = '40 mm'\nfrom.Z = '-60 mm'\nto.Z = '0 mm'\n";
    let short = "[tools.1]\ninsert = 'CNMG120408'\nholder_designation = 'PCLNR2525M12'\n";
    let long = "[tools.1]\nshape = 'insert'\ninsert = 'C'\nnose_radius = '0.8 mm'\ntip = 3\n\
                approach_angle = '95 deg'\nflute_length = '12.89581687 mm'\n";
    let (short, long) =
        (turn(&format!("{stock}{short}"), TURNED), turn(&format!("{stock}{long}"), TURNED));
    assert!((short.removed_mm3.least - long.removed_mm3.least).abs() < 1e-6);
    assert_eq!(short.verdict, long.verdict);
    // The tip was not given: the run says which one it took.
    let ids: Vec<&str> =
        short.report.diagnostics.iter().map(|found| found.code.info().id).collect();
    assert!(ids.contains(&"CH670"), "{ids:?}");
}

/// Pieces that comments on stock are made of.
const PIECES: [&str; 39] = [
    "STOCK/BLOCK",
    "STOCK ",
    "DX",
    "DY",
    "DZ",
    "1IN",
    "1.8N",
    "@F360|STOCK|",
    "@MKR|ORIGIN|",
    "id=box|",
    "id=cylinder|",
    "width=10|",
    "depth=5|",
    "height=2|",
    "x=-5|",
    "type_name=topFrontLeft|",
    "MATERIAL SIZE",
    ":",
    "X= 3",
    "Y4",
    "Z",
    "Z.5",
    ",",
    "10",
    "-2.5",
    "1e9",
    "WORKPIECE,BOX",
    "WORKPIECE,TUBE,AXIS=X",
    "DIAMETER=40",
    ",INNER_DIAMETER=",
    "XMIN=0",
    "ZMAX=",
    "SBOX X0 Y0 Z-20 L1 W2 H3",
    "$SETPARTSIZE(",
    "X SIZE:",
    "THICKNESS:",
    "G54 = ",
    "BACK-LEFT-TOP",
    "é",
];

proptest! {
    #[test]
    fn no_comment_ends_the_run(
        lines in proptest::collection::vec(proptest::collection::vec(0..PIECES.len(), 0..9), 0..5),
    ) {
        let mut program = String::new();
        for line in lines {
            let text: String = line.into_iter().map(|piece| PIECES[piece]).collect();
            program += &format!("({text})\n");
        }
        for machine in ["control = 'grbl'", "machine = 'fanuc-lathe'"] {
            let _ = chordal::tool_comments::commented_stock(&job(machine, &program));
        }
    }
}

#[test]
fn a_program_without_a_call_is_cut_with_the_tool_of_its_comment() {
    let found = mill("", &format!("{BLOCK}{}", SLOT.replace("T1 M6\n", ""))).expect("stock");
    assert!(found.removed_mm3.least <= 600.0 && 600.0 <= found.removed_mm3.most);
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
}

#[test]
fn a_tool_that_nothing_describes_doubts_no_stock() {
    let program = format!("{BLOCK}{}", SLOT.replace("(TOOL/MILL, 6, 0, 20, 0)\n", ""));
    let found = mill("", &program).expect("stock");
    assert_eq!(codes(&found.report), ["CH672"]);
    assert_eq!(found.verdict, StockVerdict::NotProved);
}
