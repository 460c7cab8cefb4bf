//! What is set before the run: offsets, tools, travel.

use chordal::machine::AXIS_LETTERS;
use chordal_export::numbers::{SummaryUnits, duration, grouped, short};
use maud::{Markup, PreEscaped, html};

use super::{NumberDisplay, left_out, scrolling, tool_name};
use crate::data::{
    AxisRange, Document, FeedRange, MachineTravel, Register, ReportedTool, ReportedWorkOffset,
};

/// Rows of a table on the page.
const MAX_TABLE_ROWS: usize = 100;

/// A place to write a value in.
fn blank() -> Markup {
    html! { span.blank { span.hidden { "not set" } } }
}

/// Work offsets and tool offsets, with blanks where the machine file gives no value.
pub fn offsets(document: &Document, show: &NumberDisplay) -> Markup {
    let (work, registers) = (&document.work_offsets, &document.registers);
    html! {
        section aria-labelledby="offsets" {
            h2 #offsets { "Offsets to set" }
            @if work.is_empty() && registers.rows.is_empty() {
                p { "None is used." }
            }
            div.sides {
                @if !work.is_empty() { (work_offsets(work, show)) }
                @if !registers.rows.is_empty() {
                    div {
                        (tool_offsets(&registers.rows[..registers.rows.len().min(MAX_TABLE_ROWS)], document.head.is_lathe, show))
                        (left_out(registers, MAX_TABLE_ROWS, "tool offsets"))
                    }
                }
            }
            @if work.iter().any(|offset| offset.values.iter().any(|value| value.value.is_none()))
                || registers.rows.iter().any(|register| is_unset(register, document.head.is_lathe))
            {
                p.faint {
                    "An empty line: the machine file has no value. Set it at the control and write it here."
                }
            }
        }
    }
}

fn is_unset(register: &Register, is_lathe: bool) -> bool {
    register.uses_length && register.length_mm.is_none()
        || register.uses_length && is_lathe && register.x_mm.is_none()
        || register.uses_radius && is_lathe && register.tip.is_none()
        || register.uses_radius && register.diameter_mm.or(register.nose_radius_mm).is_none()
}

fn work_offsets(offsets: &[ReportedWorkOffset], show: &NumberDisplay) -> Markup {
    let mut axes: Vec<char> =
        offsets.iter().flat_map(|offset| offset.values.iter().map(|value| value.axis)).collect();
    axes.sort_by_key(|axis| AXIS_LETTERS.find(*axis));
    axes.dedup();
    html! {
        div {
            (scrolling("Work offsets", offsets.len(), html! { table {
                caption { "Work offsets, machine coordinates" }
                thead {
                    tr {
                        th scope="col" { "Offset" }
                        @for axis in &axes { th.n scope="col" { (axis) " " (show.unit(*axis)) } }
                    }
                }
                tbody {
                    @for offset in offsets.iter().take(MAX_TABLE_ROWS) {
                        tr {
                            th scope="row" { (offset.name) }
                            @for axis in &axes {
                                td.n {
                                    @match offset.values.iter().find(|value| value.axis == *axis) {
                                        Some(value) => @match value.value {
                                            Some(place) => (show.place(*axis, place)),
                                            None => (blank()),
                                        },
                                        None => "–",
                                    }
                                }
                            }
                        }
                    }
                }
            } }))
            @for offset in offsets.iter().filter(|offset| !offset.moved_at.is_empty()).take(MAX_TABLE_ROWS) {
                p.faint {
                    (offset.name) " is set or shifted by the program itself, line "
                    (numbers(&offset.moved_at)) "."
                }
            }
        }
    }
}

/// A value of a tool offset; a blank where it is used and not set.
fn offset_value(used: bool, value: Option<f64>, show: &NumberDisplay) -> Markup {
    html! {
        @match (used, value) {
            (_, Some(mm)) => (show.units.coordinate(mm)),
            (true, None) => (blank()),
            (false, None) => "–",
        }
    }
}

