//! HEIDENHAIN conversational programs to and from the other languages, by their run.

use chordal::{Job, Source, SourceMap};
use chordal_rewrite::convert::{ConversionOptions, convert};

use super::posted::{RoundTrip, assert_changes_are_seen, names_in, wide};
use super::{VerdictTable, converted, job, text_of, verdict};

/// The machines that the programs for mills with three axes are converted to.
pub(super) const TARGETS: [&str; 4] = ["fanuc-0i", "haas-vf2", "sinumerik-mill", "linuxcnc-mill"];

/// The frozen programs that are right; those that others call, and datum tables, are next to them.
#[test]
fn frozen_programs() {
    let folder = "tests/heidenhain/programs";
    let names = names_in(folder);
    let is_called = |name: &&String| {
        name.ends_with(".d") || text_of(&format!("{folder}/{name}")).contains("; = called")
    };
    let called: Vec<&String> = names.iter().filter(is_called).collect();
    let mut table = VerdictTable::default();
    for name in names.iter().filter(|name| !called.contains(name)) {
        let text = text_of(&format!("{folder}/{name}"));
        let mut sources = SourceMap::new();
        sources.add(Source::new(name.as_str(), text.clone().into_bytes()));
        for other in &called {
            let text = text_of(&format!("{folder}/{other}"));
            sources.add(Source::new(other.as_str(), text.into_bytes()));
        }
        let mut machine = wide("heidenhain-mill");
        for (at, name) in tool_names(&text).iter().enumerate() {
            machine.tools.entry(at as u32 + 21).or_default().description = Some(name.clone());
        }
        let old = Job::new(sources, machine).expect("a machine without settings");
        table.add(name, &old, &TARGETS);
    }
    insta::assert_snapshot!(table.finish());
}

/// The names in `TOOL CALL "…"` and in the strings that it may use.
fn tool_names(text: &str) -> Vec<String> {
    let quoted = text.split('"').skip(1).step_by(2);
    let mut names: Vec<String> = quoted.map(String::from).collect();
    names.sort();
    names.dedup();
    names
}

const BRACKET: &str = "\
%
O1234 (BRACKET)
(FIRST SIDE)
N10 G21 G90 G17 G40 G80
N20 T1 M6 (MILL D10)
N30 G54 G0 X0 Y0 S1200 M3
N40 G43 H1 Z50. M8
N50 Z2.
N60 G1 Z-3. F200.
N70 X40. F500.
N80 G3 X50. Y10. I0 J10.
N90 G2 X60. Y20. R10.
N100 G3 I-10. (FULL CIRCLE)
G1 G41 D1 X0 Y0
Y10.
X10.
G40 X20.
G4 P500
M0
G0 Z50. M9
G91 G28 Z0
G90
T2 M6
(DRILL)
G0 G55 X10. Y-10. S2000 M3
G43 H2 Z30.
G98 G81 X10. Y10. Z-5. R2. F100.
X20.
G80
G99 G82 X10. Y30. Z-5. R2. P300
X20.
G80
G83 X30. Y30. Z-13. R2. Q5.
G80
G73 X40. Y30. Z-13. R2. Q4.
G80
G85 X50. Y30. Z-13. R2.
G80
G0 Z30.
T3 M6
G54.1 P2 X5. Y5. S500 M3
G43 H3 Z10.
G84 X5. Y5. Z-8. R3. F500.
G80
M98 P100 L2
G53 G0 Z0
M30
O100
G91
G1 X5. F300.
G90
M99
%
";

#[test]
fn a_program_in_the_words_of_the_other_language() {
    let old = job(BRACKET, wide("fanuc-30i"));
    let found = convert(&old, &wide("heidenhain-mill"), &ConversionOptions::default());
    assert!(found.holds(), "{}\n{}", verdict(&found), found.text);
    insta::assert_snapshot!(found.text);
    let middle = job(&found.text, found.machine.clone());
    let back = convert(&middle, old.machine(), &ConversionOptions::default());
    assert!(back.holds(), "{}\n{}", verdict(&back), back.text);
    insta::assert_snapshot!(back.text);
}

/// Proved there and back; the two texts.
fn proved_both_ways(text: &str, from: &str) -> [String; 2] {
    let old = job(text, wide(from));
    let trip = RoundTrip::through(&old, &wide("heidenhain-mill"));
    let back = trip.back.as_ref().map(|back| back.text.clone()).unwrap_or_default();
    assert_eq!(trip.holds(), [true; 2], "{}\n{text}\n{}\n{back}", trip.verdict(), trip.there.text);
    [trip.there.text, back]
}

