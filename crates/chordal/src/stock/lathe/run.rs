//! A run of a lathe on stock.

use chordal_diagnostics::Code;
use chordal_machine::Body;
use chordal_stock::VolumeInterval;
use chordal_stock::lathe::Region;

use super::super::engagement::MaterialData;
use super::super::report::{StockVerdict, knows_tips};
use super::super::run::{StockRunError, cut_other_sides};
use super::super::setup::{NamedBody, SetupError, SetupFileReader, shift_between};
use super::super::target::TARGET_TOLERANCE;
use super::bodies::grown;
use super::cut::{TurnedFixture, TurnedRun};
use super::gather::{TurnMove, TurnedMoves};
use super::load::{give_power, overloads};
use super::nose::look_at_surface;
use super::problems::{MessageDetail, ProblemLocation, TurnedProblems};
use super::recorder::SectionRecorder;
use super::report::TurnedReport;
use super::target::TurnedTargetPart;
use super::tools::{LatheTool, tools_of};
use crate::job::Job;
use crate::report::Report;

/// Moves between two checks for an interruption.
const MOVES_PER_CHECK: usize = 256;

/// The options of a run on turned stock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnedOptions {
    /// Touches that are no deeper than this are ignored, mm.
    pub tolerance_mm: f64,
    /// Whether to record the section after every pass, see [`TurnedReport::replay`].
    pub replay: bool,
}

impl Default for TurnedOptions {
    /// Touches from 0.01 mm on.
    fn default() -> TurnedOptions {
        TurnedOptions { tolerance_mm: 0.01, replay: false }
    }
}

