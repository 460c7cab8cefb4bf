//! Commands of a machine whose X is programmed as a diameter: places and centres are written as the
//! program writes them, radii, lengths and feeds are those of the slide; setpoints are the slide's.

use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use chordal::{Command, Job, Machine, Source, SourceMap};
use chordal_export::columns::{CommandColumns, PathColumns, RowBatcher};
use chordal_export::{CommandJsonLines, CommandWriter, OutputFormat};

/// X 50 and 60 across, then a quarter of radius 5 about X 70 Z 0: from r 30 to r 35.
const PART: &str = "G21 G90 G18 G94 S500 M3\nG0 X50. Z0\nG1 X60. F100.\nG2 X70. Z-5. I5. K0\nM30\n";

const QUARTER: f64 = 2.5 * std::f64::consts::PI;

fn job() -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", PART.as_bytes()));
    let text = "control = 'fanuc'\n[axes.X]\nprogrammed = 'diameter'\n[axes.Z]\n[axes.C]";
    let machine = Machine::from_toml("lathe.toml", text, &|name| Err(format!("no {name}")));
    Job::new(sources, machine.expect("a good machine")).expect("its settings are known")
}

#[test]
fn columns() {
    let job = job();
    let mut columns = CommandColumns::new(&job);
    job.report_of_commands(|command: &Command| columns.command(command));
    let batch = columns.take().expect("a batch");
    let known = |name: &str| -> Vec<f64> {
        let column = batch.column_by_name(name).expect(name);
        column.as_primitive::<Float64Type>().iter().flatten().collect()
    };
    assert_eq!(known("x_to_mm"), [50.0, 60.0, 70.0]);
    assert_eq!(known("z_to_mm"), [0.0, 0.0, -5.0]);
    // The plane's axes are Z and X.
    assert_eq!((known("center_a_mm"), known("center_b_mm")), (vec![0.0], vec![70.0]));
    assert_eq!((known("radius_from_mm"), known("radius_to_mm")), (vec![5.0], vec![5.0]));
    let lengths = known("length_mm");
    assert_eq!(lengths[0], 5.0);
    assert!((lengths[1] - QUARTER).abs() < 1e-12, "{lengths:?}");
    assert_eq!(known("feed_mm_per_min"), [100.0, 100.0]);
    let schema = batch.schema();
    assert_eq!(schema.metadata().get("chordal.diameter").map(String::as_str), Some("X"));
}

#[test]
fn the_exact_path_is_the_slides() {
    let job = job();
    let mut columns = PathColumns::new(&job);
    job.report_with(|_, segments| segments.iter().for_each(|segment| columns.segment(segment)));
    let batch = columns.take().expect("a batch");
    let column = batch.column_by_name("x_to_mm").expect("x_to_mm");
    let x: Vec<Option<f64>> = column.as_primitive::<Float64Type>().iter().collect();
    assert_eq!(x, [Some(25.0), Some(30.0), Some(35.0)]);
}

#[test]
fn csv_and_json() {
    let job = job();
    let mut csv = CommandWriter::new(Vec::new(), OutputFormat::Csv, &job, false).expect("a header");
    let mut json = CommandJsonLines::new(Vec::new(), &job).expect("a header");
    job.report_of_commands(|command: &Command| {
        csv.command(command).expect("a row");
        json.command(command).expect("a row");
    });
    let csv = String::from_utf8(csv.finish().expect("all")).expect("text");
    let arc = csv.lines().find(|line| line.contains(",arc,")).expect("an arc");
    let cells: Vec<&str> = arc.split(',').collect();
    // From X60 to X70 about X70, radius 5.
    assert_eq!((cells[2], cells[8], cells[16], cells[19]), ("60", "70", "70", "5"), "{arc}");
    let json = String::from_utf8(json.finish().expect("all")).expect("text");
    assert!(json.starts_with("{\"schema\":\"chordal.commands/1\""), "{json}");
    assert!(
        json.lines().next().is_some_and(|head| head.ends_with("\"diameter\":[\"X\"]}")),
        "{json}"
    );
    let arc = json.lines().find(|line| line.contains("\"arc\"")).expect("an arc");
    assert!(arc.contains("\"center\":{\"Z\":0,\"X\":70}"), "{arc}");
}
