//! A program of one control for another.
//!
//! `source` finds the parts of the text, `trace` runs it block by block, `structure` decides where
//! subprograms go, `translate` and what it calls put the words of a block into those of the new
//! control, `macros` its statements, `emit` writes blocks from what they do where there are no such words, `plan` decides
//! which of the two it is, `layout` puts the text together. The comparison of both programs has the
//! last word: what moves otherwise is written out, until nothing does.

mod arcs;
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
mod rendering;
mod spiral;
mod structure;
mod surface;
mod tap;
mod thread;
mod trace;
mod translate;
mod turning;

use std::collections::{BTreeMap, BTreeSet};

use chordal::control::{
    CompensationSide, RapidPath, RotarySurface, SettingField, SurfaceShape, ToolLengths,
};
use chordal::machine::{
    AXIS_LETTERS, RapidShape, SettingEntry, SettingValue, WorkOffset, mirrored_tip,
    work_offset_name,
};

use chordal::{Code, CommandKind, Job, Machine, Report, Severity, Source as Text, SourceMap};
use chordal_compare::{
    BlockRange, Category, ComparisonVerdict, Difference, DifferenceValue, FreePasses,
};

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
use self::trace::ProgramTrace;
pub(crate) use self::turning::station;
use crate::sides::prove_other_sides;
use crate::source::SourceBlocks;
use crate::{Certificate, Change, prove, prove_contour};

