//! Patterns of holes: HOLES1, HOLES2, CYCLE801, CYCLE802 (PGZ; cycle files of version 06.02.09).

use chordal_kernel::frames::sin_cos_degrees;

use super::CycleSettings;
use super::arguments::{CycleArguments, CycleCall, CycleFault};
use super::levels::unmodelled;
use crate::alarms::NO_ALARM;

/// The number of holes is 0.
pub(super) const NO_HOLES: u32 = 61_103;

/// The number or the distance of elements on a circle is wrong.
pub(super) const CIRCLE_ELEMENTS: u32 = 61_106;

/// The number of rows or columns is 0.
const NO_ROWS: u32 = 62_105;

/// The largest number of points of CYCLE802.
const MAX_POINTS: usize = 9;

/// What a pattern takes from the program around it.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct PatternContext {
    /// Where the tool is in the plane, in coordinates of the program.
    pub position: [f64; 2],
    /// What the sources leave open.
    pub settings: CycleSettings,
}

/// The holes of a pattern in the order in which they are made: coordinates of the program along the first and the second
/// axis of the plane.
///
/// # Errors
/// The alarm with which the control refuses the arguments; [`NO_ALARM`] for a cycle that is no pattern and for arguments
/// that are not modelled.
pub fn pattern_points(
    name: &str,
    arguments: &CycleArguments,
    context: &PatternContext,
) -> Result<Vec<[f64; 2]>, CycleFault> {
    let call = CycleCall::new(name, arguments)?;
    match call.name() {
        "HOLES1" => row(&call, context),
        "HOLES2" => circle(&call, context),
        "CYCLE801" => grid(&call, context),
        "CYCLE802" => list_of_points(&call, context),
        other => {
            let text = format!("{other} is no pattern of holes");
            Err(call.fault(NO_ALARM, None, &text))
        }
    }
}

/// HOLES1: a row from whichever end is nearer the zero of the workpiece.
fn row(call: &CycleCall<'_>, context: &PatternContext) -> Result<Vec<[f64; 2]>, CycleFault> {
    let count = count(call, "NUM", NO_HOLES, context)?;
    let reference = [call.number("SPCA"), call.number("SPCO")];
    let (sin, cos) = sin_cos_degrees(call.number("STA1"));
    let (first, pitch) = (call.magnitude("FDIS"), call.magnitude("DBH"));
    let mut points: Vec<[f64; 2]> = (0..count)
        .map(|index| first + f64::from(index) * pitch)
        .map(|distance| [reference[0] + distance * cos, reference[1] + distance * sin])
        .collect();
    let distance = |point: Option<&[f64; 2]>| point.map_or(0.0, |[a, b]| a * a + b * b);
    if distance(points.first()) > distance(points.last()) {
        points.reverse();
    }
    Ok(points)
}

/// HOLES2: holes on a circle.
fn circle(call: &CycleCall<'_>, context: &PatternContext) -> Result<Vec<[f64; 2]>, CycleFault> {
    let count = count(call, "NUM", NO_HOLES, context)?;
    let pitch = match call.number("INDA") {
        0.0 => 360.0 / f64::from(count),
        pitch => pitch,
    };
    if pitch.abs() * f64::from(count - 1) >= 360.0 {
        let text = "the holes do not fit on the circle";
        return Err(call.fault(CIRCLE_ELEMENTS, Some("INDA"), text));
    }
    let center = [call.number("CPA"), call.number("CPO")];
    let (radius, start) = (call.magnitude("RAD"), call.number("STA1"));
    Ok((0..count)
        .map(|index| sin_cos_degrees(start + f64::from(index) * pitch))
        .map(|(sin, cos)| [center[0] + radius * cos, center[1] + radius * sin])
        .collect())
}

/// CYCLE801: a rotated grid to and fro, along the smaller pitch first.
fn grid(call: &CycleCall<'_>, context: &PatternContext) -> Result<Vec<[f64; 2]>, CycleFault> {
    for parameter in ["_VARI", "_ANG1", "_ANG2"] {
        // A frame instead of a grid, and grids that are sheared.
        if call.number(parameter) != 0.0 {
            return Err(unmodelled(call, parameter));
        }
    }
    let counts = [count(call, "_NUM1", NO_ROWS, context)?, count(call, "_NUM2", NO_ROWS, context)?];
    if u64::from(counts[0]) * u64::from(counts[1]) > u64::from(context.settings.max_repetitions) {
        return Err(too_many(call, "_NUM2", context));
    }
    let pitches = [call.magnitude("_DIS1"), call.magnitude("_DIS2")];
    let reference = [call.number("_SPCA"), call.number("_SPCO")];
    let (sin, cos) = sin_cos_degrees(call.number("_STA"));
    let offset = [context.position[0] - reference[0], context.position[1] - reference[1]];
    let tool = [offset[0] * cos + offset[1] * sin, offset[1] * cos - offset[0] * sin];
    let (inner, outer) = if pitches[0] <= pitches[1] { (0, 1) } else { (1, 0) };
    let starts_low = |axis: usize| {
        let half = f64::from(counts[axis] - 1) * pitches[axis] / 2.0;
        !context.settings.grid_starts_near_tool || half >= tool[axis]
    };
    let coordinate = |axis: usize, index: u32, is_rising: bool| {
        let index = if is_rising { index } else { counts[axis] - 1 - index };
        f64::from(index) * pitches[axis]
    };
    let (inner_low, outer_low) = (starts_low(inner), starts_low(outer));
    let mut points = Vec::with_capacity((counts[0] * counts[1]) as usize);
    for line in 0..counts[outer] {
        let is_rising = inner_low == line.is_multiple_of(2);
        for index in 0..counts[inner] {
            let mut local = [0.0; 2];
            local[inner] = coordinate(inner, index, is_rising);
            local[outer] = coordinate(outer, line, outer_low);
            points.push([
                reference[0] + local[0] * cos - local[1] * sin,
                reference[1] + local[0] * sin + local[1] * cos,
            ]);
        }
    }
    Ok(points)
}

