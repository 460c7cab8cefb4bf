//! The lines at the begin and the end of a program for Mitsubishi M700 and M800.

use crate::post::PostTemplate;

pub(super) const POST: PostTemplate = super::super::fanuc::POST;
