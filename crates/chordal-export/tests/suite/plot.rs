use chordal::Segment;
use chordal::geometry::{Curve, Line, Vec3};
use chordal_export::{Plot, PlotError, PlotOptions};
use resvg::tiny_skia::Pixmap;
use resvg::usvg::roxmltree::Document;

use crate::common::{SMALL, job};
use crate::path::TWO_OFFSETS;

fn options() -> PlotOptions {
    PlotOptions {
        title: "a <b> & \"c\"\u{1}.nc".into(),
        subtitle: "Haas VF-2 — in — 1.2 min".into(),
        width_px: 800,
        height_px: 566,
        dark: false,
    }
}

fn plot(segments: &[Segment]) -> Plot {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    let mut plot = Plot::new(&job);
    segments.iter().for_each(|segment| plot.segment(segment));
    plot
}

fn small() -> Vec<Segment> {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    let mut segments = Vec::new();
    job.path(|segment| segments.push(*segment));
    segments
}

fn line(from: [f64; 3], to: [f64; 3]) -> Segment {
    let template = *small().iter().rfind(|segment| segment.known).unwrap();
    let (start, end) = (Vec3::from_array(from), Vec3::from_array(to));
    Segment {
        kind: chordal::SegmentKind::Line,
        curve: Curve::Line(Line { start, end }),
        length_mm: (end - start).length(),
        known: true,
        ..template
    }
}

/// Parses as XML, and every number in it is one.
fn check(svg: &str) {
    let document = Document::parse(svg).unwrap();
    assert_eq!(document.root_element().tag_name().name(), "svg");
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "a number is none");
}

#[test]
fn a_small_job_has_four_views_with_true_arcs() {
    let plot = plot(&small());
    let svg = plot.svg(&options());
    check(&svg);
    let document = Document::parse(&svg).unwrap();
    let texts: Vec<&str> = document.descendants().filter_map(|node| node.text()).collect();
    for title in ["Top", "Front", "Right", "Isometric", "start", "end"] {
        assert!(texts.contains(&title), "{title}");
    }
    let path = |id: &str| {
        let node = document.descendants().find(|node| node.attribute("id") == Some(id));
        node.and_then(|node| node.attribute("d")).unwrap_or("").to_string()
    };
    assert!(path("view-top-tool-1").contains('A'), "arcs in XY are arcs from above");
    assert!(path("view-front-tool-1").contains('A'), "arcs in ZX are arcs from the front");
    assert!(!path("view-isometric-tool-1").contains('A'));
}

#[test]
fn pictures_show_something() {
    for dark in [false, true] {
        let options = PlotOptions { dark, ..options() };
        let png = plot(&small()).png(&options).unwrap();
        let pixmap = Pixmap::decode_png(&png).unwrap();
        assert_eq!((pixmap.width(), pixmap.height()), (800, 566));
        let first = pixmap.pixels()[0];
        let drawn = pixmap.pixels().iter().filter(|pixel| **pixel != first).count();
        assert!(drawn > 10_000, "{drawn} pixels are drawn");
        // The first tool's blue is there.
        let blue =
            |p: &&resvg::tiny_skia::PremultipliedColorU8| p.blue() > p.red().saturating_add(80);
        assert!(pixmap.pixels().iter().filter(blue).count() > 100);
    }
}

