//! Problems, summary, comparison and conversion of programs.

use chordal::motion::MotionOptions;
use chordal::time::max_summarized_moves;
use chordal::{EVERY_PLACE, KEPT_PER_CODE};
use chordal_compare::{Category, ComparisonOptions, compare};
use chordal_export::format::{QUESTION_DIFFERENCES, QUESTION_JSON, QUESTION_PROBLEMS};
use chordal_export::report::{
    self, GitlabReport, ReportDetail, SarifReport, SummarizedRun, files_json, summary_json,
};
use chordal_export::{
    OutputFormat, comparison_json, comparison_names, comparison_text, conversion_json,
};
use chordal_rewrite::convert::{ConversionOptions, convert};

use crate::answer::{QuestionAnswer, QuestionFailure};
use crate::load_request::LoadRequest;
use crate::options::{CompareOptions, ConvertOptions, FormatOptions};

pub fn check(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let FormatOptions { format } = request.options()?;
    let loaded = request.load()?;
    let job = loaded.job()?;
    request.require_format(&QUESTION_PROBLEMS, format)?;
    let max_per_code = if QUESTION_JSON.has(format) { EVERY_PLACE } else { KEPT_PER_CODE };
    let program_report = job.check_keeping(max_per_code);
    let object = || report::json(&program_report, job.sources(), loaded.name(), &loaded.reading());
    Ok(QuestionAnswer::text(match format {
        OutputFormat::Object => object(),
        OutputFormat::Json => files_json("chordal.check/1", &[object()]),
        OutputFormat::Text => {
            report::text(&program_report, job.sources(), false, ReportDetail::default())
        }
        OutputFormat::Github => report::github(&program_report, job.sources()),
        OutputFormat::Sarif => {
            let mut sarif = SarifReport::new();
            sarif.add(&program_report, job.sources());
            sarif.finish()
        }
        _ => {
            let mut gitlab = GitlabReport::new();
            gitlab.add(&program_report, job.sources());
            gitlab.finish()
        }
    }))
}

pub fn run(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let FormatOptions { format } = request.options()?;
    request.require_format(&QUESTION_JSON, format)?;
    let loaded = request.load()?;
    let job = loaded.job()?;
    let max_moves = max_summarized_moves(loaded.size());
    let (run_report, timed) = job.report_timed(&MotionOptions::default(), max_moves, &mut ());
    // Axis limits with which no motion can be planned are an error of `time`; the summary only leaves the time out.
    let timed = timed.ok().flatten();
    let run = SummarizedRun { report: &run_report, timed: timed.as_ref(), stock: None };
    let object = summary_json(&run, &job, loaded.name(), &loaded.reading());
    Ok(QuestionAnswer::text(match format {
        OutputFormat::Json => files_json("chordal.run/1", &[object]),
        _ => object,
    }))
}

pub fn comparison(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let options: CompareOptions = request.options()?;
    let tolerance_mm = non_negative("tolerance", options.tolerance)?;
    let ignored = options.ignore.iter().map(|word| category(word)).collect::<Result<_, _>>()?;
    let (a, b) = (request.load()?, request.load()?);
    let (job_a, job_b) = (a.job()?, b.job()?);
    let jobs = [&job_a, &job_b];
    let comparison_options = ComparisonOptions {
        tolerance_mm,
        feed_tolerance: non_negative("feedTolerance", options.feed_tolerance)?,
        // One tolerance for feeds and speeds: both are relative.
        speed_tolerance: options.feed_tolerance,
        ignored,
        ..ComparisonOptions::default()
    };
    request.require_format(&QUESTION_DIFFERENCES, options.format)?;
    let differences = compare(jobs[0], jobs[1], &comparison_options);
    Ok(QuestionAnswer::text(match options.format {
        OutputFormat::Text => {
            let names = comparison_names([a.name(), b.name()], jobs);
            comparison_text(&differences, names.each_ref().map(String::as_str), jobs, tolerance_mm)
        }
        _ => comparison_json(&differences, jobs, tolerance_mm),
    }))
}

pub fn conversion(request: &mut LoadRequest) -> Result<QuestionAnswer, QuestionFailure> {
    let options: ConvertOptions = request.options()?;
    request.require_format(&QUESTION_JSON, options.format)?;
    let target = request.machine(&options.to)?;
    let defaults = ConversionOptions::default();
    let tolerance_mm =
        non_negative("tolerance", options.tolerance.unwrap_or(defaults.tolerance_mm))?;
    if options.digits.is_some_and(|digits| digits > MAX_DECIMALS) {
        let message = format!("`digits` is above {MAX_DECIMALS}");
        return Err(QuestionFailure::wrong(
            message,
            "leave it out for as many as the control keeps",
        ));
    }
    let loaded = request.load()?;
    let job = loaded.job()?;
    let conversion_options = ConversionOptions {
        tolerance_mm,
        digits: options.digits,
        despite_errors: options.despite_errors,
        exact_cycles: options.exact_cycles,
        axis_positions: options.axis_positions,
    };
    Ok(QuestionAnswer::text(conversion_json(&convert(&job, &target, &conversion_options), &job)))
}

/// The largest number of decimals that may be requested for computed words.
const MAX_DECIMALS: usize = 9;

/// Refuses an option that is negative, infinite or NaN.
fn non_negative(name: &str, value: f64) -> Result<f64, QuestionFailure> {
    if value >= 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(QuestionFailure::wrong(format!("`{name}` is {value}"), "give a number of zero or more"))
}

fn category(text: &str) -> Result<Category, QuestionFailure> {
    let category = Category::ALL.into_iter().find(|category| category.word() == text);
    category.ok_or_else(|| {
        let words: Vec<&str> = Category::ALL.iter().map(|category| category.word()).collect();
        let help = format!("the categories are {}", words.join(", "));
        QuestionFailure::wrong(format!("there is no category `{text}` to ignore"), help)
    })
}
