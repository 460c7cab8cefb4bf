//! The blocks that bring a control into the state before a line.

use chordal_command::SpindleState;
use chordal_geometry::Plane;
use chordal_kernel::significant_number;

use super::definitions::{Definition, DefinitionSlot};
use super::values::exact_number;
use super::watch::StateAtBlock;
use crate::run::transformations::Transformation;

/// What stands in the way of a head.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct HeadFault(pub String);

/// Digits after the point of lengths that a control keeps, in mm and in inches.
const LENGTH_DIGITS: [usize; 2] = [5, 6];

/// Digits after the point of angles and factors.
const ANGLE_DIGITS: usize = 6;

/// Digits after the point of feeds and speeds.
const FEED_DIGITS: usize = 9;

/// The axes of transformations.
const AXES_OF_CYCLES: [&str; 3] = ["X", "Y", "Z"];

/// Writes the head of one program.
pub(super) struct KlartextHeadWriter<'h> {
    pub state: &'h StateAtBlock,
    /// The parameters that the rest reads, as blocks.
    pub parameters: Vec<String>,
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
        lines.extend(if self.calls_tool { Vec::new() } else { self.approach()? });
        lines.extend(self.poles());
        if self.state.modes.calls_each_block {
            lines.push("M89".into());
        }
        lines.extend(self.parameters.iter().cloned());
        Ok(lines)
    }

    /// The head does not go to the place of the tool.
    pub fn approaches(&self) -> bool {
        self.calls_tool || !(0..6).any(|axis| self.takes_part(axis))
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
    fn length(&self, mm: f64) -> Option<String> {
        let (unit, digits) = match self.state.modes.is_inch {
            true => (25.4, LENGTH_DIGITS[1]),
            false => (1.0, LENGTH_DIGITS[0]),
        };
        exact_number(mm / unit, digits)
    }

    /// A coordinate; its digits must be all that the control keeps.
    fn place(&self, axis: usize, value: f64) -> Result<String, HeadFault> {
        let letter = crate::syntax::AXIS_WORDS[axis];
        let text = match axis {
            3.. => exact_number(value.to_degrees(), ANGLE_DIGITS),
            _ => self.length(value),
        };
        text.map(|text| format!("{letter}{text}")).ok_or_else(|| {
            HeadFault(format!("the position in {letter} has more decimals than a block takes"))
        })
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
                        HeadFault(format!("{name} of the tool has more decimals than a block takes"))
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
        let digits = |what: &str| {
            HeadFault(format!("the {what} has more decimals than a block takes"))
        };
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
                    return Err(HeadFault("a rotation is in force in another plane than that of the tool".into()));
                }
                let number = exact_number(*degrees, ANGLE_DIGITS).ok_or_else(|| digits("rotation"))?;
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

    fn tool_plane(&self) -> Plane {
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
    fn running(&self) -> [Option<&'static str>; 3] {
        let modal = &self.state.modal;
        let spindle = match modal.spindle {
            SpindleState::Off => None,
            SpindleState::Cw => Some("M3"),
            SpindleState::Ccw => Some("M4"),
            SpindleState::Oriented => Some("M19"),
        };
        [spindle, modal.coolant.flood.then_some("M8"), modal.coolant.mist.then_some("M7")]
    }

    /// Whether the head brings an axis to its place: the program has moved it.
    fn takes_part(&self, axis: usize) -> bool {
        let modal = &self.state.modal;
        let (a, b, _) = self.tool_plane().axes();
        let moved = |axis: usize| modal.known.has(axis) && !modal.unmoved.has(axis);
        // In a turned plane both axes move together.
        let is_plain = self.state.modes.chain.list().is_empty();
        moved(axis) || !is_plain && [a, b].contains(&axis) && (moved(a) || moved(b))
    }

    /// The tool axis to where the program has been clear, the other axes over the place, then down by feed.
    fn approach(&self) -> Result<Vec<String>, HeadFault> {
        let StateAtBlock { modal, modes, noted, .. } = self.state;
        let (a, b, normal) = self.tool_plane().axes();
        let lost = (0..6).find(|axis| !modal.known.has(*axis) && !modal.unmoved.has(*axis) && modal.machine_known.has(*axis));
        if let Some(axis) = lost {
            let letter = crate::syntax::AXIS_WORDS[axis];
            return Err(HeadFault(format!("the position in {letter} is not known")));
        }
        let place = modes.frame.programmed(&modal.position);
        let mut above = modal.position;
        above[normal] = noted.highest.max(modal.position[normal]);
        let above = modes.frame.programmed(&above)[normal];
        let goes_down = (above - place[normal]).abs() > 1e-6;
        let mut lines = Vec::new();
        let [spindle, flood, mist] = self.running();
        if self.takes_part(normal) {
            lines.push(match noted.to_machine[normal] {
                Some(_) => self.machine_line(&[normal])?,
                None if goes_down => format!("L {} R0 FMAX", self.height(normal, above)),
                None => format!("L {} R0 FMAX", self.place(normal, place[normal])?),
            });
        }
        let others = |linear: bool, by_machine: bool| -> Vec<usize> {
            let axes: &[usize] = if linear { &[a, b] } else { &[3, 4, 5] };
            let is_own = |axis: &&usize| {
                self.takes_part(**axis) && noted.to_machine[**axis].is_some() == by_machine
            };
            axes.iter().filter(is_own).copied().collect()
        };
        for linear in [false, true] {
            let by_machine = others(linear, true);
            if !by_machine.is_empty() {
                lines.push(self.machine_line(&by_machine)?);
            }
            let plain = others(linear, false);
            if !plain.is_empty() {
                let words: Result<Vec<String>, HeadFault> =
                    plain.iter().map(|axis| self.place(*axis, place[*axis])).collect();
                lines.push(format!("L {} R0 FMAX", words?.join(" ")));
            }
        }
        add_word(&mut lines, 0, spindle);
        let last = lines.len().saturating_sub(1);
        add_word(&mut lines, last, flood);
        add_word(&mut lines, last, mist);
        let feed = self.feed();
        if self.takes_part(normal) && noted.to_machine[normal].is_none() && goes_down {
            let word = self.place(normal, place[normal])?;
            lines.push(format!("L {word} R0 {}", feed.as_deref().unwrap_or("FMAX")));
        } else if let Some(feed) = feed {
            lines.push(format!("L R0 {feed}"));
        }
        Ok(lines)
    }

    /// A height above the place; what the block takes is near enough.
    fn height(&self, axis: usize, mm: f64) -> String {
        let unit = if self.state.modes.is_inch { 25.4 } else { 1.0 };
        let text = chordal_kernel::plain_number(mm / unit, LENGTH_DIGITS[0]);
        let sign = if text.starts_with('-') { "" } else { "+" };
        format!("{}{sign}{text}", crate::syntax::AXIS_WORDS[axis])
    }

    /// A rapid to places of the machine.
    fn machine_line(&self, axes: &[usize]) -> Result<String, HeadFault> {
        let StateAtBlock { modal, noted, .. } = self.state;
        let words: Result<Vec<String>, HeadFault> =
            axes.iter().map(|axis| self.place(*axis, modal.machine_position[*axis])).collect();
        let function = axes.iter().find_map(|axis| noted.to_machine[*axis]).unwrap_or(91);
        Ok(format!("L {} R0 FMAX M{function}", words?.join(" ")))
    }

    /// F of the blocks before.
    fn feed(&self) -> Option<String> {
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

    /// CC and FPOL. One whose digits no block takes is left out: the proof fails where the rest needs it.
    fn poles(&self) -> Vec<String> {
        let contour = &self.state.modes.contour;
        let (a, b, _) = contour.center_plane.unwrap_or(self.tool_plane()).axes();
        let words = |values: [(usize, Option<f64>); 2]| {
            let named = values.iter().filter_map(|(axis, value)| Some((*axis, (*value)?)));
            let words: Option<Vec<String>> =
                named.map(|(axis, value)| self.place(axis, value).ok()).collect();
            words.filter(|words| !words.is_empty()).map(|words| words.join(" "))
        };
        let center = words([(a, contour.center[a]), (b, contour.center[b])]);
        let (a, b, _) = self.tool_plane().axes();
        let pole = self.state.modes.free_pole;
        let pole = pole.and_then(|[first, second]| words([(a, Some(first)), (b, Some(second))]));
        let center = center.map(|words| format!("CC {words}"));
        center.into_iter().chain(pole.map(|words| format!("FPOL {words}"))).collect()
    }
}

/// Adds a word to a line, or as a line of its own where there is none.
fn add_word(lines: &mut Vec<String>, at: usize, word: Option<&str>) {
    let Some(word) = word else { return };
    match lines.get_mut(at) {
        Some(line) => *line += &format!(" {word}"),
        None => lines.push(word.to_string()),
    }
}
