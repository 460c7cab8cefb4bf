//! Tools as programs' comments name them: a table of comments and what is read, sizes worked out by hand.

use chordal::machine::ToolShape;
use chordal::tool_comments::{CommentedTool, known_tools, read_tool_comment};
use chordal::{Job, Machine, Source, SourceMap};

/// `T1 12 flat corner 0.5 point 118 pitch 1`, mm and degrees; `-`: nothing was read.
fn shown(said: Option<CommentedTool>) -> String {
    let Some(said) = said else { return "-".into() };
    let number =
        |value: f64| format!("{value:.5}").trim_end_matches('0').trim_end_matches('.').to_string();
    let mut text = format!("T{}", said.number);
    if let Some(mm) = said.diameter_mm {
        text += &format!(" {}", number(mm));
    }
    if let Some(shape) = said.shape {
        text += &format!(" {}", shape.as_str());
    }
    for (name, value) in [
        ("corner", said.corner_radius_mm),
        ("point", said.point_angle_rad.map(f64::to_degrees)),
        ("pitch", said.pitch_mm),
    ] {
        if let Some(value) = value {
            text += &format!(" {name} {}", number(value));
        }
    }
    text
}

fn check(inch: bool, cases: &[(&str, &str)]) {
    for (comment, expected) in cases {
        assert_eq!(shown(read_tool_comment(comment, inch, None, false)), *expected, "({comment})");
    }
}

#[test]
fn posts_in_millimetres() {
    check(
        false,
        &[
            // Fusion, HSMWorks. TAPER is the point of a drill, and the side of a chamfer mill.
            ("T1 D=12. CR=0. TAPER=118DEG - ZMIN=-8. - FLAT END MILL", "T1 12 flat corner 0"),
            ("T1 D=12. CR=0. - ZMIN=-8. - FLAT END MILL", "T1 12 flat corner 0"),
            (
                "T2 D=12.7 CR=0. TAPER=45DEG - ZMIN=-1. - CHAMFER MILL",
                "T2 12.7 chamfer corner 0 point 90",
            ),
            ("T3 D=5. CR=0. TAPER=118DEG - ZMIN=-21.5 - DRILL", "T3 5 drill corner 0 point 118"),
            ("T4 D=10. CR=2. - ZMIN=-8. - BULL NOSE END MILL", "T4 10 bull corner 2"),
            ("T5 D=6. CR=3. - ZMIN=0. - BALL END MILL", "T5 6 ball corner 3"),
            ("T1 D=100. CR=0. - ZMIN=-1. - FACE MILL", "T1 100 flat corner 0"),
            ("T6 D=6. CR=0. PITCH=1. - ZMIN=-12. - RIGHT HAND TAP", "T6 6 tap corner 0 pitch 1"),
            // Mastercam. D1 is the number of an offset.
            ("T212 |    3. FLAT ENDMILL | H0 ", "T212 3 flat"),
            (" T1 | 10. FLAT ENDMILL | H1 | D1 | TOOL DIA. - 10. ", "T1 10 flat"),
            ("T1 | 10. FLAT ENDMILL | H1 | D10.", "T1 10 flat"),
            // Esprit, SolidCAM and people.
            ("TOOL 1 = 12MM ENDMILL", "T1 12 flat"),
            ("TOOL -1- MILL DIA 10.0 R0. MM", "T1 10 corner 0"),
            ("TOOL NO. 7: 8.5 DRILL 140 DEG", "T7 8.5 drill point 140"),
            ("T9 10 DRILL", "T9 10 drill"),
            ("T10 Ø16 BALL ENDMILL", "T10 16 ball"),
            ("T11 M6X1 TAP", "T11 6 tap pitch 1"),
            ("T12 M8 X 1.25 TAP", "T12 8 tap pitch 1.25"),
            ("T13 M6 TAP", "T13 6 tap"),
            // A fraction is of an inch in a program in millimetres, too.
            ("T14 1/2 ENDMILL", "T14 12.7 flat"),
            ("T15 - 3/8\" DRILL", "T15 9.525 drill"),
            ("T16 THREADMILL DIA 8. PITCH 1.5", "T16 8 thread mill pitch 1.5"),
        ],
    );
}

