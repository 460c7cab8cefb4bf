//! What a run comes to, as a machinist would ask for it.

use std::collections::{BTreeMap, BTreeSet};

use chordal::control::{EndReason, EvidenceStrength, ProgramName, Recognition};
use chordal::diagnostics::FileId;
use chordal::machine::ToolShape;
use chordal::motion::MotionReport;
use chordal::time::TimedRun;
use chordal::tool_comments::{KnownTool, known_tools};
use chordal::{AxisTravel, Diagnostic, Job, Report, Severity, Summary, ToolUse};
use chordal_export::{GIVE_OFFSETS, left_out_texts};
use chordal_load::{Loaded, MachineReason};
use chordal_report::title;
use comfy_table::{CellAlignment, Table};

use crate::numbers::{SummaryUnits, counted, duration, fixed, grouped, short};
use crate::sheet::Sheet;
use crate::terminal::BOLD_RED;

/// Most programs, evidence, line ranges and speeds that are listed.
const MAX_PROGRAMS: usize = 12;

/// Most lines of the program's own output that are shown.
const MAX_PRINTED: usize = 20;
const MAX_EVIDENCE: usize = 4;
const MAX_RANGES: usize = 4;
const MAX_SPEEDS: usize = 4;
const MAX_TOOLS: usize = 8;
const MAX_NOTICES: usize = 4;

/// The summary as text.
pub fn text(
    loaded: &Loaded,
    job: &Job,
    report: &Report,
    timed: Option<&TimedRun>,
    color: bool,
) -> String {
    let units = SummaryUnits::of(report.summary.inch);
    let mut sheet = Sheet::new(loaded.name(), None, color);
    programs(&mut sheet, job, loaded.program);
    machine(&mut sheet, job, &loaded.chosen);
    for notice in job.machine().notices.0.iter().take(MAX_NOTICES) {
        sheet.row("note", &notice.to_string());
        notice.help.iter().for_each(|help| sheet.more(help));
    }
    sheet.row("units", if report.summary.inch { "inch" } else { "millimetres" });
    let summary = &report.summary;
    let known = known_tools(job);
    sheet.table("", &tools(&summary.tools, units, job, &known));
    let by_comment = by_comment(&summary.tools, &known);
    sheet.table("", &axes(&summary.axes, units));
    let left_out = left_out_texts(&summary.unrelated_zeros, job.profile().work_names);
    if !left_out.is_empty() {
        sheet.gap();
        sheet.rows("note", &left_out);
    }
    if summary.unrelated_zeros.iter().any(|zero| !zero.is_preset) {
        sheet.more(GIVE_OFFSETS);
    }
    sheet.gap();
    if !by_comment.is_empty() {
        let text = format!("{by_comment} from comments in the program; comments set no offset");
        sheet.row("tools", &text);
    }
    sheet.row("moves", &moves(summary, report.outcomes.iter().map(|run| run.blocks).sum()));
    let (cuts, rapids) = (summary.feed_length_mm, summary.rapid_length_mm);
    let unit = units.length_unit();
    let lengths =
        format!("{} {unit} of cuts, {} {unit} of rapids", units.length(cuts), units.length(rapids));
    sheet.row("lengths", &lengths);
    match timed.filter(|timed| timed.time.moves > 0) {
        Some(timed) => {
            sheet.row("time", &planned_time(timed));
            sheet.more(&at_feed(summary));
        }
        None => sheet.row("time", &time(summary)),
    }
    printed(&mut sheet, report);
    end(&mut sheet, job, report);
    sheet.into_text()
}

/// The second line under a picture: machine, units, time.
pub fn subtitle(job: &Job, report: &Report, timed: Option<&TimedRun>) -> String {
    let units = if report.summary.inch { "inch" } else { "mm" };
    let time = match timed {
        Some(timed) => duration(timed.time.total_s()),
        None => format!("{} without acceleration", duration(report.summary.total_time_s())),
    };
    format!("{}, {units}, {time}", job.machine().title)
}

