//! What a move costs, as ratios within one run: `cargo run --release -p chordal-stock --example ratios`.
//! With three words, `sampled`, `certified` or `plain`, the size of a cell and the length of a line in mm, it only cuts some
//! rows of the surface, for a profiler. With one, `sampled` or `certified`, it cuts a million lines of 0.1 mm at 0.05 mm.
//!
//! Finishing a wavy surface with a ball, and levels of a pocket with a flat end, against a plain loop over the
//! columns of each move's box and against lowering numbers that are in the fastest cache.
#![allow(clippy::disallowed_methods)]

#[path = "../tests/support/mod.rs"]
mod support;

use std::hint::black_box;
use std::time::Instant;

use chordal_stock::columns::ColumnCounts;
use chordal_stock::{ColumnOptions, ColumnStock, CutterProfile, Mode, TipMove};
use support::surface::{RADIUS, SIDE, raster, raster_of};

/// The better of some runs, s.
fn seconds<T>(runs: usize, mut run: impl FnMut() -> T) -> (f64, T) {
    let mut best = f64::INFINITY;
    let mut result = None;
    for _ in 0..runs {
        let begin = Instant::now();
        let value = black_box(run());
        best = best.min(begin.elapsed().as_secs_f64());
        result = Some(value);
    }
    (best, result.expect("at least one run"))
}

fn block(resolution: f64, mode: Mode) -> ColumnStock {
    block_of([SIDE, SIDE], resolution, mode)
}

fn block_of([width, depth]: [f64; 2], resolution: f64, mode: Mode) -> ColumnStock {
    let min = support::point([0.0, 0.0, -10.0]);
    let max = support::point([width, depth, 0.0]);
    let options = ColumnOptions { mode, ..ColumnOptions::new(resolution, 1 << 30) };
    ColumnStock::new(chordal_geometry::Aabb { min, max }, options).expect("it fits")
}

/// The floor of a ball on a line in double precision for each column of the move's box.
#[inline(never)]
fn plain(moves: &[TipMove], resolution: f64) -> f64 {
    use chordal_geometry::ParamCurve;
    let cells = (SIDE / resolution).round() as usize;
    let mut heights = vec![0.0_f64; cells * cells];
    for path in moves {
        let (from, to) = (path.curve.start(), path.curve.end());
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let length = libm::hypot(dx, dy);
        let (ux, uy, slope) = (dx / length, dy / length, (to.z - from.z) / length);
        let steep = (1.0 + slope * slope).sqrt();
        let range = |a: f64, b: f64| {
            let low = ((a.min(b) - RADIUS) / resolution).floor().max(0.0) as usize;
            let high = ((a.max(b) + RADIUS) / resolution).ceil().max(0.0) as usize;
            low..high.min(cells)
        };
        for row in range(from.y, to.y) {
            let y = (row as f64 + 0.5) * resolution - from.y;
            for column in range(from.x, to.x) {
                let x = (column as f64 + 0.5) * resolution - from.x;
                let (a, e) = (x * ux + y * uy, x * uy - y * ux);
                let room = RADIUS * RADIUS - e * e;
                if room < 0.0 {
                    continue;
                }
                let q = room.sqrt();
                let s = (a - slope * q / steep).clamp(0.0, length);
                let left = room - (s - a) * (s - a);
                if left < 0.0 {
                    continue;
                }
                let floor = from.z + slope * s + RADIUS - left.sqrt();
                let height = &mut heights[row * cells + column];
                *height = height.min(floor);
            }
        }
    }
    heights.iter().sum()
}

fn finish(mode: Mode, resolution: f64, moves: &[TipMove]) -> (f64, ColumnCounts) {
    let ball = CutterProfile::ball(2.0 * RADIUS).expect("a cutter");
    seconds(3, || {
        let mut stock = block(resolution, mode);
        stock.cut(&ball, moves)
    })
}

fn surface() {
    println!("ball R3 on a wavy surface, lines of one length, from solid; microseconds a move");
    println!("line  cell  sampled certified  c/s   plain plain/s plain/c  columns blocks");
    for length in [0.1, 0.5, 1.0] {
        let all = raster(length);
        // Whole rows from the middle: enough for the plain loop in a second.
        let rows = (SIDE / length) as usize;
        let moves = &all[all.len() / 2..all.len() / 2 + 12 * rows];
        for resolution in [0.05, 0.1, 0.2] {
            let (sampled, _) = finish(Mode::Sampled, resolution, moves);
            let (certified, counts) = finish(Mode::Certified, resolution, moves);
            let some = &moves[..rows * 2];
            let (loops, _) = seconds(1, || plain(some, resolution));
            let by = |time: f64, moves: &[TipMove]| time / moves.len() as f64 * 1e6;
            let (s, c, p) = (by(sampled, moves), by(certified, moves), by(loops, some));
            println!(
                "{length:4}  {resolution:4} {s:8.2} {c:9.2} {:5.2} {p:7.1} {:7.1} {:7.1} {:8} {:6}",
                c / s,
                p / s,
                p / c,
                counts.columns / moves.len() as u64,
                counts.blocks / moves.len() as u64,
            );
        }
    }
}

