//! Circular pockets in one block (Haas G12, G13): with I, or with I, K and Q.
//!
//! Haas Mill Operator's Manual (1999 and NGC): the cycle itself applies the offset, and all cuts are circular. The arcs
//! between the circles are assumed: tangent and in one direction.

use chordal_command::{AxisMask, CompensationSide};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::tolerance::COINCIDENT_MM;
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::shapes::ring_radii;
use chordal_syntax::{Block, Letters};

use crate::interpreter::Interpreter;
use chordal_kernel::{CirclesWords, MAX_RINGS};

impl Interpreter<'_> {
    /// Carries out G12 or G13.
    pub(in crate::interpreter) fn circular_pocket(
        &mut self,
        block: &Block,
        at: usize,
        direction: TurnDirection,
    ) {
        if self.control.parameters.rules.pocket_is_one_circle {
            return self.one_circle(block, at, direction);
        }
        let Some(tool) = self.pocket_start(block, at) else { return };
        let Some(radii) = self.circular_radii(block, at, tool) else { return };
        self.kernel.note_ridges(&self.at(block), &radii, tool);
        let z = self.place_of_pocket(block);
        let repeats = match block.letters().has(b'L') {
            true => self.count_of(block, b'L').unwrap_or(1),
            false => 1,
        };
        let repeats = self.repeats_of_pocket(block, repeats);
        let name = format!("G1{}", if direction == TurnDirection::Cw { 2 } else { 3 });
        let pocket = CirclesWords {
            word: self.span(block.words[at].range),
            name: &name,
            direction,
            tool,
            radii: &radii,
            level: z,
            passes: repeats,
        };
        self.kernel.mill_circles(&self.at(block), &pocket);
    }

    /// G12 and G13 of Mach3: I is the radius of the path of the tool centre.
    fn one_circle(&mut self, block: &Block, at: usize, direction: TurnDirection) {
        self.unused_axes(block, |_, _| false);
        if !self.may_have_pocket(block, at) {
            return;
        }
        let radius = self.length_of(block, b'I').filter(|radius| radius.abs() > COINCIDENT_MM);
        let Some(radius) = radius else {
            let message =
                "a circular pocket without I, the radius of the circle of the tool's centre";
            return self.refuse_pocket(block, at, message, "give I");
        };
        self.kernel.mill_circle(&self.at(block), radius, direction);
    }

    /// True in the XY plane without compensation, as pockets require; otherwise it is reported.
    fn may_have_pocket(&mut self, block: &Block, at: usize) -> bool {
        if self.kernel.state.plane != Plane::Xy {
            self.refuse_pocket(block, at, "pockets are milled only in G17", "choose G17 before");
            return false;
        }
        if self.kernel.state.side != CompensationSide::Off {
            let message = "a pocket cycle while cutter compensation is on";
            self.refuse_pocket(block, at, message, "cancel compensation with G40 before it");
            return false;
        }
        true
    }

    /// Checks what all pockets of one block need. The radius of the tool, mm; `None` when the pocket cannot be milled.
    pub(super) fn pocket_start(&mut self, block: &Block, at: usize) -> Option<f64> {
        let span = self.span(block.words[at].range);
        if !self.may_have_pocket(block, at) {
            return None;
        }
        let Some(number) = self.kernel.state.radius_offset else {
            self.kernel.report(
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
        let radius = self.kernel.state.offsets.radius_mm(number);
        if radius.is_none() {
            self.report_diameter_unknown(span, number);
        }
        radius
    }

    /// The radii of the circles, mm; `None` unless tool radius, I and K increase in this order, which is reported.
    fn circular_radii(&mut self, block: &Block, at: usize, tool: f64) -> Option<Vec<f64>> {
        let Some(first) = self.length_of(block, b'I') else {
            let message = "a circular pocket without I, the radius of its first circle";
            self.refuse_pocket(block, at, message, "give I, and K and Q for a larger pocket");
            return None;
        };
        if first <= tool + COINCIDENT_MM {
            let (is, tool) = (self.kernel.length_text(first), self.kernel.length_text(tool));
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
            (Some(last), Some(step)) if step > COINCIDENT_MM => (last, step),
            _ => {
                let message = "K, the radius of the last circle, and Q, the step, go together";
                self.refuse_pocket(block, at, message, "give both above zero, or neither");
                return None;
            }
        };
        if last <= first + COINCIDENT_MM {
            let (is, first) = (self.kernel.length_text(last), self.kernel.length_text(first));
            self.report_pocket_radii(block, b'K', format!("K is {is}, and I is {first}"));
            return None;
        }
        let radii = ring_radii(first, step, last, MAX_RINGS as usize);
        if radii.is_none() {
            self.kernel.report_too_many_passes(self.words_span(block, Letters::of("Q")), "circles");
        }
        radii
    }

    fn report_pocket_radii(&mut self, block: &Block, letter: u8, message: String) {
        let span = self.words_span(block, Letters(1 << (letter - b'A')));
        self.kernel.report(
            Diagnostic::new(Code::PocketTooSmall, span, message)
                .label("tool radius, I and K must increase in this order")
                .help("check the words, and the diameter in the offset table"),
        );
    }

    /// Moves to X and Y of the block, the centre of the pocket. Returns the level Z; `None` without Z.
    fn place_of_pocket(&mut self, block: &Block) -> Option<f64> {
        let (mut target, named) = self.target(block);
        let z = named.has(2).then_some(target[2]);
        target[2] = self.kernel.state.position[2];
        let named = named.without(AxisMask(0b100));
        if named != AxisMask::NONE {
            self.kernel.straight(&self.at(block), target, named);
        }
        z
    }

    fn repeats_of_pocket(&mut self, block: &Block, repeats: u32) -> u32 {
        let Some(word) = block.last(b'L').copied() else { return repeats };
        if repeats > 1 && !(self.kernel.state.incremental && block.letters().has(b'Z')) {
            self.kernel.report(
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
            self.kernel.report(
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

    /// Reports a pocket cycle that the control would not run.
    pub(super) fn refuse_pocket(&mut self, block: &Block, at: usize, message: &str, help: &str) {
        self.kernel.report(
            Diagnostic::new(Code::PocketRefused, self.span(block.words[at].range), message)
                .label("not carried out")
                .help(help),
        );
    }
}
