//! Block numbers that begin with a colon.

/// True for `:0030 T01 M06`: a colon, a number and words after it. The colon replaces N in a block at which a program
/// may be restarted (ISO 6983-1, alignment function). If the number is a program number, only a comment follows it.
pub(crate) fn is_alignment_number(text: &[u8]) -> bool {
    let digits = text[1..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let rest = text[1 + digits..].iter().find(|byte| !matches!(byte, b' ' | b'\t'));
    digits > 0 && rest.is_some_and(u8::is_ascii_alphabetic)
}
