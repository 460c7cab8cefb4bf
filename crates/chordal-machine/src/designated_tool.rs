//! The dimensions that the designations of a tool give, and contradictions to its other keys.

use crate::designation::{HolderDesignation, InsertDesignation, InsertLetter, WrittenDesignation};
use crate::error::{ErrorSource, MachineError, ValueLocation};
use crate::machine::Machine;
use crate::tool::{Tool, ToolShape};
use crate::turning::{TurningTool, mirrored_tip};

/// The largest difference between a nose radius in inches and the same one in tenths of a millimetre, mm.
const NOSE_TOLERANCE_MM: f64 = 0.02;
/// Entering angles that differ by less are equal, degrees: manufacturers round them, for example 62.5° to 63°.
const ANGLE_TOLERANCE_DEG: f64 = 1.0;
/// Edge lengths that differ by less are equal, mm: designations have whole millimetres.
const EDGE_TOLERANCE_MM: f64 = 1.0;

impl TurningTool {
    /// The shape of the insert, from its letter or its designation, else from that of the holder.
    fn insert_letter(&self) -> Option<InsertLetter> {
        let of_insert = self.insert_designation.as_ref().map(|written| written.value.letter);
        let of_holder = self.holder_designation.as_ref().map(|written| written.value.letter);
        self.insert.or(of_insert).or(of_holder)
    }
}

impl Tool {
    /// Fills the dimensions of the tool that its designations give and its other keys do not. `mirrored`: the control
    /// counts tip numbers with X in the opposite direction.
    pub fn take_designations(&mut self, mirrored: bool) {
        let insert = self.turning.insert_designation.as_ref().map(|written| written.value);
        let holder = self.turning.holder_designation.as_ref().map(|written| written.value);
        if insert.is_none() && holder.is_none() {
            return;
        }
        self.shape = self.shape.or(Some(ToolShape::Insert));
        self.turning.insert = self.turning.insert_letter();
        let edge_mm = insert.map_or(holder.and_then(|holder| holder.edge_mm), |one| one.edge_mm);
        self.flute_length_mm = self.flute_length_mm.or(edge_mm);
        self.nose_radius_mm = self.nose_radius_mm.or(insert.map(|insert| insert.nose_mm));
        let Some(holder) = holder else { return };
        let approach = holder.approach_degrees().map(f64::to_radians);
        self.turning.approach_angle_rad = self.turning.approach_angle_rad.or(approach);
        if let (None, Some(tip)) = (self.tip, holder.usual_tip()) {
            self.tip = Some(if mirrored { mirrored_tip(tip) } else { tip });
            self.turning.has_usual_tip = true;
        }
    }
}

impl Machine {
    /// Fills the dimensions of every tool that its designations give. `mirrored`: the control counts tip numbers with X
    /// in the opposite direction.
    pub fn take_designations(&mut self, mirrored: bool) {
        self.tools.values_mut().for_each(|tool| tool.take_designations(mirrored));
    }
}

/// The contradictions between the designations of the tools of a machine and their other keys, or each other.
pub(crate) fn contradictions(machine: &Machine) -> Vec<MachineError> {
    machine.tools.iter().flat_map(|(number, tool)| of_tool(*number, tool)).collect()
}

fn of_tool(number: u32, tool: &Tool) -> Vec<MachineError> {
    let mut errors = Vec::new();
    let turning = &tool.turning;
    let insert = turning.insert_designation.as_ref();
    let holder = turning.holder_designation.as_ref();
    if let Some(insert) = insert {
        for (message, help) in with_insert(number, tool, insert) {
            errors.push(error(insert.location.as_ref(), message, help));
        }
    }
    if let Some(holder) = holder {
        for (message, help) in with_holder(number, tool, holder) {
            errors.push(error(holder.location.as_ref(), message, help));
        }
    }
    errors
}

/// The message and the help text of an error.
type ProblemAndHelp = (String, String);

