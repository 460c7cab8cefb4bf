//! The units of a text without a units code: what comments state, and which units are plausible for its numbers.

use chordal::control::Units;

use super::trace::MotionTrace;

/// How much of the beginning is searched for comments, bytes.
const COMMENT_HEAD_BYTES: usize = 16 << 10;

/// The largest plausible part for a machine that runs such programs, mm.
const MAX_PART_MM: f64 = 4_000.0;

/// The largest plausible feed, mm/s (15 m/min).
const MAX_FEED_MM_PER_S: f64 = 250.0;

/// The smallest plausible value of the largest feed of a program, mm/s (12 mm/min).
const MIN_FEED_MM_PER_S: f64 = 0.2;

/// The plausible range of the largest turning feed of a program, mm per revolution.
const MAX_FEED_MM_PER_REV: f64 = 1.6;
const MIN_FEED_MM_PER_REV: f64 = 0.03;

/// The units that a comment near the beginning names, either next to a word such as `units` or `output` or in a
/// comment of at most two words; `None` when there is no such comment.
pub fn units_of_comments(text: &[u8]) -> Option<Units> {
    let head = &text[..text.len().min(COMMENT_HEAD_BYTES)];
    for line in head.split(|byte| matches!(byte, b'\n' | b'\r')) {
        let Some(start) = line.iter().position(|byte| matches!(byte, b'(' | b';')) else {
            continue;
        };
        let comment = String::from_utf8_lossy(&line[start..]).to_ascii_uppercase();
        let words: Vec<&str> = comment
            .split(|c: char| !c.is_ascii_alphanumeric())
            .filter(|word| !word.is_empty())
            .collect();
        let has = |names: &[&str]| words.iter().any(|word| names.contains(word));
        if !has(&["UNIT", "UNITS", "OUTPUT", "DIMENSIONS", "MEASURE"]) && words.len() > 2 {
            continue;
        }
        let inch = has(&["INCH", "INCHES"]);
        let millimetres =
            has(&["MM", "MILLIMETER", "MILLIMETERS", "MILLIMETRE", "MILLIMETRES", "METRIC"]);
        match (inch, millimetres) {
            (true, false) => return Some(Units::Inch),
            (false, true) => return Some(Units::Millimetre),
            _ => {}
        }
    }
    None
}

/// Whether the part and the feeds of a reading have plausible sizes.
pub fn is_plausible(trace: &MotionTrace) -> bool {
    let Some((low, high)) = trace.cut_box() else { return true };
    let size = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
    let per_s = trace.largest_feed_mm_per_s;
    let per_rev = trace.largest_feed_mm_per_rev;
    size <= MAX_PART_MM
        && (per_s == 0.0 || (MIN_FEED_MM_PER_S..=MAX_FEED_MM_PER_S).contains(&per_s))
        && (per_rev == 0.0 || (MIN_FEED_MM_PER_REV..=MAX_FEED_MM_PER_REV).contains(&per_rev))
}
