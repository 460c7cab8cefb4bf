//! Programs: loaded once, asked for anything.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use chordal::control::EndReason;
use chordal::geometry::Placement;
use chordal::motion::{LimitError, MotionOptions, PlannerLevel, SamplingError, SamplingRequest};
use chordal::stock::{StockOptions, StockReport, TurnedOptions, TurnedReport};
use chordal::time::{RepeatPlanning, TimeQuestion};
use chordal::{Command, Job, PathCommand, Report, RunWatch, Segment, Summary};
use chordal_compare::{Category, ComparisonOptions as Comparing, compare};
use chordal_export::columns::{
    ChordColumns, CommandColumns, PathColumns, RowBatcher, SampleColumns,
};
use chordal_export::{
    Plot, PlotOptions, SampleHead, comparison_json, conversion_json, refusal_json, report,
    restart_json, sha256_hex, split_json, time_json, transformed_json, write_unless_failed,
};
use chordal_load::{FileAccess, LoadError, Loaded, Request, RequestedMachine, file, reason};
use chordal_report::{ReportContext, gather, html};
use chordal_rewrite as rewrite;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::custom_codes::PyCustomCodes;
use crate::error;
use crate::lathe_stock::TurnedStock;
use crate::machine::Machine;
use crate::signals::PythonSignals;
use crate::stock::{self, Stock};
use crate::table::Table;

/// A program with its machine and its subprograms. It never changes; every question runs it.
#[pyclass(frozen, module = "chordal._chordal")]
pub struct Program {
    loaded: Loaded,
    report: OnceLock<Report>,
}

/// What is left of the stock, of a mill or of a lathe.
enum StockResult {
    Columns(Box<StockReport>),
    Section(Box<TurnedReport>, [Table; 2]),
}

/// What the planner was given, and what it could not plan.
type PlanSummary = (u64, u64, Vec<(u32, String)>, Vec<String>);

/// What a program is to run on, and how; a dictionary of Python's.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct PyProgramOptions {
    machine: Option<Py<Machine>>,
    control: Option<String>,
    set: Vec<String>,
    settings: Option<PathBuf>,
    tools: Option<PathBuf>,
    program: Option<u32>,
    block_delete: bool,
    max_blocks: Option<u64>,
    shop_codes: Option<Py<PyAny>>,
}

impl PyProgramOptions {
    pub fn request(self, py: Python<'_>, signals: &Arc<PythonSignals>) -> PyResult<Request> {
        let control = self.control.map(|name| {
            name.parse().map_err(|error: chordal::machine::UnknownControl| {
                error::usage(py, &error.to_string(), None)
            })
        });
        let machine = self
            .machine
            .map(|machine| RequestedMachine::Machine(Box::new(machine.get().0.clone())));
        let shop = self.shop_codes.map(|hook| PyCustomCodes::new(hook, signals.clone()));
        Ok(Request {
            machine: machine.or(control.transpose()?.map(RequestedMachine::Control)),
            files: FileAccess::Disk,
            set: self.set,
            settings: self.settings,
            tools: self.tools,
            program: self.program,
            block_delete: self.block_delete.into(),
            max_blocks: self.max_blocks,
            shop_codes: shop.map(|shop| Arc::new(shop) as _),
            interrupt: Some(signals.interrupt()),
        })
    }
}

/// Loads a file. What is not said is as the folder's `chordal.toml` or the text says.
#[pyfunction]
pub fn load_file(py: Python<'_>, path: PathBuf, options: PyProgramOptions) -> PyResult<Program> {
    loaded(py, options, |request| file(&path, request))
}

/// Loads a text under a name that messages show.
#[pyfunction]
pub fn load_text(
    py: Python<'_>,
    text: &[u8],
    name: &str,
    options: PyProgramOptions,
) -> PyResult<Program> {
    let bytes = text.to_vec();
    loaded(py, options, |request| chordal_load::text(name, bytes, request))
}

