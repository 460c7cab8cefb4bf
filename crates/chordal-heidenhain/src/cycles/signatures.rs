//! The cycles that are known: what carries each out, and the data without which it does not run.

use super::drilling::parameter_cycle_steps;
use super::faces::{face_steps, multipass_steps, ruled_surface_steps};
use super::pockets::pocket_steps;
use super::single_lip::single_lip_steps;
use super::slots::reciprocating_slot_steps;
use super::step::{CycleContext, KlartextCycleFault, KlartextCycleStep};
use super::studs::{stud_steps, wall_finishing_steps};
use super::threads::thread_steps;
use super::values::CycleValues;

/// Makes the steps of a cycle by its number.
pub type CycleSteps =
    fn(u32, &CycleValues, &CycleContext) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault>;

/// What carries a cycle out.
#[derive(Clone, Copy, Debug)]
pub enum KlartextCycleRunner {
    /// It runs where it is called, with every move from the manuals.
    Exact(CycleSteps),
    /// The same; the order of its moves, or some of them, are assumed.
    Assumed(CycleSteps),
    /// The same; where its lines lie in the plane is assumed.
    AssumedLines(CycleSteps),
    /// It runs where it is called, on the contours of cycle 14; the order of its moves is assumed.
    OnContours,
    /// It acts where it is defined.
    AtOnce,
    /// It is not carried out.
    Nothing,
}

/// A cycle with parameters.
#[derive(Clone, Copy, Debug)]
pub struct KlartextCycleSignature {
    /// Its number.
    pub number: u32,
    /// Its name.
    pub title: &'static str,
    /// The parameters that it must have.
    pub required: &'static [u32],
    /// What carries it out.
    pub runner: KlartextCycleRunner,
}

const fn exact(
    number: u32,
    title: &'static str,
    required: &'static [u32],
    steps: CycleSteps,
) -> KlartextCycleSignature {
    KlartextCycleSignature { number, title, required, runner: KlartextCycleRunner::Exact(steps) }
}

const fn assumed(
    number: u32,
    title: &'static str,
    required: &'static [u32],
    steps: CycleSteps,
) -> KlartextCycleSignature {
    KlartextCycleSignature { number, title, required, runner: KlartextCycleRunner::Assumed(steps) }
}

const fn assumed_lines(
    number: u32,
    title: &'static str,
    required: &'static [u32],
    steps: CycleSteps,
) -> KlartextCycleSignature {
    let runner = KlartextCycleRunner::AssumedLines(steps);
    KlartextCycleSignature { number, title, required, runner }
}

const fn on_contours(
    number: u32,
    title: &'static str,
    required: &'static [u32],
) -> KlartextCycleSignature {
    KlartextCycleSignature { number, title, required, runner: KlartextCycleRunner::OnContours }
}

const fn at_once(
    number: u32,
    title: &'static str,
    required: &'static [u32],
) -> KlartextCycleSignature {
    KlartextCycleSignature { number, title, required, runner: KlartextCycleRunner::AtOnce }
}

const fn unfollowed(number: u32, title: &'static str) -> KlartextCycleSignature {
    KlartextCycleSignature { number, title, required: &[], runner: KlartextCycleRunner::Nothing }
}

/// The word of the depth.
pub const MISSING_DEPTH: u32 = 201;

