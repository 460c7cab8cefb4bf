//! What cannot be bent over a map, each with its reason and what to do.

use chordal::control::{Action, CompensationSide, FeedMode, ModeCode, OnceCode, PathCode};
use chordal::diagnostics::TextRange;
use chordal::geometry::Plane;
use chordal::syntax::{Block, Word};

use super::super::edit::{TransformRefusal, line_end};
use super::super::record::{BlockEffect, BlockPass, BlockRuns};
use super::super::roles::actions;
use super::super::writer::WordWriter;
use super::grid::HeightMap;
use super::plane_path::PlanePath;

type HeightsRefusal = (String, &'static str);

fn refusal_text(
    writer: &WordWriter,
    block: &Block,
    reason: Option<HeightsRefusal>,
) -> Result<(), TransformRefusal> {
    match reason {
        Some((what, help)) => Err(TransformRefusal::new(writer.text, block, what, help)),
        None => Ok(()),
    }
}

/// The work offset that a block chooses, as it is written.
fn work_offset(writer: &WordWriter, block: &Block) -> Option<String> {
    let by_code = actions(block, writer.control)
        .find(|(_, action)| matches!(action, Action::Mode(code) if code.is_work_offset()));
    let by_word = block.word(b'E').filter(|_| writer.control.table.work_names.by_e);
    let word = by_code.map(|(word, _)| word).or(by_word)?;
    let more = block.word(b'P').map_or(String::new(), |word| writer.word(word));
    Some(writer.word(word) + &more)
}

/// Codes under which words are no places on the map. `work` is the work offset that was chosen first.
pub(super) fn codes(
    writer: &WordWriter,
    block: &Block,
    work: &mut Option<String>,
) -> Result<(), TransformRefusal> {
    for (word, action) in actions(block, writer.control) {
        refusal_text(writer, block, of_code(&writer.word(word), action))?;
    }
    let Some(chosen) = work_offset(writer, block) else { return Ok(()) };
    let first = work.get_or_insert_with(|| chosen.clone());
    let reason = (*first != chosen).then(|| {
        (
            format!("the program uses {first} and {chosen}, and the map lies in one work offset"),
            "bend one program for each work offset",
        )
    });
    refusal_text(writer, block, reason)
}

/// Why a code does not go with a map; nothing where it does.
fn of_code(word: &str, action: Action) -> Option<HeightsRefusal> {
    let once = action.once();
    let is = |codes: fn(OnceCode) -> bool| once.is_some_and(codes);
    let turns = action == Action::Mode(ModeCode::Polar { on: true })
        || is(|code| {
            matches!(
                code,
                OnceCode::Rotation
                    | OnceCode::Scaling
                    | OnceCode::Mirror { .. }
                    | OnceCode::Surface(_)
                    | OnceCode::TiltedPlane(_)
            )
        });
    let shifts = is(|code| {
        matches!(code, OnceCode::LocalShift | OnceCode::PresetPosition | OnceCode::RestorePreset)
    });
    if turns {
        let what = format!("under `{word}` the words are no places on the map");
        Some((what, "write the moves out in plain coordinates"))
    } else if shifts {
        let what = format!("`{word}` moves the zero, and the map lies in one place");
        Some((what, "write the program from one zero"))
    } else if is(|code| matches!(code, OnceCode::Probe { .. })) {
        Some((format!("`{word}` measures a place itself"), "take the probing out of the program"))
    } else if is(|code| {
        code.is_pocket() || matches!(code, OnceCode::Pattern(_) | OnceCode::Engraving)
    }) {
        Some((format!("`{word}` makes moves of its own"), "write the moves out"))
    } else {
        None
    }
}

/// A move that the map says nothing of.
pub(super) fn of_move(
    writer: &WordWriter,
    block: &Block,
    runs: &BlockRuns,
) -> Result<(), TransformRefusal> {
    let run = &runs.first;
    let context = &run.context;
    let is_arc = matches!(context.did, BlockEffect::Arc | BlockEffect::Spiral);
    let computed = |word: &Word| b"XYZ".contains(&word.letter) && word.number().is_none();
    let (what, help) = if context.did == BlockEffect::Cycle {
        ("a canned cycle has one depth for all of its holes", "write the holes as single moves")
    } else if matches!(context.did, BlockEffect::Spiral | BlockEffect::Spline) {
        ("a spiral does not lie on the map as one block", "write it as chords first (--chords)")
    } else if is_arc && context.plane != Plane::Xy {
        ("an arc in G18 or G19 does not stay one on the map", "write it as chords first (--chords)")
    } else if runs.contexts.len() > 1 || !(runs.same || runs.count == 1) {
        ("the block runs several times, from different places", "copy the subprogram for each use")
    } else if context.incremental {
        ("G91 is active: a distance says nothing of the place on the map", "write the moves in G90")
    } else if context.side != CompensationSide::Off {
        ("cutter compensation is on", "let the CAM system compute the path of the tool centre")
    } else if block.words.iter().any(|word| b"ABC".contains(&word.letter)) {
        ("a rotary axis turns the part under the map", "bend only programs of three axes")
    } else if run.moves > 1 {
        ("the block makes several moves", "write the moves out")
    } else if block.delete.is_some() {
        ("a move with / may be left out, and what follows counts on its height", "take the / away")
    } else if block.words.iter().any(computed) {
        ("a place is computed, not written as a number", "write the places as numbers")
    } else {
        return Ok(());
    };
    refusal_text(writer, block, Some((what.into(), help)))
}

/// A cut that leaves the map.
pub(super) fn inside(
    writer: &WordWriter,
    map: &HeightMap,
    block: &Block,
    run: &BlockPass,
    plane_path: &PlanePath,
) -> Result<(), TransformRefusal> {
    let most = plane_path.extremes().into_iter().map(|at| map.outside(at)).fold(0.0, f64::max);
    let unit = run.context.units.mm();
    let name = if unit == 1.0 { "mm" } else { "in" };
    let reason = (most > 1e-6).then(|| {
        (
            format!("the cut goes {:.4} {name} beyond the map", most / unit),
            "measure a larger rectangle, or let the edge of the map go on: --heights-outside clamp",
        )
    });
    refusal_text(writer, block, reason)
}

/// A block that becomes several, and cannot. `alone` is said of one that has its line for itself.
pub(super) fn several(
    writer: &WordWriter,
    block: &Block,
    run: &BlockPass,
    alone: bool,
) -> Result<(), TransformRefusal> {
    let rest = TextRange::new(block.range.end, line_end(writer.text, block.range.end));
    let rest = String::from_utf8_lossy(rest.slice(writer.text));
    let rest = rest.trim_matches([' ', ';', '\t']);
    let is_once = |action: Action| {
        let lasts = matches!(
            action,
            Action::Motion(_) | Action::Reading(_) | Action::Mode(_) | Action::Length(_)
        );
        !lasts || action == Action::Mode(ModeCode::Path(PathCode::ExactStopOnce))
    };
    let once = actions(block, writer.control).find(|(_, action)| is_once(*action));
    let turns =
        run.context.did == BlockEffect::Arc && b"PLQ".iter().any(|word| block.letters().has(*word));
    let (what, help) = if !(alone && (rest.is_empty() || rest.starts_with('('))) {
        (
            "something else follows the block on its line".to_string(),
            "write each block on a line of its own",
        )
    } else if let Some((word, _)) = once {
        (
            format!("the cut becomes several blocks, and `{}` is for one", writer.word(word)),
            "write the code on a line of its own",
        )
    } else if turns {
        (
            "the arc becomes several, and its turns are counted in one word".into(),
            "write each turn as a block",
        )
    } else if run.context.feed_mode == FeedMode::InverseTime {
        (
            "in G93 the feed is the time of one block, and the cut becomes several".into(),
            "write the program with feeds per minute (G94)",
        )
    } else {
        return Ok(());
    };
    refusal_text(writer, block, Some((what, help)))
}
