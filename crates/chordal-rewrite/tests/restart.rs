//! Programs that begin at one of their lines: every line is proved, or refused with a reason.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use chordal::control::RunOptions;
use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::restart::{
    RefusalReason, RestartProgram, blocked, check_head_approach, restart,
};

fn job_on(text: &str, machine: Machine) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    let options = RunOptions { max_repeated_blocks: 2_000, ..RunOptions::default() };
    Job::new(sources, machine).expect("good settings").options(options)
}

fn job(text: &str, machine: &str) -> Job<'static> {
    job_on(text, Machine::from_builtin(machine).expect("a built-in machine"))
}

/// The text of the program that begins at a line.
fn begun(text: &str, machine: &str, line: u32) -> String {
    let done = restart(&job(text, machine), line).expect("proved");
    String::from_utf8(done.text).expect("text")
}

fn refused(text: &str, line: u32) -> (RefusalReason, String) {
    let refused = restart(&job(text, "haas-vf2"), line).expect_err("refused");
    (refused.reason, format!("{}; {}", refused.refusal.what, refused.refusal.help))
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "nc" || ending == "ngc") {
            found.push(path);
        }
    }
}

/// The job of a program on the machine that its remarks or its folder say.
fn job_of(path: &Path) -> Option<Job<'static>> {
    let text = String::from_utf8_lossy(&std::fs::read(path).expect("a program")).into_owned();
    let remark = |mark: &str| text.split_once(mark)?.1.split(')').next();
    let beside = std::fs::read_to_string(path.with_file_name("chordal.toml")).unwrap_or_default();
    let name = remark("(machine: ").or_else(|| beside.split('"').nth(1))?;
    let mut machine = Machine::from_builtin(name).ok()?;
    for (_, rest) in text.match_indices("(set: ").map(|(at, mark)| text.split_at(at + mark.len())) {
        let assignment = rest.lines().next()?.trim_end().strip_suffix(')')?;
        machine.set(assignment).ok()?;
    }
    Some(job_on(&text, machine))
}

#[test]
fn every_line_is_proved_or_refused_with_a_reason() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut paths = Vec::new();
    files(&root.join("examples"), &mut paths);
    files(&root.join("tests/suite"), &mut paths);
    let (mut proved, mut controls) = (0, BTreeMap::<String, [u32; 2]>::new());
    let mut reasons = BTreeMap::<RefusalReason, u32>::new();
    let mut messages = BTreeMap::<String, u32>::new();
    for path in &paths {
        let Some(job) = job_of(path) else { continue };
        let text = job.sources().get(Default::default()).expect("a text").text().to_vec();
        let lines = text.split(|byte| *byte == b'\n').count() as u32;
        let counts = controls.entry(job.profile().title.to_string()).or_default();
        for line in 1..=lines {
            match restart(&job, line) {
                Ok(done) => {
                    proved += 1;
                    counts[0] += 1;
                    // What follows is the old text, byte for byte.
                    let from = text.split(|byte| *byte == b'\n').skip(line as usize - 1);
                    let rest: Vec<&[u8]> = from.collect();
                    let rest = rest.join(&b'\n');
                    let rest = rest.trim_ascii_start();
                    let new = without_contours(&done);
                    assert!(new.ends_with(rest), "{}:{line}", path.display());
                }
                Err(refused) => {
                    counts[1] += 1;
                    *reasons.entry(refused.reason).or_default() += 1;
                    let told = &refused.refusal;
                    assert!(!told.what.is_empty() && !told.help.is_empty());
                    if matches!(refused.reason, RefusalReason::Unproved | RefusalReason::Form) {
                        *messages
                            .entry(told.what.split(": ").last().unwrap_or("").into())
                            .or_default() += 1;
                    }
                }
            }
        }
    }
    println!("{} programs, {proved} lines proved", paths.len());
    controls.iter().for_each(|(name, [yes, no])| println!("  {name}: {yes} proved, {no} refused"));
    reasons.iter().for_each(|(reason, count)| println!("  refused, {reason:?}: {count}"));
    messages.iter().for_each(|(what, count)| println!("    {count} {what}"));
    assert!(controls.len() >= 5 && controls.values().all(|[yes, _]| *yes > 0));
}

