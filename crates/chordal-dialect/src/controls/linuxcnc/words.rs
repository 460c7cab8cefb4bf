//! What LinuxCNC (RS274/NGC) requires of the words of a code; each row was tested with rs274 2.9.

use crate::vocabulary::*;

pub(super) const WORD_RULES: &[WordRule] = &[
    rule(
        190,
        WordTest::Within(b'R', 0.0, 360.0),
        "takes an angle R from 0 to 360",
        "write the angle between 0 and 360 degrees",
        "R value must be within 0..360 with M19",
    ),
    rule(
        190,
        WordTest::Within(b'P', 0.0, 2.0),
        "takes P0, P1 or P2",
        "P0 turns the short way, P1 clockwise, P2 counter-clockwise",
        "P value must be 0,1,or 2 with M19",
    ),
    rule(
        190,
        WordTest::Within(b'Q', f64::MIN_POSITIVE, f64::INFINITY),
        "takes a time Q above 0",
        "give the seconds to wait, or leave Q out",
        "Q word with M19 requires a value > 0",
    ),
    rule(
        610,
        WordTest::OneOf("Q"),
        "needs Q, the number of the tool in the spindle, 0 or more",
        "write the number: `M61 Q3`",
        "Need non-negative Q-word to specify tool number with M61",
    ),
    output(620, "No valid P word with M62"),
    output(630, "No valid P word with M63"),
    output(640, "No valid P word with M64"),
    output(650, "No valid P word with M65"),
    rule(
        660,
        WordTest::NotBoth(b'P', b'E'),
        "has P and E: it waits for one input",
        "keep P, a digital input, or E, an analogue one",
        "Invalid to select both a digital and an analog input with M66",
    ),
    rule(
        660,
        WordTest::OneOf("PE"),
        "needs P or E, the number of the input, 0 or more",
        "P is a digital input, E an analogue one",
        "Need to have either a valid P or a valid E word with M66",
    ),
    rule(
        660,
        WordTest::Whole(b'L'),
        "needs a whole number L",
        "L0 does not wait; L1 to L4 are kinds of waiting",
        "Non integer value for integer",
    ),
    rule(
        660,
        WordTest::Within(b'L', 0.0, f64::INFINITY),
        "has an L below 0",
        "L0 does not wait; L1 to L4 are kinds of waiting",
        "Negative l word used",
    ),
    rule(
        660,
        WordTest::Without(b'L', b'E'),
        "cannot wait for an analogue input: with E only L0 is allowed",
        "write L0, or a digital input P",
        "Can't select analog input with wait type != immediate return",
    ),
    rule(
        660,
        WordTest::WithPositive(b'L', b'Q'),
        "waits (L other than 0) and has no time Q above 0",
        "give the seconds to wait at most with Q",
        "Zero timeout with wait type != immediate return",
    ),
    analogue(670, "Invalid analog index with M67"),
    value(670),
    analogue(680, "Invalid analog index with M68"),
    value(680),
];

const fn rule(
    code: u16,
    test: WordTest,
    message: &'static str,
    help: &'static str,
    alarm: &'static str,
) -> WordRule {
    WordRule { code: (b'M', code), test, message, help, alarm: Some(alarm), loses_path: false }
}

/// P is the number of a digital output.
const fn output(code: u16, alarm: &'static str) -> WordRule {
    rule(code, WordTest::Written(b'P'), "needs P, the number of the output", "write P", alarm)
}

/// E is the number of an analogue output.
const fn analogue(code: u16, alarm: &'static str) -> WordRule {
    rule(
        code,
        WordTest::OneOf("E"),
        "needs E, the number of the output, 0 or more",
        "write E, and the value with Q",
        alarm,
    )
}

/// Q is the value of the output; without Q rs274 sets it to -1 and continues.
const fn value(code: u16) -> WordRule {
    WordRule {
        code: (b'M', code),
        test: WordTest::Written(b'Q'),
        message: "without Q sets the output to -1",
        help: "write the value with Q",
        alarm: None,
        loses_path: false,
    }
}
