//! What the reader makes of lines.

mod compact;

use chordal_diagnostics::TextRange;
use chordal_kernel::TokenClass;
use chordal_sinumerik::syntax::{
    BlockReader, ComparisonPrecedence, ProgramUnitKind, StatementKind, tokens, units,
    with_uniform_spacing,
};
use compact::{block_text, blocks, line};

/// Each line and what is read.
fn check(rows: &[(&str, &str)]) {
    for (text, expected) in rows {
        assert_eq!(&line(text), expected, "{text}");
    }
}

#[test]
fn words() {
    check(&[
        ("G1X10Y2", "G:1 X:10 Y:2"),
        ("n10 g0 x-.5 y+3. z1.5ex-3", "N10 G:0 X:-0.5 Y:3.0 Z:0.0015"),
        ("N20 X -10.25 Y = 5", "N20 X:-10.25 Y=5"),
        ("X=R1Y=R[R2+1]", "X=R.1 Y=R[(R.2 Add 1)]"),
        ("R1=R2+1", "R.1=(R.2 Add 1)"),
        ("S2=900 M2=3 X1=5 S900 M3", "S.2=900 M.2=3 X.1=5 S:900 M:3"),
        (
            "I1=AC(2) J=IC(-3) C=DC(90) X=DIC(R1*2)",
            "I.1=Absolute<2> J=Incremental<-3> C=ShortestPath<90> X=IncrementalDiameter<(R.1 Multiply 2)>",
        ),
        ("CR=5 CR=-R1 LIMS[2]=3000 FA[X]=100", "CR=5 CR=(Minus R.1) LIMS[2]=3000 FA[X]=100"),
        ("T=\"MILL 10\" D1", "T=\"MILL 10\" D:1"),
        ("$TC_DP6[1,2]=5.5 MY_VAR2=3 _A1=4", "$TC_DP6[1,2]=5.5 MY_VAR2=3 _A1=4"),
        ("TRANS X10 Y&20", "TRANS X:10 Y:20"),
        ("SUPA G500 D0", "SUPA G:500 D:0"),
        ("SPOS[2]=ACP(R1) SPOS=90", "SPOS[2]=Positive<R.1> SPOS=90"),
        ("A[0]=SET(1,2,3) B[0]=REP(7)", "A[0]=SET<1,2,3> B[0]=REP<7>"),
        (
            "$P_UIFR[1]=CTRANS(X,10,Y,2):CROT(Z,45)",
            "$P_UIFR[1]=(CTRANS(X,10,Y,2) Chain CROT(Z,45))",
        ),
        ("X='H1F' Y='b101' Z='HFFFFFFFF'", "X=31 Y=5 Z=-1"),
        (
            "X12345678901234567890 Y0.1234567890123456789",
            "X:1.2345678901234567e19 Y:0.12345678901234568",
        ),
    ]);
}

#[test]
fn heads_and_comments() {
    check(&[
        ("/2 N10 G1", "/2 N10 G:1"),
        ("/N10 G1", "/0 N10 G:1"),
        (":123 LABEL_1: G1", ":123 LABEL_1> G:1"),
        ("lab2 : N30 X1", "N30 LAB2> X:1"),
        ("N10", "N10"),
        ("  ; ONLY \"this", "; ONLY \"this"),
        ("MSG(\"A;B\"\"C\") ;D", "MSG(\"A;B\\\"C\") ;D"),
        ("N1=5", "N.1=5"),
    ]);
    assert_eq!(blocks("G1\r\n\r\n%\n ;C\rG2"), ["G:1", ";C", "G:2"]);
    let lines: Vec<u32> = BlockReader::new(b"G1\r\n\r\n%\n ;C\rG2").map(|b| b.line).collect();
    assert_eq!(lines, [1, 4, 5]);
}

