//! A program of one control for another.
//!
//! `source` finds the parts of the text, `trace` runs it block by block, `structure` decides where
//! subprograms go, `translate` and what it calls put the words of a block into those of the new
//! control, `macros` its statements, `emit` writes blocks from what they do where there are no such words, `plan` decides
//! which of the two it is, `layout` puts the text together. The comparison of both programs has the
//! last word: what moves otherwise is written out, until nothing does.
//!
//! Where one of the controls does not read word-address blocks, `posting` writes the program from its run.

mod arcs;
mod axis_positions;
mod certify;
pub(crate) mod codes;
mod comments;
mod context;
mod contours;
mod corners;
mod cycles;
mod draft;
mod emit;
mod feed;
mod frames;
mod initial;
mod layout;
mod live;
mod macros;
pub(crate) mod numbers;
mod offsets;
mod passes;
mod pecks;
mod plan;
mod posting;
mod rendering;
mod spiral;
mod structure;
mod surface;
mod tap;
mod target;
mod thread;
mod trace;
mod translate;
mod turning;

use std::collections::BTreeMap;

use chordal::control::{ControlTable, RotarySurface, table};
use chordal::machine::AXIS_LETTERS;
use chordal::{CommandKind, Diagnostic, Job, Machine, Severity, Source as Text, SourceMap};
use chordal_compare::{Category, ComparisonVerdict, Difference};

use self::certify::{FreeCycleLines, LIMITS, ProofTerms, proof};
use self::context::ConvertContext;
pub(crate) use self::contours::{CycleContour, CycleContours};
use self::layout::TextLayout;
use self::live::LiveTools;
use self::macros::MacroConverter;
pub use self::passes::{PassChange, PassReading};
pub use self::pecks::{PeckChange, PeckReading};
use self::plan::ConvertPlan;
use self::rendering::RenderedPlan;
use self::structure::ProgramStructure;
use self::target::with_tables_of;
use self::trace::ProgramTrace;
pub(crate) use self::turning::station;
use crate::sides::prove_other_sides;
use crate::source::SourceBlocks;
use crate::word_address::BlockControl;
use crate::{Certificate, Change};

/// How a program is converted.
#[derive(Clone, Debug)]
pub struct ConversionOptions {
    /// What the new path may be away from the old one where a form must be written out, mm.
    pub tolerance_mm: f64,
    /// Digits after the point of computed words; without, those that the control keeps.
    pub digits: Option<usize>,
    /// Problems that the program has on its own control do not keep it from being converted.
    pub despite_errors: bool,
    /// Positions of the axes are written where the program gives those of the tip of the tool (tool centre point control,
    /// tilted planes), on the same control too. On another control they always are.
    pub axis_positions: bool,
    /// A cycle whose pecks the new control makes in other steps is written out as moves; without it,
    /// the cycle stays and what differs is reported.
    pub exact_cycles: bool,
}

impl Default for ConversionOptions {
    fn default() -> ConversionOptions {
        ConversionOptions {
            tolerance_mm: 0.005,
            digits: None,
            despite_errors: false,
            axis_positions: false,
            exact_cycles: false,
        }
    }
}

/// A block that cannot be carried over.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConvertRefusal {
    /// Its line in the old text, from 1; 0 for the program as a whole.
    pub line: u32,
    /// Its words.
    pub words: String,
    /// Why, for people.
    pub reason: String,
}

impl ConvertRefusal {
    /// The refusal of the program as a whole.
    fn of_program(reason: impl Into<String>) -> ConvertRefusal {
        ConvertRefusal { line: 0, words: String::new(), reason: reason.into() }
    }
}

/// Why nothing is converted to a machine whose control does not know its settings.
const UNKNOWN_SETTINGS: &str = "the machine file has settings that the control does not have";

/// A program for another control.
#[derive(Debug)]
pub struct Conversion {
    /// The new text.
    pub text: String,
    /// What was changed, in the order of the old text.
    pub changes: Vec<Change>,
    /// What could not be carried over; with any, the text is not to be used.
    pub refusals: Vec<ConvertRefusal>,
    /// The new program on its machine compared with the old one on its own.
    pub certificate: Option<Certificate>,
    /// Cycles that were kept although the new control makes their pecks in other steps.
    pub pecks: Vec<PeckChange>,
    /// Cycles of lathes that were kept although the new control cuts them in other passes.
    pub passes: Vec<PassChange>,
    /// The job of the new text: the target machine with the tools and work offsets of the old one.
    pub machine: Machine,
}

