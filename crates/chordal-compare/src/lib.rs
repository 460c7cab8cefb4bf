//! Compares two runs: the distance between their paths, and all other differences.
//!
//! Programs are compared by what they do, not by their text: steps that do the same are matched wherever they are in
//! the text, and the paths between them are traversed together. Spaces, block numbers, subprograms, units and the
//! subdivision of lines and arcs make no difference.
//!
//! The distance is an upper bound of the Fréchet distance between the two paths of the tool centre, in the frame of
//! the run (the program coordinates of the first cut), with rapids and cuts in the order in which they are made: two
//! points can move along the paths from beginning to end, without going back, and never be further apart than this.
//! It is exact for straight lines and for equal arcs and spirals; otherwise it is found within
//! [`ComparisonOptions::precision_mm`].
//!
//! ```
//! use chordal::{Job, Machine, Source, SourceMap};
//! use chordal_compare::{ComparisonOptions, ComparisonVerdict, compare};
//!
//! let job = |text: &'static [u8]| {
//!     let mut sources = SourceMap::new();
//!     sources.add(Source::new("part.nc", text));
//!     Job::new(sources, Machine::from_builtin("haas-vf2").unwrap()).unwrap()
//! };
//! let whole = job(b"G21 G90 S900 M3\nG0 X0 Y0 Z5.\nG1 X10. F100.\nM30\n");
//! let cut_in_two = job(b"G21 G90 S900 M3\nG0 X0 Y0 Z5.\nG1 X4. F100.\nX10.\nM30\n");
//! assert_eq!(compare(&whole, &cut_in_two, &ComparisonOptions::default()).verdict, ComparisonVerdict::Same);
//! ```

#![forbid(unsafe_code)]

mod align;
mod alignment_walker;
mod bound;
mod category;
mod couple;
mod course;
mod difference;
mod frechet;
mod joined_parts;
mod machine_places;
mod passes;
mod pecks;
mod problems;
mod skipped_blocks;
mod steps;
mod values;

use std::collections::BTreeSet;

use chordal::geometry::Transform;
pub use chordal::geometry::tolerance::COINCIDENT_MM;
use chordal::machine::KinematicChain;
use chordal::{Job, Machine, Report};

pub use category::{Category, ComparingCommand, shared_reference};
pub use difference::{BlockLocation, BlockRange, Difference, DifferenceValue};
pub use joined_parts::{JoinedPart, RetainedText, compare_joined};
pub use passes::{CyclePasses, FreePasses, LastPass};
pub use pecks::HolePecks;
pub use values::are_same_values;

/// How two runs are compared.
#[derive(Clone, Debug)]
pub struct ComparisonOptions {
    /// The allowed distance between the paths, mm.
    pub tolerance_mm: f64,
    /// The allowed relative difference of feeds.
    pub feed_tolerance: f64,
    /// The allowed relative difference of spindle speeds.
    pub speed_tolerance: f64,
    /// The allowed relative difference in the total time of cuts and dwells.
    pub time_tolerance: f64,
    /// The allowed difference in the positions of rotary axes, rad.
    pub rotary_tolerance_rad: f64,
    /// The precision of bounds of the distance between curves of different kinds, mm.
    pub precision_mm: f64,
    /// Compares the programmed path instead of the path of the tool centre; cutter compensation is then a state of
    /// the moves.
    pub programmed: bool,
    /// Takes positions that are unknown relative to the part as they are computed: for two runs that start at the
    /// same position, on machines with the same offsets and reference points.
    pub assume_known: bool,
    /// Differences of these categories are ignored.
    pub ignored: Vec<Category>,
    /// Compares prepared tools too. By default it does not, because preparing a tool moves nothing, and programs do
    /// it at different times.
    pub ready_tools: bool,
    /// The most differences that are returned; the others are counted.
    pub kept: usize,
    /// The programs are meant to make the same moves: if both make the same number of the same kinds, the moves are
    /// compared one by one in order, and moves between unknown positions are not compared.
    pub in_step: bool,
    /// With `in_step`, moves between unknown positions are compared too, except for their path.
    pub unknown_in_step: bool,
    /// The caller compares the other sides of unknown conditions as separate runs, so blocks that those run are not
    /// compared by their words.
    pub separate_sides: bool,
    /// Compares the axes of a machine where a program gives the tip of the tool (tool centre point control, tilted planes);
    /// `None`: the tip.
    pub axes: Option<ComparedAxes>,
    /// Lines of each program whose canned cycles may drill in different pecks: a hole counts as one cut from R to its
    /// bottom, and different pecks are reported separately ([`Comparison::pecks`]).
    pub free_pecks: [BTreeSet<u32>; 2],
    /// Lines of each program whose lathe cycles may cut in different passes: only the last pass is compared, and
    /// different passes are reported separately ([`Comparison::passes`]).
    pub free_passes: [FreePasses; 2],
}

/// The machine whose axes are compared.
#[derive(Clone, Copy, Debug)]
pub struct ComparedAxes {
    /// Its rotary axes; `None` for a machine without any.
    pub chain: Option<KinematicChain>,
    /// How far the tip may leave its path between two places of the axes, mm.
    pub tolerance_mm: f64,
}

