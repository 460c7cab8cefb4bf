//! The seam between a language and the kernel: a made-up language of lines drives the kernel through
//! [`ProgramSet`], without a block, a word or a G code anywhere.

#[path = "made_up/language.rs"]
mod language;

use std::sync::Arc;

use chordal_command::{Command, Sink};
use chordal_diagnostics::{Code, Diagnostic, Severity, Source, SourceMap, TextRange};
use chordal_kernel::{
    Checkpoint, ConfiguredControl, EndReason, Outcome, ProgramSet, ProgrammingLanguage, RunOptions,
    RunSink,
};
use chordal_machine::Machine;
use language::LinesLanguage;

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

/// The program on its machine.
struct Opened {
    sources: SourceMap<'static>,
    machine: Machine,
    options: RunOptions,
    control: Arc<dyn ConfiguredControl>,
}

impl Opened {
    fn new() -> Opened {
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.lines", PROGRAM.as_bytes()));
        let mut machine = Machine::new("made-up", LinesLanguage::control());
        machine.work_offsets.insert("G54".into(), Default::default());
        let (control, refused) = LinesLanguage.configure(&machine).expect("its control");
        assert!(refused.is_empty());
        Opened { sources, machine, options: RunOptions::default(), control }
    }

    fn programs(&self) -> Box<dyn ProgramSet + '_> {
        self.control.open(&self.sources, &self.machine, &self.options)
    }

    fn run(&self, from: Option<&Checkpoint>, wanted: Option<u32>) -> (Kept, Outcome) {
        let mut kept = Kept { wanted, ..Kept::default() };
        let ran = self.programs().run(0, from, &mut kept).expect("it is not ended");
        (kept, ran.outcome)
    }
}

#[test]
fn ten_lines_move_the_machine() {
    let opened = Opened::new();
    assert!(opened.programs().programs()[0].is_main);
    let (kept, outcome) = opened.run(None, None);
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
    let opened = Opened::new();
    let (kept, _) = opened.run(None, None);
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
    let opened = Opened::new();
    let place = PROGRAM.find("RIGHT").expect("a line") as u32;
    let (whole, outcome) = opened.run(None, Some(place));
    let (before, checkpoint) = whole.checkpoint.clone().expect("a checkpoint");
    assert_eq!((checkpoint.offset(), checkpoint.blocks()), (place, 5));
    let (rest, of_rest) = opened.run(Some(&checkpoint), None);
    assert_eq!(rest.commands, whole.commands[before..]);
    assert_eq!((of_rest.end, of_rest.blocks), (outcome.end, outcome.blocks));
    assert!(checkpoint.leads_on_like(&checkpoint.clone()));
    let (_, other) = opened.run(None, Some(0)).0.checkpoint.expect("a checkpoint");
    assert!(!checkpoint.leads_on_like(&other));
}

#[test]
fn it_is_coloured_and_explained() {
    let opened = Opened::new();
    let programs = opened.programs();
    let tokens = programs.tokens(TextRange::new(0, PROGRAM.len() as u32));
    assert_eq!(tokens.len(), 10);
    assert_eq!(tokens[1].range.slice(PROGRAM.as_bytes()), b"FEED");
    let at = PROGRAM.find("CUT").expect("a cut") as u32;
    assert_eq!(programs.meaning(at).expect("a meaning").1, "cuts along a line");
}
