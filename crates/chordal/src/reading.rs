//! On what a program is read.

use chordal_gcode::Recognition;

/// On what a program is read, and why.
#[derive(Clone, Copy, Debug)]
pub struct Reading<'a> {
    /// The machine; nothing where the text is not read.
    pub machine: Option<&'a str>,
    /// The control, or the language that is not read: `fanuc`, `fanuc-lathe`.
    pub control: &'a str,
    /// Who says so: `given`, `folder`, `extension`, `text`.
    pub from: &'a str,
    /// What the text says.
    pub recognition: Option<&'a Recognition>,
}