fn loaded(
    py: Python<'_>,
    options: PyProgramOptions,
    load: impl FnOnce(&Request) -> Result<Loaded, LoadError> + Send,
) -> PyResult<Program> {
    let signals = PythonSignals::new();
    let request = options.request(py, &signals)?;
    let loaded = py.detach(|| load(&request));
    signals.raised()?;
    match loaded {
        Ok(loaded) => Ok(Program { loaded, report: OnceLock::new() }),
        Err(error) => Err(error::of_loading(py, &error)),
    }
}

/// How hard the planner tries, by its word.
pub fn level(py: Python<'_>, word: &str) -> PyResult<PlannerLevel> {
    match word {
        "fast" => Ok(PlannerLevel::Fast),
        "best" => Ok(PlannerLevel::Best),
        other => {
            let message = format!("there is no level `{other}`");
            Err(error::usage(py, &message, Some("the levels are `fast` and `best`")))
        }
    }
}

/// A period that a sampler takes.
pub fn period(py: Python<'_>, seconds: f64) -> PyResult<f64> {
    if seconds > 0.0 && seconds.is_finite() {
        return Ok(seconds);
    }
    let message = format!("a period of {seconds} s is not above zero");
    Err(error::usage(py, &message, Some("the period is in seconds: 0.001 is a millisecond")))
}

/// The error for a run with more than `max_samples` setpoints, which takes at least `seconds`.
pub fn too_many(py: Python<'_>, max_samples: u64, seconds: f64) -> PyErr {
    let message =
        format!("more than {max_samples} setpoints: the run takes at least {seconds:.3} s");
    error::usage(py, &message, Some("give a longer period, or a larger max_samples"))
}

fn wrong_limit(py: Python<'_>, error: &LimitError) -> PyErr {
    error::usage(py, &error.to_string(), Some("correct it in the machine"))
}

/// Gathers the commands of a run.
struct CommandGatherer<'a> {
    columns: CommandColumns<'a>,
    of_path: bool,
}

impl RunWatch for CommandGatherer<'_> {
    fn programmed(&mut self, command: &Command) {
        if !self.of_path {
            self.columns.command(command);
        }
    }

    fn path(&mut self, path: PathCommand<'_>, _: &[Segment]) {
        if self.of_path {
            self.columns.path_command(path);
        }
    }
}

impl Program {
    /// Runs something on the job, without the interpreter lock. Ctrl-C ends it.
    fn ask<T: Send>(
        &self,
        py: Python<'_>,
        question: impl FnOnce(&Job<'_>) -> PyResult<T> + Send,
    ) -> PyResult<T> {
        let signals = PythonSignals::new();
        let answer = py.detach(|| {
            let job = self.loaded.job().map_err(|failure| error::inside(failure.to_string()))?;
            question(&job.interrupt(signals.interrupt()))
        });
        signals.raised()?;
        answer
    }

    /// The report of a run, made once.
    fn cached_report<'s>(&'s self, job: &Job<'_>) -> PyResult<&'s Report> {
        match self.report.get() {
            Some(report) => Ok(report),
            None => self.keep(job.report()),
        }
    }

    /// Keeps the report of a run, unless it was ended early.
    fn keep(&self, report: Report) -> PyResult<&Report> {
        let ended = report.outcomes.iter().any(|outcome| outcome.end == EndReason::Interrupted);
        if ended {
            return Err(PyKeyboardInterrupt::new_err(()));
        }
        Ok(self.report.get_or_init(|| report))
    }
}

#[pymethods]
impl Program {
    /// The name that messages show.
    #[getter]
    fn name(&self) -> &str {
        self.loaded.name()
    }

