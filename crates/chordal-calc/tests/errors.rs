//! What cannot be is answered with its numbers.

use std::f64::consts::{PI, TAU};

use chordal_calc::*;
use chordal_machine::ControlName;
use proptest::prelude::*;

#[track_caller]
fn refused<T: std::fmt::Debug>(result: Result<T, CalcError>, parts: &[&str]) {
    let error = result.unwrap_err();
    for part in parts {
        assert!(error.message.contains(part), "`{part}` is not in: {}", error.message);
    }
    assert!(!error.help.is_empty());
}

fn mill() -> ThreadMill {
    ThreadMill {
        thread: ThreadSize { major: 38.1, pitch: 3.175, starts: 1 },
        place: ThreadLocation::Inside,
        hand: ThreadHand::Right,
        cutter: ThreadMillCutter::Hob,
        cut: MillingDirection::Climb,
        ramp: None,
        root: None,
        tool_diameter: 19.05,
        depth: 12.7,
        feed: 4.0,
        spindle: 1200.0,
        wear: None,
        tool: 1,
        number: 1001,
        clearance: 2.54,
        control: ControlName::Haas,
        units: AnswerUnit::Inch,
    }
}

#[test]
fn corners() {
    let axis = LineAxis {
        cutter_radius: 5.0,
        angle: PI,
        axis: PlaneAxis::X,
        bend: CornerSide::Inside,
        rise: None,
    };
    refused(corner_with_axis(&axis, AnswerUnit::Millimetre), &["180°"]);
    refused(corner_with_axis(&LineAxis { angle: 0.0, ..axis }, AnswerUnit::Millimetre), &["0°"]);
    refused(
        corner_with_axis(&LineAxis { cutter_radius: 0.0, ..axis }, AnswerUnit::Millimetre),
        &["0 mm"],
    );
    let lines = TwoLines { cutter_radius: 5.0, a: 0.5, b: 0.5 + PI, side: TravelSide::Left };
    refused(corner_of_lines(&lines, AnswerUnit::Millimetre), &["goes back"]);
}

#[test]
fn arcs() {
    let ask = LineArc {
        cutter_radius: 5.0,
        radius: 20.0,
        height: 21.0,
        inside: true,
        toward: true,
        corner: None,
    };
    refused(line_with_arc(&ask, AnswerUnit::Millimetre), &["21 mm", "20 mm"]);
    let large = LineArc { cutter_radius: 20.0, height: 2.0, ..ask };
    refused(line_with_arc(&large, AnswerUnit::Millimetre), &["does not fit into", "20 mm"]);
    let tight = LineArc { cutter_radius: 9.0, height: 18.0, toward: false, ..ask };
    refused(line_with_arc(&tight, AnswerUnit::Millimetre), &["27 mm", "11 mm"]);
    let arcs = ArcArc {
        cutter_radius: 1.0,
        radii: [5.0, 6.0],
        inside: [false; 2],
        center_offset: [12.0, 0.0],
        side: TravelSide::Left,
    };
    refused(arc_with_arc(&arcs, AnswerUnit::Millimetre), &["5 mm", "6 mm", "12 mm"]);
    refused(
        arc_with_arc(&ArcArc { center_offset: [0.0; 2], ..arcs }, AnswerUnit::Millimetre),
        &["same centre"],
    );
    let chords = ChordCount { radius: 10.0, tolerance: 10.0, sweep: TAU };
    refused(chord_count(&chords, AnswerUnit::Millimetre), &["10 mm"]);
    refused(
        chord_count(&ChordCount { tolerance: 0.1, sweep: 7.0, ..chords }, AnswerUnit::Millimetre),
        &["401.0705°"],
    );
}

#[test]
fn threads() {
    for name in ["", "M", "M30x", "x2", "1.5", "1.5-0", "1/0-8", "M-3x2", "1.5-e", "MxX"] {
        refused(ThreadDesignation::read(name), &["is not a thread"]);
    }
    let coarse = ThreadSize { major: 6.0, pitch: 8.0, starts: 1 };
    refused(thread_data(&coarse, AnswerUnit::Millimetre), &["8 mm", "9.815 mm", "6 mm"]);
    refused(
        thread_data(&ThreadSize { starts: 0, ..coarse }, AnswerUnit::Millimetre),
        &["0 starts"],
    );
}

