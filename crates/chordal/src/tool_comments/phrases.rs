//! Comments that describe a tool after a key, without its number: `TC: 5mm Endmill`.

use super::CommentedTool;
use super::forms::number;
use super::read::read_description;

/// Keys that announce the description of a tool.
const KEYS: [&str; 6] = ["TC:", "TOOL NAME:", "TOOL NAME :", "CHANGE TOOL:", "TOOL=", "TOOL:"];

/// Keys that announce a diameter only.
const DIAMETER_KEYS: [&str; 3] =
    ["COMPENSATED TOOL PATH. DIAMETER:", "TOOL DIA.", "TOOL DIAMETER:"];

/// `TOOL NUMBER:5`: the comment after it describes this tool.
pub(super) fn named_tool(text: &str) -> Option<u32> {
    let upper = text.to_ascii_uppercase();
    let rest = upper.trim().strip_prefix("TOOL NUMBER")?;
    let digits = rest.trim_start_matches([' ', ':', '=', '#']);
    if digits.len() == rest.len() {
        return None;
    }
    digits.trim().parse().ok().filter(|number| (1..=999).contains(number))
}

/// The tool that the text describes; its number is 0 where it is not known. `named` is the number from the comment
/// before it.
pub(super) fn read_phrase(text: &str, inch: bool, named: Option<u32>) -> Option<CommentedTool> {
    let upper = text.to_ascii_uppercase();
    let upper = upper.trim();
    if let Some(number) = named {
        let described = upper.strip_prefix("DESCRIPTION:").or(Some(upper));
        let commented = described.and_then(|text| read_description(text, inch));
        return commented.map(|tool| CommentedTool { number, ..tool });
    }
    if let Some(rest) = DIAMETER_KEYS.iter().find_map(|key| upper.strip_prefix(key)) {
        let diameter = number(rest.trim_start_matches([' ', ':', '-', '=']))?;
        let diameter_mm = if inch { 25.4 * diameter } else { diameter };
        return (diameter_mm > 0.0)
            .then(|| CommentedTool { diameter_mm: Some(diameter_mm), ..CommentedTool::of(0) });
    }
    let rest = KEYS.iter().find_map(|key| upper.strip_prefix(key))?.trim();
    let own_number =
        rest.strip_prefix('T').is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
    if own_number {
        return super::read_tool_comment(rest, inch, None, false);
    }
    // `TOOL: 5`: a number, and no description.
    if rest.starts_with(|c: char| c.is_ascii_digit()) && number(rest).is_some() {
        return None;
    }
    read_description(rest, inch)
}