/// The text without the contours of cycles that are after its end.
fn without_contours(done: &RestartProgram) -> Vec<u8> {
    if done.after_the_end.is_empty() {
        return done.text.clone();
    }
    let text = String::from_utf8_lossy(&done.text).into_owned();
    let contours = done.after_the_end.join("\n") + "\n";
    let (before, after) = text.rsplit_once(&contours).expect("the contours");
    format!("{before}{after}").into_bytes()
}

const FANUC: &str = "\
%
O1000 (BRACKET)
G21 G17 G90 G40 G49 G80
T1 M06
G54 G00 X0. Y0. S3000 M03
G43 H01 Z25. M08
Z2.
G01 Z-1. F200.
X20. F400.
G02 X30. Y10. R10.
X20. Y20. R10.
G91
G01 X-5.
G90
G00 Z25.
M98 P2000
G41 D01 X40. Y0.
G01 Y10.
G40 X0. M09
M05
T2 M06
G54 G00 X5. Y5. S900 M03
G43 H02 Z25.
G81 G99 Z-5. R2. F90.
X10.
G80
G00 Z25. M09
M30
O2000 (SLOT)
G01 Z-2. F100.
G00 Z25.
M99
%
";

#[test]
fn a_fanuc_begins_within_an_arc_row() {
    insta::assert_snapshot!("fanuc", begun(FANUC, "fanuc-30i", 11));
}

#[test]
fn a_haas_begins_with_increments_and_at_a_tool_change() {
    let text = FANUC.replace('\n', "\r\n");
    insta::assert_snapshot!("haas", begun(&text, "haas-vf2", 13).replace('\r', ""));
    insta::assert_snapshot!("haas-tool-change", begun(FANUC, "haas-vf2", 21));
}

#[test]
fn a_fadal_keeps_its_sections_and_words() {
    let text = "N1 O77 (SLOTS)\nN2 L100\nN3 G91\nN4 G1 Z-.6 F10.\nN5 X.5 F30.\nN6 G0 Z.6\nN7 X-.5\n\
                N8 G90\nN9 M17\nN10 M30\nN11 M6 T1\nN12 G0 G90 S4000 M3 E1 X0 Y0\nN13 H1 Z.5 M8\n\
                N14 L101\nN15 X2.\nN16 L102\nN17 G0 Z1.\nN18 G1 Z-.1 F5.\nN19 X3. F20.\n\
                N20 Y1.\nN21 G0 Z1.\nN22 M5 M9\nN23 M30\n";
    insta::assert_snapshot!("fadal", begun(text, "fadal-4020", 20));
}

#[test]
fn what_cannot_begin_says_why_and_where_it_can() {
    let told = [1, 2, 18, 30, 40].map(|line| {
        let (reason, words) = refused(FANUC, line);
        format!("{line}: {reason:?}: {words}")
    });
    insta::assert_snapshot!("refused", told.join("\n"));
    let loops =
        "O1\nG21 G90 G54 G0 X0 Y0 Z5.\n#1=1\nWHILE [#1 LT 3] DO1\nX#1\n#1=#1+1\nEND1\nM30\n";
    assert_eq!(refused(loops, 5).0, RefusalReason::Repeated);
    let turned = "O1\nG21 G90 G54 G0 X0 Y0 Z5.\nG68 X0 Y0 R30.\nX10.\nX20.\nG69\nM30\n";
    let (reason, words) = refused(turned, 5);
    assert_eq!(reason, RefusalReason::Frame);
    assert!(words.contains("begin at line 3"), "{words}");
    let moved = "O1\nG21 G90 G54 G0 X0 Y0 Z5.\nG92 X5.\nX10.\nX20.\nM30\n";
    assert_eq!(refused(moved, 5).0, RefusalReason::Shift);
}

