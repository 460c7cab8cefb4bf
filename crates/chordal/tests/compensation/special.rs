//! Cases that need a control of their own.

use crate::difference;
use crate::support::{Ran, Step, machine, run};

fn lines(points: &[[f64; 2]]) -> Vec<Step> {
    points.iter().map(|to| Step { to: *to, arc: None }).collect()
}

fn mm(name: &str, radius: f64, settings: &[&str], text: &str) -> Ran {
    run(text, machine(name, radius, "mm", settings), 1.0)
}

fn goes(ran: &Ran, points: &[[f64; 2]]) {
    if let Some(what) = difference(&ran.steps, &lines(points), usize::MAX) {
        panic!("{what}");
    }
}

const IDLE: &str = "G21 G17 G40 G90\nG0 X-40 Y20\nG41 D1 G1 X-40 Y0 F100\nX0\nM8\nG4 P500\nY40\n\
                    G40 X-20\nM30\n";

#[test]
fn two_idle_blocks_are_too_many_for_three_blocks_read() {
    let ran = mm("fanuc-30i", 5.0, &[], IDLE);
    goes(&ran, &[[-40.0, 5.0], [0.0, 5.0], [-5.0, 40.0], [-20.0, 40.0]]);
    assert!(ran.told.contains(&"CH515"), "{:?}", ran.told);
}

#[test]
fn controls_that_read_further_find_the_corner() {
    let corner = [[-40.0, 5.0], [-5.0, 5.0], [-5.0, 40.0], [-20.0, 40.0]];
    for (name, settings) in [
        ("fanuc-30i", ["settings.\"No. 19625\"=4"].as_slice()),
        ("fanuc-30i", &["settings.\"No. 6009\"=5"]),
        ("mitsubishi-m700", &[]),
        ("haas-vf2", &[]),
        ("fadal-4020", &["settings.format=2"]),
    ] {
        let ran = mm(name, 5.0, settings, IDLE);
        goes(&ran, &corner);
        assert!(!ran.told.contains(&"CH515"), "{name}: {:?}", ran.told);
    }
    let ran = mm("linuxcnc-mill", 5.0, &[], &IDLE.replace("P500", "P0.5"));
    goes(&ran, &[[-35.0, 5.0], [-5.0, 5.0], [-5.0, 40.0], [-20.0, 40.0]]);
}

const SIDES: &str = "G21 G17 G40 G90\nG0 X-10 Y-20\nF100\nG41 D1 G1 X-10 Y0\nG1 X0\nX40\nG42 Y40\n\
                     Y60\nG40 X60\nM30\n";

#[test]
fn the_left_and_the_right_offset_cross_at_a_change_of_side() {
    for name in ["fanuc-30i", "mitsubishi-m700"] {
        let ran = mm(name, 5.0, &[], SIDES);
        goes(
            &ran,
            &[[-10.0, 5.0], [0.0, 5.0], [45.0, 5.0], [45.0, 40.0], [45.0, 60.0], [60.0, 60.0]],
        );
        assert!(ran.alarms.is_empty(), "{name}: {:?}", ran.alarms);
    }
}

#[test]
fn without_a_crossing_the_vector_stands_on_the_new_block() {
    let text = SIDES.replace("G42 Y40\nY60\nG40 X60", "G42 X80\nX90\nG40 Y-20");
    let ran = mm("fanuc-30i", 5.0, &[], &text);
    goes(
        &ran,
        &[[-10.0, 5.0], [0.0, 5.0], [40.0, -5.0], [80.0, -5.0], [90.0, -5.0], [90.0, -20.0]],
    );
}

#[test]
fn on_haas_the_block_itself_goes_to_the_other_side() {
    let ran = mm("haas-vf2", 5.0, &[], SIDES);
    goes(&ran, &[[-10.0, 5.0], [0.0, 5.0], [40.0, 5.0], [45.0, 40.0], [45.0, 60.0], [60.0, 60.0]]);
}

#[test]
fn fadal_and_linuxcnc_refuse_a_change_of_side() {
    for (name, settings, text) in [
        ("fadal-4020", ["settings.format=2"].as_slice(), "ATTEMPT TO CHANGE CRC SIDE WITHOUT G40"),
        ("linuxcnc-mill", &[], "Cannot turn cutter radius comp on when on"),
    ] {
        let ran = mm(name, 5.0, settings, SIDES);
        assert!(ran.alarms.iter().any(|shown| shown.contains(text)), "{name}: {:?}", ran.alarms);
    }
}

#[test]
fn i_and_j_beside_g40_end_the_last_offset() {
    let text = |end: &str| {
        format!("G21 G17 G40 G90\nG0 X0 Y-20\nF100\nG41 D1 G1 X0 Y0\nX40\n{end}\nM30\n")
    };
    for name in ["fanuc-30i", "mitsubishi-m700"] {
        for (end, last) in [
            ("G40 X60 Y30 I0 J10", [35.0, 5.0]),
            ("G40 X60 Y-30 I0 J-10", [45.0, 5.0]),
            ("G40 X60 Y30", [40.0, 5.0]),
        ] {
            let ran = mm(name, 5.0, &[], &text(end));
            assert!(ran.alarms.is_empty(), "{name}: {:?}", ran.alarms);
            let at = ran.steps[ran.steps.len() - 2].to;
            assert!((at[0] - last[0]).hypot(at[1] - last[1]) < 1e-9, "{name} {end}: {at:?}");
        }
    }
}

