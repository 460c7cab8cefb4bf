//! The river of ARCHITECTURE.md, held: text flows to samples and nothing flows back.

#![allow(clippy::disallowed_methods, reason = "asks cargo about the workspace")]

use std::collections::BTreeMap;

/// Each crate and the crates it may use. A crate that is not here is refused, so that a new
/// one gets its place on purpose.
const MAY_USE: &[(&str, &[&str])] = &[
    ("chordal-diagnostics", &[]),
    ("chordal-syntax", &["chordal-diagnostics"]),
    ("chordal-geometry", &[]),
    ("chordal-kinematics", &["chordal-geometry"]),
    ("chordal-machine", &["chordal-geometry", "chordal-kinematics"]),
    (
        "chordal-command",
        &["chordal-diagnostics", "chordal-geometry", "chordal-kinematics", "chordal-machine"],
    ),
    (
        "chordal-kernel",
        &[
            "chordal-diagnostics",
            "chordal-geometry",
            "chordal-kinematics",
            "chordal-machine",
            "chordal-command",
        ],
    ),
    (
        "chordal-dialect",
        &[
            "chordal-diagnostics",
            "chordal-syntax",
            "chordal-geometry",
            "chordal-machine",
            "chordal-command",
            "chordal-kernel",
        ],
    ),
    (
        "chordal-gcode",
        &[
            "chordal-diagnostics",
            "chordal-syntax",
            "chordal-geometry",
            "chordal-machine",
            "chordal-command",
            "chordal-kernel",
            "chordal-dialect",
        ],
    ),
    (
        "chordal-sinumerik",
        &[
            "chordal-diagnostics",
            "chordal-geometry",
            "chordal-machine",
            "chordal-command",
            "chordal-kernel",
        ],
    ),
    (
        "chordal-heidenhain",
        &[
            "chordal-diagnostics",
            "chordal-geometry",
            "chordal-machine",
            "chordal-command",
            "chordal-kernel",
        ],
    ),
    (
        "chordal-path",
        &[
            "chordal-command",
            "chordal-kernel",
            "chordal-kinematics",
            "chordal-machine",
            "chordal-geometry",
            "chordal-diagnostics",
        ],
    ),
    ("chordal-motion", &["chordal-geometry"]),
    ("chordal-stock", &["chordal-geometry"]),
    ("chordal-collision", &["chordal-geometry", "chordal-kinematics"]),
    (
        "chordal",
        &[
            "chordal-diagnostics",
            "chordal-syntax",
            "chordal-geometry",
            "chordal-machine",
            "chordal-command",
            "chordal-kernel",
            "chordal-dialect",
            "chordal-gcode",
            "chordal-sinumerik",
            "chordal-heidenhain",
            "chordal-path",
            "chordal-motion",
            "chordal-stock",
            "chordal-collision",
            "chordal-kinematics",
        ],
    ),
    ("chordal-calc", &["chordal-geometry", "chordal-machine", "chordal-dialect"]),
    ("chordal-export", &["chordal", "chordal-calc", "chordal-compare", "chordal-rewrite"]),
    ("chordal-report", &["chordal", "chordal-export"]),
    ("chordal-load", &["chordal"]),
    ("chordal-files", &[]),
    (
        "chordal-archive",
        &["chordal", "chordal-compare", "chordal-export", "chordal-files", "chordal-load"],
    ),
    ("chordal-compare", &["chordal"]),
    ("chordal-rewrite", &["chordal", "chordal-compare", "chordal-editor"]),
    ("chordal-editor", &["chordal"]),
    ("chordal-lsp", &["chordal", "chordal-editor"]),
    (
        "chordal-view",
        &["chordal", "chordal-compare", "chordal-editor", "chordal-export", "chordal-load"],
    ),
    // Apart from the view for its tests alone.
    (
        "chordal-server",
        &["chordal-files", "chordal-view", "chordal", "chordal-compare", "chordal-editor"],
    ),
    ("chordal-memory", &[]),
    ("chordal-page", &["chordal-editor", "chordal-load", "chordal-memory", "chordal-view"]),
    // The kernel and what it uses only for its tests, which bring a language along.
    (
        "chordal-cli",
        &[
            "chordal-command",
            "chordal-diagnostics",
            "chordal-geometry",
            "chordal-kernel",
            "chordal-machine",
            "chordal",
            "chordal-ask",
            "chordal-calc",
            "chordal-compare",
            "chordal-editor",
            "chordal-export",
            "chordal-files",
            "chordal-load",
            "chordal-report",
            "chordal-archive",
            "chordal-rewrite",
            "chordal-lsp",
            "chordal-server",
            "chordal-view",
        ],
    ),
    (
        "chordal-python",
        &[
            "chordal",
            "chordal-compare",
            "chordal-export",
            "chordal-load",
            "chordal-report",
            "chordal-rewrite",
            "chordal-archive",
        ],
    ),
    (
        "chordal-ask",
        &[
            "chordal",
            "chordal-compare",
            "chordal-editor",
            "chordal-export",
            "chordal-load",
            "chordal-rewrite",
        ],
    ),
    (
        "chordal-wasm",
        &["chordal-ask", "chordal-editor", "chordal-load", "chordal-lsp", "chordal-memory"],
    ),
    ("chordal-wheel", &["chordal-python", "chordal-cli"]),
];

#[test]
fn every_crate_uses_only_what_lies_upstream() {
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/../../Cargo.toml");
    let metadata = cargo_metadata::MetadataCommand::new()
        .manifest_path(manifest)
        .no_deps()
        .exec()
        .expect("cargo tells about the workspace");
    let allowed: BTreeMap<&str, &[&str]> = MAY_USE.iter().copied().collect();
    let mut wrong = Vec::new();
    for package in &metadata.packages {
        let Some(upstream) = allowed.get(package.name.as_str()) else {
            wrong.push(format!("{} has no place in the river", package.name));
            continue;
        };
        for dependency in &package.dependencies {
            let ours = dependency.name.starts_with("chordal");
            if ours && !upstream.contains(&dependency.name.as_str()) {
                wrong.push(format!("{} must not use {}", package.name, dependency.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert_eq!(metadata.packages.len(), MAY_USE.len(), "a crate of the list is gone");
}
