//! The new run held against the old one and the map.
//!
//! Both programs are run. What they do between moves must be the same; each old move is held against the moves
//! that stand for it: in X and Y these must lie on it, and their Z must be that of the old move and the map, at
//! every place: the difference is bounded between the places that are looked at by how fast it can change.

use chordal::control::{ArcShape, AxisMask, Feed, Position};
use chordal::diagnostics::FileId;
use chordal::{Command, CommandKind, Diagnostic, Job, RunSink, Severity, Sink};

use super::HeightOptions;
use super::grid::HeightMap;
use super::plane_path::PlanePath;
use super::write::{WrittenTrail, arc};

/// Steps of the bisection for all pieces of one move.
const MAX_STEPS: u32 = 2_000_000;

/// What was found.
#[derive(Debug, Default)]
pub(super) struct ProofResult {
    pub(super) deviation_mm: f64,
    pub(super) heights_mm: Option<[f64; 2]>,
    pub(super) moves: [u64; 2],
}

/// A move of a run.
#[derive(Clone, Debug)]
struct ProofMove {
    rapid: bool,
    from: Position,
    to: Position,
    known: [AxisMask; 2],
    shape: Option<ArcShape>,
    feed: Option<Feed>,
    /// Its block, by its first byte, and its line.
    at: u32,
    line: u32,
    here: bool,
}

/// A run, in its order.
#[derive(Default)]
struct ProofRun {
    steps: Vec<ProofMove>,
    /// What is done between moves, each with the count of moves before it.
    others: Vec<(usize, CommandKind)>,
    errors: u64,
}

impl Sink for ProofRun {
    fn command(&mut self, command: &Command) {
        let Some(motion) = command.kind.motion() else {
            self.others.push((self.steps.len(), command.kind.clone()));
            return;
        };
        self.steps.push(ProofMove {
            rapid: matches!(command.kind, CommandKind::Rapid { .. }),
            from: motion.from,
            to: motion.to,
            known: [motion.from_known, motion.to_known],
            shape: command.kind.shape().copied(),
            feed: command.kind.feed().copied(),
            at: command.origin.span.range.start,
            line: command.origin.line,
            here: command.origin.span.file == FileId(0),
        });
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.errors += u64::from(diagnostic.severity == Severity::Error);
    }
}

impl RunSink for ProofRun {}

/// Holds the new run against the old one and the map.
pub(super) fn prove(
    old: &Job,
    new: &Job,
    map: &HeightMap,
    trail: &WrittenTrail,
    warp: &HeightOptions,
) -> Result<ProofResult, String> {
    let [old, new] = [old, new].map(|job| {
        let mut course = ProofRun::default();
        job.run(&mut course);
        course
    });
    if new.errors > old.errors {
        return Err(format!(
            "the new program has {} errors, the old one {}: `chordal check` lists them",
            new.errors, old.errors
        ));
    }
    let mut prover = HeightProver {
        map,
        allowed: warp.tolerance_mm,
        rise: map.rise(),
        proved: ProofResult {
            moves: [old.steps.len() as u64, new.steps.len() as u64],
            ..ProofResult::default()
        },
    };
    let mut at = 0;
    // Where in the new run each old move begins.
    let mut starts = Vec::with_capacity(old.steps.len() + 1);
    for step in &old.steps {
        starts.push(at);
        if !step.here {
            return Err("a subprogram of another file moves".into());
        }
        let count = trail.pieces.get(&step.at).map_or(1, |count| *count as usize);
        let Some(pieces) = new.steps.get(at..at + count) else {
            return Err(format!("line {}: the new program ends before this move", step.line));
        };
        at += count;
        let is_level = trail.level.contains(&step.at);
        prover
            .step(step, pieces, is_level)
            .map_err(|what| format!("line {}: {what}", step.line))?;
    }
    starts.push(at);
    if at < new.steps.len() {
        return Err("the new program makes more moves than were written".into());
    }
    same_others(&old, &new, &starts)?;
    Ok(prover.proved)
}

