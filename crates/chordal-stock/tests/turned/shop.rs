//! Stock, tools and paths in short words, and numbers that look random.

use chordal_geometry::Vec2;
use chordal_stock::lathe::{
    Blade, BladeFacing, BladePoint, Insert, LatheStock, OutlineSegment, Region, Tip, ToolOutline,
    TurnedPass,
};

/// Numbers that look random: the same in every run.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }

    pub fn below(&mut self, count: usize) -> usize {
        (self.next() * count as f64) as usize
    }
}

/// So many rounds, or those that `CHORDAL_ROUNDS` names.
pub fn rounds(few: u64) -> u64 {
    std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok()).unwrap_or(few)
}

pub fn at(z: f64, r: f64) -> Vec2 {
    Vec2::new(z, r)
}

pub fn tip(number: u8) -> Tip {
    Tip::new(number).unwrap()
}

/// An ideal point with all behind it, for outside work towards −z.
pub fn point() -> ToolOutline {
    Insert::ideal_point(tip(3), 200.0).unwrap().outline().unwrap()
}

pub fn bar(radius: f64, from: f64, to: f64) -> LatheStock {
    LatheStock::new(&Region::bar(radius, from, to).unwrap())
}

/// A blade for outside grooves, its lower corner programmed.
pub fn blade(width: f64, corner: f64) -> Blade {
    Blade {
        width,
        corners: [corner; 2],
        length: 100.0,
        lead: 0.0,
        facing: BladeFacing::Outside,
        point: BladePoint::Lower,
    }
}

/// Straight moves along corners given as (diameter, z), as programs write them.
pub fn turn(stock: &mut LatheStock, tool: &ToolOutline, corners: &[(f64, f64)]) -> Vec<TurnedPass> {
    corners
        .windows(2)
        .map(|two| {
            let [from, to] = [two[0], two[1]].map(|(diameter, z)| at(z, diameter / 2.0));
            stock.cut(tool, &OutlineSegment::line(from, to)).unwrap()
        })
        .collect()
}

/// Moves as segments.
pub fn follow(
    stock: &mut LatheStock,
    tool: &ToolOutline,
    path: &[OutlineSegment],
) -> Vec<TurnedPass> {
    path.iter().map(|move_| stock.cut(tool, move_).unwrap()).collect()
}

pub fn near(found: f64, wanted: f64, within: f64) {
    assert!((found - wanted).abs() <= within, "{found}, not {wanted}: {:e} off", found - wanted);
}
