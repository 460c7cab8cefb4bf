//! A pocket of any outline by one block (Haas G150).
//!
//! Haas Mill Operator's Manual, G150: at each level Q, a pass round the outline that leaves K,
//! then rows by I or J; after the last level one pass round the walls. The order of the rows
//! and the ways between them are a choice.

use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::Vec2;
use chordal_syntax::{Block, Letters};

use super::MAX_RINGS;
use crate::command::{AxisMask, Feed, Move, Position};
use crate::interpreter::Interpreter;
use crate::pocket::{Outline, RasterAlong, Region, Step, inset};
use crate::table::Action;
use crate::table::code_number;

/// A depth that misses the last level by less than this, mm, is that level.
const LEVEL_EPSILON_MM: f64 = 1e-9;

/// A wall further away than this, mm, is not reached.
const UNREACHED_MM: f64 = 1e-3;

/// Most moves of one pocket.
const MAX_POCKET_MOVES: usize = 2_000_000;

const XY: AxisMask = AxisMask(0b011);
const Z: AxisMask = AxisMask(0b100);

/// The numbers of the block, mm.
struct Words {
    tool: f64,
    start: Position,
    named: AxisMask,
    r: f64,
    levels: Vec<f64>,
    along: RasterAlong,
    step: f64,
    allowance: f64,
}

