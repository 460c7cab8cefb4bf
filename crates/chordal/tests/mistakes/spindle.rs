//! Taps, tool changes and speeds of mills and lathes.

use chordal::Severity;

use crate::{LATHES, MILLS, check, check_assumed, expect, mistakes, only, says};

/// The head of a program for a mill; LinuxCNC and Mach3 want a spindle that turns before a tap.
fn tap(change: &str, speed: &str, cycle: &str) -> String {
    format!(
        "G21 G90 G17 G40 G49 G80 G94\n{change}\n{speed}\nG0 X0 Y0\nG0 Z20.\n{cycle}\nG80\nM30\n"
    )
}

#[test]
fn a_tap_without_a_speed_is_an_error_on_every_mill() {
    let cycle = "G84 X0 Y0 Z-15. R5. F750.";
    for machine in ["haas-vf2", "fanuc-0i", "mitsubishi-m700"] {
        for speed in ["", "M3", "S0 M3"] {
            let program = tap("T1 M6", speed, cycle);
            let found = check(machine, &[], &program);
            assert_eq!(mistakes(&found, &program), ["CH819 6"], "{machine} {speed}");
            says(&only(&found, "CH819"), Severity::Error, &["tool 1", "no speed"]);
        }
        expect(&[machine], &[], &tap("T1 M6", "S500 M3", cycle), &[]);
        // M29 S starts it, too.
        expect(&[machine], &[], &tap("T1 M6", "S500", cycle), &[]);
    }
    // It must turn before the tap.
    let none = tap("T1 M6", "M3", cycle);
    let found = check("linuxcnc-mill", &[], &none);
    assert!(mistakes(&found, &none).contains(&"CH819 6".to_string()), "{found:#?}");
    expect(&["linuxcnc-mill"], &[], &tap("T1 M6", "S500 M3", cycle), &[]);
    // F is the speed, and Q the lead.
    let fadal = |f: &str| tap("T1 M6", "", &format!("G84.1 X0 Y0 Z-15. R0+5. Q1.5 {f}"));
    expect(&["fadal-4020"], &["settings.units='mm'"], &fadal("F500."), &[]);
    // S of routers with a knob is set by hand.
    expect(&["mach3-mill"], &[], &tap("T1 M6", "M3", cycle), &[]);
}

#[test]
fn a_tap_in_step_with_the_spindle_needs_a_speed_too() {
    let rigid = tap("T1 M6", "M3", "G84 X0 Y0 Z-15. R5. F1.5 ,R1");
    let found = check("mitsubishi-m700", &[], &rigid);
    assert_eq!(mistakes(&found, &rigid), ["CH819 6"], "{found:#?}");
    let per_turn = tap("T1 M6", "M3", "G95 G84 X0 Y0 Z-15. R5. F1.5");
    expect(&["haas-vf2", "fanuc-0i", "mitsubishi-m700"], &[], &per_turn, &["CH819 6"]);
    // The spindle of a lathe, and no cycle before has given it a speed.
    let lathe = "G21 G18 G40 G99\nT0101\nM3\nG0 X0 Z5.\nG84 Z-15. R-2. F1.5\nG80\nM30\n";
    expect(&["fanuc-lathe", "mitsubishi-lathe"], &[], lathe, &["CH819 5"]);
    let haas = lathe.replace("R-2.", "R2.").replace("T0101", "T101");
    expect(&["haas-lathe"], &["settings.units='mm'"], &haas, &["CH819 5"]);
    expect(&["fanuc-lathe", "mitsubishi-lathe"], &[], &lathe.replace("M3", "G97 S300 M3"), &[]);
}

#[test]
fn a_part_of_a_program_may_get_its_speed_elsewhere() {
    let part = "G21 G90\nG0 X0 Y0\nG84 X0 Y0 Z-15. R5. F750.\nG80\nM30\n";
    let found = check("fanuc-0i", &[], part);
    says(&only(&found, "CH819"), Severity::Warning, &["no speed"]);
}

/// A tap of 1.25 mm pitch.
const PITCH: &[&str] = &[
    "tools.1.shape='tap'",
    "tools.1.diameter='8 mm'",
    "tools.1.pitch='1.25 mm'",
    "tools.1.flute_length='20 mm'",
];

