//! What programs of other shops showed: forms of the language that posts and hands write, and what is not known.

use chordal::{Command, Diagnostic, Job, Machine, RunSink, Sink, Source, SourceMap};

/// The end points of the moves, and the problems with their lines.
#[derive(Default)]
struct KlartextOutcome {
    ends: Vec<[f64; 3]>,
    problems: Vec<(u32, &'static str)>,
    messages: Vec<String>,
}

/// Takes a run down; the lines are those of one text.
struct OutcomeSink<'t>(KlartextOutcome, &'t str);

impl Sink for OutcomeSink<'_> {
    fn command(&mut self, command: &Command) {
        if let Some(motion) = command.kind.motion() {
            self.0.ends.push([motion.to[0], motion.to[1], motion.to[2]]);
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        let start = diagnostic.primary.span.range.start as usize;
        let line = self.1[..start].matches('\n').count() as u32 + 1;
        self.0.problems.push((line, diagnostic.code.id()));
        self.0.messages.push(diagnostic.message);
    }
}

impl RunSink for OutcomeSink<'_> {}

fn run_on(machine: Machine, file: &str, text: &str) -> KlartextOutcome {
    let mut sources = SourceMap::new();
    sources.add(Source::new(file, text.as_bytes()));
    let job = Job::new(sources, machine).expect("settings");
    let mut sink = OutcomeSink(KlartextOutcome::default(), text);
    job.run(&mut sink);
    sink.0
}

fn run(file: &str, text: &str) -> KlartextOutcome {
    run_on(Machine::from_builtin("heidenhain-mill").expect("a built-in machine"), file, text)
}

fn tool_10() -> Machine {
    let mut machine = Machine::from_builtin("heidenhain-mill").expect("a built-in machine");
    let tool = machine.tools.entry(1).or_default();
    (tool.diameter_mm, tool.offset[2]) = (Some(10.0), Some(0.0));
    machine
}

#[test]
fn a_comment_goes_on_in_the_next_line() {
    let text = "BEGIN PGM A MM\n1 ;A LONG COMMENT ~\n  L X+99 Y+99 FMAX ~\n  OF THE SHOP\n2 L X+1 Y+2 Z+3 R0 FMAX\nM30\n\
                END PGM A MM\n";
    let found = run("a.h", text);
    assert_eq!(found.ends, [[1.0, 2.0, 3.0]]);
    assert!(found.problems.iter().all(|(_, code)| *code != "CH301"), "{:?}", found.problems);
}

#[test]
fn din_iso_programs_calculate_with_formulas() {
    let text = "%A G71 *\nN10 Q1 = 3 * SIN 30 + 2 *\nN20 Q2 = - ( Q1 - 1 ) *\nN30 G00 G90 X+Q1 Y+Q2 Z+5 *\n\
                N99999999 %A G71 *\n";
    let found = run("a.i", text);
    assert_eq!(found.ends, [[3.5, -2.5, 5.0]]);
    assert!(found.problems.is_empty(), "{:?}", found.problems);
}

#[test]
fn values_that_only_the_control_has_are_no_alarm() {
    // The radius of a tool, a value of an earlier program, and a result of probing.
    let text = "BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F500\nL X+0 Y+0 Z+5 R0 FMAX M3\nQ1 = 10 / Q108\nL X+Q1\nL X+QR3\nL X+Q150\nQ2 = 5\n\
                L X+Q2 Y+3 FAUTO\nM30\nEND PGM A MM\n";
    let found = run("a.h", text);
    let own: Vec<_> = found.problems.iter().filter(|(line, _)| *line > 2).copied().collect();
    assert_eq!(own, [(4, "CH727"), (5, "CH727"), (6, "CH727"), (7, "CH727")]);
    assert_eq!(found.ends.last(), Some(&[5.0, 3.0, 5.0]));
    let known = run_on(tool_10(), "a.h", &text.replace("L X+QR3\nL X+Q150\n", ""));
    assert_eq!(known.ends[1], [2.0, 0.0, 5.0]);
    assert!(known.problems.is_empty(), "{:?}", known.problems);
}

