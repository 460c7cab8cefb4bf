//! How hard the cuts of programs are: the worked cases, units, what is too much, what is not known.

#![allow(clippy::disallowed_methods, reason = "a test reads the page")]

use chordal::stock::{
    EngagementOptions, EngagementReport, MATERIALS, MaterialGroup, NoMaterial, StockOptions,
};
use chordal::{Code, Job, Machine, Source, SourceMap};

/// Group 2 of VDI 3323; a cutter of 10 mm with 4 teeth.
const SETUP: &str = "machine = 'haas-vf2'
[stock]
shape = 'box'
from = { X = '0 mm', Y = '0 mm', Z = '-20 mm' }
to = { X = '100 mm', Y = '60 mm', Z = '0 mm' }
material = 'steel'
[tools.1]
shape = 'flat'
diameter = '10 mm'
teeth = 4
flute_length = '25 mm'
length = '0 mm'
";

/// Half of the cutter wide, 5 mm deep, 0.05 mm a tooth at 3000 rpm.
const HALF: &str = "O1\nG21 G90 G54 G17\nT1 M6\nS3000 M3\nG0 X-8. Y0.\nG43 H1 Z5.\nG1 Z-5. F2000.\nX110. F600.\n\
                    G0 Z5.\nM5\nM30\n";

fn run_on(setup: &str, program: &str, resolution: f64) -> EngagementReport {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.as_bytes().to_vec()));
    let machine = Machine::from_toml("setup.toml", setup, &|name| Err(name.to_string()));
    let job = Job::new(sources, machine.unwrap()).unwrap();
    let stock = StockOptions { resolution_mm: Some(resolution), ..StockOptions::default() };
    let options = EngagementOptions { stock, ..EngagementOptions::default() };
    job.engagement(&options, &|name| Err(name.to_string())).unwrap()
}

fn near(value: f64, truth: f64, share: f64) {
    assert!((value / truth - 1.0).abs() < share, "{value} is not {truth}");
}

#[test]
fn the_worked_case_of_half_a_cutter_in_steel() {
    // Case 23: h_m 0.03183, Q 15,000 mm³/min, 0.8006 kW, 2.548 N·m.
    let found = run_on(SETUP, HALF, 0.1);
    let tool = &found.tools[0];
    let chip = tool.chip_mm.unwrap();
    near(chip.peak, 0.05, 1e-9);
    near(tool.across_mm.typical, 5.0, 0.04);
    near(tool.axial_mm.typical, 5.0, 1e-4);
    near(tool.rate_mm3_per_s.typical * 60.0, 15_000.0, 0.02);
    near(tool.power_kw.unwrap().typical, 0.8006, 0.02);
    near(tool.torque_nm.unwrap().typical, 2.548, 0.02);
    let mean = found.moves.last().unwrap().chip.unwrap().mean_mm;
    near(mean, 0.031_83, 0.02);
    // Q is what is removed by time: half a slot, and the round end of the cutter outside is air.
    near(tool.removed_mm3, 5.0 * 5.0 * 100.0, 0.01);
    assert!(found.is_whole && found.problems.is_empty());
    assert_eq!(found.material.unwrap().group, Some(2));
}

#[test]
fn inches_and_millimetres_are_one_cut() {
    let inch = HALF
        .replace("G21", "G20")
        .replace("X-8. Y0.", "X-0.32 Y0.")
        .replace("Z5.\nG1", "Z.2\nG1")
        .replace("Z-5. F2000.", "Z-.196850393700787 F80.")
        .replace("X110. F600.", "X4.4 F23.6220472440945")
        .replace("G0 Z5.", "G0 Z.2");
    let [one, other] = [HALF, inch.as_str()].map(|text| run_on(SETUP, text, 0.2));
    let [a, b] = [&one, &other].map(|found| &found.tools[0]);
    near(b.chip_mm.unwrap().peak, a.chip_mm.unwrap().peak, 1e-3);
    near(b.power_kw.unwrap().typical, a.power_kw.unwrap().typical, 5e-3);
    near(b.removed_mm3, a.removed_mm3, 5e-3);
}

