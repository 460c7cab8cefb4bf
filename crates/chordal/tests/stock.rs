//! Programs on stock: planted touches are found, near misses are not reported, volumes enclose the truth.
//!
//! More: `CHORDAL_ROUNDS=1000 cargo test --release -p chordal --test stock`.

#![allow(clippy::disallowed_methods, reason = "a test reads how many rounds it is to run")]

mod holes;
mod tips;
mod turned;

use std::f64::consts::PI;

use chordal::geometry::Vec3;
use chordal::stock::mesh::write::write_stl;
use chordal::stock::mesh::{LayerField, LengthUnit, Mesh, SolidIntervals};
use chordal::stock::{JobRunner, StockOptions, StockReport, StockVerdict, TileJob};
use chordal::{Job, Machine, Source, SourceMap};

const RESOLUTION: f64 = 0.5;

fn rounds() -> u64 {
    std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok()).unwrap_or(40)
}

/// A simple generator of numbers from 0 to 1.
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    fn share(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }
}

fn machine(setup: &str) -> Machine {
    let none = |name: &str| Err(format!("no file {name}"));
    Machine::from_toml("setup.toml", setup, &none).expect("a good setup")
}

/// The same with a mesh file `part.stl`.
fn run_with(setup: &str, program: &str, mesh: &[u8]) -> StockReport {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.as_bytes().to_vec()));
    let job = Job::new(sources, machine(setup)).expect("settings of the control");
    let options = StockOptions { resolution_mm: Some(RESOLUTION), ..StockOptions::default() };
    job.stock(&options, &|_| Ok(mesh.to_vec())).expect("stock")
}

fn run(setup: &str, program: &str) -> StockReport {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.as_bytes().to_vec()));
    let job = Job::new(sources, machine(setup)).expect("settings of the control");
    let options = StockOptions { resolution_mm: Some(RESOLUTION), ..StockOptions::default() };
    job.stock(&options, &|name| Err(format!("no file {name}"))).expect("stock")
}

const SETUP: &str = r#"
machine = "haas-vf2"
[stock]
shape = "box"
from = { X = "0 mm", Y = "0 mm", Z = "-30 mm" }
to = { X = "100 mm", Y = "60 mm", Z = "0 mm" }
[fixtures.clamp]
shape = "box"
from = { X = "-20 mm", Y = "20 mm", Z = "-30 mm" }
to = { X = "-5 mm", Y = "40 mm", Z = "10 mm" }
[target]
shape = "box"
from = { X = "0 mm", Y = "0 mm", Z = "-30 mm" }
to = { X = "100 mm", Y = "60 mm", Z = "-5 mm" }
tolerance = "0.2 mm"
[tools.1]
shape = "flat"
diameter = "10 mm"
flute_length = "12 mm"
holder = [["30 mm", "30 mm"]]
shank = [["8 mm", "10 mm"]]
[tools.2]
shape = "ball"
diameter = "8 mm"
flute_length = "15 mm"
holder = [["30 mm", "24 mm"]]
shank = [["5 mm", "8 mm"]]
"#;

/// A program that cuts a slot within the target's allowance, with blocks before its end.
fn program(tool: u32, blocks: &str) -> String {
    format!(
        "O1\nG21 G90 G17 G54\nT{tool} M6\nS3000 M3\nG0 X-30. Y10.\nG43 H{tool} Z20.\nG0 Z-3.\n\
         G1 X70. F800.\nG0 Z20.\n{blocks}G0 Z20.\nM30\n"
    )
}

/// The names of sure touches in a line.
fn names(found: &StockReport, line: u32) -> Vec<&'static str> {
    let there = found.problems.iter().filter(|problem| problem.line == line);
    there
        .map(|problem| problem.code.info().name)
        .filter(|name| *name != "stock-not-proved")
        .collect()
}

