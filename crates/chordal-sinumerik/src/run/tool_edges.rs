//! The edges of a tool as entries of the offset table.

/// The distance of the entries of a tool's second and further edges from those of its first, whose entry has the number
/// of the tool. Tool numbers end at 32000 (NC Programming 12/2019, 2.4).
const EDGE_STEP: u32 = 100_000_000;

/// The entry of an edge in the offset table; `None` without a tool or an edge.
pub fn edge_offset_number(tool: u32, edge: u32) -> Option<u32> {
    match (tool, edge) {
        (0, _) | (_, 0) => None,
        (tool, 1) => Some(tool),
        (tool, edge) => (edge - 1).checked_mul(EDGE_STEP)?.checked_add(tool),
    }
}
