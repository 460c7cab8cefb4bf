//! Which piece of path a step of the motion is on, pieces of axes that the program never names, and in
//! work offsets of unknown relation.

use chordal::control::AxisMask;
use chordal::geometry::ParamCurve;
use chordal::motion::{MotionOptions, MotionStep, StepKind, StepSource};
use chordal::path::NotNamed;
use chordal::{Job, Machine, Segment, SegmentKind, Source, SourceMap};

const Y: AxisMask = AxisMask(0b010);
const Z: AxisMask = AxisMask(0b100);

fn job<'a>(machine: &str, text: &'a str) -> Job<'a> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.nc", text.as_bytes()));
    Job::new(sources, Machine::from_builtin(machine).expect("a machine")).expect("a job")
}

fn path(job: &Job) -> Vec<Segment> {
    let mut segments = Vec::new();
    job.path(|segment| segments.push(*segment));
    segments
}

/// Every step of a move is on a piece of its block and kind, in order, and every piece that moves has one.
#[track_caller]
fn steps_are_on_their_pieces(machine: &str, text: &str) {
    let job = job(machine, text);
    let pieces = path(&job);
    let mut sources: Vec<StepSource> = Vec::new();
    let options = MotionOptions { dog_leg_shape: true, ..MotionOptions::default() };
    let sink = |step: &MotionStep, source: &StepSource| {
        if matches!(step, MotionStep::Move(_)) {
            sources.push(*source);
        }
        Ok(())
    };
    let _ = job.motion(&options, sink).expect("limits");
    let mut stepped = vec![false; pieces.len()];
    let mut last = 0;
    for source in &sources {
        assert!(source.piece >= last, "line {}", source.origin.line);
        last = source.piece;
        let piece = &pieces[source.piece as usize];
        assert_eq!(piece.origin, source.origin);
        assert_eq!(StepKind::Move(piece.kind), source.kind);
        stepped[source.piece as usize] = true;
    }
    for (piece, stepped) in pieces.iter().zip(stepped) {
        assert_eq!(stepped, piece.length_mm > 0.0, "line {}", piece.origin.line);
    }
}

#[test]
fn steps_of_moves_in_parts_are_on_their_piece() {
    // The spindle reaches a limit within the cuts, which part there: several steps a piece.
    steps_are_on_their_pieces(
        "fanuc-lathe",
        "G21 G40 G99\nT0101\nG50 S1500\nG96 S180 M3\nG0 X62. Z2.\nZ0\nG1 X-1.6 F0.2\nG50 S900\nG0 Z2.\nX40.\n\
         G1 Z-30.\nG50 S2000\nG2 X60. Z-40. R10.\nG4 U0.5\nG1 X64.\nG97 S500\nG0 X100. Z100.\nM30\n",
    );
    // Rapids with corners, a cycle with many moves of one block, a whole circle.
    steps_are_on_their_pieces(
        "haas-vf2",
        "G21 G17 G40 G80 G90 G94\nT1 M6\nS3000 M3\nG0 X0 Y0\nZ25.\nG83 X5. Z-9. R2. Q4. F200.\nX90. Y30.\nG80\n\
         G0 X80. Y5.\nG1 Z-1.\nG2 I-10.\nG0 Z25.\nM30\n",
    );
    // A spline has several steps for each of its spans.
    steps_are_on_their_pieces(
        "linuxcnc-mill",
        "G21 G90 G61 S600 M3 F6000\nG0 X0 Y0 Z0\nG5.2 X10 Y20 P1 L4\nX30 Y30 P2\nX50 Y0 P1\nX70 Y10 P1\nG5.3\nG1 X0\nM2\n",
    );
}

/// Which pieces of a program are drawn, by their lines.
fn drawn(job: &Job) -> Vec<u32> {
    let pieces = path(job);
    pieces.iter().filter(|piece| piece.is_drawn()).map(|piece| piece.origin.line).collect()
}