/// A planted touch: what it is, the tool, its blocks, and the line of the touch.
fn planted(kind: usize, random: &mut Random) -> (&'static str, u32, String, u32) {
    let tool = 1 + u32::from(random.share() < 0.5);
    // At least twice the resolution.
    let deep = random.between(2.0 * RESOLUTION, 4.0);
    let (x, y) = (random.between(20.0, 80.0), random.between(30.0, 50.0));
    match kind {
        // A rapid sideways below the top, where nothing is cut.
        0 => ("rapid-through-stock", tool, format!("G0 X-30. Y50.\nZ-{deep:.3}\nX{x:.3}\n"), 12),
        // A rapid down into the stock.
        1 => ("rapid-through-stock", tool, format!("G0 X{x:.3} Y{y:.3}\nZ-{deep:.3}\n"), 11),
        // A cut to the side, deeper than the edges. Straight down they cut the whole hole.
        2 => {
            let flutes = if tool == 1 { 12.0 } else { 15.0 };
            (
                "deeper-than-flutes",
                tool,
                format!("G0 X{x:.3} Y{y:.3}\nG1 Z-{:.3} F200.\nX{:.3}\n", flutes + deep, x + 8.0),
                12,
            )
        }
        // The holder comes to the top where the tool is deep in a hole.
        3 => {
            let stick_out = 20.0;
            let holder = format!("G0 X{x:.3} Y{y:.3}\nG1 Z-{:.3} F200.\n", stick_out + deep);
            ("holder-in-stock", tool, holder, 11)
        }
        // Into the clamp beside the stock.
        4 => ("fixture-hit", tool, format!("G0 X-40. Y30.\nZ{:.3}\nX-12.\n", 10.0 - deep), 12),
        // Below the target.
        _ => ("gouge", tool, format!("G0 X{x:.3} Y{y:.3}\nG1 Z-{:.3} F200.\n", 5.2 + deep), 11),
    }
}

#[test]
fn planted_touches_are_found_in_their_line() {
    let mut missed = Vec::new();
    for seed in 1..=rounds() {
        let mut random = Random::new(seed);
        let (name, tool, blocks, line) = planted(seed as usize % 6, &mut random);
        let found = run(SETUP, &program(tool, &blocks));
        assert_eq!(found.verdict, StockVerdict::Problems, "seed {seed}");
        if !names(&found, line).contains(&name) {
            missed.push((seed, name, names(&found, line), blocks));
        }
    }
    assert!(missed.is_empty(), "{} of {} missed: {missed:#?}", missed.len(), rounds());
}

/// The same moves, as far from a touch as they were in.
fn near_miss(kind: usize, random: &mut Random) -> (u32, String) {
    let tool = 1 + u32::from(random.share() < 0.5);
    let off = random.between(2.0 * RESOLUTION, 4.0);
    let (x, y) = (random.between(20.0, 80.0), random.between(30.0, 50.0));
    let blocks = match kind {
        0 => format!("G0 X-30. Y50.\nG0 Z{off:.3}\nX{x:.3}\n"),
        1 => format!("G0 X{x:.3} Y{y:.3}\nZ{off:.3}\n"),
        // In the slot that is cut, at its own depth.
        2 => "G0 X30. Y10.\nZ-3.\nX60.\n".to_string(),
        // Beside the clamp.
        3 => format!("G0 X-40. Y{:.3}\nZ0\nX-12.\n", 20.0 - 15.0 - off),
        4 => format!("G0 X-40. Y30.\nZ{:.3}\nX-12.\n", 10.0 + off),
        // Above the target.
        _ => format!("G0 X{x:.3} Y{y:.3}\nG1 Z-{:.3} F200.\n", 5.0 - off.min(4.5)),
    };
    (tool, blocks)
}

#[test]
fn near_misses_are_not_reported() {
    for seed in 1..=rounds() {
        let mut random = Random::new(seed);
        let (tool, blocks) = near_miss(seed as usize % 6, &mut random);
        let found = run(SETUP, &program(tool, &blocks));
        let said: Vec<&str> = found.problems.iter().map(|each| each.code.info().name).collect();
        let sure = said.iter().filter(|name| **name != "stock-not-proved").count();
        assert_eq!(sure, 0, "seed {seed}: {said:?} in\n{blocks}");
    }
}

const PLAIN: &str = r#"
machine = "haas-vf2"
[stock]
shape = "box"
from = { X = "0 mm", Y = "0 mm", Z = "-30 mm" }
to = { X = "100 mm", Y = "60 mm", Z = "0 mm" }
[tools.1]
shape = "flat"
diameter = "10 mm"
flute_length = "12 mm"
"#;

#[test]
fn volumes_enclose_the_truth_and_clean_is_proved() {
    // A slot of 60 mm with round ends, 5 mm deep.
    let found = run(
        PLAIN,
        "O1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X20. Y30.\nG43 H1 Z5.\nG1 Z-5. F200.\nX80. F600.\nG0 Z5.\nM30\n",
    );
    let truth = (600.0 + 25.0 * PI) * 5.0;
    let removed = found.removed_mm3;
    assert!(removed.least <= truth && truth <= removed.most, "{removed:?} for {truth}");
    // Its walls are known to a cell.
    assert!(removed.most - removed.least < 0.25 * truth, "{removed:?}");
    assert_eq!(found.verdict, StockVerdict::Clean, "{:#?}", found.problems);
    assert_eq!(found.tools[0].number, 1);
    assert_eq!(found.tools[0].lowest_mm, -5.0);
    let all = 100.0 * 60.0 * 30.0;
    assert!(found.left_mm3.least <= all - truth && all - truth <= found.left_mm3.most);
}

