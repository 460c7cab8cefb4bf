//! The alarms of refused cycles on Mitsubishi lathes; all other alarms are those of the mills.

use crate::vocabulary::*;

pub(super) const TURNING: &[(TurnFault, &str)] = &[
    (TurnFault::Depth, "P204 E cmnd fixed cycle error (MRC)"),
    (TurnFault::NoContour, "P204 E cmnd fixed cycle error (MRC)"),
    (TurnFault::NoLabel, "P200 No program exists (MRC)"),
    (TurnFault::TurnsBack, "P203 D cmnd figure error (MRC)"),
    (TurnFault::NotMonotone, "P203 D cmnd figure error (MRC)"),
    (TurnFault::FirstBlock, "P203 D cmnd figure error (MRC)"),
    (TurnFault::CodeInContour, "P201 Program error (MRC)"),
    (TurnFault::Passes, "P204 E cmnd fixed cycle error (MRC)"),
    (TurnFault::Step, "P204 E cmnd fixed cycle error (MRC)"),
    (TurnFault::ThreadDepth, "P204 E cmnd fixed cycle error (MRC)"),
    (TurnFault::ThreadLeast, "P204 E cmnd fixed cycle error (MRC)"),
    (TurnFault::ThreadAngle, "P204 E cmnd fixed cycle error (MRC)"),
    (TurnFault::Lead, "P62 No F command"),
    (TurnFault::PassAxis, "P190 Turning cycle command error"),
];
