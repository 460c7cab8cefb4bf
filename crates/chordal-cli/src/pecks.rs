//! What `chordal convert` says of cycles whose pecks are other ones on the new machine.

use chordal_export::length_text;
use chordal_rewrite::convert::{PeckChange, PeckReading};

use crate::numbers::{SummaryUnits, counted};

/// A line for each kind of difference.
pub fn text(changes: &[PeckChange], machines: [&String; 2], units: SummaryUnits) -> String {
    if changes.is_empty() {
        return String::new();
    }
    let mut groups: Vec<(&PeckChange, u32, u64)> = Vec::new();
    for change in changes {
        let same = |one: &&mut (&PeckChange, u32, u64)| {
            one.0.cycle == change.cycle && pecks_text(one.0, units) == pecks_text(change, units)
        };
        match groups.iter_mut().find(same) {
            Some(group) => {
                group.1 += 1;
                group.2 += change.holes;
            }
            None => groups.push((change, 1, change.holes)),
        }
    }
    let mut text = "\npecks\n".to_string();
    for (change, blocks, holes) in groups {
        let blocks = counted(u64::from(blocks), "block", "blocks");
        let holes = counted(holes, "hole", "holes");
        text += &format!(
            "  {} in {blocks} ({holes}), first in line {}: the holes are the same, their pecks are not\n",
            change.cycle, change.lines[0]
        );
        for (machine, words) in machines.into_iter().zip(pecks_text(change, units)) {
            text += &format!("      {machine}: {words}\n");
        }
    }
    text + "  --exact-cycles writes these cycles out as moves\n"
}

fn pecks_text(change: &PeckChange, units: SummaryUnits) -> [String; 2] {
    change.readings.each_ref().map(|reading| reading_text(reading, units))
}

fn reading_text(reading: &PeckReading, units: SummaryUnits) -> String {
    let length = |mm: f64| length_text(mm, units);
    let step = length(reading.largest_step_mm);
    let mut text = match reading.pecks {
        1 => format!("one peck of {step}"),
        many => format!("{many} pecks of {step} at most"),
    };
    let by = |setting: Option<&str>| setting.map_or_else(String::new, |name| format!(" ({name})"));
    if let Some(clearance) = reading.clearance_mm {
        text += &format!(
            "; the rapid back stops {} above the last depth{}",
            length(clearance),
            by(reading.clearance_setting)
        );
    }
    if let Some(above) = reading.above_r_mm.filter(|above| *above > 1e-6) {
        text += &format!(
            "; the tool goes out to {} above R{}",
            length(above),
            by(reading.above_r_setting)
        );
    }
    text
}
