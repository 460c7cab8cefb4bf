//! Every program of the documents and of the examples through every transform: the motion that is
//! meant, or a refusal that says why.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::path::{Path, PathBuf};

use chordal::control::{RunOptions, Units};
use chordal::{Job, Machine, Source, SourceMap};
use chordal_compare::Category;
use chordal_rewrite::{ArcForm, TransformStep, TransformedProgram, transform};
use proptest::prelude::*;

const MACHINES: [(&str, &str); 9] = [
    ("fadal", "fadal-4020"),
    ("haas", "haas-vf2"),
    ("fanuc", "fanuc-30i"),
    ("mitsubishi-type2", "mitsubishi-m700-type2"),
    ("mitsubishi", "mitsubishi-m700"),
    ("linuxcnc", "linuxcnc-mill"),
    ("textbook-absolute-center", "textbook-absolute-center"),
    ("textbook-from-center", "textbook-from-center"),
    ("textbook", "textbook-from-center"),
];

/// Programs with the machine that their folder says.
fn programs() -> Vec<(PathBuf, &'static str)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut all = Vec::new();
    for base in ["examples", "tests/suite"] {
        for (folder, machine) in MACHINES {
            let Ok(entries) = std::fs::read_dir(root.join(base).join(folder)) else { continue };
            let mut files: Vec<PathBuf> = entries
                .map(|entry| entry.unwrap().path())
                .filter(|path| {
                    path.extension().is_some_and(|ending| ending == "nc" || ending == "ngc")
                })
                .collect();
            files.sort();
            all.extend(files.into_iter().map(|file| (file, machine)));
        }
    }
    assert!(all.len() > 100);
    all
}

fn job(text: Vec<u8>, machine: &str) -> Job<'static> {
    let machine = Machine::from_builtin(machine).unwrap();
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text));
    // What never ends need not be run for long.
    let options = RunOptions { max_repeated_blocks: 20_000, ..RunOptions::default() };
    Job::new(sources, machine).unwrap().options(options)
}

fn fit(tolerance: f64) -> TransformStep {
    TransformStep::Fit { tolerance, feed_tolerance: 0.01 }
}

/// Each with how many of the programs must come out proved; the others are refused, or differ in a way
/// that is reported (a travel that is exceeded, a printed position, a clearance that a parameter holds).
fn steps() -> Vec<(&'static str, TransformStep, usize)> {
    let rotate =
        |degrees: f64| TransformStep::Rotate { angle: degrees.to_radians(), about: [25.4, 12.7] };
    vec![
        ("shift", TransformStep::Shift([2.54, -12.7, 0.254]), 134),
        ("rotate 90", rotate(90.0), 86),
        ("rotate 30", rotate(30.0), 84),
        ("mirror x", TransformStep::MirrorX, 118),
        ("mirror y", TransformStep::MirrorY, 132),
        ("scale 2", TransformStep::Scale(2.0), 62),
        ("mm", TransformStep::Units(Units::Millimetre), 133),
        ("inch", TransformStep::Units(Units::Inch), 154),
        ("feed", TransformStep::Rates { feed: 0.5, speed: 1.0 }, 153),
        ("speed", TransformStep::Rates { feed: 1.0, speed: 2.0 }, 155),
        ("radius", TransformStep::Arcs(ArcForm::Radius), 182),
        ("center", TransformStep::Arcs(ArcForm::Center), 181),
        ("chords", TransformStep::Chords(0.01), 132),
        ("fit", fit(0.02), 183),
        ("simplify", TransformStep::Simplify(0.02), 183),
        ("renumber", TransformStep::Renumber { first: 10, step: 5 }, 170),
        ("no numbers", TransformStep::NoNumbers, 174),
        ("comments", TransformStep::StripComments, 158),
    ]
}