#[test]
fn the_pitch_of_a_tap_is_checked_with_both_forms_of_f() {
    for machine in ["haas-vf2", "fanuc-0i", "mitsubishi-m700", "linuxcnc-mill"] {
        for (mode, right, wrong) in [("G94", "F625.", "F500."), ("G95", "F1.25", "F1.")] {
            let cycle =
                |f: &str| tap("T1 M6", "S500 M3", &format!("{mode} G84 X0 Y0 Z-15. R5. {f}"));
            expect(&[machine], PITCH, &cycle(right), &[]);
            expect(&[machine], PITCH, &cycle(wrong), &["CH818 6"]);
        }
    }
    // Feeds per revolution need an encoder there.
    let grblhal = |f: &str| tap("T1 M6", "S500 M3", &format!("G84 X0 Y0 Z-15. R5. {f}"));
    expect(&["grblhal"], PITCH, &grblhal("F625."), &[]);
    expect(&["grblhal"], PITCH, &grblhal("F500."), &["CH818 6"]);
    let q = |lead: &str| tap("T1 M6", "", &format!("G84.1 X0 Y0 Z-15. R0+5. Q{lead} F500."));
    let metric: Vec<&str> = PITCH.iter().copied().chain(["settings.units='mm'"]).collect();
    expect(&["fadal-4020"], &metric, &q("1.25"), &[]);
    expect(&["fadal-4020"], &metric, &q("1."), &["CH818 6"]);
    let k = |lead: &str| tap("T1 M6", "S500 M3", &format!("G33.1 Z-15. K{lead}"));
    expect(&["linuxcnc-mill"], PITCH, &k("1.25"), &[]);
    expect(&["linuxcnc-mill"], PITCH, &k("1."), &["CH818 6"]);
    for (mode, right, wrong) in [("G98", "F625.", "F500."), ("G99", "F1.25", "F1.")] {
        let lathe = |f: &str| {
            format!(
                "G21 G18 G40 {mode}\nT0101\nG97 S500 M3\nG0 X0 Z5.\nG84 Z-15. R-2. {f}\nG80\nM30\n"
            )
        };
        expect(&["fanuc-lathe", "mitsubishi-lathe"], PITCH, &lathe(right), &[]);
        expect(&["fanuc-lathe", "mitsubishi-lathe"], PITCH, &lathe(wrong), &["CH818 5"]);
        let haas = |f: &str| lathe(f).replace("R-2.", "R2.").replace("T0101", "T101");
        let metric: Vec<&str> = PITCH.iter().copied().chain(["settings.units='mm'"]).collect();
        expect(&["haas-lathe"], &metric, &haas(right), &[]);
        expect(&["haas-lathe"], &metric, &haas(wrong), &["CH818 5"]);
    }
}

#[test]
fn speeds_of_every_form_are_held_against_the_spindle() {
    let mill = |speed: &str| format!("G21 G90 G94\nT1 M6\n{speed}\nG0 X0 Y0\nG1 X10. F100.\nM30\n");
    for machine in MILLS {
        let most = ["spindle.max='8000 rpm'"];
        expect(&[machine], &most, &mill("S8000 M3"), &[]);
        expect(&[machine], &most, &mill("S9000 M3"), &["CH606 3"]);
        expect(&[machine], &most, &mill("M3 S9000"), &["CH606 3"]);
    }
    // Of routers the built-in machines give no speed of the spindle.
    let router = "G21 G90 G94\nS9000 M3\nG0 X0 Y0\nG1 X10 F100\nM30\n";
    for machine in ["grbl", "grblhal", "fluidnc", "mach3-mill"] {
        expect(&[machine], &[], router, &[]);
        expect(&[machine], &["spindle.max='8000 rpm'"], router, &["CH606 2"]);
    }
    // The way out of a tap with J, the speed after the hole with E, a tap whose F is its speed.
    let most = &["spindle.max='3000 rpm'", "feed.max='20 m/min'"];
    let haas =
        |words: &str| tap("T1 M6", "S2000 M3", &format!("G84 X0 Y0 Z-15. R5. F2500. {words}"));
    expect(&["haas-vf2"], most, &haas("J1"), &[]);
    expect(&["haas-vf2"], most, &haas("J2"), &["CH606 6"]);
    let after =
        |words: &str| tap("T1 M6", "S2000 M3", &format!("G81 X0 Y0 Z-15. R5. F200. {words}"));
    expect(&["haas-vf2"], most, &after("E2500"), &[]);
    expect(&["haas-vf2"], most, &after("E3500"), &["CH606 6"]);
    let fadal = |f: &str| tap("T1 M6", "", &format!("G84.1 X0 Y0 Z-15. R0+5. Q1.25 {f}"));
    let metric = &["spindle.max='3000 rpm'", "feed.max='20 m/min'", "settings.units='mm'"];
    expect(&["fadal-4020"], metric, &fadal("F2500."), &[]);
    expect(&["fadal-4020"], metric, &fadal("F3500."), &["CH606 6"]);
    let back = |i: &str| tap("T1 M6", "S2000 M3", &format!("G33.1 Z-15. K1. {i}"));
    expect(&["linuxcnc-mill"], most, &back(""), &[]);
    expect(&["linuxcnc-mill"], most, &back("I2."), &["CH606 6"]);
}