#[test]
fn tools_that_do_not_fit() {
    refused(
        thread_mill(&ThreadMill { tool_diameter: 35.0, ..mill() }),
        &["1.37795 in", "1.36468 in"],
    );
    let near = ThreadMill { tool_diameter: 34.0, ramp: Some(RampSweep::Eighth), ..mill() };
    refused(thread_mill(&near), &["1/8 turn", "1.36468 in"]);
    let quarter = ThreadMill { wear: Some(0.1), ramp: Some(RampSweep::Quarter), ..mill() };
    refused(thread_mill(&quarter), &["straight lead-in"]);
    refused(thread_mill(&ThreadMill { wear: Some(5.0), ..mill() }), &["wear of 0.19685 in"]);
    let fine = ThreadMill { cutter: ThreadMillCutter::Single, depth: 9e3, ..mill() };
    refused(thread_mill(&fine), &["2836 turns"]);
    let root = ThreadMill { place: ThreadLocation::Outside, root: Some(40.0), ..mill() };
    refused(thread_mill(&root), &["1.5748 in", "1.5 in"]);
    let root = ThreadMill { place: ThreadLocation::Outside, root: Some(30.0), ..mill() };
    refused(thread_mill(&root), &["1.1811 in", "1.28349 in"]);
    for broken in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        assert!(thread_mill(&ThreadMill { depth: broken, ..mill() }).is_err());
        assert!(thread_mill(&ThreadMill { feed: broken, ..mill() }).is_err());
        assert!(thread_mill(&ThreadMill { tool_diameter: broken, ..mill() }).is_err());
        assert!(thread_mill(&ThreadMill { spindle: broken, ..mill() }).is_err());
    }
}

#[test]
fn a_pitch_finer_than_the_program_can_say() {
    let thread = ThreadSize { major: 38.1, pitch: 0.05, starts: 1 };
    refused(thread_mill(&ThreadMill { thread, ..mill() }), &["0.00197 in", "0.0001 in"]);
    let starts = ThreadSize { starts: 2, ..mill().thread };
    refused(thread_mill(&ThreadMill { thread: starts, ..mill() }), &["2 starts"]);
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => 0.01f64..100.0,
        1 => any::<f64>(),
        1 => Just(0.0),
        1 => Just(f64::MAX),
        1 => Just(f64::MIN_POSITIVE),
    ]
}

proptest! {
    /// Whatever is asked, there is an answer in finite numbers, or an error that says why.
    #[test]
    fn any_numbers(n in [number(), number(), number(), number(), number(), number()], way: [bool; 6]) {
        let finite = |result: Result<WorkedCalculation, CalcError>| {
            if let Ok(worked) = result {
                for step in &worked.steps {
                    let text = step.quantity.text(worked.units);
                    assert!(!text.contains("NaN"), "{worked:?}");
                }
            }
        };
        let [a, b, c, d, e, f] = n;
        let units = if way[0] { AnswerUnit::Inch } else { AnswerUnit::Millimetre };
        let side = if way[1] { TravelSide::Left } else { TravelSide::Right };
        finite(corner_of_lines(&TwoLines { cutter_radius: a, a: b, b: c, side }, units));
        finite(tangent_point(&TangentTransition { cutter_radius: a, angle: b, side }, units));
        let corner = way[2].then_some(d);
        finite(line_with_arc(
            &LineArc { cutter_radius: a, radius: b, height: c, inside: way[3], toward: way[4], corner },
            units,
        ));
        let inside = [way[3], way[4]];
        finite(arc_with_arc(&ArcArc { cutter_radius: a, radii: [b, c], inside, center_offset: [d, e], side }, units));
        finite(chord_count(&ChordCount { radius: a, tolerance: b, sweep: c }, units));
        let thread = ThreadSize { major: a, pitch: b, starts: 1 };
        finite(thread_data(&thread, units));
        let ask = ThreadMill {
            thread,
            units,
            tool_diameter: c,
            depth: d,
            feed: e,
            clearance: f,
            place: if way[1] { ThreadLocation::Inside } else { ThreadLocation::Outside },
            cutter: if way[2] { ThreadMillCutter::Hob } else { ThreadMillCutter::Single },
            root: way[3].then_some(f),
            wear: way[4].then_some(e),
            ..mill()
        };
        if let Ok(program) = thread_mill(&ask) {
            prop_assert!(!program.text.contains("NaN") && !program.text.contains("inf"));
            finite(Ok(program.worked));
        }
    }

    /// Any text is a thread or is refused.
    #[test]
    fn any_name(name in "[MGNPTUCRx0-9 ./#\"×agABHL\\-]{0,14}") {
        if let Ok(thread) = ThreadDesignation::read(&name) {
            prop_assert!(thread.major > 0.0 && thread.pitch > 0.0 && thread.pitch.is_finite());
            if let Ok(worked) = named_thread(&thread, 1, thread.units) {
                prop_assert!(worked.steps.iter().all(|step| step.quantity.value.is_finite()));
            }
        }
    }
}
