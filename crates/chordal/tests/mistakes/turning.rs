//! Threads, cutting speeds and turrets of lathes.

use std::f64::consts::PI;

use chordal::Severity;

use crate::{LATHES, check, check_assumed, expect, mistakes, only, says};

const METRIC: &[&str] = &["settings.units='mm'"];

/// Lathes whose G76 is written in two blocks.
const TWO_BLOCKS: &[&str] = &["fanuc-lathe", "mitsubishi-lathe"];

fn turned(speed: &str, body: &str) -> String {
    format!("G21 G18 G40 G99\nT0101\n{speed}\n{body}\nG0 X200. Z100.\nM30\n")
}

fn linuxcnc(speed: &str, body: &str) -> String {
    format!("G7 G21 G18 G40 G90 G95\nT1 M6\n{speed}\n{body}\nG0 X200. Z100.\nM2\n")
}

#[test]
fn a_thread_that_is_faster_than_its_axis_is_an_error() {
    // 3 mm at 5000 rpm are 15 m/min, and the machines do 12 m/min.
    let most = &["settings.units='mm'", "spindle.max='6000 rpm'"];
    let threads = ["G0 X28. Z6.\nG32 Z-20. F3.", "G0 X28. Z6.\nG92 X23.2 Z-25. F3."];
    for thread in threads {
        for machine in LATHES {
            let found = check(machine, most, &turned("G97 S5000 M3", thread));
            says(
                &only(&found, "CH407"),
                Severity::Error,
                &["lead of 3 mm", "5000 rpm", "15000 mm/min", "12000 mm/min"],
            );
            let help = only(&found, "CH407").help.unwrap_or_default();
            assert!(help.contains("S4000"), "{help}");
        }
        expect(LATHES, most, &turned("G97 S4000 M3", thread), &[]);
    }
    let packed = |s: u32| {
        turned(
            &format!("G97 S{s} M3"),
            "G0 X28. Z6.\nG76 P021060 Q100 R100\nG76 X20.376 Z-25. P1812 Q500 F3.",
        )
    };
    expect(TWO_BLOCKS, most, &packed(5000), &["CH407 6"]);
    expect(TWO_BLOCKS, most, &packed(3900), &[]);
    let haas =
        |s: u32| turned(&format!("G97 S{s} M3"), "G0 X28. Z6.\nG76 X20.376 Z-25. K1.812 D0.5 F3.");
    expect(&["haas-lathe"], most, &haas(5000), &["CH407 5"]);
    expect(&["haas-lathe"], most, &haas(3900), &[]);
    // The lead grows from 3 mm by 0.5 mm a turn: at 26 mm it is 5.916 mm (9 + 2 x 0.5 x 26 = 35).
    let changing = turned("G97 S2500 M3", "G0 X28. Z6.\nG34 Z-20. F3. K.5");
    let found = check("fanuc-lathe", most, &changing);
    says(&only(&found, "CH407"), Severity::Error, &["5.916 mm", "2500 rpm"]);
    expect(&["fanuc-lathe"], most, &changing.replace("S2500", "S2000"), &[]);
    // LinuxCNC's machine has no largest feed, and 8 m/min in Z.
    for thread in ["G0 X28. Z6.\nG33 Z-20. K3.", "G0 X28. Z6.\nG76 P3. Z-25. I-4. J.5 K3.6 Q29.5"] {
        let found = check("linuxcnc-lathe", &[], &linuxcnc("G97 S3000 M3", thread));
        says(&only(&found, "CH407"), Severity::Error, &["9000 mm/min", "8000 mm/min", "Z axis"]);
        expect(&["linuxcnc-lathe"], &[], &linuxcnc("G97 S2600 M3", thread), &[]);
    }
    // Where nobody named the machine it is a note about its limits.
    let program = turned("G97 S4000 M3", threads[0]).replace("F3.", "F4.");
    assert_eq!(mistakes(&check_assumed("fanuc-lathe", &program), &program), ["CH608 1"]);
}

