//! What `chordal convert` says of cycles of a lathe whose passes are other ones on the new machine.

use chordal_export::length_text;
use chordal_rewrite::convert::{PassChange, PassReading};

use crate::numbers::{SummaryUnits, counted};

/// Three lines for each cycle.
pub fn text(changes: &[PassChange], machines: [&String; 2], units: SummaryUnits) -> String {
    if changes.is_empty() {
        return String::new();
    }
    let mut text = "\npasses\n".to_string();
    for change in changes {
        text += &format!(
            "  {} in line {}: the last pass is the same, the passes before it are not\n",
            change.cycle, change.lines[0]
        );
        for (machine, reading) in machines.into_iter().zip(&change.readings) {
            text += &format!("      {machine}: {}\n", passes_text(reading, units));
        }
    }
    text + "  --exact-cycles writes these cycles out as moves\n"
}

fn passes_text(reading: &PassReading, units: SummaryUnits) -> String {
    let length = |mm: f64| length_text(mm, units);
    let cuts = counted(reading.cuts as u64, "cut", "cuts");
    let step = reading
        .largest_step_mm
        .map_or_else(String::new, |mm| format!(", levels {} apart at most", length(mm)));
    format!("{cuts}, {} long together{step}", length(reading.length_mm))
}
