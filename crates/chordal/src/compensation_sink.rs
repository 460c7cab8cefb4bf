//! A run with cutter compensation between the control and the path.

use chordal_command::{CallPath, Command, CommandKind, CompensationSide, Origin, Sink};
use chordal_diagnostics::{Diagnostic, SourceMap, Span};
use chordal_kernel::{ConfiguredControl, Outcome, RunSink};
use chordal_path::{
    Compensator, ContourCheck, ContourPiece, PathBuilder, PathCommand, PathSink, Segment, SideCheck,
};

use crate::job::Job;

/// The offset with which the side is judged where the machine file gives no diameter, mm: small enough that the
/// contour keeps its shape.
const NOMINAL_RADIUS_MM: f64 = 1e-3;

/// Most diagnostics that wait for the end of the run, when their chains of calls are known.
pub(crate) const MAX_WAITING: usize = 10_000;

impl Job<'_> {
    /// Runs and pushes the exact path, segment by segment, all in the frame of the run.
    pub fn path(&self, push: impl FnMut(&Segment)) -> Vec<Outcome> {
        let builder = self.path_builder();
        let (outcomes, _) = CompensationSink::run(self, PathSegments { builder, push });
        outcomes
    }

    /// Runs and pushes everything that cutter compensation produces: the commands of the tool centre, problems, and
    /// the compensated contours. `radius_mm` replaces the radius of the offset table.
    pub fn compensated<S: PathSink>(&self, radius_mm: Option<f64>, sink: &mut S) -> Vec<Outcome> {
        CompensationSink::run_with(self, radius_mm, None, sink).0
    }
}

struct PathSegments<'m, F> {
    builder: PathBuilder<'m>,
    push: F,
}

impl<F: FnMut(&Segment)> PathSink for PathSegments<'_, F> {
    fn command(&mut self, path: PathCommand<'_>) {
        self.builder.command(path.command, &mut self.push);
    }

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}
}

/// Passes the commands of a control through compensation on to a path sink.
pub(crate) struct CompensationSink<'a, S> {
    pub compensator: Compensator,
    pub pending: PendingDiagnostics<'a, S>,
    control: &'a dyn ConfiguredControl,
    /// Follows a contour whose offset is not known, while there is one.
    nominal: Option<Box<NominalSink>>,
}

/// A contour without a diameter: only the side from which the tool approaches can be judged.
struct NominalSink {
    compensator: Compensator,
    sides: SideCheck,
}

impl NominalSink {
    fn command(&mut self, command: &Command, report: &mut dyn FnMut(Diagnostic, &Origin)) {
        let NominalSink { compensator, sides } = self;
        compensator.command(command, &mut SideSink { sides, report });
    }

    fn finish(&mut self, report: &mut dyn FnMut(Diagnostic, &Origin)) {
        let NominalSink { compensator, sides } = self;
        compensator.finish(&mut SideSink { sides, report });
    }
}

/// Takes the pieces of a contour and ignores everything else.
struct SideSink<'s> {
    sides: &'s mut SideCheck,
    report: &'s mut dyn FnMut(Diagnostic, &Origin),
}

impl PathSink for SideSink<'_> {
    fn command(&mut self, _: PathCommand<'_>) {}

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}

    fn contour(&mut self, piece: &ContourPiece) {
        self.sides.piece(piece, self.report);
    }
}

/// The next sink, and the diagnostics of compensation that wait for their chains of calls.
pub(crate) struct PendingDiagnostics<'a, S> {
    pub inner: S,
    sources: &'a SourceMap<'a>,
    pub waiting: Vec<(Diagnostic, CallPath)>,
    /// Checks contours against the whole path, where the run is judged.
    contours: Option<ContourCheck>,
}

impl<'a, S: PathSink> CompensationSink<'a, S> {
    /// Runs a job into a sink and returns the sink.
    pub fn run(job: &'a Job<'a>, sink: S) -> (Vec<Outcome>, S) {
        CompensationSink::run_with(job, None, None, sink)
    }

    /// The same, and reports where the tool would cut into a contour.
    pub fn judge(job: &'a Job<'a>, sink: S) -> (Vec<Outcome>, S) {
        CompensationSink::run_with(job, None, Some(ContourCheck::default()), sink)
    }

    /// The same with another radius than the offset table's, mm.
    pub fn run_with(
        job: &'a Job<'a>,
        radius_mm: Option<f64>,
        contours: Option<ContourCheck>,
        sink: S,
    ) -> (Vec<Outcome>, S) {
        let mut this = CompensationSink::new(job, contours, sink);
        if let Some(radius) = radius_mm {
            this.compensator = this.compensator.with_radius(radius);
        }
        let outcomes = job.run_each(&mut this, |this, outcome, head| {
            this.finish();
            this.pending.resolve(outcome);
            this.pending.inner.ended(head);
        });
        (outcomes, this.pending.inner)
    }