fn tool_offsets(registers: &[Register], is_lathe: bool, show: &NumberDisplay) -> Markup {
    let unit = show.units.length_unit();
    html! {
        (scrolling("Tool offsets", registers.len(), html! { table {
            caption { "Tool offsets" }
            thead {
                tr {
                    th scope="col" { "No." }
                    th scope="col" { "Tool" }
                    @if is_lathe {
                        th.n scope="col" { "X " (unit) }
                        th.n scope="col" { "Z " (unit) }
                        th.n scope="col" { "Nose radius " (unit) }
                        th.n scope="col" { "Tip" }
                    } @else {
                        th.n scope="col" { "H length " (unit) }
                        th.n scope="col" { "D diameter " (unit) }
                    }
                }
            }
            tbody {
                @for register in registers {
                    tr {
                        th scope="row" { (register.number) }
                        td { (tools_of(&register.tools)) }
                        @if is_lathe { (of_lathe(register, show)) } @else { (of_mill(register, show)) }
                    }
                }
            }
        } }))
        @for register in registers.iter().filter(|register| register.by_program) {
            p.faint { "Offset " (register.number) " is written by the program itself." }
        }
    }
}

fn of_mill(register: &Register, show: &NumberDisplay) -> Markup {
    let Register { uses_length, uses_radius, .. } = *register;
    html! {
        td.n { (offset_value(uses_length, register.length_mm.filter(|_| uses_length), show)) }
        td.n { (offset_value(uses_radius, register.diameter_mm.filter(|_| uses_radius), show)) }
    }
}

/// The nose and the tip are of the offset table whether compensation is used or not; a blank only where it is.
fn of_lathe(register: &Register, show: &NumberDisplay) -> Markup {
    let Register { uses_length, uses_radius, .. } = *register;
    html! {
        td.n { (offset_value(uses_length, register.x_mm, show)) }
        td.n { (offset_value(uses_length, register.length_mm, show)) }
        td.n { (offset_value(uses_radius, register.nose_radius_mm, show)) }
        td.n {
            @match register.tip {
                Some(tip) => (tip),
                None if uses_radius => (blank()),
                None => "–",
            }
        }
    }
}

fn tools_of(numbers: &[u32]) -> String {
    let names: Vec<String> = numbers.iter().map(|number| tool_name(*number)).collect();
    if names.is_empty() { "–".to_string() } else { names.join(", ") }
}

fn numbers(numbers: &[u32]) -> String {
    numbers.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
}

/// The tools in the order of their first use.
pub fn tools(document: &Document, show: &NumberDisplay) -> Markup {
    let unit = show.units.length_unit();
    let is_lathe = document.head.is_lathe;
    let sign = |number: u32| document.pictures.tools.iter().find(|tool| tool.number == number);
    html! {
        section aria-labelledby="tools" {
            h2 #tools { "Tools in order of use" }
            @if document.tools.rows.is_empty() {
                p { "No tool is called, and nothing is cut." }
            } @else {
                (scrolling("Tools", document.tools.rows.len(), html! { table {
                        thead {
                            tr {
                                th scope="col" { "Tool" }
                                th scope="col" { "What it is" }
                                @if is_lathe {
                                    th scope="col" { "Offset" }
                                    th.n scope="col" { "Nose radius " (unit) }
                                    th.n scope="col" { "Tip" }
                                    th.n scope="col" { "rpm" }
                                    th.n scope="col" { "Feed " (unit) " per rev" }
                                } @else {
                                    th scope="col" { "H" }
                                    th scope="col" { "D" }
                                    th.n scope="col" { "Ø " (unit) }
                                    th.n scope="col" { "rpm" }
                                    th.n scope="col" { "Feed " (show.units.feed_unit()) }
                                }
                                th.n scope="col" { "Lowest Z" }
                                th.n scope="col" { "Cuts " (unit) }
                                th scope="col" { "Coolant" }
                                th.n scope="col" { "Time" }
                            }
                        }
                        tbody {
                            @for tool in document.tools.rows.iter().take(MAX_TABLE_ROWS) {
                                tr {
                                    th scope="row" {
                                        span.sign {
                                            @if let Some(sign) = sign(tool.number) { (PreEscaped(&sign.svg)) }
                                            (tool_name(tool.number))
                                        }
                                    }
                                    td.words { (what(tool)) }
                                    td { (dash(&numbers(&tool.length_offsets))) }
                                    @if is_lathe {
                                        td.n { (dash(&nose(tool, show))) }
                                        td.n { (dash(&tool.tip.map(|tip| tip.to_string()).unwrap_or_default())) }
                                    } @else {
                                        td { (dash(&numbers(&tool.radius_offsets))) }
                                        td.n { (dash(&diameter(tool, show))) }
                                    }
                                    td.n { (spindle(tool)) }
                                    td.n { (feeds(&tool.feeds, is_lathe, show)) }
                                    td.n { (dash(&tool.lowest_z_mm.map(|z| show.units.coordinate(z)).unwrap_or_default())) }
                                    td.n { (show.units.length(tool.cut_mm)) }
                                    td { (dash(&tool.coolant.join(", "))) }
                                    td.n { (dash(&tool.time_s.map(duration).unwrap_or_default())) }
                                }
                            }
                        }
                    } }))
                (left_out(&document.tools, MAX_TABLE_ROWS, "tools"))
                @if document.tools.rows.iter().take(MAX_TABLE_ROWS).any(|tool| tool.by_comment) {
                    p { "* As a comment of the program says; the machine file gives no diameter. No offset is set by it." }
                }
            }
        }
    }
}

