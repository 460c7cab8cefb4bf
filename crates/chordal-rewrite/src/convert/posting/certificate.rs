//! The proof that a program written from its run does the same.

use chordal::{CommandKind, Job, Machine};

use super::super::ConversionOptions;
use super::super::certify::{ProofTerms, proof};
use super::places::turns_of_tool_axis;
use super::recorded::RecordedRun;
use super::tables::{TableSet, UsedNumbers};
use crate::Certificate;

/// What is proved: a text on the machine of the new control, and the old job.
pub(super) struct PostedProof<'a> {
    pub old: &'a Job<'a>,
    /// The target with the tables of the old machine.
    pub machine: &'a Machine,
    pub used: &'a UsedNumbers,
    pub options: &'a ConversionOptions,
}

/// What the proof found.
pub(super) struct ProofOutcome {
    pub certificate: Certificate,
    /// The tool's axis does not make the same machine positions.
    pub other_tool_axis: Option<String>,
}

impl PostedProof<'_> {
    /// Compares the path, and the machine positions of the tool's axis; `None` where the machine has settings that its
    /// control does not know.
    pub fn of(&self, text: &str) -> Option<ProofOutcome> {
        let certificate = self.paths(text)?;
        let other_tool_axis = self.tool_axis(text)?;
        Some(ProofOutcome { certificate, other_tool_axis })
    }

    /// The paths, on machines whose tools all have the length zero: which length is active does not show in them.
    fn paths(&self, text: &str) -> Option<Certificate> {
        let [old, new] = self.jobs(text, TableSet::WITHOUT_LENGTHS)?;
        let commands = RecordedRun::of(&old).commands;
        // Text that was printed is a comment now.
        let printed =
            commands.iter().any(|command| matches!(command.kind, CommandKind::Output { .. }));
        let terms = ProofTerms { is_other_language: true, printed, ..ProofTerms::default() };
        Some(proof(&commands, [&old, &new], self.options, terms))
    }

    /// The machine positions of the tool's axis, with a length for each tool of its own.
    fn tool_axis(&self, text: &str) -> Option<Option<String>> {
        let has_lengths =
            |job: &Job| job.word_address().is_none_or(super::super::codes::has_lengths);
        let [old, new] = self.jobs(text, TableSet::FIRST)?;
        if ![&old, &new].into_iter().all(has_lengths) {
            return Some(None);
        }
        let places = [&old, &new].map(|job| turns_of_tool_axis(job, &RecordedRun::of(job)));
        let most = self.options.tolerance_mm;
        let is_same = places[0].len() == places[1].len()
            && places[0].iter().zip(&places[1]).all(|(a, b)| (a - b).abs() <= most);
        Some((!is_same).then(|| {
            let differs = places[0].iter().zip(&places[1]).position(|(a, b)| (a - b).abs() > most);
            let at = differs.unwrap_or(places[0].len().min(places[1].len()));
            format!(
                "the lengths of the tools do not act the same way: the axis of the tool turns round at another place the {}. time",
                at + 1
            )
        }))
    }

    fn jobs(&self, text: &str, tables: TableSet) -> Option<[Job<'_>; 2]> {
        let own = tables.fill(self.old.machine(), self.old.profile(), self.used);
        let old = self.old.on_machine(own).ok()?;
        let profile = chordal::control::control_profile(self.machine.control)?;
        let machine = tables.fill(self.machine, profile, self.used);
        let new = super::super::job("converted", text.to_string(), &machine)?;
        Some([old, new])
    }
}
