//! Codes of a shop's own: who knows them is asked, and what is answered is carried out in every
//! question alike.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex};

use chordal::control::{EndReason, ProgramName};
use chordal::motion::{
    MotionOptions, PlanSink, PlannerStep, StepKind, StepSource, StepSources, WaitKind,
};
use chordal::{
    Code, CommandKind, CustomCode, Job, Machine, Report, RunOptions, ShopAnswer, ShopCall,
    ShopCodes, ShopRecord, Source, SourceMap,
};

fn job_on(machine: Machine, text: &str, shop: Option<Arc<dyn ShopCodes>>) -> Job<'_> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes()));
    let options =
        RunOptions { shop_codes: shop, max_repeated_blocks: 100_000, ..RunOptions::default() };
    Job::new(sources, machine).expect("a machine").options(options)
}

fn builtin(name: &str) -> Machine {
    Machine::from_builtin(name).expect("a built-in machine")
}

fn job<F>(text: &str, shop: F) -> Job<'_>
where
    F: Fn(&ShopCall<'_>) -> ShopAnswer + Send + Sync + 'static,
{
    job_on(builtin("haas-vf2"), text, Some(Arc::new(shop)))
}

/// What a run does, in short, with the line of its text.
fn steps(job: &Job<'_>) -> Vec<String> {
    let mut steps = Vec::new();
    job.report_of_commands(|command| {
        let line = command.origin.line;
        match &command.kind {
            CommandKind::Dwell { seconds, label } => {
                steps.push(format!("{line}: {seconds} s {}", label.as_deref().unwrap_or("-")));
            }
            CommandKind::Rapid { motion, .. } | CommandKind::Line { motion, .. } => {
                let [x, y, z, ..] = motion.to;
                steps.push(format!("{line}: X{x} Y{y} Z{z}"));
            }
            CommandKind::End => steps.push(format!("{line}: end")),
            _ => {}
        }
    });
    steps
}

fn told(report: &Report) -> Vec<(Code, &str)> {
    report.diagnostics.iter().map(|d| (d.code, d.message.as_str())).collect()
}

const FLIP: &str = "G21 G90 G0 X10. Y0. Z5.\nM120 P2 X20.\nX30.\nM30\n";

#[test]
fn a_time_is_a_wait_after_the_move_of_its_block() {
    let job = job(FLIP, |call| match call.code {
        CustomCode::M(1200) => ShopAnswer::wait(2.5, "part flip"),
        _ => ShopAnswer::NotMine,
    });
    let expected = ["1: X10 Y0 Z5", "2: X20 Y0 Z5", "2: 2.5 s part flip", "3: X30 Y0 Z5", "4: end"];
    assert_eq!(steps(&job), expected);
    let report = job.report();
    assert_eq!(told(&report), [], "P is a word of the shop's code");
    assert_eq!((report.summary.dwells, report.summary.dwell_time_s), (1, 2.5));
    assert_eq!(told(&job.check()), []);
}

#[test]
fn the_planner_waits_as_long() {
    struct Waits(Vec<(WaitKind, f64)>);
    impl PlanSink for Waits {
        fn step(&mut self, step: PlannerStep<'_>, sources: &StepSources) {
            if let PlannerStep::Wait { seconds, tag } = step
                && seconds > 0.0
                && let Some(StepSource { kind: StepKind::Wait(kind), .. }) = sources.get(tag)
            {
                self.0.push((*kind, seconds));
            }
        }
    }
    let job = job(FLIP, |_| ShopAnswer::wait(2.5, "part flip"));
    let mut waits = Waits(Vec::new());
    job.plan(&MotionOptions::default(), &mut waits).expect("limits");
    assert_eq!(waits.0, [(WaitKind::ShopCode, 2.5)]);
}

#[test]
fn what_nobody_knows_is_told_as_ever() {
    let nobody = job(FLIP, |_| ShopAnswer::NotMine);
    let without = job_on(builtin("haas-vf2"), FLIP, None);
    assert_eq!(told(&nobody.report()), told(&without.report()));
    assert_eq!(told(&nobody.report())[0].0, Code::UnknownCode);
    assert_eq!(steps(&nobody), steps(&without));
}

#[test]
fn blocks_of_the_shop_run_as_a_subprogram() {
    let job = job(FLIP, |_| ShopAnswer::text("G91 G0 Z50.\nG1 Q1. X1. F100.\nG90"));
    let expected =
        ["1: X10 Y0 Z5", "2: X20 Y0 Z5", "1: X20 Y0 Z55", "2: X21 Y0 Z55", "3: X30 Y0 Z55"];
    assert_eq!(steps(&job)[..5], expected);
    let report = job.report();
    let unused = report.diagnostics.iter().find(|problem| problem.code == Code::UnusedWord);
    let problem = unused.expect("Q beside G1");
    let name = |file| job.sources().get(file).map(Source::name);
    assert_eq!(name(problem.primary.span.file), Some("custom code M120"));
    assert_eq!(job.sources().words(problem.primary.span), "Q1.");
    let calls: Vec<_> = problem.calls.iter().map(|call| job.sources().words(*call)).collect();
    assert_eq!(calls, ["M120 P2 X20."], "and through which block it was reached");
    let files = job.sources().appended().count();
    assert_eq!(files, 1, "a text is kept once, however often the job is asked");
}

#[test]
fn a_refusal_is_an_error_at_the_word() {
    let job = job(FLIP, |_| ShopAnswer::Refused("the door is open".into()));
    let report = job.report();
    let problem = &report.diagnostics[0];
    assert_eq!(problem.code, Code::ShopCodeRefused);
    assert_eq!(problem.message, "the rule for the custom code M120 refuses it: the door is open");
    assert_eq!(job.sources().words(problem.primary.span), "M120");
    assert_eq!(report.summary.dwells, 0);
}

#[test]
fn a_time_that_cannot_be_is_refused() {
    for seconds in [-1.0, f64::NAN, f64::INFINITY] {
        let job = job(FLIP, move |_| ShopAnswer::Wait { seconds, label: None });
        let report = job.report();
        assert_eq!(report.diagnostics[0].code, Code::ShopCodeRefused, "{seconds}");
        assert!(
            report.diagnostics[0]
                .message
                .ends_with(&format!("a time of {seconds} s is not possible"))
        );
    }
}

#[test]
fn a_missing_program_is_asked_for_with_its_arguments() {
    let text = "G21 G90 G0 X0 Y0 Z0\nG65 P9010 A1.5 X2. L3\nM98 P9011 L2\nG65 P9012\nM30\n";
    let job = job(text, |call| match call.code {
        CustomCode::Program(9010) => {
            assert_eq!(call.arguments, [(1, 1.5), (24, 2.0)]);
            ShopAnswer::text("G91 G0 X#24\nG90")
        }
        CustomCode::Program(9011) => {
            assert_eq!(call.words, [('M', 98.0), ('P', 9011.0), ('L', 2.0)]);
            ShopAnswer::Wait { seconds: 1.5, label: None }
        }
        _ => ShopAnswer::NotMine,
    });
    let expected =
        ["1: X0 Y0 Z0", "1: X2 Y0 Z0", "1: X4 Y0 Z0", "1: X6 Y0 Z0", "3: 3 s O9011", "5: end"];
    assert_eq!(steps(&job), expected);
    let report = job.report();
    assert_eq!(told(&report)[0].0, Code::MissingSubprogram);
    let missing = &report.outcomes[0].missing_programs;
    assert_eq!(*missing, [ProgramName::Number(9012)], "what the shop knows is not missing");
}

#[test]
fn a_code_that_a_setting_makes_a_call_is_asked_by_its_program() {
    let mut machine = builtin("haas-vf2");
    machine.set("settings.\"Setting 91\"=1").ok();
    let mut fanuc = builtin("fanuc-30i");
    fanuc.set("settings.\"No. 6080\"=160").expect("the setting of M alias");
    let shop = |call: &ShopCall<'_>| match call.code {
        CustomCode::Program(9020) => ShopAnswer::wait(4.0, "pallet"),
        _ => ShopAnswer::NotMine,
    };
    let text = "O1\nG21 G90 G0 X0 Y0 Z0\nM160\nM30\n";
    let job = job_on(fanuc, text, Some(Arc::new(shop)));
    assert_eq!(steps(&job), ["2: X0 Y0 Z0", "3: 4 s pallet", "4: end"]);
}

