//! Problems, summary, comparison and conversion of programs.

use chordal::motion::MotionOptions;
use chordal::time::max_summarized_moves;
use chordal::{EVERY_PLACE, KEPT_PER_CODE, RunWatch};
use chordal_compare::{Category, ComparisonOptions as Comparing, compare};
use chordal_export::report::{
    self, GitlabReport, ReportDetail, RunOf, SarifReport, files_json, summary_json,
};
use chordal_export::{comparison_json, comparison_names, comparison_text, conversion_json};
use chordal_rewrite::convert::{ConversionOptions as Converting, convert};

use crate::answer::{Answer, Failure};
use crate::loading::Asked;
use crate::options::{CompareOptions, ConvertOptions, Format, OnlyFormat};

/// Sees nothing of a run.
struct Unwatched;

impl RunWatch for Unwatched {}

pub fn check(asked: &mut Asked) -> Result<Answer, Failure> {
    let OnlyFormat { format } = asked.options()?;
    let loaded = asked.load()?;
    let job = loaded.job()?;
    let kept = if format.is_json() { EVERY_PLACE } else { KEPT_PER_CODE };
    let found = job.check_keeping(kept);
    let object = || report::json(&found, job.sources(), loaded.name(), &loaded.reading());
    Ok(Answer::text(match format {
        Format::Object => object(),
        Format::Json => files_json("chordal.check/1", &[object()]),
        Format::Text => report::text(&found, job.sources(), false, ReportDetail::default()),
        Format::Github => report::github(&found, job.sources()),
        Format::Sarif => {
            let mut sarif = SarifReport::new();
            sarif.add(&found, job.sources());
            sarif.finish()
        }
        Format::Gitlab => {
            let mut gitlab = GitlabReport::new();
            gitlab.add(&found, job.sources());
            gitlab.finish()
        }
        Format::Jsonl | Format::Csv | Format::Canon => {
            return Err(asked.no_form(&["object", "json", "text", "github", "gitlab", "sarif"]));
        }
    }))
}

pub fn run(asked: &mut Asked) -> Result<Answer, Failure> {
    let OnlyFormat { format } = asked.options()?;
    if !format.is_json() {
        return Err(asked.no_form(&["object", "json"]));
    }
    let loaded = asked.load()?;
    let job = loaded.job()?;
    let most = max_summarized_moves(loaded.size());
    let (found, timed) = job.report_timed(&MotionOptions::default(), most, &mut Unwatched);
    // Limits nothing can be planned with are reported by the question about the time.
    let timed = timed.ok().flatten();
    let run = RunOf { report: &found, timed: timed.as_ref(), stock: None };
    let object = summary_json(&run, &job, loaded.name(), &loaded.reading());
    Ok(Answer::text(match format {
        Format::Json => files_json("chordal.run/1", &[object]),
        _ => object,
    }))
}

pub fn compared(asked: &mut Asked) -> Result<Answer, Failure> {
    let options: CompareOptions = asked.options()?;
    let tolerance_mm = length("tolerance", options.tolerance)?;
    let ignored = options.ignore.iter().map(|word| category(word)).collect::<Result<_, _>>()?;
    let (a, b) = (asked.load()?, asked.load()?);
    let (job_a, job_b) = (a.job()?, b.job()?);
    let jobs = [&job_a, &job_b];
    let comparing = Comparing {
        tolerance_mm,
        feed_tolerance: length("feedTolerance", options.feed_tolerance)?,
        speed_tolerance: options.feed_tolerance,
        ignored,
        ..Comparing::default()
    };
    let found = compare(jobs[0], jobs[1], &comparing);
    Ok(Answer::text(match options.format {
        format if format.is_json() => comparison_json(&found, jobs, tolerance_mm),
        Format::Text => {
            let names = comparison_names([a.name(), b.name()], jobs);
            comparison_text(&found, names.each_ref().map(String::as_str), jobs, tolerance_mm)
        }
        _ => return Err(asked.no_form(&["object", "json", "text"])),
    }))
}

pub fn converted(asked: &mut Asked) -> Result<Answer, Failure> {
    let options: ConvertOptions = asked.options()?;
    if !options.format.is_json() {
        return Err(asked.no_form(&["object", "json"]));
    }
    let target = asked.machine(&options.to)?;
    let usual = Converting::default();
    let tolerance_mm = length("tolerance", options.tolerance.unwrap_or(usual.tolerance_mm))?;
    if options.digits.is_some_and(|digits| digits > MOST_DIGITS) {
        let message = format!("`digits` is above {MOST_DIGITS}");
        return Err(Failure::wrong(message, "leave it out for as many as the control keeps"));
    }
    let loaded = asked.load()?;
    let job = loaded.job()?;
    let converting = Converting {
        tolerance_mm,
        digits: options.digits,
        despite_errors: options.despite_errors,
        exact_cycles: options.exact_cycles,
    };
    Ok(Answer::text(conversion_json(&convert(&job, &target, &converting), &job)))
}

/// Most decimals of a computed word.
const MOST_DIGITS: usize = 9;

/// A number of zero or more.
fn length(name: &str, value: f64) -> Result<f64, Failure> {
    if value >= 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(Failure::wrong(format!("`{name}` is {value}"), "give a number of zero or more"))
}

fn category(text: &str) -> Result<Category, Failure> {
    let found = Category::ALL.into_iter().find(|category| category.word() == text);
    found.ok_or_else(|| {
        let words: Vec<&str> = Category::ALL.iter().map(|category| category.word()).collect();
        let help = format!("the categories are {}", words.join(", "));
        Failure::wrong(format!("there is no category `{text}` to ignore"), help)
    })
}
