//! Thirty programs whose removed volume and profile have a closed form, within 1e-9 of them.

use std::f64::consts::PI;

use super::{corners, turn};

/// A bar of 60 with its face at Z0, and an ideal point for each direction: T1 outside, T2 in a bore, T4 slim.
const BAR: &str = "
[stock]
shape = 'cylinder'
diameter = '60 mm'
from = '-100 mm'
to = '0 mm'
";

const TOOLS: &str = "
[tools.1]
shape = 'insert'
insert = 'S'
approach_angle = '90 deg'
flute_length = '150 mm'
nose_radius = '0 mm'
tip = 3
[tools.2]
shape = 'insert'
insert = 'S'
approach_angle = '90 deg'
flute_length = '9 mm'
nose_radius = '0 mm'
tip = 2
[tools.3]
shape = 'groove'
width = '3 mm'
flute_length = '40 mm'
tip = 3
[tools.4]
shape = 'insert'
insert = 'V'
approach_angle = '90 deg'
flute_length = '100 mm'
nose_radius = '0 mm'
tip = 3
[tools.5]
shape = 'drill'
diameter = '20 mm'
point_angle = '180 deg'
[tools.6]
shape = 'drill'
diameter = '20 mm'
point_angle = '118 deg'
[tools.7]
shape = 'groove'
width = '4 mm'
flute_length = '8 mm'
tip = 2
[tools.8]
shape = 'groove'
width = '3 mm'
flute_length = '20 mm'
tip = 3
facing = 'face'
[tools.9]
shape = 'insert'
insert = 'S'
approach_angle = '90 deg'
flute_length = '150 mm'
nose_radius = '0.8 mm'
tip = 3
[tools.10]
shape = 'insert'
insert = 'R'
nose_radius = '5 mm'
tip = 8
";

const HEAD: &str = "G21 G18 G40 G97 G99\nS800 M3\n";
const SHAFT: &str = "N10 G0 X20.\nG1 Z-20.\nX40. Z-35.\nZ-50.\nN50 X62.\n";

fn cylinder(diameter: f64, length: f64) -> f64 {
    PI / 4.0 * diameter * diameter * length
}

fn ring(inner: f64, outer: f64, length: f64) -> f64 {
    cylinder(outer, length) - cylinder(inner, length)
}

fn cone(d0: f64, d1: f64, length: f64) -> f64 {
    PI / 12.0 * (d0 * d0 + d0 * d1 + d1 * d1) * length
}

/// What an area makes whose centroid turns on a diameter (Pappus).
fn turned(area: f64, diameter: f64) -> f64 {
    PI * diameter * area
}

/// What a round corner leaves of a square one: its area, and how far its centroid is from the sharp corner.
fn corner(radius: f64) -> (f64, f64) {
    ((1.0 - PI / 4.0) * radius * radius, (10.0 - 3.0 * PI) / (12.0 - 3.0 * PI) * radius)
}

/// Runs blocks with a tool on a setup, and compares what goes and the corners of what is left.
fn removes(name: &str, setup: &str, blocks: &str, wanted: f64, profile: &[(f64, f64)]) {
    let program = format!("{HEAD}{blocks}M30\n");
    let found = turn(&format!("{setup}{TOOLS}"), &program);
    let said: Vec<&String> = found.report.diagnostics.iter().map(|each| &each.message).collect();
    assert!(found.problems.is_empty(), "{name}: {said:?}");
    let amount = found.removed_mm3;
    assert!(
        (amount.least - wanted).abs() <= 1e-9 * wanted,
        "{name}: {} for {wanted}",
        amount.least
    );
    assert_eq!(amount.least, amount.most, "{name}");
    let by_tool: f64 = found.tools.iter().map(|tool| tool.removed_mm3.most).sum();
    assert!((by_tool - wanted).abs() <= 1e-9 * wanted, "{name}: {by_tool} by tool");
    let mut profile = profile.to_vec();
    profile.sort_by(|x, y| x.partial_cmp(y).expect("numbers"));
    let corners = corners(&found);
    let same = |(a, b): (&(f64, f64), &(f64, f64))| {
        (a.0 - b.0).abs() <= 1e-9 * 60.0 && (a.1 - b.1).abs() <= 1e-9 * 60.0
    };
    let is_same = corners.len() == profile.len() && corners.iter().zip(&profile).all(same);
    assert!(is_same, "{name}:\n{corners:?}\nfor\n{profile:?}");
}

