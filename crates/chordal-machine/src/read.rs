//! Reads machine files: first the files that they inherit from, then their own keys.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::builtin::{builtin, builtin_names};
use crate::check::{INHERITS, SchemaLocation, put_table};
use crate::control::ControlName;
use crate::designated_tool::contradictions;
use crate::error::{ErrorSource, MachineError};
use crate::files::{in_folder_of, is_separator};
use crate::machine::Machine;
use crate::suggest;

/// The largest depth of inheritance.
const MAX_INHERITANCE_DEPTH: usize = 16;

/// Returns the text of a file by name, or the reason why it cannot.
type TextLoader<'l> = &'l dyn Fn(&str) -> Result<String, String>;

impl Machine {
    /// Reads a built-in machine.
    pub fn from_builtin(name: &str) -> Result<Machine, Vec<MachineError>> {
        let Some(text) = builtin(name) else {
            let help = builtin_help(name);
            let message = format!("there is no built-in machine `{name}`");
            return Err(vec![ErrorSource::new(name, "").error(None, message, Some(help))]);
        };
        read(&builtin_file(name), text, &|_| {
            Err("built-in machines inherit only from built-in ones".into())
        })
    }

    /// Reads a machine file. `inherits` names a built-in machine, or else a file, whose text `loader` returns. `loader`
    /// gets the name joined to the folder of the file with the key, so that it is relative to the same folder as
    /// `file_name`. Every error of every file is reported.
    pub fn from_toml(
        file_name: &str,
        text: &str,
        loader: &dyn Fn(&str) -> Result<String, String>,
    ) -> Result<Machine, Vec<MachineError>> {
        read(file_name, text, loader)
    }
}

fn read(file: &str, text: &str, loader: TextLoader<'_>) -> Result<Machine, Vec<MachineError>> {
    let mut reader = MachineReader {
        loader,
        // This control is a placeholder until a file names one; no machine is returned without.
        machine: Machine::without_axes("", ControlName::Fanuc),
        control_is_known: false,
        parts_missing: false,
        errors: Vec::new(),
        chain: Vec::new(),
    };
    reader.machine.title.clear();
    reader.load(file, text);
    if !reader.control_is_known && !reader.parts_missing {
        let names: Vec<&str> = ControlName::ALL.iter().map(|control| control.as_str()).collect();
        let help = format!("write `control = \"…\"` with {}", suggest::or_list(&names));
        let message = "the machine file does not name its control";
        reader.errors.push(ErrorSource::new(file, text).error(None, message, Some(help)));
    }
    if reader.errors.is_empty() {
        reader.errors = contradictions(&reader.machine);
    }
    if !reader.errors.is_empty() {
        return Err(reader.errors);
    }
    let mut machine = reader.machine;
    if machine.title.is_empty() {
        machine.title = machine.name.clone();
    }
    machine.give_default_axes();
    Ok(machine)
}

struct MachineReader<'l> {
    loader: TextLoader<'l>,
    machine: Machine,
    control_is_known: bool,
    /// A part could not be read, so missing keys may be in it.
    parts_missing: bool,
    errors: Vec<MachineError>,
    /// The files that are being read, each of which inherits from the next.
    chain: Vec<String>,
}

