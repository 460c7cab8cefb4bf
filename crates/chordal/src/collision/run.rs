//! The check of a run: every pair of bodies along every move.

use std::collections::BTreeMap;

use chordal_collision::{AxisMove, MachineLinks, PairAnswer, PairCheck, PairOverlap};
use chordal_command::{AxisMask, CommandKind, Origin, Units};
use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_kinematics::{KinematicChain, RotaryMount};
use chordal_machine::{Axis, RotaryTarget};
use chordal_path::{PathCommand, Segment};

use super::bodies::{
    BodyRole, ContactMeaning, MachineBody, machine_bodies, meaning, setup_bodies, tool_bodies,
};
use super::doubts::CollisionDoubts;
use super::moves::{FollowedMove, MoveFollower};
use super::problems::{budget_diagnostic, contact_diagnostic};
use super::report::{CollisionProblem, CollisionReport, CollisionVerdict};
use crate::job::Job;
use crate::other_sides::MAX_STOCK_SIDE_RUNS;
use crate::report::RunWatch;
use crate::stock::{SetupError, SetupFileReader, ToolFrustums, ToolPart, tool_outlines};

/// The options of a check for collisions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CollisionOptions {
    /// Bodies that touch are found; bodies that stay so far apart are not reported, mm.
    pub tolerance_mm: f64,
    /// The most positions of two bodies that are looked at.
    pub budget: u64,
}

impl Default for CollisionOptions {
    /// A tenth of a millimetre, some tens of millions of positions.
    fn default() -> CollisionOptions {
        CollisionOptions { tolerance_mm: 0.1, budget: 50_000_000 }
    }
}

/// Why a check for collisions is not possible.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CollisionError {
    /// The machine is a lathe.
    #[error("this machine turns its parts: collisions are checked on mills")]
    Turns,
    /// The tolerance is not above zero.
    #[error("the tolerance must be above zero")]
    NoTolerance,
    /// The setup cannot be used.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// It was interrupted.
    #[error("the check for collisions was ended early")]
    Interrupted,
}

/// Most problems that are kept of a run.
const MAX_PROBLEMS: usize = 1000;

/// Most positions for one pair of bodies on one piece of a move: four thousand times as many as usual.
const MAX_POSITIONS_OF_PIECE: u64 = 1_000_000;

/// The part of the tolerance by which straight moves of the axes may be off while the tip is held.
const DEVIATION_SHARE: f64 = 1.0 / 32.0;

impl Job<'_> {
    /// Whether bodies of the machine, the setup and the tools touch on a move of the program; `files` reads the meshes that
    /// the setup names.
    ///
    /// # Errors
    /// On a lathe, with a setup that is incomplete, or a tolerance that is not above zero.
    pub fn collide(
        &self,
        options: &CollisionOptions,
        files: SetupFileReader<'_>,
    ) -> Result<CollisionReport, CollisionError> {
        let mut found = self.collide_of_run(options, files)?;
        let mut verdict = found.verdict;
        self.add_other_sides(&mut found.report, MAX_STOCK_SIDE_RUNS, |side| {
            let Ok(of_side) = side.collide_of_run(options, files) else { return Vec::new() };
            verdict = match (verdict, of_side.verdict) {
                (CollisionVerdict::Problems, _) | (_, CollisionVerdict::Problems) => {
                    CollisionVerdict::Problems
                }
                (CollisionVerdict::NotProved, _) | (_, CollisionVerdict::NotProved) => {
                    CollisionVerdict::NotProved
                }
                (CollisionVerdict::Clean, CollisionVerdict::Clean) => CollisionVerdict::Clean,
            };
            of_side.report.diagnostics
        });
        found.verdict = verdict;
        Ok(found)
    }

    fn collide_of_run(
        &self,
        options: &CollisionOptions,
        files: SetupFileReader<'_>,
    ) -> Result<CollisionReport, CollisionError> {
        if self.machine().turns() {
            return Err(CollisionError::Turns);
        }
        if options.tolerance_mm.is_nan() || options.tolerance_mm <= 0.0 {
            return Err(CollisionError::NoTolerance);
        }
        let mut doubts = CollisionDoubts::default();
        let chain = self.machine().kinematic_chain();
        let chain = match chain {
            Ok(chain) => chain,
            Err(error) => {
                let reason = format!("the kinematics of the machine are not known: {error}");
                let help = "give the rotary axes in the machine file, or remove those that it does not have (`[axes] A = false`); nothing is checked without them";
                doubts.add(Span::default(), reason, help);
                KinematicChain::CARTESIAN
            }
        };
        let is_known = doubts.diagnostics.is_empty();
        let links = self.machine_links(&chain);
        let mut bodies = Vec::new();
        if is_known {
            for body in machine_bodies(self.machine(), &links) {
                match body {
                    Ok(body) => bodies.push(body),
                    Err(reason) => doubts.add(
                        Span::default(),
                        format!("{reason}, so that body is not checked"),
                        "complete the machine file",
                    ),
                }
            }
            bodies.extend(setup_bodies(self, &links, &chain, files, &mut doubts)?);
        }
        let mut run = CollisionRun {
            job: self,
            options: *options,
            follower: MoveFollower::new(
                self.machine(),
                self.initial_frame(),
                options.tolerance_mm * DEVIATION_SHARE,
            ),
            scenes: BTreeMap::new(),
            fixed: bodies,
            outlines: if is_known { tool_outlines(self) } else { BTreeMap::new() },
            links,
            chain,
            is_known,
            doubts,
            tool: 0,
            units: self.rules().units,
            budget: options.budget,
            moves: 0,
            titles: Vec::new(),
            without_holder: Vec::new(),
            most_pairs: 0,
            problems: Vec::new(),
            diagnostics: Vec::new(),
            more: 0,
            hits: 0,
            last: Vec::new(),
        };
        run.use_tool(&Origin::default());
        let report = self.report_watched(&mut run);
        if self.is_interrupted() {
            return Err(CollisionError::Interrupted);
        }
        Ok(run.finish(report))
    }

    pub(super) fn machine_links(&self, chain: &KinematicChain) -> MachineLinks {
        let linear = &self.machine().linear;
        // What is not given does not matter between part and tool; bodies on the base are left out then.
        let sides = linear.sides.map(|side| match side {
            Some(RotaryTarget::Table) => RotaryMount::Table,
            Some(RotaryTarget::Head) | None => RotaryMount::Head,
        });
        let order = linear.order.unwrap_or_default().axes().map(|axis| axis as usize);
        MachineLinks::new(chain, sides, order)
    }
}

