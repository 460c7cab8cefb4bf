//! FileAccess beside a program, of any text: machine and setup files with what they name, tool tables, printed settings,
//! variables. An answer or a refusal, never a crash; and what was read runs.

#![no_main]

use std::path::PathBuf;

use chordal::machine::{Machine, QuantityDimension, parse_quantity};
use chordal::stock::StockOptions;
use chordal_load::{FileAccess, Loader, ProgramInput, ProgramText, Request, RequestedMachine};
use libfuzzer_sys::fuzz_target;

const PROGRAM: &[u8] = b"%\nO1\nG21 G90 G54\nT1 M6\nG43 H1 G0 X0 Y0 Z5.\nS900 M3\nG1 Z-1. F100.\n\
    G41 D1 X10. Y#500\nG2 X12. Y2. I2. J0\nG40 X0\nG83 Z-2. R1. Q.5\nG80\nM98 P2\nG28 Z0\nM30\nO2\nG4 P1\nM99\n%\n";

const LATHE: &[u8] =
    b"%\nO1\nG21 G90 G54\nT0101\nG50 S2000\nG96 S100 M3\nG0 X20. Z2.\nG42 G1 Z-5. F.1\nX30.\n\
    G40 G0 X50.\nG76 P010060 Q50 R20\nM30\n%\n";

fuzz_target!(|input: (u8, &[u8])| {
    let (choice, bytes) = input;
    let named = |name: &str| (PathBuf::from(name), bytes.to_vec());
    let base = ["haas-vf2", "fanuc-lathe", "linuxcnc-mill", "grbl", "fadal-4020"]
        [usize::from(choice >> 3) % 5];
    let program = if base == "fanuc-lathe" { LATHE } else { PROGRAM };
    let mut request = Request { max_blocks: Some(2_000), ..Request::default() };
    let on = |name: &str| Some(RequestedMachine::Name(name.to_string()));
    let mut files = Vec::new();
    let above = |keys: &str| format!("{keys} = \"{base}\"\n").into_bytes();
    match choice % 8 {
        0 => {
            files.push(named("own.toml"));
            request.machine = on("own.toml");
        }
        1 => {
            files.push(("own.toml".into(), [above("inherits"), bytes.to_vec()].concat()));
            request.machine = on("own.toml");
        }
        2 => {
            files.push(("setup.toml".into(), [above("machine"), bytes.to_vec()].concat()));
            request.machine = on("setup.toml");
        }
        3 => {
            let setup = b"[stock]\nshape = \"stl\"\nfile = \"any.stl\"\n[fixtures.vise]\nshape = \"dxf\"\nfile = \"any.dxf\"\n";
            files.push(("setup.toml".into(), [above("machine"), setup.to_vec()].concat()));
            files.push(named("any.stl"));
            files.push(named("any.dxf"));
            request.machine = on("setup.toml");
        }
        4 => {
            files.push(named("dump.txt"));
            request.settings = Some("dump.txt".into());
            request.machine = on("grbl");
        }
        5 => {
            files.push(named("tool.tbl"));
            request.tools = Some("tool.tbl".into());
            request.machine = on(base);
        }
        6 => {
            files.extend([named("any.var"), named("macro.txt"), named("O2.nc")]);
            request.machine = on(base);
        }
        _ => files.extend([named("chordal.toml"), named("O2.nc")]),
    }
    let given = FileAccess::in_memory(files.clone());
    request.files = given.clone();
    if let Ok(text) = std::str::from_utf8(bytes) {
        let mut machine = Machine::from_builtin(base).expect("a built-in machine");
        for line in text.lines() {
            let _ = machine.set(line);
            let _ = parse_quantity(line, QuantityDimension::Length);
        }
    }
    let Ok(mut loader) = Loader::new(request) else { return };
    let input = ProgramInput { path: Some("part.nc".into()), root: None };
    let text = ProgramText::of("part.nc", program.to_vec()).expect("a short text");
    let Ok(loaded) = loader.load_text(text, &input) else { return };
    let Ok(job) = loaded.job() else { return };
    let report = job.report();
    assert!(report.summary.feed_length_mm.is_finite());
    let read = |name: &str| given.bytes(&PathBuf::from(name)).map_err(|error| error.to_string());
    let options = StockOptions { budget: 1 << 22, ..StockOptions::default() };
    let _ = job.stock(&options, &read);
    let _ = job.turned_stock(&Default::default(), &read);
});