#[test]
fn a_parameter_of_the_program_that_is_not_set_is_an_alarm() {
    let text = "BEGIN PGM A MM\nL X+Q5 FMAX\nM30\nEND PGM A MM\n";
    assert_eq!(run("a.h", text).problems, [(2, "CH705")]);
}

#[test]
fn a_rapid_from_an_unknown_place_is_not_one_into_the_blank() {
    let text = "BEGIN PGM A MM\nBLK FORM 0.1 Z X+0 Y+0 Z-20\nBLK FORM 0.2 X+100 Y+100 Z+0\nTOOL CALL 1 Z S800 F100\n\
                L Z-15 R0 FMAX M91\nL X+20 Y+20 FMAX M3\nL Z+25 FMAX\nM30\nEND PGM A MM\n";
    let mut machine = tool_10();
    assert!(run_on(machine.clone(), "a.h", text).problems.is_empty());
    // With a preset it is known: machine Z-15 is Z-5 of the program.
    machine.work_offsets.entry("G54".into()).or_default().values = [Some(-10.0); 6];
    let found = run_on(machine, "a.h", text);
    assert!(found.problems.contains(&(6, "CH602")), "{:?} {:?}", found.problems, found.messages);
}

/// A program that drills with a cycle and does something between two calls.
fn drilled(between: &str) -> KlartextOutcome {
    let text = format!(
        "BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F500\nL X+0 Y+0 Z+50 R0 FMAX M3\n\
         CYCL DEF 200 Q200=2 Q201=-10 Q206=150 Q202=20 Q210=0 Q203=+0 Q204=20 Q211=0\n\
         L X+10 FMAX M99\n{between}\nL X+20 FMAX M99\nM30\nEND PGM A MM\n"
    );
    run_on(tool_10(), "a.h", &text)
}

#[test]
fn data_of_a_cycle_can_be_assigned_after_its_definition() {
    let deepest = |between: &str| {
        let found = drilled(between);
        assert!(found.problems.is_empty(), "{:?}", found.messages);
        let at = |x: f64| {
            let own = found.ends.iter().filter(|end| end[0] == x).map(|end| end[2]);
            own.fold(f64::INFINITY, f64::min)
        };
        [at(10.0), at(20.0)]
    };
    assert_eq!(deepest("Q201 = -18"), [-10.0, -18.0]);
    assert_eq!(deepest("FN 0: Q203 = -5"), [-10.0, -15.0]);
    // The value that was assigned counts, not the parameter that it came from.
    assert_eq!(deepest("Q1 = -18"), [-10.0, -10.0]);
}

/// The signs of the turns of a cycle that is called once, with its spindle.
fn turns(definition: &str, spindle: &str) -> Vec<f64> {
    struct Turns(Vec<f64>);
    impl Sink for Turns {
        fn command(&mut self, command: &Command) {
            self.0.extend(command.kind.shape().map(|shape| shape.sweep.signum()));
        }

        fn diagnostic(&mut self, diagnostic: Diagnostic) {
            assert_ne!(diagnostic.severity, chordal::Severity::Error, "{}", diagnostic.message);
        }
    }
    impl RunSink for Turns {}
    let text = format!(
        "BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F500\nL X+0 Y+0 Z+2 R0 FMAX {spindle}\n{definition}\n\
         CYCL CALL\nM30\nEND PGM A MM\n"
    );
    let mut sources = SourceMap::new();
    sources.add(Source::new("a.h", text.into_bytes()));
    let mut sink = Turns(Vec::new());
    Job::new(sources, tool_10()).expect("settings").run(&mut sink);
    assert!(!sink.0.is_empty(), "{definition}");
    sink.0.dedup();
    sink.0
}

