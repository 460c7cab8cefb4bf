//! What is open at a place of a run, by the codes that opened it.

use chordal::Control;
use chordal::control::{Action, CallCode, FrameKinds, ModeCode, OnceCode, SurfaceCode};
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
            if matches!(row.action, Action::NotSimulated | Action::NotFollowed)
                && word.letter == b'G'
            {
                self.unknown = Some((row.name(word.letter), block.line));
            }
            self.follow_action(row.action, block);
            if let Some(code) = row.action.once() {
                self.shift.follow(source, control, block, code, moved);
            }
        }
    }

    fn follow_action(&mut self, action: Action, block: &Block) {
        self.follow_frame(action, block);
        let opened = match action {
            Action::Cycle(_) => &mut self.cycle,
            Action::Call(CallCode::ModalMacroCall { .. })
            | Action::Mode(ModeCode::ModalSubroutine) => &mut self.call,
            Action::Mode(
                ModeCode::CompensationLeft
                | ModeCode::CompensationRight
                | ModeCode::CompensationLeftBy
                | ModeCode::CompensationRightBy,
            ) => &mut self.compensation,
            Action::Mode(ModeCode::Polar { on: true })
            | Action::Once(
                OnceCode::Rotation
                | OnceCode::Scaling
                | OnceCode::Mirror { .. }
                | OnceCode::Surface(_),
            ) => &mut self.frame,
            Action::Mode(ModeCode::ModalCallOff) => return self.call = None,
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
            | Action::NotFollowed => return,
        };
        *opened = Some(block.line);
    }

    fn follow_frame(&mut self, action: Action, block: &Block) {
        let frames = &mut self.frames;
        match action {
            Action::Once(OnceCode::Rotation) => frames.rotation = true,
            Action::Mode(ModeCode::RotationOff) => frames.rotation = false,
            Action::Once(OnceCode::Scaling) => frames.scaling = true,
            Action::Mode(ModeCode::ScalingOff) => frames.scaling = false,
            Action::Once(OnceCode::Mirror { .. }) => frames.mirror = true,
            Action::Once(OnceCode::MirrorOff) => frames.mirror = false,
            Action::Mode(ModeCode::Polar { on }) => frames.polar = on,
            Action::Once(OnceCode::Surface(code)) => frames.surface = begins_surface(block, code),
            Action::Reading(_)
            | Action::Before(_)
            | Action::Mode(_)
            | Action::Length(_)
            | Action::Motion(_)
            | Action::Cycle(_)
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
