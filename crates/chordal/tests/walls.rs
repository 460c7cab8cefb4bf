//! Surfaces of what is left: no ledge in a wall. A face that looks straight up or down lies at a height that the tip of a
//! tool, one of its shoulders or the stock has.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use chordal::stock::mesh::write::write_stl;
use chordal::stock::mesh::{LengthUnit, Mesh, StlOptions, read_stl};
use chordal::stock::{StockOptions, StockReport};
use chordal::{Job, Machine, Source, SourceMap};

/// Two resolutions, mm: one that the parts are multiples of, and one that leaves a narrow last column.
const RESOLUTIONS: [f64; 2] = [0.5, 0.37];
/// Tops are joined that differ by no more, as a share of the resolution: as `chordal stock -o` does.
const JOINED: f64 = 0.1;
/// Heights are rounded to a 1024th of a millimetre where there are undersides, which lie half of that between.
const ROUNDING: f64 = 1.0 / 1024.0;
/// Area of one height that is less than this is rounding of coordinates, mm²: a column has a tenth of a square
/// millimetre and more.
const LEAST_AREA: f64 = 1e-6;
/// Faces that are steeper are walls.
const LEVEL: f64 = 0.99;

/// Where a face may be that looks up or down.
type Level = [f64; 2];

struct Part {
    name: &'static str,
    stock: &'static str,
    blocks: String,
    /// Heights, from and to, mm. The bottom of the stock is at -20, and its top at 0.
    levels: Vec<Level>,
    /// The area of the faces that look up at a height, by hand, mm².
    area: Option<(f64, f64)>,
}

const BOX: &str = "shape = 'box'\nfrom = { X = '0 mm', Y = '0 mm', Z = '-20 mm' }\n\
                   to = { X = '80 mm', Y = '60 mm', Z = '0 mm' }\n";
const TUBE: &str = "shape = 'tube'\naxis = 'Z'\ndiameter = '50 mm'\nbore = '16 mm'\n\
                    from = { X = '0 mm', Y = '0 mm', Z = '-20 mm' }\nto = { Z = '0 mm' }\n";
const INCH: &str = "shape = 'box'\nfrom = { X = '0 in', Y = '0 in', Z = '-0.75 in' }\n\
                    to = { X = '3.25 in', Y = '2.125 in', Z = '0 in' }\n";

const TOOLS: &str = "
[tools.1]
shape = 'flat'
diameter = '10 mm'
flute_length = '30 mm'
[tools.2]
shape = 'ball'
diameter = '8 mm'
flute_length = '30 mm'
[tools.3]
shape = 'drill'
diameter = '8 mm'
point_angle = '118 deg'
flute_length = '40 mm'
[tools.4]
shape = 't-slot'
diameter = '20 mm'
flute_length = '4 mm'
shank_diameter = '9 mm'
[tools.5]
shape = 'bull'
diameter = '10 mm'
corner_radius = '2 mm'
flute_length = '30 mm'
[tools.6]
shape = 'chamfer'
diameter = '12 mm'
point_angle = '90 deg'
flute_length = '6 mm'
[tools.7]
shape = 'lollipop'
diameter = '12 mm'
shank_diameter = '6 mm'
[tools.8]
shape = 'form'
profile = [['0 mm', '3 mm'], ['4 mm', '3 mm'], ['4 mm', '6 mm'], ['20 mm', '6 mm']]
[tools.9]
shape = 'tap'
diameter = '12 mm'
pitch = '1.75 mm'
flute_length = '30 mm'
";

fn stock_of(part: &Part, resolution: f64) -> StockReport {
    let setup = format!("machine = 'haas-vf2'\n[stock]\n{}{TOOLS}", part.stock);
    let units = if part.stock == INCH { "G20" } else { "G21" };
    let program = format!("O1\n{units} G90 G17 G54\n{}M30\n", part.blocks);
    cut(&setup, program, resolution)
}

/// What a program leaves of the stock of a setup.
fn cut(setup: &str, program: String, resolution: f64) -> StockReport {
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("setup.toml", setup, &none).expect("a good setup");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.into_bytes()));
    let job = Job::new(sources, machine).expect("settings of the control");
    let options = StockOptions { resolution_mm: Some(resolution), ..StockOptions::default() };
    job.stock(&options, &|name| Err(format!("no file {name}"))).expect("stock")
}

