//! What an operator meets, and what the program is made of.

use chordal_export::numbers::{counted, grouped};
use maud::{Markup, html};

use super::{NumberDisplay, left_out, program_name, scrolling, tool_name};
use crate::data::{CalledProgram, Document, OperatorStop, SkippedBlocks, StopKind};

/// Stops and programs on the page.
const MAX_LISTED: usize = 60;

/// Stops, messages, probing and block delete.
pub fn stops(document: &Document) -> Markup {
    let (stops, skipped) = (&document.stops, &document.skipped);
    html! {
        section aria-labelledby="stops" {
            h2 #stops { "Stops and messages" }
            @if stops.rows.is_empty() && skipped.lines.rows.is_empty() {
                p { "None: it runs to its end without a stop." }
            }
            @if !stops.rows.is_empty() {
                (scrolling("Stops and messages", stops.rows.len(), html! { table {
                    thead {
                        tr {
                            th scope="col" { "Line" }
                            th scope="col" { "What" }
                            th scope="col" { "Tool" }
                            th scope="col" { "Text" }
                            th.n scope="col" { "Times" }
                        }
                    }
                    tbody { @for stop in stops.rows.iter().take(MAX_LISTED) { (row(stop)) } }
                } }))
                (left_out(stops, MAX_LISTED, "stops and messages"))
            }
            @if !skipped.lines.rows.is_empty() { (skipped_blocks(skipped)) }
        }
    }
}

fn row(stop: &OperatorStop) -> Markup {
    let what = match stop.kind {
        StopKind::Stop => "Stop (M0)",
        StopKind::OptionalStop => "Optional stop (M1)",
        StopKind::Message => "Message",
        StopKind::Probe => "Probe or skip move",
    };
    html! {
        tr {
            th scope="row" { (stop.line) @if let Some(file) = &stop.file { " of " (file) } }
            td { @if stop.kind == StopKind::Stop { strong { (what) } } @else { (what) } }
            td { (tool_name(stop.tool)) }
            td.words { (stop.text.as_deref().unwrap_or("–")) }
            td.n { (grouped(stop.times)) }
        }
    }
}

fn skipped_blocks(skipped: &SkippedBlocks) -> Markup {
    let lines: Vec<String> = skipped.lines.rows.iter().map(u32::to_string).collect();
    html! {
        p {
            "Block delete (/) is on line " (lines.join(", "))
            @if skipped.lines.left_out > 0 { " and " (grouped(skipped.lines.left_out)) " more" }
            ". This report is of a run with the switch "
            strong { @if skipped.left_out { "on" } @else { "off" } } "."
        }
    }
}

/// Moves counted, subprograms, what is printed.
pub fn program(document: &Document, show: &NumberDisplay) -> Markup {
    let moves = &document.moves;
    let counts = [
        (moves.lines, "line", "lines"),
        (moves.arcs, "arc", "arcs"),
        (moves.helices, "helix", "helices"),
        (moves.spirals, "spiral", "spirals"),
        (moves.splines, "spline", "splines"),
        (moves.rapids, "rapid", "rapids"),
        (moves.dwells, "dwell", "dwells"),
    ];
    let some = counts.into_iter().filter(|(number, ..)| *number > 0);
    let reported: Vec<String> =
        some.map(|(number, one, many)| counted(number, one, many)).collect();
    let unit = show.units.length_unit();
    html! {
        section aria-labelledby="program" {
            h2 #program { "Program" }
            p {
                @if reported.is_empty() { "No moves" } @else { (reported.join(", ")) }
                " in " (counted(moves.blocks, "block", "blocks")) "; "
                (show.units.length(moves.cut_mm)) " " (unit) " of cuts, "
                (show.units.length(moves.rapid_mm)) " " (unit) " of rapids."
            }
            @if !document.called.rows.is_empty() {
                h3 { "Subprograms that run" }
                (scrolling("Subprograms", document.called.rows.len(), html! { table {
                    thead {
                        tr {
                            th scope="col" { "Program" }
                            th scope="col" { "File" }
                            th.n scope="col" { "Line" }
                        }
                    }
                    tbody {
                        @for called in document.called.rows.iter().take(MAX_LISTED) {
                            (subprogram(called, &document.head.file))
                        }
                    }
                } }))
                (left_out(&document.called, MAX_LISTED, "programs"))
            }
            @if !document.printed.rows.is_empty() {
                h3 { "It prints" }
                pre.printed tabindex="0" aria-label="Printed lines" {
                    @for line in &document.printed.rows { (line) "\n" }
                }
                (left_out(&document.printed, document.printed.rows.len(), "lines"))
            }
        }
    }
}

fn subprogram(called: &CalledProgram, own: &str) -> Markup {
    html! {
        tr {
            th scope="row" { (program_name(called)) }
            td.words { (called.file.as_deref().unwrap_or(own)) }
            td.n { (called.line) }
        }
    }
}