/// The texts have these lines.
fn has_lines(texts: &[String; 2], lines: [&[&str]; 2]) {
    for (text, lines) in texts.iter().zip(lines) {
        for line in lines {
            assert!(text.contains(line), "{line} is not in\n{text}");
        }
    }
}

const HEAD: &str = "G21 G90 G17 G40 G80\nT1 M6\nG54 G0 X0 Y0 S900 M3\nG43 H1 Z20.\n";

#[test]
fn arcs_in_three_planes_and_helices() {
    let text = format!(
        "{HEAD}G1 Z0 F300.\nG3 X20. I10. J0\nG18 G2 X40. Z0 I10. K0\nG19 G3 Y20. Z0 J10. K0\nG17 G2 X40. Y20. Z-5. I-10. J0\nG0 Z20.\nM30\n"
    );
    let texts = proved_both_ways(&text, "fanuc-30i");
    let klartext = ["CC X+10 Y+0", "CC X+30 Z+0", "CC Y+10 Z+0", "C X+40 Y+20 Z-5 DR-"];
    has_lines(&texts, [&klartext, &["G18", "G19"]]);
    let turns = "T1 M6\nG90 G54 G0 X0 Y0 S900 M3\nZ20 D1\nG1 Z0 F300\nG3 X0 Y0 Z-6 I10 J0 TURN=2\nG3 X10 Y10 Z-9 I10 J0 TURN=1\nG0 Z20\nM30\n";
    let texts = proved_both_ways(turns, "sinumerik-mill");
    has_lines(&texts, [&["CP IPA+1080 IZ-6 DR+", "CP IPA+630 IZ-3 DR+"], &["TURN=2", "TURN=1"]]);
}

#[test]
fn inches() {
    let text = "G20 G90 G17 G40 G80\nT1 M6\nG54 G0 X0 Y0 S900 M3\nG43 H1 Z1.\nG1 Z0 F12.5\nG2 X1.5 Y0 I.75 J0\nG0 Z1.\nG99 G82 X.125 Y.25 Z-.5 R.1 P200 F5.\nG80\nM30\n";
    let texts = proved_both_ways(text, "fanuc-30i");
    has_lines(
        &texts,
        [
            &["BEGIN PGM PROGRAM INCH", "L Z+0 F125", "C X+1.5 Y+0 DR-", "Q206=+50 ", "Q200=+0.1 "],
            &["G20", "F12.5", "G82"],
        ],
    );
}

#[test]
fn holes_stay_cycles() {
    let text = format!(
        "{HEAD}G98 G81 X5. Y5. Z-5. R2. F100.\nX15.\nG80\nG99 G82 X25. Z-5. R2. P500\nG80\nG83 X35. Z-12. R2. Q3.\nG80\nG73 X45. Z-12. R2. Q3.\nG80\nG85 X55. Z-12. R2.\nG80\nG0 Z20.\nM30\n"
    );
    let texts = proved_both_ways(&text, "fanuc-30i");
    let klartext = ["CYCL DEF 200 ", "CYCL DEF 205 ", "CYCL DEF 201 ", "R0 FMAX M99"];
    has_lines(&texts, [&klartext, &["G81", "G82", "G83", "G73", "G85"]]);
    let taps = format!(
        "{HEAD}G0 X5. Y5.\nZ3.\nG84 Z-8. R3. F900.\nG80\nM5\nM4\nG0 X15.\nG74 Z-8. R3. F900. P300\nG80\nG0 Z20.\nM30\n"
    );
    let texts = proved_both_ways(&taps, "fanuc-30i");
    let klartext = ["CYCL DEF 207 ", "Q239=+1 ", "CYCL DEF 206 ", "Q211=+0.3 "];
    has_lines(&texts, [&klartext, &["G84", "G74"]]);
}

