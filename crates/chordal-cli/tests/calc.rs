//! `chordal calc`: what is asked, what is answered, what is written.

mod common;

use common::Folder;
use serde_json::Value;

#[track_caller]
fn says(arguments: &str, texts: &[&str]) {
    let arguments: Vec<&str> = arguments.split(' ').collect();
    Folder::new().run(&arguments).ends(0).says(texts);
}

#[track_caller]
fn refuses(arguments: &str, texts: &[&str]) {
    let arguments: Vec<&str> = arguments.split(' ').collect();
    Folder::new().run(&arguments).ends(2).complains(texts);
}

/// The lecture's numbers, by the commands that its reader would type.
#[test]
fn the_lecture() {
    let tool = "--tool 0.5in";
    says(
        &format!("calc corner --angle 60deg --axis y {tool}"),
        &["ΔY = CR·tan(θ/2)", "= 0.25·tan(60°/2)", "= 0.14434 in"],
    );
    says(
        &format!("calc corner --angle 30deg --rise 1in {tool}"),
        &["= 0.06699 in", "b  = h/tan(θ)", "= 1.73205 in", "X  = b − ΔX", "= 1.66506 in"],
    );
    says(&format!("calc corner --angle 75 --axis y {tool}"), &["= 0.19183 in"]);
    says(
        &format!("calc two-angles -a 45deg -b 15deg {tool}"),
        &["sin((a+b)/2)/cos((a−b)/2)", "= 0.12941 in", "cos((a+b)/2)", "= 0.22414 in"],
    );
    says(&format!("calc corner --angle 45deg {tool}"), &["= 0.10355 in"]);
    let arc = format!("calc line-arc --radius 1.25in --height 0.5in {tool}");
    says(&format!("{arc} --corner 1.1454in"), &["Δi − √((R − CR)² − (Δj − CR)²)", "= 0.17715 in"]);
    says(&arc, &["= 1.14564 in", "= 0.1774 in"]);
    says(&format!("calc tangent --angle 45deg {tool}"), &["= 0.17678 in", "= 0.17678 in"]);
}

#[test]
fn units_are_written_or_said() {
    says("calc corner --angle 90deg --tool 10mm", &["ΔX = CR·tan(θ/2)", "= 5 mm"]);
    says("calc corner --angle 90deg --tool 10 --units mm", &["= 5 mm"]);
    says("calc corner --angle 90deg --tool 25.4mm --units inch", &["= 0.5 in"]);
    says("calc chords --radius 10mm --tolerance 0.01mm", &["N = s/α, rounded up", "= 71"]);
    says(
        "calc arc --radius 1in --from 90 --to 0 --cw --start-x 2in --start-y 3in",
        &["G2 X3 Y2 I0 J-1"],
    );
    says("calc thread --diameter 1.5in --tpi 8", &["L   = n·P", "= 0.125 in"]);
    says("calc thread M30x2 --starts 3", &["= 6 mm"]);
    refuses("calc corner --angle 90deg --tool 10", &["`10` has no unit", "10in or", "--units"]);
    refuses("calc corner --angle 90deg --tool 10furlong", &["furlong"]);
}

#[test]
fn what_cannot_be_is_told_with_its_numbers() {
    refuses("calc corner --angle 180deg --tool 10mm", &["180°", "below 180°"]);
    refuses("calc chords --radius 1mm --tolerance 2mm", &["2 mm", "1 mm"]);
    refuses(
        "calc line-arc --radius 10mm --height 12mm --tool 4mm",
        &["12 mm", "10 mm", "calc tangent"],
    );
    refuses("calc thread", &["no thread is given", "M30x2"]);
    refuses("calc thread M31", &["`M31` has no pitch", "ISO 261"]);
    let mill =
        "calc thread-mill M12x1.75 --depth 10mm --feed 200mm/min --spindle 3000 --control haas";
    refuses(&format!("{mill} --tool 11mm"), &["11 mm", "10.1056 mm", "smaller tool"]);
    refuses(&format!("{mill} --tool 8mm --root 9mm"), &["--root"]);
    refuses(&format!("{mill} --tool 8mm --ramp 1/3"), &["1/8 or 1/4"]);
    refuses("calc thread-mill M12x1.75 --control okuma", &["okuma", "fadal, haas"]);
    refuses(
        "calc corner --angle 45deg --tool 10mm -o corner.dxf",
        &["corner.dxf", ".svg and .png"],
    );
}

