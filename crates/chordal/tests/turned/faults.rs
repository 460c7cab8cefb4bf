//! Planted faults: each is found with its line and measure, and the program without it is clean.

use chordal::diagnostics::Code;
use chordal::stock::{StockVerdict, TurnedReport};

use super::{turn, turn_with};

const SETUP: &str = "
[stock]
shape = 'cylinder'
diameter = '60 mm'
from = '-100 mm'
to = '0 mm'
[tools.1]
shape = 'insert'
insert = 'C'
approach_angle = '95 deg'
flute_length = '12 mm'
nose_radius = '0.8 mm'
tip = 3
[tools.2]
shape = 'insert'
insert = 'C'
approach_angle = '95 deg'
flute_length = '6 mm'
nose_radius = '0.4 mm'
tip = 2
shank_diameter = '16 mm'
bar_offset = '9 mm'
[tools.3]
shape = 'groove'
width = '3 mm'
corner_radius = '0.2 mm'
flute_length = '15 mm'
tip = 3
[tools.4]
shape = 'drill'
diameter = '20 mm'
point_angle = '118 deg'
[tools.5]
shape = 'groove'
width = '3 mm'
corner_radius = '0.2 mm'
flute_length = '35 mm'
tip = 3
";

fn run(more: &str, blocks: &str) -> TurnedReport {
    turn(&format!("{SETUP}{more}"), &format!("G21 G18 G40 G97 G99\nS800 M3\n{blocks}M30\n"))
}

/// The first problem of a program: its code, its line and its depth.
fn problem(more: &str, blocks: &str) -> (Code, u32, f64) {
    let found = run(more, blocks);
    assert_eq!(found.verdict, StockVerdict::Problems);
    let problem = found.problems.first().expect("a problem");
    (problem.code, problem.line, problem.depth_mm.most)
}

fn is_clean(more: &str, blocks: &str) {
    let found = run(more, blocks);
    let said: Vec<String> = found
        .report
        .diagnostics
        .iter()
        .map(|each| format!("{:?} {}", each.code, each.message))
        .collect();
    assert_eq!(found.verdict, StockVerdict::Clean, "{said:#?}");
    assert!(found.problems.is_empty(), "{said:#?}");
}

fn near(found: (Code, u32, f64), code: Code, line: u32, depth: f64) {
    assert_eq!((found.0, found.1), (code, line), "{found:?}");
    assert!((found.2 - depth).abs() < 1e-6, "{found:?}, not {depth}");
}

#[test]
fn rapids_into_stock() {
    is_clean("", "T0101\nG0 X58. Z2.\nG1 Z-40. F.2\nX62.\nG0 Z2.\n");
    // From the side, 1 mm deep on the radius; and back through the shoulder.
    near(
        problem("", "T0101\nG0 X62. Z2.\nG0 X58.\nG0 Z-40.\nG0 X62.\nG0 Z2.\n"),
        Code::RapidThroughStock,
        6,
        1.0,
    );
    let found = problem("", "T0101\nG0 X58. Z2.\nG1 Z-40. F.2\nG0 X50. Z-42.\nG0 X62.\nG0 Z2.\n");
    assert_eq!((found.0, found.1), (Code::RapidThroughStock, 6));
}

