//! What the page asks.

use serde::{Deserialize, Serialize};

/// A piece of the text that is replaced; places are UTF-16 code units of the text before.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Change {
    /// Where it begins.
    pub from: usize,
    /// Where it ends.
    pub to: usize,
    /// What stands there instead.
    pub insert: String,
}

/// What the program is compared with.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Other {
    /// Nothing.
    #[default]
    Nothing,
    /// What the command line names.
    Named,
    /// The same text on another machine; without a name on the one that the command line, the folder or the
    /// text says.
    Machine(Option<String>),
}

/// Which chords are to stand for arcs.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
pub struct AskedChords {
    /// mm.
    pub tolerance_mm: f64,
    /// Corners on both sides of the curve.
    #[serde(default)]
    pub balanced: bool,
    /// Those that the control itself cuts, where it does; whatever the tolerance.
    #[serde(default)]
    pub as_control: bool,
}

/// A request and the number that its answer bears.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Request {
    /// Given back with the answer.
    #[serde(default)]
    pub id: u64,
    /// What is asked.
    #[serde(flatten)]
    pub ask: Ask,
}

/// What the page may ask.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(tag = "ask", rename_all = "snake_case")]
pub enum Ask {
    /// The text has changed: it is run anew.
    Edit {
        /// In order, none over another.
        changes: Vec<Change>,
    },
    /// Another machine; `None` is the one that the command line, the folder or the text says.
    Machine {
        /// As `chordal machines` lists it, and the units at power-on where they are chosen, too: `haas-vf2 in inch`.
        name: Option<String>,
        /// It answers as what the program is read, and is not compared with the machine before.
        #[serde(default)]
        is_answer: bool,
    },
    /// What the program is compared with.
    Against {
        /// Nothing, what the command line names, or the same text on another machine.
        other: Other,
    },
    /// What the two paths may be apart.
    Tolerance {
        /// mm.
        tolerance_mm: f64,
    },
    /// How finely the stock is cut.
    Stock {
        /// About so many columns.
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
    /// The chords that stand for arcs.
    Chords(AskedChords),
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
    /// Where the name at a place is made.
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
        /// Even if the file has changed meanwhile.
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
        let read = |text| serde_json::from_str::<Request>(text);
        let edit =
            read(r#"{"id":3,"ask":"edit","changes":[{"from":1,"to":2,"insert":"x"}]}"#).unwrap();
        let change = Change { from: 1, to: 2, insert: "x".into() };
        assert_eq!(edit, Request { id: 3, ask: Ask::Edit { changes: vec![change] } });
        assert_eq!(read(r#"{"ask":"reload"}"#).unwrap().ask, Ask::Reload);
        let machine = read(r#"{"ask":"against","other":{"machine":"haas-vf2"}}"#).unwrap().ask;
        let other = Other::Machine(Some("haas-vf2".into()));
        assert_eq!(machine, Ask::Against { other });
        let named = read(r#"{"ask":"against","other":"named"}"#).unwrap().ask;
        assert_eq!(named, Ask::Against { other: Other::Named });
        for wrong in [
            "",
            "[]",
            "{}",
            r#"{"ask":"format"}"#,
            r#"{"ask":"edit"}"#,
            r#"{"ask":"edit","changes":[{"from":-1,"to":0,"insert":""}]}"#,
            r#"{"ask":"state","done":1e99,"line":1}"#,
            r#"{"id":"x","ask":"reload"}"#,
            r#"{"ask":"against","other":"/etc/passwd"}"#,
            r#"{"ask":"against","other":{"file":"other.nc"}}"#,
            r#"{"ask":"tolerance","tolerance_mm":"0.1"}"#,
        ] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }
}
