//! Three-dimensional rotation (G68 with I, J and K) and tool offset (G41 with I, J and K). Neither is followed; what the
//! control refuses about them is reported.

use chordal_command::CompensationSide;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::{Action, LengthCode, ModeCode, OnceCode, SpatialRules};
use chordal_dialect::{CodeGroup, CodeRow};
use chordal_syntax::{Block, Letters};

use super::Interpreter;

const VECTOR: Letters = Letters::of("IJK");

/// The active rotations and offset.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct SpatialState {
    /// Number of nested rotations.
    rotations: u32,
    /// A length offset was active when the first rotation began.
    began_with_length: bool,
    /// A three-dimensional offset is active.
    offset: bool,
    /// The last code of the length group that is not followed (G43.4); `None` after G49.
    length_code: Option<u16>,
}

impl Interpreter<'_> {
    /// True when a code of this block begins a three-dimensional rotation.
    pub(super) fn is_spatial(&self, block: &Block, row: &CodeRow) -> bool {
        self.control
            .table
            .spatial
            .is_some_and(|rules| rules.begins.contains(&row.code) && block.letters().meets(VECTOR))
    }

    /// Checks the codes of a block against active rotations and offsets.
    #[inline]
    pub(super) fn watch_spatial(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        if let Some(rules) = self.control.table.spatial {
            self.watch_spatial_codes(block, codes, rules);
        }
    }

    fn watch_spatial_codes(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
        rules: &SpatialRules,
    ) {
        let begins = codes
            .iter()
            .find(|(row, at)| block.words[*at].letter == b'G' && self.is_spatial(block, row));
        for (row, at) in codes.iter().filter(|(_, at)| block.words[*at].letter == b'G') {
            self.watch_spatial_code(block, row, *at, rules, begins.is_some());
        }
        if let Some((row, at)) = begins {
            self.begin_spatial(block, row, *at, rules);
        }
    }

    fn watch_spatial_code(
        &mut self,
        block: &Block,
        row: &CodeRow,
        at: usize,
        rules: &SpatialRules,
        begins: bool,
    ) {
        let name = row.name(b'G');
        let active = self.spatial.rotations > 0;
        let adjacent =
            rules.excluded_codes.filter(|(codes, _)| begins && codes.contains(&row.code));
        if let Some((_, alarm)) = adjacent {
            let message = format!("{name} in the block of a rotation in space");
            self.report_spatial(block, at, message, "write it in a block before", alarm);
        } else if let Some(alarm) = rules.refused_inside(row.code).filter(|_| active) {
            let message = format!("{name} while a rotation in space is active");
            self.report_spatial(block, at, message, "end the rotation with G69 before", alarm);
        }
        if rules.refused_after(row.code).is_some() {
            self.spatial.length_code = Some(row.code);
        }
        let scales = row.action == Action::Once(OnceCode::Scaling);
        if let Some(alarm) = rules.scaling_in_offset.filter(|_| scales && self.spatial.offset) {
            let message = format!("{name} while an offset in space (G41 with I, J and K) is on");
            self.report_spatial(block, at, message, "cancel the offset with G40 before", alarm);
        }
        if row.group == CodeGroup::Compensation {
            let on = row.action != Action::Mode(ModeCode::CompensationOff);
            let whole = b"IJK".iter().all(|letter| block.letters().has(*letter));
            self.spatial.offset = rules.scaling_in_offset.is_some() && on && whole;
            if self.spatial.offset {
                self.not_followed(&block.words[at], "an offset in space by I, J and K");
            }
        }
        let lengths = row.group == CodeGroup::ToolLength;
        if row.action == Action::Length(LengthCode::Cancel) {
            self.spatial.length_code = None;
        } else if lengths
            && active
            && self.spatial.began_with_length
            && let Some(alarm) = rules.length_not_nested
        {
            let message =
                format!("{name} in a rotation in space that began with another length offset");
            let help =
                "end the rotation with G69 before, or start the length offset inside it alone";
            self.report_spatial(block, at, message, help, alarm);
        }
        if row.group == CodeGroup::Rotation && !begins && active {
            self.end_spatial(block, at, rules);
        }
    }

    fn begin_spatial(&mut self, block: &Block, row: &CodeRow, at: usize, rules: &SpatialRules) {
        let name = row.name(b'G');
        let has = |letter: u8| block.letters().has(letter);
        let missing = b"IJKR".iter().filter(|letter| !has(**letter));
        let missing: Vec<String> = missing.map(|letter| char::from(*letter).to_string()).collect();
        let zero =
            b"IJK".iter().all(|letter| block.last(*letter).is_some_and(|word| self.is_zero(word)));
        if let Some(alarm) = rules.format {
            let wrong = match missing.is_empty() {
                false => Some(format!("{name} in space without {}", missing.join(", "))),
                true => zero.then(|| format!("I, J and K of {name} are all 0: no direction")),
            };
            if let Some(message) = wrong {
                let help = "write I, J and K, the direction of the axis, and R, the angle";
                self.report_spatial(block, at, message, help, alarm);
            }
        }
        let parallel = [(b'X', b'U'), (b'Y', b'V'), (b'Z', b'W')];
        let parallel = parallel.iter().find(|(first, second)| has(*first) && has(*second));
        if let (Some((first, second)), Some(alarm)) = (parallel, rules.parallel_axes) {
            let [first, second] = [first, second].map(|letter| char::from(*letter));
            let message = format!("{name} names {first} and {second}, which are parallel");
            self.report_spatial(block, at, message, "name one of them", alarm);
        }
        if let Some(alarm) =
            rules.in_compensation.filter(|_| self.kernel.state.side != CompensationSide::Off)
        {
            let message = "a rotation in space begins while cutter compensation is on".to_string();
            self.report_spatial(block, at, message, "cancel compensation with G40 before", alarm);
        }
        if let Some(code) = self.spatial.length_code
            && let Some(alarm) = rules.refused_after(code)
        {
            let active = chordal_dialect::code_name(b'G', code);
            let message = format!("a rotation in space begins while {active} is active");
            self.report_spatial(block, at, message, "cancel it with G49 before", alarm);
        }
        let exceeded = rules.max_active.filter(|(max, _)| self.spatial.rotations >= *max);
        if let Some((max, alarm)) = exceeded {
            let message = format!("rotation {} in space, one in another", max + 1);
            let help = format!("at most {max} may be active: end them with G69 before");
            return self.report_spatial(block, at, message, &help, alarm);
        }
        if self.spatial.rotations == 0 {
            self.spatial.began_with_length = self.has_length();
        }
        self.spatial.rotations += 1;
    }

    /// G69, which ends all rotations.
    fn end_spatial(&mut self, block: &Block, at: usize, rules: &SpatialRules) {
        let (before, now) = (self.spatial.began_with_length, self.has_length());
        self.spatial.rotations = 0;
        if let Some(alarm) = rules.length_not_nested.filter(|_| before != now) {
            let (message, help) = match now {
                true => (
                    "a length offset that began inside a rotation in space does not end inside it",
                    "write G49 before G69, or the length offset before G68",
                ),
                false => (
                    "a length offset that began before a rotation in space ends inside it",
                    "write G49 after G69",
                ),
            };
            self.report_spatial(block, at, message.to_string(), help, alarm);
        }
    }

    fn has_length(&self) -> bool {
        self.kernel.state.offsets.length().number.is_some()
    }

    fn report_spatial(
        &mut self,
        block: &Block,
        at: usize,
        message: String,
        help: &str,
        alarm: &str,
    ) {
        let span = self.span(block.words[at].range);
        let diagnostic = Diagnostic::new(Code::SpatialRotation, span, message).help(help);
        self.report_refused(diagnostic, alarm);
    }
}
