//! Programs of lathes on the other lathes.

use std::collections::BTreeMap;

use chordal::Job;
use chordal::control::Units;
use chordal_rewrite::convert::{Conversion, ConversionOptions, convert};
use chordal_rewrite::restart::restart;
use chordal_rewrite::{TransformStep, transform};

use super::{job, job_of, machine, suite_programs, text_of, verdict};

/// A machine of each control.
const LATHES: [&str; 4] = ["fanuc-lathe", "haas-lathe", "mitsubishi-lathe", "linuxcnc-lathe"];

/// Every lathe program of the suite and of the examples on every other lathe, and the new program back again.
#[test]
fn all_programs() {
    let mut table = String::new();
    let (mut proved, mut back, mut all) = (0, 0, 0);
    let mut paths = Vec::new();
    for root in ["tests/suite", "examples"] {
        paths.extend(LATHES.iter().flat_map(|name| programs(root, name)));
    }
    for path in paths {
        let old = job_of(&text_of(&path), &[]);
        table += &format!("{path}\n");
        for to in LATHES {
            if old.profile().name == to {
                continue;
            }
            let found = convert(&old, &machine(with_axes(&old, to)), &ConversionOptions::default());
            all += 1;
            proved += usize::from(found.holds());
            table += &format!("    {to}: {}{}", verdict(&found), other_passes(&found));
            if found.holds() {
                let new = found.job("converted").expect("settings of the machine");
                let again = convert(&new, old.machine(), &ConversionOptions::default());
                back += usize::from(again.holds());
                table += &format!("; back: {}", verdict(&again));
            }
            table += "\n";
        }
    }
    table += &format!("\n{proved} of {all} proved, {back} of these back again\n");
    insta::assert_snapshot!(table);
}