#[test]
fn holders_shanks_and_reach() {
    // The holder is 3 mm left of the tip from 10 mm of radius on.
    let holder = "holder_outline = [['10 mm', '-3 mm'], ['60 mm', '-3 mm'], ['60 mm', '20 mm'], ['10 mm', '20 mm']]\n";
    let setup = SETUP.replace("tip = 3\n[tools.2]", &format!("tip = 3\n{holder}[tools.2]"));
    let go = |blocks: &str| turn(&setup, &format!("G21 G18 G40 G97 G99\nS800 M3\n{blocks}M30\n"));
    let fine = go("T0101\nG0 X42. Z2.\nG1 Z-40. F.2\nG0 X62. Z-39.\nG0 Z2.\n");
    assert_eq!(fine.verdict, StockVerdict::Clean, "{:?}", fine.problems);
    let deep =
        go("T0101\nG0 X46. Z2.\nG1 Z-40. F.2\nG0 X62. Z-39.\nG0 Z2.\nX34.\nG1 Z-40.\nG0 X80.\n");
    let first = &deep.problems[0];
    assert_eq!((first.code, first.line), (Code::HolderInStock, 9), "{:?}", deep.problems);
    // At X34 the holder begins at diameter 54, 3 mm farther left, below the surface of 60.
    assert!((first.depth_mm.most - 3.0).abs() < 1e-6, "{first:?}");
    // A bar of 16 whose middle is 9 below the tip needs a bore of more than 2·(9 + 8) − …: 20 is too small.
    let hole = "T0404\nG0 X0 Z3.\nG1 Z-60. F.1\nG0 Z3.\n";
    is_clean("", &format!("{hole}T0202\nG0 X22. Z3.\nG1 Z-5. F.1\nX19.\nG0 Z3.\n"));
    let shank = run("", &format!("{hole}T0202\nG0 X22. Z3.\nG1 Z-30. F.1\nX19.\nG0 Z3.\n"));
    assert!(shank.problems.is_empty(), "{:?}", shank.problems);
    let thick = SETUP.replace(
        "shank_diameter = '16 mm'\nbar_offset = '9 mm'",
        "shank_diameter = '20 mm'\nbar_offset = '14 mm'",
    );
    let program = format!(
        "G21 G18 G40 G97 G99\nS800 M3\n{hole}T0202\nG0 X22. Z3.\nG1 Z-30. F.1\nX19.\nG0 Z3.\nM30\n"
    );
    let found = turn(&thick, &program);
    assert_eq!(found.problems[0].code, Code::ShankInStock, "{:?}", found.problems);
    // The blade reaches 15 mm; 18 mm deep its body is in the groove.
    near(
        problem("", "T0303\nG0 X62. Z-30.\nG1 X24. F.05\nG0 X62.\n"),
        Code::DeeperThanFlutes,
        5,
        3.0,
    );
}

#[test]
fn spindle_and_fixtures() {
    near(
        problem("", "M5\nT0101\nG0 X58. Z2.\nG1 Z-10. F.2\nX62.\nG0 Z2.\n"),
        Code::CutsWithoutSpindle,
        6,
        1.0,
    );
    let jaws = "[fixtures.jaws]\nshape = 'tube'\ndiameter = '140 mm'\nbore = '60 mm'\nfrom = '-120 mm'\nto = '-70 mm'\nclearance = '2 mm'\n";
    is_clean(jaws, "T0101\nG0 X58. Z2.\nG1 Z-60. F.2\nX62.\nG0 Z2.\n");
    let found = problem(jaws, "T0101\nG0 X58. Z2.\nG1 Z-69. F.2\nX62.\nG0 Z2.\n");
    assert_eq!((found.0, found.1), (Code::FixtureHit, 5));
}

#[test]
fn grooves() {
    is_clean("", "T0303\nG0 X62. Z-23.\nG75 R.5\nG75 X40. Z-30. P3000 Q2500 F.1\nG0 X80.\n");
    // A step of 3.5 with a tool of 3 leaves ridges of 0.5.
    let found = run("", "T0303\nG0 X62. Z-23.\nG75 R.5\nG75 X40. Z-30. P3000 Q3500 F.1\nG0 X80.\n");
    let ridges: Vec<_> = found.problems.iter().map(|each| (each.code, each.line)).collect();
    assert_eq!(ridges, [(Code::GrooveRidge, 6)]);
    assert!((found.problems[0].depth_mm.most - 10.0).abs() < 1e-9, "{:?}", found.problems);
    let text = &found.report.diagnostics.last().expect("a ridge").message;
    assert!(text.contains("0.5 mm wide and 10 mm high"), "{text}");
    // The part-off stops before the axis, at it, and past it.
    near(problem("", "T0505\nG0 X62. Z-50.\nG1 X1.6 F.05\nG0 X62.\n"), Code::PartOffPip, 5, 0.8);
    let at_axis = problem("", "T0505\nG0 X62. Z-50.\nG1 X0 F.05\nG0 X62.\n");
    assert_eq!((at_axis.0, at_axis.1), (Code::PartOffPip, 5));
    // The corner of 0.2 leaves a pip as high, but for what is within a thousandth of the side.
    assert!(at_axis.2 > 0.15 && at_axis.2 <= 0.2, "{at_axis:?}");
    is_clean("", "T0505\nG0 X62. Z-50.\nG1 X-.4 F.05\nG0 X62.\n");
    let parted = run("", "T0505\nG0 X62. Z-50.\nG1 X-.4 F.05\nG0 X62.\n");
    assert_eq!(parted.loose.len(), 1);
    assert!((parted.loose[0].section.volume() - std::f64::consts::PI * 900.0 * 47.0).abs() < 1e-6);
}