/// `.5`, with a star where a comment says it.
fn diameter(tool: &ReportedTool, show: &NumberDisplay) -> String {
    let star = if tool.by_comment { "*" } else { "" };
    tool.diameter_mm.map_or_else(String::new, |mm| format!("{}{star}", show.units.coordinate(mm)))
}

/// The nose radius of an insert, the diameter of a drill.
fn nose(tool: &ReportedTool, show: &NumberDisplay) -> String {
    match tool.nose_radius_mm {
        Some(mm) => show.units.coordinate(mm),
        None => {
            tool.diameter_mm.map_or_else(String::new, |_| format!("Ø {}", diameter(tool, show)))
        }
    }
}

fn dash(text: &str) -> &str {
    if text.is_empty() { "–" } else { text }
}

fn what(tool: &ReportedTool) -> Markup {
    html! {
        @match (&tool.comment, &tool.table) {
            (Some(comment), Some(table)) if comment != table => {
                (comment) br; span.faint { "tool table: " (table) }
            }
            (Some(text), _) | (None, Some(text)) => (text),
            (None, None) => "–",
        }
        @if tool.changes > 1 { " " span.faint { "(changed in " (grouped(tool.changes)) " times)" } }
    }
}

fn spindle(tool: &ReportedTool) -> Markup {
    let turns = match (tool.clockwise, tool.counterclockwise) {
        (true, true) => "M3, M4",
        (true, false) => "M3",
        (false, true) => "M4",
        (false, false) => "",
    };
    html! {
        @match tool.rpm {
            Some(range) => { (span_of(range, |rpm| short(rpm, 1))) " " span.faint { (turns) } }
            None => "–",
        }
    }
}

/// What is not in the unit of the column has its own: feed per revolution on a lathe, per minute on a mill.
fn feeds(feeds: &FeedRange, is_lathe: bool, show: &NumberDisplay) -> Markup {
    let decimals = match show.units {
        SummaryUnits::Inch => 5,
        SummaryUnits::Millimetre => 4,
    };
    let per_rev = |mm: f64| short(mm / show.units.length_mm(), decimals);
    let per_minute_unit =
        if is_lathe { format!(" {}", show.units.feed_unit()) } else { String::new() };
    let mut parts = Vec::new();
    if let Some(range) = feeds.mm_per_rev.filter(|_| is_lathe) {
        parts.push(span_of(range, per_rev));
    }
    if let Some(range) = feeds.mm_per_min {
        let text = span_of(range, |mm_per_min| show.units.feed(mm_per_min / 60.0));
        parts.push(format!("{text}{per_minute_unit}"));
    }
    if let Some(range) = feeds.mm_per_rev.filter(|_| !is_lathe) {
        parts.push(format!("{} per rev", span_of(range, per_rev)));
    }
    if feeds.inverse_time {
        parts.push("by time (G93)".to_string());
    }
    html! { (dash(&parts.join("; "))) }
}

/// `100`, or `100–250`.
fn span_of((low, high): (f64, f64), text: impl Fn(f64) -> String) -> String {
    let (low, high) = (text(low), text(high));
    if low == high { low } else { format!("{low}–{high}") }
}