/// The profile of a bar's left end and the corners of its right one.
fn bar_with(right: &[(f64, f64)]) -> Vec<(f64, f64)> {
    [(0.0, -100.0), (60.0, -100.0)].into_iter().chain(right.iter().copied()).collect()
}

#[test]
fn straight_passes_and_faces() {
    let one = bar_with(&[(60.0, -40.0), (50.0, -40.0), (50.0, 0.0), (0.0, 0.0)]);
    removes(
        "G1",
        BAR,
        "T0101\nG0 X50. Z2.\nG1 Z-40. F.2\nX62.\nG0 Z2.\n",
        ring(50.0, 60.0, 40.0),
        &one,
    );
    let steps = bar_with(&[
        (60.0, -40.0),
        (54.0, -40.0),
        (54.0, -30.0),
        (50.0, -30.0),
        (50.0, 0.0),
        (0.0, 0.0),
    ]);
    let wanted = ring(54.0, 60.0, 40.0) + ring(50.0, 54.0, 30.0);
    let blocks = "T0101\nG0 X66. Z2.\nG90 X60. Z-40. F.25\nX54.\nX50. Z-30.\nG0 X80.\n";
    removes("G90", BAR, blocks, wanted, &steps);
    let face = bar_with(&[(60.0, -2.0), (20.0, -2.0), (20.0, 0.0), (0.0, 0.0)]);
    let blocks = "T0101\nG0 X66. Z2.\nG94 X20. Z-2. F.2\nG0 X80.\n";
    removes("G94", BAR, blocks, ring(20.0, 60.0, 2.0), &face);
    let short = bar_with(&[(60.0, -3.0), (0.0, -3.0)]);
    let to_axis = "T0101\nG0 X62. Z-3.\nG1 X0 F.1\nG0 Z2.\n";
    removes("a face", BAR, to_axis, cylinder(60.0, 3.0), &short);
    let past = "T0101\nG0 X62. Z-3.\nG1 X-2. F.1\nG0 Z2.\n";
    removes("a face past the axis", BAR, past, cylinder(60.0, 3.0), &short);
    let inch = "G20\nT0101\nG0 X2. Z.1\nG1 Z-1.5 F.008\nX2.5\nG0 Z.1\n";
    let wanted = ring(50.8, 60.0, 38.1);
    let profile = bar_with(&[(60.0, -38.1), (50.8, -38.1), (50.8, 0.0), (0.0, 0.0)]);
    removes("inches", BAR, inch, wanted, &profile);
    let taper = "T0101\nG0 X66. Z2.\nG90 X60. Z-40. R-5.25 F.2\nG0 X80.\n";
    let at_face = 49.5 + 10.5 / 42.0 * 2.0;
    let wanted = cylinder(60.0, 40.0) - cone(at_face, 60.0, 40.0);
    let profile = bar_with(&[(60.0, -40.0), (at_face, 0.0), (0.0, 0.0)]);
    removes("G90 with R", BAR, taper, wanted, &profile);
}

