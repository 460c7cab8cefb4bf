//! How long cuts with rotary axes take, by the rule of each control. Expected times are computed from the rule.

use chordal::{Job, Machine, Severity, Source, SourceMap};

/// The seconds that the cuts of a program take at their feeds, and whether its path and time are known.
fn cutting_time(machine: &str, settings: &[&str], program: &str) -> (f64, bool) {
    let mut machine = Machine::from_builtin(machine).expect("a built-in machine");
    for setting in settings {
        machine.set(setting).expect("a setting of this machine");
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("turn.nc", program.as_bytes()));
    let job = Job::new(sources, machine).expect("a machine of its own control");
    let report = job.report();
    let errors: Vec<_> =
        report.diagnostics.iter().filter(|found| found.severity == Severity::Error).collect();
    assert!(errors.is_empty(), "{program}: {errors:?}");
    (report.summary.feed_time_s, report.not_verified_from.is_none())
}

const FANUC: &[&str] = &["fanuc-30i", "mitsubishi-m700"];
const FOURTH: &str = "settings.\"Setting 34\"=\"4 in\"";
const FIFTH: &str = "settings.\"Setting 79\"=\"60 mm\"";

/// Fanuc B-63174EN 4.2: the vector of all axes, a degree for a unit of length.
#[test]
fn a_fanuc_counts_a_degree_as_a_unit_of_length() {
    let rows = [
        // The manual's own: X20. C40. F300. takes 0.149 min.
        ("G91 G1 X20. C40. F300.", 60.0 * (20f64.powi(2) + 40f64.powi(2)).sqrt() / 300.0),
        ("G91 G1 X200. C400. F300.", 60.0 * (200f64.powi(2) + 400f64.powi(2)).sqrt() / 300.0),
        // Rotary axes alone, one and two.
        ("G91 G1 C-90. F360.", 15.0),
        ("G91 G1 A30. C40. F100.", 30.0),
        ("G91 G1 X3. Y-4. Z12. A84. F85.", 60.0),
        // The same path without rotary axes, and a rotary axis that stays.
        ("G90 G1 X100. C0 F100.", 60.0),
        // F of another block holds for another shape.
        ("G91 G1 X10. F600.\nX3. C4.", 1.5),
        // In inverse time F alone decides.
        ("G91 G93 G1 X20. C40. F4.", 15.0),
        // Per revolution along the same vector: 100 rpm.
        ("G91 G95 G1 X3. C4. F0.1", 30.0),
        ("G91 G95 G1 C45. F0.5", 54.0),
    ];
    for machine in FANUC {
        for (cut, expected_s) in rows {
            let program = format!("%\nO1\nG21 G94 S100 M3\nG0 X0 Y0 Z0 A0 C0\n{cut}\nM30\n%\n");
            let (seconds, _) = cutting_time(machine, &[], &program);
            assert!(
                (seconds - expected_s).abs() < 1e-9,
                "{machine} {cut}: {seconds} s, not {expected_s}"
            );
        }
        // A degree is an inch in G20.
        let program = "%\nO1\nG20 G94 S100 M3\nG0 X0 C0\nG91 G1 X3. C4. F10.\nM30\n%\n";
        assert!((cutting_time(machine, &[], program).0 - 30.0).abs() < 1e-9, "{machine}");
    }
}

