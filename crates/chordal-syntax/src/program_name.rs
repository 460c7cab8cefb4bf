//! Programs by name: `<PART_1>`.

/// Numbers from here on stand for names (`<PART_1>`): they are made from the name, and nobody writes them.
const FIRST_OF_NAMES: u32 = 1 << 31;

/// Most characters of a program's name (Fanuc 30i).
const MAX_NAME_LENGTH: usize = 32;

/// The program that `<NAME>` at the beginning of a text names, and the length of the words; `<O123>` is program 123.
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
    // FNV-1a: two names of one folder have the same number once in many millions.
    let hash = name.iter().fold(0x811c_9dc5_u32, |hash, byte| {
        (hash ^ u32::from(byte.to_ascii_uppercase())).wrapping_mul(0x0100_0193)
    });
    Some((number.unwrap_or(FIRST_OF_NAMES | hash >> 2), length + 2))
}

/// Whether a program's number stands for a name.
pub fn is_program_name(number: u32) -> bool {
    number >= FIRST_OF_NAMES
}
