//! Commands, path, time and setpoints of programs.

use std::io;

use chordal::motion::{MotionOptions, SamplingError, SamplingRequest};
use chordal::time::{RepeatPlanning, TimeQuestion};
use chordal::{Job, Report};
use chordal_export::columns::{CommandColumns, PathColumns, SampleColumns};
use chordal_export::format::{
    QUESTION_COMMANDS, QUESTION_JSON, QUESTION_OBJECT, QUESTION_PATH, QUESTION_SETPOINTS,
};
use chordal_export::{
    CommandWriter, FormatList, OutputFormat, SampleHead, SampleWriter, report, time_json,
    write_unless_failed,
};
use chordal_load::Loaded;
use serde_json::{Value, json};

use crate::answer::{QuestionAnswer, QuestionFailure};
use crate::columns::table;
use crate::load_request::LoadRequest;
use crate::options::{FormatOptions, SampleOptions, TimeOptions};

pub fn commands(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    command_rows(request, &QUESTION_COMMANDS, false)
}

pub fn path(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    command_rows(request, &QUESTION_PATH, true)
}

/// Commands as programmed, or with `of_path` those of the tool centre after cutter compensation.
fn command_rows(
    request: &mut LoadRequest,
    list: &FormatList,
    of_path: bool,
) -> Result<QuestionAnswer, QuestionFailure> {
    let FormatOptions { format } = request.options()?;
    let loaded = request.load()?;
    let job = loaded.job()?;
    request.require_format(list, format)?;
    if format == OutputFormat::Object {
        let mut columns = CommandColumns::of(&job, of_path);
        let run_report = if of_path {
            job.report_of_path(|path, _| columns.path_command(path))
        } else {
            job.report_of_commands(|command| columns.command(command))
        };
        return table(&mut columns, report_member(&run_report, &job, &loaded));
    }
    let mut out = CommandWriter::new(Vec::new(), format, &job, of_path).map_err(write_failure)?;
    let mut written = Ok(());
    if of_path {
        job.report_of_path(|path, _| write_unless_failed(&mut written, || out.path_command(path)));
    } else {
        job.report_of_commands(|command| {
            write_unless_failed(&mut written, || out.command(command))
        });
    }
    text_answer(written.and_then(|()| out.finish()))
}

pub fn curves(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let FormatOptions { format } = request.options()?;
    request.require_format(&QUESTION_OBJECT, format)?;
    let loaded = request.load()?;
    let job = loaded.job()?;
    let mut columns = PathColumns::new(&job);
    let run_report = job.report_of_path(|_, segments| {
        segments.iter().for_each(|segment| columns.segment(segment));
    });
    table(&mut columns, report_member(&run_report, &job, &loaded))
}

pub fn time(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let options: TimeOptions = request.options()?;
    request.require_format(&QUESTION_JSON, options.format)?;
    let loaded = request.load()?;
    let job = loaded.job()?;
    let question = TimeQuestion {
        options: MotionOptions {
            level: options.level.level(),
            operations: options.operations.start(),
            ..MotionOptions::default()
        },
        repeat_planning: if options.what_if {
            RepeatPlanning::Always
        } else {
            RepeatPlanning::IfShort
        },
        computes_least: options.bound,
    };
    let (run_report, study) = job.time_study(&question);
    match study? {
        Some(study) => Ok(QuestionAnswer::text(time_json(&study, &run_report, &job))),
        None => Err(QuestionFailure::plain("the program has more moves than can be counted", None)),
    }
}

pub fn sample(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let options: SampleOptions = request.options()?;
    let period_s = options.period;
    if !(period_s > 0.0 && period_s.is_finite()) {
        let message = format!("`period` is {period_s}");
        return Err(QuestionFailure::wrong(
            message,
            "give seconds above zero: 0.001 is a millisecond",
        ));
    }
    let loaded = request.load()?;
    let job = loaded.job()?;
    let run_report = job.report();
    let head = SampleHead::of(&job, &run_report, period_s);
    let sampling = SamplingRequest {
        period_s,
        level: options.level.level(),
        max_samples: options.max_samples,
    };
    request.require_format(&QUESTION_SETPOINTS, options.format)?;
    let mut columns = SampleColumns::new(&head);
    if options.format != OutputFormat::Object {
        let mut out =
            SampleWriter::new(Vec::new(), options.format, columns).map_err(write_failure)?;
        let mut written = Ok(());
        let sampled = job.setpoints(&sampling, |sample, line| {
            write_unless_failed(&mut written, || out.sample(sample, line));
        });
        sampled.map_err(|error| sampling_failure(error, &sampling))?;
        return text_answer(written.and_then(|()| out.finish()));
    }
    let sampled = job.setpoints(&sampling, |sample, line| columns.sample(sample, line));
    let sampled = sampled.map_err(|error| sampling_failure(error, &sampling))?;
    let mut members = report_member(&run_report, &job, &loaded);
    let (chord_error_mm, chord_error_line) = sampled.chord;
    members["time_s"] = json!(sampled.time_s);
    members["chord_mm"] = json!(chord_error_mm);
    members["chord_line"] = json!(chord_error_line);
    table(&mut columns, members)
}

fn sampling_failure(error: SamplingError, sampling: &SamplingRequest) -> QuestionFailure {
    match error {
        SamplingError::Limit(error) => error.into(),
        SamplingError::TooMany { at_least_s } => QuestionFailure::wrong(
            format!(
                "more than {} setpoints: the run takes at least {at_least_s:.3} s, with a setpoint every {} s",
                sampling.max_samples, sampling.period_s
            ),
            "give a longer `period`, or a larger `maxSamples`",
        ),
    }
}

/// The answer's member `report`, next to its columns: the report of the run.
fn report_member(run_report: &Report, job: &Job<'_>, loaded: &Loaded) -> Value {
    let report = report::json(run_report, job.sources(), loaded.name(), &loaded.reading());
    json!({ "report": serde_json::from_str::<Value>(&report).unwrap_or_default() })
}

fn text_answer(written: io::Result<Vec<u8>>) -> Result<QuestionAnswer, QuestionFailure> {
    let text = written.map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    text.map(QuestionAnswer::text).map_err(write_failure)
}

/// Cannot happen in practice: writing to a `Vec` does not fail.
fn write_failure(error: io::Error) -> QuestionFailure {
    QuestionFailure::plain(format!("the answer could not be written: {error}"), None)
}