#[test]
fn a_feed_per_revolution_is_held_against_the_machine_at_the_smallest_diameter() {
    // 200 m/min at 20 mm are 3183 rpm: 3 mm a turn are 9549 mm/min, and at 10 mm with 4500 rpm 13500 mm/min.
    let cut = |x: u32| turned("G50 S4500\nG96 S200 M3", &format!("G0 X60. Z2.\nG1 X{x}. F3."));
    let most = &["settings.units='mm'", "spindle.max='4500 rpm'"];
    expect(LATHES, most, &cut(20), &[]);
    expect(LATHES, most, &cut(10), &["CH407 6"]);
    let found = check("fanuc-lathe", most, &cut(10));
    says(&only(&found, "CH407"), Severity::Error, &["13500 mm/min", "12000 mm/min", "4500 rpm"]);
}

#[test]
fn a_cutting_speed_without_a_limit_is_said_where_the_machine_is_at_its_maximum() {
    let facing = |speed: &str, x: &str| turned(speed, &format!("G0 X60. Z0\nG1 X{x} F.2"));
    for (machine, rpm) in
        [("fanuc-lathe", 4500.0), ("mitsubishi-lathe", 4500.0), ("haas-lathe", 4000.0)]
    {
        // D = V / (pi n)
        let diameter = 200_000.0 / (PI * rpm);
        let found = check(machine, METRIC, &facing("G96 S200 M3", "-1.6"));
        let (d, n) = (format!("{diameter:.3} mm"), format!("{rpm} rpm"));
        says(&only(&found, "CH613"), Severity::Warning, &[&d, &n, "the centre"]);
        assert!(only(&found, "CH613").help.unwrap_or_default().contains("G50 S"));
        expect(&[machine], METRIC, &facing("G50 S2500\nG96 S200 M3", "-1.6"), &[]);
        // Never so fast: just above the diameter.
        expect(&[machine], METRIC, &facing("G96 S200 M3", &format!("{:.3}", diameter + 0.01)), &[]);
        expect(
            &[machine],
            METRIC,
            &facing("G96 S200 M3", &format!("{:.3}", diameter - 0.01)),
            &["CH613 5"],
        );
        expect(&[machine], METRIC, &facing("G97 S1500 M3", "-1.6"), &[]);
        // Once for each tool; an arc towards the centre, and one that stays away from it.
        let arc = |x: u32, r: u32| {
            turned("G96 S200 M3", &format!("G0 X60. Z0\nG1 X40. F.2\nG2 X{x}. Z-10. R{r}."))
        };
        expect(&[machine], METRIC, &arc(20, 20), &[]);
        expect(&[machine], METRIC, &arc(10, 20), &["CH613 6"]);
    }
    // Inside of a cycle, and by its finishing pass.
    let rough = turned(
        "G96 S200 M3",
        "G0 X62. Z2.\nG72 W2. R1.\nG72 P10 Q20 U.4 W.2 F.3\nN10 G0 Z-10.\nG1 X0 F.1\nN20 Z2.",
    );
    let found = check("fanuc-lathe", METRIC, &rough);
    assert_eq!(mistakes(&found, &rough).first().map(String::as_str), Some("CH613 6"), "{found:#?}");
    // In other systems of G codes it is G92 S.
    let system_b = "G21 G18 G40 G95\nT0101\nG96 S200 M3\nG0 X60. Z0\nG1 X-1.6 F.2\nM30\n";
    let found = check("fanuc-lathe-b", METRIC, system_b);
    assert!(only(&found, "CH613").help.unwrap_or_default().contains("G92 S"), "{found:#?}");
    expect(&["fanuc-lathe-b"], METRIC, &system_b.replace("G96", "G92 S2500\nG96"), &[]);
    // LinuxCNC limits it by D of the block.
    let program = |speed: &str| linuxcnc(speed, "G0 X60. Z0\nG1 X-1.6 F.2");
    let found = check("linuxcnc-lathe", &[], &program("G96 S200 M3"));
    says(&only(&found, "CH613"), Severity::Warning, &["3000 rpm"]);
    assert!(only(&found, "CH613").help.unwrap_or_default().contains("G96 D"));
    expect(&["linuxcnc-lathe"], &[], &program("G96 D2500 S200 M3"), &[]);
}

