//! The order of the house, read off the source: no import runs upwards, and no files import each other in a circle.
//!
//! A file imports another if it names a path that leads there, in a `use` or in its code. What stands behind
//! `#[cfg(test)]` does not count. A re-export (`pub use` in a `mod.rs` or `lib.rs`) of a name that the file itself does not
//! use is not an import: paths are followed through it to the file that defines the name. So a `mod.rs` that only lists its
//! files is never part of a circle; one with code is, if that code uses a file that uses it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The packages, each may import those before it: name and folder.
const PACKAGES: [(&str, &str); 4] = [
    ("skycube_files", "src/files"),
    ("skycube_tracer", "src/tracer"),
    ("skycube_analysis", "src/analysis"),
    ("skycube", "src"),
];

/// Modules in their order, each may import those before it.
const ORDERS: [&[&str]; 5] = [
    &[
        "skycube_tracer::parallel",
        "skycube_tracer::math",
        "skycube_tracer::colour",
        "skycube_tracer::sampling",
        "skycube_tracer::picture",
        "skycube_tracer::envmap",
        "skycube_tracer::bvh",
        "skycube_tracer::shapes",
        "skycube_tracer::camera",
        "skycube_tracer::lights",
        "skycube_tracer::materials",
        "skycube_tracer::scene",
        "skycube_tracer::integrators",
        "skycube_tracer::render",
    ],
    &[
        "skycube_tracer::integrators::common",
        "skycube_tracer::integrators::textbook",
        "skycube_tracer::integrators::side_by_side",
        "skycube_tracer::integrators::guided",
    ],
    &["skycube_analysis::stress", "skycube_analysis::validator_limits"],
    &["skycube_analysis::validate", "skycube_analysis::validator_limits"],
    &["skycube::lessons", "skycube::report", "skycube::commands"],
];

/// Tools that stand side by side: none imports another.
const SIDE_BY_SIDE: [&str; 5] = [
    "skycube_analysis::compare",
    "skycube_analysis::converge",
    "skycube_analysis::grade",
    "skycube_analysis::stress",
    "skycube_analysis::validate",
];

/// A module: its path, as in `skycube_tracer::math::ray`.
type Module = String;

/// What a source says, without comments, texts and tests.
#[derive(Default)]
struct Source {
    /// Paths of `use`, expanded, and whether it is a re-export.
    uses: Vec<(Vec<String>, bool)>,
    /// Paths in the code.
    paths: Vec<Vec<String>>,
    /// Names in the code.
    names: BTreeSet<String>,
}

struct House {
    sources: BTreeMap<Module, Source>,
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let circles = circles(&House::read().imports());
    assert!(circles.is_empty(), "{} circles:\n{}", circles.len(), circles.join("\n"));
}