/// The bodies with one tool in the spindle, and the pairs of them that must not touch.
struct ToolScene {
    bodies: Vec<MachineBody>,
    pairs: Vec<BodyPair>,
}

struct BodyPair {
    bodies: [usize; 2],
    meaning: ContactMeaning,
    /// The axes that move them relative to each other.
    axes: AxisMask,
}

struct CollisionRun<'a> {
    job: &'a Job<'a>,
    options: CollisionOptions,
    follower: MoveFollower<'a>,
    scenes: BTreeMap<u32, std::rc::Rc<ToolScene>>,
    /// The bodies of machine and setup.
    fixed: Vec<MachineBody>,
    outlines: BTreeMap<u32, Result<ToolFrustums, String>>,
    links: MachineLinks,
    chain: KinematicChain,
    /// Whether the kinematics are known.
    is_known: bool,
    doubts: CollisionDoubts,
    tool: u32,
    units: Units,
    budget: u64,
    moves: u64,
    titles: Vec<String>,
    without_holder: Vec<u32>,
    most_pairs: usize,
    problems: Vec<CollisionProblem>,
    diagnostics: Vec<Diagnostic>,
    more: u64,
    hits: u64,
    /// The pairs of the last block that were reported, with the index of their problem.
    last: Vec<(Origin, [String; 2], usize)>,
}