#[test]
fn of_a_machine_that_is_not_known_only_the_centre_is_said() {
    let facing = |x: &str| turned("G96 S200 M3", &format!("G0 X60. Z0\nG1 X{x} F.2"));
    let found = check_assumed("fanuc-lathe", &facing("-1.6"));
    let found = only(&found, "CH613");
    says(&found, Severity::Warning, &["the centre"]);
    assert!(!found.message.contains("4500"), "{}", found.message);
    let near = facing("5.");
    assert_eq!(mistakes(&check_assumed("fanuc-lathe", &near), &near), Vec::<String>::new());
}

#[test]
fn a_thread_at_a_cutting_speed_is_a_warning() {
    let speeds = ("G50 S2500\nG96 S120 M3", "G97 S800 M3");
    let threads = [
        (LATHES, "G0 X28. Z6.\nG32 Z-20. F2."),
        (LATHES, "G0 X28. Z6.\nG92 X23.2 Z-25. F3.\nX22.8"),
        (TWO_BLOCKS, "G0 X28. Z6.\nG76 P021060 Q100 R100\nG76 X20.376 Z-25. P1812 Q500 F3."),
        (&["haas-lathe"], "G0 X28. Z6.\nG76 X20.376 Z-25. K1.812 D0.5 F3."),
    ];
    for (machines, thread) in threads {
        for machine in machines {
            let found = check(machine, METRIC, &turned(speeds.0, thread));
            says(&only(&found, "CH614"), Severity::Warning, &["G96", "rpm here"]);
        }
        expect(machines, METRIC, &turned(speeds.1, thread), &[]);
        // Back to a speed before the thread.
        expect(
            machines,
            METRIC,
            &turned(speeds.0, thread).replace("G0 X28.", "G97 S800\nG0 X28."),
            &[],
        );
    }
    for thread in ["G0 X28. Z6.\nG33 Z-20. K2.", "G0 X28. Z6.\nG76 P3. Z-25. I-4. J.5 K3.6 Q29.5"] {
        let found = check("linuxcnc-lathe", &[], &linuxcnc("G96 D2000 S120 M3", thread));
        says(&only(&found, "CH614"), Severity::Warning, &["G96"]);
        expect(&["linuxcnc-lathe"], &[], &linuxcnc("G97 S800 M3", thread), &[]);
    }
}

#[test]
fn a_hole_in_the_centre_at_a_cutting_speed_is_a_warning() {
    let speeds = ("G50 S2500\nG96 S120 M3", "G97 S800 M3");
    let holes = [
        (LATHES, "G0 X0 Z5.\nG1 Z-30. F.1\nG0 Z5."),
        (LATHES, "G0 X0 Z5.\nG1 Z-10. F.1\nG0 Z2.\nG0 Z-9.\nG1 Z-20.\nG0 Z5."),
        (LATHES, "G0 X0 Z5.\nG74 R1.\nG74 Z-40. Q12000 F.15"),
        (TWO_BLOCKS, "G0 X0 Z5.\nG83 Z-30. R-2. Q5000 F.1\nG80"),
        (TWO_BLOCKS, "G0 X0 Z5.\nG84 Z-15. R-2. F1.5\nG80"),
        (&["haas-lathe"], "G0 X0 Z5.\nG83 Z-30. R2. Q5. F.1\nG80"),
        (&["haas-lathe"], "G0 X0 Z5.\nG84 Z-15. R2. F1.5\nG80"),
    ];
    for (machines, hole) in holes {
        for machine in machines {
            let hole = if *machine == "haas-lathe" {
                hole.replace("G74 R1.\nG74 Z-40. Q12000", "G74 Z-40. K12.")
            } else {
                hole.to_string()
            };
            let found = check(machine, METRIC, &turned(speeds.0, &hole));
            says(&only(&found, "CH615"), Severity::Warning, &["2500 rpm"]);
            expect(&[machine], METRIC, &turned(speeds.1, &hole), &[]);
        }
    }
    // A contour that begins in the centre, a face that ends there, and a hole that is bored away from it.
    for right in [
        "G0 X0 Z2.\nG1 Z0 F.1\nG3 X20. Z-10. R10.\nG1 Z-20.",
        "G0 X60. Z0\nG1 X0 F.1\nG1 Z2.\nG0 X60.",
        "G0 X30. Z2.\nG1 Z-20. F.1\nG0 Z2.",
    ] {
        expect(LATHES, METRIC, &turned(speeds.0, right), &[]);
    }
    let found = check(
        "linuxcnc-lathe",
        &[],
        &linuxcnc("G96 D2000 S120 M3", "G0 X0 Z5.\nG1 Z-30. F.1\nG0 Z5."),
    );
    says(&only(&found, "CH615"), Severity::Warning, &["2000 rpm"]);
}

