//! The pull side allocates and frees nothing, whatever happens. A program of its own, without the
//! test harness: what other threads allocate would be counted, too.

mod support;

use std::alloc::System;

use chordal_motion::{PlannerStep, PushOutcome, StreamOptions, stream};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};
use support::law::{Law, circle_trajectory, cut_line};
use support::limits;

#[global_allocator]
static COUNTING: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

fn main() {
    let region = Region::new(COUNTING);
    drop(std::hint::black_box(vec![1_u8; 100]));
    assert_eq!(region.change().allocations, 1, "the counter counts");

    let options = StreamOptions { windows: 4, ..StreamOptions::default() };
    let machine = limits(200.0, 2000.0, 1e5);
    let (mut feeder, mut servo) = stream(machine, options, [5.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let circle = circle_trajectory(5.0, 12.0, 1);
    let end = circle.to();
    let law = Law { speed: 150.0, acceleration: 1900.0, jerk: 9e4 };
    let lines =
        law.trajectory(cut_line([end[0], end[1], 0.0], [end[0] + 60.0, end[1], 0.0], 60_000));
    let mut steps = vec![
        PlannerStep::Trajectory(&circle),
        PlannerStep::Wait { seconds: 0.05, tag: 9 },
        PlannerStep::Trajectory(&lines),
    ]
    .into_iter();
    let mut next = steps.next();
    let mut counts = (0, 0, 0);
    let mut total = 0;
    let mut finished = false;
    while !finished {
        // Now and then the push side is away.
        if total % 1200 < 500 {
            while let Some(step) = next {
                match feeder.push_step(step) {
                    Ok(PushOutcome::Taken) => next = steps.next(),
                    _ => break,
                }
            }
            if next.is_none() {
                feeder.finish();
            }
        }
        let region = Region::new(COUNTING);
        for _ in 0..10 {
            match total % 500 {
                100 => servo.hold(),
                200 => servo.resume(),
                300 => servo.set_override(1.5),
                400 => servo.set_override(0.7),
                450 => servo.set_override(1.0),
                _ => {}
            }
            let point = servo.next();
            finished |= point.finished;
            total += 1;
        }
        let change = region.change();
        counts.0 += change.allocations;
        counts.1 += change.deallocations;
        counts.2 += change.reallocations;
        assert!(total < 100_000, "the end is not reached");
    }
    assert_eq!(counts, (0, 0, 0), "allocations, frees, changes of size in {total} setpoints");
    assert!(total > 1000 && servo.underruns() > 0, "{total} {}", servo.underruns());
}