#[test]
fn an_axis_that_is_never_named_lies_at_zero() {
    let turned = job(
        "haas-vf2",
        "G21 G18 G90\nS1000 M3\nG0 X0 Z5.\nG1 X10. Z-5. F100.\nG2 X20. Z-5. R5.\nM30\n",
    );
    assert_eq!(turned.not_named_axes().never, Y);
    // The first move comes from where nobody knows.
    assert_eq!(drawn(&turned), [4, 5]);
    assert!(path(&turned).iter().all(|piece| piece.curve.bounds().max.y == 0.0));
    // A shift is no place.
    let shifted =
        job("haas-vf2", "G21 G18 G90\nS1000 M3\nG52 Y7.\nG0 X0 Z5.\nG1 X10. Z-5. F100.\nM30\n");
    assert_eq!(shifted.not_named_axes().never, Y);
    assert_eq!(drawn(&shifted), [5]);
    assert!(path(&shifted).iter().all(|piece| piece.curve.bounds().max.y == 0.0));
    let flat = job("linuxcnc-mill", "G21 G90\nG0 X0 Y0\nG1 X10 F100\nY10\nM2\n");
    assert_eq!(flat.not_named_axes().never, Z);
    assert_eq!(drawn(&flat), [3, 4]);
}

#[test]
fn an_axis_that_is_named_later_is_not_known_before() {
    let late = job("linuxcnc-mill", "G21 G90\nG0 X0 Y0\nG1 X10 F100\nZ-1\nX0\nM2\n");
    assert_eq!(late.not_named_axes(), NotNamed::NONE);
    assert_eq!(drawn(&late), [5]);
    // In no cut: a contour of which the rest is missing. What names it is not drawn from zero.
    let part = job("linuxcnc-mill", "G21 G90\nG0 X0 Y0\nG1 X10 F100\nY10\nG0 Z5\nX0\nM2\n");
    assert_eq!(part.not_named_axes(), NotNamed { in_no_cut: Z, ..NotNamed::NONE });
    assert_eq!(drawn(&part), [3, 4, 6]);
    // Nothing is named: there is nothing to draw.
    let nothing = job("haas-vf2", "G91 G28 X0 Y0 Z0\nM30\n");
    assert_eq!(nothing.not_named_axes(), NotNamed::NONE);
    assert!(drawn(&nothing).is_empty());
    // To the reference point, and there is no work offset: where that is on the part is not known.
    let home = job(
        "haas-vf2",
        "G21 G90\nS1000 M3\nG0 X0 Y0\nZ5.\nG1 X10. F100.\nG91 G28 Z0\nG90\nG1 X20.\nG0 Z5.\nG1 X30.\nM30\n",
    );
    assert_eq!(drawn(&home), [5, 10]);
}

#[test]
fn a_machine_that_knows_where_it_stands_needs_no_name() {
    // Y-50 of the machine is the zero of the part, so the machine's zero is Y50: nothing is assumed.
    let text = "inherits = \"haas-vf2\"\n[work_offsets.G54]\nX = \"-100 mm\"\nY = \"-50 mm\"\nZ = \"-200 mm\"\n";
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("m.toml", text, &none).expect("a machine");
    let mut sources = SourceMap::new();
    sources
        .add(Source::new("t.nc", &b"G21 G18 G90\nS1000 M3\nG0 X0 Z5.\nG1 X10. F100.\nM30\n"[..]));
    let job = Job::new(sources, machine).expect("a job");
    assert_eq!(job.not_named_axes(), NotNamed::NONE);
    assert!(path(&job).iter().all(|piece| piece.curve.end().y == 50.0));
}

/// A cut along X in each of these frames, which are lines of the program before it.
fn in_frames(frames: &[&str]) -> String {
    let mut text = String::from("G21 G17 G90\nS1000 M3\n");
    for frame in frames {
        text += &format!("{frame}\nG0 X0 Y0\nZ5.\nG1 Z-1. F100.\nX10.\nG0 Z5.\n");
    }
    text + "M30\n"
}

/// The ends of the cuts along X that are drawn, and the systems of those that are not.
fn ends_of_cuts(machine: Machine, text: &str) -> (Vec<f64>, Vec<String>, Vec<(f64, f64)>) {
    let mut sources = SourceMap::new();
    sources.add(Source::new("t.nc", text.as_bytes()));
    let job = Job::new(sources, machine).expect("a job");
    let (mut drawn, mut left_out) = (Vec::new(), Vec::new());
    let naming = job.profile().work_names;
    for piece in path(&job).iter().filter(|piece| piece.kind == SegmentKind::Line) {
        let (start, end) = (piece.curve.start(), piece.curve.end());
        if start.x == end.x {
            continue;
        }
        match piece.unrelated_zero {
            Some(zero) => left_out.push(zero.system.key(naming)),
            None => drawn.push(end.x),
        }
        assert_eq!(piece.is_drawn(), piece.unrelated_zero.is_none());
    }
    let axes = job.report().summary.axes;
    (
        drawn,
        left_out,
        axes.iter().filter(|axis| axis.letter == 'X').map(|axis| axis.range).collect(),
    )
}