#[test]
fn calls() {
    check(&[
        ("CYCLE83 (52,50,,,2.5,-1)", "CYCLE83(52,50,_,_,2.5,-1)"),
        ("NAME() NAME(,)", "NAME() NAME(_,_)"),
        ("WORKPIECE(,\"\",,\"BOX\",112)", "WORKPIECE(_,\"\",_,\"BOX\",112)"),
        ("NAME P3", "NAME P:3"),
        ("L10 P2", "L:10 P:2"),
        ("L010(1,2)", "L010(1,2)"),
        ("MCALL", "MCALL"),
        ("MCALL L10", "MCALL L10"),
        ("MCALL CYCLE81(10,0,2,-5)", "MCALL CYCLE81(10,0,2,-5)"),
        ("CALL \"A\"<<R1", "CALL (\"A\" Join R.1)"),
        ("CALL BLOCK A1 TO B2", "CALL A1..B2"),
        ("CALL NAME BLOCK AA TO BB", "CALL NAME AA..BB"),
        ("PCALL /_N_WCS_DIR/_N_SHAFT(1,R2)", "PCALL /_N_WCS_DIR/_N_SHAFT(1,R.2)"),
        ("EXTCALL(\"F.MPF\")", "CALL \"F.MPF\""),
        ("ISOCALL PNAME", "CALL PNAME"),
        ("MSG(\"R1 = \"<<R1<<\" mm\")", "MSG(((\"R1 = \" Join R.1) Join \" mm\"))"),
        ("MSG(<<R1+1<<\"A\")", "MSG(((Text (R.1 Add 1)) Join \"A\"))"),
        ("SETINT(1) PRIO=1 ALARM_SUB", "SETINT(1) PRIO=1 ALARM_SUB"),
    ]);
}

#[test]
fn flow() {
    check(&[
        (
            "IF R1==1 GOTOF AA IF R1==2 GOTOB N20",
            "IF (R.1 Equal 1) Forward->AA IF (R.1 Equal 2) Backward->N20",
        ),
        ("IF (R1>1) GOTO :30", "IF (R.1 Greater 1) Both->:30"),
        ("IF NOT $P_SEARCH", "IF (Not $P_SEARCH)"),
        ("IF R1==1GOTOF END_1 ; X", "IF (R.1 Equal 1) Forward->END_1 ; X"),
        ("ELSE ;", "ELSE ;"),
        ("ENDIF", "ENDIF"),
        ("GOTOC \"L\"<<R1", "BothOrNone->?(\"L\" Join R.1)"),
        ("GOTOF LAB[R1]", "Forward->?LAB[R.1]"),
        ("GOTOS", "ProgramStart->start"),
        (
            "CASE(R1) OF 1 GOTOF AA -2 GOTOB N5 DEFAULT GOTOF CC",
            "CASE R.1 1:Forward->AA -2:Backward->N5 ELSE:Forward->CC",
        ),
        ("CASE R1+1 OF 1 GOTOF AA", "CASE (R.1 Add 1) 1:Forward->AA"),
        ("FOR R1=0 TO R2-1", "FOR R.1=0 TO (R.2 Subtract 1)"),
        ("FOR COUNT[1] = 5 TO 1", "FOR COUNT[1]=5 TO 1"),
        ("ENDFOR", "ENDFOR"),
        ("WHILE R1<>0", "WHILE (R.1 NotEqual 0)"),
        ("UNTIL R1>=5", "UNTIL (R.1 GreaterOrEqual 5)"),
        ("LOOP", "LOOP"),
        ("REPEAT", "REPEAT"),
        ("REPEAT AA", "REPEAT AA"),
        ("REPEAT AA P=2", "REPEAT AA P=2"),
        ("REPEAT AA BB P=R1*2", "REPEAT AA to BB P=(R.1 Multiply 2)"),
        ("REPEATB AA P3", "REPEATB AA P=3"),
    ]);
}

