//! What a line expects, held against what it does.

use chordal::geometry::Vec3;

use super::record::{KlartextRunRecord, RecordedMove, expects_position, parameters};

/// How far a coordinate may be off: the set is rounded to three decimals, mm.
const TOLERANCE_MM: f64 = 1.1e-3;

/// How far an angle may be off, degrees.
const TOLERANCE_DEG: f64 = 1.1e-3;

/// The value after a letter: `X+10.5`.
pub fn value(words: &str, letter: char) -> Option<f64> {
    words.split_whitespace().find_map(|word| word.strip_prefix(letter)?.parse().ok())
}

/// The coordinates that an expectation names, by axis.
pub fn place(words: &str) -> [Option<f64>; 3] {
    ['X', 'Y', 'Z'].map(|letter| value(words, letter))
}

pub fn is_near(found: [f64; 3], expected: [Option<f64>; 3]) -> bool {
    (0..3).all(|axis| expected[axis].is_none_or(|mm| (found[axis] - mm).abs() <= TOLERANCE_MM))
}

pub fn end_of(step: &RecordedMove) -> [f64; 3] {
    let to = step.kind.motion().expect("a move").to;
    [to[0], to[1], to[2]]
}

/// The map of the plane from programmed coordinates to those of the preset, by two points of lines that expect both.
#[derive(Default)]
pub struct ExpectedPlaneMap {
    pairs: Vec<([f64; 2], [f64; 2])>,
}

impl ExpectedPlaneMap {
    pub fn note(&mut self, notes: &[String]) {
        let find = |prefix: &str| {
            let note = notes.iter().find_map(|note| match prefix {
                "" => note.starts_with(['X', 'Y']).then_some(note.as_str()),
                prefix => note.strip_prefix(prefix),
            })?;
            let [x, y, _] = place(note);
            Some([x?, y?])
        };
        if let (Some(own), Some(work)) = (find(""), find("work "))
            && self.pairs.last().is_none_or(|(last, _)| *last != own)
        {
            self.pairs.push((own, work));
        }
    }

    /// A point of the preset in programmed coordinates: where the map turns, moves and enlarges alone, and where it
    /// mirrors, too.
    fn programmed(&self, point: [f64; 2]) -> [[f64; 2]; 2] {
        let [.., (own1, work1), (own2, work2)] = self.pairs.as_slice() else { return [point; 2] };
        let minus = |one: &[f64; 2], two: &[f64; 2]| [one[0] - two[0], one[1] - two[1]];
        let divide = |n: [f64; 2], d: [f64; 2]| {
            let squared = d[0] * d[0] + d[1] * d[1];
            [(n[0] * d[0] + n[1] * d[1]) / squared, (n[1] * d[0] - n[0] * d[1]) / squared]
        };
        [1.0, -1.0].map(|sign| {
            let flipped = |by: [f64; 2]| [by[0], sign * by[1]];
            let factor = divide(minus(own2, own1), flipped(minus(work2, work1)));
            let by = flipped(minus(&point, work1));
            [
                own1[0] + by[0] * factor[0] - by[1] * factor[1],
                own1[1] + by[0] * factor[1] + by[1] * factor[0],
            ]
        })
    }
}

/// The values that the last run of a line has recorded: those of its parameters in their order, then X, Y and Z.
pub fn recorded_values(record: &KlartextRunRecord, line: u32, count: usize) -> Option<&[f64]> {
    let all = record.values.get(&line)?;
    all.len().checked_sub(count).map(|from| &all[from..])
}

/// The moves of the last time that a line is carried out: those without a move of another line between them.
pub fn last_run(record: &KlartextRunRecord, line: u32) -> Vec<&RecordedMove> {
    let is_own = |step: &&RecordedMove| step.line == line;
    let mut own: Vec<&RecordedMove> =
        record.moves.iter().rev().skip_while(|step| !is_own(step)).take_while(is_own).collect();
    own.reverse();
    own
}

/// The last move of a line; without one, that before it.
pub fn last_move(record: &KlartextRunRecord, line: u32) -> Option<&RecordedMove> {
    let own = record.moves.iter().rposition(|step| step.line == line);
    let before = || record.moves.iter().rposition(|step| step.line <= line);
    own.or_else(before).map(|at| &record.moves[at])
}