impl Interpreter<'_> {
    /// G150.
    pub(in crate::interpreter) fn general_pocket(&mut self, block: &Block, at: usize) {
        let Some(tool) = self.pocket_start(block, at) else { return };
        let Some(words) = self.general_words(block, at, tool) else { return };
        let start = Vec2::new(words.start[0], words.start[1]);
        let Some(outline) = self.pocket_outline(block, at, start) else { return };
        if !self.side_is_inside(block, &outline) {
            return;
        }
        let Some((rough, finish)) = self.general_paths(block, at, &words, &outline, start) else {
            return;
        };
        if words.levels.len().saturating_mul(rough.len()) > MAX_POCKET_MOVES {
            return self.report_too_many_passes(self.words_span(block, Letters::of("QIJ")), "rows");
        }
        let span = self.span(block.words[at].range);
        let label = format!("levels: {}", words.levels.len());
        let choice = "the order of its passes and the moves between them are assumed";
        self.note_assumed_path(span, "G150", choice, label);
        let mut over = words.start;
        over[2] = self.state.position[2];
        self.routine_rapid(over, words.named.and(XY));
        let mut down = self.state.position;
        down[2] = words.r;
        self.routine_rapid(down, Z);
        let feed = self.feed_of_pocket(block);
        for (pass, z) in words.levels.iter().enumerate() {
            if pass > 0 && !self.count_repeated() {
                return;
            }
            let mut target = self.state.position;
            target[2] = *z;
            self.routine_line(target, Z, feed);
            self.follow(&rough, feed, XY);
        }
        self.follow(&finish, feed, XY);
    }

    fn feed_of_pocket(&mut self, block: &Block) -> Feed {
        let state = &self.state;
        let motion = Move {
            from: state.position,
            to: state.position,
            from_known: state.known,
            to_known: state.known,
        };
        self.feed_for(block, &motion, None)
    }

    /// Reads and judges the words of the block.
    fn general_words(&mut self, block: &Block, at: usize, tool: f64) -> Option<Words> {
        let (target, named) = self.target(block);
        let (r, z) = (self.length_of(block, b'R'), named.has(2).then_some(target[2]));
        let (Some(r), Some(z)) = (r, z) else {
            let message = "a pocket without its levels";
            self.refuse_pocket(block, at, message, "give the plane R and the depth Z");
            return None;
        };
        // In G91, R counts from where the tool stands and Z from R, as in drilling cycles.
        let relative = self.state.incremental;
        let z_word = z - self.state.position[2];
        let r = if relative { self.state.position[2] + r } else { r };
        let z = if relative { r + z_word } else { z };
        if z >= r {
            let (z, r) = (self.length_text(z), self.length_text(r));
            let message = format!("the depth {z} is not below the plane R, {r}");
            self.refuse_pocket(block, at, &message, "check Z and R");
            return None;
        }
        let levels = self.pocket_levels(block, at, r, z)?;
        let steps = (self.length_of(block, b'I'), self.length_of(block, b'J'));
        let (along, step) = match steps {
            (Some(step), None) => (RasterAlong::First, step),
            (None, Some(step)) => (RasterAlong::Second, step),
            _ => {
                let message = "a pocket has one stepover, I or J";
                self.refuse_pocket(block, at, message, "I steps along X, J along Y; give one");
                return None;
            }
        };
        let allowance = self.length_of(block, b'K').unwrap_or(0.0);
        if step <= 0.0 || allowance < 0.0 {
            let message = "the stepover must be above zero, and K not below it";
            self.refuse_pocket(block, at, message, "check I or J, and K");
            return None;
        }
        Some(Words { tool, start: target, named, r, levels, along, step, allowance })
    }

    /// R − Q, R − 2Q, …, Z; without Q, Z alone.
    fn pocket_levels(&mut self, block: &Block, at: usize, r: f64, z: f64) -> Option<Vec<f64>> {
        let Some(q) = self.length_of(block, b'Q') else { return Some(vec![z]) };
        if q <= 0.0 {
            let message = "the depth of a pass, Q, must be above zero";
            self.refuse_pocket(block, at, message, "give Q without a sign");
            return None;
        }
        let count = ((r - z - LEVEL_EPSILON_MM) / q).ceil().max(1.0);
        if count > f64::from(MAX_RINGS) {
            self.report_too_many_passes(self.words_span(block, Letters::of("Q")), "levels");
            return None;
        }
        let mut levels: Vec<f64> =
            (1..count as u32).map(|level| r - f64::from(level) * q).collect();
        levels.push(z);
        Some(levels)
    }

    /// G41 has the inside of a counter-clockwise outline on its left, G42 that of a clockwise
    /// one on its right.
    fn side_is_inside(&mut self, block: &Block, outline: &Outline) -> bool {
        let side = block.all(b'G').find_map(|word| {
            let row = self.control.g_code(self.literal(word).and_then(code_number)?)?;
            let left = match row.action {
                Action::CompensationLeft => true,
                Action::CompensationRight => false,
                _ => return None,
            };
            Some((*word, left))
        });
        let Some((word, left)) = side else {
            let span = self.span(block.range);
            self.report(
                Diagnostic::new(Code::PocketRefused, span, "a pocket without G41 or G42")
                    .label("not carried out")
                    .help("write G41 for a counter-clockwise outline, G42 for a clockwise one"),
            );
            return false;
        };
        if left != outline.was_clockwise() {
            return true;
        }
        let (code, turn) = if left { ("G41", "clockwise") } else { ("G42", "counter-clockwise") };
        let other = if left { "G42" } else { "G41" };
        let message = format!("{code} with a {turn} outline lies outside the pocket");
        let help = format!("write {other}, or reverse the outline");
        self.report_outline(self.span(word.range), message, &help);
        false
    }

    /// The path of a level and the one of the walls; `None` when the tool finds no room.
    fn general_paths(
        &mut self,
        block: &Block,
        at: usize,
        words: &Words,
        outline: &Outline,
        start: Vec2,
    ) -> Option<(Vec<Step>, Vec<Step>)> {
        let keep = words.tool + words.allowance;
        let rough_border = inset(outline, keep);
        let Some(rough) = Region::around(outline, &rough_border, keep, start) else {
            self.report_no_room(block, at, keep, outline, start);
            return None;
        };
        if words.tool > 0.0 && words.step > 2.0 * words.tool * (1.0 + 1e-9) {
            let left = self.length_text(words.step - 2.0 * words.tool);
            let tool = self.length_text(2.0 * words.tool);
            self.report(
                Diagnostic::new(
                    Code::PocketRidges,
                    self.words_span(block, Letters::of("IJ")),
                    format!("ridges {left} wide stay between the passes: the tool is {tool}"),
                )
                .label("more than the diameter of the tool")
                .help("use a smaller stepover, or a larger tool"),
            );
        }
        let Ok(steps) = rough.clear(words.along, words.step, MAX_RINGS as usize) else {
            self.report_too_many_passes(self.words_span(block, Letters::of("IJ")), "rows");
            return None;
        };
        let wall_border = inset(outline, words.tool);
        let walls = Region::around(outline, &wall_border, words.tool, start)?;
        let reached = if words.allowance > 0.0 { &walls } else { &rough };
        self.note_unreached(block, at, words.tool, outline, reached);
        let finish = if words.allowance > 0.0 { walls.round() } else { Vec::new() };
        Some((steps, finish))
    }

    fn report_no_room(&mut self, block: &Block, at: usize, keep: f64, outline: &Outline, p: Vec2) {
        let span = self.span(block.words[at].range);
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

    /// Walls that the tool does not come to.
    fn note_unreached(
        &mut self,
        block: &Block,
        at: usize,
        tool: f64,
        outline: &Outline,
        reached: &Region<'_>,
    ) {
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
                self.span(block.words[at].range),
                format!(
                    "a tool with diameter {tool} stays {left} away from the wall at X {x}, Y {y}"
                ),
            )
            .label("only the part with the start hole is milled")
            .help("use a smaller tool, or mill the rest as a separate pocket"),
        );
    }
}
