//! The output of `skycube lessons`.

use std::path::Path;

use crate::lessons::{Language, Lesson, Started};

/// All lessons, a line each: number, title, what it needs.
pub fn lesson_list(lessons: &[Lesson], language: Language) -> String {
    let titles = lessons.iter().map(|lesson| lesson.title.in_language(language));
    let width = titles.map(|title| title.chars().count()).max().unwrap_or(0);
    let needs = language.choose("needs", "potřebuje");
    let line = |lesson: &Lesson| {
        let [title, what] = [&lesson.title, &lesson.needs].map(|text| text.in_language(language));
        format!("{:02}  {title:width$}  {needs}: {what}\n", lesson.number)
    };
    let lines: String = lessons.iter().map(line).collect();
    let hint = language.choose(
        "skycube lessons NN shows a lesson, skycube lessons start NN copies its scenes into a folder",
        "skycube lessons NN ukáže lekci, skycube lessons start NN zkopíruje její scény do složky",
    );
    format!("{lines}\n{hint}\n")
}

/// One lesson: goal, what it needs, commands.
pub fn lesson_page(lesson: &Lesson, language: Language) -> String {
    let (number, name, readme) = (lesson.number, lesson.name(), language.readme());
    let [goal, needs] = language.choose(["goal", "needs"], ["cíl", "potřebuje"]);
    let hint = language.choose(
        format!(
            "`skycube lessons start {number}` copies the lesson into the folder {name}. There, read {readme} and run"
        ),
        format!(
            "`skycube lessons start {number}` zkopíruje lekci do složky {name}. Tam si přečtěte {readme} a spusťte"
        ),
    );
    let lines: String = lesson.commands.iter().map(|command| format!("    {command}\n")).collect();
    format!(
        "{number:02} {}\n\n{goal}: {}\n{needs}: {}\n\n{hint}\n{lines}",
        lesson.title.in_language(language),
        lesson.goal.in_language(language),
        lesson.needs.in_language(language),
    )
}

/// What was copied, and what to do next.
pub fn lesson_started(lesson: &Lesson, started: &[Started], folder: &Path, language: Language) -> String {
    let already = language.choose("already there:", "už tam je:");
    let line = |Started { file, was_there }: &Started| {
        format!("{} {}\n", if *was_there { already } else { "wrote" }, file.display())
    };
    let lines: String = started.iter().map(line).collect();
    let folder = folder.display();
    let readme = language.readme();
    let hint = language.choose(
        format!("next: cd {folder}, read {readme}, and run"),
        format!("dál: cd {folder}, přečtěte si {readme} a spusťte"),
    );
    let first = lesson.commands.first().map_or("skycube help", String::as_str);
    format!("{lines}\n{hint}\n    {first}\n")
}