/// Whether the rotary axes are where an expectation names them, degrees.
pub fn rotary_axes_agree(note: &str, step: Option<&RecordedMove>) -> bool {
    let named = [('A', 3), ('C', 5)].map(|(letter, axis)| (value(note, letter), axis));
    named.into_iter().filter_map(|(expected, axis)| Some((expected?, axis))).all(
        |(expected, axis)| {
            let to = step.and_then(|step| step.kind.motion()).map(|motion| motion.to[axis]);
            to.is_some_and(|angle| (angle.to_degrees() - expected).abs() <= TOLERANCE_DEG)
        },
    )
}

/// A number that an expectation names.
pub fn expected_number<T: std::str::FromStr>(words: &str) -> Result<T, String> {
    words.trim().parse().map_err(|_| "it names no number".to_string())
}

/// Checks an expectation of a line.
///
/// # Errors
/// What is found in its place.
pub fn check(
    note: &str,
    line: u32,
    notes: &[String],
    record: &KlartextRunRecord,
    map: Option<&ExpectedPlaneMap>,
) -> Result<(), String> {
    let own = last_run(record, line);
    // The axis of the tool is that of the deepest point.
    let deepest = notes.iter().find_map(|note| note.strip_prefix("lowest "));
    let tool_axis = deepest.and_then(|words| place(words).iter().position(Option::is_some));
    let tool_axis = tool_axis.unwrap_or(2);
    let names = parameters(notes);
    let has_places = map.is_some() && expects_position(notes);
    let recorded = || {
        let count = names.len() + if has_places { 3 } else { 0 };
        recorded_values(record, line, count).ok_or("nothing is recorded".to_string())
    };
    let (kind, words) = note.split_once(' ').unwrap_or((note, ""));
    let is_place = |found: Option<[f64; 3]>, words: &str| match found {
        Some(found) if is_near(found, place(words)) => Ok(()),
        found => Err(format!("{found:?}")),
    };
    let is_equal = |found: usize| match expected_number::<usize>(words)? {
        expected if expected == found => Ok(()),
        _ => Err(found.to_string()),
    };
    match kind {
        "clean" | "called" | "kind" | "says" | "fault" | "path" => Ok(()),
        "end" => is_place(record.moves.last().map(end_of), words),
        "work" => {
            let found = last_move(record, line).map(|step| {
                let end = Vec3::from_array(end_of(step));
                step.plane.map_or(end, |plane| plane.apply_point(end)).to_array()
            });
            is_place(found, words)
        }
        "centre" => {
            let arc = own.iter().rev().find_map(|step| Some((step.kind.shape()?, step.plane)));
            let (shape, plane) = arc.ok_or("no arc")?;
            let (a, b, _) = shape.plane.axes();
            // Coordinates of a tilted plane are those of the program.
            let centers = match map.filter(|_| plane.is_none()) {
                Some(map) => map.programmed(shape.center),
                None => [shape.center; 2],
            };
            let expected = place(words);
            let is_right = |center: &[f64; 2]| {
                [(a, center[0]), (b, center[1])].into_iter().all(|(axis, mm)| {
                    expected[axis].is_none_or(|expected| (mm - expected).abs() <= TOLERANCE_MM)
                })
            };
            if centers.iter().any(is_right) { Ok(()) } else { Err(format!("{centers:?}")) }
        }
        "runs" => is_equal(record.runs.get(&line).copied().unwrap_or(0)),
        "strokes" => is_equal(strokes(&own, tool_axis)),
        "lowest" => {
            let axis = tool_axis;
            let lowest = own.iter().map(|step| end_of(step)[axis]).fold(f64::INFINITY, f64::min);
            let lowest = match map.filter(|_| axis == 2) {
                // The shift of Z is that of the end of the line.
                Some(_) => {
                    let z = recorded()?.last().copied().ok_or("no position is recorded")?;
                    let z = z * record.unit_mm;
                    lowest - own.last().map_or(0.0, |step| end_of(step)[2]) + z
                }
                None => lowest,
            };
            let expected = place(words)[axis].ok_or("it names no axis")?;
            match (lowest - expected).abs() <= TOLERANCE_MM {
                true => Ok(()),
                false => Err(lowest.to_string()),
            }
        }
        "min" | "max" => {
            let sign = if kind == "min" { 1.0 } else { -1.0 };
            let mut found = [f64::INFINITY; 2];
            for step in own.iter().filter(|step| step.kind.feed().is_some()) {
                for point in points_of(step) {
                    (0..2).for_each(|axis| found[axis] = found[axis].min(sign * point[axis]));
                }
            }
            let [x, y, _] = place(words);
            let found = [sign * found[0], sign * found[1], 0.0];
            if is_near(found, [x, y, None]) { Ok(()) } else { Err(format!("{found:?}")) }
        }
        _ if note.starts_with('Q') => {
            let (name, expected) = note.split_once('=').ok_or("it names no value")?;
            let expected: f64 = expected_number(expected)?;
            let at = names.iter().position(|own| own == name).ok_or("it is not recorded")?;
            let found = recorded()?[at];
            match (found - expected).abs() <= TOLERANCE_MM {
                true => Ok(()),
                false => Err(found.to_string()),
            }
        }
        _ if note.starts_with(['X', 'Y', 'Z', 'A', 'C']) => {
            let step = last_move(record, line);
            if !rotary_axes_agree(note, step) {
                return Err(format!("{:?}", step.and_then(|step| step.kind.motion())));
            }
            match has_places {
                true => {
                    let [.., x, y, z] = *recorded()? else { return Err("no position".into()) };
                    is_place(Some([x, y, z].map(|length| length * record.unit_mm)), note)
                }
                false => is_place(step.map(end_of), note),
            }
        }
        _ => Err("is not checked".into()),
    }
}

