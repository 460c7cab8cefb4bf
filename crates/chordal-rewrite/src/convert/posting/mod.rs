//! A program for a control of another language, written from its run.
//!
//! `recorded` keeps what a run does, `tables` fills the tables of machines so that runs show what positions depend on,
//! `places` finds that out, `holes` finds the holes of drilling cycles. The [`PostedProgram`] that comes out has no
//! language: a [`ProgramWriter`] of the new control writes it. `assembly` adds comments and block numbers of the old text,
//! `certificate` compares both programs. Cycles that do not make the same moves are written out, until nothing differs.

mod approaches;
mod assembly;
mod certificate;
mod holes;
mod places;
mod program_tools;
mod recorded;
mod remarks;
mod tables;
mod taps;
mod word_writer;

use std::collections::BTreeSet;

use chordal::control::{
    ConfiguredControl, Control, Origin, PostedKind, PostedProgram, PostedStep, ProgramWriter,
    StartingModes, Units, WordAddressControl, WriterNote, WriterOptions, WrittenProgram,
    control_profile,
};
use chordal::diagnostics::FileId;
use chordal::machine::{AXES, AXIS_LETTERS};
use chordal::{Code, Command, CommandKind, Diagnostic, Job, Machine, Span};
use chordal_compare::{Category, ComparisonVerdict, Difference, DifferenceValue};

use self::approaches::{LeadForm, LongerLeads, center_approaches};
use self::assembly::{AssembledText, StepLines, assemble, main_line};
use self::certificate::{ContourTwin, PostedProof, ProofOutcome};
use self::places::UnplacedCommand;
use self::program_tools::ProgramTools;
use self::recorded::RecordedRun;
use self::remarks::SourceRemarks;
use self::tables::{TableSet, UsedNumbers, with_tables_of};
use self::word_writer::WordAddressWriter;
use super::{
    Conversion, ConversionOptions, ConvertRefusal, MAX_ROUNDS, UNKNOWN_SETTINGS, error_refusal,
    other_diameters, own_errors,
};
use crate::word_address::other_language;
use crate::{Certificate, Change};

/// Converts a program by its run; the refusals and the text go into `conversion`.
pub(super) fn convert_by_run(old: &Job, options: &ConversionOptions, conversion: &mut Conversion) {
    if let Err(refusals) = converted(old, options, conversion) {
        conversion.refusals = refusals;
    }
}

/// Proves another text in place of that of a conversion.
pub(super) fn prove_posted(
    old: &Job,
    machine: &Machine,
    text: String,
    options: &ConversionOptions,
) -> Option<Certificate> {
    let used = UsedNumbers::of(old, &RecordedRun::of(old).commands);
    let tools = program_tools(old, &used).ok()?;
    let proof = PostedProof::new(old, machine, &used, &tools, options)?;
    let mut outcome = proof.of(&text, None)?;
    if !outcome.certificate.holds() {
        let posted = PostedRun::of(old, &used, options).ok()?;
        for form in LeadForm::ALL {
            let other = longer_leads(old, &posted.program, form, &proof, options);
            let other = other.and_then(|(_, twin)| proof.of(&text, Some(&twin)));
            if let Some(other) = other.filter(|other| other.certificate.holds()) {
                outcome = other;
                break;
            }
        }
    }
    let ProofOutcome { mut certificate, other_tool_axis } = outcome;
    if other_tool_axis.is_some() {
        certificate.comparison.verdict = ComparisonVerdict::Different;
    }
    Some(certificate)
}

fn refusal(reason: impl Into<String>) -> Vec<ConvertRefusal> {
    vec![ConvertRefusal::of_program(reason)]
}

/// The refusal of a line of the old text.
fn line_refusal(old: &Job, file: FileId, line: u32, reason: impl Into<String>) -> ConvertRefusal {
    ConvertRefusal { line, words: words_of_line(old, file, line), reason: reason.into() }
}