impl MachineReader<'_> {
    fn load(&mut self, file: &str, text: &str) {
        let source = ErrorSource::new(file, text);
        let (document, syntax) = DeTable::parse_recoverable(text);
        let document = document.into_inner();
        self.chain.push(normal(file));
        let mut parents = INHERITS.iter().filter_map(|key| Some((*key, document.get(*key)?)));
        let parent = parents.next();
        if let Some((key, parent)) = parent {
            self.inherit(key, parent, file, &source);
        }
        if let Some((key, second)) = parents.next() {
            let message = format!("`{key}` has no meaning together with `inherits`");
            let help = Some("one of the two names the machine".to_string());
            self.errors.push(source.error(Some(second.span()), message, help));
        }
        if parent.is_none_or(|(key, _)| key == "inherits") {
            self.machine.name = stem(file).to_string();
        }
        self.control_is_known |= document.contains_key("control");

        let mut errors = Vec::new();
        put_table(&mut self.machine, &SchemaLocation::default(), &document, &source, &mut errors);
        if !syntax.is_empty() {
            self.parts_missing = true;
            let mut syntax: Vec<MachineError> = syntax
                .iter()
                .map(|error| source.error(error.span(), error.message(), None))
                .collect();
            syntax.sort_by_key(MachineError::line);
            syntax.dedup_by_key(|error| error.line());
            // After a syntax error the keys may be wrong, and values from error recovery have no position.
            let first = syntax[0].line().unwrap_or(0);
            errors.retain(|error| {
                error.line().is_some_and(|line| line < first) && !error.underlined().is_empty()
            });
            errors.extend(syntax);
        }
        errors.sort_by_key(|error| error.span.as_ref().map(|span| (span.start, span.end)));
        self.errors.append(&mut errors);
        self.chain.pop();
    }

    fn inherit(
        &mut self,
        key: &str,
        parent: &Spanned<DeValue<'_>>,
        file: &str,
        source: &ErrorSource,
    ) {
        let refuse = |message: String, help: Option<String>| {
            source.error(Some(parent.span()), message, help)
        };
        let DeValue::String(name) = parent.get_ref() else {
            self.parts_missing = true;
            let help = format!("write `{key} = \"haas-vf2\"`");
            let message = format!("`{key}` needs the name of a machine or of a file");
            self.errors.push(refuse(message, Some(help)));
            return;
        };
        let (parent_file, inside) = match builtin(name) {
            Some(text) => (builtin_file(name), Some(text)),
            None => (in_folder_of(file, name), None),
        };
        let problem = if self.chain.contains(&normal(&parent_file)) {
            let round: Vec<&str> =
                self.chain.iter().map(String::as_str).chain([parent_file.as_str()]).collect();
            Some(refuse(format!("`inherits` goes in a circle: {}", round.join(" -> ")), None))
        } else if self.chain.len() >= MAX_INHERITANCE_DEPTH {
            Some(refuse(
                format!("more than {MAX_INHERITANCE_DEPTH} files inherit from each other"),
                None,
            ))
        } else {
            match inside.map_or_else(|| (self.loader)(&parent_file), |text| Ok(text.to_string())) {
                Ok(text) => {
                    self.load(&parent_file, &text);
                    None
                }
                Err(why) => Some(refuse(
                    format!(
                        "`{name}` is neither a built-in machine nor a file that can be read: {why}"
                    ),
                    Some(builtin_help(name)),
                )),
            }
        };
        if let Some(problem) = problem {
            self.parts_missing = true;
            self.errors.push(problem);
        }
    }
}

/// The file name of a built-in machine in errors.
fn builtin_file(name: &str) -> String {
    format!("built-in/{name}.toml")
}

fn builtin_help(name: &str) -> String {
    match suggest::nearest(name, builtin_names().iter().copied()) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("the built-in machines are {}", builtin_names().join(", ")),
    }
}

/// The name of a file without folder and extension.
fn stem(file: &str) -> &str {
    let name = file.rsplit(is_separator).next().unwrap_or(file);
    name.strip_suffix(".toml").filter(|name| !name.is_empty()).unwrap_or(name)
}

/// The name with `.` and `..` resolved, so that circular inheritance is detected.
fn normal(file: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in file.split(is_separator) {
        match part {
            "." => {}
            ".." if parts.last().is_some_and(|last| !last.is_empty() && *last != "..") => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files() {
        assert_eq!(stem("shop/vmc.toml"), "vmc");
        assert_eq!(stem("C:\\shop\\vmc.toml"), "vmc");
        assert_eq!(stem("vmc"), "vmc");
        assert_eq!(stem(".toml"), ".toml");
        assert_eq!(in_folder_of("shop/vmc.toml", "base.toml"), "shop/base.toml");
        assert_eq!(in_folder_of("vmc.toml", "base.toml"), "base.toml");
        assert_eq!(in_folder_of("shop/vmc.toml", "/base.toml"), "/base.toml");
        assert_eq!(in_folder_of("shop/vmc.toml", "C:/base.toml"), "C:/base.toml");
        assert_eq!(normal("shop/../shop/./vmc.toml"), "shop/vmc.toml");
        assert_eq!(normal("../vmc.toml"), "../vmc.toml");
    }
}