/// The programs that are run, then those that they can call.
fn programs(sheet: &mut Sheet, job: &Job, program: Option<u32>) {
    let set = job.program_set();
    let programs = set.programs();
    let mains: Vec<usize> = match program {
        Some(number) => set.find(number).into_iter().collect(),
        None => (0..programs.len()).filter(|index| programs[*index].is_main).collect(),
    };
    let shown = |index: &usize| {
        let program = &programs[*index];
        let source = job.sources().get(program.file);
        let text = source.map_or(&[][..], |source| source.text());
        let name = program.name.as_ref();
        let name = name.map_or_else(|| "without a number".into(), ProgramName::to_string);
        let title = title(text, program.head.end as usize);
        let title = title.map_or_else(String::new, |title| format!(" ({title})"));
        let from = match source {
            Some(source) if program.file != FileId(0) => format!(" from {}", source.name()),
            _ => String::new(),
        };
        format!("{name}{title}{from}")
    };
    let list = |indices: &[usize]| {
        let mut rows: Vec<String> = indices.iter().take(MAX_PROGRAMS).map(shown).collect();
        if indices.len() > MAX_PROGRAMS {
            rows.push(format!("and {} more", indices.len() - MAX_PROGRAMS));
        }
        rows
    };
    let is_main: BTreeSet<usize> = mains.iter().copied().collect();
    let others: Vec<usize> = (0..programs.len()).filter(|index| !is_main.contains(index)).collect();
    sheet.rows(if mains.len() == 1 { "program" } else { "programs" }, &list(&mains));
    sheet.rows("calls", &list(&others));
}

fn machine(sheet: &mut Sheet, job: &Job, chosen: &MachineReason) {
    let (machine, control) = (job.machine(), job.profile());
    let known = if machine.title == machine.name {
        machine.name.clone()
    } else {
        format!("{} ({})", machine.title, machine.name)
    };
    match chosen {
        MachineReason::Requested => {
            sheet.row("control", control.title);
            sheet.row("machine", &known);
        }
        MachineReason::Folder(file) => {
            sheet.row("control", control.title);
            sheet.row("machine", &format!("{known}, from {}", file.display()));
        }
        MachineReason::Ending => {
            sheet.row("control", &format!("{}, because of the file extension", control.title));
            sheet.row("machine", &format!("{known}; say --machine for another"));
        }
        MachineReason::Recognized(found, _) if found.strength() == EvidenceStrength::Assumed => {
            sheet.row(
                "control",
                &format!("{}, assumed: nothing in the text says which control", control.title),
            );
            sheet.row("machine", &format!("{known}; say --machine for another"));
        }
        MachineReason::Recognized(found, _) => recognized(sheet, found, control.title, &known),
    }
}

/// The control by its signs, and what it may be instead.
fn recognized(sheet: &mut Sheet, found: &Recognition, title: &str, machine: &str) {
    let chosen = found.chosen();
    let title = if chosen.not_read { chosen.title } else { title };
    let sure = match found.strength() {
        EvidenceStrength::Weak => "probable",
        EvidenceStrength::Sure | EvidenceStrength::Likely | EvidenceStrength::Assumed => {
            "recognized"
        }
    };
    sheet.row("control", &format!("{title}, {sure}:"));
    let signs: Vec<_> = found.evidence().collect();
    for sign in signs.iter().take(MAX_EVIDENCE) {
        sheet.more(&format!("line {}: {}", sign.line, sign.sign));
    }
    if signs.len() > MAX_EVIDENCE {
        sheet.more(&format!("and {} more signs", signs.len() - MAX_EVIDENCE));
    }
    if let Some(next) = found.runner_up().filter(|_| !chosen.not_read) {
        sheet.more(&format!("next to it {}", next.title));
    }
    if chosen.not_read {
        sheet.row("machine", "none; say --machine to read it as that machine would");
    } else {
        sheet.row("machine", &format!("{machine}; say --machine for another"));
    }
}

/// What the program prints.
fn printed(sheet: &mut Sheet, report: &Report) {
    let lines: Vec<String> = report.output.iter().take(MAX_PRINTED).cloned().collect();
    sheet.rows("prints", &lines);
    let more = report.output.len().saturating_sub(MAX_PRINTED);
    if more > 0 {
        sheet.more(&format!("and {more} more lines; `-o NAME.txt` writes all of them"));
    }
}