/// Blocks of a tool, from a place above the part on.
fn tool(number: u32, x: f64, y: f64, blocks: &str) -> String {
    format!("T{number} M6\nS3000 M3\nG0 X{x:.4} Y{y:.4}\nG43 H{number} Z5.\n{blocks}\nG0 Z5.\n")
}

/// A cut along a line at a height.
fn line(number: u32, from: [f64; 2], to: [f64; 2], z: f64) -> String {
    let blocks = format!("G1 Z{z:.3} F300.\nX{:.4} Y{:.4} F800.", to[0], to[1]);
    tool(number, from[0], from[1], &blocks)
}

/// Around a rectangle about (40, 30), by half its sides.
fn around(half: [f64; 2], z: f64) -> String {
    let [x, y] = half;
    let blocks = format!(
        "G1 Z{z:.3} F300.\nX{right:.3} F800.\nY{back:.3}\nX{left:.3}\nY{front:.3}\nX{right:.3}",
        right = 40.0 + x,
        left = 40.0 - x,
        back = 30.0 + y,
        front = 30.0 - y
    );
    tool(1, 40.0 - x, 30.0 - y, &blocks)
}

fn part(name: &'static str, blocks: String, levels: &[Level]) -> Part {
    Part { name, stock: BOX, blocks, levels: levels.to_vec(), area: None }
}

fn at(z: f64) -> Level {
    [z, z]
}

const TOP: Level = [0.0, 0.0];
const BOTTOM: Level = [-20.0, -20.0];