/// Every program through every step: the motion that is meant, or a reason.
#[test]
fn every_program_through_every_step() {
    let mut short = Vec::new();
    for (name, step, least) in steps() {
        let (mut proved, mut refused, mut differ) = (0, 0, 0);
        for (path, machine) in programs() {
            let text = std::fs::read(&path).unwrap();
            let said = String::from_utf8_lossy(&text).into_owned();
            let said = said.split_once("(machine: ").and_then(|(_, rest)| rest.split_once(')'));
            let job = job(text, said.map_or(machine, |(name, _)| name.trim()));
            match transform(&job, &[step]) {
                Ok(done) if done.certificate.holds() => proved += 1,
                Ok(done) => {
                    differ += 1;
                    let is_told = !done.certificate.comparison.differences.is_empty()
                        || done.notes.iter().any(|note| note.contains("nothing can be proved"));
                    assert!(is_told, "{name} {path:?}");
                }
                Err(refusal) => {
                    refused += 1;
                    let is_told =
                        refusal.line > 0 && !refusal.what.is_empty() && !refusal.help.is_empty();
                    assert!(is_told, "{name} {path:?}: {refusal:?}");
                }
            }
        }
        println!("{name}: {proved} proved, {refused} refused, {differ} differ and say where");
        if proved < least {
            short.push((name, proved, least));
        }
    }
    assert!(short.is_empty(), "fewer are proved than were: {short:?}");
}

fn haas(text: &str, steps: &[TransformStep]) -> TransformedProgram {
    let done = transform(&job(text.as_bytes().to_vec(), "haas-vf2"), steps).unwrap();
    let differences = &done.certificate.comparison.differences;
    assert!(done.certificate.holds(), "{differences:?}\n{}", String::from_utf8_lossy(&done.text));
    done
}

fn text_after(text: &str, steps: &[TransformStep]) -> String {
    String::from_utf8(haas(text, steps).text).unwrap()
}

const PART: &str = "\
%
O1 (PART)
N10 G21 G90 G54 G17
N20 T1 M6
N30 G0 X0. Y0. S900 M3 (APPROACH)
N40 G43 H1 Z2.
N50 G1 Z-1. F100.
N60 X10.50 F200.
N70 G3 X20. Y9.5 R9.5
N80 G91 G1 X-5. Y.5
N90 G90 G2 X5. Y10. I-5. J0.
N100 G0 Z50.
N110 M30
%
";

#[test]
fn the_style_is_kept() {
    let moved = text_after(PART, &[TransformStep::Shift([5.0, -0.25, 0.0])]);
    let expected = PART
        .replace("X0. Y0. S900", "X5. Y-0.25 S900")
        .replace("X10.50 F200", "X15.50 F200")
        .replace("X20. Y9.5 R9.5", "X25. Y9.25 R9.5")
        .replace("X5. Y10. I-5.", "X10. Y9.75 I-5.");
    assert_eq!(moved, expected);
}

#[test]
fn a_zero_has_no_zero_before_its_point_where_the_program_writes_none() {
    let text = "G21 G90 G17 S900 M3\nG0 X.0 Y.5 Z5.0\nG1 Z-.5 F50.0\nX.5\nX.0 Y1.0\nM30\n";
    let quarter_turn =
        TransformStep::Rotate { angle: std::f64::consts::FRAC_PI_2, about: [0.0; 2] };
    let turned = text_after(text, &[quarter_turn]);
    let lines: Vec<&str> = turned.lines().skip(3).collect();
    assert_eq!(lines, ["X-.5 Y.5", "X-1.0 Y.0", "M30"]);
}

#[test]
fn a_mirror_image_turns_the_other_way() {
    let image = text_after(PART, &[TransformStep::MirrorX]);
    assert!(image.contains("N70 G2 X-20. Y9.5 R9.5") && image.contains("N80 G91 G1 X5. Y.5"));
    assert!(image.contains("N90 G90 G3 X-5. Y10. I5. J0."), "{image}");
}

#[test]
fn a_turn_names_the_axis_that_was_left_out() {
    let turned = text_after(
        PART,
        &[TransformStep::Rotate { angle: std::f64::consts::FRAC_PI_2, about: [0.0; 2] }],
    );
    assert!(turned.contains("N60 X0.00 Y10.50 F200."), "{turned}");
    assert!(turned.contains("N90 G90 G2 X-10. Y5. I0. J-5."), "{turned}");
}

#[test]
fn other_units_and_back() {
    let done = haas(PART, &[TransformStep::Units(Units::Inch)]);
    let inch = String::from_utf8(done.text).unwrap();
    assert!(inch.contains("N10 G20 G90") && inch.contains("X0.4134 F7.874"), "{inch}");
    haas(PART, &[TransformStep::Units(Units::Inch), TransformStep::Units(Units::Millimetre)]);
}

