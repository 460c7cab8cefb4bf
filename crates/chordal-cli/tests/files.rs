//! What commands do with files: inputs stay, outputs are whole or as before and stay what they are, and a signal
//! leaves nothing behind.

#![cfg(unix)]
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "the tests of a shell have its files and processes"
)]

mod common;

use std::fs::{self, File};
use std::io::Read;
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use common::{CLEAN, Folder};

const MAIN: &str = "O20\nG20 G17 G40 G90\nG0 X0 Y0 Z.1\nS900 M3\nM98 P200\nM5\nM30\n";
const SUB: &str = "O200\nG1 X1. F10.\nM99\n";
const SHOP: &str = "inherits = \"haas-vf2\"\n";
const SETUP: &str =
    "machine = \"haas-vf2\"\n[stock]\nshape = \"stl\"\nfile = \"block.stl\"\nunit = \"in\"\n";

/// A block of 2 by 2 by 1 as text.
fn block() -> String {
    let at = |corner: usize| [corner & 1, corner >> 1 & 1, corner >> 2].map(|side| side as f64);
    let sides =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut text = String::from("solid block\n");
    for [a, b, c, d] in sides {
        for corners in [[a, b, c], [a, c, d]] {
            text += "facet normal 0 0 0\nouter loop\n";
            for [x, y, z] in corners.map(at) {
                text += &format!("vertex {} {} {}\n", 2.0 * x - 0.5, 2.0 * y - 0.5, z - 1.0);
            }
            text += "endloop\nendfacet\n";
        }
    }
    text + "endsolid block\n"
}

/// A program with its subprogram, a machine file and what else a command reads.
fn shop() -> Folder {
    let folder = Folder::new();
    folder.write("main.nc", MAIN).write("O200.nc", SUB).write("shop.toml", SHOP);
    folder.write("part.nc", CLEAN).write("tool.tbl", "T1 P1 D0.25\n");
    folder.write("setup.toml", SETUP).write("block.stl", block());
    folder.write("map.csv", "x,y,z\n0,0,0\n3,0,0\n0,3,0\n3,3,0\n");
    folder
}

#[test]
fn no_command_writes_over_what_it_reads() {
    let folder = shop();
    let hard = folder.path("hard.nc");
    fs::hard_link(folder.path("O200.nc"), &hard).unwrap();
    symlink("shop.toml", folder.path("soft.toml")).unwrap();
    fs::create_dir(folder.path("sub")).unwrap();
    let convert = ["convert", "main.nc", "-m", "shop.toml", "--to", "fanuc-0i"];
    let shift = ["transform", "main.nc", "-m", "shop.toml", "--shift", "X0"];
    let heights = ["transform", "part.nc", "-m", "haas-vf2", "--heights", "map.csv"];
    let restart = ["restart", "main.nc", "-m", "shop.toml", "--line", "4"];
    let commands = ["commands", "main.nc", "-m", "shop.toml", "--format", "csv"];
    let tools =
        ["sample", "part.nc", "-m", "linuxcnc-mill", "--tools", "tool.tbl", "--format", "csv"];
    let stock = ["stock", "part.nc", "--setup", "setup.toml"];
    let compare = ["compare", "part.nc", "main.nc", "-m", "shop.toml"];
    for (command, over) in [
        (&convert[..], "main.nc"),
        (&convert, "./main.nc"),
        (&convert, "sub/../main.nc"),
        (&convert, "O200.nc"),
        (&convert, "hard.nc"),
        (&convert, "shop.toml"),
        (&convert, "soft.toml"),
        (&shift, "O200.nc"),
        (&shift, "shop.toml"),
        (&heights, "map.csv"),
        (&restart, "O200.nc"),
        (&commands, "O200.nc"),
        (&commands, "main.nc"),
        (&tools, "tool.tbl"),
        (&compare, "part.nc"),
        (&compare, "main.nc"),
        (&stock, "block.stl"),
    ] {
        let before: Vec<_> = folder.names().iter().map(|name| folder.bytes(name)).collect();
        let done = folder.run(&[command, &["-o", over]].concat());
        assert_eq!(done.code, 2, "{command:?} -o {over}: {}{}", done.out, done.err);
        let after: Vec<_> = folder.names().iter().map(|name| folder.bytes(name)).collect();
        assert!(before == after, "{command:?} -o {over}");
    }
    let done = folder.run(&[&convert[..], &["-o", "O200.nc"]].concat());
    assert!(done.err.contains("O200.nc is read by this command"), "{}", done.err);
    folder.run(&[&stock[..], &["-o", "left.stl"]].concat());
    assert!(folder.names().contains(&"left.stl".to_string()));
    // Another name is written, and then that one may be written again.
    for _ in 0..2 {
        folder.run(&[&convert[..], &["-o", "new.nc"]].concat()).ends(0);
    }
}