/// As on the control: a block in polar interpolation is none to begin at.
#[test]
fn nothing_begins_on_a_face() {
    let text = "O1\nG21 G18 G40 G98 G97 S900 M3\nT0101\nG0 X40. Z1. C0\nG12.1\nG1 C10. F100.\nX30.\nG13.1\nG0 Z5.\nM30\n";
    let refused = restart(&job(text, "fanuc-lathe-c"), 7).expect_err("on the face");
    assert_eq!(refused.reason, RefusalReason::Frame);
    assert!(refused.refusal.what.contains("polar or cylindrical"), "{}", refused.refusal.what);
}

const HOLES: &str = "\
O1000 (HOLES)
G21 G17 G90 G40 G49 G80
T1 M06
G54 G00 X0. Y0. S2000 M03
G43 H01 Z25. M08
G98 G83 X10. Y10. Z-20. R2. Q3. F200.
X20.
X30. R5.
G99 X40.
X50.
G80
G00 Z50. M09
T2 M06
G54 G00 X50. Y10. S500 M03
G43 H02 Z10. M08
M29 S500
G99 G84 Z-15. R5. F500.
X40.
X30.
G80 G00 Z50.
M30
";

/// The cycle is put in force with the last of its words, and makes no hole before the line.
#[test]
fn a_row_of_holes_goes_on_at_the_next_hole() {
    for machine in ["fanuc-30i", "mitsubishi-m700", "haas-vf2"] {
        let head: Vec<String> =
            begun(HOLES, machine, 10).lines().skip(1).take(9).map(str::to_string).collect();
        insta::assert_snapshot!(format!("holes-{machine}"), head.join("\n"));
    }
    let tap = restart(&job(HOLES, "fanuc-30i"), 19).expect("proved").head;
    assert_eq!(tap[tap.len() - 2..], ["M29 S500", "G84 Z-15. R5. F500. K0"]);
    let fadal = "N1 O77 (HOLES)\nN2 M6 T1\nN3 G0 G90 S4000 M3 E1 X0 Y0\nN4 H1 Z.5 M8\n\
                 N5 G99 G81 Z-.5 R0+.1 F10. X1.\nN6 G91\nN7 X.5\nN8 X.5\nN9 G80 G90\nN10 M30\n";
    let head = restart(&job(fadal, "fadal-4020"), 8).expect("proved").head;
    assert_eq!(head[head.len() - 2..], ["G81 Z-.5 R0+.1 F10.", "G91"]);
    let cannot = restart(&job(HOLES, "linuxcnc-mill"), 7).expect_err("refused");
    assert_eq!(cannot.reason, RefusalReason::Cycle);
    assert!(cannot.refusal.help.contains("line 6"), "{}", cannot.refusal.help);
    let values = HOLES.replace("Q3.", "Q#5").replace("T1 M06", "T1 M06\n#5=3.");
    assert_eq!(refused(&values, 9).0, RefusalReason::Cycle);
}

/// A shift that stands is said again; one that is taken back is not.
#[test]
fn a_moved_zero_is_said_again() {
    let text =
        "O1\nG21 G90 G54\nG52 X5. Y2.\nG0 X0 Y0 Z5.\nX10.\nG52 X0\nX20.\nG52 Y0\nX30.\nX40.\nM30\n";
    let head = |line| restart(&job(text, "haas-vf2"), line).expect("proved").head;
    let says = |line, words: &str| head(line).iter().any(|put_in| put_in == words);
    assert!(says(5, "G52 X5. Y2.") && !says(5, "G52 X0"));
    assert!(says(7, "G52 X5. Y2.") && says(7, "G52 X0"));
    assert!(!head(10).iter().any(|line| line.contains("G52")));
}

