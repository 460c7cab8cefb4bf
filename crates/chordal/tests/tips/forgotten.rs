//! Ways to forget or to mistake the length of a tool, on every control: where the tip is, the verdict on the stock
//! with lengths that are known and with lengths that are not, and the line that is named.
//!
//! Tool 1 is 100 mm long and tool 2 is 200 mm long; the program goes to Z-5 with tool 2, so the tip is at
//! -5 + (length in force - 200).

use chordal::stock::StockVerdict::{self, Clean, NotProved, Problems};
use chordal::{Code, Diagnostic};

use super::lowest_tip;
use crate::run;
use crate::turned::turn_on;

/// What one way of writing does.
struct LengthCase {
    what: &'static str,
    /// Blocks before the change to tool 2.
    before: &'static str,
    /// The change.
    change: &'static str,
    /// Blocks from the change to the approach, which is the last of them.
    approach: &'static str,
    /// Blocks between the approach and the cut.
    between: &'static str,
    /// Where the tip is at the bottom of the cut, mm.
    tip_mm: f64,
    /// The verdict where both lengths are in the machine file, and where none is.
    verdicts: [StockVerdict; 2],
}

const CHANGE: &str = "T2 M6";
/// The tip is where the program says.
const RIGHT: [StockVerdict; 2] = [Clean, Clean];
/// It is not, which is known only with the lengths.
const WRONG: [StockVerdict; 2] = [Problems, NotProved];

const fn way(
    what: &'static str,
    approach: &'static str,
    tip_mm: f64,
    verdicts: [StockVerdict; 2],
) -> LengthCase {
    LengthCase { what, before: "", change: CHANGE, approach, between: "", tip_mm, verdicts }
}

/// Tool 1 cuts first, with its own length.
const FIRST_TOOL: &str = "T1 M6\nG0 X10. Y20. S3000 M3\nG43 H1 Z25.\nG1 Z-1. F300.\nG0 Z25.\n\
                          G91 G28 Z0.\nG90";

/// Of controls whose programs say G43 with H.
fn common_ways() -> Vec<LengthCase> {
    vec![
        way("the length of the tool", "G43 H2 Z25.", -5.0, RIGHT),
        way("no length", "Z25.", -205.0, WRONG),
        way("the length of tool 1", "G43 H1 Z25.", -105.0, WRONG),
        LengthCase {
            between: "G49",
            ..way("cancelled before the cut", "G43 H2 Z25.", -205.0, WRONG)
        },
        LengthCase { before: "G43 H2", ..way("before the change of tools", "Z25.", -5.0, RIGHT) },
        LengthCase { before: FIRST_TOOL, ..way("that of tool 1 stays", "Z25.", -105.0, WRONG) },
        LengthCase {
            before: FIRST_TOOL,
            ..way("two tools, both right", "G43 H2 Z25.", -5.0, RIGHT)
        },
    ]
}

/// `G43 H0` brings no length into force.
fn zero_is_none() -> LengthCase {
    way("H0", "G43 H0 Z25.", -205.0, WRONG)
}

/// G43 without H uses the H that is in force.
fn without_number_in_force() -> Vec<LengthCase> {
    vec![
        way("G43 without H", "G43 Z25.", -205.0, WRONG),
        LengthCase {
            before: FIRST_TOOL,
            ..way("G43 without H after tool 1", "G43 Z25.", -105.0, WRONG)
        },
    ]
}

/// G43 without H uses the tool in the spindle.
fn without_number_of_tool() -> Vec<LengthCase> {
    vec![
        way("G43 without H", "G43 Z25.", -5.0, RIGHT),
        LengthCase {
            before: FIRST_TOOL,
            ..way("G43 without H after tool 1", "G43 Z25.", -5.0, RIGHT)
        },
    ]
}

/// Controls with a wear of each length and with G44.
fn wear_and_minus() -> Vec<LengthCase> {
    vec![
        LengthCase { before: "G10 L11 P2 R0.5", ..way("wear alone", "G43 H2 Z25.", -4.5, RIGHT) },
        // Who subtracts all lengths keeps them with the other sign.
        way("G44 alone", "G44 H2 Z25.", -5.0, RIGHT),
        LengthCase { before: FIRST_TOOL, ..way("G44 after G43", "G44 H2 Z25.", -405.0, WRONG) },
    ]
}

/// The length stays through returns to the reference point and moves in machine coordinates.
fn kept_ways() -> Vec<LengthCase> {
    vec![
        LengthCase {
            between: "G91 G28 Z0.\nG90 Z25.",
            ..way("a return to the reference point", "G43 H2 Z25.", -5.0, RIGHT)
        },
        LengthCase {
            between: "G53 G0 Z0.\nG0 Z25.",
            ..way("a move of the machine", "G43 H2 Z25.", -5.0, RIGHT)
        },
    ]
}