#[test]
fn outputs_of_one_name_are_refused() {
    let folder = shop();
    fs::create_dir(folder.path("sub")).unwrap();
    symlink("one.svg", folder.path("link.svg")).unwrap();
    for [one, other] in
        [["one.svg", "./one.svg"], ["one.svg", "sub/../one.svg"], ["one.svg", "link.svg"]]
    {
        let done = folder.run(&["run", "part.nc", "-m", "haas-vf2", "-o", one, "-o", other]);
        assert_eq!(done.code, 2, "{one} {other}: {}", done.err);
        assert!(done.err.contains("would be written twice"), "{}", done.err);
    }
    let convert = ["convert", "main.nc", "-m", "shop.toml", "--to", "fanuc-0i"];
    for more in
        [["-o", "new.txt", "--certificate", "new.txt"], ["-o", "new.svg", "--picture", "./new.svg"]]
    {
        let done = folder.run(&[&convert[..], &more].concat());
        assert_eq!(done.code, 2, "{more:?}: {}", done.err);
        assert!(done.err.contains("would be written twice"), "{}", done.err);
    }
    // Whatever comes of what is no file is nobody's loss.
    folder
        .run(&[&convert[..], &["-o", "/dev/null", "--certificate", "/dev/null"]].concat())
        .ends(0);
}

#[test]
fn what_is_no_file_is_written_through() {
    let folder = shop();
    let convert = ["convert", "main.nc", "-m", "shop.toml", "--to", "fanuc-0i"];
    folder.run(&[&convert[..], &["-o", "out.nc"]].concat()).ends(0);
    let due = folder.read("out.nc");
    let pipe = folder.path("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let reader = {
        let pipe = pipe.clone();
        thread::spawn(move || {
            let mut text = String::new();
            File::open(pipe).unwrap().read_to_string(&mut text).unwrap();
            text
        })
    };
    folder.run(&[&convert[..], &["-o", "pipe"]].concat()).ends(0);
    assert_eq!(reader.join().unwrap(), due);
    assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
    folder.run(&[&convert[..], &["-o", "/dev/null"]].concat()).ends(0);
    assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
    let out = folder.run(&[&convert[..], &["-o", "/dev/stdout"]].concat());
    assert!(out.code == 0 && out.out.contains(&due), "{}{}", out.out, out.err);
    assert!(fs::symlink_metadata("/dev/stdout").unwrap().is_symlink());
}

#[test]
fn a_full_disk_is_said_of_the_file_that_is_full() {
    let folder = shop();
    for command in [
        &["transform", "part.nc", "-m", "haas-vf2", "--feed", "90%"][..],
        &["convert", "part.nc", "-m", "haas-vf2", "--to", "fanuc-0i"],
        &["restart", "part.nc", "-m", "haas-vf2", "--line", "6"],
        &["commands", "part.nc", "-m", "haas-vf2", "--format", "csv"],
        &["sample", "part.nc", "-m", "haas-vf2", "--format", "csv"],
        &["path", "part.nc", "-m", "haas-vf2", "--format", "csv"],
        &["chords", "part.nc", "-m", "haas-vf2", "--format", "csv", "--tolerance", "0.01mm"],
    ] {
        let done = folder.run(&[command, &["-o", "/dev/full"]].concat());
        assert_eq!(done.code, 2, "{command:?}: {}{}", done.out, done.err);
        assert!(done.err.contains("cannot write /dev/full: "), "{command:?}: {}", done.err);
    }
}