#[test]
fn definitions() {
    check(&[
        ("DEF REAL A=1, B[2,3]", "DEF Real A=1 B[2,3]"),
        ("DEF STRING[16] NAME=\"X\"", "DEF Text(16) NAME=\"X\""),
        (
            "DEF INT A_1[3]=SET(1,2,3), A_2[3]=(4,5,6)",
            "DEF Integer A_1[3]=SET<1,2,3> A_2[3]=SET<4,5,6>",
        ),
        ("DEF BOOL OK=TRUE", "DEF Boolean OK=true"),
        ("DEF CHAN REAL PHU 14 LLI -1 ULI 9 MY_GUD", "DEF Real MY_GUD"),
        ("DEF FRAME F1=CTRANS(X,1)", "DEF Frame F1=CTRANS(X,1)"),
        ("PROC SUB1 SAVE DISPLOF", "PROC SUB1() SAVE"),
        (
            "PROC L20(REAL A, INT BB=-2, VAR REAL CC[3], STRING[16] DD) SBLOF SAVE ;X",
            "PROC L20(Real A, Integer BB=-2, VAR Real CC, Text(16) DD) SAVE ;X",
        ),
        ("EXTERN SUB2(REAL, VAR INT)", "EXTERN SUB2"),
        ("DEFINE GO_FAST AS G0 F=100 ;C", "DEFINE GO_FAST AS <G0 F=100> ;C"),
        ("DEFINE M6 AS L6", "DEFINE M6 AS <L6>"),
        ("N5 ID=1 WHENEVER $A_IN[1]==1 DO M7 ;C", "N5 SYNC<ID=1 WHENEVER $A_IN[1]==1 DO M7 > ;C"),
        ("WHEN TRUE DO X=1", "SYNC<WHEN TRUE DO X=1>"),
    ]);
}

#[test]
fn precedence() {
    check(&[
        ("R1=1+2*3-4 DIV 5", "R.1=((1 Add (2 Multiply 3)) Subtract (4 IntegerDivide 5))"),
        ("R1=-7 MOD 4", "R.1=(-7 Modulo 4)"),
        ("R1=NOT A1==B1", "R.1=((Not A.1) Equal B.1)"),
        ("IF R1==1 AND R2==2", "IF ((R.1 Equal (1 And R.2)) Equal 2)"),
        ("R1=1 B_OR 2 B_XOR 3 B_AND 4+5", "R.1=(1 BitOr (2 BitXor (3 BitAnd (4 Add 5))))"),
        ("R1=1 OR 2 XOR 3 AND 4", "R.1=(1 Or (2 Xor (3 And 4)))"),
        ("R1=\"A\"<<1+2==\"A3\"", "R.1=((\"A\" Join (1 Add 2)) Equal \"A3\")"),
        ("R1=2*(3+4)-SIN(30)", "R.1=((2 Multiply (3 Add 4)) Subtract SIN(30))"),
    ]);
    let text = "IF R1==1 AND R2==2 OR \"A\"<<R3==\"A1\"";
    let mut reader = BlockReader::new(text.as_bytes());
    reader.set_precedence(ComparisonPrecedence::BeforeLogic);
    let block = reader.next().unwrap();
    assert_eq!(
        block_text(text, &block),
        "IF (((R.1 Equal 1) And (R.2 Equal 2)) Or ((\"A\" Join R.3) Equal \"A1\"))"
    );
    assert!(block.doubtful_comparisons.is_empty());
}

#[test]
fn comparisons_of_logic_without_parentheses_are_doubtful() {
    let doubtful = |text: &str| {
        let block = BlockReader::new(text.as_bytes()).next().unwrap();
        block.doubtful_comparisons.len()
    };
    assert_eq!(doubtful("IF R1==1 AND R2==2"), 1);
    assert_eq!(doubtful("IF (R1==1) AND (R2==2)"), 0);
    assert_eq!(doubtful("IF (R1 AND R2)==2"), 0);
    assert_eq!(doubtful("IF R1 AND R2"), 0);
}