/// The words of a line of the old text.
fn words_of_line(old: &Job, file: FileId, line: u32) -> String {
    let source = old.sources().get(file);
    let words = source.map(|source| String::from_utf8_lossy(source.line_text(line)));
    words.unwrap_or_default().trim().to_string()
}

fn converted(
    old: &Job,
    options: &ConversionOptions,
    conversion: &mut Conversion,
) -> Result<(), Vec<ConvertRefusal>> {
    conversion.machine = with_tables_of(old, &conversion.machine);
    let machine = conversion.machine.clone();
    let empty = super::job("", String::new(), &machine).ok_or_else(|| {
        match control_profile(machine.control) {
            Some(_) => refusal(UNKNOWN_SETTINGS),
            None => refusal(other_language(machine.control)),
        }
    })?;
    let writer = writer_of(empty.configured_control())
        .ok_or_else(|| refusal(other_language(machine.control)))?;
    check_kinds(old, &empty)?;
    if let Some(differs) = other_diameters(old, &machine) {
        return Err(vec![differs]);
    }
    let errors = own_errors(old, options);
    if !errors.is_empty() {
        let refusal =
            |error: &Diagnostic| error_refusal(old, error, advice_on(error, old.machine()));
        return Err(errors.iter().map(refusal).collect());
    }
    let remarks = single_program(old)?;
    check_verified(old)?;
    let used = UsedNumbers::of(old, &RecordedRun::of(old).commands);
    let tools = program_tools(old, &used)?;
    tools.put_into(&mut conversion.machine);
    let posted = PostedRun::of(old, &used, options)?;
    check_axes(old, &machine, &posted)?;
    check_tools(old, &posted)?;
    let proof = PostedProof::new(old, &machine, &used, &tools, options)
        .ok_or_else(|| refusal(UNKNOWN_SETTINGS))?;
    let rounds = ConversionRounds {
        old,
        writer: &*writer,
        remarks: &remarks,
        posted: &posted,
        program: &posted.program,
        tools: &tools,
        proof: &proof,
        twin: None,
        options,
    };
    let found = rounds.run()?;
    let found = match found.holds() {
        true => found,
        false => match rounds.run_with_longer_leads() {
            Some(found) => found,
            None => {
                rounds.check_leads(&found)?;
                found
            }
        },
    };
    (conversion.text, conversion.changes) = (found.text, found.changes);
    conversion.certificate = found.certificate;
    Ok(())
}

/// What can be done about an error on a machine.
fn advice_on<'d>(error: &'d Diagnostic, machine: &Machine) -> Option<&'d str> {
    const OTHER_MACHINE: &str = "name the machine that the program was written for with --machine: its file says which rotary axes it has";
    let turns = machine.axes[3..].iter().any(Option::is_some);
    let needs_rotary = matches!(error.code, Code::TiltedPlane | Code::NoSuchAxis);
    error.help.as_deref().or((needs_rotary && !turns).then_some(OTHER_MACHINE))
}

/// What the program says about its tools.
fn program_tools(old: &Job, used: &UsedNumbers) -> Result<ProgramTools, Vec<ConvertRefusal>> {
    let run = |tables: TableSet| -> Result<Vec<Command>, Vec<ConvertRefusal>> {
        let machine = tables.fill(old.machine(), old.profile(), used);
        let job = old.on_machine(machine).map_err(|error| refusal(error.to_string()))?;
        Ok(RecordedRun::of(&job).commands)
    };
    let (without, with) = (run(TableSet::WITHOUT_LENGTHS)?, run(TableSet::FIRST)?);
    ProgramTools::of(old, used, [&without, &with]).map_err(|conflict| {
        let origin = conflict.origin;
        vec![line_refusal(old, origin.span.file, origin.line, conflict.reason)]
    })
}

/// The writer of a control; `None` where programs of other languages are not converted to it.
fn writer_of(control: &dyn ConfiguredControl) -> Option<Box<dyn ProgramWriter + '_>> {
    match WordAddressControl::tables(control) {
        Some(control) if may_be_written(control) => Some(Box::new(WordAddressWriter { control })),
        Some(_) => None,
        None => control.program_writer(),
    }
}