/// G92 before the first move counts from where the machine stands: there it can be said again.
#[test]
fn a_preset_before_the_first_move_is_said_again() {
    let text = "O1\nG21 G90\nG92 X0 Y0 Z50.\nS900 M3\nG0 X-10. Y-5.\nZ2.\nG1 Z-1. F100.\nX-20.\nX-30.\nG0 Z50.\nM30\n";
    let done = restart(&job(text, "fanuc-30i"), 9).expect("proved");
    assert!(done.from_the_start && done.head.iter().any(|line| line == "G92 X0 Y0 Z50."));
    let later = text.replace("X-20.\n", "X-20.\nG92 X0\n");
    assert_eq!(refused(&later, 10).0, RefusalReason::Shift);
}

/// A bar of 62 and a tool that goes to X40 in front of it, and only then out to X64.
const APPROACH: &str = "O1\nG21 G18 G40 G99 F.2\nT0101\nG97 S800 M3\nG0 X40. Z2.\nX64.\nG1 Z-30. F.2\nX70.\nG0 Z2.\nM30\n";

const BAR: &str = "machine = \"fanuc-lathe\"\n[stock]\nshape = \"cylinder\"\ndiameter = \"62 mm\"\n\
                   from = \"-90 mm\"\nto = \"0 mm\"\n[tools.1]\noffset.X = \"-100 mm\"\noffset.Z = \"-50 mm\"\n\
                   shape = \"insert\"\ninsert = \"C\"\napproach_angle = \"95 deg\"\nflute_length = \"12 mm\"\n\
                   nose_radius = \"0.8 mm\"\ntip = 3\n";

fn on_bar(text: &str) -> Job<'static> {
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("bar.toml", BAR, &none).expect("a good setup");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    Job::new(sources, machine).expect("a job")
}

/// The head goes to X40 by rapid and along Z by feed: through the bar.
#[test]
fn the_way_in_of_a_lathe_is_looked_at_with_what_stands() {
    let none = |name: &str| Err(format!("no file {name}"));
    let old = on_bar(APPROACH);
    let done = restart(&old, 8).expect("proved");
    assert!(done.head.contains(&"G1 Z-30. F.2".to_string()), "{:?}", done.head);
    let way = check_head_approach(&old, &done, &none).expect("a stock").expect("a lathe");
    let hit = way.hits.first().expect("it cuts");
    // From X40 to the bar's 62, 11 mm deep.
    assert!((hit.depth_mm - 11.0).abs() < 1e-6, "{hit:?}");
    let refused = blocked(&old, &done, &way).expect("a refusal");
    assert_eq!(refused.reason.word(), "way-in");
    assert!(
        refused.refusal.what.contains("cuts 11 mm deep into what stands there")
            && refused.refusal.what.contains("`G1 Z-30. F.2` of the new program"),
        "{}",
        refused.refusal.what
    );
    // Before the cut it goes along X alone, in front of the bar.
    let done = restart(&old, 7).expect("proved");
    let way = check_head_approach(&old, &done, &none).expect("a stock").expect("a lathe");
    assert_eq!((way.moves, way.hits.len(), way.unknown.as_deref()), (1, 0, None));
    // Where the bar is turned down to 38 first, the way is free.
    let turned =
        APPROACH.replace("G0 X40. Z2.\n", "G0 X40. Z2.\nX38.\nG1 Z-40. F.2\nG0 X64.\nZ2.\n");
    let old = on_bar(&turned);
    let done = restart(&old, 12).expect("proved");
    let way = check_head_approach(&old, &done, &none).expect("a stock").expect("a lathe");
    assert!(way.moves == 2 && way.hits.is_empty() && way.unknown.is_none(), "{way:?}");
    assert!(blocked(&old, &done, &way).is_none());
    // Without a stock nothing is looked at.
    let bare = job(APPROACH, "fanuc-lathe");
    let done = restart(&bare, 8).expect("proved");
    assert_eq!(check_head_approach(&bare, &done, &none).expect("no setup"), None);
}