fn parts() -> Vec<Part> {
    let slot = |z: f64| line(1, [-10.0, 31.3], [90.0, 31.3], z);
    let ring = "G1 Z-10. F300.\nX53.1 F800.\nG3 I-13.1 J0.\nG1 X40.";
    let turn = [20.0_f64.to_radians().cos(), 20.0_f64.to_radians().sin()];
    let across = |side: f64, along: f64| {
        [40.0 + along * turn[0] - side * turn[1], 30.0 + along * turn[1] + side * turn[0]]
    };
    vec![
        Part {
            area: Some((-10.0, 800.0)),
            ..part("a slot along X", slot(-10.0), &[TOP, at(-10.0), BOTTOM])
        },
        Part {
            area: Some((-4.0, 600.0)),
            ..part(
                "a slot along Y",
                line(1, [33.3, -10.0], [33.3, 70.0], -4.0),
                &[TOP, at(-4.0), BOTTOM],
            )
        },
        Part {
            area: Some((-10.0, 40.0 * 10.0 + 25.0 * PI)),
            ..part(
                "a slot at 30 degrees",
                line(1, [20.0, 20.0], [20.0 + 40.0 * 0.75_f64.sqrt(), 40.0], -10.0),
                &[TOP, at(-10.0), BOTTOM],
            )
        },
        Part {
            area: Some((-7.0, 800.0_f64.sqrt() * 10.0 + 25.0 * PI)),
            ..part(
                "a slot at 45 degrees",
                line(1, [30.05, 20.17], [50.05, 40.17], -7.0),
                &[TOP, at(-7.0), BOTTOM],
            )
        },
        Part {
            area: Some((-10.0, PI * 18.1 * 18.1 - PI * 8.1 * 8.1)),
            ..part(
                "a round groove",
                tool(1, 53.1, 30.0, "G1 Z-10. F300.\nG3 I-13.1 J0. F800."),
                &[TOP, at(-10.0), BOTTOM],
            )
        },
        part("a round pocket", tool(1, 40.0, 30.0, ring), &[TOP, at(-10.0), BOTTOM]),
        Part {
            area: Some((-4.0, 60.0 * 40.0 - 40.0 * 20.0 - (100.0 - 25.0 * PI))),
            ..part("an island", around([25.0, 15.0], -4.0), &[TOP, at(-4.0), BOTTOM])
        },
        part(
            "two depths",
            around([25.0, 15.0], -4.0) + &around([23.0, 13.0], -10.0),
            &[TOP, at(-4.0), at(-10.0), BOTTOM],
        ),
        part(
            "a pocket with round corners",
            tool(
                1,
                30.0,
                20.0,
                "G1 Z-10. F300.\nX50. F800.\nG3 X55. Y25. R5.\nG1 Y35.\nG3 X50. Y40. R5.\n\
                 G1 X30.\nG3 X25. Y35. R5.\nG1 Y25.\nG3 X30. Y20. R5.",
            ),
            &[TOP, at(-10.0), BOTTOM],
        ),
        Part {
            area: Some((-10.0, 800.0)),
            ..part(
                "crossing slots",
                slot(-10.0) + &line(1, [33.3, -10.0], [33.3, 70.0], -4.0),
                &[TOP, at(-4.0), at(-10.0), BOTTOM],
            )
        },
        part(
            "a deep groove of a ball mill",
            line(2, [-10.0, 30.1], [90.0, 30.1], -10.0),
            &[TOP, [-10.0, -6.0], BOTTOM],
        ),
        part(
            "a deep groove of a ball mill at 20 degrees",
            line(2, across(0.0, -30.0), across(0.0, 30.0), -11.0),
            &[TOP, [-11.0, -7.0], BOTTOM],
        ),
        part(
            "a groove of a bull mill",
            line(5, [20.0, 20.0], [60.0, 40.0], -10.0),
            &[TOP, [-10.0, -8.0], BOTTOM],
        ),
        part(
            "a chamfer cutter that goes deeper than its cone",
            line(6, [-10.0, 30.1], [90.0, 30.1], -9.0),
            &[TOP, [-9.0, -3.0], BOTTOM],
        ),
        part(
            "drilled holes",
            tool(3, 20.0, 20.0, "G81 X20. Y20. Z-12. R2. F200.\nX40.2 Y31.7\nG80"),
            // The cone of a drill of 8 with 118 degrees is 2.404 high.
            &[TOP, [-12.0, -9.59], BOTTOM],
        ),
        part(
            "drilled through",
            tool(3, 40.2, 31.7, "G81 X40.2 Y31.7 Z-25. R2. F200.\nG80"),
            &[TOP, BOTTOM],
        ),
        part(
            "a tapped hole",
            tool(9, 40.2, 31.7, "G1 Z-12. F500.\nZ5."),
            &[TOP, at(-12.0), BOTTOM],
        ),
        Part {
            // Under the shoulders, 20 wide, the floor of both.
            area: Some((-12.0, 1600.0)),
            ..part(
                "a T-slot",
                line(1, [-10.0, 30.3], [90.0, 30.3], -12.0)
                    + &line(4, [-15.0, 30.3], [95.0, 30.3], -12.0),
                &[TOP, at(-12.0), at(-8.0), BOTTOM],
            )
        },
        part(
            "a T-slot around a corner, at an angle",
            line(1, across(0.0, -60.0), across(0.0, 5.0), -12.0)
                + &tool(
                    4,
                    across(0.0, -75.0)[0],
                    across(0.0, -75.0)[1],
                    &format!(
                        "G1 Z-12. F300.\nX{:.4} Y{:.4} F300.\nX{:.4} Y{:.4}",
                        across(0.0, 0.0)[0],
                        across(0.0, 0.0)[1],
                        across(0.0, -75.0)[0],
                        across(0.0, -75.0)[1]
                    ),
                ),
            &[TOP, at(-12.0), at(-8.0), BOTTOM],
        ),
        part(
            "an undercut of a lollipop",
            line(1, [-10.0, 30.3], [90.0, 30.3], -12.0)
                + &line(7, [-15.0, 30.3], [95.0, 30.3], -15.0),
            &[TOP, at(-12.0), [-15.0, -3.0], BOTTOM],
        ),
        part(
            "a form tool with a shoulder",
            line(8, [15.0, 22.0], [60.0, 37.0], -9.0),
            &[TOP, at(-9.0), at(-5.0), BOTTOM],
        ),
        part(
            "a ramp in the ground",
            tool(1, 20.0, 22.0, "G1 Z-4. F300.\nX60. Y37. Z-10."),
            &[TOP, [-10.0, -4.0], BOTTOM],
        ),
        part(
            "a bore by a helix",
            tool(
                1,
                47.0,
                30.3,
                "G1 Z-4. F300.\nG3 I-7. J0. Z-6.\nI-7. J0. Z-8.\nI-7. J0. Z-10.\nI-7. J0.",
            ),
            &[TOP, [-10.0, -4.0], BOTTOM],
        ),
        Part {
            stock: INCH,
            area: Some((-0.28125 * 25.4, 3.25 * 25.4 * 10.0)),
            ..part(
                "a slot in inches",
                "T1 M6\nS3000 M3\nG0 X-1. Y1.\nG43 H1 Z.5\nG1 Z-.28125 F20.\nX4.5 F30.\nG0 Z1.\n"
                    .to_string(),
                &[TOP, at(-0.28125 * 25.4), at(-0.75 * 25.4)],
            )
        },
        Part {
            stock: TUBE,
            ..part("nothing cut of a tube", tool(1, 60.0, 0.0, ""), &[TOP, BOTTOM])
        },
        Part {
            stock: TUBE,
            ..part(
                "a step around a tube",
                tool(1, 40.0, 0.0, "G1 Z-6. F300.\nX26.3 F800.\nG2 I-26.3 J0."),
                &[TOP, at(-6.0), BOTTOM],
            )
        },
        part(
            "steps across the edge of the stock",
            line(1, [-10.0, 58.7], [90.0, 58.7], -3.0)
                + &line(1, [79.8, -10.0], [79.8, 70.0], -8.0)
                + &line(1, [-4.95, -10.0], [-4.95, 70.0], -13.0),
            &[TOP, at(-3.0), at(-8.0), at(-13.0), BOTTOM],
        ),
    ]
}

