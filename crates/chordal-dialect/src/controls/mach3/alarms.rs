//! The alarms of Mach3. Its texts are not published: these are from the older interpreter that it is based on, and from
//! reports of users.

use crate::vocabulary::*;

pub(super) const ALARMS: &[(Code, &str)] =
    &[(Code::RadiusMismatch, "Radius to end of arc differs from radius to start")];
