//! Roughing: level by level down to the contour, then once along it (G71 in passes along Z, G72 along X).

use chordal_diagnostics::{Code, Diagnostic, Severity};

use crate::kernel::Kernel;
use crate::rules::FirstLevel;
use crate::statement::Statement;
use crate::turning::COINCIDENT_MM;
use crate::turning::profile::{ContourEdge, ContourProfile, CycleView};

/// Largest number of passes of one cycle: a depth of a micrometre is a mistake.
const MAX_PASSES: u32 = 100_000;

/// The words of a roughing cycle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RoughWords {
    /// Passes along X (G72), not along Z.
    pub along_x: bool,
    /// Finishing allowance, on the radius and along Z, mm.
    pub allowance: [f64; 2],
    /// Depth of a pass, mm.
    pub depth: f64,
    /// Retraction after a pass, mm.
    pub retract: f64,
    /// Additional allowance of a first contour pass, on the radius and along Z, mm; zero for a single contour pass.
    pub rough_allowance: [f64; 2],
    /// Pockets are cut as well (type II).
    pub pockets: bool,
}

/// The contour of a cycle and its data, in (along, across) coordinates.
struct RoughingJob<'e> {
    view: CycleView,
    edges: &'e [ContourEdge],
    /// The start of the passes.
    begin: [f64; 2],
    /// The end of the contour's first block, moved by the allowance.
    first: [f64; 2],
    retract: f64,
    rapid_infeed: bool,
}

impl Kernel<'_> {
    /// Roughs down to a contour, and returns to the start.
    pub fn rough(&mut self, at: &dyn Statement, words: &RoughWords, profile: &ContourProfile) {
        let start = self.turned_place();
        let view = CycleView::new(words.along_x, start, profile);
        let finish = view.seen(words.allowance);
        self.check_allowance(at, finish);
        let more = view.seen(words.rough_allowance);
        let by = [finish[0] + more[0], finish[1] + more[1]];
        let edges = view.edges(profile, by);
        let seen = view.seen(start);
        let begin = [seen[0] + by[0], seen[1] + by[1]];
        let first = view.seen(profile.start);
        let first = [first[0] + by[0], first[1] + by[1]];
        let lowest = edges.iter().map(ContourEdge::lowest).fold(first[1], f64::min);
        let top = match self.rules.turning.first_level {
            FirstLevel::Allowance => begin[1],
            FirstLevel::Start => seen[1],
        };
        let passes = (top - lowest) / words.depth;
        if passes > f64::from(MAX_PASSES) {
            return self.report_passes(at, passes);
        }
        self.origin.cycle = true;
        self.turn_rapid(view.place(begin));
        let job = RoughingJob {
            view,
            edges: &edges,
            begin,
            first,
            retract: words.retract,
            rapid_infeed: profile.first_is_rapid,
        };
        match words.pockets {
            true => self.rough_pockets(at, &job, top, words.depth, lowest),
            false => self.rough_levels(at, &job, top, words.depth, lowest),
        }
        self.infeed(at, &job, [begin[0], first[1]]);
        self.infeed(at, &job, first);
        self.turn_contour(at, edges.iter().map(|edge| view.placed(edge)));
        if more != [0.0; 2] {
            self.contour_nearer(at, &view, profile, start, finish);
        }
        self.turn_rapid(start);
        self.origin.cycle = false;
    }

    /// A second pass along the contour, with the finishing allowance only.
    fn contour_nearer(
        &mut self,
        at: &dyn Statement,
        view: &CycleView,
        profile: &ContourProfile,
        start: [f64; 2],
        by: [f64; 2],
    ) {
        let moved = |place: [f64; 2]| {
            let seen = view.seen(place);
            view.place([seen[0] + by[0], seen[1] + by[1]])
        };
        self.turn_rapid(moved(start));
        match profile.first_is_rapid {
            true => self.turn_rapid(moved(profile.start)),
            false => self.turn_cut(at, moved(profile.start)),
        }
        let edges = view.edges(profile, by);
        self.turn_contour(at, edges.iter().map(|edge| view.placed(edge)));
    }

    fn infeed(&mut self, at: &dyn Statement, job: &RoughingJob<'_>, to: [f64; 2]) {
        match job.rapid_infeed {
            true => self.turn_rapid(job.view.place(to)),
            false => self.turn_cut(at, job.view.place(to)),
        }
    }

    /// Type I: each pass from the start to the contour, and away from it at 45 degrees.
    fn rough_levels(
        &mut self,
        at: &dyn Statement,
        job: &RoughingJob<'_>,
        top: f64,
        depth: f64,
        lowest: f64,
    ) {
        let view = job.view;
        let mut pass = 1.0;
        loop {
            let level = top - depth * pass;
            if level <= lowest + COINCIDENT_MM {
                return;
            }
            self.infeed(at, job, [job.begin[0], level]);
            let end = hit(job.first, job.edges, level);
            self.turn_cut(at, view.place([end, level]));
            let out = [end + job.retract, level + job.retract];
            self.turn_rapid(view.place(out));
            self.turn_rapid(view.place([job.begin[0].max(out[0]), out[1]]));
            pass += 1.0;
        }
    }

    /// Type II: each pass follows the contour where it lies above the level, pocket after pocket.
    fn rough_pockets(
        &mut self,
        at: &dyn Statement,
        job: &RoughingJob<'_>,
        top: f64,
        depth: f64,
        lowest: f64,
    ) {
        let view = job.view;
        let mut above = f64::INFINITY;
        let mut height = job.begin[1];
        let mut pass = 1.0;
        loop {
            let level = (top - depth * pass).max(lowest);
            for run in runs(job.first, job.edges, level, above) {
                let Some(first) = run.first() else { continue };
                // Over the contour between the pockets.
                let here = view.seen(self.turned_place())[0];
                let over = highest_between(job.edges, here, first.from[0]) + job.retract;
                if over > height + COINCIDENT_MM && over <= job.begin[1] {
                    height = over;
                    self.turn_rapid(view.place([here, height]));
                }
                self.turn_rapid(view.place([first.from[0], height]));
                self.infeed(at, job, first.from);
                for edge in &run {
                    self.turn_edge(at, &view.placed(edge));
                }
                let end = run.last().map_or(first.to, |edge| edge.to);
                height = end[1] + job.retract;
                self.turn_rapid(view.place([end[0], height]));
            }
            if level <= lowest + COINCIDENT_MM {
                break;
            }
            above = level;
            pass += 1.0;
        }
        // First out of the last pocket, over the contour between it and the start.
        let here = view.seen(self.turned_place())[0];
        let over = highest_between(job.edges, here, job.begin[0]) + job.retract;
        if over > height + COINCIDENT_MM && over <= job.begin[1] {
            height = over;
            self.turn_rapid(view.place([here, height]));
        }
        self.turn_rapid(view.place([job.begin[0], height]));
    }

    /// Reports an allowance that moves the contour into the part.
    fn check_allowance(&mut self, at: &dyn Statement, by: [f64; 2]) {
        if by[1] >= 0.0 && by[0] >= 0.0 {
            return;
        }
        let size = self.length_text(by[0].min(by[1]).abs());
        self.report(
            Diagnostic::new(
                Code::BadWordValue,
                at.span(),
                format!("the finishing allowance goes into the part, by {size}"),
            )
            .severity(Severity::Warning)
            .label("roughing cuts below the contour")
            .help("change the sign of U or W: outside towards +X, in a bore towards -X"),
        );
    }

    fn report_passes(&mut self, at: &dyn Statement, passes: f64) {
        self.report(
            Diagnostic::new(
                Code::BudgetReached,
                at.span(),
                format!("this depth needs {passes:.0} passes; Chordal makes at most {MAX_PASSES}"),
            )
            .help("is the depth of a pass meant so small? a number without a point counts least increments"),
        );
    }
}