#[test]
fn the_shop_sees_where_the_control_stands() {
    let seen = Arc::new(Mutex::new(Vec::new()));
    let note = seen.clone();
    let text =
        "G20 G90 T3 M6\nG0 X1. Y2. Z3.\nS500 M3\nG91\n/M2\nN50 M120.1 P7 (FLIP)\nM121\nM30\n";
    let shop = move |call: &ShopCall<'_>| {
        let known: Vec<bool> = (0..3).map(|axis| call.known.has(axis)).collect();
        note.lock().expect("a lock").push(format!(
            "{} {} {} {:?} {} {:?} {:?} T{} {:?} {:?} {} {} {known:?}",
            call.code,
            call.nth,
            call.file,
            call.line,
            call.text.trim(),
            call.words,
            call.arguments,
            call.tool,
            &call.position[..3],
            call.units,
            call.incremental,
            call.spindle_rpm,
        ));
        ShopAnswer::Wait { seconds: 0.0, label: None }
    };
    let mut machine = builtin("haas-vf2");
    machine.switches.block_delete = [true; 10];
    job_on(machine, text, Some(Arc::new(shop))).run(&mut Nothing);
    let seen = seen.lock().expect("a lock");
    let state = "[] T3 [25.4, 50.8, 76.2] Inch true 500 [true, true, true]";
    let first = "M120.1 0 part.nc 6 N50 M120.1 P7 (FLIP) [('M', 120.1), ('P', 7.0)]";
    assert_eq!(
        *seen,
        [format!("{first} {state}"), format!("M121 1 part.nc 7 M121 [('M', 121.0)] {state}"),]
    );
}

