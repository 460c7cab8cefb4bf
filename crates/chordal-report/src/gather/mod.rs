//! One run, watched, and everything a report says about it.

pub(crate) mod problems;
mod stock;
mod stops;
mod text;
mod time;
mod tools;
mod travel;

use chordal::control::{Command, CommandKind, EndReason};
use chordal::diagnostics::FileId;
use chordal::geometry::Plane;
use chordal::motion::{MotionOptions, OperationStart};
use chordal::stock::StockLeft;
use chordal::{Job, PathCommand, Report, RunWatch, Segment, SegmentKind};
use chordal_export::{Plot, Viewpoint, page_section, sha256_hex};

use self::stops::{ProgramWatcher, StopWatcher};
use self::text::{CommentFinder, clean, file_name};
use self::tools::ToolWatcher;
use self::travel::TravelWatcher;
use crate::data::{
    CappedRows, Document, MoveCounts, PathPicture, PathPictures, ReportHead, SkippedBlocks,
    ToolSign,
};

pub use self::text::title;

/// Lines of the program's own output that are reported.
const MAX_PRINTED: usize = 40;
/// The sides of a picture, px of its own.
const PICTURE_PX: (u32, u32) = (500, 400);
/// The half section of a lathe has the room of the page, px.
const SECTION_PX: (u32, u32) = (1000, 560);

/// What a report cannot know of itself.
#[derive(Clone, Copy, Debug, Default)]
pub struct ReportContext<'a> {
    /// The file, as it is to be called; without its folder.
    pub file: &'a str,
    /// The one program of the text that is run, where the caller chose it.
    pub program: Option<u32>,
    /// Why this machine, where nobody said it.
    pub recognized: Option<&'a str>,
    /// A date to print. A report reads no clock: the same input gives the same bytes.
    pub date: Option<&'a str>,
    /// What the program leaves of a stock, where one is given.
    pub stock: Option<&'a StockLeft>,
}

/// A report, and what else the run found.
#[derive(Clone, Debug)]
pub struct GatheredReport {
    /// The report.
    pub document: Document,
    /// The run's own summary and diagnostics.
    pub report: Report,
}

/// Runs a program once, with all checks and its time planned, and gathers what a report says.
/// Memory is that of the run; what is kept is bounded.
pub fn gather(job: &Job, about: &ReportContext) -> GatheredReport {
    let mut seen = ReportWatcher::new(job);
    let options = MotionOptions { operations: OperationStart::Comment, ..MotionOptions::default() };
    let (report, timed) = job.report_timed(&options, u64::MAX, &mut seen);
    // Limits nothing can be planned with: the report is without times, and says so.
    let timed = timed.ok().flatten();
    let ReportWatcher { tools, travels, stops, programs, mut plot, plane_mm, .. } = seen;
    plot.set_inch(report.summary.inch);
    match about.stock {
        Some(StockLeft::Columns(found)) => plot.set_stock(found),
        Some(StockLeft::Section(found)) => plot.set_section(found),
        None => {}
    }

    let comments = CommentFinder::new(job, programs.first_main(about.program));
    let time = timed.as_ref().map(|timed| &timed.time);
    let tools_reported = tools.tools(job, &comments, &report.summary, time);
    let times =
        timed.as_ref().map(|timed| time::time(timed, &tools_reported.rows, &comments.head(), job));
    // The run on stock has found the same and more.
    let report = about.stock.map_or(report, |found| found.report().clone());
    let printed = report.output.iter().take(MAX_PRINTED).map(|line| clean(line, 200));
    let document = Document {
        schema: "chordal.report/1",
        chordal: env!("CARGO_PKG_VERSION"),
        head: head(job, about, &report, &programs, &comments),
        errors: report.counts.errors,
        not_verified_from: report
            .not_verified_line(job.sources())
            .map(|(file, line)| (file.to_string(), line)),
        is_path_verified: report.is_path_verified(),
        warnings: report.counts.warnings,
        notes: report.counts.notes,
        ends: ends(job, &report),
        moves: moves(&report),
        time: times,
        tools: tools_reported,
        work_offsets: travels.work_offsets(job),
        registers: tools.registers(job),
        travel: travels.travel(job),
        machine_travel: travels.machine(job),
        stops: stops.finish(job, &comments),
        skipped: SkippedBlocks {
            lines: text::skipped(job),
            left_out: job.machine().switches.block_delete.contains(&true),
        },
        printed: CappedRows {
            rows: printed.collect(),
            left_out: report.output.len().saturating_sub(MAX_PRINTED) as u64,
        },
        called: programs.called(about.program),
        problems: problems::problems(&report, job),
        stock: about.stock.map(|found| stock::stock(found, time)),
        pictures: pictures(&plot, &plane_mm, about.stock),
    };
    GatheredReport { document, report }
}