#[test]
fn faults_leave_the_rest_of_the_line() {
    check(&[
        ("G1 X=5+*3 Y2", "G:1 Y:2 !a value is missing@*3"),
        ("X Y2", "Y:2 !the address has no value@X"),
        (
            "MSG(\"A B\" ? \"C D\") X1",
            "X:1 !a comma or a closing parenthesis is missing@? \"C D\")",
        ),
        ("MSG(\"A ;B", "!the text has no closing quotation mark@\"A ;B"),
        ("5 X1", "X:1 !this begins no word@5"),
        ("IF R1==1 X5 Y6", "Y:6 !a jump or the end of the block is missing@X5"),
        ("L1: X5", "X:5 !a label begins with two letters or underscores@:"),
        ("SUPA[1] X2", "X:2 !an equals sign is missing@SUPA[1]"),
        ("R1='Q1' X2", "X:2 !a constant in apostrophes is 'H…' or 'B…' of at most 32 bits@'Q1'"),
        (
            "DEF FLOAT AB ;C",
            "AB ;C !a type is missing: INT, REAL, BOOL, CHAR, STRING, AXIS or FRAME@FLOAT",
        ),
    ]);
}

#[test]
fn nesting_and_length_are_limited() {
    let deep = format!("R1={}1{}", "(".repeat(100_000), ")".repeat(100_000));
    assert!(line(&deep).starts_with("!the expression is nested too deeply"));
    let signs = format!("R1={}R2", "-".repeat(100_000));
    assert!(line(&signs).starts_with("!the expression is nested too deeply"));
    let long = format!("R1=1{}", "+1".repeat(100_000));
    assert!(line(&long).starts_with("!the expression has too many operators"));
    let wide = format!("R1=1{}", "+1".repeat(500));
    assert!(line(&wide).starts_with("R.1="));
    let faults = BlockReader::new("? ".repeat(100_000).as_bytes()).next().unwrap().faults;
    assert_eq!(faults.len(), 16);
    let words = BlockReader::new("X1 ".repeat(100_000).as_bytes()).next().unwrap().statements;
    assert_eq!(words.len(), 100_000);
}

#[test]
fn ranges_are_those_of_the_text() {
    let text = "N10 AA: X = R1 + 2  TRANS Y-3 ;C\r\n";
    let block = BlockReader::new(text.as_bytes()).next().unwrap();
    let slice = |range: TextRange| String::from_utf8_lossy(range.slice(text.as_bytes()));
    assert_eq!(slice(block.range), "N10 AA: X = R1 + 2  TRANS Y-3 ;C");
    assert_eq!(slice(block.number.unwrap().range), "N10");
    assert_eq!(slice(block.label.unwrap().range), "AA:");
    let statements: Vec<_> = block.statements.iter().map(|s| slice(s.range)).collect();
    assert_eq!(statements, ["X = R1 + 2", "TRANS", "Y-3"]);
    let StatementKind::Word(word) = &block.statements[0].kind else { panic!("a word") };
    assert_eq!(slice(word.address.range), "X");
}

#[test]
fn a_reader_goes_on_anywhere() {
    let text = b"G1\nG2\nG3\nG4\n";
    let mut reader = BlockReader::new(text);
    reader.seek(3, 2);
    reader.limit(9);
    assert_eq!((reader.offset(), reader.line()), (3, 2));
    let lines: Vec<u32> = reader.by_ref().map(|block| block.line).collect();
    assert_eq!(lines, [2, 3]);
    assert_eq!((reader.offset(), reader.line()), (9, 4));
}

#[test]
fn programs_of_a_tape() {
    let text = b";first\n%_N_PART_MPF\n;$PATH=/_N_WKS_DIR/_N_P_WPD\nG1\nM30\n%SUB_1_SPF\nPROC OTHER\nM17\n%_N_X_INI\n";
    let units = units(text);
    let names: Vec<_> = units.iter().map(|unit| (unit.name.as_deref(), unit.kind)).collect();
    assert_eq!(
        names,
        [
            (Some("PART"), ProgramUnitKind::Main),
            (Some("SUB_1"), ProgramUnitKind::Sub),
            (Some("X_INI"), ProgramUnitKind::Unknown)
        ]
    );
    assert_eq!(units[0].first_line, 4);
    assert_eq!(&text[units[0].head.end as usize..units[0].range.end as usize], b"G1\nM30\n");
    assert_eq!(units[1].range.start, units[0].range.end);
    assert_eq!(units[2].range.end as usize, text.len());
}

