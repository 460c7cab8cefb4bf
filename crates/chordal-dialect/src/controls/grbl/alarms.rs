//! The alarms of GRBL 1.1, for motions that are not possible; wrong blocks get the answers in `firmware.rs`.

use crate::vocabulary::*;

pub(super) const ALARMS: &[(Code, &str)] = &[
    (Code::TravelExceeded, "ALARM:2"),
    (Code::ProbeWithoutHit, "ALARM:5"),
    (Code::RadiusMismatch, "error:33"),
    (Code::RadiusTooShort, "error:34"),
    (Code::FullCircleByRadius, "error:33"),
    (Code::NoCenter, "error:35"),
    (Code::MissingFeed, "error:22"),
];
