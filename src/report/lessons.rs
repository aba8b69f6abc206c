//! The output of `skycube lessons`.

use std::path::Path;

use crate::lessons::{Language, Lesson, Started};

/// All lessons, a line each: number, title, what it needs.
pub fn lesson_list(lessons: &[Lesson], language: Language) -> String {
    let title = |lesson: &Lesson| lesson.title.in_language(language).to_owned();
    let width = lessons.iter().map(|lesson| title(lesson).chars().count()).max().unwrap_or(0);
    let needs = match language {
        Language::En => "needs",
        Language::Cs => "potřebuje",
    };
    let line = |lesson: &Lesson| {
        let title = title(lesson);
        let padding = " ".repeat(width - title.chars().count());
        format!("{:02}  {title}{padding}  {needs}: {}\n", lesson.number, lesson.needs.in_language(language))
    };
    let lines: String = lessons.iter().map(line).collect();
    let hint = match language {
        Language::En => "skycube lessons NN shows a lesson, skycube lessons start NN copies its scenes into a folder",
        Language::Cs => "skycube lessons NN ukáže lekci, skycube lessons start NN zkopíruje její scény do složky",
    };
    format!("{lines}\n{hint}\n")
}

/// One lesson: goal, what it needs, commands.
pub fn lesson_page(lesson: &Lesson, language: Language) -> String {
    let [goal, needs, text, commands] = match language {
        Language::En => ["goal", "needs", "read", "commands, in the folder that `skycube lessons start` makes"],
        Language::Cs => ["cíl", "potřebuje", "text", "příkazy, ve složce, kterou založí `skycube lessons start`"],
    };
    let lines: String = lesson.commands.iter().map(|command| format!("    {command}\n")).collect();
    format!(
        "{:02} {}\n\n{goal}: {}\n{needs}: {}\n{text}: {}\n\n{commands}:\n{lines}",
        lesson.number,
        lesson.title.in_language(language),
        lesson.goal.in_language(language),
        lesson.needs.in_language(language),
        lesson.readme(language).display()
    )
}

/// What was copied, and what to do next.
pub fn lesson_started(lesson: &Lesson, started: &[Started], folder: &Path, language: Language) -> String {
    let already = match language {
        Language::En => "already there:",
        Language::Cs => "už tam je:",
    };
    let line = |Started { file, was_there }: &Started| {
        format!("{} {}\n", if *was_there { already } else { "wrote" }, file.display())
    };
    let lines: String = started.iter().map(line).collect();
    let folder = folder.display();
    let readme = lesson.readme(language);
    let readme = readme.file_name().unwrap_or_default().display().to_string();
    let hint = match language {
        Language::En => format!("next: cd {folder}, read {readme}, and run"),
        Language::Cs => format!("dál: cd {folder}, přečtěte si {readme} a spusťte"),
    };
    let first = lesson.commands.first().map_or("skycube help", String::as_str);
    format!("{lines}\n{hint}\n    {first}\n")
}