impl Default for ComparisonOptions {
    fn default() -> ComparisonOptions {
        ComparisonOptions {
            tolerance_mm: 0.0,
            feed_tolerance: 1e-6,
            speed_tolerance: 1e-6,
            time_tolerance: 1e-3,
            rotary_tolerance_rad: 1e-9,
            precision_mm: 1e-6,
            programmed: false,
            assume_known: false,
            ignored: Vec::new(),
            ready_tools: false,
            kept: 1000,
            in_step: false,
            unknown_in_step: false,
            separate_sides: false,
            axes: None,
            free_pecks: Default::default(),
            free_passes: Default::default(),
        }
    }
}

/// How the first run is transformed before it is compared with the second.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunMapping {
    /// The transformation of the path, in the frame of the run. Machine positions (the start position and the targets
    /// of G28 and G53) do not move with it, so moves from and to them are not compared.
    pub path: Transform,
    /// The factor for the feeds of cuts. The feed of a tap follows the spindle speed instead.
    pub feed: f64,
    /// The factor for spindle speeds.
    pub speed: f64,
}

impl Default for RunMapping {
    fn default() -> RunMapping {
        RunMapping { path: Transform::identity(), feed: 1.0, speed: 1.0 }
    }
}

/// The result of a comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ComparisonVerdict {
    /// The motion and everything else are the same.
    Same,
    /// The paths differ by no more than the tolerance; everything else is the same.
    Within,
    /// Something differs.
    Different,
    /// No difference was found, but one of the programs does something that the simulation cannot follow.
    NotVerified,
}

/// The outcome of a comparison.
#[derive(Debug)]
pub struct Comparison {
    /// The result in one word.
    pub verdict: ComparisonVerdict,
    /// An upper bound of the distance between the paths, mm; `None` when no moves of the two could be compared.
    pub max_distance_mm: Option<f64>,
    /// The blocks at the largest distance; `None` when the paths coincide.
    pub farthest: Option<[BlockLocation; 2]>,
    /// A point on each path near the largest distance, in the frame of the run, mm. It shows where to look and is not
    /// exact.
    pub farthest_at_mm: Option<[[f64; 3]; 2]>,
    /// The differences in the order of the first program. Paths within the tolerance are not listed.
    pub differences: Vec<Difference>,
    /// How many further differences there are.
    pub dropped: u64,
    /// The number of moves in each run.
    pub moves: [u64; 2],
    /// Holes that the two runs drill in different pecks, where the options allow it.
    pub pecks: Vec<[HolePecks; 2]>,
    /// Lathe cycles that the two runs cut in different passes, where the options allow it.
    pub passes: Vec<[CyclePasses; 2]>,
    /// The reports of the two runs.
    pub reports: [Report; 2],
}

/// Runs both programs and compares them. When [`Job::interrupt`] ends a run, the comparison is empty; the report
/// shows the interruption. When no positions are known relative to the part and the machines have the same offsets
/// and reference points, both are assumed to start at the same position.
pub fn compare(a: &Job, b: &Job, options: &ComparisonOptions) -> Comparison {
    let mapping = RunMapping::default();
    let found = compare_mapped(a, b, options, &mapping);
    let was_interrupted = found.reports.iter().any(course::was_interrupted);
    let nothing_known =
        found.max_distance_mm.is_none() && found.moves != [0, 0] && !was_interrupted;
    if nothing_known && !options.assume_known && have_same_places(a.machine(), b.machine()) {
        let options = ComparisonOptions { assume_known: true, ..options.clone() };
        return compare_mapped(a, b, &options, &mapping);
    }
    found
}

fn have_same_places(a: &Machine, b: &Machine) -> bool {
    let places =
        |machine: &Machine| (machine.home, machine.reference_points, machine.work_offsets.clone());
    places(a) == places(b)
}

/// Compares the first run, transformed by a mapping, with the second.
pub fn compare_mapped(
    a: &Job,
    b: &Job,
    options: &ComparisonOptions,
    mapping: &RunMapping,
) -> Comparison {
    let jobs = [a, b];
    let is_moved = mapping.path != Transform::identity();
    let [mut a, mut b] = jobs.map(|job| {
        let places = is_moved.then(|| machine_places::MachinePlaces::of(job));
        course::ComparedRun::of(job, options, places)
    });
    if *mapping != RunMapping::default() {
        a.map(mapping);
    }
    let [lines_a, lines_b] = &options.free_pecks;
    let holes = [pecks::join(&mut a, lines_a), pecks::join(&mut b, lines_b)];
    let [lines_a, lines_b] = &options.free_passes;
    let cycles = [passes::join(&mut a, lines_a), passes::join(&mut b, lines_b)];
    conclude(jobs, a, b, &AllowedDifferences { holes, cycles }, options)
}

/// The pecks and passes that the options allow to differ.
#[derive(Default)]
struct AllowedDifferences {
    holes: [Vec<HolePecks>; 2],
    cycles: [Vec<CyclePasses>; 2],
}