#[test]
fn feeds_times_tolerances_and_offsets() {
    let text = format!(
        "{HEAD}G1 Z0 F300.\nG95 X10. F.2\nY10.\nG94 X0 F300.\nG4 P1500\nG0 G59 X1. Y1.\nG54.1 P3 X2.\nM7\nG1 X5.\nM9\nM1\nG0 Z20.\nM5\nM30\n"
    );
    let texts = proved_both_ways(&text, "fanuc-30i");
    let klartext =
        ["L X+10 F0.2 M136", "L X+0 F300 M137", "DWELL 1.5", "Q339=+6 ", "Q339=+9 ", "M7", "M1\n"];
    has_lines(&texts, [&klartext, &["G95", "G94", "G4", "G59", "G54.1 P3", "M7", "M1"]]);
    let linux = "G21 G90 G17 G40 G64 P0.05\nT1 M6\nG54 G0 X0 Y0 S900 M3\nG43 H1 Z20.\nG1 Z0 F300\nX10\nG61 Y10\nG0 Z20\nM30\n";
    let texts = proved_both_ways(linux, "linuxcnc-mill");
    has_lines(&texts, [&["CYCL DEF 32.1 T0.05\n", "CYCL DEF 32.1\n"], &["G64"]]);
}

/// A program with the data of its tool, holes and a contour.
const PLATE: &str = "\
0 BEGIN PGM PLATE MM
1 BLK FORM 0.1 Z X+0 Y+0 Z-20
2 BLK FORM 0.2 X+100 Y+60 Z+0
3 TOOL DEF 1 L+0 R+5
4 TOOL CALL 1 Z S2000 F400
5 L Z+50 R0 FMAX M3
6 L X-10 Y-10 R0 FMAX M8
7 L Z-5 FMAX
8 L X+10 Y+10 RL FAUTO ; CONTOUR
9 L Y+40
10 RND R5
11 L X+50
12 L Y+10
13 L X+5
14 L Y-10 R0
15 L Z+50 FMAX M9
16 L Z+0 R0 FMAX M91
17 TOOL CALL 2 Z S1500
18 CYCL DEF 247 DATUM SETTING ~
  Q339=+2 ;DATUM NUMBER
19 L X+20 Y+20 R0 FMAX M3
20 L Z+30 FMAX
21 CYCL DEF 200 DRILLING ~
  Q200=2 ;SET-UP CLEARANCE ~
  Q201=-15 ;DEPTH ~
  Q206=150 ;FEED RATE FOR PLNGNG ~
  Q202=15 ;PLUNGING DEPTH ~
  Q210=0 ;DWELL TIME AT TOP ~
  Q203=+0 ;SURFACE COORDINATE ~
  Q204=30 ;2ND SET-UP CLEARANCE ~
  Q211=0.5 ;DWELL TIME AT DEPTH
22 LBL 1
23 L IX+10 FMAX M99
24 CALL LBL 1 REP 3
25 L Z+30 FMAX
26 TOOL CALL 3 Z S500
27 L X+20 Y+20 R0 FMAX M3
28 L Z+3 FMAX
29 CYCL DEF 207 RIGID TAPPING ~
  Q200=3 ;SET-UP CLEARANCE ~
  Q201=-8 ;DEPTH ~
  Q239=+1 ;THREAD PITCH ~
  Q203=+0 ;SURFACE COORDINATE ~
  Q204=3 ;2ND SET-UP CLEARANCE
30 CYCL CALL
31 L Z+50 FMAX M30
32 END PGM PLATE MM
";

#[test]
fn a_conversational_program_on_other_controls() {
    let old = job(PLATE, wide("heidenhain-mill"));
    let mut texts = String::new();
    for target in TARGETS {
        let found = converted(&old, target);
        assert!(found.holds(), "{target}: {}\n{}", verdict(&found), found.text);
        texts += &format!("==== {target}\n{}", found.text);
        let reasons = found.changes.iter().map(|change| change.reason.as_str());
        let of_tool = reasons.into_iter().filter(|reason| reason.contains("tool table")).count();
        assert_eq!(of_tool, 1, "{target}");
        assert_eq!(found.machine.tools[&1].diameter_mm, Some(10.0));
    }
    insta::assert_snapshot!(texts);
}

/// Each change of the new program is seen by the proof.
#[test]
fn the_proof_sees_changes() {
    let old = job(BRACKET, wide("fanuc-30i"));
    let found = convert(&old, &wide("heidenhain-mill"), &ConversionOptions::default());
    let changes = [
        ("TOOL CALL 2 Z", "TOOL CALL 3 Z"),
        ("M91", "M99"),
        ("Q339=+2", "Q339=+3"),
        ("1234 MM", "1234 INCH"),
        ("F500", "F501"),
        ("S1200", "S1201"),
        ("DWELL 0.5", "DWELL 0.6"),
        (" RL", " RR"),
        ("C X+50 Y+10 DR+", "C X+50 Y+10 DR-"),
        ("CC X+50 Y+20", "CC X+50.02 Y+20"),
        ("Q201=-5 ", "Q201=-5.01 "),
        ("Q204=+30 ", "Q204=+25 "),
        ("Q211=+0.3 ", "Q211=+0.4 "),
        ("Q202=+5 ;PLUNGING DEPTH ~\n  Q203", "Q202=+4 ;PLUNGING DEPTH ~\n  Q203"),
        ("Q258=+1 ", "Q258=+1.2 "),
        ("Q257=+4 ", "Q257=+5 "),
        ("Q208=+100 ", "Q208=+200 "),
        ("Q239=+1 ", "Q239=+1.25 "),
        ("M8", "M7"),
        (" M9\n", "\n"),
    ];
    assert_changes_are_seen(&old, &found, &changes);
}