/// The cycles.
const CYCLE_SIGNATURES: &[KlartextCycleSignature] = &[
    at_once(20, "contour data", &[1, 3, 4, 5, 6, 7]),
    on_contours(21, "pilot drilling", &[10, 11]),
    on_contours(22, "rough-out", &[10, 11, 12]),
    on_contours(23, "floor finishing", &[11, 12]),
    on_contours(24, "side finishing", &[10, 11, 12]),
    on_contours(25, "contour train", &[1, 3, 5, 7, 10, 11, 12]),
    exact(200, "drilling", &[200, 201, 206, 202, 203], parameter_cycle_steps),
    exact(201, "reaming", &[200, 201, 206, 203], parameter_cycle_steps),
    exact(202, "boring", &[200, 201, 206, 203, 214], parameter_cycle_steps),
    exact(203, "universal drilling", &[200, 201, 206, 202, 203], parameter_cycle_steps),
    assumed(204, "back boring", &[200, 249, 250, 251, 252, 254, 203, 214], parameter_cycle_steps),
    exact(205, "universal pecking", &[200, 201, 206, 202, 203], parameter_cycle_steps),
    exact(206, "tapping with a floating chuck", &[200, 201, 206, 203], parameter_cycle_steps),
    exact(207, "rigid tapping", &[200, 201, 239, 203], parameter_cycle_steps),
    assumed(208, "bore milling", &[200, 201, 206, 334, 203, 335], parameter_cycle_steps),
    exact(209, "tapping with chip breaking", &[200, 201, 239, 203, 257], parameter_cycle_steps),
    at_once(220, "pattern of holes on a circle", &[216, 217, 244, 241]),
    at_once(221, "pattern of holes on lines", &[225, 226, 237, 238, 242, 243]),
    exact(240, "centring", &[200, 206, 203], parameter_cycle_steps),
    at_once(247, "preset", &[339]),
    assumed(
        210,
        "slot with reciprocating plunge",
        &[200, 201, 207, 202, 203, 216, 217, 218, 219],
        reciprocating_slot_steps,
    ),
    assumed(
        211,
        "round slot",
        &[200, 201, 207, 202, 203, 216, 217, 244, 219, 245, 248],
        reciprocating_slot_steps,
    ),
    assumed(
        212,
        "pocket finishing",
        &[200, 201, 206, 202, 207, 203, 216, 217, 218, 219],
        wall_finishing_steps,
    ),
    assumed(
        213,
        "stud finishing",
        &[200, 201, 206, 202, 207, 203, 216, 217, 218, 219],
        wall_finishing_steps,
    ),
    assumed(
        214,
        "circular pocket finishing",
        &[200, 201, 206, 202, 207, 203, 216, 217, 223],
        wall_finishing_steps,
    ),
    assumed(
        215,
        "circular stud finishing",
        &[200, 201, 206, 202, 207, 203, 216, 217, 223],
        wall_finishing_steps,
    ),
    assumed_lines(
        230,
        "multipass milling",
        &[225, 226, 227, 218, 219, 240, 206, 207, 209, 200],
        multipass_steps,
    ),
    assumed(
        231,
        "ruled surface",
        &[225, 226, 227, 228, 229, 230, 231, 232, 233, 234, 235, 236, 240, 207],
        ruled_surface_steps,
    ),
    assumed_lines(232, "face milling", &[225, 226, 227, 386, 218, 219, 202, 207, 200], face_steps),
    unfollowed(233, "face milling with side walls"),
    assumed(241, "single-lip deep-hole drilling", &[200, 201, 206, 203], single_lip_steps),
    assumed(251, "rectangular pocket", &[218, 219, 207, 201, 202, 206, 200, 203], pocket_steps),
    assumed(252, "circular pocket", &[223, 207, 201, 202, 206, 200, 203], pocket_steps),
    assumed(253, "slot", &[218, 219, 207, 201, 202, 206, 200, 203], pocket_steps),
    assumed(
        254,
        "circular slot",
        &[219, 375, 376, 248, 207, 201, 202, 206, 200, 203],
        pocket_steps,
    ),
    assumed(
        256,
        "rectangular stud",
        &[218, 424, 219, 425, 207, 201, 202, 206, 200, 203],
        stud_steps,
    ),
    assumed(257, "circular stud", &[223, 222, 207, 201, 202, 206, 200, 203], stud_steps),
    unfollowed(258, "polygon stud"),
    assumed(262, "thread milling", &[335, 239, 201, 200, 203, 207], thread_steps),
    assumed(
        263,
        "thread milling and countersinking",
        &[335, 239, 201, 356, 200, 203, 254, 207],
        thread_steps,
    ),
    assumed(
        264,
        "thread drilling and milling",
        &[335, 239, 201, 356, 202, 200, 203, 206, 207],
        thread_steps,
    ),
    assumed(
        265,
        "helical thread drilling and milling",
        &[335, 239, 201, 200, 203, 207],
        thread_steps,
    ),
    assumed(267, "outside thread milling", &[335, 239, 201, 200, 203, 207], thread_steps),
    at_once(270, "contour train data", &[]),
];

/// A cycle by its number; `None` for one that is not known.
pub fn cycle_signature(number: u32) -> Option<&'static KlartextCycleSignature> {
    CYCLE_SIGNATURES.iter().find(|cycle| cycle.number == number)
}
