//! Sections that are kept for a picture: each is the one before without what its pass takes.

use chordal::stock::section::OutlineSegment;
use chordal::stock::{TurnedOptions, TurnedPiece, TurnedReplay, TurnedReport};
use chordal::{Job, Machine, Source, SourceMap};

const BAR: &str = r#"
machine = "fanuc-lathe"
[stock]
shape = "tube"
diameter = "60 mm"
bore = "20 mm"
from = "-70 mm"
to = "0 mm"
[tools.1]
shape = "insert"
insert = "C"
approach_angle = "95 deg"
flute_length = "12 mm"
nose_radius = "0.8 mm"
tip = 3
holder_outline = [["8 mm", "10 mm"], ["120 mm", "10 mm"], ["120 mm", "35 mm"], ["8 mm", "35 mm"]]
offset.X = "0 mm"
offset.Z = "0 mm"
[tools.2]
shape = "insert"
insert = "D"
approach_angle = "93 deg"
flute_length = "9 mm"
nose_radius = "0.4 mm"
tip = 2
shank_diameter = "12 mm"
max_chip = "0.15 mm"
offset.X = "0 mm"
offset.Z = "0 mm"
[tools.5]
shape = "groove"
width = "3 mm"
corner_radius = "0.2 mm"
flute_length = "22 mm"
tip = 3
offset.X = "0 mm"
offset.Z = "0 mm"
"#;

/// Outside with an arc, a bore with a feed that is too high at its end, a part that comes off.
const RING: &str = "G21 G18 G40 G97 G99 S900 M3
G28 U0 W0
T0101
G0 X64. Z2.
G71 U2. R0.5
G71 P10 Q20 U0 W0 F0.2
N10 G0 X40.
G1 Z-10.
G2 X50. Z-15. R5.
G1 Z-30.
N20 X62.
G0 X100. Z50.
T0202
G0 X24. Z2.
G1 Z-25. F0.1
X26. F0.3
G0 X20.
Z50.
T0505
G0 X64. Z-40.
G1 X19. F0.05
G0 X70.
M30
";

fn replayed() -> (TurnedReport, TurnedReplay) {
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("setup.toml", BAR, &none).expect("a good setup");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", RING.as_bytes().to_vec()));
    let job = Job::new(sources, machine).expect("a job");
    let options = TurnedOptions { replay: true, ..TurnedOptions::default() };
    let none = |name: &str| Err(format!("no file {name}"));
    let mut found = job.turned_stock(&options, &none).expect("stock");
    let replay = found.replay.take().expect("it was asked for");
    (found, replay)
}

/// The area within segments, in any order.
fn area<'s>(segments: impl Iterator<Item = &'s OutlineSegment>) -> f64 {
    segments
        .map(|segment| {
            let bulge = segment.bend.map_or(0.0, |bend| {
                let sweep = segment.sweep();
                bend.radius * bend.radius * (sweep - sweep.sin())
            });
            0.5 * (segment.start.cross(segment.end) + bulge)
        })
        .sum()
}

#[test]
fn every_section_is_the_one_before_without_what_its_pass_takes() {
    let (found, replay) = replayed();
    assert!(replay.is_whole);
    let is_there = |piece: &&TurnedPiece, number: u32| piece.from <= number && number < piece.until;
    let of = |number: u32| {
        area(replay.pieces.iter().filter(|it| is_there(it, number)).map(|it| &it.segment))
    };
    let mut left = found.before.area();
    assert!((of(0) - left).abs() < 1e-9);
    // Five levels, three moves of the contour, two in the bore, the part-off.
    assert_eq!(replay.rows.len(), 11, "{:?}", replay.rows);
    for (number, row) in (1..).zip(&replay.rows) {
        let taken = found.moves.iter().filter(|each| each.row == *row);
        let taken: f64 = taken.map(|each| each.area_mm2).sum();
        assert!(taken > 0.0);
        left -= taken;
        assert!((of(number) - left).abs() < 1e-8, "after row {row}: {} {left}", of(number));
    }
    // Every cut has its section.
    let cuts = found.moves.iter().filter(|each| each.area_mm2 > 0.0).count();
    assert_eq!(cuts, replay.rows.len());
    let last = replay.rows.len() as u32;
    let loose = replay.pieces.iter().filter(|piece| piece.is_loose);
    assert!(loose.clone().all(|piece| piece.from == last));
    assert_eq!(found.loose.len(), 1);
    let off = area(loose.map(|piece| &piece.segment));
    assert!((off - found.loose[0].section.area()).abs() < 1e-9);
}

#[test]
fn surfaces_have_the_tool_that_made_them_and_tools_their_shape() {
    let (found, replay) = replayed();
    let last = replay.rows.len() as u32;
    let made = |diameter: f64| {
        let mut tools: Vec<u32> = replay
            .pieces
            .iter()
            .filter(|piece| piece.until > last && piece.segment.start.b == 0.5 * diameter)
            .filter(|piece| piece.segment.end.b == piece.segment.start.b)
            .map(|piece| piece.segment.tag)
            .collect();
        tools.sort_unstable();
        tools.dedup();
        tools
    };
    assert_eq!((made(40.0), made(24.0), made(60.0)), (vec![1], vec![2], vec![0]));
    let by: Vec<u32> = found
        .section
        .outline()
        .iter()
        .flatten()
        .filter_map(|segment| found.made_by(segment))
        .map(|made_by| made_by.line)
        .collect();
    // Of what is in the chuck the part-off made a face.
    assert!(by.contains(&21), "{by:?}");
    assert_eq!(replay.tools.keys().copied().collect::<Vec<_>>(), [1, 2, 5]);
    assert!(replay.tools.values().all(|tool| !tool.edges.is_empty()));
    assert!(!replay.tools[&1].body.is_empty() && !replay.tools[&2].body.is_empty());
    assert!(replay.tools[&5].body.is_empty());
}

#[test]
fn a_chip_that_is_too_thick_is_marked_at_its_move() {
    let (found, _) = replayed();
    let marked: Vec<u32> = found
        .moves
        .iter()
        .filter(|each| each.overload.is_some())
        .map(|each| each.origin.line)
        .collect();
    assert_eq!(marked, [16]);
}