/// The area of level faces by their heights, mm²: of those that look up, and of those that look down.
fn level_areas(mesh: &Mesh) -> BTreeMap<i64, [f64; 2]> {
    let mut areas: BTreeMap<i64, [f64; 2]> = BTreeMap::new();
    for triangle in 0..mesh.triangles().len() {
        let [a, b, c] = mesh.corners(triangle);
        let across = (b - a).cross(c - a);
        let double = across.length();
        if double > 0.0 && across.z.abs() > LEVEL * double {
            let z = (a.z + b.z + c.z) / 3.0;
            let side = usize::from(across.z < 0.0);
            areas.entry((z * 1e6).round() as i64).or_default()[side] += 0.5 * double;
        }
    }
    areas
}

/// What is wrong with the surface of a part.
fn faults(part: &Part, resolution: f64) -> Vec<String> {
    let found = stock_of(part, resolution);
    let mut faults = Vec::new();
    let mut say = |is_right: bool, fault: String| {
        if !is_right {
            faults.push(format!("{} at {resolution}: {fault}", part.name));
        }
    };
    let tolerance = JOINED * resolution;
    let near = tolerance + ROUNDING;
    let made = found.surface(tolerance).expect("a surface");
    say(made.mesh.edges().are_paired(), format!("{:?}", made.mesh.edges()));
    // As a file that shares no vertices: columns that touch are parted there, and coordinates are rounded.
    let bytes = write_stl(&made.clone().parted(1e-3 * resolution), LengthUnit::Millimetre);
    let options = StlOptions { unit: LengthUnit::Millimetre, weld: 0.0, limit: usize::MAX };
    let file = read_stl(&bytes.expect("STL"), &options).expect("a mesh").mesh;
    say(file.edges().are_paired(), format!("{:?}", file.edges()));
    for (mesh, rounding) in [(&made.mesh, 0.0), (&file, 1e-2)] {
        let (volume, left) = (mesh.volume(), found.left_mm3);
        let is_between = left.least - rounding <= volume && volume <= left.most + rounding;
        say(is_between, format!("{volume} mm³ is not in {left:?}"));
        let areas = level_areas(mesh);
        for (z, area) in &areas {
            let z = *z as f64 * 1e-6;
            let is_made = |[from, to]: &Level| from - near <= z && z <= to + near;
            let is_made = part.levels.iter().any(is_made);
            say(is_made || area.iter().sum::<f64>() < LEAST_AREA, format!("{area:?} mm² at {z}"));
        }
        if let Some((height, by_hand)) = part.area {
            let there = areas.iter().filter(|(z, _)| (**z as f64 * 1e-6 - height).abs() <= near);
            let area: f64 = there.map(|(_, area)| area[0]).sum();
            // A column is cut as its middle is, so a wall along the columns is off by half a column at most, and
            // there are two of them for each 10 mm of width.
            let most = by_hand / 10.0 * resolution;
            say((area - by_hand).abs() <= most, format!("{area} mm² at {height}, not {by_hand}"));
        }
    }
    faults
}

