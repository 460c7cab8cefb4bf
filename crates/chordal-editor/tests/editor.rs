//! What an editor gets about small programs.

use chordal::Machine;
use chordal_editor::{
    EditorProgram, EntryKind, FormatError, NameRole, NumberingOptions, RenameError, SymbolName,
    TokenClass,
};

fn on(machine: &str, text: &str) -> EditorProgram {
    let machine = Machine::from_builtin(machine).expect("a built-in machine");
    EditorProgram::new("test.nc", text.into(), machine).expect("a program")
}

fn haas(text: &str) -> EditorProgram {
    on("haas-vf2", text)
}

fn words(program: &EditorProgram) -> Vec<(String, TokenClass)> {
    let text = |range: chordal::diagnostics::TextRange| {
        String::from_utf8_lossy(range.slice(program.text())).into_owned()
    };
    program.tokens(1, u32::MAX).iter().map(|token| (text(token.range), token.class)).collect()
}

/// Where the first of some words stands.
fn at(program: &EditorProgram, words: &str) -> u32 {
    let text = String::from_utf8_lossy(program.text()).into_owned();
    text.find(words).expect("the words stand in the text") as u32
}

#[test]
fn words_have_classes() {
    let program = haas("%\nO100 (PART)\n/N5 G1 X1. F20. M8\n#101=#1+SIN[2.] (A)\nG0 Z#101 T5\n");
    let expected = [
        ("%", TokenClass::Mark),
        ("O100", TokenClass::Program),
        ("(PART)", TokenClass::Comment),
        ("/", TokenClass::Mark),
        ("N5", TokenClass::Label),
        ("G1", TokenClass::GCode),
        ("X1.", TokenClass::Axis),
        ("F20.", TokenClass::Speed),
        ("M8", TokenClass::MCode),
        ("#101", TokenClass::Variable),
        ("#1", TokenClass::Variable),
        ("SIN", TokenClass::Keyword),
        ("2.", TokenClass::Number),
        ("(A)", TokenClass::Comment),
        ("G0", TokenClass::GCode),
        ("Z", TokenClass::Axis),
        ("#101", TokenClass::Variable),
        ("T5", TokenClass::Tool),
    ];
    let expected: Vec<_> = expected.map(|(text, class)| (text.to_string(), class)).into();
    assert_eq!(words(&program), expected);
}

#[test]
fn fadal_macro_lines_have_classes() {
    let program = on("fadal-4020", "# V1=R2+3 ' up\n# :LOOP\nR0+1.5\nX+R3\nM30\n");
    let words = words(&program);
    let class = |text: &str| words.iter().find(|(word, _)| word == text).map(|(_, class)| *class);
    assert_eq!(class("V1"), Some(TokenClass::Variable));
    assert_eq!(class("R2"), Some(TokenClass::Variable));
    assert_eq!(class("R0+1.5"), Some(TokenClass::Variable));
    assert_eq!(class("X+R3"), Some(TokenClass::Axis));
}

#[test]
fn a_word_tells_what_it_does_and_what_its_line_did() {
    let program = haas("G20 G90\nG0 X0 Y0\nG2 X2. Y0. I1. J0 F20.\nM30\n");
    let ran = program.ran();
    let hover = program.hover(at(&program, "G2 X2"), Some(&ran)).expect("a hover");
    assert_eq!(hover.range.slice(program.text()), b"G2");
    assert!(hover.text.contains("clockwise"), "{}", hover.text);
    // Half a circle of radius 1 in.
    assert!(hover.text.contains("This line moves 3.1416 in"), "{}", hover.text);
    let centre = program.hover(at(&program, "I1."), Some(&ran)).expect("a hover");
    let means = "from the start of the arc to its centre, along X";
    assert!(centre.text.contains(&format!("I1. in G2: {means}")), "{}", centre.text);
    // The code says the same of each of its words, with the value.
    assert!(hover.text.contains(&format!("I1.       {means}")), "{}", hover.text);
}

#[test]
fn the_state_behind_a_line_is_the_controls() {
    let program =
        haas("G21 G90 T3 M6\nS1000 M3\n\nG1 X10. Y-2.5 F200.\n(A REMARK)\nG91 X1.\nM30\n");
    let modal = program.modal_after(5).expect("a state");
    let text = program.modal_text(&modal);
    assert!(text.starts_with("G1 G17 G90 G94 G21 G40\n"), "{text}");
    assert!(text.contains("X10 Y-2.5 Z"), "{text}");
    assert!(text.contains("F 200 mm/min, S1000 clockwise, T3"), "{text}");
    assert_eq!(program.modal_after(6).map(|modal| modal.position[0]), Some(11.0));
    assert!(program.modal_after(5).is_some() && haas("").modal_after(1).is_none());
}

