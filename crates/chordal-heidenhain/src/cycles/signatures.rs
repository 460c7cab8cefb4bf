//! The cycles that are known, and the data without which they do not run.

/// A cycle with parameters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct KlartextCycleSignature {
    /// Its number.
    pub number: u32,
    /// Its name.
    pub title: &'static str,
    /// The parameters that it must have.
    pub required: &'static [u32],
    /// It is carried out.
    pub is_carried_out: bool,
}

const fn cycle(
    number: u32,
    title: &'static str,
    required: &'static [u32],
) -> KlartextCycleSignature {
    KlartextCycleSignature { number, title, required, is_carried_out: true }
}

const fn unfollowed(number: u32, title: &'static str) -> KlartextCycleSignature {
    KlartextCycleSignature { number, title, required: &[], is_carried_out: false }
}

/// The word of the depth.
pub const MISSING_DEPTH: u32 = 201;

/// The cycles.
const CYCLE_SIGNATURES: &[KlartextCycleSignature] = &[
    cycle(200, "drilling", &[200, 201, 206, 202, 203]),
    cycle(201, "reaming", &[200, 201, 206, 203]),
    cycle(202, "boring", &[200, 201, 206, 203, 214]),
    cycle(203, "universal drilling", &[200, 201, 206, 202, 203]),
    cycle(204, "back boring", &[200, 249, 250, 251, 252, 254, 203, 214]),
    cycle(205, "universal pecking", &[200, 201, 206, 202, 203]),
    cycle(206, "tapping with a floating chuck", &[200, 201, 206, 203]),
    cycle(207, "rigid tapping", &[200, 201, 239, 203]),
    cycle(208, "bore milling", &[200, 201, 206, 334, 203, 335]),
    cycle(209, "tapping with chip breaking", &[200, 201, 239, 203, 257]),
    cycle(220, "pattern of holes on a circle", &[216, 217, 244, 241]),
    cycle(221, "pattern of holes on lines", &[225, 226, 237, 238, 242, 243]),
    cycle(240, "centring", &[200, 206, 203]),
    cycle(247, "preset", &[339]),
    unfollowed(210, "slot with reciprocating plunge"),
    unfollowed(211, "round slot"),
    unfollowed(212, "pocket finishing"),
    unfollowed(213, "stud finishing"),
    unfollowed(214, "circular pocket finishing"),
    unfollowed(215, "circular stud finishing"),
    unfollowed(230, "multipass milling"),
    unfollowed(231, "ruled surface"),
    unfollowed(232, "face milling"),
    unfollowed(233, "face milling"),
    unfollowed(241, "single-lip deep-hole drilling"),
    cycle(251, "rectangular pocket", &[218, 219, 207, 201, 202, 206, 200, 203]),
    cycle(252, "circular pocket", &[223, 207, 201, 202, 206, 200, 203]),
    cycle(253, "slot", &[218, 219, 207, 201, 202, 206, 200, 203]),
    cycle(254, "circular slot", &[219, 375, 376, 248, 207, 201, 202, 206, 200, 203]),
    unfollowed(256, "rectangular stud"),
    unfollowed(257, "circular stud"),
    cycle(262, "thread milling", &[335, 239, 201, 200, 203, 207]),
    cycle(263, "thread milling and countersinking", &[335, 239, 201, 356, 200, 203, 254, 207]),
    cycle(264, "thread drilling and milling", &[335, 239, 201, 356, 202, 200, 203, 206, 207]),
    cycle(265, "helical thread drilling and milling", &[335, 239, 201, 200, 203, 207]),
    unfollowed(267, "outside thread milling"),
];

/// A cycle by its number; `None` for one that is not known.
pub fn cycle_signature(number: u32) -> Option<&'static KlartextCycleSignature> {
    CYCLE_SIGNATURES.iter().find(|cycle| cycle.number == number)
}

/// How many lines of data an old cycle has; `None` for one that is not carried out.
pub fn old_cycle_lines(number: u32) -> Option<u32> {
    match number {
        1 => Some(5),
        2 => Some(4),
        17 | 18 => Some(3),
        4 => Some(6),
        5 => Some(5),
        _ => None,
    }
}