fn haas_with(offsets: &str) -> Machine {
    let none = |name: &str| Err(format!("no file {name}"));
    let text = format!("inherits = \"haas-vf2\"\n{offsets}");
    Machine::from_toml("m.toml", &text, &none).expect("a machine")
}

#[test]
fn moves_in_a_work_offset_of_unknown_relation_are_not_drawn_over_others() {
    let both = "[work_offsets]\nG54 = { X = \"-100 mm\", Y = \"-50 mm\", Z = \"-200 mm\" }\n\
                G55 = { X = \"-70 mm\", Y = \"-50 mm\", Z = \"-200 mm\" }\n";
    let first = "[work_offsets]\nG54 = { X = \"-100 mm\", Y = \"-50 mm\", Z = \"-200 mm\" }\n";
    let known_x = "[work_offsets]\nG54 = { X = \"-100 mm\", Y = \"-50 mm\", Z = \"-200 mm\" }\n\
                   G55 = { X = \"-70 mm\", Y = \"-50 mm\" }\n";
    let text = in_frames(&["G54", "G55", "G54"]);
    let two = || vec!["G55".to_string()];
    // The machine stands at its X0, which is X100 of G54.
    let placed = (vec![10.0, 40.0, 10.0], vec![], vec![(0.0, 100.0)]);
    assert_eq!(ends_of_cuts(haas_with(both), &text), placed);
    for offsets in ["", first, known_x] {
        // Back in G54 it is where it was before.
        let found = ends_of_cuts(haas_with(offsets), &text);
        assert_eq!((&found.0, &found.1), (&vec![10.0, 10.0], &two()), "{offsets}");
    }
    // The ranges are those of what has a place; X of G55 has one where it is given.
    assert_eq!(ends_of_cuts(haas_with(""), &text).2, [(0.0, 10.0)]);
    let only_z = "[work_offsets]\nG54 = { Z = \"-200 mm\" }\nG55 = { Z = \"-200 mm\" }\n";
    assert_eq!(ends_of_cuts(haas_with(only_z), &text).2, [(0.0, 10.0)]);
}

#[test]
fn shifts_of_a_work_offset_that_is_not_given_are_drawn_where_they_are() {
    let shifted = in_frames(&["G54", "G52 X50.", "G52 X0", "G92 X-20."]);
    let (drawn, left_out, range) = ends_of_cuts(haas_with(""), &shifted);
    // After the third cut the tool is at X10, which G92 calls X-20: zero is at 30.
    assert_eq!((drawn, left_out, range), (vec![10.0, 60.0, 10.0, 40.0], vec![], vec![(0.0, 60.0)]));
    // A preset where nobody knows the tool to be.
    let home = "G21 G17 G90\nS1000 M3\nG54 G0 X0 Y0\nZ5.\nG1 Z-1. F100.\nX10.\nG0 Z5.\nG91 G28 X0\nG90 G92 X0\n\
                G0 X0\nG1 X7.\nM30\n";
    assert_eq!(ends_of_cuts(haas_with(""), home).1, ["G54"]);
}

#[test]
fn a_jog_to_the_part_before_its_zero_is_set_hides_nothing() {
    let text =
        "$X\nG21 G90\n$J=G91 X12 F500\nG10 L20 P1 X0 Y0 Z0\nG0 Z5\nG0 X0 Y0\nG1 Z-1 F30\nG1 X30\n";
    assert!(drawn(&job("grbl", text)).ends_with(&[7, 8]), "the cuts");
}

#[test]
fn rapids_alone_have_the_frame_of_the_first_of_them() {
    let text = "G21 G90\nG54 G0 X0 Y0 Z5.\nX10.\nG55 G0 X0 Y0 Z5.\nX100.\nM30\n";
    assert_eq!(drawn(&job("haas-vf2", text)), [3]);
}