/// Where the control would stop, or how the program ends.
fn end(sheet: &mut Sheet, job: &Job, report: &Report) {
    let first = report.diagnostics.iter().filter(|d| d.severity == Severity::Error);
    if let Some(first) = first.min_by_key(|diagnostic| call_order(diagnostic)) {
        let what = match &first.alarm {
            Some(alarm) => {
                let title = job.profile().title;
                let own = alarm.strip_prefix(title).and_then(|rest| rest.strip_prefix(": "));
                let alarm = own.unwrap_or(alarm);
                format!("the control would stop at {}: {alarm}", place(first, job))
            }
            None => format!("first error at {}: {}", place(first, job), first.message),
        };
        sheet.row_in(BOLD_RED, "stop", &what);
    } else if report.outcomes.iter().any(|outcome| outcome.end == EndReason::Repeats) {
        sheet.row("end", "M99: the control would start again");
    }
}

/// The order in which a run comes by: the place of the outermost call first.
fn call_order(diagnostic: &Diagnostic) -> Vec<u32> {
    let calls = diagnostic.calls.iter().rev().map(|call| call.range.start);
    calls.chain([diagnostic.primary.span.range.start]).collect()
}

fn place(diagnostic: &Diagnostic, job: &Job) -> String {
    let span = diagnostic.primary.span;
    let Some(source) = job.sources().get(span.file) else { return String::new() };
    let line = format!("line {}", source.line_of(span.range.start));
    if span.file == FileId(0) { line } else { format!("{line} of {}", source.name()) }
}

/// A table without lines, its first columns to the left and the others to the right.
pub fn plain_table(header: &[&str], left: usize) -> Table {
    let mut table = Table::new();
    table.load_style(comfy_table::presets::NOTHING).set_header(header.to_vec());
    for (index, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, 2));
        if index >= left {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

/// The tools of which a comment gave the size or the shape: `T1, T3`.
fn by_comment(tools: &[ToolUse], known: &BTreeMap<u32, KnownTool>) -> String {
    let stated =
        |tool: &&ToolUse| known.get(&tool.number).is_some_and(|known| known.comment.is_some());
    let mut names: Vec<String> = tools
        .iter()
        .filter(stated)
        .take(MAX_TOOLS + 1)
        .map(|tool| format!("T{}", tool.number))
        .collect();
    if names.len() > MAX_TOOLS {
        names[MAX_TOOLS] = "others".to_string();
    }
    names.join(", ")
}

/// `T5 end mill` by the machine file, else `T5 flat 0.5 in` by a comment.
fn tool_description(
    number: u32,
    job: &Job,
    units: SummaryUnits,
    known: &BTreeMap<u32, KnownTool>,
) -> String {
    let name = tool_name(number, job);
    let Some(KnownTool { tool, comment: Some(_), .. }) = known.get(&number) else { return name };
    let named = job.machine().tools.get(&number).is_some_and(|tool| tool.label().is_some());
    let shape = tool.shape.filter(|_| !named).map_or("", ToolShape::as_str);
    let size =
        tool.diameter_mm.map(|mm| format!("{} {}", units.coordinate(mm), units.length_unit()));
    let parts = [name.as_str(), shape, size.as_deref().unwrap_or("")];
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ")
}

fn tools(
    tools: &[ToolUse],
    units: SummaryUnits,
    job: &Job,
    known: &BTreeMap<u32, KnownTool>,
) -> Table {
    let (feed, cuts) =
        (format!("feed {}", units.feed_unit()), format!("cuts {}", units.length_unit()));
    let mut table = plain_table(&["tool", "lines", &feed, "rpm", &cuts, "time"], 2);
    for tool in tools {
        table.add_row([
            tool_description(tool.number, job, units, known),
            ranges(&tool.lines),
            tool.feeds_mm_per_s.map_or_else(
                || "-".into(),
                |(low, high)| {
                    let (low, high) = (units.feed(low), units.feed(high));
                    if low == high { low } else { format!("{low} to {high}") }
                },
            ),
            speeds(&tool.speeds_rpm),
            units.length(tool.feed_length_mm),
            duration(tool.feed_time_s + tool.rapid_time_s),
        ]);
    }
    table
}

/// `T5 end mill`, as the machine file calls it.
pub fn tool_name(number: u32, job: &Job) -> String {
    let known = job.machine().tools.get(&number);
    let known = known.and_then(|known| known.label());
    match (number, known) {
        (0, _) => "none yet".to_string(),
        (number, Some(known)) => format!("T{number} {known}"),
        (number, None) => format!("T{number}"),
    }
}

fn ranges(lines: &[(u32, u32)]) -> String {
    let mut shown: Vec<String> = lines
        .iter()
        .take(MAX_RANGES)
        .map(|(first, last)| match first == last {
            true => first.to_string(),
            false => format!("{first}-{last}"),
        })
        .collect();
    if lines.len() > MAX_RANGES {
        shown.push(format!("and {} more", lines.len() - MAX_RANGES));
    }
    shown.join(", ")
}

fn speeds(speeds: &[f64]) -> String {
    let low = speeds.iter().copied().fold(f64::INFINITY, f64::min);
    let high = speeds.iter().copied().fold(0.0, f64::max);
    match speeds {
        [] => "-".into(),
        few if few.len() <= MAX_SPEEDS => {
            few.iter().map(|rpm| short(*rpm, 1)).collect::<Vec<_>>().join(", ")
        }
        _ => format!("{} to {}", short(low, 1), short(high, 1)),
    }
}

fn axes(axes: &[AxisTravel], units: SummaryUnits) -> Table {
    let mut table = plain_table(&["axis", "from", "to", "cuts from", "to", ""], 1);
    if let Some(column) = table.column_mut(5) {
        column.set_cell_alignment(CellAlignment::Left);
    }
    for axis in axes {
        let rotary = matches!(axis.letter, 'A' | 'B' | 'C');
        let number = |value: f64| match rotary {
            true => fixed(value.to_degrees(), 3),
            false => units.coordinate(value),
        };
        let (from, to) = axis.range;
        let cut = |value: Option<f64>| value.map_or_else(|| "-".to_string(), number);
        table.add_row([
            axis.letter.to_string(),
            number(from),
            number(to),
            cut(axis.cut_range.map(|range| range.0)),
            cut(axis.cut_range.map(|range| range.1)),
            if rotary { "deg" } else { units.length_unit() }.to_string(),
        ]);
    }
    table
}

fn moves(summary: &Summary, blocks: u64) -> String {
    let mut parts = Vec::new();
    for (number, one, many) in [
        (summary.lines, "line", "lines"),
        (summary.arcs, "arc", "arcs"),
        (summary.helices, "helix", "helices"),
        (summary.spirals, "spiral", "spirals"),
        (summary.splines, "spline", "splines"),
        (summary.rapids, "rapid", "rapids"),
        (summary.dwells, "dwell", "dwells"),
    ] {
        if number > 0 {
            parts.push(counted(number, one, many));
        }
    }
    let moves = if parts.is_empty() { "none".to_string() } else { parts.join(", ") };
    format!("{moves}, in {} blocks", grouped(blocks))
}

/// The time of a program too long to be planned here.
fn time(summary: &Summary) -> String {
    let total = duration(summary.total_time_s());
    let about = if total.starts_with("under") { "" } else { "about " };
    let parts = parts(&[
        ("cuts", summary.feed_time_s),
        ("rapids", summary.rapid_time_s),
        ("dwells", summary.dwell_time_s),
    ]);
    let missing = missing(summary);
    format!("{about}{total} without acceleration and tool changes{parts}{missing}")
}

/// What the times of a run are with.
pub fn motion_law(motion: &MotionReport) -> &'static str {
    match motion.limits.junctions {
        Some(_) => "with acceleration",
        None => "with acceleration and jerk",
    }
}

