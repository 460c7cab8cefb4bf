//! What a part program needs and does not say: values of the machine, user data, tables of the control, names that nothing
//! defines.

use chordal::control::{CommandKind, Origin};
use chordal::diagnostics::Code;
use chordal::machine::{SettingEntry, SettingValue};
use chordal::path::PathCommand;
use chordal::{Diagnostic, Job, Machine, PathSink, Severity, Source, SourceMap};

/// The last work offset of a run: X, Y and Z, mm.
#[derive(Default)]
struct LastWorkOffset(Option<[f64; 3]>);

impl PathSink for LastWorkOffset {
    fn command(&mut self, path: PathCommand<'_>) {
        if let CommandKind::WorkOffset { offset, .. } = &path.command.kind {
            self.0 = Some([offset[0], offset[1], offset[2]]);
        }
    }

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}
}

fn machine() -> Machine {
    let mut machine = Machine::from_builtin("sinumerik-mill").expect("a built-in machine");
    machine.set("tools.1.length=100 mm").expect("a good assignment");
    machine.set("tools.1.diameter=10 mm").expect("a good assignment");
    machine.set("work_offsets.G54.Z=-400 mm").expect("a good assignment");
    machine
}

/// A program with other files of its folder.
fn job(text: &str, tables: &[(&str, &str)], machine: Machine) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.mpf", text.as_bytes().to_vec()));
    for (name, text) in tables {
        sources.add(Source::new(*name, text.as_bytes().to_vec()));
    }
    Job::new(sources, machine).expect("a machine of this control")
}

fn found(text: &str, tables: &[(&str, &str)]) -> Vec<Diagnostic> {
    job(text, tables, machine()).check().diagnostics
}

/// The codes of a program with their severities, without notes about what is assumed of the machine.
fn codes(text: &str, tables: &[(&str, &str)]) -> Vec<(Code, Severity)> {
    let found = found(text, tables);
    found.iter().map(|found| (found.code, found.severity)).collect()
}

/// The ends of the moves, X Y Z.
fn ends(text: &str, tables: &[(&str, &str)]) -> Vec<[f64; 3]> {
    let mut ends = Vec::new();
    job(text, tables, machine()).path(|segment| {
        let end = chordal::geometry::ParamCurve::end(&segment.curve);
        ends.push([end.x, end.y, end.z]);
    });
    ends
}

const HEAD: &str = "G17 G90 G710 G54\nT1 D1 M6\nS3000 M3 F200\nG0 X0 Y0 Z10\n";

#[test]
fn a_value_of_the_machine_is_unknown_and_no_error() {
    let text = format!("{HEAD}R1=$AA_IM[X]+1\nG1 X=R1\nY20\nX30\nM30\n");
    assert_eq!(codes(&text, &[]), [(Code::UnknownPath, Severity::Note)]);
    let report = job(&text, &[], machine()).check();
    assert!(report.diagnostics[0].message.contains("$AA_IM[X]"), "{:?}", report.diagnostics);
}

#[test]
fn a_condition_of_unknown_value_is_assumed() {
    let text = format!("{HEAD}IF $A_IN[3]==1 GOTOF WEITER\nG1 X10\nWEITER:\nG1 Y10\nM30\n");
    assert_eq!(codes(&text, &[]), [(Code::AssumedBranch, Severity::Note)]);
    // FALSE AND … is FALSE, whatever the other operand is.
    let text = format!("{HEAD}IF (1==2) AND ($A_IN[3]==1) GOTOF WEITER\nG1 X10\nWEITER:\nM30\n");
    assert_eq!(codes(&text, &[]), []);
}

#[test]
fn a_feed_of_unknown_value_leaves_the_path() {
    let text = format!("{HEAD}G1 X10 F=$A_DBR[4]\nY10\nM30\n");
    assert_eq!(codes(&text, &[]), [(Code::UnknownTime, Severity::Note)]);
}