/// What is refused, each with its sentence.
#[test]
fn refusals_have_a_sentence() {
    let reason = |text: &str, from: &str, to: &str| {
        let found = convert(&job(text, wide(from)), &wide(to), &ConversionOptions::default());
        assert!(!found.holds() && found.text.is_empty(), "{text}\n{}", found.text);
        format!("line {}: {}", found.refusals[0].line, found.refusals[0].reason)
    };
    let mut table = String::new();
    for text in [
        "G21 G91 S900 M3\nG0 X5. Z5.\nG90 G1 X0 F100.\nM30\n",
        "G21 G90 G54 S900 M3\nG0 X0 Y0 Z5.\n/G1 X10. F100.\nM30\n",
        "G21 G90 G54 T2 M6\nS900 M3\nG0 X0 Y0\nG43 H12 Z5.\nG1 X10. F100.\nM30\n",
        "G21 G90 G54 T2 M6\nS900 M3\nG0 X0 Y0\nZ5.\nG1 X10. F100.\nM30\n",
        "G21 G90 G54 T2 M6\nS900 M3\nG0 X0 Y0\nG43 H2 Z5.\nG1 G41 D5 X10. Y10. F100.\nG40 X20.\nM30\n",
        "G21 G90 G54 S900 M3\nG0 X0 Y0 Z5.\nG10 L2 P1 X5.\nG1 X10. F100.\nM30\n",
        "G21 G90 G54 M3\nG0 X0 Y0 Z5.\nG1 X10. F100.\nM30\n",
        "G21 G90 G54 T1 M6\nG43 H1 G0 X0 Y0 Z5. S900 M3\nT2 M6\nG43 H2\nG3 X10. Z-1. I5. J0 F100.\nM30\n",
        "G21 G90 G54 S900 M3\nG0 X0 Y0 Z5.\nG31 X10. F100.\nM30\n",
    ] {
        table += &format!("{text}    {}\n", reason(text, "fanuc-30i", "heidenhain-mill"));
    }
    let block = |body: &str| format!("0 BEGIN PGM A MM\n{body}9 END PGM A MM\n");
    for body in [
        "1 TOOL CALL 1 Z S900\n2 L Z+5 R0 FMAX M3\n/ 3 L X+10 F100\n",
        "1 TOOL CALL 1 Y S900\n2 L Y+5 R0 FMAX M3\n3 L X+10 F100\n",
        "1 TOOL CALL 1 Z S900 DL+1\n2 L Z+5 R0 FMAX M3\n3 L X+10 F100\n4 TOOL CALL 1 Z DL+2\n5 L Z+0\n",
        "1 TOOL DEF 1 L+0 R+5\n2 TOOL CALL 1 Z S900\n3 L X-7 Y+14 R0 FMAX M3\n4 L Z-5 F300\n5 APPR CT X+0 Y+20 CCA90 R+2 RL F300\n6 L Y+60\n7 DEP LT LEN10\n",
        "1 TOOL DEF 5 L+0 R+5\n2 TOOL CALL 5 Z S900\n3 L Z+5 R0 FMAX M3\n4 CYCL DEF 209 TAPPING W/ CHIP BRKG Q200=5 Q201=-20 Q239=+1 Q203=+0 Q204=+20 Q257=5 Q256=1 Q336=0\n5 L X+5 Y+5 FMAX M99\n",
        "1 TOOL DEF 5 L+0 R+5\n2 TOOL CALL 5 Z S900\n3 L Z+5 R0 FMAX M3\n4 CYCL DEF 256 RECTANGULAR STUD Q218=60 Q424=70 Q219=40 Q425=50 Q220=5 Q368=0 Q224=0 Q367=0 Q207=500 Q351=+1 Q201=-5 Q202=5 Q206=150 Q200=2 Q203=+0 Q204=20 Q370=1 Q437=0 Q215=0 Q369=0 Q338=0 Q385=500\n5 L X+5 Y+5 FMAX M99\n",
        "1 TOOL CALL \"MILL\" Z S900\n2 L Z+5 R0 FMAX M3\n3 L X+10 F100\n",
        "1 TOOL CALL 1 Z S900\n2 L Z+5 R0 FMAX M3\n3 PLANE SPATIAL SPA+10 SPB+0 SPC+0 STAY\n4 L X+10 F100\n",
    ] {
        let text = block(body);
        table += &format!("{text}    {}\n", reason(&text, "heidenhain-mill", "haas-vf2"));
    }
    insta::assert_snapshot!(table);
}