#[test]
fn a_helical_bore_keeps_its_turns() {
    let text = "G70 G17 G40 G90\nG0 X2 Y-2\nG0 Z0\nF10.\nG1 X3. G41 D1\nG91 I-1. G3 Z-.3 L3\n\
                I-1. G3 Z-.13\nI-1. G3 L2\nG90 X2. G40 G0\nM2\n";
    let settings = ["settings.format=2"];
    let ran = run(text, machine("fadal-4020", 0.375, "inch", &settings), 25.4);
    assert_eq!(ran.steps.len(), 8, "{ran:?}");
    for (step, height) in ran.steps[1..7].iter().zip([-0.3, -0.6, -0.9, -1.03, -1.03, -1.03]) {
        assert!((step.to[0] - 2.625).hypot(step.to[1] + 2.0) < 1e-9, "{step:?}");
        let Some((center, crate::Sweep::Degrees(sweep))) = step.arc else { panic!("{step:?}") };
        assert!((center[0] - 2.0).hypot(center[1] + 2.0) < 1e-9, "{step:?}");
        assert!((sweep - 360.0).abs() < 1e-9, "{step:?}");
        let index = ran.steps.iter().position(|one| std::ptr::eq(one, step)).unwrap_or(0);
        assert!((ran.heights[index] - height).abs() < 1e-9, "{:?}", ran.heights);
    }
    assert!((ran.steps[7].to[0] - 2.0).abs() < 1e-9);
}

#[test]
fn g39_rounds_the_end_of_its_block() {
    let text = "G21 G17 G40 G90\nG0 X0 Y0\nG91\nG1 G42 X20. Y20. D1 F100\nG39 X40.\nG39 Y40.\n\
                G39 X-40.\nY-40.\nG40 X-20. Y-20.\nM2\n";
    let arc = |to: [f64; 2], center: [f64; 2]| Step {
        to,
        arc: Some((center, crate::Sweep::Degrees(90.0))),
    };
    let line = |to: [f64; 2]| Step { to, arc: None };
    let ran = mm("mitsubishi-m700", 5.0, &[], text);
    let wanted = [
        line([20.0, 15.0]),
        line([60.0, 15.0]),
        arc([65.0, 20.0], [60.0, 20.0]),
        line([65.0, 60.0]),
        arc([60.0, 65.0], [60.0, 60.0]),
        line([20.0, 65.0]),
        arc([15.0, 60.0], [20.0, 60.0]),
        line([15.0, 20.0]),
        line([0.0, 0.0]),
    ];
    assert_eq!(difference(&ran.steps, &wanted, usize::MAX), None);
    let ran = mm("mitsubishi-m700", 5.0, &[], &text.replace("G39 ", ""));
    goes(&ran, &[[20.0, 15.0], [65.0, 15.0], [65.0, 65.0], [15.0, 65.0], [15.0, 20.0], [0.0, 0.0]]);
}

const TROUGH: &str = "G21 G17 G90 G40\nG0 X26.8328 Y13.4164\nF100\nG41 D1 G1 X0. Y0.\n\
                      G1 X50. Y-100.\nG1 X70. Y-100.\nG1 X120. Y0.\nG40 G1 X93.1672 Y13.4164\nM2\n";

#[test]
fn avoidance_leaves_the_floor_of_a_trough_out() {
    let sine = 1.0 / 5.0f64.sqrt();
    let wall = [20.0 * 2.0 * sine, 20.0 * sine];
    for (name, setting) in
        [("mitsubishi-m700", "settings.\"#8102\"=1"), ("fanuc-30i", "settings.\"No. 19607#5\"=1")]
    {
        let ran = mm(name, 20.0, &[setting], TROUGH);
        goes(
            &ran,
            &[
                [wall[0], wall[1]],
                [60.0, -75.278_640_45],
                [120.0 - wall[0], wall[1]],
                [93.1672, 13.4164],
            ],
        );
        assert!(ran.alarms.is_empty() && ran.told.contains(&"CH519"), "{name}: {ran:?}");
    }
}

#[test]
fn a_trough_fits_up_to_its_limit() {
    for (radius, fits) in [(16.18, true), (16.181, false)] {
        let ran = mm("mitsubishi-m700", radius, &[], TROUGH);
        assert_eq!(ran.alarms.is_empty(), fits, "{radius}: {:?}", ran.alarms);
    }
}