struct Nothing;

impl chordal::RunSink for Nothing {}

impl chordal::Sink for Nothing {
    fn command(&mut self, _: &chordal::Command) {}
    fn diagnostic(&mut self, _: chordal::Diagnostic) {}
}

#[test]
fn codes_of_the_control_are_not_the_shops() {
    // M8 is carried out, M39 reported as not simulated: that one the caller may answer.
    let text = "G21 G90 G0 X0 Y0 Z0\nM8\nM39\nM30\n";
    let job = job(text, |call| {
        assert_eq!(call.code, CustomCode::M(390));
        ShopAnswer::wait(1.0, "turret")
    });
    assert!(steps(&job).contains(&"3: 1 s turret".to_string()));
    assert_eq!(told(&job.report()), []);
}

#[test]
fn blocks_of_the_shop_have_the_budgets_of_a_subprogram() {
    // A code whose blocks call it again, and a loop without end.
    let again = job("G21 G90\nM120\nM30\n", |_| ShopAnswer::text("M120"));
    let report = again.report();
    assert_eq!(told(&report)[0].0, Code::NestingTooDeep);
    let endless = job("G21 G90\nM120\nM30\n", |_| ShopAnswer::text("WHILE[1EQ1]DO1\nG4P1\nEND1"));
    let report = endless.report();
    assert_eq!(report.outcomes[0].end, EndReason::Budget);
    let distinct = Arc::new(AtomicU32::new(0));
    let lines = "M120\n".repeat(10_050);
    let text = format!("G21 G90\n{lines}M30\n");
    let counted = distinct.clone();
    let many = job(&text, move |_| {
        ShopAnswer::text(&format!("(TEXT {})", counted.fetch_add(1, Ordering::Relaxed)))
    });
    let report = many.check();
    assert_eq!(report.counts.errors, 50, "more than 10,000 different texts are refused");
}

#[test]
fn labels_and_returns_stay_within_the_blocks_of_the_shop() {
    let blocks = "N1 G91 G0 X1.\nIF[#5041GE3]GOTO2\nGOTO1\nN2 G90 M99\nX99.";
    let job = job("G21 G90 G0 X0 Y0 Z0\nM120\nN2 X50.\nM30\n", move |_| ShopAnswer::text(blocks));
    let expected =
        ["1: X0 Y0 Z0", "1: X1 Y0 Z0", "1: X2 Y0 Z0", "1: X3 Y0 Z0", "3: X50 Y0 Z0", "4: end"];
    assert_eq!(steps(&job), expected);
}

