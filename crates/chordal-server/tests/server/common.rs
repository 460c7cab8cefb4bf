//! A server in a thread, and clients for it.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::PathBuf;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use chordal::{Machine, ShopAnswer, ShopCall};
use chordal_compare::ComparisonOptions;
use chordal_editor::{EditorProgram, EditorSetup};
use chordal_server::{
    ComparedProgram, ListedMachine, PageServer, ProgramRefusal, ProgramSource, save,
};
use serde_json::Value;
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket};

/// How long a test waits for an answer.
const TIMEOUT: Duration = Duration::from_secs(30);

/// A program in a file or only in memory.
pub struct Shown {
    pub path: Option<PathBuf>,
    pub text: Mutex<Vec<u8>>,
    pub compared: Option<Arc<ComparedProgram>>,
    /// A setup file; `None` uses a built-in machine.
    pub setup: Option<String>,
}

impl Shown {
    pub fn text(text: &str) -> Shown {
        Shown {
            path: None,
            text: Mutex::new(text.as_bytes().to_vec()),
            compared: None,
            setup: None,
        }
    }

    pub fn file(path: PathBuf) -> Shown {
        Shown { path: Some(path), text: Mutex::default(), compared: None, setup: None }
    }

    /// With the machine, stock and tools of a setup file.
    pub fn set_up(self, setup: &str) -> Shown {
        Shown { setup: Some(setup.to_string()), ..self }
    }

    /// Compared with another program.
    pub fn compared(self, other: Shown, own_text: bool) -> Shown {
        let programs = Arc::new(other);
        let compared =
            ComparedProgram { programs, own_text, options: ComparisonOptions::default() };
        Shown { compared: Some(Arc::new(compared)), ..self }
    }
}

/// Running this code panics, to simulate a defect in Chordal.
pub const FAILS: &str = "M777";

fn fails(call: &ShopCall<'_>) -> ShopAnswer {
    assert_ne!(call.code.to_string(), FAILS, "a made-up failure");
    ShopAnswer::NotMine
}

impl ProgramSource for Shown {
    fn path(&self) -> Option<PathBuf> {
        self.path.clone()
    }

    fn name(&self) -> String {
        "part.nc".into()
    }

    fn read(&self) -> Result<Vec<u8>, ProgramRefusal> {
        let refused =
            |error: std::io::Error| ProgramRefusal { message: error.to_string(), help: None };
        match &self.path {
            Some(path) => std::fs::read(path).map_err(refused),
            None => Ok(self.text.lock().unwrap().clone()),
        }
    }

    fn write(&self, bytes: &[u8]) -> Result<(), ProgramRefusal> {
        save(self.path.as_deref().expect("a file"), bytes)
    }

    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<EditorProgram, ProgramRefusal> {
        let none = |name: &str| Err(format!("no file {name}"));
        let machine = match &self.setup {
            Some(setup) => Machine::from_toml("setup.toml", setup, &none),
            None => Machine::from_builtin(machine.unwrap_or("haas-vf2")),
        };
        let machine = machine.map_err(|errors| ProgramRefusal {
            message: errors[0].message.clone(),
            help: errors[0].help.clone(),
        })?;
        let others = vec![("O77.nc".to_string(), b"(BESIDE)\nO77\nM99\n".to_vec())];
        let mut setup = EditorSetup { subprogram_texts: others, ..EditorSetup::of(machine) };
        if text.windows(FAILS.len()).any(|word| word == FAILS.as_bytes()) {
            setup.options.shop_codes = Some(Arc::new(fails));
        }
        Ok(EditorProgram::set_up("part.nc", text, setup).expect("settings that the control knows"))
    }

    fn compared_program(&self) -> Option<Arc<ComparedProgram>> {
        self.compared.clone()
    }

    fn machines(&self) -> Vec<ListedMachine> {
        vec![ListedMachine { name: "haas-vf2".into(), title: "Haas".into() }]
    }
}

/// The port and the token of a server that runs until the tests end.
pub struct Site {
    pub port: u16,
    pub token: String,
}

pub fn serve(shown: Shown) -> Site {
    serve_by(PageServer::listen(0).unwrap(), shown)
}

pub fn serve_by(server: PageServer, shown: Shown) -> Site {
    let url = server.url();
    let rest = url.strip_prefix("http://127.0.0.1:").unwrap();
    let (port, token) = rest.split_once('/').unwrap();
    let site = Site { port: port.parse().unwrap(), token: token.trim_end_matches('/').into() };
    thread::spawn(move || server.serve(Arc::new(shown)));
    site
}

impl Site {
    pub fn host(&self) -> String {
        format!("127.0.0.1:{}", self.port)
    }