#[test]
fn roughing_and_finishing() {
    let part = cylinder(20.0, 20.0) + cone(20.0, 40.0, 15.0) + cylinder(40.0, 15.0);
    let wanted = cylinder(60.0, 50.0) - part;
    let profile = bar_with(&[
        (60.0, -50.0),
        (40.0, -50.0),
        (40.0, -35.0),
        (20.0, -20.0),
        (20.0, 0.0),
        (0.0, 0.0),
    ]);
    let rough =
        format!("T0101\nG0 X62. Z2.\nG71 U2.5 R1.\nG71 P10 Q50 U0 W0 F.3\n{SHAFT}G0 X80.\n");
    removes("G71", BAR, &rough, wanted, &profile);
    let both = format!(
        "T0101\nG0 X62. Z2.\nG71 U2.5 R1.\nG71 P10 Q50 U.6 W.2 F.3\n{SHAFT}G70 P10 Q50\nG0 X80.\n"
    );
    removes("G71 and G70", BAR, &both, wanted, &profile);
    // The allowance moves the whole profile.
    let more = cylinder(20.6, 19.8) + cone(20.6, 40.6, 15.0) + cylinder(40.6, 15.0);
    let shifted = bar_with(&[
        (60.0, -49.8),
        (40.6, -49.8),
        (40.6, -34.8),
        (20.6, -19.8),
        (20.6, 0.0),
        (0.0, 0.0),
    ]);
    let rough =
        format!("T0101\nG0 X62. Z2.\nG71 U2.5 R1.\nG71 P10 Q50 U.6 W.2 F.3\n{SHAFT}G0 X80.\n");
    removes("G71 with allowances", BAR, &rough, cylinder(60.0, 49.8) - more, &shifted);
    let pattern =
        format!("T0101\nG0 X62. Z2.\nG73 U6. W4. R3\nG73 P10 Q50 U0 W0 F.3\n{SHAFT}G0 X80.\n");
    removes("G73", BAR, &pattern, wanted, &profile);
    let pocket = "T0404\nG0 X62. Z2.\nG71 U4. R.5\nG71 P10 Q50 U0 W0 F.3\nN10 G0 X30. W0\nG1 Z-10.\nX20. \
                  Z-15.\nZ-25.\nX30. Z-30.\nZ-40.\nN50 X62.\nG0 X80.\n";
    let part = cylinder(30.0, 10.0)
        + 2.0 * cone(20.0, 30.0, 5.0)
        + cylinder(20.0, 10.0)
        + cylinder(30.0, 10.0);
    let profile = bar_with(&[
        (60.0, -40.0),
        (30.0, -40.0),
        (30.0, -30.0),
        (20.0, -25.0),
        (20.0, -15.0),
        (30.0, -10.0),
        (30.0, 0.0),
        (0.0, 0.0),
    ]);
    removes("G71 with a pocket", BAR, pocket, cylinder(60.0, 40.0) - part, &profile);
    let faces = "T0101\nG0 X62. Z2.\nG72 W3. R1.\nG72 P10 Q50 U0 W0 F.3\nN10 G0 Z-20.\nG1 X40.\nX20. Z-5.\nN50 \
                 Z2.\nG0 X80.\n";
    let part = cone(40.0, 20.0, 15.0) + cylinder(20.0, 5.0);
    let profile = bar_with(&[(60.0, -20.0), (40.0, -20.0), (20.0, -5.0), (20.0, 0.0), (0.0, 0.0)]);
    removes("G72", BAR, faces, cylinder(60.0, 20.0) - part, &profile);
}

#[test]
fn grooves_and_parting() {
    let groove = bar_with(&[
        (60.0, -30.0),
        (40.0, -30.0),
        (40.0, -20.0),
        (60.0, -20.0),
        (60.0, 0.0),
        (0.0, 0.0),
    ]);
    let g75 = "T0303\nG0 X62. Z-23.\nG75 R.5\nG75 X40. Z-30. P3000 Q2500 F.1\nG0 X80.\n";
    removes("G75", BAR, g75, ring(40.0, 60.0, 10.0), &groove);
    let plain = "T0303\nG0 X62. Z-23.\nG1 X40. F.1\nG0 X62.\nZ-26.\nG1 X40.\nG0 X62.\nZ-29.\nG1 X40.\nG0 \
                 X62.\nZ-30.\nG1 X40.\nG0 X62.\n";
    removes("plunges", BAR, plain, ring(40.0, 60.0, 10.0), &groove);
    let turned_groove = "T0303\nG0 X62. Z-23.\nG1 X40. F.1\nZ-30.\nX62.\n";
    removes("a groove by turning", BAR, turned_groove, ring(40.0, 60.0, 10.0), &groove);
    let face_groove =
        bar_with(&[(60.0, 0.0), (46.0, 0.0), (46.0, -5.0), (40.0, -5.0), (40.0, 0.0), (0.0, 0.0)]);
    let plunge = "T0808\nG0 X40. Z2.\nG1 Z-5. F.1\nG0 Z2.\n";
    removes("a groove in the face", BAR, plunge, ring(40.0, 46.0, 5.0), &face_groove);
    let off = [
        (0.0, -100.0),
        (60.0, -100.0),
        (60.0, -50.0),
        (0.0, -50.0),
        (0.0, -47.0),
        (60.0, -47.0),
        (60.0, 0.0),
        (0.0, 0.0),
    ];
    let part_off = "T0303\nG0 X62. Z-50.\nG1 X-.4 F.05\nG0 X62.\n";
    removes("a part-off", BAR, part_off, cylinder(60.0, 3.0), &off);
    // A half circle of R5 at the surface: its centroid is 4R/3π below.
    let round = "T1010\nG0 X64. Z-30.\nG1 X50. F.1\nG0 X64.\n";
    let area = 12.5 * PI;
    let wanted = turned(area, 60.0 - 2.0 * 4.0 * 5.0 / (3.0 * PI));
    let profile = bar_with(&[(60.0, -35.0), (60.0, -25.0), (60.0, 0.0), (0.0, 0.0)]);
    removes("a round groove", BAR, round, wanted, &profile);
}