#[test]
fn no_import_runs_upwards() {
    let is_in = |module: &str, folder: &str| module == folder || module.starts_with(&format!("{folder}::"));
    let place = |order: &[&str], module: &str| order.iter().position(|folder| is_in(module, folder));
    let mut faults = Vec::new();
    for (from, to) in House::read().imports().iter().flat_map(|(from, all)| all.iter().map(move |to| (from, to))) {
        for order in ORDERS {
            if let (Some(above), Some(below)) = (place(order, from), place(order, to))
                && below > above
            {
                faults.push(format!("{from} imports {to}, which stands above it"));
            }
        }
        if let (Some(one), Some(other)) = (place(&SIDE_BY_SIDE, from), place(&SIDE_BY_SIDE, to))
            && one != other
        {
            faults.push(format!("{from} imports {to}, which stands beside it"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn circles_and_re_exports_are_told_apart() {
    let house = |sources: &[(&str, &str)]| House {
        sources: sources.iter().map(|(module, text)| ((*module).to_owned(), Source::parse(text))).collect(),
    };
    let listed = house(&[
        ("skycube", ""),
        ("skycube::a", "mod b; mod c; pub use b::B; pub use c::{C, D as E};"),
        ("skycube::a::b", "use super::E; /* super::c */ struct B(&'static str);"),
        ("skycube::a::c", "const C: &str = \"use super::B;\"; #[cfg(test)] mod tests { use super::super::B; }"),
    ]);
    assert_eq!(listed.imports()["skycube::a::b"], BTreeSet::from(["skycube::a::c".to_owned()]));
    assert_eq!(circles(&listed.imports()), [""; 0]);
    let own_code = house(&[
        ("skycube", ""),
        ("skycube::a", "mod b; struct A; fn f() { b::g() }"),
        ("skycube::a::b", "pub fn g() -> super::A { super::A }"),
    ]);
    assert_eq!(circles(&own_code.imports()), ["skycube::a, skycube::a::b"]);
}

impl House {
    fn read() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let mut sources = BTreeMap::new();
        for (package, folder) in PACKAGES {
            for file in files(&root.join(folder)) {
                let inside = file.strip_prefix(root.join(folder)).unwrap().with_extension("");
                let mut module: Vec<&str> = inside.iter().map(|part| part.to_str().unwrap()).collect();
                // The root package has the others in its folder; tests are not part of the house.
                let other = package == "skycube" && ["files", "tracer", "analysis"].contains(&module[0]);
                if other || module.contains(&"tests") {
                    continue;
                }
                module.retain(|part| !["mod", "lib"].contains(part));
                let path = [&[package], &module[..]].concat().join("::");
                sources.insert(path, Source::parse(&std::fs::read_to_string(&file).unwrap()));
            }
        }
        assert!(sources.len() > 100, "the sources are elsewhere");
        Self { sources }
    }

    /// Which modules each one imports.
    fn imports(&self) -> BTreeMap<Module, BTreeSet<Module>> {
        let imports = |(module, source): (&Module, &Source)| {
            let used = |(path, re_export): &&(Vec<String>, bool)| {
                !re_export || path.last().is_some_and(|name| source.names.contains(name))
            };
            let uses = source.uses.iter().filter(used).map(|(path, _)| path);
            let found = uses.chain(&source.paths).filter_map(|path| self.resolved(module, path));
            (module.clone(), found.filter(|other| other != module).collect())
        };
        self.sources.iter().map(imports).collect()
    }

    /// The module that a path in another one leads to.
    fn resolved(&self, module: &str, path: &[String]) -> Option<Module> {
        let (first, rest) = path.split_first()?;
        let package = module.split("::").next()?;
        match first.as_str() {
            "crate" => self.followed(package, rest),
            "self" => self.followed(module, rest),
            "super" => {
                let parent = module.rsplit_once("::")?.0;
                if rest.first().is_some_and(|next| next == "super") {
                    return self.resolved(parent, rest);
                }
                self.followed(parent, rest)
            }
            name if PACKAGES.iter().any(|(package, _)| *package == name) => self.followed(name, rest),
            name if self.sources.contains_key(&format!("{module}::{name}")) => self.followed(module, path),
            _ => None,
        }
    }

    /// Goes down a path from a module, through re-exports.
    fn followed(&self, module: &str, path: &[String]) -> Option<Module> {
        let source = self.sources.get(module)?;
        let Some((name, rest)) = path.split_first() else { return Some(module.to_owned()) };
        let child = format!("{module}::{name}");
        if self.sources.contains_key(&child) {
            return self.followed(&child, rest);
        }
        // A name that the root of a package imports serves the whole package.
        let is_root = !module.contains("::");
        let through = source.uses.iter().find(|(path, re_export)| (*re_export || is_root) && path.last() == Some(name));
        match through {
            Some((target, _)) => self.resolved(module, &[target, rest].concat()),
            None => Some(module.to_owned()),
        }
    }
}

/// Sets of modules each of which imports, over others of the set, all others.
fn circles(imports: &BTreeMap<Module, BTreeSet<Module>>) -> Vec<String> {
    let reached = |from: &Module| {
        let mut reached = BTreeSet::new();
        let mut waiting: Vec<&Module> = imports[from].iter().collect();
        while let Some(module) = waiting.pop() {
            if reached.insert(module.clone()) {
                waiting.extend(imports.get(module).into_iter().flatten());
            }
        }
        reached
    };
    let reached: BTreeMap<&Module, BTreeSet<Module>> = imports.keys().map(|module| (module, reached(module))).collect();
    let circle = |module: &Module| {
        let together =
            reached[module].iter().filter(|other| reached.get(other).is_some_and(|back| back.contains(module)));
        together.cloned().collect::<Vec<_>>().join(", ")
    };
    let circles: BTreeSet<String> = imports.keys().map(circle).collect();
    circles.into_iter().filter(|circle| !circle.is_empty()).collect()
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

impl Source {
    fn parse(text: &str) -> Self {
        let tokens = without_tests(tokens(text));
        let mut source = Self::default();
        let mut index = 0;
        while index < tokens.len() {
            if tokens[index] == "use" {
                let end = index + tokens[index..].iter().position(|token| token == ";").unwrap_or(0);
                // `pub use`, `pub(crate) use`.
                let re_export = index > 0 && ["pub", ")"].contains(&tokens[index - 1].as_str());
                let paths = expanded(&tokens[index + 1..end]);
                source.uses.extend(paths.into_iter().map(|path| (path, re_export)));
                index = end.max(index + 1);
                continue;
            }
            let mut path = vec![tokens[index].clone()];
            while tokens.get(index + 1).is_some_and(|token| token == "::") && tokens.len() > index + 2 {
                path.push(tokens[index + 2].clone());
                index += 2;
            }
            // `mod name;` names nothing.
            if index == 0 || tokens[index - 1] != "mod" {
                source.names.insert(path[0].clone());
            }
            if path.len() > 1 {
                source.paths.push(path);
            }
            index += 1;
        }
        source
    }
}

/// The paths of a `use`: `a::{b, c as d}` is `a::b` and `a::c`.
fn expanded(tokens: &[String]) -> Vec<Vec<String>> {
    let mut paths = Vec::new();
    let mut prefixes: Vec<Vec<String>> = vec![Vec::new()];
    let mut path: Vec<String> = Vec::new();
    let mut skip = false;
    for token in tokens.iter().map(String::as_str).chain([","]) {
        match token {
            "{" => prefixes.push(std::mem::take(&mut path)),
            "}" | "," => {
                if !path.is_empty() {
                    let full = prefixes.concat().into_iter().chain(std::mem::take(&mut path));
                    paths.push(full.filter(|part| part != "self" || prefixes.len() == 1).collect());
                }
                if token == "}" {
                    prefixes.pop();
                }
            }
            "as" => skip = true,
            "::" => {}
            _ if skip => {
                // The new name is what the code says; a re-export is found by it.
                path.pop();
                path.push(token.to_owned());
                skip = false;
            }
            name => path.push(name.to_owned()),
        }
    }
    paths
}

/// Words, `::` and single signs, without comments, texts and characters.
fn tokens(text: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if first == '"' {
            text_length(rest)
        } else if first == '\'' {
            character_length(rest)
        } else if first.is_alphanumeric() || first == '_' {
            let length = rest.find(|sign: char| !sign.is_alphanumeric() && sign != '_').unwrap_or(rest.len());
            tokens.push(rest[..length].to_owned());
            length
        } else if rest.starts_with("::") {
            tokens.push("::".to_owned());
            2
        } else {
            if !first.is_whitespace() {
                tokens.push(first.to_string());
            }
            first.len_utf8()
        };
        rest = &rest[length..];
    }
    tokens
}

/// The length of a text in quotes.
fn text_length(rest: &str) -> usize {
    let mut escaped = false;
    for (index, sign) in rest.char_indices().skip(1) {
        match sign {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return index + 1,
            _ => {}
        }
    }
    rest.len()
}

/// The length of a character in quotes, or of the sign that begins a lifetime.
fn character_length(rest: &str) -> usize {
    let mut signs = rest.char_indices().skip(1);
    match (signs.next(), signs.next()) {
        (Some((_, '\\')), _) => {
            rest[2..].char_indices().skip(1).find(|(_, sign)| *sign == '\'').map_or(1, |(end, _)| end + 3)
        }
        (Some(_), Some((end, '\''))) => end + 1,
        _ => 1,
    }
}

/// The tokens without the items behind `#[cfg(test)]`.
fn without_tests(tokens: Vec<String>) -> Vec<String> {
    const ATTRIBUTE: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];
    let mut kept = Vec::new();
    let mut index = 0;
    while index < tokens.len() {
        if !tokens[index..].iter().take(ATTRIBUTE.len()).eq(ATTRIBUTE.iter()) {
            kept.push(tokens[index].clone());
            index += 1;
            continue;
        }
        let mut depth = 0;
        for token in &tokens[index + ATTRIBUTE.len()..] {
            index += 1;
            match token.as_str() {
                "{" => depth += 1,
                "}" => depth -= 1,
                _ => {}
            }
            if depth == 0 && [";", "}"].contains(&token.as_str()) {
                break;
            }
        }
        index += ATTRIBUTE.len();
    }
    kept
}
