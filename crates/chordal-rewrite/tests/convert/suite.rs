//! The programs of the suite, whatever they are about: what becomes of each on each control.

use std::path::{Path, PathBuf};

use super::{MACHINES, converted, job_of, text_of, verdict};

#[test]
#[allow(clippy::disallowed_methods, reason = "tests read folders")]
fn all_programs() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut table = String::new();
    let (mut proved, mut all) = (0, 0);
    for folder in ["fadal", "haas", "fanuc", "mitsubishi", "linuxcnc", "textbook", "five"] {
        let folder = format!("tests/suite/{folder}");
        let entries = std::fs::read_dir(root.join(&folder)).expect("the suite");
        let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
        files.sort();
        for file in files {
            let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let path = format!("{folder}/{name}");
            let old = job_of(&text_of(&path), &[]);
            let first = converted(&old, MACHINES[0]);
            if first.text.is_empty() {
                table += &format!("{path}\n    {}\n", verdict(&first));
                assert!(!first.holds() && old.check().counts.errors > 0, "{path}");
                continue;
            }
            table += &format!("{path}\n");
            for to in MACHINES {
                let found = converted(&old, to);
                all += 1;
                proved += usize::from(found.holds());
                table += &format!("    {to}: {}\n", verdict(&found));
            }
        }
    }
    table += &format!("\n{proved} of {all} proved\n");
    insta::assert_snapshot!(table);
}
