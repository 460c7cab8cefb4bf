//! What is open at a place of a run, by the codes that opened it.

use chordal::Control;
use chordal::control::{
    Action, CallCode, FrameKinds, LengthCode, ModeCode, OnceCode, SurfaceCode, TiltedPlaneCode,
};
use chordal::machine::AXIS_LETTERS;
use chordal::syntax::Block;

use super::shift::ActiveShift;
use crate::source::SourceBlocks;

/// Lines of blocks that opened something; nothing where it was never opened, or is closed as far as words say it: where
/// compensation, cycles and frames end, the modal state says.
#[derive(Clone, Debug, Default)]
pub(crate) struct OpenConstructs {
    pub(crate) compensation: Option<u32>,
    pub(crate) cycle: Option<u32>,
    pub(crate) frame: Option<u32>,
    /// The frames by their codes, also where the control has refused one.
    pub(crate) frames: FrameKinds,
    pub(crate) call: Option<u32>,
    /// `,R` or `,C`, which needs the next move.
    pub(crate) corner: Option<u32>,
    /// A G code that Chordal does not carry out.
    pub(crate) unknown: Option<(String, u32)>,
    pub(crate) shift: ActiveShift,
}

impl OpenConstructs {
    /// Follows a block that has been carried out; `moved`: a move was made before its end.
    pub(crate) fn follow(
        &mut self,
        source: &SourceBlocks,
        control: &Control,
        block: &Block,
        moved: bool,
    ) {
        self.corner = Some(block.line).filter(|_| block.commas);
        for word in &block.words {
            let Some(row) = control.row_of(word) else { continue };
            if row.action.is_left_out() && word.letter == b'G' {
                self.unknown = Some((row.name(word.letter), block.line));
            }
            self.follow_action(row.action, block);
            if let Some(code) = row.action.once() {
                self.shift.follow(source, control, block, code, moved);
            }
        }
    }

    fn follow_action(&mut self, action: Action, block: &Block) {
        let line = Some(block.line);
        match action {
            Action::Cycle(_) => self.cycle = line,
            Action::Call(CallCode::ModalMacroCall { .. })
            | Action::Mode(ModeCode::ModalSubroutine) => self.call = line,
            Action::Mode(ModeCode::ModalCallOff) => self.call = None,
            Action::Mode(
                ModeCode::CompensationLeft
                | ModeCode::CompensationRight
                | ModeCode::CompensationLeftByDiameter
                | ModeCode::CompensationRightByDiameter,
            ) => self.compensation = line,
            Action::Once(OnceCode::Rotation) => (self.frame, self.frames.rotation) = (line, true),
            Action::Mode(ModeCode::RotationOff) => {
                (self.frames.rotation, self.frames.part) = (false, false);
            }
            Action::Once(OnceCode::Scaling) => (self.frame, self.frames.scaling) = (line, true),
            Action::Mode(ModeCode::ScalingOff) => self.frames.scaling = false,
            Action::Once(OnceCode::Mirror { .. }) => {
                (self.frame, self.frames.mirror) = (line, true);
            }
            Action::Once(OnceCode::MirrorOff) => self.frames.mirror = false,
            Action::Mode(ModeCode::Polar { on: true }) => {
                (self.frame, self.frames.polar) = (line, true);
            }
            Action::Mode(ModeCode::Polar { on: false }) => self.frames.polar = false,
            Action::Once(OnceCode::Surface(code)) => {
                (self.frame, self.frames.surface) = (line, begins_surface(block, code));
            }
            Action::Length(
                LengthCode::ToolCenter | LengthCode::ToolCenterByVector | LengthCode::AlongTool,
            )
            | Action::Once(OnceCode::TiltedPlane(
                TiltedPlaneCode::Define { .. }
                | TiltedPlaneCode::DefineByAxes
                | TiltedPlaneCode::DefineByTool
                | TiltedPlaneCode::OriginOnTable { on: true },
            )) => {
                (self.frame, self.frames.part) = (line, true);
            }
            Action::Length(LengthCode::Cancel)
            | Action::Once(OnceCode::TiltedPlane(
                TiltedPlaneCode::Off | TiltedPlaneCode::OriginOnTable { on: false },
            )) => self.frames.part = false,
            Action::Reading(_)
            | Action::Before(_)
            | Action::Mode(_)
            | Action::Length(_)
            | Action::Motion(_)
            | Action::Once(_)
            | Action::Call(_)
            | Action::After(_)
            | Action::NoEffect
            | Action::NotSimulated
            | Action::NotFollowed => {}
        }
    }
}

/// Whether a code begins polar or cylindrical interpolation: a cylinder without a radius ends it.
fn begins_surface(block: &Block, code: SurfaceCode) -> bool {
    let is_radius = |letter: u8| AXIS_LETTERS.as_bytes().contains(&letter) || letter == b'R';
    let mut radii = block.words.iter().filter(|word| is_radius(word.letter));
    match code {
        SurfaceCode::Face => true,
        SurfaceCode::FaceOff => false,
        SurfaceCode::Cylinder => {
            radii.any(|word| word.number().is_none_or(|number| !number.is_zero()))
        }
    }
}