#[test]
fn what_is_not_known_is_not_clean() {
    let moves = "G0 X20. Y30.\nG43 H1 Z5.\nG1 Z-5. F200.\nX80. F600.\nG0 Z5.\nM30\n";
    // A tool without a shape.
    let unknown = PLAIN.replace("shape = \"flat\"\n", "");
    let found = run(&unknown, &format!("O1\nG21 G90 G54\nT1 M6\nS3000 M3\n{moves}"));
    assert_eq!(found.verdict, StockVerdict::NotProved);
    // Nobody knows what it removes: between nothing and all.
    assert_eq!((found.removed_mm3.least, found.left_mm3.least), (0.0, 0.0));
    assert!(found.removed_mm3.most >= 100.0 * 60.0 * 30.0);
    assert!(
        found.report.diagnostics.iter().any(|each| each.code.info().name == "tool-without-shape")
    );
    // A spindle that stands.
    let found = run(PLAIN, &format!("O1\nG21 G90 G54\nT1 M6\n{moves}"));
    assert_eq!(names(&found, 6), ["cuts-without-spindle"]);
    // No stock.
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", b"O1\nG21 G90\nM30\n".as_slice()));
    let job = Job::new(sources, machine("machine = 'haas-vf2'\n")).expect("settings");
    assert!(job.stock(&StockOptions::default(), &|_| Err(String::new())).is_err());
}

#[test]
fn a_gouge_and_a_fixture_are_called_what_they_are() {
    let said = |blocks: &str, name: &str| {
        let found = run(SETUP, &program(1, blocks));
        let diagnostics = found.report.diagnostics;
        let named = diagnostics.into_iter().find(|each| each.code.info().name == name);
        named.map(|each| each.message).unwrap_or_default()
    };
    let gouge = said("G0 X50. Y40.\nG1 Z-8. F200.\n", "gouge");
    assert!(gouge.starts_with("tool 1 cuts") && gouge.ends_with("deep into the part"), "{gouge}");
    let clamp = said("G0 X-40. Y30.\nZ5.\nX-12.\n", "fixture-hit");
    assert_eq!(clamp, "tool 1 or its holder touches `clamp`");
}

/// Tiles in any order, what they find in any order, on threads: the same answers to the bit.
#[test]
fn tiles_may_be_cut_on_threads() {
    let text = program(1, "G0 X50. Y40.\nG1 Z-9. F200.\nG3 X30. Y40. I-10. J0.\nG0 X80. Y50.\n");
    let told = |runner: &JobRunner<'_>| {
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
        let job = Job::new(sources, machine(SETUP)).expect("settings of the control");
        let options = StockOptions { resolution_mm: Some(0.25), ..StockOptions::default() };
        let found = job.stock_by(&options, &|_| Err(String::new()), runner).expect("stock");
        assert!(!found.problems.is_empty());
        let StockReport { problems, removed_mm3, left_mm3, refined, target, tools, .. } = found;
        let heights = format!("{:?}", found.stock.height_pairs());
        (problems, removed_mm3, left_mm3, refined, target, tools, heights)
    };
    let one = told(&|tiles| tiles.into_iter().map(TileJob::run).collect());
    let backwards = told(&|tiles| tiles.into_iter().rev().map(TileJob::run).collect());
    let each_on_its_own = told(&|tiles| {
        std::thread::scope(|scope| {
            let threads: Vec<_> =
                tiles.into_iter().map(|tile| scope.spawn(|| tile.run())).collect();
            threads.into_iter().map(|thread| thread.join().expect("a tile")).collect()
        })
    });
    assert!(one == backwards && one == each_on_its_own);
}

const THREADED: &str = "O1\nG21 G90 G17 G54\nT1 M6\nS3000 M3\nG0 X50. Y30.\nG43 H1 Z5.\nG1 Z-20. F300.\n\
G91 G1 X6. F600.\nG3 I-6. J0. Z0.\nG1 X-6.\nG90 G0 Z5.\nT2 M6\nS3000 M3\nG0 X50. Y30.\nG43 H2 Z5.\nG1 Z-15. F300.\n\
G91 G1 X7.8 F300.\nG3 I-7.8 J0. Z1.5\nG1 X-7.8\nG90 G0 Z5.\nM30\n";

