//! How each control wants a program begun and ended. Data: the way of the tool is the same.

use chordal_machine::ControlName;

/// The frame of a program. In the lines `{…}` stands for what `mill` fills in.
pub(crate) struct Post {
    /// A machine of this control that comes with Chordal.
    pub machine: &'static str,
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

const HAAS: Post = Post {
    machine: "haas-vf2",
    remark: ["(", ")"],
    open: &["%", "O{number} ({title})"],
    begin: &[
        "T{tool} M06",
        "G00 G90 G17 {units} G40 G49 G80",
        "G54 {start} {spindle} M03",
        "G43 H{offset} {clear} M08",
    ],
    end: &["G00 {clear} M09", "G53 G49 Z0. M05", "M30", "%"],
    two_digits: true,
};

const FANUC: Post = Post {
    machine: "fanuc-30i",
    remark: ["(", ")"],
    open: &["%", "O{number} ({title})"],
    begin: &[
        "{units} G17 G90 G40 G49 G80",
        "T{tool} M06",
        "G54 G00 {start} {spindle} M03",
        "G43 H{offset} {clear} M08",
    ],
    end: &["G00 {clear} M09", "M05", "G91 G28 Z0.", "G90 G49", "M30", "%"],
    two_digits: true,
};

const MITSUBISHI: Post = Post { machine: "mitsubishi-m700", ..FANUC };

const FADAL: Post = Post {
    machine: "fadal-4020",
    remark: ["(", ")"],
    open: &["O{number} ({title})"],
    begin: &[
        "M6 T{tool}",
        "G90 G17 {units} G40",
        "G0 {spindle} M3 E1 {start}",
        "H{tool} {wear}{clear} M8",
    ],
    end: &["G0 {clear}", "M5 M9", "G90 G0 H0 Z0", "M2"],
    two_digits: false,
};

const LINUXCNC: Post = Post {
    machine: "linuxcnc-mill",
    // By these the program is known as LinuxCNC's.
    remark: ["; ", ""],
    open: &["%", "; {title}"],
    begin: &[
        "{units} G17 G90 G94 G40 G49 G80 G64 {blend}",
        "T{tool} M6",
        "G54 G0 {start} {spindle} M3",
        "G43 H{tool} {clear} M8",
    ],
    end: &["G0 {clear} M9", "M5", "G49", "M2", "%"],
    two_digits: false,
};

impl Post {
    /// The frame of a control.
    pub fn of(control: ControlName) -> &'static Post {
        match control {
            ControlName::Fadal => &FADAL,
            ControlName::Haas => &HAAS,
            ControlName::Fanuc => &FANUC,
            ControlName::Mitsubishi => &MITSUBISHI,
            ControlName::Linuxcnc => &LINUXCNC,
        }
    }

    /// A G code as this control's people write it.
    pub fn code(&self, number: u32) -> String {
        if self.two_digits { format!("G{number:02}") } else { format!("G{number}") }
    }
}

/// Puts the fillings into a line.
pub(crate) fn fill(line: &str, fillings: &[(&str, String)]) -> String {
    let mut text = line.to_string();
    for (name, value) in fillings {
        text = text.replace(&format!("{{{name}}}"), value);
    }
    text
}