#[test]
fn speeds_of_lathes_are_held_against_the_spindle() {
    let lathe = |speed: &str| {
        format!("G21 G18 G40 G99\nT0101\nG50 S3000\n{speed}\nG0 X60. Z2.\nG1 Z-10. F.2\nM30\n")
    };
    for speed in ["G97 S4000 M3", "G96 S150 M3", "G96 S600 M3", "S4000 M3"] {
        expect(LATHES, &[], &lathe(speed), &[]);
    }
    for speed in ["G97 S5000 M3", "M3 S5000", "G97 S5000"] {
        let found: Vec<Vec<String>> = LATHES
            .iter()
            .map(|each| mistakes(&check(each, &[], &lathe(speed)), &lathe(speed)))
            .collect();
        assert!(
            found.iter().all(|each| each.contains(&"CH606 4".to_string())),
            "{speed}: {found:?}"
        );
    }
    // From a cutting speed to a speed.
    let after = lathe("G96 S150 M3").replace("M30", "G97 S5000\nG1 Z-20.\nM30");
    expect(LATHES, &[], &after, &["CH606 7"]);
    // M29 S of a tap, and live tools.
    let tap =
        lathe("G97 S300 M3").replace("G1 Z-10. F.2", "G0 X0\nM29 S5000\nG84 Z-15. R-2. F.3\nG80");
    expect(&["fanuc-lathe"], &[], &tap, &["CH606 7"]);
    let live = lathe("G97 S7000 M3 P12");
    expect(&["fanuc-lathe-c"], &[], &live, &["CH606 4"]);
    expect(&["fanuc-lathe-c"], &[], &lathe("G97 S5500 M3 P12"), &[]);
}

#[test]
fn a_cut_after_a_tool_change_needs_m3_where_the_change_stops_the_spindle() {
    let program = |start: &str| {
        format!(
            "G21 G90 G94\nT1 M6\nS2000 M3\nG0 X0 Y0\nG1 X10. F200.\nT2 M6\n{start}\nG0 X0 Y10.\nG1 X10.\nM30\n"
        )
    };
    let stops = &["fadal-4020", "haas-vf2", "fanuc-0i", "mitsubishi-m700", "linuxcnc-mill"];
    expect(stops, &[], &program(""), &["CH413 9"]);
    expect(stops, &[], &program("M3"), &[]);
    expect(stops, &["settings.spindle_at_tool_change='turns'"], &program(""), &[]);
    // M6 of Mach3 does what the macros of the shop do; the spindle of a grblHAL may be switched by hand.
    expect(&["mach3-mill", "grblhal"], &[], &program(""), &[]);
    let stop = &["settings.spindle_at_tool_change='stops'"];
    expect(&["mach3-mill"], stop, &program(""), &["CH413 9"]);
    // A turret turns while the spindle does.
    let lathe = "G21 G18 G40 G99\nT0101\nG97 S800 M3\nG0 X60. Z2.\nG1 Z-10. F.2\nG0 X100. Z100.\nT0202\nG0 X58. Z2.\nG1 Z-10.\nM30\n";
    expect(LATHES, &["settings.units='mm'"], lathe, &[]);
    expect(
        LATHES,
        &["settings.units='mm'", "settings.spindle_at_tool_change='stops'"],
        lathe,
        &["CH413 9"],
    );
}

#[test]
fn feeds_per_revolution_are_held_against_the_axes() {
    // 0.5 mm at 8000 rpm is 4000 mm/min.
    let program = |f: &str| format!("G21 G90 G95\nT1 M6\nS8000 M3\nG0 X0 Y0\nG1 X100. {f}\nM30\n");
    let most = &["feed.max='5000 mm/min'", "spindle.max='10000 rpm'"];
    for machine in ["haas-vf2", "fanuc-0i", "mitsubishi-m700", "linuxcnc-mill"] {
        expect(&[machine], most, &program("F.5"), &[]);
        let found = check(machine, most, &program("F.7"));
        says(&only(&found, "CH407"), Severity::Error, &["5600 mm/min", "5000 mm/min", "8000 rpm"]);
    }
    // Where nobody named the machine it is a note; LinuxCNC's has no largest feed.
    for machine in ["haas-vf2", "fanuc-0i", "mitsubishi-m700"] {
        let program = program("F50.").replace("S8000", "S3000");
        assert_eq!(mistakes(&check_assumed(machine, &program), &program), ["CH608 1"], "{machine}");
    }
    // A tap with its lead, and one that goes out faster.
    let tapped = tap("T1 M6", "S4000 M3", "G95 G84 X0 Y0 Z-15. R5. F1.5");
    let most = &["feed.max='5000 mm/min'"];
    expect(&["haas-vf2", "fanuc-0i", "mitsubishi-m700"], most, &tapped, &["CH407 6"]);
    expect(&["haas-vf2", "fanuc-0i", "mitsubishi-m700"], most, &tapped.replace("F1.5", "F1."), &[]);
    let rigid = tap("T1 M6", "S4000 M3", "G84 X0 Y0 Z-15. R5. F1.5 ,R1");
    expect(&["mitsubishi-m700"], most, &rigid, &["CH407 6"]);
    let lead = |words: &str| tap("T1 M6", "S4000 M3", &format!("G33.1 Z-15. {words}"));
    expect(&["linuxcnc-mill"], most, &lead("K1.5"), &["CH407 6"]);
    expect(&["linuxcnc-mill"], most, &lead("K1."), &[]);
    let fadal = |lead: &str| tap("T1 M6", "", &format!("G84.1 X0 Y0 Z-15. R0+5. Q{lead} F4000."));
    let metric = &["feed.max='5000 mm/min'", "settings.units='mm'"];
    expect(&["fadal-4020"], metric, &fadal("1.5"), &["CH407 6"]);
    expect(&["fadal-4020"], metric, &fadal("1."), &[]);
}