/// The feed moves along the axis of the tool to a new depth, of the last hole.
pub fn strokes(own: &[&RecordedMove], axis: usize) -> usize {
    let (mut count, mut depth) = (0, f64::INFINITY);
    for step in own {
        let motion = step.kind.motion().expect("a move");
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        let across = (motion.to[a] - motion.from[a]).hypot(motion.to[b] - motion.from[b]);
        let is_rapid = step.kind.feed().is_none();
        // Further than a boring tool leaves its wall is the next hole.
        if is_rapid && across > 1.0 {
            (count, depth) = (0, f64::INFINITY);
        }
        let deeper = motion.to[axis] < depth - 1e-6 && motion.to[axis] < motion.from[axis];
        if !is_rapid && deeper {
            count += 1;
            depth = motion.to[axis];
        }
    }
    count
}

/// Points of a move, close to each other on arcs.
pub fn points_of(step: &RecordedMove) -> Vec<[f64; 2]> {
    let motion = step.kind.motion().expect("a move");
    let mut points = vec![[motion.from[0], motion.from[1]], [motion.to[0], motion.to[1]]];
    if let Some(shape) = step.kind.shape() {
        let from = [motion.from[0] - shape.center[0], motion.from[1] - shape.center[1]];
        for part in 0..=720 {
            let (sin, cos) = (shape.sweep * f64::from(part) / 720.0).sin_cos();
            points.push([
                shape.center[0] + from[0] * cos - from[1] * sin,
                shape.center[1] + from[0] * sin + from[1] * cos,
            ]);
        }
    }
    points
}

/// The points of a compensated path that a line expects, in their order; what is wrong for each.
pub fn check_path(
    notes: &[String],
    line: u32,
    text: &str,
    record: &KlartextRunRecord,
) -> Vec<String> {
    // The end of an element at a corner stands on the line of the corner.
    let is_corner = ["RND", "CHF", "G24", "G25"].iter().any(|word| text.contains(word));
    let first = if is_corner { line - 1 } else { line };
    let of_line = || record.moves.iter().filter(move |step| (first..=line).contains(&step.line));
    // A rounding is named with the point where it begins.
    let start = of_line().next().map(|step| {
        let from = step.kind.motion().expect("a move").from;
        [from[0], from[1], from[2]]
    });
    let mut own = start.into_iter().chain(of_line().map(end_of));
    let mut wrong = Vec::new();
    for note in notes {
        let Some(words) = note.strip_prefix("path ") else { continue };
        let expected = place(words);
        if !own.any(|end| is_near(end, expected)) {
            wrong.push(format!("line {line}: `{note}`: not in the path"));
        }
    }
    wrong
}