/// Watches a run.
struct ReportWatcher<'j> {
    tools: ToolWatcher,
    travels: TravelWatcher,
    stops: StopWatcher,
    programs: ProgramWatcher<'j>,
    plot: Plot,
    plane: Plane,
    /// Length of the cuts while each plane was chosen, mm: XY, ZX, YZ.
    plane_mm: [f64; 3],
}

impl<'j> ReportWatcher<'j> {
    fn new(job: &'j Job<'j>) -> ReportWatcher<'j> {
        ReportWatcher {
            tools: ToolWatcher::new(),
            travels: TravelWatcher::new(job),
            stops: StopWatcher::default(),
            programs: ProgramWatcher::new(job),
            plot: Plot::new(job),
            plane: job.rules().starts_in,
            plane_mm: [0.0; 3],
        }
    }
}

impl RunWatch for ReportWatcher<'_> {
    fn programmed(&mut self, command: &Command) {
        self.programs.see(&command.origin);
        self.tools.programmed(command);
        self.stops.programmed(command, self.tools.number());
    }

    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        if let CommandKind::Plane(plane) = path.command.kind {
            self.plane = plane;
        }
        let lowest_z = self.travels.command(path.command);
        self.tools.path(path.command, lowest_z);
        for segment in segments {
            if segment.kind != SegmentKind::Rapid && segment.length_mm.is_finite() {
                self.plane_mm[plane_index(self.plane)] += segment.length_mm;
            }
            self.plot.segment(segment);
        }
    }
}

fn plane_index(plane: Plane) -> usize {
    match plane {
        Plane::Xy => 0,
        Plane::Zx => 1,
        Plane::Yz => 2,
    }
}

fn head(
    job: &Job,
    about: &ReportContext,
    report: &Report,
    programs: &ProgramWatcher,
    comments: &CommentFinder,
) -> ReportHead {
    let source = job.sources().get(FileId(0));
    let text = source.map_or(&[][..], |source| source.text());
    let ended = text.last().is_none_or(|byte| matches!(byte, b'\n' | b'\r'));
    let lines = source.map_or(0, |source| u64::from(source.line_of(text.len() as u32)));
    let machine = job.machine();
    ReportHead {
        file: file_name(about.file),
        programs: programs.mains(about.program),
        comments: comments.head(),
        control: job.profile().title,
        machine: clean(&machine.title, 120),
        is_lathe: machine.turns(),
        recognized: about.recognized.map(|why| clean(why, 300)),
        units: if report.summary.inch { "inch" } else { "mm" },
        bytes: text.len() as u64,
        lines: lines - u64::from(ended && lines > 0),
        sha256: sha256_hex(text),
        date: about.date.map(|date| clean(date, 60)),
    }
}

