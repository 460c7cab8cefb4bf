//! Flow control by O words: `o100 sub`, `o<name> call [1]`, `o[#1] while [#2 LT 3]`.

use chordal_diagnostics::{Code, TextRange};

use crate::expression::{Expression, ExpressionParser};

/// The label of a subroutine or a control structure.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum OLabel {
    /// The text of a number or a name, without the brackets.
    Text(TextRange),
    /// A number that is computed.
    Computed(Expression),
}

/// The word after the label.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "the names are the words themselves")]
pub enum FlowWord {
    Sub,
    EndSub,
    Return,
    Call,
    If,
    ElseIf,
    Else,
    EndIf,
    While,
    EndWhile,
    Do,
    Repeat,
    EndRepeat,
    Break,
    Continue,
}

/// The words; a longer one comes before one that is its beginning.
const WORDS: [(&str, FlowWord); 15] = [
    ("ENDSUB", FlowWord::EndSub),
    ("ENDIF", FlowWord::EndIf),
    ("ENDWHILE", FlowWord::EndWhile),
    ("ENDREPEAT", FlowWord::EndRepeat),
    ("SUB", FlowWord::Sub),
    ("RETURN", FlowWord::Return),
    ("CALL", FlowWord::Call),
    ("IF", FlowWord::If),
    ("ELSEIF", FlowWord::ElseIf),
    ("ELSE", FlowWord::Else),
    ("WHILE", FlowWord::While),
    ("DO", FlowWord::Do),
    ("REPEAT", FlowWord::Repeat),
    ("BREAK", FlowWord::Break),
    ("CONTINUE", FlowWord::Continue),
];

/// The start of a flow control line. Its values are not read yet.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct OWord {
    /// The label.
    pub label: OLabel,
    /// The word; `None` for an unknown word, which was reported.
    pub word: Option<FlowWord>,
    /// The text of label and word.
    pub range: TextRange,
}

/// Reads the label and the word of a line that begins with O. Problems are stored in the parser.
pub fn parse_o_word(parser: &mut ExpressionParser<'_>) -> OWord {
    parser.next_mark();
    let start = parser.position();
    parser.take_text("O");
    let label = label(parser);
    parser.next_mark();
    let word_at = parser.position();
    let word = WORDS.iter().find(|(text, _)| parser.take_spread(text)).map(|(_, word)| *word);
    if word.is_none() {
        parser.at = parser.end;
        let range = TextRange::new(word_at, parser.position());
        parser.problem(Code::BadStatement, range, |d| {
            d.label("not a flow control word").help(
                "after an O word comes sub, endsub, call, return, if, elseif, else, endif, \
                 while, endwhile, do, repeat, endrepeat, break or continue",
            )
        });
    }
    OWord { label, word, range: TextRange::new(start, parser.position()) }
}

fn label(parser: &mut ExpressionParser<'_>) -> OLabel {
    let mark = parser.next_mark();
    if matches!(mark, b'[' | b'#') {
        return OLabel::Computed(parser.value());
    }
    let rest = &parser.text[parser.at..parser.end];
    if mark != b'<' {
        let length = rest.iter().take_while(|b| !b.is_ascii_alphabetic()).count();
        let start = parser.position();
        parser.at += length;
        return OLabel::Text(TextRange::new(start, parser.position()));
    }
    let start = parser.at as u32 + 1;
    match rest.iter().position(|b| *b == b'>') {
        Some(length) => {
            parser.at += length + 1;
            OLabel::Text(TextRange::new(start, parser.position() - 1))
        }
        None => {
            parser.at = parser.end;
            let range = TextRange::new(start - 1, start);
            parser.problem(Code::BadStatement, range, |d| {
                d.label("this name is not closed").help("close it with `>`")
            });
            OLabel::Text(TextRange::new(start, parser.position()))
        }
    }
}

#[cfg(test)]
mod tests {
    use chordal_diagnostics::FileId;

    use super::*;
    use crate::MacroGrammar;

    /// Names, and operators in brackets only: the grammar of a control with O words.
    static GRAMMAR: MacroGrammar =
        MacroGrammar { names: true, operators_in_brackets_only: true, ..MacroGrammar::MACRO_B };

    fn parse(text: &str) -> (String, Option<FlowWord>, usize) {
        let mut parser = ExpressionParser::new(text.as_bytes(), FileId(0), &GRAMMAR);
        parser.start(text.as_bytes(), FileId(0), TextRange::new(0, text.len() as u32));
        let line = parse_o_word(&mut parser);
        let label = match line.label {
            OLabel::Text(range) => String::from_utf8_lossy(range.slice(text.as_bytes())).into(),
            OLabel::Computed(expression) => {
                format!("{} steps", parser.steps(expression).len())
            }
        };
        (label, line.word, parser.problems.len())
    }

    #[test]
    fn labels_and_words() {
        assert_eq!(parse("o100 sub"), ("100 ".into(), Some(FlowWord::Sub), 0));
        assert_eq!(parse("O<Drill> CALL [1]"), ("Drill".into(), Some(FlowWord::Call), 0));
        assert_eq!(parse("o[#1+1] call"), ("4 steps".into(), Some(FlowWord::Call), 0));
        assert_eq!(parse("o1 elseif [1]").1, Some(FlowWord::ElseIf));
        assert_eq!(parse("o1 endwhile").1, Some(FlowWord::EndWhile));
        assert_eq!(parse("o 1 0 0 end s u b").1, Some(FlowWord::EndSub));
        assert_eq!(parse("o#5 call"), ("2 steps".into(), Some(FlowWord::Call), 0));
    }

    #[test]
    fn what_is_no_word_is_told() {
        assert_eq!(parse("o1 perhaps"), ("1 ".into(), None, 1));
        assert_eq!(parse("o<x sub").2, 2);
    }
}
