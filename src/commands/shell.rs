//! `skycube completions` and `skycube man`: what a shell wants to know about the command line.

use std::path::PathBuf;

use clap::{Args, Command};
use clap_complete::Shell;

use super::terminal::{Outcome, print};
use crate::error::{Error, Result};
use crate::picture::{make_folder, write_together};

#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell
    shell: Shell,
}

#[derive(Debug, Args)]
pub struct ManArguments {
    /// The folder to write skycube.1, skycube-check.1, ... to; made if it is missing
    folder: PathBuf,
}

/// Prints the completions of a shell.
pub fn completions(arguments: &CompletionsArguments, mut command: Command) -> Result<Outcome> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, "skycube", &mut script);
    print(String::from_utf8_lossy(&script));
    Ok(Outcome::Clean)
}

/// Writes a manual page for the program and for each command.
pub fn man(arguments: &ManArguments, mut command: Command) -> Result<Outcome> {
    command.build();
    let mut pages = Vec::new();
    for page in with_subcommands(&command).into_iter().map(|command| clap_mangen::Man::new(command.clone())) {
        let mut text = Vec::new();
        page.render(&mut text).map_err(|error| Error::new(format!("cannot make a manual page: {error}")))?;
        pages.push((arguments.folder.join(page.get_filename()), text));
    }
    make_folder(&arguments.folder)?;
    write_together(pages.iter().map(|(path, page)| (path.as_path(), page.as_slice())))?;
    pages.iter().for_each(|(path, _)| print(format_args!("wrote {}\n", path.display())));
    Ok(Outcome::Clean)
}

/// A command and all below it. `skycube lessons start` has the page skycube-lessons-start.
fn with_subcommands(command: &Command) -> Vec<&Command> {
    let below = command.get_subcommands().filter(|below| below.get_name() != "help");
    std::iter::once(command).chain(below.flat_map(with_subcommands)).collect()
}