/// CYCLE802: up to nine points. A point exists when one of its coordinates is written; the other one is then 0. A digit 2
/// of `_XA` or `_YA` makes a coordinate incremental from the point before; the first point is absolute.
fn list_of_points(
    call: &CycleCall<'_>,
    context: &PatternContext,
) -> Result<Vec<[f64; 2]>, CycleFault> {
    const X: [&str; MAX_POINTS] = ["_X0", "_X1", "_X2", "_X3", "_X4", "_X5", "_X6", "_X7", "_X8"];
    const Y: [&str; MAX_POINTS] = ["_Y0", "_Y1", "_Y2", "_Y3", "_Y4", "_Y5", "_Y6", "_Y7", "_Y8"];
    let is_incremental = |parameter: &str, point: usize| {
        let place =
            if context.settings.last_digit_is_first_point { point } else { MAX_POINTS - 1 - point };
        call.integer(parameter) / 10_i64.pow(place as u32) % 10 == 2
    };
    let mut points: Vec<[f64; 2]> = Vec::new();
    for (index, (x, y)) in X.into_iter().zip(Y).enumerate() {
        if call.argument(x).is_none() && call.argument(y).is_none() {
            continue;
        }
        let mut point = [call.number(x), call.number(y)];
        if let Some(last) = points.last() {
            for (axis, modes) in ["_XA", "_YA"].into_iter().enumerate() {
                if is_incremental(modes, index) {
                    point[axis] += last[axis];
                }
            }
        }
        points.push(point);
    }
    if points.is_empty() {
        return Err(call.fault(NO_HOLES, Some("_X0"), "no point is programmed"));
    }
    Ok(points)
}

/// A number of elements; the cycle files take its magnitude.
fn count(
    call: &CycleCall<'_>,
    parameter: &str,
    alarm: u32,
    context: &PatternContext,
) -> Result<u32, CycleFault> {
    let count = call.integer(parameter).unsigned_abs();
    if count == 0 {
        let text = format!("{parameter} must not be 0");
        return Err(call.fault(alarm, Some(parameter), &text));
    }
    u32::try_from(count)
        .ok()
        .filter(|count| *count <= context.settings.max_repetitions)
        .ok_or_else(|| too_many(call, parameter, context))
}