/// A name with a class shows its limits (ASME B1.1, ISO 965-2); without one it does not.
#[test]
fn a_class_gives_its_limits() {
    says(
        "calc thread 1/4-20-UNC-2A",
        &["dmax", "= 0.2489 in", "= 0.2408 in", "= 0.2164 in", "= 0.2127 in", "ASME B1.1"],
    );
    says("calc thread M10x1.5-6H", &["= 8.376 mm", "= 8.676 mm", "= 9.026 mm", "= 9.206 mm"]);
    says("calc thread 1/4-20", &["Basic sizes without allowance or tolerance"]);
    says("calc thread 1.5-8-UNC", &["UNC of 1.5 in has 6 threads per inch; 1.5-8 is 8-UN."]);
    says(
        "calc thread 1/2-NPT",
        &["ASME B1.20.1", "0.75843 in", "thread-mill writes no program for it"],
    );
    says("calc thread G1/2", &["ISO 228-1", "18.631 mm"]);
    let arguments = ["calc", "thread", "1 1/16-28 9Q"];
    Folder::new().run(&arguments).ends(2).complains(&["`9Q`", "1A 2A 3A", "1B 2B 3B"]);
    let arguments = ["calc", "thread", "1/2 NPT", "-o", "npt.svg"];
    let folder = Folder::new();
    folder.run(&arguments).ends(0);
    assert!(folder.read("npt.svg").contains("60°"));
}

/// What a mill cannot do well, or a program cannot have, is said.
#[test]
fn thread_mill_says_its_limits() {
    let rest = "--depth 0.5in --feed 10in/min --spindle 5000 --control haas --units inch";
    let small = format!("calc thread-mill 5/16-18 --tool 0.2in {rest}");
    let doubt = "HOLES BELOW 3/8 IN MAY NOT BE POSSIBLE OR PRACTICAL TO THREAD MILL";
    says(&small, &[&format!("({doubt})")]);
    says(&format!("{small} -o thread.nc"), &[&doubt.to_lowercase()]);
    let json = Folder::new()
        .run(&format!("{small} --format json").split(' ').collect::<Vec<_>>())
        .ends(0)
        .out;
    let whole: Value = serde_json::from_str(&json).unwrap();
    let notes = whole["notes"].as_array().unwrap();
    assert!(notes.iter().any(|note| note.as_str().unwrap().contains("below 3/8 in")), "{notes:?}");
    // 7/16-14 has a hole of 0.3602, 1/2-13 one of 0.4167; outside there is no hole.
    says(&format!("calc thread-mill 7/16-14 --tool 0.25in {rest}"), &[doubt]);
    for name in ["1/2-13 --tool 0.25in", "5/16-18 --tool 0.2in --outside"] {
        let command = format!("calc thread-mill {name} {rest}");
        let out = Folder::new().run(&command.split(' ').collect::<Vec<_>>()).ends(0).out;
        assert!(!out.contains("HOLES BELOW"), "{out}");
    }
    // An eighth of an eighth of an inch, rounded as on paper.
    let eighth = format!("calc thread-mill 1.5-8 --tool 0.5in --ramp 1/8 {rest} -o thread.nc");
    says(&eighth, &["1/8·0.125", "= 0.01563 in"]);
    let left = format!("calc thread-mill 1/2-13-UNC-2B-LH --tool 0.25in {rest}");
    says(&left, &["LEFT HAND"]);
    refuses(&format!("{left} --hand right"), &["different hands"]);
    refuses(&format!("calc thread-mill 1/2-NPT --tool 0.25in {rest}"), &["taper of 1:16"]);
    refuses(&format!("calc thread-mill G1/2 --tool 0.25in {rest}"), &["55°"]);
}

#[test]
fn json_has_formulas_and_numbers() {
    let arguments = ["calc", "corner", "--angle", "60deg", "--tool", "0.5in", "--format", "json"];
    let out = Folder::new().run(&arguments).ends(0).out;
    let whole: Value = serde_json::from_str(&out).unwrap();
    let step = &whole["steps"][0];
    assert_eq!(step["symbol"], "ΔX");
    assert_eq!(step["formula"], "CR·tan(θ/2)");
    assert_eq!(step["unit"], "in");
    assert!((step["value"].as_f64().unwrap() - 0.25 * 30f64.to_radians().tan()).abs() < 1e-12);
    assert_eq!(step["result"], true);
}

#[test]
fn figures_are_written() {
    let folder = Folder::new();
    let base =
        ["calc", "corner", "--angle", "60deg", "--tool", "0.5in", "-o", "a.svg", "-o", "b.png"];
    folder.run(&base).ends(0);
    let svg = folder.read("a.svg");
    assert!(svg.starts_with("<svg") && svg.contains("ΔX 0.14434"), "{svg}");
    let png = folder.bytes("b.png");
    assert!(png.starts_with(b"\x89PNG"));
    assert_eq!(folder.names(), ["a.svg", "b.png"]);
}

