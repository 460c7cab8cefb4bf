//! The document as one HTML page that needs nothing else.

mod program;
mod setup;
mod stock;
mod times;

use chordal_export::Plot;
use chordal_export::numbers::{SummaryUnits, counted, duration, fixed, grouped};
use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::data::{CalledProgram, CappedRows, Document, ReportHead, ReportedProblem};

const STYLE: &str = include_str!("style.css");

/// Digits of the digest that are shown at the top; all of them stand at the foot.
const DIGEST: usize = 12;

/// The page. Styles and drawings are in it, scripts there are none, and nothing is fetched.
pub fn html(document: &Document) -> String {
    let show = NumberDisplay::of(document);
    let head = &document.head;
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="generator" content={ "Chordal " (document.chordal) };
                title { (name(head)) " – setup sheet" }
                style { (PreEscaped(STYLE)) (PreEscaped(plot_colors())) }
            }
            body {
                header { (heading(document)) (banner(document)) (facts(document, &show)) }
                main {
                    // What must be mended comes before what is set up.
                    @if document.errors > 0 { (problems(document)) }
                    (pictures(document))
                    (stock::stock(document, &show))
                    (setup::offsets(document, &show))
                    (setup::tools(document, &show))
                    (program::stops(document))
                    (times::times(document))
                    (setup::travel(document, &show))
                    @if document.errors == 0 { (problems(document)) }
                    (program::program(document, &show))
                    div.sign-off {
                        span { "Set up by" } span { "Checked by" } span { "Date" }
                    }
                }
                (foot(document))
            }
        }
    };
    page.into_string()
}

/// Numbers in the program's own units.
struct NumberDisplay {
    units: SummaryUnits,
}

impl NumberDisplay {
    fn of(document: &Document) -> NumberDisplay {
        NumberDisplay { units: SummaryUnits::of(document.head.units == "inch") }
    }

    fn is_inch(&self) -> bool {
        self.units == SummaryUnits::Inch
    }

    /// A place of an axis, mm or degrees.
    fn place(&self, axis: char, value: f64) -> String {
        if is_rotary(axis) { fixed(value, 3) } else { self.units.coordinate(value) }
    }

    /// The unit of an axis.
    fn unit(&self, axis: char) -> &'static str {
        if is_rotary(axis) { "deg" } else { self.units.length_unit() }
    }
}

fn is_rotary(axis: char) -> bool {
    matches!(axis, 'A' | 'B' | 'C')
}

/// `2 errors, 1 warning`.
fn counts(document: &Document) -> String {
    let all = [
        (document.errors, "error", "errors"),
        (document.warnings, "warning", "warnings"),
        (document.notes, "note", "notes"),
    ];
    let some = all.into_iter().filter(|(number, ..)| *number > 0);
    let reported: Vec<String> =
        some.map(|(number, one, many)| counted(number, one, many)).collect();
    if reported.is_empty() { "none".to_string() } else { reported.join(", ") }
}

/// The colours of the drawings: light ones for paper and by day.
fn plot_colors() -> String {
    format!(
        ":root{{{}}}@media screen and (prefers-color-scheme: dark){{:root{{{}}}}}",
        Plot::page_colors(false),
        Plot::page_colors(true)
    )
}

/// `O1000 BRACKET`, or the file.
fn name(head: &ReportHead) -> String {
    match head.programs.rows.as_slice() {
        [only] if only.number.is_some() => program_name(only),
        _ => head.file.clone(),
    }
}

fn program_name(program: &CalledProgram) -> String {
    let number = program.number.map(|number| format!("O{number}"));
    let parts: Vec<&str> = number.as_deref().into_iter().chain(program.title.as_deref()).collect();
    if parts.is_empty() { "without a number".to_string() } else { parts.join(" ") }
}

fn heading(document: &Document) -> Markup {
    let head = &document.head;
    let title = name(head);
    html! {
        h1 { (title) }
        @if title != head.file { p.subtitle.faint { (head.file) } }
        @if head.programs.rows.len() > 1 {
            p.subtitle {
                "Programs: "
                (head.programs.rows.iter().take(12).map(program_name).collect::<Vec<_>>().join(", "))
                @if head.programs.rows.len() > 12 || head.programs.left_out > 0 {
                    " and "
                    (grouped(head.programs.rows.len().saturating_sub(12) as u64 + head.programs.left_out))
                    " more"
                }
            }
        }
        @if !head.comments.is_empty() {
            ul.comments { @for comment in &head.comments { li { (comment) } } }
        }
    }
}

/// What must be seen before the sheet is used.
fn banner(document: &Document) -> Markup {
    let first = document.problems.rows.first();
    html! {
        @if document.errors > 0 {
            div.banner.error role="region" aria-label="Errors" {
                p {
                    strong {
                        "Do not run: " (counted(document.errors, "error", "errors")) "."
                    }
                    " The control would stop, or would not do what the text says. "
                    a href="#problems" { "All problems" }
                }
                @if let Some(first) = first {
                    p { @if let Some((_, line)) = &first.place { "Line " (line) ": " } (first.message) }
                }
                @if let Some((file, line)) = &document.not_verified_from {
                    p {
                        "Not verified from line " (line) " of " (file) " on: the "
                        (if document.is_path_verified { "time" } else { "path" }) " after it is not known."
                    }
                }
                (ends(document))
            }
        } @else if !document.ends.is_empty() || document.warnings > 0 {
            div.banner.warning role="region" aria-label="Warnings" {
                @if document.warnings > 0 {
                    p {
                        strong { (counted(document.warnings, "warning", "warnings")) "." } " "
                        a href="#problems" { "Read them first" }
                    }
                }
                (ends(document))
            }
        }
    }
}