/// Settings 34 and 79: F is a length on the diameter of the axis.
#[test]
fn a_haas_counts_the_arc_on_the_diameter_of_the_axis() {
    let program = |cut: &str| format!("%\nO1\nG20 G94 S100 M3\nG0 X0 A0\n{cut}\nM30\n%\n");
    // 90 degrees on 4 in are pi inches.
    let pi = std::f64::consts::PI;
    for (cut, expected_s) in [
        ("G91 G1 A90. F10.", 60.0 * pi / 10.0),
        ("G91 G1 X1. A90. F10.", 60.0 * (1.0 + pi * pi).sqrt() / 10.0),
        ("G91 G93 G1 X1. A90. F10.", 6.0),
        ("G91 G1 X10. F10.", 60.0),
    ] {
        let (seconds, verified) = cutting_time("haas-vf2", &[FOURTH], &program(cut));
        assert!((seconds - expected_s).abs() < 1e-9, "{cut}: {seconds} s, not {expected_s}");
        assert!(verified, "{cut}");
    }
    // 286.479 deg/min, the example of ten inches a minute on four inches.
    let (seconds, _) = cutting_time("haas-vf2", &[FOURTH], &program("G91 G1 A286.479 F10."));
    assert!((seconds - 60.0).abs() < 1e-3, "{seconds} s");
    // The setting in millimetres, and a diameter that nobody gave: the time is not known.
    let (seconds, verified) = cutting_time(
        "haas-vf2",
        &["settings.\"Setting 34\"=\"101.6 mm\""],
        &program("G91 G1 A90. F10."),
    );
    assert!((seconds - 60.0 * pi / 10.0).abs() < 1e-9 && verified, "{seconds} s");
    for cut in ["G91 G1 A90. F10.", "G91 G1 X1. A90. F10."] {
        assert!(!cutting_time("haas-vf2", &[], &program(cut)).1, "{cut}");
    }
    // In inverse time nothing depends on it, nor does a rapid.
    for cut in ["G91 G93 G1 X1. A90. F10.", "G91 G0 A90.\nG1 X1. F10."] {
        assert!(cutting_time("haas-vf2", &[], &program(cut)).1, "{cut}");
    }
}

/// The first rotary axis that the machine has is the 4th: B on a UMC, and A where there is one.
#[test]
fn the_first_rotary_axis_of_a_haas_is_its_fourth() {
    let pi = std::f64::consts::PI;
    for (cut, expected_s) in [
        // The issue's own: a turn of C at 1000 mm/min on 60 mm.
        ("G91 G1 C360. F1000.", 60.0 * pi * 60.0 / 1000.0),
        ("G91 G1 B90. F100.", 60.0 * pi * 101.6 / 4.0 / 100.0),
        ("G91 G1 B90. C180. F100.", 60.0 * (pi * 25.4).hypot(pi * 30.0) / 100.0),
    ] {
        let program = format!("%\nO1\nG21 G94 S100 M3\nG0 X0 B0 C0\n{cut}\nM30\n%\n");
        let (seconds, verified) = cutting_time("haas-umc750", &[FOURTH, FIFTH], &program);
        assert!((seconds - expected_s).abs() < 1e-9, "{cut}: {seconds} s, not {expected_s}");
        assert!(verified, "{cut}");
    }
    let program = "%\nO1\nG21 G94 S100 M3\nG0 X0 A0 B0\nG91 G1 B90. F100.\nM30\n%\n";
    let with_a = ["axes.B.max_velocity=\"100 deg/s\"", FOURTH, FIFTH];
    let (seconds, _) = cutting_time("haas-vf2", &with_a, program);
    assert!((seconds - 60.0 * pi * 15.0 / 100.0).abs() < 1e-9, "{seconds} s");
}

/// LinuxCNC: X, Y and Z alone where any of them moves; degrees per minute otherwise (rs274).
#[test]
fn linuxcnc_counts_the_linear_axes_alone() {
    for (cut, expected_s) in [
        ("G91 G1 X200 A400 F300", 40.0),
        ("G91 G1 A400 F300", 80.0),
        ("G91 G93 G1 X20 A40 F4", 15.0),
    ] {
        let program = format!("G21 G94 S100 M3\nG0 X0 A0\n{cut}\nM2\n");
        let (seconds, _) = cutting_time("linuxcnc-mill", &[], &program);
        assert!((seconds - expected_s).abs() < 1e-9, "{cut}: {seconds} s, not {expected_s}");
    }
}

/// The setting changes the rule on every control.
#[test]
fn the_rule_is_a_setting() {
    let program = "%\nO1\nG20 G94 S100 M3\nG0 X0 A0\nG91 G1 X3. A4. F1.\nM30\n%\n";
    for (value, expected_s) in [
        ("linear-axes", 180.0),
        ("degrees-as-units", 300.0),
        // 3 in and 4 mm at 1 in a minute.
        ("degrees-as-mm", 60.0 * (3f64 * 25.4).hypot(4.0) / 25.4),
    ] {
        for machine in ["fanuc-30i", "haas-vf2", "mitsubishi-m700"] {
            let (seconds, _) =
                cutting_time(machine, &[&format!("settings.rotary_feed={value}")], program);
            assert!((seconds - expected_s).abs() < 1e-9, "{machine} {value}: {seconds} s");
        }
    }
}
