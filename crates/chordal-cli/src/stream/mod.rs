//! `chordal stream`: the planned motion in real time, as an MTConnect adapter sends it (SHDR).

mod clients;
mod shdr;

use std::net::{Ipv4Addr, TcpListener};
use std::path::PathBuf;
use std::time::{Duration, Instant};

use chordal::machine::{AXES, AXIS_LETTERS};
use chordal::motion::{MotionSample, PlannerLevel, SamplingRequest};
use chordal::{Job, Report};
use chordal_export::report::{self, ReportDetail};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::options::CommonArgs;
use crate::programs::{load_one, recognized};
use crate::sample::{failure, period, verdict};
use crate::terminal::{TerminalSupport, say};
use clients::StreamClients;
use shdr::Observations;

const EXAMPLES: &str = "\
Examples:
  chordal stream part.nc --port 7878
  chordal stream part.nc -m haas-vf2 --rate 10 --period 50ms

Listens on 127.0.0.1 and begins when the first client connects: an MTConnect agent, a dashboard, nc.
It sends lines of SHDR, each value when it changes: Xact, Yact, Zact (mm), Aact, Bact, Cact (degrees),
path_feedrate (mm/s), line, block, program, mode, execution, avail, logic (condition). docs/serve.md
describes them. Nothing is sent elsewhere, and nothing that clients send is carried out.";

/// Sends the planned positions in real time, as an MTConnect adapter does, for dashboards and agents
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// Port on 127.0.0.1; 0 takes a free one
    #[arg(long, default_value_t = 7878)]
    port: u16,

    /// Time from one look at the axes to the next, with its unit
    #[arg(long, value_name = "TIME", default_value = "100ms", value_parser = period)]
    period: f64,

    /// How many times as fast as the machine
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    rate: f64,

    /// Begins again at the end, until it is stopped
    #[arg(long)]
    repeat: bool,

    #[command(flatten)]
    common: CommonArgs,
}

/// Looks at the axes that a client could not keep up with.
const SHORTEST_S: f64 = 1e-3;

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    if !(args.rate > 0.0 && args.rate <= 1e4) {
        let message = format!("a rate of {} is not between 0 and 10000", args.rate);
        return Err(CommandFailure::wrong(message, "1 is as fast as the machine"));
    }
    if args.period < SHORTEST_S {
        return Err(CommandFailure::wrong(
            "the period is below 1 ms",
            "setpoints to a file: chordal sample",
        ));
    }
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    let report = job.report();
    terminal.write_error(&recognized(&loaded));
    terminal.write_error(&report::text(
        &report,
        job.sources(),
        terminal.err,
        ReportDetail::default(),
    ));
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, args.port)).map_err(|error| {
        let message = format!("port {} of 127.0.0.1 cannot be used: {error}", args.port);
        CommandFailure::wrong(message, "take another --port; 0 takes a free one")
    })?;
    let address =
        listener.local_addr().map_err(|error| CommandFailure::write("the port", &error))?;
    say(&format!("{address}\n"))?;
    let mut clients = StreamClients::of(listener);
    clients.wait_for_one();
    loop {
        StreamPlayback::new(args, &job, &report, &mut clients).play(args, &job)?;
        if !args.repeat {
            return Ok(verdict(&report));
        }
    }
}

/// A run on its way to the clients.
struct StreamPlayback<'a, 'b> {
    clients: &'a mut StreamClients,
    observations: Observations,
    job: &'a Job<'b>,
    axes: Vec<usize>,
    began: Instant,
    rate: f64,
    line: u32,
}

impl<'a, 'b> StreamPlayback<'a, 'b> {
    fn new(
        args: &Args,
        job: &'a Job<'b>,
        report: &Report,
        clients: &'a mut StreamClients,
    ) -> StreamPlayback<'a, 'b> {
        let mut observations = Observations::default();
        observations.set("avail", "AVAILABLE");
        observations.set("mode", "AUTOMATIC");
        observations.set("execution", "ACTIVE");
        observations.set("program", &args.file.to_string_lossy());
        observations.condition(job, report);
        let moved = report.summary.axes.iter().filter_map(|axis| AXIS_LETTERS.find(axis.letter));
        let axes = (0..3).chain(moved.filter(|axis| *axis >= 3 && *axis < AXES)).collect();
        let (began, rate) = (Instant::now(), args.rate);
        StreamPlayback { clients, observations, job, axes, began, rate, line: 0 }
    }

    fn play(mut self, args: &Args, job: &Job<'_>) -> Result<(), CommandFailure> {
        let period_s = args.period * args.rate;
        let sampling =
            SamplingRequest { period_s, level: PlannerLevel::Fast, max_samples: u64::MAX };
        let sampled = job.setpoints(&sampling, |sample, line| self.show(sample, line));
        sampled.map_err(|error| failure(&error, u64::MAX, period_s))?;
        self.observations.set("execution", "PROGRAM_COMPLETED");
        self.observations.set("path_feedrate", "0");
        self.clients.send(&mut self.observations);
        Ok(())
    }

    fn show(&mut self, sample: &MotionSample, line: u32) {
        for axis in &self.axes {
            let value = sample.position[*axis];
            let value = if *axis < 3 { value } else { value.to_degrees() };
            let letter = &AXIS_LETTERS[*axis..=*axis];
            self.observations.set(&format!("{letter}act"), &number(value));
        }
        self.observations.set("path_feedrate", &number(self.rate * sample.speed()));
        if line != self.line {
            self.line = line;
            self.observations.set("line", &line.to_string());
            self.observations.set("block", &block(self.job, line));
        }
        let due = Duration::from_secs_f64(sample.time_s / self.rate);
        self.clients.wait_until(self.began + due, &self.observations);
        self.clients.send(&mut self.observations);
    }
}

/// A ten-thousandth of a millimetre, without zeros at the end; of what is not known the word of MTConnect.
fn number(value: f64) -> String {
    if value.is_nan() { "UNAVAILABLE".to_string() } else { crate::numbers::short(value, 4) }
}

/// The text of a line of the program.
fn block(job: &Job<'_>, line: u32) -> String {
    let source = job.sources().get(chordal::diagnostics::FileId(0));
    let text = source.filter(|_| line > 0).map(|source| source.line_text(line));
    String::from_utf8_lossy(text.unwrap_or_default()).trim().to_string()
}