/// The ways of each control.
fn table() -> Vec<(&'static str, Vec<LengthCase>)> {
    let fanuc = || {
        let mut ways = common_ways();
        ways.push(zero_is_none());
        ways.extend(without_number_in_force());
        ways.extend(wear_and_minus());
        ways.extend(kept_ways());
        ways
    };
    // Setting 15: the number of another tool is an alarm.
    let haas = || {
        let mut ways = fanuc();
        let others = ["the length of tool 1", "G43 without H after tool 1"];
        for way in ways.iter_mut().filter(|way| others.contains(&way.what)) {
            way.verdicts[1] = Problems;
        }
        ways
    };
    let mut linuxcnc = common_ways();
    // The offset of the tool in the spindle, on machines whose changer puts tools back (G43, "H0 is a special case").
    linuxcnc.push(way("H0", "G43 H0 Z25.", -5.0, RIGHT));
    linuxcnc.extend(without_number_of_tool());
    linuxcnc.extend(kept_ways());
    linuxcnc.extend([
        LengthCase {
            before: "G10 L1 P2 Z200.5",
            ..way("another length in the table", "G43 H2 Z25.", -4.5, RIGHT)
        },
        // Where no length is given, the program says it.
        way("the length in the block", "G43.1 Z200.\nZ25.", -5.0, RIGHT),
        way("a wrong length in the block", "G43.1 Z150.\nZ25.", -55.0, [Problems, Clean]),
        way("added to that of tool 1", "G43 H1\nG43.2 H1\nZ25.", -5.0, [Clean, NotProved]),
    ]);
    let mut mach3 = common_ways();
    mach3.push(zero_is_none());
    mach3.extend(kept_ways());
    let fadal = vec![
        way("the length of the tool", "H2 Z25.", -5.0, RIGHT),
        way("no length", "Z25.", -205.0, WRONG),
        way("the length of tool 1", "H1 Z25.", -105.0, WRONG),
        way("H0", "H0 Z25.", -205.0, WRONG),
        LengthCase { between: "H0", ..way("cancelled before the cut", "H2 Z25.", -205.0, WRONG) },
        LengthCase { between: "G49", ..way("G49 before the cut", "H2 Z25.", -205.0, WRONG) },
        LengthCase {
            before: "T1 M6\nG0 X10. Y20. S3000 M3\nH1 Z25.\nG1 Z-1. F300.\nG0 Z25.\nG91 G28 Z0.\nG90",
            ..way("that of tool 1 stays", "Z25.", -105.0, WRONG)
        },
    ];
    let none = || vec![way("no length", "Z25.", -5.0, RIGHT)];
    vec![
        ("fanuc-0i", fanuc()),
        ("haas-vf2", haas()),
        ("mitsubishi-m700", fanuc()),
        ("linuxcnc-mill", touched_off(linuxcnc)),
        ("mach3-mill", touched_off(mach3)),
        ("grblhal", none()),
        ("fadal-4020", fadal),
        ("grbl", none()),
        ("fluidnc", none()),
        ("marlin-router", none()),
    ]
}

/// The same where the work offset is set with each tool that has no length.
fn touched_off(mut ways: Vec<LengthCase>) -> Vec<LengthCase> {
    for way in ways.iter_mut().filter(|way| ["no length", "H0"].contains(&way.what)) {
        way.verdicts[1] = Clean;
    }
    ways
}

fn setup(machine: &str, is_known: bool) -> String {
    let work_offset = if machine.starts_with("fadal") { "E1" } else { "G54" };
    let length = |mm: u32| {
        if is_known { format!("length = \"{mm} mm\"\n") } else { String::new() }
    };
    let tool = |number: u32, mm: u32| {
        format!(
            "[tools.{number}]\nshape = \"flat\"\ndiameter = \"10 mm\"\nflute_length = \"500 mm\"\n{}",
            length(mm)
        )
    };
    let lengths_exist = !["grblhal", "grbl", "fluidnc", "marlin-router"].contains(&machine);
    let z = if lengths_exist { -290 } else { -50 };
    format!(
        "machine = \"{machine}\"\n[work_offsets.{work_offset}]\nX = \"-100 mm\"\nY = \"-100 mm\"\nZ = \"{z} mm\"\n\
         [stock]\nshape = \"box\"\nfrom = {{ X = \"0 mm\", Y = \"0 mm\", Z = \"-20 mm\" }}\n\
         to = {{ X = \"40 mm\", Y = \"40 mm\", Z = \"0 mm\" }}\n{}{}",
        tool(if is_marlin(machine) { 0 } else { 1 }, 100),
        tool(2, 200)
    )
}