#[test]
fn contours_without_compensation() {
    let long = SETUP.replace("flute_length = '12 mm'", "flute_length = '40 mm'");
    let run = |_: &str, blocks: &str| {
        turn(&long, &format!("G21 G18 G40 G97 G99\nS800 M3\n{blocks}M30\n"))
    };
    // Half of a taper of 26.565 degrees: r(cos + sin − 1) is left, 0.8 mm nose.
    let blocks = "T0101\nG0 X20. Z2.\nG1 Z-20. F.2\nX40. Z-40.\nZ-60.\nX64.\nG0 Z2.\n";
    let found = run("", blocks);
    let nose: Vec<_> = found.problems.iter().map(|each| (each.code, each.line)).collect();
    assert_eq!(nose, [(Code::NoseLeaves, 6)], "{:?}", found.problems);
    let angle = 0.5_f64.atan();
    let left = 0.8 * (angle.cos() + angle.sin() - 1.0);
    assert!((found.problems[0].depth_mm.most - left).abs() < 1e-9, "{:?}", found.problems);
    assert_eq!(found.verdict, StockVerdict::Clean, "material that is left may be an allowance");
    let with = run(
        "",
        "T0101\nG0 X14. Z5.\nG42 G1 X20. Z2. F.2\nZ-20.\nX40. Z-40.\nZ-60.\nX64.\nG40 X70. Z-55.\nG0 Z5.\n",
    );
    assert!(with.problems.is_empty(), "{:?}", with.problems);
    // Down a slope of 3 degrees, which the insert can just follow, the nose cuts below the contour.
    let end = 47.904;
    let slope = (0.5 * (50.0 - end) / 20.0_f64).atan();
    let down = format!("T0101\nG0 X50. Z2.\nG1 Z-20. F.2\nX{end} Z-40.\nX64.\nG0 Z2.\n");
    let found = run("", &down);
    let gouge = found.problems.iter().find(|each| each.code == Code::NoseGouge).expect("a gouge");
    assert_eq!(gouge.line, 6);
    assert!(
        (gouge.depth_mm.most - 0.8 * (1.0 - slope.cos() + slope.sin())).abs() < 1e-9,
        "{gouge:?}"
    );
    // Down 30 degrees the flank, which is free by 5, cuts into the cylinder before.
    let steep = "T0101\nG0 X50. Z2.\nG1 Z-20. F.2\nX38.4530 Z-30.\nX64.\nG0 Z2.\n";
    let found = run("", steep);
    let flank = found.problems.iter().find(|each| each.code == Code::FlankGouge).expect("a flank");
    assert_eq!(flank.line, 6);
    // The flank rises by tan 5° from its nose at the lower end: 4.9 mm below the cylinder at its end.
    assert!(flank.depth_mm.most > 4.5 && flank.depth_mm.most < 5.2, "{flank:?}");
}

