//! G and M codes of one control on another: by what they do.

use chordal::Job;
use chordal::control::table::{CodeGroup, CodeRow, code_name, code_number};
use chordal::control::{Action, AfterCode, LengthCode, ModeCode, OnceCode, PathCode};
use chordal::control::{Control, UnitCodes, WorkName};

use super::draft::{BlockDraft, NeedsExpansion};
use crate::source::{WordStyle, whole};

/// The row of a control that does this.
pub(crate) fn row(action: Action, control: &Control) -> Option<(&'static CodeRow, u8)> {
    let usable = |row: &&CodeRow| {
        row.group != CodeGroup::Units
            || match control.parameters.unit_codes {
                UnitCodes::Both | UnitCodes::G20 => row.code < 700,
                UnitCodes::G70 => row.code >= 700,
            }
    };
    let mut g = control.g_codes().filter(usable).filter(|row| same(row.action, action));
    // Of several codes the first is the plain one; of path modes (G62, G64) the last.
    let g = match g.next() {
        Some(row) if row.group == CodeGroup::PathMode => g.next_back().or(Some(row)),
        row => row,
    };
    let m = || control.table.m_codes.iter().find(|row| same(row.action, action));
    g.map(|row| (row, b'G')).or_else(|| m().map(|row| (row, b'M')))
}

/// True when two actions do the same, so far as a program can show.
fn same(one: Action, other: Action) -> bool {
    if is_own(one) {
        return false;
    }
    let overrides = |action: Action| action.mode().and_then(ModeCode::overrides);
    let of_both = overrides(one).zip(overrides(other));
    of_both.map_or(one == other, |(one, other)| one == other)
}

/// A code that means what its control or its machine makes of it.
fn is_own(action: Action) -> bool {
    matches!(
        action,
        Action::NoEffect
            | Action::NotSimulated
            | Action::NotFollowed
            | Action::After(AfterCode::ShopCode)
    )
}

/// A code, by its words in a run, that means what the old control makes of it, and that the new one does not have with
/// this meaning: a conversion leaves it out.
pub(crate) fn is_only_of(words: &str, from: &Control, to: &Control) -> bool {
    let code = words.split(' ').next().unwrap_or_default();
    let row = |control: &Control| {
        let letter = code.bytes().next()?;
        let number = code_number(chordal::syntax::Decimal::parse(code.get(1..)?.as_bytes())?)?;
        match letter {
            b'G' => control.g_code(number),
            _ => control.m_code(number),
        }
    };
    let Some(own) = row(from) else { return false };
    !row(to).is_some_and(|there| there.action == own.action && there.title == own.title)
}

/// A row's code as the programmer writes codes.
pub(crate) fn spelt(row: &CodeRow, letter: u8, style: WordStyle) -> String {
    if style.two_digits && row.code < 100 && row.code.is_multiple_of(10) {
        return format!("{}{:02}", char::from(letter), row.code / 10);
    }
    row.name(letter)
}

/// The code that does this, as the programmer writes codes.
pub(crate) fn name(action: Action, control: &Control, style: WordStyle) -> Option<String> {
    row(action, control).map(|(row, letter)| spelt(row, letter, style))
}

pub(crate) fn overrides(on: bool, control: &Control, style: WordStyle) -> Option<String> {
    name(Action::Mode(ModeCode::Overrides { on, rapid: false }), control, style)
}

/// What an action is, for people.
pub(crate) fn what(action: Action) -> String {
    let rows = chordal::control::CONTROLS
        .iter()
        .flat_map(|table| table.g_codes.iter().chain(table.m_codes));
    let title = rows.into_iter().find(|row| same(row.action, action)).map(|row| row.title);
    title.unwrap_or("a code of the control").into()
}