impl CollisionRun<'_> {
    /// Takes the bodies of the tool in the spindle.
    fn use_tool(&mut self, origin: &Origin) {
        if self.scenes.contains_key(&self.tool) || !self.is_known {
            return;
        }
        let mut bodies = self.fixed.clone();
        if self.tool != 0 {
            bodies.extend(self.bodies_of_tool(origin));
        }
        let mut pairs = Vec::new();
        for (place, one) in bodies.iter().enumerate() {
            for (other, body) in bodies.iter().enumerate().skip(place + 1) {
                let Some(meaning) = meaning(&self.links, one, body) else { continue };
                // Messages name the tool first.
                let is_tool = matches!(body.role, BodyRole::Tool(_));
                let named = if is_tool { [other, place] } else { [place, other] };
                let mut axes = AxisMask::NONE;
                let [a, b] = [one.linked.link(), body.linked.link()];
                self.links.axes_between(a, b).into_iter().for_each(|axis| axes.insert(axis));
                pairs.push(BodyPair { bodies: named, meaning, axes });
            }
        }
        for body in &bodies {
            if !self.titles.contains(&body.title) {
                self.titles.push(body.title.clone());
            }
        }
        self.most_pairs = self.most_pairs.max(pairs.len());
        self.scenes.insert(self.tool, std::rc::Rc::new(ToolScene { bodies, pairs }));
    }

    fn bodies_of_tool(&mut self, origin: &Origin) -> Vec<MachineBody> {
        let number = self.tool;
        let tool = self.job.machine().tools.get(&number);
        let length = tool.and_then(|tool| tool.offset_of(Axis::Z as usize));
        let reason = match (self.outlines.get(&number), length) {
            (None, _) => "its shape is not known".to_string(),
            (Some(Err(reason)), _) => reason.clone(),
            (Some(Ok(_)), None) => "its length is not given".to_string(),
            (Some(Ok(_)), Some(length)) if length <= 0.0 => {
                "its length is not that from the gauge point of the spindle: it is not above zero"
                    .to_string()
            }
            (Some(Ok(outline)), Some(length)) => {
                let is_holder = |part: &(ToolPart, _)| part.0 == ToolPart::Holder;
                if !outline.parts.iter().any(is_holder) {
                    self.without_holder.push(number);
                }
                return tool_bodies(number, outline, length, &self.links, &self.chain);
            }
        };
        self.doubts.add(
            origin.span,
            format!("tool {number} is not checked: {reason}"),
            "give its shape, its length from the gauge point, its shank and its holder in the machine or setup file",
        );
        Vec::new()
    }

    fn follow(&mut self, followed: &FollowedMove, origin: &Origin, is_cut: bool) {
        self.moves += 1;
        if self.moves == 1 {
            self.add_unknown_start(origin);
        }
        if let Some(reason) = followed.not_followed {
            let reason = format!("this move is not checked: {reason}");
            return self.doubts.add(origin.span, reason, "no move with this reason is checked");
        }
        if self.tool == 0 && is_cut {
            let reason = "which tool is in the spindle is not known, so no tool is checked";
            let help = "name the tool in the program before its first cut";
            self.doubts.add(origin.span, reason.to_string(), help);
        }
        let Some(scene) = self.scenes.get(&self.tool).cloned() else { return };
        let mut unknown = AxisMask::NONE;
        for pair in &scene.pairs {
            if !followed.known.covers(pair.axes) {
                unknown = unknown.or(pair.axes.without(followed.known));
                continue;
            }
            self.follow_pair(&scene, pair, followed, origin);
        }
        if unknown != AxisMask::NONE {
            self.add_unknown(unknown, followed, origin);
        }
    }

    /// A run begins at the first reference point, and at 0 on axes for which it is not given: then nothing is proved.
    fn add_unknown_start(&mut self, origin: &Origin) {
        let home = AxisMask::with_values(&self.job.machine().home);
        let pairs = self.scenes.values().flat_map(|scene| &scene.pairs);
        let needed = pairs.fold(AxisMask::NONE, |axes, pair| axes.or(pair.axes));
        let unknown = needed.without(home);
        if unknown == AxisMask::NONE {
            return;
        }
        let letters: Vec<String> = unknown.iter().map(|axis| axis.to_string()).collect();
        let verb = if letters.len() == 1 { "stands" } else { "stand" };
        let reason = format!(
            "where {} {verb} before the program is not known: 0 in machine coordinates is assumed",
            letters.join(", ")
        );
        self.doubts.add(origin.span, reason, "give `[home]` of each axis in the machine file");
    }

    fn add_unknown(&mut self, unknown: AxisMask, followed: &FollowedMove, origin: &Origin) {
        let letters: Vec<String> = unknown.iter().map(|axis| axis.to_string()).collect();
        let verb = if letters.len() == 1 { "is" } else { "are" };
        let letters = letters.join(", ");
        let lacks_offset = followed.lacks_offset && unknown.and(AxisMask::LINEAR) != AxisMask::NONE;
        let (reason, help) = match lacks_offset {
            true => (
                format!(
                    "where {letters} {verb} in machine coordinates is not known, so this move is not checked in full: the work offset is not given"
                ),
                "give X, Y and Z of the work offset in `[work_offsets]`",
            ),
            false => (
                format!(
                    "where {letters} {verb} at the start or the end of this move is not known, so it is not checked in full"
                ),
                "give `[home]` in the machine file, where the axes stand before the program, or name each axis in it",
            ),
        };
        self.doubts.add(origin.span, reason, help);
    }

    fn follow_pair(
        &mut self,
        scene: &ToolScene,
        pair: &BodyPair,
        followed: &FollowedMove,
        origin: &Origin,
    ) {
        let bodies = pair.bodies.map(|body| &scene.bodies[body]);
        let check = PairCheck::new(&self.links, &bodies[0].linked, &bodies[1].linked);
        for piece in &followed.pieces {
            let allowed = self.budget.min(MAX_POSITIONS_OF_PIECE);
            let mut left = allowed;
            let answer = check.along(piece, self.options.tolerance_mm, &mut left);
            self.budget -= allowed - left;
            match answer {
                PairAnswer::Free => {}
                PairAnswer::Contact { share, .. } => {
                    let code = match pair.meaning {
                        ContactMeaning::Collision => Code::MachineCollision,
                        ContactMeaning::Doubt => Code::CollisionNotProved,
                    };
                    let is_kept = self.problems.len() < MAX_PROBLEMS;
                    let overlap = match is_kept {
                        true => check.deepest(piece, share, self.options.tolerance_mm),
                        false => PairOverlap { share, depth_mm: 0.0, distance_mm: 0.0 },
                    };
                    self.contact(code, bodies, piece, overlap, origin, true);
                }
                PairAnswer::Undecided { share } => {
                    let overlap = PairOverlap { share, depth_mm: 0.0, distance_mm: 0.0 };
                    self.contact(Code::CollisionNotProved, bodies, piece, overlap, origin, false);
                }
            }
        }
    }

    /// Adds a contact, or deepens that of the same bodies in the same block.
    fn contact(
        &mut self,
        code: Code,
        bodies: [&MachineBody; 2],
        piece: &AxisMove,
        overlap: PairOverlap,
        origin: &Origin,
        is_decided: bool,
    ) {
        self.hits += u64::from(code == Code::MachineCollision);
        let names = bodies.map(|body| body.title.clone());
        let source = self.job.sources().get(origin.span.file);
        let at = piece.at(overlap.share);
        let has_axis = |axis: usize| self.job.machine().axes[axis].is_some();
        let problem = CollisionProblem {
            code,
            file: source.map_or("", |source| source.name()).to_string(),
            line: origin.line,
            bodies: names.clone(),
            depth_mm: overlap.depth_mm,
            distance_mm: overlap.distance_mm,
            axes: std::array::from_fn(|axis| has_axis(axis).then_some(at[axis])),
        };
        let diagnostic = match is_decided {
            true => contact_diagnostic(&problem, origin, self.units),
            false => budget_diagnostic(&problem, origin),
        };
        self.last.retain(|(known, ..)| known == origin);
        if let Some((.., index)) = self.last.iter().find(|(_, known, _)| *known == names) {
            let known = &mut self.problems[*index];
            let is_worse = match (problem.code, known.code) {
                (Code::MachineCollision, Code::CollisionNotProved) => true,
                (Code::CollisionNotProved, Code::MachineCollision) => false,
                _ => problem.depth_mm > known.depth_mm,
            };
            if is_worse {
                (*known, self.diagnostics[*index]) = (problem, diagnostic);
            }
            return;
        }
        if self.problems.len() >= MAX_PROBLEMS {
            self.more += 1;
            return;
        }
        self.last.push((*origin, names, self.problems.len()));
        self.problems.push(problem);
        self.diagnostics.push(diagnostic);
    }

    fn finish(mut self, mut report: crate::report::Report) -> CollisionReport {
        let has_pairs = self.most_pairs > 0;
        if report.outcomes.len() > 1 {
            let reason = "the text holds several programs, and where the axes stand between them is not known";
            let help = "check one program at a time with --program";
            self.doubts.add(Span::default(), reason.to_string(), help);
        }
        let is_proved = has_pairs
            && self.doubts.diagnostics.is_empty()
            && self.problems.is_empty()
            && self.more == 0
            && report.is_path_verified();
        let has_errors = report.counts.errors > 0;
        self.diagnostics.append(&mut self.doubts.diagnostics);
        if !has_pairs && self.is_known {
            let message = "nothing was compared: no two bodies are given that could collide";
            let help = "give `[solids]` in the machine file, fixtures in the setup, and the tools with their lengths";
            let diagnostic = Diagnostic::new(Code::NothingToCollide, Span::default(), message);
            self.diagnostics.push(diagnostic.help(help));
        }
        report.add(self.diagnostics);
        CollisionReport {
            tolerance_mm: self.options.tolerance_mm,
            verdict: match (self.hits > 0 || has_errors, is_proved) {
                (true, _) => CollisionVerdict::Problems,
                (false, true) => CollisionVerdict::Clean,
                (false, false) => CollisionVerdict::NotProved,
            },
            bodies: self.titles,
            without_holder: self.without_holder,
            pairs: self.most_pairs,
            moves: self.moves,
            positions: self.options.budget - self.budget,
            problems: self.problems,
            more_problems: self.more,
            report,
        }
    }
}

impl RunWatch for CollisionRun<'_> {
    fn path(&mut self, path: PathCommand<'_>, _: &[Segment]) {
        let command = path.command;
        if let CommandKind::Tool { number } | CommandKind::ToolNumber { number } = command.kind {
            self.tool = number;
            self.use_tool(&command.origin);
        }
        if let CommandKind::Units(units) = &command.kind {
            self.units = *units;
        }
        if let Some(followed) = self.follower.follow(command)
            && self.is_known
        {
            let is_cut = command.kind.feed().is_some();
            self.follow(&followed, &command.origin, is_cut);
        }
    }
}
