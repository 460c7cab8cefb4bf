//! Problems as one JSON object.

use chordal::control::Recognition;
use chordal::diagnostics::{Applicability, Fix};
use chordal::{Diagnostic, ProgramReading, ReadingChoices, Report, SourceMap, Span};
use serde_json::{Map, Value, json};

use super::place::{call_text, place};

/// The members of the object that say on what the program was read.
fn insert_reading(
    object: &mut Map<String, Value>,
    reading: &ProgramReading<'_>,
    sources: &SourceMap<'_>,
) {
    let found = reading.recognition;
    let signs = found.into_iter().flat_map(Recognition::evidence);
    let evidence: Value = signs
        .map(|sign| json!({ "sign": sign.sign, "line": sign.line, "weight": sign.weight }))
        .collect();
    let next = found
        .and_then(Recognition::runner_up)
        .map(|next| json!({ "control": next.name, "weight": next.weight, "errors": next.errors }));
    object.insert("machine".into(), json!(reading.machine));
    object.insert("control".into(), reading.control.into());
    object.insert("control_from".into(), reading.from.into());
    let strength = found.map(|found| found.strength().as_str());
    object.insert("control_strength".into(), json!(strength));
    object.insert("control_evidence".into(), evidence);
    object.insert("runner_up".into(), json!(next));
    if let Some(choices) = &reading.choices {
        object.insert("readings".into(), readings_value(choices, sources));
    }
}

/// As what a text may be read that does not name its control and its units for certain: the member `readings` of
/// that object.
fn readings_value(choices: &ReadingChoices, sources: &SourceMap) -> Value {
    let readings = choices.readings.iter().map(|reading| {
        let settings = reading.settings.iter().map(|setting| setting.assignment);
        json!({
            "title": reading.title,
            "control": reading.controls.first(),
            "controls": reading.controls,
            "machine": reading.machine,
            "units": reading.units(),
            "settings": settings.collect::<Value>(),
            "size_mm": reading.size_mm,
            "motion": reading.motion,
            "option": reading.option,
        })
    });
    let difference = choices.difference.as_ref().map(|at| {
        let line = place(at.span, sources).map(|place| place.start.line);
        json!({ "line": line, "only_feed": at.only_feed })
    });
    json!({ "possible": readings.collect::<Value>(), "difference": difference })
}

/// All problems of a run as one JSON object, schema `chordal.diagnostics/1`; `file` is the
/// name of the program. Lines and columns count from 1, columns in characters; ends are one
/// past the last. `start` and `end` are offsets in bytes.
pub fn json(
    report: &Report,
    sources: &SourceMap,
    file: &str,
    reading: &ProgramReading<'_>,
) -> String {
    let object = problems("chordal.diagnostics/1", report, sources, file, reading);
    format!("{:#}\n", Value::Object(object))
}

/// The objects of several programs, or of one, as one object under the name of their schema:
/// `chordal.check/1`, `chordal.run/1`.
pub fn files_json(schema: &str, objects: &[String]) -> String {
    let objects: Vec<&str> = objects.iter().map(|object| object.trim_end()).collect();
    format!("{{\"schema\":\"{schema}\",\"files\":[\n{}\n]}}\n", objects.join(",\n"))
}

/// The members of that object, under the name of a schema.
pub(super) fn problems(
    schema: &str,
    report: &Report,
    sources: &SourceMap,
    file: &str,
    reading: &ProgramReading<'_>,
) -> Map<String, Value> {
    let diagnostics: Vec<Value> =
        report.diagnostics.iter().map(|diagnostic| problem(diagnostic, sources)).collect();
    let dropped: Vec<Value> = report
        .dropped
        .iter()
        .map(|(code, count)| json!({ "code": code.id(), "name": code.info().name, "count": count }))
        .collect();
    let head = json!({ "schema": schema, "file": file });
    let found = json!({
        "counts": {
            "errors": report.counts.errors,
            "warnings": report.counts.warnings,
            "notes": report.counts.notes,
        },
        "verified": report.verified(),
        "not_verified_from": report.not_verified_line(sources).map(|(file, line)| json!({ "file": file, "line": line })),
        "other_sides": {
            "run": places(&report.other_sides.run, sources),
            "left_out": places(&report.other_sides.left_out, sources),
            "block_delete": report.other_sides.block_delete,
        },
        "diagnostics": diagnostics,
        "dropped": dropped,
    });
    let mut object = Map::new();
    object.extend(members(head));
    insert_reading(&mut object, reading, sources);
    object.extend(members(found));
    object
}

