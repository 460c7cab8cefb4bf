//! How hard the cuts are: words and JSON.

use std::fmt::Write as _;

use chordal::control::{Units, telling_number};
use chordal::stock::{
    BoundedValue, EngagementReport, LoadPeak, MoveEngagement, NoMaterial, ToolEngagement,
};
use serde_json::{Value, json};

use super::json::{between, problem, rounded};

/// Numbers in the units of a program.
struct EngagementUnits(Units);

impl EngagementUnits {
    fn length(&self, mm: f64) -> String {
        match self.0 {
            Units::Inch => format!("{} in", telling_number(mm / 25.4, 3)),
            Units::Millimetre => format!("{} mm", telling_number(mm, 2)),
        }
    }

    fn chip(&self, mm: f64) -> String {
        match self.0 {
            Units::Inch => format!("{} in", telling_number(mm / 25.4, 5)),
            Units::Millimetre => format!("{} mm", telling_number(mm, 4)),
        }
    }

    /// From mm³/s, by minute.
    fn rate(&self, rate: f64) -> String {
        match self.0 {
            Units::Inch => format!("{} in³/min", telling_number(rate * 60.0 / 25.4_f64.powi(3), 2)),
            Units::Millimetre => format!("{} cm³/min", telling_number(rate * 0.06, 1)),
        }
    }

    fn power(&self, kw: f64) -> String {
        match self.0 {
            Units::Inch => format!("{} hp", telling_number(kw / KW_OF_HP, 2)),
            Units::Millimetre => format!("{} kW", telling_number(kw, 2)),
        }
    }

    fn torque(&self, nm: f64) -> String {
        match self.0 {
            Units::Inch => format!("{} in·lb", telling_number(nm / NM_OF_INLB, 1)),
            Units::Millimetre => format!("{} N·m", telling_number(nm, 2)),
        }
    }
}

/// A horsepower, kW.
const KW_OF_HP: f64 = 0.745_699_871_582_270_2;
/// An inch-pound, N·m.
const NM_OF_INLB: f64 = 0.112_984_829_027_616_7;

/// The answer for people, in the units of the program; the problems are printed apart.
pub fn engagement_text(found: &EngagementReport) -> String {
    let words = EngagementUnits(found.units);
    let mut text = String::new();
    for tool in &found.tools {
        let _ = writeln!(text, "{}", head(tool));
        let mut row = |name: &str, peak: LoadPeak, say: &dyn Fn(f64) -> String| {
            let _ = writeln!(
                text,
                "  {name:<13} {:<14} typical {:<14} line {}",
                say(peak.peak),
                say(peak.typical),
                peak.line
            );
        };
        if tool.across_mm.peak <= 0.0 {
            text += "  cuts nothing\n";
            continue;
        }
        row("radial depth", tool.across_mm, &|mm| words.length(mm));
        row("axial depth", tool.axial_mm, &|mm| words.length(mm));
        if let Some(chip) = tool.chip_mm {
            row("chip", chip, &|mm| words.chip(mm));
        }
        row("removal rate", tool.rate_mm3_per_s, &|rate| words.rate(rate));
        if let Some(power) = tool.power_kw {
            row("power ± 30 %", power, &|kw| words.power(kw));
        }
        if let Some(torque) = tool.torque_nm {
            row("torque ± 30 %", torque, &|nm| words.torque(nm));
        }
    }
    if found.tools.is_empty() && found.not_measured.is_empty() {
        text += "no move is cut from the stock\n";
    }
    match (&found.material, &found.material_word) {
        (Some(material), _) => {
            let group = match material.group {
                Some(group) => format!("VDI 3323 group {group}"),
                None => material.source.clone(),
            };
            let _ = writeln!(
                text,
                "material      {}: {group}, {} N/mm², exponent {}",
                material.name, material.k_c1, material.m_c
            );
        }
        (None, Some(word)) => {
            let why = match found.no_material {
                Some(NoMaterial::Lacks(key)) => {
                    format!(
                        "`[materials]` has no `{key}` of `{word}`, and it is not a material of the table"
                    )
                }
                Some(NoMaterial::Unknown) | None => format!(
                    "`{word}` is not in the table of materials (docs/engagement.md); give its `k_c1` and `m_c` in `[materials]`"
                ),
            };
            let _ = writeln!(text, "note: no power and no torque: {why}");
        }
        (None, None) => {
            text += "note: no power and no torque: `[stock]` has no `material`\n";
        }
    }
    let toothless: Vec<String> = found
        .tools
        .iter()
        .filter(|tool| tool.teeth.is_none())
        .map(|tool| tool.number.to_string())
        .collect();
    if !toothless.is_empty() {
        let _ = writeln!(
            text,
            "note: no chip of tool {}: the number of its teeth is not given",
            toothless.join(", ")
        );
    }
    if !found.not_measured.is_empty() {
        let tools: Vec<String> = found.not_measured.iter().map(u32::to_string).collect();
        let _ = writeln!(
            text,
            "note: tool {} cuts below its widest place: what it engages is not measured",
            tools.join(", ")
        );
    }
    let _ = writeln!(text, "resolution    {}", words.length(found.resolution_mm));
    text +=
        "depths and chips are at most, at the programmed feeds; touches are not looked at here\n";
    if !found.is_whole {
        text += "not whole: some moves are not cut from the stock, see above\n";
    }
    text
}