#[test]
fn posts_and_people_in_inches() {
    check(
        true,
        &[
            ("T1 D=0.5 CR=0. - ZMIN=-0.25 - FLAT END MILL", "T1 12.7 flat corner 0"),
            ("T2 1/2 DRILL", "T2 12.7 drill"),
            ("TOOL 3 - .500 ENDMILL", "T3 12.7 flat"),
            ("T3 | 3/8 FLAT ENDMILL | H3 | D3 | DIA .375", "T3 9.525 flat"),
            ("T3 | 3/8 FLAT ENDMILL | H3 | D3 | WEAR COMP | TOOL DIA. - .375", "T3 9.525 flat"),
            ("3/8 FLAT ENDMILL TOOL - 3 DIA. OFF. - 3 LEN. - 3 DIA. - .375", "T3 9.525 flat"),
            ("T4 DIA .500", "T4 12.7"),
            ("T4 DIA-0.5000", "T4 12.7"),
            ("TOOL #5 .25 DIA. 4 FLUTE END MILL", "T5 6.35 flat"),
            ("TOOL #1 0.5 INCH DIAMETER END MILL", "T1 12.7 flat"),
            ("T6 1/4-20 TAP", "T6 6.35 tap pitch 1.27"),
            ("T06 - #10-32 TAP", "T6 4.826 tap pitch 0.79375"),
            ("T7 10-24 TAP", "T7 4.826 tap pitch 1.05833"),
            ("T7 M6X1 TAP", "T7 6 tap pitch 1"),
            ("T8 #7 DRILL", "T8 5.1054 drill"),
            ("T8 #7 TAP DRILL", "T8 5.1054 drill"),
            ("T9 F DRILL FOR 5/16-18 TAP", "T9 6.5278 drill"),
            ("T9 LETTER F DRILL", "T9 6.5278 drill"),
            ("T10 12MM END MILL", "T10 12 flat"),
            ("T11 1-1/2 FACE MILL", "T11 38.1 flat"),
            ("T11 1 1/2 FACE MILL", "T11 38.1 flat"),
            ("T12 1/2 BULL ENDMILL .06R", "T12 12.7 bull corner 1.524"),
            ("T13 82 DEG .5 COUNTERSINK", "T13 12.7 chamfer point 82"),
            ("T14 SPOT DRILL 90 DEG .375", "T14 9.525 drill point 90"),
            ("T1 FACE MILL 2.0", "T1 50.8 flat"),
            ("T1 is a .5 in dia endmill", "T1 12.7 flat"),
            ("T5 CHAMFER MILL 0.375, 90 DEGREES", "T5 9.525 chamfer point 90"),
            ("TOOL #1, 3/8 2FL EM, CENTER CUTTING", "T1 9.525 flat"),
            ("TOOL 1, END MILL 1.0: TOP, BORE 1.625, OUTSIDE 2.000", "T1 25.4 flat"),
            ("TOOL 2, STUB DRILL .177: THREE HOLES", "T2 4.4958 drill"),
            ("TOOL 3, REAMER .188", "T3 4.7752"),
            ("T2 1/4-20 THREAD MILL", "T2 thread mill pitch 1.27"),
            ("T5 END MILL", "T5 flat"),
        ],
    );
}

#[test]
fn what_is_no_tool_is_not_read() {
    for inch in [false, true] {
        check(
            inch,
            &[
                ("T1 IS BROKEN", "-"),
                ("T12 NEXT", "-"),
                ("T3 CHANGE DRILL AFTER 100 PARTS", "-"),
                ("T1 12-05-2024", "-"),
                ("TOP SIDE 2.5 THICK", "-"),
                ("T-SLOT 10. WIDE", "-"),
                ("T25 TORX", "-"),
                ("T1", "-"),
                ("TOOL 1", "-"),
                ("TOOL 1 AGAIN, OFFSET 11", "-"),
                ("TOOL #6, 3/8 (.375", "-"),
                ("TOOL CHANGE BLOCK", "-"),
                ("TOOL DIAMETER: 3.0", "-"),
                ("TOOL 10MM ENDMILL", "-"),
                ("DATE=DD-MM-YY - 03-11-19 TIME=HH:MM - 16:16", "-"),
                ("O1234 BRACKET 1/2 DRILL", "-"),
                ("T0101 OD ROUGH", "-"),
                ("TOOL - 1 OFFSET - 1", "-"),
                ("T4 D3 H4", "-"),
                ("T4 Z-12.5", "-"),
                ("", "-"),
                ("T999999999999999999999 1/2 DRILL", "-"),
                ("T2 9999. DRILL", "T2 drill"),
            ],
        );
    }
}

#[test]
fn a_comment_beside_the_call_needs_no_number() {
    let called = |text| shown(read_tool_comment(text, true, Some(5), false));
    assert_eq!(called("#7 DRILL"), "T5 5.1054 drill");
    assert_eq!(called("1/2 4FL ENDMILL"), "T5 12.7 flat");
    assert_eq!(called("FINISH POCKET .01 STOCK"), "-");
    // Another tool's comment is about that.
    assert_eq!(called("T6 1/4 DRILL"), "T6 6.35 drill");
}

