//! A program that begins at one of its lines: the text with the blocks that the control needs there. Nothing is proved here.
//!
//! `source` finds the block, `watch` runs up to it and notes what holds there (`definitions`, `functions`), `labels` finds the
//! subprograms that stand before it and are called after it, `head` writes the blocks, `approach` the
//! moves among them, with places and numbers as `places` and `values` have them.

mod approach;
mod definitions;
mod functions;
mod head;
mod labels;
mod places;
mod source;
mod values;
mod watch;

use std::collections::BTreeSet;
use std::ops::Range;

use chordal_command::CompensationSide;
use chordal_diagnostics::FileId;
use chordal_kernel::{EndReason, RestartFault, RestartObstacle, RestartedText, StateItem};

use self::head::KlartextHeadWriter;
use self::places::HeadFault;
use self::source::{BeginPlace, SourceText, fault};
use self::values::{add_names, add_reads, parameter_number};
use self::watch::{StateAtBlock, WatchedRun};
use super::interpreter::KlartextInterpreter;
use super::program_texts::{KlartextTexts, file_stem};
use crate::syntax::{KlartextStatement, LineReader, ParameterBank, ParameterName};

/// What to do where the program begins at a line anyway.
const RUN_IT: &str = "run the program itself";

/// How it moves every block says itself, and the data of a tool every TOOL CALL sets anew.
const FREE_ITEMS: &[StateItem] = &[StateItem::Motion, StateItem::Tables];

/// The parameters that every control leaves to programs.
const FREE_PARAMETERS: Range<u32> = 1..100;

/// The text of a program so that it begins at a line.
///
/// # Errors
/// Why it cannot begin there.
pub fn restarted_text(
    texts: &KlartextTexts<'_>,
    program: usize,
    line: u32,
) -> Result<RestartedText, RestartFault> {
    let text = texts.text(FileId(0));
    if LineReader::new(text).is_iso() {
        let what =
            "the program is written in DIN/ISO, and heads are written for conversational programs";
        return Err(fault(
            RestartObstacle::Form,
            what,
            "begin at a block with the control's own scan",
        ));
    }
    let source = SourceText::read(text);
    let place = source.place_of(line)?;
    let first = source.first_after_frame();
    let restart = KlartextRestart { texts, source, place, first, line };
    let start = restart.source.blocks[place.at].block.range.start;
    let kept = restart.kept();
    let mut sink = ();
    let run = KlartextInterpreter::new(texts, program, &mut sink).watch(start, kept);
    let state = restart.state_of(&run)?;
    restart.check_open(state)?;
    restart.source.check_alone(place.at)?;
    let sections = restart.source.needed_before(place.at, &state.modes.contour_labels)?;
    restart.written(state, &sections, run.end)
}

/// The request, and the text that it is about.
struct KlartextRestart<'r, 'a> {
    texts: &'r KlartextTexts<'a>,
    source: SourceText<'a>,
    place: BeginPlace,
    /// The first block after the program's own first lines.
    first: usize,
    line: u32,
}

impl KlartextRestart<'_, '_> {
    /// The byte up to which the text stays as it is.
    fn kept(&self) -> u32 {
        self.source.blocks.get(self.first).map_or(0, |own| own.lines.start)
    }

