//! The vertices on the vertical line at a corner of four cells.
//!
//! The cells around the corner are numbered counter-clockwise from the one with higher x and y. Wall `k` is between
//! cells `k` and `k + 1`: in the direction +Y, −X, −Y, +X from the corner.

/// A face at a corner and a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FaceKind {
    /// The wall with this number, from the level up.
    Up(usize),
    /// The wall with this number, from the level down.
    Down(usize),
    /// The top or the bottom of the cell with this number.
    Flat(usize),
}

impl FaceKind {
    const COUNT: usize = 12;

    const fn index(self) -> usize {
        match self {
            FaceKind::Up(wall) => wall,
            FaceKind::Down(wall) => 4 + wall,
            FaceKind::Flat(cell) => 8 + cell,
        }
    }
}

/// The directions from the corner to each cell.
const CELL_DIRECTIONS: [[i8; 2]; 4] = [[1, 1], [-1, 1], [-1, -1], [1, -1]];

/// The solid cell behind the face with this index.
fn solid_cell(face: usize, above: [bool; 4], below: [bool; 4]) -> usize {
    let cell = face % 4;
    let solid = match face / 4 {
        0 => above[cell],
        1 => below[cell],
        _ => true,
    };
    if solid { cell } else { (cell + 1) % 4 }
}

/// Most levels: four tops and the bottom.
const MAX_LEVELS: usize = 5;
/// Most vertices: at most two bodies touch at a level.
const MAX_VERTICES: usize = 2 * MAX_LEVELS;

/// The vertices over one corner.
pub(super) struct CornerNode {
    levels: [f64; MAX_LEVELS],
    count: usize,
    /// The vertex of each face at each level, where two bodies touch along the line; `None` where there is one vertex
    /// for each level.
    touching: Option<[[u8; FaceKind::COUNT]; MAX_LEVELS]>,
    /// The level of each vertex.
    vertex_levels: [u8; MAX_VERTICES],
    vertices: usize,
    /// For each vertex the direction to its body, along X and Y, where another body has a vertex at the same place;
    /// zero elsewhere.
    directions: [[i8; 2]; MAX_VERTICES],
}

impl CornerNode {
    /// `heights` of the four cells, with that of the bottom for a hole. `tops` and `bottom` say which have a vertex
    /// here.
    pub(super) fn new(heights: [f64; 4], floor: f64, tops: bool, bottom: bool) -> CornerNode {
        let mut node = CornerNode {
            levels: [0.0; MAX_LEVELS],
            count: 0,
            touching: None,
            vertex_levels: std::array::from_fn(|vertex| vertex as u8),
            vertices: 0,
            directions: [[0, 0]; MAX_VERTICES],
        };
        if bottom {
            node.add(floor);
        }
        if tops {
            heights.into_iter().filter(|height| *height > floor).for_each(|top| node.add(top));
        }
        node.vertices = node.count;
        let [a, b, c, d] = heights;
        if a.max(c) < b.min(d) || b.max(d) < a.min(c) {
            node.part(heights, floor);
        }
        node
    }

    /// The levels, from the lowest, mm.
    pub(super) fn levels(&self) -> &[f64] {
        &self.levels[..self.count]
    }

    /// For each vertex the direction along X and Y that separates it from another one at the same place; zero where
    /// it is alone.
    pub(super) fn directions(&self) -> &[[i8; 2]] {
        &self.directions[..self.vertices]
    }

    /// The height of each vertex, mm.
    pub(super) fn vertices(&self) -> impl Iterator<Item = f64> {
        self.vertex_levels[..self.vertices].iter().map(|level| self.levels[usize::from(*level)])
    }

    /// The vertex of a face at a level, counted from the first of the corner.
    pub(super) fn vertex(&self, level: usize, face: FaceKind) -> usize {
        self.touching.map_or(level, |of| usize::from(of[level][face.index()]))
    }

    /// The number of the level at a height, mm.
    pub(super) fn level(&self, height: f64) -> usize {
        self.levels().iter().position(|level| *level >= height).unwrap_or(0)
    }

    fn add(&mut self, level: f64) {
        let at = self.levels().iter().position(|other| *other >= level).unwrap_or(self.count);
        if at == self.count || self.levels[at] > level {
            self.levels.copy_within(at..self.count, at + 1);
            self.levels[at] = level;
            self.count += 1;
        }
    }