/// The words that choose a work offset; nothing where the control does not have so many.
pub(crate) fn work_offset(name: WorkName, control: &Control, style: WordStyle) -> Option<String> {
    let number = name.ordinal();
    let table = control.table;
    if table.work_names.by_e {
        return Some(format!("E{number}"));
    }
    let code = |mode| self::name(Action::Mode(mode), control, style);
    let gap = if style.spaced { " " } else { "" };
    let by_p = |mode, p| code(mode).map(|code| format!("{code}{gap}P{p}"));
    match number {
        0 => None,
        1..=5 => code(ModeCode::WorkOffset(53 + number as u16)),
        // Where one code counts all of them it is this one without P.
        6 => code(ModeCode::WorkOffset(59)).or_else(|| code(ModeCode::WorkOffsetByOrdinal)),
        _ => code(ModeCode::WorkOffsetPoint(number as u16 - 6))
            .or_else(|| by_p(ModeCode::WorkOffsetExtended, number - 6))
            .or_else(|| by_p(ModeCode::WorkOffsetByOrdinal, number)),
    }
}

/// What becomes of the G and M words of a block.
pub(crate) fn translate(
    draft: &mut BlockDraft,
    from: &Control,
    to: &Control,
    style: WordStyle,
) -> Result<(), NeedsExpansion> {
    for at in 0..draft.block.words.len() {
        let word = draft.block.words[at];
        if draft.is_changed(at) {
            continue;
        }
        let Some(own) = from.row_of(&word) else { continue };
        one(draft, at, own, [from, to], style)?;
    }
    Ok(())
}

fn one(
    draft: &mut BlockDraft,
    at: usize,
    own: &'static CodeRow,
    [from, to]: [&Control; 2],
    style: WordStyle,
) -> Result<(), NeedsExpansion> {
    let letter = draft.block.words[at].letter;
    let there = if letter == b'G' { to.g_code(own.code) } else { to.m_code(own.code) };
    let title = to.table.title;
    if is_own(own.action) {
        if !there.is_some_and(|row| row.action == own.action && row.title == own.title) {
            leave_out(draft, at, own, to);
        }
        return Ok(());
    }
    if let Some(code) = own.action.mode() {
        if code.is_work_offset() {
            return offset_code(draft, at, code, [from, to], style);
        }
        if code.is_other_plane() && from.parameters.plane_codes != to.parameters.plane_codes {
            let other = match code == ModeCode::PlaneZx {
                true => ModeCode::PlaneYz,
                false => ModeCode::PlaneZx,
            };
            let new = name(Action::Mode(other), to, style).ok_or_else(|| missing(own, to))?;
            draft.replace(at, new, format!("{title} uses this code for the plane"));
            return Ok(());
        }
        if code == ModeCode::Path(PathCode::ExactStopOnce) && row(own.action, to).is_none() {
            exact_stop_once(draft, at, to, style);
            return Ok(());
        }
    }
    match own.action.once() {
        // Its words differ from one control to the next, but for those that call it alike.
        Some(OnceCode::Surface(_)) => {
            let is_alike = |row: &CodeRow| row.action == own.action && row.title == own.title;
            return there.is_some_and(is_alike).then_some(()).ok_or_else(|| missing(own, to));
        }
        // What holes these make is looked at with their cycle.
        Some(OnceCode::Pattern(_)) => return Ok(()),
        Some(_) | None => {}
    }
    if own.action == Action::After(AfterCode::RunCycleHere) {
        return Ok(());
    }
    // What is drilled along X, or tapped with a live tool, has codes of its own.
    if own.action.cycle().is_some()
        && is_in(own, from) != LatheDrilling::default()
        && there.is_none_or(|row| row.action != own.action)
    {
        let row = cycle_row(own, is_in(own, from), to).ok_or_else(|| missing(own, to))?;
        let reason = format!("{}: {title} has another code for it", own.title);
        draft.replace(at, spelt(row, b'G', style), reason);
        return Ok(());
    }
    if own.action == Action::Length(LengthCode::Cancel)
        && from.table.firmware.is_none()
        && to.table.firmware.is_some()
        && draft.block.letters().meets(chordal::syntax::Letters::of("XYZ"))
        && let Some(new) = name(own.action, to, style)
    {
        draft.remove(at, format!("{title} ignores axis words next to {new}: in a block before"));
        draft.before.push(new);
        return Ok(());
    }
    // The same number for the same thing is the rule.
    if there.is_some_and(|row| same(row.action, own.action) && is_chosen(row, to)) {
        return Ok(());
    }
    if let Some(new) = name(own.action, to, style) {
        draft.replace(at, new, format!("{}: {title} has another code for it", own.title));
        return Ok(());
    }
    without_such_a_code(draft, at, own, to, style)
}