#[test]
fn bores() {
    let hole = bar_with(&[(60.0, 0.0), (20.0, 0.0), (20.0, -40.0), (0.0, -40.0)]);
    let g74 = "T0505\nG0 X0 Z3.\nG74 R1.\nG74 Z-40. Q12000 F.15\nG0 X80.\n";
    removes("G74", BAR, g74, cylinder(20.0, 40.0), &hole);
    let point = 10.0 / (59.0_f64.to_radians()).tan();
    let drill = "T0606\nG0 X0 Z3.\nG1 Z-30. F.15\nG0 Z3.\n";
    let wanted = cylinder(20.0, 30.0 - point) + cone(0.0, 20.0, point);
    let profile = bar_with(&[(60.0, 0.0), (20.0, 0.0), (20.0, -30.0 + point), (0.0, -30.0)]);
    removes("a drill", BAR, drill, wanted, &profile);
    let bore =
        "T0505\nG0 X0 Z3.\nG1 Z-40. F.15\nG0 Z3.\nT0202\nG0 X30. Z3.\nG1 Z-20. F.1\nX20.\nG0 Z3.\n";
    let wanted = cylinder(20.0, 40.0) + ring(20.0, 30.0, 20.0);
    let profile = bar_with(&[
        (60.0, 0.0),
        (30.0, 0.0),
        (30.0, -20.0),
        (20.0, -20.0),
        (20.0, -40.0),
        (0.0, -40.0),
    ]);
    removes("a bore", BAR, bore, wanted, &profile);
    let taper = "T0505\nG0 X0 Z3.\nG1 Z-40. F.15\nG0 Z3.\nT0202\nG0 X36. Z0\nG1 X24. Z-20. F.1\nX20.\nG0 Z3.\n";
    let wanted = cylinder(20.0, 40.0) + cone(24.0, 36.0, 20.0) - cylinder(20.0, 20.0);
    let profile = bar_with(&[
        (60.0, 0.0),
        (36.0, 0.0),
        (24.0, -20.0),
        (20.0, -20.0),
        (20.0, -40.0),
        (0.0, -40.0),
    ]);
    removes("a tapered bore", BAR, taper, wanted, &profile);
    let inside = "T0505\nG0 X0 Z3.\nG1 Z-40. F.15\nG0 Z3.\nT0707\nG0 X18. Z3.\nZ-24.\nG1 X30. F.05\nG0 X18.\nZ3.\n";
    let wanted = cylinder(20.0, 40.0) + ring(20.0, 30.0, 4.0);
    let profile = bar_with(&[
        (60.0, 0.0),
        (20.0, 0.0),
        (20.0, -20.0),
        (30.0, -20.0),
        (30.0, -24.0),
        (20.0, -24.0),
        (20.0, -40.0),
        (0.0, -40.0),
    ]);
    removes("a groove in a bore", BAR, inside, wanted, &profile);
    let g71 = "T0505\nG0 X0 Z3.\nG1 Z-60. F.15\nG0 Z3.\nT0202\nG0 X19. Z2.\nG71 U2. R.5\nG71 P10 Q50 U0 W0 F.2\nN10 \
               G0 X40.\nG1 Z-10.\nX30.\nZ-30.\nN50 X19.\nG0 Z50.\n";
    let wanted = cylinder(20.0, 60.0) + ring(20.0, 40.0, 10.0) + ring(20.0, 30.0, 20.0);
    let profile = bar_with(&[
        (60.0, 0.0),
        (40.0, 0.0),
        (40.0, -10.0),
        (30.0, -10.0),
        (30.0, -30.0),
        (20.0, -30.0),
        (20.0, -60.0),
        (0.0, -60.0),
    ]);
    removes("G71 in a bore", BAR, g71, wanted, &profile);
}