fn too_many(call: &CycleCall<'_>, parameter: &str, context: &PatternContext) -> CycleFault {
    let text = format!("a pattern of more than {} holes", context.settings.max_repetitions);
    call.fault(NO_ALARM, Some(parameter), &text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cycles::tests::notation::arguments;

    fn points_in(call: &str, context: &PatternContext) -> Result<Vec<[f64; 2]>, CycleFault> {
        let (name, list) = call.trim_end_matches(')').split_once('(').expect("a call");
        pattern_points(name, &arguments(list), context)
    }

    #[track_caller]
    fn check_in(call: &str, context: &PatternContext, expected: &[[f64; 2]]) {
        let points = points_in(call, context).expect("a call without a fault");
        assert_eq!(points.len(), expected.len(), "{points:?}");
        for (point, expected) in points.iter().zip(expected) {
            let distance = (point[0] - expected[0]).hypot(point[1] - expected[1]);
            assert!(distance < 1e-4, "{points:?}");
        }
    }

    #[track_caller]
    fn check(call: &str, expected: &[[f64; 2]]) {
        check_in(call, &PatternContext::default(), expected);
    }

    fn fault(call: &str) -> (u32, Option<usize>) {
        let fault = points_in(call, &PatternContext::default()).expect_err("a fault");
        let number = format!("alarm {}:", fault.alarm);
        assert_eq!(fault.alarm != 0, fault.message.starts_with(&number), "{fault:?}");
        (fault.alarm, fault.parameter)
    }

    #[test]
    fn a_row_begins_at_the_end_nearer_the_zero() {
        check("HOLES1(100,0,180,10,20,4)", &[[30.0, 0.0], [50.0, 0.0], [70.0, 0.0], [90.0, 0.0]]);
        check("HOLES1(20,5,90,10,20,3)", &[[20.0, 15.0], [20.0, 35.0], [20.0, 55.0]]);
        // Both ends are equally far from the zero: the row is not reversed.
        check("HOLES1(-30,10,0,0,30,3)", &[[-30.0, 10.0], [0.0, 10.0], [30.0, 10.0]]);
        // 10 along 30°: (8.6603, 5), and 20 more: (25.9808, 15). Signs of distances are ignored.
        check("HOLES1(0,0,30,-10,-20,-2)", &[[8.6603, 5.0], [25.9808, 15.0]]);
        assert_eq!(fault("HOLES1(0,0,0,10,20,0)"), (61103, Some(5)));
    }

    #[test]
    fn a_circle_is_divided() {
        check(
            "HOLES2(50,40,30,45,0,5)",
            &[
                [71.2132, 61.2132],
                [36.3803, 66.7302],
                [20.3693, 35.3070],
                [45.3070, 10.3693],
                [76.7302, 26.3803],
            ],
        );
        check("HOLES2(0,0,10,0,-90,3)", &[[10.0, 0.0], [0.0, -10.0], [-10.0, 0.0]]);
        assert_eq!(fault("HOLES2(0,0,10,0,90,5)"), (61106, Some(4)));
        assert_eq!(fault("HOLES2(0,0,10,0,0,0)"), (61103, Some(5)));
        assert_eq!(fault("HOLES2(0,0,10,0,0,100001)"), (0, Some(5)));
    }

    #[test]
    fn a_grid_runs_to_and_fro_along_the_smaller_pitch() {
        check(
            "CYCLE801(30,20,0,10,15,3,2)",
            &[[30.0, 20.0], [40.0, 20.0], [50.0, 20.0], [50.0, 35.0], [40.0, 35.0], [30.0, 35.0]],
        );
        check(
            "CYCLE801(30,20,0,15,10,2,3)",
            &[[30.0, 20.0], [30.0, 30.0], [30.0, 40.0], [45.0, 40.0], [45.0, 30.0], [45.0, 20.0]],
        );
        // A quarter turn: columns go up, rows go to the left.
        let context = PatternContext { position: [30.0, 20.0], ..Default::default() };
        check_in(
            "CYCLE801(30,20,90,10,15,2,2)",
            &context,
            &[[30.0, 20.0], [30.0, 30.0], [15.0, 30.0], [15.0, 20.0]],
        );
    }

    #[test]
    fn a_grid_begins_near_the_tool() {
        let mut context = PatternContext { position: [49.0, 34.0], ..Default::default() };
        let call = "CYCLE801(30,20,0,10,15,3,2)";
        check_in(
            call,
            &context,
            &[[50.0, 35.0], [40.0, 35.0], [30.0, 35.0], [30.0, 20.0], [40.0, 20.0], [50.0, 20.0]],
        );
        context.settings.grid_starts_near_tool = false;
        let points = points_in(call, &context).expect("points");
        assert_eq!(points[0], [30.0, 20.0]);
    }

    #[test]
    fn faults_of_a_grid() {
        assert_eq!(fault("CYCLE801(30,20,0,10,15,0,2)"), (62105, Some(5)));
        assert_eq!(fault("CYCLE801(30,20,0,10,15,2,0)"), (62105, Some(6)));
        assert_eq!(fault("CYCLE801(30,20,0,10,15,1000,1000)"), (0, Some(6)));
        assert_eq!(fault("CYCLE801(30,20,0,10,15,2,2,1)"), (0, Some(7)));
    }

    #[test]
    fn a_list_of_points() {
        check(
            "CYCLE802(111111111,111111111,0,0,50,0,50,50,,,,,,,,,,,,,0,0,1)",
            &[[0.0, 0.0], [50.0, 0.0], [50.0, 50.0]],
        );
        // The second and the third X are incremental; a Y that is left out is 0.
        check(
            "CYCLE802(111111221,111111111,10,5,20,,-5,7)",
            &[[10.0, 5.0], [30.0, 0.0], [25.0, 7.0]],
        );
        let mut context = PatternContext::default();
        context.settings.last_digit_is_first_point = false;
        check_in(
            "CYCLE802(122111111,111111111,10,5,20,,-5,7)",
            &context,
            &[[10.0, 5.0], [30.0, 0.0], [25.0, 7.0]],
        );
        let all = "CYCLE802(1,1,0,0,1,0,2,0,3,0,4,0,5,0,6,0,7,0,8,9)";
        let points = points_in(all, &context).expect("points");
        assert_eq!((points.len(), points[8]), (9, [8.0, 9.0]));
        assert_eq!(fault("CYCLE802(111111111,111111111)"), (61103, Some(2)));
        assert_eq!(fault("CYCLE81(10,0,2,-25)"), (0, None));
    }
}