#[test]
fn a_variable_is_moved_where_it_is_used() {
    let text = "G21 G90 S900 M3\n#1=10.\nG0 X0 Y0 Z2.\nG1 Z-1. F100.\nX#1 Y[#1*2.]\nG0 Z50.\nM30\n";
    let moved = text_after(text, &[TransformStep::Shift([5.0, -1.0, 0.0])]);
    assert!(moved.contains("X[#1+5.] Y[[#1*2.]-1.]"), "{moved}");
    let image = text_after(text, &[TransformStep::MirrorX]);
    assert!(image.contains("X[0.-#1]"), "{image}");
}

#[test]
fn a_subprogram_that_is_run_in_two_ways_is_refused() {
    let text = "O1\nG21 G90 S900 M3\nG0 X0 Y0 Z2.\nG1 Z-1. F100.\nM98 P2\nG91\nM98 P2\nG90 G0 Z50.\nM30\n\
                O2\nX10. Y5.\nM99\n";
    let refusal =
        transform(&job(text.into(), "haas-vf2"), &[TransformStep::Shift([1.0, 0.0, 0.0])])
            .unwrap_err();
    assert_eq!((refusal.line, refusal.text.as_str()), (11, "X10. Y5."));
}

#[test]
fn a_tap_goes_with_the_spindle() {
    let text =
        "G21 G90 G54 S500 M3\nG0 X0 Y0 Z5.\nG84 Z-10. R2. F500.\nG80\nG1 Z1. F300.\nG0 Z50.\nM30\n";
    let slow = text_after(text, &[TransformStep::Rates { feed: 0.9, speed: 0.5 }]);
    assert!(
        slow.contains("S250") && slow.contains("R2. F250.") && slow.contains("Z1. F270."),
        "{slow}"
    );
}

#[test]
fn shrinking_takes_what_does_nothing_and_no_more() {
    let tight = haas(PART, &[TransformStep::Shrink(PART.len() - 1)]);
    assert!(String::from_utf8_lossy(&tight.text).contains("N60X10.50F200."));
    let small = haas(PART, &[TransformStep::Shrink(tight.text.len() - 1)]);
    assert!(small.text.len() < tight.text.len());
    let text = String::from_utf8(small.text).unwrap();
    assert!(text.contains("(PART)") && text.contains("N60X10.5F200."), "{text}");
    let refusal =
        transform(&job(PART.into(), "haas-vf2"), &[TransformStep::Shrink(20)]).unwrap_err();
    assert!(refusal.what.contains("bytes"), "{refusal}");
}

/// Three laps of chords: the arcs that they were come back, and the lines stay.
#[test]
fn chords_become_arcs_again() {
    let chords = haas(PART, &[TransformStep::Chords(0.001)]);
    let text = String::from_utf8(chords.text).unwrap();
    assert!(text.lines().count() > 60 && !text.contains("G2 ") && !text.contains("G3 "), "{text}");
    let fitted = haas(&text, &[fit(0.01)]);
    let text = String::from_utf8(fitted.text).unwrap();
    let arcs = text.lines().filter(|line| line.contains("G2 ") || line.contains("G3 ")).count();
    assert!(arcs >= 1 && text.lines().count() < 25, "{text}");
}

/// Five rows of `tools/surfacing.py` in the digits of the program: as few arcs as the geometry's test holds them to,
/// proved, and tangent as far as these digits say it.
#[test]
fn a_surfacing_program_becomes_tangent_arcs() {
    let mut text =
        String::from("G21 G90 G17 G64 P0.01\nT1 M6\nS12000 M3\nG0 X0 Y0 Z5\nG1 Z0.3 F3000\n");
    for row in 0..5 {
        for step in 0..1000 {
            let x = 0.1 * f64::from(if row % 2 == 0 { step } else { 999 - step });
            let z = 0.6 * (0.3 * x).sin() + 0.3 * (0.11 * x + 0.05 * f64::from(row)).cos();
            let y = if step == 0 { format!("Y{:.3}", 0.1 * f64::from(row)) } else { String::new() };
            text += &format!("X{x:.3}{y}Z{z:.4}\n");
        }
    }
    text += "G0 Z5\nM30\n";
    let source = job(text.clone().into_bytes(), "linuxcnc-mill");
    let done = transform(&source, &[fit(0.01)]).unwrap();
    assert!(done.certificate.holds(), "{:?}", done.certificate.comparison.differences);
    assert!(done.certificate.comparison.max_distance_mm.unwrap() <= 0.01);
    let new = String::from_utf8(done.text).unwrap();
    let arcs = new.lines().filter(|line| line.contains('I') && line.contains('K')).count();
    let lines = new.lines().count() - 8 - arcs;
    println!("{} lines are {arcs} arcs and {lines} lines", text.lines().count());
    // 97.4 is the asymptotic minimum of the five rows.
    assert!((90..=110).contains(&arcs), "{arcs}\n{new}");
    assert!(lines < 20, "{new}");
}