#[test]
fn pockets_and_bores_turn_as_programmed() {
    let bore = |climb: i32| {
        format!(
            "CYCL DEF 208 Q200=2 Q201=-5 Q206=150 Q334=1 Q203=+0 Q204=20 Q335=30 Q342=0 Q351={climb}"
        )
    };
    let pocket = |climb: i32| {
        format!(
            "CYCL DEF 252 Q215=0 Q223=40 Q368=0.2 Q207=500 Q351={climb} Q201=-5 Q202=5 Q369=0 Q206=150 Q338=0 \
             Q200=2 Q203=+0 Q204=20 Q370=1 Q366=1 Q385=500"
        )
    };
    for definition in [bore, pocket] {
        assert_eq!(turns(&definition(1), "M3"), [1.0]);
        assert_eq!(turns(&definition(-1), "M3"), [-1.0]);
        assert_eq!(turns(&definition(1), "M4"), [-1.0]);
    }
    let old = |sign: &str| {
        format!(
            "CYCL DEF 5.0 CIRCULAR POCKET\nCYCL DEF 5.1 SET UP 2\nCYCL DEF 5.2 DEPTH -5\nCYCL DEF 5.3 PECKG 5 F100\n\
             CYCL DEF 5.4 RADIUS 20\nCYCL DEF 5.5 F300 DR{sign}"
        )
    };
    assert_eq!(turns(&old("+"), "M3"), [1.0]);
    assert_eq!(turns(&old("-"), "M3"), [-1.0]);
}

#[test]
fn patterns_run_old_cycles() {
    let text = "BEGIN PGM A MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+50 R0 FMAX M3\nCYCL DEF 1.0 PECKING\nCYCL DEF 1.1 SET UP 2\n\
                CYCL DEF 1.2 DEPTH -10\nCYCL DEF 1.3 PECKG 10\nCYCL DEF 1.4 DWELL 0\nCYCL DEF 1.5 F200\n\
                CYCL DEF 221 Q225=10 Q226=5 Q237=20 Q238=15 Q242=2 Q243=1 Q224=0 Q200=2 Q203=+0 Q204=30\nM30\nEND PGM A MM\n";
    let found = run_on(tool_10(), "a.h", text);
    assert!(found.problems.is_empty(), "{:?}", found.messages);
    let holes: Vec<_> = found.ends.iter().filter(|end| end[2] == -10.0).map(|end| end[0]).collect();
    assert_eq!(holes, [10.0, 30.0]);
    assert_eq!(found.ends.last(), Some(&[30.0, 5.0, 30.0]));
}

/// A contour that a fuzzer has found: two programs in one, with an arc at the end of what is not solved.
#[test]
fn half_a_free_contour_has_an_answer() {
    let text = "0 BEGIN PGM FKGERADEN MM\n\
                1 ; = clean\n\
                2 BLK FORM 0.1 Z X+0 Y+0 Z-10\n\
                3 BLK FORM 0.2 X+80 Y+90 Z+0\n\
                4 TOOL CALL 10 Z S3000\n\
                5 L Z+50 R0 FMAX M3\n\
                6 L X+5 Y+5 R0 FMAX ; = X+5 Y+5 Z+50\n\
                7 L Z+2 FMAX\n\
                8 L Z-2 F150 ; = X+5 Y+5 Z-2\n\
                9 FPOL X+50 Y+50\n\
                10 FL X+5 Y+60 F400 ; = X+5 Y+60\n\
                11 FL AN+0 LEN+20 ; = X+25 Y+60\n\
                12 FL PR+30 PA+90 ; = X+50 Y+80\n\
                13 FL X+70 AN-45 ; = X+70 Y+60\n\
                14 FC DR- R10 X+60 Y+50  X+80 Y+90 Z+0\n\
                4 TOOL CALL 10 Z S3000\n\
                5 L Z+50 R0 FMAX M3\n\
                6 L X+5 Y+5 R0 FMAX ; = X+5 Y+5 Z+50\n\
                7 L Z+2 FMAX\n\
                8 L Z-2 F150 ; = X+5 Y+5 Z-2\n\
                9 FPOL X+50 Y+50\n\
                10 FL X+5 Y+60 F400 ; = X+5 Y+60\n\
                11 FL AN+0 LCCX+60 CCY+60 ; = X+60 Y+50 ; = centre X+60 Y+60\n\
                15 FL X+65 Y+20 ; = X+65 Y+20\n\
                16 ; the next two are solved together\n\
                17 FL AN+180 ; = X+20 Y+20\n\
                18 FL X+5 Y+5 AN+225 ; = X+5 Y+5\n\
                19 L Z+50 R0 FMAX ; = X+5 Y+5 Z+50\n\
                20 M30 ; = end X+5 Y+5 Z+50\n\
                21 END PGM FKGERADEN MM\n\
                ";
    assert!(!run("a.h", text).problems.is_empty());
}