#[test]
fn the_outline_names_subroutines_as_the_program_does() {
    let text = "o<Lift> sub\nG0 Z5\no<lift> endsub\no<deep>sub\no<deep>endsub\no100 sub\no100 endsub\nM2\n";
    let outline = on("linuxcnc-mill", text).outline();
    let names: Vec<&str> = outline.iter().map(|entry| entry.name.as_str()).collect();
    assert_eq!(names, ["o<lift>", "o<deep>", "o100"]);
}

#[test]
fn the_outline_goes_by_program_tool_and_operation() {
    let program = haas(
        "%\nO1 (PLATE)\nT1 M6 (DRILL)\n(SPOT)\nG0 X1.\n(DEEP)\nG0 X2.\nT2\nM6\n(***)\n(BORE)\nM30\nO2\nM99\n%\n",
    );
    let outline = program.outline();
    let names = |entries: &[chordal_editor::OutlineEntry]| -> Vec<String> {
        entries.iter().map(|entry| format!("{} {}", entry.name, entry.detail)).collect()
    };
    assert_eq!(names(&outline), ["O1 PLATE", "O2 "]);
    assert_eq!(names(&outline[0].children), ["T1 DRILL", "T2 "]);
    let [first, second] = outline[0].children.as_slice() else { panic!("two tools") };
    assert_eq!(names(&first.children), ["SPOT ", "DEEP "]);
    assert_eq!(names(&second.children), ["BORE "]);
    assert_eq!(second.kind, EntryKind::Tool);
    // Each reaches to the next.
    assert_eq!(first.range.end, second.range.start);
    assert_eq!(outline[0].range.end, outline[1].range.start);
}

#[test]
fn names_are_made_and_used() {
    let program = haas(
        "O1\nM98 P1000\nN10 G0 X1.\nIF[#101GT3]GOTO10\nM97 P10\nM30\nO1000\nN10 #1=2\nM99 P10\n",
    );
    let places = |offset: u32| {
        let name = program.name_at(offset).expect("a name").name;
        let places = program.places_of(&name);
        let line = |range: chordal::diagnostics::TextRange| program.source().line_of(range.start);
        places.iter().map(|place| (line(place.range), place.role)).collect::<Vec<_>>()
    };
    assert_eq!(places(at(&program, "P1000")), [(2, NameRole::Use), (7, NameRole::Definition)]);
    // The N10 of the other program is another one.
    let jumps = [(3, NameRole::Definition), (4, NameRole::Use), (5, NameRole::Use)];
    assert_eq!(places(at(&program, "N10")), jumps);
    assert_eq!(places(at(&program, "N10 #1")), [(8, NameRole::Definition), (9, NameRole::Use)]);
    let local = program.name_at(at(&program, "#1=")).expect("a name").name;
    assert_eq!(local, SymbolName::Variable { program: Some(1), name: "#1".into() });
}

#[test]
fn a_variable_gets_another_name() {
    let program = haas("O1\n#101=1.\n#1=#101\n(#101 SAYS HOW DEEP)\nG0 X#101 Y[#101+#102]\nM30\n");
    let renamed = program.rename(at(&program, "#101"), "110").expect("a rename");
    assert_eq!(renamed.name, "#110");
    let lines: Vec<u32> =
        renamed.places.iter().map(|range| program.source().line_of(range.start)).collect();
    assert_eq!(lines, [2, 3, 5, 5], "the comment stays");
    let refused = |new: &str| program.rename(at(&program, "#101"), new).expect_err("a refusal");
    assert_eq!(refused("#102"), RenameError::Taken { new: "#102".into(), line: 5 });
    assert!(matches!(refused("#5"), RenameError::NotAName { .. }), "a program's own variable");
    assert!(matches!(refused("depth"), RenameError::NotAName { .. }));
    assert_eq!(program.rename(at(&program, "G0"), "#110"), Err(RenameError::NoVariable));
    let computed = haas("#101=1\n#[#101+1]=3\nM30\n");
    let refused = computed.rename(at(&computed, "#101"), "#110");
    assert!(matches!(refused, Err(RenameError::Computed { line: 2, .. })), "{refused:?}");
}