/// Blocks of several codes are not written as several lines.
fn may_be_written(control: &Control) -> bool {
    control.table.command_line.is_none()
}

fn check_kinds(old: &Job, new: &Job) -> Result<(), Vec<ConvertRefusal>> {
    let [from, to] = [old, new].map(Job::profile);
    match from.turns || to.turns {
        true => Err(refusal(format!(
            "programs of lathes are not converted between {} and {}",
            from.title, to.title
        ))),
        false => Ok(()),
    }
}

/// A tool that has a name in the program, and no number in the machine file, is tool 0 of the run.
fn check_tools(old: &Job, posted: &PostedRun) -> Result<(), Vec<ConvertRefusal>> {
    let mut is_without_number = false;
    for (step, origin) in posted.program.steps.iter().zip(&posted.origins) {
        let cuts = match &step.kind {
            PostedKind::Command(CommandKind::Tool { number }) => {
                is_without_number = *number == 0;
                false
            }
            PostedKind::Command(command) => command.feed().is_some(),
            PostedKind::Hole(_) | PostedKind::Tap(_) => true,
            PostedKind::MachineMove { .. } => false,
        };
        if is_without_number && cuts {
            let reason = "the tool that cuts here has no number: a tool with a name needs one with this `description` in [tools] of the machine file";
            return Err(vec![line_refusal(old, origin.span.file, origin.line, reason)]);
        }
    }
    Ok(())
}

/// Axes that the program moves and the target does not have.
fn check_axes(old: &Job, target: &Machine, posted: &PostedRun) -> Result<(), Vec<ConvertRefusal>> {
    let is_missing = |step: &PostedStep| {
        let PostedKind::Command(command) = &step.kind else { return None };
        let motion = command.motion()?;
        (0..AXES)
            .find(|axis| target.axes[*axis].is_none() && motion.from[*axis] != motion.to[*axis])
    };
    let found = posted.program.steps.iter().zip(&posted.origins);
    let missing = found.filter_map(|(step, origin)| Some((is_missing(step)?, *origin)));
    match missing.into_iter().next() {
        Some((axis, origin)) => {
            let letter = char::from(AXIS_LETTERS.as_bytes()[axis]);
            let reason = format!("{} has no {letter} axis", target.name);
            Err(vec![line_refusal(old, origin.span.file, origin.line, reason)])
        }
        None => Ok(()),
    }
}

/// The comments of the only program of the text.
fn single_program(old: &Job) -> Result<SourceRemarks, Vec<ConvertRefusal>> {
    let programs = old.program_set();
    let mains = old.mains(&*programs);
    let [main] = mains[..] else {
        return Err(refusal(
            "the text has several programs, each of which begins by itself: choose one",
        ));
    };
    let remarks = SourceRemarks::of(old, main);
    match remarks.deletable {
        Some(line) => Err(vec![line_refusal(
            old,
            FileId(0),
            line,
            "block delete (/) decides at the machine what runs, and a program that is written from its run has one way only: take the slash away, or the block, and convert again",
        )]),
        None => Ok(remarks),
    }
}

/// Nothing is claimed of a run that is not verified.
fn check_verified(old: &Job) -> Result<(), Vec<ConvertRefusal>> {
    let report = old.report();
    if report.verified() {
        return Ok(());
    }
    let is_reason = |one: &&Diagnostic| one.code.loses_path(one.severity) || one.code.loses_time();
    let Some(reason) = report.diagnostics.iter().find(is_reason) else {
        return Err(refusal("the run of the program is not verified"));
    };
    let span = reason.primary.span;
    let line = old.sources().get(span.file).map_or(0, |source| source.line_of(span.range.start));
    let advice = match reason.code {
        Code::CyclePathAssumed => "what is assumed cannot be proved, so write these moves out in the program, or take a cycle of the new control".to_string(),
        _ => reason.help.clone().unwrap_or_default(),
    };
    let advice = if advice.is_empty() { advice } else { format!("; {advice}") };
    let reason = format!("the run of the program is not verified: {}{advice}", reason.message);
    Err(vec![line_refusal(old, span.file, line, reason)])
}

