//! Machines, and random bodies and moves on them.

use core::ops::Deref;

use chordal_collision::{AxisMove, MachineLinks};
use chordal_geometry::{ConvexSolid, Curve, Line, ParamCurve, Transform, Vec3};
use chordal_kinematics::{KinematicChain, RotaryJoint, RotaryLetter, RotaryMount};

/// A small generator, so that a failure repeats.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn point(&mut self, size: f64) -> Vec3 {
        let mut along = || self.between(-size, size);
        Vec3::new(along(), along(), along())
    }

    pub fn direction(&mut self) -> Vec3 {
        loop {
            let point = self.point(1.0);
            if (0.1..=1.0).contains(&point.length()) {
                return point.normalized().unwrap();
            }
        }
    }

    /// A box, a ball, a cone or a hull about a point.
    pub fn solid(&mut self, size: f64, about: Vec3) -> ConvexSolid {
        let low = 0.2 * size;
        match (self.unit() * 4.0) as u32 {
            0 => {
                let half = Vec3::new(1.0, 1.0, 1.0) * low + self.point(low * 0.9);
                ConvexSolid::cuboid(about - half, about + half)
            }
            1 => ConvexSolid::ball(about, self.between(low, size)),
            2 => {
                let half = self.direction() * self.between(low, size);
                let radii = [self.between(0.0, size), self.between(low, size)];
                ConvexSolid::frustum([about - half, about + half], radii)
            }
            _ => ConvexSolid::hull((0..9).map(|_| about + self.point(size)).collect()),
        }
        .unwrap()
    }
}

/// A machine with its chain, which the tests use to place the tool on the part independently of the links.
pub struct Kinematics {
    pub name: &'static str,
    pub chain: KinematicChain,
    pub links: MachineLinks,
}

/// A move with what the tests ask of it.
#[derive(Debug)]
pub struct TestMove(pub AxisMove);

impl From<AxisMove> for TestMove {
    fn from(path: AxisMove) -> TestMove {
        TestMove(path)
    }
}

impl Deref for TestMove {
    type Target = AxisMove;
    fn deref(&self) -> &AxisMove {
        &self.0
    }
}

impl TestMove {
    pub fn curve_start(&self) -> Vec3 {
        self.0.curve.start()
    }
}

impl Kinematics {
    pub const COUNT: usize = 5;

    pub fn number(number: usize) -> Kinematics {
        use RotaryMount::{Head, Table};
        let c_table = RotaryJoint::table(RotaryLetter::C, Vec3::new(-120.0, -80.0, 0.0));
        let a_table = RotaryJoint::table(RotaryLetter::A, Vec3::new(0.0, -80.0, -150.0));
        let b_head = RotaryJoint::head(RotaryLetter::B, Vec3::new(0.0, 0.0, 150.0));
        let c_head = RotaryJoint::head(RotaryLetter::C, Vec3::ZERO);
        let (name, joints, sides, order): (_, &[RotaryJoint], _, _) = match number % Self::COUNT {
            0 => ("three axes", &[], [Table, Table, Head], [1, 0, 2]),
            1 => ("two tables", &[c_table, a_table], [Head, Table, Head], [0, 1, 2]),
            2 => ("head and table", &[c_table, b_head], [Table, Head, Head], [0, 1, 2]),
            3 => (
                "nutating table, reversed",
                &[c_table.turned_around(), b_head.along(Vec3::new(0.0, 1.0, 1.0))],
                [Head, Head, Table],
                [2, 1, 0],
            ),
            _ => ("two heads", &[c_head, b_head], [Head, Head, Head], [0, 1, 2]),
        };
        let chain = KinematicChain::new(joints).unwrap();
        let links = MachineLinks::new(&chain, sides, order);
        Kinematics { name, chain, links }
    }

    /// From the coordinates of a body of the tool (at the gauge point, every axis at zero) to those of the part.
    pub fn tool_on_part(&self, axes: &[f64; 6]) -> Transform {
        let [x, y, z, a, b, c] = *axes;
        let angles = [a, b, c];
        let place = |tool: Vec3| self.chain.pose(Vec3::new(x, y, z), &angles, tool).tip;
        let origin = place(Vec3::ZERO);
        let [u, v, w] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| place(axis) - origin);
        Transform::from_frame(chordal_geometry::Frame { origin, u, v, w })
    }

    pub fn random_move(&self, random: &mut Random) -> TestMove {
        let start = random.point(150.0);
        let end = start + random.point(100.0);
        let mut angles = || -> [f64; 3] { core::array::from_fn(|_| random.between(-1.5, 1.5)) };
        let (rotary_from, rotary_to) = (angles(), angles());
        TestMove(AxisMove {
            curve: Curve::Line(Line { start, end }),
            rotary_from,
            rotary_to,
            deviation_mm: 0.0,
        })
    }
}