#[test]
fn a_text_without_a_head_is_one_program() {
    let whole = units(b"; c\nG1\nM30\n");
    assert_eq!(whole.len(), 1);
    assert_eq!((whole[0].name.clone(), whole[0].kind), (None, ProgramUnitKind::Unknown));
    let sub = units(b"; c\n\nPROC MY_SUB(REAL A)\nM17\n");
    assert_eq!((sub[0].name.as_deref(), sub[0].kind), (Some("MY_SUB"), ProgramUnitKind::Sub));
    assert_eq!(units(b"").len(), 1);
    let mixed = units(b"G1\n%MPF12\nG2\n");
    assert_eq!(mixed.len(), 2);
    assert_eq!(mixed[0].range, TextRange::new(0, 3));
    assert_eq!((mixed[1].name.as_deref(), mixed[1].kind), (Some("12"), ProgramUnitKind::Main));
}

#[test]
fn tokens_of_lines() {
    let text = "%_N_A_MPF\n/N10 LAB: G1 X-10 F=R1*2 CR=5 MSG(\"A\") ;C\nIF $P_SIM GOTOF LAB\n";
    let found: Vec<(String, TokenClass)> = tokens(text.as_bytes(), TextRange::new(0, 1000))
        .into_iter()
        .map(|token| {
            let slice = token.range.slice(text.as_bytes());
            (String::from_utf8_lossy(slice).into_owned(), token.class)
        })
        .collect();
    let found: Vec<(&str, TokenClass)> = found.iter().map(|(t, c)| (t.as_str(), *c)).collect();
    assert_eq!(
        found,
        [
            ("%_N_A_MPF", TokenClass::Program),
            ("/", TokenClass::Mark),
            ("N10", TokenClass::Label),
            ("LAB:", TokenClass::Label),
            ("G1", TokenClass::GCode),
            ("X-10", TokenClass::Axis),
            ("F", TokenClass::Speed),
            ("R1", TokenClass::Variable),
            ("2", TokenClass::Number),
            ("CR", TokenClass::Variable),
            ("5", TokenClass::Number),
            ("MSG", TokenClass::Keyword),
            ("\"A\"", TokenClass::Text),
            (";C", TokenClass::Comment),
            ("IF", TokenClass::Keyword),
            ("$P_SIM", TokenClass::Variable),
            ("GOTOF", TokenClass::Keyword),
            ("LAB", TokenClass::GCode),
        ]
    );
    let part = tokens(text.as_bytes(), TextRange::new(20, 25));
    assert_eq!(part.len(), 2);
}

#[test]
#[allow(clippy::disallowed_methods, reason = "the programs are files")]
fn uniform_spacing_changes_no_block_of_any_program() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    let mut folders = vec![folder];
    let (mut programs, mut changed) = (0, 0);
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = std::fs::read_to_string(&path).expect("a text");
            let read = |text: &str| -> Vec<String> {
                let blocks = BlockReader::new(text.as_bytes());
                blocks.map(|block| block_text(text, &block)).collect()
            };
            let space = |text: &str| {
                String::from_utf8(with_uniform_spacing(text.as_bytes())).expect("a text")
            };
            // As it is written, and with more blanks where they are not part of a text.
            let wide = |line: &str| match line.contains(['"', ';']) {
                true => format!("{line}\n"),
                false => format!("  {}\n", line.replace(' ', "  ")),
            };
            for text in [text.clone(), text.lines().map(wide).collect()] {
                let spaced = space(&text);
                assert_eq!(read(&spaced), read(&text), "{}", path.display());
                assert_eq!(space(&spaced), spaced, "{}", path.display());
                changed += usize::from(spaced != text);
            }
            programs += 1;
        }
    }
    assert!(programs > 500 && changed > 500, "{programs} programs, {changed} changed");
}
