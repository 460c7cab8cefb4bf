//! Lasers on GRBL, grblHAL and FluidNC: where another power stops the axes.

use chordal::motion::{
    MotionOptions, PlanSink, PlannerStep, StepKind, StepSource, StepSources, WaitKind,
};
use chordal::{Job, Machine, Source, SourceMap};

/// How often the axes stand for the spindle output, and the time of the program.
#[derive(Default)]
struct Stops {
    stops: usize,
    seconds: f64,
}

impl PlanSink for Stops {
    fn step(&mut self, step: PlannerStep<'_>, sources: &StepSources) {
        match step {
            PlannerStep::Trajectory(stretch) => {
                self.seconds += stretch.duration_s() - stretch.overlap_s
            }
            PlannerStep::Wait { seconds, tag } => {
                self.seconds += seconds;
                if let Some(StepSource { kind: StepKind::Wait(WaitKind::SpindleSpeed), .. }) =
                    sources.get(tag)
                {
                    self.stops += 1;
                }
            }
        }
    }
}

fn stops(machine: &str, setting: &str, program: &str) -> Stops {
    let mut machine = Machine::from_builtin(machine).expect("a built-in machine");
    if !setting.is_empty() {
        machine.set(setting).expect("a setting of this machine");
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("laser.nc", program.as_bytes()));
    let job = Job::new(sources, machine).expect("a machine of its own control");
    let mut found = Stops::default();
    job.plan(&MotionOptions::default(), &mut found).expect("limits of the machine");
    found
}

/// Machines and their setting of laser mode.
const LASERS: [(&str, &str); 4] = [
    ("grbl", "settings.$32=1"),
    ("grblhal", "settings.$32=on"),
    ("fluidnc", "settings.laser_mode=on"),
    // A laser by its machine file.
    ("openbuilds-acro-1010", ""),
];

const HEAD: &str = "G21 G90 G94\nG0 X0 Y0\n";

#[test]
fn power_beside_a_motion_does_not_stop_the_axes() {
    let rows = [
        // Two stops: M4 switches the laser on, and M2 switches it off.
        ("M4 S0 F3000\nG1 X10 S100\nX20 S200\nX30 S0\n", 2),
        ("M3 S100 F3000\nG1 X10\nX20 S200\nG0 X30 S0\nG1 X40 S300\n", 2),
        ("M4 S0 F3000\nG1 X10 S100\nG2 X20 I5 S200\nX30 Y0 I5 S100\n", 2),
        // S alone stops, in a block with modes alone too.
        ("M4 S0 F3000\nG1 X10 S100\nS200\nX20\n", 3),
        ("M3 S10 F3000\nG1 X10\nG1 S20\nX20\nF1000 S30\nX30\n", 4),
        // The same power again is no change.
        ("M4 S100 F3000\nG1 X10 S100\nS100\nX20\n", 2),
        // Off, and on again.
        ("M4 S100 F3000\nG1 X10\nM5\nG0 X20\nM4\nG1 X30\nM5\n", 4),
        // A power while the laser is off is kept for the next M3.
        ("F3000 S100\nG1 X10\nS200\nX20\nM3\nX30\n", 2),
    ];
    for (machine, setting) in LASERS {
        for (text, expected) in rows {
            let found = stops(machine, setting, &format!("{HEAD}{text}M2\n"));
            assert_eq!(found.stops, expected, "{machine}: {text}");
        }
    }
}

#[test]
fn a_raster_takes_the_time_of_its_line() {
    let rows: String =
        (1..=1000).map(|n| format!("X{:.1} S{}\n", 0.1 * f64::from(n), n % 2 * 500)).collect();
    let raster = format!("{HEAD}M4 S0\nG1 F3000\n{rows}M2\n");
    let same = rows.replace("S500", "").replace("S0", "");
    let line = format!("{HEAD}M4 S0\nG1 F3000\n{same}M2\n");
    for (machine, setting) in LASERS {
        let [raster, line] = [&raster, &line].map(|text| stops(machine, setting, text).seconds);
        assert!((raster - line).abs() < 1e-6 * line, "{machine}: {raster} s, not {line} s");
    }
}

#[test]
fn without_laser_mode_each_speed_stops() {
    let text = format!("{HEAD}M4 S50 F3000\nG1 X10 S100\nX20 S200\nX30 S300\nM2\n");
    for (machine, setting) in
        [("grbl", ""), ("grblhal", ""), ("fluidnc", ""), ("openbuilds-acro-1010", "settings.$32=0")]
    {
        assert_eq!(stops(machine, setting, &text).stops, 5, "{machine}");
    }
}
