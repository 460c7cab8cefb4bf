//! The codes for what is in force.

use chordal::control::{Action, FeedMode, ModeCode, ReadingCode, Units};
use chordal::geometry::Plane;

pub(crate) fn units_action(units: Units) -> Action {
    match units {
        Units::Inch => Action::Reading(ReadingCode::Inch),
        Units::Millimetre => Action::Reading(ReadingCode::Millimetre),
    }
}

pub(crate) fn plane_action(plane: Plane) -> Action {
    match plane {
        Plane::Xy => Action::Mode(ModeCode::PlaneXy),
        Plane::Zx => Action::Mode(ModeCode::PlaneZx),
        Plane::Yz => Action::Mode(ModeCode::PlaneYz),
    }
}

pub(crate) fn distance_action(incremental: bool) -> Action {
    if incremental {
        Action::Reading(ReadingCode::Incremental)
    } else {
        Action::Reading(ReadingCode::Absolute)
    }
}

pub(crate) fn feed_action(mode: FeedMode) -> Action {
    match mode {
        FeedMode::PerTime => Action::Reading(ReadingCode::FeedPerTime),
        FeedMode::InverseTime => Action::Reading(ReadingCode::FeedInverseTime),
        FeedMode::PerRevolution => Action::Reading(ReadingCode::FeedPerRevolution),
    }
}