/// Along X, and with a live tool.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct LatheDrilling {
    pub(crate) radial: bool,
    pub(crate) live: bool,
}

/// What a code of a cycle drills like on its control.
pub(crate) fn is_in(row: &CodeRow, control: &Control) -> LatheDrilling {
    LatheDrilling {
        radial: control.table.radial_cycles.contains(&row.code),
        live: control.table.live_taps.contains(&row.code),
    }
}

/// The code of a control for the same cycle in the same direction; one for live tools where it has such.
pub(crate) fn cycle_row(
    own: &CodeRow,
    drilling: LatheDrilling,
    to: &Control,
) -> Option<&'static CodeRow> {
    let rows = || {
        to.g_codes()
            .filter(|row| row.action == own.action && is_in(row, to).radial == drilling.radial)
    };
    rows().find(|row| is_in(row, to).live == drilling.live).or_else(|| rows().next())
}

/// A code whose like the new control does not have.
fn without_such_a_code(
    draft: &mut BlockDraft,
    at: usize,
    own: &'static CodeRow,
    to: &Control,
    style: WordStyle,
) -> Result<(), NeedsExpansion> {
    let title = to.table.title;
    if let Action::Mode(ModeCode::Path(code)) = own.action {
        return path_mode_without_a_code(draft, at, own, code, to, style);
    }
    if own.action.facts(to.table, &to.parameters).may_be_left_out {
        match own.action.mode() {
            Some(_) => leave_out(draft, at, own, to),
            None => draft.remove(at, format!("centres are written as {title} reads them")),
        }
        return Ok(());
    }
    if let Some(OnceCode::Probe { must_hit }) = own.action.once() {
        let new = name(Action::Once(OnceCode::Probe { must_hit: !must_hit }), to, style);
        let reason = format!("{title} reports a probe without a touch in another way");
        draft.replace(at, new.ok_or_else(|| missing(own, to))?, reason);
        return Ok(());
    }
    if matches!(own.action, Action::Length(LengthCode::Plus | LengthCode::Cancel))
        && !has_lengths(to)
    {
        draft.remove(at, without_lengths(to));
        if let Some(h) = draft.place(b'H') {
            draft.remove(h, without_lengths(to));
        }
        return Ok(());
    }
    Err(missing(own, to))
}

/// It has a table of tool lengths. Where it has none, each tool is set to the work zero by itself.
pub(crate) fn has_lengths(control: &Control) -> bool {
    row(Action::Length(LengthCode::Plus), control).is_some()
}

/// Whether programs of all these jobs choose tool lengths; controls of other languages have them.
pub(crate) fn all_have_lengths(jobs: [&Job; 2]) -> bool {
    jobs.into_iter().all(|job| job.word_address().is_none_or(has_lengths))
}

/// Why the length of a tool is left out.
pub(crate) fn without_lengths(to: &Control) -> String {
    format!("{} has no tool table: set Z to the work zero with each tool", to.table.title)
}