/// A bore of R11, and a turn of two teeth of pitch 1.5 in it.
#[test]
fn a_thread_mill_cuts_its_thread() {
    let setup = "machine = 'haas-vf2'\n[stock]\nshape = 'box'\n\
        from = { X = '30 mm', Y = '10 mm', Z = '-20 mm' }\nto = { X = '70 mm', Y = '50 mm', Z = '0 mm' }\n\
        [tools.1]\nshape = 'flat'\ndiameter = '10 mm'\nflute_length = '25 mm'\n\
        [tools.2]\nshape = 'thread mill'\ndiameter = '8 mm'\npitch = '1.5 mm'\nteeth = 2\nflute_length = '6 mm'\n\
        shank_diameter = '6 mm'\n";
    let found = run(setup, THREADED);
    let thread = found.tools[1].removed_mm3;
    // The disc reaches R11.8, so 0.8 beyond the bore: of the area of that ring, and less than a height of 6 mm.
    let ring = PI * (11.8_f64.powi(2) - 11.0_f64.powi(2)) * 6.0;
    assert!(thread.least < ring && thread.most > 0.2 * ring, "{thread:?} {ring}");
    assert!(found.stock.has_gaps());
    surface_of(&found);
    assert!(found.problems.iter().all(|problem| problem.code.info().name == "stock-not-proved"));
}

/// The part that is left, as a closed surface.
fn surface_of(found: &StockReport) -> Mesh {
    assert!(found.has_undersides());
    let mesh = found.surface(0.1 * RESOLUTION).expect("a surface").mesh;
    assert!(mesh.edges().are_paired(), "{:?}", mesh.edges());
    let volume = mesh.volume();
    assert!(found.left_mm3.least <= volume && volume <= found.left_mm3.most, "{volume}");
    mesh
}

const T_SLOT: &str = r#"
machine = "haas-vf2"
[stock]
shape = "box"
from = { X = "0 mm", Y = "-30 mm", Z = "-20 mm" }
to = { X = "100 mm", Y = "30 mm", Z = "0 mm" }
[tools.1]
shape = "flat"
diameter = "10 mm"
flute_length = "25 mm"
[tools.2]
shape = "t-slot"
diameter = "20 mm"
flute_length = "4 mm"
shank_diameter = "9 mm"
"#;

/// Passes along X at Z-12, each with a tool.
fn passes(tools: &[u32]) -> String {
    let pass = |tool: &u32| {
        format!(
            "T{tool} M6\nS1000 M3\nG0 X-20. Y0.\nG43 H{tool} Z5.\nG0 Z-12.\nG1 X120. F600.\nG0 Z20.\n"
        )
    };
    format!("O1\nG21 G90 G54\n{}M30\n", tools.iter().map(pass).collect::<String>())
}

#[test]
fn an_undercut_is_in_the_target_or_goes_into_it() {
    let both = passes(&[1, 2]);
    let part = |program: &str| {
        let found = run(T_SLOT, program);
        let mesh = match found.intervals() {
            Some(_) => surface_of(&found),
            None => box_with_a_slot(),
        };
        write_stl(&mesh, LengthUnit::Millimetre).expect("STL")
    };
    let setup = format!("{T_SLOT}[target]\nfile = 'part.stl'\ntolerance = '0.6 mm'\n");
    // The part has the undercut: nothing goes into it, and nothing is left over but for walls.
    let with = part(&both);
    let found = run_with(&setup, &both, &with);
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.problems);
    let left_over = found.target.expect("a target").left_over_mm3;
    assert!(left_over.least < 500.0 && left_over.most < 5_000.0, "{left_over:?}");
    // Without the second tool the undercut is left over: 4 × 10 × 100.
    let found = run_with(&setup, &passes(&[1]), &with);
    let left_over = found.target.expect("a target").left_over_mm3;
    assert!(left_over.least > 3_000.0, "{left_over:?}");
    assert!(left_over.least <= 4_000.0 && 4_000.0 <= left_over.most, "{left_over:?}");
    // The part has a slot alone: the undercut goes into its walls.
    let found = run_with(&setup, &both, &part(&passes(&[1])));
    assert_eq!(found.verdict, StockVerdict::Problems);
    assert!(codes(&found).contains(&"CH626"), "{:?}", found.problems);
    let gouge = found.problems.iter().find(|each| each.tool == 2).expect("a gouge");
    assert!(gouge.depth_mm.least > 2.0 && gouge.depth_mm.most < 6.0, "{gouge:?}");
}