/// What brings a length into force, and the line that does so again in the head.
#[test]
fn every_form_of_a_tool_length_is_said_again() {
    let program = |machine: &str, length: &str| {
        let begin = if machine.starts_with("fadal") {
            "G21 G90\nE1"
        } else {
            "G21 G90 G17 G40 G49 G80\nG54"
        };
        format!(
            "{begin}\nG10 L10 P2 R180.\nT2 M6\nG0 X10. Y20. S3000 M3\n{length}\nG1 Z-1. F300.\nX30.\nX40.\nG0 Z25.\nM2\n"
        )
    };
    let cases = [
        ("fanuc-0i", "G43 H2 Z25.", "G43 H2 Z25."),
        ("haas-vf2", "G43 H2\nZ25.", "G43 H2 Z25."),
        ("mitsubishi-m700", "G44 H2 Z25.", "G44 H2 Z25."),
        ("linuxcnc-mill", "G43.1 Z25.\nZ25.", "G43.1 Z25.\n"),
        ("linuxcnc-mill", "G43.1 X1. Z-3.5\nX10. Z25.", "G43.1 X1. Z-3.5\n"),
        ("grblhal", "G43.1 Z25.\nZ25.", "G43.1 Z25.\n"),
    ];
    for (machine, length, head) in cases {
        let mut text = program(machine, length);
        if !["fanuc-0i", "haas-vf2", "mitsubishi-m700"].contains(&machine) {
            text = text.replace("G10 L10 P2 R180.\n", "");
        }
        let line = text.lines().position(|line| line == "X40.").expect("the line") as u32 + 1;
        let begun = begun(&text, machine, line);
        assert!(begun.contains(head), "{machine}, {length}:\n{begun}");
        // Without it the length is another one, which the proof sees.
        let without = begun.replace(head, if head.ends_with('\n') { "" } else { "Z25." });
        let job = |text: &str| job(text, machine);
        let compared = chordal_compare::compare(&job(&text), &job(&without), &Default::default());
        assert_ne!(
            compared.verdict,
            chordal_compare::ComparisonVerdict::Same,
            "{machine}, {length}"
        );
    }
}

/// Outputs, clamps and overrides are none of the head: they are named, and are no part of the proof.
#[test]
fn codes_that_are_not_repeated_are_named() {
    let unrepeated = |machine: &str, codes: &str| -> Vec<(String, u32)> {
        let text = format!(
            "G21 G90 G17 G40 G49 G80\nT1 M6\n{codes}\nG0 G54 X10. Y20. S3000 M3\nM8\nG43 H1 Z25.\nG1 Z-1. F300.\n\
             X30.\nX40.\nG0 Z25.\nM2\n"
        );
        let line = text.lines().position(|line| line == "X40.").expect("the line") as u32 + 1;
        let done = restart(&job(&text, machine), line).expect("proved");
        done.unrepeated.into_iter().map(|code| (code.words, code.line)).collect()
    };
    let named = |codes: &[(&str, u32)]| -> Vec<(String, u32)> {
        codes.iter().map(|(words, line)| (words.to_string(), *line)).collect()
    };
    assert_eq!(unrepeated("linuxcnc-mill", "M9"), named(&[]));
    assert_eq!(
        unrepeated("linuxcnc-mill", "M51 P0\nM64 P1\nM68 E0 Q5\nM64 P1"),
        named(&[("M51 P0", 3), ("M68 E0 Q5", 5), ("M64 P1", 6)])
    );
    assert_eq!(unrepeated("haas-vf2", "M10\nM83"), named(&[("M10", 3), ("M83", 4)]));
}

