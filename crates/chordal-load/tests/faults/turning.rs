//! The kinds of faults of lathe programs.

use super::kinds::Kind;
use super::rules::{first_cut, no_spindle, same_line};
use super::{Line, Part, Word};

type Planted = Option<String>;

const fn kind(
    name: &'static str,
    plant: fn(&Part, &Line) -> Planted,
    codes: &'static [&'static str],
) -> Kind {
    Kind { name, plant, place: same_line, codes, not_on: &[], anywhere: false }
}

pub const KINDS: &[Kind] = &[
    kind("P names no block", no_first_block, &["CH202"]),
    kind("Q names no block", no_last_block, &["CH202"]),
    kind("P missing", without_p, &["CH308"]),
    Kind { anywhere: true, ..kind("contour that turns back", turned_contour, &["CH303"]) },
    Kind { anywhere: true, ..kind("a cycle in a contour", cycle_in_contour, &["CH207"]) },
    Kind { place: cycle_of_depth, ..kind("depth of a pass missing", no_depth, &["CH303"]) },
    kind("height of a thread missing", no_height, &["CH303"]),
    kind("first pass of a thread missing", no_first_pass, &["CH303"]),
    kind("distance of grooves missing", no_distance, &["CH303"]),
    kind("no pass of a pattern", no_passes, &["CH303"]),
    kind("end of a thread missing", no_end_of_thread, &["CH303", "CH308"]),
    // B is the axis of the second spindle, except on LinuxCNC.
    kind("an axis that is not there", other_axis, &["CH309", "CH306"]),
    kind("negative speed", negative_speed, &["CH303"]),
    Kind { place: first_cut_or_cycle, ..kind("spindle not started", no_spindle, &["CH413"]) },
    Kind { anywhere: true, ..kind("radius of an arc too small", small_radius, &["CH402"]) },
    Kind { anywhere: true, ..kind("centre of an arc moved", moved_centre, &["CH401"]) },
    kind("subroutine of a contour not there", no_subroutine, &["CH201"]),
    kind("depth zero", zero_depth, &["CH303"]),
    kind("crest of a thread at zero", zero_crest, &["CH303"]),
    kind("cutting speed without a value", no_cutting_speed, &["CH308"]),
];

/// The first line that cuts, or the cycle that cuts the contour in it.
fn first_cut_or_cycle(part: &Part, line: &Line) -> Option<usize> {
    let cut = first_cut(part, line)?;
    let lines = part.lines.iter().filter(|other| (line.number..=cut).contains(&other.number));
    let mut cycles = lines.filter(|other| by_labels(other).is_some());
    Some(cycles.next().map_or(cut, |cycle| cycle.number))
}

/// A cycle with P and Q.
fn by_labels(line: &Line) -> Option<(&Word, &Word)> {
    line.g(&["70", "71", "72", "73"])?;
    Some((line.word(b'P')?, line.word(b'Q')?))
}

fn no_first_block(_: &Part, line: &Line) -> Planted {
    Some(line.with(by_labels(line)?.0, "P8765"))
}

fn no_last_block(_: &Part, line: &Line) -> Planted {
    Some(line.with(by_labels(line)?.1, "Q8765"))
}

fn without_p(_: &Part, line: &Line) -> Planted {
    Some(line.without(by_labels(line)?.0))
}

/// The roughing cycle whose contour a line stands in, after its first block.
fn cycle_around<'p>(part: &'p Part, line: &Line) -> Option<&'p Line> {
    let labelled = |word: &Word| {
        let label = format!("N{}", word.value);
        part.lines.iter().find(|line| line.text.starts_with(&format!("{label} ")))
    };
    part.lines.iter().find(|cycle| {
        cycle.g(&["71", "72"]).is_some()
            && by_labels(cycle).is_some_and(|(p, q)| {
                let (first, last) = (labelled(p), labelled(q));
                first.is_some_and(|first| first.number < line.number)
                    && last.is_some_and(|last| line.number <= last.number)
            })
    })
}

/// Along Z (G71) or X (G72) to the side of the start.
fn turned_contour(part: &Part, line: &Line) -> Planted {
    let cycle = cycle_around(part, line)?;
    match cycle.g(&["71"]) {
        Some(_) => {
            let word = line.word(b'Z').filter(|word| word.value.starts_with('-'))?;
            Some(line.with(word, "Z40."))
        }
        None => Some(line.with(line.word(b'X')?, "X190.")),
    }
}

fn cycle_in_contour(part: &Part, line: &Line) -> Planted {
    cycle_around(part, line).map(|_| format!("G75 X1. F.1 ({})", line.number))
}

