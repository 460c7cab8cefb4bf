//! Where the bodies of a machine are relative to the part, against places computed by hand.

use std::f64::consts::FRAC_PI_2;

use chordal::collision::MachineOnPart;
use chordal::geometry::{Transform, Vec3};
use chordal::{Job, Machine, Source, SourceMap};

const PROGRAM: &str = "G21 G90 G17 G94\nG54\nT1 M6\nG0 X0 Y0 Z50.\nG1 Z0 F500\nM30\n";

const BODIES: &str = "
[kinematics]
X = 'head'
Y = 'table'
Z = 'head'
[work_offsets.G54]
X = '-300 mm'
Y = '-200 mm'
Z = '-350 mm'
[solids.base]
on = 'base'
shape = 'box'
from = { X = '-800 mm', Y = '-500 mm', Z = '-900 mm' }
to = { X = '200 mm', Y = '200 mm', Z = '-800 mm' }
[solids.slide]
on = 'Y'
shape = 'box'
from = { X = '-400 mm', Y = '-300 mm', Z = '-800 mm' }
to = { X = '-200 mm', Y = '-100 mm', Z = '-700 mm' }
[solids.table]
on = 'C'
shape = 'cylinder'
from = { X = '-300 mm', Y = '-200 mm', Z = '-450 mm' }
to = { X = '-300 mm', Y = '-200 mm', Z = '-400 mm' }
diameter = '300 mm'
[solids.spindle]
on = 'spindle'
shape = 'cylinder'
to = { Z = '150 mm' }
diameter = '120 mm'
";

fn machine_on_part(machine: &str) -> MachineOnPart {
    let text = format!("{machine}{BODIES}");
    let machine = Machine::from_toml("five.toml", &text, &|name| Err(format!("no {name}")))
        .expect("a machine");
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", PROGRAM.as_bytes().to_vec()));
    let job = Job::new(sources, machine).expect("good settings");
    let placed = job.machine_on_part().expect("bodies").expect("known places");
    assert!(placed.left_out.is_empty(), "{:?}", placed.left_out);
    placed
}

/// Where a point of a body, given with all axes at zero, is in the frame of the run on the part.
fn place(machine: &MachineOnPart, body: &str, axes: [f64; 6], point: [f64; 3]) -> [f64; 3] {
    let body = machine.bodies.iter().find(|own| own.name == body).expect("the body");
    let motions = body.motions.iter();
    let pose = motions.fold(Transform::identity(), |pose, motion| pose.then(&motion.motion(&axes)));
    let at = pose.then(&machine.to_part).apply_point(Vec3::from_array(point));
    at.to_array().map(|mm| (mm * 1e6).round() / 1e6 + 0.0)
}

#[test]
fn on_a_trunnion_the_part_stays_and_the_machine_turns_about_it() {
    let machine = machine_on_part(
        "inherits = 'fanuc-ac-trunnion'
[rotary.A]
point = { Y = '-200 mm', Z = '-400 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
[solids.cradle]
on = 'A'
shape = 'box'
from = { X = '-500 mm', Y = '-300 mm', Z = '-550 mm' }
to = { X = '-100 mm', Y = '-100 mm', Z = '-450 mm' }
",
    );
    let axes = [-250.0, -180.0, -200.0, FRAC_PI_2, 0.0, FRAC_PI_2];
    // The table carries the part: its middle is where the work offset says, 50 below the zero.
    assert_eq!(place(&machine, "table", axes, [-300.0, -200.0, -400.0]), [0.0, 0.0, -50.0]);
    // The cradle turns about C alone, the way of the tool: what is at +X of the axis of C comes to +Y.
    assert_eq!(place(&machine, "cradle", axes, [-100.0, -200.0, -450.0]), [0.0, 200.0, -100.0]);
    // The gauge point is at 50, 20, 200 from the axes of both tables. A at 90 degrees takes it from Z to -Y: 50, -200, 20;
    // C then from X to Y and from -Y to X: 200, 50, 20. The axis of A is 50 below the zero of the part.
    assert_eq!(place(&machine, "spindle", axes, [0.0; 3]), [200.0, 50.0, -30.0]);
    // 100 above the gauge point along the spindle: further along the direction of the tool, which is +X of the part.
    assert_eq!(place(&machine, "spindle", axes, [0.0, 0.0, 100.0]), [300.0, 50.0, -30.0]);
    // Y moves the slide under the tables: with them at zero it is still on the part, the base is not.
    let upright = [-250.0, -180.0, -200.0, 0.0, 0.0, 0.0];
    assert_eq!(place(&machine, "slide", upright, [-300.0, -200.0, -700.0]), [0.0, 0.0, -350.0]);
    assert_eq!(place(&machine, "base", upright, [-300.0, -200.0, -800.0]), [0.0, -180.0, -450.0]);
    // C at 90 degrees: the base, 180 towards -Y, comes to +X.
    let turned = [-250.0, -180.0, -200.0, 0.0, 0.0, FRAC_PI_2];
    assert_eq!(place(&machine, "base", turned, [-300.0, -200.0, -800.0]), [180.0, 0.0, -450.0]);
}

#[test]
fn a_head_turns_about_its_point_and_moves_with_the_linear_axes() {
    let machine = machine_on_part(
        "inherits = 'fanuc-head-table'
[rotary.B]
point = { X = '0 mm', Z = '150 mm' }
[rotary.C]
point = { X = '-300 mm', Y = '-200 mm' }
[solids.ram]
on = 'Z'
shape = 'box'
from = { X = '-100 mm', Y = '-100 mm', Z = '150 mm' }
to = { X = '100 mm', Y = '100 mm', Z = '500 mm' }
",
    );
    let axes = [-250.0, -180.0, -100.0, 0.0, FRAC_PI_2, 0.0];
    // The point of the head is at -250, -180, 50 on the machine: 50, 20, 400 from the zero of the part.
    assert_eq!(place(&machine, "ram", axes, [0.0, 0.0, 150.0]), [50.0, 20.0, 400.0]);
    // B at 90 degrees lays the spindle along +X: the gauge point is 150 towards -X of that point.
    assert_eq!(place(&machine, "spindle", axes, [0.0; 3]), [-100.0, 20.0, 400.0]);
    assert_eq!(place(&machine, "spindle", axes, [0.0, 0.0, 100.0]), [0.0, 20.0, 400.0]);
    // With the table at 90 degrees all of it turns about Z of the part, from X to Y.
    let turned = [-250.0, -180.0, -100.0, 0.0, FRAC_PI_2, FRAC_PI_2];
    assert_eq!(place(&machine, "spindle", turned, [0.0; 3]), [-20.0, -100.0, 400.0]);
    assert_eq!(place(&machine, "table", turned, [-300.0, -200.0, -400.0]), [0.0, 0.0, -50.0]);
}

#[test]
fn without_a_work_offset_no_place_is_known() {
    let text = "inherits = 'fanuc-head-table'
[solids.spindle]
on = 'spindle'
shape = 'cylinder'
to = { Z = '150 mm' }
diameter = '120 mm'
";
    let job = |text: &str| {
        let machine = Machine::from_toml("five.toml", text, &|name| Err(format!("no {name}")))
            .expect("a machine");
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.nc", PROGRAM.as_bytes().to_vec()));
        Job::new(sources, machine).expect("good settings")
    };
    assert!(matches!(job(text).machine_on_part(), Some(Err(_))));
    assert_eq!(job("inherits = 'fanuc-head-table'\n").machine_on_part(), None);
}
