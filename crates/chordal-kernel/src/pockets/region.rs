//! A pocket of any outline: at each level a pass along the wall that leaves the allowance, then rows; after the
//! last level one finishing pass along the walls.

use chordal_command::{AxisMask, Feed, Move, Position};
use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_geometry::Vec2;

use super::MAX_RINGS;
use super::shapes::{Outline, PocketRegion, RasterAlong, Step, inset};
use crate::kernel::Kernel;
use crate::statement::{Statement, WordMeaning};

/// A depth that misses the last level by less than this, mm, is that level.
const LEVEL_EPSILON_MM: f64 = 1e-9;

/// A wall further than this from the tool, mm, is not reached.
const UNREACHED_MM: f64 = 1e-3;

/// Largest number of moves of one pocket, to bound memory.
const MAX_POCKET_MOVES: usize = 2_000_000;

const Z: AxisMask = AxisMask(0b100);

/// The words of a pocket with an outline; lengths in mm.
#[derive(Clone, Debug)]
pub struct RegionWords<'w> {
    /// The word that mills it.
    pub word: Span,
    /// Its name, for people.
    pub name: &'w str,
    /// The outline of the walls.
    pub outline: &'w Outline,
    /// The radius of the tool.
    pub tool: f64,
    /// The start hole.
    pub start: Position,
    /// The axes of the start hole that the statement names.
    pub named: AxisMask,
    /// Z where the feed begins.
    pub r: f64,
    /// Z of each level, downwards.
    pub levels: Vec<f64>,
    /// The axis along which the rows step.
    pub along: RasterAlong,
    /// Distance between rows.
    pub step: f64,
    /// Finishing allowance at the walls.
    pub allowance: f64,
}

/// The levels R − Q, R − 2Q, …, Z, mm; `None` for more than [`MAX_RINGS`].
pub fn rings_to_depth(r: f64, z: f64, q: f64) -> Option<Vec<f64>> {
    let count = ((r - z - LEVEL_EPSILON_MM) / q).ceil().max(1.0);
    if count > f64::from(MAX_RINGS) {
        return None;
    }
    let mut levels: Vec<f64> = (1..count as u32).map(|level| r - f64::from(level) * q).collect();
    levels.push(z);
    Some(levels)
}

impl Kernel<'_> {
    /// Mills the pocket.
    pub fn mill_region(&mut self, at: &dyn Statement, words: &RegionWords<'_>) {
        let Some((rough, finish)) = self.region_paths(at, words) else { return };
        if words.levels.len().saturating_mul(rough.len()) > MAX_POCKET_MOVES {
            return self.report_too_many_passes(at.words(WordMeaning::Steps), "rows");
        }
        let label = format!("levels: {}", words.levels.len());
        let choice = "the order of its passes and the moves between them are assumed";
        self.note_assumed_path(words.word, words.name, choice, label);
        let mut over = words.start;
        over[2] = self.state.position[2];
        self.routine_rapid(over, words.named.and(AxisMask::XY));
        let mut down = self.state.position;
        down[2] = words.r;
        self.routine_rapid(down, Z);
        let feed = self.feed_of_pocket(at);
        for (pass, z) in words.levels.iter().enumerate() {
            if pass > 0 && !self.count_repeated() {
                return;
            }
            let mut target = self.state.position;
            target[2] = *z;
            self.routine_line(target, Z, feed);
            self.follow(&rough, feed, AxisMask::XY);
        }
        self.follow(&finish, feed, AxisMask::XY);
    }

    fn feed_of_pocket(&mut self, at: &dyn Statement) -> Feed {
        let state = &self.state;
        let motion = Move {
            from: state.position,
            to: state.position,
            from_known: state.known,
            to_known: state.known,
        };
        self.feed_for(at, &motion, None)
    }

    /// The path of a level and the finishing path; `None` when the tool does not fit, which is reported.
    fn region_paths(
        &mut self,
        at: &dyn Statement,
        words: &RegionWords<'_>,
    ) -> Option<(Vec<Step>, Vec<Step>)> {
        let (outline, start) = (words.outline, Vec2::new(words.start[0], words.start[1]));
        let keep = words.tool + words.allowance;
        let rough_border = inset(outline, keep);
        let Some(rough) = PocketRegion::around(outline, &rough_border, keep, start) else {
            self.report_no_room(words, keep);
            return None;
        };
        if words.tool > 0.0 && words.step > 2.0 * words.tool * (1.0 + 1e-9) {
            let left = self.length_text(words.step - 2.0 * words.tool);
            let tool = self.length_text(2.0 * words.tool);
            self.report(
                Diagnostic::new(
                    Code::PocketRidges,
                    at.words(WordMeaning::Stepover),
                    format!("ridges {left} wide stay between the passes: the tool is {tool}"),
                )
                .label("more than the diameter of the tool")
                .help("use a smaller stepover, or a larger tool"),
            );
        }
        let Ok(steps) = rough.clear(words.along, words.step, MAX_RINGS as usize) else {
            self.report_too_many_passes(at.words(WordMeaning::Stepover), "rows");
            return None;
        };
        let wall_border = inset(outline, words.tool);
        let walls = PocketRegion::around(outline, &wall_border, words.tool, start)?;
        let reached = if words.allowance > 0.0 { &walls } else { &rough };
        self.note_unreached(words, reached);
        let finish = if words.allowance > 0.0 { walls.round() } else { Vec::new() };
        Some((steps, finish))
    }

    fn report_no_room(&mut self, words: &RegionWords<'_>, keep: f64) {
        let (outline, p) = (words.outline, Vec2::new(words.start[0], words.start[1]));
        let span = words.word;
        let diagnostic = if outline.contains(p) {
            let (away, keep) = (self.length_text(outline.distance(p)), self.length_text(keep));
            Diagnostic::new(
                Code::PocketTooSmall,
                span,
                format!("the start hole is {away} from the wall, and the tool with K needs {keep}"),
            )
            .help("put the start hole where the tool has room, or use a smaller tool")
        } else {
            let message = "the start hole lies outside the outline";
            Diagnostic::new(Code::PocketGeometry, span, message)
                .help("X and Y are a point inside the pocket; the first move goes to the outline")
        };
        self.report(diagnostic.label("not carried out"));
    }

    /// Reports a wall that the tool does not reach.
    fn note_unreached(&mut self, words: &RegionWords<'_>, reached: &PocketRegion<'_>) {
        let (outline, tool) = (words.outline, words.tool);
        let farthest = outline
            .middles()
            .map(|middle| (reached.distance_of_border(middle) - tool, middle))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        let Some((left, place)) = farthest.filter(|(left, _)| *left > UNREACHED_MM) else { return };
        let (left, x, y) =
            (self.length_text(left), self.length_text(place.a), self.length_text(place.b));
        let tool = self.length_text(2.0 * tool);
        self.report(
            Diagnostic::new(
                Code::PocketUnreached,
                words.word,
                format!(
                    "a tool with diameter {tool} stays {left} away from the wall at X {x}, Y {y}"
                ),
            )
            .label("only the part with the start hole is milled")
            .help("use a smaller tool, or mill the rest as a separate pocket"),
        );
    }
}
