//! Checks the approach of a tool to the place where a program is restarted against the stock that is left there.

use std::ops::Range;

use chordal_command::Origin;
use chordal_diagnostics::FileId;
use chordal_stock::lathe::{LatheStock, Region};

use super::super::run::StockRunError;
use super::super::setup::{NamedBody, SetupFileReader, shift_between};
use super::bodies::grown;
use super::cut::{TurnedFixture, TurnedRun};
use super::gather::{TurnMove, TurnedMoveKind, TurnedMoves};
use super::problems::TurnedProblems;
use super::run::TurnedOptions;
use super::tools::tools_of;
use crate::job::Job;

/// A collision of the approach.
#[derive(Clone, Debug, PartialEq)]
pub struct ApproachHit {
    /// The line of the new program that causes it.
    pub line: u32,
    /// How deep, mm.
    pub depth_mm: f64,
    /// Its place: Z and radius, mm.
    pub at: [f64; 2],
    /// What happens, as a sentence.
    pub what: String,
}

/// The approach to a line, on the stock that the moves before it have left.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ApproachCheck {
    /// Number of moves that were checked.
    pub moves: u64,
    /// The collisions, in the order of the moves.
    pub hits: Vec<ApproachHit>,
    /// Why the check is incomplete; `None` where it is complete.
    pub unknown: Option<String>,
}

impl Job<'_> {
    /// Checks whether the first moves of `new`, those of the blocks in `head` (bytes of its first text), meet what
    /// this program has left at that point. After these moves, both programs must do the same.
    ///
    /// # Errors
    /// Without stock, or with a setup that is incomplete.
    pub fn check_turned_approach(
        &self,
        new: &Job<'_>,
        head: Range<u32>,
        options: &TurnedOptions,
        files: SetupFileReader<'_>,
    ) -> Result<ApproachCheck, StockRunError> {
        let tools = tools_of(self);
        let (naming, units) = (self.profile().work_names, self.rules().units);
        let mut gathered =
            [TurnedMoves::new(&tools, naming, units), TurnedMoves::new(&tools, naming, units)];
        self.report_watched(&mut gathered[0]);
        new.report_watched(&mut gathered[1]);
        let [old, begun] = gathered;
        let is_head = |origin: &Origin| {
            origin.span.file == FileId(0) && head.contains(&origin.span.range.start)
        };
        let course: Vec<TurnMove> =
            begun.moves.iter().take_while(|one| is_head(&one.origin)).copied().collect();
        let after = begun.moves.len() - course.len();
        let mut found = ApproachCheck { moves: course.len() as u64, ..ApproachCheck::default() };
        let Some(before) = old.moves.len().checked_sub(after) else {
            found.unknown = Some("the moves after the line are not the same".into());
            return Ok(found);
        };
        let setup = &self.machine().setup;
        let section_of =
            |name: &str, body: &chordal_machine::Body| -> Result<Region, StockRunError> {
                let named = NamedBody { name, body };
                let shift = shift_between(self.machine(), &named, old.work.as_deref())?;
                Ok(named.section(shift, files)?)
            };
        let premise = self.stock_premise()?;
        let stock = section_of("stock", &premise.body)?;
        let mut cutting = TurnedRun::new(
            &tools,
            options.tolerance_mm,
            &stock,
            TurnedProblems::new(old.units, self.sources()),
        );
        let moves: Vec<TurnMove> = old.moves[..before].iter().chain(&course).copied().collect();
        for number in 0..before {
            if self.is_interrupted() {
                return Err(StockRunError::Interrupted);
            }
            cutting.step(number, &moves);
        }
        if !old.is_whole() {
            found.unknown = Some("not every move before the line is cut from the stock".into());
        } else if cutting.found.undecided > 0 {
            found.unknown = Some("a move before the line could not be cut exactly".into());
        }
        // Fixtures are checked only from here on: the moves before have been run already.
        for (name, body) in &setup.fixtures {
            let section = section_of(&format!("fixtures.{name}"), body)?;
            let clearance = body.clearance_mm.unwrap_or(0.0);
            let body = LatheStock::new(&grown(&section, clearance));
            cutting.fixtures.push(TurnedFixture { name, clearance, body });
        }
        cutting.found = TurnedProblems::new(old.units, new.sources());
        for number in before..moves.len() {
            meet(&mut cutting, number, &moves, &mut found);
        }
        Ok(found)
    }
}

/// Carries out a move of the approach, and records its collisions.
fn meet(cutting: &mut TurnedRun<'_>, number: usize, moves: &[TurnMove], found: &mut ApproachCheck) {
    let (known, cuts) = (cutting.found.list.len(), cutting.moves.len());
    cutting.step(number, moves);
    let move_ = &moves[number];
    let line = move_.origin.line;
    let problems = cutting.found.list.iter().zip(&cutting.found.diagnostics).skip(known);
    for (problem, diagnostic) in problems {
        found.hits.push(ApproachHit {
            line,
            depth_mm: problem.depth_mm.most,
            at: [problem.at.z, problem.at.x],
            what: diagnostic.message.clone(),
        });
    }
    let deepest = cutting.moves[cuts..].iter().max_by(|a, b| a.depth_mm.total_cmp(&b.depth_mm));
    if let Some(cut) = deepest.filter(|cut| {
        move_.kind != TurnedMoveKind::Rapid
            && cut.depth_mm > cutting.tolerance
            && cut.area_mm2 > 0.0
    }) {
        let depth = cutting.found.units.length_text(cut.depth_mm);
        found.hits.push(ApproachHit {
            line,
            depth_mm: cut.depth_mm,
            at: [move_.path.end.a, move_.path.end.b],
            what: format!("tool {} cuts {depth} deep into what stands there", move_.tool),
        });
    }
}
