//! A TOML document with positions: values are taken key by key, and every error names file, line and key. Keys that
//! remain are unknown and refused.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use glam::{DVec3, Vec3};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::text_file::read_text;
use crate::choice::names_of;
use crate::error::{Error, Result};
use crate::guard::guarded;

/// The text of a TOML file.
pub struct Document {
    file: PathBuf,
    text: String,
}

/// A table whose keys are taken one by one.
pub struct Table<'a> {
    place: Place<'a>,
    /// In the order of the keys.
    entries: Vec<Entry<'a>>,
    taken: Vec<&'static str>,
}

/// A key and its value; the offset is that of the key.
struct Entry<'a> {
    key: &'a str,
    offset: usize,
    value: &'a DeValue<'a>,
}

/// A value and where it stands.
pub struct Value<'a> {
    place: Place<'a>,
    value: &'a DeValue<'a>,
}

/// Where something stands in a document.
#[derive(Clone)]
struct Place<'a> {
    document: &'a Document,
    /// In bytes from the start of the text; made a line only where somebody complains.
    offset: usize,
    /// Dotted; empty for the whole document.
    key: String,
}

impl Document {
    /// Reads a file.
    pub fn read(file: &Path) -> Result<Self> {
        Ok(Self::new(file, read_text(file)?))
    }

    /// A document from its text; `file` is what errors call it and what paths in it are relative to.
    pub fn new(file: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        Self { file: file.into(), text: text.into() }
    }

    /// Parses the text.
    pub fn parse(&self) -> Result<Spanned<DeTable<'_>>> {
        let parsed = guarded("look for what is unusual in it, and take it out", || {
            DeTable::parse(&self.text).map_err(|error| {
                let line = error.span().map_or(1, |span| self.line(span.start));
                Error::new(format!("not valid TOML: {}", error.message().replace('\n', "; "))).at_line(line)
            })
        });
        parsed.map_err(|error| error.in_file(&self.file))
    }

    /// The whole document as a table.
    pub fn root<'a>(&'a self, parsed: &'a Spanned<DeTable<'a>>) -> Table<'a> {
        Table::new(Place { document: self, offset: 0, key: String::new() }, parsed.get_ref())
    }

    /// The folder that relative paths start from.
    pub fn folder(&self) -> &Path {
        self.file.parent().unwrap_or(Path::new(""))
    }

    fn line(&self, offset: usize) -> usize {
        1 + self.text.as_bytes()[..offset.min(self.text.len())].iter().filter(|&&byte| byte == b'\n').count()
    }
}

impl<'a> Place<'a> {
    fn error(&self, problem: impl Into<String>) -> Error {
        let error = Error::new(problem).in_file(&self.document.file).at_line(self.document.line(self.offset));
        if self.key.is_empty() { error } else { error.at_key(&self.key) }
    }

    fn below(&self, key: &str, offset: usize) -> Self {
        let key = if self.key.is_empty() { key.to_owned() } else { format!("{}.{key}", self.key) };
        Self { document: self.document, offset, key }
    }
}

impl<'a> Table<'a> {
    fn new(place: Place<'a>, table: &'a DeTable<'a>) -> Self {
        let entry = |(key, value): (&'a Spanned<_>, &'a Spanned<DeValue<'a>>)| Entry {
            key: AsRef::<str>::as_ref(key.get_ref()),
            offset: key.span().start,
            value: value.get_ref(),
        };
        let mut entries: Vec<_> = table.iter().map(entry).collect();
        entries.sort_by_key(|entry| entry.key);
        Self { place, entries, taken: Vec::new() }
    }

    /// Takes a key that may be missing.
    pub fn optional(&mut self, key: &'static str) -> Option<Value<'a>> {
        self.taken.push(key);
        let index = self.entries.iter().position(|entry| entry.key == key)?;
        let entry = self.entries.remove(index);
        Some(self.value(&entry))
    }

    /// True if the key is there and was not taken.
    pub fn has(&self, key: &str) -> bool {
        self.entries.iter().any(|entry| entry.key == key)
    }

    fn value(&self, entry: &Entry<'a>) -> Value<'a> {
        Value { place: self.place.below(entry.key, entry.offset), value: entry.value }
    }

    /// Takes a key that must be there.
    pub fn required(&mut self, key: &'static str) -> Result<Value<'a>> {
        self.optional(key).ok_or_else(|| self.misspelt(key).unwrap_or_else(|| self.missing(key)))
    }

    fn missing(&self, key: &str) -> Error {
        self.error(format!("the key \"{key}\" is missing"))
    }

    /// An error that names the key somebody probably meant by a misspelt one: at most two letters differ.
    fn misspelt(&self, key: &str) -> Option<Error> {
        let distance = |found: &str| strsim::damerau_levenshtein(found, key);
        let found = self.entries.iter().min_by_key(|entry| distance(entry.key))?;
        let close = distance(found.key) <= 2 && !self.taken.contains(&found.key);
        close.then(|| self.value(found).error("unknown key").help(format!("did you mean \"{key}\"?")))
    }

    /// Takes all remaining keys.
    pub fn take_all(&mut self) -> Vec<(String, Value<'a>)> {
        let entries = std::mem::take(&mut self.entries);
        entries.iter().map(|entry| (entry.key.to_owned(), self.value(entry))).collect()
    }

    /// Refuses keys that nobody took.
    pub fn finish(self) -> Result<()> {
        let Some(unknown) = self.entries.iter().min_by_key(|entry| entry.offset) else { return Ok(()) };
        let mut known = self.taken.clone();
        known.sort_unstable();
        known.dedup();
        Err(self.value(unknown).error("unknown key").expected(format!("one of {}", known.join(", "))))
    }

    /// An error about this table.
    pub fn error(&self, problem: impl Into<String>) -> Error {
        self.place.error(problem)
    }
}

impl<'a> Value<'a> {
    /// An error about this value.
    pub fn error(&self, problem: impl Into<String>) -> Error {
        self.place.error(problem)
    }

    /// An error that shows what was found.
    fn unexpected(&self, expected: &str) -> Error {
        let found = match self.value {
            DeValue::String(text) => format!("found \"{text}\""),
            DeValue::Integer(number) => format!("found {}", number.as_str()),
            DeValue::Float(number) => format!("found {}", number.as_str()),
            DeValue::Boolean(value) => format!("found {value}"),
            DeValue::Datetime(_) => "found a date".to_owned(),
            DeValue::Array(array) => format!("found a list of length {}", array.len()),
            DeValue::Table(_) => "found a table".to_owned(),
        };
        self.error(found).expected(expected)
    }

    /// True for `{ ... }` and `[table]`.
    pub fn is_table(&self) -> bool {
        self.value.is_table()
    }

    /// True for `[ ... ]`.
    pub fn is_list(&self) -> bool {
        self.value.is_array()
    }

    /// A table.
    pub fn table(&self) -> Result<Table<'a>> {
        let table = self.value.as_table().ok_or_else(|| self.unexpected("a table"))?;
        Ok(Table::new(self.place.clone(), table))
    }

    /// The entries of a list, each with its own place.
    pub fn list(&self) -> Result<Vec<Value<'a>>> {
        let array = self.value.as_array().ok_or_else(|| self.unexpected("a list"))?;
        let entry = |(index, value): (usize, &'a Spanned<DeValue<'a>>)| Value {
            place: Place {
                key: format!("{}[{index}]", self.place.key),
                offset: value.span().start,
                document: self.place.document,
            },
            value: value.get_ref(),
        };
        Ok(array.iter().enumerate().map(entry).collect())
    }

    /// A text.
    pub fn text(&self) -> Result<&'a str> {
        self.value.as_str().ok_or_else(|| self.unexpected("a text in quotes"))
    }

