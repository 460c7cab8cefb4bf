//! Turning tools: stations with their offsets, and the offsets that a program writes.

use chordal_command::CompensationSide;
use chordal_syntax::Block;

use super::Interpreter;

impl Interpreter<'_> {
    /// S in the block of a preset (G50 S) limits the spindle speed, rev/min.
    pub(super) fn take_speed_limit(&mut self, block: &Block) {
        let Some(number) = block.last(b'S').and_then(|word| self.literal(word)) else { return };
        if number.to_f64() >= 0.0 {
            self.kernel.limit_speed(number.to_f64());
        }
    }

    /// `T0101`: changes to station 1 with offset 1, which acts at once.
    pub(super) fn take_station(&mut self, block: &Block, digits: u32) {
        let Some(word) = block.last(b'T').copied() else { return };
        let Some(number) = self.count(&word) else { return };
        // With five or more digits, three belong to the offset (Fanuc parameter 5028 = 3).
        let digits = if number >= 10_000 { 3 } else { digits };
        let split = 10_u32.pow(digits);
        let (station, offset) = (number / split, number % split);
        let tool = if station > 0 { station } else { offset };
        if tool > 0 && tool != self.kernel.state.tool {
            self.kernel.state.selected_tool = Some(tool);
            self.kernel.tool_change(self.span(word.range));
        }
        let before = self.kernel.state.radius_offset;
        self.kernel.state.radius_offset = (offset > 0).then_some(offset);
        let length =
            chordal_kernel::LengthOffset { number: (offset > 0).then_some(offset), minus: false };
        if length != self.kernel.state.offsets.length() {
            self.kernel.set_length(&self.at(block), length);
        }
        if self.kernel.state.side != CompensationSide::Off
            && before != self.kernel.state.radius_offset
        {
            let span = self.span(word.range);
            self.kernel.emit_compensation(self.kernel.state.radius_offset, None, span);
        }
    }

    /// G10 P: writes geometry or wear of a turning tool; without `wear`, P above 10000 means geometry.
    pub(super) fn write_turning_tool(&mut self, block: &Block, wear: Option<bool>) {
        let Some(number) = self.count_of(block, b'P') else {
            let span = self.span(block.range);
            let message = "G10 needs P, the number of the offset".to_string();
            return self.kernel.missing_word(span, message, "P1 is wear 1, P10001 geometry 1");
        };
        let axes = self.control.axes();
        self.unused_axes(block, |axis, _| axes.has(axis));
        let words = self.axis_words(block);
        let mut added = [None; chordal_machine::AXES];
        for (letter, axis) in self.control.parameters.increments {
            let axis = usize::from(super::literals::AXIS_OF[usize::from(*axis)]);
            added[axis] =
                block.last(*letter).copied().and_then(|word| self.axis_value(&word, axis));
        }
        let radius = self.length_of(block, b'R');
        let tip = if block.letters().has(b'Q') { self.count_of(block, b'Q') } else { None };
        let geometry = wear.map_or(number > 10_000, |wear| !wear);
        if number == 0 {
            return self.kernel.write_work_values("EXT", &words, false);
        }
        let tool = if geometry && wear.is_none() { number - 10_000 } else { number };
        self.kernel.state.shift_coordinates(|offsets| {
            let tool = offsets.tool_mut(tool);
            let values = if geometry { &mut tool.offset } else { &mut tool.offset_wear };
            for axis in 0..values.len() {
                if let Some(value) = words[axis] {
                    values[axis] = Some(value);
                } else if let Some(by) = added[axis] {
                    values[axis] = Some(values[axis].unwrap_or(0.0) + by);
                }
            }
            if geometry {
                tool.nose_radius_mm = radius.or(tool.nose_radius_mm);
                tool.tip = tip.or(tool.tip);
            } else if let Some(radius) = radius {
                tool.diameter_wear_mm = Some(2.0 * radius);
            }
        });
        self.kernel.emit_tool_length();
    }
}
