//! Named choices: one derive, `clap::ValueEnum`, gives their names to the command line, to scene files and to reports.

use clap::ValueEnum;

/// What a choice is called.
pub fn name_of<T: ValueEnum>(choice: T) -> String {
    choice.to_possible_value().expect("no choice is hidden").get_name().to_owned()
}

/// What all choices are called.
pub fn names_of<T: ValueEnum>() -> Vec<String> {
    T::value_variants().iter().cloned().map(name_of).collect()
}