    /// `true` or `false`.
    pub fn boolean(&self) -> Result<bool> {
        self.value.as_bool().ok_or_else(|| self.unexpected("true or false"))
    }

    /// The path of a file, relative to the document's folder.
    pub fn path(&self) -> Result<PathBuf> {
        Ok(self.place.document.folder().join(self.text()?))
    }

    /// A finite number.
    pub fn number(&self) -> Result<f64> {
        self.number_where("a number", |_| true)
    }

    /// A finite number that meets a condition, described by `expected`.
    pub fn number_where(&self, expected: &str, condition: impl Fn(f64) -> bool) -> Result<f64> {
        let digits = match self.value {
            DeValue::Integer(number) if number.radix() == 10 => number.as_str(),
            DeValue::Float(number) => number.as_str(),
            _ => return Err(self.unexpected(expected)),
        };
        let number: Option<f64> = digits.replace('_', "").parse().ok();
        number.filter(|&number| number.is_finite() && condition(number)).ok_or_else(|| self.unexpected(expected))
    }

    /// A whole number in a range.
    pub fn integer(&self, range: std::ops::RangeInclusive<u32>) -> Result<u32> {
        let expected = format!("a whole number from {} to {}", range.start(), range.end());
        let number = self.number_where(&expected, |number| {
            number.fract() == 0.0 && number >= f64::from(*range.start()) && number <= f64::from(*range.end())
        })?;
        Ok(number as u32)
    }

    /// Three numbers.
    pub fn vector(&self) -> Result<DVec3> {
        self.numbers::<3>("three numbers, [x, y, z]").map(DVec3::from_array)
    }

    /// A fixed count of numbers.
    pub fn numbers<const COUNT: usize>(&self, expected: &str) -> Result<[f64; COUNT]> {
        let entries = if self.is_list() { self.list()? } else { return Err(self.unexpected(expected)) };
        if entries.len() != COUNT {
            return Err(self.unexpected(expected));
        }
        let numbers: Vec<f64> = entries.iter().map(Value::number).collect::<Result<_>>()?;
        Ok(numbers.try_into().expect("the count was checked"))
    }

    /// A linear colour: one number for grey, or three for red, green, blue; none negative.
    pub fn colour(&self) -> Result<Vec3> {
        const EXPECTED: &str = "a colour: one number, or [red, green, blue], none negative";
        let colour = if self.is_list() {
            DVec3::from_array(self.numbers::<3>(EXPECTED)?)
        } else {
            DVec3::splat(self.number_where(EXPECTED, |_| true)?)
        };
        if colour.min_element() < 0.0 || !colour.as_vec3().is_finite() {
            return Err(self.unexpected(EXPECTED));
        }
        Ok(colour.as_vec3())
    }

    /// One of the choices of an enum, by their names on the command line.
    pub fn choice<T: ValueEnum>(&self) -> Result<T> {
        let names = names_of::<T>();
        let place = self.one_of(&names.iter().map(String::as_str).collect::<Vec<_>>())?;
        Ok(T::value_variants()[place].clone())
    }

    /// One of several values by their names.
    pub fn named<T: Clone>(&self, values: &[(&str, T)]) -> Result<T> {
        let names: Vec<&str> = values.iter().map(|(name, _)| *name).collect();
        Ok(values[self.one_of(&names)?].1.clone())
    }

    /// The place of a text in a list of those that are known.
    fn one_of(&self, names: &[&str]) -> Result<usize> {
        let place = self.value.as_str().and_then(|text| names.iter().position(|name| *name == text));
        place.ok_or_else(|| self.unexpected(&format!("one of {}", names.join(", "))))
    }
}
