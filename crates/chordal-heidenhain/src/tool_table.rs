//! Tool tables of the control (`TOOL.T`): a line with the names of the columns at fixed places, and a line for each tool.

use chordal_machine::{Machine, Tool, ToolShape};

use crate::table::ControlTableText;

/// Whether a text is a tool table.
pub fn is_tool_table(text: &[u8]) -> bool {
    let first = text.trim_ascii_start();
    first.get(..10).is_some_and(|start| start.eq_ignore_ascii_case(b"BEGIN TOOL"))
}

/// Takes the tools of a table over into a machine: what the control holds wins, what it does not say stays.
pub fn take_tool_table(text: &[u8], machine: &mut Machine) {
    let Some(table) = ControlTableText::read(text) else { return };
    for row in table.rows() {
        // A tool with an index (5.1) is another edge of the same tool.
        let Some(tool) = row.text("T").and_then(|text| text.parse::<u32>().ok()) else { continue };
        let is_empty = ["NAME", "L", "R"]
            .iter()
            .all(|name| row.text(name).is_none_or(|text| text.parse::<f64>() == Ok(0.0)));
        if tool == 0 || is_empty {
            continue;
        }
        let entry = machine.tools.entry(tool).or_default();
        let length = |name: &str| row.number(name).map(|value| value * table.unit_mm);
        take_row(entry, row.text("NAME"), &length, &|name| row.number(name));
        if entry.shape.is_none() {
            entry.shape = shape_of(entry, row.text("TYP").as_deref(), row.number("R2").is_some());
        }
    }
}

/// Tool types (TYP) with a shape that R, R2 and T-ANGLE do not describe: probes, turning tools, thread mills.
const OTHER_TYPES: [&str; 9] = ["TCHP", "TURN", "GF", "GSF", "EP", "WSP", "BGF", "ZBGF", "BCKBOR"];

/// The shape that the control's own simulation draws from R, R2, T-ANGLE and PITCH (TNC 640, tool table); `None` where
/// these do not describe it.
fn shape_of(tool: &Tool, kind: Option<&str>, has_corner_radius: bool) -> Option<ToolShape> {
    let is_kind = |other: &&str| kind.is_some_and(|kind| kind.eq_ignore_ascii_case(other));
    if OTHER_TYPES.iter().any(is_kind) {
        return None;
    }
    if tool.point_angle_rad.is_some() {
        return Some(ToolShape::Drill);
    }
    if tool.pitch_mm.is_some() {
        return Some(ToolShape::Tap);
    }
    let radius = tool.diameter_mm? / 2.0;
    match tool.corner_radius_mm {
        Some(corner) if corner >= radius => Some(ToolShape::Ball),
        Some(_) => Some(ToolShape::Bull),
        None => has_corner_radius.then_some(ToolShape::Flat),
    }
}

