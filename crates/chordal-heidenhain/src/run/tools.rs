//! TOOL CALL and TOOL DEF.

use chordal_command::telling_number;
use chordal_diagnostics::{Code, TextRange};
use chordal_geometry::Plane;
use chordal_kernel::LengthOffset;
use chordal_machine::Tool;

use super::block_values::KlartextView;
use super::interpreter::KlartextInterpreter;
use crate::syntax::{FeedValue, ToolCallWords, ToolName, WordOperand};

/// The planes by their normal: X, Y, Z.
const PLANES: [Plane; 3] = [Plane::Yz, Plane::Zx, Plane::Xy];

impl KlartextInterpreter<'_> {
    /// TOOL DEF with L and R: the tool's data stand in the program. Without them it only makes the tool ready.
    pub(super) fn define_tool(
        &mut self,
        number: WordOperand,
        length: Option<WordOperand>,
        radius: Option<WordOperand>,
    ) {
        let range = self.here;
        let Some(number) = self.operand(number, range) else { return };
        let number = number.round().max(0.0) as u32;
        if length.is_none() && radius.is_none() {
            return self.kernel.select_tool(number);
        }
        let unit = self.unit_mm();
        let length = length.and_then(|value| self.operand(value, range)).unwrap_or(0.0) * unit;
        let radius = radius.and_then(|value| self.operand(value, range)).unwrap_or(0.0) * unit;
        let mut tool = self.tools.get(&number).cloned().unwrap_or_default();
        tool.offset[2] = Some(length);
        tool.offset_wear = Default::default();
        tool.diameter_mm = Some(2.0 * radius);
        tool.diameter_wear_mm = None;
        self.tools.insert(number, tool);
    }

    /// TOOL CALL.
    pub(super) fn tool_call(&mut self, words: &ToolCallWords) {
        let range = self.here;
        if let Some(axis) = words.axis {
            let span = self.span(range);
            self.kernel.set_plane(span, PLANES[axis]);
        }
        if let Some((name, range)) = &words.tool {
            self.change_tool(name, *range, words);
        }
        if let Some(speed) = words.speed
            && let Some(rpm) = self.operand(speed, range)
        {
            if rpm < 0.0 {
                let message = format!("the speed is {}", telling_number(rpm, 0));
                return self.bad_value(range, message, "a speed is not negative");
            }
            self.kernel.set_speed(rpm);
        }
        if let Some(feed) = words.feed {
            if let FeedValue::Value(value) = feed.value {
                self.modes.tool_feed = self.operand(value, feed.range);
            }
            self.apply_feed(Some(feed));
        }
        self.set_tool_parameters();
    }

    fn change_tool(&mut self, name: &ToolName, range: TextRange, words: &ToolCallWords) {
        if !self.modes.has_tool && words.axis.is_none() {
            let message = "the first TOOL CALL has no tool axis: Z is assumed";
            self.problem(Code::MissingWord, range, message);
        }
        if self.follows_tip() {
            let message = "a tool is called while M128 is active, whose tip the control holds";
            self.problem(Code::TiltedPlane, range, message);
        }
        self.modes.has_tool = true;
        let Some(number) = self.tool_number(name, range) else {
            self.kernel.select_unknown_tool();
            let span = self.span(range);
            self.kernel.tool_change(span);
            self.kernel.state.radius_offset = None;
            return;
        };
        self.kernel.select_tool(number);
        let span = self.span(range);
        // The tool that is in the spindle is not changed, and the spindle goes on.
        let spindle = (self.kernel.state.tool == number).then_some(self.kernel.state.spindle);
        self.kernel.tool_change(span);
        self.kernel.state.spindle = spindle.unwrap_or(self.kernel.state.spindle);
        let allowances = words.allowances.map(|value| {
            value.and_then(|value| self.operand(value, range)).unwrap_or(0.0) * self.unit_mm()
        });
        self.put_tool(number, allowances);
    }

    /// Makes the length and the radius of a tool active, with the allowances DL, DR and DR2 of TOOL CALL, mm.
    fn put_tool(&mut self, number: u32, [length, radius, corner]: [f64; 3]) {
        let view = KlartextView { span: self.span(self.here), words: None };
        let axis = self.tool_axis();
        self.kernel.state.offsets.set_tool_axis(axis);
        if number == 0 {
            self.kernel.set_length(&view, LengthOffset { number: None, minus: false });
            self.kernel.state.radius_offset = None;
            return;
        }
        let base: Option<Tool> = self.tools.get(&number).cloned();
        if let Some(mut tool) = base {
            if length != 0.0 {
                tool.offset_wear[2] = Some(tool.offset_wear[2].unwrap_or(0.0) + length);
            }
            if radius != 0.0 {
                let wear = tool.diameter_wear_mm.unwrap_or(0.0) + 2.0 * radius;
                tool.diameter_wear_mm = Some(wear);
            }
            if corner != 0.0 {
                tool.corner_radius_mm = tool.corner_radius_mm.map(|own| own + corner);
            }
            // The length lies along the axis of the tool.
            if axis != 2 {
                let has_length = tool.offset[2].is_some();
                tool.offset.swap(axis, 2);
                tool.offset_wear.swap(axis, 2);
                // Without a length none is known along Z either, so that the tip is not known.
                tool.offset[2] = tool.offset[2].or(has_length.then_some(0.0));
            }
            *self.kernel.state.offsets.tool_mut(number) = tool;
        }
        let offset = LengthOffset { number: Some(number), minus: false };
        self.kernel.set_length(&view, offset);
        self.kernel.state.radius_offset = Some(number);
    }

    /// The number of a tool; `None` for a name that no tool has.
    fn tool_number(&mut self, name: &ToolName, range: TextRange) -> Option<u32> {
        let name = match name {
            ToolName::Number(value) => {
                let number = self.operand(*value, range)?;
                return Some(number.max(0.0) as u32);
            }
            ToolName::Text(text) => text.clone(),
            ToolName::Parameter(number) => self.parameters.text(*number)?.to_string(),
        };
        let mut named: Vec<u32> = self
            .tools
            .iter()
            .filter(|(_, tool)| tool.description.as_deref() == Some(name.as_str()))
            .map(|(number, _)| *number)
            .collect();
        named.sort_unstable();
        if named.is_empty() && self.is_first_report(&format!("tool {name}")) {
            let message =
                format!("the machine file has no tool {name}: its length and radius are not known");
            self.problem(Code::OffsetNotSet, range, message);
        }
        named.first().copied()
    }

    /// What the control keeps about the tool in Q parameters.
    fn set_tool_parameters(&mut self) {
        let tool = self.kernel.state.tool;
        let unit = self.unit_mm();
        let radius = self.kernel.state.offsets.radius_mm(tool).map(|radius| radius / unit);
        self.parameters.set_shared_if_known(108, radius);
        let length = self.kernel.state.offsets.length_mm(tool).map(|length| length / unit);
        self.parameters.set_shared_if_known(114, length);
        self.parameters.set_shared(109, self.tool_axis() as f64);
    }
}
