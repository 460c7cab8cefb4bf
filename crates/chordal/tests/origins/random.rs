//! Random macro programs with planted unknown values, against a small model that knows only which values are known.
//!
//! More: `CHORDAL_ROUNDS=5000 cargo test --release -p chordal --test origins random`.

use std::collections::BTreeMap;
use std::fmt::Write;

use chordal::CommandKind;

use super::{job, report};

/// Variables that the programs set before they read them.
const LOCALS: [u32; 5] = [1, 2, 3, 4, 5];

struct Random(u64);

impl Random {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) % limit
    }

    fn chance(&mut self, percent: u64) -> bool {
        self.below(100) < percent
    }

    fn pick<T: Copy>(&mut self, some: &[T]) -> T {
        some[self.below(some.len() as u64) as usize]
    }

    /// A number with one decimal.
    fn number(&mut self) -> f64 {
        self.below(200) as f64 / 10.0
    }
}

/// How a control writes its programs.
struct Writing {
    machine: &'static str,
    /// IF and GOTO, WHILE and DO; else O words.
    has_blocks: bool,
    /// Variables that nobody sets.
    unknown: &'static [u32],
}

const WRITINGS: [Writing; 4] = [
    Writing { machine: "fanuc-0i", has_blocks: true, unknown: &[500, 101, 1000, 3901, 2001] },
    Writing { machine: "haas-vf2", has_blocks: true, unknown: &[500, 101, 1000, 3901, 10900] },
    Writing {
        machine: "mitsubishi-m700",
        has_blocks: true,
        unknown: &[500, 101, 1000, 3901, 4401],
    },
    Writing { machine: "linuxcnc-mill", has_blocks: false, unknown: &[500, 101, 5399, 31, 4999] },
];

#[derive(Clone, Copy)]
enum Term {
    Number(f64),
    Variable(u32),
}

/// `a`, `a+b`, `a-b`, `a*0.5`, `ABS[a]`.
#[derive(Clone, Copy)]
enum Value {
    Plain(Term),
    Sum(Term, Term),
    Difference(Term, Term),
    Half(Term),
    Absolute(Term),
}

#[derive(Clone, Copy)]
struct Condition {
    value: Value,
    is_greater: bool,
    than: f64,
}

enum Node {
    Assign(u32, Value),
    Move(char, Value),
    Feed(Value),
    Dwell(Value),
    If(Condition, Vec<Node>),
    /// So many passes, counted in a variable of its own.
    Loop(Value, Vec<Node>),
    Print(Value),
}

fn term(random: &mut Random, unknown: &[u32], percent: u64) -> Term {
    match random.below(10) {
        _ if random.chance(percent) => Term::Variable(random.pick(unknown)),
        0..5 => Term::Variable(random.pick(&LOCALS)),
        _ => Term::Number(random.number()),
    }
}

fn value(random: &mut Random, unknown: &[u32], percent: u64) -> Value {
    let term = |random: &mut Random| term(random, unknown, percent);
    match random.below(5) {
        0 => Value::Plain(term(random)),
        1 => Value::Sum(term(random), term(random)),
        2 => Value::Difference(term(random), term(random)),
        3 => Value::Half(term(random)),
        _ => Value::Absolute(term(random)),
    }
}

/// Statements; `percent` of their terms are unknown.
fn nodes(random: &mut Random, unknown: &[u32], percent: u64, depth: u32) -> Vec<Node> {
    let count = 1 + random.below(5);
    (0..count)
        .map(|_| {
            let value = |random: &mut Random| value(random, unknown, percent);
            match random.below(if depth < 2 { 10 } else { 7 }) {
                0..3 => Node::Assign(random.pick(&LOCALS), value(random)),
                3 | 4 => Node::Move(random.pick(&['X', 'Y']), value(random)),
                5 => match random.below(3) {
                    0 => Node::Feed(Value::Absolute(Term::Number(50.0 + random.below(50) as f64))),
                    1 => Node::Dwell(value(random)),
                    _ => Node::Feed(value(random)),
                },
                6 => Node::Print(value(random)),
                7 | 8 => {
                    let (is_greater, than) = (random.chance(50), random.number());
                    let condition = Condition { value: value(random), is_greater, than };
                    Node::If(condition, nodes(random, unknown, percent, depth + 1))
                }
                _ => Node::Loop(value(random), nodes(random, unknown, percent, depth + 1)),
            }
        })
        .collect()
}

/// Writes a program, and follows with what is known where each statement stands.
struct Writer<'w> {
    writing: &'w Writing,
    text: String,
    line: usize,
    labels: u32,
    /// Loops that are open.
    depth: u32,
}