#[test]
fn a_name_that_nothing_defines_is_an_alarm_only_where_nothing_else_can_have_it() {
    let text = format!("{HEAD}ZUSTELLUNG=2\nG1 X10\nM30\n");
    let warned = found(&text, &[]);
    assert_eq!(warned[0].severity, Severity::Warning);
    assert!(warned[0].alarm.as_deref().is_some_and(|alarm| alarm.contains("12550")), "{warned:?}");
    assert!(warned.iter().any(|found| found.code == Code::UnknownPath));

    let mut strict = machine();
    let setting = SettingEntry { value: SettingValue::Text("alarm".into()), location: None };
    strict.settings.insert("undefined_names".to_string(), setting);
    let found = job(&text, &[], strict).check().diagnostics;
    assert_eq!(found[0].severity, Severity::Error);

    // A typing error is one, whatever the control may have.
    let text = format!("DEF REAL TIEFE=5\n{HEAD}G1 Z=-TIEFFE\nM30\n");
    let found = job(&text, &[], machine()).check().diagnostics;
    assert!(found.iter().any(|found| found.severity == Severity::Error
        && found.alarm.as_deref().is_some_and(|alarm| alarm.contains("12550"))));
}

#[test]
fn a_program_that_nothing_has_is_a_warning_with_the_alarm() {
    let found = found(&format!("{HEAD}SPINDLE_WARMUP(3)\nG1 X10\nM30\n"), &[]);
    assert_eq!((found[0].code, found[0].severity), (Code::MissingSubprogram, Severity::Warning));
    assert!(found[0].alarm.as_deref().is_some_and(|alarm| alarm.contains("14011")), "{found:?}");
}

#[test]
fn user_data_come_from_a_file_of_definitions() {
    let definitions =
        ("GUD.DEF", "%_N_GUD_DEF\nDEF CHAN REAL CLEARANCE=12.5\nDEF NCK REAL PROBED\nM17\n");
    let text = format!("{HEAD}G1 Z=-2 X=CLEARANCE\nM30\n");
    assert_eq!(codes(&text, &[definitions]), []);
    assert_eq!(ends(&text, &[definitions]).last(), Some(&[12.5, 0.0, -2.0]));
    // What the control holds where the file gives no value is not known.
    let text = format!("{HEAD}G1 X=PROBED\nX10\nM30\n");
    assert_eq!(codes(&text, &[definitions]), [(Code::UnknownPath, Severity::Note)]);
}

#[test]
fn a_macro_stands_for_its_text() {
    let definitions = ("MACRO.DEF", "DEFINE HOME AS G0 X50 Y60\nDEFINE SAFE AS 25\nM17\n");
    let text = format!("{HEAD}HOME\nZ=SAFE\nM30\n");
    assert_eq!(codes(&text, &[definitions]), []);
    assert_eq!(ends(&text, &[definitions]).last(), Some(&[50.0, 60.0, 25.0]));
    let text = format!("DEFINE DOWN AS G1 Z-3\n{HEAD}DOWN X5\nM30\n");
    assert_eq!(ends(&text, &[]).last(), Some(&[5.0, 0.0, -3.0]));
}

#[test]
fn a_table_of_tools_decides_which_edges_there_are() {
    let table =
        ("TOOLS.INI", "$TC_DP3[1,1]=100\n$TC_DP6[1,1]=5\n$TC_DP3[1,2]=98\n$TC_DP6[1,2]=4\nM17\n");
    let text = |edge: u32| format!("{HEAD}D{edge}\nG1 Z-1\nM30\n");
    assert_eq!(codes(&text(2), &[table]), []);
    let found = found(&text(3), &[table]);
    assert!(
        found.iter().any(|found| found.severity == Severity::Error
            && found.alarm.as_deref().is_some_and(|alarm| alarm.contains("17180"))),
        "{found:?}"
    );
}

