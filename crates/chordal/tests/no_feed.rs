//! Cuts without a feed take no time that anybody knows: the summary and the planner count none of them, and as many.

use chordal::motion::MotionOptions;
use chordal::{Job, Machine, Source, SourceMap};

const MILLS: [&str; 9] = [
    "fanuc-0i",
    "haas-vf2",
    "mitsubishi-m700",
    "fadal-4020",
    "linuxcnc-mill",
    "mach3-mill",
    "fanuc-6m",
    "tormach-pathpilot",
    "textbook-absolute-center",
];

fn job(machine: &str, text: &str) -> Job<'static> {
    let machine = Machine::from_builtin(machine).unwrap();
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    Job::new(sources, machine).unwrap()
}

/// Cuts without a feed and the time of cuts, as the summary and as the planner have them.
fn counted(machine: &str, text: &str) -> [(u64, f64); 2] {
    let job = job(machine, text);
    let summary = job.report().summary;
    let timed = job.time(&MotionOptions::default()).unwrap();
    [
        (summary.cuts_without_time, summary.feed_time_s),
        (timed.motion.cuts_without_feed, timed.time.times.cutting_s),
    ]
}

#[test]
fn cuts_without_a_feed_are_not_timed() {
    let head = "G21 G90 G94 G17 G40 G54\nS900 M3\nG0 X0 Y0 Z5.\n";
    // The cuts of each, all of them without a feed.
    let bodies = [
        ("G1 Z-2.\nX30.\nY7. Z-3.\n", 3),
        ("G1 F0 X10.\nX30.\n", 2),
        ("G1 X4. Y4.\nG2 X10. Y10. I6. J0.\nG3 X4. Y4. R6.\n", 3),
        // Per minute, and per revolution of a spindle that stands.
        ("S0 M5\nG95 G1 X9. F.2\nY3.\nG94\n", 2),
    ];
    for machine in MILLS {
        // A Fadal has no feed per revolution.
        let has_revolutions = machine != "fadal-4020";
        for (body, cuts) in
            bodies.into_iter().filter(|(body, _)| has_revolutions || !body.contains("G95"))
        {
            let text = format!("{head}{body}G0 Z50.\nM30\n");
            let [summary, timed] = counted(machine, &text);
            assert_eq!(summary, (cuts, 0.0), "{machine}, summary\n{text}");
            assert_eq!(timed, (cuts, 0.0), "{machine}, planner\n{text}");
        }
        // With a feed after it both count what has one: 60 mm at 600 mm/min, and more for the ramps.
        let text = format!("{head}G1 X20.\nX80. F600.\nG0 Z50.\nM30\n");
        let [summary, timed] = counted(machine, &text);
        assert_eq!((summary.0, timed.0), (1, 1), "{machine}");
        assert!((summary.1 - 6.0).abs() < 1e-9, "{machine}: {}", summary.1);
        assert!(timed.1 >= 6.0 - 1e-9 && timed.1 < 6.5, "{machine}: {}", timed.1);
    }
}

#[test]
fn a_feed_of_the_control_itself_counts() {
    // Marlin starts with a feed of its own.
    let text = "G21\nG90\nG0 X0 Y0 Z5\nG1 X30\nG1 Y7\nG0 Z50\n";
    let [summary, timed] = counted("marlin-router", text);
    assert_eq!((summary.0, timed.0), (0, 0));
    assert!(summary.1 > 0.0 && timed.1 >= summary.1 - 1e-9, "{summary:?} {timed:?}");
}

#[test]
fn cuts_per_revolution_of_a_spindle_that_stands_are_not_timed() {
    for machine in ["fanuc-lathe", "haas-lathe", "mitsubishi-lathe", "linuxcnc-lathe"] {
        let text = "G21 G18 G40 G95\nG0 X40. Z2.\nG1 Z-20. F.25\nX44.\nG0 Z2.\nM30\n";
        let text =
            if machine == "linuxcnc-lathe" { text.to_string() } else { text.replace("G95", "G99") };
        let [summary, timed] = counted(machine, &text);
        assert_eq!((summary, timed), ((2, 0.0), (2, 0.0)), "{machine}");
    }
}
