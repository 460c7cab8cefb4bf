//! `[motion]`, `[times]` and the limits of rapids: read, written, refused.

use chordal_machine::{Machine, MotionSettings, RotaryAxis, RotaryTarget};

const FILE: &str = "\
control = \"haas\"
[axes.X]
max_velocity = \"20 m/min\"
max_acceleration = \"2 m/s^2\"
rapid_acceleration = \"4 m/s^2\"
rapid_jerk = \"200 m/s^3\"
[axes.A]
rapid_acceleration = \"180 deg/s^2\"
[motion]
servo_period = \"0.5 ms\"
feed_override = \"80 %\"
rapid_override = 0.25
corner_tolerance = \"0.001 in\"
exact_path_tolerance = \"2 um\"
rapid_corner_tolerance = \"5 mm\"
rotary_tolerance = \"0.02 deg\"
[times]
spindle_per_1000_rpm = \"0.3 s\"
spindle_orient = \"1.5 s\"
probe = \"100 ms\"
m_code = \"0.2 s\"
[rotary.A]
turns = \"table\"
reversed = true
center.Y = \"1 in\"
[rotary.C]
turns = \"head\"
";

fn read(text: &str) -> Machine {
    Machine::from_toml("mine.toml", text, &|_| Err(String::new())).expect("a machine")
}

#[test]
fn every_key_is_read() {
    let machine = read(FILE);
    let motion = machine.motion;
    assert_eq!(motion.servo_period_s, Some(0.0005));
    assert_eq!(motion.feed_override, Some(0.8));
    assert_eq!(motion.rapid_override, Some(0.25));
    assert_eq!(motion.corner_tolerance_mm, Some(0.0254));
    assert_eq!(motion.exact_path_tolerance_mm, Some(0.002));
    assert_eq!(motion.rapid_corner_tolerance_mm, Some(5.0));
    assert_eq!(motion.rotary_tolerance_rad, Some(0.02_f64.to_radians()));
    let times = machine.times;
    assert_eq!(times.spindle_per_1000_rpm_s, Some(0.3));
    assert_eq!(times.spindle_orient_s, Some(1.5));
    assert_eq!((times.probe_s, times.m_code_s), (Some(0.1), Some(0.2)));
    let x = machine.axes[0].expect("X");
    assert_eq!((x.max_acceleration, x.rapid_acceleration), (Some(2000.0), Some(4000.0)));
    assert_eq!(x.rapid_jerk, Some(200_000.0));
    let [about_x, about_y, about_z] = machine.rotary;
    assert_eq!((about_x.turns, about_x.reversed), (Some(RotaryTarget::Table), true));
    assert_eq!(about_x.center_mm, [None, Some(25.4), None]);
    assert_eq!(about_y, RotaryAxis::default());
    assert_eq!(about_z.turns, Some(RotaryTarget::Head));
    let a = machine.axes[3].expect("A");
    assert_eq!(a.rapid_acceleration, Some(std::f64::consts::PI));
}

#[test]
fn what_is_written_is_read_back() {
    let machine = read(FILE);
    let again = read(&machine.to_toml());
    assert_eq!(again.rotary, machine.rotary);
    assert_eq!(again.motion, machine.motion);
    assert_eq!(again.times, machine.times);
    assert_eq!(again.axes, machine.axes);
}

#[test]
fn defaults_hold_where_nothing_is_said() {
    let motion = MotionSettings::default();
    assert_eq!(motion.servo_period_s(), 0.001);
    assert_eq!((motion.feed_override(), motion.rapid_override()), (1.0, 1.0));
    assert_eq!((motion.corner_tolerance_mm(), motion.exact_path_tolerance_mm()), (0.05, 0.0));
    assert_eq!(motion.rotary_tolerance_rad(), 0.01_f64.to_radians());
}

#[test]
fn slips_are_told_with_their_place() {
    for (line, message) in [
        ("feed_override = 80", "`feed_override` is 8000 %: it must be above 0 and at most 200 %"),
        ("feed_override = \"0 %\"", "`feed_override` is 0 %: it must be above 0 and at most 200 %"),
        (
            "rapid_override = \"-5 %\"",
            "`rapid_override` is -5 %: it must be above 0 and at most 200 %",
        ),
        (
            "feed_override = \"fast\"",
            "`feed_override` takes a percentage or a fraction; this is a text",
        ),
        ("feed_override = nan", "a control cannot hold the number `nan`"),
        ("servo_period = \"0 ms\"", "`servo_period` must be more than zero"),
        ("servo_period = \"1 mm\"", "`servo_period` takes a time; `1 mm` is a length"),
        ("corner_tolerance = \"-1 mm\"", "`corner_tolerance` cannot be negative"),
        ("corner_tolerance = 0.05", "`corner_tolerance` takes a length; `0.05` has no unit"),
        ("rotary_tolerance = \"1 mm\"", "`rotary_tolerance` takes an angle; `1 mm` is a length"),
        ("corner_tolerence = \"1 mm\"", "`motion` has no key `corner_tolerence`"),
    ] {
        let text = format!("control = \"haas\"\n[motion]\n{line}\n");
        let errors =
            Machine::from_toml("mine.toml", &text, &|_| Err(String::new())).expect_err(line);
        assert_eq!(errors.len(), 1, "{line}");
        assert_eq!(errors[0].message, message);
        assert_eq!(errors[0].line(), Some(3), "{line}");
        assert!(!errors[0].underlined().is_empty(), "{line}");
    }
}

#[test]
fn limits_of_axes_must_be_positive_numbers() {
    for (value, message) in [
        ("\"0 mm/s^2\"", "`max_acceleration` must be more than zero"),
        ("\"-3 m/s^2\"", "`max_acceleration` must be more than zero"),
        (
            "\"nan mm/s^2\"",
            "`max_acceleration` takes an acceleration; `nan mm/s^2` does not start with a number",
        ),
        (
            "\"1e999 mm/s^2\"",
            "`max_acceleration` takes an acceleration; `1e999 mm/s^2` is out of range",
        ),
    ] {
        let text = format!("control = \"haas\"\n[axes.X]\nmax_acceleration = {value}\n");
        let errors =
            Machine::from_toml("mine.toml", &text, &|_| Err(String::new())).expect_err(value);
        assert_eq!(errors[0].message, message);
        assert_eq!(errors[0].line(), Some(3));
    }
}

#[test]
fn a_percentage_of_a_command_line_needs_no_quotes() {
    let mut machine = read(FILE);
    machine.set("motion.feed_override = 120 %").expect("taken");
    assert_eq!(machine.motion.feed_override, Some(1.2));
    let error = machine.set("motion.feed_override = 50").expect_err("refused");
    assert_eq!(error.help.as_deref(), Some("did you mean \"50 %\"?"));
}
