//! The help: commands in groups by what people want, and examples for each.

use clap::Command;

/// The commands, by what people want.
const GROUPS: [(&str, &[&str]); 5] = [
    ("Check a skybox", &["check", "fix", "convert", "view", "cross", "shots", "probe"]),
    ("Grade and compare", &["grade", "compare"]),
    ("Render", &["render", "bake", "trace", "converge", "stress"]),
    ("Learn", &["lessons"]),
    ("Shell", &["schema", "completions", "man", "help"]),
];

/// What one types, in the order of the groups.
#[rustfmt::skip]
const EXAMPLES: [(&str, &[&str]); 18] = [
    ("check", &[
        "skycube check Meadow.zip",
        "skycube check textures/sky --engine unity",
        "skycube check skies/*/ --strict",
        "skycube check skies -q",
        "skycube check skies --format github",
        "curl -s https://example.com/sky.zip | skycube check -",
    ]),
    ("fix", &[
        "skycube fix Meadow.zip -o repaired",
        "skycube fix skies -o repaired",
        "skycube fix textures/sky --lookup exercise --code cpp",
    ]),
    ("convert", &[
        "skycube convert Meadow.zip -o cross.png --to cross",
        "skycube convert panorama.hdr -o faces --to faces --size 1024",
        "skycube convert Meadow.zip -o panorama.png --to equirectangular",
    ]),
    ("view", &[
        "skycube view Meadow.zip",
        "skycube view textures/sky --engine babylon -o sky.html",
    ]),
    ("cross", &[
        "skycube cross Meadow.zip -o cross.png",
        "skycube cross skies --sheet -o skies.png",
        "skycube cross textures/sky --engine unreal --fixed -o cross.png",
        "skycube cross Meadow.zip -o - | display",
    ]),
    ("shots", &[
        "skycube shots Meadow.zip --lookup humus-z-up -o shots",
        "skycube shots textures/sky --engine threejs --size 256 -o shots",
    ]),
    ("probe", &[
        "skycube probe Meadow.zip --lookup humus-z-up --direction 0.3,-1,0.5",
    ]),
    ("grade", &[
        "skycube grade my-shots --map Meadow.zip --lookup humus-z-up",
        "skycube grade my-shots --map Meadow.zip --code cpp",
    ]),
    ("compare", &[
        "skycube compare mine.png expected.png",
        "skycube compare mine.png expected.png --metric psnr --threshold 35 -o difference.png",
        "skycube compare renders expected -o differences.html",
        "skycube compare renders expected --update",
        "my-renderer scene.txt | skycube compare - expected.png",
    ]),
    ("render", &[
        "skycube render scene.toml",
        "skycube render scene.toml --integrator path --samples 64 -o picture.exr",
        "skycube render scene.toml --time 10s -o - | display",
    ]),
    ("bake", &[
        "skycube bake scene.toml -o baked --face-size 1024",
        "skycube bake scene.toml -o - | skycube check -",
    ]),
    ("trace", &[
        "skycube trace scene.toml --pixel 220,360",
    ]),
    ("converge", &[
        "skycube converge scene.toml --samples 1,4,16,64",
    ]),
    ("stress", &[
        "skycube stress --rays 20000",
    ]),
    ("lessons", &[
        "skycube lessons",
        "skycube lessons 06 --language cs",
        "skycube lessons start 06 -o my-lesson",
    ]),
    ("schema", &[
        "skycube schema check > check.schema.json",
    ]),
    ("completions", &[
        "skycube completions bash > ~/.local/share/bash-completion/completions/skycube",
        "skycube completions zsh > ~/.zfunc/_skycube",
        "skycube completions fish > ~/.config/fish/completions/skycube.fish",
    ]),
    ("man", &[
        "skycube man ~/.local/share/man/man1",
    ]),
];

/// The command line with its commands in groups, and with examples.
pub fn with_examples(mut command: Command) -> Command {
    let template = format!("{{about-with-newline}}\n{{usage-heading}} {{usage}}\n{}\n", groups(&command));
    for (name, examples) in EXAMPLES {
        // A program without a feature lacks its command.
        if command.find_subcommand(name).is_some() {
            command = command.mut_subcommand(name, |command| with_examples_of(command, examples));
        }
    }
    let heading = *command.get_styles().get_header();
    command.help_template(format!("{template}{heading}Options:{heading:#}\n{{options}}{{after-help}}"))
}

/// A command with its examples below its help.
fn with_examples_of(command: Command, examples: &[&str]) -> Command {
    let heading = *command.get_styles().get_header();
    let mut text = format!("{heading}Examples:{heading:#}");
    examples.iter().for_each(|example| text += &format!("\n  {example}"));
    if let Some(after) = command.get_after_help() {
        text += &format!("\n\n{after}");
    }
    command.after_help(text)
}

/// The groups as the help lists them.
fn groups(command: &Command) -> String {
    let (heading, literal) = (command.get_styles().get_header(), command.get_styles().get_literal());
    let mut text = String::new();
    for (title, names) in GROUPS {
        text += &format!("\n{heading}{title}:{heading:#}\n");
        for name in names {
            let about = match command.find_subcommand(name) {
                Some(command) => command.get_about().map(ToString::to_string).unwrap_or_default(),
                None if *name == "help" => "Print this message or the help of a command".to_owned(),
                None => continue,
            };
            text += &format!("  {literal}{name}{literal:#}{}  {about}\n", " ".repeat(11 - name.len()));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use clap::{CommandFactory, Parser};

    use super::*;
    use crate::commands::CommandLine;

    fn commands() -> Vec<String> {
        let command = CommandLine::command();
        command.get_subcommands().map(|command| command.get_name().to_owned()).collect()
    }

    #[test]
    fn every_command_has_its_place_and_examples() {
        let grouped: Vec<&str> = GROUPS.iter().flat_map(|(_, names)| *names).copied().collect();
        for name in commands() {
            assert_eq!(grouped.iter().filter(|grouped| **grouped == name).count(), 1, "{name}");
            assert_eq!(EXAMPLES.iter().filter(|(command, _)| *command == name).count(), 1, "{name}");
        }
    }

    /// The part of an example that is ours; `~` and `*` are for the shell.
    #[test]
    fn every_example_is_accepted() {
        for (name, example) in EXAMPLES.iter().flat_map(|(name, examples)| examples.iter().map(move |one| (name, one)))
        {
            let ours: Vec<&str> = example.split('|').filter(|part| part.trim().starts_with("skycube ")).collect();
            assert!(ours.iter().any(|part| part.contains(&format!("skycube {name}"))), "{example}");
            for part in ours {
                let words = part.split(" > ").next().unwrap().split_whitespace();
                CommandLine::try_parse_from(words).unwrap_or_else(|error| panic!("{example}: {error}"));
            }
        }
    }

    #[test]
    fn the_help_fits_into_80_columns() {
        let help = with_examples(CommandLine::command()).term_width(80).render_help().to_string();
        assert!(help.contains("Check a skybox:\n  check        ") && help.contains("\nOptions:\n"), "{help}");
        let longest = help.lines().max_by_key(|line| line.chars().count()).unwrap();
        assert!(longest.chars().count() <= 80, "{longest}");
        for name in commands() {
            assert!(help.contains(&format!("\n  {name} ")), "{name}: {help}");
        }
    }
}
