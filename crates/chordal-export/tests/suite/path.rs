use std::collections::BTreeMap;

use chordal::geometry::Placement;
use chordal::{Job, Segment, SegmentKind};
use chordal_export::{ChordWriter, DxfWriter, OutputFormat};

use crate::common::{SMALL, job};

fn segments() -> Vec<Segment> {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    let mut segments = Vec::new();
    job.path(|segment| segments.push(*segment));
    segments
}

/// Both formats of text, with a tolerance of so much.
fn writers<'a>(job: &'a Job<'a>, tolerance_mm: f64) -> [ChordWriter<'a, Vec<u8>>; 2] {
    [OutputFormat::Csv, OutputFormat::Jsonl].map(|format| {
        ChordWriter::new(Vec::new(), format, job, (tolerance_mm, Placement::Inscribed)).unwrap()
    })
}

fn lines(writer: ChordWriter<'_, Vec<u8>>) -> Vec<String> {
    let text = String::from_utf8(writer.finish().unwrap()).unwrap();
    text.lines().map(str::to_string).collect()
}

#[test]
fn chords_are_the_same_in_both_formats_and_join() {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    let [mut csv, mut json] = writers(&job, 0.01);
    for segment in segments() {
        csv.segment(&segment).unwrap();
        json.segment(&segment).unwrap();
    }
    let (csv, json) = (lines(csv), lines(json));
    assert_eq!(csv.len(), json.len());
    assert!(csv.len() > 100);
    assert_eq!(
        json[0],
        r#"{"schema":"chordal.chords/1","length_unit":"mm","tolerance_mm":0.01,"placement":"inscribed"}"#
    );
    let mut end: Option<serde_json::Value> = None;
    for (row, line) in csv.iter().zip(&json).skip(1) {
        let object: serde_json::Value = serde_json::from_str(line).unwrap();
        let cells: Vec<&str> = row.split(',').collect();
        assert_eq!(cells.len(), 10);
        assert_eq!(object["line"].to_string(), cells[0]);
        assert_eq!(object["kind"], cells[1]);
        assert_eq!(object["to"]["Y"].as_f64().unwrap(), cells[6].parse::<f64>().unwrap());
        if let Some(end) = end {
            assert_eq!(object["from"], end);
        }
        end = Some(object["to"].clone());
    }
}

#[test]
fn chords_without_a_tolerance_are_refused() {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let cut = (tolerance, Placement::Balanced);
        assert!(ChordWriter::new(Vec::new(), OutputFormat::Csv, &job, cut).is_err());
    }
}

/// Entities of a DXF text as their groups.
fn entities(text: &str) -> Vec<(String, BTreeMap<u32, String>)> {
    let all: Vec<&str> = text.lines().collect();
    assert_eq!(all.len() % 2, 0, "groups are pairs of lines");
    let groups = all.chunks(2).map(|pair| (pair[0].parse::<u32>().unwrap(), pair[1]));
    let mut groups = groups.skip_while(|group| *group != (2, "ENTITIES")).skip(1);
    let mut entities: Vec<(String, BTreeMap<u32, String>)> = Vec::new();
    for (code, value) in groups.by_ref() {
        match (code, entities.last_mut()) {
            (0, _) if value == "ENDSEC" => break,
            (0, _) => entities.push((value.into(), BTreeMap::new())),
            (code, Some((_, entity))) => assert!(entity.insert(code, value.into()).is_none()),
            (code, None) => panic!("group {code} before the first entity"),
        }
    }
    assert_eq!(groups.next(), Some((0, "EOF")));
    entities
}

fn number(entity: &BTreeMap<u32, String>, code: u32) -> f64 {
    entity[&code].parse().unwrap()
}

