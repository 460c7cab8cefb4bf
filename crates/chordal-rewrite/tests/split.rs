//! Programs in parts: each stands by itself, and one after the other they are the whole.

#![allow(clippy::disallowed_methods, reason = "the programs are files")]

use std::path::Path;

use chordal::control::RunOptions;
use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::{SplitBy, SplitProgram, split};

fn job(text: &str, machine: &str) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    let options = RunOptions { max_repeated_blocks: 20_000, ..RunOptions::default() };
    Job::new(sources, Machine::from_builtin(machine).unwrap()).unwrap().options(options)
}

fn proved(text: &str, machine: &str, by: SplitBy) -> SplitProgram {
    let done = split(&job(text, machine), by).unwrap();
    let differences = &done.certificate.comparison.differences;
    assert!(done.certificate.holds(), "{differences:#?}");
    assert!(done.notes.is_empty(), "{:?}", done.notes);
    done
}

fn texts(done: &SplitProgram) -> Vec<String> {
    done.parts.iter().map(|part| String::from_utf8_lossy(&part.text).into_owned()).collect()
}

const THREE_TOOLS: &str = "\
%
O1000 (COVER)
T1 M06 (FACE)
G00 G90 G17 G20 G40 G49 G80
G54 X0. Y0. S6000 M03
G43 H01 Z1. M08
G01 Z-.05 F10.
X2. F40.
G00 Z1.
X0. Y1.
G01 Z-.05
X2.
G00 Z1. M09
G53 G49 Z0. M05
M01
(SLOTS)
T2 M06
G54 G90 G00 X1. Y1. S2000 M03
G43 H02 Z.5 M08
M98 P2000
G00 X2.
M98 P2000
M09
G53 G49 Z0. M05
T3 M06
G54 G90 G00 X1. Y1. S2000 M03
G43 H03 Z.5
G81 G99 Z-.5 R.1 F8.
X2.
G80
G00 Z1.
M30
O2000 (ONE SLOT)
G91 G01 Z-.6 F10.
X.5 F30.
G00 Z.6
X-.5
G90
M99
%
";

#[test]
fn one_program_for_each_tool() {
    let done = proved(THREE_TOOLS, "haas-vf2", SplitBy::Tool);
    let texts = texts(&done);
    assert_eq!(
        done.parts.iter().map(|part| part.number).collect::<Vec<_>>(),
        [Some(1000), Some(1001), Some(1002)]
    );
    // The remark before the tool change goes with it, and the spindle's and the coolant's end are there.
    assert_eq!(
        texts[1],
        "%\nO1001 (COVER)\n(PART 2 OF 3, FROM LINE 16)\nG20 G17 G90 G40 G80\nG54\nG00\nF40.\n\
         (SLOTS)\nT2 M06\nG54 G90 G00 X1. Y1. S2000 M03\nG43 H02 Z.5 M08\nM98 P2000\nG00 X2.\n\
         M98 P2000\nM09\nG53 G49 Z0. M05\nM30\nO2000 (ONE SLOT)\nG91 G01 Z-.6 F10.\nX.5 F30.\n\
         G00 Z.6\nX-.5\nG90\nM99\n%\n"
    );
    // The subprogram is where it is called.
    assert!(!texts[0].contains("O2000") && !texts[2].contains("O2000"));
}

/// Rows of which each begins and ends above the part, in absolute or incremental coordinates.
fn rows(incremental: bool) -> String {
    let mut text = "%\nO1000\nT1 M06\nG00 G90 G17 G20 G40 G49 G80\nG54 X0. Y0. S6000 M03\n\
                    G43 H01 Z1. M08\n"
        .to_string();
    if incremental {
        text += "G91\n";
    }
    for row in 1..=20 {
        text += &if incremental {
            "G01 Z-1.05 F10.\nX2. F40.\nG00 Z1.05\nX-2. Y.1\n".to_string()
        } else {
            format!("G01 Z-.05 F10.\nX2. F40.\nG00 Z1.\nX0. Y{:.1}\n", f64::from(row) / 10.0)
        };
    }
    text + "G53 G49 Z0. M05\nM30\n%\n"
}

