//! Programs that read a value: the line from which on they are not verified, by hand.

use super::lost_line;

/// What a machine file gives beside the built-in machine.
const NOTHING: &[&str] = &[];
const OFFSETS: &[&str] =
    &["work_offsets.G54.X=-300 mm", "work_offsets.G54.Y=-200 mm", "work_offsets.G54.Z=-400 mm"];
const LENGTH: &[&str] = &["tools.1.length=100 mm"];

/// A program: what is given, its blocks, and the first line that is not verified.
type Case = (&'static [&'static str], &'static str, Option<usize>);

/// Of the three controls with macro B.
const MACRO_B: &[Case] = &[
    // Common variables.
    (NOTHING, "G0 X#500", Some(1)),
    (&["#500=2"], "G0 X#500", None),
    (NOTHING, "#500=1\nG0 X#500", None),
    (NOTHING, "#501=#500\n#502=#501*2\nG0 X#502", Some(3)),
    (NOTHING, "#501=#500\n#501=3\nG0 X#501", None),
    (NOTHING, "IF[#500EQ1]GOTO9\nG0 X1.\nN9", Some(1)),
    (NOTHING, "#1=0\nWHILE[#1LT#500]DO1\nG0 X#1\n#1=#1+1\nEND1", Some(2)),
    (NOTHING, "#1=#0\nIF[#1EQ#0]GOTO9\nG0 X1.\nN9", None),
    // Words that an unknown value reaches.
    (NOTHING, "M98 P2001 L#500", Some(1)),
    (NOTHING, "M98 P#500", Some(1)),
    (NOTHING, "G65 P2000 A#500", Some(5)),
    (NOTHING, "G65 P2001 A#500", None),
    (NOTHING, "G43 H#500 Z5.", Some(1)),
    (NOTHING, "G0 X5.\nG41 D#500 G1 X10. F100.\nG40 X20.", Some(2)),
    (NOTHING, "T#500 M6", Some(1)),
    (NOTHING, "S#500 M3\nG1 X5. F100.", Some(1)),
    (NOTHING, "G1 X5. F#500", Some(1)),
    (NOTHING, "G4 P#500", Some(1)),
    (NOTHING, "G#500 X5.", Some(1)),
    (NOTHING, "M#500", Some(1)),
    (NOTHING, "G10 L2 P1 X#500", Some(1)),
    (NOTHING, "#5221=#500", Some(1)),
    (NOTHING, "#3000=#500", Some(1)),
    (NOTHING, "GOTO#500\nN9", Some(1)),
    // What is printed or stored reaches no path.
    (NOTHING, "POPEN\nDPRNT[A#500[33]]\nPCLOS", None),
    (NOTHING, "#501=#500", None),
    // Inputs, outputs, timers, the clock.
    (NOTHING, "G0 X#1000", Some(1)),
    (&["#1000=1"], "G0 X#1000", None),
    (NOTHING, "IF[#1000EQ1]GOTO9\nG0 X1.\nN9", Some(1)),
    (NOTHING, "G0 X#1100", Some(1)),
    (NOTHING, "#1100=1\nG0 X#1100", None),
    (NOTHING, "G0 X#3003", None),
    (NOTHING, "G0 X[#3001/1000]", Some(1)),
    (NOTHING, "#3001=0\nG0 X[#3001/1000]", Some(2)),
    (NOTHING, "#3001=0\nWHILE[#3001LT500]DO1\nEND1", Some(2)),
    (NOTHING, "G0 X[#3011/1000000]", Some(1)),
    (&["macros.date=2024-05-17"], "G0 X[#3011/1000000]", None),
    (NOTHING, "G0 X[#3012/1000]", Some(1)),
    // Positions.
    (NOTHING, "G0 X#5001", Some(1)),
    (NOTHING, "G0 X10.\nG0 X[#5001+5]", None),
    (NOTHING, "G91 G0 X10.\nG90 G0 X[#5001+5]", Some(2)),
    (NOTHING, "G0 X#5021", Some(1)),
    (NOTHING, "G91 G28 X0\nG90\nG0 Y[#5021/10]", None),
    (NOTHING, "G0 X10.\nG0 Y[#5021/10]", Some(2)),
    (OFFSETS, "G0 X10.\nG0 Y[#5021/10]", None),
    (NOTHING, "G53 G0 X-20.\nG0 Y[#5021/10]", None),
    (NOTHING, "G0 X#5041", Some(1)),
    (NOTHING, "G0 X10.\nG0 X#5041", None),
    (NOTHING, "G43 H1 Z10.\nG0 X[#5043/10]", Some(2)),
    (LENGTH, "G43 H1 Z10.\nG0 X[#5043/10]", None),
    // Skip moves: where they touch is in no program.
    (NOTHING, "G0 X#5061", Some(1)),
    (NOTHING, "G31 Z-5. F100.\nG0 Z#5063", Some(1)),
    (&["probe.hit={ Z = \"-3 mm\" }"], "G0 Z0.\nG31 Z-5. F100.\nG0 Z#5063", None),
    (&["probe.hit=end"], "G0 Z0.\nG31 Z-5. F100.\nG0 Z#5063", None),
    // Modal words and codes.
    (NOTHING, "G0 X#4001", None),
    (NOTHING, "G#4003 X1.", None),
    (NOTHING, "G0 X[#4109/100]", Some(1)),
    (NOTHING, "F100.\nG0 X[#4109/100]", None),
    (NOTHING, "G0 X[#4119/100]", Some(1)),
    (NOTHING, "S100\nG0 X[#4119/100]", None),
    (NOTHING, "G0 X#4120", Some(1)),
    (NOTHING, "T1\nG0 X#4120", None),
    (NOTHING, "G0 X#4107", Some(1)),
    (NOTHING, "G0 X#4111", Some(1)),
    (LENGTH, "G43 H1 Z10.\nG0 X#4111", None),
    // Offsets.
    (NOTHING, "G0 X[#5221/100]", Some(1)),
    (OFFSETS, "G0 X[#5221/100]", None),
    (NOTHING, "G10 L2 P1 X-100.\nG0 X[#5221/100]", None),
    (NOTHING, "G0 X#5201", Some(1)),
    (OFFSETS, "G0 X#5201", None),
    (NOTHING, "G0 X#7001", Some(1)),
    (NOTHING, "G91 G10 L2 P1 X5.\nG90 G0 X0.", Some(1)),
    (OFFSETS, "G91 G10 L2 P1 X5.\nG90 G0 X0.", None),
];

