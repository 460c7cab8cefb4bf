//! Where an operator is needed, or gets a message; and the programs that run.

use std::collections::BTreeMap;

use chordal::control::{Command, CommandKind, Origin, ProgramName, ProgramPlace, ProgramSet};
use chordal::diagnostics::FileId;
use chordal::{Job, Span};

use super::text::{CommentFinder, clean, file_name, title};
use crate::data::{CalledProgram, CappedRows, OperatorStop, StopKind};

/// Stops that are reported.
const MAX_STOPS: usize = 200;
/// Programs that are reported.
const MAX_CALLED: usize = 60;

#[derive(Debug)]
struct StopOccurrence {
    kind: StopKind,
    origin: Origin,
    /// The words of a message.
    message: Option<Span>,
    tool: u32,
    times: u64,
}

/// Watches for stops.
#[derive(Debug, Default)]
pub struct StopWatcher {
    seen: Vec<StopOccurrence>,
    by_place: BTreeMap<(StopKind, u32, u32), usize>,
    left_out: u64,
}

impl StopWatcher {
    /// Follows a command as programmed.
    pub fn programmed(&mut self, command: &Command, tool: u32) {
        let origin = command.origin;
        let (kind, message) = match &command.kind {
            CommandKind::Stop { optional: false } => (StopKind::Stop, None),
            CommandKind::Stop { optional: true } => (StopKind::OptionalStop, None),
            CommandKind::Message(range) => {
                (StopKind::Message, Some(range.in_file(origin.span.file)))
            }
            CommandKind::Probed { .. } => (StopKind::Probe, None),
            _ => return,
        };
        let place = (kind, origin.span.file.0, origin.span.range.start);
        if let Some(seen) = self.by_place.get(&place).and_then(|at| self.seen.get_mut(*at)) {
            seen.times += 1;
        } else if self.seen.len() < MAX_STOPS {
            self.by_place.insert(place, self.seen.len());
            self.seen.push(StopOccurrence { kind, origin, message, tool, times: 1 });
        } else {
            self.left_out += 1;
        }
    }

    /// The stops with the comments next to them.
    pub fn finish(&self, job: &Job, comments: &CommentFinder) -> CappedRows<OperatorStop> {
        let of_stop = |seen: &StopOccurrence| OperatorStop {
            kind: seen.kind,
            line: seen.origin.line,
            file: other_file(job, seen.origin.span.file),
            tool: seen.tool,
            text: match (seen.message, seen.kind) {
                (Some(span), _) => Some(clean(&job.sources().words(span), 200)),
                (None, StopKind::Probe) => None,
                (None, _) => comments.comment_at(&seen.origin),
            },
            times: seen.times,
        };
        CappedRows { rows: self.seen.iter().map(of_stop).collect(), left_out: self.left_out }
    }
}

/// The name of a file that is not the program's own.
pub fn other_file(job: &Job, file: FileId) -> Option<String> {
    if file == FileId(0) {
        return None;
    }
    job.sources().get(file).map(|source| file_name(source.name()))
}

/// Watches which programs run.
pub struct ProgramWatcher<'j> {
    job: &'j Job<'j>,
    programs: Box<dyn ProgramSet + 'j>,
    ran: Vec<bool>,
    /// The one that ran last.
    at: usize,
}

impl<'j> ProgramWatcher<'j> {
    pub fn new(job: &'j Job<'j>) -> ProgramWatcher<'j> {
        let programs = job.program_set();
        let ran = vec![false; programs.programs().len()];
        ProgramWatcher { job, programs, ran, at: 0 }
    }

    /// Follows a command.
    #[inline]
    pub fn see(&mut self, origin: &Origin) {
        if !self.holds(self.at, origin) {
            // Programs of a text mostly run in order.
            let count = self.ran.len();
            let mut others = (1..count).map(|step| (self.at + step) % count);
            let Some(found) = others.find(|index| self.holds(*index, origin)) else { return };
            self.at = found;
        }
        self.ran[self.at] = true;
    }

    fn holds(&self, index: usize, origin: &Origin) -> bool {
        self.programs.programs().get(index).is_some_and(|program| {
            program.file == origin.span.file && program.has(origin.span.range.start)
        })
    }

    /// The programs that a run begins with.
    pub fn mains(&self, only: Option<u32>) -> CappedRows<CalledProgram> {
        self.rows(&self.main_places(only))
    }

    /// The first of them.
    pub fn first_main(&self, only: Option<u32>) -> Option<&ProgramPlace> {
        let first = *self.main_places(only).first()?;
        self.programs.programs().get(first)
    }

    /// The others that ran.
    pub fn called(&self, only: Option<u32>) -> CappedRows<CalledProgram> {
        let mut others = self.ran.clone();
        self.main_places(only).into_iter().for_each(|main| others[main] = false);
        let others = (0..others.len()).filter(|at| others[*at]);
        self.rows(&others.collect::<Vec<usize>>())
    }

    fn main_places(&self, only: Option<u32>) -> Vec<usize> {
        match only {
            Some(number) => self.programs.find(number).into_iter().collect(),
            None => {
                let programs = self.programs.programs();
                (0..programs.len()).filter(|index| programs[*index].is_main).collect()
            }
        }
    }

    fn rows(&self, places: &[usize]) -> CappedRows<CalledProgram> {
        let rows = places.iter().take(MAX_CALLED).map(|at| {
            let program = &self.programs.programs()[*at];
            let source = self.job.sources().get(program.file);
            let text = source.map_or(&[][..], |source| source.text());
            let remark = program.key().and_then(|_| title(text, program.head.end as usize));
            // A program with a name has no number.
            let number = program.number();
            let name = program.name.as_ref().map(ProgramName::to_string);
            let name = name.filter(|_| number.is_none());
            let title = match (name, remark) {
                (Some(name), Some(remark)) => Some(format!("{name} {remark}")),
                (name, remark) => name.or(remark),
            };
            CalledProgram {
                number,
                title,
                file: other_file(self.job, program.file),
                line: program.line,
            }
        });
        CappedRows {
            rows: rows.collect(),
            left_out: places.len().saturating_sub(MAX_CALLED) as u64,
        }
    }
}