    /// The state before the first command.
    pub fn new(
        job: &'a Job<'a>,
        contours: Option<ContourCheck>,
        sink: S,
    ) -> CompensationSink<'a, S> {
        let compensator = Compensator::new(job.rules(), job.profile().alarms());
        let pending = PendingDiagnostics {
            inner: sink,
            sources: job.sources(),
            waiting: Vec::new(),
            contours,
        };
        CompensationSink { compensator, pending, control: job.configured_control(), nominal: None }
    }

    /// Passes a command to the contour with the nominal radius, which begins at a G41 or G42 whose offset is not
    /// known.
    fn follow_nominal(&mut self, command: &Command) {
        if self.nominal.is_none() {
            let unknown = matches!(
                command.kind,
                CommandKind::Compensation { side, number: Some(_), radius_mm: None, .. }
                    if side != CompensationSide::Off
            );
            if !unknown || self.pending.contours.is_none() || !self.compensator.is_settled() {
                return;
            }
            let mut compensator =
                Compensator::new(self.control.rules(), self.control.profile().alarms())
                    .with_radius(NOMINAL_RADIUS_MM);
            compensator.recall(&self.compensator.memory());
            self.nominal = Some(Box::new(NominalSink { compensator, sides: SideCheck::default() }));
        }
        if let Some(mut nominal) = self.nominal.take() {
            nominal.command(command, &mut |diagnostic, origin| {
                PathSink::diagnostic(&mut self.pending, diagnostic, origin);
            });
            self.nominal = (!nominal.compensator.is_settled()).then_some(nominal);
        }
    }

    /// Ends what is open when a program ends.
    pub fn finish(&mut self) {
        self.compensator.finish(&mut self.pending);
        if let Some(mut nominal) = self.nominal.take() {
            nominal.finish(&mut |diagnostic, origin| {
                PathSink::diagnostic(&mut self.pending, diagnostic, origin);
            });
        }
        self.pending.judge(|contours, report| contours.finish(report));
    }

    /// Whether no compensated contour is open.
    pub fn is_settled(&self) -> bool {
        let contours = &self.pending.contours;
        self.compensator.is_settled()
            && self.nominal.is_none()
            && contours.as_ref().is_none_or(ContourCheck::is_settled)
    }
}

impl<S: PathSink> Sink for CompensationSink<'_, S> {
    #[inline]
    fn command(&mut self, command: &Command) {
        if !matches!(command.kind, CommandKind::Idle) {
            self.pending.inner.programmed(command);
        }
        if self.nominal.is_some() || matches!(command.kind, CommandKind::Compensation { .. }) {
            self.follow_nominal(command);
        }
        self.compensator.command(command, &mut self.pending);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.pending.inner.diagnostic(diagnostic, &Origin::default());
    }
}

impl<S: PathSink> RunSink for CompensationSink<'_, S> {}

impl<S: PathSink> PendingDiagnostics<'_, S> {
    /// Shows something to the check of contours, and reports what it finds.
    fn judge(&mut self, see: impl FnOnce(&mut ContourCheck, &mut dyn FnMut(Diagnostic, &Origin))) {
        if let Some(mut contours) = self.contours.take() {
            see(&mut contours, &mut |diagnostic, origin| self.diagnostic(diagnostic, origin));
            self.contours = Some(contours);
        }
    }

    /// Reports what waited: the chains of calls are known when the run has ended.
    fn resolve(&mut self, outcome: &Outcome) {
        for (mut diagnostic, call) in self.waiting.drain(..) {
            diagnostic.calls = outcome.calls.resolve(call);
            self.inner.diagnostic(diagnostic, &Origin { call, ..Origin::default() });
        }
    }
}

impl<S: PathSink> PathSink for PendingDiagnostics<'_, S> {
    #[inline]
    fn command(&mut self, command: PathCommand<'_>) {
        self.inner.command(command);
    }

    fn diagnostic(&mut self, mut diagnostic: Diagnostic, origin: &Origin) {
        if let Some(contours) = &mut self.contours {
            contours.alarm(&diagnostic);
        }
        name_sequence(&mut diagnostic, self.sources, origin.span);
        if origin.call == CallPath::default() || self.waiting.len() >= MAX_WAITING {
            self.inner.diagnostic(diagnostic, origin);
        } else {
            self.waiting.push((diagnostic, origin.call));
        }
    }

    fn contour(&mut self, piece: &ContourPiece) {
        self.judge(|contours, report| contours.piece(piece, report));
        self.inner.contour(piece);
    }
}

/// Puts the N number of the block into an alarm text that shows it.
pub(crate) fn name_sequence(diagnostic: &mut Diagnostic, sources: &SourceMap, span: Span) {
    if let Some(alarm) = &mut diagnostic.alarm
        && alarm.contains("{n}")
    {
        *alarm = alarm.replace("{n}", &sequence(sources, span));
    }
}

/// The digits of the N word at the head of a block, for alarms.
fn sequence(sources: &SourceMap, span: Span) -> String {
    let text = sources.words(span);
    let text = text.trim_start().trim_start_matches('/').trim_start();
    let digits: String = match text.strip_prefix(['N', 'n']) {
        Some(rest) => rest.trim_start().chars().take_while(char::is_ascii_digit).collect(),
        None => String::new(),
    };
    if digits.is_empty() { "?".into() } else { digits }
}