impl Writer<'_> {
    fn put(&mut self, line: &str) -> usize {
        writeln!(self.text, "{line}").expect("text");
        self.line += 1;
        self.line
    }

    fn term(&self, term: Term) -> String {
        match term {
            Term::Number(number) => format!("{number:.1}"),
            Term::Variable(number) => format!("#{number}"),
        }
    }

    fn value(&self, value: Value) -> String {
        let term = |term| self.term(term);
        match value {
            Value::Plain(a) => term(a),
            Value::Sum(a, b) => format!("{}+{}", term(a), term(b)),
            Value::Difference(a, b) => format!("{}-{}", term(a), term(b)),
            Value::Half(a) => format!("{}*0.5", term(a)),
            Value::Absolute(a) => format!("ABS[{}]", term(a)),
        }
    }

    fn condition(&self, condition: Condition, is_turned: bool) -> String {
        let operator = match condition.is_greater != is_turned {
            true if is_turned => "GE",
            true => "GT",
            false if is_turned => "LE",
            false => "LT",
        };
        format!("[[{}] {operator} {:.1}]", self.value(condition.value), condition.than)
    }

    /// Writes statements and gives each its line.
    fn nodes(&mut self, nodes: &[Node]) -> Vec<Placed> {
        nodes.iter().map(|node| self.node(node)).collect()
    }

    fn node(&mut self, node: &Node) -> Placed {
        self.labels += 1;
        let label = self.labels;
        match node {
            Node::Assign(number, value) => {
                let line = format!("#{number}=[{}]", self.value(*value));
                Placed::simple(self.put(&line), Act::Assign(*number, *value))
            }
            Node::Move(letter, value) => {
                let line = format!("G1 {letter}[{}]", self.value(*value));
                Placed::simple(self.put(&line), Act::Move(*letter, *value))
            }
            Node::Feed(value) => {
                let line = format!("F[ABS[{}]+10.]", self.value(*value));
                Placed::simple(self.put(&line), Act::Reach(*value))
            }
            Node::Dwell(value) => {
                let line = format!("G4 P[ABS[{}]]", self.value(*value));
                Placed::simple(self.put(&line), Act::Reach(*value))
            }
            Node::Print(value) => {
                let line = match (value, self.writing.has_blocks) {
                    (Value::Plain(Term::Variable(number)), true) => {
                        format!("DPRNT[A#{number}[33]]")
                    }
                    (Value::Plain(Term::Variable(number)), false) => format!("(PRINT, #{number})"),
                    _ => "(nothing)".to_string(),
                };
                Placed::simple(self.put(&line), Act::Nothing)
            }
            Node::If(condition, inner) => {
                let is_blocks = self.writing.has_blocks;
                let line = match is_blocks {
                    true => format!("IF{}GOTO{label}", self.condition(*condition, true)),
                    false => format!("o{label} if {}", self.condition(*condition, false)),
                };
                let line = self.put(&line);
                let inner = self.nodes(inner);
                match is_blocks {
                    true => self.put(&format!("N{label}")),
                    false => self.put(&format!("o{label} endif")),
                };
                Placed { line, act: Act::If(*condition), inner }
            }
            Node::Loop(count, inner) => {
                let counter = 520 + label;
                let (loop_line, end) = match self.writing.has_blocks {
                    true => {
                        self.put(&format!("#{counter}=0"));
                        let level = self.depth + 1;
                        let test =
                            format!("WHILE[#{counter} LT [{}]]DO{level}", self.limit(*count));
                        (self.put(&test), format!("END{level}"))
                    }
                    false => {
                        self.put(&format!("#{counter}=0"));
                        let test =
                            format!("o{label} while [#{counter} LT [{}]]", self.limit(*count));
                        (self.put(&test), format!("o{label} endwhile"))
                    }
                };
                self.depth += 1;
                let inner = self.nodes(inner);
                self.depth -= 1;
                self.put(&format!("#{counter}=[#{counter}+1]"));
                self.put(&end);
                Placed { line: loop_line, act: Act::Loop(*count, counter), inner }
            }
        }
    }

    /// At most three passes, whatever the value.
    fn limit(&self, count: Value) -> String {
        let value = self.value(count);
        format!("ABS[{value}]-FIX[ABS[{value}]/3]*3")
    }
}

/// A statement with its line.
struct Placed {
    line: usize,
    act: Act,
    inner: Vec<Placed>,
}

#[derive(Clone, Copy)]
enum Act {
    Assign(u32, Value),
    Move(char, Value),
    /// A feed or a wait.
    Reach(Value),
    If(Condition),
    Loop(Value, u32),
    Nothing,
}

impl Placed {
    fn simple(line: usize, act: Act) -> Placed {
        Placed { line, act, inner: Vec::new() }
    }
}

/// What is known of the variables, and where the axes stand.
struct Model {
    values: BTreeMap<u32, Option<f64>>,
    place: [f64; 2],
    /// The line from which on something is not known.
    lost: Option<usize>,
}

impl Model {
    fn term(&self, term: Term) -> Option<f64> {
        match term {
            Term::Number(number) => Some(number),
            Term::Variable(number) => self.values.get(&number).copied().flatten(),
        }
    }

