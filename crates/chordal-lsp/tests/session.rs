//! A client uses every feature of the server.

#![allow(clippy::disallowed_methods, reason = "the client stands on the other side of a thread")]

use std::path::Path;
use std::sync::Arc;
use std::thread::{self, JoinHandle};

use chordal::{Machine, ShopAnswer, ShopCall};
use chordal_editor::EditorSetup;
use chordal_lsp::{SetupFinder, serve};
use lsp_server::{Connection, Message, Notification, Request, RequestId};
use serde_json::{Value, json};

/// Every text runs on one machine, or on the one in the settings.
struct Typical;

impl SetupFinder for Typical {
    fn open(
        &self,
        _: Option<&Path>,
        text: &[u8],
        machine: Option<&str>,
    ) -> Result<EditorSetup, String> {
        let machine = Machine::from_builtin(machine.unwrap_or("haas-vf2"))
            .map_err(|_| "there is no such machine".to_string())?;
        let why = Some("taken for a Haas".to_string());
        let beside = vec![("/shop/O77.nc".to_string(), b"%\n(BESIDE)\nO77\nM99\n".to_vec())];
        let mut setup = EditorSetup { why, subprogram_texts: beside, ..EditorSetup::of(machine) };
        if text.windows(FAILS.len()).any(|word| word == FAILS.as_bytes()) {
            setup.options.shop_codes = Some(Arc::new(fails));
        }
        assert!(!text.starts_with(OPENING_FAILS), "a made-up failure");
        Ok(setup)
    }
}

/// Running this code panics, to simulate a defect in Chordal.
const FAILS: &str = "M777";
/// Opening a text that begins with this panics too.
const OPENING_FAILS: &[u8] = b"(OPENING FAILS)";

fn fails(call: &ShopCall<'_>) -> ShopAnswer {
    assert_ne!(call.code.to_string(), FAILS, "a made-up failure");
    ShopAnswer::NotMine
}

/// The editor's end of the connection.
struct Editor {
    connection: Connection,
    server: JoinHandle<()>,
    next: i32,
    notices: Vec<Notification>,
    capabilities: Value,
}

const URI: &str = "file:///shop/part.nc";

impl Editor {
    fn start(settings: Value) -> Editor {
        let (server, connection) = Connection::memory();
        let server = thread::spawn(move || {
            serve(&server, &Typical).expect("the client keeps to the protocol");
        });
        let mut editor =
            Editor { connection, server, next: 0, notices: Vec::new(), capabilities: Value::Null };
        let params = json!({ "capabilities": {}, "initializationOptions": settings });
        let answer = editor.ask("initialize", params).expect("an answer");
        assert_eq!(answer["serverInfo"]["name"], "chordal");
        editor.capabilities = answer["capabilities"].clone();
        editor.tell("initialized", json!({}));
        editor
    }

    fn tell(&self, method: &str, params: Value) {
        let notice = Notification::new(method.into(), params);
        self.connection.sender.send(notice.into()).expect("the server listens");
    }

    fn ask(&mut self, method: &str, params: Value) -> Result<Value, String> {
        self.next += 1;
        let id = RequestId::from(self.next);
        let request = Request::new(id.clone(), method.into(), params);
        self.connection.sender.send(request.into()).expect("the server listens");
        loop {
            match self.receive() {
                Message::Response(answer) if answer.id == id => {
                    return answer.response_kind_or_error();
                }
                Message::Notification(notice) => self.notices.push(notice),
                _ => {}
            }
        }
    }

    fn receive(&self) -> Message {
        let limit = std::time::Duration::from_secs(60);
        self.connection.receiver.recv_timeout(limit).expect("an answer within a minute")
    }

    /// Sends a request about the only document.
    fn of(&mut self, method: &str, more: Value) -> Result<Value, String> {
        let mut params = json!({ "textDocument": { "uri": URI } });
        for (key, value) in more.as_object().expect("an object") {
            params[key] = value.clone();
        }
        self.ask(&format!("textDocument/{method}"), params)
    }