/// What is done between moves is the same, and at the same places among them.
fn same_others(old: &ProofRun, new: &ProofRun, starts: &[usize]) -> Result<(), String> {
    if old.others.len() != new.others.len() {
        return Err("the new program does something else between its moves".into());
    }
    for ((place, one), (new_place, other)) in old.others.iter().zip(&new.others) {
        if one != other || starts.get(*place) != Some(new_place) {
            let line = old.steps.get(*place).map_or(0, |step| step.line);
            return Err(format!("before line {line} the new program does something else"));
        }
    }
    Ok(())
}

/// A move to a place of the machine, or aside from one, is the same; Z may come from another height.
fn stays(old: &ProofMove, new: &ProofMove) -> Result<(), String> {
    let same = |one: &Position, other: &Position, known: AxisMask| {
        (0..one.len()).all(|axis| !known.has(axis) || axis == 2 || one[axis] == other[axis])
    };
    let end = !old.known[1].has(2) || old.to[2] == new.to[2];
    let is_same = old.known == new.known
        && same(&old.from, &new.from, old.known[0])
        && same(&old.to, &new.to, old.known[1])
        && (end || old.from[2] == old.to[2]);
    is_same.then_some(()).ok_or_else(|| "the move is another one".into())
}

struct HeightProver<'a> {
    map: &'a HeightMap,
    allowed: f64,
    /// How far rapids are raised, mm.
    rise: f64,
    proved: ProofResult,
}

