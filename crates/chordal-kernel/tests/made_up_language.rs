//! The seam between a language and the kernel: a made-up language of lines drives the kernel
//! through [`Language`], without a block, a word or a G code anywhere.

use std::any::Any;

use chordal_command::{
    AxisMask, CallPath, Command, CommandKind, Origin, Sink, SpindleState, WorkName, WorkNaming,
};
use chordal_diagnostics::{Code, Diagnostic, FileId, Severity, Span, TextRange, TextShift};
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::rules::{CycleKind, Rules};
use chordal_kernel::{
    Alarms, ArcWords, Checkpoint, CheckpointMemory, CompletedRun, CycleState, EndReason, Kernel,
    KernelMemory, Language, Offsets, Outcome, ProgramPlace, RunSink, State, Statement, Token,
    TokenClass, WordMeaning,
};
use chordal_machine::{AXES, ControlName, Machine};

/// A line of the language.
struct Line<'t> {
    words: Vec<&'t str>,
    span: Span,
}

impl Line<'_> {
    fn number(&self, at: usize) -> f64 {
        self.words.get(at).and_then(|word| word.parse().ok()).unwrap_or(0.0)
    }
}

impl Statement for Line<'_> {
    fn span(&self) -> Span {
        self.span
    }

    fn words(&self, _: WordMeaning) -> Span {
        self.span
    }

    fn name(&self, what: WordMeaning) -> &'static str {
        match what {
            WordMeaning::Center => "ABOUT",
            _ => "this word",
        }
    }

    fn center_names(&self, _: Plane) -> [&'static str; 2] {
        ["the first", "the second number after ABOUT"]
    }

    fn number(&self, _: WordMeaning) -> Option<String> {
        None
    }

    fn has(&self, what: WordMeaning) -> bool {
        what == WordMeaning::Center && self.words.contains(&"ABOUT")
    }

    fn has_feed(&self) -> bool {
        self.words[0] == "FEED"
    }
}

/// Programs of lines: `RAPID x y z`, `CUT x y z`, `LEFT x y ABOUT a b`, `RIGHT …`, `FEED mm/min`,
/// `TURN rpm`, `DRILL x y DEPTH z FROM r`, `END`.
struct Lines {
    text: &'static str,
    machine: Machine,
    rules: Rules,
}

/// What this language remembers at a checkpoint: nothing but the kernel's own.
#[derive(Clone, Debug)]
struct LinesMemory(KernelMemory);

impl CheckpointMemory for LinesMemory {
    fn is_like(&self, other: &dyn CheckpointMemory) -> bool {
        other.as_any().downcast_ref().is_some_and(|other: &LinesMemory| self.0.is_like(&other.0))
    }

    fn shift(&mut self, shift: &TextShift) -> Option<()> {
        self.0.shift(shift)
    }

    fn copy(&self) -> Box<dyn CheckpointMemory> {
        Box::new(self.clone())
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

impl Lines {
    fn new(text: &'static str) -> Lines {
        let mut machine = Machine::new("made-up", ControlName::Fanuc);
        machine.work_offsets.insert("G54".into(), Default::default());
        Lines { text, machine, rules: Rules::COMMON }
    }

    fn kernel<'a>(&'a self, sink: &'a mut (dyn RunSink + 'a)) -> Kernel<'a> {
        let naming = WorkNaming { extended: "G54.1", first: 1, by_e: false };
        let offsets = Offsets::new(&self.machine, WorkName::G(54), naming);
        let state = State::new(&self.rules, offsets, [0.0; AXES]);
        let alarms = Alarms {
            title: "Made up",
            texts: &[(Code::RadiusMismatch, "THIS IS NO CIRCLE, OFF BY {delta}")],
        };
        Kernel::new(&self.rules, &self.machine, alarms, state, sink)
    }

    /// The lines from a byte on.
    fn lines(&self, from: u32) -> impl Iterator<Item = (u32, Line<'_>)> {
        let mut start = from;
        self.text[from as usize..].split_inclusive('\n').filter_map(move |text| {
            let at = start;
            start += text.len() as u32;
            let words: Vec<&str> = text.split_whitespace().collect();
            let range = TextRange::new(at, at + text.trim_end().len() as u32);
            let span = Span { file: FileId(0), range };
            (!words.is_empty()).then_some((at, Line { words, span }))
        })
    }

    /// Carries out a line; false at the end.
    fn carry_out(kernel: &mut Kernel<'_>, line: &Line) -> bool {
        const XY: AxisMask = AxisMask(0b011);
        const XYZ: AxisMask = AxisMask::LINEAR;
        let mut target = kernel.state.position;
        for (axis, value) in target.iter_mut().enumerate().take(3) {
            if matches!(line.words[0], "RAPID" | "CUT") || axis < 2 {
                *value = line.number(axis + 1);
            }
        }
        match line.words[0] {
            "RAPID" => kernel.rapid(target, XYZ),
            "CUT" => kernel.line(line, target, XYZ),
            "FEED" => {
                let per_s = line.number(1) / 60.0;
                kernel.set_feed(line.span, per_s, per_s.to_radians());
            }
            "TURN" => {
                kernel.set_speed(line.number(1));
                kernel.set_spindle(SpindleState::Cw);
            }
            "LEFT" | "RIGHT" => {
                let left = line.words[0] == "LEFT";
                let arc = ArcWords {
                    direction: if left { TurnDirection::Ccw } else { TurnDirection::Cw },
                    center: [Some(line.number(4)), Some(line.number(5))],
                    turns: 0,
                };
                kernel.arc_by_center(line, &arc, target, XY);
            }
            "DRILL" => {
                let level = kernel.state.position[2];
                let mut cycle = CycleState::new(CycleKind::Drill, 2, level);
                (cycle.z, cycle.r) = (Some(line.number(4)), Some(line.number(6)));
                kernel.state.cycle = Some(cycle);
                kernel.fire_hole_at(line, target);
                kernel.state.cycle = None;
            }
            "END" => {
                kernel.emit(CommandKind::End);
                return false;
            }
            other => {
                let message = format!("`{other}` is not a word of this language");
                kernel.report(Diagnostic::new(Code::UnknownCode, line.span, message));
            }
        }
        true
    }
}

