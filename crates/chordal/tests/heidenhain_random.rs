//! Random conversational and DIN/ISO programs: whatever stands in them, a run ends and reports what is wrong.

use chordal::{Job, Machine, RunOptions, Source, SourceMap};
use proptest::prelude::*;

/// Blocks of which random programs are made.
const BLOCKS: &[&str] = &[
    "TOOL DEF 1 L+0 R+5",
    "TOOL CALL 1 Z S3000 F200",
    "TOOL CALL 2 Y S100 DL+0.1 DR-0.2",
    "TOOL CALL \"A\"",
    "L X+10 Y+20 R0 FMAX M3",
    "L Z-5 F100",
    "L X+40 RL F300",
    "L IX-7 IY+3 RR",
    "L Y+5 R0",
    "X+1 Y+2",
    "L X+Q1 Y-Q2",
    "L A+10 C+20",
    "L X0 Y0 Z0 M91",
    "L M140 MB MAX",
    "L M140 MB 20 FMAX",
    "CC X+20 Y+20",
    "CC",
    "CC IX+5",
    "CC X+1 Z-2",
    "C X+30 Y+20 DR+",
    "C DR-",
    "CR X+0 Y+0 R+30 DR-",
    "CR X+0 R-5 DR+",
    "CT X+7 Y+8",
    "LP PR+10 PA+30",
    "LP IPR+1 IPA+5",
    "CP IPA+720 IZ-3 DR+",
    "CP PA+90 DR-",
    "CP IPA-90 DR+",
    "CTP PR+9 PA+1",
    "RND R3 F50",
    "CHF 2",
    "RND R-1",
    "RND",
    "APPR LT X+5 Y+5 LEN10 RL F100",
    "APPR LCT X+5 Y+5 R4 RR",
    "APPR CT X+1 Y+1 CCA90 R-3 RL",
    "APPR PLN PR+5 PA+9 LEN3 RL",
    "DEP LT LEN5",
    "DEP LCT X-9 Y-9 R2",
    "DEP CT CCA180 R+3",
    "DEP LN LEN+0",
    "LBL 1",
    "LBL 0",
    "CALL LBL 1",
    "CALL LBL 1 REP 3",
    "CALL LBL 9",
    "CALL PGM X",
    "LBL \"A\"",
    "CALL LBL \"A\"",
    "FN 0: Q1 = +5",
    "Q2 = Q1 ^ 99 * 3",
    "Q1 = Q2 / ( Q1 - 5 )",
    "FN 9: IF +Q1 EQU +5 GOTO LBL 1",
    "FN 11: IF +Q1 GT +0 GOTO LBL 1",
    "FN 18: SYSREAD Q3 = ID270 NR1 IDX2",
    "QS1 = \"a\" || QS2",
    "FN 14: ERROR = 3",
    "CYCL DEF 7.0",
    "CYCL DEF 7.1 X+5",
    "CYCL DEF 7.2 IY-5",
    "CYCL DEF 8.0",
    "CYCL DEF 8.1 X",
    "CYCL DEF 8.1",
    "CYCL DEF 10.1 ROT+30",
    "CYCL DEF 11.1 SCL 0.5",
    "CYCL DEF 11.1 SCL 0",
    "CYCL DEF 26.1 X2 Y0.5 CCX+3 CCY+1",
    "CYCL DEF 19.1 A+20 B+0 C+0",
    "CYCL DEF 19.1",
    "PLANE SPATIAL SPA+0 SPB+30 SPC+0 TURN",
    "PLANE RESET STAY",
    "PLANE VECTOR BX1 BY0 BZ0 NX0 NY0.5 NZ0.8 STAY",
    "M128",
    "M129",
    "LN X+1 Y+2 Z+3 TX0.1 TY0 TZ1",
    "M89",
    "M97",
    "CYCL DEF 200 Q200=2 Q201=-10 Q206=100 Q202=3 Q210=0 Q203=+0 Q204=50 Q211=0",
    "CYCL DEF 203 Q200=2 Q201=-10 Q206=100 Q202=3 Q203=0 Q212=1 Q213=2 Q205=0.5 Q256=0.2 Q208=MAX",
    "CYCL DEF 208 Q200=2 Q201=-10 Q206=100 Q334=0 Q203=0 Q335=20",
    "CYCL DEF 209 Q200=2 Q201=-9 Q239=1 Q203=0 Q257=0",
    "CYCL DEF 251 Q215=0 Q218=60 Q219=40 Q220=8 Q368=0.3 Q207=500 Q201=-9 Q202=0.01 Q206=9 Q200=2 Q203=0 Q370=0.001",
    "CYCL DEF 254 Q219=12 Q375=70 Q376=45 Q248=-90 Q207=6 Q201=-6 Q202=3 Q206=1 Q200=2 Q203=0",
    "CYCL DEF 262 Q335=16 Q239=-1.5 Q201=-20 Q355=3 Q200=2 Q203=0 Q207=500",
    "CYCL DEF 14.0 CONTOUR",
    "CYCL DEF 14.1 CONTOUR LABEL1 /2",
    "CYCL DEF 20 Q1=-9 Q2=1.5 Q3=-0.1 Q4=0.2 Q5=0 Q6=2 Q7=50 Q8=0.5 Q9=-1",
    "CYCL DEF 22 Q10=5 Q11=100 Q12=500 Q18=0",
    "CYCL DEF 23 Q11=100 Q12=500",
    "CYCL DEF 24 Q9=1 Q10=5 Q11=100 Q12=500 Q14=0",
    "CYCL DEF 25 Q1=-9 Q3=0 Q5=0 Q7=9 Q10=0.001 Q11=1 Q12=2 Q15=0",
    "CYCL DEF 7.1 #3",
    "SEL TABLE \"A.D\"",
    "TRANS DATUM TABLE TABLINE1",
    "TRANS DATUM TABLE",
    "L X+0 Y+0 RL",
    "L X+50 RR",
    "L Y+50",
    "CYCL DEF 256 Q218=60 Q424=80 Q219=40 Q425=1 Q220=99 Q207=500 Q201=-9 Q202=0.01 Q206=9 Q200=2 Q203=0 Q370=0.001 Q215=0 Q368=0.2",
    "CYCL DEF 257 Q223=0 Q222=80 Q207=500 Q201=-9 Q202=3 Q206=9 Q200=2 Q203=0 Q376=400 Q351=-1",
    "CYCL DEF 267 Q335=16 Q239=-0.0001 Q201=-20 Q355=3 Q200=2 Q203=0 Q207=500 Q358=-1 Q359=0",
    "CYCL DEF 241 Q200=2 Q201=-100 Q206=9 Q203=0 Q379=120 Q426=5 Q428=1 Q429=8 Q435=5 Q202=0.001",
    "CYCL DEF 210 Q200=2 Q201=-9 Q207=9 Q202=1 Q203=0 Q216=0 Q217=0 Q218=5 Q219=12 Q338=0.1",
    "CYCL DEF 211 Q200=2 Q201=-9 Q207=9 Q202=1 Q203=0 Q216=0 Q217=0 Q244=9 Q219=12 Q245=9 Q248=-999",
    "CYCL DEF 212 Q200=2 Q201=-9 Q206=5 Q202=1 Q207=9 Q203=0 Q216=0 Q217=0 Q218=50 Q219=12 Q220=9 Q221=99",
    "CYCL DEF 215 Q200=2 Q201=-9 Q206=5 Q202=1 Q207=9 Q203=0 Q216=0 Q217=0 Q222=50 Q223=12",
    "CYCL DEF 230 Q225=0 Q226=0 Q227=2 Q218=0 Q219=75 Q240=0 Q206=1 Q207=5 Q209=2 Q200=2",
    "CYCL DEF 231 Q225=0 Q226=0 Q227=2 Q228=9 Q229=0 Q230=0 Q231=0 Q232=9 Q233=0 Q234=0 Q235=9 Q236=99 Q240=3 Q207=5",
    "CYCL DEF 232 Q389=2 Q225=0 Q226=0 Q227=2 Q386=-3 Q218=9 Q219=75 Q202=0 Q207=5 Q200=2 Q370=0.001",
    "CYCL DEF 3.0",
    "CYCL DEF 3.1 SET UP -2",
    "CYCL DEF 3.2 DEPTH -9",
    "CYCL DEF 3.3 PECKG -1 F9",
    "CYCL DEF 3.4 Y-80",
    "CYCL DEF 3.5 X+12",
    "CYCL DEF 3.6 F90",
    "CYCL DEF 220 Q216=0 Q217=0 Q244=20 Q241=7 Q246=360",
    "CYCL DEF 221 Q225=0 Q226=0 Q237=1 Q238=1 Q242=3 Q243=2",
    "CYCL DEF 1.0",
    "CYCL DEF 1.1 SET UP -2",
    "CYCL DEF 1.2 DEPTH -9",
    "CYCL DEF 1.3 PECKG -0.001",
    "CYCL DEF 1.5 F9",
    "CYCL DEF 12.1 PGM X",
    "CYCL CALL",
    "L X+5 M99",
    "CYCL CALL POS X+1 Y+1 Z+0 FMAX",
    "PATTERN DEF POS1 (X+1 Y+2 Z+0)",
    "CYCL CALL PAT FMAX",
    "BLK FORM 0.1 Z X+0 Y+0 Z-20",
    "BLK FORM 0.2 X+100 Y+100 Z+0",
    "M30",
    "STOP",
    "END PGM A MM",
    "L X+99999999 Y-0.0000001 F99999",
    "FL AN+30 LEN10",
    "TCH PROBE 411 DATUM Q321=+5",
];

