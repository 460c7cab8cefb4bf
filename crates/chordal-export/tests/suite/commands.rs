use std::f64::consts::TAU;
use std::io::Write;

use chordal::control::{ArcShape, AxisMask, Feed, FeedAlong, FeedMode, Move, Origin, RapidPath};
use chordal::geometry::Plane;
use chordal::machine::AXES;
use chordal::{Command, CommandKind, Job};
use chordal_export::{CanonWriter, CommandJsonLines, CommandWriter, OutputFormat};

use crate::common::{SMALL, job};

fn commands(job: &Job) -> Vec<Command> {
    let mut commands = Vec::new();
    job.report_of_commands(|command| commands.push(command.clone()));
    commands
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

fn json_lines(job: &Job, commands: &[Command]) -> String {
    let mut writer = CommandJsonLines::new(Vec::new(), job).unwrap();
    commands.iter().for_each(|command| writer.command(command).unwrap());
    text(writer.finish().unwrap())
}

#[test]
fn json_lines_of_a_small_job() {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    insta::assert_snapshot!(json_lines(&job, &commands(&job)));
}

#[test]
fn csv_of_a_small_job() {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    let mut writer = CommandWriter::new(Vec::new(), OutputFormat::Csv, &job, false).unwrap();
    commands(&job).iter().for_each(|command| writer.command(command).unwrap());
    insta::assert_snapshot!(text(writer.finish().unwrap()));
}

#[test]
fn canonical_text_of_a_small_job() {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    let mut writer = CanonWriter::new(Vec::new(), &job).unwrap();
    commands(&job).iter().for_each(|command| writer.command(command).unwrap());
    insta::assert_snapshot!(text(writer.finish().unwrap()));
}

fn helix(sweep: f64, radius_to: f64, feed: Feed) -> Command {
    let motion = Move {
        from: [10.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        to: [radius_to, 0.0, -3.0, 0.0, 0.0, 0.0],
        from_known: AxisMask::ALL,
        to_known: AxisMask::LINEAR,
    };
    let shape =
        ArcShape { plane: Plane::Xy, center: [0.0, 0.0], sweep, radius_from: 10.0, radius_to };
    Command {
        kind: CommandKind::Arc { motion, shape, feed },
        origin: Origin { line: 7, ..Origin::default() },
    }
}

const FEED: Feed = Feed {
    value: 10.0,
    mode: FeedMode::PerTime,
    along: FeedAlong::Path,
    spindle_rev_per_s: 5.0,
    lead_change: 0.0,
    surface: None,
};

fn object(command: &Command) -> serde_json::Value {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    let lines = json_lines(&job, std::slice::from_ref(command));
    serde_json::from_str(lines.lines().nth(1).unwrap()).unwrap()
}

#[test]
fn feeds_of_every_mode_are_per_minute() {
    let length = (TAU * 10.0).hypot(3.0);
    let cases = [
        (FeedMode::PerTime, FeedAlong::Path, 600.0),
        (FeedMode::PerRevolution, FeedAlong::Path, 3000.0),
        (FeedMode::InverseTime, FeedAlong::Path, 600.0 * length),
        (FeedMode::InverseTime, FeedAlong::Plane, 600.0 * TAU * 10.0),
    ];
    for (mode, along, expected) in cases {
        let object = object(&helix(TAU, 10.0, Feed { mode, along, ..FEED }));
        assert!((object["feed"].as_f64().unwrap() - expected).abs() < 1e-8, "{object}");
        assert!((object["length"].as_f64().unwrap() - length).abs() < 1e-8);
        assert_eq!(object.get("feed_mode").is_some(), mode != FeedMode::PerTime);
        assert_eq!(object.get("feed_along").is_some(), along == FeedAlong::Plane);
    }
    let none = object(&helix(TAU, 10.0, Feed { value: f64::NAN, ..FEED }));
    assert!(none["feed"].is_null());
}

#[test]
fn every_line_is_an_object_of_the_schema() {
    let job = job("haas-vf2", "a \"name\"\\with\n signs Ø.nc", SMALL);
    let lines = json_lines(&job, &commands(&job));
    let mut objects = lines.lines().map(|line| {
        serde_json::from_str::<serde_json::Value>(line).unwrap_or_else(|error| {
            panic!("{error}: {line}");
        })
    });
    let header = objects.next().unwrap();
    assert_eq!(header["schema"], "chordal.commands/1");
    assert_eq!(header["program"], "a \"name\"\\with\n signs Ø.nc");
    for object in objects {
        assert!(object["line"].is_u64() && object["kind"].is_string(), "{object}");
    }
}

#[test]
fn turns_and_unequal_radii_are_told_in_canonical_text() {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    let mut writer = CanonWriter::new(Vec::new(), &job).unwrap();
    writer.command(&helix(-2.5 * TAU, 10.0, FEED)).unwrap();
    writer.command(&helix(TAU, 12.0, FEED)).unwrap();
    let text = text(writer.finish().unwrap());
    let lines: Vec<&str> = text.lines().skip(3).collect();
    assert_eq!(
        lines,
        [
            "N7 SET_FEED_RATE(600.000000)",
            "N7 ARC_FEED(10.000000, 0.000000, 0.000000, 0.000000, -3, -3.000000, 0.000000, \
             0.000000, 0.000000)",
            "N7 ARC_FEED(12.000000, 0.000000, 0.000000, 0.000000, 1, -3.000000, 0.000000, \
             0.000000, 0.000000) ; radius 10.000000 to 12.000000",
        ]
    );
}

#[test]
fn numbers_that_are_none_are_null() {
    let mut command = helix(TAU, 10.0, FEED);
    command.kind = CommandKind::Rapid {
        motion: Move {
            from: [f64::NAN, f64::INFINITY, -0.0, 0.0, 0.0, 0.0],
            to: [0.0; AXES],
            from_known: AxisMask::NONE,
            to_known: AxisMask::ALL,
        },
        path: RapidPath::Straight,
    };
    let object = object(&command);
    assert!(object["from"]["X"].is_null() && object["from"]["Y"].is_null());
    assert_eq!(object["from"]["Z"].to_string(), "0");
    assert_eq!(object["from_unknown"], serde_json::json!(["X", "Y", "Z"]));
}

/// An output that is full after a few bytes.
struct Full(usize);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0 = self.0.checked_sub(bytes.len()).ok_or(std::io::ErrorKind::StorageFull)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_full_disk_is_told() {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    let mut writer = CommandJsonLines::new(Full(400), &job).unwrap();
    let all = commands(&job);
    assert!(all.iter().any(|command| writer.command(command).is_err()));
}

const SPLINE: &[u8] = b"G21 G90 G17 S900 M3 F600
G0 X0 Y0 Z0
G5 I0 J3 P0 Q-3 X1 Y1
G5.2 X2 Y2 P1
X3 Y1 P2
G5.3
M2
";

#[test]
fn splines_are_of_a_kind_of_their_own() {
    let job = job("linuxcnc-mill", "spline.nc", SPLINE);
    let commands = commands(&job);
    let lines: Vec<serde_json::Value> = json_lines(&job, &commands)
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .filter(|object: &serde_json::Value| object["kind"] == "spline")
        .collect();
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[0]["order"], 4);
    assert_eq!(lines[0]["y"], serde_json::json!([0, 3, -2, 1]));
    assert_eq!(lines[1]["weights"], serde_json::json!([1, 1, 2]));
    assert_eq!(lines[1]["feed"].as_f64(), Some(600.0));

    let mut writer = CommandWriter::new(Vec::new(), OutputFormat::Csv, &job, false).unwrap();
    commands.iter().for_each(|command| writer.command(command).unwrap());
    let csv = text(writer.finish().unwrap());
    assert_eq!(csv.lines().filter(|line| line.contains(",spline,")).count(), 2);

    let mut writer = CanonWriter::new(Vec::new(), &job).unwrap();
    commands.iter().for_each(|command| writer.command(command).unwrap());
    let canon = text(writer.finish().unwrap());
    let first = "N3 NURBS_FEED(4, 0.000000, 0.000000, 1.000000, 0.000000, 3.000000, 1.000000, ";
    assert!(canon.contains(first), "{canon}");
}

/// Each move of a canonical text with its plane and the last call of each part of its frame, numbers as thousandths.
fn canonical_moves(text: &str) -> Vec<(String, Vec<i64>)> {
    let (mut plane, mut frame) =
        (String::from("XY"), [vec![1, 0, 0, 0, 0, 0, 0], vec![0; 6], vec![0]]);
    let mut moves = Vec::new();
    for line in text.lines() {
        let call = line.trim_start().trim_start_matches(|c: char| c == 'N' || c.is_ascii_digit());
        let Some((name, rest)) = call.trim_start_matches(['.', ' ']).split_once('(') else {
            continue;
        };
        let rest = rest.trim_end_matches(')');
        let numbers =
            || rest.split(", ").map(|part| (part.parse::<f64>().unwrap() * 1e3).round() as i64);
        match name {
            "SELECT_PLANE" => plane = rest[rest.len() - 2..].to_string(),
            "SET_G5X_OFFSET" => frame[0] = numbers().collect(),
            "SET_G92_OFFSET" => frame[1] = numbers().collect(),
            "SET_XY_ROTATION" => frame[2] = numbers().collect(),
            "STRAIGHT_TRAVERSE" | "STRAIGHT_FEED" => {
                moves.push((name.to_string(), numbers().chain(frame.concat()).collect()));
            }
            "ARC_FEED" => {
                moves.push((format!("{name} {plane}"), numbers().chain(frame.concat()).collect()));
            }
            _ => {}
        }
    }
    moves
}

/// Held against what LinuxCNC's own interpreter (`rs274 -g`) prints for the same blocks: places before the turn, and what lies
/// between them and the machine. `tools/canon_rs274.py` compares random programs.
#[test]
fn canonical_places_are_those_before_a_turn_with_its_frame() {
    let program = b"G21 G90 G17 G40 F300\nG10 L2 P1 X3.5 Y-2 R40\nG0 X8 Y3 Z2\nG92 X1.5 Y-6\nG0 X4 Y2.5 Z1\n\
        G3 X8 Y2.5 I2 J0\nG52 X-3 Z4\nG1 X5 Y1 Z-2\nG18 G2 X9 Z-2 I2 K0\nG55\nG10 L2 P2 R180\nG0 X2 Y7 Z3\n\
        G18 G3 X-4 Z3 I-3 K0\nG19 G2 Y7 Z3 J2.5 K-1\nG92.1\nG17 G0 X1 Y2 Z8\nM2\n";
    let job = job("linuxcnc-mill", "turned.ngc", program);
    let mut writer = CanonWriter::new(Vec::new(), &job).unwrap();
    commands(&job).iter().for_each(|command| writer.command(command).unwrap());
    let text = text(writer.finish().unwrap());
    let printed = "\
        N..... SET_G5X_OFFSET(1, 3.5000, -2.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SET_XY_ROTATION(40.0000)\n\
        N..... STRAIGHT_TRAVERSE(8.0000, 3.0000, 2.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SET_G92_OFFSET(6.5000, 9.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... STRAIGHT_TRAVERSE(4.0000, 2.5000, 1.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... ARC_FEED(8.0000, 2.5000, 6.0000, 2.5000, 1, 1.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SET_G92_OFFSET(-3.0000, 9.0000, 4.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... STRAIGHT_FEED(5.0000, 1.0000, -2.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SELECT_PLANE(CANON_PLANE_XZ)\n\
        N..... ARC_FEED(-2.0000, 9.0000, -2.0000, 7.0000, -1, 1.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SET_G5X_OFFSET(2, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SET_G92_OFFSET(-3.0000, 9.0000, 4.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SET_XY_ROTATION(0.0000)\n\
        N..... SET_G5X_OFFSET(2, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SET_XY_ROTATION(180.0000)\n\
        N..... STRAIGHT_TRAVERSE(2.0000, 7.0000, 3.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SELECT_PLANE(CANON_PLANE_XZ)\n\
        N..... ARC_FEED(3.0000, -4.0000, 3.0000, -1.0000, 1, 7.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SELECT_PLANE(CANON_PLANE_YZ)\n\
        N..... ARC_FEED(7.0000, 3.0000, 9.5000, 2.0000, -1, -4.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SET_G92_OFFSET(0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n\
        N..... SELECT_PLANE(CANON_PLANE_XY)\n\
        N..... STRAIGHT_TRAVERSE(1.0000, 2.0000, 8.0000, 0.0000, 0.0000, 0.0000)\n";
    assert_eq!(canonical_moves(&text), canonical_moves(printed), "{text}");
    assert_eq!(canonical_moves(printed).len(), 9);
}