impl Language for Lines {
    fn programs(&self) -> Vec<ProgramPlace> {
        let range = TextRange::new(0, self.text.len() as u32);
        let span = Span { file: FileId(0), range };
        vec![ProgramPlace { span, number: None, is_main: true }]
    }

    fn run(
        &self,
        _: usize,
        from: Option<&Checkpoint>,
        sink: &mut dyn RunSink,
    ) -> Option<CompletedRun> {
        let mut kernel = self.kernel(sink);
        kernel.state.arc_center = chordal_kernel::rules::ArcCenter::Absolute;
        let mut blocks = from.map_or(0, Checkpoint::blocks);
        if let Some(memory) = from.and_then(Checkpoint::memory::<LinesMemory>) {
            kernel.recall(memory.0.clone());
        }
        let mut end = EndReason::EndOfText;
        for (at, line) in self.lines(from.map_or(0, Checkpoint::offset)) {
            if at >= kernel.sink.next_checkpoint() {
                let memory = LinesMemory(kernel.memory());
                let checkpoint = Checkpoint::new(at, 1, blocks, Box::new(memory));
                if kernel.sink.checkpoint(checkpoint, None).is_break() {
                    return None;
                }
            }
            blocks += 1;
            kernel.origin =
                Origin { span: line.span, line: 1, call: CallPath::default(), cycle: false };
            if !Lines::carry_out(&mut kernel, &line) {
                end = EndReason::ProgramEnd;
                break;
            }
        }
        let outcome =
            Outcome { end, blocks, calls: Default::default(), missing_programs: Vec::new() };
        Some(CompletedRun { outcome, text_read: None })
    }

    fn tokens(&self, part: TextRange) -> Vec<Token> {
        let lines = self.lines(0).filter(|(at, _)| *at >= part.start && *at < part.end);
        let keyword = |line: Line<'_>| {
            let start = line.span.range.start;
            let range = TextRange::new(start, start + line.words[0].len() as u32);
            Token { range, class: TokenClass::Keyword }
        };
        lines.map(|(_, line)| keyword(line)).collect()
    }

    fn meaning(&self, at: u32) -> Option<(TextRange, String)> {
        let token = self.tokens(TextRange::new(0, u32::MAX));
        let token =
            token.into_iter().find(|token| token.range.start <= at && at < token.range.end)?;
        let text = match token.range.slice(self.text.as_bytes()) {
            b"RAPID" => "moves fast",
            b"CUT" => "cuts along a line",
            _ => return None,
        };
        Some((token.range, text.into()))
    }
}

/// Keeps what a run gives, and takes one checkpoint.
#[derive(Default)]
struct Kept {
    commands: Vec<Command>,
    problems: Vec<Diagnostic>,
    wanted: Option<u32>,
    checkpoint: Option<(usize, Checkpoint)>,
}

impl Sink for Kept {
    fn command(&mut self, command: &Command) {
        self.commands.push(command.clone());
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.problems.push(diagnostic);
    }
}

impl RunSink for Kept {
    fn next_checkpoint(&self) -> u32 {
        self.wanted.filter(|_| self.checkpoint.is_none()).unwrap_or(u32::MAX)
    }