    /// The status, headers and body of the answer to a request with this first line and these header lines.
    pub fn raw(&self, first: &str, lines: &[String]) -> (u16, String, Vec<u8>) {
        let mut socket = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        socket.set_read_timeout(Some(TIMEOUT)).unwrap();
        let head = format!("{first}\r\n{}\r\nConnection: close\r\n\r\n", lines.join("\r\n"));
        socket.write_all(head.as_bytes()).unwrap();
        let mut bytes = Vec::new();
        let _ = socket.read_to_end(&mut bytes);
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").expect("an answer");
        let head = String::from_utf8(bytes[..end].to_vec()).unwrap();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        (status, head.to_ascii_lowercase(), bytes[end + 4..].to_vec())
    }

    pub fn get(&self, path: &str) -> (u16, String, Vec<u8>) {
        self.raw(&format!("GET {path} HTTP/1.1"), &[format!("Host: {}", self.host())])
    }

    /// Opens a connection with these headers; the error is the status of the refusal.
    pub fn connect(&self, path: &str, headers: &[(&str, &str)]) -> Result<Live, u16> {
        let socket = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        socket.set_read_timeout(Some(TIMEOUT)).unwrap();
        let mut request = format!("ws://{}{path}", self.host()).into_client_request().unwrap();
        for (name, value) in headers {
            let name: tungstenite::http::HeaderName = name.parse().unwrap();
            request.headers_mut().insert(name, value.parse().unwrap());
        }
        match tungstenite::client(request, socket) {
            Ok((socket, _)) => Ok(Live { socket }),
            Err(tungstenite::HandshakeError::Failure(tungstenite::Error::Http(response))) => {
                Err(response.status().as_u16())
            }
            Err(error) => panic!("{error}"),
        }
    }

    pub fn live(&self) -> Live {
        self.connect(&format!("/{}/live", self.token), &[]).unwrap()
    }
}

/// A page's connection.
pub struct Live {
    pub socket: WebSocket<TcpStream>,
}

/// The header of a frame and the bytes of its columns.
pub struct Columns {
    pub header: Value,
    data: Vec<u8>,
}

impl Columns {
    fn read(bytes: &[u8]) -> Columns {
        let length = u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize;
        let header = serde_json::from_slice(&bytes[4..4 + length]).unwrap();
        Columns { header, data: bytes[4 + length..].to_vec() }
    }

    fn bytes(&self, name: &str, kind: &str, size: usize) -> &[u8] {
        let place = &self.header["columns"][name];
        assert_eq!(place["type"], kind, "{name}");
        let number = |key: &str| place[key].as_u64().unwrap() as usize;
        &self.data[number("offset")..number("offset") + size * number("count")]
    }

    pub fn f32(&self, name: &str) -> Vec<f32> {
        let four = |bytes: &[u8]| f32::from_le_bytes(bytes.try_into().unwrap());
        self.bytes(name, "f32", 4).chunks(4).map(four).collect()
    }

    pub fn u32(&self, name: &str) -> Vec<u32> {
        let four = |bytes: &[u8]| u32::from_le_bytes(bytes.try_into().unwrap());
        self.bytes(name, "u32", 4).chunks(4).map(four).collect()
    }

    pub fn u8(&self, name: &str) -> Vec<u8> {
        self.bytes(name, "u8", 1).to_vec()
    }
}

/// A message from the server.
pub enum PageMessage {
    Json(Value),
    Columns(Columns),
    Closed,
}

impl Live {
    pub fn send(&mut self, text: &str) {
        self.socket.send(Message::text(text)).unwrap();
    }

    pub fn next(&mut self) -> PageMessage {
        match self.socket.read() {
            Ok(Message::Text(text)) => PageMessage::Json(serde_json::from_str(&text).unwrap()),
            Ok(Message::Binary(bytes)) => PageMessage::Columns(Columns::read(&bytes)),
            Ok(Message::Close(_)) | Err(_) => PageMessage::Closed,
            Ok(_) => self.next(),
        }
    }

    /// Waits for the next object of a type; earlier messages are skipped.
    pub fn json(&mut self, kind: &str) -> Value {
        loop {
            match self.next() {
                PageMessage::Json(object) if object["type"] == kind => return object,
                PageMessage::Closed => panic!("closed before `{kind}`"),
                _ => {}
            }
        }
    }

    /// Waits for the next frame of a type; earlier messages are skipped.
    pub fn columns(&mut self, kind: &str) -> Columns {
        loop {
            match self.next() {
                PageMessage::Columns(columns) if columns.header["type"] == kind => return columns,
                PageMessage::Closed => panic!("closed before `{kind}`"),
                _ => {}
            }
        }
    }
}
