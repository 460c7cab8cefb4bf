//! A made-up language of lines. It has no block, no word and no G code: it shows what a language has to bring along.
//!
//! `TOOL n`, `TURN rpm`, `FEED mm/min`, `RAPID x y z`, `CUT x y z`, `LEFT x y ABOUT a b`, `RIGHT …`,
//! `DRILL x y DEPTH z FROM r`, `PART name` (runs the file of that name), `NOTE text`, `END`.

use std::any::Any;
use std::sync::Arc;

use chordal_command::{
    AxisMask, CallPath, CallPaths, CommandKind, Origin, SpindleState, WorkNaming,
};
use chordal_diagnostics::{Code, Diagnostic, FileId, SourceMap, Span, TextRange, TextShift};
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::rules::{ArcCenter, CycleKind, LengthRules, Rules, ToolLengths};
use chordal_kernel::{
    Alarms, ArcWords, Checkpoint, CheckpointMemory, CompletedRun, ConfiguredControl,
    ControlCandidate, ControlProfile, CycleState, EndReason, FoundSign, Kernel, KernelMemory,
    Modal, Outcome, ProgramName, ProgramPlace, ProgramSet, ProgrammingLanguage, RunOptions,
    RunSink, SettingError, State, Statement, TextSymbol, TextSymbolKind, Token, TokenClass,
    WordCompletion, WordMeaning,
};
use chordal_machine::{AXES, ControlName, Machine};

/// The words of the language and what they do.
const WORDS: [(&str, &str); 11] = [
    ("TOOL", "changes the tool"),
    ("TURN", "turns the spindle"),
    ("FEED", "sets the feed"),
    ("RAPID", "moves fast"),
    ("CUT", "cuts along a line"),
    ("LEFT", "cuts an arc to the left"),
    ("RIGHT", "cuts an arc to the right"),
    ("DRILL", "drills a hole"),
    ("PART", "runs another program"),
    ("NOTE", "says something to people"),
    ("END", "ends the program"),
];

const PROFILE: ControlProfile = ControlProfile {
    name: "made-up",
    title: "Made up",
    source: "this file",
    default_machine: "made-up",
    alarms: &[(Code::RadiusMismatch, "THIS IS NO CIRCLE, OFF BY {delta}")],
    work_names: WorkNaming { extended: "G54.1", first: 1, by_e: false },
    turns: false,
};

const RULES: Rules = Rules {
    length: LengthRules { source: ToolLengths::TouchedOff, ..LengthRules::COMMON },
    ..Rules::COMMON
};

/// The language.
#[derive(Debug)]
pub struct LinesLanguage;

impl LinesLanguage {
    /// The name of its control.
    pub fn control() -> ControlName {
        ControlName::register(PROFILE.name)
    }
}

impl ProgrammingLanguage for LinesLanguage {
    fn title(&self) -> &'static str {
        "made-up lines"
    }

    fn profile(&self, control: ControlName) -> Option<ControlProfile> {
        (control.as_str() == PROFILE.name).then_some(PROFILE)
    }

    fn configure(
        &self,
        machine: &Machine,
    ) -> Option<(Arc<dyn ConfiguredControl>, Vec<SettingError>)> {
        self.profile(machine.control)?;
        let mut axes = AxisMask::NONE;
        (0..AXES).filter(|axis| machine.axes[*axis].is_some()).for_each(|axis| axes.insert(axis));
        let refused = machine.settings.keys().map(|name| SettingError {
            name: name.clone(),
            message: "this control has no settings".into(),
            help: None,
        });
        Some((Arc::new(LinesControl { rules: RULES, axes }), refused.collect()))
    }

    fn has_program_line(&self, text: &[u8]) -> bool {
        let is_known = |line: &Line<'_>| WORDS.iter().any(|(word, _)| *word == line.words[0]);
        lines(FileId(0), text, 0).any(|(_, line)| is_known(&line))
    }

    fn recognize(&self, text: &[u8]) -> Vec<ControlCandidate> {
        let line = |line: &Line<'_>| matches!(line.words[0], "RAPID" | "CUT");
        let Some((at, _)) = lines(FileId(0), text, 0).find(|(_, found)| line(found)) else {
            return Vec::new();
        };
        let before = text[..at as usize].iter().filter(|byte| **byte == b'\n').count();
        let sign = FoundSign {
            sign: "a line begins with RAPID or CUT",
            line: before as u32 + 1,
            offset: at,
            weight: 20,
            machine: None,
        };
        vec![ControlCandidate {
            name: PROFILE.name,
            title: PROFILE.title,
            control: LinesLanguage::control(),
            not_read: false,
            weight: sign.weight,
            signs: vec![sign],
            errors: None,
        }]
    }
}

