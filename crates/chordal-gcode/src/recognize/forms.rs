//! Forms of a line that are not patterns of words.

use chordal_dialect::recognition::TextForm;

use super::line::SampleLine;

/// The words of flow control after an O number.
const FLOW: &[&[u8]] = &[
    b"SUB",
    b"ENDSUB",
    b"IF",
    b"ELSE",
    b"ELSEIF",
    b"ENDIF",
    b"WHILE",
    b"ENDWHILE",
    b"DO",
    b"REPEAT",
    b"ENDREPEAT",
    b"CALL",
    b"RETURN",
    b"BREAK",
    b"CONTINUE",
];

/// True when the line has this form; false for forms of the whole text.
pub fn shows(form: TextForm, text: &[u8], line: &SampleLine) -> bool {
    let code = text[..line.code_end].trim_ascii();
    match form {
        TextForm::Register => !line.macros && register(code),
        TextForm::OpenComments => line.open,
        TextForm::SemicolonComments => line.semicolon,
        TextForm::OWord => o_word(code),
        TextForm::NamedParameter => line.macros && memchr::memmem::find(code, b"#<").is_some(),
        TextForm::HashLine => {
            matches!(after_n(code), [b'#', second, ..] if second.is_ascii_alphabetic() || *second == b':')
        }
        TextForm::SubroutineHead => subroutine_head(line),
        TextForm::MacroStatement => line.macros && numbered_variable(code),
        TextForm::DollarLine => {
            matches!(code, [b'$', second, ..] if second.is_ascii_uppercase() || second.is_ascii_digit())
        }
        TextForm::ParameterIsSet => parameter(code, b'R', b"="),
        TextForm::EqualsAddress => line.odd && equals_address(code),
        TextForm::LParameter => line.odd && parameter(code, b'L', b"=<>"),
        TextForm::HParameter => line.odd && parameter(code, b'H', b"="),
        TextForm::StatementInParentheses => {
            line.comments.iter().any(|(from, to)| is_statement(&text[*from..*to]))
        }
        TextForm::CommaCoordinates => comma_coordinates(text),
        // Forms of the whole text.
        TextForm::BareText
        | TextForm::MixedNumbers
        | TextForm::TrailingPoints
        | TextForm::SmallControl
        | TextForm::LengthWithoutTape => false,
    }
}

/// True when the text begins with the piece, in upper or lower case; `?` is a digit. With `whole`, nothing may follow.
pub fn begins(text: &[u8], piece: &str, whole: bool) -> bool {
    let same = |(byte, pattern): (&u8, u8)| match pattern {
        b'?' => byte.is_ascii_digit(),
        letter => byte.to_ascii_uppercase() == letter,
    };
    let fits = if whole { text.len() == piece.len() } else { text.len() >= piece.len() };
    fits && text.iter().zip(piece.bytes()).all(same)
}

/// `R0+1.5`, `R1-.2`: R, a digit, a sign.
fn register(code: &[u8]) -> bool {
    code.windows(3).any(|part| {
        part[0].eq_ignore_ascii_case(&b'R')
            && part[1].is_ascii_digit()
            && matches!(part[2], b'+' | b'-')
    })
}

/// `o100 sub`, `N5 o<bolt> call [1]`.
fn o_word(code: &[u8]) -> bool {
    let [b'O' | b'o', rest @ ..] = after_n(code) else { return false };
    let rest = rest.trim_ascii_start();
    if rest.first() == Some(&b'<') {
        return true;
    }
    let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let rest = rest[digits..].trim_ascii_start();
    let letters = rest.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
    digits > 0 && FLOW.iter().any(|word| rest[..letters].eq_ignore_ascii_case(word))
}

/// The code after the N number of a block.
fn after_n(code: &[u8]) -> &[u8] {
    let [b'N' | b'n', rest @ ..] = code else { return code };
    let digits = rest.iter().take_while(|byte| byte.is_ascii_digit() || **byte == b'.').count();
    rest[digits..].trim_ascii_start()
}

/// `L100` alone: a multiple of 100.
fn subroutine_head(line: &SampleLine) -> bool {
    let mut words = line.words.iter().filter(|word| word.letter != b'N');
    match (words.next(), words.next()) {
        (Some(word), None) if word.letter == b'L' && !line.odd && word.decimals.is_none() => {
            word.value >= 100.0 && word.value < 9100.0 && word.value % 100.0 == 0.0
        }
        _ => false,
    }
}

/// `#100=1`, `IF[#1 EQ 2]`, `X#24`, not `#<name>` and not `#V1`.
fn numbered_variable(code: &[u8]) -> bool {
    memchr::memchr_iter(b'#', code).any(|at| {
        let next = code[at + 1..].iter().find(|byte| **byte != b' ');
        next.is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'[' | b'#'))
    })
}

