//! A run on stock in words.

use chordal::stock::{StockReport, StockVerdict, VolumeInterval};
use chordal::{Code, Report, Severity};

use crate::numbers::duration;

/// A volume between two bounds: cubic centimetres, or cubic inches.
pub fn stock_volume(bounds_mm3: [f64; 2], inch: bool) -> String {
    let (unit, size) = if inch { ("in³", 25.4_f64.powi(3)) } else { ("cm³", 1000.0) };
    let [least, most] = bounds_mm3.map(|volume| volume / size);
    // As many digits as both bounds share, and one more.
    let gap = (most - least).max(1e-9 * most.abs()).max(1e-9);
    let decimals = (1.0 - gap.log10()).ceil().clamp(0.0, 4.0) as usize;
    let [low, high] = [least, most].map(|value| format!("{value:.decimals$}"));
    if low == high { format!("{low} {unit}") } else { format!("{low} to {high} {unit}") }
}

/// The answer for people, in the units of the program; the problems are printed apart.
pub fn stock_text(found: &StockReport) -> String {
    let inch = found.report.summary.inch;
    let length = |mm: f64| {
        if inch { format!("{:.4} in", mm / 25.4) } else { format!("{mm:.3} mm") }
    };
    let volume = |amount: VolumeInterval, inch| stock_volume([amount.least, amount.most], inch);
    let mut text = format!("removed     {}\n", volume(found.removed_mm3, inch));
    text += &format!("left        {}\n", volume(found.left_mm3, inch));
    text += &format!("resolution  {}\n", length(found.resolution_mm));
    if found.sides > 1 {
        text += &format!("sides       {}, one for each angle of the rotary axes\n", found.sides);
    }
    for tool in &found.tools {
        let removed = volume(tool.removed_mm3, inch);
        let lowest = length(tool.lowest_mm);
        let time = tool.time_s.map(|time| format!(", {}", duration(time))).unwrap_or_default();
        text += &format!("tool {:<6} {removed}, lowest tip {lowest}{time}\n", tool.number);
    }
    if let Some(target) = &found.target {
        let volume = volume(target.left_over_mm3, inch);
        text += &format!("left over   {volume} outside of the target\n");
    }
    text += stock_verdict_text(found.verdict);
    text.push('\n');
    text += &stock_premise_text(&found.report);
    text += &without_holder(found);
    text
}

/// What the verdict rests on: stock from the program, a work offset that may have been set with the tool.
pub(super) fn stock_premise_text(report: &Report) -> String {
    let says = |code: Code, severity: Severity| {
        report.diagnostics.iter().any(|found| found.code == code && found.severity == severity)
    };
    let mut text = String::new();
    if says(Code::StockFromComment, Severity::Note) {
        text += "this holds for the stock that the program describes: no setup gives one\n";
    }
    if says(Code::TipNotKnown, Severity::Note) {
        text += "this holds only where Z0 was set with the tool: its length is not given, and none is in force\n";
    }
    text
}

/// The tools of which no holder is given, where it counts.
fn without_holder(found: &StockReport) -> String {
    let missing = found.tools.iter().filter(|tool| !tool.has_holder);
    let numbers: Vec<String> = missing.map(|tool| tool.number.to_string()).collect();
    if numbers.is_empty() || found.verdict != StockVerdict::Clean {
        return String::new();
    }
    let tools = if numbers.len() == 1 { "tool" } else { "tools" };
    format!("no holder is given of {tools} {}, so none was looked at\n", numbers.join(", "))
}

/// What a verdict says.
pub fn stock_verdict_text(verdict: StockVerdict) -> &'static str {
    match verdict {
        StockVerdict::Clean => {
            "clean: no rapid, and no shank or holder that is given, touches material; proved within the resolution"
        }
        StockVerdict::Problems => "problems: see the list of problems",
        StockVerdict::NotProved => {
            "not proved: no touch was found, and the messages say what is not known"
        }
    }
}
