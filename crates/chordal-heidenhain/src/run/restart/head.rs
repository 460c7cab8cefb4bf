//! The blocks that bring a control into the state before a line.

use chordal_command::SpindleState;
use chordal_geometry::Plane;
use chordal_kernel::significant_number;

use super::definitions::{Definition, DefinitionSlot};
use super::places::{ANGLE_DIGITS, HeadFault, LENGTH_DIGITS, PlaceWriter};
use super::values::exact_number;
use super::watch::StateAtBlock;
use crate::run::transformations::Transformation;

/// Digits after the point of feeds and speeds.
const FEED_DIGITS: usize = 9;

/// The axes of transformations.
const AXES_OF_CYCLES: [&str; 3] = ["X", "Y", "Z"];

/// Writes the head of one program.
pub(super) struct KlartextHeadWriter<'h> {
    pub state: &'h StateAtBlock,
    /// The parameters that the rest reads, as blocks.
    pub parameters: Vec<String>,
    /// Q parameters that are free for places.
    pub free_parameters: Vec<u32>,
    /// The block that the program begins at calls a tool.
    pub calls_tool: bool,
}

impl KlartextHeadWriter<'_> {
    /// All blocks.
    pub fn lines(&self) -> Result<Vec<String>, HeadFault> {
        let mut lines = Vec::new();
        for (slot, definition) in &self.state.noted.definitions {
            if matches!(slot, DefinitionSlot::Blank | DefinitionSlot::Tool(_)) {
                lines.extend(self.definition(*slot, definition)?);
            }
        }
        lines.extend(self.preset()?);
        lines.extend(self.tool()?);
        lines.extend(self.transformations()?);
        for (slot, definition) in &self.state.noted.definitions {
            let is_stated = matches!(
                slot,
                DefinitionSlot::Blank | DefinitionSlot::Tool(_) | DefinitionSlot::Preset
            );
            if !is_stated {
                lines.extend(self.definition(*slot, definition)?);
            }
        }
        lines.extend(self.functions());
        let mut places = PlaceWriter::new(self.free_parameters.clone());
        let approach = if self.calls_tool { Vec::new() } else { self.approach(&mut places)? };
        let poles = self.poles(&mut places);
        lines.append(&mut places.lines);
        lines.extend(approach);
        lines.extend(poles);
        if self.state.modes.calls_each_block {
            lines.push("M89".into());
        }
        lines.extend(self.parameters.iter().cloned());
        Ok(lines)
    }

    fn definition(
        &self,
        slot: DefinitionSlot,
        definition: &Definition,
    ) -> Result<Vec<String>, HeadFault> {
        let texts: Option<Vec<String>> = definition.texts.iter().cloned().collect();
        texts.ok_or_else(|| {
            let line = definition.line;
            HeadFault(format!("a value of the definition in line {line} is not known ({slot:?})"))
        })
    }

    fn preset(&self) -> Result<Vec<String>, HeadFault> {
        let definition = self.state.noted.definitions.get(&DefinitionSlot::Preset);
        definition.map_or(Ok(Vec::new()), |own| self.definition(DefinitionSlot::Preset, own))
    }

    /// A length in program units.
    pub(super) fn length(&self, mm: f64) -> Option<String> {
        let (unit, digits) = match self.state.modes.is_inch {
            true => (25.4, LENGTH_DIGITS[1]),
            false => (1.0, LENGTH_DIGITS[0]),
        };
        exact_number(mm / unit, digits)
    }

    /// TOOL CALL, and the tool that is made ready after it.
    fn tool(&self) -> Result<Vec<String>, HeadFault> {
        let StateAtBlock { modal, modes, noted, .. } = self.state;
        let ready = modal.selected_tool.filter(|ready| *ready != modal.tool);
        let mut lines = Vec::new();
        if !self.calls_tool && modes.has_tool {
            let Some(tool) = &noted.tool else {
                return Err(HeadFault("the tool in the spindle has no known name".into()));
            };
            let axis = AXES_OF_CYCLES[modal.plane.axes().2];
            let mut words = vec![format!("TOOL CALL {} {axis}", tool.name)];
            if modal.rpm != 0.0 {
                words.push(format!("S{}", significant_number(modal.rpm, FEED_DIGITS)));
            }
            if let Some(feed) = modes.tool_feed {
                words.push(format!("F{}", significant_number(feed, FEED_DIGITS)));
            }
            for (name, value) in ["DL", "DR", "DR2"].iter().zip(tool.allowances) {
                if value != 0.0 {
                    let number = exact_number(value, LENGTH_DIGITS[1]);
                    let number = number.ok_or_else(|| {
                        HeadFault(format!(
                            "{name} of the tool has more decimals than a block takes"
                        ))
                    })?;
                    words.push(format!("{name}{number}"));
                }
            }
            lines.push(words.join(" "));
        }
        lines.extend(ready.map(|number| format!("TOOL DEF {number}")));
        Ok(lines)
    }

    /// The cycles of the transformations in force, in the order in which they act.
    fn transformations(&self) -> Result<Vec<String>, HeadFault> {
        let mut lines = Vec::new();
        for one in self.state.modes.chain.list() {
            lines.extend(self.transformation(one)?);
        }
        Ok(lines)
    }

    fn transformation(&self, one: &Transformation) -> Result<Vec<String>, HeadFault> {
        let digits =
            |what: &str| HeadFault(format!("the {what} has more decimals than a block takes"));
        let numbered = |number: u32, title: &str, data: Vec<String>| {
            let lines = data.into_iter().enumerate();
            let lines = lines.map(|(at, words)| format!("CYCL DEF {number}.{} {words}", at + 1));
            [format!("CYCL DEF {number}.0 {title}")].into_iter().chain(lines).collect()
        };
        match one {
            Transformation::Shift(by) => {
                let mut data = Vec::new();
                for (axis, mm) in AXES_OF_CYCLES.iter().zip(by) {
                    let number = self.length(*mm).ok_or_else(|| digits("datum shift"))?;
                    data.push(format!("{axis}{number}"));
                }
                Ok(numbered(7, "DATUM SHIFT", data))
            }
            Transformation::Mirror(axes) => {
                let named = AXES_OF_CYCLES.iter().zip(axes).filter(|(_, mirrored)| **mirrored);
                let named: Vec<&str> = named.map(|(axis, _)| *axis).collect();
                Ok(numbered(8, "MIRROR IMAGE", vec![named.join(" ")]))
            }
            Transformation::Rotation(plane, degrees) => {
                if *plane != self.tool_plane() {
                    return Err(HeadFault(
                        "a rotation is in force in another plane than that of the tool".into(),
                    ));
                }
                let number =
                    exact_number(*degrees, ANGLE_DIGITS).ok_or_else(|| digits("rotation"))?;
                Ok(numbered(10, "ROTATION", vec![format!("ROT{number}")]))
            }
            Transformation::Scale(factor) => {
                let number = exact_number(*factor, ANGLE_DIGITS).ok_or_else(|| digits("scale"))?;
                Ok(numbered(11, "SCALING", vec![format!("SCL{}", number.trim_start_matches('+'))]))
            }
            Transformation::AxisScale(factors, center) => {
                let mut words = Vec::new();
                for (axis, factor) in AXES_OF_CYCLES.iter().zip(factors) {
                    let number = exact_number(*factor, ANGLE_DIGITS);
                    let number = number.ok_or_else(|| digits("scale of an axis"))?;
                    words.push(format!("{axis}{}", number.trim_start_matches('+')));
                }
                for (axis, mm) in AXES_OF_CYCLES.iter().zip(center) {
                    let number = self.length(*mm).ok_or_else(|| digits("centre of a scale"))?;
                    words.push(format!("CC{axis}{number}"));
                }
                Ok(numbered(26, "AXIS-SPECIFIC SCALING", vec![words.join(" ")]))
            }
        }
    }

    pub(super) fn tool_plane(&self) -> Plane {
        self.state.modal.plane
    }

    /// The M functions that stay in force, but for the spindle and the coolant.
    fn functions(&self) -> Vec<String> {
        let mut words: Vec<String> = self.state.noted.functions.lasting.values().cloned().collect();
        if self.state.modes.per_revolution {
            words.push("M136".into());
        }
        words
    }

    /// The spindle and the coolant.
    pub(super) fn running(&self) -> [Option<&'static str>; 3] {
        let modal = &self.state.modal;
        let spindle = match modal.spindle {
            SpindleState::Off => None,
            SpindleState::Cw => Some("M3"),
            SpindleState::Ccw => Some("M4"),
            SpindleState::Oriented => Some("M19"),
        };
        [spindle, modal.coolant.flood.then_some("M8"), modal.coolant.mist.then_some("M7")]
    }

    /// F of the blocks before.
    pub(super) fn feed(&self) -> Option<String> {
        use chordal_command::FeedMode;
        let StateAtBlock { modal, modes, .. } = self.state;
        let feed = modal.feed?;
        let per_minute = if modes.is_inch { 60.0 / 2.54 } else { 60.0 };
        let per_turn = if modes.is_inch { 1.0 / 25.4 } else { 1.0 };
        let (word, value) = match modal.feed_mode {
            FeedMode::PerRevolution if modes.per_revolution => ("F", feed * per_turn),
            FeedMode::PerRevolution => ("FU", feed * per_turn),
            FeedMode::PerTime | FeedMode::InverseTime => ("F", feed * per_minute),
        };
        Some(format!("{word}{}", significant_number(value, FEED_DIGITS)))
    }
}
