//! What a code is to a firmware: who takes the axis words, and which mode it changes.

use chordal_dialect::{
    Action, CodeGroup, CodeRow, Control, LengthCode, ModeCode, MotionCode, OnceCode, ReadingCode,
    code_number,
};
use chordal_syntax::Decimal;

use super::line::ReadWord;
use super::memory::{FirmwareModes, FirmwareMotion};

/// What takes the axis words of a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum AxisUse {
    Once,
    Motion,
    Length,
}

/// G53.
pub(super) fn is_machine_move(control: &Control, word: &ReadWord) -> bool {
    let row = code_number(word.number).and_then(|code| control.g_code(code));
    word.letter == b'G'
        && row.is_some_and(|row| row.action == Action::Once(OnceCode::MachineCoordinates))
}

/// A code, in tenths, as it is written.
pub(super) fn tenths(code: u16) -> Decimal {
    match code % 10 {
        0 => Decimal::integer(i64::from(code / 10)),
        _ => Decimal { mantissa: i64::from(code), scale: 1, has_point: true, negative: false },
    }
}

/// The whole number of a code; one that no code has where it is below zero or large.
pub(super) fn whole_number(value: f32) -> u16 {
    let whole = value.trunc();
    if (0.0..1000.0).contains(&whole) { whole as u16 } else { 1000 }
}

/// So many mm, in inch.
pub(super) fn in_inch(mm: f32) -> Decimal {
    let mantissa = (f64::from(mm) / 25.4 * 1e12).round() as i64;
    Decimal { mantissa, scale: 12, has_point: true, negative: false }
}

/// A number cut to a byte.
pub(super) fn byte(value: f32) -> u8 {
    (value.trunc() as i64) as u8
}

/// What a code takes the axis words for.
pub(super) fn axis_use(row: &'static CodeRow) -> Option<AxisUse> {
    let action = row.action;
    let is_probe = matches!(action.once(), Some(OnceCode::Probe { .. }));
    if action.motion().is_some() || action.cycle().is_some() || is_probe {
        return Some(AxisUse::Motion);
    }
    if let Action::Length(code) = action {
        return length_axes(code);
    }
    (takes_axes(row) || action == Action::NotFollowed).then_some(AxisUse::Once)
}

/// G43.1 and G49 ask for the axis words, whether they have them or not; G43 H does not.
fn length_axes(code: LengthCode) -> Option<AxisUse> {
    match code {
        LengthCode::FromAxes | LengthCode::Cancel => Some(AxisUse::Length),
        LengthCode::Plus
        | LengthCode::Minus
        | LengthCode::Add
        | LengthCode::ToolCenter
        | LengthCode::ToolCenterByVector
        | LengthCode::AlongTool => None,
    }
}

/// It needs the axis words for itself: a code with a stored place (G28.1) does not, nor does G53.
fn takes_axes(row: &CodeRow) -> bool {
    match row.action.once() {
        Some(OnceCode::SetData | OnceCode::PresetPosition) => true,
        Some(OnceCode::ReturnToReference { .. }) => true,
        Some(_) | None => false,
    }
}

/// G80.
pub(super) fn ends_motion(row: &CodeRow) -> bool {
    row.action == Action::Mode(ModeCode::CancelCycle)
}

impl FirmwareModes {
    /// What a code changes.
    pub fn take(&mut self, row: &CodeRow) {
        if let Some(motion) = row.action.motion() {
            self.motion = match motion {
                MotionCode::Rapid => FirmwareMotion::Rapid,
                MotionCode::ArcCw | MotionCode::ArcCcw => FirmwareMotion::Arc,
                MotionCode::Linear
                | MotionCode::SpiralCw
                | MotionCode::SpiralCcw
                | MotionCode::Thread
                | MotionCode::RigidTap
                | MotionCode::SplineEnd
                | MotionCode::Turn(_) => FirmwareMotion::Linear,
                MotionCode::Spline(_) => FirmwareMotion::Spline(row.code),
            };
        } else if row.action.cycle().is_some() {
            self.motion = FirmwareMotion::Cycle;
        } else if let Action::Once(OnceCode::Probe { .. }) = row.action {
            self.motion = FirmwareMotion::Probe(row.code);
        } else if ends_motion(row) {
            self.motion = FirmwareMotion::None;
        } else if let Action::Reading(code) = row.action {
            match code {
                ReadingCode::Inch => self.inch = true,
                ReadingCode::Millimetre => self.inch = false,
                ReadingCode::Absolute => self.incremental = false,
                ReadingCode::Incremental => self.incremental = true,
                ReadingCode::FeedInverseTime => self.inverse = true,
                ReadingCode::FeedPerTime => self.inverse = false,
                ReadingCode::ArcCenterAbsolute
                | ReadingCode::ArcCenterIncremental
                | ReadingCode::FeedPerRevolution
                | ReadingCode::SurfaceSpeed
                | ReadingCode::SpindleRpm
                | ReadingCode::Diameters
                | ReadingCode::Radii => {}
            }
        } else if row.group == CodeGroup::Plane {
            self.plane = usize::from(row.code / 10 - 17);
        } else if row.group == CodeGroup::ReturnLevel {
            self.return_to_r = row.action == Action::Mode(ModeCode::ReturnToR);
        } else if row.group == CodeGroup::WorkOffset {
            // G59.1 comes after G59.
            self.system = usize::from(row.code / 10 - 54 + row.code % 10);
        }
    }
}