impl Conversion {
    /// The text may be used: nothing was refused and the proof holds.
    pub fn holds(&self) -> bool {
        self.refusals.is_empty() && self.certificate.as_ref().is_some_and(Certificate::holds)
    }

    /// The new text as a program on the machine that it was proved on; nothing where that has settings that
    /// its control does not know.
    pub fn job(&self, name: &str) -> Option<Job<'static>> {
        job(name, self.text.clone(), &self.machine)
    }
}

fn job(name: &str, text: String, machine: &Machine) -> Option<Job<'static>> {
    let mut sources = SourceMap::new();
    sources.add(Text::new(name.to_string(), text.into_bytes()));
    Job::new(sources, machine.clone()).ok()
}

/// Rounds of writing out what differs. Each writes out more blocks, so that there is an end anyway.
const MAX_ROUNDS: usize = 8;

/// Differences of one round that are followed.
const MAX_FOLLOWED: usize = 200;

/// Writes a program for another machine.
pub fn convert(old: &Job, target: &Machine, options: &ConversionOptions) -> Conversion {
    let mut conversion = Conversion {
        text: String::new(),
        changes: Vec::new(),
        refusals: Vec::new(),
        certificate: None,
        pecks: Vec::new(),
        passes: Vec::new(),
        machine: target.clone(),
    };
    let controls = [old.machine().control, target.control];
    let [Some(from), Some(to)] = controls.map(table) else {
        posting::convert_by_run(old, options, &mut conversion);
        return conversion;
    };
    conversion.machine = with_tables_of(old, target, [from, to]);
    conversion.refusals =
        other_kind([from, to]).map_or_else(|| own_problems(old, options), |refusal| vec![refusal]);
    let Some(empty) = job("", String::new(), &conversion.machine) else {
        conversion.refusals.push(ConvertRefusal::of_program(UNKNOWN_SETTINGS));
        return conversion;
    };
    if conversion.refusals.is_empty() {
        conversion.refusals.extend(other_diameters(old, &conversion.machine));
    }
    if !conversion.refusals.is_empty() {
        return conversion;
    }
    let source = SourceBlocks::of(old);
    let mut trace = ProgramTrace::of(old, &source);
    let axes = axis_positions::compared_axes(&trace, [old.machine(), &conversion.machine], options);
    if let Some(axes) = &axes {
        conversion.refusals =
            axis_positions::write_axes(&mut trace, old, &conversion.machine, axes);
    }
    conversion.refusals.extend(missing_axes(old, &conversion.machine, &trace));
    if !conversion.refusals.is_empty() {
        return conversion;
    }
    let (from, to) = (old.control(), empty.control());
    let structure = ProgramStructure::of(&source, from, to);
    let macros = MacroConverter::of(&source, [from, to]);
    let contours = CycleContours::of(&source, old);
    let live = LiveTools::of(&source, &trace, [from, to]);
    let context = ConvertContext {
        source: &source,
        trace: &trace,
        structure: &structure,
        from,
        to,
        macros: &macros,
        contours: &contours,
        live: &live,
        x_factor: conversion.machine.written_factor(0),
        keeps_rotations: frames::keeps_rotations(&source, from, to),
        keeps_corners: corners::keeps_corners(&source, &trace, from, to),
        exact_cycles: options.exact_cycles,
        writes_axes: axes.is_some(),
        switches_to_axes: axis_positions::switches_to_axes(
            [old.machine(), &conversion.machine],
            axes.is_some(),
        ),
    };
    let mut plan = ConvertPlan::new(&context, options);
    // Writing out more may end worse than before: the nearest attempt is the one that is shown.
    let mut best = usize::MAX;
    let mut terms = ProofTerms { axes, ..ProofTerms::default() };
    let mut tried: BTreeMap<u32, ConvertRefusal> = BTreeMap::new();
    for round in 0..MAX_ROUNDS {
        let RenderedPlan { lines, changes, refusals, printed, unwritten } = plan.render();
        let layout = layout::lay_out(&source, &structure, lines, [from, to]);
        let Some(new) = job("converted", layout.text.clone(), &conversion.machine) else { break };
        let free = match options.exact_cycles {
            true => FreeCycleLines::default(),
            false => FreeCycleLines {
                pecks: pecks::lines(&context, &plan, &layout),
                passes: passes::lines(&context, &plan, &layout),
            },
        };
        let now = ProofTerms { free, printed, is_other_language: false, axes };
        let certificate = proof(&trace.commands, [old, &new], options, now.clone());
        let holds = certificate.holds() && refusals.is_empty();
        let more = !holds
            && round + 1 < MAX_ROUNDS
            && follow(&mut plan, &certificate, &source, &layout, round);
        for refusal in refusals.iter().chain(&unwritten) {
            tried.entry(refusal.line).or_insert_with(|| refusal.clone());
        }
        let faults = refusals.len() + certificate.comparison.differences.len();
        if holds || faults < best {
            best = faults;
            terms = now;
            conversion.text = layout.text;
            conversion.changes = changes;
            conversion.refusals = refusals;
            conversion.pecks = pecks::changes(&context, &certificate);
            conversion.passes = passes::changes(&context, &certificate);
            conversion.certificate = Some(certificate);
        }
        if !more {
            break;
        }
    }
    explain(&mut conversion, tried);
    prove_sides(&mut conversion, old, |old, new| {
        proof(&trace.commands, [old, new], options, terms.clone())
    });
    conversion
}