/// The program, with the numbers of the lines of the approach and of the cut.
fn program(machine: &str, way: &LengthCase) -> (String, [u32; 2]) {
    let has_firmware = ["grbl", "fluidnc", "marlin-router"].contains(&machine);
    let (start, offset) = match machine {
        "fadal-4020" => ("G21 G90", "E1"),
        "marlin-router" => ("G21\nG90", ""),
        _ if has_firmware => ("G21 G90", "G54"),
        "grblhal" | "mach3-mill" | "linuxcnc-mill" => ("G21 G90 G17 G40 G49 G80", "G54"),
        _ => ("O1\nG21 G90 G17 G40 G49 G80", "G54"),
    };
    let change = if is_marlin(machine) { "" } else { way.change };
    let mut text = format!("{start}\n{offset}\n{}\n{change}\n", way.before);
    text += match machine {
        "marlin-router" => "M3 S255\nG0 X20 Y20\n",
        _ => "G0 X20. Y20. S3000 M3\n",
    };
    text += way.approach;
    let approach = text.lines().count() as u32;
    text += &format!("\n{}\nG1 Z-5. F300.\n", way.between);
    let cut = text.lines().count() as u32;
    text += "G0 Z25.\nM30\n";
    if is_marlin(machine) {
        text = text.replace("M30\n", "");
    }
    (text, [approach, cut])
}

/// Firmware takes one command a line and has no table of tools: the tool is number 0.
fn is_marlin(machine: &str) -> bool {
    machine == "marlin-router"
}

fn is_touched_off(machine: &str) -> bool {
    ["linuxcnc-mill", "mach3-mill"].contains(&machine)
}

fn line_of(text: &str, diagnostic: &Diagnostic) -> u32 {
    let start = diagnostic.primary.span.range.start as usize;
    text[..start].matches('\n').count() as u32 + 1
}

