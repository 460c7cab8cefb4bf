//! The requests of the page.

use serde::{Deserialize, Serialize};

/// A replaced part of the text; offsets are UTF-16 code units in the text before all changes.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TextChange {
    /// The first replaced code unit.
    pub from: usize,
    /// The first code unit after the replaced part.
    pub to: usize,
    /// The text that replaces it.
    pub insert: String,
}

/// The other program of a comparison.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ComparedWith {
    /// No comparison.
    #[default]
    Nothing,
    /// The program that the command line names.
    Named,
    /// The same text on another machine; `None` is the one from the command line, the folder or the text.
    Machine(Option<String>),
}

/// How arcs are replaced by chords.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
pub struct ChordRequest {
    /// The largest distance between a chord and its curve, mm; above 0.
    pub tolerance_mm: f64,
    /// Chords deviate to both sides of the curve; otherwise their ends are on the curve.
    #[serde(default)]
    pub balanced: bool,
    /// Uses the chords that the control itself computes, if it does so; the tolerance is then ignored.
    #[serde(default)]
    pub as_control: bool,
}

/// A request with its number.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct PageRequest {
    /// The answer carries the same number.
    #[serde(default)]
    pub id: u64,
    /// The request itself.
    #[serde(flatten)]
    pub kind: RequestKind,
}

/// The kinds of requests.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(tag = "request", rename_all = "snake_case")]
pub enum RequestKind {
    /// The text has changed and is run again.
    Edit {
        /// In order, without overlaps.
        changes: Vec<TextChange>,
    },
    /// Run on another machine.
    Machine {
        /// The name as in `chordal machines`, optionally with units at power-on: `haas-vf2 in inch`. `None` is the
        /// machine from the command line, the folder or the text.
        name: Option<String>,
        /// The machine answers the question about the reading, so the run is not compared with the previous machine.
        #[serde(default)]
        is_answer: bool,
    },
    /// Compare with another program.
    CompareWith {
        /// The other program.
        other: ComparedWith,
    },
    /// The distance within which paths are equal.
    Tolerance {
        /// Zero or more, mm.
        tolerance_mm: f64,
    },
    /// The resolution of the stock.
    Stock {
        /// The approximate number of columns; limited to what a page can draw.
        columns: u32,
    },
    /// Lines of the other program.
    OtherText {
        /// 0 is the program itself; other numbers are its subprograms.
        #[serde(default)]
        file: u32,
        /// The line, from 1.
        line: u32,
    },
    /// The chords that replace the arcs.
    Chords(ChordRequest),
    /// The modal state at a position: after a number of path segments and at a line.
    State {
        /// The number of path segments that are done.
        done: u32,
        /// The line of the program, from 1.
        line: u32,
    },
    /// The classes of the words in some lines, for syntax colouring.
    Tokens {
        /// The first line, from 1.
        from: u32,
        /// The line after the last.
        to: u32,
    },
    /// The meaning of a word.
    Hover {
        /// Its line, from 1.
        line: u32,
        /// A column in it, from 0, in UTF-16 code units.
        column: u32,
    },
    /// The definition of the name at a position.
    Definition {
        /// Its line, from 1.
        line: u32,
        /// A column in it, from 0, in UTF-16 code units.
        column: u32,
    },
    /// The outline of programs, tools and operations.
    Outline,
    /// Save the text to its file.
    Save {
        /// Overwrite the file even if it has changed since it was read.
        #[serde(default)]
        force: bool,
    },
    /// Read the file again and discard unsaved changes.
    Reload,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn requests_are_objects_with_a_verb() {
        let read = |text| serde_json::from_str::<PageRequest>(text);
        let edit = read(r#"{"id":3,"request":"edit","changes":[{"from":1,"to":2,"insert":"x"}]}"#)
            .unwrap();
        let change = TextChange { from: 1, to: 2, insert: "x".into() };
        assert_eq!(edit, PageRequest { id: 3, kind: RequestKind::Edit { changes: vec![change] } });
        assert_eq!(read(r#"{"request":"reload"}"#).unwrap().kind, RequestKind::Reload);
        let machine =
            read(r#"{"request":"compare_with","other":{"machine":"haas-vf2"}}"#).unwrap().kind;
        let other = ComparedWith::Machine(Some("haas-vf2".into()));
        assert_eq!(machine, RequestKind::CompareWith { other });
        let named = read(r#"{"request":"compare_with","other":"named"}"#).unwrap().kind;
        assert_eq!(named, RequestKind::CompareWith { other: ComparedWith::Named });
        for wrong in [
            "",
            "[]",
            "{}",
            r#"{"request":"format"}"#,
            r#"{"request":"edit"}"#,
            r#"{"request":"edit","changes":[{"from":-1,"to":0,"insert":""}]}"#,
            r#"{"request":"state","done":1e99,"line":1}"#,
            r#"{"id":"x","request":"reload"}"#,
            r#"{"request":"compare_with","other":"/etc/passwd"}"#,
            r#"{"request":"compare_with","other":{"file":"other.nc"}}"#,
            r#"{"request":"tolerance","tolerance_mm":"0.1"}"#,
        ] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }
}