/// Of Haas and Mitsubishi, which show tool offsets under the same numbers.
const TOOL_TABLE: &[Case] = &[
    (NOTHING, "G0 X[#2001/100]", Some(1)),
    (NOTHING, "G0 X[#2201/100]", Some(1)),
    (NOTHING, "G0 X[#2401/100]", Some(1)),
    (NOTHING, "G0 X[#2601/100]", Some(1)),
    (NOTHING, "G10 L10 P1 R50.\nG10 L11 P1 R1.\nG0 X[[#2001+#2201]/100]", None),
];

const FANUC: &[Case] = &[
    (NOTHING, "G0 X[#2001/100]", Some(1)),
    (NOTHING, "G0 X[#11001/100]", Some(1)),
    (LENGTH, "G0 X[#11001/100]", None),
    (NOTHING, "G0 X[#13001/100]", Some(1)),
    (&["tools.1.diameter=10 mm"], "G0 X[#13001/100]", None),
    (NOTHING, "G0 X#5083", None),
    (NOTHING, "G43 H1 Z10.\nG0 X[#5083/100]", Some(2)),
    (LENGTH, "G43 H1 Z10.\nG0 X[#5083/100]", None),
    (NOTHING, "G0 X#3007", Some(1)),
    (NOTHING, "G0 X#2501", Some(1)),
    (NOTHING, "G0 X#100001", Some(1)),
    (NOTHING, "G0 X#100351", Some(1)),
];

const HAAS: &[Case] = &[
    (NOTHING, "G0 X#3026", Some(1)),
    (NOTHING, "T1 M6\nG0 X#3026", None),
    (NOTHING, "G0 X[#3027/100]", Some(1)),
    (NOTHING, "S100 M3\nG0 X[#3027/100]", None),
    (NOTHING, "G0 X#20033", Some(1)),
    (NOTHING, "G0 X#11000", Some(1)),
    (NOTHING, "G0 X#12000", Some(1)),
    (NOTHING, "G0 X#10000", Some(1)),
];

