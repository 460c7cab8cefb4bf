//! Compensated contours: no crash, no hang, no number that is not finite, on lines, arcs and
//! helices in all planes, with any offset and the comings and goings of G41 and G42.

#![no_main]

mod support;

use libfuzzer_sys::fuzz_target;

const WORDS: &[&str] = &[
    "\n",
    "\n",
    "\n",
    "\n",
    "\n",
    "G41 D1 ",
    "G42 D1 ",
    "G40 ",
    "D2 ",
    "D3 ",
    "D0 ",
    "H1 ",
    "G41 ",
    "G42 ",
    "G0 ",
    "G1 ",
    "G1 ",
    "G2 ",
    "G3 ",
    "G17 ",
    "G18 ",
    "G19 ",
    "G90 ",
    "G91 ",
    "X0 ",
    "X1. ",
    "X-1. ",
    "X.2 ",
    "X-.2 ",
    "X3. ",
    "X.0001 ",
    "Y0 ",
    "Y1. ",
    "Y-1. ",
    "Y.2 ",
    "Y-.2 ",
    "Y3. ",
    "Z0 ",
    "Z-1. ",
    "Z.1 ",
    "I.2 ",
    "I-.2 ",
    "I1. ",
    "I-1. ",
    "I0 ",
    "J.2 ",
    "J-.2 ",
    "J1. ",
    "J-1. ",
    "J0 ",
    "K1. ",
    "K-1. ",
    "R1. ",
    "R-1. ",
    "R.3 ",
    "R0+1. ",
    "L3 ",
    "P2 ",
    "G39 ",
    "M8\n",
    "G4 P1\n",
    "G28 X0\n",
    "G53 X0\n",
    "G92 X0\n",
    "M6 T2\n",
    "G81 Z-1. R.1 ",
    "G80\n",
    "G20 ",
    "G21 ",
    "G52 X1.\n",
    "G10 L12 P1 R.3\n",
    "M99\n",
    "M98 P1\n",
    "A10. ",
    "Q.2 ",
    "M17\n",
];

fuzz_target!(|bytes: &[u8]| {
    if let Some((machine, text)) =
        support::program(bytes, "G20 G90 G17 S900 M3\nT1 M6\nH1\nG1 X0 Y0 F10.\n", WORDS)
    {
        support::run_words(machine, &text);
    }
});