#[test]
fn form_tools_go_into_the_target_or_are_proved_clean() {
    let form = "[tools.3]\nshape = 'form'\n\
                profile = [['0 mm', '1 mm'], ['0 mm', '3 mm'], ['4 mm', '3 mm'], ['4.5 mm', '6 mm']]\n";
    let setup = format!("{SETUP}{form}");
    // The target is full below -5, and may be cut 0.2 deeper: by the step at 4 mm, too.
    let at = |z: f64| format!("G0 X-30. Y50.\nZ{z:.3}\nG1 X130. F800.\n");
    let found = run(&setup, &program(1, &format!("T3 M6\nS3000 M3\nG43 H3 Z20.\n{}", at(-5.15))));
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.problems);
    for (z, deep) in [(-5.5, 0.5), (-8.0, 3.0)] {
        let found = run(&setup, &program(1, &format!("T3 M6\nS3000 M3\nG43 H3 Z20.\n{}", at(z))));
        let gouge = found.problems.iter().find(|each| each.code.info().id == "CH626");
        let gouge = gouge.expect("a gouge").depth_mm;
        assert!(gouge.least <= deep && deep <= gouge.most + 1e-6, "{z} {gouge:?}");
        assert!(gouge.least > deep - 0.21, "{z} {gouge:?}");
    }
}

/// A slot 10 wide, and what a tool leaves of its walls on a line at a Y, or straight down at that place.
fn in_the_slot(tool: &str, y: f64, blocks: &str) -> StockReport {
    let setup =
        format!("{T_SLOT}[tools.3]\n{tool}\n[target]\nfile = 'part.stl'\ntolerance = '0.3 mm'\n");
    let program = format!(
        "O1\nG21 G90 G54\nT3 M6\nS900 M3\nG0 X50. Y{y:.3}\nG43 H3 Z20.\n{blocks}G0 Z20.\nM30\n"
    );
    let mesh = write_stl(&box_with_a_slot(), LengthUnit::Millimetre).expect("STL");
    run_with(&setup, &program, &mesh)
}

#[test]
fn taps_and_thread_mills_are_compared_with_the_target() {
    let tap = |diameter: f64| {
        let tool = format!(
            "shape = 'tap'\ndiameter = '{diameter} mm'\npitch = '1.5 mm'\nflute_length = '30 mm'"
        );
        in_the_slot(&tool, 0.0, "G1 Z-10. F100.\nZ20.\n")
    };
    // 9 fits into 10; of 10.8 the core of 9.18 does, and the thread is 0.4 in the walls; of 13 the core is 0.69 in them.
    assert_eq!(tap(9.0).verdict, StockVerdict::Clean);
    let between = tap(10.8);
    assert_eq!(between.verdict, StockVerdict::NotProved, "{:?}", between.problems);
    assert!(codes(&between).contains(&"CH629"));
    assert!(codes(&tap(13.0)).contains(&"CH626"));
    let mill = "shape = 'thread mill'\ndiameter = '6 mm'\npitch = '2 mm'\nteeth = 3\nshank_diameter = '3 mm'";
    let on = |y: f64| in_the_slot(mill, y, "G1 Z-5. F100.\nX60. F300.\nZ20.\n");
    let found = on(1.9);
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.problems);
    // 0.2 of the crests in the wall is within the tolerance; of 0.9 the core is clear of the wall and teeth are in it.
    let found = on(2.2);
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.problems);
    let found = on(2.9);
    assert!(codes(&found).contains(&"CH626"), "{:?}", found.problems);
}

#[test]
fn what_a_tap_leaves_is_between_its_core_and_its_thread() {
    let setup = format!(
        "{T_SLOT}[tools.3]\nshape = 'tap'\ndiameter = '12 mm'\npitch = '1.75 mm'\nflute_length = '30 mm'\n"
    );
    let program =
        "O1\nG21 G90 G54\nT3 M6\nS300 M3\nG0 X50. Y0.\nG43 H3 Z20.\nG1 Z-10. F500.\nZ20.\nM30\n";
    let removed = run(&setup, program).removed_mm3;
    let core: f64 = 12.0 - 2.0 * 0.541_265_877 * 1.75;
    let [core, whole] = [core, 12.0].map(|diameter| PI / 4.0 * diameter * diameter * 10.0);
    assert!(removed.least <= core && whole <= removed.most, "{removed:?}");
    assert!(removed.least > 0.8 * core && removed.most < 1.2 * whole, "{removed:?}");
    // A rapid back into the core goes through the thread.
    let back = program.replace("Z20.\nM30", "Z20.\nG0 X50. Z-10.\nM30");
    assert!(codes(&run(&setup, &back)).iter().any(|code| ["CH620", "CH629"].contains(code)));
}

