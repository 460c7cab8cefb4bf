//! `chordal view`: what is said before a page is served.

mod common;

use common::{CLEAN, Folder};

#[test]
fn wrong_use_is_told_before_anything_is_served() {
    let folder = Folder::new();
    folder.write("a.nc", CLEAN).write("b.nc", CLEAN);
    let cases: [(&[&str], &str); 6] = [
        (&["a.nc", "--against", "none.nc"], "cannot read none.nc"),
        (&["a.nc", "--against", "b.nc", "--as", "haas-vf2"], "--as is given once for two programs"),
        (&["a.nc", "--as", "haas-vf2", "--as", "nothing-like-it"], "nothing-like-it"),
        (&["a.nc", "--against", "b.nc", "--tolerance=-1mm"], "write a length of zero or more"),
        (&["a.nc", "--as", "haas-vf2", "--as", "haas-vf2", "--as", "haas-vf2"], "more than twice"),
        (&["-", "--against", "-"], "both programs are standard input"),
    ];
    for (words, said) in cases {
        let done = folder.run(&[&["view", "--no-browser"][..], words].concat()).ends(2);
        assert!(done.err.contains(said), "{words:?}: {}", done.err);
        assert_eq!(done.out, "", "{words:?}");
    }
}
