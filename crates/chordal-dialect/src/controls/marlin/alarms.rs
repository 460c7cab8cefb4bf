//! The answers of Marlin to problems. It continues after each.

use crate::vocabulary::*;

pub(super) const ALARMS: &[(Code, &str)] = &[
    (Code::NoCenter, "Error:G2/G3 bad parameters"),
    (Code::FullCircleByRadius, "Error:G2/G3 bad parameters"),
];