/// 100 × 60 × 20 mm with a slot of 10 × 12 along X.
fn box_with_a_slot() -> Mesh {
    let mut intervals = SolidIntervals::default();
    for row in 0..120 {
        let is_slot = (50..70).contains(&row);
        (0..200).for_each(|_| intervals.push([[0.0, if is_slot { 8.0 } else { 20.0 }]]));
    }
    let origin = Vec3::new(0.0, -30.0, -20.0);
    let (size, intervals) = ([100.0, 60.0], &intervals);
    let field = LayerField { origin, cell: 0.5, columns: 200, rows: 120, size, intervals };
    field.mesh(0.0).expect("a surface").mesh
}

/// A bar about the axis of a rotary table.
const BAR: &str = r#"
machine = "haas-vf2"
[axes.A]
[rotary.A]
turns = "table"
[stock]
shape = "box"
from = { X = "0 mm", Y = "-20 mm", Z = "-15 mm" }
to = { X = "100 mm", Y = "20 mm", Z = "15 mm" }
[tools.1]
shape = "flat"
diameter = "10 mm"
flute_length = "30 mm"
"#;

/// Cuts at angles of A, each from a safe place: blocks between are at that angle.
fn indexed(sides: &[(&str, &str)]) -> String {
    let side = |(angle, blocks): &(&str, &str)| format!("G0 Z60.\nG0 A{angle}\n{blocks}");
    let sides: String = sides.iter().map(side).collect();
    format!(
        "O1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X-20. Y0. A0.\nG43 H1 Z60.\n{sides}G0 Z60.\nM30\n"
    )
}

fn codes(found: &StockReport) -> Vec<&'static str> {
    found.report.diagnostics.iter().map(|each| each.code.info().id).collect()
}

const SLOT: &str = "G0 X-20. Y0.\nZ10.\nG1 X120. F600.\n";

#[test]
fn a_part_is_cut_from_several_sides() {
    let deep = SLOT.replace("Z10.", "Z15.");
    let sides = [("0.", SLOT), ("90.", &deep), ("180.", SLOT), ("450.", &deep)];
    let found = run(BAR, &indexed(&sides));
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
    assert_eq!(found.sides, 3);
    // Three slots of 5 × 10 × 100; no one alone is more.
    let removed = found.removed_mm3;
    assert!(removed.least <= 15_000.0 && 15_000.0 <= removed.most, "{removed:?}");
    // Walls are known to a column of half a millimetre.
    assert!(removed.least > 4_499.0 && removed.most < 16_501.0, "{removed:?}");
    let left = found.left_mm3;
    assert!(left.least <= 105_000.0 && 105_000.0 <= left.most, "{left:?}");
    // The part with all slots as one closed surface.
    let volume = surface_of(&found).volume();
    assert!((volume - 105_000.0).abs() < 1_000.0, "{volume}");
    // The slot of A90 goes into one of the sides along Y, from 10 to 20 mm above the bottom.
    let intervals = found.intervals().expect("cut from other sides");
    let sides = [0, 79].map(|row| intervals.of(row * 200 + 100));
    let slotted = sides.iter().find(|side| side.len() == 2).expect("a slot");
    // A wall is known to a column, and its place along another one to a 64th of it.
    let near = |a: f64, b: f64| (a - b).abs() <= RESOLUTION * (1.0 + 1.0 / 64.0);
    assert!(near(slotted[0][1], 10.0) && near(slotted[1][0], 20.0), "{slotted:?}");
    assert!(sides.iter().any(|side| side.len() == 1));
}

#[test]
fn touches_from_several_sides_are_sure_or_not_proved_and_never_clean() {
    // 10 mm deep into a side that nothing else has cut.
    let found = run(BAR, &indexed(&[("0.", SLOT), ("90.", "G0 X50. Y0.\nZ10.\n")]));
    assert_eq!(found.verdict, StockVerdict::Problems);
    let hit = &found.problems[0];
    assert_eq!(hit.code.info().name, "rapid-through-stock");
    assert!(hit.depth_mm.least > 9.9 && hit.depth_mm.most < 10.1, "{hit:?}");
    // Through what the first side has removed: the tool is in air.
    let step = "G0 X-20. Y-5.\nZ10.\nG1 X120. F600.\nG0 Y-14.\nG1 X-20.\nG0 Y-18.\nG1 X120.\n";
    let through = "G0 X-20. Y16.\nZ1.\nG0 X120.\n";
    let found = run(BAR, &indexed(&[("0.", step), ("90.", through)]));
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.problems);
    // A millimetre deeper than that, and where something of the first side is cut after it, it is not.
    let deeper = through.replace("Z1.", "Z-1.");
    let half = &step[..step.find("G0 Y-14.").unwrap()];
    for sides in [
        [("0.", step), ("90.", &deeper), ("0.", "")],
        [("0.", half), ("90.", through), ("0.", step)],
        [("90.", through), ("0.", step), ("0.", "")],
    ] {
        let found = run(BAR, &indexed(&sides));
        assert_eq!(found.verdict, StockVerdict::NotProved, "{sides:?} {:?}", found.problems);
        assert!(codes(&found).contains(&"CH629"));
    }
    // Without the step it is a touch.
    let found = run(BAR, &indexed(&[("90.", through)]));
    assert_eq!(found.verdict, StockVerdict::Problems);
}