    /// The text, as the control reads it.
    #[getter]
    fn text<'py>(&self, py: Python<'py>) -> Bound<'py, pyo3::types::PyBytes> {
        pyo3::types::PyBytes::new(py, self.loaded.text())
    }

    /// The SHA-256 of the text in hexadecimal.
    #[getter]
    fn sha256(&self, py: Python<'_>) -> String {
        py.detach(|| sha256_hex(self.loaded.text()))
    }

    /// The machine.
    #[getter]
    fn machine(&self) -> Machine {
        Machine(self.loaded.machine().clone())
    }

    /// Why this machine, in a line; `None` where the caller said it.
    #[getter]
    fn recognized(&self, py: Python<'_>) -> PyResult<Option<String>> {
        self.ask(py, |_| Ok(self.loaded.why()))
    }

    /// The problems as the JSON of `chordal check --format json`, and each as text for people and as
    /// the setup sheet shows it.
    fn problems(&self, py: Python<'_>) -> PyResult<(String, Vec<(String, String)>)> {
        self.ask(py, |job| {
            let reported = self.cached_report(job)?;
            let sources = job.sources();
            let drawn = reported.diagnostics.iter().map(|each| {
                let text = report::one(each, sources, false);
                (text, chordal_report::problem_html(each, sources))
            });
            let loaded = &self.loaded;
            let json = report::json(reported, sources, loaded.name(), &loaded.reading());
            Ok((json, drawn.collect()))
        })
    }

    /// The lines that the program prints (DPRNT).
    fn output(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        self.ask(py, |job| Ok(self.cached_report(job)?.output.clone()))
    }

    /// File and line from which on the path is not known.
    fn not_verified_from(&self, py: Python<'_>) -> PyResult<Option<(String, u32)>> {
        self.ask(py, |job| {
            let line = self.cached_report(job)?.not_verified_line(job.sources());
            Ok(line.map(|(file, line)| (file.to_string(), line)))
        })
    }

    /// What the run comes to.
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.ask(py, |job| self.cached_report(job).map(|_| ()))?;
        let empty = Summary::default();
        summary_dict(py, self.report.get().map_or(&empty, |report| &report.summary))
    }

    /// Commands as programmed, or those of the tool centre.
    fn commands(&self, py: Python<'_>, of_path: bool) -> PyResult<Table> {
        self.ask(py, |job| {
            let columns =
                if of_path { CommandColumns::of_path(job) } else { CommandColumns::new(job) };
            let mut commands = CommandGatherer { columns, of_path };
            let reported = job.report_watched(&mut commands);
            self.keep(reported)?;
            commands.columns.take().and_then(Table::new).map_err(error::inside)
        })
    }

    /// The exact path.
    fn path(&self, py: Python<'_>) -> PyResult<Table> {
        self.ask(py, |job| {
            let mut columns = PathColumns::new(job);
            job.path(|segment| columns.segment(segment));
            columns.take().and_then(Table::new).map_err(error::inside)
        })
    }

    /// The path as chords.
    fn chords(&self, py: Python<'_>, tolerance: f64, balanced: bool) -> PyResult<Table> {
        let placement = if balanced { Placement::Balanced } else { Placement::Inscribed };
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            let message = format!("a chord tolerance of {tolerance} mm is not above zero");
            return Err(error::usage(py, &message, None));
        }
        self.ask(py, |job| {
            let mut columns = ChordColumns::new(job, tolerance, placement);
            let mut done = Ok(());
            job.path(|segment| write_unless_failed(&mut done, || columns.segment(segment)));
            done.map_err(error::value)?;
            columns.take().and_then(Table::new).map_err(error::inside)
        })
    }

    /// The setpoints of the axes, and what the planner was given.
    fn trajectory(
        &self,
        py: Python<'_>,
        period_s: f64,
        level_word: &str,
        max_samples: u64,
    ) -> PyResult<(Table, PlanSummary)> {
        let (period_s, level) = (period(py, period_s)?, level(py, level_word)?);
        let sampling = SamplingRequest { period_s, level, max_samples };
        let planned = self.ask(py, |job| {
            let mut columns = SampleColumns::new(&SampleHead::of(job, &job.report(), period_s));
            let sampled = job.setpoints(&sampling, |sample, line| columns.sample(sample, line));
            let motion = match sampled {
                Ok(sampled) => sampled.motion,
                Err(error) => return Ok(Err(error)),
            };
            let table = columns.take().and_then(Table::new).map_err(error::inside)?;
            let refused = motion.refused.iter();
            let refused = refused.map(|each| (each.source.origin.line, each.error.to_string()));
            let assumed = motion.limits.assumed.iter();
            let assumed =
                assumed.map(|each| format!("{} of {}", each.quantity, each.axis.letter()));
            let reported =
                (motion.moves, motion.cuts_without_feed, refused.collect(), assumed.collect());
            Ok(Ok((table, reported)))
        })?;
        planned.map_err(|error| match error {
            SamplingError::Limit(error) => wrong_limit(py, &error),
            SamplingError::TooMany { at_least_s } => too_many(py, max_samples, at_least_s),
        })
    }

    /// The time as the JSON of `chordal time --format json`.
    #[pyo3(signature = (level_word, feed_override, rapid_override, what_if, bound))]
    fn time(
        &self,
        py: Python<'_>,
        level_word: &str,
        feed_override: Option<f64>,
        rapid_override: Option<f64>,
        what_if: bool,
        bound: bool,
    ) -> PyResult<String> {
        let level = level(py, level_word)?;
        let options =
            MotionOptions { level, feed_override, rapid_override, ..MotionOptions::default() };
        let repeat_planning = if what_if { RepeatPlanning::Always } else { RepeatPlanning::Never };
        let question = TimeQuestion { options, repeat_planning, computes_least: bound };
        let timed = self.ask(py, |job| Ok(time_of(job, self.cached_report(job)?, &question)))?;
        timed.map_err(|error| wrong_limit(py, &error))
    }

    /// The text after steps, each a name and its numbers, and what was changed and proved as JSON; only
    /// the JSON where a step is refused.
    fn transform(
        &self,
        py: Python<'_>,
        steps: Vec<(String, Vec<f64>)>,
    ) -> PyResult<(Option<Vec<u8>>, String)> {
        let steps: Vec<rewrite::TransformStep> = steps
            .iter()
            .map(|(name, numbers)| {
                rewrite::TransformStep::of(name, numbers).ok_or_else(|| {
                    error::value(format!("there is no step {name} of these numbers"))
                })
            })
            .collect::<PyResult<_>>()?;
        self.ask(py, |job| match rewrite::transform(job, &steps) {
            Ok(done) => {
                let new = job.with_text(done.text.clone());
                let reported = transformed_json(&done, [job, &new], None);
                Ok((Some(done.text), reported))
            }
            Err(refusal) => Ok((None, refusal_json(&refusal, self.loaded.name()))),
        })
    }

    /// The text raised by a map of heights in units of so many mm, and what is to be said of it as JSON; only the
    /// JSON where it is refused.
    fn bend(
        &self,
        py: Python<'_>,
        map: Vec<u8>,
        unit_mm: f64,
        zero: Option<[f64; 2]>,
        tolerance_mm: f64,
        clamp: bool,
    ) -> PyResult<(Option<Vec<u8>>, String)> {
        let map = rewrite::HeightMap::read(&map, unit_mm).map_err(|wrong| {
            let place = wrong.line.map_or(String::new(), |line| format!("line {line}: "));
            error::usage(py, &format!("{place}{}", wrong.what), Some(&wrong.help))
        })?;
        let map = match zero {
            Some(at) => map.with_zero_at(at),
            None => map,
        };
        let how = rewrite::HeightOptions { tolerance_mm, clamp };
        self.ask(py, |job| match rewrite::warp(job, &map, &how) {
            Ok(warped) => {
                let new = job.with_text(warped.done.text.clone());
                let reported = transformed_json(&warped.done, [job, &new], None);
                Ok((Some(warped.done.text), reported))
            }
            Err(refusal) => Ok((None, refusal_json(&refusal, self.loaded.name()))),
        })
    }

    /// The program in parts of at most so many bytes, or one for each tool: their texts, and what is to be
    /// said of them as JSON.
    fn split(&self, py: Python<'_>, most: Option<usize>) -> PyResult<(Vec<Vec<u8>>, String)> {
        let by = most.map_or(rewrite::SplitBy::Tool, rewrite::SplitBy::Bytes);
        self.ask(py, |job| match rewrite::split(job, by) {
            Ok(done) => {
                let reported = split_json(&done, None, [job, job], &[]);
                Ok((done.parts.into_iter().map(|part| part.text).collect(), reported))
            }
            Err(refusal) => Ok((Vec::new(), refusal_json(&refusal, self.loaded.name()))),
        })
    }

    /// The text that begins at a line, and what is to be said of it as JSON; only the JSON where it is refused.
    fn restart(&self, py: Python<'_>, line: u32) -> PyResult<(Option<Vec<u8>>, String)> {
        let name = self.loaded.name();
        self.ask(py, |job| match rewrite::restart::restart(job, line) {
            Ok(done) => {
                let reported = restart_json(Ok(&done), name, None, None);
                Ok((Some(done.text), reported))
            }
            Err(refused) => Ok((None, restart_json(Err(&refused), name, None, None))),
        })
    }

    /// This program compared with another, as JSON. Categories of `ignore` are no differences.
    fn compare(
        &self,
        py: Python<'_>,
        other: &Program,
        tolerance_mm: f64,
        feed_tolerance: f64,
        ignore: Vec<String>,
    ) -> PyResult<String> {
        let ignored = ignore
            .iter()
            .map(|word| {
                let mut all = Category::ALL.into_iter();
                all.find(|category| category.word() == word)
                    .ok_or_else(|| error::value(format!("there is no category {word}")))
            })
            .collect::<PyResult<_>>()?;
        let options = Comparing {
            tolerance_mm,
            feed_tolerance,
            speed_tolerance: feed_tolerance,
            ignored,
            ..Comparing::default()
        };
        self.ask(py, |job| {
            let other = other.loaded.job().map_err(|failure| error::inside(failure.to_string()))?;
            let found = compare(job, &other, &options);
            Ok(comparison_json(&found, [job, &other], tolerance_mm))
        })
    }

    /// The program for another machine: changes, proof and text as JSON.
    #[allow(clippy::too_many_arguments, reason = "each is an argument of the method in Python")]
    fn convert(
        &self,
        py: Python<'_>,
        to: &Machine,
        tolerance_mm: f64,
        digits: Option<usize>,
        despite_errors: bool,
        exact_cycles: bool,
        axis_positions: bool,
    ) -> PyResult<String> {
        let options = rewrite::convert::ConversionOptions {
            tolerance_mm,
            digits,
            despite_errors,
            exact_cycles,
            axis_positions,
        };
        self.ask(py, |job| {
            let found = rewrite::convert::convert(job, &to.0, &options);
            Ok(conversion_json(&found, job))
        })
    }

    /// What is left of the stock of a setup, or of the program's own machine.
    fn stock(
        &self,
        py: Python<'_>,
        setup: Option<&Machine>,
        resolution_mm: Option<f64>,
        finest_mm: Option<f64>,
        tolerance_mm: f64,
        budget: u64,
    ) -> PyResult<Py<PyAny>> {
        let options = StockOptions { resolution_mm, finest_mm, tolerance_mm, budget };
        let files = |name: &str| std::fs::read(name).map_err(|wrong| reason(&wrong));
        let machine = setup.map(|setup| setup.0.clone());
        let signals = PythonSignals::new();
        let found = py.detach(|| {
            let job = match machine {
                Some(machine) => self.loaded.job_on(machine),
                None => self.loaded.job(),
            };
            let job = job.map_err(|failure| error::inside(failure.to_string()))?;
            let job = job.interrupt(signals.interrupt());
            let turned = TurnedOptions { tolerance_mm, replay: false };
            // Where the limits of the axes are wrong there are no times.
            let times =
                || job.time(&MotionOptions::default()).map_or(Vec::new(), |it| it.time.tools);
            if !job.turns() {
                return Ok(job.stock(&options, &files).map(|mut found| {
                    found.take_times(&times());
                    StockResult::Columns(Box::new(found))
                }));
            }
            let mut found = match job.turned_stock(&turned, &files) {
                Ok(found) => found,
                Err(wrong) => return Ok(Err(wrong)),
            };
            found.take_times(&times());
            let tables = TurnedStock::tables(&job, &found)?;
            Ok::<_, PyErr>(Ok(StockResult::Section(Box::new(found), tables)))
        });
        signals.raised()?;
        let name = self.loaded.name();
        Ok(match found?.map_err(|wrong| stock::refused(py, &wrong))? {
            StockResult::Columns(found) => Py::new(py, Stock::new(*found, name))?.into_any(),
            StockResult::Section(found, tables) => {
                Py::new(py, TurnedStock::new(py, *found, tables, name)?)?.into_any()
            }
        })
    }

    /// The setup sheet as one HTML page.
    #[pyo3(signature = (date))]
    fn report_html(&self, py: Python<'_>, date: Option<&str>) -> PyResult<String> {
        self.ask(py, |job| {
            let recognized = self.loaded.why();
            let gathered = gather(
                job,
                &ReportContext {
                    file: self.loaded.name(),
                    program: self.loaded.program,
                    recognized: recognized.as_deref(),
                    date,
                    stock: None,
                },
            );
            self.keep(gathered.report)?;
            Ok(html(&gathered.document))
        })
    }

    /// The picture of the path as SVG.
    fn svg(&self, py: Python<'_>, width: u32, height: u32, dark: bool) -> PyResult<String> {
        self.ask(py, |job| {
            let (plot, options) = self.plot(job, width, height, dark);
            Ok(plot.svg(&options))
        })
    }

    /// The picture of the path as PNG.
    fn png(&self, py: Python<'_>, width: u32, height: u32, dark: bool) -> PyResult<Vec<u8>> {
        self.ask(py, |job| {
            let (plot, options) = self.plot(job, width, height, dark);
            plot.png(&options).map_err(error::value)
        })
    }
}

