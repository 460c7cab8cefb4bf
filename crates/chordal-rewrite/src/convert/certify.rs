//! Both programs compared, and which differences belong to the controls and machines.

use std::collections::BTreeSet;

use chordal::control::{CompensationSide, SurfaceShape};
use chordal::{Code, Command, CommandKind, Control, Job, Report};
use chordal_compare::{
    BlockRange, Category, ComparedAxes, Difference, DifferenceValue, FreePasses,
};

use super::trace;
use super::{ConversionOptions, axis_positions, codes};
use crate::{Certificate, prove, prove_contour};

/// Whole categories of differences that belong to the machines.
const OF_MACHINES: &[Category] = &[Category::RapidPath, Category::PathMode, Category::Overrides];

/// How far an angle may be from the exact one where it is computed, rad: half of the last of its three decimals, and what the
/// control rounds once more.
const WRITTEN_ANGLE_TOLERANCE_RAD: f64 = 0.6e-3 * std::f64::consts::PI / 180.0;

/// How far the duration of a move of the axes may be from that of the tip, a share: F is rounded.
const WRITTEN_AXES_FEED_TOLERANCE: f64 = 2e-3;

/// The lines of both texts whose cycles may be made in other steps.
#[derive(Clone, Default)]
pub(super) struct FreeCycleLines {
    pub(super) pecks: [BTreeSet<u32>; 2],
    pub(super) passes: [FreePasses; 2],
}

/// What a proof does not count as a difference.
#[derive(Clone, Default)]
pub(super) struct ProofTerms {
    /// The lines of cycles that may be made in other steps.
    pub(super) free: FreeCycleLines,
    /// Text that was printed is a comment now.
    pub(super) printed: bool,
    /// The axes that are compared where the old program gives the tip; `None` where it does not.
    pub(super) axes: Option<ComparedAxes>,
    /// The languages are two: tool lengths are compared in another way, and variables have no counterpart.
    pub(super) is_other_language: bool,
}

/// Compares two programs; `commands` are those of the old one.
pub(super) fn proof(
    commands: &[Command],
    [old, new]: [&Job; 2],
    options: &ConversionOptions,
    terms: ProofTerms,
) -> Certificate {
    let ProofTerms { free, printed, is_other_language, axes } = terms;
    let compensates = commands.iter().any(|command| {
        matches!(command.kind, CommandKind::Compensation { side, .. } if side != CompensationSide::Off)
    });
    let compare = chordal_compare::ComparisonOptions {
        tolerance_mm: options.tolerance_mm,
        feed_tolerance: if axes.is_some() { WRITTEN_AXES_FEED_TOLERANCE } else { 1e-5 },
        speed_tolerance: 1e-5,
        rotary_tolerance_rad: match axes {
            Some(_) => WRITTEN_ANGLE_TOLERANCE_RAD,
            None => rotary_tolerance(commands, options),
        },
        axes,
        // Both begin at the same place, and both machines have the same tables.
        assume_known: true,
        separate_sides: true,
        free_pecks: free.pecks,
        free_passes: free.passes,
        kept: 100_000,
        ignored: match is_other_language {
            true => vec![Category::LengthOffset, Category::Value],
            false => Vec::new(),
        },
        ..chordal_compare::ComparisonOptions::default()
    };
    let surface = [old, new].map(trace::surface_lines);
    let turns = old.profile().turns;
    // Without a tool table each tool is set to the work zero.
    let no_lengths = !codes::all_have_lengths([old, new]);
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
            let controls: [Option<&Control>; 2] = [old, new].map(Job::word_address);
            // Another language has no codes of the old one.
            let [Some(from), Some(to)] = controls else { return true };
            codes::is_only_of(words, from, to)
        }
        // It only makes the machine take the axes, which are compared.
        (Category::Code, Some([DifferenceValue::Nothing, DifferenceValue::Text(words)])) => {
            axis_positions::SWITCH_TO_AXES.contains(&words.as_str())
                && axis_positions::begins_with_tip(new.machine())
        }
        // On the same control a variable means the same, so it must have the same value.
        (Category::Variable, Some([DifferenceValue::Text(_), DifferenceValue::Text(_)])) => {
            old.profile().name != new.profile().name
        }
        (Category::Message | Category::Alarm | Category::Variable, _) => true,
        _ => false,
    }
}

/// How far rotary axes may be apart: on a cylinder one control gives lengths and the other one angles, and both are rounded. At its
/// radius that is no more than the tolerance.
fn rotary_tolerance(commands: &[Command], options: &ConversionOptions) -> f64 {
    let radii = commands.iter().filter_map(|command| match &command.kind {
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
pub(super) const LIMITS: &[Code] = &[
    Code::TravelExceeded,
    Code::FeedOverLimit,
    Code::SpindleOverLimit,
    Code::SpeedWithoutLimit,
    Code::LengthOffsetOfOtherTool,
    Code::OffsetNotSet,
    Code::DiameterNotSet,
];