/// A run as a program in no language.
struct PostedRun {
    program: PostedProgram,
    /// The block of each step.
    origins: Vec<Origin>,
    carried_out: BTreeSet<u32>,
    /// The blocks of the main program that call something, in the order of their first run.
    callers: Vec<Span>,
}

impl PostedRun {
    fn of(
        old: &Job,
        used: &UsedNumbers,
        options: &ConversionOptions,
    ) -> Result<PostedRun, Vec<ConvertRefusal>> {
        let on = |tables: TableSet| {
            let machine = tables.fill(old.machine(), old.profile(), used);
            old.on_machine(machine).map_err(|error| refusal(error.to_string()))
        };
        let jobs = [on(TableSet::FIRST)?, on(TableSet::SECOND)?];
        let [one, other] = [RecordedRun::of(&jobs[0]), RecordedRun::of(&jobs[1])];
        let placed =
            places::placed_commands([&jobs[0], &jobs[1]], [&one, &other], options.tolerance_mm);
        let refuse = |unplaced: UnplacedCommand| {
            let origin = one.commands.get(unplaced.index).map(|command| command.origin);
            let origin = origin.unwrap_or_default();
            vec![line_refusal(old, origin.span.file, origin.line, unplaced.reason)]
        };
        let placed = placed.map_err(refuse)?;
        let (steps, first): (Vec<PostedStep>, Vec<usize>) =
            holes::steps_with_holes(&placed, &one.commands).map_err(refuse)?.into_iter().unzip();
        let origins = first.into_iter().map(|index| one.commands[index].origin).collect();
        let programs = old.programs();
        let main = programs.iter().find(|program| program.is_main);
        let name = main.and_then(|program| Some(program.name.as_ref()?.to_string()));
        // A name of digits is a number to controls that number their programs.
        let of_name: Option<u32> = name.as_deref().and_then(|name| name.parse().ok());
        let number = main.and_then(|program| program.number()).or(of_name);
        let name = name.filter(|_| of_name.is_none());
        let program = PostedProgram { number, name, start: starting_modes(old, &steps), steps };
        let callers = one.callers();
        Ok(PostedRun { program, origins, carried_out: one.main_lines, callers })
    }
}

/// What is active before the first step; the units are those of the first move, which all words before can have.
fn starting_modes(old: &Job, steps: &[PostedStep]) -> StartingModes {
    let rules = old.rules();
    let before_moves = steps.iter().map_while(|step| match &step.kind {
        PostedKind::Command(command) if command.motion().is_none() => Some(command),
        PostedKind::Command(_)
        | PostedKind::MachineMove { .. }
        | PostedKind::Hole(_)
        | PostedKind::Tap(_) => None,
    });
    let units = before_moves.filter_map(|command| {
        let CommandKind::Units(units) = command else { return None };
        Some(*units)
    });
    let units: Option<Units> = units.last();
    StartingModes {
        units: units.unwrap_or(rules.units),
        plane: rules.starts_in,
        feed_mode: rules.starting_feed_mode(),
        work: old.initial_work_offset().ordinal(),
    }
}

/// Why an approach is written in another way than its path of the tool centre.
const LONGER_LEAD: &str = "compensation begins with the line before the approach: the new control needs a lead-in that is longer than the radius";