/// The only control of the language.
#[derive(Debug)]
pub struct LinesControl {
    rules: Rules,
    axes: AxisMask,
}

impl ConfiguredControl for LinesControl {
    fn profile(&self) -> ControlProfile {
        PROFILE
    }

    fn rules(&self) -> &Rules {
        &self.rules
    }

    fn axes(&self) -> AxisMask {
        self.axes
    }

    fn open<'a>(
        &'a self,
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        options: &'a RunOptions,
    ) -> Box<dyn ProgramSet + 'a> {
        Box::new(LinesPrograms::new(self, sources, machine, options))
    }

    fn program_names(&self, _: &[u8]) -> Vec<ProgramName> {
        Vec::new()
    }

    fn called_programs(&self, text: &[u8]) -> Vec<ProgramName> {
        let calls = lines(FileId(0), text, 0).filter(|(_, line)| line.words[0] == "PART");
        calls
            .filter_map(|(_, line)| Some(ProgramName::from(line.words.get(1)?.to_string())))
            .collect()
    }

    fn names_units(&self, _: &[u8]) -> bool {
        true
    }

    fn subprogram_extensions(&self) -> &'static [&'static str] {
        &["lines"]
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// A line of the language.
pub struct Line<'t> {
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

/// The lines of a text from a byte on, with the byte at which each begins.
fn lines(file: FileId, text: &[u8], from: u32) -> impl Iterator<Item = (u32, Line<'_>)> {
    let mut start = from;
    text[from as usize..].split_inclusive(|byte| *byte == b'\n').filter_map(move |line| {
        let at = start;
        start += line.len() as u32;
        let line = std::str::from_utf8(line).unwrap_or("?");
        let words: Vec<&str> = line.split_whitespace().collect();
        let range = TextRange::new(at, at + line.trim_end().len() as u32);
        (!words.is_empty()).then_some((at, Line { words, span: Span { file, range } }))
    })
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

/// The programs of some texts: each text is one.
pub struct LinesPrograms<'a> {
    control: &'a LinesControl,
    sources: &'a SourceMap<'a>,
    machine: &'a Machine,
    options: &'a RunOptions,
    places: Vec<ProgramPlace>,
}

impl<'a> LinesPrograms<'a> {
    fn new(
        control: &'a LinesControl,
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        options: &'a RunOptions,
    ) -> LinesPrograms<'a> {
        let place = |(file, source): (FileId, &chordal_diagnostics::Source<'_>)| ProgramPlace {
            file,
            name: Some(ProgramName::from(name_of(source.name()).to_string())),
            head: TextRange::new(0, 0),
            range: TextRange::new(0, source.text().len() as u32),
            line: 1,
            is_main: file == FileId(0),
        };
        let places = sources.iter().map(place).collect();
        LinesPrograms { control, sources, machine, options, places }
    }

    fn text(&self, file: FileId) -> &'a [u8] {
        self.sources.get(file).map_or(&[], |source| source.text())
    }

    fn kernel<'k>(&'k self, sink: &'k mut (dyn RunSink + 'k)) -> Kernel<'k> {
        let offsets = self.control.initial_offsets(self.machine);
        let home = self.machine.home.map(|place| place.unwrap_or(0.0));
        let state = State::new(&self.control.rules, offsets, home);
        let alarms = Alarms { title: PROFILE.title, texts: PROFILE.alarms };
        let mut kernel = Kernel::new(&self.control.rules, self.machine, alarms, state, sink);
        kernel.max_repeated = self.options.max_repeated_blocks;
        kernel
    }

    /// Runs the text that a `PART` line names.
    fn run_part(&self, kernel: &mut Kernel<'_>, line: &Line<'_>, run: &mut LinesRun) {
        let name = line.words.get(1).copied().unwrap_or_default();
        let found = self.places.iter().find(|place| {
            place.name.as_ref().is_some_and(|own| own.to_string().eq_ignore_ascii_case(name))
        });
        let Some(place) = found.filter(|place| place.file != FileId(0)) else {
            run.missing.push(ProgramName::from(name.to_string()));
            let message = format!("there is no program {name}");
            return kernel.report(Diagnostic::new(Code::MissingSubprogram, line.span, message));
        };
        let caller = kernel.origin;
        let call = run.calls.enter(caller.call, line.span);
        for (number, (_, line)) in lines(place.file, self.text(place.file), 0).enumerate() {
            kernel.origin = Origin { span: line.span, line: number as u32 + 1, call, cycle: false };
            run.blocks += 1;
            if !carry_out(kernel, &line) {
                break;
            }
        }
        kernel.origin = caller;
    }
}

