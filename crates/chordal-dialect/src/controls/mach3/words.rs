//! What Mach3 requires of the words of a code, and forms of its codes that are not simulated.

use crate::vocabulary::*;

pub(super) const WORD_RULES: &[WordRule] = &[
    lost((b'G', 100), WordTest::Absent("R"), "with R is not followed"),
    lost((b'G', 120), WordTest::Absent("XYZABC"), NOT_BY_AXES),
    lost((b'G', 130), WordTest::Absent("XYZABC"), NOT_BY_AXES),
    lost((b'G', 410), WordTest::Absent("P"), SIZE_BY_P),
    lost((b'G', 420), WordTest::Absent("P"), SIZE_BY_P),
    lost((b'G', 430), WordTest::OneOf("H"), WITHOUT_H),
    lost((b'G', 440), WordTest::OneOf("H"), WITHOUT_H),
    lost(
        (b'G', 510),
        WordTest::Absent("ABC"),
        "of a rotary axis is not followed: X, Y and Z are",
    ),
    lost(
        (b'G', 680),
        WordTest::Absent("XYZCI"),
        "with X, Y or I is not followed: A and B are its centre, R the angle",
    ),
    lost((b'G', 680), WordTest::Written(b'A'), CENTER),
    lost((b'G', 680), WordTest::Written(b'B'), CENTER),
    lost((b'G', 680), WordTest::Written(b'R'), "without R, its angle, is not followed"),
];

const NOT_BY_AXES: &str = "with axis words is not followed: I alone is, the radius of the circle";

const WITHOUT_H: &str = "without H is not followed: write H and the number of the tool";

const SIZE_BY_P: &str =
    "with P, the size of the cutter, is not followed: write D and the number of the tool";

const CENTER: &str = "without A and B, its centre, is not followed";

const fn lost(code: (u8, u16), test: WordTest, message: &'static str) -> WordRule {
    WordRule { code, test, message, help: "", alarm: None, loses_path: true }
}