/// A program goes where it is asked to, and `chordal check` has nothing against it.
#[test]
fn a_thread_program_is_written_and_checks_clean() {
    let controls = [
        ("fadal", "fadal-4020"),
        ("haas", "haas-vf2"),
        ("fanuc", "fanuc-30i"),
        ("mitsubishi", "mitsubishi-m700"),
        ("linuxcnc", "linuxcnc-mill"),
    ];
    for (control, machine) in controls {
        let folder = Folder::new();
        let mut arguments = vec![
            "calc",
            "thread-mill",
            "1.5-8",
            "--tool",
            "0.75in",
            "--depth",
            "0.5in",
            "--feed",
            "10in/min",
            "--spindle",
            "1200",
            "--control",
            control,
        ];
        let program = folder.run(&arguments).ends(0).out;
        assert!(
            program.contains("(RIGHT HAND, INSIDE, CLIMB CUT WITH M3: G3, Z UP)")
                || program.contains("; RIGHT HAND, INSIDE, CLIMB CUT WITH M3: G3, Z UP")
        );
        arguments.extend(["-o", "thread.nc", "-o", "thread.svg"]);
        folder.run(&arguments).ends(0).says(&[
            "R  = (D − d)/2",
            "= 0.375 in",
            "written thread.nc",
            "written thread.svg",
        ]);
        assert_eq!(folder.read("thread.nc"), program);
        let done = folder.run(&["check", "thread.nc", "--machine", machine]).ends(0);
        assert!(!done.out.contains("warning["), "{}", done.out);
        assert!(!done.out.contains("error["), "{}", done.out);
    }
}

#[test]
fn a_thread_program_in_json() {
    let folder = Folder::new();
    let arguments = [
        "calc",
        "thread-mill",
        "M30x2",
        "--outside",
        "--hand",
        "left",
        "--cutter",
        "single",
        "--tool",
        "12mm",
        "--depth",
        "24mm",
        "--feed",
        "400mm/min",
        "--spindle",
        "2500",
        "--control",
        "fanuc",
        "--format",
        "json",
    ];
    let whole: Value = serde_json::from_str(&folder.run(&arguments).ends(0).out).unwrap();
    let program = whole["program"].as_str().unwrap();
    assert!(program.contains("(LEFT HAND, OUTSIDE, CLIMB CUT WITH M3: G2, Z UP)"), "{program}");
    assert_eq!(program.matches("(TURN ").count(), 13);
}

#[test]
fn every_subject_has_an_example() {
    for subject in [
        "corner",
        "two-angles",
        "tangent",
        "line-arc",
        "arc-arc",
        "arc",
        "chords",
        "thread",
        "thread-mill",
    ] {
        says(&format!("calc {subject} --help"), &["Examples:", &format!("chordal calc {subject}")]);
    }
}

/// The examples of the help do what they say.
#[test]
fn the_examples_run() {
    for subject in [
        "corner",
        "two-angles",
        "tangent",
        "line-arc",
        "arc-arc",
        "arc",
        "chords",
        "thread",
        "thread-mill",
    ] {
        let help = Folder::new().run(&["calc", subject, "--help"]).ends(0).out;
        let examples = help.split("Examples:").nth(1).unwrap().replace("\\\n", " ");
        let mut tried = 0;
        for line in examples.lines().filter_map(|line| line.trim().strip_prefix("chordal ")) {
            // What follows two spaces says what comes out.
            let line = line.split_whitespace().collect::<Vec<_>>().join(" ");
            let command = line.split(" where ").next().unwrap();
            let command = command.split(" 0.144 ").next().unwrap();
            let command =
                command.split(" 0.17678 ").next().unwrap().replace("\"1 1/16-28\"", "M8x1.25");
            let arguments: Vec<&str> = command.split(' ').collect();
            Folder::new().run(&arguments).ends(0);
            tried += 1;
        }
        assert!(tried > 0, "{subject}");
    }
}

/// The numbers of Haas's O60023 (1.5-8 with a tool of .5, as its path has it): in from X.25 Y-.25
/// at Z-.5156, one turn of radius .5 from Z-.5 to Z-.375, out to X.25 Y.25 at Z-.3594.
#[test]
fn the_thread_of_the_haas_manual() {
    let program = "calc thread-mill 1.5-8 --tool 0.5in --depth 0.5in --ramp 1/8 --feed 30in/min \
                   --spindle 1000 --control haas";
    says(
        program,
        &[
            "G01 Z-0.5156",
            "G01 X0.25 Y-0.25",
            "G03 X0.5 Y0. I0. J0.25 Z-0.5 F20. (IN)",
            "G03 I-0.5 Z-0.375",
            "G03 X0.25 Y0.25 I-0.25 J0. Z-0.3594 (OUT)",
        ],
    );
}