#[test]
fn a_wall_has_no_ledge() {
    let parts = parts();
    assert!(parts.len() >= 20);
    let mut faults_of_all = Vec::new();
    for part in &parts {
        for resolution in RESOLUTIONS {
            faults_of_all.extend(faults(part, resolution));
        }
    }
    assert!(faults_of_all.is_empty(), "{}", faults_of_all.join("\n"));
}

/// A bar of 100 × 40 × 30 mm about the axis of a rotary table.
const TURNED_BAR: &str = "machine = 'haas-vf2'\n[axes.A]\n[rotary.A]\nturns = 'table'\n[stock]\nshape = 'box'\n\
                          from = { X = '0 mm', Y = '-20 mm', Z = '-15 mm' }\n\
                          to = { X = '100 mm', Y = '20 mm', Z = '15 mm' }\n";

/// A slot of 10 mm through the whole bar along X, to a height at an angle of A.
fn turned_slot(angle: u32, z: i32) -> String {
    format!("G0 Z60.\nA{angle}.\nX-20. Y0.\nG1 Z{z}. F600.\nX120.\n")
}

#[test]
fn a_part_that_is_cut_from_several_sides_has_no_ledge() {
    // Slots of 5 mm depth from above and below, and of 8 mm depth from the sides along Y.
    let sides = [(0, 10), (90, 12), (180, 10), (270, 12)];
    let blocks: String = sides.iter().map(|(angle, z)| turned_slot(*angle, *z)).collect();
    // Heights and areas of the faces that look up and down, mm and mm²: the stock next to the slots, their floors, and the
    // walls of those from the sides, which lie half their width from the axis.
    let faces = [
        (15.0, [3_000.0, 0.0]),
        (10.0, [1_000.0, 0.0]),
        (5.0, [0.0, 1_600.0]),
        (-5.0, [1_600.0, 0.0]),
        (-10.0, [0.0, 1_000.0]),
        (-15.0, [0.0, 3_000.0]),
    ];
    let setup = format!("{TURNED_BAR}{TOOLS}");
    let program = format!(
        "O1\nG21 G90 G17 G54\nT1 M6\nS3000 M3\nG0 X-20. Y0. A0.\nG43 H1 Z60.\n{blocks}G0 Z60.\nM30\n"
    );
    for resolution in RESOLUTIONS {
        let found = cut(&setup, program.clone(), resolution);
        assert_eq!(found.sides, 4);
        let made = found.surface(JOINED * resolution).expect("a surface");
        assert!(made.mesh.edges().are_paired(), "{:?}", made.mesh.edges());
        let (volume, left) = (made.mesh.volume(), found.left_mm3);
        assert!(left.least <= volume && volume <= left.most, "{volume} mm³ is not in {left:?}");
        let areas = level_areas(&made.mesh);
        // A wall from the side is known to a column.
        let near = resolution * (1.0 + 1.0 / 64.0);
        let mut rest = areas.clone();
        for (z, by_hand) in faces {
            let mut area = [0.0; 2];
            for (height, own) in &areas {
                if (*height as f64 * 1e-6 - z).abs() <= near {
                    rest.remove(height);
                    (0..2).for_each(|side| area[side] += own[side]);
                }
            }
            for side in 0..2 {
                // Each face is bounded by two walls along X, each half a column off at most.
                let most = 100.0 * resolution + LEAST_AREA;
                let off = (area[side] - by_hand[side]).abs();
                assert!(off <= most, "{area:?} mm² at {z} and {resolution}, not {by_hand:?}");
            }
        }
        let ledges: f64 = rest.values().flatten().sum();
        assert!(ledges < LEAST_AREA, "ledges of {ledges} mm²: {rest:?}");
    }
}