/// The plane of an arc before a contour is not that of the contour.
#[test]
fn compensation_after_arcs_in_other_planes() {
    let text = format!(
        "{HEAD}G0 X-20. Y-20.\nG1 Z-3. F300.\nG18 G2 X-10. Z-3. I5. K0\nG19 G3 Y-10. Z-3. J5. K0\nG17\nG1 G41 D1 X0 Y0\nY40.\nX40.\nY0\nX-20.\nG40 Y-20.\nG0 Z20.\nM30\n"
    );
    let texts = proved_both_ways(&text, "fanuc-30i");
    has_lines(&texts, [&["L X+0 Y+0 RL", "L Y-20 R0"], &["G41 D1", "G40"]]);
}

/// TOOL DEF gives a length that the tool table does not have.
#[test]
fn lengths_of_the_program_itself() {
    let text = "0 BEGIN PGM A MM\n1 TOOL DEF 5 L+30 R+6\n2 TOOL CALL 5 Z S900\n3 L Z+50 R0 FMAX M3\n4 L X-15 Y+35 FMAX\n5 L Z-3 F200\n6 L X+20\n7 L Z+50 FMAX M30\n8 END PGM A MM\n";
    let old = job(text, wide("heidenhain-mill"));
    for target in TARGETS {
        let found = converted(&old, target);
        assert!(found.holds(), "{target}: {}\n{}", verdict(&found), found.text);
        assert_eq!(found.machine.tools[&5].offset[2], Some(30.0));
    }
}

/// On controls that need a lead-in longer than the radius, compensation begins with the line before the approach.
#[test]
fn approaches_are_parts_of_contours() {
    for (approach, lines) in [
        ("APPR LT X+5 Y+5 LEN15 RL F300", ["G41 D18 X5. Y-10.", "Y5. F300."]),
        ("APPR LN X+5 Y+5 LEN15 RL F300", ["G41 D18 X5.", "Y95."]),
        ("APPR CT X+5 Y+5 CCA90 R+4 RL F300", ["G41 D18 ", "G3 X5. Y5."]),
        ("APPR LCT X+5 Y+5 R5 RL F300", ["G41 D18 ", "G3 X5. Y5."]),
    ] {
        let text = format!(
            "0 BEGIN PGM A MM\n1 TOOL DEF 18 L+0 R+10\n2 TOOL CALL 18 Z S3000\n3 L Z+250 R0 FMAX M3\n4 L X-20 Y-20 R0 FMAX\n5 L Z-8 R0 F1000\n6 {approach}\n7 L X+5 Y+95\n8 L X+95 Y+95\n9 L X+95 Y+5\n10 L X+5 Y+5\n11 DEP LT LEN10 F1000\n12 L Z+250 R0 FMAX M30\n13 END PGM A MM\n"
        );
        let old = job(&text, wide("heidenhain-mill"));
        for target in ["haas-vf2", "linuxcnc-mill"] {
            let found = converted(&old, target);
            assert!(found.holds(), "{target}: {}\n{}", verdict(&found), found.text);
            for line in lines {
                assert!(found.text.contains(line), "{line} is not in\n{}", found.text);
            }
            let reasons = found.changes.iter().filter(|one| one.reason.contains("lead-in"));
            assert_eq!(reasons.map(|one| one.line).collect::<Vec<u32>>(), [7], "{}", found.text);
            let changes = [
                (lines[0], "G41 D18 X4.9 Y-9."),
                ("G41 D18", "G41 D17"),
                ("Y95.", "Y95.02"),
                ("X95.", "X95. F310."),
            ];
            if target == "haas-vf2" && approach.contains("APPR LT") {
                assert_changes_are_seen(&old, &found, &changes);
            }
        }
    }
}