#[test]
fn sides_in_turn_know_what_the_others_have_removed_since() {
    let slot = SLOT.replace("Z10.", "Z15.");
    let step = "G0 X-20. Y-5.\nZ10.\nG1 X120. F600.\nG0 Y-14.\nG1 X-20.\nG0 Y-18.\nG1 X120.\n";
    let half = &step[..step.find("G0 Y-14.").unwrap()];
    let through = "G0 X-20. Y16.\nZ1.\nG0 X120.\n";
    let verdict = |sides: &[(&str, &str)]| {
        let found = run(BAR, &indexed(sides));
        let removed = found.removed_mm3;
        assert!(removed.least <= removed.most, "{removed:?}");
        (found.verdict, removed)
    };
    // The other half of the step is cut while the second side waits for its rapid through it.
    let (clean, removed) = verdict(&[("0.", half), ("90.", &slot), ("0.", step), ("90.", through)]);
    assert_eq!(clean, StockVerdict::Clean);
    // A step of 5 × 20 × 100 and a slot of 5 × 10 × 100, which do not meet.
    assert!(removed.least <= 15_000.0 && 15_000.0 <= removed.most, "{removed:?}");
    assert!(removed.least > 9_000.0 && removed.most < 17_000.0, "{removed:?}");
    // Before that it is there.
    for sides in [
        [("0.", half), ("90.", &*slot), ("90.", through), ("0.", step)],
        [("90.", &*slot), ("0.", half), ("90.", through), ("0.", step)],
    ] {
        assert_eq!(verdict(&sides).0, StockVerdict::NotProved, "{sides:?}");
    }
    // However often the sides change: what comes later is never known.
    let mut often: Vec<(&str, &str)> = Vec::new();
    for _ in 0..9 {
        often.extend([("0.", half), ("90.", &*slot)]);
    }
    often.extend([("90.", through), ("0.", step)]);
    assert_eq!(verdict(&often).0, StockVerdict::NotProved);
}

#[test]
fn what_several_sides_remove_adds_up_where_one_follows_the_other() {
    // Two steps of 5 × 9 × 100 and a slot of 5 × 10 × 100; none meets another.
    let step = |y: &str, z: &str| format!("G0 X-20. Y{y}\nZ{z}\nG1 X120. F600.\n");
    let sides =
        [("0.", step("-16.", "10.")), ("180.", step("-16.", "10.")), ("90.", step("0.", "15."))];
    let sides = sides.each_ref().map(|(angle, blocks)| (*angle, blocks.as_str()));
    let found = run(BAR, &indexed(&sides));
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
    let removed = found.removed_mm3;
    assert!(removed.least <= 14_000.0 && 14_000.0 <= removed.most, "{removed:?}");
    // The slot begins with what the first step has left: both are known, but for a column along each wall.
    assert!(removed.least > 7_500.0, "{removed:?}");
}

#[test]
fn a_part_that_turns_must_be_clear_of_the_tool() {
    // Its corners are 25 mm from the axis.
    let turned_at = |z: &str| format!("G0 X50. Y0.\nZ{z}\nA45.\nA0.\n");
    let found = run(BAR, &indexed(&[("0.", &turned_at("25.01"))]));
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
    let found = run(BAR, &indexed(&[("0.", &turned_at("24.9"))]));
    assert_eq!(found.verdict, StockVerdict::NotProved);
    assert!(codes(&found).contains(&"CH630"));
    let cut = "G0 X50. Y0.\nZ10.\nG1 X60. A90. F300.\nG0 X-20.\n";
    assert!(codes(&run(BAR, &indexed(&[("0.", cut)]))).contains(&"CH630"));
    // Where it is not known what A turns, nothing at an angle is followed; at zero everything is.
    let unknown =
        BAR.replace("[rotary.A]\nturns = \"table\"\n", "").replace("haas-vf2", "linuxcnc-mill");
    let found = run(&unknown, &indexed(&[("90.", SLOT)]));
    assert_eq!(found.verdict, StockVerdict::NotProved);
    let said = |each: &chordal::Diagnostic| each.message.contains("[rotary.A]");
    assert!(found.report.diagnostics.iter().any(said));
    assert_eq!(found.removed_mm3.least, 0.0);
    assert_eq!(found.removed_mm3.most, found.left_mm3.most);
    assert_eq!(run(&unknown, &indexed(&[("0.", SLOT)])).verdict, StockVerdict::Clean);
}

