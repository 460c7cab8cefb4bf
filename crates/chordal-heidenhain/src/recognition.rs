//! How lines of the language begin. The signs by which programs are recognized are searched with those of all other
//! languages, in one pass over the text.

/// Lines that are looked at.
const MAX_SEARCHED_LINES: usize = 2000;

/// Whether some line begins a program, calls a tool, or defines a cycle or a blank.
pub fn begins_like_klartext(text: &[u8]) -> bool {
    const BEGINNINGS: [&[u8]; 4] = [b"BEGIN PGM", b"TOOL CALL", b"CYCL DEF", b"BLK FORM"];
    text.split(|byte| *byte == b'\n').take(MAX_SEARCHED_LINES).any(|line| {
        let line = line.trim_ascii_start();
        let digits = line.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let line = line[digits..].trim_ascii_start();
        BEGINNINGS.iter().any(|beginning| {
            line.get(..beginning.len()).is_some_and(|start| start.eq_ignore_ascii_case(beginning))
        })
    })
}
