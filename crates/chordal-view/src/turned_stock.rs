//! The stock of a lathe: its exact cross-section after every pass, as lines and arcs with the moves at which they
//! appear and disappear, then the collisions and the cutting loads.

use std::collections::BTreeMap;

use chordal::Job;
use chordal::diagnostics::Code;
use chordal::stock::section::{OutlineSegment, Region};
use chordal::stock::{
    StockRunError, TurnedMove, TurnedOptions, TurnedReplay, TurnedReport, TurnedShape,
};
use serde_json::{Value, json};

use crate::answer;
use crate::frame::ColumnFrame;
use crate::outbox::PageOutbox;
use crate::program::ProgramSource;

/// Sends the sections of a run, its problems and its cutting loads.
pub fn run(job: &Job, run: u64, programs: &dyn ProgramSource, out: &PageOutbox) {
    let files = |name: &str| programs.named_file(name);
    let options = TurnedOptions { replay: true, ..TurnedOptions::default() };
    match job.turned_stock(&options, &files) {
        Ok(found) => {
            if let Some(replay) = &found.replay {
                out.binary(sections(run, &found, replay));
            }
            out.json(&report_json(run, &found, job));
            out.binary(engagement(run, &found));
        }
        Err(StockRunError::Interrupted) => {}
        Err(error) => out.json(&answer::no_stock(run, &error)),
    }
}

/// A line or an arc as numbers: both ends and the centre (Z and radius, mm), and the direction: 0 straight, 1
/// counterclockwise (from +Z to +radius), −1 clockwise.
fn numbers(segment: &OutlineSegment) -> [f64; 7] {
    let OutlineSegment { start, end, bend, .. } = segment;
    let (center, turn) = match bend {
        None => (*start, 0.0),
        Some(bend) => (bend.center, if bend.counterclockwise { 1.0 } else { -1.0 }),
    };
    [start.a, start.b, end.a, end.b, center.a, center.b, turn]
}

/// Closed outlines, each as the concatenated numbers of its segments.
fn loops(outline: &[Vec<OutlineSegment>]) -> Value {
    outline.iter().map(|segments| segments.iter().flat_map(numbers).collect::<Vec<_>>()).collect()
}

fn shape(region: &Region) -> Value {
    loops(&region.shape())
}

fn tools(tools: &BTreeMap<u32, TurnedShape>) -> Value {
    let tool = |(number, shape): (&u32, &TurnedShape)| json!({ "number": number, "edges": loops(&shape.edges), "body": loops(&shape.body) });
    tools.iter().map(tool).collect()
}

fn sections(run: u64, found: &TurnedReport, replay: &TurnedReplay) -> Vec<u8> {
    let mut frame = ColumnFrame::default();
    let pieces = &replay.pieces;
    let lines: Vec<f32> =
        pieces.iter().flat_map(|piece| numbers(&piece.segment)).map(|each| each as f32).collect();
    frame.column("lines", &lines);
    frame.column("from", &pieces.iter().map(|piece| piece.from).collect::<Vec<_>>());
    frame.column("until", &pieces.iter().map(|piece| piece.until).collect::<Vec<_>>());
    frame.column("tool", &pieces.iter().map(|piece| piece.segment.tag).collect::<Vec<_>>());
    frame.column("loose", &pieces.iter().map(|piece| u8::from(piece.is_loose)).collect::<Vec<_>>());
    frame.column("rows", &replay.rows);
    let fixtures = replay
        .fixtures
        .iter()
        .map(|(name, section)| json!({ "name": name, "loops": shape(section) }));
    let threads = found
        .threads
        .iter()
        .map(|thread| (thread.row, thread.grooves.as_ref().unwrap_or(&thread.section)))
        .map(|(row, section)| json!({ "row": row, "loops": shape(section) }));
    frame.finish(json!({
        "type": "turned",
        "run": run,
        "whole": replay.is_whole,
        "before": shape(&found.before),
        "target": found.target_section.as_ref().map(shape),
        "fixtures": fixtures.collect::<Vec<_>>(),
        "threads": threads.collect::<Vec<_>>(),
        "tools": tools(&replay.tools),
    }))
}

/// The remaining stock, the collisions and their positions, together with the problems of the run, because the page
/// lists all in one list.
fn report_json(run: u64, found: &TurnedReport, job: &Job) -> Value {
    let between = |amount: chordal::stock::VolumeInterval| json!({ "least": amount.least, "most": amount.most });
    let problems = found.problems.iter().map(|problem| {
        json!({ "code": problem.code.info().id, "line": problem.line, "at": [problem.at.z, problem.at.x] })
    });
    let mut message = answer::report(&found.report, job);
    message["type"] = json!("turned_report");
    message["run"] = json!(run);
    message["verdict"] = json!(found.verdict.as_str());
    message["removed_mm3"] = between(found.removed_mm3);
    message["left_mm3"] = between(found.left_mm3);
    message["parts_off"] = json!(found.loose.len());
    message["problems"] = problems.collect();
    message
}

/// The loads of the moves that cut; -1 is an unknown value.
fn engagement(run: u64, found: &TurnedReport) -> Vec<u8> {
    let cuts: Vec<&TurnedMove> =
        found.moves.iter().filter(|each| each.area_mm2 > 0.0 && !each.is_thread).collect();
    let column = |of: &dyn Fn(&TurnedMove) -> f64| -> Vec<f32> {
        cuts.iter().map(|each| of(each) as f32).collect()
    };
    let problem = |each: &&TurnedMove| match each.overload {
        None => 0,
        Some(Code::SpindleOverloaded) => 3u8,
        Some(_) => 1,
    };
    let mut frame = ColumnFrame::default();
    frame.column("row", &cuts.iter().map(|each| each.row).collect::<Vec<_>>());
    frame.column("radial", &column(&|each| each.depth_mm));
    frame.column("chip", &column(&|each| each.chip_mm.unwrap_or(-1.0)));
    frame.column("power", &column(&|each| each.power_kw.unwrap_or(-1.0)));
    frame.column("problem", &cuts.iter().map(problem).collect::<Vec<_>>());
    frame.finish(json!({ "type": "engagement", "run": run, "turning": true, "whole": true }))
}