/// The same bar on the tables of a trunnion: A goes through it 20 mm below its zero, C through its zero.
const TRUNNION_BAR: &str = r#"
machine = "fanuc-ac-trunnion"
[rotary.A]
point = { Y = "-200 mm", Z = "-400 mm" }
[rotary.C]
point = { X = "-300 mm", Y = "-200 mm" }
[work_offsets.G54]
X = "-300 mm"
Y = "-200 mm"
Z = "-380 mm"
[stock]
shape = "box"
from = { X = "0 mm", Y = "-20 mm", Z = "-15 mm" }
to = { X = "100 mm", Y = "20 mm", Z = "15 mm" }
[tools.1]
shape = "flat"
diameter = "10 mm"
length = "100 mm"
flute_length = "30 mm"
"#;

/// Blocks in the plane of the side at Y-20, with the tool upright on it: Y of the plane is Z of the part.
fn on_the_side(blocks: &str) -> String {
    format!(
        "O1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X-20. Y0. A0. C0.\nG43 H1 Z100.\n\
         G68.2 X0 Y-20. Z0 I0 J90. K0\nG53.1\nG0 X-20. Y0. Z50.\n{blocks}G0 Z50.\nG69\nM30\n"
    )
}

#[test]
fn a_tilted_plane_is_cut_like_a_side_that_faces_the_spindle() {
    let found = run(TRUNNION_BAR, &on_the_side("Z-5.\nG1 X120. F600.\n"));
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
    // A slot of 5 × 10 × 100, whose walls are known to a column.
    let removed = found.removed_mm3;
    assert!(removed.least <= 5_000.0 && 5_000.0 <= removed.most, "{removed:?}");
    assert!(removed.least > 4_000.0 && removed.most < 6_000.0, "{removed:?}");
    // The same slot without a plane: Y of the machine is Y of the plane seen from A90, 20 mm farther out.
    let plain = "O1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X-20. Y0. A0. C0.\nG43 H1 Z100.\nA90.\n\
                 G0 X-20. Y20. Z50.\nZ-5.\nG1 X120. F600.\nG0 Z50.\nM30\n";
    let same = run(TRUNNION_BAR, plain);
    assert_eq!(same.verdict, StockVerdict::Clean, "{:?}", same.report.diagnostics);
    let near = |a: f64, b: f64| (a - b).abs() < 200.0;
    assert!(near(same.removed_mm3.least, removed.least), "{:?} {removed:?}", same.removed_mm3);
    // Under tool centre point control the same place, by the coordinates of the part.
    let by_tip = "O1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X-20. Y0. A0. C0.\nG43 H1 Z100.\nA90.\n\
                  G43.4 H1\nG0 X-20. Y-70. Z0\nY-15.\nG1 X120. F600.\nG0 Y-70.\nG49\nM30\n";
    let tip = run(TRUNNION_BAR, by_tip);
    assert_eq!(tip.verdict, StockVerdict::Clean, "{:?}", tip.report.diagnostics);
    assert!(near(tip.removed_mm3.least, removed.least), "{:?} {removed:?}", tip.removed_mm3);
}

#[test]
fn a_touch_in_a_tilted_plane_is_found_and_a_tool_that_turns_above_the_part_is_clear() {
    let found = run(TRUNNION_BAR, &on_the_side("G0 X50. Z-10.\n"));
    assert_eq!(found.verdict, StockVerdict::Problems);
    let hit = &found.problems[0];
    assert_eq!(hit.code.info().name, "rapid-through-stock");
    assert!(hit.depth_mm.least > 9.9 && hit.depth_mm.most < 10.1, "{hit:?}");
    // A tool that turns above the part is clear of it; nothing is said of how it turns where its axes are not known.
    let turning = "O1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X-20. Y0. A0. C0.\nG43.4 H1 Z100.\n\
                   G1 X120. Z40. A60. F600.\nG49\nM30\n";
    let found = run(TRUNNION_BAR, turning);
    assert_eq!(found.verdict, StockVerdict::Clean, "{:?}", found.report.diagnostics);
    assert_eq!(found.removed_mm3.most, 0.0);
}
