//! Stock with a tool whose direction turns under tool centre point control: volumes by hand, planted touches, clearance.

use std::f64::consts::PI;

use chordal::stock::{StockOptions, StockReport, StockVerdict};
use chordal::{Job, Machine, Source, SourceMap};

/// A block on the tables of a trunnion, and a flat end mill of radius 3.
const TRUNNION: &str = r#"
machine = "fanuc-ac-trunnion"
[rotary.A]
point = { Y = "-200 mm", Z = "-400 mm" }
[rotary.C]
point = { X = "-300 mm", Y = "-200 mm" }
[work_offsets.G54]
X = "-300 mm"
Y = "-200 mm"
Z = "-380 mm"
[stock]
shape = "box"
from = { X = "-20 mm", Y = "-20 mm", Z = "-30 mm" }
to = { X = "20 mm", Y = "20 mm", Z = "0 mm" }
[tools.1]
shape = "flat"
diameter = "6 mm"
length = "100 mm"
flute_length = "25 mm"
"#;

fn run_at(resolution: f64, setup: &str, blocks: &str) -> StockReport {
    let program = format!(
        "O1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X0. Y0. C0.\nG43.4 H1 Z50.\n{blocks}G49\nM30\n"
    );
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("setup.toml", setup, &none).expect("a good setup");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.into_bytes()));
    let job = Job::new(sources, machine).expect("settings of the control");
    let options = StockOptions { resolution_mm: Some(resolution), ..StockOptions::default() };
    job.stock(&options, &|name| Err(format!("no file {name}"))).expect("stock")
}

fn run(setup: &str, blocks: &str) -> StockReport {
    run_at(0.4, setup, blocks)
}

fn codes(found: &StockReport) -> Vec<&'static str> {
    found.report.diagnostics.iter().map(|each| each.code.info().id).collect()
}

#[test]
fn a_tool_that_leans_to_both_sides_about_its_tip() {
    // The tip 10 mm deep, leaning 20 degrees to both sides. At the half width w of the tool in a plane of the turn, the
    // sides of the tool at both ends enclose, up to the top, d² tan + 2wd/cos, and below the tip w² tan.
    let (radius, depth, angle) = (3.0_f64, 10.0_f64, 20_f64.to_radians());
    let truth = angle.tan() * (4.0 / 3.0 * radius.powi(3) + 2.0 * radius * depth * depth)
        + PI * radius * radius * depth / angle.cos();
    let blocks = "G0 Z2.\nG1 Z-10. F600.\nA20.\nA-20.\nA0.\nG0 Z50.\n";
    let mut last = f64::INFINITY;
    for resolution in [0.8, 0.4, 0.2] {
        let found = run_at(resolution, TRUNNION, blocks);
        assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
        let removed = found.removed_mm3;
        assert!(removed.least <= truth && truth <= removed.most, "{truth} {removed:?}");
        let gap = removed.most - removed.least;
        assert!(gap < 0.75 * last, "{truth} {removed:?}");
        last = gap;
    }
    assert!(last < 0.2 * truth, "{last} {truth}");
}

#[test]
fn a_head_leans_the_tool_as_a_table_leans_the_part() {
    let setup = TRUNNION
        .replace("fanuc-ac-trunnion", "fanuc-head-table")
        .replace("[rotary.A]\npoint = { Y = \"-200 mm\", Z = \"-400 mm\" }\n", "");
    let (depth, angle) = (10.0_f64, 20_f64.to_radians());
    let truth = angle.tan() * (4.0 / 3.0 * 27.0 + 2.0 * 3.0 * depth * depth)
        + PI * 9.0 * depth / angle.cos();
    let found = run(&setup, "G0 Z2.\nG1 Z-10. F600.\nB20.\nX0.\nB-20.\nB0.\nG0 Z50.\n");
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
    let removed = found.removed_mm3;
    assert!(removed.least <= truth && truth <= removed.most, "{truth} {removed:?}");
    assert!(removed.most - removed.least < 0.35 * truth, "{removed:?}");
}

