//! The alarms of refused cycles on Fanuc lathes; all other alarms are those of the mills.

use crate::vocabulary::*;

pub(super) const TURNING: &[(TurnFault, &str)] = &[
    (TurnFault::Depth, "PS0062 ILLEGAL COMMAND IN THE BLOCK"),
    (TurnFault::NoContour, "PS0061 P OR Q COMMAND IS NOT IN THE MULTIPLE REPETITIVE CYCLES BLOCK"),
    (TurnFault::NoLabel, "PS0063 SPECIFIED SEQUENCE NUMBER NOT FOUND"),
    (TurnFault::TurnsBack, "PS0064 THE FINISHING SHAPE IS NOT A MONOTONOUS CHANGE (FIRST AXES)"),
    (TurnFault::NotMonotone, "PS0329 THE FINISHING SHAPE IS NOT A MONOTONOUS CHANGE (SECOND AXES)"),
    (TurnFault::FirstBlock, "PS0065 G00/G01 IS NOT IN THE FIRST BLOCK OF SHAPE PROGRAM"),
    (TurnFault::CodeInContour, "PS0325 UNAVAILABLE COMMAND IS IN SHAPE PROGRAM"),
    (TurnFault::Passes, "PS0321 ILLEGAL REPEATED COUNT"),
    (TurnFault::Step, "PS0320 ILLEGAL MOVEMENT AMOUNT/CUTTING AMOUNT"),
    (TurnFault::ThreadDepth, "PS0317 ILLEGAL THREAD CUTTING COMMAND"),
    (TurnFault::ThreadLeast, "PS0316 ILLEGAL CUTTING AMOUNT"),
    (TurnFault::ThreadAngle, "PS0315 ILLEGAL THREAD ANGLE COMMAND"),
    (TurnFault::Lead, "PS0313 ILLEGAL LEAD COMMAND"),
    (TurnFault::PassAxis, "PS0330 ILLEGAL AXIS COMMAND IS IN THE TURNING CANNED CYCLE"),
];
