//! The stock of a page: its frames reproduce the stock of a direct run, forward and backward.

use chordal::stock::{ColumnDrop, ReplayOptions, ReplaySink, StockBefore};
use chordal::{Job, Machine, Source, SourceMap};

use crate::common::{Columns, Live, PageMessage, Shown, serve};

const SETUP: &str = r#"
machine = "haas-vf2"
[settings]
tool_lengths = "touched-off"
[stock]
shape = "box"
from = { X = "0 mm", Y = "0 mm", Z = "-20 mm" }
to = { X = "60 mm", Y = "40 mm", Z = "0 mm" }
[target]
shape = "box"
from = { X = "0 mm", Y = "0 mm", Z = "-20 mm" }
to = { X = "60 mm", Y = "40 mm", Z = "-3 mm" }
[fixtures.jaw]
shape = "box"
from = { X = "0 mm", Y = "40 mm", Z = "-30 mm" }
to = { X = "60 mm", Y = "60 mm", Z = "-10 mm" }
[tools.1]
shape = "flat"
diameter = "10 mm"
flute_length = "25 mm"
teeth = 2
max_chip = "0.05 mm"
[tools.2]
shape = "ball"
diameter = "8 mm"
flute_length = "20 mm"
"#;

/// A pocket and an arc with two tools; line 9 is the first of the second tool, line 13 is a rapid through the part.
const FIRST: &str =
    "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X10. Y10. Z5.\nG1 Z-4. F200.\nX50. F600.\nY30.\nG0 Z20.\n";
const SECOND: &str =
    "T2 M6\nG0 X30. Y10.\nG1 Z-3. F200.\nG3 X30. Y30. I0 J10. F500.\nG0 X5.\nZ20.\nM30\n";

fn whole() -> String {
    [FIRST, SECOND].concat()
}

/// The stock as a page stores it.
struct Page {
    stock: Columns,
    drops: Vec<ColumnDrop>,
}

fn gather(live: &mut Live) -> Page {
    let stock = live.columns("stock");
    let mut drops = Vec::new();
    loop {
        let some = live.columns("stock_drops");
        let (columns, rows) = (some.u32("column"), some.u32("row"));
        let (shares, heights) = (some.f32("share"), some.f32("height"));
        for (at, &column) in columns.iter().enumerate() {
            let (row, share, height) = (rows[at], shares[at], heights[at]);
            drops.push(ColumnDrop { column, row, share, height });
        }
        if some.header["progress"] == 1.0 {
            return Page { stock, drops };
        }
    }
}

/// A direct run of a program: the stock before and after.
fn direct(program: &str, columns: u32) -> (StockBefore, Vec<f32>) {
    struct Before(Option<StockBefore>);
    impl ReplaySink for Before {
        fn before(&mut self, stock: &StockBefore) {
            self.0 = Some(stock.clone());
        }
        fn lowered(&mut self, _drops: &[ColumnDrop], _progress: f64) -> bool {
            true
        }
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.as_bytes().to_vec()));
    let no_text = |name: &str| Err(format!("no file {name}"));
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("setup.toml", SETUP, &no_text).unwrap();
    let job = Job::new(sources, machine).unwrap();
    let mut before = Before(None);
    let stock = job
        .replay_stock(&ReplayOptions { columns, lag: 0.0 }, &none, &mut before)
        .unwrap()
        .unwrap();
    let top = stock.grid().bounds().max.z;
    let left = stock.height_pairs().iter().map(|at| (at.outer - top) as f32).collect();
    (before.0.unwrap(), left)
}

