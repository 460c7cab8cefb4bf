//! How far an archive is: a bar on a terminal, lines elsewhere.

use std::sync::Mutex;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::numbers::grouped;
use crate::terminal::TerminalSupport;

/// How often a line is written where there is no terminal.
const EVERY: Duration = Duration::from_secs(5);

/// How far an archive is: a bar on a terminal, lines where they are asked for, else nothing.
pub struct ProgressMeter {
    bar: ProgressBar,
    lines: Option<Mutex<ProgressLines>>,
    terminal: TerminalSupport,
}

struct ProgressLines {
    files: u64,
    done: u64,
    /// Files and bytes that this run did itself: what the rate is made of.
    own: (u64, u64),
    began: Instant,
    last_report: Instant,
}

impl ProgressMeter {
    pub fn new(files: usize, requested: bool, terminal: TerminalSupport) -> ProgressMeter {
        let target = ProgressDrawTarget::stderr();
        let drawn = !target.is_hidden() && files > 1;
        let bar = if drawn {
            ProgressBar::with_draw_target(Some(files as u64), target)
        } else {
            ProgressBar::hidden()
        };
        let style = "{bar:30} {human_pos}/{human_len} files, {per_sec}, {eta} left";
        if let Ok(style) = ProgressStyle::with_template(style) {
            bar.set_style(style);
        }
        let now = Instant::now();
        let lines = ProgressLines {
            files: files as u64,
            done: 0,
            own: (0, 0),
            began: now,
            last_report: now,
        };
        ProgressMeter { bar, lines: (requested && !drawn).then(|| Mutex::new(lines)), terminal }
    }

    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

impl chordal_archive::ArchiveProgress for ProgressMeter {
    fn file(&self, bytes: u64, anew: bool) {
        self.bar.inc(1);
        let Some(Ok(mut lines)) = self.lines.as_ref().map(Mutex::lock) else { return };
        lines.done += 1;
        if anew {
            lines.own.0 += 1;
            lines.own.1 += bytes;
        }
        if lines.last_report.elapsed() >= EVERY || lines.done == lines.files {
            lines.last_report = Instant::now();
            self.terminal.write_error(&lines.text());
        }
    }
}

impl ProgressLines {
    fn text(&self) -> String {
        let seconds = self.began.elapsed().as_secs_f64().max(1e-9);
        let rate = self.own.0 as f64 / seconds;
        let left = match self.files - self.done {
            0 => "done".to_string(),
            left if rate > 0.0 => format!("{:.0} s left", left as f64 / rate),
            _ => "time left not known".to_string(),
        };
        format!(
            "{} of {} files, {rate:.0} files/s, {:.1} MB/s, {left}\n",
            grouped(self.done),
            grouped(self.files),
            self.own.1 as f64 / seconds / 1e6,
        )
    }
}