/// Refuses a conversion that is right for one way through the program and not for another.
fn prove_sides(conversion: &mut Conversion, old: &Job, prove: impl Fn(&Job, &Job) -> Certificate) {
    if !conversion.refusals.is_empty() {
        return;
    }
    let Some(new) = conversion.job("converted") else { return };
    let Some(mut certificate) = conversion.certificate.take() else { return };
    let before = certificate.comparison.verdict;
    let stated = prove_other_sides([old, &new], &mut certificate, prove);
    let is_different = certificate.comparison.verdict == ComparisonVerdict::Different;
    if let Some(reason) = stated.filter(|_| is_different && before != ComparisonVerdict::Different)
    {
        conversion.refusals.push(ConvertRefusal { line: 0, words: String::new(), reason });
    }
    conversion.certificate = Some(certificate);
}

/// Blocks that differ are refused where the attempt to write them out has shown why they cannot be converted.
fn explain(conversion: &mut Conversion, tried: BTreeMap<u32, ConvertRefusal>) {
    if conversion.holds() || !conversion.refusals.is_empty() {
        return;
    }
    let Some(certificate) = &conversion.certificate else { return };
    let differs = |refusal: &ConvertRefusal| {
        certificate.comparison.differences.iter().any(|difference| {
            difference.blocks[0].is_some_and(|blocks| {
                let (from, to) = blocks.lines();
                (from..=to).contains(&refusal.line)
            })
        })
    };
    conversion.refusals = tried.into_values().filter(differs).collect();
}

/// Proves another text in place of that of a conversion, one that was changed by hand: as a whole, without other steps of
/// its cycles. Nothing where the machine has settings that its control does not have.
pub fn prove_text(
    old: &Job,
    found: &Conversion,
    text: String,
    options: &ConversionOptions,
) -> Option<Certificate> {
    if old.word_address().is_none() || table(found.machine.control).is_none() {
        return posting::prove_posted(old, &found.machine, text, options);
    }
    let new = job("converted", text, &found.machine)?;
    let source = SourceBlocks::of(old);
    let trace = ProgramTrace::of(old, &source);
    let axes = axis_positions::compared_axes(&trace, [old.machine(), &found.machine], options);
    let terms = ProofTerms { axes, ..ProofTerms::default() };
    Some(proof(&trace.commands, [old, &new], options, terms))
}

/// Writes out the blocks that differ; false where there is nothing left to do.
fn follow(
    plan: &mut ConvertPlan,
    certificate: &Certificate,
    source: &SourceBlocks,
    layout: &TextLayout,
    round: usize,
) -> bool {
    let mut any = false;
    for difference in certificate.comparison.differences.iter().take(MAX_FOLLOWED) {
        let reason = format!("its words do not do the same ({})", difference.category.word());
        // What a difference begins with may be all of it: the next rounds show it.
        let all = round >= MAX_ROUNDS / 2;
        for at in blocks_of(difference, source, layout) {
            let is_new = plan.write_out(at, &reason);
            any |= is_new;
            if is_new && !all {
                break;
            }
        }
    }
    any || plan.write_all("the parts together do not do the same")
}

/// The blocks of the old text that a difference is about.
fn blocks_of(difference: &Difference, source: &SourceBlocks, layout: &TextLayout) -> Vec<usize> {
    let mut found = Vec::new();
    if let Some(at) = difference.blocks[0].filter(|_| difference.category != Category::Problem) {
        let (from, to) = at.lines();
        found.extend(source.blocks_on(from, to));
    }
    if let Some(at) = &difference.blocks[1] {
        let (from, to) = at.lines();
        let lines = layout.from.iter().skip(from as usize - 1).take((to + 1 - from) as usize);
        found.extend(lines.flatten().copied());
    }
    found
}

