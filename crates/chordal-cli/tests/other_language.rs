//! A language that is no word-address goes through everything: it is recognized and loaded, checked, run, planned, cut
//! from stock, edited, shown on the page, reported, compared and archived. What rewrites blocks refuses it, each with
//! the same sentence.
//!
//! The language is the made-up one of `chordal-kernel/tests/made_up`, registered as an application would do it.

#![allow(clippy::disallowed_methods, reason = "the test of a shell has its files")]

#[path = "../../chordal-kernel/tests/made_up/language.rs"]
mod language;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, Once};
use std::thread;

use arrow_array::cast::AsArray as _;
use chordal::control::register_language;
use chordal::{Code, Job, Machine, RunOptions, SegmentKind, Severity, Source, SourceMap};
use chordal_editor::{EditorProgram, EditorSetup};
use chordal_load::{Loader, ProgramInput, Request};
use chordal_lsp::SetupFinder;
use chordal_rewrite::{SplitBy, TransformStep, convert, restart, split, transform};
use chordal_view::{
    ListedMachine, PageOutbox, PagePort, ProgramRefusal, ProgramSource, ProgramView, WorkItem,
};
use language::LinesLanguage;
use lsp_server::{Connection, Message, Notification, Request as LspRequest};
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use serde_json::{Value, json};

/// One hole and a step along the front of a block of 60 x 40 x 10 mm; the step is in a file of its own.
const PART: &str = "\
NOTE BRACKET, SIDE 2
TOOL 1
TURN 3000
FEED 600
RAPID -10 0 5
PART step
DRILL 30 20 DEPTH -8 FROM 2
END
";

const STEP: &str = "\
RAPID -10 0 -2
CUT 70 0 -2
RAPID 70 0 5
";

const SETUP: &str = r#"
name = "lines-mill"
title = "A mill that reads lines"
control = "made-up"

[axes.X]
max_velocity = "24 m/min"
[axes.Y]
max_velocity = "24 m/min"
[axes.Z]
max_velocity = "24 m/min"

[work_offsets.G54]
X = "0 mm"
Y = "0 mm"
Z = "0 mm"

[stock]
shape = "box"
from = { X = "0 mm", Y = "0 mm", Z = "-10 mm" }
to   = { X = "60 mm", Y = "40 mm", Z = "0 mm" }

[tools.1]
shape = "flat"
diameter = "10 mm"
flute_length = "30 mm"
"#;

/// The sentence with which everything that rewrites blocks refuses the language.
const REFUSAL: &str = "programs for Made up are not made of word-address blocks";

/// A folder with the program, its subprogram and the file of its machine.
struct Shop {
    folder: tempfile::TempDir,
}