#[test]
fn arcs() {
    let (area, off) = corner(5.0);
    let ball = "T0101\nG0 X0 Z2.\nG1 Z0 F.1\nG3 X40. Z-20. R20.\nG1 X62.\nG0 Z2.\n";
    let wanted = cylinder(60.0, 20.0) - 2.0 / 3.0 * PI * 8000.0;
    let profile = bar_with(&[(60.0, -20.0), (40.0, -20.0), (0.0, 0.0)]);
    removes("a ball", BAR, ball, wanted, &profile);
    let round = "T0101\nG0 X50. Z2.\nG1 Z0 F.1\nG3 X60. Z-5. R5.\nG1 X62.\nG0 Z2.\n";
    let profile = bar_with(&[(60.0, -5.0), (50.0, 0.0), (0.0, 0.0)]);
    removes("a round edge", BAR, round, turned(area, 60.0 - 2.0 * off), &profile);
    let fillet = "T0101\nG0 X40. Z2.\nG1 Z-15. F.1\nG2 X50. Z-20. I5. K0\nG1 X62.\nG0 Z2.\n";
    let wanted = ring(40.0, 60.0, 20.0) - turned(area, 40.0 + 2.0 * off);
    let profile = bar_with(&[(60.0, -20.0), (50.0, -20.0), (40.0, -15.0), (40.0, 0.0), (0.0, 0.0)]);
    removes("a fillet", BAR, fillet, wanted, &profile);
    // The nose leaves its own radius in a shoulder.
    let (area, off) = corner(0.8);
    let shoulder = "T0909\nG0 X50. Z2.\nG1 Z-40. F.2\nX62.\nG0 Z2.\n";
    let wanted = ring(50.0, 60.0, 40.0) - turned(area, 50.0 + 2.0 * off);
    let profile = bar_with(&[(60.0, -40.0), (51.6, -40.0), (50.0, -39.2), (50.0, 0.0), (0.0, 0.0)]);
    removes("a shoulder by a nose", BAR, shoulder, wanted, &profile);
    // With compensation the nose touches the programmed cone.
    let cone_blocks =
        "T0909\nG0 X16. Z5.\nG42 G1 X18. Z2. F.2\nX40. Z-20.\nX64. Z-44.\nG40 X70. Z-40.\nG0 Z5.\n";
    let wanted = cylinder(60.0, 40.0) - cone(20.0, 60.0, 40.0);
    let profile = bar_with(&[(60.0, -40.0), (20.0, 0.0), (0.0, 0.0)]);
    removes("a compensated cone", BAR, cone_blocks, wanted, &profile);
    let ball = "T0909\nG0 X-3. Z5.\nG42 G1 X0 Z0 F.2\nG3 X40. Z-20. R20.\nG1 X70.\nG40 X74. Z-18.\nG0 Z5.\n";
    let wanted = cylinder(60.0, 20.0) - 2.0 / 3.0 * PI * 8000.0;
    let (area, off) = corner(0.8);
    let _ = (area, off);
    let found = turn(&format!("{BAR}{TOOLS}"), &format!("{HEAD}{ball}M30\n"));
    // The nose leaves its radius between the ball and the shoulder, and nothing else.
    let left = wanted - found.removed_mm3.least;
    assert!(left > 0.0 && left < 40.0 * PI * 0.8 * 0.8, "{left}");
}

#[test]
fn other_stock() {
    let tube = "
[stock]
shape = 'tube'
diameter = '60 mm'
bore = '20 mm'
from = '-100 mm'
to = '0 mm'
";
    let blocks = "T0101\nG0 X62. Z-3.\nG1 X18. F.1\nG0 Z2.\n";
    let profile = [(20.0, -100.0), (60.0, -100.0), (60.0, -3.0), (20.0, -3.0)];
    removes("a tube", tube, blocks, ring(20.0, 60.0, 3.0), &profile);
    // A forging: a cone from 60 to 40 over 30 mm, on a bar; turned to 40.
    let contour = "
[stock]
shape = 'contour'
contour = [['40 mm', '0 mm'], ['60 mm', '-30 mm'], ['60 mm', '-100 mm']]
";
    let blocks = "T0101\nG0 X40. Z2.\nG1 Z-50. F.2\nX62.\nG0 Z2.\n";
    let wanted = cone(40.0, 60.0, 30.0) + cylinder(60.0, 20.0) - cylinder(40.0, 50.0);
    let profile = bar_with(&[(60.0, -50.0), (40.0, -50.0), (40.0, 0.0), (0.0, 0.0)]);
    removes("a contour", contour, blocks, wanted, &profile);
    // A gang lathe cuts on the other side of the axis.
    let gang = "T0202\nG0 X-50. Z2.\nG1 Z-40. F.2\nX-62.\nG0 Z2.\n";
    let profile = bar_with(&[(60.0, -40.0), (50.0, -40.0), (50.0, 0.0), (0.0, 0.0)]);
    removes("negative X", BAR, gang, ring(50.0, 60.0, 40.0), &profile);
}
