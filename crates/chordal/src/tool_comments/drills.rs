//! Named sizes: number and letter drills (ASME B94.11M), number screws (ASME B1.1).

/// Number drills 1 to 80, ten-thousandths of an inch.
const NUMBERS: [u16; 80] = [
    2280, 2210, 2130, 2090, 2055, 2040, 2010, 1990, 1960, 1935, 1910, 1890, 1850, 1820, 1800, 1770,
    1730, 1695, 1660, 1610, 1590, 1570, 1540, 1520, 1495, 1470, 1440, 1405, 1360, 1285, 1200, 1160,
    1130, 1110, 1100, 1065, 1040, 1015, 995, 980, 960, 935, 890, 860, 820, 810, 785, 760, 730, 700,
    670, 635, 595, 550, 520, 465, 430, 420, 410, 400, 390, 380, 370, 360, 350, 330, 320, 310, 292,
    280, 260, 250, 240, 225, 210, 200, 180, 160, 145, 135,
];

/// Letter drills A to Z, thousandths of an inch.
const LETTERS: [u16; 26] = [
    234, 238, 242, 246, 250, 257, 261, 266, 272, 277, 281, 290, 295, 302, 316, 323, 332, 339, 348,
    358, 368, 377, 386, 397, 404, 413,
];

/// The diameter of a number drill, mm; `None` where there is no such number.
pub(super) fn number_drill(number: u32) -> Option<f64> {
    let size = NUMBERS.get(usize::try_from(number.checked_sub(1)?).ok()?)?;
    Some(f64::from(*size) * 254.0 / 100_000.0)
}

/// The diameter of a letter drill, mm; `None` for anything but one letter.
pub(super) fn letter_drill(letter: &str) -> Option<f64> {
    let [letter @ b'A'..=b'Z'] = letter.as_bytes() else { return None };
    Some(f64::from(LETTERS[usize::from(letter - b'A')]) * 254.0 / 10_000.0)
}

/// The major diameter of a number screw, #0 to #12, mm: 0.060 in + 0.013 in times the number.
pub(super) fn number_screw(number: u32) -> Option<f64> {
    (number <= 12).then(|| f64::from(60 + 13 * number) * 254.0 / 10_000.0)
}