/// The position along a level at which it meets the contour.
fn hit(first: [f64; 2], edges: &[ContourEdge], level: f64) -> f64 {
    if first[1] > level {
        return first[0];
    }
    for edge in edges {
        if let Some(share) = edge.crossings(level).first() {
            return edge.at(*share)[0];
        }
        if edge.to[1] >= level {
            return edge.to[0];
        }
    }
    edges.last().map_or(first[0], |edge| edge.to[0])
}

/// The connected runs of the contour below `above`, raised to at least `level`.
fn runs(first: [f64; 2], edges: &[ContourEdge], level: f64, above: f64) -> Vec<Vec<ContourEdge>> {
    let mut runs: Vec<Vec<ContourEdge>> = Vec::new();
    let mut run: Vec<ContourEdge> = Vec::new();
    let mut at = [first[0], first[1].max(level)];
    for edge in edges {
        let mut cuts = edge.crossings(level);
        if above.is_finite() {
            cuts.extend(edge.crossings(above));
        }
        cuts.sort_by(f64::total_cmp);
        let mut from = 0.0;
        for to in cuts.into_iter().chain([1.0]) {
            let piece = edge.piece(from, to);
            let middle = edge.at((from + to) / 2.0)[1];
            from = to;
            if middle >= above {
                if !run.is_empty() {
                    runs.push(std::mem::take(&mut run));
                }
                at = piece.to;
                continue;
            }
            let piece = match middle < level {
                true => {
                    ContourEdge::line([piece.from[0], level], [piece.to[0], level], edge.origin)
                }
                false => piece,
            };
            if run.is_empty() {
                at = piece.from;
            }
            join(&mut run, at, piece);
            at = piece.to;
        }
    }
    if !run.is_empty() {
        runs.push(run);
    }
    // A run without a length only touches the level.
    runs.retain(|run| run.iter().any(|edge| edge.from != edge.to));
    runs
}

/// Adds a piece to a run; consecutive pieces along the level are merged.
fn join(run: &mut Vec<ContourEdge>, at: [f64; 2], piece: ContourEdge) {
    if piece.from == piece.to {
        return;
    }
    let flat = |edge: &ContourEdge| edge.arc.is_none() && edge.from[1] == edge.to[1];
    match run.last_mut() {
        Some(last) if flat(last) && flat(&piece) && last.to[1] == piece.from[1] => {
            last.to = piece.to
        }
        _ => {
            let gap = (at[0] - piece.from[0]).abs() + (at[1] - piece.from[1]).abs();
            if !run.is_empty() && gap > COINCIDENT_MM {
                run.push(ContourEdge::line(at, piece.from, piece.origin));
            }
            run.push(piece);
        }
    }
}

/// The highest end of an edge between two positions along the passes.
fn highest_between(edges: &[ContourEdge], one: f64, other: f64) -> f64 {
    let (low, high) = (one.min(other), one.max(other));
    edges
        .iter()
        .filter(|edge| edge.from[0].min(edge.to[0]) < high && edge.from[0].max(edge.to[0]) > low)
        .map(|edge| edge.from[1].max(edge.to[1]))
        .fold(f64::NEG_INFINITY, f64::max)
}