#[test]
fn the_height_of_a_thread_is_held_against_its_lead() {
    let fanuc = |words: &str| {
        turned(
            "G97 S800 M3",
            &format!("G0 X28. Z6.\nG76 P021060 Q100 R100\nG76 X20.376 Z-25. {words}"),
        )
    };
    for right in
        ["P1840 Q500 F3.", "P1812 Q300 F3.", "P613 Q200 F1.", "P613 Q200 F4.", "P870 Q200 F1."]
    {
        expect(TWO_BLOCKS, METRIC, &fanuc(right), &[]);
    }
    for wrong in ["P184 Q150 F3.", "P18400 Q500 F3.", "P1840 Q2000 F3.", "P1840 Q500 F1."] {
        expect(TWO_BLOCKS, METRIC, &fanuc(wrong), &["CH617 6"]);
    }
    let found = check("fanuc-lathe", METRIC, &fanuc("P184 Q150 F3."));
    says(
        &only(&found, "CH617"),
        Severity::Warning,
        &["0.184 mm", "0.061 times", "3 mm", "1.84 mm"],
    );
    // A point: read as millimetres here, and refused or left out elsewhere.
    expect(&["fanuc-lathe"], METRIC, &fanuc("P1.84 Q.5 F3."), &["CH617 6"]);
    expect(
        &["fanuc-lathe"],
        &["settings.units='mm'", "settings.\"point in G76\"='allowed'"],
        &fanuc("P1.84 Q.5 F3."),
        &[],
    );
    expect(&["mitsubishi-lathe"], METRIC, &fanuc("P1.84 Q.5 F3."), &[]);
    // Inch: 3/4-10 is 0.0613 in high.
    let inch = fanuc("P613 Q180 F.1")
        .replace("G21", "G20")
        .replace("X20.376", "X.627")
        .replace("X28. Z6.", "X.9 Z.2")
        .replace("Z-25.", "Z-1.")
        .replace("X200. Z100.", "X8. Z4.")
        .replace("Q100 R100", "Q30 R30");
    expect(TWO_BLOCKS, METRIC, &inch, &[]);
    expect(TWO_BLOCKS, METRIC, &inch.replace("P613", "P1557"), &["CH617 6"]);
    // The least depth above the height: the control refuses the cycle.
    let least = fanuc("P613 Q200 F1.").replace("Q100", "Q700");
    let found = check("fanuc-lathe", METRIC, &least);
    let refused = found.iter().find(|each| each.severity == Severity::Error).expect("an error");
    assert!(refused.alarm.as_deref().is_some_and(|alarm| alarm.contains("PS0316")), "{refused:#?}");
    let haas =
        |words: &str| turned("G97 S800 M3", &format!("G0 X28. Z6.\nG76 X20.376 Z-25. {words}"));
    expect(&["haas-lathe"], METRIC, &haas("K1.84 D.5 F3."), &[]);
    expect(&["haas-lathe"], METRIC, &haas("K.184 D.1 F3."), &["CH617 5"]);
    expect(&["haas-lathe"], METRIC, &haas("K18.4 D.5 F3."), &["CH617 5"]);
    expect(&["haas-lathe"], METRIC, &haas("K1.84 D2. F3."), &["CH617 5"]);
    let cnc = |words: &str| {
        linuxcnc("G97 S800 M3", &format!("G0 X28. Z6.\nG76 Z-25. I-4. {words} Q29.5"))
    };
    // Diameters here.
    expect(&["linuxcnc-lathe"], &[], &cnc("P3. J.5 K3.68"), &[]);
    expect(&["linuxcnc-lathe"], &[], &cnc("P3. J.1 K.368"), &["CH617 5"]);
    expect(&["linuxcnc-lathe"], &[], &cnc("P1. J.5 K3.68"), &["CH617 5"]);
}