/// Where the tool goes.
pub fn travel(document: &Document, show: &NumberDisplay) -> Markup {
    html! {
        section aria-labelledby="travel" {
            h2 #travel { "Travel" }
            @if document.travel.rows.is_empty() {
                p { "No move is at a known position relative to the part." }
            } @else {
                (scrolling("Travel by work offset", 3 * document.travel.rows.len(), html! { table {
                        thead {
                            tr {
                                th scope="col" { "Program coordinates" }
                                th scope="col" { "Axis" }
                                th.n scope="col" { "Cuts from" }
                                th.n scope="col" { "to" }
                                th.n scope="col" { "All moves from" }
                                th.n scope="col" { "to" }
                                th scope="col" { "" span.hidden { "Unit" } }
                                th.n scope="col" { "Zero may be at" }
                            }
                        }
                        tbody {
                            @for travel in document.travel.rows.iter().take(MAX_TABLE_ROWS) {
                                @for (index, axis) in travel.axes.iter().enumerate() {
                                    tr {
                                        @if index == 0 {
                                            th scope="rowgroup" rowspan=(travel.axes.len()) {
                                                (travel.name)
                                                @if let Some(line) = travel.moved_at {
                                                    br; span.faint { "moved, line " (line) }
                                                }
                                            }
                                        }
                                        (range(axis, show))
                                    }
                                }
                            }
                        }
                    } }))
                (left_out(&document.travel, MAX_TABLE_ROWS, "changes of work offsets"))
            }
            @if document.travel.rows.iter().any(|t| t.axes.iter().any(|a| a.zero_may_lie.is_some())) {
                p.faint {
                    "“Zero may be at”: the values of a work offset, in machine coordinates, with which all its "
                    "moves stay within the machine's travel."
                }
            }
            @if !document.machine_travel.is_empty() { (machine(&document.machine_travel, show)) }
        }
    }
}

fn range(axis: &AxisRange, show: &NumberDisplay) -> Markup {
    let place = |value: f64| show.place(axis.axis, value);
    html! {
        td { (axis.axis) }
        @match axis.cuts {
            Some((low, high)) => { td.n { (place(low)) } td.n { (place(high)) } }
            None => { td.n { "–" } td.n { "–" } }
        }
        td.n { (place(axis.all.0)) }
        td.n { (place(axis.all.1)) }
        td { (show.unit(axis.axis)) }
        td.n {
            @match axis.zero_may_lie {
                Some((low, high)) if low <= high => { (place(low)) " to " (place(high)) }
                Some(_) => "nowhere: too large for the machine",
                None => "",
            }
        }
    }
}

fn machine(axes: &[MachineTravel], show: &NumberDisplay) -> Markup {
    html! {
        div.keep {
            h3 { "Check of the machine's travel" }
            (scrolling("Machine travel", axes.len(), html! { table {
                thead {
                    tr {
                        th scope="col" { "Axis" }
                        th.n scope="col" { "Travel from" }
                        th.n scope="col" { "to" }
                        th.n scope="col" { "Goes from" }
                        th.n scope="col" { "to" }
                        th scope="col" { "" span.hidden { "Unit" } }
                        th scope="col" { "" span.hidden { "Remark" } }
                    }
                }
                tbody {
                    @for axis in axes {
                        @let place = |value: f64| show.place(axis.axis, value);
                        tr {
                            th scope="row" { (axis.axis) }
                            td.n { (place(axis.limits.0)) }
                            td.n { (place(axis.limits.1)) }
                            @match axis.goes {
                                Some((low, high)) => { td.n { (place(low)) } td.n { (place(high)) } }
                                None => { td.n { "–" } td.n { "–" } }
                            }
                            td { (show.unit(axis.axis)) }
                            td { (remark(axis)) }
                        }
                    }
                }
            } }))
        }
    }
}

fn remark(axis: &MachineTravel) -> &'static str {
    let (low, high) = axis.limits;
    let slack = 1e-6;
    match axis.goes {
        Some((from, to)) if from < low - slack || to > high + slack => {
            "beyond the machine's travel"
        }
        _ if axis.partly_unknown => "not all known: an offset is not set",
        _ => "within",
    }
}
