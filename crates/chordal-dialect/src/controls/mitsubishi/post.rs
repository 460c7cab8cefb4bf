//! How Mitsubishi M700 and M800 wants a program begun and ended.

use crate::post::Post;

pub(super) const POST: Post = super::super::fanuc::POST;