fn moves(report: &Report) -> MoveCounts {
    let summary = &report.summary;
    MoveCounts {
        blocks: report.outcomes.iter().map(|outcome| outcome.blocks).sum(),
        lines: summary.lines,
        arcs: summary.arcs,
        helices: summary.helices,
        spirals: summary.spirals,
        splines: summary.splines,
        rapids: summary.rapids,
        dwells: summary.dwells,
        cut_mm: summary.feed_length_mm,
        rapid_mm: summary.rapid_length_mm,
    }
}

/// How the run ended, where it did not end as programs do; each sentence once.
fn ends(job: &Job, report: &Report) -> Vec<String> {
    let mut sentences: Vec<String> = Vec::new();
    for outcome in &report.outcomes {
        let sentence = match outcome.end {
            EndReason::ProgramEnd => continue,
            EndReason::EndOfText if outcome.blocks == 0 => continue,
            EndReason::EndOfText => "The text ends without an end code (M2, M30).",
            EndReason::Repeats => {
                "It ends with M99: the control starts again from the top. This report covers one run."
            }
            EndReason::LostJump => {
                "It jumps to a block that does not exist. This report covers the run up to there."
            }
            EndReason::Alarm => {
                "It stops itself with an alarm. This report covers the run up to there."
            }
            EndReason::Budget => {
                "It does not end: Chordal stopped the run. This report covers the run up to there."
            }
            EndReason::NotRun => "This is a macro: without its caller nothing of it is run.",
            EndReason::Interrupted => "The run ended early; this report covers its beginning.",
        };
        if !sentences.iter().any(|own| own == sentence) {
            sentences.push(sentence.to_string());
        }
    }
    if job.sources().get(FileId(0)).is_none_or(|source| source.text().is_empty()) {
        sentences.push("The file is empty.".to_string());
    }
    sentences
}

/// The isometric view, and the plane in which most is cut.
fn pictures(plot: &Plot, plane_mm: &[f64; 3], stock: Option<&StockLeft>) -> PathPictures {
    let mut main = (Viewpoint::Top, "the XY plane (G17) from above", plane_mm[0]);
    let others = [
        (Viewpoint::Front, "the ZX plane (G18) from the front", plane_mm[1]),
        (Viewpoint::Right, "the YZ plane (G19) from the right", plane_mm[2]),
    ];
    for other in others {
        if other.2 > main.2 {
            main = other;
        }
    }
    let (width, height) = PICTURE_PX;
    // The one view of a lathe has the room of two.
    let width = if plot.is_turned() { 2 * width } else { width };
    let turned = [(Viewpoint::Turned, "Z to the right and X up, X as a diameter")];
    let milled = [(Viewpoint::Isometric, "from the front, right and above"), (main.0, main.1)];
    let views: &[(Viewpoint, &str)] = if plot.is_turned() { &turned } else { &milled };
    let view = |(from, what): &(Viewpoint, &str)| {
        let drawn = plot.page_view(*from, width, height)?;
        Some(PathPicture { caption: format!("{what}; grid {}", drawn.grid), svg: drawn.svg })
    };
    let sign = |tool: chordal_export::PageTool| ToolSign { number: tool.number, svg: tool.sign };
    PathPictures {
        views: views.iter().filter_map(view).collect(),
        stock: match stock {
            Some(StockLeft::Section(found)) => Some(PathPicture {
                caption: format!(
                    "the half section above, from outside below; dashed: the stock{}",
                    if found.target_section.is_some() { "; green: the target" } else { "" }
                ),
                svg: page_section(found, SECTION_PX.0, SECTION_PX.1),
            }),
            Some(StockLeft::Columns(_)) | None => {
                plot.page_stock(Viewpoint::Isometric, width, height).map(|drawn| PathPicture {
                    caption: format!("from the front, right and above; grid {}", drawn.grid),
                    svg: drawn.svg,
                })
            }
        },
        tools: plot.page_tools().into_iter().map(sign).collect(),
        cuts_left_out: plot.leaves_out_cuts(),
        remarks: plot.remarks(),
    }
}
