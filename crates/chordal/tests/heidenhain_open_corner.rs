//! M98: the tool goes past an open inside corner to the end of its element, and from there to the start of the next.

use chordal::control::Origin;
use chordal::path::PathCommand;
use chordal::{Diagnostic, Job, Machine, PathSink, RunOptions, Severity, Source, SourceMap};

#[derive(Default)]
struct Centres {
    ends: Vec<[f64; 2]>,
    found: Vec<Diagnostic>,
}

impl PathSink for Centres {
    fn command(&mut self, path: PathCommand<'_>) {
        if let Some(motion) = path.command.kind.motion() {
            self.ends.push([motion.to[0], motion.to[1]]);
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &Origin) {
        self.found.push(diagnostic);
    }
}

/// The ends of the moves of the tool's centre, after the approach.
fn path(contour: &str, tool: f64) -> (Vec<[f64; 2]>, Vec<Diagnostic>) {
    let text = format!(
        "BEGIN PGM T MM\nTOOL DEF 1 L+0 R+{tool}\nTOOL CALL 1 Z S1000\nL X+0 Y+100 R0 FMAX M3\nL Z-2 F100\n{contour}\n\
         L Z+50 FMAX\nM30\nEND PGM T MM\n"
    );
    let mut machine = Machine::from_builtin("heidenhain-mill").expect("a built-in machine");
    machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = Some((-1000.0, 1000.0)));
    machine.work_offsets.entry("G54".to_string()).or_default().values = [Some(0.0); 6];
    let mut sources = SourceMap::new();
    sources.add(Source::new("T.H", text.into_bytes()));
    let mut centres = Centres::default();
    let job = Job::new(sources, machine).expect("a job").options(RunOptions::default());
    job.compensated(None, &mut centres);
    (centres.ends, centres.found)
}

fn has(ends: &[[f64; 2]], expected: &[[f64; 2]]) -> bool {
    let near = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-6;
    ends.windows(expected.len()).any(|own| own.iter().zip(expected).all(|(a, b)| near(a, b)))
}

#[test]
fn open_corners_are_cut_to_the_ends_of_both_elements() {
    for tool in [3.0, 5.0, 8.0] {
        for (side, sign) in [("RL", 1.0), ("RR", -1.0)] {
            // Down to a corner, and away from it: for RL to +X, for RR to -X.
            let out = sign * 60.0;
            let contour = |m: &str| {
                format!("L X+0 Y+50 {side} F200\nL Y+0 {m}\nL X{out:+}\nL X{out:+} Y+90 R0")
            };
            let (ends, _) = path(&contour(""), tool);
            let inner = [sign * tool, tool];
            assert!(has(&ends, &[inner]), "without M98: {ends:?}");
            let (ends, found) = path(&contour("M98"), tool);
            let expected = [[sign * tool, 50.0], [sign * tool, 0.0], [0.0, tool], [out, tool]];
            assert!(has(&ends, &expected), "{side} R{tool}: {ends:?} lacks {expected:?}");
            assert!(!has(&ends, &[inner]));
            // No gouge is reported, and that the path between is assumed is said once.
            let said: Vec<&str> = found
                .iter()
                .filter(|own| own.severity != Severity::Note)
                .map(|own| own.code.id())
                .collect();
            assert_eq!(said, [""; 0], "{found:?}");
            assert_eq!(found.iter().filter(|own| own.code.id() == "CH829").count(), 1);
        }
    }
}

#[test]
fn it_acts_in_its_block_and_at_inside_corners_alone() {
    // The second inside corner is passed as any other.
    let (ends, _) = path("L X+0 Y+50 RL F200\nL Y+0 M98\nL X+60\nL Y+40\nL X+60 Y+90 R0", 5.0);
    assert!(has(&ends, &[[5.0, 0.0], [0.0, 5.0], [55.0, 5.0], [55.0, 40.0]]), "{ends:?}");
    // An outside corner keeps its arc about the corner.
    let outside =
        |m: &str| path(&format!("L X+0 Y+50 RL F200\nL Y+0 {m}\nL X-60\nL X-60 Y-90 R0"), 5.0).0;
    assert_eq!(outside("M98"), outside(""));
    assert!(has(&outside("M98"), &[[5.0, 0.0], [0.0, -5.0]]));
}