/// Blocks of DIN/ISO programs.
const ISO_BLOCKS: &[&str] = &[
    "T1 G17 S3000*",
    "G99 T1 L+0 R+5*",
    "G00 G40 G90 X+10 Y+10 M3*",
    "G01 Z-5 F100*",
    "G41 X+20 F300*",
    "G40 X+0*",
    "G02 X+5 Y+5 R+9*",
    "I+5 J+5*",
    "G03 X+0 Y+9*",
    "G06 X+3 Y+4*",
    "G10 R+9 H+30*",
    "G13 G91 H+720 Z-3*",
    "G12 H+9*",
    "G24 R2*",
    "G25 R3*",
    "G28 X*",
    "G28*",
    "G54 X+5*",
    "G73 H+30*",
    "G72 F2*",
    "G79*",
    "G29*",
    "G98 L1*",
    "L1,0*",
    "L1,3*",
    "D00 Q1 P01 +3*",
    "D04 Q1 P01 +1 P02 +0*",
    "D09 P01 +Q1 P02 +3 P03 +1*",
    "G200 Q200=2 Q201=-9 Q206=9 Q202=3 Q203=0*",
    "M99*",
    "M30*",
    "G91 X+Q1*",
    "G999*",
    "N5 %A G71 *",
];

fn run(text: String, machine: &str) {
    let mut sources = SourceMap::new();
    sources.add(Source::new("A.H".to_string(), text.into_bytes()));
    sources.add(Source::new(
        "X.H".to_string(),
        b"BEGIN PGM X INCH\nL IX+1 FMAX\nEND PGM X INCH\n".to_vec(),
    ));
    let machine = Machine::from_builtin(machine).expect("a built-in machine");
    let options = RunOptions { max_repeated_blocks: 500, ..RunOptions::default() };
    let job = Job::new(sources, machine).expect("a job").options(options);
    let report = job.check();
    for found in &report.diagnostics {
        assert!(!found.message.is_empty());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn conversational_programs_end(
        blocks in proptest::collection::vec(0..BLOCKS.len(), 1..40), has_tables in any::<bool>()
    ) {
        let mut text = String::from("0 BEGIN PGM A MM\nTOOL DEF 1 L+0 R+5\nTOOL CALL 1 Z S1000\n");
        blocks.iter().for_each(|block| text += &format!("{}\n", BLOCKS[*block]));
        let machine = if has_tables { "heidenhain-ac-trunnion" } else { "heidenhain-mill" };
        run(text, machine);
    }

    #[test]
    fn iso_programs_end(blocks in proptest::collection::vec(0..ISO_BLOCKS.len(), 1..40)) {
        let mut text = String::from("%A G71 *\n");
        blocks.iter().for_each(|block| text += &format!("N10 {}\n", ISO_BLOCKS[*block]));
        run(text, "heidenhain-mill");
    }
}