/// A table that the control saved writes a settable frame as a chain, most of whose frames do nothing.
#[test]
fn a_chain_of_frames_in_a_table_is_the_work_offset() {
    let text = format!("{HEAD}G1 X10\nM30\n");
    let machine = || {
        let mut machine = machine();
        machine.axes.iter_mut().flatten().for_each(|axis| axis.travel = None);
        machine
    };
    let offset_of = |chain: &str| {
        let table = format!("$P_UIFR[1]={chain}\nM17\n");
        let job = job(&text, &[("uifr.ini", &table)], machine());
        let found = job.check().diagnostics;
        let found: Vec<_> = found.iter().map(|found| (found.code, found.severity)).collect();
        let mut offset = LastWorkOffset::default();
        job.compensated(None, &mut offset);
        (found, offset.0)
    };
    let neutral = "CROT(X,0,Y,0,Z,0):CSCALE(X,1,Y,1,Z,1):CMIRROR()";
    for (chain, expected) in [
        ("CTRANS(X,10,Y,20,Z,-400)".to_string(), [10.0, 20.0, -400.0]),
        (format!("CTRANS(X,10,Y,20,Z,-400):{neutral}"), [10.0, 20.0, -400.0]),
        (format!("CTRANS(X,10,Z,-400):{neutral}:CFINE(X,0.5,Y,-0.25)"), [10.5, -0.25, -400.0]),
    ] {
        assert_eq!(offset_of(&chain), (Vec::new(), Some(expected)), "{chain}");
    }
    for chain in ["CTRANS(X,10):CROT(Z,30)", "CTRANS(X,10):CSCALE(X,2)", "CTRANS(X,10):CMIRROR(Y)"]
    {
        let (found, _) = offset_of(chain);
        assert_eq!(found, [(Code::NotFollowed, Severity::Error)], "{chain}");
    }
}

/// The leads of the cuts of a lathe program, mm: mean along the path, and change in each revolution.
fn leads(text: &str) -> Vec<[f64; 2]> {
    #[derive(Default)]
    struct Leads(Vec<[f64; 2]>);
    impl PathSink for Leads {
        fn command(&mut self, path: PathCommand<'_>) {
            if let CommandKind::Line { feed, .. } = &path.command.kind {
                self.0.push([feed.value, feed.lead_change]);
            }
        }
        fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}
    }
    let machine = Machine::from_builtin("sinumerik-lathe").expect("a built-in machine");
    let mut found = Leads::default();
    job(text, &[], machine).compensated(None, &mut found);
    found.0
}

#[test]
fn the_lead_of_a_thread_changes_with_each_revolution() {
    let head = "G18 G90 G95 DIAMOF\nT1 D1\nS600 M3\nG0 X20 Z5\n";
    let near = |found: &[[f64; 2]], expected: &[[f64; 2]]| {
        let pairs = found.iter().flatten().zip(expected.iter().flatten());
        found.len() == expected.len() && pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-9)
    };
    // Over 20 mm the square of the lead grows by 2 · 0.1 · 20 to 5; with G35 it falls from 4 by 2 · 0.02 · 20.
    let cylinder = format!("{head}G34 Z-15 K1 F0.1\nG35 Z-35 K=2 F0.02\nM30\n");
    let (grown, fallen) = (0.5 * (1.0 + 5_f64.sqrt()), 0.5 * (2.0 + 3.2_f64.sqrt()));
    let found = leads(&cylinder);
    assert!(near(&found, &[[grown, 0.1], [fallen, -0.02]]), "{found:?}");
    // On a taper the path is longer than the way of Z.
    let taper = format!("{head}G34 X35 Z-15 K1 F0.1\nM30\n");
    let longer = 15_f64.hypot(20.0) / 20.0;
    let found = leads(&taper);
    assert!(near(&found, &[[grown * longer, 0.1 * longer]]), "{found:?}");
    // Without F the lead stays.
    let constant = format!("{head}G34 Z-15 K1\nM30\n");
    assert!(near(&leads(&constant), &[[1.0, 0.0]]));
    // A lead that becomes zero on the way: 1 mm squared is used up after 5 mm.
    let vanishing = format!("{head}G35 Z-15 K1 F0.1\nM30\n");
    let machine = Machine::from_builtin("sinumerik-lathe").expect("a built-in machine");
    let report = job(&vanishing, &[], machine).check();
    let error = report.diagnostics.iter().find(|found| found.severity == Severity::Error);
    let message = &error.expect("an error").message;
    assert!(message.contains("becomes zero after 5 mm of 20 mm"), "{message}");
}