impl Job<'_> {
    /// Whether the machine is a lathe, whose stock is simulated by [`Job::turned_stock`].
    pub fn turns(&self) -> bool {
        self.machine().turns()
    }

    /// Runs a lathe program on the stock of its machine's setup; `files` reads the drawings that the setup names.
    ///
    /// # Errors
    /// Without stock, or with a setup that is incomplete.
    pub fn turned_stock(
        &self,
        options: &TurnedOptions,
        files: SetupFileReader<'_>,
    ) -> Result<TurnedReport, StockRunError> {
        let mut found = self.turned_stock_of_run(options, files)?;
        cut_other_sides(self, &mut found.report, &mut found.verdict, |job| {
            let side = job.turned_stock_of_run(options, files).ok()?;
            Some((side.report, side.verdict))
        });
        Ok(found)
    }

    /// Cuts the stock with one run.
    fn turned_stock_of_run(
        &self,
        options: &TurnedOptions,
        files: SetupFileReader<'_>,
    ) -> Result<TurnedReport, StockRunError> {
        let tools = tools_of(self);
        let mut gathered = TurnedMoves::new(&tools, self.profile().work_names, self.rules().units);
        let report = self.report_watched(&mut gathered);
        let section_of = |name: &str, body: &Body| -> Result<Region, SetupError> {
            let named = NamedBody { name, body };
            let shift = shift_between(self.machine(), &named, gathered.work.as_deref())?;
            named.section(shift, files)
        };
        let setup = &self.machine().setup;
        let premise = self.stock_premise()?;
        let stock = section_of("stock", &premise.body)?;
        let found = TurnedProblems::new(gathered.units, self.sources());
        let mut cutting = TurnedRun::new(&tools, options.tolerance_mm, &stock, found);
        if options.replay {
            cutting.recorder = Some(SectionRecorder::new(&stock));
        }
        for (name, body) in &setup.fixtures {
            let section = section_of(&format!("fixtures.{name}"), body)?;
            if let Some(recorder) = &mut cutting.recorder {
                recorder.fixture(name, &section);
            }
            let clearance = body.clearance_mm.unwrap_or(0.0);
            let body = chordal_stock::lathe::LatheStock::new(&grown(&section, clearance));
            cutting.fixtures.push(TurnedFixture { name, clearance, body });
        }
        if let Some(body) = &setup.target {
            let tolerance = body.tolerance_mm.unwrap_or(TARGET_TOLERANCE);
            cutting.target = Some(TurnedTargetPart::new(section_of("target", body)?, tolerance));
        }
        for number in 0..gathered.moves.len() {
            if number % MOVES_PER_CHECK == 0 && self.is_interrupted() {
                return Err(StockRunError::Interrupted);
            }
            cutting.step(number, &gathered.moves);
        }
        let mut found = self.finish(report, &stock, cutting, gathered, options);
        let doubt = premise.doubt(found.removed_mm3.most, !found.tools.is_empty());
        if doubt.is_some() && found.verdict == StockVerdict::Clean {
            found.verdict = StockVerdict::NotProved;
        }
        found.report.add(premise.note().into_iter().chain(doubt));
        Ok(found)
    }

    fn finish(
        &self,
        mut report: Report,
        before: &Region,
        mut cutting: TurnedRun<'_>,
        gathered: TurnedMoves<'_>,
        options: &TurnedOptions,
    ) -> TurnedReport {
        let section = cutting.stock.region();
        let recorder = cutting.recorder.take();
        let replay =
            recorder.map(|recorder| recorder.finish(&section, cutting.tools, &gathered.moves));
        let loose = std::mem::take(&mut cutting.loose);
        let sections: Vec<&Region> =
            std::iter::once(&section).chain(loose.iter().map(|part| &part.section)).collect();
        let tolerance = options.tolerance_mm;
        cutting.grooves.look(&sections, &gathered.moves, tolerance, &mut cutting.found);
        let tool_of = |number: u32| -> Option<&LatheTool> {
            cutting.tools.get(&number).and_then(|tool| tool.as_ref().ok())
        };
        for section in &sections {
            look_at_surface(section, &gathered.moves, tool_of, tolerance, &mut cutting.found);
        }
        let target = cutting.target.as_ref().map(|target| target.compare(&sections));
        if let (Some(found), Some(target), Some(last)) =
            (&target, &cutting.target, gathered.moves.last())
            && found.highest_mm > target.tolerance
        {
            let at = ProblemLocation { origin: last.origin, tool: last.tool, place: found.at };
            cutting.found.push(Code::MaterialLeft, found.highest_mm, &at, MessageDetail::Nothing);
        }
        // Threads are not cut from the sections: what they remove is part of what is left.
        let of_threads = cutting.most_of_threads(&sections);
        let left: f64 = sections.iter().map(|section| section.volume()).sum();
        let before_mm3 = before.volume();
        // Nobody knows what the cuts remove that are not simulated.
        let surely_left = if gathered.is_whole() { left - of_threads } else { 0.0 };
        let mut moves = std::mem::take(&mut cutting.moves);
        let mut tools = cutting.tools_in_order();
        let setup = &self.machine().setup;
        let material = setup.stock.as_ref().and_then(|stock| stock.material.as_deref());
        if let Some(Ok(material)) = material.map(|word| MaterialData::of(word, &setup.materials)) {
            give_power(&mut moves, &mut tools, &material);
        }
        let mut too_hard = overloads(self, &mut moves, gathered.units);
        let TurnedRun { found, threads, target: target_part, bound, .. } = cutting;
        let has_problems = found.hits > 0 || !too_hard.is_empty() || report.counts.errors > 0;
        let is_proved = gathered.is_whole()
            && found.undecided == 0
            && report.is_path_verified()
            && knows_tips(&report);
        let mut diagnostics = found.diagnostics;
        diagnostics.extend(gathered.diagnostics);
        diagnostics.append(&mut too_hard);
        report.add(diagnostics);
        TurnedReport {
            before_mm3,
            removed_mm3: VolumeInterval {
                least: before_mm3 - left,
                most: before_mm3 - surely_left,
            },
            left_mm3: VolumeInterval { least: surely_left, most: left },
            bound_mm: bound,
            verdict: match (has_problems, is_proved) {
                (true, _) => StockVerdict::Problems,
                (false, true) => StockVerdict::Clean,
                (false, false) => StockVerdict::NotProved,
            },
            problems: found.list,
            more_problems: found.more,
            tools,
            moves,
            before: before.clone(),
            section,
            loose,
            threads,
            target_section: target_part.map(|target| target.section),
            target,
            makers: gathered.moves.iter().map(TurnMove::maker).collect(),
            replay,
            report,
        }
    }
}
