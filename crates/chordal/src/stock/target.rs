//! The target part: where cuts go into it, and what is left on it.

use chordal_diagnostics::Code;
use chordal_geometry::{ParamCurve, Transform, Vec3};
use chordal_stock::shape::SolidShape;
use chordal_stock::{
    AxialSolid, ColumnOptions, ColumnStock, RevolvedBody, StockCheck, StockError, StockTask,
    TipMove, TurningTask, VolumeInterval,
};

use super::gather::MoveBatch;
use super::heights::ShapeHeights;
use super::inside::{InnerCertainty, InnerCutter};
use super::pass::PassContext;
use super::problems::StockProblems;
use super::solid_intervals::{ColumnKnowledge, intervals_of, without};

/// Contacts that are less deep than this are rounding, mm.
const CONTACT_ROUNDING_MM: f64 = 1e-3;
/// The side of the finest cells as a share of the tolerance.
const OF_TOLERANCE: f64 = 0.5;

/// The default tolerance of a target part, mm.
pub(super) const TARGET_TOLERANCE: f64 = 0.05;

/// A target part with its tolerance, mm.
pub(super) struct TargetPart {
    /// A shape that contains it, and one that it contains.
    pub shapes: [SolidShape; 2],
    pub tolerance: f64,
}

/// What is left on the target part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TargetReport {
    /// Volume of material outside the part, mm³.
    pub left_over_mm3: VolumeInterval,
    /// Largest height of that material, mm: at least and at most.
    pub highest_mm: VolumeInterval,
    /// Where it is highest, in the frame of the run, mm.
    pub at: Vec3,
}

/// Finds cuts into the part, and what is left on it of a stock that was cut in this orientation alone (`None` without
/// that stock).
pub(super) fn look_at_target(
    run: &PassContext<'_>,
    target: &TargetPart,
    stock: Option<&ColumnStock>,
    problems: &mut StockProblems,
) -> Result<Option<TargetReport>, StockError> {
    let [outer, inner] = &target.shapes;
    let heights = ShapeHeights::between([outer, inner], run.resolution);
    look_for_gouges(run, target, &heights, problems)?;
    Ok(stock.map(|stock| left_over(&heights, stock)))
}

/// Finds gouges: the cutter inset by the tolerance touches the part exactly where the true one is deeper in it than
/// the tolerance.
fn look_for_gouges(
    run: &PassContext<'_>,
    target: &TargetPart,
    heights: &ShapeHeights<'_>,
    problems: &mut StockProblems,
) -> Result<(), StockError> {
    let bounds = heights.bounds();
    let mut questions: Vec<TargetQuestion<'_>> = Vec::new();
    for batch in run.batches.iter().filter(|batch| !batch.kind.is_rapid()) {
        let Some(tool) = run.tool(batch.tool) else { continue };
        if !batch.tool_turns.is_empty() {
            match tool.inside_solid(target.tolerance) {
                Some(solid) => questions.push(TargetQuestion {
                    batch,
                    bodies: Vec::new(),
                    turning: Some([solid]),
                    is_sure: true,
                    moves: batch.moves.clone(),
                }),
                None => problems.undecided += 1,
            }
            continue;
        }
        let Some(InnerCutter { holds, sure, lift }) = tool.inside(target.tolerance) else {
            problems.undecided += 1;
            continue;
        };
        let is_sure = !matches!(sure, InnerCertainty::Nothing);
        let bodies = match sure {
            InnerCertainty::Body(sure) => vec![holds, sure],
            InnerCertainty::Same | InnerCertainty::Nothing => vec![holds],
        };
        let up = Transform::translation(Vec3::new(0.0, 0.0, lift));
        let moves =
            batch.moves.iter().map(|path| TipMove { curve: path.curve.transformed(&up), ..*path });
        let moves = moves.collect();
        questions.push(TargetQuestion { batch, bodies, turning: None, is_sure, moves });
    }
    let tasks: Vec<StockTask<'_>> = questions
        .iter()
        .map(|question| StockTask {
            bodies: &question.bodies,
            turning: question.turning.as_ref().map(|bodies| TurningTask {
                turns: &question.batch.tool_turns,
                removes: None,
                may: None,
                bodies,
            }),
            moves: &question.moves,
            drop: f64::INFINITY,
            ..StockTask::default()
        })
        .collect();
    let hollows = |corners: [[f64; 2]; 2]| heights.hollows(corners);
    let is_hollow = heights.is_hollow();
    let heights = |low: [f64; 2], high: [f64; 2]| heights.of(low, high);
    let check = StockCheck {
        bounds,
        options: ColumnOptions { middles: false, ..run.columns() },
        heights: &heights,
        hollows: is_hollow.then_some(&hollows),
        tasks: &tasks,
        lowered: &[],
        tolerance: CONTACT_ROUNDING_MM,
        finest: run.finest().min(OF_TOLERANCE * target.tolerance),
    };
    let checked = check.run_by(&|tiles| run.tiles(tiles))?;
    for (question, contacts) in questions.iter().zip(&checked.contacts) {
        let batch = question.batch;
        for (index, origin) in batch.origins.iter().enumerate() {
            let place = run.place(*origin, batch.tool);
            let mut contact = contacts[0][index];
            // The last body is the one that is certainly inside.
            contact.least = match contacts.last() {
                Some(sure) if question.is_sure => sure[index].least.min(contact.most),
                _ => 0.0,
            };
            if contact.most > CONTACT_ROUNDING_MM {
                // The depth of the true cutter is that of its inset plus the tolerance.
                contact.most += target.tolerance;
                if contact.least > CONTACT_ROUNDING_MM {
                    contact.least += target.tolerance;
                }
            }
            problems.touches([(Code::Gouge, contact)].into_iter(), CONTACT_ROUNDING_MM, &place);
        }
    }
    Ok(())
}