    fn value(&self, value: Value) -> Option<f64> {
        Some(match value {
            Value::Plain(a) => self.term(a)?,
            Value::Sum(a, b) => self.term(a)? + self.term(b)?,
            Value::Difference(a, b) => self.term(a)? - self.term(b)?,
            Value::Half(a) => self.term(a)? * 0.5,
            Value::Absolute(a) => self.term(a)?.abs(),
        })
    }

    /// Runs until something is lost.
    fn run(&mut self, placed: &[Placed]) {
        for each in placed {
            if self.lost.is_some() {
                return;
            }
            self.step(each);
        }
    }

    fn step(&mut self, each: &Placed) {
        match each.act {
            Act::Nothing => {}
            Act::Assign(number, value) => {
                let value = self.value(value);
                self.values.insert(number, value);
            }
            Act::Move(letter, value) => match self.value(value) {
                Some(value) => self.place[usize::from(letter == 'Y')] = value,
                None => self.lost = Some(each.line),
            },
            Act::Reach(value) => {
                if self.value(value).is_none() {
                    self.lost = Some(each.line);
                }
            }
            Act::If(condition) => match self.value(condition.value) {
                None => self.lost = Some(each.line),
                Some(value) => {
                    let holds = match condition.is_greater {
                        true => value > condition.than,
                        false => value < condition.than,
                    };
                    if holds {
                        self.run(&each.inner);
                    }
                }
            },
            Act::Loop(count, counter) => {
                let mut passes = 0.0;
                while self.lost.is_none() {
                    // The limit is computed anew before each pass.
                    let Some(count) = self.value(count) else {
                        self.lost = Some(each.line);
                        return;
                    };
                    let limit = count.abs() - (count.abs() / 3.0).floor() * 3.0;
                    if passes >= limit {
                        return;
                    }
                    self.values.insert(counter, Some(passes));
                    self.run(&each.inner);
                    passes += 1.0;
                }
            }
        }
    }
}

fn rounds() -> u64 {
    #[allow(clippy::disallowed_methods, reason = "a test reads how many rounds it is to run")]
    let asked = std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok());
    asked.unwrap_or(300)
}

#[test]
fn random_programs_are_verified_where_the_model_knows_everything() {
    let (mut wrong, mut verified, mut all) = (Vec::new(), 0, 0);
    for (kind, writing) in WRITINGS.iter().enumerate() {
        for seed in 0..rounds() {
            let mut random =
                Random((seed * 8 + kind as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
            let percent = random.pick(&[0, 5, 20, 40]);
            let tree = nodes(&mut random, writing.unknown, percent, 0);
            let mut writer = Writer { writing, text: String::new(), line: 0, labels: 20, depth: 0 };
            if writing.has_blocks {
                writer.put("O1");
            }
            writer.put("G21 G17 G40 G80 G90 G94 F100.");
            writer.put("G0 X0 Y0 Z0");
            LOCALS.iter().for_each(|local| {
                writer.put(&format!("#{local}={local}."));
            });
            let placed = writer.nodes(&tree);
            writer.put(if writing.has_blocks { "M30" } else { "M2" });
            let text = writer.text;
            let known = || LOCALS.iter().map(|local| (*local, Some(f64::from(*local))));
            let mut model = Model { values: known().collect(), place: [0.0; 2], lost: None };
            model.run(&placed);
            all += 1;
            verified += u64::from(model.lost.is_none());
            let found = report(writing.machine, &[], &text);
            let line = found.not_verified_from.map(|span| {
                1 + text.as_bytes()[..span.range.start as usize]
                    .iter()
                    .filter(|b| **b == b'\n')
                    .count()
            });
            if line != model.lost {
                wrong.push(format!(
                    "{} model {:?}, got {line:?}\n{text}",
                    writing.machine, model.lost
                ));
                continue;
            }
            // With all values the run is whole, and ends where the model does.
            let given: Vec<String> =
                writing.unknown.iter().map(|number| format!("#{number}=2.5")).collect();
            let given: Vec<&str> = given.iter().map(String::as_str).collect();
            let values = known().chain(writing.unknown.iter().map(|number| (*number, Some(2.5))));
            let mut model = Model { values: values.collect(), place: [0.0; 2], lost: None };
            model.run(&placed);
            let mut end = [0.0; 2];
            let whole = job(writing.machine, &given, &text).report_of_commands(|command| {
                if let CommandKind::Rapid { motion, .. } | CommandKind::Line { motion, .. } =
                    &command.kind
                {
                    end = [motion.to[0], motion.to[1]];
                }
            });
            let is_near = (0..2).all(|axis| (end[axis] - model.place[axis]).abs() < 1e-3);
            if !whole.verified() || !is_near {
                let verified = whole.verified();
                wrong.push(format!(
                    "{} given: {verified} {end:?} {:?}\n{text}",
                    writing.machine, model.place
                ));
            }
        }
    }
    assert!(verified * 5 > all && verified * 5 < all * 4, "{verified} of {all} are verified");
    assert!(
        wrong.is_empty(),
        "{} of {all}:\n{}",
        wrong.len(),
        wrong[..wrong.len().min(4)].join("\n")
    );
}