#[test]
fn named_parameters_keep_their_reach() {
    let program = on("linuxcnc-mill", "#<depth>=1\n#<_all>=2\nG0 X#<Depth>\nM2\n");
    let renamed = program.rename(at(&program, "#<depth>"), "deep").expect("a rename");
    assert_eq!(
        (renamed.name.as_str(), renamed.places.len()),
        ("#<deep>", 2),
        "letters of either case name the same"
    );
    let refused = program.rename(at(&program, "#<depth>"), "_deep");
    assert!(matches!(refused, Err(RenameError::NotAName { .. })), "it would become global");
}

#[test]
fn completions_are_those_of_the_control_and_the_line() {
    let program = haas("G1\nG43 \nM98 P\nO1000\nM99\n");
    let (start, codes) = program.completions(2);
    assert_eq!(start, 0);
    let texts: Vec<&str> = codes.iter().map(|code| code.text.as_str()).collect();
    assert!(texts.contains(&"G154") && texts.contains(&"G2"));
    let (_, letters) = program.completions(at(&program, "G43 ") + 4);
    assert_eq!(letters.first().map(|letter| letter.text.as_str()), Some("H"));
    let (_, places) = program.completions(at(&program, "98 P") + 4);
    assert_eq!(places.iter().map(|place| place.text.as_str()).collect::<Vec<_>>(), ["P1000"]);
    let comment = haas("(G1 \n");
    assert_eq!(comment.completions(4).1, []);
}

#[test]
fn spaces_are_put_between_words() {
    let program = haas("N5G1X1.Y 2.  (A B)\n/N10 G0Z1.\nIF [#1EQ2] GOTO5\nG90   \nX[ 1+2 ]\nM30\n");
    let edits = program.spaced(1, u32::MAX).expect("nothing moves otherwise");
    let text = String::from_utf8(program.edited(&edits)).expect("a text");
    assert_eq!(text, "N5 G1 X1. Y2. (A B)\n/N10 G0 Z1.\nIF [#1EQ2] GOTO5\nG90\nX[ 1+2 ]\nM30\n");
    assert_eq!(program.with_text(text.into()).spaced(1, u32::MAX), Ok(vec![]));
}

#[test]
fn a_part_program_of_another_language_is_spaced_as_a_whole() {
    let written =
        "%_N_PART_MPF\nG17G90  G0 X0Y0 Z5\n/2 N20   G1X=R1+2 F100 ;to the  corner\nEND: M30  \n";
    let program = on("sinumerik-mill", written);
    let edits = program.spaced(1, u32::MAX).expect("nothing moves otherwise");
    let text = String::from_utf8(program.edited(&edits)).expect("a text");
    let expected =
        "%_N_PART_MPF\nG17 G90 G0 X0 Y0 Z5\n/2N20 G1 X=R1+2 F100 ;to the  corner\nEND: M30\n";
    assert_eq!(text, expected);
    assert_eq!(program.with_text(text.into()).spaced(1, u32::MAX), Ok(vec![]));
}

#[test]
fn numbers_change_with_their_jumps() {
    let numbering = NumberingOptions { first: 10, step: 10, all: true };
    let program = haas("O1\nG90\nN7 G0 X1.\n#1=1\nIF[#1EQ1]GOTO 7\nM97 P9\nM30\nN9 X2.\nM99\n");
    let text = |program: &EditorProgram| {
        let edits = program.renumbered(numbering)?;
        Ok::<_, FormatError>(String::from_utf8(program.edited(&edits)).expect("a text"))
    };
    let expected = "O1\nN10 G90\nN20 G0 X1.\n#1=1\nIF[#1EQ1]GOTO 20\nN30 M97 P50\nN40 M30\n\
                    N50 X2.\nN60 M99\n";
    assert_eq!(text(&program), Ok(expected.into()));
    let computed = haas("N1 #1=5\nGOTO#1\nN5 M30\n");
    assert!(matches!(text(&computed), Err(FormatError::ComputedJump { line: 2, .. })));
    let twice = haas("GOTO5\nN5 M0\nN5 M30\n");
    assert_eq!(text(&twice), Err(FormatError::Ambiguous { number: 5, line: 1 }));
}