#[test]
fn axes_that_are_not_known_are_not_followed() {
    let setup = TRUNNION.replace("fanuc-ac-trunnion", "linuxcnc-mill");
    let setup = format!("{setup}[axes.A]\n[axes.C]\n");
    let found = run(&setup, "G1 X10. A20. F600.\n");
    assert_ne!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
}

#[test]
fn a_shank_and_a_fixture_are_found_and_missed() {
    // The tool comes down beside the block and leans 40 degrees over its edge, with its tip 12 mm deep: edges of 6 mm end
    // inside of the block, those of 25 mm do not.
    let blocks = "G0 Y26. Z10.\nG1 Z-12. F600.\nY19. A40.\nY26. A0.\nG0 Z40.\n";
    let long = run(TRUNNION, blocks);
    assert_eq!(long.verdict, StockVerdict::Clean, "{:?}", long.report.diagnostics);
    let short = TRUNNION.replace("flute_length = \"25 mm\"", "flute_length = \"6 mm\"");
    let short = run(&short, blocks);
    assert_eq!(short.verdict, StockVerdict::Problems, "{:?}", short.report.diagnostics);
    assert!(codes(&short).contains(&"CH621"), "{:?}", short.report.diagnostics);
    let jaw = |from: f64| {
        format!(
            "{TRUNNION}[fixtures.jaw]\nshape = \"box\"\nfrom = {{ X = \"-20 mm\", Y = \"{from} mm\", Z = \"0 mm\" }}\n\
             to = {{ X = \"20 mm\", Y = \"{} mm\", Z = \"8 mm\" }}\n",
            from + 5.0
        )
    };
    let near = run(&jaw(0.0), blocks);
    assert!(codes(&near).contains(&"CH624"), "{:?}", near.report.diagnostics);
    let far = run(&jaw(-12.0), blocks);
    assert_eq!(far.verdict, StockVerdict::Clean, "{:?}", far.report.diagnostics);
}

#[test]
fn a_gouge_while_the_tool_turns_is_found() {
    let target = "[target]\nshape = \"box\"\nfrom = { X = \"-20 mm\", Y = \"-20 mm\", Z = \"-30 mm\" }\n\
                  to = { X = \"20 mm\", Y = \"20 mm\", Z = \"-5 mm\" }\n";
    let setup = format!("{TRUNNION}{target}");
    // Leaning 20 degrees, the edge of the tool is 3 sin 20° = 1.03 mm below its tip.
    let at = |z: &str| format!("G0 Z2.\nG1 Z{z} F600.\nA20.\nA-20.\nA0.\nG0 Z50.\n");
    let clean = run(&setup, &at("-3.9"));
    assert_eq!(clean.verdict, StockVerdict::Clean, "{:?}", clean.report.diagnostics);
    let gouged = run(&setup, &at("-4.5"));
    assert_eq!(gouged.verdict, StockVerdict::Problems, "{:?}", gouged.report.diagnostics);
    assert!(codes(&gouged).contains(&"CH626"), "{:?}", gouged.report.diagnostics);
}

#[test]
fn a_planted_rapid_through_the_stock_is_found() {
    let found = run(TRUNNION, "G0 Y-60. Z40.\nY30. Z-8. A30.\nZ50.\n");
    assert_eq!(found.verdict, StockVerdict::Problems, "{:?}", found.report.diagnostics);
    let hit = &found.problems[0];
    assert_eq!(hit.code.info().name, "rapid-through-stock");
    assert_eq!(hit.line, 8);
    assert!(hit.depth_mm.least > 1.0 && hit.depth_mm.least <= hit.depth_mm.most, "{hit:?}");
}

#[test]
fn the_same_rapid_with_clearance_is_clean() {
    let found = run(TRUNNION, "G0 Y-60. Z40.\nY30. Z3. A30.\nZ50.\n");
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
    assert!(!codes(&found).contains(&"CH630"));
}