/// `R1=5`, `L0 < 5`: the letter and a number before one of these marks, not inside another word.
fn parameter(code: &[u8], letter: u8, marks: &[u8]) -> bool {
    code.iter().enumerate().filter(|(_, byte)| marks.contains(byte)).any(|(at, _)| {
        let before = code[..at].trim_ascii_end();
        let digits = before.iter().rev().take_while(|byte| byte.is_ascii_digit()).count();
        let starts = |before: &[u8]| {
            before.last().is_none_or(|byte| !byte.is_ascii_alphabetic() && !b"#<_".contains(byte))
        };
        match before[..before.len() - digits].split_last() {
            Some((last, rest)) => digits > 0 && last.eq_ignore_ascii_case(&letter) && starts(rest),
            None => false,
        }
    })
}

/// `P1=2`, `IF P1 EQ 2 GOTO N10`, `GOTO N10`, `CALL 5`, which some controls write in parentheses.
fn is_statement(comment: &[u8]) -> bool {
    let comment = comment.trim_ascii();
    let after = |word: &str| begins(comment, word, false);
    after("IF P?") || after("GOTO N?") || after("CALL ?") || {
        let digits = comment.iter().skip(1).take_while(|byte| byte.is_ascii_digit()).count();
        let value = comment.get(1 + digits..).unwrap_or_default().trim_ascii_start();
        after("P?") && matches!(value, [b'=', ..])
    }
}

/// `Z100,200,-50;`: Z, three whole numbers with commas between, a semicolon.
fn comma_coordinates(text: &[u8]) -> bool {
    let [b'Z', numbers @ .., b';'] = text.trim_ascii() else { return false };
    let whole = |number: &[u8]| {
        let digits = number.strip_prefix(b"-").unwrap_or(number);
        !digits.is_empty() && digits.iter().all(u8::is_ascii_digit)
    };
    let mut numbers = numbers.split(|byte| *byte == b',');
    numbers.by_ref().take(3).filter(|number| whole(number)).count() == 3 && numbers.next().is_none()
}

/// `X=5`, `F=R1`: a letter alone, an equals sign, a value.
fn equals_address(code: &[u8]) -> bool {
    memchr::memchr_iter(b'=', code).any(|at| {
        let before = code[..at].trim_ascii_end();
        let single = match before {
            [.., before, letter] => {
                letter.is_ascii_alphabetic()
                    && !before.is_ascii_alphanumeric()
                    && *before != b'#'
                    && *before != b'_'
            }
            [letter] => letter.is_ascii_alphabetic(),
            [] => false,
        };
        single && code.get(at + 1).is_some_and(|byte| *byte != b'=')
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn has(form: TextForm, text: &str) -> bool {
        let mut line = SampleLine::default();
        line.read(text.as_bytes());
        shows(form, text.as_bytes(), &line)
    }

    #[test]
    fn beginnings() {
        assert!(begins(b"%00227", "%?????", true) && begins(b"jz,5.0", "JZ,", false));
        assert!(!begins(b"%0022", "%?????", false) && !begins(b"%002277", "%?????", true));
    }

    #[test]
    fn forms() {
        for text in ["o100 sub", "N5 O<bolt> call [1]", "o7 endwhile"] {
            assert!(has(TextForm::OWord, text), "{text}");
        }
        assert!(!has(TextForm::OWord, "O1000 (SUB)") && !has(TextForm::OWord, "O100"));
        assert!(has(TextForm::MacroStatement, "IF[#100 EQ 1]GOTO 9"));
        assert!(!has(TextForm::MacroStatement, "#<depth>=1"));
        assert!(has(TextForm::Register, "R0+1.5 R1-.2") && !has(TextForm::Register, "X1. R2."));
        assert!(
            has(TextForm::SubroutineHead, "N3 L100") && !has(TextForm::SubroutineHead, "L9401")
        );
        assert!(
            has(TextForm::ParameterIsSet, "N10 R1=R2+5") && !has(TextForm::ParameterIsSet, "CR=5")
        );
        assert!(has(TextForm::EqualsAddress, "G1 X=R1") && !has(TextForm::EqualsAddress, "#1=5"));
        assert!(
            has(TextForm::LParameter, "G79 L0<5 N10") && has(TextForm::LParameter, "N5 L0 = 1")
        );
        assert!(!has(TextForm::LParameter, "#<L1>=2") && !has(TextForm::LParameter, "VAL1=2"));
        assert!(
            has(TextForm::HParameter, "H175 = 0.1600") && !has(TextForm::HParameter, "IF[H1EQ2]")
        );
        for text in ["(P1=2)", "N10 (IF P1 EQ 2 GOTO N10)", "(GOTO N50)"] {
            assert!(has(TextForm::StatementInParentheses, text), "{text}");
        }
        assert!(!has(TextForm::StatementInParentheses, "(PART 1)"));
        assert!(!has(TextForm::StatementInParentheses, "(IF PROBE FAILS)"));
        assert!(has(TextForm::CommaCoordinates, "Z100,200,-50;"));
        assert!(
            !has(TextForm::CommaCoordinates, "Z10;") && !has(TextForm::CommaCoordinates, "Z1,2,3")
        );
        assert!(has(TextForm::DollarLine, "$H") && has(TextForm::HashLine, "N5 #V1=5"));
    }
}