/// The numbers of the Fadal manual, section 13 (1 1/16 - 28, half an inch): fifteen turns of G2
/// down from Z.0357 outside, fifteen of G3 up from Z-.5 inside, on 1.0187 and 1.0625. The inside
/// radius is .15625: half of a step either way.
#[test]
fn the_threads_of_the_fadal_manual() {
    let base = ["calc", "thread-mill", "1 1/16-28", "--tool", "0.75in", "--depth", "0.5in"];
    let rest = ["--feed", "25in/min", "--spindle", "10000", "--control", "fadal"];
    let single = ["--cutter", "single", "--outside"];
    let outside = [&base[..], &rest, &single].concat();
    let out = Folder::new().run(&outside).ends(0).says(&["1.01868/2 + 0.75/2 = 0.88434"]).out;
    let turns: Vec<&str> = out.lines().filter(|line| line.contains("(TURN")).collect();
    assert_eq!(turns.len(), 15);
    assert!(turns[0].starts_with("G2 I-0.8843 Z0. "), "{}", turns[0]);
    assert!(turns[14].starts_with("G2 I-0.8843 Z-0.5 "), "{}", turns[14]);
    assert!(out.contains("Z0.0357 F"), "{out}");

    let inside = [&base[..], &rest, &single[..2]].concat();
    let out = Folder::new().run(&inside).ends(0).out;
    let turns: Vec<&str> = out.lines().filter(|line| line.contains("(TURN")).collect();
    assert_eq!(turns.len(), 15);
    assert!(turns[0].starts_with("G3 I-0.1562 Z-0.4643 "), "{}", turns[0]);
    assert!(turns[14].starts_with("G3 I-0.1562 Z0.0357 "), "{}", turns[14]);
}

#[test]
fn speeds_and_feeds_are_those_of_the_formulas() {
    // 120000/(37.699) by hand; 0.05·4·3183.1; 10·2·636.62/1000.
    let cut =
        "--tool 12mm --surface 120m/min --teeth 4 --per-tooth 0.05mm --width 2mm --depth 10mm";
    says(
        &format!("calc speeds {cut}"),
        &["= 3183.099 rpm", "= 636.62 mm/min", "= 0.0373 mm", "= 12.732 cm³/min"],
    );
    // The shop's rule of thumb for 400 sfm at half an inch: 3.82·400/0.5 = 3056.
    says(
        "calc speeds --tool 0.5in --surface 400sfm --teeth 3 --per-tooth 0.003in",
        &["v  = 400 ft/min", "= 3055.775 rpm", "= 27.502 in/min"],
    );
    says(
        "calc speeds --tool 10mm --spindle 6000 --teeth 2 --feed 900mm/min",
        &["= 188.496 m/min", "= 0.075 mm"],
    );
    refuses("calc speeds --tool 10mm", &["--surface"]);
    refuses("calc speeds --tool 10mm --surface 100", &["has no unit: write 100m/min or 100sfm"]);
    refuses(
        "calc speeds --tool 10mm --surface 90m/min --teeth 0 --per-tooth 0.1mm",
        &["numbers above zero"],
    );
    refuses(
        "calc speeds --tool 10mm --surface 90m/min --teeth 2 --per-tooth 0.1mm --width 11mm",
        &["a tool of 10 mm cannot cut 11 mm wide"],
    );
}

/// Drills of the usual charts: 8.5 for M10, No. 7 (.201) for 1/4-20, 5.5 for a formed M6.
#[test]
fn the_hole_before_a_tap_is_that_of_the_charts() {
    says("calc tap-drill M10x1.5", &["= 8.5386 mm"]);
    says("calc tap-drill 1/4-20", &["= 0.20129 in"]);
    says("calc tap-drill M6x1 --forming", &["D − 0.68·P·e", "= 5.49 mm"]);
    refuses("calc tap-drill M10x1.5 --percent 120", &["120 % of a thread is not possible"]);
    refuses("calc tap-drill 1/2-NPT", &["says nothing of a pipe thread"]);
}

#[test]
fn holes_lie_on_their_circle() {
    says(
        "calc bolt-circle --diameter 80mm --holes 3",
        &["= 40 mm", "= -20 mm", "= 34.641 mm", "= -34.641 mm", "= 69.282 mm"],
    );
    // From the first to the last: 0°, 30°, 60° and 90°.
    says(
        "calc bolt-circle --diameter 2in --holes 4 --sweep 90deg --center-x 1in",
        &["w  = s/(N − 1)", "= 30°", "= 1.86603 in", "= 0.5 in", "= 1 in"],
    );
    refuses("calc bolt-circle --diameter 80mm --holes 0", &["0 holes on a circle of 80 mm"]);
    refuses("calc bolt-circle --diameter 80mm --holes 3 --sweep 0deg", &["holes over 0°"]);
}
