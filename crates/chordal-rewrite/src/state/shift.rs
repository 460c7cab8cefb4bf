//! What moved the zero and holds, in the words of the program: G52, and a G92 before the first move.

use chordal::Control;
use chordal::control::OnceCode;
use chordal::machine::AXIS_LETTERS;
use chordal::syntax::{Block, Letters};

use crate::source::SourceBlocks;

/// Axes by which a block moves the zero.
const AXES: Letters = Letters::of("XYZUVWCH");

/// The blocks that made it, while it is not back at zero.
#[derive(Clone, Debug, Default)]
pub(crate) struct ActiveShift {
    pub(crate) lines: Vec<String>,
    /// The axes that are off zero.
    axes: Vec<u8>,
    /// The blocks that gave the place where the program starts its coordinates.
    pub(crate) presets: Vec<String>,
    /// The line of a block that cannot be said again.
    pub(crate) unrepeatable: Option<u32>,
    /// Some block has moved the zero, and none has brought it back.
    pub(crate) is_active: bool,
}

impl ActiveShift {
    /// Follows a code of a block; `moved`: a move was made before its end.
    pub(super) fn follow(
        &mut self,
        source: &SourceBlocks,
        control: &Control,
        block: &Block,
        code: OnceCode,
        moved: bool,
    ) {
        let is_repeatable = match code {
            OnceCode::LocalShift => self.take(source, block),
            OnceCode::PresetPosition if limits_spindle(block, control) => true,
            // At the place where the program starts it can be said again.
            OnceCode::PresetPosition if !moved => {
                self.presets.push(source.words_of(block));
                block.words.iter().all(|word| word.number().is_some())
            }
            OnceCode::PresetPosition | OnceCode::RestorePreset => false,
            OnceCode::ClearPreset { .. } => {
                (self.is_active, self.unrepeatable) = (false, None);
                return self.presets.clear();
            }
            OnceCode::Rotation
            | OnceCode::Scaling
            | OnceCode::Mirror { .. }
            | OnceCode::MirrorOff
            | OnceCode::Surface(_)
            | OnceCode::TiltedPlane(_)
            | OnceCode::Dwell
            | OnceCode::SetData
            | OnceCode::ReturnToReference { .. }
            | OnceCode::ReturnFromReference
            | OnceCode::Home
            | OnceCode::MachineCoordinates
            | OnceCode::CircularPocketCw
            | OnceCode::CircularPocketCcw
            | OnceCode::GeneralPocket
            | OnceCode::Engraving
            | OnceCode::Pattern(_)
            | OnceCode::Probe { .. }
            | OnceCode::Turning(_)
            | OnceCode::CornerArcBlock => return,
        };
        let mut axes = block
            .words
            .iter()
            .filter(|word| AXIS_LETTERS.as_bytes().contains(&word.letter))
            .peekable();
        self.is_active = code != OnceCode::LocalShift
            || axes.peek().is_none()
            || !axes.all(|word| word.number().is_some_and(|number| number.is_zero()));
        if !is_repeatable {
            self.unrepeatable = Some(block.line);
        }
    }

    /// Takes a block with G52; false where a value is no plain number.
    fn take(&mut self, source: &SourceBlocks, block: &Block) -> bool {
        for word in &block.words {
            if !b"XYZABCUVW".contains(&word.letter) {
                continue;
            }
            let Some(number) = word.number() else { return false };
            self.axes.retain(|axis| *axis != word.letter);
            if number.to_f64() != 0.0 {
                self.axes.push(word.letter);
            }
        }
        self.lines.push(source.words_of(block));
        if self.axes.is_empty() {
            self.lines.clear();
        }
        true
    }
}

/// A block that limits the spindle and moves no zero.
pub(crate) fn limits_spindle(block: &Block, control: &Control) -> bool {
    control.parameters.preset_limits_speed
        && block.word(b'S').is_some()
        && !block.letters().meets(AXES)
}