/// A shaft, and a second tool that comes when the first stands at these places.
fn two_tools(before: &str) -> String {
    format!(
        "G21 G18 G40 G99\nT0101\nG97 S800 M3\nG0 X62. Z2.\nG1 X50. F.2\nZ-40.\nX62.\n{before}\nT0202\nG0 X48. Z2.\nG1 Z-40.\nG0 X200. Z100.\nM30\n"
    )
}

#[test]
fn a_turret_that_turns_in_the_part_is_a_warning() {
    for machine in LATHES {
        for right in ["G0 X200. Z100.", "G28 U0 W0", "G0 X70.", "G0 Z5.", "G0 X62. Z2."] {
            expect(&[machine], METRIC, &two_tools(right), &[]);
        }
        let inside = two_tools("G0 X52. Z5.\nG0 Z-10.\nG1 X48.\nG0 X49.");
        let found = check(machine, METRIC, &inside);
        assert_eq!(mistakes(&found, &inside), ["CH616 12"], "{machine} {found:#?}");
        // The first cut was along 50 mm.
        says(
            &only(&found, "CH616"),
            Severity::Warning,
            &["tool 1 is at X 49 mm, Z -10 mm", "0.5 mm inside"],
        );
        // The tool number stays: nothing turns.
        expect(&[machine], METRIC, &inside.replace("T0202", "T0111"), &[]);
        // A clearance of the machine file: 3 mm in front of the face, and 3 mm beside the shoulder.
        for (before, distance) in
            [("G0 X20.\nG0 X20. Z5.", "3 mm from"), ("G0 X68. Z-40.", "3 mm from")]
        {
            let settings = &["settings.units='mm'", "turret_clearance='5 mm'"];
            let found = check(
                machine,
                settings,
                &two_tools(before).replace("X62.\nG0 X20.\n", "X62.\nG0 Z10.\n"),
            );
            says(&only(&found, "CH616"), Severity::Warning, &[distance]);
        }
    }
}

#[test]
fn the_tool_that_comes_is_looked_at_where_both_offsets_are_known() {
    // The second tool is 60 mm longer in Z: at Z25 of the first its tip is at Z-35.
    let offsets = &[
        "settings.units='mm'",
        "tools.1.offset.X='-100 mm'",
        "tools.1.offset.Z='-80 mm'",
        "tools.2.offset.X='-100 mm'",
        "tools.2.offset.Z='-20 mm'",
    ];
    let program = two_tools("G0 X30. Z25.");
    let found = check("fanuc-lathe", offsets, &program);
    says(
        &only(&found, "CH616"),
        Severity::Warning,
        &["tool 2 comes to X 30 mm, Z -35 mm", "10 mm inside"],
    );
    expect(&["fanuc-lathe"], offsets, &two_tools("G0 X30. Z100."), &[]);
    expect(&["fanuc-lathe"], METRIC, &program, &[]);
}

#[test]
fn a_place_that_is_not_known_and_another_part_say_nothing() {
    let inside = two_tools("G0 X52. Z5.\nG0 Z-10.\nG1 X48.\nG0 X49.");
    // The cuts are in another work offset.
    expect(LATHES, METRIC, &inside.replace("T0202", "G55\nT0202"), &[]);
    // Only X went home.
    expect(LATHES, METRIC, &inside.replace("G0 X49.", "G28 U0"), &[]);
}
