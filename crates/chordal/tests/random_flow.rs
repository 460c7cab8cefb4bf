//! O words and macro lines put together at random: no crash, no hang, no number that is not
//! finite.

use chordal::machine::Machine;
use chordal::{Job, RunOptions, Source, SourceMap};
use proptest::prelude::*;

const O_WORDS: &[&str] = &[
    "o1 sub\n",
    "o1 endsub [#1]\n",
    "o1 call [1] [#2]\n",
    "o1 return\n",
    "o<a> sub\n",
    "o<a> endsub\n",
    "o<a> call\n",
    "o[#1] call\n",
    "o2 if [#1 LT 3]\n",
    "o2 elseif [1]\n",
    "o2 else\n",
    "o2 endif\n",
    "o3 while [#2 LT 5]\n",
    "o3 endwhile\n",
    "o3 break\n",
    "o3 continue\n",
    "o4 do\n",
    "o4 while [#1 NE 2]\n",
    "o5 repeat [3]\n",
    "o5 endrepeat\n",
    "o5 break\n",
    "o4 continue\n",
    "#1=[#1+1]\n",
    "#2=[#2+.5] #3=#2 G1 X#3\n",
    "#<a>=#<_x>\n",
    "#<_b>=[#<a>**2]\n",
    "G1 X#<_b> Y#1 F100\n",
    "(PRINT, #1 %d#2 %.3f#<a> #)\n",
    "(ABORT, no)\n",
    "(MSG, hello)\n",
    "G38.2 Z-#1\n",
    "#[#1]=#5061\n",
    "##1=2\n",
    "X[",
    "]",
    "#",
    "o",
    "<",
    ">",
    "o6 perhaps\n",
    "M98 P1\n",
    "M99\n",
    "M2\n",
    "O7\n",
    "X[EXISTS[#<a>]]\n",
    "#5221=#5220\n",
    "\n",
    "; a comment\n",
    "/o3 break\n",
    "N5 o2 endif\n",
    "G#1\n",
    "o[[[1]]] call\n",
    "#1=1/0\n",
];

const LINES: &[&str] = &[
    "#V1=V1+1\n",
    "#V2=V1*2\n",
    "#:A\n",
    "#:B\n",
    "#GOTO :A\n",
    "#GOTO :B\n",
    "#GOTO N5\n",
    "N5 ",
    "#IF V1<5 THEN GOTO :A\n",
    "#IF V1=V2 OR NOT V3 THEN V3=1\n",
    "#R1=V1\n",
    "X+R1\n",
    "Y-R2 I+R1 G2\n",
    "R0+R1\n",
    "G1 F10.\n",
    "G91 X.1 L+R1\n",
    "#PRINT \"A\",V1,\n",
    "#PRINT V2\n",
    "#INPUT V4\n",
    "#CLEAR V1-V9,V20\n",
    "#SET RND3\n",
    "#SET RADIANS\n",
    "#V3=RND(SIN(V1))\n",
    "#START 1\n",
    "#START 2\n",
    "O1\n",
    "O2\n",
    "L100\n",
    "M17\n",
    "M30\n",
    "M2\n",
    "L101\n",
    "G66 L101\n",
    "G67\n",
    "#FX(V1)=V2\n",
    "#V(V1)=H1\n",
    "#TU(R1)=AX\n",
    "#V1=SQR(-V1)\n",
    "#V1=1/V9\n",
    "#",
    "(",
    ")",
    "\"",
    "'",
    ":",
    "=",
    "IF",
    "THEN",
    "V",
    "9999999999",
    "-",
    "\n",
    "G31 Z-1.\n",
    "M98 P2\n",
    "/#V1=3\n",
];

fn run(machine: &str, text: &str) {
    let machine = Machine::from_builtin(machine).expect("built in");
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
        assert!(range.start <= range.end && range.end as usize <= text.len());
        assert!(!diagnostic.message.is_empty());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn any_flow_of_o_words_ends(pieces in prop::collection::vec(0..O_WORDS.len(), 1..60)) {
        let text: String = pieces.iter().map(|piece| O_WORDS[*piece]).collect();
        run("linuxcnc-mill", &text);
    }

    #[test]
    fn any_program_of_macro_lines_ends(pieces in prop::collection::vec(0..LINES.len(), 1..60)) {
        let text: String = pieces.iter().map(|piece| LINES[*piece]).collect();
        run("fadal-4020", &text);
    }
}