/// Every word of an axis that is a diameter on one of the machines alone would be another place.
fn other_diameters(old: &Job, target: &Machine) -> Option<ConvertRefusal> {
    let factors = old.machine().written_factors().into_iter().zip(target.written_factors());
    let differs = AXIS_LETTERS.chars().zip(factors).find(|(_, (from, to))| from != to);
    differs.map(|(letter, _)| ConvertRefusal {
        line: 0,
        words: String::new(),
        reason: format!(
            "{letter} is programmed as a diameter on one of the machines and as a radius on the other"
        ),
    })
}

/// Programs of lathes are for lathes, those of mills for mills.
fn other_kind(tables: [&ControlTable; 2]) -> Option<ConvertRefusal> {
    // Blocks of several codes are not written as several lines.
    if tables[1].command_line.is_some() && tables[0].command_line.is_none() {
        return Some(ConvertRefusal {
            line: 0,
            words: String::new(),
            reason: format!(
                "programs are not converted to {}, which has one command a line: choose its post",
                tables[1].title
            ),
        });
    }
    let [from, to] = tables.map(|table| if table.turns() { "lathe" } else { "mill" });
    (from != to).then(|| ConvertRefusal {
        line: 0,
        words: String::new(),
        reason: format!(
            "a program of a {from} ({}) is not converted for a {to} ({})",
            tables[0].title, tables[1].title
        ),
    })
}

/// Axes that a program of a lathe moves and the target does not have.
fn missing_axes(old: &Job, target: &Machine, trace: &ProgramTrace) -> Vec<ConvertRefusal> {
    if !old.profile().turns {
        return Vec::new();
    }
    let mut first: [Option<&chordal::Command>; 6] = [None; 6];
    let mut surface: Option<RotarySurface> = None;
    for command in &trace.commands {
        if let CommandKind::Surface { surface: now, .. } = command.kind {
            surface = now;
            // The length across is the rotary axis, whatever letter it is written with.
            if let Some(surface) = now {
                first[surface.rotary].get_or_insert(command);
            }
        }
        let Some(motion) = command.kind.motion() else { continue };
        for (axis, first) in first.iter_mut().enumerate() {
            let is_across = surface.is_some_and(|surface| surface.across == axis);
            if motion.from[axis] != motion.to[axis] && !is_across {
                first.get_or_insert(command);
            }
        }
    }
    let mut refusals = Vec::new();
    for (axis, letter) in AXIS_LETTERS.chars().enumerate() {
        let moves = first[axis].filter(|_| target.axes[axis].is_none());
        let Some(command) = moves else { continue };
        let source = old.sources().get(command.origin.span.file);
        let words =
            source.map(|source| String::from_utf8_lossy(source.line_text(command.origin.line)));
        refusals.push(ConvertRefusal {
            line: command.origin.line,
            words: words.unwrap_or_default().trim().to_string(),
            reason: format!("{} has no {letter} axis", target.name),
        });
    }
    refusals
}

/// Errors of the program on its own control.
fn own_problems(old: &Job, options: &ConversionOptions) -> Vec<ConvertRefusal> {
    own_errors(old, options).iter().map(|one| error_refusal(old, one, None)).collect()
}

/// The errors of the program on its own control, where they count.
fn own_errors(old: &Job, options: &ConversionOptions) -> Vec<Diagnostic> {
    if options.despite_errors {
        return Vec::new();
    }
    let counts = |one: &Diagnostic| one.severity == Severity::Error && !LIMITS.contains(&one.code);
    old.check().diagnostics.into_iter().filter(counts).collect()
}

/// The refusal because of an error, with what can be done about it.
fn error_refusal(old: &Job, error: &Diagnostic, help: Option<&str>) -> ConvertRefusal {
    let span = error.primary.span;
    let source = old.sources().get(span.file);
    let line = source.map_or(0, |source| source.line_of(span.range.start));
    let words = source.map(|source| String::from_utf8_lossy(source.line_text(line)));
    let help = help.map_or_else(String::new, |help| format!(" ({help})"));
    ConvertRefusal {
        line,
        words: words.unwrap_or_default().trim().to_string(),
        reason: format!("an error on the original control: {}{help}", error.message),
    }
}
