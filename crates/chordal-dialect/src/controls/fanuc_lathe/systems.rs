//! The G code systems B and C of Fanuc lathes (No. 3401), as their differences from A.

use crate::vocabulary::codes::*;
use crate::vocabulary::*;
use chordal_kernel::TurnPass;
use chordal_kernel::rules::TurnCycle;

use super::codes::CYCLE_WORDS;

pub(super) const SYSTEMS: &[CodeSystem] =
    &[CodeSystem { name: "B", codes: B, without: &[320, 500] }, CodeSystem { name: "C", codes: C, without: &[320, 500] }];

const B: &[CodeRow] = &[
    row(330, CodeGroup::Motion, Motion(Thread), "Q", "thread in one pass, F is its lead"),
    row(770, CodeGroup::Motion, Motion(Turn(TurnPass::Turning)), "RI", "one pass along Z, and back"),
    row(780, CodeGroup::Motion, Motion(Turn(TurnPass::Thread)), "RIQ", "one thread pass, and back"),
    row(790, CodeGroup::Motion, Motion(Turn(TurnPass::Facing)), "RK", "one pass along X, and back"),
    row(900, CodeGroup::Distance, Reading(Absolute), "", "absolute coordinates"),
    row(910, CodeGroup::Distance, Reading(Incremental), "", "incremental coordinates"),
    PRESET,
    row(940, CodeGroup::FeedMode, Reading(FeedPerTime), "", "feed per minute"),
    row(950, CodeGroup::FeedMode, Reading(FeedPerRevolution), "", "feed per revolution"),
    row(980, CodeGroup::ReturnLevel, Mode(ReturnInitial), "", "cycles return to the initial level"),
    row(990, CodeGroup::ReturnLevel, Mode(ReturnToR), "", "cycles return to the R level"),
];

const C: &[CodeRow] = &[
    row(200, CodeGroup::Motion, Motion(Turn(TurnPass::Turning)), "RI", "one pass along Z, and back"),
    row(210, CodeGroup::Motion, Motion(Turn(TurnPass::Thread)), "RIQ", "one thread pass, and back"),
    row(240, CodeGroup::Motion, Motion(Turn(TurnPass::Facing)), "RK", "one pass along X, and back"),
    row(330, CodeGroup::Motion, Motion(Thread), "Q", "thread in one pass, F is its lead"),
    row(700, CodeGroup::Units, Reading(Inch), "", "inch"),
    row(710, CodeGroup::Units, Reading(Millimetre), "", "millimetres"),
    row(720, CodeGroup::OneShot, Once(Turning(TurnCycle::Finish)), CYCLE_WORDS, "finishing cycle"),
    row(730, CodeGroup::OneShot, Once(Turning(TurnCycle::Rough)), CYCLE_WORDS, "roughing along Z"),
    row(740, CodeGroup::OneShot, Once(Turning(TurnCycle::RoughFace)), CYCLE_WORDS, "roughing along X"),
    row(
        750,
        CodeGroup::OneShot,
        Once(Turning(TurnCycle::Pattern)),
        CYCLE_WORDS,
        "the contour again and again, ever nearer",
    ),
    row(760, CodeGroup::OneShot, Once(Turning(TurnCycle::PeckZ)), CYCLE_WORDS, "pecks along Z"),
    row(770, CodeGroup::OneShot, Once(Turning(TurnCycle::PeckX)), CYCLE_WORDS, "pecks along X"),
    row(780, CodeGroup::OneShot, Once(Turning(TurnCycle::Thread)), CYCLE_WORDS, "thread in many passes"),
    row(900, CodeGroup::Distance, Reading(Absolute), "", "absolute coordinates"),
    row(910, CodeGroup::Distance, Reading(Incremental), "", "incremental coordinates"),
    PRESET,
    row(940, CodeGroup::FeedMode, Reading(FeedPerTime), "", "feed per minute"),
    row(950, CodeGroup::FeedMode, Reading(FeedPerRevolution), "", "feed per revolution"),
    row(980, CodeGroup::ReturnLevel, Mode(ReturnInitial), "", "cycles return to the initial level"),
    row(990, CodeGroup::ReturnLevel, Mode(ReturnToR), "", "cycles return to the R level"),
];

const PRESET: CodeRow = row(
    920,
    CodeGroup::OneShot,
    Once(PresetPosition),
    "S",
    "the current position gets these coordinates; S limits the spindle speed",
);