#[test]
fn blocks_of_the_shop_stand_alone_in_their_block() {
    let shop = |call: &ShopCall<'_>| match call.code {
        CustomCode::M(1210) => ShopAnswer::wait(1.0, "clamp"),
        _ => ShopAnswer::text("G91 G0 X1.\nG90"),
    };
    let beside = job("G21 G90 G0 X0 Y0 Z0\nM120 M121\nM30\n", shop);
    assert_eq!(steps(&beside), ["1: X0 Y0 Z0", "2: 1 s clamp", "1: X1 Y0 Z0", "3: end"]);
    for text in ["M120 M122\nM30\n", "M120 M30\n"] {
        let report = job(text, shop).report();
        assert_eq!(told(&report)[0].0, Code::NotAlone, "{text}");
    }
}

#[test]
fn the_machine_file_names_codes_with_their_time() {
    let mut machine = builtin("haas-vf2");
    machine.set("shop_codes.M120={time=\"2500 ms\", label=\"part flip\"}").expect("keys");
    machine.set("shop_codes.M121.time=1 s").expect("keys");
    machine.set("shop_codes.M122={}").expect("keys");
    let text = "G21 G90 G0 X0 Y0 Z0\nM120\nM121 P1\nM122\nM123\nM30\n";
    let alone = job_on(machine.clone(), text, None);
    assert_eq!(steps(&alone), ["1: X0 Y0 Z0", "2: 2.5 s part flip", "3: 1 s M121", "6: end"]);
    let report = alone.report();
    assert_eq!(told(&report).len(), 1, "M123 alone is unknown: {:?}", told(&report));
    // What the run is given comes first.
    let shop = |call: &ShopCall<'_>| match call.code {
        CustomCode::M(1200) => ShopAnswer::wait(9.0, "by hand"),
        _ => ShopAnswer::NotMine,
    };
    let both = job_on(machine.clone(), text, Some(Arc::new(shop)));
    assert_eq!(steps(&both)[1..3], ["2: 9 s by hand", "3: 1 s M121"]);
    let mut twice = machine.clone();
    twice.set("shop_codes.O9810={time=\"1 s\", blocks=\"G4 P1.\"}").expect("keys");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes()));
    assert!(Job::new(sources, twice).is_err(), "blocks take their own time");
    machine.set("shop_codes.M8.time=1 s").expect("keys");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes()));
    assert!(Job::new(sources, machine).is_err(), "M8 is the control's own");
}

#[test]
fn a_record_asks_once_and_repeats_itself() {
    let asked = Arc::new(AtomicU32::new(0));
    let count = asked.clone();
    let moody = move |_: &ShopCall<'_>| ShopAnswer::Wait {
        seconds: f64::from(1 + count.fetch_add(1, Ordering::Relaxed)),
        label: None,
    };
    let shop = Arc::new(ShopRecord::new(Arc::new(moody)));
    let job = job_on(builtin("haas-vf2"), "G21\nM120 (1)\nM120 (2)\nM30\n", Some(shop));
    let first = steps(&job);
    assert_eq!(first, ["2: 1 s M120", "3: 2 s M120", "4: end"]);
    assert_eq!(steps(&job), first);
    assert_eq!(job.report().summary.dwell_time_s, 3.0);
    assert_eq!(asked.load(Ordering::Relaxed), 2);
}

#[test]
fn a_run_ends_when_it_is_interrupted() {
    let text = "G21 G90 G0 X0 Y0 Z0\n".repeat(100_000);
    let mut sources = SourceMap::new();
    sources.add(Source::new("long.nc", text.as_bytes()));
    let asked = Arc::new(AtomicU32::new(0));
    let count = asked.clone();
    let interrupt = move || count.fetch_add(1, Ordering::Relaxed) == 2;
    let options = RunOptions { interrupt: Some(Arc::new(interrupt)), ..RunOptions::default() };
    let job = Job::new(sources, builtin("haas-vf2")).expect("a machine").options(options);
    let outcomes = job.run(&mut Nothing);
    assert_eq!(outcomes[0].end, EndReason::Interrupted);
    assert!(outcomes[0].blocks < 4_000, "{}", outcomes[0].blocks);
}
