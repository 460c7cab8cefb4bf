//! TRANS, ROT, SCALE, MIRROR and their additive forms; CYCLE800 without angles.

use chordal_command::Position;
use chordal_diagnostics::TextRange;
use chordal_kernel::frames::FrameMap;

use super::interpreter::Interpreter;
use super::programmable_frame::{linear, rotated, scaled, shift_of};
use super::words::BlockWords;

impl Interpreter<'_> {
    /// The position with X, Y and Z at a programmed point (mm) and the rotary axes where they are.
    pub(super) fn mapped(&self, [x, y, z]: [f64; 3]) -> Position {
        let [_, _, _, a, b, c] = self.kernel.state.position;
        self.modes.frame.point(&[x, y, z, a, b, c])
    }

    /// Sets the programmable frame. The axes do not move.
    pub(super) fn set_frames(&mut self, range: TextRange, words: &BlockWords) {
        for (name, _) in &words.names {
            let is_additive = name.starts_with('A') && name != "ANG";
            let bare = if is_additive { &name[1..] } else { name.as_str() };
            let inner = match bare {
                "TRANS" => FrameMap::translation(linear(self.lengths(words), 0.0)),
                "ROT" => self.rotation(words),
                "SCALE" => scaled(factors(words)),
                "MIRROR" => scaled(mirrors(words)),
                _ => continue,
            };
            let map = match is_additive {
                true => inner.then(&self.modes.programmable),
                false => inner,
            };
            self.modes.set_frames(map, self.modes.swivel);
            self.modes.last_direction = None;
            // TRANS and its like begin anew; ATRANS adds to what G59 replaces.
            let added = if bare == "TRANS" { self.lengths(words) } else { [0.0; 3] };
            self.modes.additive_shift = match is_additive {
                true => std::array::from_fn(|axis| self.modes.additive_shift[axis] + added[axis]),
                false => [0.0; 3],
            };
        }
        for (code, _) in &words.g_codes {
            if matches!(code, 58 | 59) {
                self.replace_shift(*code == 59, range, words);
            }
        }
    }

    /// G58 and G59: replace the absolute or the additive part of the programmable shift on the named axes
    /// (Fundamentals 11/2006, 6.3).
    fn replace_shift(&mut self, is_additive: bool, range: TextRange, words: &BlockWords) {
        let Some(mut shift) = shift_of(&self.modes.programmable) else {
            let what = "G58 and G59 in a rotated, scaled or mirrored frame are not followed";
            return self.not_followed(range, what);
        };
        let unit = self.unit_mm();
        for (axis, shift) in shift.iter_mut().enumerate() {
            let Some(word) = words.axes[axis] else { continue };
            let value = word.value * unit;
            let additive = &mut self.modes.additive_shift[axis];
            if is_additive {
                *shift += value - *additive;
                *additive = value;
            } else {
                *shift = value + *additive;
            }
        }
        let map = FrameMap::translation(linear([shift[0], shift[1], shift[2]], 0.0));
        self.modes.set_frames(map, self.modes.swivel);
    }

    /// The axis words of a block as lengths, mm; 0 where there is none.
    fn lengths(&self, words: &BlockWords) -> [f64; 3] {
        let unit = self.unit_mm();
        std::array::from_fn(|axis| words.axes[axis].map_or(0.0, |word| word.value * unit))
    }

    /// `ROT X Y Z`, or `ROT RPL=` about the normal of the plane.
    fn rotation(&self, words: &BlockWords) -> FrameMap {
        if let Some(angle) = words.other("RPL") {
            return FrameMap::rotation(self.kernel.state.plane, [0.0; 2], angle.value);
        }
        rotated(std::array::from_fn(|axis| words.axes[axis].map_or(0.0, |word| word.value)))
    }
}

/// Whether a block is one of frames, whose axis words do not move.
pub fn is_frame_block(words: &BlockWords) -> bool {
    const NAMES: [&str; 8] =
        ["TRANS", "ATRANS", "ROT", "AROT", "SCALE", "ASCALE", "MIRROR", "AMIRROR"];
    words.names.iter().any(|(name, _)| NAMES.contains(&name.as_str()))
        || words.g_codes.iter().any(|(code, _)| matches!(code, 58 | 59))
}

fn factors(words: &BlockWords) -> [f64; 3] {
    std::array::from_fn(|axis| {
        let factor = words.axes[axis].map_or(1.0, |word| word.value);
        if factor == 0.0 { 1.0 } else { factor }
    })
}

/// The value of a mirrored axis has no meaning (MD10612).
fn mirrors(words: &BlockWords) -> [f64; 3] {
    std::array::from_fn(|axis| if words.axes[axis].is_some() { -1.0 } else { 1.0 })
}
