//! Materials: the specific cutting force by the thickness of the chip (Kienzle: k_c = k_c1.1 · h^−m_c).
//!
//! The groups are those of VDI 3323. The values are ISCAR's: turning catalogue 2017, page 558, and boring guide 2022,
//! page 111. Where the two differ, as for titanium by 70 %, the larger value is taken and `source` quotes the other.
//! A setup file may have values of its own, `[materials.<name>]`.

use std::collections::BTreeMap;

use chordal_machine::CuttingForce;

/// A material with its Kienzle values.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialData {
    /// Its name for people.
    pub name: String,
    /// Its number in VDI 3323; `None` where a setup file gives it.
    pub group: Option<u8>,
    /// The specific cutting force k_c1.1 at a chip of 1 mm × 1 mm, N/mm².
    pub k_c1: f64,
    /// The exponent with which it falls with the thickness of the chip.
    pub m_c: f64,
    /// Where the two values are from.
    pub source: String,
}

/// Why a material of `[stock]` has no values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoMaterial {
    /// There is no such material.
    Unknown,
    /// `[materials]` has it without this key, and the table has no material of the name.
    Lacks(&'static str),
}

impl MaterialData {
    /// The material with a name: one of `[materials]`, or else one of the table.
    ///
    /// # Errors Where there is none, or one of its values is missing.
    pub fn of(
        word: &str,
        own: &BTreeMap<String, CuttingForce>,
    ) -> Result<MaterialData, NoMaterial> {
        let known = MaterialGroup::named(word);
        let is_meant = |name: &str| name.trim().eq_ignore_ascii_case(word.trim());
        let Some((name, own)) = own.iter().find(|(name, _)| is_meant(name)) else {
            return known.map(MaterialGroup::material).ok_or(NoMaterial::Unknown);
        };
        let value = |own: Option<f64>, of: fn(&MaterialGroup) -> f64, key: &'static str| {
            own.or(known.map(of)).ok_or(NoMaterial::Lacks(key))
        };
        Ok(MaterialData {
            k_c1: value(own.k_c1_n_per_mm2, |group| group.k_c1, "k_c1")?,
            m_c: value(own.m_c, |group| group.m_c, "m_c")?,
            name: name.trim().to_string(),
            group: None,
            source: own.source.clone().unwrap_or_else(|| format!("[materials] {}", name.trim())),
        })
    }

    /// The specific cutting force at a mean chip thickness in mm, N/mm²: force over chip section. Below
    /// `MIN_CHIP_MM` it is the value at that thickness.
    pub fn force(&self, mean_mm: f64) -> f64 {
        self.k_c1 * libm::pow(mean_mm.max(MIN_CHIP_MM), -self.m_c)
    }

    /// The power of a cut, kW, from the removal rate in mm³/s and the mean chip thickness in mm. An estimate: see
    /// [`POWER_SHARE`].
    pub fn power(&self, removal: f64, mean_mm: f64) -> f64 {
        self.force(mean_mm) * removal / WATT_MM / 1000.0
    }
}

/// A group of materials of VDI 3323.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaterialGroup {
    /// Its number in VDI 3323.
    pub group: u8,
    /// Its name for people.
    pub name: &'static str,
    /// Names in `[stock] material` that mean it, in lower case.
    pub words: &'static [&'static str],
    /// The specific cutting force k_c1.1 at a chip of 1 mm × 1 mm, N/mm².
    pub k_c1: f64,
    /// The exponent with which it falls with the thickness of the chip.
    pub m_c: f64,
    /// Where the two values are from.
    pub source: &'static str,
}

const BOTH: &str = "ISCAR turning catalogue 2017 p. 558, boring guide 2022 p. 111";
const TURNING: &str =
    "ISCAR turning catalogue 2017 p. 558; its boring guide 2022 p. 111 has 1245 N/mm² and 0.24";

/// The materials with built-in values.
pub const MATERIALS: &[MaterialGroup] = &[
    MaterialGroup {
        group: 1,
        name: "steel below 0.25 % C",
        words: &["low carbon steel", "mild steel", "1018", "s235", "s355", "st37", "c15"],
        k_c1: 1350.0,
        m_c: 0.21,
        source: BOTH,
    },
    MaterialGroup {
        group: 2,
        name: "steel from 0.25 % C on, annealed",
        words: &["steel", "carbon steel", "1045", "c45", "ck45"],
        k_c1: 1500.0,
        m_c: 0.22,
        source: BOTH,
    },
    MaterialGroup {
        group: 7,
        name: "low alloy steel, tempered, 275 HB",
        words: &["alloy steel", "4140", "42crmo4"],
        k_c1: 1675.0,
        m_c: 0.24,
        source: BOTH,
    },
    MaterialGroup {
        group: 14,
        name: "stainless steel, austenitic",
        words: &["stainless", "stainless steel", "304", "316", "1.4301", "1.4404"],
        k_c1: 2150.0,
        m_c: 0.20,
        source: BOTH,
    },
    MaterialGroup {
        group: 15,
        name: "grey cast iron, 180 HB",
        words: &["cast iron", "grey iron", "grey cast iron", "gray iron", "gg25"],
        k_c1: 1150.0,
        m_c: 0.20,
        source: BOTH,
    },
    MaterialGroup {
        group: 18,
        name: "nodular cast iron, pearlitic",
        words: &["nodular iron", "ductile iron", "nodular cast iron", "ggg60"],
        k_c1: 1350.0,
        m_c: 0.28,
        source: BOTH,
    },
    MaterialGroup {
        group: 22,
        name: "wrought aluminium, hardened",
        words: &["aluminium", "aluminum", "6061", "6082", "7075", "6061-t6", "7075-t6"],
        k_c1: 800.0,
        m_c: 0.25,
        source: BOTH,
    },
    MaterialGroup {
        group: 27,
        name: "brass",
        words: &["brass", "360 brass", "cuzn39pb3"],
        k_c1: 700.0,
        m_c: 0.27,
        source: BOTH,
    },
    MaterialGroup {
        group: 34,
        name: "nickel or cobalt alloy, hardened",
        words: &["inconel", "inconel 718", "nickel alloy"],
        k_c1: 3300.0,
        m_c: 0.24,
        source: BOTH,
    },
    MaterialGroup {
        group: 37,
        name: "titanium alloy, alpha and beta",
        words: &["titanium", "ti-6al-4v", "ti6al4v", "grade 5"],
        k_c1: 2110.0,
        m_c: 0.22,
        source: TURNING,
    },
];

