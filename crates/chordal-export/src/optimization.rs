//! New feeds: words and JSON.

use chordal::stock::POWER_SHARE;
use chordal_rewrite::OptimizedProgram;
use serde_json::{Value, json};

/// A time for people: minutes and seconds, or seconds to a tenth.
fn time_text(seconds: f64) -> String {
    if seconds < 60.0 {
        return format!("{seconds:.1} s");
    }
    let whole = seconds.round() as u64;
    format!("{}:{:02} min", whole / 60, whole % 60)
}

/// The share that one number is less than another, in percent; below zero where it is more.
fn less(before: f64, after: f64) -> f64 {
    if before > 0.0 { 100.0 * (before - after) / before } else { 0.0 }
}

/// The answer for people; `mm` says whether the program is in millimetres.
pub fn optimized_text(done: &OptimizedProgram, mm: bool) -> String {
    let chip = |value: f64| {
        if mm { format!("{value:.4} mm") } else { format!("{:.5} in", value / 25.4) }
    };
    let mut text = String::new();
    for tool in &done.chips {
        let [before, after] = tool.peak_mm;
        text += &format!(
            "tool {}: chip up to {}, before up to {}, limit {}\n",
            tool.tool,
            chip(after),
            chip(before),
            chip(tool.limit_mm)
        );
    }
    let [changed, all] = done.blocks;
    text += &format!("feeds     {changed} of {all} blocks have another one\n");
    if let Some(splits) = &done.splits {
        text += &format!(
            "split     {} {} into {} parts, nowhere further than {} from the path before\n",
            splits.blocks,
            if splits.blocks == 1 { "block" } else { "blocks" },
            splits.parts,
            if mm {
                format!("{:.6} mm", splits.off_mm)
            } else {
                format!("{:.7} in", splits.off_mm / 25.4)
            }
        );
    }
    let [before, after] = done.seconds;
    let share = less(before, after);
    let word = if share >= 0.0 { "less" } else { "more" };
    text += &format!(
        "time      {}, before {}: {:.1} % {word}\n",
        time_text(after),
        time_text(before),
        share.abs()
    );
    for note in &done.notes {
        text += &format!("note: {note}\n");
    }
    for each in &done.not_split {
        let blocks = match each.blocks {
            1 => format!("the block on line {} is not split", each.line),
            blocks => format!("{blocks} blocks are not split, the first on line {}", each.line),
        };
        text += &format!("note: {blocks}: {}\n", each.why);
    }
    if let Some(splits) = &done.splits {
        let cells = done.proof.cells;
        let stock = match cells - splits.same_cells {
            0 => " and the same stock to the bit".to_string(),
            others => {
                format!("; {others} columns of the stock have other bounds, which overlap")
            }
        };
        text += &format!("proved: the parts make the path of their blocks{stock}\n");
    }
    text += &format!(
        "proved: {} commands are the same but for their feeds, and the stock to the bit in {} columns\n",
        done.proof.commands, done.proof.cells
    );
    text
}

/// Schema `chordal.optimize/1`: mm, s.
pub fn optimized_json(done: &OptimizedProgram, file: &str, written: Option<&str>) -> String {
    let chips: Vec<Value> = done
        .chips
        .iter()
        .map(|tool| {
            json!({
                "tool": tool.tool,
                "limit_mm": tool.limit_mm,
                "before_mm": tool.peak_mm[0],
                "after_mm": tool.peak_mm[1],
            })
        })
        .collect();
    let changes: Vec<Value> = done
        .changes
        .iter()
        .map(|change| {
            json!({
                "line": change.line,
                "before": change.before,
                "after": change.after,
                "reason": change.reason,
            })
        })
        .collect();
    let object = json!({
        "schema": "chordal.optimize/1",
        "file": file,
        "written": written,
        "chips": chips,
        "blocks": { "changed": done.blocks[0], "all": done.blocks[1] },
        "seconds": { "before": done.seconds[0], "after": done.seconds[1] },
        "engaged_s": { "before": done.engaged_s[0], "after": done.engaged_s[1] },
        "power_share": POWER_SHARE,
        "proof": { "commands": done.proof.commands, "cells": done.proof.cells },
        "split": done.splits.map(|splits| json!({
            "blocks": splits.blocks,
            "parts": splits.parts,
            "off_mm": splits.off_mm,
            "same_cells": splits.same_cells,
        })),
        "not_split": done.not_split.iter().map(|each| json!({
            "blocks": each.blocks,
            "line": each.line,
            "reason": each.why,
        })).collect::<Vec<_>>(),
        "notes": done.notes,
        "changes": changes,
    });
    crate::pretty_json(object)
}
