//! Tilted planes: the words that define them, and the codes that turn the tool to them.

use chordal_command::CompensationSide;
use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_dialect::{CodeRow, TiltedPlaneCode};
use chordal_geometry::{Transform, Vec3};
use chordal_kernel::frames::plane_forms;
use chordal_kernel::{AngleSign, TurnError};
use chordal_syntax::Block;

use super::Interpreter;

/// The number of X, Y and Z, which are the origin of a plane.
const LINEAR_AXES: usize = 3;

/// A plane that several blocks define together, as far as they have come (G68.2 P2 and P3).
#[derive(Clone, Copy, Debug)]
pub(super) struct OpenPlane {
    /// The value of P.
    form: PartedForm,
    /// Its coordinates are those of the plane in force.
    in_active: bool,
    /// Where the first block stands.
    at: Span,
    /// The points or the vectors by Q − 1.
    parts: [Option<Vec3>; 3],
    /// The origin of vectors.
    origin: Vec3,
    /// The shift and the angle of Q0.
    shift: (Vec3, f64),
}

/// How several blocks define a plane.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum PartedForm {
    /// P2: three points.
    Points,
    /// P3: the directions of X and Z.
    Vectors,
}

impl PartedForm {
    /// The number of blocks that it needs.
    fn count(self) -> usize {
        match self {
            PartedForm::Points => 3,
            PartedForm::Vectors => 2,
        }
    }
}

