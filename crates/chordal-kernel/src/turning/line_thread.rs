//! A thread measured from its drive line (LinuxCNC G76): the line parallel to Z on which the tool starts.

use chordal_diagnostics::{Code, Diagnostic};

use crate::kernel::Kernel;
use crate::statement::Statement;
use crate::turning::XZ;

/// Largest number of passes of one thread.
const MAX_PASSES: u32 = 10_000;

/// The words of a thread measured from its drive line, mm on the radius.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LineThreadWords {
    /// Z at its end.
    pub end_z: f64,
    /// Advance per revolution.
    pub lead: f64,
    /// From the drive line to the crest; positive for an internal thread.
    pub crest: f64,
    /// Depth of the first pass.
    pub first: f64,
    /// Height of the thread.
    pub height: f64,
    /// Degression: the depth of pass n is `first` times this root of n; 1 for equal steps.
    pub root: f64,
    /// Infeed angle (compound slide), degrees.
    pub angle_deg: f64,
    /// Spring passes: repetitions at full depth.
    pub spring: u32,
    /// Length of a taper at the ends along Z.
    pub taper: f64,
    /// The taper is at the start, at the end.
    pub tapered: (bool, bool),
}

impl Kernel<'_> {
    /// Cuts the thread, and ends on the drive line at the end of the thread.
    pub fn line_thread(&mut self, at: &dyn Statement, words: &LineThreadWords) {
        let start = self.turned_place();
        let forth = if words.end_z > start[1] { -1.0 } else { 1.0 };
        let slope = libm::tan(words.angle_deg.to_radians()) * forth;
        let root = words.root.max(1.0);
        self.origin.cycle = true;
        let mut number = 1;
        let mut depth = words.first;
        while depth < words.height {
            self.line_thread_pass(words, start, depth, slope, forth);
            number += 1;
            if number > MAX_PASSES {
                let message = format!("this thread needs more than {MAX_PASSES} passes");
                self.report(
                    Diagnostic::new(Code::BudgetReached, at.span(), message)
                        .help("is J, the depth of the first pass, meant so small?"),
                );
                break;
            }
            depth = words.first * libm::pow(f64::from(number), 1.0 / root);
        }
        for _ in 0..=words.spring.min(MAX_PASSES) {
            self.line_thread_pass(words, start, words.height, slope, forth);
        }
        self.turn_rapid([start[0], words.end_z]);
        self.origin.cycle = false;
    }

    fn line_thread_pass(
        &mut self,
        words: &LineThreadWords,
        start: [f64; 2],
        depth: f64,
        slope: f64,
        forth: f64,
    ) {
        let inward = if words.crest > 0.0 { 1.0 } else { -1.0 };
        let x = |depth: f64| start[0] + inward * (words.crest.abs() + depth);
        // The clearance from the drive line decreases with the depth, as in LinuxCNC.
        let clear = start[0] - inward * (words.height - depth);
        let z = start[1] - depth * slope;
        let end = words.end_z + (words.height - depth) * slope;
        let (tapers_in, tapers_out) = words.tapered;
        let taper = words.taper * forth;
        let on_taper = words.lead * libm::hypot(words.taper, words.height) / words.taper;
        self.turn_rapid([clear, z]);
        if tapers_in && taper != 0.0 {
            self.in_lead([x(depth - words.height), z], on_taper);
            self.in_lead([x(depth), z - taper], on_taper);
        } else {
            self.turn_rapid([x(depth), z]);
        }
        if tapers_out && taper != 0.0 {
            self.in_lead([x(depth), end + taper], words.lead);
            self.in_lead([x(depth - words.height), end], on_taper);
        } else {
            self.in_lead([x(depth), end], words.lead);
        }
        self.turn_rapid([clear, end]);
    }

    /// A synchronized cut with the lead along its path.
    fn in_lead(&mut self, to: [f64; 2], lead: f64) {
        let target = self.place_at(to);
        if target != self.state.position {
            self.thread(target, XZ, lead);
        }
    }
}