#[test]
fn dxf_holds_true_arcs() {
    let mut writer = DxfWriter::new(Vec::new(), &job("linuxcnc-mill", "small.nc", SMALL)).unwrap();
    let segments: Vec<Segment> = segments();
    segments.iter().for_each(|segment| writer.segment(segment).unwrap());
    let text = String::from_utf8(writer.finish().unwrap()).unwrap();
    let entities = entities(&text);
    let count = |name: &str| entities.iter().filter(|entity| entity.0 == name).count();
    let known = |kind: SegmentKind| {
        let moves = |s: &&Segment| s.kind == kind && s.known && s.length_mm > 0.0;
        segments.iter().filter(moves).count()
    };
    assert_eq!(count("LINE"), known(SegmentKind::Line) + known(SegmentKind::Rapid));
    assert_eq!((count("ARC"), count("POLYLINE"), count("SEQEND")), (2, 1, 1));

    let arcs: Vec<_> = entities.iter().filter(|entity| entity.0 == "ARC").collect();
    // G3 from (1, 0) about (1, 1) to (2, 1) inches.
    let first = &arcs[0].1;
    let values = [10, 20, 30, 40, 50, 51].map(|code| number(first, code));
    let expected = [25.4, 25.4, -2.54, 25.4, 270.0, 0.0];
    for (value, expected) in values.iter().zip(expected) {
        assert!((value - expected).abs() < 1e-6, "{values:?}");
    }
    assert_eq!(first[&8], "TOOL_1");
    // The half circle in the ZX plane has the normal Y: its own axes are -X and Z.
    let second = &arcs[1].1;
    assert_eq!([210, 220, 230].map(|code| number(second, code)), [0.0, 1.0, 0.0]);
    assert!((number(second, 10) + 2.5 * 25.4).abs() < 1e-6);
    assert!((number(second, 20) + 0.2 * 25.4).abs() < 1e-6);
    assert!((number(second, 30) - 25.4).abs() < 1e-6);
}

#[test]
fn what_is_not_known_is_no_entity() {
    let text = b"G21 G18 G90\nS900 M3\nG1 X10. Z-5. F100.\nX20. Z-10.\nM30\n";
    let job = job("haas-vf2", "profile.nc", text);
    let mut dxf = DxfWriter::new(Vec::new(), &job).unwrap();
    job.path(|segment| dxf.segment(segment).unwrap());
    // X and Z of the first move come from nowhere; Y is never named, and lies at zero.
    let text = String::from_utf8(dxf.finish().unwrap()).unwrap();
    assert_eq!(entities(&text).len(), 1);
    assert_eq!(text.matches("999\nY is never named; drawn at Y0\n").count(), 1);
}

/// The same cut in each of two work offsets that nobody gives, and one more shifted in the first.
pub const TWO_OFFSETS: &[u8] = b"G21 G17 G90\nS900 M3\nG54 G0 X0 Y0\nZ5.\nG1 Z-1. F100.\nX10.\nG0 Z5.\nG55 G0 X0 Y0\nZ5.\n\
    G1 Z-1. F100.\nX10. Y3.\nG0 Z5.\nG54\nG52 X50.\nG0 X0 Y0\nZ5.\nG1 Z-1. F100.\nX10.\nG0 Z5.\nM30\n";

#[test]
fn a_work_offset_of_unknown_relation_is_no_entity() {
    let job = job("haas-vf2", "two.nc", TWO_OFFSETS);
    let mut dxf = DxfWriter::new(Vec::new(), &job).unwrap();
    job.path(|segment| dxf.segment(segment).unwrap());
    let text = String::from_utf8(dxf.finish().unwrap()).unwrap();
    let entities = entities(&text);
    let cuts: Vec<[f64; 2]> = entities
        .iter()
        .filter(|(_, groups)| groups[&8] != "RAPID" && number(groups, 30) == number(groups, 31))
        .map(|(_, groups)| [number(groups, 10), number(groups, 11)])
        .collect();
    assert_eq!(cuts, [[0.0, 10.0], [50.0, 60.0]]);
    let said = "999\nmoves in G55 are left out: where it lies from G54 is not given\n";
    assert_eq!(text.matches(said).count(), 1);
}

#[test]
fn a_chord_from_a_place_that_is_not_known_is_blank_there() {
    let text = b"G21 G18 G90\nS900 M3\nG1 X10. Z-5. F100.\nG2 X20. Z-5. R5.\nG91 G28 Z0\nM30\n";
    let job = job("haas-vf2", "profile.nc", text);
    let [mut csv, mut json] = writers(&job, 1.0);
    job.path(|segment| {
        csv.segment(segment).unwrap();
        json.segment(segment).unwrap();
    });
    let (csv, json) = (lines(csv), lines(json));
    // Y is never named, and at zero.
    assert!(csv[1].starts_with("3,line,,0,,10,0,-5,,"), "{}", csv[1]);
    assert!(csv[2].starts_with("4,arc,10,0,-5,"), "{}", csv[2]);
    let last = csv.last().unwrap();
    assert!(last.starts_with("5,rapid,20,0,-5,20,0,,,"), "{last}");
    assert!(json[1].contains("\"from\":{\"X\":null,\"Y\":0,\"Z\":null}"), "{}", json[1]);
    assert!(json[1].contains("\"length_mm\":null"), "{}", json[1]);
}