const LINUXCNC: &[Case] = &[
    (NOTHING, "G0 X#31", Some(1)),
    (NOTHING, "#31=4\nG0 X#31", None),
    (NOTHING, "M66 P0 L0\nG0 X#5399", Some(2)),
    (NOTHING, "G0 X[#5403/100]", Some(1)),
    (NOTHING, "T1 M6\nG0 X[#5403/100]", Some(2)),
    (LENGTH, "T1 M6\nG0 X[#5403/100]", None),
    (NOTHING, "G0 X[#5410/100]", Some(1)),
    (NOTHING, "G0 X#5400", Some(1)),
    (NOTHING, "T1 M6\nG0 X#5400", None),
    (NOTHING, "G0 X#<_tool_offset>", None),
    (NOTHING, "G43 H1\nG0 X#<_tool_offset>", Some(2)),
    (LENGTH, "G43 H1\nG0 X#<_tool_offset>", None),
    (NOTHING, "G0 X#5161", Some(1)),
    (NOTHING, "G53 G0 X-5 Y-5 Z-5\nG28.1\nG0 X#5161", None),
    (&["#5161=3"], "G0 X#5161", None),
    (NOTHING, "G0 X#5211", Some(1)),
    (NOTHING, "G92.1\nG0 X#5211", None),
    (NOTHING, "G0 X#5210", Some(1)),
    (NOTHING, "G0 X#5221", Some(1)),
    (OFFSETS, "G0 X[#5221/100]", None),
    (NOTHING, "G0 X#5220", None),
    (NOTHING, "G0 X#5021", Some(1)),
    (NOTHING, "G0 X#5420", Some(1)),
    (NOTHING, "G0 X10\nG0 Y#5420", None),
    (NOTHING, "G0 X#<_x>", Some(1)),
    (NOTHING, "G0 X10\nG0 Y#<_x>", None),
    (NOTHING, "G0 X#<_abs_x>", Some(1)),
    (NOTHING, "G0 X#5061", Some(1)),
    (NOTHING, "G0 X#5070", Some(1)),
    (NOTHING, "G38.2 Z-5 F100\nG0 Z#5063", Some(1)),
    (&["probe.hit=end"], "G0 Z0\nG38.2 Z-5 F100\nG0 Z#5063", None),
    (NOTHING, "G0 X#<_hal[motion.feed-hold]>", Some(1)),
    (NOTHING, "G0 X#<_ini[TRAJ]LINEAR_UNITS>", Some(1)),
    (NOTHING, "G0 X#<_current_tool>", Some(1)),
    (NOTHING, "G0 X#<_selected_pocket>", Some(1)),
    (NOTHING, "G0 X[#<_rpm>/100]", Some(1)),
    (NOTHING, "S100\nG0 X[#<_rpm>/100]", None),
    (NOTHING, "G0 X[#<_feed>/100]", Some(1)),
    (NOTHING, "F100\nG0 X[#<_feed>/100]", None),
    (NOTHING, "G0 X#<_metric>", None),
    (NOTHING, "o100 if [#31 GT 2]\nG0 X1\no100 endif", Some(1)),
    (NOTHING, "o100 repeat [#31]\nG0 X1\no100 endrepeat", Some(1)),
    (NOTHING, "o100 while [#31 GT 2]\nG0 X1\no100 endwhile", Some(1)),
    (NOTHING, "G43 H#31", Some(1)),
];

const MACH3: &[Case] = &[
    (NOTHING, "G0 X#500", Some(1)),
    (NOTHING, "G0 X#2000", Some(1)),
    (NOTHING, "G0 X#5161", Some(1)),
    (NOTHING, "G0 X#5211", Some(1)),
    (NOTHING, "G0 X#5221", Some(1)),
];

const FADAL: &[Case] = &[
    (NOTHING, "N10 G0 X+R1", Some(1)),
    (NOTHING, "N10 R1+5.\nN11 G0 X+R1", None),
    (NOTHING, "#R1=V1\nN10 G0 X+R1", Some(2)),
    (NOTHING, "#V1=3\n#R1=V1\nN10 G0 X+R1", None),
    (NOTHING, "#R1=FX1\nN10 G0 X+R1", Some(2)),
    (&["work_offsets.E1.X=-3 mm"], "#R1=FX1\nN10 G0 X+R1", None),
    (NOTHING, "#R1=H1\nN10 G0 X+R1", Some(2)),
    (&["tools.1.length=3 mm"], "#R1=H1\nN10 G0 X+R1", None),
    (NOTHING, "#R1=D1\nN10 G0 X+R1", Some(2)),
    (NOTHING, "#R1=AX\nN10 G0 X+R1", Some(2)),
    (NOTHING, "N10 G0 X5.\n#R1=AX\nN11 G0 X+R1", None),
    (NOTHING, "#R1=TN\nN10 G0 X+R1", Some(2)),
    (NOTHING, "N10 T2 M6\n#R1=TN\nN11 G0 X+R1", None),
    (NOTHING, "#R1=VF/100\nN10 G0 X+R1", Some(2)),
    (NOTHING, "#R1=PX1\nN10 G0 X+R1", Some(2)),
    (NOTHING, "#IF V1 GT 2 THEN GOTO :9\nN10 G0 X1.\n#:9", Some(1)),
];

fn deviations(machine: &str, cases: &[Case]) -> Vec<String> {
    let checked = cases.iter().filter_map(|&(given, body, expected)| {
        let (line, said) = lost_line(machine, given, body);
        (line != expected).then(|| {
            format!("{machine} {given:?}\n{body}\n  expected {expected:?}, got {line:?}: {said:#?}")
        })
    });
    checked.collect()
}

#[test]
fn what_a_value_reaches_is_not_verified_where_nobody_gave_it() {
    let tables: [(&[&str], &[Case]); 7] = [
        (&["fanuc-0i", "haas-vf2", "mitsubishi-m700"], MACRO_B),
        (&["haas-vf2", "mitsubishi-m700"], TOOL_TABLE),
        (&["fanuc-0i"], FANUC),
        (&["haas-vf2"], HAAS),
        (&["linuxcnc-mill"], LINUXCNC),
        (&["mach3-mill"], MACH3),
        (&["fadal-4020"], FADAL),
    ];
    let (mut all, mut wrong) = (0, Vec::new());
    for (machines, cases) in tables {
        for machine in machines {
            all += cases.len();
            wrong.extend(deviations(machine, cases));
        }
    }
    assert!(wrong.is_empty(), "{} of {all} deviate:\n{}", wrong.len(), wrong.join("\n"));
}