impl Shop {
    fn new() -> Shop {
        static REGISTERED: Once = Once::new();
        REGISTERED.call_once(|| {
            LinesLanguage::control();
            register_language(&LinesLanguage);
        });
        let folder = tempfile::tempdir().expect("a folder");
        let shop = Shop { folder };
        for (name, text) in [("part.lines", PART), ("step.lines", STEP), ("mill.toml", SETUP)] {
            fs::write(shop.path(name), text).expect("a file");
        }
        shop
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn machine(&self) -> Machine {
        Machine::from_toml("mill.toml", SETUP, &|_| Err("no other file".into())).expect("a machine")
    }

    /// The exit code of a command. A word that ends in an extension of the shop's files is one of them.
    fn run(&self, command: &str) -> u8 {
        let is_file = |word: &str| {
            [".lines", ".toml", ".svg", ".csv", ".stl", ".html", ".txt", ".parquet"]
                .iter()
                .any(|extension| word.ends_with(extension))
        };
        let word = |word: &str| match word {
            "." => self.folder.path().into(),
            word if is_file(word) => self.path(word).into_os_string(),
            word => word.into(),
        };
        chordal_cli::run(["chordal"].into_iter().chain(command.split(' ')).map(word))
    }

    fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn job(&self, text: &'static str) -> Job<'static> {
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.lines", text.as_bytes()));
        sources.add(Source::new("step.lines", STEP.as_bytes()));
        Job::new(sources, self.machine()).expect("a job")
    }

    fn program(&self, text: &str) -> EditorProgram {
        EditorProgram::set_up("part.lines", text.into(), self.setup()).expect("a program")
    }

    fn setup(&self) -> EditorSetup {
        let subprogram_texts = vec![("step.lines".to_string(), STEP.into())];
        EditorSetup { subprogram_texts, ..EditorSetup::of(self.machine()) }
    }
}

#[test]
fn it_is_recognized_and_its_subprograms_are_found() {
    let shop = Shop::new();
    let mut loader = Loader::new(Request::default()).expect("a loader");
    let input = ProgramInput { path: Some(shop.path("part.lines")), root: None };
    let loaded = loader.load(&input).expect("a program");
    assert_eq!(loaded.control(), "made-up");
    let why = loaded.why().expect("a reason");
    assert_eq!(why, "recognized as Made up by line 5 (a line begins with RAPID or CUT)");
    let job = loaded.job().expect("a job");
    assert_eq!(job.sources().iter().count(), 2, "the step is in another file");
    let report = job.check();
    assert!(report.outcomes[0].missing_programs.is_empty());
    let errors: Vec<_> =
        report.diagnostics.iter().filter(|found| found.severity == Severity::Error).collect();
    assert!(errors.is_empty(), "{errors:?}");
}

#[test]
fn a_fault_is_found_with_the_words_of_the_control() {
    let shop = Shop::new();
    let job = shop.job("TURN 900\nFEED 600\nRAPID 0 0 5\nCUT 0 0 -1\nRIGHT 20 0 ABOUT 14 0\nEND\n");
    let report = job.check();
    let fault = report.diagnostics.iter().find(|found| found.code == Code::RadiusMismatch);
    let fault = fault.expect("the radii differ");
    assert!(fault.alarm.as_deref().expect("an alarm").starts_with("Made up: THIS IS NO CIRCLE"));
    fs::write(shop.path("wrong.lines"), "RAPID 0 0 5\nJUMP 1 2 3\nEND\n").expect("a file");
    assert_eq!(shop.run("check wrong.lines --machine mill.toml"), 1);
    assert_eq!(shop.run("check part.lines --machine mill.toml"), 0);
}

#[test]
fn it_runs_is_planned_and_cuts_stock() {
    let shop = Shop::new();
    assert_eq!(shop.run("run part.lines --machine mill.toml -o part.svg"), 0);
    assert!(shop.text("part.svg").contains("<svg"));
    assert_eq!(shop.run("path part.lines --machine mill.toml -o path.csv"), 0);
    assert!(shop.text("path.csv").lines().count() > 8);
    assert_eq!(shop.run("time part.lines --machine mill.toml -o time.svg"), 0);
    assert_eq!(shop.run("stock part.lines --machine mill.toml -o left.stl"), 0);
    assert!(fs::metadata(shop.path("left.stl")).expect("a body").len() > 1000);

    let job = shop.job(PART);
    let mut cut_mm = 0.0;
    job.path(|segment| {
        if segment.kind != SegmentKind::Rapid {
            cut_mm += segment.length_mm;
        }
    });
    // 80 mm along the front, and the hole from 2 to -8.
    assert!((cut_mm - 90.0).abs() < 1e-9, "{cut_mm}");
}

#[test]
fn an_editor_colours_explains_completes_and_formats_it() {
    let shop = Shop::new();
    let program = shop.program(PART);
    assert_eq!(program.tokens(1, u32::MAX).len(), 8);
    let at = PART.find("DRILL").expect("a line") as u32;
    assert_eq!(program.hover(at, None).expect("a meaning").text, "**drills a hole**");
    let moved = program.hover(at, Some(&program.ran())).expect("a meaning").text;
    assert!(moved.contains("This line moves"), "{moved}");
    assert_eq!(program.outline()[0].name, "TOOL 1");
    assert!(program.completions(0).1.iter().any(|word| word.text == "RAPID"));
    let state = program.modal_after(4).expect("a state");
    assert_eq!((state.tool, state.rpm, state.feed), (1, 3000.0, Some(10.0)));
    let wide = shop.program("RAPID   0  0 5\nEND\n");
    let edits = wide.spaced(1, u32::MAX).expect("it moves the same");
    assert_eq!(wide.edited(&edits), b"RAPID 0 0 5\nEND\n");
    assert!(program.occurrences().is_empty() && program.rename(at, "X").is_err());
}

/// A finder that gives the machine of the shop to every text.
struct ShopFinder(EditorSetup);

impl SetupFinder for ShopFinder {
    fn open(&self, _: Option<&Path>, _: &[u8], _: Option<&str>) -> Result<EditorSetup, String> {
        Ok(self.0.clone())
    }
}

#[test]
fn a_language_server_answers_about_it() {
    let finder = ShopFinder(Shop::new().setup());
    let (server, client) = Connection::memory();
    let server = thread::spawn(move || chordal_lsp::serve(&server, &finder).map_err(drop));
    let tell = |method: &str, params: Value| {
        client.sender.send(Notification::new(method.into(), params).into()).expect("it listens");
    };
    let ask = |id: i32, method: &str, params: Value| {
        client
            .sender
            .send(LspRequest::new(id.into(), method.into(), params).into())
            .expect("it listens");
        loop {
            match client.receiver.recv().expect("an answer") {
                Message::Response(answer) if answer.id == id.into() => {
                    return serde_json::to_value(answer).expect("JSON")["result"].clone();
                }
                _ => {}
            }
        }
    };
    ask(1, "initialize", json!({ "capabilities": {} }));
    tell("initialized", json!({}));
    let text =
        json!({ "uri": "file:///part.lines", "languageId": "nc", "version": 1, "text": PART });
    tell("textDocument/didOpen", json!({ "textDocument": text }));
    let document = json!({ "uri": "file:///part.lines" });
    let tokens = ask(2, "textDocument/semanticTokens/full", json!({ "textDocument": document }));
    assert_eq!(tokens["data"].as_array().expect("tokens").len(), 8 * 5);
    let place = json!({ "textDocument": document, "position": { "line": 1, "character": 1 } });
    let hover = ask(3, "textDocument/hover", place.clone());
    assert!(hover["contents"].to_string().contains("changes the tool"), "{hover}");
    let symbols = ask(4, "textDocument/documentSymbol", json!({ "textDocument": document }));
    assert_eq!(symbols[0]["name"], "TOOL 1");
    let words = ask(5, "textDocument/completion", place);
    assert!(words.to_string().contains("DRILL"), "{words}");
    ask(6, "shutdown", Value::Null);
    tell("exit", Value::Null);
    assert!(server.join().is_ok());
}

/// The program of the page.
struct PageProgram(EditorSetup);

impl ProgramSource for PageProgram {
    fn name(&self) -> String {
        "part.lines".into()
    }

    fn read(&self) -> Result<Vec<u8>, ProgramRefusal> {
        Ok(PART.into())
    }

    fn open(&self, text: Vec<u8>, _: Option<&str>) -> Result<EditorProgram, ProgramRefusal> {
        Ok(EditorProgram::set_up("part.lines", text, self.0.clone()).expect("a program"))
    }

    fn machines(&self) -> Vec<ListedMachine> {
        Vec::new()
    }
}

/// The messages to the page: texts, and the number of columns.
#[derive(Clone, Default)]
struct PageMessages(Arc<Mutex<(Vec<Value>, usize)>>);

impl PagePort for PageMessages {
    fn text(&self, text: String) {
        let message = serde_json::from_str(&text).expect("JSON");
        self.0.lock().expect("one thread").0.push(message);
    }

    fn binary(&self, _: Vec<u8>) {
        self.0.lock().expect("one thread").1 += 1;
    }

    fn binary_later(&self, frame: Vec<u8>) {
        self.binary(frame);
    }
}

#[test]
fn the_page_shows_its_path() {
    let sent = PageMessages::default();
    let view =
        ProgramView::new(Arc::new(PageProgram(Shop::new().setup())), PageOutbox::new(sent.clone()));
    let mut work: Vec<WorkItem> = Vec::new();
    assert!(view.begin(&mut |item| work.push(item)));
    view.send_text();
    while let Some(item) = work.pop() {
        view.work(item, &mut |next| work.push(next));
    }
    let request = json!({ "id": 1, "request": "outline" });
    view.answer(serde_json::from_value(request).expect("a request"), &mut |_| {});
    let (texts, frames) = &*sent.0.lock().expect("one thread");
    assert!(*frames > 0, "columns of the path");
    let all = Value::from(texts.clone()).to_string();
    assert!(all.contains("Made up") && all.contains("TOOL 1"), "{all}");
}

#[test]
fn it_is_reported_compared_and_archived() {
    let shop = Shop::new();
    assert_eq!(shop.run("report part.lines --machine mill.toml -o sheet.html"), 0);
    let sheet = shop.text("sheet.html");
    assert!(sheet.contains("Made up") && sheet.contains("BRACKET, SIDE 2"), "{sheet}");
    assert_eq!(shop.run("compare part.lines part.lines --machine mill.toml"), 0);
    fs::write(shop.path("deep.lines"), PART.replace("DEPTH -8", "DEPTH -9")).expect("a file");
    assert_eq!(shop.run("compare part.lines deep.lines --machine mill.toml"), 1);
    fs::write(shop.path("chordal.toml"), "machine = \"mill.toml\"\n").expect("a file");
    // The step alone has no spindle and no feed: it is a program of its own here.
    assert_eq!(shop.run("archive check . --out all.parquet"), 1);
    let bytes = fs::read(shop.path("all.parquet")).expect("a table");
    let rows =
        ParquetRecordBatchReaderBuilder::try_new(bytes::Bytes::from(bytes)).expect("a table");
    let rows = rows.build().expect("rows").next().expect("rows").expect("rows");
    let column = |name: &str| rows[name].as_string::<i32>().clone();
    let (paths, controls, states) = (column("path"), column("control"), column("status"));
    let row = (0..rows.num_rows()).find(|row| paths.value(*row).ends_with("part.lines"));
    let row = row.expect("a row");
    assert_eq!((controls.value(row), states.value(row)), ("made-up", "ok"));
}

#[test]
fn what_rewrites_blocks_refuses_it_with_one_sentence() {
    let shop = Shop::new();
    let job = shop.job(PART);
    let haas = Machine::from_builtin("haas-vf2").expect("a machine");
    let options = convert::ConversionOptions::default();
    let mut refusals = vec![
        transform(&job, &[TransformStep::Shift([1.0, 0.0, 0.0])]).unwrap_err().what,
        restart::restart(&job, 3).unwrap_err().refusal.what,
        restart::prove_head(&job, 3, b"END").unwrap_err().refusal.what,
        split(&job, SplitBy::Tool).map(drop).unwrap_err().what,
    ];
    // Nothing is converted to it either.
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", b"G21 G90 S900 M3\nG1 X0 Y0 F600.\nM30\n".as_slice()));
    let blocks = Job::new(sources, haas).expect("a job").options(RunOptions::default());
    refusals.push(convert::convert(&blocks, &shop.machine(), &options).refusals[0].reason.clone());
    for refusal in refusals {
        assert!(refusal.starts_with(REFUSAL), "{refusal}");
    }
    for command in [
        "transform part.lines --machine mill.toml --shift X1mm -o new.txt",
        "restart part.lines --machine mill.toml --line 5 -o new.txt",
        "optimize part.lines --machine mill.toml -o new.txt",
    ] {
        assert_ne!(shop.run(command), 0, "{command}");
        assert!(!shop.path("new.txt").exists(), "{command}");
    }
}

#[test]
fn it_is_converted_to_blocks_by_its_run() {
    let shop = Shop::new();
    let job = shop.job(PART);
    let haas = Machine::from_builtin("haas-vf2").expect("a machine");
    let found = convert::convert(&job, &haas, &convert::ConversionOptions::default());
    assert!(found.holds(), "{:?}\n{}", found.refusals, found.text);
    assert!(found.text.contains("T1 M6") && found.text.contains("G98 G81"), "{}", found.text);
    let command = "convert part.lines --machine mill.toml --to haas-vf2 -o new.txt";
    assert_eq!(shop.run(command), 0);
    assert_eq!(shop.text("new.txt"), found.text);
}