impl Program {
    fn plot(&self, job: &Job<'_>, width: u32, height: u32, dark: bool) -> (Plot, PlotOptions) {
        let mut plot = Plot::picture(job);
        let reported = job.report_with(|_, segments| {
            segments.iter().for_each(|segment| plot.segment(segment));
        });
        plot.set_inch(reported.summary.inch);
        let options = PlotOptions {
            title: self.loaded.name().to_string(),
            subtitle: job.machine().title.clone(),
            width_px: width,
            height_px: height,
            dark,
        };
        (plot, options)
    }
}

fn time_of(job: &Job<'_>, report: &Report, question: &TimeQuestion) -> Result<String, LimitError> {
    let (_, study) = job.time_study(question);
    Ok(study?.map_or_else(|| String::from("{}"), |study| time_json(&study, report, job)))
}

fn summary_dict<'py>(py: Python<'py>, summary: &Summary) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("inch", summary.inch)?;
    for (name, count) in [
        ("lines", summary.lines),
        ("arcs", summary.arcs),
        ("helices", summary.helices),
        ("spirals", summary.spirals),
        ("splines", summary.splines),
        ("rapids", summary.rapids),
        ("dwells", summary.dwells),
        ("cuts_without_time", summary.cuts_without_time),
    ] {
        dict.set_item(name, count)?;
    }
    for (name, value) in [
        ("feed_length_mm", summary.feed_length_mm),
        ("rapid_length_mm", summary.rapid_length_mm),
        ("feed_time_s", summary.feed_time_s),
        ("rapid_time_s", summary.rapid_time_s),
        ("dwell_time_s", summary.dwell_time_s),
    ] {
        dict.set_item(name, value)?;
    }
    let travels: Vec<_> = summary
        .axes
        .iter()
        .map(|axis| {
            let scale = if "XYZ".contains(axis.letter) { 1.0 } else { 1f64.to_degrees() };
            let scaled = |(low, high): (f64, f64)| (low * scale, high * scale);
            (axis.letter, scaled(axis.range), axis.cut_range.map(scaled), axis.distance * scale)
        })
        .collect();
    dict.set_item("axes", travels)?;
    let tools: Vec<_> = summary
        .tools
        .iter()
        .map(|tool| (tool.number, tool.feed_length_mm, tool.feed_time_s, tool.rapid_time_s))
        .collect();
    dict.set_item("tools", tools)?;
    Ok(dict)
}