/// A wave of chords, with what a row of CAM output has behind each.
fn wave(behind: impl Fn(usize, f64) -> String) -> String {
    let mut text = String::from("G21 G90 G17\nT1 M6\nS12000 M3\nG0 X0 Y0 Z5.\nG1 Z0. F3000.\n");
    for step in 0..200 {
        let x = 0.25 * step as f64;
        text += &format!("G1 X{x:.3} Y{:.3}{}\n", 8.0 * (0.2 * x).sin(), behind(step, x));
    }
    text + "X60.\nG0 Z5.\nM30\n"
}

fn feeds(text: &str) -> Vec<&str> {
    text.lines().filter_map(|line| line.split(' ').find(|word| word.starts_with('F'))).collect()
}

/// Feeds within the tolerance are one feed, the slowest; what holds after the row is said again.
#[test]
fn a_feed_in_every_block_is_no_obstacle() {
    let same = haas(&wave(|_, _| " F900.".into()), &[fit(0.01)]);
    let text = String::from_utf8(same.text).unwrap();
    assert!(text.lines().count() < 40, "{text}");
    assert_eq!(feeds(&text), ["F3000.", "F900."]);

    let near = wave(|step, _| format!(" F{}.", 900 + step % 7));
    let text = String::from_utf8(haas(&near, &[fit(0.01)]).text).unwrap();
    assert!(text.lines().count() < 40, "{text}");
    // 199 % 7 is 3: so fast the last block was, and so fast the next one is to go on.
    assert_eq!(feeds(&text), ["F3000.", "F900.", "F903."]);

    // The least of 7 that are 2 % apart is not the feed of all: rows end where the tolerance does.
    let apart = wave(|step, _| format!(" F{}.", if step < 100 { 900 } else { 1000 }));
    let text = String::from_utf8(haas(&apart, &[fit(0.01)]).text).unwrap();
    assert_eq!(feeds(&text), ["F3000.", "F900.", "F1000."]);
    let exact = TransformStep::Fit { tolerance: 0.01, feed_tolerance: 0.0 };
    let kept = String::from_utf8(haas(&near, &[exact]).text).unwrap();
    assert_eq!(kept, near);
}

/// In a helix F is the feed in the plane: where the chords fall steeply, that is another motion.
#[test]
fn a_row_whose_proof_fails_stays_and_is_told() {
    let flat = wave(|_, _| String::new());
    let steep = wave(|_, x| format!(" Z{:.3}", -x));
    let (head, _) = flat.split_once("X60.").unwrap();
    let (_, second) = steep.split_once("F3000.\n").unwrap();
    let text = format!("{head}G0 Z5.\nX0. Y0.\nG1 Z0. F3000.\n{second}");
    let done = transform(&job(text.clone().into_bytes(), "fanuc-30i"), &[fit(0.01)]).unwrap();
    assert!(done.certificate.holds());
    let new = String::from_utf8(done.text).unwrap();
    assert!(new.ends_with(second), "{new}");
    assert!(new.lines().count() < text.lines().count() - 150, "{new}");
    let said = done.notes.iter().find(|note| note.contains("stays as it is"));
    assert!(said.is_some_and(|note| note.contains("feed")), "{:?}", done.notes);
}