/// Compares two recorded runs.
fn conclude(
    jobs: [&Job; 2],
    a: course::ComparedRun,
    b: course::ComparedRun,
    allowed: &AllowedDifferences,
    options: &ComparisonOptions,
) -> Comparison {
    if [&a, &b].into_iter().any(course::ComparedRun::was_interrupted) {
        return interrupted([a, b]);
    }
    let mut walk = alignment_walker::AlignmentWalker::new(&a, &b, options);
    // Half of the tolerance, so that steps matched on the grid are within it; at least 1e-6 mm because of rounding
    // errors.
    let grid_mm = (options.tolerance_mm / 2.0).max(1e-6);
    let in_step =
        if options.in_step { align::in_step(&a, &b, options.unknown_in_step) } else { None };
    walk.along(&in_step.unwrap_or_else(|| align::align(&a, &b, grid_mm)));
    let mut found = walk.finish();
    problems::compare(jobs, [&a.report, &b.report], &mut found);
    if !options.ignored.contains(&Category::Value) {
        problems::compare_values(jobs, [&a.report, &b.report], &mut found);
    }
    if !options.ignored.contains(&Category::NotRun) {
        skipped_blocks::compare(jobs, [&a.report, &b.report], options.separate_sides, &mut found);
    }
    let pecks = pecks::compare(&allowed.holes, options.tolerance_mm, &mut found.differences);
    let passes = passes::compare(&allowed.cycles, options.tolerance_mm, &mut found.differences);
    let has_other_steps = !pecks.is_empty() || !passes.is_empty();
    if !has_other_steps && let Some(times) = time_difference([&a, &b], &found, options) {
        found.differences.push(times);
    }
    found.differences.retain(|difference| !options.ignored.contains(&difference.category));
    let verified = a.report.verified() && b.report.verified();
    let has_path = found.max_distance_mm.is_some_and(|distance| distance > COINCIDENT_MM);
    let verdict = match (found.differences.is_empty(), has_path) {
        (true, _) if !verified => ComparisonVerdict::NotVerified,
        (true, false) => ComparisonVerdict::Same,
        // Paths further apart than the tolerance are among the differences, unless they are ignored.
        (true, true) => ComparisonVerdict::Within,
        (false, _) => ComparisonVerdict::Different,
    };
    let dropped = found.differences.len().saturating_sub(options.kept) as u64;
    found.differences.truncate(options.kept);
    Comparison {
        verdict,
        max_distance_mm: found.max_distance_mm,
        farthest: found.farthest,
        farthest_at_mm: found.farthest_at_mm,
        differences: found.differences,
        dropped,
        moves: [&a, &b].map(course::ComparedRun::move_count),
        pecks,
        passes,
        reports: [a.report, b.report],
    }
}

/// The difference in the time of cuts and dwells; `None` when it is within the tolerance or another difference
/// explains it.
fn time_difference(
    courses: [&course::ComparedRun; 2],
    found: &alignment_walker::ComparisonFindings,
    options: &ComparisonOptions,
) -> Option<Difference> {
    let shows = |difference: &Difference| {
        matches!(
            difference.category,
            Category::Path
                | Category::Order
                | Category::Rapid
                | Category::Rotary
                | Category::Unknown
                | Category::Feed
                | Category::Dwell
        )
    };
    let times = courses.map(course::ComparedRun::cutting_s);
    let separate = (times[0] - times[1]).abs();
    let most = times[0].max(times[1]);
    // A path within the tolerance may be longer and take longer, at most as long as at the lowest feed.
    let lengths = courses.map(course::ComparedRun::cut_mm);
    let slowest =
        courses.into_iter().filter_map(course::ComparedRun::slowest).fold(f64::INFINITY, f64::min);
    let longer_s = (lengths[0] - lengths[1]).abs() / slowest;
    let part = options.time_tolerance.max(options.feed_tolerance);
    if separate <= part * most + longer_s || found.differences.iter().any(shows) {
        return None;
    }
    let ends = courses.map(|course| {
        let place =
            |step: Option<&course::RunStep>| step.map(|step| BlockLocation::from(step.origin()));
        let (first, last) = (place(course.steps.first()), place(course.steps.last()));
        first.zip(last).map(|(first, last)| BlockRange { first, last })
    });
    let steps = courses.map(|course| course.steps.len() as u64);
    let values = Some(times.map(DifferenceValue::Seconds));
    Some(Difference::new(Category::Time, ends, steps, values))
}

/// The empty comparison of runs of which one was interrupted.
fn interrupted(courses: [course::ComparedRun; 2]) -> Comparison {
    Comparison {
        verdict: ComparisonVerdict::Different,
        max_distance_mm: None,
        farthest: None,
        farthest_at_mm: None,
        differences: Vec::new(),
        dropped: 0,
        moves: courses.each_ref().map(course::ComparedRun::move_count),
        pecks: Vec::new(),
        passes: Vec::new(),
        reports: courses.map(|course| course.report),
    }
}
