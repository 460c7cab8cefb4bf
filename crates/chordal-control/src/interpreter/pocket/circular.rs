//! Circular pockets by one block (Haas G12, G13): I alone, or I, K and Q.
//!
//! Haas Mill Operator's Manual (1999 and NGC): the offset is applied by the cycle itself, all
//! cutting is circular; the arcs between the circles are a model, tangent and of one sense.

use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::{Direction, Plane, Vec2};
use chordal_syntax::{Block, Letters};

use super::MAX_RINGS;
use crate::command::{AxisMask, Side};
use crate::interpreter::Interpreter;
use crate::pocket::{Step, ring_radii, rings};

/// Lengths that differ by less than this, mm, are the same.
const SAME_MM: f64 = 1e-9;

impl Interpreter<'_> {
    /// G12 and G13.
    pub(in crate::interpreter) fn circular_pocket(
        &mut self,
        block: &Block,
        at: usize,
        direction: Direction,
    ) {
        let Some(tool) = self.pocket_start(block, at) else { return };
        let Some(radii) = self.circular_radii(block, at, tool) else { return };
        self.note_ridges(block, &radii, tool);
        let centers: Vec<f64> = radii.iter().map(|radius| radius - tool).collect();
        let path = rings(&centers, 1, direction);
        let z = self.place_of_pocket(block);
        let repeats = match block.letters().has(b'L') {
            true => self.count_of(block, b'L').unwrap_or(1),
            false => 1,
        };
        let repeats = self.repeats_of_pocket(block, repeats);
        let center = Vec2::new(self.state.position[0], self.state.position[1]);
        let placed: Vec<Step> = path.iter().map(|step| step.shifted(center)).collect();
        let name = format!("G1{}", if direction == Direction::Cw { 2 } else { 3 });
        let choice = "half circles between full circles are shown, tangent and in one direction";
        let label = format!("circles: {}", radii.len());
        self.note_assumed_path(self.span(block.words[at].range), &name, choice, label);
        let down = z.map_or(0.0, |z| z - self.state.position[2]);
        for pass in 0..repeats {
            if pass > 0 && !self.count_repeated() {
                return;
            }
            let mut target = self.state.position;
            let named = if z.is_some() { AxisMask(0b100) } else { AxisMask::NONE };
            match z {
                Some(z) if pass == 0 => target[2] = z,
                Some(_) if self.state.incremental => target[2] += down,
                _ => {}
            }
            let motion = crate::command::Move {
                from: self.state.position,
                to: target,
                from_known: self.state.known,
                to_known: self.state.known,
            };
            let feed = self.feed_for(block, &motion, None);
            if target != self.state.position {
                self.routine_line(target, named, feed);
            }
            self.follow(&placed, feed, AxisMask::NONE);
        }
    }

    /// What all pockets of one block ask for; the radius of the tool, mm.
    pub(super) fn pocket_start(&mut self, block: &Block, at: usize) -> Option<f64> {
        let span = self.span(block.words[at].range);
        if self.state.plane != Plane::Xy {
            self.refuse_pocket(block, at, "pockets are milled only in G17", "choose G17 before");
            return None;
        }
        if self.state.side != Side::Off {
            let message = "a pocket cycle while cutter compensation is on";
            self.refuse_pocket(block, at, message, "cancel compensation with G40 before it");
            return None;
        }
        let Some(number) = self.state.radius_offset else {
            self.report(
                Diagnostic::new(
                    Code::PocketWithoutDiameter,
                    span,
                    "a pocket cycle before the first D, so it has no tool radius",
                )
                .label("its motion is missing from the path")
                .help(
                    "put D and the offset number into this block; D0 uses the sizes without an offset",
                ),
            );
            return None;
        };
        if number == 0 {
            return Some(0.0);
        }
        let radius = self.state.offsets.radius_mm(number);
        if radius.is_none() {
            self.report_diameter_unknown(span, number);
        }
        radius
    }

    /// The radii of the circles, mm, when tool radius, I and K grow in this order.
    fn circular_radii(&mut self, block: &Block, at: usize, tool: f64) -> Option<Vec<f64>> {
        let Some(first) = self.length_of(block, b'I') else {
            let message = "a circular pocket without I, the radius of its first circle";
            self.refuse_pocket(block, at, message, "give I, and K and Q for a larger pocket");
            return None;
        };
        if first <= tool + SAME_MM {
            let (is, tool) = (self.length_text(first), self.length_text(tool));
            self.report_pocket_radii(
                block,
                b'I',
                format!("I is {is}, and the tool's radius is {tool}"),
            );
            return None;
        }
        let (last, step) = (self.length_of(block, b'K'), self.length_of(block, b'Q'));
        let (last, step) = match (last, step) {
            (None, None) => return Some(vec![first]),
            (Some(last), Some(step)) if step > SAME_MM => (last, step),
            _ => {
                let message = "K, the radius of the last circle, and Q, the step, go together";
                self.refuse_pocket(block, at, message, "give both above zero, or neither");
                return None;
            }
        };
        if last <= first + SAME_MM {
            let (is, first) = (self.length_text(last), self.length_text(first));
            self.report_pocket_radii(block, b'K', format!("K is {is}, and I is {first}"));
            return None;
        }
        let radii = ring_radii(first, step, last, MAX_RINGS as usize);
        if radii.is_none() {
            self.report_too_many_passes(self.words_span(block, Letters::of("Q")), "circles");
        }
        radii
    }

    fn report_pocket_radii(&mut self, block: &Block, letter: u8, message: String) {
        let span = self.words_span(block, Letters(1 << (letter - b'A')));
        self.report(
            Diagnostic::new(Code::PocketTooSmall, span, message)
                .label("tool radius, I and K must increase in this order")
                .help("check the words, and the diameter in the offset table"),
        );
    }

    /// Rings further apart than the tool is wide, or a core in the middle.
    fn note_ridges(&mut self, block: &Block, radii: &[f64], tool: f64) {
        // One circle alone finishes a bore that is there; D0 says nothing of the tool.
        let &[first, second, ..] = radii else { return };
        if tool == 0.0 {
            return;
        }
        let wide = 2.0 * tool + SAME_MM;
        let core = first - 2.0 * tool;
        let (letters, what, width) = if second - first > wide {
            ("Q", "between the circles", second - first - 2.0 * tool)
        } else if core > tool + SAME_MM {
            ("I", "about the middle", core - tool)
        } else {
            return;
        };
        let (width, tool) = (self.length_text(width), self.length_text(2.0 * tool));
        let span = self.words_span(block, Letters::of(letters));
        self.report(
            Diagnostic::new(
                Code::PocketRidges,
                span,
                format!("a ring {width} wide stays {what}: the tool is {tool}"),
            )
            .label("more than the diameter of the tool")
            .help("use a smaller step, or a larger tool"),
        );
    }

    /// Moves to X and Y of the block, where the pocket is; the level that Z names.
    fn place_of_pocket(&mut self, block: &Block) -> Option<f64> {
        let (mut target, named) = self.target(block);
        let z = named.has(2).then_some(target[2]);
        target[2] = self.state.position[2];
        let named = named.without(AxisMask(0b100));
        if named != AxisMask::NONE {
            self.straight(block, target, named);
        }
        z
    }

    fn repeats_of_pocket(&mut self, block: &Block, repeats: u32) -> u32 {
        let Some(word) = block.last(b'L').copied() else { return repeats };
        if repeats > 1 && !(self.state.incremental && block.letters().has(b'Z')) {
            self.report(
                Diagnostic::new(
                    Code::UnusedWord,
                    self.span(word.range),
                    format!("L{repeats} mills the same depth {repeats} times"),
                )
                .label("no step in Z")
                .help("use G91 with Z as the step, or remove L"),
            );
        }
        let limit = self.control.parameters.max_repeats;
        if repeats == 0 || repeats > limit {
            self.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("L{repeats} cannot be the number of passes: 1 to {limit}"),
                )
                .label("carried out once")
                .help("write the number of passes, or leave L out for one"),
            );
            return 1;
        }
        repeats
    }

    /// A pocket cycle that the control would not run.
    pub(super) fn refuse_pocket(&mut self, block: &Block, at: usize, message: &str, help: &str) {
        self.report(
            Diagnostic::new(Code::PocketRefused, self.span(block.words[at].range), message)
                .label("not carried out")
                .help(help),
        );
    }
}