    /// What holds before the block, where the main program carries it out once.
    fn state_of<'s>(&self, run: &'s WatchedRun) -> Result<&'s StateAtBlock, RestartFault> {
        if let (Some(caller), None) = (run.caller, &run.state) {
            let help = format!("begin at line {caller}, which calls it");
            return Err(fault(RestartObstacle::Called, "the line is in a called subprogram", help));
        }
        let Some(state) = &run.state else {
            let what = "the run never comes to this line";
            let help =
                "name a line that is carried out; of a contour of cycle 14 that of the cycle";
            return Err(fault(RestartObstacle::NoBlock, what, help));
        };
        if !run.has_begun || self.place.from <= self.kept() {
            return Err(fault(RestartObstacle::Beginning, "the program begins there", RUN_IT));
        }
        if run.times > 1 {
            let what = format!("the line is carried out {} times", run.times);
            let help = "begin before the label of the repeat, the jump or the call";
            return Err(fault(RestartObstacle::Repeated, what, help));
        }
        Ok(state)
    }

    /// Refuses what no head brings back.
    fn check_open(&self, state: &StateAtBlock) -> Result<(), RestartFault> {
        let begun = |obstacle, what: &str, line: Option<u32>| {
            let help = match line {
                Some(line) => format!("begin at line {line}, where that begins, or before"),
                None => "begin before it".into(),
            };
            Err(fault(obstacle, what, help))
        };
        if state.modal.side != CompensationSide::Off {
            let what = "radius compensation (RL or RR) is on";
            return begun(RestartObstacle::Compensation, what, state.noted.compensation);
        }
        if state.noted.frame.is_some() {
            let what = "a tilted plane, M128 or TCPM is in force";
            return begun(RestartObstacle::Frame, what, state.noted.frame);
        }
        Ok(())
    }

    /// The blocks that set the parameters which the rest reads.
    fn parameters(
        &self,
        state: &StateAtBlock,
        sections: &[Range<usize>],
    ) -> Result<Vec<String>, RestartFault> {
        let mut reads = BTreeSet::new();
        let rest = self.place.at..self.source.blocks.len();
        for at in sections.iter().cloned().chain([rest]).flatten() {
            add_reads(self.source.text, &self.source.blocks[at].parts, &mut reads);
        }
        let called = self.texts.texts.iter().filter(|text| text.file != FileId(0));
        for text in called.map(|own| self.texts.text(own.file)) {
            for lines in LineReader::new(text) {
                add_reads(text, &lines.parts, &mut reads);
            }
        }
        let mut lines = Vec::new();
        for name in reads {
            lines.extend(parameter_line(state, name)?);
        }
        Ok(lines)
    }

    /// Q parameters that no program here names or has set, for places with more decimals than a block takes.
    fn free_parameters(&self, state: &StateAtBlock) -> Vec<u32> {
        let mut named = BTreeSet::new();
        for text in self.texts.texts.iter().map(|own| self.texts.text(own.file)) {
            for lines in LineReader::new(text) {
                add_names(text, &lines.parts, &mut named);
            }
        }
        let is_free = |number: &u32| {
            let name = ParameterName { bank: ParameterBank::Shared, number: *number };
            !named.contains(&name) && !state.parameters.is_set(name)
        };
        FREE_PARAMETERS.rev().filter(is_free).collect()
    }

    fn written(
        &self,
        state: &StateAtBlock,
        sections: &[Range<usize>],
        end: EndReason,
    ) -> Result<RestartedText, RestartFault> {
        let calls_tool = match self.source.statement(self.place.at) {
            KlartextStatement::ToolCall(words) => words.tool.is_some(),
            _ => false,
        };
        let parameters = self.parameters(state, sections)?;
        let free_parameters = self.free_parameters(state);
        let head = KlartextHeadWriter { state, parameters, free_parameters, calls_tool };
        let lines = head.lines().map_err(|HeadFault(what)| {
            let help = "begin at another line, best at a TOOL CALL";
            fault(RestartObstacle::Form, what, help)
        })?;
        let mut text = RestartText::new(&self.source, self.kept());
        text.put(&format!("; BEGINS AT LINE {} OF {}", self.line, self.file()));
        // After M2 or M30 nothing runs into subprograms; otherwise they are jumped over.
        let is_after_end = end == EndReason::ProgramEnd;
        if !sections.is_empty() && !is_after_end {
            let label = self.source.free_label();
            text.put(&format!("FN 9: IF +0 EQU +0 GOTO LBL {label}"));
            text.copy(sections);
            text.put(&format!("LBL {label}"));
        }
        lines.iter().for_each(|line| text.put(line));
        let begin = text.text.len() as u32;
        let close = self.close_of_program();
        text.append(self.place.from, close);
        if is_after_end {
            text.copy(sections);
        }
        text.append(close, self.source.text.len() as u32);
        Ok(RestartedText {
            text: text.text,
            head: lines,
            kept: self.kept(),
            begins: [self.place.from, begin],
            block: self.source.blocks[self.place.at].block.range.start,
            moved: text.moved,
            approaches: head.approaches(),
            unrepeated: state.noted.functions.unrepeated.clone(),
            free_items: FREE_ITEMS,
        })
    }

    /// The byte at which the line of END PGM begins, or the end of the text.
    fn close_of_program(&self) -> u32 {
        let is_end =
            |at: &usize| matches!(self.source.statement(*at), KlartextStatement::End { .. });
        let end = (self.place.at..self.source.blocks.len()).rev().find(is_end);
        end.map_or(self.source.text.len() as u32, |at| self.source.blocks[at].lines.start)
    }

    /// The name of the file.
    fn file(&self) -> String {
        let name = self.texts.sources.get(FileId(0)).map_or("", |source| source.name());
        let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
        format!("{}.{}", file_stem(name), ending.to_ascii_uppercase())
    }
}

/// The block that sets a parameter to its value; nothing where it has none.
fn parameter_line(
    state: &StateAtBlock,
    name: ParameterName,
) -> Result<Option<String>, RestartFault> {
    if name.bank == ParameterBank::Text {
        let text = state.parameters.text(name.number);
        return Ok(text.map(|text| format!("DECLARE STRING {name} = \"{text}\"")));
    }
    // Those of the control itself come by themselves.
    if name.is_of_control() {
        return Ok(None);
    }
    if state.parameters.was_lost(name) {
        let what = format!("the value of {name}, which is read after the line, is not known");
        let help = "begin before the block that sets it, or set it to a number in the program";
        return Err(fault(RestartObstacle::Unsure, what, help));
    }
    let value = state.parameters.number(name).filter(|_| state.parameters.is_set(name));
    Ok(value.map(|value| format!("FN 0: {name} = {}", parameter_number(value))))
}

/// A text that is put together.
struct RestartText<'s, 'a> {
    source: &'s SourceText<'a>,
    text: Vec<u8>,
    line_end: &'static str,
    moved: Vec<(Range<u32>, u32)>,
}

impl<'s, 'a> RestartText<'s, 'a> {
    /// The first bytes of the old text.
    fn new(source: &'s SourceText<'a>, kept: u32) -> RestartText<'s, 'a> {
        let crlf = source.text.windows(2).any(|pair| pair == b"\r\n");
        RestartText {
            source,
            text: source.text[..kept as usize].to_vec(),
            line_end: if crlf { "\r\n" } else { "\n" },
            moved: Vec::new(),
        }
    }

    fn put(&mut self, line: &str) {
        let line = line.replace("\r\n", "\n").replace('\n', self.line_end);
        self.text.extend_from_slice(line.as_bytes());
        self.text.extend_from_slice(self.line_end.as_bytes());
    }

    fn append(&mut self, from: u32, to: u32) {
        self.text.extend_from_slice(&self.source.text[from as usize..to.max(from) as usize]);
    }

    /// Copies blocks.
    fn copy(&mut self, sections: &[Range<usize>]) {
        for blocks in sections {
            let from = self.source.blocks[blocks.start].lines.start;
            let to = self.source.blocks[blocks.end - 1].lines.end;
            if !self.text.ends_with(b"\n") {
                self.put("");
            }
            self.moved.push((from..to, self.text.len() as u32));
            self.append(from, to);
        }
    }
}