impl HeightProver<'_> {
    /// The same F. Where it is the feed in the plane of an arc, the slope of the map changes that along the arc:
    /// from √(1 + s²) to √(1 + (s + m)²), which is no more than m of it.
    fn same_feed(&self, old: &ProofMove, new: &ProofMove) -> bool {
        let (Some(one), Some(other)) = (old.feed, new.feed) else {
            return old.feed.is_none() && new.feed.is_none();
        };
        let slope = || {
            let shape =
                old.shape.as_ref().map(|shape| arc(shape, [old.from[0], old.from[1]]).bounds());
            shape.map_or(0.0, |[low, high]| self.map.steepest(low, high))
        };
        one.mode == other.mode
            && one.spindle_rev_per_s == other.spindle_rev_per_s
            // A cut before any F has none in both.
            && (one.value.to_bits() == other.value.to_bits()
                || (one.value - other.value).abs() <= one.value * (slope() + 1e-6))
    }

    fn step(
        &mut self,
        old: &ProofMove,
        pieces: &[ProofMove],
        is_level: bool,
    ) -> Result<(), String> {
        if pieces.iter().any(|new| new.rapid != old.rapid || !self.same_feed(old, new)) {
            return Err("the move or its feed is another one".into());
        }
        if is_level {
            return stays(old, &pieces[0]);
        }
        if old.rapid {
            return self.rapid(old, pieces);
        }
        // From the level of rapids a cut first goes down to the surface.
        let aside = |step: &ProofMove| step.from[..2] != step.to[..2] || step.shape.is_some();
        let pieces = match pieces {
            [down, rest @ ..] if !rest.is_empty() && aside(old) && !aside(down) => {
                let target = old.from[2] + self.map.height([old.from[0], old.from[1]]);
                if (down.to[2] - target).abs() > self.allowed {
                    return Err("the cut does not begin on the surface".into());
                }
                rest
            }
            all => all,
        };
        match old.shape {
            Some(shape) => self.arc(old, &shape, pieces),
            None => self.line(old, pieces),
        }
    }

    /// A rapid of the program: it ends where Z is above the whole map, and on its way, which may first go straight
    /// up, it is nowhere nearer to the surface than it was.
    fn rapid(&mut self, old: &ProofMove, pieces: &[ProofMove]) -> Result<(), String> {
        let last = &pieces[pieces.len() - 1];
        let same = (0..old.to.len())
            .all(|axis| axis == 2 || !old.known[1].has(axis) || old.to[axis] == last.to[axis]);
        if !same {
            return Err("the rapid ends at another place".into());
        }
        if !old.known[1].has(2) {
            return Ok(());
        }
        let off = (last.to[2] - (old.to[2] + self.rise)).abs();
        let moves_z = !old.known[0].has(2) || old.from[2] != old.to[2];
        let stays = last.from[2] == last.to[2] && !moves_z;
        if off > self.allowed && !stays {
            return Err(format!("the rapid ends {off:.4} mm off"));
        }
        let knows = old.known[0].has(0) && old.known[0].has(1) && old.known[0].has(2);
        if !knows || !pieces[0].known[0].has(2) {
            return Ok(());
        }
        let route =
            PlanePath::Line { from: [old.from[0], old.from[1]], to: [old.to[0], old.to[1]] };
        if let [up, _] = pieces
            && (up.from[..2] != up.to[..2] || up.to[2] < up.from[2] - self.allowed)
        {
            return Err("the rapid does not go straight up first".into());
        }
        // Where both ends are above the whole map, all between is.
        let above = |new: f64, old: f64| new >= old + self.rise - self.allowed;
        if above(last.from[2], old.from[2]) && above(last.to[2], old.to[2]) {
            return Ok(());
        }
        let places = route.nodes(self.map, self.allowed).map_err(|_| "the rapid is too long")?;
        let near = places.into_iter().find(|t| {
            let between = |from: f64, to: f64| from * (1.0 - t) + to * t;
            let target = between(old.from[2], old.to[2]) + self.map.height(route.at(*t));
            between(last.from[2], last.to[2]) < target - 2.0 * self.allowed
        });
        match near {
            Some(_) => Err("the rapid would come nearer to the surface".into()),
            None => Ok(()),
        }
    }

    fn line(&mut self, old: &ProofMove, pieces: &[ProofMove]) -> Result<(), String> {
        let route = [old.to[0] - old.from[0], old.to[1] - old.from[1]];
        let square = route[0] * route[0] + route[1] * route[1];
        if square == 0.0 {
            return self.down(old, pieces);
        }
        let mut before = 0.0;
        for new in pieces {
            if new.shape.is_some() {
                return Err("a line became an arc".into());
            }
            let fraction = |at: &Position| {
                ((at[0] - old.from[0]) * route[0] + (at[1] - old.from[1]) * route[1]) / square
            };
            let [first, last] = [fraction(&new.from), fraction(&new.to)];
            if first < before - 1e-9 || last < first {
                return Err("the pieces go back and forth".into());
            }
            before = last;
            let aside = [first, last].into_iter().zip([&new.from, &new.to]).map(|(t, at)| {
                let on = [old.from[0] + route[0] * t, old.from[1] + route[1] * t];
                (at[0] - on[0]).hypot(at[1] - on[1])
            });
            let aside = aside.fold(0.0, f64::max);
            let piece =
                PlanePath::Line { from: [new.from[0], new.from[1]], to: [new.to[0], new.to[1]] };
            self.piece(old, new, &piece, [first, last], aside)?;
        }
        self.ends(old, pieces)
    }

    /// A cut straight up or down, which may begin at the level of rapids: its end is on the surface.
    fn down(&mut self, old: &ProofMove, pieces: &[ProofMove]) -> Result<(), String> {
        let [new] = pieces else { return Err("a cut straight down became several".into()) };
        let height = self.map.height([old.to[0], old.to[1]]);
        let off = (new.to[2] - (old.to[2] + height)).abs();
        if off > self.allowed || new.from[..2] != new.to[..2] {
            return Err(format!("the cut ends {off:.4} mm off the surface"));
        }
        self.proved.deviation_mm = self.proved.deviation_mm.max(off);
        self.ends(old, pieces)
    }

    fn arc(
        &mut self,
        old: &ProofMove,
        shape: &ArcShape,
        pieces: &[ProofMove],
    ) -> Result<(), String> {
        let radius = (old.from[0] - shape.center[0]).hypot(old.from[1] - shape.center[1]);
        let mut swept = 0.0;
        for new in pieces {
            let Some(own) = new.shape.filter(|own| own.plane == shape.plane) else {
                return Err("an arc became something else".into());
            };
            let piece = arc(&own, [new.from[0], new.from[1]]);
            let PlanePath::Arc { radius: of_piece, .. } = piece else { return Ok(()) };
            let separate = (own.center[0] - shape.center[0]).hypot(own.center[1] - shape.center[1]);
            let first = swept / shape.sweep;
            swept += own.sweep;
            // Every point of the piece is at least as near to the old circle as this.
            let reach = separate + (of_piece - radius).abs();
            // On a short piece a centre that is off moves its points by much less: its ends are on it.
            let ends = [&new.from, &new.to].map(|at| {
                ((at[0] - shape.center[0]).hypot(at[1] - shape.center[1]) - radius).abs()
            });
            let bulge = |r: f64| r * (1.0 - libm::cos((0.5 * own.sweep).clamp(-1.5, 1.5)));
            let by_ends = ends[0].max(ends[1]) + (bulge(of_piece) - bulge(radius)).abs();
            let aside = if own.sweep.abs() < 1.0 { reach.min(by_ends) } else { reach };
            self.piece(old, new, &piece, [first, swept / shape.sweep], aside)?;
        }
        if (swept - shape.sweep).abs() * radius > self.allowed {
            return Err("the pieces do not turn as far as the arc".into());
        }
        self.ends(old, pieces)
    }

    fn ends(&self, old: &ProofMove, pieces: &[ProofMove]) -> Result<(), String> {
        let last = &pieces[pieces.len() - 1];
        let same = |a: &Position, b: &Position| {
            (0..a.len()).all(|axis| axis == 2 || (a[axis] - b[axis]).abs() < 1e-9)
        };
        let is_joined = same(&old.from, &pieces[0].from) && same(&old.to, &last.to);
        is_joined.then_some(()).ok_or_else(|| "the cut ends at another place".into())
    }

    /// One piece that stands for a part of an old move, `aside` off it in X and Y.
    fn piece(
        &mut self,
        old: &ProofMove,
        new: &ProofMove,
        plane_path: &PlanePath,
        part: [f64; 2],
        aside: f64,
    ) -> Result<(), String> {
        let rise = old.to[2] - old.from[2];
        let length = match plane_path {
            PlanePath::Line { from, to } => (to[0] - from[0]).hypot(to[1] - from[1]),
            PlanePath::Arc { radius, sweep, .. } => radius * sweep.abs(),
        };
        let off = |s: f64| {
            let z = new.from[2] * (1.0 - s) + new.to[2] * s;
            let t = part[0] * (1.0 - s) + part[1] * s;
            (z - (old.from[2] + rise * t) - self.map.height(plane_path.at(s))).abs()
        };
        let [low, high] = plane_path.bounds();
        let steepest = self.map.steepest(low.map(|at| at - aside), high.map(|at| at + aside));
        // How fast the difference can change along the piece.
        let most = (new.to[2] - new.from[2] - rise * (part[1] - part[0])).abs() + steepest * length;
        // The place on the old move lies aside, where the surface has another height.
        let slant = steepest * aside;
        let separate = |off: f64| (off + slant).hypot(aside);
        let allowed = (self.allowed * self.allowed - aside * aside).max(0.0).sqrt() - slant;
        let mut open = vec![(0.0, 1.0)];
        let (mut deepest, mut steps) = (off(0.0).max(off(1.0)), 0);
        let mut bound = deepest;
        while let Some((low, high)) = open.pop() {
            steps += 1;
            let middle = 0.5 * (low + high);
            let here = off(middle);
            deepest = deepest.max(here);
            let upper = here + 0.5 * (high - low) * most;
            if deepest > allowed + 1e-9 {
                return Err(format!(
                    "the new path is {:.4} mm off, {:.4} mm is allowed",
                    separate(deepest),
                    self.allowed
                ));
            }
            if steps > MAX_STEPS {
                return Err(format!(
                    "the move was looked at in {MAX_STEPS} places, and more would be needed; \
                     allow a larger tolerance"
                ));
            }
            // A hundredth of the tolerance tells enough.
            let is_near = upper <= deepest + 0.01 * self.allowed || upper <= 0.5 * allowed;
            if upper <= allowed && is_near {
                bound = bound.max(upper);
            } else {
                open.extend([(low, middle), (middle, high)]);
            }
        }
        let heights = [0.0, 0.5, 1.0].map(|s| self.map.height(plane_path.at(s)));
        let [low, high] = self.proved.heights_mm.unwrap_or([f64::INFINITY, f64::NEG_INFINITY]);
        self.proved.heights_mm = Some([
            heights.iter().copied().fold(low, f64::min),
            heights.iter().copied().fold(high, f64::max),
        ]);
        let distance = separate(bound.max(deepest));
        self.proved.deviation_mm = self.proved.deviation_mm.max(distance);
        Ok(())
    }
}