/// The time as the machine's axes can do it.
fn planned_time(timed: &TimedRun) -> String {
    let (time, times) = (&timed.time, &timed.time.times);
    let mut shares = vec![("cuts", times.cutting_s), ("rapids", times.rapid_s)];
    shares.extend(time.waits.iter().map(|(kind, seconds)| (kind.name(), *seconds)));
    let total = duration(time.total_s());
    let how = motion_law(&timed.motion);
    format!("{total}, {how}{}", parts(&shares))
}

/// What the moves would take without speeding up and slowing down.
fn at_feed(summary: &Summary) -> String {
    let moving = duration(summary.feed_time_s + summary.rapid_time_s);
    format!("the moves without acceleration: {moving}{}", missing(summary))
}

fn parts(shares: &[(&str, f64)]) -> String {
    let parts: Vec<String> = shares
        .iter()
        .filter(|(_, seconds)| *seconds > 0.0)
        .map(|(what, seconds)| format!("{what} {}", duration(*seconds)))
        .collect();
    if parts.is_empty() { String::new() } else { format!(": {}", parts.join(", ")) }
}

fn missing(summary: &Summary) -> String {
    match summary.cuts_without_time {
        0 => String::new(),
        some => format!("; {} without a feed not counted", counted(some, "cut", "cuts")),
    }
}
