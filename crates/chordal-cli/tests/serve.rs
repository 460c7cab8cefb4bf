//! `chordal serve` and `chordal stream`: other programs ask and listen.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "the tests of a shell have its files and processes"
)]

mod common;

use std::io::{BufRead, BufReader, Write};
use std::net::TcpStream;
use std::process::{Child, ChildStdin, ChildStdout, Stdio};
use std::time::Duration;

use common::{BROKEN, CLEAN, Folder};
use serde_json::{Value, json};

/// A service that is asked.
struct Service {
    child: Child,
    questions: Option<ChildStdin>,
    answers: BufReader<ChildStdout>,
}

impl Service {
    fn of(folder: &Folder) -> Service {
        let mut command = folder.command(&["serve", "--stdio"]);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut child = command.spawn().expect("the command");
        let questions = child.stdin.take();
        let answers = BufReader::new(child.stdout.take().expect("its output"));
        let mut service = Service { child, questions, answers };
        assert_eq!(service.hear()["protocol"], "chordal.serve/1");
        service
    }

    fn say(&mut self, line: impl AsRef<[u8]>) {
        let questions = self.questions.as_mut().expect("its input");
        questions.write_all(line.as_ref()).and_then(|()| questions.write_all(b"\n")).unwrap();
    }

    fn hear(&mut self) -> Value {
        let mut line = String::new();
        self.answers.read_line(&mut line).expect("a line");
        serde_json::from_str(&line).unwrap_or_else(|error| panic!("{error}: {line}"))
    }

    fn ask(&mut self, question: &Value) -> Value {
        self.say(question.to_string());
        self.hear()
    }

    fn end(mut self) {
        self.questions.take();
        assert!(self.child.wait().expect("it ends").success());
    }
}

#[test]
fn answers_are_those_of_the_command() {
    let folder = Folder::with_part();
    folder.write("bad.nc", BROKEN);
    let mut service = Service::of(&folder);
    let program = json!({ "file": "bad.nc", "machine": "haas-vf2" });
    let answer = service.ask(&json!({ "id": 1, "ask": "check", "program": program }));
    assert_eq!(answer["id"], 1);
    let command = ["check", "bad.nc", "-m", "haas-vf2", "--format", "json"];
    let command: Value = serde_json::from_str(&folder.run(&command).out).unwrap();
    assert_eq!(answer["answer"], command["files"][0]);

    let time =
        json!({ "id": "t", "ask": "time", "program": { "text": CLEAN, "machine": "haas-vf2" } });
    let command = ["time", "part.nc", "-m", "haas-vf2", "--format", "json"];
    let command: Value = serde_json::from_str(&folder.run(&command).out).unwrap();
    assert_eq!(service.ask(&time)["answer"]["total_s"], command["total_s"]);

    let path = json!({ "ask": "path", "program": { "text": CLEAN, "machine": "haas-vf2" } });
    let path = service.ask(&path);
    let column = |name: &str| {
        let columns = path["answer"]["columns"].as_array().unwrap();
        columns.iter().find(|column| column["name"] == name).unwrap()["values"].clone()
    };
    let rows = path["answer"]["rows"].as_u64().unwrap() as usize;
    let (kinds, lines) = (column("kind"), column("line"));
    assert_eq!((kinds.as_array().unwrap().len(), lines.as_array().unwrap().len()), (rows, rows));
    let arc = kinds.as_array().unwrap().iter().position(|kind| kind == "arc").unwrap();
    assert_eq!(lines[arc], 9);
    // Half an inch of radius; lines have none.
    let radii = column("radius_from_mm");
    assert!((radii[arc].as_f64().unwrap() - 12.7).abs() < 1e-9 && radii[arc + 1].is_null());

    let github = json!({ "ask": "check", "program": program, "options": { "format": "github" } });
    assert!(service.ask(&github)["answer"].as_str().unwrap().starts_with("::error file=bad.nc"));
    let both = json!({ "ask": "compare", "programs": [{ "text": CLEAN }, { "file": "part.nc" }] });
    assert_eq!(service.ask(&both)["error"], Value::Null);
    service.end();
}