    fn checkpoint(
        &mut self,
        checkpoint: Checkpoint,
        _: Option<TextRange>,
    ) -> std::ops::ControlFlow<()> {
        self.checkpoint = Some((self.commands.len(), checkpoint));
        std::ops::ControlFlow::Continue(())
    }
}

const PROGRAM: &str = "\
TURN 2000
FEED 600
RAPID 0 0 5
CUT 0 0 -1
LEFT 10 0 ABOUT 5 0
RIGHT 20 0 ABOUT 14 0
CUT 20 0 5
DRILL 30 40 DEPTH -8 FROM 2
JUMP 1 2 3
END
";

fn run(language: &Lines, from: Option<&Checkpoint>, wanted: Option<u32>) -> (Kept, Outcome) {
    let mut kept = Kept { wanted, ..Kept::default() };
    let ran = language.run(0, from, &mut kept).expect("it is not ended");
    (kept, ran.outcome)
}

#[test]
fn ten_lines_move_the_machine() {
    let language = Lines::new(PROGRAM);
    assert!(language.programs()[0].is_main);
    let (kept, outcome) = run(&language, None, None);
    assert_eq!((outcome.end, outcome.blocks), (EndReason::ProgramEnd, 10));
    let moves: Vec<_> = kept.commands.iter().filter_map(|c| c.kind.motion()).collect();
    let ends: Vec<[f64; 3]> = moves.iter().map(|m| [m.to[0], m.to[1], m.to[2]]).collect();
    // The hole: over it, down to 2, cut to -8, back to the level where the cycle began.
    let expected = [
        [0.0, 0.0, 5.0],
        [0.0, 0.0, -1.0],
        [10.0, 0.0, -1.0],
        [20.0, 0.0, -1.0],
        [20.0, 0.0, 5.0],
        [30.0, 40.0, 5.0],
        [30.0, 40.0, 2.0],
        [30.0, 40.0, -8.0],
        [30.0, 40.0, 5.0],
    ];
    assert_eq!(ends, expected);
    let arc = kept.commands.iter().find_map(|command| command.kind.shape()).expect("an arc");
    assert_eq!((arc.center, arc.radius_from), ([5.0, 0.0], 5.0));
    assert!((arc.sweep - std::f64::consts::PI).abs() < 1e-12, "half a circle to the left");
    let feed = kept.commands.iter().find_map(|command| command.kind.feed()).expect("a cut");
    assert_eq!(feed.value, 10.0, "600 mm/min are 10 mm/s");
}

#[test]
fn its_problems_have_their_line_and_the_control_s_own_words() {
    let language = Lines::new(PROGRAM);
    let (kept, _) = run(&language, None, None);
    let errors: Vec<_> = kept.problems.iter().filter(|p| p.severity == Severity::Error).collect();
    // From 10 0 the centre 14 0 is 4 away, from 20 0 it is 6.
    assert_eq!(errors[0].code, Code::RadiusMismatch);
    let text = errors[0].primary.span.range.slice(PROGRAM.as_bytes());
    assert_eq!(text, b"RIGHT 20 0 ABOUT 14 0");
    assert_eq!(errors[0].alarm.as_deref(), Some("Made up: THIS IS NO CIRCLE, OFF BY 0.0787 in"));
    assert_eq!(errors[1].code, Code::UnknownCode);
    assert!(errors[1].message.contains("JUMP"));
}

#[test]
fn a_run_goes_on_from_a_checkpoint() {
    let language = Lines::new(PROGRAM);
    let place = PROGRAM.find("RIGHT").expect("a line") as u32;
    let (whole, outcome) = run(&language, None, Some(place));
    let (before, checkpoint) = whole.checkpoint.clone().expect("a checkpoint");
    assert_eq!((checkpoint.offset(), checkpoint.blocks()), (place, 5));
    let (rest, of_rest) = run(&language, Some(&checkpoint), None);
    assert_eq!(rest.commands, whole.commands[before..]);
    assert_eq!((of_rest.end, of_rest.blocks), (outcome.end, outcome.blocks));
    assert!(checkpoint.leads_on_like(&checkpoint.clone()));
    let (_, other) = run(&language, None, Some(0)).0.checkpoint.expect("a checkpoint");
    assert!(!checkpoint.leads_on_like(&other));
}

#[test]
fn it_is_coloured_and_explained() {
    let language = Lines::new(PROGRAM);
    let tokens = language.tokens(TextRange::new(0, PROGRAM.len() as u32));
    assert_eq!(tokens.len(), 10);
    assert_eq!(tokens[1].range.slice(PROGRAM.as_bytes()), b"FEED");
    let at = PROGRAM.find("CUT").expect("a cut") as u32;
    assert_eq!(language.meaning(at).expect("a meaning").1, "cuts along a line");
}