#[test]
fn targets() {
    let target = "
[target]
shape = 'contour'
contour = [['20 mm', '0 mm'], ['20 mm', '-20 mm'], ['40 mm', '-35 mm'], ['40 mm', '-50 mm'], ['60 mm', '-50 mm'], ['60 mm', '-60 mm']]
tolerance = '0.02 mm'
";
    let tools = SETUP.replace(
        "insert = 'C'\napproach_angle = '95 deg'\nflute_length = '12 mm'\nnose_radius = '0.8 mm'",
        "insert = 'S'\napproach_angle = '90 deg'\nflute_length = '50 mm'\nnose_radius = '0 mm'",
    );
    let program = |x: &str| {
        format!(
            "G21 G18 G40 G97 G99\nS800 M3\nT0101\nG0 X20. Z2.\nG1 Z-20. F.2\nX40. Z-35.\nX{x} Z-50.\nX62.\nG0 Z2.\nM30\n"
        )
    };
    let found = turn(&format!("{tools}{target}"), &program("40."));
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.problems);
    let on_part = found.target.expect("a target");
    assert!(on_part.left_over_mm3.abs() < 1e-6 && on_part.gouged_mm3.abs() < 1e-6, "{on_part:?}");
    let found = turn(&format!("{tools}{target}"), &program("39.8"));
    let gouge = found.problems.iter().find(|each| each.code == Code::Gouge).expect("a gouge");
    assert_eq!(gouge.line, 7);
    assert!((gouge.depth_mm.most - 0.1).abs() < 1e-6, "{gouge:?}");
    let found = turn(&format!("{tools}{target}"), &program("40.2"));
    let left = found.target.expect("a target");
    // It grows to 0.1 at the shoulder, which is as near there.
    assert!(left.highest_mm > 0.09 && left.highest_mm < 0.1, "{left:?}");
    assert!(found.problems.iter().any(|each| each.code == Code::MaterialLeft));
    // The same part as a drawing: what a run left, as DXF.
    let drawing = "
[target]
shape = 'dxf'
file = 'part.dxf'
";
    let dxf = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n90\n6\n70\n0\n10\n0\n20\n10\n10\n-20\n20\n10\n10\n-35\n20\n20\n10\n-50\n20\n20\n10\n-50\n20\n30\n10\n-60\n20\n30\n0\nLINE\n10\n-60\n20\n30\n11\n-60\n21\n0\n0\nLINE\n10\n0\n20\n10\n11\n0\n21\n0\n0\nENDSEC\n0\nEOF\n";
    let files = |name: &str| match name {
        "part.dxf" => Ok(dxf.as_bytes().to_vec()),
        _ => Err("not there".to_string()),
    };
    let found = turn_with(&format!("{tools}{drawing}"), &program("40."), &files);
    let on_part = found.target.expect("a target");
    assert!(on_part.left_over_mm3.abs() < 1e-6 && on_part.gouged_mm3.abs() < 1e-6, "{on_part:?}");
}

#[test]
fn what_is_not_followed_is_not_proved() {
    let found = run("", "T0909\nG0 X58. Z2.\nG1 Z-40. F.2\nG0 X62.\n");
    let messages: Vec<_> = found.report.diagnostics.iter().map(|each| &each.message).collect();
    assert_eq!(found.verdict, StockVerdict::NotProved, "{messages:?}");
    let codes: Vec<Code> = found.report.diagnostics.iter().map(|each| each.code).collect();
    assert!(codes.contains(&Code::ToolWithoutShape), "{codes:?}");
    // A drill beside the axis.
    let found = run("", "T0404\nG0 X10. Z2.\nG1 Z-10. F.1\n");
    assert_eq!(found.verdict, StockVerdict::NotProved);
}

#[test]
fn threads_are_between_nothing_and_all() {
    let tool = "[tools.7]\nshape = 'insert'\ninsert_angle = '60 deg'\nflute_length = '14 mm'\nnose_radius = '0.2 mm'\npitch = '3 mm'\ntip = 8\n";
    let blocks =
        "T0707\nG0 X64. Z6.\nG76 P020060 Q100 R0.05\nG76 X56.32 Z-26. P1840 Q500 F3.\nG0 X80.\n";
    let found = run(tool, blocks);
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.problems);
    assert_eq!(found.removed_mm3.least, 0.0);
    assert!(found.removed_mm3.most > 0.0);
    assert_eq!(found.threads.len(), 1);
    assert_eq!(found.section.volume(), found.before_mm3);
}

/// The volume of a ring whose section is a triangle from the surface of radius 30 down, with an angle of 60 degrees.
fn ring(depth: f64) -> f64 {
    let area = depth.powi(2) * 30.0_f64.to_radians().tan();
    // By Pappus: the middle of a triangle is a third below its base.
    2.0 * std::f64::consts::PI * (30.0 - depth / 3.0) * area
}

