//! The requests of the page.

use serde::{Deserialize, Serialize};

/// A piece of the text that is replaced; places are UTF-16 code units of the text before.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TextChange {
    /// First code unit that is replaced.
    pub from: usize,
    /// First code unit after it.
    pub to: usize,
    /// The text that replaces it.
    pub insert: String,
}

/// What the program is compared with.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ComparedWith {
    /// It is not compared.
    #[default]
    Nothing,
    /// What the command line names.
    Named,
    /// The same text on another machine; without a name on the one that the command line, the folder or the
    /// text says.
    Machine(Option<String>),
}

/// Which chords replace the arcs.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
pub struct ChordRequest {
    /// Largest distance of a chord from its curve, mm; above 0.
    pub tolerance_mm: f64,
    /// Corners on both sides of the curve.
    #[serde(default)]
    pub balanced: bool,
    /// The chords that the control itself cuts, if it does; the tolerance is then not used.
    #[serde(default)]
    pub as_control: bool,
}

/// A request with its number.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct PageRequest {
    /// The answer has the same number.
    #[serde(default)]
    pub id: u64,
    /// What is requested.
    #[serde(flatten)]
    pub kind: RequestKind,
}

/// The kinds of requests.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(tag = "request", rename_all = "snake_case")]
pub enum RequestKind {
    /// The text has changed, and runs again.
    Edit {
        /// In order, none over another.
        changes: Vec<TextChange>,
    },
    /// Another machine; `None` is the one that the command line, the folder or the text says.
    Machine {
        /// As `chordal machines` lists it, and the units at power-on where they are chosen, too: `haas-vf2 in inch`.
        name: Option<String>,
        /// It answers the question of the reading: it is not compared with the machine before.
        #[serde(default)]
        is_answer: bool,
    },
    /// What the program is compared with.
    CompareWith {
        /// Nothing, what the command line names, or the same text on another machine.
        other: ComparedWith,
    },
    /// Paths within this distance are the same.
    Tolerance {
        /// Zero or more, mm.
        tolerance_mm: f64,
    },
    /// How finely the stock is cut.
    Stock {
        /// About this number of columns; it is limited to what a page can draw.
        columns: u32,
    },
    /// Lines of the other program, to be read.
    OtherText {
        /// 0 is the program itself, others are those of its subprograms.
        #[serde(default)]
        file: u32,
        /// From 1.
        line: u32,
    },
    /// The chords that replace arcs.
    Chords(ChordRequest),
    /// What is active once so many pieces of path are done and a line is reached.
    State {
        /// Pieces of path that are done.
        done: u32,
        /// Line of the program, from 1.
        line: u32,
    },
    /// The words of some lines, for colours.
    Tokens {
        /// The first line, from 1.
        from: u32,
        /// The line after the last.
        to: u32,
    },
    /// What a word means.
    Hover {
        /// Its line, from 1.
        line: u32,
        /// A column in it, from 0, in UTF-16 code units.
        column: u32,
    },
    /// Where the name at a position is defined.
    Definition {
        /// Its line, from 1.
        line: u32,
        /// A column in it, from 0, in UTF-16 code units.
        column: u32,
    },
    /// Programs, tools and operations.
    Outline,
    /// The text goes to its file.
    Save {
        /// Even if the file has changed since it was read.
        #[serde(default)]
        force: bool,
    },
    /// The file is read again; what was typed is gone.
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