impl Interpreter<'_> {
    /// Carries out G68.2, G53.1 and their like.
    pub(super) fn tilted_plane(&mut self, block: &Block, at: usize, code: TiltedPlaneCode) {
        match code {
            TiltedPlaneCode::Define { in_active } => self.define_plane(block, at, None, in_active),
            TiltedPlaneCode::DefineByAxes => self.define_plane(block, at, Some(1), false),
            TiltedPlaneCode::DefineByTool => self.define_plane_by_tool(block, at),
            TiltedPlaneCode::Off => {
                self.unused_axes(block, |_, _| false);
                self.kernel.set_tilted_plane(None);
            }
            TiltedPlaneCode::Turn { holds_tip } => {
                self.unused_axes(block, |_, _| false);
                self.turn_to_plane(block, at, holds_tip);
            }
            TiltedPlaneCode::OriginOnTable { on } => {
                self.unused_axes(block, |_, _| false);
                match on {
                    true => self.begin_origin_on_table(block, at),
                    false => self.kernel.end_origin_on_table(),
                }
            }
        }
    }

    /// What is wrong before any word of a definition is read.
    fn check_begin_of_plane(&mut self, block: &Block, at: usize, in_active: bool) {
        let rules = self.control.table.tilted_plane;
        let name = self.code_text(block, at);
        let is_active = self.kernel.has_tilted_plane();
        if is_active && !in_active {
            let message = format!("{name} while a tilted plane is in force");
            let help = "end the plane before with G69";
            self.report_plane(block, at, message, help, rules.twice);
        }
        if in_active && !is_active {
            let message = format!("{name} without a tilted plane");
            let help = "define the plane that it goes on from in a block before, with G68.2";
            self.report_plane(block, at, message, help, rules.format);
        }
        if self.kernel.state.side != CompensationSide::Off {
            let message = format!("{name} while cutter compensation is on");
            let help = "cancel compensation with G40 on a move before";
            self.report_plane(block, at, message, help, rules.format);
        }
    }

    fn define_plane(&mut self, block: &Block, at: usize, form: Option<u32>, in_active: bool) {
        self.unused_axes(block, |axis, _| axis < LINEAR_AXES);
        let form = match (form, block.letters().has(b'P')) {
            (Some(form), _) => Some(form),
            (None, true) => self.count_of(block, b'P'),
            (None, false) => Some(0),
        };
        let parted = match form {
            Some(2) => Some(PartedForm::Points),
            Some(3) => Some(PartedForm::Vectors),
            _ => None,
        };
        if self.open_plane.is_none() {
            self.check_begin_of_plane(block, at, in_active);
        }
        if let Some(form) = parted {
            return self.take_part_of_plane(block, at, form, in_active);
        }
        let rules = self.control.table.tilted_plane;
        let angles = b"IJK".map(|letter| self.angle_of(block, letter).unwrap_or(0.0).to_radians());
        let rotation = match form {
            Some(0) => Some(plane_forms::euler(angles)),
            Some(1) => match self.order_of_axes(block) {
                Some(order) => Some(plane_forms::about_fixed_axes(angles, order)),
                None => {
                    let message = "Q is the order of the three axes, such as 123".to_string();
                    let help = "write each of 1, 2 and 3 once, or leave Q out";
                    self.report_plane(block, at, message, help, rules.format);
                    None
                }
            },
            Some(4) => plane_forms::two_projections(angles),
            _ => {
                let message = "P of a tilted plane is 0, 1, 2, 3 or 4".to_string();
                let help = "0: Euler angles, 1: angles about X, Y and Z, 2: points, 3: vectors, 4: two projections";
                self.report_plane(block, at, message, help, rules.format);
                None
            }
        };
        let origin = self.linear_words(block).map(|value| value.unwrap_or(0.0));
        let plane =
            rotation.map(|turn| turn.then(&Transform::translation(Vec3::from_array(origin))));
        self.take_plane(block, at, plane, in_active);
    }

    /// The plane in force; that of the work coordinate system without one.
    pub(super) fn active_plane(&self) -> Transform {
        self.kernel.tilted_plane().unwrap_or(Transform::identity())
    }

    /// X, Y and Z of the block, mm.
    fn linear_words(&mut self, block: &Block) -> [Option<f64>; 3] {
        let [x, y, z, ..] = self.axis_words(block);
        [x, y, z]
    }

    /// The plane that words have defined, if they have.
    fn take_plane(&mut self, block: &Block, at: usize, plane: Option<Transform>, in_active: bool) {
        let Some(plane) = plane else {
            let word = block.words[at];
            return self.not_followed(&word, "a plane without a direction");
        };
        let plane = match in_active {
            true => plane.then(&self.active_plane()),
            false => plane,
        };
        self.kernel.set_tilted_plane(Some(plane));
    }

    /// One of the blocks of G68.2 P2 or P3.
    fn take_part_of_plane(&mut self, block: &Block, at: usize, form: PartedForm, in_active: bool) {
        let values = self.linear_words(block).map(|value| value.unwrap_or(0.0));
        let point = Vec3::from_array(values);
        let mut open = self.open_plane.take().unwrap_or(OpenPlane {
            form,
            in_active,
            at: self.span(block.words[at].range),
            parts: [None; 3],
            origin: Vec3::ZERO,
            shift: (Vec3::ZERO, 0.0),
        });
        let number = match block.letters().has(b'Q') {
            true => self.count_of(block, b'Q').map(|number| number as usize),
            false => None,
        };
        match (form, number) {
            (PartedForm::Points, Some(0)) => {
                let angle = self.angle_of(block, b'R').unwrap_or(0.0).to_radians();
                open.shift = (point, angle);
            }
            (PartedForm::Points, Some(number @ 1..=3)) => open.parts[number - 1] = Some(point),
            (PartedForm::Vectors, Some(number @ 1..=2)) => {
                open.parts[number - 1] = Some(self.vector_of(block));
                if number == 1 {
                    open.origin = point;
                }
            }
            _ => {
                let count = form.count();
                let message = format!("Q says which of the {count} parts of the plane this is");
                let help = "write Q1 and on, each in a block of its own";
                let rules = self.control.table.tilted_plane;
                self.report_plane(block, at, message, help, rules.format);
                return self.take_plane(block, at, None, false);
            }
        }
        self.open_plane = Some(open);
    }

    /// Before a block that does not go on with the definition of a plane: it is made of what has come.
    pub(super) fn close_plane(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        let goes_on = codes.iter().any(|(row, _)| row.defines_plane());
        if block.words.is_empty() || goes_on {
            return;
        }
        self.end_open_plane();
    }

    /// Makes the plane that several blocks have defined.
    pub(super) fn end_open_plane(&mut self) {
        let Some(open) = self.open_plane.take() else { return };
        let rules = self.control.table.tilted_plane;
        let parts = &open.parts[..open.form.count()];
        let missing = parts.iter().position(Option::is_none);
        let [first, second, third] = open.parts.map(|part| part.unwrap_or(Vec3::ZERO));
        let made = match (missing, open.form) {
            (Some(number), _) => Err(format!("a tilted plane without Q{}", number + 1)),
            (None, PartedForm::Points) => plane_forms::through_points([first, second, third])
                .ok_or_else(|| "the three points of the plane lie on a line".to_string()),
            (None, PartedForm::Vectors) => plane_forms::by_vectors(open.origin, [first, second])
                .map_err(|off| match off {
                    Some(off) => format!("X and Z of the plane miss a right angle by {off:.3} deg"),
                    None => "a vector of the plane has the length 0".to_string(),
                }),
        };
        match made {
            Ok(plane) => {
                let (by, angle) = open.shift;
                let plane = plane_forms::shifted(&plane, by, angle);
                let plane = match open.in_active {
                    true => plane.then(&self.active_plane()),
                    false => plane,
                };
                self.kernel.set_tilted_plane(Some(plane));
            }
            Err(message) => {
                let diagnostic = Diagnostic::new(Code::TiltedPlane, open.at, message)
                    .help("give every part of the plane, in blocks that follow each other");
                self.report_plane_diagnostic(diagnostic, rules.format);
                // The first block may stand in another file.
                let own = Some(open.at).filter(|at| at.file == self.file);
                let at = own.unwrap_or(self.kernel.origin.span);
                self.lose_path(at.range, "the plane is not known".to_string());
            }
        }
    }

    /// G68.3: upright under the tool as it stands.
    fn define_plane_by_tool(&mut self, block: &Block, at: usize) {
        self.unused_axes(block, |axis, _| axis < LINEAR_AXES);
        self.check_begin_of_plane(block, at, false);
        let rules = self.control.table.tilted_plane;
        let origin = self.linear_words(block);
        if origin.iter().any(Option::is_some) && origin.iter().any(Option::is_none) {
            let name = self.code_text(block, at);
            let message = format!("{name} with some of X, Y and Z");
            let help = "give all three, or none: then the origin is the tip of the tool";
            self.report_plane(block, at, message, help, rules.format);
        }
        let (tip, tool) = match self.kernel.tool_on_part() {
            Ok(stand) => stand,
            Err(_) => {
                let word = block.words[at];
                let what = "the direction of the tool is not known: a plane by it";
                return self.not_followed(&word, what);
            }
        };
        let tip = tip.to_array();
        let origin = std::array::from_fn(|axis| match origin.iter().all(Option::is_none) {
            true => tip[axis],
            false => origin[axis].unwrap_or(0.0),
        });
        let angle = self.angle_of(block, b'R').unwrap_or(0.0).to_radians();
        let plane = plane_forms::under_tool(Vec3::from_array(origin), tool, angle);
        self.take_plane(block, at, plane, false);
    }

    /// G254: the origin rides on the tables.
    fn begin_origin_on_table(&mut self, block: &Block, at: usize) {
        let follows_tip =
            self.kernel.state.part_frame.as_ref().is_some_and(|frame| frame.follows_tip);
        let name = self.code_text(block, at);
        let in_force = [
            (self.kernel.state.origin_on_table, "the dynamic work offset is on already"),
            (follows_tip, "tool centre point control is on"),
            (self.kernel.has_tilted_plane(), "a tilted plane is in force"),
        ];
        if let Some((_, what)) = in_force.into_iter().find(|(is_on, _)| *is_on) {
            let message = format!("{name} while {what}");
            let help =
                "end it before: G255 the offset, G49 tool centre point control, G269 a plane";
            self.report_plane(block, at, message, help, None);
        }
        let rotary = self.kernel.rotary_work_offset();
        if let Some((letter, degrees)) = rotary {
            let message = format!("{name} with {letter} at {degrees} deg in the work offset");
            let help =
                "set the rotary axes of the work offset to 0: the origin is turned from there";
            self.report_plane(block, at, message, help, None);
        }
        if self.kernel.begin_origin_on_table().is_err() {
            let word = block.words[at];
            self.not_followed(&word, "how the tables stand is not known: the origin on them");
        }
    }

    /// Tool centre point control begins: it does not go with an origin that rides on the tables.
    /// The direction of the tool by a vector does not go with a frame that stays.
    pub(super) fn check_begin_of_tool_center(&mut self, block: &Block, at: usize, by_vector: bool) {
        if by_vector && self.control.parameters.rules.frames.tip_frame_stays {
            let name = self.code_text(block, at);
            let message = format!("{name} while the frame of the tip stays");
            let diagnostic =
                Diagnostic::new(Code::ToolVector, self.span(block.words[at].range), message)
                    .label("the frame of a direction rides on the table")
                    .help("begin with G43.4 and write the rotary axes, or let the frame ride");
            let alarm = self.control.table.tilted_plane.vector_in_fixed_frame;
            self.report_plane_diagnostic(diagnostic, alarm);
        }
        if self.kernel.state.origin_on_table {
            let name = self.code_text(block, at);
            let message = format!("{name} while the dynamic work offset is on");
            self.report_plane(block, at, message, "end it before with G255", None);
        }
    }

    /// The order of the axes of I, J and K in which they turn; `None` if Q does not name each once.
    fn order_of_axes(&mut self, block: &Block) -> Option<[usize; 3]> {
        if !block.letters().has(b'Q') {
            return Some([0, 1, 2]);
        }
        let number = self.count_of(block, b'Q')?;
        let order =
            [number / 100, number / 10 % 10, number % 10].map(|digit| digit.wrapping_sub(1));
        let is_complete = number < 1000 && (0..3).all(|axis| order.contains(&axis));
        is_complete.then(|| order.map(|axis| axis as usize))
    }

    fn turn_to_plane(&mut self, block: &Block, at: usize, holds_tip: bool) {
        let rules = self.control.table.tilted_plane;
        let name = self.code_text(block, at);
        let sign = match block.letters().has(b'P') {
            true => self.count_of(block, b'P'),
            false => Some(0),
        };
        let sign = match sign {
            Some(1) => Some(AngleSign::Positive),
            Some(2) => Some(AngleSign::Negative),
            Some(0) => None,
            _ => {
                let message = format!("P of {name} is 0, 1 or 2");
                let help =
                    "1: the positive angle of the axis nearer to the tool, 2: the negative one";
                self.report_plane(block, at, message, help, rules.format);
                None
            }
        };
        match self.kernel.turn_to_plane(holds_tip, sign) {
            Ok(()) => {}
            Err(TurnError::NoPlane) => {
                let message = format!("{name} without a tilted plane");
                let help = "define the plane in a block before";
                self.report_plane(block, at, message, help, rules.without_plane);
            }
            Err(TurnError::NoKinematics(why)) => {
                let span = self.span(block.words[at].range);
                self.kernel.report_no_kinematics(span, &name, &why);
            }
            Err(TurnError::Unreachable(why)) => {
                let message = format!("{name}: {why}");
                let help = "choose another plane, or a machine whose axes reach it";
                self.report_plane(block, at, message, help, rules.unreachable);
            }
        }
    }

    fn report_plane(
        &mut self,
        block: &Block,
        at: usize,
        message: String,
        help: &str,
        alarm: Option<&str>,
    ) {
        let span = self.span(block.words[at].range);
        let diagnostic = Diagnostic::new(Code::TiltedPlane, span, message).help(help);
        self.report_plane_diagnostic(diagnostic, alarm);
    }

    fn report_plane_diagnostic(&mut self, diagnostic: Diagnostic, alarm: Option<&str>) {
        match alarm {
            Some(alarm) => self.report_refused(diagnostic, alarm),
            None => self.kernel.report(diagnostic),
        }
    }
}
