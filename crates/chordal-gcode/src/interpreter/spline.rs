//! Splines: G5 and G5.1 in one block, G5.2 to G5.3 by control points.

use chordal_command::{AxisMask, CompensationSide, Position};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_dialect::{Action, MotionCode};
use chordal_geometry::{Plane, Spline, SplinePiece, Vec3};
use chordal_kernel::{ModalMotion, SplineForm};
use chordal_syntax::{Block, Letters};

use super::Interpreter;

/// The order of a NURBS without L, and the smallest one with L.
const MIN_ORDER: usize = 3;

/// The state of splines between blocks.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct SplineMemory {
    /// The vector from the start to the first control point of the next G5 without I and J, mm.
    continuation: [f64; 2],
    /// The open NURBS; `None` without one.
    open: Option<OpenSpline>,
}

/// The control points since G5.2.
#[derive(Clone, Debug, PartialEq)]
struct OpenSpline {
    points: Vec<Vec3>,
    weights: Vec<f64>,
    order: usize,
    /// The axes named by its points.
    named: AxisMask,
}

/// X, Y and Z of a position.
fn point(position: &Position) -> Vec3 {
    Vec3::new(position[0], position[1], position[2])
}

impl Interpreter<'_> {
    /// Carries out a block while G5, G5.1 or G5.2 is active.
    pub(super) fn spline_block(&mut self, block: &Block, form: SplineForm, explicit: bool) {
        let letters = block.letters();
        let words = match form {
            SplineForm::Cubic => Letters::of("XYZABCIJPQ"),
            SplineForm::Quadratic => Letters::of("XYZABCIJ"),
            SplineForm::Points => Letters::of("XYZABCPL"),
        };
        if !(explicit || letters.meets(words)) {
            return;
        }
        let (mut target, named) = self.target(block);
        let fits = self.check_spline_axes(block, named);
        target[2..].copy_from_slice(&self.kernel.state.position[2..]);
        match form {
            SplineForm::Points => self.control_point(block, &target, named),
            SplineForm::Cubic | SplineForm::Quadratic => {
                let middle = match form {
                    SplineForm::Cubic => self.cubic_points(block, &target),
                    _ => self.quadratic_point(block),
                };
                match middle {
                    Some(middle) if fits => {
                        let points =
                            [&[self.kernel.point()], &middle[..], &[point(&target)]].concat();
                        if let Ok(curve) = Spline::bezier(points) {
                            self.kernel.spline(&self.at(block), curve, named.and(AxisMask::XY));
                        }
                    }
                    _ => self.kernel.straight_instead(
                        &self.at(block),
                        target,
                        named.and(AxisMask::XY),
                    ),
                }
            }
        }
    }

    /// The inner control points of G5; `None` when words are missing, which is reported.
    fn cubic_points(&mut self, block: &Block, target: &Position) -> Option<Vec<Vec3>> {
        let [i, j, p, q] = [b'I', b'J', b'P', b'Q'].map(|letter| self.length_of(block, letter));
        let (Some(p), Some(q)) = (p, q) else {
            let missing = if p.is_none() && q.is_none() {
                "P and Q"
            } else if p.is_none() {
                "P"
            } else {
                "Q"
            };
            self.report_spline(
                Code::SplineWords,
                self.span(block.range),
                format!("a cubic spline without {missing}"),
                "give P and Q, the way from the end to the second control point",
            );
            return None;
        };
        let [i, j] = match (i, j) {
            (Some(i), Some(j)) => [i, j],
            (None, None) => self.spline.continuation,
            _ => {
                let (has, lacks) = if i.is_some() { ("I", "J") } else { ("J", "I") };
                self.report_spline(
                    Code::SplineWords,
                    self.words_span(block, Letters::of("IJ")),
                    format!("a cubic spline with {has} and without {lacks}"),
                    "give both I and J, or neither to go on in the direction of the last G5",
                );
                return None;
            }
        };
        self.spline.continuation = [-p, -q];
        let (start, end) = (self.kernel.point(), point(target));
        Some(vec![start + Vec3::new(i, j, 0.0), end + Vec3::new(p, q, 0.0)])
    }

    /// The inner control point of G5.1; `None` when words are missing, which is reported.
    fn quadratic_point(&mut self, block: &Block) -> Option<Vec<Vec3>> {
        let (i, j) = (self.length_of(block, b'I'), self.length_of(block, b'J'));
        let (Some(i), Some(j)) = (i, j) else {
            let missing = if i.is_none() && j.is_none() {
                "I and J"
            } else if i.is_none() {
                "I"
            } else {
                "J"
            };
            self.report_spline(
                Code::SplineWords,
                self.span(block.range),
                format!("a quadratic spline without {missing}"),
                "give I and J, the way from the start to the control point",
            );
            return None;
        };
        Some(vec![self.kernel.point() + Vec3::new(i, j, 0.0)])
    }

    /// Adds a control point of G5.2; the first block begins the spline at the present position.
    fn control_point(&mut self, block: &Block, target: &Position, named: AxisMask) {
        let letters = block.letters();
        let span = self.span(block.range);
        let first = self.spline.open.is_none();
        let has = [letters.has(b'X'), letters.has(b'Y')];
        let weight = self.weight(block);
        let begins_alone = first && !letters.has(b'P') && !has[0];
        let lacks_weight = !begins_alone && weight.is_none_or(|weight| weight <= 0.0);
        if has[0] != has[1] {
            let (has, lacks) = if has[0] { ("X", "Y") } else { ("Y", "X") };
            self.report_spline(
                Code::SplinePoint,
                span,
                format!("a control point with {has} and without {lacks}"),
                "give X and Y of every control point",
            );
        } else if !has[0] && letters.has(b'P') && !first {
            self.report_spline(
                Code::SplinePoint,
                span,
                "a weight P without X and Y".to_string(),
                "only the first line of a NURBS may give P alone, for the point where the tool stands",
            );
        } else if lacks_weight {
            let message = match weight {
                Some(weight) => format!("a control point of weight {weight}"),
                None => "a control point without its weight P".to_string(),
            };
            self.report_spline(
                Code::SplineWeight,
                span,
                message,
                "give P above zero: P1 is a plain point",
            );
        }
        let order = if letters.has(b'L') { self.count_of(block, b'L').unwrap_or(0) } else { 0 };
        let weight = weight.filter(|weight| *weight > 0.0).unwrap_or(1.0);
        let start = self.kernel.point();
        let begins = if has == [false; 2] { weight } else { 1.0 };
        let open = self.spline.open.get_or_insert_with(|| OpenSpline {
            points: vec![start],
            weights: vec![begins],
            order: MIN_ORDER,
            named: AxisMask::NONE,
        });
        if order as usize > MIN_ORDER {
            open.order = order as usize;
        }
        if has != [false; 2] {
            open.points.push(point(target));
            open.weights.push(weight);
            open.named = open.named.or(named.and(AxisMask::XY));
        }
    }

    fn weight(&mut self, block: &Block) -> Option<f64> {
        let word = *block.last(b'P')?;
        Some(self.literal(&word)?.to_f64())
    }

    /// G5.3: cuts along the curve of the control points.
    pub(super) fn end_spline(&mut self, block: &Block) {
        let span = self.span(block.range);
        let open = self.spline.open.take();
        let is_open = self.kernel.state.motion == ModalMotion::Spline(SplineForm::Points);
        self.kernel.state.motion = ModalMotion::None;
        let (_, named) = self.target(block);
        if named != AxisMask::NONE {
            self.report_spline(
                Code::SplinePoint,
                span,
                "axis words in the block of G5.3 are no control point".to_string(),
                "put the point into a block of its own before G5.3",
            );
        }
        let Some(open) = open.filter(|_| is_open) else {
            return self.report_spline(
                Code::SplineOpen,
                span,
                "G5.3 without control points".to_string(),
                "begin the NURBS with G5.2",
            );
        };
        let OpenSpline { points, weights, order, named } = open;
        let count = points.len();
        let mut target = self.kernel.state.position;
        if let Some(last) = points.last() {
            target[..3].copy_from_slice(&last.to_array());
        }
        let most = SplinePiece::MAX_ORDER;
        if count < order {
            let mut diagnostic = Diagnostic::new(
                Code::SplineTooFew,
                span,
                format!(
                    "a spline of order {order} needs {order} control points; this one has {count}"
                ),
            )
            .note("the position of the tool at G5.2 is the first of them")
            .help("add points, or lower L");
            diagnostic.alarm = self.kernel.alarm_text(Code::SplineTooFew, Some(order.to_string()));
            self.kernel.report(diagnostic);
        } else if order > most {
            self.report_spline(
                Code::SplineOrder,
                span,
                format!("a spline of order {order}; Chordal carries out orders up to {most}"),
                "lower L, or write the curve as lines",
            );
        } else if self.check_spline_axes(block, AxisMask::NONE)
            && let Ok(curve) = Spline::uniform(order, points, weights)
        {
            return self.kernel.spline(&self.at(block), curve, named);
        }
        self.kernel.straight_instead(&self.at(block), target, named);
    }

    /// True when plane, axes and compensation permit a spline; otherwise this is reported.
    fn check_spline_axes(&mut self, block: &Block, named: AxisMask) -> bool {
        let before = self.kernel.state.side;
        let others = named.without(AxisMask::XY);
        if self.kernel.state.plane != Plane::Xy {
            let plane = super::arc::plane_name(self.kernel.state.plane);
            self.report_spline(
                Code::SplinePlane,
                self.span(block.range),
                format!("a spline, and the plane is {plane}"),
                "choose G17 before the spline",
            );
        } else if others != AxisMask::NONE {
            let letters: String = others.iter().map(|axis| axis.letter()).collect();
            let words = letters.bytes().fold(Letters::NONE, |mut all, letter| {
                all.insert(letter);
                all
            });
            self.report_spline(
                Code::SplinePlane,
                self.words_span(block, words),
                format!(
                    "{} in a spline, which moves X and Y only",
                    letters.chars().map(String::from).collect::<Vec<_>>().join(", ")
                ),
                "move the other axes in a block of their own",
            );
        } else if before != CompensationSide::Off {
            self.report_spline(
                Code::SplineInCompensation,
                self.span(block.range),
                "a spline while cutter compensation is on".to_string(),
                "cancel compensation with G40 before the spline",
            );
        } else {
            return true;
        }
        false
    }

    /// Reports a motion code that discards the points of an open NURBS.
    pub(super) fn watch_open_spline(&mut self, block: &Block, code: MotionCode) {
        let is_open = self.kernel.state.motion == ModalMotion::Spline(SplineForm::Points);
        let continues = match code {
            MotionCode::Spline(SplineForm::Points) => is_open,
            MotionCode::SplineEnd => true,
            MotionCode::Rapid
            | MotionCode::Linear
            | MotionCode::ArcCw
            | MotionCode::ArcCcw
            | MotionCode::SpiralCw
            | MotionCode::SpiralCcw
            | MotionCode::Thread
            | MotionCode::RigidTap
            | MotionCode::Turn(_)
            | MotionCode::Spline(SplineForm::Cubic | SplineForm::Quadratic) => false,
        };
        if !continues {
            self.drop_open_spline(block);
        }
    }

    /// Reports a NURBS that G5.3 does not end.
    #[inline]
    pub(super) fn drop_open_spline(&mut self, block: &Block) {
        let Some(open) = self.spline.open.take() else { return };
        let count = open.points.len();
        let diagnostic = Diagnostic::new(
            Code::SplineOpen,
            self.span(block.range),
            format!("G5.3 is missing: {count} control points since G5.2 are not cut"),
        )
        // The control discards them without a message.
        .severity(Severity::Warning)
        .help("end the NURBS with G5.3 before this block");
        self.kernel.report(diagnostic);
    }

    #[cold]
    fn report_spline(&mut self, code: Code, span: Span, message: String, help: &str) {
        let diagnostic = Diagnostic::new(code, span, message).help(help);
        // A problem of a single control point does not prevent the curve.
        let of_points = [Code::SplinePoint, Code::SplineWeight, Code::SplineOpen].contains(&code);
        self.kernel.report(match of_points {
            true => diagnostic,
            false => diagnostic.label("shown as a straight line"),
        });
    }

    /// Ten times the code of a spline.
    pub(super) fn spline_code(&self, form: SplineForm) -> f64 {
        let action = Action::Motion(MotionCode::Spline(form));
        let row = self.control.table.g_codes.iter().find(|row| row.action == action);
        row.map_or(50.0, |row| f64::from(row.code))
    }
}
