//! Macro statements put together at random: no crash, no hang, no number that is not finite.

use chordal::machine::{Machine, builtin_names};
use chordal::{Code, Job, RunOptions, Source, SourceMap};
use proptest::prelude::*;

const PIECES: &[&str] = &[
    "#1",
    "#[",
    "]",
    "[",
    "=",
    "+",
    "-",
    "*",
    "/",
    "1",
    "2.5",
    "-.5",
    "0",
    "1E9",
    "99999999999",
    "SIN[",
    "ATAN[",
    "]/[",
    "SQRT[",
    "ROUND[",
    "FIX[",
    "LN[",
    "EXP[",
    "EQ",
    "NE",
    "GT",
    "AND",
    "MOD",
    "IF[",
    "]GOTO",
    "]THEN ",
    "WHILE[",
    "]DO1",
    "DO2",
    "END1",
    "END2",
    "GOTO",
    "N1 ",
    "N2 ",
    "G0 X",
    "G1 F",
    "G2 X1. I",
    "G65 P1 A",
    "G66 P2 ",
    "G67",
    "G66.1 P1 ",
    "M98 P2 L",
    "M99",
    "M30",
    "#3000=1(STOP)",
    "#3006=",
    "DPRNT[X#1[44]]",
    "DPRNT[",
    "POPEN",
    "#5021",
    "#4001",
    "#2001=",
    "#5221=",
    "#7001=",
    "#100=",
    "#500",
    "#0",
    "##",
    "#<a>",
    "(",
    ")",
    "\n",
    "\n",
    "\n",
    "\nO1\n",
    "\nO2\n",
    ";",
    " ",
    "Y",
    "R",
    "H#1",
    "T#2",
    "G#1",
    "M[3.5]",
    "G31 Z",
    "G10 L2 P1 X#1",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn any_macro_program_ends(
        machine in 0usize..64,
        pieces in prop::collection::vec(0..PIECES.len(), 1..80),
    ) {
        let names = builtin_names();
        let machine = Machine::from_builtin(names[machine % names.len()]).expect("built in");
        let text: String = pieces.iter().map(|piece| PIECES[*piece]).collect();
        let mut sources = SourceMap::new();
        sources.add(Source::new("random", text.as_bytes()));
        let options = RunOptions { max_repeated_blocks: 500, ..RunOptions::default() };
        let job = Job::new(sources, machine).expect("a good machine").options(options);
        let report = job.report_with(|command, segments| {
            if let Some(motion) = command.kind.motion() {
                assert!(motion.from.iter().chain(&motion.to).all(|value| value.is_finite()));
            }
            assert!(segments.iter().all(|segment| segment.length_mm.is_finite()));
        });
        for diagnostic in &report.diagnostics {
            let range = diagnostic.primary.span.range;
            prop_assert!(range.start <= range.end && range.end as usize <= text.len());
            prop_assert!(!diagnostic.message.is_empty());
        }
    }
}

#[test]
fn a_jump_back_in_a_program_with_macros_is_counted() {
    for (machine, text) in
        [("haas-vf2", "N1 #1=#1+1\nM99 P1\n"), ("fadal-4020", "N1 G1 X1. F10.\n#V1=2\nM99 P1\n")]
    {
        let mut sources = SourceMap::new();
        sources.add(Source::new("endless", text.as_bytes()));
        let machine = Machine::from_builtin(machine).expect("built in");
        let options = RunOptions { max_repeated_blocks: 500, ..RunOptions::default() };
        let job = Job::new(sources, machine).expect("a good machine").options(options);
        let codes: Vec<_> = job.report().diagnostics.iter().map(|each| each.code).collect();
        assert!(codes.contains(&Code::BudgetReached), "{text}: {codes:?}");
    }
}