#[test]
fn the_frames_give_the_stock_of_a_direct_run_forward_and_backward() {
    let mut live = serve(Shown::text(&whole()).set_up(SETUP)).live();
    let lines = live.columns("path").u32("line");
    let Page { stock, drops } = gather(&mut live);
    let (before, left) = direct(&whole(), 250_000);
    assert_eq!(stock.f32("heights"), before.heights);
    assert_eq!(stock.header["cells"], serde_json::json!(before.columns));
    assert_eq!(stock.f32("target"), before.target.unwrap().0);
    // Forward: to the tool change, where a program that ends there has the same stock, and to the end.
    let second = lines.iter().position(|line| *line >= 9).unwrap() as u32;
    let mut now = stock.f32("heights");
    let mut undo = Vec::new();
    let mut at_change = None;
    for drop in &drops {
        if drop.row >= second && at_change.is_none() {
            at_change = Some(now.clone());
        }
        let column = drop.column as usize;
        undo.push((drop.row, column, now[column]));
        now[column] = drop.height;
    }
    let (_, left_by_first) = direct(&[FIRST, "M30\n"].concat(), 250_000);
    assert!(left_by_first != left && left_by_first != before.heights);
    assert!(at_change.unwrap() == left_by_first);
    assert!(now == left);
    // Backward: to the tool change and to the uncut stock.
    for (row, column, height) in undo.into_iter().rev() {
        if row < second && !now.is_empty() && now != left_by_first {
            panic!("after the second tool is undone the stock is another");
        }
        if row < second {
            break;
        }
        now[column] = height;
    }
    assert!(now == left_by_first);
}

#[test]
fn what_is_touched_comes_with_its_line_and_the_other_problems() {
    let mut live = serve(Shown::text(&whole()).set_up(SETUP)).live();
    let report = live.json("stock_report");
    assert_eq!((&report["verdict"], &report["run"]), (&"problems".into(), &1.into()));
    let problems = report["diagnostics"].as_array().unwrap();
    let rapid = problems.iter().find(|problem| problem["code"] == "CH620").unwrap();
    assert_eq!((&rapid["place"]["line"], &rapid["place"]["own"]), (&13.into(), &true.into()));
    // The first tool cuts 1 mm into the target.
    assert!(problems.iter().any(|problem| problem["code"] == "CH626"));
    assert!(report["removed_mm3"]["least"].as_f64().unwrap() > 1000.0);
}

