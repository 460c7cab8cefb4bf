//! A pocket of any outline in one block (Haas G150).
//!
//! Haas Mill Operator's Manual, G150: at each level Q, a pass along the outline that leaves K, then rows by I or J;
//! after the last level one pass along the walls. The order of the rows and the moves between them are assumed.

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::code_number;
use chordal_dialect::{Action, ModeCode};
use chordal_geometry::Vec2;
use chordal_kernel::shapes::{Outline, RasterAlong};
use chordal_syntax::{Block, Letters};

use crate::interpreter::Interpreter;
use chordal_kernel::{RegionWords, rings_to_depth};

/// The values of the block, mm.
struct PocketWords {
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
    /// Carries out G150.
    pub(in crate::interpreter) fn general_pocket(&mut self, block: &Block, at: usize) {
        let Some(tool) = self.pocket_start(block, at) else { return };
        let Some(words) = self.general_words(block, at, tool) else { return };
        let start = Vec2::new(words.start[0], words.start[1]);
        let Some(outline) = self.pocket_outline(block, at, start) else { return };
        if !self.side_is_inside(block, &outline) {
            return;
        }
        let pocket = RegionWords {
            word: self.span(block.words[at].range),
            name: "G150",
            outline: &outline,
            tool: words.tool,
            start: words.start,
            named: words.named,
            r: words.r,
            levels: words.levels,
            along: words.along,
            step: words.step,
            allowance: words.allowance,
        };
        self.kernel.mill_region(&self.at(block), &pocket);
    }

    /// Reads and checks the words of the block; `None` when the control would refuse them, which is reported.
    fn general_words(&mut self, block: &Block, at: usize, tool: f64) -> Option<PocketWords> {
        let (target, named) = self.target(block);
        let (r, z) = (self.length_of(block, b'R'), named.has(2).then_some(target[2]));
        let (Some(r), Some(z)) = (r, z) else {
            let message = "a pocket without its levels";
            self.refuse_pocket(block, at, message, "give the plane R and the depth Z");
            return None;
        };
        // In G91, R is relative to the present position and Z to R, as in drilling cycles.
        let relative = self.kernel.state.incremental;
        let z_word = z - self.kernel.state.position[2];
        let r = if relative { self.kernel.state.position[2] + r } else { r };
        let z = if relative { r + z_word } else { z };
        if z >= r {
            let (z, r) = (self.kernel.length_text(z), self.kernel.length_text(r));
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
        Some(PocketWords { tool, start: target, named, r, levels, along, step, allowance })
    }

    /// The levels R − Q, R − 2Q, …, Z, mm; without Q only Z.
    fn pocket_levels(&mut self, block: &Block, at: usize, r: f64, z: f64) -> Option<Vec<f64>> {
        let Some(q) = self.length_of(block, b'Q') else { return Some(vec![z]) };
        if q <= 0.0 {
            let message = "the depth of a pass, Q, must be above zero";
            self.refuse_pocket(block, at, message, "give Q without a sign");
            return None;
        }
        let levels = rings_to_depth(r, z, q);
        if levels.is_none() {
            self.kernel.report_too_many_passes(self.words_span(block, Letters::of("Q")), "levels");
        }
        levels
    }

    /// True when the side is inside: G41 with a counter-clockwise outline, G42 with a clockwise one. Otherwise it is
    /// reported.
    fn side_is_inside(&mut self, block: &Block, outline: &Outline) -> bool {
        let side = block.all(b'G').find_map(|word| {
            let row = self.control.g_code(self.literal(word).and_then(code_number)?)?;
            let left = row.action == Action::Mode(ModeCode::CompensationLeft);
            let right = row.action == Action::Mode(ModeCode::CompensationRight);
            (left || right).then_some((*word, left))
        });
        let Some((word, left)) = side else {
            let span = self.span(block.range);
            self.kernel.report(
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
}