impl MaterialGroup {
    /// The group with a name or a number (`VDI 22`, `22`); `None` where there is none.
    pub fn named(word: &str) -> Option<&'static MaterialGroup> {
        let word = word.trim().to_ascii_lowercase();
        let number = word.strip_prefix("vdi").unwrap_or(&word).trim();
        let by_number = number.parse::<u8>().ok();
        MATERIALS.iter().find(|material| {
            Some(material.group) == by_number || material.words.contains(&word.as_str())
        })
    }

    /// A material with the values of the group.
    pub fn material(&self) -> MaterialData {
        MaterialData {
            name: self.name.to_string(),
            group: Some(self.group),
            k_c1: self.k_c1,
            m_c: self.m_c,
            source: self.source.to_string(),
        }
    }
}

/// Kienzle's formula is measured on chips down to about this thickness, mm; extended to zero, its force would be
/// infinite.
pub const MIN_CHIP_MM: f64 = 0.005;

/// Power by this formula is an estimate: edge, rake, wear and coolant change it by up to this share either way.
pub const POWER_SHARE: f64 = 0.3;

/// Watts in N·mm/s.
const WATT_MM: f64 = 1000.0;

/// The torque of a power in kW at a speed in revolutions per minute, N·m.
pub fn torque(power_kw: f64, rpm: f64) -> f64 {
    power_kw * 60_000.0 / (2.0 * std::f64::consts::PI * rpm)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worked_case_of_steel() {
        // Group 2, D10 with 4 teeth, half of it wide, 5 deep, 0.05 a tooth at 3000 rpm.
        let steel = MaterialGroup::named("VDI 2").unwrap().material();
        let feed = 0.05 * 4.0 * 3000.0 / 60.0;
        let removal: f64 = 5.0 * 5.0 * feed;
        assert!((removal * 60.0 - 15_000.0).abs() < 1e-9);
        let mean: f64 = 0.05 * 2.0 / std::f64::consts::PI;
        assert!((mean - 0.031_83).abs() < 1e-5);
        assert!((steel.force(mean) - 3202.0).abs() < 0.5, "{}", steel.force(mean));
        let power = steel.power(removal, mean);
        assert!((power - 0.800_6).abs() < 5e-5, "{power}");
        assert!((torque(power, 3000.0) - 2.548).abs() < 5e-4, "{}", torque(power, 3000.0));
    }

    #[test]
    fn words_and_numbers_name_one_material_each() {
        for material in MATERIALS {
            assert_eq!(
                MaterialGroup::named(&material.group.to_string()).unwrap().group,
                material.group
            );
            for word in material.words {
                assert_eq!(MaterialGroup::named(word).unwrap().group, material.group, "{word}");
            }
        }
        let named = MaterialGroup::named;
        assert_eq!(named(" Aluminum ").unwrap().group, 22);
        assert!(named("unobtainium").is_none() && named("").is_none());
        // A force has an end where the chip has none.
        assert!(MATERIALS[0].material().force(0.0).is_finite());
    }

    #[test]
    fn values_of_a_setup_count_before_the_table() {
        let force = |k_c1_n_per_mm2, m_c| CuttingForce { k_c1_n_per_mm2, m_c, source: None };
        let own = BTreeMap::from([
            ("Bronze".to_string(), force(Some(1780.0), Some(0.17))),
            ("aluminium".to_string(), force(Some(700.0), None)),
            ("unobtainium".to_string(), force(None, Some(0.3))),
        ]);
        let bronze = MaterialData::of(" bronze", &own).unwrap();
        assert_eq!((bronze.k_c1, bronze.m_c, bronze.group), (1780.0, 0.17, None));
        // What is not given is that of the table; another word of the group stays as it is there.
        let aluminium = MaterialData::of("Aluminium", &own).unwrap();
        assert_eq!((aluminium.k_c1, aluminium.m_c), (700.0, 0.25));
        assert_eq!(MaterialData::of("6061", &own).unwrap().k_c1, 800.0);
        assert_eq!(MaterialData::of("unobtainium", &own), Err(NoMaterial::Lacks("k_c1")));
        assert_eq!(MaterialData::of("wood", &own), Err(NoMaterial::Unknown));
    }
}