#[test]
fn the_page_may_request_other_columns_and_an_edit_starts_again() {
    let mut live = serve(Shown::text(&whole()).set_up(SETUP)).live();
    let usual = gather(&mut live).stock;
    live.json("stock_report");
    live.send(r#"{"request":"stock","columns":10000}"#);
    let coarse = gather(&mut live).stock;
    let (before, _) = direct(&whole(), 10_000);
    assert_eq!(coarse.f32("heights"), before.heights);
    let cells = |stock: &Columns| stock.f32("heights").len();
    assert!(cells(&coarse) <= 10_000 && cells(&usual) <= 250_000 && cells(&usual) > 200_000);
    live.json("stock_report");
    // Another digit of the feed gives the same stock in another run.
    live.send(r#"{"request":"edit","changes":[{"from":0,"to":0,"insert":"(NEW)\n"}]}"#);
    assert_eq!(gather(&mut live).stock.header["run"], 2);
}

#[test]
fn gaps_of_undercuts_come_with_their_moments() {
    let setup = "machine = \"haas-vf2\"\n[settings]\ntool_lengths = \"touched-off\"\n[stock]\nshape = \"box\"\n\
                 from = { X = \"0 mm\", Y = \"-30 mm\", Z = \"-20 mm\" }\n\
                 to = { X = \"100 mm\", Y = \"30 mm\", Z = \"0 mm\" }\n\
                 [tools.1]\nshape = \"flat\"\ndiameter = \"10 mm\"\nflute_length = \"25 mm\"\n\
                 [tools.2]\nshape = \"t-slot\"\ndiameter = \"20 mm\"\nflute_length = \"4 mm\"\n\
                 shank_diameter = \"9 mm\"\n";
    let pass = |tool: u32| {
        format!("T{tool} M6\nS900 M3\nG0 X-20. Y0. Z5.\nZ-12.\nG1 X120. F600.\nG0 Z20.\n")
    };
    let program = format!("G21 G90 G17\n{}{}M30\n", pass(1), pass(2));
    let mut live = serve(Shown::text(&program).set_up(setup)).live();
    let lines = live.columns("path").u32("line");
    let stock = live.columns("stock");
    let cells = &stock.header["cells"];
    let side = stock.header["resolution_mm"].as_f64().unwrap();
    let found = live.columns("stock_gaps");
    let (columns, rows, counts) = (found.u32("column"), found.u32("row"), found.u32("count"));
    let (shares, gaps) = (found.f32("share"), found.f32("gaps"));
    // Next to the slot, 8 mm from its middle: from 12 to 8 mm below the top, later the farther along the slot.
    let across = cells[0].as_u64().unwrap();
    let row = ((8.0 + 30.0) / side) as u64;
    let mut at = 0;
    let mut types: Vec<(u64, f32)> = Vec::new();
    for (n, column) in columns.iter().enumerate() {
        let own = &gaps[at..at + 2 * counts[n] as usize];
        at += own.len();
        assert_eq!(lines[rows[n] as usize], 12);
        if u64::from(*column) / across == row && !own.is_empty() {
            assert!((own[0] + 12.0).abs() < 0.01 && (own[1] + 8.0).abs() < 0.01, "{own:?}");
            types.push((u64::from(*column) % across, shares[n]));
        }
    }
    assert_eq!(at, gaps.len());
    assert!(types.len() as u64 >= across - 2, "{} of {across}", types.len());
    assert!(shares.windows(2).all(|pair| pair[0] <= pair[1]));
    let [(first, early), (last, late)] = [types[0], types[types.len() - 1]];
    assert!(first < last && early < 0.2 && late > 0.7, "{early} {late}");
}

#[test]
fn without_stock_and_with_a_wrong_setup_the_reason_is_reported() {
    let mut live = serve(Shown::text(&whole())).live();
    let received = live.json("no_stock");
    assert_eq!(received["message"], serde_json::Value::Null);
    let wrong = "machine = \"haas-vf2\"\n[stock]\nshape = \"stl\"\nfile = \"lost.stl\"\n";
    let mut live = serve(Shown::text(&whole()).set_up(wrong)).live();
    let received = live.json("no_stock");
    assert!(received["message"].as_str().unwrap().contains("lost.stl"), "{received}");
    assert!(received["help"].is_string());
    // The path is sent nevertheless.
    live.send(r#"{"id":1,"request":"outline"}"#);
    assert!(matches!(live.next(), PageMessage::Json(_) | PageMessage::Columns(_)));
}

#[test]
fn fixtures_and_how_hard_the_cuts_are_come_with_it() {
    let mut live = serve(Shown::text(&whole()).set_up(SETUP)).live();
    let lines = live.columns("path").u32("line");
    let stock = live.columns("stock");
    assert_eq!(stock.header["fixtures"], serde_json::json!(["jaw"]));
    let corners = stock.f32("fixtures");
    assert_eq!(corners.len(), 12 * 9);
    assert!(corners.chunks(3).all(|at| (40.0..=60.0).contains(&at[1])));
    let found = live.columns("engagement");
    let (rows, radial, chips) = (found.u32("row"), found.f32("radial"), found.f32("chip"));
    // 600 mm/min, 5000 rev/min, two teeth: 0.06 mm per tooth at the full width of the tool.
    let at = rows.iter().position(|row| lines[*row as usize] == 6).expect("the slot");
    assert!((radial[at] - 10.0).abs() < 0.3 && (chips[at] - 0.06).abs() < 1e-4);
    assert_eq!(found.u8("problem")[at], 1);
    // The number of teeth of the ball cutter is unknown.
    let ball = rows.iter().position(|row| lines[*row as usize] == 12).expect("the arc");
    assert!(chips[ball] < 0.0 && radial[ball] > 0.0 && found.u8("problem")[ball] == 0);
}
