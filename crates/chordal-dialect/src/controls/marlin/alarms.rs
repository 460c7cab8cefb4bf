//! What Marlin answers. It goes on after each.

use crate::vocabulary::*;

pub(super) const ALARMS: &[(Code, &str)] = &[
    (Code::NoCenter, "Error:G2/G3 bad parameters"),
    (Code::FullCircleByRadius, "Error:G2/G3 bad parameters"),
];
