//! Named programs: `<PART_1>`.

/// Program numbers from this one represent names (`<PART_1>`): they are computed from the name, and too large to be
/// written.
const FIRST_OF_NAMES: u32 = 1 << 31;

/// The largest number of characters in a program name (Fanuc 30i).
const MAX_NAME_LENGTH: usize = 32;

/// The number of the program that `<NAME>` at the start of a text names, and the length of that text in bytes; `<O123>`
/// is program 123. `None` without a name.
pub fn scan_program_name(text: &[u8]) -> Option<(u32, usize)> {
    let name = text.strip_prefix(b"<")?;
    let length = name.iter().take(MAX_NAME_LENGTH + 1).position(|byte| *byte == b'>')?;
    let name = &name[..length];
    let fits = |byte: &u8| byte.is_ascii_alphanumeric() || b" _+-.".contains(byte);
    if name.is_empty() || !name.iter().all(fits) {
        return None;
    }
    let digits =
        name[0].eq_ignore_ascii_case(&b'O').then(|| std::str::from_utf8(&name[1..]).ok()).flatten();
    let number =
        digits.and_then(|digits| digits.parse().ok()).filter(|number| *number < FIRST_OF_NAMES);
    // FNV-1a: the probability that two names have the same number is negligible.
    let hash = name.iter().fold(0x811c_9dc5_u32, |hash, byte| {
        (hash ^ u32::from(byte.to_ascii_uppercase())).wrapping_mul(0x0100_0193)
    });
    Some((number.unwrap_or(FIRST_OF_NAMES | hash >> 2), length + 2))
}

/// Whether a program number represents a name.
pub fn is_program_name(number: u32) -> bool {
    number >= FIRST_OF_NAMES
}
