//! How a control needs a program begun and ended, as data; the path of the tool is the same on all.

/// The lines around a program. In them `{…}` is what the thread milling program fills in.
#[derive(Debug)]
pub struct PostTemplate {
    /// What encloses a remark, such as `(` and `)`.
    pub remark: [&'static str; 2],
    /// Before the remarks: tape mark and program number.
    pub open: &'static [&'static str],
    /// From the tool change to the position above the start.
    pub begin: &'static [&'static str],
    /// From the clearance plane to the end of the program.
    pub end: &'static [&'static str],
    /// G codes are written with two digits: `G03`.
    pub two_digits: bool,
}

impl PostTemplate {
    /// No lines around the program.
    pub const EMPTY: PostTemplate =
        PostTemplate { remark: ["(", ")"], open: &[], begin: &[], end: &[], two_digits: false };

    /// A G code as programs of this control usually have it: `G03` or `G3`.
    pub fn code(&self, number: u32) -> String {
        if self.two_digits { format!("G{number:02}") } else { format!("G{number}") }
    }
}
