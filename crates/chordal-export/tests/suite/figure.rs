//! The sheets of calculations: every text stands where it can be read.

use chordal::geometry::{TurnDirection, Vec2};
use chordal::machine::ControlName;
use chordal_calc::*;
use chordal_export::{PlotError, PlotOptions, figure_png, figure_svg};
use resvg::usvg::roxmltree::Document;

const OPTIONS: (u32, u32) = (1200, 800);

fn options() -> PlotOptions {
    PlotOptions { width_px: OPTIONS.0, height_px: OPTIONS.1, ..PlotOptions::default() }
}

/// Left, top, width and height of each text of the drawing, and the text. A letter is taken to be
/// half as wide as it is high, as most are.
fn texts(svg: &str) -> Vec<([f64; 4], String)> {
    let document = Document::parse(svg).expect("an SVG");
    document
        .descendants()
        .filter(|node| node.attribute("class") == Some("label"))
        .map(|node| {
            let number = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
            let text = node.text().unwrap_or_default().to_string();
            let (size, x, y) = (number("font-size"), number("x"), number("y"));
            let width = text.chars().count() as f64 * size * 0.5;
            ([x - width / 2.0, y - 0.8 * size, width, size], text)
        })
        .collect()
}

#[track_caller]
fn readable(worked: &WorkedCalculation) {
    let svg = figure_svg(worked, &options());
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    let texts = texts(&svg);
    assert!(!texts.is_empty(), "{}", worked.title);
    for (index, ([left, top, width, height], text)) in texts.iter().enumerate() {
        let inside = *left >= 0.0
            && *top >= 0.0
            && left + width <= f64::from(OPTIONS.0) * 0.64
            && top + height <= f64::from(OPTIONS.1);
        assert!(inside, "`{text}` leaves the drawing of {}: {left} {top}", worked.title);
        for ([l, t, w, h], other) in &texts[index + 1..] {
            let apart = left + width <= *l || l + w <= *left || top + height <= *t || t + h <= *top;
            assert!(apart, "`{text}` and `{other}` overlap in {:?}", worked.inputs);
        }
    }
}

#[test]
fn corners() {
    for degrees in [2, 15, 30, 45, 60, 75, 90, 120, 150, 170] {
        for (axis, bend) in
            [(PlaneAxis::X, CornerSide::Outside), (PlaneAxis::Y, CornerSide::Inside)]
        {
            let angle = f64::from(degrees).to_radians();
            let ask = LineAxis { cutter_radius: 6.35, angle, axis, bend, rise: None };
            readable(&corner_with_axis(&ask, AnswerUnit::Inch).unwrap());
        }
        for b in [-160, -90, -20, 0, 10, 45, 90, 135, 200] {
            if (b + degrees) % 180 == 0 || (b - degrees) % 180 == 0 {
                continue;
            }
            let (a, b) = (f64::from(degrees).to_radians(), f64::from(b).to_radians());
            for side in [TravelSide::Left, TravelSide::Right] {
                let ask = TwoLines { cutter_radius: 6.35, a, b, side };
                readable(&corner_of_lines(&ask, AnswerUnit::Inch).unwrap());
            }
            let ask = TangentTransition { cutter_radius: 5.0, angle: b, side: TravelSide::Right };
            readable(&tangent_point(&ask, AnswerUnit::Millimetre).unwrap());
        }
    }
}

#[test]
fn arcs() {
    for inside in [false, true] {
        for toward in [false, true] {
            for height in [0.0, 3.0, 12.0, 20.0] {
                let (cutter_radius, radius) = (4.0, 31.0);
                let ask = LineArc { cutter_radius, radius, height, inside, toward, corner: None };
                readable(&line_with_arc(&ask, AnswerUnit::Millimetre).unwrap());
            }
            for apart in [[30.0, 0.0], [0.0, -30.0], [-22.0, 22.0]] {
                let inside = [inside, toward];
                let side = TravelSide::Right;
                let ask = ArcArc {
                    cutter_radius: 3.0,
                    radii: [30.0, 20.0],
                    inside,
                    center_offset: apart,
                    side,
                };
                readable(&arc_with_arc(&ask, AnswerUnit::Inch).unwrap());
            }
        }
    }
    for from in [-90, -30, 0, 45, 180, 300] {
        for to in [-45, 0, 90, 135, 270] {
            let ask = ArcPoints {
                start: Vec2::new(-123.4567, 98.7654),
                radius: 20.0,
                from: f64::from(from).to_radians(),
                to: f64::from(to).to_radians(),
                direction: TurnDirection::Cw,
            };
            readable(&arc_points(&ask, AnswerUnit::Millimetre).unwrap());
        }
    }
    for tolerance in [4.0, 0.5, 1e-3] {
        for sweep in [0.3, 1.5, 6.2] {
            let ask = ChordCount { radius: 10.0, tolerance, sweep };
            readable(&chord_count(&ask, AnswerUnit::Millimetre).unwrap());
        }
    }
}

#[test]
fn threads() {
    for (major, pitch) in [(38.1, 3.175), (6.0, 1.0), (100.0, 1.0), (3.0, 0.5)] {
        let thread = ThreadSize { major, pitch, starts: 1 };
        for units in [AnswerUnit::Inch, AnswerUnit::Millimetre] {
            readable(&thread_data(&thread, units).unwrap());
            for place in [ThreadLocation::Inside, ThreadLocation::Outside] {
                for ramp in [None, Some(RampSweep::Quarter)] {
                    let ask = ThreadMill {
                        thread,
                        place,
                        hand: ThreadHand::Left,
                        cutter: ThreadMillCutter::Single,
                        cut: MillingDirection::Climb,
                        ramp,
                        root: None,
                        tool_diameter: major * 0.6,
                        depth: 10.0,
                        feed: 4.0,
                        spindle: 2000.0,
                        wear: None,
                        tool: 1,
                        number: 1,
                        clearance: 2.5,
                        control: ControlName::Haas,
                        units,
                    };
                    readable(&thread_mill(&ask).unwrap().worked);
                }
            }
        }
    }
}

#[test]
fn a_sheet_has_a_size() {
    let ask = ChordCount { radius: 10.0, tolerance: 0.5, sweep: 1.0 };
    let worked = chord_count(&ask, AnswerUnit::Millimetre).unwrap();
    let size = |width_px, height_px| {
        figure_png(&worked, &PlotOptions { width_px, height_px, ..PlotOptions::default() })
    };
    assert!(matches!(size(0, 800), Err(PlotError::Size(0, 800))));
    assert!(size(300, 200).unwrap().starts_with(b"\x89PNG"));
    let small = PlotOptions { width_px: 1, height_px: 1, ..PlotOptions::default() };
    assert!(figure_svg(&worked, &small).contains("width=\"200\""));
}
