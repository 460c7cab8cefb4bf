//! Blocks of DIN/ISO programs: their G codes become the path functions and cycles of the conversational form.

use chordal_command::{CommandKind, CompensationSide, SpindleState};
use chordal_diagnostics::{Code, TextRange};
use chordal_geometry::TurnDirection;

use super::interpreter::KlartextInterpreter;
use super::run_state::KlartextFlow;
use super::transformations::Transformation;
use crate::syntax::{
    FeedValue, FeedWord, IsoWords, OperandWord, PathFunction, PathWords, ToolCallWords, ToolName,
};

/// Whether a code is one of motion.
const fn is_motion(code: u32) -> bool {
    matches!(code, 0..=3 | 5..=7 | 10..=13 | 15 | 16)
}

/// Codes that change nothing here: soft keys of a contour, the next tool, the protection of parts.
const WITHOUT_EFFECT: [u32; 5] = [9, 50, 51, 70, 71];

impl KlartextInterpreter<'_> {
    /// The words of a block after its modal codes: coordinates are incremental after G91.
    pub(super) fn iso_words(&mut self, words: &IsoWords) -> IsoWords {
        let mut words = words.clone();
        self.take_iso_codes(&words);
        let is_incremental = self.modes.iso.is_incremental;
        let coordinates = words.axes.iter_mut().chain(&mut words.center);
        for word in coordinates.chain([&mut words.angle, &mut words.radius]).flatten() {
            word.is_incremental = is_incremental;
        }
        words
    }

    /// Carries out a block of a DIN/ISO program.
    pub(super) fn iso_block(&mut self, words: &IsoWords) -> KlartextFlow {
        let words = self.iso_words(words);
        let has = |code: u32| words.codes.iter().any(|(own, _)| *own == code);
        if words.tool.is_some() || words.speed.is_some() {
            self.iso_tool_call(&words);
        }
        if let Some(flow) = self.iso_once(&words) {
            return flow;
        }
        let has_center = words.center.iter().any(Option::is_some);
        if has_center || has(29) {
            let mut center = PathWords::default();
            center.axes[..3].copy_from_slice(&words.center);
            self.set_center(&center);
        }
        let path = self.iso_path(&words);
        let is_polar = matches!(self.modes.iso.motion, 10..=13 | 15 | 16);
        let has_side = path.side.is_some();
        let moves = path.axes.iter().any(Option::is_some)
            || is_polar && (words.radius.is_some() || words.angle.is_some())
            || has_side && has_center;
        if !moves {
            // F alone, G40 alone and M functions alone.
            if let Some((side, _)) = path.side {
                self.iso_side_alone(side, &path);
            }
            return self.functions_alone(&PathWords { side: None, ..path });
        }
        self.path_block(self.iso_function(&words), &path)
    }

    /// Modal codes, and those that are not known.
    fn take_iso_codes(&mut self, words: &IsoWords) {
        let motions = words.codes.iter().filter(|(code, _)| is_motion(*code));
        if let Some((code, range)) = motions.skip(1).last() {
            let message = format!("G{code} is a second motion in this block");
            self.problem(Code::SameGroup, *range, message);
        }
        for (code, range) in &words.codes {
            match code {
                90 => self.modes.iso.is_incremental = false,
                91 => self.modes.iso.is_incremental = true,
                code if is_motion(*code) => self.modes.iso.motion = *code,
                4 | 17..=20 | 28..=31 | 36 | 38 | 40..=44 | 54 | 72 | 73 | 79 => {}
                code if WITHOUT_EFFECT.contains(code) => {}
                1..=89 => {
                    let what = format!("G{code} is not followed here");
                    self.not_followed_once(&format!("G{code}"), *range, &what);
                }
                code => {
                    let message = format!("G{code} is no code of this control");
                    self.problem(Code::UnknownCode, *range, message);
                }
            }
        }
        match self.modes.iso.motion {
            2 | 12 => self.modes.iso.direction = TurnDirection::Cw,
            3 | 13 => self.modes.iso.direction = TurnDirection::Ccw,
            _ => {}
        }
    }

    fn iso_side_alone(&mut self, side: CompensationSide, path: &PathWords) {
        if side == CompensationSide::Off {
            self.set_compensation(PathFunction::Line, path);
        }
    }

    /// Codes that use the words of their block themselves; `None` where the block goes on.
    fn iso_once(&mut self, words: &IsoWords) -> Option<KlartextFlow> {
        let axes = PathWords { axes: words.axes, ..PathWords::default() };
        for (code, range) in words.codes.clone() {
            match code {
                30 | 31 => self.blank(Some((code - 29) as u8), &axes),
                54 => self.datum_shift(&axes),
                28 => {
                    let [x, y, z, ..] = words.named;
                    self.transform(Transformation::Mirror([x, y, z]));
                }
                73 => self.iso_rotation(words, range),
                72 => {
                    let factor = words.feed.and_then(|word| self.operand(word.value, word.range));
                    match factor.filter(|factor| *factor > 0.0) {
                        Some(factor) => self.transform(Transformation::Scale(factor)),
                        None => {
                            let message = "G72 has no factor F above zero";
                            self.problem(Code::MissingWord, range, message);
                        }
                    }
                }
                4 => {
                    let seconds = words.feed.and_then(|word| self.operand(word.value, word.range));
                    let seconds = seconds.unwrap_or(0.0).max(0.0);
                    self.kernel.emit(CommandKind::Dwell { seconds, label: None });
                }
                36 => self.kernel.set_spindle(SpindleState::Oriented),
                38 => self.kernel.emit(CommandKind::Stop { optional: false }),
                79 => {
                    let functions =
                        PathWords { functions: words.functions.clone(), ..PathWords::default() };
                    return Some(self.cycle_call_block(&functions));
                }
                _ => continue,
            }
            return Some(self.functions_at_end(&words.functions));
        }
        None
    }

    fn iso_rotation(&mut self, words: &IsoWords, range: TextRange) {
        let Some(word) = words.angle else {
            return self.problem(Code::MissingWord, range, "G73 has no angle H");
        };
        let Some(value) = self.operand(word.value, word.range) else { return };
        let before = self.modes.chain.rotation_deg();
        let degrees = if word.is_incremental { before + value } else { value };
        self.transform(Transformation::Rotation(self.tool_plane(), degrees));
    }

    fn iso_tool_call(&mut self, words: &IsoWords) {
        let axis = words.codes.iter().find_map(|(code, _)| match code {
            17 => Some(2),
            18 => Some(1),
            19 => Some(0),
            _ => None,
        });
        let call = ToolCallWords {
            tool: words.tool.map(|word| (ToolName::Number(word.value), word.range)),
            axis,
            speed: words.speed.map(|word| word.value),
            ..ToolCallWords::default()
        };
        self.tool_call(&call);
    }

    /// The path function of the active motion.
    pub(super) fn iso_function(&self, words: &IsoWords) -> PathFunction {
        match self.modes.iso.motion {
            2 | 3 | 5 if words.radius.is_some() => PathFunction::RadiusArc,
            2 | 3 | 5 => PathFunction::CenterArc,
            6 => PathFunction::TangentArc,
            10 | 11 => PathFunction::PolarLine,
            12 | 13 | 15 => PathFunction::PolarArc,
            16 => PathFunction::PolarTangentArc,
            _ => PathFunction::Line,
        }
    }

    /// The words of the conversational form.
    pub(super) fn iso_path(&self, words: &IsoWords) -> PathWords {
        let motion = self.modes.iso.motion;
        let side = words.codes.iter().find_map(|(code, range)| match code {
            40 => Some((CompensationSide::Off, *range)),
            41 => Some((CompensationSide::Left, *range)),
            42 => Some((CompensationSide::Right, *range)),
            _ => None,
        });
        let is_rapid = matches!(motion, 0 | 10);
        let feed = match (is_rapid, words.feed) {
            (true, _) => Some(FeedWord { value: FeedValue::Rapid, range: self.here }),
            (false, Some(OperandWord { value, range, .. })) => {
                Some(FeedWord { value: FeedValue::Value(value), range })
            }
            (false, None) => None,
        };
        let is_polar = matches!(motion, 10..=13 | 15 | 16);
        let is_arc = matches!(motion, 2 | 3 | 5 | 12 | 13 | 15);
        let is_by_sign = is_polar && words.angle.is_some_and(|word| word.is_incremental);
        let direction = (is_arc && !is_by_sign).then_some((self.modes.iso.direction, self.here));
        PathWords {
            axes: words.axes,
            polar_radius: words.radius.filter(|_| is_polar),
            polar_angle: words.angle.filter(|_| is_polar),
            radius: words.radius.filter(|_| !is_polar),
            direction,
            side,
            feed,
            functions: words.functions.clone(),
            ..PathWords::default()
        }
    }
}