/// How a program is converted.
#[derive(Clone, Debug)]
pub struct ConversionOptions {
    /// What the new path may be away from the old one where a form must be written out, mm.
    pub tolerance_mm: f64,
    /// Digits after the point of computed words; without, those that the control keeps.
    pub digits: Option<usize>,
    /// Problems that the program has on its own control do not keep it from being converted.
    pub despite_errors: bool,
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

/// Whole categories of those.
const OF_MACHINES: &[Category] = &[Category::RapidPath, Category::PathMode, Category::Overrides];

/// Rounds of writing out what differs. Each writes out more blocks, so that there is an end anyway.
const MAX_ROUNDS: usize = 8;

/// Differences of one round that are followed.
const MAX_FOLLOWED: usize = 200;

/// Writes a program for another machine.
pub fn convert(old: &Job, target: &Machine, options: &ConversionOptions) -> Conversion {
    let machine = with_tables_of(old, target);
    let mut conversion = Conversion {
        text: String::new(),
        changes: Vec::new(),
        refusals: other_kind(old, target)
            .map_or_else(|| own_problems(old, options), |refusal| vec![refusal]),
        certificate: None,
        pecks: Vec::new(),
        passes: Vec::new(),
        machine,
    };
    let Some(empty) = job("", String::new(), &conversion.machine) else {
        conversion.refusals.push(ConvertRefusal {
            line: 0,
            words: String::new(),
            reason: "the machine file has settings that the control does not have".into(),
        });
        return conversion;
    };
    if conversion.refusals.is_empty() {
        conversion.refusals.extend(other_diameters(old, &conversion.machine));
    }
    if !conversion.refusals.is_empty() {
        return conversion;
    }
    let source = SourceBlocks::of(old);
    let trace = ProgramTrace::of(old, &source);
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
    };
    let mut plan = ConvertPlan::new(&context, options);
    // Writing out more may end worse than before: the nearest attempt is the one that is shown.
    let mut best = usize::MAX;
    let mut terms = (FreeCycleLines::default(), false);
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
        let certificate = proof(&trace, [old, &new], options, free.clone(), printed);
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
            terms = (free, printed);
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
        let (free, printed) = terms.clone();
        proof(&trace, [old, new], options, free, printed)
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

/// The lines of both texts whose cycles may be made in other steps.
#[derive(Clone, Default)]
struct FreeCycleLines {
    pecks: [BTreeSet<u32>; 2],
    passes: [FreePasses; 2],
}

fn proof(
    trace: &ProgramTrace,
    [old, new]: [&Job; 2],
    options: &ConversionOptions,
    free: FreeCycleLines,
    printed: bool,
) -> Certificate {
    let compensates = trace.commands.iter().any(|command| {
        matches!(command.kind, CommandKind::Compensation { side, .. } if side != CompensationSide::Off)
    });
    let compare = chordal_compare::ComparisonOptions {
        tolerance_mm: options.tolerance_mm,
        feed_tolerance: 1e-5,
        speed_tolerance: 1e-5,
        rotary_tolerance_rad: rotary_tolerance(trace, options),
        // Both begin at the same place, and both machines have the same tables.
        assume_known: true,
        separate_sides: true,
        free_pecks: free.pecks,
        free_passes: free.passes,
        kept: 100_000,
        ..chordal_compare::ComparisonOptions::default()
    };
    let surface = [old, new].map(trace::surface_lines);
    let turns = old.control().table.turns();
    // Without a tool table each tool is set to the work zero.
    let no_lengths = ![old, new].map(Job::control).into_iter().all(codes::has_lengths);
    let is_expected = |difference: &Difference| {
        is_of_machine(difference, turns)
            || (no_lengths && difference.category == Category::LengthOffset)
            || (printed && difference.category == Category::Output)
            || follows_the_diameter(difference, &surface)
            || is_left_out(difference, [old, new])
    };
    let mut certificate = if compensates {
        prove_contour(old, new, &compare, is_expected)
    } else {
        let mut certificate = prove(old, new, &compare, &[]);
        certificate.set_aside(is_expected);
        certificate
    };
    // What is not followed is not proved either way, and variables have other names.
    if !certificate.comparison.reports.iter().all(Report::verified) {
        certificate.set_aside(|difference| difference.category == Category::Value);
    }
    certificate
}

/// A code of the old control that the new one does not have, and that is among the changes; what statements and remarks
/// say to the operator.
fn is_left_out(difference: &Difference, [old, new]: [&Job; 2]) -> bool {
    match (difference.category, &difference.values) {
        (Category::Code, Some([DifferenceValue::Text(words), DifferenceValue::Nothing])) => {
            codes::is_only_of(words, old.control(), new.control())
        }
        (Category::Message | Category::Alarm | Category::Variable, _) => true,
        _ => false,
    }
}

/// How far rotary axes may be apart: on a cylinder one control gives lengths and the other one angles, and both are rounded. At its
/// radius that is no more than the tolerance.
fn rotary_tolerance(trace: &ProgramTrace, options: &ConversionOptions) -> f64 {
    let radii = trace.commands.iter().filter_map(|command| match &command.kind {
        CommandKind::Surface { surface: Some(surface), .. } => match surface.shape {
            SurfaceShape::Cylinder { radius_mm } => Some(radius_mm),
            SurfaceShape::Face { .. } => None,
        },
        _ => None,
    });
    let largest = radii.fold(0.0, f64::max);
    let usual = chordal_compare::ComparisonOptions::default().rotary_tolerance_rad;
    if largest > 0.0 { (options.tolerance_mm / largest).max(usual) } else { usual }
}

/// Revolutions of a spindle that keeps a cutting speed in both programs follow the diameter; at which point of a rapid they
/// change makes no difference. What a cut makes of them is compared as its feed.
fn follows_the_diameter(difference: &Difference, surface: &[BTreeSet<u32>; 2]) -> bool {
    let same_path = matches!(
        difference.values,
        Some([DifferenceValue::Spindle(one, _), DifferenceValue::Spindle(other, _)]) if one == other
    );
    let is_surface = |(blocks, lines): (&Option<BlockRange>, &BTreeSet<u32>)| {
        blocks.is_some_and(|blocks| {
            let (from, to) = blocks.lines();
            (from..=to).any(|line| lines.contains(&line))
        })
    };
    difference.category == Category::Spindle
        && same_path
        && difference.blocks.iter().zip(surface).all(is_surface)
}

/// Differences that belong to the machines, not to the text; of programs for lathes where it `turns`.
fn is_of_machine(difference: &Difference, turns: bool) -> bool {
    match (difference.category, &difference.values) {
        (
            Category::Problem,
            Some(
                [DifferenceValue::Nothing, DifferenceValue::Text(text)]
                | [DifferenceValue::Text(text), DifferenceValue::Nothing],
            ),
        ) => {
            let id = text.split(':').next().unwrap_or_default();
            LIMITS.iter().any(|code| code.id() == id)
        }
        // A turning tool's own radius has no number where T names a tool alone.
        (Category::RadiusOffset, Some(values)) if turns => {
            values.contains(&DifferenceValue::Nothing)
        }
        // E0 of one control is G53 of the others.
        (Category::WorkOffset, Some(values)) => values.contains(&DifferenceValue::Number(0)),
        // How wide a printed number is, is a setting.
        (Category::Output, Some([DifferenceValue::Text(one), DifferenceValue::Text(other)])) => {
            one.split_whitespace().eq(other.split_whitespace())
        }
        (category, _) => OF_MACHINES.contains(&category),
    }
}

/// What a program may ask too much of one machine and not of another.
const LIMITS: &[Code] = &[
    Code::TravelExceeded,
    Code::FeedOverLimit,
    Code::SpindleOverLimit,
    Code::SpeedWithoutLimit,
    Code::LengthOffsetOfOtherTool,
    Code::OffsetNotSet,
    Code::DiameterNotSet,
];

/// Proves another text in place of that of a conversion, one that was changed by hand: as a whole, without other steps of
/// its cycles. Nothing where the machine has settings that its control does not have.
pub fn prove_text(
    old: &Job,
    found: &Conversion,
    text: String,
    options: &ConversionOptions,
) -> Option<Certificate> {
    let new = job("converted", text, &found.machine)?;
    let source = SourceBlocks::of(old);
    let trace = ProgramTrace::of(old, &source);
    Some(proof(&trace, [old, &new], options, FreeCycleLines::default(), false))
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
fn other_kind(old: &Job, target: &Machine) -> Option<ConvertRefusal> {
    let tables = [old.control().table, chordal::control::table(target.control)];
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
    if !old.control().table.turns() {
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
    if options.despite_errors {
        return Vec::new();
    }
    let report = old.check();
    let counts = report
        .diagnostics
        .iter()
        .filter(|one| one.severity == Severity::Error && !LIMITS.contains(&one.code));
    counts
        .map(|one| {
            let span = one.primary.span;
            let source = old.sources().get(span.file);
            let line = source.map_or(0, |source| source.line_of(span.range.start));
            let words = source.map(|source| String::from_utf8_lossy(source.line_text(line)));
            ConvertRefusal {
                line,
                words: words.unwrap_or_default().trim().to_string(),
                reason: format!("an error on the original control: {}", one.message),
            }
        })
        .collect()
}

/// The target with what the old machine's tables hold: the cut depends on both.
fn with_tables_of(job: &Job, target: &Machine) -> Machine {
    let old = job.machine();
    let mut machine = target.clone();
    // The shape of rapids is the machine's; compared with each other, both go alike.
    machine.rapid = Some(match job.control().parameters.rules.rapid {
        RapidPath::DogLeg => RapidShape::DogLeg,
        RapidPath::Straight | RapidPath::AtFeed(_) => RapidShape::Straight,
    });
    machine.tools = old.tools.clone();
    // Who sets the work offset with each tool does so on the new machine, too.
    if job.control().parameters.rules.length.source != ToolLengths::Table {
        machine.set("settings.tool_lengths=\"touched-off\"").ok();
    }
    goes_on_after_refusal(&mut machine);
    if job.control().table.turns() {
        machine.spindle_max_rpm = old.spindle_max_rpm;
        // A dog-leg bends where the faster axis arrives: X and Z of lathes have speeds of their own.
        for (axis, limits) in machine.axes.iter_mut().enumerate() {
            if let (Some(limits), Some(own)) = (limits, old.axes[axis]) {
                limits.max_velocity = own.max_velocity;
            }
        }
    }
    let tips = [job.control().table, chordal::control::table(target.control)];
    let [one, other] = tips.map(|table| table.parameters.rules.turning.tips_mirrored);
    if one != other {
        for tool in machine.tools.values_mut() {
            tool.tip = tool.tip.map(mirrored_tip);
        }
    }
    machine.home = old.home;
    machine.reference_points = old.reference_points;
    machine.macros = old.macros.clone();
    machine.probe = old.probe;
    machine.switches = old.switches;
    machine.clearance_mm = old.clearance_mm.or(target.clearance_mm);
    machine.work_offsets = old
        .work_offsets
        .iter()
        .map(|(name, offset)| (renamed(name, target), *offset))
        .collect::<BTreeMap<String, WorkOffset>>();
    machine
}

/// One block that a firmware refuses does not hide what comes after it: each is found.
fn goes_on_after_refusal(machine: &mut Machine) {
    let table = chordal::control::table(machine.control);
    if let Some(setting) =
        table.settings.iter().find(|setting| setting.field == SettingField::AFTER_REFUSAL)
    {
        let value = SettingValue::Text("continue".into());
        machine.settings.insert(setting.name.into(), SettingEntry { value, location: None });
    }
}

/// The name under which the target has a work offset: E7 is G54.1 P1 and G154 P1.
fn renamed(name: &str, target: &Machine) -> String {
    let table = chordal::control::table(target.control);
    let number = |text: &str| text.trim().parse::<u32>().ok();
    let ordinal = match name.split_once(" P") {
        Some((code, extended)) => {
            // Mach3 counts G54 to G59 with them.
            let before = if code == "G59" { 0 } else { 6 };
            number(extended).map(|number| number + before)
        }
        None => match name.strip_prefix("G59.") {
            Some(point) => number(point).map(|number| number + 6),
            None => name
                .strip_prefix('E')
                .and_then(number)
                .or_else(|| name.strip_prefix('G').and_then(number)?.checked_sub(53)),
        },
    };
    let Some(ordinal) = ordinal else { return name.into() };
    let new = match (table.work_names.by_e, ordinal) {
        (true, _) => format!("E{ordinal}"),
        (false, 1..=6) => format!("G{}", 53 + ordinal),
        (false, _) => table.work_names.extended_key(ordinal.saturating_sub(6) as u16),
    };
    work_offset_name(&new).unwrap_or(new)
}
