//! Two runs compared with each other: how far apart their paths are, and in what else they differ.
//!
//! Programs are compared by what they do, not by their text: steps that do the same find each other
//! wherever they stand, and what lies between is walked together. Neither spaces, numbers of blocks,
//! subprograms, units nor the way lines and arcs are cut make a difference.
//!
//! The distance is an upper bound of the Fréchet distance of the two paths of the tool centre, in the
//! frame of the run (the program coordinates of the first cut), rapids and cuts in the order in which
//! they are made: two who walk the paths from beginning to end without going back are never further
//! apart than this. It is exact for straight lines and for equal arcs and spirals, else found within
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
use chordal::{Job, Machine, Report};

pub use category::{Category, ComparingCommand, shared_reference};
pub use difference::{BlockLocation, BlockRange, Difference, DifferenceValue};
pub use joined_parts::{JoinedPart, RetainedText, compare_joined};
pub use passes::{CyclePasses, FreePasses, LastPass};
pub use pecks::HolePecks;
pub use values::are_same_values;

/// How two runs are compared with each other.
#[derive(Clone, Debug)]
pub struct ComparisonOptions {
    /// Paths may be this far apart, mm.
    pub tolerance_mm: f64,
    /// Feeds may differ by this part of them.
    pub feed_tolerance: f64,
    /// Spindle speeds may differ by this part of them.
    pub speed_tolerance: f64,
    /// The time of all cuts and dwells may differ by this part of it.
    pub time_tolerance: f64,
    /// Rotary axes may stand this far apart, rad.
    pub rotary_tolerance_rad: f64,
    /// Bounds of distances between curves of different kinds are found to this, mm.
    pub precision_mm: f64,
    /// The path as it is programmed is compared, not that of the tool centre: cutter compensation
    /// is a state of its moves.
    pub programmed: bool,
    /// Places that are not known relative to the part are taken as they are counted: for two runs that
    /// begin at the same place, on machines with the same offsets and reference points.
    pub assume_known: bool,
    /// Differences of these are none.
    pub ignored: Vec<Category>,
    /// Tools that are made ready count. They move nothing, and programs name them sooner or later.
    pub ready_tools: bool,
    /// So many differences are kept; the rest is counted.
    pub kept: usize,
    /// The two are meant to make the same moves: where both make as many of the same kinds, they are held
    /// against each other one by one in their order, and moves between places that are not known not at all.
    pub in_step: bool,
    /// In step, of moves between places that are not known all is compared but the path: the way, the feed, the state.
    pub unknown_in_step: bool,
    /// Whoever asks compares the other sides of conditions that nobody knows as runs of their own: blocks that they run
    /// are not held against each other by their words.
    pub separate_sides: bool,
    /// Lines of either program whose canned cycles may drill in other steps: there a hole counts as one
    /// cut from R to its bottom, and how the steps differ is reported apart ([`Comparison::pecks`]).
    pub free_pecks: [BTreeSet<u32>; 2],
    /// Lines of either program whose cycles of a lathe may cut in passes of their own: there the last pass counts, and
    /// how the others differ is reported apart ([`Comparison::passes`]).
    pub free_passes: [FreePasses; 2],
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
            free_pecks: Default::default(),
            free_passes: Default::default(),
        }
    }
}

/// What is to become of a run, so that another one may be the same.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunMapping {
    /// Where the path goes, in the frame of the run. Places of the machine stay: where it stands at the
    /// start and where G28 and G53 go; moves from and to them are not compared with each other.
    pub path: Transform,
    /// What feeds are multiplied by: of cuts, not of taps, whose feed goes with the spindle.
    pub feed: f64,
    /// What spindle speeds are multiplied by.
    pub speed: f64,
}

impl Default for RunMapping {
    fn default() -> RunMapping {
        RunMapping { path: Transform::identity(), feed: 1.0, speed: 1.0 }
    }
}

/// The answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ComparisonVerdict {
    /// The same motion, and everything else the same.
    Same,
    /// The paths are apart, but nowhere by more than the tolerance; everything else is the same.
    Within,
    /// Something differs.
    Different,
    /// No difference was found, and one of the programs does something that is not followed: from
    /// there on nothing is known.
    NotVerified,
}

/// What came out.
#[derive(Debug)]
pub struct Comparison {
    /// The answer.
    pub verdict: ComparisonVerdict,
    /// The paths are nowhere further apart than this, mm; nothing where one of the two has no moves that
    /// the other's could be compared with.
    pub max_distance_mm: Option<f64>,
    /// The blocks where they are furthest apart.
    pub farthest: Option<[BlockLocation; 2]>,
    /// A place on each path, about there, in the frame of the run, mm: where to look, not a measure.
    pub farthest_at_mm: Option<[[f64; 3]; 2]>,
    /// The differences, in the order of the first program; paths within the tolerance are none.
    pub differences: Vec<Difference>,
    /// How many more there are.
    pub dropped: u64,
    /// How many moves each has.
    pub moves: [u64; 2],
    /// Holes that the two drill in other steps, where they may.
    pub pecks: Vec<[HolePecks; 2]>,
    /// Cycles of lathes that the two cut in other passes, where they may.
    pub passes: Vec<[CyclePasses; 2]>,
    /// What the runs themselves found.
    pub reports: [Report; 2],
}

/// Runs both and holds them against each other. A run that [`Job::interrupt`] ends leaves the comparison
/// without a word, as its report says. Where no place of either is known relative to the part,
/// and their machines have the same tables, both are taken to begin at the same place.
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

/// Holds what the first does, moved and at other feeds and speeds, against the second.
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

/// What two runs may do otherwise.
#[derive(Default)]
struct AllowedDifferences {
    holes: [Vec<HolePecks>; 2],
    cycles: [Vec<CyclePasses>; 2],
}

/// Walks along two runs.
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
    // Half of the tolerance, so that what the grid takes for the same is within it; not finer than
    // what rounding may do.
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
        // Paths further apart than the tolerance are among the differences, unless they do not count.
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

/// The time of cuts and dwells, where nothing else shows why it differs.
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
    // A path within the tolerance may be longer, and takes longer then: at the lowest feed the longest.
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

/// Nothing can be said of a run that was given up.
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
