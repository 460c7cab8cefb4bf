//! The proof that a program written from its run does the same.

use chordal::{Command, CommandKind, Job, Machine};
use chordal_compare::{Category, Difference, DifferenceValue};

use super::super::certify::{ProofTerms, proof};
use super::super::{ConversionOptions, codes, job};
use super::places::turns_of_tool_axis;
use super::program_tools::ProgramTools;
use super::recorded::RecordedRun;
use super::tables::{FilledLengths, TableSet, UsedNumbers};
use crate::Certificate;

/// What texts on the machine of the new control are compared with: the old program, run once on each set of tables.
pub(super) struct PostedProof<'a> {
    /// The target with the tables of the old machine.
    machine: &'a Machine,
    used: &'a UsedNumbers,
    tools: &'a ProgramTools,
    options: &'a ConversionOptions,
    /// The old program with tools of length zero: which length is active does not show in its path.
    without_lengths: Job<'a>,
    /// Its commands.
    commands: Vec<Command>,
    /// The old program with a length for each tool of its own.
    with_lengths: Job<'a>,
    /// The machine positions of its tool axis.
    turns: Vec<f64>,
}

/// A program of the old control whose tool centre goes as that of the old one, with other compensated contours.
pub(super) struct ContourTwin {
    job: Job<'static>,
    commands: Vec<Command>,
    /// How far its path is from that of the old program, mm.
    distance_mm: f64,
}

/// Compensation is active where it was not: the path of the tool centre says whether that is right.
fn begins_compensation(difference: &Difference) -> bool {
    difference.category == Category::RadiusOffset
        && matches!(difference.values, Some([DifferenceValue::Nothing, DifferenceValue::Number(_)]))
}

/// What the proof found.
pub(super) struct ProofOutcome {
    pub certificate: Certificate,
    /// The tool's axis does not make the same machine positions.
    pub other_tool_axis: Option<String>,
}

impl<'a> PostedProof<'a> {
    /// Runs the old program; `None` where its machine has settings that its control does not know.
    pub fn new(
        old: &'a Job<'a>,
        machine: &'a Machine,
        used: &'a UsedNumbers,
        tools: &'a ProgramTools,
        options: &'a ConversionOptions,
    ) -> Option<PostedProof<'a>> {
        let on = |tables: TableSet| {
            let mut machine = tables.fill(old.machine(), old.profile(), used);
            tools.put_lengths_into(&mut machine);
            if tables.lengths == FilledLengths::Zero {
                tools.cancel_allowances(&mut machine);
            }
            old.on_machine(machine).ok()
        };
        let [without_lengths, with_lengths] =
            [on(TableSet::WITHOUT_LENGTHS)?, on(TableSet::FIRST)?];
        let commands = RecordedRun::of(&without_lengths).commands;
        let turns = turns_of_tool_axis(&with_lengths, &RecordedRun::of(&with_lengths));
        Some(PostedProof {
            machine,
            used,
            tools,
            options,
            without_lengths,
            commands,
            with_lengths,
            turns,
        })
    }

    /// A text for the old machine, whose contours may stand for those of the old program; `None` where its tool centre does not
    /// go the same way.
    pub fn contour_twin(&self, old: &Job, text: String) -> Option<ContourTwin> {
        let tables = TableSet::WITHOUT_LENGTHS;
        let mut machine = tables.fill(old.machine(), old.profile(), self.used);
        self.tools.put_into(&mut machine);
        self.tools.cancel_allowances(&mut machine);
        let job = job("contours", text, &machine)?;
        let mut same =
            proof(&self.commands, [&self.without_lengths, &job], self.options, self.terms());
        same.set_aside(begins_compensation);
        if !same.holds() || same.tool_center.is_some() {
            return None;
        }
        let commands = RecordedRun::of(&job).commands;
        let distance_mm = same.comparison.max_distance_mm.unwrap_or(0.0);
        Some(ContourTwin { job, commands, distance_mm })
    }

    /// Compares the path, or the contours with those of a twin, and the machine positions of the tool's axis; `None` where the
    /// machine has settings that its control does not know.
    pub fn of(&self, text: &str, twin: Option<&ContourTwin>) -> Option<ProofOutcome> {
        let certificate = self.paths(text, twin)?;
        let other_tool_axis = self.tool_axis(text)?;
        Some(ProofOutcome { certificate, other_tool_axis })
    }

    /// The paths, on machines whose tools all have the length zero.
    fn paths(&self, text: &str, twin: Option<&ContourTwin>) -> Option<Certificate> {
        let new = self.job(text, TableSet::WITHOUT_LENGTHS)?;
        let own = proof(&self.commands, [&self.without_lengths, &new], self.options, self.terms());
        let Some(twin) = twin.filter(|_| !own.holds()) else { return Some(own) };
        // Both steps together keep to the tolerance.
        let tolerance_mm = self.options.tolerance_mm - twin.distance_mm;
        let options = ConversionOptions { tolerance_mm, ..self.options.clone() };
        let contours = proof(&twin.commands, [&twin.job, &new], &options, self.terms());
        if !contours.holds() {
            return Some(own);
        }
        let tool_center = contours.tool_center.is_some().then_some(own.comparison);
        Some(Certificate { tool_center, ..contours })
    }

    fn terms(&self) -> ProofTerms {
        // Text that was printed is a comment now.
        let printed =
            self.commands.iter().any(|command| matches!(command.kind, CommandKind::Output { .. }));
        ProofTerms { is_other_language: true, printed, ..ProofTerms::default() }
    }

    /// The machine positions of the tool's axis, with a length for each tool of its own.
    fn tool_axis(&self, text: &str) -> Option<Option<String>> {
        let new = self.job(text, TableSet::FIRST)?;
        if !codes::all_have_lengths([&self.with_lengths, &new]) {
            return Some(None);
        }
        let (before, after) = (&self.turns, turns_of_tool_axis(&new, &RecordedRun::of(&new)));
        let is_same = |(one, other): (&f64, &f64)| (one - other).abs() <= self.options.tolerance_mm;
        let place = before.iter().zip(&after).position(|pair| !is_same(pair));
        let place = place.or((before.len() != after.len()).then(|| before.len().min(after.len())));
        Some(place.map(|at| {
            format!(
                "the lengths of the tools do not act the same way: the axis of the tool turns round at another place the {}. time",
                at + 1
            )
        }))
    }

    /// A text on the target with a set of tables.
    fn job(&self, text: &str, tables: TableSet) -> Option<Job<'static>> {
        let profile = chordal::control::control_profile(self.machine.control)?;
        let mut machine = tables.fill(self.machine, profile, self.used);
        self.tools.put_into(&mut machine);
        if tables.lengths == FilledLengths::Zero {
            self.tools.cancel_allowances(&mut machine);
        }
        job("converted", text.to_string(), &machine)
    }
}