fn with_insert(
    number: u32,
    tool: &Tool,
    insert: &WrittenDesignation<InsertDesignation>,
) -> Vec<ProblemAndHelp> {
    let InsertDesignation { letter, edge_mm, nose_mm, .. } = insert.value;
    let name = format!("the insert {}", insert.text);
    let mut wrong = Vec::new();
    let mut differs = |says: String, key: &str, provided: String| {
        wrong.push((
            format!("{name} has {says}, and `tools.{number}.{key}` says {provided}"),
            format!("correct one of the two, or leave `{key}` out"),
        ));
    };
    if let Some(provided) =
        tool.nose_radius_mm.filter(|provided| (provided - nose_mm).abs() > NOSE_TOLERANCE_MM)
    {
        differs(format!("a nose radius of {}", mm(nose_mm)), "nose_radius", mm(provided));
    }
    if let (Some(provided), Some(corner)) = (tool.turning.insert_angle_rad, letter.corner_degrees())
        && (provided.to_degrees() - corner).abs() > ANGLE_TOLERANCE_DEG
    {
        differs(format!("a corner of {corner}°"), "insert_angle", degrees(provided));
    }
    if let (Some(provided), Some(edge)) = (tool.flute_length_mm, edge_mm)
        && provided > edge + EDGE_TOLERANCE_MM
    {
        differs(format!("edges of {}", mm(edge)), "flute_length", mm(provided));
    }
    if let Some(shape) = tool.shape.filter(|shape| *shape != ToolShape::Insert) {
        differs("the shape `insert`".to_string(), "shape", format!("`{}`", shape.as_str()));
    }
    wrong
}

fn with_holder(
    number: u32,
    tool: &Tool,
    holder: &WrittenDesignation<HolderDesignation>,
) -> Vec<ProblemAndHelp> {
    let value = holder.value;
    let name = format!("the holder {}", holder.text);
    let mut wrong = Vec::new();
    if let (Some(provided), Some(approach)) =
        (tool.turning.approach_angle_rad, value.approach_degrees())
        && (provided.to_degrees() - approach).abs() > ANGLE_TOLERANCE_DEG
    {
        wrong.push((
            format!(
                "{name} holds the main edge at {approach}° to Z, and `tools.{number}.approach_angle` says {}",
                degrees(provided)
            ),
            "correct one of the two, or leave `approach_angle` out".to_string(),
        ));
    }
    let takes = |what: String, is: String| {
        (
            format!("{name} takes inserts with {what}, and {is}"),
            "correct one of the two".to_string(),
        )
    };
    let other_letter = tool.turning.insert.filter(|letter| *letter != value.letter);
    if let Some(letter) = other_letter {
        let is = format!("`tools.{number}.insert` is `{}`", letter.as_str());
        wrong.push(takes(format!("the letter {}", value.letter.as_str()), is));
    }
    if let Some(insert) = &tool.turning.insert_designation {
        wrong.extend(of_pair(&value, insert).map(|(what, is)| takes(what, is)));
    }
    wrong
}

/// The mismatch between holder and insert: what the holder takes, and what the insert is; `None` if they fit.
fn of_pair(
    holder: &HolderDesignation,
    insert: &WrittenDesignation<InsertDesignation>,
) -> Option<(String, String)> {
    let InsertDesignation { letter, clearance, edge_mm, .. } = insert.value;
    let is = format!("the insert is {}", insert.text);
    if letter != holder.letter || clearance != holder.clearance {
        let letters = format!("the letters {}{}", holder.letter.as_str(), holder.clearance);
        return Some((letters, is));
    }
    let (edge, own) = (holder.edge_mm?, edge_mm?);
    let differs = (edge - own).abs() > EDGE_TOLERANCE_MM;
    differs
        .then(|| (format!("edges of {}", mm(edge)), format!("{is}, whose edges are {}", mm(own))))
}

fn error(location: Option<&ValueLocation>, message: String, help: String) -> MachineError {
    match location {
        Some(at) => MachineError {
            message,
            help: Some(help),
            file: at.file.to_string(),
            span: Some(at.span.clone()),
            text: at.text.clone(),
        },
        None => ErrorSource::new("machine", "").error(None, message, Some(help)),
    }
}

/// A length as text.
fn mm(length: f64) -> String {
    format!("{} mm", rounded(length, 1000.0))
}

fn degrees(angle: f64) -> String {
    format!("{}°", rounded(angle.to_degrees(), 10.0))
}

fn rounded(value: f64, per_unit: f64) -> f64 {
    (value * per_unit).round() / per_unit
}
