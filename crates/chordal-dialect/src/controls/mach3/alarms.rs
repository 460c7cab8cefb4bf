//! What Mach3 shows for a problem. Its texts are not published: those that its interpreter has from the
//! common ancestor and that its users report.

use crate::vocabulary::*;

pub(super) const ALARMS: &[(Code, &str)] =
    &[(Code::RadiusMismatch, "Radius to end of arc differs from radius to start")];
