//! LinuxCNC's tool table.

mod common;

use chordal_machine::{Axis, Tool, read_tool_tbl};

#[test]
fn lines_as_the_manual_has_them() {
    let text = "\
; a comment alone

T1 P1 X0 Y0 Z+0.511 A0 D+0.125 I0 J0 Q0 ;1/8 end mill
t3 d.5 z-1. p-1
  D1.5   T99999 P3 ; ; spot ; drill\r
T2 P17
";
    let tools = read_tool_tbl(text, false).expect("a good table");
    assert_eq!(tools.keys().copied().collect::<Vec<_>>(), [1, 2, 3, 99999]);
    assert_eq!(
        tools[&1],
        Tool {
            offset: [Some(0.0), Some(0.0), Some(12.9794), Some(0.0), None, None],
            diameter_mm: Some(3.175),
            comment: Some("1/8 end mill".into()),
            ..Tool::default()
        }
    );
    assert_eq!(tools[&3].length_mm(), Some(-25.4));
    assert_eq!(tools[&3].diameter_mm, Some(12.7));
    assert_eq!(tools[&99999].comment.as_deref(), Some("; spot ; drill"));
    assert_eq!(tools[&2], Tool::default());
    let millimetres = read_tool_tbl("T1 D6.35 Z100", true).expect("a good table");
    assert_eq!(millimetres[&1].diameter_mm, Some(6.35));
    assert_eq!(millimetres[&1].length_mm(), Some(100.0));
    let lathe = read_tool_tbl("T7 X-1 Z2 B90 D.0625 Q3", false).expect("a good table");
    assert_eq!(lathe[&7].offset[Axis::X as usize], Some(-25.4));
    assert_eq!(lathe[&7].offset[Axis::B as usize], Some(std::f64::consts::FRAC_PI_2));
    assert_eq!(lathe[&7].tip, Some(3));
    assert!(read_tool_tbl("", false).is_ok_and(|tools| tools.is_empty()));
}

#[test]
fn every_bad_line_is_reported() {
    let text = "T1 D0.5\nT2 D1/8 Zx\nD5 ; no number\nT1 Z1\nT4 F5 D1 D2\nTwo Z1\né T5\n";
    let errors = read_tool_tbl(text, false).expect_err("bad lines");
    assert_eq!(
        common::shown(&errors),
        "\
tool.tbl:2: `D` needs a number, not `1/8`
  ^ D1/8
tool.tbl:2: `Z` needs a number, not `x`
  ^ Zx
tool.tbl:3: this line names no tool
  ^ D5
  = start the line with the tool's number, such as `T1`
tool.tbl:4: tool 1 is already in the table
  ^ T1
tool.tbl:5: `F5` is not a word of a tool table
  ^ F5
  = the words are T, P, D, X Y Z A B C U V W, I, J and Q; a comment starts with `;`
tool.tbl:5: `D` appears twice in this line
  ^ D2
tool.tbl:6: `T` needs a whole number, not `wo`
  ^ Two
tool.tbl:7: `é` is not a word of a tool table
  ^ é
  = the words are T, P, D, X Y Z A B C U V W, I, J and Q; a comment starts with `;`"
    );
}