fn job(text: &str, machine: &str) -> Job<'static> {
    let machine = Machine::from_toml("m.toml", machine, &|name| Err(format!("no {name}")));
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    Job::new(sources, machine.expect("a good machine")).expect("good settings")
}

const PROGRAM: &str = "O1 (PART)
(T1 D=0.5 CR=0. - ZMIN=-1. - FLAT END MILL)
(T2 D=0.25 CR=0. TAPER=118DEG - ZMIN=-1. - DRILL)
(T3 | 3/8 FLAT ENDMILL | H3 | D3)
G20 G90
T4 M6 (#7 DRILL)
T1 M6
M30
";

#[test]
fn the_machine_file_comes_first() {
    let job = job(
        PROGRAM,
        "control = 'haas'\n[tools.1]\ndiameter = '12 mm'\n[tools.2]\nlength = '100 mm'\n\
         [tools.3]\nshape = 'ball'\n[tools.9]\nshape = 'tap'",
    );
    let tools = known_tools(&job);
    let text = |number: u32| {
        let span = tools[&number].comment?;
        let text = job.sources().get(span.file)?.text();
        Some(String::from_utf8_lossy(span.range.slice(text)).into_owned())
    };
    // It has a diameter: nothing of the comment is taken.
    assert_eq!(
        (tools[&1].tool.diameter_mm, tools[&1].tool.shape, text(1)),
        (Some(12.0), None, None)
    );
    // It has a length alone.
    assert_eq!(tools[&2].tool.diameter_mm, Some(6.35));
    assert_eq!(tools[&2].tool.shape, Some(ToolShape::Drill));
    assert_eq!(tools[&2].tool.length_mm(), Some(100.0));
    assert_eq!(text(2).as_deref(), Some("(T2 D=0.25 CR=0. TAPER=118DEG - ZMIN=-1. - DRILL)"));
    // The comment speaks of another shape: this is another tool.
    assert_eq!((tools[&3].tool.diameter_mm, text(3)), (None, None));
    assert_eq!(tools[&4].tool.diameter_mm, Some(5.1054));
    assert_eq!(text(9), None);
    // The control's tables know nothing of it.
    assert_eq!(job.machine().tools[&2].diameter_mm, None);
}

#[test]
fn millimetres_are_those_of_the_program() {
    let job = job(&PROGRAM.replace("G20", "G21"), "control = 'haas'");
    assert_eq!(known_tools(&job)[&1].tool.diameter_mm, Some(0.5));
    assert_eq!(known_tools(&job)[&3].tool.diameter_mm, Some(9.525));
}

/// Pieces that tool comments are made of, those at the end of a text above all.
const PIECES: [&str; 40] = [
    "T1",
    "T",
    "TOOL",
    "1",
    "5",
    "1/2",
    "1/",
    ".5",
    "5.",
    "3/8-16",
    "-",
    "--",
    "=",
    ":",
    "#",
    "#7",
    "DIA",
    "D",
    "D=",
    "CR",
    "R",
    "TAP",
    "DRILL",
    "LETTER",
    "M6X1",
    "M",
    "X",
    "TPI",
    "20",
    "PITCH",
    "MM",
    "IN",
    "\"",
    "Ø",
    "°",
    "DEG",
    "TAPER=",
    "END MILL",
    "é",
    "999999999999",
];

proptest::proptest! {
    #[test]
    fn no_comment_ends_the_reading(
        pieces in proptest::collection::vec((0..PIECES.len(), proptest::bool::ANY), 0..9),
        inch in proptest::bool::ANY,
    ) {
        let text: String = pieces
            .into_iter()
            .map(|(piece, space)| format!("{}{}", PIECES[piece], if space { " " } else { "" }))
            .collect();
        for turns in [false, true] {
            let _ = read_tool_comment(&text, inch, Some(1), turns);
        }
    }

    #[test]
    fn no_text_ends_the_reading(text in "\\PC*") {
        for turns in [false, true] {
            let _ = read_tool_comment(&format!("T1 {text}"), true, None, turns);
        }
    }
}

#[test]
fn a_number_with_a_dash_at_the_end_is_read() {
    check(
        true,
        &[("T1 5-", "-"), ("T1 1/2-", "-"), ("T1 3/8-16 TAP", "T1 9.525 tap pitch 1.5875")],
    );
}