#[test]
fn loops_with_values_that_are_not_known_end() {
    let text = "BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F500\nL X+0 Y+0 Z+5 R0 FMAX M3\nQ1 = 0\nLBL 1\nQ1 = Q1 + Q108\n\
                FN 11: IF +Q1 GT +20 GOTO LBL 2\nL IX+1\nFN 9: IF +0 EQU +0 GOTO LBL 1\nLBL 2\nL X+50\nM30\nEND PGM A MM\n";
    let found = run("a.h", text);
    let codes: Vec<_> = found.problems.iter().map(|(_, code)| *code).collect();
    assert!(!codes.contains(&"CH211") && codes.contains(&"CH727"), "{codes:?}");
    assert_eq!(found.ends.last().map(|end| end[0]), Some(50.0));
    assert!(run_on(tool_10(), "a.h", text).problems.is_empty());
}

#[test]
fn a_corner_after_a_move_to_an_unknown_place_is_no_alarm() {
    let text = "BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F500\nL X+0 Y+0 Z+5 R0 FMAX M3\nL X+QR1 FAUTO\nRND R2\nL Y+50\nM30\n\
                END PGM A MM\n";
    let codes: Vec<_> = run_on(tool_10(), "a.h", text).problems.iter().map(|own| own.1).collect();
    assert_eq!(codes, ["CH727"]);
}

/// The axes that a move leaves from an unknown place.
#[test]
fn a_tool_of_unknown_length_is_unknown_along_its_own_axis() {
    struct UnknownStartRecord(Vec<Vec<usize>>);
    impl Sink for UnknownStartRecord {
        fn command(&mut self, command: &Command) {
            if let Some(motion) = command.kind.motion() {
                self.0.push((0..3).filter(|axis| !motion.from_known.has(*axis)).collect());
            }
        }

        fn diagnostic(&mut self, _: Diagnostic) {}
    }
    impl RunSink for UnknownStartRecord {}
    for (axis, letter) in ["X", "Y", "Z"].iter().enumerate() {
        let text = format!(
            "BEGIN PGM A MM\nTOOL CALL 7 {letter} S1000\nL X+0 Y+0 Z+0 R0 FMAX\nTOOL CALL 8 {letter} S900\n\
             L X+10 Y+10 Z+10 FMAX\nM30\nEND PGM A MM\n"
        );
        let mut machine = Machine::from_builtin("heidenhain-mill").expect("a machine");
        machine.work_offsets.entry("G54".into()).or_default().values = [Some(0.0); 6];
        let mut sources = SourceMap::new();
        sources.add(Source::new("a.h", text.into_bytes()));
        let mut sink = UnknownStartRecord(Vec::new());
        Job::new(sources, machine).expect("settings").run(&mut sink);
        assert_eq!(sink.0.last(), Some(&vec![axis]), "{letter}");
    }
}
