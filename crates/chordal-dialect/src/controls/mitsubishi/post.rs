//! How Mitsubishi M700 and M800 wants a program begun and ended.

use crate::post::PostTemplate;

pub(super) const POST: PostTemplate = super::super::fanuc::POST;