/// A program with its approaches as parts of compensated contours, and the same on the old machine; `None` where there are no
/// such approaches, or where the tool centre goes otherwise with them.
fn longer_leads(
    old: &Job,
    program: &PostedProgram,
    form: LeadForm,
    proof: &PostedProof<'_>,
    options: &ConversionOptions,
) -> Option<(LongerLeads, ContourTwin)> {
    let leads = LongerLeads::of(program, form)?;
    let writer = writer_of(old.configured_control())?;
    let writing = WriterOptions {
        // Cycles have no contours.
        written_out: (0..program.steps.len()).collect(),
        digits: options.digits,
        tolerance_mm: options.tolerance_mm,
    };
    let written = writer.write(&leads.program, &writing);
    if !written.refusals.is_empty() {
        return None;
    }
    let remarks = SourceRemarks::default();
    let lines = StepLines { remarks: &remarks, carried_out: &BTreeSet::new(), lines: Vec::new() };
    let text = assemble(&*writer, &written, &lines).text;
    Some((leads, proof.contour_twin(old, text)?))
}

/// Why an approach cannot be written.
const SHORT_LEAD: &str = "this approach leads the tool centre to the contour, and compensation begins there with a lead-in as long as the radius: the new control needs a longer one, so begin the approach further away from the contour, or approach with RL or RR on a line that is longer than the radius";

/// A text that was written, with its proof.
#[derive(Default)]
struct PostedText {
    text: String,
    changes: Vec<Change>,
    certificate: Option<Certificate>,
}

impl PostedText {
    fn holds(&self) -> bool {
        self.certificate.as_ref().is_some_and(Certificate::holds)
    }
}

/// Writes and compares, until nothing differs or nothing is left to write out.
struct ConversionRounds<'a> {
    old: &'a Job<'a>,
    writer: &'a dyn ProgramWriter,
    remarks: &'a SourceRemarks,
    posted: &'a PostedRun,
    /// What is written: the steps of the run, or the same with other approaches.
    program: &'a PostedProgram,
    tools: &'a ProgramTools,
    proof: &'a PostedProof<'a>,
    /// Where the contours are those of other approaches.
    twin: Option<&'a ContourTwin>,
    options: &'a ConversionOptions,
}