/// A path of which no place is known is not proved, whatever its text.
#[test]
fn nothing_held_against_nothing_is_no_proof() {
    let text = "G21 G90 G94 S900 M3\nF300.\nG1 X1. Y1.\nX2.\nM30\n";
    let done =
        transform(&job(text.into(), "linuxcnc-mill"), &[TransformStep::Shift([1.0, 0.0, 0.0])])
            .unwrap();
    assert!(!done.certificate.holds());
    assert!(done.notes.iter().any(|note| note.contains("program X, Y and Z")), "{:?}", done.notes);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(40) })]

    /// A path that is moved in several ways and back is where it was.
    #[test]
    fn there_and_back(
        shift in prop::array::uniform3(-200i32..200),
        turns in prop::bool::ANY,
        degrees in -180i32..180,
        scale in prop::sample::select(vec![0.5, 2.0, 4.0]),
        mirror in prop::bool::ANY,
        which in 0usize..1000,
    ) {
        let shift = shift.map(|step| f64::from(step) * 0.254);
        let mut there = vec![TransformStep::Shift(shift)];
        let mut back = vec![TransformStep::Shift(shift.map(|by| -by))];
        if mirror {
            there.push(TransformStep::MirrorY);
            back.push(TransformStep::MirrorY);
        }
        if turns {
            let angle = f64::from(degrees).to_radians();
            there.push(TransformStep::Rotate { angle, about: [0.0; 2] });
            back.push(TransformStep::Rotate { angle: -angle, about: [0.0; 2] });
        } else {
            there.push(TransformStep::Scale(scale));
            back.push(TransformStep::Scale(1.0 / scale));
        }
        let programs = programs();
        let (path, machine) = &programs[which % programs.len()];
        let text = std::fs::read(path).unwrap();
        let Ok(moved) = transform(&job(text.clone(), machine), &there) else { return Ok(()) };
        if !moved.certificate.holds() {
            return Ok(());
        }
        let all: Vec<TransformStep> = there.into_iter().chain(back.into_iter().rev()).collect();
        let Ok(done) = transform(&job(text, machine), &all) else { return Ok(()) };
        // Expressions that grow may be nested too deep.
        let differences = &done.certificate.comparison.differences;
        let is_deep = differences.iter().any(|one| one.category == Category::Problem);
        prop_assert!(done.certificate.holds() || is_deep, "{path:?} {all:?}: {:?}", done.certificate.comparison.differences.first());
    }
}

/// A quarter turn makes YZ of ZX and ZX of YZ: arcs and cycles of each lie in the other one after it.
#[test]
fn a_quarter_turn_takes_arcs_and_cycles_of_one_upright_plane_to_the_other() {
    let head = "G21 G90 G94 G40 G49 G80 G17 G54\nS900 M3\nG0 X12. Y7. Z3.\nG1 Z-1. F240.\n";
    let bodies = [
        // A half circle and a helix in ZX by their centres, a quarter in YZ by its radius.
        "G18 G2 X20. Z-1. I4. K0.\nG3 X12. Z-1. I-4. K0. Y9.\nG19 G3 Y13. Z-5. R4.\nG17 G1 X3.\n",
        // Distances, the plane said before the arc, more than half a turn.
        "G19\nG91\nG2 Y6. Z2. J3. K1.\nG3 Y2.5 Z2.5 R-2.5\nG90\nG18\nG3 X17. Z6. R15.\nG17\n",
        // A whole circle with a lead, then lines.
        "G19 G3 X15. J-2.5 K.5\nG18 G2 I1.5 K-2. Y6.\nG17 G1 X1. Y2.\n",
        // Compensation in an upright plane.
        "G18 G42 D1 G1 X14. Z-2.\nG1 X20. Z-2.\nG2 X26. Z-8. I0. K-6.\nG1 Z-14.\nG40 G1 X30. Z-15.\nG17\n",
        // Holes along Y and along X.
        "G0 Z8.\nG18 G98 G81 X3. Z2. Y-4. R5. F90.\nX6.\nZ4.\nG80\nG19 G83 Y1. Z6. X-7. R10. Q2.5\nG80\nG17\n",
    ];
    for (body, machine) in bodies
        .iter()
        .flat_map(|body| ["fanuc-30i", "haas-vf2", "mitsubishi-m700"].map(|m| (body, m)))
    {
        let text = format!("{head}{body}G0 Z50.\nM30\n");
        // Fanuc and Mitsubishi drill along Z in every plane; where they are told to, along the plane's normal.
        for degrees in [90.0_f64, -90.0, 270.0, 450.0] {
            for about in [[0.0, 0.0], [3.5, -2.25]] {
                let steps = [TransformStep::Rotate { angle: degrees.to_radians(), about }];
                let done = transform(&job(text.clone().into(), machine), &steps);
                let done = done.unwrap_or_else(|refusal| {
                    panic!("{machine} {degrees}: {} `{}`\n{text}", refusal.what, refusal.text)
                });
                let new = String::from_utf8_lossy(&done.text).into_owned();
                assert!(
                    done.certificate.holds(),
                    "{machine} {degrees} about {about:?}\n{text}\n{new}"
                );
                let count = |text: &str, word: &str| text.matches(word).count();
                assert_eq!(count(&text, "G18"), count(&new, "G19"), "{new}");
                assert_eq!(count(&text, "G19"), count(&new, "G18"), "{new}");
            }
        }
        let steps = [TransformStep::Rotate { angle: 30_f64.to_radians(), about: [0.0, 0.0] }];
        match transform(&job(text.clone().into(), machine), &steps) {
            Err(refusal) => assert!(refusal.help.contains("90°"), "{}", refusal.help),
            Ok(done) => assert!(body.contains("G81") && done.certificate.holds(), "{text}"),
        }
    }
}