/// What the control keeps is the same where the program begins, or the line is refused.
#[test]
fn what_the_control_keeps_is_brought_back_or_refused() {
    let at = |program: &str, words: &str| {
        let line = program.lines().position(|line| line == words).expect("the line") as u32 + 1;
        restart(&job(program, "linuxcnc-mill"), line)
    };
    let begin = "G21 G17 G90 G40 G49 G80 G94\nG54\nT1 M6\nS1000 M3\nG0 X0 Y0 Z30\nF200\n";
    // G52 of millimetres would be inches in the head.
    let text = format!("{begin}G52 X24\nG0 X25.4 Y25.4 Z25.4\nG20\nG1 X1 F9\nX2\nM2\n");
    assert_eq!(at(&text, "X2").expect_err("refused").reason, RefusalReason::Unproved);
    let text = format!("{begin}G52 X24\nG0 X5 Y5 Z5\nG1 X1 F9\nX2\nM2\n");
    assert!(at(&text, "X2").is_ok());
    // M49 ends both overrides, M50 that of the feed alone.
    let text = format!("{begin}M49\nM50 P0\nG0 X5 Y5 Z5\nG1 X1 F9\nX2\nM2\n");
    let head = at(&text, "X2").expect("proved").head;
    assert!(head.contains(&"M49".to_string()) && head.contains(&"M50 P0".to_string()), "{head:?}");
    // Y and Z would be wherever the machine stands.
    let text = format!("{begin}G1 X5 Y6 Z-2\nG59.1\nX8\nX9\nM2\n");
    assert!(at(&text, "X8").is_err());
    // Tables that variables have written are not in the head.
    let text = format!("{begin}#5241=7\nG0 X5 Y5 Z5\nG1 X1\nX2\nM2\n");
    assert!(at(&text, "X2").is_err());
    // A length that is added is given by its sum.
    let text = format!("{begin}G43.1 Z25\nG43.2 H2\nG0 X5 Y5 Z5\nG1 X1\nX2\nM2\n");
    let mut machine = Machine::from_builtin("linuxcnc-mill").expect("a machine");
    machine.set("tools.2.length = 10 mm").expect("a length");
    let done = restart(&job_on(&text, machine), 11).expect("proved");
    assert!(done.head.contains(&"G43.1 Z35.".to_string()), "{:?}", done.head);
}

/// After a tool change or G28 Z0 the height is where the machine has it: a shift of the zero, and places of X and Y, say all
/// that the rest needs.
#[test]
fn a_program_begins_after_a_shift_of_the_zero_with_the_height_of_the_machine() {
    const SHIFTED: &str = "\
%
O1
G21 G90 G40 G17 G94
T1 M6
S1000 M3
G0 G54 X10. Y0.
G43 H1 Z5.
G1 Z-1. F100.
X20.
G0 Z50.
G91 G28 Z0
G90
G52 X5. Y6.
G0 X10. Y10.
X12.
G43 H1 Z5.
G1 Z-1.
X30.
G0 Z50.
G91 G28 Z0
G90 G52 X0. Y0.
G0 X1. Y1.
G43 H1 Z5.
G1 Z-1.
M30
%
";
    for machine in ["fanuc-0i", "haas-vf2", "mitsubishi-m700", "linuxcnc-mill"] {
        // The lines after each shift, whose program goes to its first place by itself, and those between that and the way
        // down.
        for (line, over) in
            [(14, ""), (15, "X10. Y10."), (16, "X12. Y10."), (22, ""), (23, "X1. Y1.")]
        {
            let text = begun(SHIFTED, machine, line);
            let (head, _) =
                text.split_once(SHIFTED.lines().nth(line as usize - 1).unwrap()).unwrap();
            let said = head.lines().find_map(|said| said.strip_prefix("G0 G54 "));
            assert!(said.unwrap_or_default().starts_with(over), "{machine}, line {line}\n{text}");
            assert_eq!(said.is_none(), over.is_empty(), "{machine}, line {line}\n{text}");
            assert_eq!(head.contains("G52 X5. Y6."), line < 22, "{machine}, line {line}\n{text}");
        }
    }
    // Without a place of X and Y there is nothing to begin at.
    let bare = "%\nO1\nG21 G90 G40 G17 G94\nT1 M6\nG54\nG52 X5.\nS900 M3\nG1 X3. F100.\nY2. Z1.\nX9.\nM30\n%\n";
    assert_eq!(refused(bare, 9).0, RefusalReason::Position);
}