/// The moves of a batch with the inset of its tool.
struct TargetQuestion<'a> {
    batch: &'a MoveBatch,
    /// A body that contains the inset and, where it is another, one that is certainly inside.
    bodies: Vec<RevolvedBody>,
    /// The inset where the tool is not upright, in place of these.
    turning: Option<[AxialSolid; 1]>,
    /// True where the last body is certainly inside the tool.
    is_sure: bool,
    moves: Vec<TipMove>,
}

fn length(intervals: &[[f64; 2]]) -> f64 {
    intervals.iter().map(|[from, to]| to - from).sum()
}

fn left_over(heights: &ShapeHeights<'_>, stock: &ColumnStock) -> TargetReport {
    let grid = stock.grid();
    let [columns, rows] = grid.cells();
    let pairs = stock.height_pairs();
    let mut left = VolumeInterval::default();
    let mut highest = VolumeInterval::default();
    let mut at = Vec3::ZERO;
    for row in 0..rows {
        let mut of_row = VolumeInterval::default();
        for column in 0..columns {
            let [low, high] = grid.corners(column, row);
            let area = (high[0] - low[0]) * (high[1] - low[1]);
            let pair = pairs[row as usize * columns as usize + column as usize];
            let [may_be, is] = heights.filled([low, high]);
            let over = |known: ColumnKnowledge, height: f64, part: &[[f64; 2]]| {
                let left = intervals_of(stock, [column, row], known, height);
                part.iter().fold(left, |left, own| without(&left, *own))
            };
            // What is certainly left and outside of all that may be part, and what may be left and is not certainly
            // part.
            let surely = over(ColumnKnowledge::Surely, pair.inner, &may_be);
            let maybe = over(ColumnKnowledge::Maybe, pair.outer, &is);
            let [least, most] = [&surely, &maybe].map(|over| length(over));
            of_row.least += area * least;
            of_row.most += area * most;
            let thickest =
                |over: &[[f64; 2]]| over.iter().map(|[from, to]| to - from).fold(0.0, f64::max);
            if thickest(&surely) > highest.least {
                highest.least = thickest(&surely);
                let top = surely.last().map_or(pair.inner, |last| last[1]);
                at = Vec3::new(0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), top);
            }
            highest.most = highest.most.max(thickest(&maybe));
        }
        left.least += of_row.least;
        left.most += of_row.most;
    }
    TargetReport { left_over_mm3: left, highest_mm: highest, at }
}
