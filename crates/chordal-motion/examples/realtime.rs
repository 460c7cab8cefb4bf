//! A thread that serves axes at 1 kHz and at 4 kHz while another pushes moves: how late it
//! wakes, what a setpoint costs, what is asked of the axes.
//!
//! `cargo run --release -p chordal-motion --example realtime [SECONDS]`
//!
//! For figures that mean anything the pulling thread wants a core of its own and a real-time
//! priority: `chrt --fifo 80 taskset -c 1 …`.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a shell: threads, a clock and arguments are what it shows"
)]

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use chordal_geometry::{AXES, Arc, Curve, Line, Plane, Vec3};
use chordal_motion::{
    AxisLimit, CornerMode, KinematicLimits, MoveKind, MoveRequest, PushOutcome, StreamFeeder,
    StreamOptions, StreamServo, stream,
};

fn main() {
    let seconds = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(4.0);
    let axis = AxisLimit { velocity: 200.0, acceleration: 2000.0, jerk: 1e5 };
    let limits = KinematicLimits::new([Some(axis), Some(axis), Some(axis), None, None, None])
        .expect("positive limits");
    for period_s in [0.001, 0.000_25] {
        let options = StreamOptions { period_s, ..StreamOptions::default() };
        let (feeder, servo) = stream(limits, options, program(0).from());
        let stop = AtomicBool::new(false);
        let report = std::thread::scope(|scope| {
            let puller = scope.spawn(|| {
                let report = pull(servo, &limits, period_s, seconds);
                stop.store(true, Ordering::Relaxed);
                report
            });
            scope.spawn(|| push(feeder, &stop));
            puller.join().expect("the pulling thread ends")
        });
        report.print(period_s);
    }
}

/// A slot with round ends, a polygon eased within a hundredth, a traverse: again and again.
fn program(index: u64) -> MoveRequest {
    let polygon = |corner: u64| {
        let angle = corner as f64 / 300.0 * std::f64::consts::TAU;
        Vec3::new(30.0 * angle.cos() - 30.0, 30.0 * angle.sin(), 0.0)
    };
    let line = |from: Vec3, to: Vec3| Curve::from(Line::new(from, to));
    let (curve, corner): (Curve, CornerMode) = match index % 305 {
        step @ 0..300 => (
            line(polygon(step), polygon(step + 1)),
            CornerMode::Joined { linear_mm: 0.01, rotary_rad: 0.0 },
        ),
        300 => (line(Vec3::ZERO, Vec3::new(80.0, 0.0, 0.0)), CornerMode::Exact),
        301 => (half(Vec3::new(80.0, 10.0, 0.0), -10.0), CornerMode::Exact),
        302 => (line(Vec3::new(80.0, 20.0, 0.0), Vec3::new(0.0, 20.0, 0.0)), CornerMode::Exact),
        303 => (half(Vec3::new(0.0, 10.0, 0.0), 10.0), CornerMode::Exact),
        _ => (line(Vec3::ZERO, polygon(0)), CornerMode::Stop),
    };
    MoveRequest {
        curve,
        rotary_from: [0.0; 3],
        rotary_to: [0.0; 3],
        path_length: None,
        speed: 150.0,
        corner,
        kind: MoveKind::Cut,
        tag: index,
    }
}

/// Half a circle to the left about a centre, begun at `out` mm of Y from it.
fn half(center: Vec3, out: f64) -> Curve {
    let w = Plane::Xy.frame().w;
    let u = Vec3::new(0.0, out.signum(), 0.0);
    let frame = chordal_geometry::Frame { origin: center, u, v: w.cross(u), w };
    Arc::new(frame, out.abs(), std::f64::consts::PI, 0.0).into()
}

fn push(mut feeder: StreamFeeder, stop: &AtomicBool) {
    let mut next = 0;
    while !stop.load(Ordering::Relaxed) {
        match feeder.push(&program(next)) {
            Ok(PushOutcome::Taken) => next += 1,
            Ok(PushOutcome::Full) => std::thread::sleep(Duration::from_millis(20)),
            Err(error) => {
                println!("move {next}: {error}");
                return;
            }
        }
    }
}