#[test]
fn what_is_no_question_is_answered_and_the_next_one_too() {
    let folder = Folder::with_part();
    let mut service = Service::of(&folder);
    let deep = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
    for (line, kind, said) in [
        ("nonsense", "use", "not JSON"),
        ("[1,2]", "use", "not a question"),
        (deep.as_str(), "use", "not JSON"),
        ("\u{1}\u{2}", "use", "not JSON"),
        (r#"{"id":1}"#, "use", "either `ask` or `cancel`"),
        (r#"{"id":1,"ask":"check","cancel":2}"#, "use", "either `ask` or `cancel`"),
        (r#"{"id":1,"ask":"what"}"#, "use", "there is no question `what`"),
        (r#"{"id":1,"ask":"check"}"#, "use", "there is no program"),
        (r#"{"id":1,"ask":"check","program":{}}"#, "use", "`file` or its `text`"),
        (
            r#"{"id":1,"ask":"check","program":{"file":7}}"#,
            "use",
            "`file` of a program is not a text",
        ),
        (r#"{"id":1,"ask":"check","program":{"file":"no.nc"}}"#, "file", "cannot read no.nc"),
        (r#"{"id":1,"ask":"check","program":{"file":"part.nc","maschine":""}}"#, "use", "maschine"),
        (r#"{"id":1,"ask":"check","program":{"file":"part.nc","machine":"haas"}}"#, "use", "haas"),
        (r#"{"id":1,"ask":"time","options":{"speed":1},"program":{"text":"M30"}}"#, "use", "speed"),
        (
            r#"{"id":1,"ask":"check","watch":true,"program":{"text":"M30"}}"#,
            "use",
            "no file to watch",
        ),
        (r#"{"id":{},"ask":"machines"}"#, "use", "`id` is not a number or a text"),
        (r#"{"id":1,"ask":"panic"}"#, "chordal", "asked to panic"),
    ] {
        service.say(line);
        let error = &service.hear()["error"];
        let message = error["message"].as_str().unwrap_or_default();
        assert!(message.contains(said), "{line:.60}: {error}");
        assert_eq!(error["kind"], kind, "{line:.60}: {error}");
    }
    service.say([0xff, 0xfe]);
    assert_eq!(service.hear()["error"]["kind"], "use");
    service.say("\n\n");
    let answer = service.ask(&json!({ "id": 9, "ask": "check", "program": { "file": "part.nc" } }));
    assert_eq!((&answer["id"], &answer["error"]), (&json!(9), &Value::Null));
    service.end();
}

#[test]
fn a_watched_file_is_answered_again() {
    let folder = Folder::with_part();
    let mut service = Service::of(&folder);
    let program = json!({ "file": "part.nc", "machine": "haas-vf2" });
    let question = json!({ "id": 5, "ask": "check", "program": program, "watch": true });
    let errors = |answer: &Value| answer["answer"]["counts"]["errors"].as_u64();
    let first = service.ask(&question);
    assert_eq!((errors(&first), &first["again"]), (Some(0), &Value::Null), "{first}");
    folder.write("part.nc", BROKEN);
    let second = service.hear();
    assert_eq!((errors(&second), &second["again"]), (Some(1), &json!(1)), "{second}");
    std::fs::remove_file(folder.path("part.nc")).unwrap();
    let gone = service.hear();
    assert_eq!((&gone["error"]["kind"], &gone["again"]), (&json!("file"), &json!(2)), "{gone}");
    folder.write("part.nc", CLEAN);
    assert_eq!(errors(&service.hear()), Some(0));
    assert_eq!(service.ask(&json!({ "cancel": 5 })), json!({ "id": 5, "cancelled": true }));
    assert_eq!(service.ask(&json!({ "cancel": 5 })), json!({ "id": 5, "cancelled": false }));
    folder.write("part.nc", BROKEN);
    let other = service.ask(&json!({ "id": 6, "ask": "check", "program": program }));
    assert_eq!((&other["id"], errors(&other)), (&json!(6), Some(1)));
    service.end();
}

/// A stream that is listened to until it ends.
fn listen(folder: &Folder, program: &str) -> (Vec<String>, Option<i32>) {
    let arguments =
        ["stream", program, "-m", "haas-vf2", "--port", "0", "--rate", "200", "--period", "2ms"];
    let mut command = folder.command(&arguments);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
    let mut child = command.spawn().expect("the command");
    let mut address = String::new();
    let mut out = BufReader::new(child.stdout.take().expect("its output"));
    out.read_line(&mut address).unwrap();
    let mut stream = TcpStream::connect(address.trim()).expect("it listens");
    stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    stream.write_all(b"nonsense\n* PING\n").unwrap();
    let lines = BufReader::new(stream).lines().map_while(Result::ok).collect();
    (lines, child.wait().expect("it ends").code())
}

#[test]
fn a_stream_goes_where_the_program_goes() {
    let folder = Folder::with_part();
    let (lines, code) = listen(&folder, "part.nc");
    assert_eq!(code, Some(0));
    assert!(lines.iter().any(|line| line == "* PONG 10000"), "{lines:?}");
    let mut last = std::collections::BTreeMap::new();
    let mut blocks = Vec::new();
    for line in lines.iter().filter(|line| !line.starts_with('*')) {
        let fields: Vec<&str> = line.split('|').collect();
        if fields[1] == "logic" {
            assert_eq!(fields[2], "NORMAL", "{line}");
            continue;
        }
        assert!(
            fields[0].len() == 24 && fields[0].ends_with('Z') && fields.len() % 2 == 1,
            "{line}"
        );
        for pair in fields[1..].chunks(2) {
            if pair[0] == "block" {
                blocks.push(pair[1].to_string());
            }
            last.insert(pair[0].to_string(), pair[1].to_string());
        }
    }
    // The square ends where it began, a tenth of an inch above.
    let end = ["Xact", "Yact", "Zact", "path_feedrate", "execution", "avail", "program"];
    let end = end.map(|key| last.get(key).map_or("", String::as_str));
    assert_eq!(end, ["0", "0", "2.54", "0", "PROGRAM_COMPLETED", "AVAILABLE", "part.nc"]);
    assert!(blocks.iter().any(|block| block == "G3 X0 Y1. I-.5 J0"), "{blocks:?}");
}

#[test]
fn a_fault_is_a_condition() {
    let folder = Folder::new();
    folder.write("bad.nc", BROKEN);
    let (lines, code) = listen(&folder, "bad.nc");
    assert_eq!(code, Some(1));
    let fault = lines.iter().find(|line| line.contains("|logic|")).expect("a condition");
    assert!(fault.contains("|logic|FAULT|CH401|||line 6: "), "{fault}");
    for (arguments, said) in [
        (&["stream", "bad.nc", "--rate", "0"][..], "a rate of 0"),
        (&["stream", "bad.nc", "--period", "1us"], "below 1 ms"),
        (&["stream", "no.nc"], "no.nc"),
        (&["serve"], "--stdio"),
    ] {
        folder.run(arguments).ends(2).complains(&[said]);
    }
}