/// Takes a row over; `length` gives lengths in mm, `number` numbers as written.
fn take_row(
    tool: &mut Tool,
    name: Option<String>,
    length: &dyn Fn(&str) -> Option<f64>,
    number: &dyn Fn(&str) -> Option<f64>,
) {
    tool.description = name.or(tool.description.take());
    if let Some(mm) = length("L") {
        tool.offset[2] = Some(mm);
    }
    // A radius of 0 is that of a tool nobody has measured.
    if let Some(mm) = length("R").filter(|mm| *mm > 0.0) {
        tool.diameter_mm = Some(2.0 * mm);
    }
    if let Some(mm) = length("R2").filter(|mm| *mm > 0.0) {
        tool.corner_radius_mm = Some(mm);
    }
    if let Some(mm) = length("DL").filter(|mm| *mm != 0.0) {
        tool.offset_wear[2] = Some(mm);
    }
    if let Some(mm) = length("DR").filter(|mm| *mm != 0.0) {
        tool.diameter_wear_mm = Some(2.0 * mm);
    }
    if let Some(mm) = length("LCUTS").filter(|mm| *mm > 0.0) {
        tool.flute_length_mm = Some(mm);
    }
    if let Some(mm) = length("PITCH").filter(|mm| *mm > 0.0) {
        tool.pitch_mm = Some(mm);
    }
    if let Some(degrees) = number("T-ANGLE").filter(|degrees| (1.0..180.0).contains(degrees)) {
        tool.point_angle_rad = Some(degrees.to_radians());
    }
    let teeth = number("CUT").or(number("CUT."));
    if let Some(count) = teeth.filter(|count| (1.0..=100.0).contains(count)) {
        tool.teeth = Some(count as u32);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "BEGIN TOOL.T MM Version:1.0\r\n\
        T    NAME             L        R        R2       DL      DR      CUT. T-ANGLE\r\n\
        0                     +0       +0       +0       +0      +0      0    +0\r\n\
        5    END MILL 10      +100.5   +5       +0       +0.1    -0.05   4    +0\r\n\
        5.1  END MILL 10 UP   +90      +5\r\n\
        7    DRILL 8,5        +120     +4.25    +0       +0      +0      2    +118\r\n\
        [END]\r\n\
        9    NOT A TOOL       +1       +1\r\n";

    #[test]
    fn columns_are_those_of_the_header() {
        assert!(is_tool_table(TABLE.as_bytes()));
        let mut machine = Machine::from_builtin("heidenhain-mill").expect("a machine");
        take_tool_table(TABLE.as_bytes(), &mut machine);
        assert_eq!(machine.tools.keys().copied().collect::<Vec<u32>>(), [5, 7]);
        let mill = &machine.tools[&5];
        assert_eq!(mill.description.as_deref(), Some("END MILL 10"));
        assert_eq!((mill.offset[2], mill.diameter_mm), (Some(100.5), Some(10.0)));
        assert_eq!((mill.offset_wear[2], mill.diameter_wear_mm), (Some(0.1), Some(-0.1)));
        assert_eq!(mill.teeth, Some(4));
        let drill = &machine.tools[&7];
        assert_eq!(drill.point_angle_rad, Some(118_f64.to_radians()));
        assert_eq!(drill.radius_mm(), Some(4.25));
        assert_eq!((mill.shape, drill.shape), (Some(ToolShape::Flat), Some(ToolShape::Drill)));
    }

    #[test]
    fn shapes_are_those_of_the_radii_the_point_and_the_type() {
        let table = "BEGIN TOOL.T MM\n\
            T  NAME   L     R    R2    T-ANGLE PITCH TYP\n\
            1  BALL   +100  +3   +3    +0      +0    MILL\n\
            2  BULL   +100  +6   +1    +0      +0    MILL_R\n\
            3  SINK   +100  +6   +0    +90     +0    CSINK\n\
            4  M8     +100  +4   +0    +0      +1.25 TAP\n\
            5  THREAD +100  +4   +0    +0      +1.25 GF\n\
            6  PROBE  +100  +3   +3    +0      +0    TCHP\n\
            7  OLD    +100  +3\n[END]\n";
        let mut machine = Machine::from_builtin("heidenhain-mill").expect("a machine");
        machine.tools.entry(2).or_default().shape = Some(ToolShape::Form);
        take_tool_table(table.as_bytes(), &mut machine);
        let shapes: Vec<_> = machine.tools.values().map(|tool| tool.shape).collect();
        let expected = [
            Some(ToolShape::Ball),
            Some(ToolShape::Form),
            Some(ToolShape::Drill),
            Some(ToolShape::Tap),
            None,
            None,
            None,
        ];
        assert_eq!(shapes, expected);
    }

    #[test]
    fn any_text_is_taken_without_a_failure() {
        let mut machine = Machine::from_builtin("heidenhain-mill").expect("a machine");
        for text in ["", "BEGIN TOOL.T", "BEGIN TOOL.T MM\n\n\nT", "BEGIN TOOL.T\n T L\n\u{fc}\n5"]
        {
            take_tool_table(text.as_bytes(), &mut machine);
        }
        assert!(machine.tools.is_empty());
    }
}