fn head(tool: &ToolEngagement) -> String {
    let teeth = match tool.teeth {
        Some(1) => ", 1 tooth".to_string(),
        Some(teeth) => format!(", {teeth} teeth"),
        None => String::new(),
    };
    let seconds = telling_number(tool.engaged_s, 1);
    format!("tool {}{teeth}: {} moves, {seconds} s in material", tool.number, tool.moves)
}

fn bounds(value: BoundedValue, scale: f64) -> Value {
    between(value.least * scale, value.most * scale)
}

fn peak(peak: LoadPeak, scale: f64) -> Value {
    json!({
        "peak": rounded(peak.peak * scale),
        "typical": rounded(peak.typical * scale),
        "line": peak.line,
    })
}

/// Schema `chordal.engagement/1`: mm, mm/min, mm³/min, kW, N·m, degrees. `moves`: with every move.
pub fn engagement_json(found: &EngagementReport, file: &str, moves: bool) -> String {
    const MINUTE: f64 = 60.0;
    let tools: Vec<Value> = found
        .tools
        .iter()
        .map(|tool| {
            json!({
                "number": tool.number,
                "teeth": tool.teeth,
                "moves": tool.moves,
                "engaged_s": rounded(tool.engaged_s),
                "removed_mm3": rounded(tool.removed_mm3),
                "radial_depth_mm": peak(tool.across_mm, 1.0),
                "axial_depth_mm": peak(tool.axial_mm, 1.0),
                "chip_mm": tool.chip_mm.map(|value| peak(value, 1.0)),
                "lasting_chip_mm": tool.lasting_chip_mm.map(rounded),
                "rate_mm3_per_min": peak(tool.rate_mm3_per_s, MINUTE),
                "power_kw": tool.power_kw.map(|value| peak(value, 1.0)),
                "torque_nm": tool.torque_nm.map(|value| peak(value, 1.0)),
            })
        })
        .collect();
    let problems: Vec<Value> = found
        .problems
        .iter()
        .map(|found| {
            let limit = json!(rounded(found.limit));
            let more = [("value", bounds(found.value, 1.0)), ("limit", limit)];
            problem(found.code, (&found.file, found.line), found.tool, more)
        })
        .collect();
    let material = found.material.as_ref().map(|material| {
        json!({
            "name": material.name,
            "vdi_3323": material.group,
            "k_c1_n_per_mm2": material.k_c1,
            "m_c": material.m_c,
            "source": material.source,
        })
    });
    let rows: Option<Vec<Value>> = moves.then(|| found.moves.iter().map(row).collect());
    let object = json!({
        "schema": "chordal.engagement/1",
        "file": file,
        "resolution_mm": found.resolution_mm,
        "material": material,
        "spindle_kw": found.spindle_kw,
        "power_share": chordal::stock::POWER_SHARE,
        "whole": found.is_whole,
        "not_measured": found.not_measured,
        "tools": tools,
        "problems": problems,
        "problems_left_out": found.more_problems,
        "errors": found.report.counts.errors,
        "moves": rows,
    });
    crate::pretty_json(object)
}

fn row(each: &MoveEngagement) -> Value {
    json!({
        "line": each.origin.line,
        "tool": each.tool,
        "length_mm": rounded(each.length_mm),
        "engaged_mm": rounded(each.engaged_mm),
        "feed_mm_per_min": rounded(each.feed_mm_per_s * 60.0),
        "spindle_rpm": rounded(each.rpm),
        "radial_depth_mm": bounds(each.across_mm, 1.0),
        "axial_depth_mm": bounds(each.axial_mm, 1.0),
        "angle_deg": bounds(each.angle_rad, 180.0 / std::f64::consts::PI),
        "chip_mm": each.chip.map(|chip| bounds(chip.peak_mm, 1.0)),
        "mean_chip_mm": each.chip.map(|chip| rounded(chip.mean_mm)),
        "removed_mm3": rounded(each.removed_mm3),
        "rate_mm3_per_min": rounded(each.rate_mm3_per_s * 60.0),
        "power_kw": each.effort.map(|effort| rounded(effort.power_kw)),
        "torque_nm": each.effort.map(|effort| rounded(effort.torque_nm)),
    })
}