#[test]
fn the_tip_of_every_way_to_forget_a_length_is_where_the_machine_puts_it() {
    let mut wrong = Vec::new();
    let mut count = 0;
    for (machine, ways) in table() {
        for way in &ways {
            for (is_known, expected) in [(true, way.verdicts[0]), (false, way.verdicts[1])] {
                count += 1;
                let (text, [approach, cut]) = program(machine, way);
                let found = run(&setup(machine, is_known), &text);
                let mut miss = |what: String| {
                    wrong.push(format!("{machine}, {}, known {is_known}: {what}", way.what));
                };
                if found.verdict != expected {
                    let says: Vec<_> = found
                        .report
                        .diagnostics
                        .iter()
                        .map(|each| (each.code, each.message.clone()))
                        .collect();
                    miss(format!("{:?} instead of {expected:?}: {says:?}", found.verdict));
                }
                let tip = lowest_tip(&found);
                if is_known && (tip - way.tip_mm).abs() > 1e-6 {
                    miss(format!("the tip at {tip} instead of {}", way.tip_mm));
                }
                let says = |code: Code| {
                    let mut all = found.report.diagnostics.iter();
                    all.find(|each| each.code == code).map(|each| line_of(&text, each))
                };
                let line = match expected {
                    Problems if way.between.is_empty() => (Code::TipDisplaced, Some(approach)),
                    Problems => (Code::TipDisplaced, Some(cut)),
                    NotProved => (Code::TipNotKnown, Some(cut)),
                    _ => (Code::TipDisplaced, None),
                };
                let is_said_otherwise = expected == Problems && !is_known
                    || expected == NotProved && is_touched_off(machine);
                if !is_said_otherwise && says(line.0) != line.1 {
                    miss(format!(
                        "line {:?} of {:?} instead of {:?}",
                        says(line.0),
                        line.0,
                        line.1
                    ));
                }
            }
        }
    }
    println!("{count} programs, {} deviations", wrong.len());
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn a_length_that_the_end_of_a_program_keeps_is_unknown_to_the_next_one() {
    // The first tool has no G43; where the control keeps lengths at M30, the last one of the program before is active.
    let way = way("no length", "Z25.", -5.0, WRONG);
    for machine in ["fanuc-0i", "haas-vf2", "mitsubishi-m700", "fadal-4020", "linuxcnc-mill"] {
        let (text, [_, cut]) = program(machine, &way);
        let open = text.replace(" G49", "");
        let settings = |at_end: &str| {
            format!("[settings]\ntool_lengths = \"table\"\nlength_at_program_end = \"{at_end}\"\n")
        };
        let run_with = |text: &str, at_end: &str, is_known: bool| {
            let setup = setup(machine, is_known);
            run(&setup.replacen("[work", &format!("{}[work", settings(at_end)), 1), text)
        };
        assert_eq!(run_with(&text, "ended", true).verdict, Problems, "{machine}");
        for is_known in [true, false] {
            let found = run_with(&open, "kept", is_known);
            assert_eq!(found.verdict, NotProved, "{machine}: {:?}", found.report.diagnostics);
            let says = found.report.diagnostics.iter().find(|each| each.code == Code::TipNotKnown);
            let says = says.unwrap_or_else(|| panic!("{machine}: no CH611"));
            assert!(says.message.contains("the program before"), "{machine}: {}", says.message);
            assert_eq!(line_of(&open, says), cut, "{machine}");
        }
        // A program that ends it, or brings its own into force, does not depend on the one before.
        let ends = open.replacen("\nG0 X20.", "\nG49\nG0 X20.", 1);
        assert_eq!(run_with(&ends, "kept", true).verdict, Problems, "{machine}");
        let brings = match machine {
            "fadal-4020" => "\nH2 Z25.\n",
            _ => "\nG43 H2 Z25.\n",
        };
        let brings = open.replacen("\nZ25.\n", brings, 1);
        let found = run_with(&brings, "kept", true);
        assert_eq!(found.verdict, Clean, "{machine}: {:?}", found.report.diagnostics);
    }
}

/// A bar of 40 mm; the program turns it to 30 mm over 20 mm. The offset of tool 1 is 10 mm of diameter smaller.
const BAR: &str =
    "[stock]\nshape = \"cylinder\"\ndiameter = \"40 mm\"\nfrom = \"-60 mm\"\nto = \"0 mm\"\n";

#[test]
fn the_offset_of_another_station_moves_the_tip_of_a_turning_tool() {
    let tool = |machine: &str, number: u32, x: i32, is_known: bool| {
        // LinuxCNC numbers the tips with X the other way round.
        let tip = if machine == "linuxcnc-lathe" { 2 } else { 3 };
        let offset = match is_known {
            true => format!("offset.X = \"{x} mm\"\noffset.Z = \"-50 mm\"\n"),
            false => String::new(),
        };
        format!(
            "[tools.{number}]\nshape = \"insert\"\ninsert = \"C\"\napproach_angle = \"95 deg\"\n\
             flute_length = \"12 mm\"\nnose_radius = \"0.4 mm\"\ntip = {tip}\n{offset}"
        )
    };
    let setup = |machine: &str, is_known: bool| {
        format!(
            "[work_offsets.G54]\nX = \"0 mm\"\nZ = \"-300 mm\"\n{BAR}{}{}",
            tool(machine, 1, -100, is_known),
            tool(machine, 2, -90, is_known)
        )
    };
    // The word of the tool, the diameter that is turned, and the verdicts.
    let right = |text| (text, 30.0, RIGHT);
    let other = |text| (text, 20.0, WRONG);
    let none = |text| (text, 120.0, WRONG);
    // Without an offset the slide itself is sent to X30, beyond its end.
    let beyond = |text| (text, 120.0, [Problems, Problems]);
    let fanuc = vec![
        right("T0202"),
        other("T0201"),
        beyond("T0200"),
        right("T0101\nT0202"),
        other("T0202\nT0201"),
        beyond("T0202\nT0200"),
    ];
    let linuxcnc = vec![
        right("T2 M6 G43"),
        right("T2 M6\nG43 H2"),
        other("T2 M6\nG43 H1"),
        ("T2 M6", 120.0, [Problems, Clean]),
        none("T2 M6 G43\nG49"),
    ];
    let table = [
        ("fanuc-lathe", fanuc.clone()),
        ("haas-lathe", fanuc.clone()),
        ("mitsubishi-lathe", fanuc),
        ("linuxcnc-lathe", linuxcnc),
    ];
    let mut wrong = Vec::new();
    for (machine, ways) in table {
        let start = if machine.starts_with("linuxcnc") {
            "G21 G18 G40 G7 G95"
        } else {
            "O1\nG21 G18 G40 G99"
        };
        for (tool, diameter, verdicts) in ways {
            for (is_known, expected) in [(true, verdicts[0]), (false, verdicts[1])] {
                let text = format!(
                    "{start}\nG54\n{tool}\nG97 S800 M3\nG0 X30. Z2.\nG1 Z-20. F.2\nX44.\nG0 X60.\nZ50.\nM30\n"
                );
                let found = turn_on(machine, &setup(machine, is_known), &text);
                let what = format!("{machine}, {}, known {is_known}", tool.replace('\n', " / "));
                if found.verdict != expected {
                    let says: Vec<_> =
                        found.report.diagnostics.iter().map(|each| each.message.clone()).collect();
                    wrong.push(format!(
                        "{what}: {:?} instead of {expected:?}: {says:?}",
                        found.verdict
                    ));
                }
                if is_known && diameter < 40.0 {
                    let by_hand =
                        std::f64::consts::PI / 4.0 * (1600.0 - diameter * diameter) * 20.0;
                    let removed = found.removed_mm3.most;
                    if (removed - by_hand).abs() > 0.02 * by_hand {
                        wrong.push(format!("{what}: removed {removed} instead of {by_hand}"));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}
