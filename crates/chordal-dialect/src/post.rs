//! How a control wants a program begun and ended, as data: the way of the tool is the same.

/// The frame of a program. In the lines `{…}` is what the thread mill program fills in.
#[derive(Debug)]
pub struct PostTemplate {
    /// What stands around a remark.
    pub remark: [&'static str; 2],
    /// Before the remarks: file mark and program number.
    pub open: &'static [&'static str],
    /// From the tool change until the tool stands above the start.
    pub begin: &'static [&'static str],
    /// From the clearance plane to the end.
    pub end: &'static [&'static str],
    /// `G03`, not `G3`.
    pub two_digits: bool,
}

impl PostTemplate {
    /// No lines around the path.
    pub const EMPTY: PostTemplate =
        PostTemplate { remark: ["(", ")"], open: &[], begin: &[], end: &[], two_digits: false };

    /// A G code as this control's people write it.
    pub fn code(&self, number: u32) -> String {
        if self.two_digits { format!("G{number:02}") } else { format!("G{number}") }
    }
}