    /// Gives each level a vertex for each body, where two bodies may touch along the line.
    fn part(&mut self, heights: [f64; 4], floor: f64) {
        let mut of = [[0; FaceKind::COUNT]; MAX_LEVELS];
        let (mut first, mut vertex_levels) = (0, [0; MAX_VERTICES]);
        for (level, of) in of.iter_mut().enumerate().take(self.count) {
            let z = self.levels[level];
            let above = heights.map(|height| height > z);
            let below = heights.map(|height| height >= z && z > floor);
            let meeting = LevelMeeting::of(above, below);
            *of = meeting.vertex.map(|vertex| vertex + first as u8);
            let next = first + meeting.count;
            vertex_levels[first..next].fill(level as u8);
            self.directions[first..next].copy_from_slice(&meeting.directions[..meeting.count]);
            first = next;
        }
        (self.vertices, self.vertex_levels) = (first, vertex_levels);
        self.touching = Some(of);
    }
}

/// The vertices at one level of a corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct LevelMeeting {
    /// The vertex of each face that is there, from zero.
    vertex: [u8; FaceKind::COUNT],
    /// Number of vertices: two where two bodies touch.
    pub count: usize,
    /// The direction to the body of each vertex, along X and Y, where there are two.
    pub directions: [[i8; 2]; 2],
}

impl LevelMeeting {
    /// The vertices of a level, given whether each of the four cells is solid just above and just below it. No cell
    /// may have its top at the level where an interval of another one begins.
    ///
    /// Faces that share an edge share a vertex. At a vertical edge where two solid cells touch only diagonally, the
    /// two faces of the same cell share a vertex.
    pub fn of(above: [bool; 4], below: [bool; 4]) -> LevelMeeting {
        let mut class: [usize; FaceKind::COUNT] = std::array::from_fn(|face| face);
        let mut present = [false; FaceKind::COUNT];
        for cell in 0..4 {
            let next = (cell + 1) % 4;
            present[FaceKind::Up(cell).index()] = above[cell] != above[next];
            present[FaceKind::Down(cell).index()] = below[cell] != below[next];
            present[FaceKind::Flat(cell).index()] = above[cell] != below[cell];
        }
        let mut join = |faces: &[FaceKind]| {
            let mut there = faces.iter().map(|face| face.index()).filter(|face| present[*face]);
            if let Some(first) = there.next() {
                for face in there {
                    let (from, to) = (class[face], class[first]);
                    class.iter_mut().filter(|c| **c == from).for_each(|c| *c = to);
                }
            }
        };
        for cell in 0..4 {
            let next = (cell + 1) % 4;
            join(&[
                FaceKind::Up(cell),
                FaceKind::Down(cell),
                FaceKind::Flat(cell),
                FaceKind::Flat(next),
            ]);
            // Consecutive solid cells lie between two walls, which share a vertex.
            for (solid, face) in
                [(above, FaceKind::Up as fn(usize) -> FaceKind), (below, FaceKind::Down)]
            {
                if solid[next] && !solid[cell] {
                    let run = (1..4).take_while(|more| solid[(cell + more) % 4]).count();
                    join(&[face(cell), face((cell + run) % 4)]);
                }
            }
        }
        let mut meeting =
            LevelMeeting { vertex: [0; FaceKind::COUNT], count: 0, directions: [[0; 2]; 2] };
        let mut numbers = [None; FaceKind::COUNT];
        for face in (0..FaceKind::COUNT).filter(|face| present[*face]) {
            let number = *numbers[class[face]].get_or_insert_with(|| {
                meeting.count += 1;
                meeting.count - 1
            });
            meeting.vertex[face] = number as u8;
            let path = CELL_DIRECTIONS[solid_cell(face, above, below)];
            for (sum, part) in meeting.directions[number].iter_mut().zip(path) {
                *sum += part;
            }
        }
        let is_one = meeting.count < 2;
        meeting.directions =
            meeting.directions.map(|path| if is_one { [0, 0] } else { path.map(i8::signum) });
        meeting
    }

    /// The vertex of a face, from zero.
    pub fn vertex(&self, face: FaceKind) -> u32 {
        u32::from(self.vertex[face.index()])
    }
}