/// What a run counts.
struct LinesRun {
    blocks: u64,
    calls: CallPaths,
    missing: Vec<ProgramName>,
}

/// The name of a file without folder and extension.
fn name_of(file: &str) -> &str {
    let file = file.rsplit(['/', '\\']).next().unwrap_or(file);
    file.split_once('.').map_or(file, |(stem, _)| stem)
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
        "TOOL" => {
            kernel.select_tool(line.number(1) as u32);
            kernel.tool_change(line.span);
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
        "NOTE" => {}
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

impl ProgramSet for LinesPrograms<'_> {
    fn programs(&self) -> &[ProgramPlace] {
        &self.places
    }

    fn run(
        &self,
        program: usize,
        from: Option<&Checkpoint>,
        sink: &mut dyn RunSink,
    ) -> Option<CompletedRun> {
        let file = self.places.get(program)?.file;
        let mut kernel = self.kernel(sink);
        kernel.state.arc_center = ArcCenter::Absolute;
        let blocks = from.map_or(0, Checkpoint::blocks);
        let mut run = LinesRun { blocks, calls: CallPaths::default(), missing: Vec::new() };
        if let Some(memory) = from.and_then(Checkpoint::memory::<LinesMemory>) {
            kernel.recall(memory.0.clone());
        }
        let mut end = EndReason::EndOfText;
        let source = self.sources.get(file)?;
        for (at, line) in lines(file, self.text(file), from.map_or(0, Checkpoint::offset)) {
            let number = source.line_of(at);
            if at >= kernel.sink.next_checkpoint() {
                let memory = LinesMemory(kernel.memory());
                let checkpoint = Checkpoint::new(at, number, run.blocks, Box::new(memory));
                if kernel.sink.checkpoint(checkpoint, None).is_break() {
                    return None;
                }
            }
            run.blocks += 1;
            kernel.origin =
                Origin { span: line.span, line: number, call: CallPath::default(), cycle: false };
            let goes_on = match line.words[0] {
                "PART" => {
                    self.run_part(&mut kernel, &line, &mut run);
                    true
                }
                _ => carry_out(&mut kernel, &line),
            };
            if kernel.sink.wants_blocks() {
                kernel.block_done(&|state| Modal::of(state, Vec::new()));
            }
            if !goes_on {
                end = EndReason::ProgramEnd;
                break;
            }
        }
        let LinesRun { blocks, calls, missing } = run;
        let outcome = Outcome { end, blocks, calls, missing_programs: missing };
        Some(CompletedRun { outcome, text_read: None })
    }

    fn tokens(&self, part: TextRange) -> Vec<Token> {
        let all = lines(FileId(0), self.text(FileId(0)), 0);
        let own = all.filter(|(at, _)| *at >= part.start && *at < part.end);
        let token = |line: Line<'_>| {
            let TextRange { start, end } = line.span.range;
            match line.words[0] {
                "NOTE" => Token { range: TextRange::new(start, end), class: TokenClass::Comment },
                word => {
                    let range = TextRange::new(start, start + word.len() as u32);
                    Token { range, class: TokenClass::Keyword }
                }
            }
        };
        own.map(|(_, line)| token(line)).collect()
    }

    fn meaning(&self, at: u32) -> Option<(TextRange, String)> {
        let tokens = self.tokens(TextRange::new(0, u32::MAX));
        let token =
            tokens.into_iter().find(|token| token.range.start <= at && at < token.range.end)?;
        let word = std::str::from_utf8(token.range.slice(self.text(FileId(0)))).ok()?;
        let (_, meaning) = WORDS.iter().find(|(own, _)| *own == word)?;
        Some((token.range, meaning.to_string()))
    }

    fn symbols(&self) -> Vec<TextSymbol> {
        let all = lines(FileId(0), self.text(FileId(0)), 0);
        let tools = all.filter(|(_, line)| line.words[0] == "TOOL");
        tools
            .map(|(_, line)| TextSymbol {
                name: line.words.join(" "),
                kind: TextSymbolKind::Tool,
                range: line.span.range,
                body: line.span.range,
            })
            .collect()
    }

    fn completions(&self, _: u32) -> Vec<WordCompletion> {
        let word = |(word, meaning): &(&str, &str)| WordCompletion {
            word: word.to_string(),
            meaning: meaning.to_string(),
        };
        WORDS.iter().map(word).collect()
    }

    fn formatted(&self) -> Option<String> {
        let all = lines(FileId(0), self.text(FileId(0)), 0);
        Some(all.map(|(_, line)| line.words.join(" ") + "\n").collect())
    }
}
