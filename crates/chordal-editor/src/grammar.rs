//! The grammar for editors that colour by regular expressions, from the tables of all controls.
//! Where the language server runs, its own reading takes over.

use std::collections::BTreeSet;

use chordal::control::CONTROLS;
use chordal::control::table::{CodeRow, ControlTable};
use serde_json::{Value, json};

/// A TextMate grammar of the codes that some control has.
pub fn grammar() -> Value {
    let rule = |name: &str, pattern: String| json!({ "name": name, "match": pattern });
    let g_codes = codes_pattern('G', |table| table.g_codes);
    let m_codes = codes_pattern('M', |table| table.m_codes);
    json!({
        "name": "NC program",
        "scopeName": "source.nc",
        "fileTypes": ["nc", "ngc", "tap", "eia"],
        "patterns": [
            rule("punctuation.definition.tape.nc", r"^\s*%.*$".into()),
            rule("comment.block.nc", r"\([^)\n]*\)?".into()),
            rule("comment.line.nc", r"(;|^\s*\*).*$".into()),
            rule("entity.name.function.nc", r"(?i)^\s*(?:N\d+\s*)?[O:]\s*(?:\d+|<[^>]*>)".into()),
            rule("entity.name.label.nc", r"(?i)(?<![A-Z#])N\s*\d+".into()),
            rule("keyword.control.nc", format!(r"(?i)(?<![A-Z])(?:{WORDS})(?![A-Z])")),
            rule("variable.other.nc", r"(?i)#<[^>]*>|#\d+|(?<=[+\-])R\d|^\s*R\d".into()),
            rule("keyword.other.g-code.nc", g_codes),
            rule("support.function.m-code.nc", m_codes),
            rule("support.type.axis.nc", word_pattern("XYZABCUVW")),
            rule("constant.numeric.feed.nc", word_pattern("FS")),
            rule("entity.name.type.tool.nc", word_pattern("TDH")),
            rule("variable.parameter.nc", word_pattern("EIJKLPQR")),
        ],
    })
}

/// Words of the macro languages.
const WORDS: &str = "IF|THEN|ELSEIF|ELSE|ENDIF|GOTO|WHILE|DO|END|ENDWHILE|REPEAT|ENDREPEAT|SUB|ENDSUB|\
    CALL|RETURN|BREAK|CONTINUE|DPRNT|BPRNT|POPEN|PCLOS|PRINT|INPUT|CLEAR|START|EQ|NE|GT|LT|GE|LE|\
    AND|OR|XOR|MOD|SIN|COS|TAN|ASIN|ACOS|ATAN|SQRT|ABS|ROUND|FIX|FUP|LN|EXP|BIN|BCD";

/// A letter with a number, a variable or an expression after it.
fn word_pattern(letters: &str) -> String {
    format!(r"(?i)(?<![A-Z#])[{letters}](?=\s*[-+.\d#\[])\s*[-+]?[\d.]*")
}

/// The codes of a letter that any control has, each with leading zeros.
fn codes_pattern(letter: char, of: fn(&ControlTable) -> &'static [CodeRow]) -> String {
    let all: BTreeSet<u16> =
        CONTROLS.iter().flat_map(|table| of(table)).map(|row| row.code).collect();
    // A longer code stands before one that begins it.
    let mut codes: Vec<String> = all
        .into_iter()
        .map(|code| match (code / 10, code % 10) {
            (whole, 0) => whole.to_string(),
            (whole, tenth) => format!(r"{whole}\.{tenth}"),
        })
        .collect();
    codes.sort_by_key(|code| std::cmp::Reverse(code.len()));
    format!(r"(?i)(?<![A-Z#]){letter}\s*0*(?:{})(?![\d.])", codes.join("|"))
}