fn path_mode_without_a_code(
    draft: &mut BlockDraft,
    at: usize,
    own: &'static CodeRow,
    code: PathCode,
    to: &Control,
    style: WordStyle,
) -> Result<(), NeedsExpansion> {
    let stop = Action::Mode(ModeCode::Path(PathCode::ExactStop));
    match name(stop, to, style).filter(|_| code == PathCode::Exact) {
        Some(new) => {
            let title = to.table.title;
            draft.replace(at, new, format!("{title} has no exact path without a stop"));
        }
        None if code == PathCode::ExactStopOnce => return Err(missing(own, to)),
        None => leave_out(draft, at, own, to),
    }
    Ok(())
}

fn is_chosen(row: &CodeRow, control: &Control) -> bool {
    self::row(row.action, control)
        .is_none_or(|(first, _)| row.group != CodeGroup::Units || first.code == row.code)
}

fn missing(own: &CodeRow, to: &Control) -> NeedsExpansion {
    NeedsExpansion(format!("{} has no code for {}", to.table.title, own.title))
}

/// Takes a code out that moves nothing, with the words that only it takes.
fn leave_out(draft: &mut BlockDraft, at: usize, own: &CodeRow, to: &Control) {
    let reason = format!("{} has no code for it ({})", to.table.title, own.title);
    let code = draft.written(at);
    draft.remove(at, reason);
    let axes = chordal::syntax::Letters::of("XYZABCFSTHDN");
    let others = draft.block.words.iter().enumerate().any(|(other, word)| {
        other != at && matches!(word.letter, b'G' | b'M') && !draft.is_gone(other)
    });
    for other in 0..draft.block.words.len() {
        let letter = draft.block.words[other].letter;
        if !others && own.words.without(axes).has(letter) && !matches!(letter, b'G' | b'M') {
            draft.remove(other, format!("belongs to {code}"));
        }
    }
}

fn exact_stop_once(draft: &mut BlockDraft, at: usize, to: &Control, style: WordStyle) {
    let stop = name(Action::Mode(ModeCode::Path(PathCode::ExactStop)), to, style);
    let go_on = name(Action::Mode(ModeCode::Path(PathCode::Continuous)), to, style);
    let (Some(stop), Some(go_on)) = (stop, go_on) else {
        return draft.remove(at, format!("{} stops at corners by a modal code", to.table.title));
    };
    draft.replace(
        at,
        stop,
        format!("{} stops at corners by a modal code, here active for this block", to.table.title),
    );
    draft.after.push(go_on);
}

fn offset_code(
    draft: &mut BlockDraft,
    at: usize,
    code: ModeCode,
    [from, to]: [&Control; 2],
    style: WordStyle,
) -> Result<(), NeedsExpansion> {
    let p = draft.place(b'P');
    let is_by_ordinal = code == ModeCode::WorkOffsetByOrdinal;
    let by_code = code.work_name().or((is_by_ordinal && p.is_none()).then_some(WorkName::G(59)));
    let name = match by_code {
        Some(name) => name,
        None => {
            let number = whole(p.map(|p| &draft.block.words[p]));
            let number = number.and_then(|number| u16::try_from(number).ok());
            let Some(number) = number else {
                return Err(NeedsExpansion("the number of the work offset is computed".into()));
            };
            if from.table.work_names == to.table.work_names {
                return Ok(());
            }
            draft.set(p.unwrap_or(at), "");
            if is_by_ordinal {
                let none = || NeedsExpansion("there is no work offset 0".into());
                WorkName::of_ordinal(number).ok_or_else(none)?
            } else {
                WorkName::Extended(number)
            }
        }
    };
    let new = work_offset(name, to, style).ok_or_else(|| {
        NeedsExpansion(format!("{} has no work offset {}", to.table.title, name.ordinal()))
    })?;
    let reason = format!("work offset {} is {new} on {}", name.ordinal(), to.table.title);
    let written = draft.written(at);
    let is_same = chordal::syntax::Decimal::parse(&written.as_bytes()[1..])
        .and_then(code_number)
        .is_some_and(|code| new == code_name(b'G', code));
    if !is_same {
        draft.replace(at, new, reason);
    }
    Ok(())
}