    fn open(&self, text: &str) {
        let item = json!({ "uri": URI, "languageId": "nc", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": item }));
    }

    fn change(&self, version: i32, range: Value, text: &str) {
        let change = json!({ "range": range, "text": text });
        self.tell(
            "textDocument/didChange",
            json!({ "textDocument": { "uri": URI, "version": version }, "contentChanges": [change] }),
        );
    }

    /// Waits for the problems of a version.
    fn problems(&mut self, version: i32) -> Vec<Value> {
        loop {
            let notices = std::mem::take(&mut self.notices);
            let told = notices.into_iter().rev().find_map(|notice| {
                let mine = notice.method == "textDocument/publishDiagnostics"
                    && notice.params["version"] == version;
                mine.then(|| notice.params["diagnostics"].as_array().cloned().expect("a list"))
            });
            if let Some(told) = told {
                return told;
            }
            if let Message::Notification(notice) = self.receive() {
                self.notices.push(notice);
            }
        }
    }

    /// Waits until the server requests a refresh of the inlay hints, because the moves of the lines are known.
    fn ran(&mut self) {
        loop {
            match self.receive() {
                Message::Request(request) if request.method == "workspace/inlayHint/refresh" => {
                    return;
                }
                Message::Notification(notice) => self.notices.push(notice),
                _ => {}
            }
        }
    }

    /// Waits for a notification and keeps the others.
    fn wait(&mut self, method: &str, wanted: impl Fn(&Value) -> bool) {
        loop {
            let Message::Notification(notice) = self.receive() else { continue };
            if notice.method == method && wanted(&notice.params) {
                return;
            }
            self.notices.push(notice);
        }
    }

    fn end(mut self) {
        self.ask("shutdown", Value::Null).expect("an answer");
        self.tell("exit", Value::Null);
        self.server.join().expect("the server ends");
    }
}

trait Kind {
    fn response_kind_or_error(self) -> Result<Value, String>;
}

impl Kind for lsp_server::Response {
    fn response_kind_or_error(self) -> Result<Value, String> {
        let text = serde_json::to_value(&self).expect("a message");
        match text.get("error") {
            Some(error) => Err(error["message"].as_str().unwrap_or_default().to_string()),
            None => Ok(text.get("result").cloned().unwrap_or(Value::Null)),
        }
    }
}

fn place(line: u32, character: u32) -> Value {
    json!({ "position": { "line": line, "character": character } })
}

fn range(from: (u32, u32), to: (u32, u32)) -> Value {
    json!({
        "start": { "line": from.0, "character": from.1 },
        "end": { "line": to.0, "character": to.1 },
    })
}

const PART: &str = "%\nO100 (PLATE)\nT1 M6 (MILL)\nG20 G90 G54 S900 M3\n#101=2.\nG0 X0 Y0\n\
                    N10 G1 X#101 F20.\nG2 X3. Y1. I0 J1.\nIF[#101GT5]GOTO10\nM98 P200\nM30\n\
                    O200\nM99\n%\n";

/// The editor answers a request of the server before it reads the answer to `shutdown`.
#[test]
fn what_comes_in_between_shutdown_and_exit_is_passed_over() {
    let mut editor = Editor::start(Value::Null);
    editor.ask("shutdown", Value::Null).expect("an answer");
    let late = lsp_server::Response::new_ok(RequestId::from(1), Value::Null);
    editor.connection.sender.send(late.into()).expect("the server listens");
    editor.tell("$/setTrace", json!({ "value": "off" }));
    let refused = editor.of("hover", place(0, 0)).unwrap_err();
    assert_eq!(refused, "the server is shutting down");
    editor.tell("exit", Value::Null);
    editor.server.join().expect("the server ends");
}

#[test]
fn problems_come_and_go_as_one_types() {
    let mut editor = Editor::start(json!({}));
    editor.open("G20 G90\nG1 X1. F20.\nM30\n");
    let first = editor.problems(1);
    assert!(first.iter().all(|problem| problem["severity"] != 1), "{first:?}");
    // The end of the arc is off by 0.5 in.
    editor.change(2, range((1, 0), (1, 0)), "G1 X0 Y0 F20.\nG2 X1. Y0 I.25 J0\n");
    let wrong = editor.problems(2);
    let arc = wrong.iter().find(|problem| problem["severity"] == 1).expect("an error");
    assert_eq!(arc["range"]["start"]["line"], 2);
    let message = arc["message"].as_str().expect("a text");
    assert!(message.contains("0.5 in") && message.contains("The control shows"), "{message}");
    editor.change(3, range((2, 11), (2, 14)), ".5");
    let mended = editor.problems(3);
    assert!(mended.iter().all(|problem| problem["severity"] != 1), "{mended:?}");
    editor.end();
}

/// First and last line, from 0, of what can be folded in that text: O100, T1, N10 and O200.
const FOLDED_LINES: [(u64, u64); 4] = [(1, 10), (2, 10), (6, 10), (11, 13)];

#[test]
fn every_question_has_its_answer() {
    let mut editor = Editor::start(json!({}));
    editor.open(PART);
    editor
        .wait("window/logMessage", |params| params["message"] == "/shop/part.nc: taken for a Haas");
    editor.problems(1);
    editor.ran();

    let hover = editor.of("hover", place(7, 1)).expect("a hover");
    let text = hover["contents"]["value"].as_str().expect("a text");
    // Three quarters of a circle of radius 1 in, and the modal state after it.
    assert!(text.contains("clockwise") && text.contains("4.7124 in"), "{text}");
    assert!(text.contains("G2 G17 G90 G94 G20 G40") && text.contains("X3 Y1"), "{text}");

    let found = editor.of("completion", place(7, 1)).expect("completions");
    let labels: Vec<&str> = found
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(|item| item["label"].as_str())
        .collect();
    assert!(labels.contains(&"G154"), "{labels:?}");

    let outline = editor.of("documentSymbol", json!({})).expect("symbols");
    assert_eq!(outline[0]["name"], "O100");
    assert_eq!(outline[0]["detail"], "PLATE");
    assert_eq!(outline[0]["children"][0]["name"], "T1");
    assert_eq!(outline[1]["name"], "O200");

    let folds = editor.of("foldingRange", json!({})).expect("folds");
    let lines = |fold: &Value| (fold["startLine"].as_u64(), fold["endLine"].as_u64());
    let folds: Vec<_> = folds.as_array().expect("a list").iter().map(lines).collect();
    assert_eq!(folds, FOLDED_LINES.map(|(from, to)| (Some(from), Some(to))));

    let program = editor.of("definition", place(9, 6)).expect("a place");
    assert_eq!(program[0]["range"], range((11, 0), (11, 4)));
    let label = editor.of("definition", place(8, 16)).expect("a place");
    assert_eq!(label[0]["range"], range((6, 0), (6, 3)));

    let mut asked = place(4, 1);
    asked["context"] = json!({ "includeDeclaration": true });
    let uses = editor.of("references", asked).expect("places");
    assert_eq!(uses.as_array().map(Vec::len), Some(3), "{uses}");

    let prepared = editor.of("prepareRename", place(6, 9)).expect("a range");
    assert_eq!(prepared, range((6, 8), (6, 12)));
    let mut asked = place(6, 9);
    asked["newName"] = json!("#120");
    let renamed = editor.of("rename", asked).expect("edits");
    assert_eq!(renamed["changes"][URI].as_array().map(Vec::len), Some(3), "{renamed}");
    let mut asked = place(6, 9);
    asked["newName"] = json!("depth");
    let refused = editor.of("rename", asked).expect_err("a refusal");
    assert!(refused.contains("`depth` cannot be a name here"), "{refused}");

    let hints = editor.of("inlayHint", json!({ "range": range((5, 0), (7, 0)) })).expect("hints");
    let labels: Vec<&str> = hints
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(|hint| hint["label"].as_str())
        .collect();
    assert!(labels.contains(&"2 in") && labels.contains(&"4.7124 in"), "{labels:?}");

    let tokens = editor.of("semanticTokens/full", json!({})).expect("tokens");
    let full = tokens["data"].as_array().map_or(0, Vec::len);
    let part = editor.of("semanticTokens/range", json!({ "range": range((6, 0), (7, 0)) }));
    let part = part.expect("tokens")["data"].as_array().map_or(0, Vec::len);
    assert!(full > part && part > 0 && full.is_multiple_of(5), "{full} {part}");

    let unknown = editor.of("codeLens", json!({})).expect_err("a refusal");
    assert!(unknown.contains("codeLens"), "{unknown}");
    let malformed = editor.ask("textDocument/hover", json!({ "where": 5 })).expect_err("a refusal");
    assert!(malformed.contains("missing field"), "{malformed}");
    editor.end();
}

#[test]
fn texts_are_formatted_and_numbered() {
    let mut editor = Editor::start(json!({}));
    editor.open("G20G90\nG1X1.F20.\nN7 X2.\nGOTO7\nM30\n");
    editor.problems(1);
    let edits = editor
        .of("formatting", json!({ "options": { "tabSize": 4, "insertSpaces": true } }))
        .expect("edits");
    let texts: Vec<&str> = edits
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(|edit| edit["newText"].as_str())
        .collect();
    assert_eq!(texts, ["G20 G90", "G1 X1. F20."]);
    let all = json!({ "range": range((0, 0), (1, 0)), "context": { "diagnostics": [] } });
    let actions = editor.of("codeAction", all).expect("actions");
    let renumber = actions
        .as_array()
        .expect("a list")
        .iter()
        .find(|action| action["kind"] == "source.renumber.chordal")
        .expect("renumbering is offered")
        .clone();
    assert!(renumber.get("edit").is_none(), "worked out when it is chosen");
    let resolved = editor.ask("codeAction/resolve", renumber).expect("edits");
    let edits = resolved["edit"]["changes"][URI].as_array().cloned().expect("a list");
    let texts: Vec<&str> = edits.iter().filter_map(|edit| edit["newText"].as_str()).collect();
    assert_eq!(texts, ["N10 ", "N20 ", "N30", "30", "N40 "]);
    editor.end();
}

#[test]
fn fixes_are_offered_where_they_belong() {
    let mut editor = Editor::start(json!({}));
    // A letter O instead of a zero, and nothing else.
    editor.open("G20 G90\nG1 X1O.5 F20.\nM30\n");
    let problems = editor.problems(1);
    assert!(!problems.is_empty());
    let at =
        |line| json!({ "range": range((line, 0), (line, 9)), "context": { "diagnostics": [] } });
    let fixes = |actions: &Value| {
        let list = actions.as_array().cloned().expect("a list");
        list.iter().filter(|action| action["kind"] == "quickfix").count()
    };
    let there = editor.of("codeAction", at(1)).expect("actions");
    assert_eq!(fixes(&there), 1, "{there}");
    let elsewhere = editor.of("codeAction", at(2)).expect("actions");
    assert_eq!(fixes(&elsewhere), 0, "{elsewhere}");
    editor.end();
}

#[test]
fn every_word_that_makes_an_arc_true_is_offered_as_a_fix() {
    let mut editor = Editor::start(json!({ "machine": "fanuc-0i" }));
    editor.open("G21 G90 G17 S900 M3\nG1 X2. Y-11.68 F90.\nG3 X4. Y-16.18 I1. J0.\nM30\n");
    let problems = editor.problems(1);
    assert!(problems.iter().any(|problem| problem["code"] == "CH401"), "{problems:?}");
    let at = json!({ "range": range((2, 3), (2, 3)), "context": { "diagnostics": [] } });
    let actions = editor.of("codeAction", at).expect("actions");
    let texts: Vec<(&str, &str)> = actions
        .as_array()
        .expect("a list")
        .iter()
        .filter(|action| action["kind"] == "quickfix")
        .map(|action| {
            let edit = &action["edit"]["changes"][URI][0];
            (action["title"].as_str().unwrap_or(""), edit["newText"].as_str().unwrap_or(""))
        })
        .collect();
    // The digits of the end, or those of the point before.
    assert_eq!(
        texts.iter().map(|(_, text)| *text).collect::<Vec<_>>(),
        ["Y-11.68", "Y-16.18"],
        "{actions}"
    );
    assert!(texts[0].0.contains("`Y-11.68` for `Y-16.18`"), "{actions}");
    assert!(texts[1].0.contains("in the block before"), "{actions}");
    editor.end();
}

#[test]
fn the_settings_choose_the_machine() {
    let mut editor = Editor::start(json!({ "machine": "fadal-4020" }));
    editor.open("L100\nX1.\nM17\nM30\n");
    editor.problems(1);
    let hover = editor.of("hover", place(2, 1)).expect("a hover");
    assert!(hover.to_string().contains("Fadal"), "{hover}");
    let settings = json!({ "settings": { "chordal": { "machine": "no-such" } } });
    editor.tell("workspace/didChangeConfiguration", settings);
    let told = editor.problems(1);
    assert_eq!(told[0]["message"], "there is no such machine");
    let none = editor.of("hover", place(2, 1)).expect_err("a refusal");
    assert!(none.contains("no machine"), "{none}");
    editor.end();
}

#[test]
fn a_subprogram_in_another_file_is_gone_to() {
    let mut editor = Editor::start(json!({}));
    editor.open("O1\nM98 P77\nM98 P77\nM98 P5\nM30\n");
    editor.problems(1);
    let made = editor.of("definition", place(1, 6)).expect("a place");
    let there = json!([{ "uri": "file:///shop/O77.nc", "range": range((2, 0), (2, 3)) }]);
    assert_eq!(made, there);
    let mut asked = place(2, 6);
    asked["context"] = json!({ "includeDeclaration": true });
    let uses = editor.of("references", asked).expect("places");
    let uris: Vec<&str> =
        uses.as_array().expect("a list").iter().filter_map(|each| each["uri"].as_str()).collect();
    assert_eq!(uris, [URI, URI, "file:///shop/O77.nc"]);
    let nowhere = editor.of("definition", place(3, 6)).expect("no place");
    assert_eq!(nowhere, json!([]));
    editor.end();
}

#[test]
fn questions_about_a_run_wait_for_it_or_are_given_up() {
    let mut editor = Editor::start(json!({}));
    let text: String = (0..30_000).map(|step| format!("G1 X{}. F9.\n", step % 7)).collect();
    editor.open(&text);
    // Requested immediately, answered after the text has run.
    let hints = editor.of("inlayHint", json!({ "range": range((0, 0), (3, 0)) })).expect("hints");
    assert!(hints.as_array().is_some_and(|hints| !hints.is_empty()), "{hints}");
    editor.change(2, range((0, 0), (0, 0)), " ");
    let params = json!({ "textDocument": { "uri": URI }, "range": range((0, 0), (3, 0)) });
    let id = RequestId::from(1000);
    let request = Request::new(id.clone(), "textDocument/inlayHint".into(), params);
    editor.connection.sender.send(request.into()).expect("the server listens");
    editor.change(3, range((0, 0), (0, 0)), " ");
    loop {
        if let Message::Response(answer) = editor.receive()
            && answer.id == id
        {
            let refused = answer.response_kind_or_error().expect_err("the text has changed");
            assert_eq!(refused, "the text has changed");
            break;
        }
    }
    editor.end();
}

#[test]
fn problems_of_a_long_text_are_those_of_a_whole_check() {
    let mut editor = Editor::start(json!({}));
    let mut text = String::from("G20 G90 G17\nT1 M6\nS900 M3\nG0 X0 Y0 Z1.\nG1 Z0 F10.\n");
    for step in 0..9_000 {
        text += &format!("X{}. Y{}.\n", step % 13, step % 5);
    }
    text += "G2 X3. Y1. I9. J0\nG0 Z1.\nM30\n";
    editor.open(&text);
    let first = editor.problems(1);
    let arc = |problems: &[Value]| {
        let wrong = problems.iter().filter(|problem| problem["severity"] == 1);
        let line = |problem: &Value| problem["range"]["start"]["line"].as_u64().expect("a line");
        // Problems of the program as a whole are shown at its beginning.
        wrong.map(line).max().expect("an error")
    };
    assert_eq!(arc(&first), 9_005);
    editor.change(2, range((20, 0), (20, 0)), "(A LINE MORE)\n");
    assert_eq!(arc(&editor.problems(2)), 9_006);
    editor.change(3, range((5_000, 0), (5_002, 0)), "");
    assert_eq!(arc(&editor.problems(3)), 9_004);
    // Every position after it changes.
    editor.change(4, range((5, 0), (5, 0)), "G91\n");
    let fourth = editor.problems(4);
    editor.change(5, range((5, 0), (6, 0)), "");
    let fifth = editor.problems(5);
    assert_eq!(arc(&fifth), 9_004);
    assert!(fourth != fifth);
    editor.end();
}

/// The editor waits a minute for an answer at most.
#[test]
fn very_long_texts_and_lines_have_their_answers() {
    let head = "G21 G90 G17\nT1 M6\nS900 M3\nG0 X0 Y0 Z1.\nG1 Z0 F10.\n";
    let lines = "X1. Y2.\n".repeat(500_000);
    let line = format!("{}\n", "X1. ".repeat(500_000));
    for text in [format!("{head}{lines}M30\n"), format!("{head}{line}M30\n")] {
        let mut editor = Editor::start(json!({}));
        editor.open(&text);
        editor.problems(1);
        assert_eq!(editor.of("hover", place(4, 0)).err(), None);
        assert_eq!(editor.of("documentSymbol", json!({})).err(), None);
        editor.change(2, range((4, 0), (4, 0)), "(A COMMENT)");
        editor.problems(2);
        editor.end();
    }
}

#[test]
fn a_failure_of_ours_ends_one_run_and_not_the_server() {
    let mut editor = Editor::start(json!({}));
    editor.open(&format!("G20 G90\n{FAILS}\nG1 X1. F20.\nM30\n"));
    let told = editor.problems(1);
    let message = told[0]["message"].as_str().unwrap();
    assert!(message.starts_with("Chordal failed: ") && message.contains("a made-up failure"));
    // The modal state there would come from a run; the request is answered nevertheless.
    let refused = editor.of("hover", place(2, 1)).expect_err("no state");
    assert!(refused.starts_with("Chordal failed: "), "{refused}");
    editor.of("documentSymbol", json!({})).expect("an outline");
    // Requests that need a run are not left waiting.
    let at = json!({ "range": range((0, 0), (4, 0)) });
    editor.of("inlayHint", at).expect_err("no run");
    editor.change(2, range((1, 0), (2, 0)), "");
    let next = editor.problems(2);
    assert!(!next.is_empty() && next.iter().all(|told| !told.to_string().contains("failed")));
    editor.end();
}

#[test]
fn a_text_that_fails_to_open_leaves_the_others() {
    let mut editor = Editor::start(json!({}));
    editor.open(std::str::from_utf8(OPENING_FAILS).unwrap());
    editor.wait("window/showMessage", |told| told["message"].to_string().contains("made-up"));
    editor.open("G20 G90\nG1 X1. F20.\nM30\n");
    editor.problems(1);
    editor.of("hover", place(1, 1)).expect("a hover");
    editor.end();
}

#[test]
fn a_first_message_with_odd_words_is_no_reason_to_end() {
    let (server, connection) = Connection::memory();
    let server = thread::spawn(move || serve(&server, &Typical).expect("it goes on"));
    let odd = json!({ "capabilities": 7, "rootUri": [], "initializationOptions": "none" });
    let mut editor =
        Editor { connection, server, next: 0, notices: Vec::new(), capabilities: Value::Null };
    editor.ask("initialize", odd).expect("an answer");
    // Before `initialized`, which some editors send late.
    editor.open("G20 G90\nG1 X1. F20.\nM30\n");
    editor.of("hover", place(1, 1)).expect("a hover");
    editor.end();
}