impl ConversionRounds<'_> {
    fn run(&self) -> Result<PostedText, Vec<ConvertRefusal>> {
        let mut options = WriterOptions {
            written_out: BTreeSet::new(),
            digits: self.options.digits,
            tolerance_mm: self.options.tolerance_mm,
        };
        for round in 0..MAX_ROUNDS {
            let written = self.writer.write(self.program, &options);
            let refusals = self.refusals(&written);
            if !refusals.is_empty() {
                return Err(refusals);
            }
            let text = self.text(&written);
            let outcome =
                self.proof.of(&text.text, self.twin).ok_or_else(|| refusal(UNKNOWN_SETTINGS))?;
            let holds = outcome.certificate.holds() && outcome.other_tool_axis.is_none();
            let before = options.written_out.len();
            if !holds {
                self.follow(&outcome, &text, &mut options.written_out, round);
            }
            let goes_on = options.written_out.len() > before && round + 1 < MAX_ROUNDS;
            if goes_on {
                continue;
            }
            if let Some(reason) = outcome.other_tool_axis.filter(|_| outcome.certificate.holds()) {
                return Err(refusal(reason));
            }
            let changes = self.changes(&written);
            let certificate = Some(outcome.certificate);
            return Ok(PostedText { text: text.text, changes, certificate });
        }
        Ok(PostedText::default())
    }

    /// Writes approaches as parts of compensated contours; `None` where the program does not hold with them.
    fn run_with_longer_leads(&self) -> Option<PostedText> {
        LeadForm::ALL.into_iter().find_map(|form| {
            let (leads, twin) =
                longer_leads(self.old, self.program, form, self.proof, self.options)?;
            let rounds = ConversionRounds { program: &leads.program, twin: Some(&twin), ..*self };
            let mut found = rounds.run().ok().filter(PostedText::holds)?;
            found.changes.extend(leads.steps.iter().map(|step| self.lead_change(*step)));
            found.changes.sort_by_key(|change| change.line);
            found.changes.dedup();
            Some(found)
        })
    }

    /// A text with lead-ins that its control does not take is no use to anybody.
    fn check_leads(&self, found: &PostedText) -> Result<(), Vec<ConvertRefusal>> {
        let differences = found.certificate.iter().flat_map(|one| &one.comparison.differences);
        let is_short = |difference: &Difference| {
            matches!(
                &difference.values,
                Some([DifferenceValue::Nothing, DifferenceValue::Text(text)])
                    if difference.category == Category::Problem
                        && text.starts_with(Code::LeadInTooShort.id())
            )
        };
        if !differences.into_iter().any(is_short) {
            return Ok(());
        }
        let refusals: Vec<ConvertRefusal> = center_approaches(self.program)
            .into_iter()
            .filter_map(|step| self.posted.origins.get(step))
            .map(|origin| line_refusal(self.old, origin.span.file, origin.line, SHORT_LEAD))
            .collect();
        if refusals.is_empty() { Ok(()) } else { Err(refusals) }
    }

    /// What was changed at an approach.
    fn lead_change(&self, step: usize) -> Change {
        let origin = self.posted.origins.get(step).copied().unwrap_or_default();
        Change {
            line: origin.line,
            before: words_of_line(self.old, origin.span.file, origin.line),
            after: String::new(),
            reason: LONGER_LEAD.to_string(),
        }
    }

    fn text(&self, written: &WrittenProgram) -> AssembledText {
        let lines = StepLines {
            remarks: self.remarks,
            carried_out: &self.posted.carried_out,
            lines: self.posted.origins.iter().map(main_line).collect(),
        };
        assemble(self.writer, written, &lines)
    }

    /// Writes out the cycles of the lines that differ, and after some rounds all of them.
    fn follow(
        &self,
        outcome: &ProofOutcome,
        text: &AssembledText,
        written_out: &mut BTreeSet<usize>,
        round: usize,
    ) {
        let steps = &self.program.steps;
        let is_hole = |step: &usize| matches!(steps[*step].kind, PostedKind::Hole(_));
        let before = written_out.len();
        for difference in &outcome.certificate.comparison.differences {
            let Some(blocks) = &difference.blocks[1] else { continue };
            for step in text.steps_of(blocks.lines()) {
                // The line of a move to a hole, or that of the hole itself.
                written_out.extend(
                    [step, step + 1].into_iter().filter(|step| *step < steps.len()).filter(is_hole),
                );
            }
        }
        if written_out.len() == before || round + 2 >= MAX_ROUNDS {
            written_out.extend((0..steps.len()).filter(is_hole));
        }
    }

    fn refusals(&self, written: &WrittenProgram) -> Vec<ConvertRefusal> {
        let refusal = |note: &WriterNote| {
            let origin = self.posted.origins.get(note.step).copied().unwrap_or_default();
            line_refusal(self.old, origin.span.file, origin.line, note.reason.clone())
        };
        let mut refusals: Vec<ConvertRefusal> = written.refusals.iter().map(refusal).collect();
        refusals.dedup();
        refusals
    }

    /// What was written in another way than block by block.
    fn changes(&self, written: &WrittenProgram) -> Vec<Change> {
        let change = |note: &WriterNote| {
            let origin = self.posted.origins.get(note.step).copied().unwrap_or_default();
            Change {
                line: origin.line,
                before: words_of_line(self.old, origin.span.file, origin.line),
                after: note.words.clone(),
                reason: note.reason.clone(),
            }
        };
        let called = self.posted.callers.iter().filter_map(|span| {
            let source = self.old.sources().get(span.file)?;
            let line = source.line_of(span.range.start);
            let before = words_of_line(self.old, span.file, line);
            let reason = "what it calls is written out as it runs".to_string();
            Some(Change { line, before, after: String::new(), reason })
        });
        let of_tools = self.tools.sentences().map(|(origin, reason)| Change {
            line: origin.line,
            before: words_of_line(self.old, origin.span.file, origin.line),
            after: String::new(),
            reason,
        });
        let notes = written.notes.iter().map(change);
        let mut changes: Vec<Change> = called.chain(of_tools).chain(notes).collect();
        changes.sort_by_key(|change| change.line);
        changes.dedup();
        changes
    }
}