#[test]
fn a_part_begins_as_the_whole_stood_there() {
    let done = proved(&rows(false), "haas-vf2", SplitBy::Bytes(400));
    assert!(done.parts.iter().all(|part| part.text.len() <= 400));
    assert!(done.parts.windows(2).all(|two| two[1].lines[0] == two[0].lines[1] + 1));
    let texts = texts(&done);
    assert!(texts[0].ends_with("G00 Z1.\nX0. Y0.7\nM09\nM05\nM30\n%\n"), "{}", texts[0]);
    assert!(
        texts[1].starts_with(
            "%\nO1001\n(PART 2 OF 4, FROM LINE 35)\nG20 G17 G90 G40 G80\nT1 M06\n\
             G00 G54 X0. Y0.7 S6000 M03\nG43 H01 Z1.\nM08\nF40.\nG01 Z-.05 F10.\n"
        ),
        "{}",
        texts[1]
    );
}

#[test]
fn increments_go_on() {
    let done = proved(&rows(true), "haas-vf2", SplitBy::Bytes(400));
    assert!(done.parts.len() > 2);
    assert_eq!(done.parts[1].begin[0], "G20 G17 G90 G40 G80");
    assert_eq!(done.parts[1].begin.last().unwrap(), "G91");
}

#[test]
fn sections_of_a_fadal_go_with_their_calls() {
    let text = "N1 O77 (SLOTS)\nN2 L100\nN3 G91\nN4 G1 Z-.6 F10.\nN5 X.5 F30.\nN6 G0 Z.6\nN7 X-.5\n\
                N8 G90\nN9 M17\nN10 M30\nN11 M6 T1\nN12 G0 G90 S4000 M3 E1 X0 Y0\nN13 H1 Z.5 M8\n\
                N14 L101\nN15 X2.\nN16 L102\nN17 G0 Z1.\nN18 M5 M9\nN19 M6 T2\n\
                N20 G0 G90 S3000 M3 E1 X0 Y1.\nN21 H2 Z.5\nN22 G1 Z-.1 F5.\nN23 X2.\nN24 G0 Z1.\nN25 M5\n\
                N26 M30\n";
    let done = proved(text, "fadal-4020", SplitBy::Tool);
    let texts = texts(&done);
    assert!(texts[0].contains("L100") && !texts[1].contains("L100"), "{texts:#?}");
    assert!(texts[1].starts_with("N1 O78 (SLOTS)\n(PART 2 OF 2, FROM LINE 19)\n"));
}

#[test]
fn neither_loops_nor_variables_are_parted() {
    let text = "%\nO1\nT1 M6\nG90 G54 G0 X0 Y0 S1000 M3\nG43 H1 Z1.\n#1=0\nWHILE [#1 LT 3] DO1\n\
                G0 X[#1]\nG1 Z-.1 F5.\nG0 Z1.\n#1=#1+1\nEND1\nG0 X5.\nG1 Z-.1\nG0 Z1.\nM30\n%\n";
    let refused = split(&job(text, "haas-vf2"), SplitBy::Bytes(100)).unwrap_err();
    assert!(refused.what.contains("there is no point to split the program"), "{refused}");
    assert!(refused.what.contains("from line 1 to line 13"), "{refused}");
    let done = proved(text, "haas-vf2", SplitBy::Bytes(130));
    assert_eq!(done.parts.len(), 2);
    assert_eq!(done.parts[1].lines, [14, 16]);
}

/// What a part would do otherwise is seen: G52 and G68 are not said again.
#[test]
fn what_is_not_said_again_is_not_parted() {
    let text = "%\nO1\nT1 M6\nG90 G54 G0 X0 Y0 S1000 M3\nG43 H1 Z1.\nG52 X1. Y1.\nG0 X0\nG1 Z-.1 F5.\nG0 Z1.\n\
                X1.\nG1 Z-.1\nG0 Z1.\nX2.\nG1 Z-.1\nG0 Z1.\nG52 X0 Y0\nG0 X5. Y0\nX6.\nG1 Z-.1\nG0 Z1.\nM30\n%\n";
    let done = proved(text, "haas-vf2", SplitBy::Bytes(160));
    assert!(done.parts[1].lines[0] > 16, "{:?}", done.parts);
}