#[test]
fn a_program_with_splines_is_refused_where_its_path_would_change() {
    let text = "G21 G90 G17 S900 M3 F500\nG0 X0 Y0 Z0\nG5 I0 J3 P0 Q-3 X1 Y1\nM2\n";
    let run = |step: TransformStep| transform(&job(text.into(), "linuxcnc-mill"), &[step]);
    for step in [
        TransformStep::MirrorX,
        TransformStep::Shift([1.0, 0.0, 0.0]),
        TransformStep::Chords(0.01),
        TransformStep::Scale(2.0),
    ] {
        let refusal = run(step).unwrap_err();
        assert_eq!(refusal.line, 3);
        assert!(refusal.what.contains("splines"), "{}", refusal.what);
    }
    assert!(run(TransformStep::NoNumbers).is_ok());
}

#[test]
fn coordinates_on_a_face_are_not_transformed() {
    let text = "G21 G18 G40 G98 G97 S900 M3\nG0 X40. Z1. C0\nG12.1\nG1 C10. F100.\nG13.1\nM30\n";
    let run = |step: TransformStep| transform(&job(text.into(), "fanuc-lathe-c"), &[step]);
    for step in [TransformStep::Shift([0.0, 0.0, 1.0]), TransformStep::Scale(2.0)] {
        let refusal = run(step).unwrap_err();
        assert_eq!(refusal.line, 3);
        assert!(refusal.what.contains("a face or a cylinder"), "{}", refusal.what);
    }
    assert!(run(TransformStep::NoNumbers).is_ok());
}

/// A firmware that judges each arc as it is written gets as many decimals as that needs.
#[test]
fn turned_and_scaled_arcs_of_a_router_are_not_refused() {
    let mut seed = 11_u64;
    let mut random = |from: f64, to: f64| {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        from + (to - from) * (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    for (units, unit, digits) in [("G20", 1.0 / 25.4, 4), ("G21", 1.0, 3)] {
        for _ in 0..6 {
            let mut text =
                format!("{units} G90 G17 G94\nM3 S9000\nG0 X0 Y0 Z{:.3}\nG1 Z0 F10\n", 5.0 * unit);
            let (mut x, mut y) = (0.0, 0.0);
            let round = |value: f64| format!("{value:.digits$}").parse::<f64>().unwrap();
            for _ in 0..20 {
                let radius = 10f64.powf(random(-0.6, 2.0)) * unit;
                let (from, sweep) = (random(0.0, 6.2), random(0.2, 5.0));
                let (i, j) = (round(-radius * from.cos()), round(-radius * from.sin()));
                let (radius, from) = (i.hypot(j), (-j).atan2(-i));
                let end =
                    [x + i + radius * (from + sweep).cos(), y + j + radius * (from + sweep).sin()];
                let end = end.map(round);
                text += &format!("G3 X{} Y{} I{i} J{j} F{}\n", end[0], end[1], 500.0 * unit);
                [x, y] = end;
            }
            text += "M2\n";
            let angle = random(1.0, 89.0_f64).to_radians();
            let steps = [
                TransformStep::Rotate { angle, about: [3.0, 4.0] },
                TransformStep::Scale(random(0.3, 0.9)),
            ];
            let done = transform(&job(text.clone().into_bytes(), "grbl"), &steps);
            let done = done.unwrap_or_else(|refusal| panic!("{refusal:?}\n{text}"));
            let certificate = &done.certificate;
            assert!(certificate.holds(), "{:?}\n{text}", certificate.comparison.differences);
        }
    }
}