#[test]
fn a_thread_removes_its_groove_at_most() {
    // From Z0 to Z-30 with lead 3 the groove goes round ten times; where it runs in, as much is missing before the face
    // as there is after it.
    let found = run(SHARP, "T0707\nG0 X57. Z3.\nG32 Z-30. F3.\nG0 X80.\n");
    let by_hand = 10.0 * ring(1.5);
    let most = found.removed_mm3.most;
    assert!(most > by_hand && most < 1.04 * by_hand, "{most} and {by_hand} mm3");
    assert_eq!(found.removed_mm3.least, 0.0);
    let tool = found.tools.first().expect("a tool");
    assert!((tool.removed_mm3.most - most).abs() < 1e-6, "{tool:?}");
    // Further passes in the same groove add nothing but their own depth.
    let passes = "T0707\nG0 X59. Z3.\nG32 Z-30. F3.\nG0 X80.\nZ6.\nX58.\nG32 Z-30. F3.\nG0 X80.\nZ9.\nX57.\nG32 Z-30. F3.\nG0 X80.\n";
    let deeper = run(SHARP, passes);
    assert!((deeper.removed_mm3.most - most).abs() < 0.01 * most, "{}", deeper.removed_mm3.most);
    // Two starts are two grooves, which do not meet with a lead of 6.
    let starts = "T0707\nG0 X57. Z6.\nG32 Z-30. F6.\nG0 X80.\nZ9.\nX57.\nG32 Z-30. F6.\nG0 X80.\n";
    let double = run(SHARP, starts).removed_mm3.most;
    assert!(double > by_hand && double < 1.08 * by_hand, "{double} and {by_hand} mm3");
}

#[test]
fn a_thread_on_a_taper_removes_its_groove_at_most() {
    // 1 : 16 on the diameter along a bar of radius 30: the depth grows from 0.6 to 1.5 where it is cut, from Z0 to Z-30.
    let found = run(SHARP, "T0707\nG0 X58.98 Z3.\nG32 X57. Z-30. F3.\nG0 X80.\n");
    let depth = |z: f64| 0.51 + 0.99 * (3.0 - z) / 33.0;
    // Simpson's rule over the ten revolutions; the middle of the V is where the tool is.
    let steps = 1000;
    let by_hand: f64 = (0..=steps)
        .map(|at| {
            let weight = if at == 0 || at == steps { 1.0 } else { 2.0 + 2.0 * f64::from(at % 2) };
            weight * ring(depth(-30.0 * f64::from(at) / f64::from(steps)))
        })
        .sum::<f64>()
        * 10.0
        / (3.0 * f64::from(steps));
    let most = found.removed_mm3.most;
    assert!(most > 0.99 * by_hand && most < 1.08 * by_hand, "{most} and {by_hand} mm3");
}

/// A threading tool with an ideal point.
const SHARP: &str = "[tools.7]\nshape = 'insert'\ninsert_angle = '60 deg'\nflute_length = '14 mm'\nnose_radius = '0 mm'\npitch = '3 mm'\ntip = 8\n";

#[test]
fn a_thread_cuts_the_section_once_in_each_revolution() {
    // From Z3 with lead 3: at Z0, where the face halves it, and at Z-3 to Z-30; a triangle 1.5 deep of 60 degrees is
    // 1.5² tan 30° large.
    let found = run(SHARP, "T0707\nG0 X57. Z3.\nG32 Z-30. F3.\nG0 X80.\n");
    let thread = found.threads.first().expect("a thread");
    let grooves = thread.grooves.as_ref().expect("grooves");
    let one = 1.5_f64.powi(2) * 30.0_f64.to_radians().tan();
    assert!((grooves.area() - 10.5 * one).abs() < 1e-9, "{}", grooves.area());
    assert!((thread.lead_mm.expect("a lead") - 3.0).abs() < 1e-9);
    let cut: f64 = found.threaded_sections().iter().map(|section| section.area()).sum();
    assert!((found.section.area() - cut - 10.5 * one).abs() < 1e-9);
    // Their bottoms: radius 28.5 at every third millimetre.
    let bottoms =
        grooves.shape().into_iter().flatten().filter(|edge| (edge.start.b - 28.5).abs() < 1e-9);
    let mut bottoms: Vec<i64> =
        bottoms.map(|edge| (edge.start.a * 1000.0).round() as i64).collect();
    bottoms.sort_unstable();
    assert_eq!(bottoms, (0..=10).map(|turn| -30_000 + 3_000 * turn).collect::<Vec<_>>());
}