/// Codes that are not carried out may be active: nothing is split after them, and M codes are reported.
#[test]
fn behind_unknown_codes_nothing_is_parted() {
    let text = THREE_TOOLS.replace("(SLOTS)", "G68 X0 Y0 R30.");
    let done = proved(&text, "haas-vf2", SplitBy::Tool);
    assert_eq!(done.parts.len(), 1);
    let text = THREE_TOOLS.replace("(SLOTS)", "M82");
    let done = split(&job(&text, "haas-vf2"), SplitBy::Tool).unwrap();
    assert!(done.certificate.holds() && done.parts.len() == 3);
    assert_eq!(done.notes.len(), 1);
    assert!(
        done.notes[0].starts_with("Chordal does not carry out M82 (line 16)"),
        "{:?}",
        done.notes
    );
}

/// The parts end as the whole does, and a tool that cannot begin a part is reported with the reason.
#[test]
fn what_holds_tools_together_is_told() {
    let text = THREE_TOOLS
        .replace("M30", "M02")
        .replace("S6000", "S#500")
        .replace("T1 M06 (FACE)", "#500=6000\nT1 M06");
    let text = text.replace("X1. Y1. S2000 M03\nG43 H02", "X1. Y1. S#500 M03\nG43 H02");
    let done = split(&job(&text, "haas-vf2"), SplitBy::Tool).unwrap();
    assert!(done.certificate.holds());
    assert_eq!(done.parts.len(), 2);
    assert_eq!(done.notes, ["not split before line 17, inside #500"]);
    assert!(texts(&done)[0].contains("\nM02\n"), "{}", texts(&done)[0]);
}

#[test]
fn an_empty_file_is_no_program() {
    assert!(split(&job("", "haas-vf2"), SplitBy::Tool).unwrap_err().what.contains("no program"));
}

/// Every program of the documents and of the examples, in halves.
#[test]
fn every_program_in_parts() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let (mut parted, mut refused, mut differ) = (0, 0, Vec::new());
    for (folder, machine) in [
        ("fadal", "fadal-4020"),
        ("haas", "haas-vf2"),
        ("fanuc", "fanuc-30i"),
        ("mitsubishi", "mitsubishi-m700"),
        ("linuxcnc", "linuxcnc-mill"),
        ("textbook", "textbook-from-center"),
    ] {
        for base in ["examples", "tests/suite"] {
            let Ok(entries) = std::fs::read_dir(root.join(base).join(folder)) else { continue };
            let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
            files.sort();
            for file in files {
                let is_program =
                    file.extension().is_some_and(|ending| ending == "nc" || ending == "ngc");
                let Ok(text) = std::fs::read(&file) else { continue };
                if !is_program {
                    continue;
                }
                let text = String::from_utf8_lossy(&text).into_owned();
                let job = job(&text, machine);
                for by in [
                    SplitBy::Tool,
                    SplitBy::Bytes(text.len() * 2 / 3),
                    SplitBy::Bytes(text.len() / 2 + 100),
                ] {
                    match split(&job, by) {
                        Ok(done) => {
                            for part in &done.parts {
                                assert!(match by {
                                    SplitBy::Bytes(most) => part.text.len() <= most,
                                    SplitBy::Tool => true,
                                });
                            }
                            parted += usize::from(done.parts.len() > 1);
                            if !done.certificate.holds() && job.report().verified() {
                                differ.push((file.clone(), by));
                            }
                        }
                        Err(error) => {
                            assert!(!error.help.is_empty());
                            refused += 1;
                        }
                    }
                }
            }
        }
    }
    assert!(differ.is_empty(), "{differ:#?}");
    // Most of these programs have one tool and nothing above their cuts on the way.
    assert!(parted >= 22 && refused > 100, "{parted} in parts, {refused} refused");
}

/// The control goes on after its alarm in the text alone: nobody knows whether the scaling acts.
#[test]
fn no_part_begins_after_a_scaling_that_the_control_refuses() {
    let tool = |number: u32| {
        format!("T{number} M6\nS900 M3\nG43 H{number} Z50.\nG0 X0 Y0\nG1 Z-1. F50.\nX9.\nG0 Z50.\n")
    };
    let parts = |scaling: &str| {
        let text = format!("O1\nG21 G90 G54\n{}{scaling}{}M30\n", tool(1), tool(2));
        proved(&text, "fanuc-30i", SplitBy::Tool).parts.len()
    };
    assert_eq!((parts(""), parts("G51 X0 Y0 P0\n"), parts("G51 X0 Y0 P0\nG50\n")), (2, 1, 2));
}