#[test]
fn what_is_too_much_and_what_rubs_is_said_with_its_line() {
    let weak = SETUP.replace("[stock]", "[spindle]\nmax = '8100 rpm'\npower = '500 W'\n[stock]");
    let found = run_on(&weak, HALF, 0.2);
    let problem = &found.problems[0];
    assert_eq!((problem.code, problem.line, problem.tool), (Code::SpindleOverloaded, 8, 1));
    near(0.5 * (problem.value.least + problem.value.most), 0.8, 0.05);
    assert_eq!(problem.limit, 0.5);
    let thin = SETUP.replace("teeth = 4", "teeth = 4\nmax_chip = '0.04 mm'");
    let found = run_on(&thin, HALF, 0.2);
    assert_eq!((found.problems[0].code, found.problems[0].line), (Code::ChipTooThick, 8));
    near(found.problems[0].value.most, 0.05, 1e-9);
    // At 60 mm/min a tooth takes 0.005 mm.
    let blunt = SETUP.replace("teeth = 4", "teeth = 4\nmin_chip = '0.01 mm'");
    let slow = HALF.replace("F600.", "F60.");
    let found = run_on(&blunt, &slow, 0.2);
    assert_eq!((found.problems[0].code, found.problems[0].line), (Code::ToolRubs, 8));
    assert!(run_on(&blunt, HALF, 0.2).problems.is_empty());
    let said = found.report.diagnostics.iter().find(|each| each.code == Code::ToolRubs).unwrap();
    assert!(said.message.contains("at most 0.005 mm"), "{}", said.message);
}

#[test]
fn nothing_is_guessed() {
    // Without teeth there is no chip and no power; depths and removal are there.
    let found = run_on(&SETUP.replace("teeth = 4\n", ""), HALF, 0.2);
    let tool = &found.tools[0];
    assert!(tool.chip_mm.is_none() && tool.power_kw.is_none() && tool.rate_mm3_per_s.peak > 0.0);
    let found = run_on(&SETUP.replace("'steel'", "'unobtainium'"), HALF, 0.2);
    assert!(found.material.is_none() && found.tools[0].power_kw.is_none());
    assert_eq!(found.material_word.as_deref(), Some("unobtainium"));
    assert_eq!(found.no_material, Some(NoMaterial::Unknown));
    let found = run_on(SETUP, &HALF.replace("T1 M6", "T5 M6"), 0.2);
    assert!(!found.is_whole && found.tools.is_empty());
}

#[test]
fn a_setup_has_its_own_materials() {
    // Twice the force of the table is twice the power.
    let table = run_on(SETUP, HALF, 0.2);
    let own = "[materials.Steel]\nk_c1 = '3000 N/mm²'\n";
    let found = run_on(&format!("{SETUP}{own}"), HALF, 0.2);
    let [once, twice] = [&table, &found].map(|found| found.tools[0].power_kw.unwrap().peak);
    assert!((twice / once - 2.0).abs() < 1e-9, "{once} {twice}");
    let material = found.material.unwrap();
    assert_eq!((material.k_c1, material.m_c, material.group), (3000.0, 0.22, None));
    let half = format!(
        "{}[materials.unobtainium]\nm_c = 0.3\n",
        SETUP.replace("'steel'", "'unobtainium'")
    );
    let found = run_on(&half, HALF, 0.2);
    assert_eq!(found.no_material, Some(NoMaterial::Lacks("k_c1")));
    assert!(found.material.is_none() && found.tools[0].power_kw.is_none());
}

#[test]
fn the_page_has_the_table_of_materials() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/engagement.md");
    let page = std::fs::read_to_string(path).expect("the page");
    for material in MATERIALS {
        let MaterialGroup { group, name, words, k_c1, m_c, .. } = material;
        let row = format!("| {group} | {name} | {k_c1} | {m_c} | {} |\n", words.join(", "));
        assert!(page.contains(&row), "{row}");
    }
    assert_eq!(
        page.lines().filter(|line| line.starts_with('|') && line.matches('|').count() == 6).count(),
        MATERIALS.len() + 2
    );
}