#[test]
fn grooves_of_a_lead_that_grows_lie_farther_and_farther_apart() {
    // After n revolutions the tool has advanced by 2 n + 0.25 n².
    let found = run(SHARP, "T0707\nG0 X57. Z3.\nG34 Z-32. F2. K.5\nG0 X80.\n");
    let thread = found.threads.first().expect("a thread");
    assert_eq!(thread.lead_mm, None);
    let grooves = thread.grooves.as_ref().expect("grooves");
    let edges = grooves.shape().into_iter().flatten();
    let bottoms = edges.filter(|edge| (edge.start.b - 28.5).abs() < 1e-9);
    let mut bottoms: Vec<i64> =
        bottoms.map(|edge| (edge.start.a * 1000.0).round() as i64).collect();
    bottoms.sort_unstable();
    assert_eq!(bottoms, [-29_000, -23_250, -18_000, -13_250, -9_000, -5_250, -2_000]);
    // One that falls: 3 n - 0.1 n².
    let found = run(SHARP, "T0707\nG0 X57. Z3.\nG34 Z-18. F3. K-.2\nG0 X80.\n");
    let grooves = found.threads[0].grooves.as_ref().expect("grooves");
    let edges = grooves.shape().into_iter().flatten();
    let bottoms = edges.filter(|edge| (edge.start.b - 28.5).abs() < 1e-9);
    let mut bottoms: Vec<i64> =
        bottoms.map(|edge| (edge.start.a * 1000.0).round() as i64).collect();
    bottoms.sort_unstable();
    let meant: Vec<i64> = (2..=11).rev().map(|n| 3_000 - (3_000 * n - 100 * n * n)).collect();
    assert_eq!(bottoms, meant);
}

#[test]
fn passes_of_a_thread_cut_one_groove_deeper() {
    // The second pass begins one lead farther out: at the same places.
    let blocks = "T0707\nG0 X58. Z3.\nG32 Z-30. F3.\nG0 X80.\nZ6.\nX57.\nG32 Z-30. F3.\nG0 X80.\n";
    let found = run(SHARP, blocks);
    assert_eq!(found.threads.len(), 1);
    let grooves = found.threads[0].grooves.as_ref().expect("grooves");
    let one = 1.5_f64.powi(2) * 30.0_f64.to_radians().tan();
    assert!((grooves.area() - 10.5 * one).abs() < 1e-9, "{}", grooves.area());
    // A start that is not a whole lead away cuts a thread of its own in between.
    let blocks = blocks.replace("Z6.", "Z4.5");
    let found = run(SHARP, &blocks);
    let grooves = found.threads[0].grooves.as_ref().expect("grooves");
    let first = 1.0_f64.powi(2) * 30.0_f64.to_radians().tan();
    // Ten and a half of the first pass, and ten of the second at Z-1.5 to Z-28.5, which do not meet them.
    let whole = 10.5 * first + 10.0 * one;
    assert!((grooves.area() - whole).abs() < 1e-9, "{} {whole}", grooves.area());
}

#[test]
fn what_is_milled_on_a_face_is_not_proved() {
    let axis = "[axes.C]\nmax_velocity = '36000 deg/min'\n";
    let found =
        run(axis, "T0404\nG0 X40. Z2. C0\nG12.1\nG1 X30. F1.\nC5.\nX-30.\nC0\nG13.1\nG0 X70.\n");
    assert_eq!(found.verdict, StockVerdict::NotProved, "{:?}", found.report.diagnostics);
    let said = found.report.diagnostics.iter().any(|each| {
        each.code == Code::StockNotFollowed && each.message.contains("polar or cylindrical")
    });
    assert!(said, "{:?}", found.report.diagnostics);
}