/// The block with the depth, and no P.
fn gives_depth(line: &Line) -> bool {
    line.g(&["71", "72"]).is_some() && line.word(b'P').is_none() && line.word(b'R').is_some()
}

fn no_depth(part: &Part, line: &Line) -> Planted {
    // Haas has it in the block of the cycle.
    if by_labels(line).is_some() && line.g(&["71", "72"]).is_some() {
        return Some(line.without(line.word(b'D')?));
    }
    let first = part.lines.iter().find(|line| gives_depth(line))?;
    (first.number == line.number).then(String::new)
}

/// The cycle after it.
fn cycle_of_depth(part: &Part, line: &Line) -> Option<usize> {
    let after = part.lines.iter().filter(|cycle| cycle.number >= line.number);
    let mut cycles = after.filter(|cycle| cycle.g(&["71", "72"]).is_some());
    Some(cycles.find(|cycle| by_labels(cycle).is_some())?.number)
}

/// G76 with its end.
fn thread(line: &Line) -> bool {
    line.g(&["76"]).is_some() && line.word(b'X').is_some()
}

fn no_height(_: &Part, line: &Line) -> Planted {
    let letter = if line.word(b'K').is_some() { b'K' } else { b'P' };
    Some(line.without(line.word(letter).filter(|_| thread(line))?))
}

fn no_first_pass(_: &Part, line: &Line) -> Planted {
    let letter = if line.word(b'K').is_some() { b'D' } else { b'Q' };
    Some(line.without(line.word(letter).filter(|_| thread(line))?))
}

fn no_end_of_thread(_: &Part, line: &Line) -> Planted {
    line.g(&["76"])?;
    Some(line.without(line.word(b'Z')?))
}

fn no_distance(_: &Part, line: &Line) -> Planted {
    line.g(&["75"]).filter(|_| line.word(b'Z').is_some())?;
    let letter = if line.word(b'K').is_some() { b'K' } else { b'Q' };
    Some(line.without(line.word(letter)?))
}

fn no_passes(_: &Part, line: &Line) -> Planted {
    line.g(&["73"])?;
    if line.word(b'P').is_some() {
        return Some(line.with(line.word(b'D')?, "D0"));
    }
    Some(line.with(line.word(b'R').filter(|_| line.word(b'U').is_some())?, "R0"))
}

/// A move of X, or of Z.
fn moves(line: &Line) -> bool {
    let codes = line.words.iter().filter(|word| matches!(word.letter, b'G' | b'M'));
    let plain = |word: &Word| matches!(word.value.as_str(), "0" | "1" | "00" | "01");
    line.done.ran
        && (line.word(b'X').is_some() || line.word(b'Z').is_some())
        && codes.into_iter().all(|word| word.letter == b'G' && plain(word))
}

fn other_axis(_: &Part, line: &Line) -> Planted {
    line.words.last().filter(|_| moves(line))?;
    let at = line.words.last()?.range.end;
    Some(format!("{} B5.{}", &line.text[..at], &line.text[at..]))
}

fn negative_speed(_: &Part, line: &Line) -> Planted {
    let word = line.word(b'S')?;
    line.g(&["97"])?;
    Some(line.with(word, &format!("S-{}", word.value)))
}

fn small_radius(part: &Part, line: &Line) -> Planted {
    line.g(&["2", "3"]).filter(|_| line.done.ran || cycle_around(part, line).is_some())?;
    Some(line.with(line.word(b'R')?, "R0.2"))
}

fn moved_centre(part: &Part, line: &Line) -> Planted {
    line.g(&["2", "3"]).filter(|_| line.done.ran || cycle_around(part, line).is_some())?;
    Some(line.with(line.word(b'I')?, "I9.5"))
}

/// A cycle by the contour of a subroutine.
fn by_subroutine(line: &Line) -> Option<&Word> {
    line.g(&["70", "71", "71.1", "71.2", "72", "72.1", "72.2"])?;
    line.word(b'Q').filter(|_| line.word(b'P').is_none())
}

fn no_subroutine(_: &Part, line: &Line) -> Planted {
    Some(line.with(by_subroutine(line)?, "Q8765"))
}

fn zero_depth(_: &Part, line: &Line) -> Planted {
    by_subroutine(line)?;
    Some(line.with(line.word(b'I')?, "I0"))
}

fn zero_crest(_: &Part, line: &Line) -> Planted {
    line.g(&["76"]).filter(|_| line.word(b'J').is_some())?;
    Some(line.with(line.word(b'I')?, "I0"))
}

fn no_cutting_speed(part: &Part, line: &Line) -> Planted {
    line.g(&["96"]).filter(|_| part.control == "linuxcnc-lathe")?;
    Some(line.without(line.word(b'S')?))
}
