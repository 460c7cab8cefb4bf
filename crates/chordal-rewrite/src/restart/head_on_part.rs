//! Heads while coordinates are those of the part: in a tilted plane, and under tool centre point control.

use chordal::control::AxisMask;
use chordal::control::{Action, MotionCode, Position};
use chordal::geometry::Vec3;

use super::head::{HeadError, HeadWriter};
use crate::state::EXACT;

/// The way along the tool leads above the part where the tool stands no flatter than this above the XY plane: the sine of
/// 10 degrees.
const LEAST_RISE: f64 = 0.173_648_177_666_930_33;

impl HeadWriter<'_, '_> {
    /// The work offset, the rotary axes and the blocks of the tilted plane that is in force; none without a plane.
    pub(super) fn plane(&self) -> Result<Vec<String>, HeadError> {
        let plane = &self.before.part_frame.plane;
        if plane.is_empty() {
            return Ok(Vec::new());
        }
        // Of two ways to stand on a plane, a control takes the one that is near.
        let lines = self.state.work().into_iter().chain(self.rotary_line()?);
        Ok(lines.chain(plane.iter().cloned()).collect())
    }

    /// The work offset, the rotary axes, and the tilted plane that is in force.
    pub(super) fn stand(&self) -> Result<Vec<String>, HeadError> {
        if !self.before.part_frame.plane.is_empty() {
            return self.plane();
        }
        Ok(self.state.work().into_iter().chain(self.rotary_line()?).collect())
    }

    /// A rapid of the rotary axes that the program has turned, alone; none without one.
    pub(super) fn rotary_line(&self) -> Result<Option<String>, HeadError> {
        let words = self.rotary_words()?;
        if words.is_empty() {
            return Ok(None);
        }
        let rapid = self.needed(Action::Motion(MotionCode::Rapid), "a rapid")?;
        Ok(Some(self.state.line([rapid].into_iter().chain(words))))
    }

    /// Where the rotary axes stand that the program has turned.
    fn rotary_words(&self) -> Result<Vec<String>, HeadError> {
        let modal = &self.before.modal;
        if !modal.known.covers(self.rotary_axes()) {
            return Err(HeadError("where the rotary axes stand is not known".into()));
        }
        let axes = AxisMask::ROTARY.iter().map(|axis| axis as usize);
        let turned = axes.filter(|axis| modal.known.has(*axis) && self.names(*axis));
        turned.map(|axis| self.place(axis, modal.position[axis])).collect()
    }

    /// Whether a tilted plane is in force on a machine that turns the tool: its X and Y depend on the length of the tool.
    pub(super) fn turns_tool_to_plane(&self) -> bool {
        let frame = self.before.frame.part_frame.as_ref();
        let turns_tool = frame.is_some_and(|frame| frame.turns_tool());
        turns_tool && !self.before.part_frame.plane.is_empty()
    }

    /// The lines before a block under tool centre point control where no words give the place of the tip: the program goes
    /// to its own first one.
    pub(super) fn before_approach_of_tip(&self) -> Result<Vec<String>, HeadError> {
        let state = &self.state;
        let mut lines = self.modes();
        lines.extend(self.tool());
        lines.extend(state.work());
        lines.extend(self.rotary_line()?);
        let spindle = state.line(state.spindle());
        lines.extend(Some(spindle).filter(|words| !words.is_empty()));
        let vector = &self.before.part_frame.vector;
        lines.push(state.line(state.length_offset().into_iter().chain(vector.iter().cloned())));
        self.finish(lines)
    }

    /// The lines that turn the rotary axes away from the part, take the tip to where the program has been clear, and bring it
    /// to its place along the tool: what lies there in its way has been passed by the tool itself.
    pub(super) fn along_tool(&self) -> Result<Vec<String>, HeadError> {
        let state = &self.state;
        let clear = self.clear_place()?;
        let frame = &self.before.frame;
        let over = frame.on_axes(&clear);
        let mut lines = self.modes();
        lines.extend(self.tool());
        let mut words = vec![self.needed(Action::Motion(MotionCode::Rapid), "a rapid")?];
        words.extend(state.work());
        // Above the place: what a word takes is near enough.
        words.extend([0, 1].map(|axis| state.place(axis, over[axis]).0));
        words.extend(self.rotary_words()?);
        words.extend(state.spindle());
        lines.push(state.line(words));
        let vector = &self.before.part_frame.vector;
        let down = state.length_offset().into_iter();
        let down = down.chain([0, 1, 2].map(|axis| state.place(axis, clear[axis]).0));
        lines.push(state.line(down.chain(vector.iter().cloned())));
        lines.extend(self.before.words.coolant.iter().cloned());
        lines.push(self.to_place_along_tool(vector)?);
        lines.extend(state.ready_tool());
        lines.extend(self.ending()?);
        Ok(lines)
    }

    /// From the clear place to the place itself, by feed where the program has one.
    fn to_place_along_tool(&self, vector: &[String]) -> Result<String, HeadError> {
        let (state, modal) = (&self.state, &self.before.modal);
        let mut words = Vec::new();
        if state.feed().is_some() {
            words.push(self.needed(Action::Motion(MotionCode::Linear), "a straight cut")?);
        }
        for axis in 0..3 {
            words.push(self.place(axis, modal.position[axis])?);
        }
        words.extend(vector.iter().cloned());
        words.extend(state.feed());
        Ok(state.line(words))
    }

    /// The rotary axes on which the frame of the part depends; none without a frame.
    fn rotary_axes(&self) -> AxisMask {
        let frame = self.before.frame.part_frame.as_ref();
        let chain = frame.and_then(|frame| frame.chain.as_ref());
        chain.map_or(AxisMask::NONE, AxisMask::of_chain)
    }

    /// The place that lies along the tool at the height where the program has been clear.
    fn clear_place(&self) -> Result<Position, HeadError> {
        let refuse = |what: String| Err(HeadError(what));
        let (modal, frame) = (&self.before.modal, &self.before.frame);
        let direction = frame
            .part_frame
            .as_ref()
            .and_then(|part_frame| part_frame.tool_direction(&modal.position, &frame.offsets()));
        let Some(direction) = direction else {
            return refuse("the machine file does not give the rotary axes".into());
        };
        if direction.z < LEAST_RISE {
            let degrees = direction.z.clamp(-1.0, 1.0).asin().to_degrees();
            return refuse(format!(
                "the tool stands {degrees:.1} degrees above the XY plane: the way along it does not lead above the part"
            ));
        }
        let rise = (self.before.highest - modal.position[2]).max(0.0);
        let [x, y, z, ..] = modal.position;
        let retract = if rise < EXACT { Vec3::ZERO } else { direction * (rise / direction.z) };
        let mut clear = modal.position;
        clear[..3].copy_from_slice(&(Vec3::new(x, y, z) + retract).to_array());
        Ok(clear)
    }
}