#[test]
fn a_file_that_is_there_keeps_its_mode_and_its_link() {
    let folder = shop();
    folder.write("real/out.svg", "old");
    fs::set_permissions(folder.path("real/out.svg"), fs::Permissions::from_mode(0o640)).unwrap();
    symlink("real/out.svg", folder.path("out.svg")).unwrap();
    folder.run(&["run", "part.nc", "-m", "haas-vf2", "-o", "out.svg"]).ends(0);
    assert!(fs::symlink_metadata(folder.path("out.svg")).unwrap().is_symlink());
    assert!(folder.read("real/out.svg").starts_with("<svg"));
    let mode = fs::metadata(folder.path("real/out.svg")).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o640);
}

/// Waits until it is so.
fn until(is_so: impl Fn() -> bool) {
    let begun = Instant::now();
    while !is_so() {
        assert!(begun.elapsed() < Duration::from_secs(60), "it never came to be so");
        thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn a_signal_leaves_no_draft() {
    let folder = Folder::new();
    folder.write("long.nc", "O1\nG21 G90\nG0 X0 Y0\nS900 M3\nN1 G1 X1. F100.\nX0\nGOTO 1\nM30\n");
    folder.write("out.csv", "old");
    for (signal, name) in [(2, "INT"), (15, "TERM"), (1, "HUP")] {
        for command in [["run", "out.csv"], ["sample", "new.csv"], ["commands", "new.csv"]] {
            let [command, out] = command;
            let most = "1000000000000";
            let arguments = [command, "long.nc", "-m", "fanuc-0i", "--max-blocks", most, "-o", out];
            let mut child = folder
                .command(&arguments)
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn()
                .unwrap();
            until(|| folder.names().iter().any(|name| name.starts_with(".chordal-")));
            let told =
                Command::new("kill").args([&format!("-{name}"), &child.id().to_string()]).status();
            assert!(told.unwrap().success());
            // It ends by the signal, as whoever started it expects.
            assert_eq!(child.wait().unwrap().signal(), Some(signal), "{command}, SIG{name}");
            assert_eq!(folder.names(), ["long.nc", "out.csv"], "{command}, SIG{name}");
            assert_eq!(folder.read("out.csv"), "old");
        }
    }
}

#[test]
fn a_pipe_that_nobody_writes_into_and_a_device_without_end_are_refused() {
    let folder = shop();
    assert!(Command::new("mkfifo").arg(folder.path("pipe.stl")).status().unwrap().success());
    folder.write("pipe.toml", SETUP.replace("block.stl", "pipe.stl"));
    folder.write("zero.toml", SETUP.replace("block.stl", "/dev/zero"));
    symlink("/dev/zero", folder.path("machine.toml")).unwrap();
    for arguments in [
        &["check", "/dev/zero"][..],
        &["check", "part.nc", "-m", "machine.toml"],
        &["stock", "part.nc", "--setup", "zero.toml"],
        &["check", "pipe.stl"],
        &["stock", "part.nc", "--setup", "pipe.toml"],
    ] {
        let done = folder.run(arguments);
        assert_eq!(done.code, 2, "{arguments:?}: {}{}", done.out, done.err);
        assert!(done.err.contains("a pipe"), "{arguments:?}: {}", done.err);
    }
    // One into which somebody writes is a program as any.
    let pipe = folder.path("pipe.stl");
    let writer = thread::spawn(move || fs::write(pipe, CLEAN).unwrap());
    folder.run(&["check", "pipe.stl", "-m", "haas-vf2"]).ends(0);
    writer.join().unwrap();
    assert!(Path::new("/dev/zero").exists());
}