/// Where things begin: files and lines.
fn places(spans: &[Span], sources: &SourceMap) -> Vec<Value> {
    let place = |span: &Span| {
        let source = sources.get(span.file)?;
        Some(json!({ "file": source.name(), "line": source.line_of(span.range.start) }))
    };
    spans.iter().filter_map(place).collect()
}

/// The members of an object.
fn members(value: Value) -> Map<String, Value> {
    match value {
        Value::Object(members) => members,
        _ => Map::new(),
    }
}

fn problem(diagnostic: &Diagnostic, sources: &SourceMap) -> Value {
    let mut object = Map::new();
    object.insert("code".into(), diagnostic.code.id().into());
    object.insert("name".into(), diagnostic.code.info().name.into());
    object.insert("severity".into(), diagnostic.severity.word().into());
    object.insert("message".into(), diagnostic.message.as_str().into());
    insert_place(&mut object, diagnostic.primary.span, sources);
    object.insert("label".into(), diagnostic.primary.text.as_str().into());
    let secondary = diagnostic.secondary.iter().map(|label| {
        let mut inner = Map::new();
        insert_place(&mut inner, label.span, sources);
        inner.insert("label".into(), label.text.as_str().into());
        Value::Object(inner)
    });
    object.insert("secondary".into(), secondary.collect());
    object.insert("alarm".into(), json!(diagnostic.alarm));
    object.insert("notes".into(), json!(diagnostic.notes));
    object.insert("help".into(), json!(diagnostic.help));
    let fix = diagnostic.fix.as_ref().map(|fix| fix_object(fix, sources));
    object.insert("fix".into(), json!(fix));
    let others = diagnostic.other_fixes.iter().map(|fix| fix_object(fix, sources));
    object.insert("other_fixes".into(), others.collect());
    let calls = diagnostic.calls.iter().map(|call| call_object(*call, sources));
    object.insert("calls".into(), calls.collect());
    Value::Object(object)
}

/// File, lines, columns and offsets; null for a problem of the program as a whole.
fn insert_place(object: &mut Map<String, Value>, span: Span, sources: &SourceMap) {
    let place = place(span, sources);
    let known = place.is_some();
    let name = sources.get(span.file).map(|source| source.name());
    object.insert("file".into(), json!(name));
    object.insert("line".into(), json!(place.as_ref().map(|at| at.start.line)));
    object.insert("column".into(), json!(place.as_ref().map(|at| at.start.column)));
    object.insert("end_line".into(), json!(place.as_ref().map(|at| at.end.line)));
    object.insert("end_column".into(), json!(place.as_ref().map(|at| at.end.column)));
    object.insert("start".into(), json!(known.then_some(span.range.start)));
    object.insert("end".into(), json!(known.then_some(span.range.end)));
}

fn fix_object(fix: &Fix, sources: &SourceMap) -> Value {
    json!({
        "title": fix.title,
        "replacement": fix.replacement,
        "applicability": match fix.applicability {
            Applicability::Safe => "safe",
            Applicability::Unsafe => "unsafe",
        },
        "file": sources.get(fix.span.file).map(|source| source.name()),
        "start": fix.span.range.start,
        "end": fix.span.range.end,
    })
}

fn call_object(call: Span, sources: &SourceMap) -> Value {
    let place = place(call, sources);
    json!({
        "file": place.as_ref().map(|at| at.file),
        "line": place.as_ref().map(|at| at.start.line),
        "text": call_text(call, sources),
    })
}