#[test]
fn a_negative_offset_swaps_the_side() {
    let text = |side: &str| {
        format!("G21 G17 G40 G90\nG0 X-20 Y-20\nF100\n{side} D1 G1 X0 Y0\nX40\nY40\nG40 X60\nM30\n")
    };
    for name in ["fanuc-30i", "mitsubishi-m700", "haas-vf2", "linuxcnc-mill"] {
        let left = mm(name, -5.0, &[], &text("G41"));
        let right = mm(name, 5.0, &[], &text("G42"));
        assert_eq!(difference(&left.steps, &right.steps, usize::MAX), None, "{name}");
    }
}

#[test]
fn offset_zero_moves_nothing_aside() {
    let text = "G21 G17 G40 G90\nG0 X-20 Y-20\nF100\nG41 D0 G1 X0 Y0\nX40\nG40 X60\nM30\n";
    for name in ["fanuc-30i", "mitsubishi-m700", "haas-vf2"] {
        assert!(mm(name, 5.0, &[], text).steps.is_empty(), "{name}");
    }
}

#[test]
fn wear_adds_to_the_offset() {
    let text = "G21 G17 G40 G90\nG0 X0 Y-20\nF100\nG41 D1 G1 X0 Y0\nX40\nG40 Y30\nM30\n";
    for name in ["fanuc-30i", "haas-vf2", "mitsubishi-m700"] {
        let ran = mm(name, 5.0, &["tools.1.diameter_wear=\"-0.2 mm\""], text);
        goes(&ran, &[[0.0, 4.9], [40.0, 4.9], [40.0, 30.0]]);
    }
}

#[test]
fn h_brings_the_diameter_in_format_1_and_d_in_format_2() {
    let text = "G70 G17 G40 G90\nH1\nG0 X0 Y-2.\nF10.\nG41 G1 X0 Y0\nX4.\nG40 Y3.\nM2\n";
    let ran = run(text, machine("fadal-4020", 0.25, "inch", &[]), 25.4);
    goes(&ran, &[[0.0, 0.25], [4.0, 0.25], [4.0, 3.0]]);
    let ran = run(text, machine("fadal-4020", 0.25, "inch", &["settings.format=2"]), 25.4);
    assert!(ran.steps.is_empty() && ran.told.contains(&"CH503"), "{ran:?}");
}

#[test]
fn type_c_moves_aside_at_once() {
    let text = "G21 G17 G40 G90\nG0 X0 Y0\nF100\nG1 X0 Y0\nG41 D1\nX40\nY40\nG40\nX60\nM30\n";
    let ran = mm("fanuc-30i", 5.0, &["settings.\"No. 5003#1\"=1"], text);
    goes(&ran, &[[0.0, 5.0], [35.0, 5.0], [35.0, 40.0], [40.0, 40.0], [60.0, 40.0]]);
}

#[test]
fn short_links_are_left_out() {
    // 02c with links of 5 mm: they stay above 5010 = 4.9 mm and go at 5.1 mm.
    let text = "G21 G17 G90 G40\nG0 X-40. Y20.\nF100\nG41 D1 G1 X-40. Y0.\nG1 X0. Y0.\n\
                G1 X-28.2843 Y-28.2843\nG40 G1 X-14.1421 Y-42.4264\nM2\n";
    let with = |limit: &str| mm("fanuc-30i", 5.0, &[limit], text).steps.len();
    assert_eq!(with("settings.\"No. 5010\"=\"4.9 mm\""), 5);
    assert_eq!(with("settings.\"No. 5010\"=\"5.1 mm\""), 4);
}

#[test]
fn linuxcnc_names_the_move_that_cannot_be_reached() {
    // As rs274 2.9 says it.
    let text = |end: &str| {
        format!("G21 G17 G90 G40\nG0 X-60 Y0\nF100\nG41 D1 G1 X-40 Y0\n{end}G40 G1 X-20\nM2\n")
    };
    for (end, alarm) in [
        (
            "G1 X0 Y10\nG3 X1.2 Y10.2 R6\nG1 X1.2 Y30\n",
            "Arc to straight motion makes a corner the compensated tool can't fit in without gouging",
        ),
        ("G1 X0 Y0\nG1 X0 Y30\nG3 X-1 Y31 R1\n", "Tool radius not less than arc radius with comp"),
    ] {
        let ran = mm("linuxcnc-mill", 5.0, &[], &text(end));
        let shown = ran.alarms.iter().any(|shown| shown.ends_with(alarm));
        assert!(shown, "{end}: {:?}", ran.alarms);
    }
}

#[test]
fn spirals_are_refused_or_done_by_circles() {
    let text = "G21 G17 G40 G90\nG0 X0 Y-20\nF100\nG42 D1 G1 X0 Y0\nX20\n\
                G3 X60 Y0 I20 J0 Q5 L2\nG1 X80\nG40 Y20\nM30\n";
    let fanuc = mm("fanuc-30i", 5.0, &[], text);
    assert!(fanuc.told.contains(&"CH516"), "{fanuc:?}");
    assert!(!fanuc.alarms.iter().any(|alarm| alarm.contains("spiral")), "{fanuc:?}");
    let refused = mm("fanuc-30i", 5.0, &["settings.compensation_spirals=refused"], text);
    assert!(refused.alarms.iter().any(|alarm| alarm.contains("spiral")), "{refused:?}");
}
