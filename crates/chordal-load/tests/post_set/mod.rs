//! The programs of `tests/posts`, with their labels.

use std::fs;
use std::path::Path;

/// A program of the set.
#[allow(dead_code, reason = "each test looks at a part of the label")]
pub struct PostProgram {
    /// The file that it stands in.
    pub source: String,
    pub title: String,
    /// The controls that it may be for, the one it was written for first.
    pub controls: Vec<String>,
    /// The box of its cuts along X, Y and Z, mm, where it is known.
    pub ends: [Option<(f64, f64)>; 3],
    pub text: String,
}

/// All of them, in the order of their files.
pub fn programs() -> Vec<PostProgram> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/posts");
    let mut files: Vec<_> =
        fs::read_dir(folder).expect("the set").map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    files.iter().flat_map(|path| programs_of(path)).collect()
}

/// Each program begins after `=== controls | units | X Y Z | title`.
fn programs_of(path: &Path) -> Vec<PostProgram> {
    let source = path.file_stem().expect("a name").to_string_lossy().into_owned();
    let all = fs::read_to_string(path).expect("a text");
    let program = |part: &str| {
        let (head, text) = part.split_once('\n').expect("a program");
        let fields: Vec<&str> = head.split(" | ").map(str::trim).collect();
        let [controls, _, ends, title] = fields[..] else { panic!("{source}: {head}") };
        let mut boxes = ends.split(' ').map(|end| {
            let (low, high) = end.trim_start_matches(['X', 'Y', 'Z']).split_once("..")?;
            Some((low.parse().ok()?, high.parse().ok()?))
        });
        PostProgram {
            source: source.clone(),
            title: title.to_string(),
            controls: controls.split(',').map(str::to_string).collect(),
            ends: std::array::from_fn(|_| boxes.next().flatten()),
            text: format!("{}\n", text.trim_end_matches('\n')),
        }
    };
    all.split("\n=== ").skip(1).map(program).collect()
}