struct Report {
    wake: Histogram,
    cost: Histogram,
    underruns: u64,
    setpoints: u64,
    resting: u64,
    /// Largest velocity, acceleration and jerk of an axis, by differences of positions, over
    /// its limits.
    used: [f64; 3],
}

fn pull(mut servo: StreamServo, limits: &KinematicLimits, period_s: f64, seconds: f64) -> Report {
    let count = (seconds / period_s) as u64;
    let period = Duration::from_secs_f64(period_s);
    let mut report = Report {
        wake: Histogram::default(),
        cost: Histogram::default(),
        underruns: 0,
        setpoints: count,
        resting: 0,
        used: [0.0; 3],
    };
    let mut places = [[0.0; AXES]; 4];
    // The push side plans its first windows.
    std::thread::sleep(Duration::from_millis(300));
    let mut due = Instant::now() + period;
    for index in 0..count {
        let now = Instant::now();
        if due > now {
            std::thread::sleep(due - now);
        }
        report.wake.add(due.elapsed());
        match (index as f64 * period_s * 10.0) as u64 % 20 {
            7 => servo.hold(),
            9 => servo.resume(),
            12 => servo.set_override(0.5),
            14 => servo.set_override(1.5),
            17 => servo.set_override(1.0),
            _ => {}
        }
        let begin = Instant::now();
        let point = servo.next();
        report.cost.add(begin.elapsed());
        report.resting += u64::from(point.rate == 0.0);
        places.rotate_left(1);
        places[3] = point.position;
        for axis in 0..3 {
            let Some(limit) = limits.axis(axis) else { continue };
            let [a, b, c, d] = places.map(|place| place[axis]);
            let used = [
                (d - c) / period_s / limit.velocity,
                (d - 2.0 * c + b) / period_s.powi(2) / limit.acceleration,
                (d - 3.0 * c + 3.0 * b - a) / period_s.powi(3) / limit.jerk,
            ];
            if index > 3 {
                for (most, used) in report.used.iter_mut().zip(used) {
                    *most = most.max(used.abs());
                }
            }
        }
        due += period;
    }
    report.underruns = servo.underruns();
    report
}

/// Counts by powers of two of nanoseconds, in quarters.
struct Histogram {
    counts: [u64; 160],
    most: Duration,
}

impl Default for Histogram {
    fn default() -> Histogram {
        Histogram { counts: [0; 160], most: Duration::ZERO }
    }
}

impl Histogram {
    fn add(&mut self, time: Duration) {
        let bin = ((time.as_nanos().max(1) as f64).log2() * 4.0) as usize;
        self.counts[bin.min(159)] += 1;
        self.most = self.most.max(time);
    }

    /// The time below which a share of the counts lies, µs.
    fn share(&self, share: f64) -> f64 {
        let total: u64 = self.counts.iter().sum();
        let mut sum = 0;
        for (bin, count) in self.counts.iter().enumerate() {
            sum += count;
            if sum as f64 >= share * total as f64 {
                return f64::exp2((bin as f64 + 1.0) / 4.0) / 1000.0;
            }
        }
        self.most.as_secs_f64() * 1e6
    }

    fn print(&self, name: &str) {
        println!(
            "{name}: half below {:.2} µs, 99 % below {:.1} µs, 99.9 % below {:.1} µs, most {:.1} µs",
            self.share(0.5),
            self.share(0.99),
            self.share(0.999),
            self.most.as_secs_f64() * 1e6
        );
        let total: u64 = self.counts.iter().sum();
        for (octave, bins) in self.counts.chunks(4).enumerate() {
            let count: u64 = bins.iter().sum();
            if count > 0 {
                let bar = "#".repeat((count * 50).div_ceil(total.max(1)) as usize);
                println!("  to {:>10.3} µs {count:>7} {bar}", f64::exp2(octave as f64 + 1.0) / 1e3);
            }
        }
    }
}

impl Report {
    fn print(&self, period_s: f64) {
        println!("--- {} setpoints, one every {} ms ---", self.setpoints, period_s * 1000.0);
        self.wake.print("woken late by");
        self.cost.print("cost of a setpoint");
        let [v, a, j] = self.used;
        println!(
            "underruns {}, at rest in {} setpoints; most of the limits used: velocity {v:.6}, \
             acceleration {a:.6}, jerk {j:.6}\n",
            self.underruns, self.resting
        );
    }
}