#[test]
fn odd_paths_are_drawn() {
    let p = [1.0, 2.0, 3.0];
    let cases: Vec<(&str, Vec<Segment>)> = vec![
        ("nothing", vec![]),
        ("a point", vec![line(p, p)]),
        ("a plunge", vec![line([1.0, 2.0, 0.0], [1.0, 2.0, -9.0])]),
        ("a flat line", vec![line([0.0, 0.0, 0.0], [1000.0, 0.0, 0.0])]),
        ("huge", vec![line([-1e12, 0.0, 0.0], [1e12, 1e12, 5.0])]),
        ("tiny", vec![line([5.0, 5.0, 5.0], [5.0 + 1e-7, 5.0, 5.0])]),
        ("far away", vec![line([1e9, 1e9, 0.0], [1e9 + 1e-3, 1e9, 0.0])]),
        ("not finite", vec![line([f64::NAN, 0.0, 0.0], p), line(p, [f64::INFINITY, 0.0, 0.0])]),
        ("not known", vec![Segment { known: false, ..line(p, [0.0; 3]) }]),
    ];
    for (name, segments) in cases {
        let plot = plot(&segments);
        for (width_px, height_px) in [(800, 566), (200, 200), (300, 2000), (2000, 300)] {
            let options = PlotOptions { width_px, height_px, ..options() };
            let svg = plot.svg(&options);
            check(&svg);
            assert!(svg.len() < 200_000, "{name}: {} bytes", svg.len());
            assert!(!plot.png(&options).unwrap().is_empty(), "{name}");
        }
    }
}

#[test]
fn an_empty_path_says_so() {
    assert!(plot(&[]).svg(&options()).contains("no motion"));
}

#[test]
fn sizes_without_sense_are_refused() {
    for (width_px, height_px) in [(0, 500), (500, 100), (20_000, 500), (16_384, 16_384)] {
        let result = plot(&small()).png(&PlotOptions { width_px, height_px, ..options() });
        assert!(matches!(result, Err(PlotError::Size(..))));
    }
}

#[test]
fn a_large_path_makes_a_small_drawing() {
    let job = job("linuxcnc-mill", "small.nc", SMALL);
    let mut plot = Plot::new(&job);
    let mut segment = line([0.0; 3], [0.0; 3]);
    let mut from = Vec3::ZERO;
    // More than the store keeps without thinning.
    for n in 1..=2_300_000u32 {
        let (row, place) = (n / 1500, n % 1500);
        let x = f64::from(if row % 2 == 0 { place } else { 1499 - place });
        let to = Vec3::new(x * 0.1, f64::from(row) * 0.1, (x * 0.01).sin());
        segment.curve = Curve::Line(Line { start: from, end: to });
        segment.length_mm = (to - from).length();
        plot.segment(&segment);
        from = to;
    }
    let svg = plot.svg(&PlotOptions::default());
    check(&svg);
    assert!(svg.len() < 14 << 20, "{} bytes", svg.len());
}

/// X and Z of a profile, as manuals print it: Y is never named.
const PROFILE: &[u8] =
    b"G21 G18 G90\nS900 M3\nG1 X10. Z-5. F100.\nX20. Z-10.\nG2 X30. Z-10. R5.\nM30\n";

#[test]
fn a_fragment_that_never_names_an_axis_has_a_picture_that_says_so() {
    let job = job("haas-vf2", "profile.nc", PROFILE);
    let mut plot = Plot::new(&job);
    job.path(|segment| plot.segment(segment));
    let svg = plot.svg(&options());
    check(&svg);
    assert!(svg.contains("Y is never named; drawn at Y0"), "it is said");
    assert_eq!(svg.matches("never named").count(), 1);
    let document = Document::parse(&svg).unwrap();
    let front =
        document.descendants().find(|node| node.attribute("id") == Some("view-front-tool-0"));
    assert!(
        front.and_then(|node| node.attribute("d")).unwrap_or("").contains('A'),
        "the arc is drawn"
    );
    assert!(!plot_of_all_axes().contains("never named"));
}

#[test]
fn a_picture_says_which_work_offset_is_left_out() {
    let job = job("haas-vf2", "two.nc", TWO_OFFSETS);
    let mut plot = Plot::new(&job);
    job.path(|segment| plot.segment(segment));
    let svg = plot.svg(&options());
    check(&svg);
    assert!(svg.contains("moves in G55 are left out: where it lies from G54 is not given"));
    // 60 mm: the cut at G52 X50.
    assert!(svg.contains("X 0 to 2.3622  ·  Y 0 to 0  ·"), "{svg}");
    assert!(!svg.contains("unknown positions"), "that is another reason");
}

fn plot_of_all_axes() -> String {
    plot(&small()).svg(&options())
}
