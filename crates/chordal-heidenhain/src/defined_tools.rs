//! TOOL DEF: the tools that a program defines.

use std::collections::BTreeMap;

use chordal_kernel::DefinedTool;
use chordal_machine::{Tool, ToolShape};

use crate::syntax::{
    KlartextStatement, LineReader, WordOperand, block_of_lines, contains_ignoring_case,
};

const INCH_MM: f64 = 25.4;

/// The tools of TOOL DEF with a radius, in the order of their numbers. The block says nothing about their shape: a cylinder
/// of the radius is assumed, whose edges are as long as L. Tools with parameters, or with two different radii, are left
/// out.
pub fn defined_tools(text: &[u8]) -> Vec<DefinedTool> {
    let mut found: BTreeMap<u32, Option<DefinedTool>> = BTreeMap::new();
    let mut unit = 1.0;
    for lines in LineReader::new(text) {
        if !may_define(lines.range.slice(text)) {
            continue;
        }
        let block = block_of_lines(text, &lines);
        match block.statement {
            KlartextStatement::Begin { is_inch, .. } => unit = if is_inch { INCH_MM } else { 1.0 },
            KlartextStatement::ToolDefinition { number, length, radius } => {
                let Some(number) = literal(Some(number)) else { continue };
                let number = number.round().max(0.0) as u32;
                let own = tool_of(literal(length), literal(radius), unit);
                let tool = own.map(|tool| DefinedTool { number, tool, range: block.range });
                add(&mut found, number, tool, length.is_some() || radius.is_some());
            }
            _ => {}
        }
    }
    found.into_values().flatten().collect()
}

/// Whether a block may be TOOL DEF or the head of a program: most are none of these, and need not be read.
fn may_define(block: &[u8]) -> bool {
    match block.iter().find(|byte| !(byte.is_ascii_digit() || b" \t/".contains(byte))) {
        Some(b'T' | b't' | b'B' | b'b' | b'%') => true,
        Some(b'N' | b'n' | b'G' | b'g') => contains_ignoring_case(block, b"G99"),
        _ => false,
    }
}

/// Adds a tool; one that another block defines with other data is not known.
fn add(
    found: &mut BTreeMap<u32, Option<DefinedTool>>,
    number: u32,
    tool: Option<DefinedTool>,
    has_data: bool,
) {
    if !has_data {
        return;
    }
    let of = |tool: &Option<DefinedTool>| tool.as_ref().map(|own| own.tool.diameter_mm);
    match found.get_mut(&number) {
        None => {
            found.insert(number, tool);
        }
        Some(first) if of(first) != of(&tool) => *first = None,
        Some(_) => {}
    }
}

fn literal(word: Option<WordOperand>) -> Option<f64> {
    match word? {
        WordOperand::Number(value) => Some(value),
        WordOperand::Parameter { .. } => None,
    }
}

fn tool_of(length: Option<f64>, radius: Option<f64>, unit: f64) -> Option<Tool> {
    let radius = radius.filter(|radius| *radius > 0.0)? * unit;
    let length = length.map(|length| length * unit);
    let mut tool = Tool {
        diameter_mm: Some(2.0 * radius),
        shape: Some(ToolShape::Flat),
        flute_length_mm: length.filter(|length| *length > 0.0),
        ..Tool::default()
    };
    tool.offset[2] = length;
    Some(tool)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tools_with_a_radius_are_cylinders() {
        let text = "0 BEGIN PGM P MM\n1 TOOL DEF 1 L+80 R+5\n2 TOOL DEF 2 L+0 R3,5\n3 TOOL DEF 3 L+Q1 R+Q2\n4 TOOL DEF 4\n5 TOOL DEF 1 L+80 R+5\n6 TOOL DEF 7 R2\n7 TOOL DEF 7 R3\n";
        let found = defined_tools(text.as_bytes());
        let data: Vec<_> = found
            .iter()
            .map(|own| (own.number, own.tool.diameter_mm, own.tool.flute_length_mm))
            .collect();
        assert_eq!(data, [(1, Some(10.0), Some(80.0)), (2, Some(7.0), None)]);
        assert_eq!(found[0].range.slice(text.as_bytes()), b"1 TOOL DEF 1 L+80 R+5");
        let inch = defined_tools(b"0 BEGIN PGM P INCH\n1 TOOL DEF 1 L+1 R+.25\n");
        assert_eq!(inch[0].tool.diameter_mm, Some(12.7));
        let iso = defined_tools(b"%P G71 *\nN10 G99 T3 L+0 R+4 *\n");
        assert_eq!((iso[0].number, iso[0].tool.diameter_mm), (3, Some(8.0)));
    }
}