fn ends(document: &Document) -> Markup {
    html! { @for end in &document.ends { p { (end) } } }
}

fn facts(document: &Document, show: &NumberDisplay) -> Markup {
    let head = &document.head;
    let fact = |name: &str, value: &str, large: bool| {
        html! {
            div { dt { (name) } @if large { dd.large { (value) } } @else { dd { (value) } } }
        }
    };
    let cuts = format!("{} {}", show.units.length(document.moves.cut_mm), show.units.length_unit());
    html! {
        dl.facts {
            @if let Some(time) = &document.time {
                (fact("Cycle time", &duration(time.total_s), true))
                (fact("of which cutting", &duration(time.cutting_s), true))
            } @else {
                (fact("Cycle time", "not planned", true))
                (fact("Cuts", &cuts, true))
            }
            (fact("Tools", &grouped(document.tools.rows.len() as u64 + document.tools.left_out), true))
            (fact("Problems", &counts(document), true))
            (fact("Control", head.control, false))
            (fact("Machine", &head.machine, false))
            (fact("Units", head.units, false))
            (fact("Text (SHA-256)", &head.sha256[..DIGEST.min(head.sha256.len())], false))
            @if let Some(date) = &head.date { (fact("Date", date, false)) }
        }
        @if let Some(why) = &head.recognized {
            p.faint { "No machine was given: " (why) "." }
        }
    }
}

fn pictures(document: &Document) -> Markup {
    let pictures = &document.pictures;
    html! {
        section aria-labelledby="path" {
            h2 #path { "Path" }
            @if pictures.views.is_empty() {
                p { "No move is at a known position relative to the part." }
            } @else {
                div.pictures {
                    @for picture in &pictures.views {
                        figure {
                            (PreEscaped(&picture.svg))
                            figcaption { (upper_first(&picture.caption)) }
                        }
                    }
                }
                ul.legend {
                    @for tool in pictures.tools.iter().take(24) {
                        li { (PreEscaped(&tool.svg)) (tool_name(tool.number)) }
                    }
                    @if pictures.tools.len() > 24 {
                        li { "and " (pictures.tools.len() - 24) " more tools" }
                    }
                    li.faint { "dashed: rapids" }
                    @if document.stock.is_some() { li.faint { "grey: the stock that is left" } }
                    li.faint { "quartered circle: zero of the work offset of the first cut" }
                    li.faint { "ring and square: start and end" }
                }
                @if pictures.cuts_left_out {
                    p.faint { "Cuts at unknown positions are left out." }
                }
                @for stated in &pictures.remarks {
                    p.faint { (upper_first(stated)) "." }
                }
            }
        }
    }
}

fn upper_first(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

fn tool_name(number: u32) -> String {
    if number == 0 { "no tool".to_string() } else { format!("T{number}") }
}

/// Rows of a table that goes onto one page of paper as a whole.
const ON_ONE_PAGE: usize = 16;

/// A table that scrolls where the window is too narrow for it.
fn scrolling(label: &str, rows: usize, table: Markup) -> Markup {
    html! {
        div.scroll.keep[rows <= ON_ONE_PAGE] role="region" aria-label=(label) tabindex="0" { (table) }
    }
}

/// The line that says what a table leaves out.
fn left_out<T>(rows: &CappedRows<T>, shown: usize, what: &str) -> Markup {
    let more = rows.left_out + rows.rows.len().saturating_sub(shown) as u64;
    html! { @if more > 0 { p.faint { "and " (grouped(more)) " more " (what) } } }
}

fn problems(document: &Document) -> Markup {
    html! {
        section aria-labelledby="problems" {
            h2 #problems { "Problems" }
            @if document.problems.rows.is_empty() {
                p { "None: the program passed all checks of this control and machine." }
            } @else {
                p { (upper_first(&counts(document))) "." }
                @for each in &document.problems.rows { (problem(each)) }
                (left_out(&document.problems, document.problems.rows.len(), "problems"))
            }
        }
    }
}

/// One problem, as the sheet and a notebook show it.
pub(crate) fn problem(problem: &ReportedProblem) -> Markup {
    html! {
        div class={ "problem " (problem.severity) } {
            h3 {
                span.severity { (problem.severity) " " (problem.code) } " "
                @if let Some((_, line)) = &problem.place { "Line " (line) ": " }
                (problem.message)
            }
            @if !problem.excerpt.trim().is_empty() {
                pre tabindex="0" aria-label="The words in their lines" { (problem.excerpt.trim_end()) }
            }
            @if let Some(alarm) = &problem.alarm { p { strong { "Alarm: " } (alarm) } }
            @for note in &problem.notes { p { (upper_first(note)) } }
            @if let Some(help) = &problem.help { p { strong { "What to do: " } (help) } }
            @if let Some(fix) = &problem.fix { p { strong { "Fix: " } (fix) } }
        }
    }
}

fn foot(document: &Document) -> Markup {
    let head = &document.head;
    html! {
        footer {
            p {
                (head.file) ", " (counted(head.bytes, "byte", "bytes")) ", "
                (counted(head.lines, "line", "lines")) ", SHA-256 " (head.sha256)
            }
            p {
                "Made by Chordal " (document.chordal) ". Times hold velocity, acceleration and jerk of "
                "every axis, as the machine file gives them; the times are not measured."
                @if document.stock.is_none() {
                    " Without a setup file, stock, fixtures and holders are not looked at."
                }
            }
        }
    }
}