/// Some rows of the surface once, for a profiler that counts instructions.
fn once(mode: &str, resolution: f64, length: f64) {
    let all = raster(length);
    let moves = &all[all.len() / 2..all.len() / 2 + 4 * (SIDE / length) as usize];
    if mode == "plain" {
        return println!("{} moves, {}", moves.len(), plain(moves, resolution));
    }
    let mode = if mode == "sampled" { Mode::Sampled } else { Mode::Certified };
    let ball = CutterProfile::ball(2.0 * RADIUS).expect("a cutter");
    let counts = block(resolution, mode).cut(&ball, moves);
    println!("{} moves, {counts:?}", moves.len());
}

/// A million lines on one core: seconds on the clock and of the processor, and memory.
fn million(mode: &str) {
    let size = [180.0, 166.8];
    let mode = if mode == "sampled" { Mode::Sampled } else { Mode::Certified };
    let moves = raster_of(size, 0.1);
    let ball = CutterProfile::ball(2.0 * RADIUS).expect("a cutter");
    let mut stock = block_of(size, 0.05, mode);
    let before = processor_seconds();
    let (time, counts) = seconds(1, || stock.cut(&ball, &moves));
    let used = processor_seconds().zip(before).map(|(after, before)| after - before);
    println!("{} lines, {mode:?}: {time:.1} s on the clock", moves.len());
    println!("of the processor: {} s", used.map_or("?".into(), |used| format!("{used:.1}")));
    println!("{} columns a move", counts.columns / moves.len() as u64);
    println!("{:.0} MB for the columns", stock.bytes() as f64 / 1e6);
}

/// What this process has used of a processor, s; known on Linux only.
fn processor_seconds() -> Option<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    let mut fields = stat.rsplit_once(") ")?.1.split(' ').skip(11);
    let mut next = || fields.next()?.parse::<f64>().ok();
    Some((next()? + next()?) / 100.0)
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if let [mode] = &words[..] {
        return million(mode);
    }
    if let [mode, resolution, length] = &words[..]
        && let (Ok(resolution), Ok(length)) = (resolution.parse(), length.parse())
    {
        return once(mode, resolution, length);
    }
    surface();
    pocket();
}

/// Levels of a pocket: columns of the moves' boxes a second, against the least loop.
fn pocket() {
    const LEVELS: u32 = 4;
    const STEP: f64 = 4.0;
    const END: f64 = 5.0;
    let flat = CutterProfile::flat(2.0 * END).expect("a cutter");
    let mut corners = Vec::new();
    for level in 1..=LEVELS {
        let z = -1.5 * f64::from(level);
        let mut y = END + 1.0;
        let mut ends = [END + 1.0, SIDE - END - 1.0];
        while y < SIDE - END {
            corners.extend([[ends[0], y, z], [ends[1], y, z]]);
            ends.swap(0, 1);
            y += STEP;
        }
    }
    let moves = support::path(&corners);
    let swept: f64 = corners
        .windows(2)
        .map(|two| {
            let size = |n: usize| (two[1][n] - two[0][n]).abs() + 2.0 * END;
            size(0) * size(1)
        })
        .sum();
    let mut numbers = vec![0.0_f32; 4096];
    const ROUNDS: usize = 20_000;
    let (least, _) = seconds(3, || {
        for round in 0..ROUNDS {
            let to = -(round as f32);
            for number in &mut numbers {
                *number = number.min(black_box(to));
            }
            black_box(&mut numbers);
        }
    });
    let limit = (ROUNDS * numbers.len()) as f64 / least;
    println!(
        "pocket, flat R5, {LEVELS} levels; columns a second in the moves' boxes, by the least loop"
    );
    println!("cell  sampled certified   (the loop: {:.2} G/s)", limit / 1e9);
    for resolution in [0.05, 0.1, 0.2] {
        let rate = |mode: Mode| {
            let (time, _) = seconds(3, || {
                let mut stock = block(resolution, mode);
                stock.cut(&flat, &moves)
            });
            swept / (resolution * resolution) / time / limit
        };
        println!("{resolution:4} {:8.3} {:9.3}", rate(Mode::Sampled), rate(Mode::Certified));
    }
}