/// The machine of a control that has C and Y where the program's own machine has C.
fn with_axes(old: &Job, to: &'static str) -> &'static str {
    match (old.machine().axes[5].is_some(), to) {
        (true, "fanuc-lathe") => "fanuc-lathe-y",
        (true, "haas-lathe") => "haas-lathe-y",
        (_, to) => to,
    }
}

/// Cycles that stay in passes of the new control, by their codes.
fn other_passes(found: &Conversion) -> String {
    let cycles: Vec<&str> = found.passes.iter().map(|one| one.cycle.as_str()).collect();
    match cycles.as_slice() {
        [] => String::new(),
        some => format!(" but for the passes of {}", some.join(" ")),
    }
}

/// The programs of a control in a folder of the project.
#[allow(clippy::disallowed_methods, reason = "tests read folders")]
fn programs(root: &str, name: &str) -> Vec<String> {
    if root == "tests/suite" {
        return suite_programs(&[name]);
    }
    let folder = format!("{root}/{name}");
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(&folder);
    let entries = std::fs::read_dir(path).expect("the examples");
    let names = entries.flatten().map(|entry| entry.file_name());
    let names = names.map(|name| name.to_string_lossy().into_owned());
    let mut names: Vec<String> = names.filter(|name| !name.ends_with(".toml")).collect();
    names.sort();
    names.into_iter().map(|name| format!("{folder}/{name}")).collect()
}

/// The lines of a Fanuc program on another lathe, each proved, without the head that is the same.
fn lines(body: &str, from: &str, to: &str) -> Vec<String> {
    let old = job(body, machine(from));
    let found = convert(&old, &machine(to), &ConversionOptions::default());
    assert!(found.holds(), "{}: {}", verdict(&found), found.text);
    found.text.lines().map(str::to_string).collect()
}

#[test]
fn two_blocks_of_a_cycle_are_one_and_one_is_two() {
    let fanuc = "G21 G18 G40 G99\nT0101\nG97 S800 M3\nG0 X62. Z2.\nG71 U2.5 R1.\nG71 P10 Q20 U.6 W.2 F.3\n\
                 N10 G0 X20.\nG1 Z-20.\nN20 X62.\nG70 P10 Q20\nG0 X28. Z6.\nG76 P011060 Q100 R0\n\
                 G76 X20.32 Z-19. P1840 Q500 F3.\nM30\n";
    let haas = lines(fanuc, "fanuc-lathe", "haas-lathe");
    assert!(haas.iter().any(|line| line == "G71 P10 Q20 U.6 W.2 F.3 D2.5"), "{haas:?}");
    assert!(haas.iter().any(|line| line == "G76 X20.32 Z-19. K1.84 D.5 F3. A60"), "{haas:?}");
    assert_eq!(haas.iter().filter(|line| line.starts_with("G7")).count(), 3, "{haas:?}");
    let again = lines(&haas.join("\n"), "haas-lathe", "fanuc-lathe");
    for line in [
        "G71 U2.5 R1.27",
        "G71 P10 Q20 U.6 W.2 F.3",
        "G76 P001060 Q0 R0.",
        "G76 X20.32 Z-19. P1840 Q500 F3.",
    ] {
        assert!(again.iter().any(|own| own == line), "{line}: {again:?}");
    }
}

#[test]
fn stations_speeds_and_distances_of_another_control() {
    let fanuc = "G21 G18 G40 G99\nT0111\nG50 S2500\nG96 S200 M3\nG0 X62. Z2.\nG1 X50. W-3. F.2\n\
                 G32 Z-20. F2.\nG28 U0 W0\nT0100\nM30\n";
    let found = lines(fanuc, "fanuc-lathe", "linuxcnc-lathe");
    let expected = [
        "G7",
        "G21 G18 G40 G95",
        "T1 M6 G43 H11",
        "G96 D2500 S200 M3",
        "G0 X62. Z2.",
        "G1 X50. Z-1. F.2",
        "G33 Z-20. K2.",
        "G91 G28 X0 Z0",
        "G90",
        "G49",
        "M30",
    ];
    let own: Vec<&str> = found
        .iter()
        .map(String::as_str)
        .filter(|line| !line.starts_with(['%', 'O', '(']))
        .collect();
    assert_eq!(own, expected);
}

#[test]
fn radii_become_diameters_and_systems_of_codes_their_own() {
    let radii = "G21 G8 G18 G40 G90 G94\nT1 M6 G43\nS500 M3\nG0 X31 Z2\nG1 X25.5 F100\nG3 X27 Z0.5 K-1.5\nM2\n";
    let found = lines(radii, "linuxcnc-lathe", "haas-lathe");
    for line in ["T0101", "G0 X62. Z2.", "G1 X51. F100", "G3 X54. Z0.5 K-1.5"] {
        assert!(found.iter().any(|own| own == line), "{line}: {found:?}");
    }
    let mut system_b = machine("fanuc-lathe");
    system_b.set("settings.\"No. 3401\"=\"B\"").expect("a setting");
    let text = "G21 G18 G40 G99\nT0101\nG50 S3000\nG97 S800 M3\nG0 X62. Z2.\nG90 X60. Z-20. F.2\nG0 U2.\nM30\n";
    let old = job(text, machine("fanuc-lathe"));
    let found = convert(&old, &system_b, &ConversionOptions::default());
    assert!(found.holds(), "{}", verdict(&found));
    for line in ["G21 G18 G40 G95", "G92 S3000", "G77 X60. Z-20. F.2"] {
        assert!(found.text.lines().any(|own| own == line), "{line}: {}", found.text);
    }
}

#[test]
fn passes_of_cycles_that_stay_are_measured() {
    let text = "G21 G18 G40 G99\nT0101\nG97 S800 M3\nG0 X62. Z2.\nG71 U2.5 R1.\nG71 P10 Q20 U.6 W.2 F.3\n\
                N10 G0 X20.\nG1 Z-20.\nN20 X62.\nM30\n";
    let old = job(text, machine("fanuc-lathe"));
    let found = convert(&old, &machine("haas-lathe"), &ConversionOptions::default());
    let [change] = found.passes.as_slice() else { panic!("{:?}", found.passes) };
    assert_eq!((change.lines[0], change.cycle.as_str()), (6, "G71"));
    // Levels from X62.6 down to 20.6 in steps of 5: eight, and the contour; from X62: eight as well.
    assert_eq!(change.readings.map(|reading| reading.cuts), [9, 9]);
    let exact = ConversionOptions { exact_cycles: true, ..ConversionOptions::default() };
    let written = convert(&old, &machine("haas-lathe"), &exact);
    assert!(written.holds() && written.passes.is_empty());
    assert!(!written.text.lines().any(|line| line.starts_with("G71")), "{}", written.text);
}

/// A contour that the last pass leaves elsewhere is no pass of its own: the proof fails, and the cycle is written out.
#[test]
fn another_last_pass_is_written_out() {
    let text = "G21 G18 G40 G99\nT0101\nG97 S800 M3\nG0 X28. Z6.\nG76 P010560 Q100 R0\n\
                G76 X20.32 Z-19. P1840 Q500 F3.\nM30\n";
    let old = job(text, machine("fanuc-lathe"));
    let found = convert(&old, &machine("haas-lathe"), &ConversionOptions::default());
    assert!(found.holds() && found.passes.is_empty(), "{}", verdict(&found));
    assert!(found.text.contains("G32 Z-17.5 F3."), "{}", found.text);
}

/// Every lathe program of the suite and of the examples, moved along Z, in the other unit, mirrored and scaled.
#[test]
fn all_programs_changed_in_place() {
    let steps = [
        ("shift Z", TransformStep::Shift([0.0, 0.0, -12.5])),
        ("inch", TransformStep::Units(Units::Inch)),
        ("mm", TransformStep::Units(Units::Millimetre)),
        ("mirror X", TransformStep::MirrorX),
        ("scale 2", TransformStep::Scale(2.0)),
        ("shift X", TransformStep::Shift([1.0, 0.0, 0.0])),
    ];
    let mut table = String::new();
    for root in ["tests/suite", "examples"] {
        for path in LATHES.iter().flat_map(|name| programs(root, name)) {
            let old = job_of(&text_of(&path), &[]);
            table += &format!("{path}\n");
            for (name, step) in &steps {
                let said = match transform(&old, std::slice::from_ref(step)) {
                    Ok(found) if found.certificate.holds() => "proved".to_string(),
                    Ok(found) => {
                        let differences = &found.certificate.comparison.differences;
                        let mut words: Vec<&str> =
                            differences.iter().map(|one| one.category.word()).collect();
                        words.dedup();
                        let words = words.join(", ");
                        format!(
                            "not proved: {}",
                            if words.is_empty() { "not verified" } else { words.as_str() }
                        )
                    }
                    Err(refusal) => format!("refused, line {}: {}", refusal.line, refusal.what),
                };
                table += &format!("    {name}: {said}\n");
            }
        }
    }
    insta::assert_snapshot!(table);
}

/// Every lathe program of the examples, begun at each of its lines.
#[test]
fn all_examples_begun_at_each_line() {
    let mut table = String::new();
    for path in LATHES.iter().flat_map(|name| programs("examples", name)) {
        let text = text_of(&path);
        let old = job_of(&text, &[]);
        let mut proved = 0;
        let mut reasons: BTreeMap<&str, Vec<u32>> = BTreeMap::new();
        for line in 1..=text.lines().count() as u32 {
            match restart(&old, line) {
                Ok(_) => proved += 1,
                Err(refused) => reasons.entry(refused.reason.word()).or_default().push(line),
            }
        }
        table += &format!("{path}: {proved} proved\n");
        for (reason, lines) in reasons {
            let lines: Vec<String> = lines.iter().map(u32::to_string).collect();
            table += &format!("    {reason}: {}\n", lines.join(" "));
        }
    }
    insta::assert_snapshot!(table);
}

const SHAFT: &str = "O1\nG21 G18 G40 G99\nT0101\nG50 S2500\nG96 S200 M3\nG0 X62. Z2. M8\nG71 U2.5 R1.\n\
                     G71 P10 Q20 U.6 W.2 F.3\nN10 G0 X20.\nG1 Z-20. F.1\nN20 X62.\nG0 X100. Z50.\nT0303\nG50 S3500\n\
                     G96 S280 M3\nG0 X62. Z2.\nG70 P10 Q20\nG0 X100. Z50.\nT0505\nG97 S700\nG0 X28. Z6.\n\
                     G76 P021060 Q100 R.05\nG76 X20.32 Z-18. P1840 Q500 F3.\nM30\n%\n";

#[test]
fn a_lathe_begins_with_its_limit_its_speed_and_a_way_in() {
    let old = job(SHAFT, machine("fanuc-lathe"));
    let found = restart(&old, 17).expect("the finishing cycle");
    let head = [
        "G21 G18 G40 G80 G99",
        "T0303",
        "G50 S3500",
        "G96 S280 M3",
        "G0 X62. Z2.",
        "M8",
        "F.3",
        "G0",
    ];
    assert_eq!(found.head, head);
    assert_eq!(found.after_the_end, ["N10 G0 X20.", "G1 Z-20. F.1", "N20 X62."]);
    let text = String::from_utf8(found.text).expect("text");
    let end = text.find("M30").expect("the end");
    assert!(text[end..].contains("N10 G0 X20.\nG1 Z-20. F.1\nN20 X62.\n%"), "{text}");
    // The setup of the thread goes with its second block; that of roughing is not needed any more.
    let thread = restart(&old, 23).expect("the thread");
    assert!(thread.head.contains(&"G76 P021060 Q100 R.05".to_string()), "{:?}", thread.head);
    assert!(!thread.head.iter().any(|line| line.starts_with("G71")), "{:?}", thread.head);
    let inside = restart(&old, 10).expect_err("a line of the contour");
    assert_eq!(inside.reason.word(), "cycle");
    assert_eq!(inside.refusal.what, "the line is in the contour of the cycle in line 8");
}

#[test]
fn a_limit_of_the_spindle_is_no_moved_zero() {
    let text = "O1\nG21 G18 G40 G99\nT101\nG50 S2500\nG97 S900 M3\nG0 X40. Z2.\nG50 S1800\nG1 Z-5. F.1\n\
                G0 X60.\nM30\n";
    let found = restart(&job(text, machine("haas-lathe")), 8).expect("the cut");
    assert!(found.head.contains(&"G50 S1800".to_string()), "{:?}", found.head);
}

#[test]
fn what_a_shift_along_z_changes_in_cycles() {
    let old = job(SHAFT, machine("fanuc-lathe"));
    let found =
        transform(&old, &[TransformStep::Shift([0.0, 0.0, -10.0])]).expect("a shift along Z");
    assert!(found.certificate.holds());
    let text = String::from_utf8(found.text).expect("text");
    for line in ["G71 P10 Q20 U.6 W.2 F.3", "G1 Z-30. F.1", "G76 X20.32 Z-28. P1840 Q500 F3."] {
        assert!(text.lines().any(|own| own == line), "{line}: {text}");
    }
    let inch = transform(&old, &[TransformStep::Units(Units::Inch)]).expect("the other unit");
    let text = String::from_utf8(inch.text).expect("text");
    // 2.5 mm, 200 m/min, 1.84 mm and a lead of 3 mm.
    for word in ["U.0984", "S656", "P724", "F.11811"] {
        assert!(text.contains(word), "{word}: {text}");
    }
    let other =
        transform(&old, &[TransformStep::Shift([1.0, 0.0, 0.0])]).expect_err("another part");
    assert!(other.what.contains("this makes another part"), "{}", other.what);
}

const POLAR: &str = "O1\nG21 G18 G40 G80 G98\nT0101\nG97 S1500 M3 P12\nG28 H0\nG0 X70. Z2. C0\nG1 Z-4. F200.\nG12.1\n\
                     G1 G42 X30. F300.\nC8.66\nG3 X20. C13.66 I-5. J0\nG1 X-30. H-2.\nC1.\nG40 X70.\nG13.1\nG0 Z50.\nM5 P12\nM30\n";

/// The lines of a program on another machine, without the head.
fn on(body: &str, from: &str, to: &str) -> Vec<String> {
    let lines = lines(body, from, to);
    lines.into_iter().filter(|line| !line.starts_with(['%', 'O', '('])).collect()
}

#[test]
fn a_face_is_written_with_the_letters_of_the_other_control() {
    let haas = on(POLAR, "fanuc-lathe-c", "haas-lathe-y");
    let expected = [
        "G21 G18 G40 G80 G98",
        "T0101",
        "G97 M133 P1500",
        "M154",
        "G28 H0",
        "G0 X70. Z2. C0",
        "G1 Z-4. F200.",
        "G112",
        "G17",
        "G1 G42 X30. F300.",
        "Y8.66",
        "G3 X20. Y13.66 I-5. J0",
        "G1 X-30. V-2.",
        "Y1.",
        "G40 X70.",
        "G113",
        "G18",
        "G0 Z50.",
        "M135",
        "M30",
    ];
    assert_eq!(haas, expected);
    let again = on(&haas.join("\n"), "haas-lathe-y", "fanuc-lathe-c");
    for line in [
        "G97 S1500 M3 P12",
        "G12.1",
        "C8.66",
        "G3 X20. C13.66 I-5. J0",
        "G1 X-30. H-2.",
        "G13.1",
        "M5 P12",
    ] {
        assert!(again.iter().any(|own| own == line), "{line}: {again:?}");
    }
    assert!(!again.iter().any(|line| line.contains("M154") || line == "G17"), "{again:?}");
}

#[test]
fn a_cylinder_is_written_in_degrees_and_in_lengths() {
    // Radius 25: 60 degrees are 26.1799 mm. In G18 arcs turn from Z to C, in G19 from Y to Z.
    let fanuc = "O1\nG21 G18 G40 G98\nT0101\nG97 S1500 M3 P12\nG0 X60. Z0 C0\nG1 X48. F100.\nG7.1 C25.\n\
                 G1 C60. F200.\nG3 Z10. C82.918 R10.\nG1 Z20. H10.\nG7.1 C0\nG0 X60.\nM5 P12\nM30\n";
    let haas = on(fanuc, "fanuc-lathe-c", "haas-lathe-y");
    let own = [
        "G19",
        "G107 C0 Y0 R25.",
        "G1 Y26.18 F200.",
        "G2 Z10. Y36.18 R10.",
        "G1 Z20. Y40.543",
        "G107",
        "G18",
    ];
    let from = haas.iter().position(|line| line == "G19").expect("the plane");
    assert_eq!(haas[from..from + own.len()], own, "{haas:?}");
    let again = on(&haas.join("\n"), "haas-lathe-y", "fanuc-lathe-c");
    for line in ["G7.1 C25.", "G1 C60. F200.", "G2 Z10. C82.918 R10.", "G7.1 C0"] {
        assert!(again.iter().any(|own| own == line), "{line}: {again:?}");
    }
}

#[test]
fn a_target_without_c_is_refused() {
    for (from, to) in [("fanuc-lathe-c", "haas-lathe"), ("fanuc-lathe-c", "mitsubishi-lathe")] {
        let found =
            convert(&job(POLAR, machine(from)), &machine(to), &ConversionOptions::default());
        let [refusal] = found.refusals.as_slice() else { panic!("{:?}", found.refusals) };
        assert_eq!(refusal.reason, format!("{to} has no C axis"));
        assert_eq!(refusal.line, 8);
    }
    // A length across is C, whatever letter it has: a machine with C and without Y takes it.
    let haas = on(POLAR, "fanuc-lathe-c", "haas-lathe-y").join("\n");
    let found = convert(
        &job(&haas, machine("haas-lathe-y")),
        &machine("fanuc-lathe-c"),
        &ConversionOptions::default(),
    );
    assert!(found.holds(), "{}", verdict(&found));
}

#[test]
fn live_tools_are_found_where_c_moves_while_the_spindle_turns() {
    // Without P12: the spindle itself cannot turn while C moves.
    let fanuc = "O1\nG21 G18 G40 G80 G98\nT0101\nG97 S900 M3\nG0 X50. Z2.\nG1 Z-10. F100.\nG0 X60. Z5.\nM5\nT0202\n\
                 S1500 M3\nG0 X40. Z5. C0\nG83 Z-12. R-3. F150.\nC90.\nG80\nG0 X66. Z-20.\nG87 X40. R-2. F120.\n\
                 C180.\nG80\nM5\nT0303\nG99 S500 M3\nG0 X40. Z5. C0\nG84 Z-10. R-3. F1.\nC90.\nG80\nM5\nM30\n";
    let haas = on(fanuc, "fanuc-lathe-c", "haas-lathe-y");
    for line in [
        "G97 S900 M3",
        "M133 P1500",
        "M154",
        "G83 Z-12. R2. F150.",
        "G243 X40. R62. F120.",
        "M133 P500",
        "G95 Z-10. R2. F1.",
        "M135",
    ] {
        assert!(haas.iter().any(|own| own.contains(line)), "{line}: {haas:?}");
    }
    assert_eq!(haas.iter().filter(|line| line.as_str() == "M5").count(), 1, "{haas:?}");
}
