//! JUnit XML, which CI servers show as tests: a case for each map, picture or set of shots.
//! <https://github.com/testmoapp/junitxml>

use html_escape::encode_double_quoted_attribute;

use super::super::html::harmless;
use super::{Examined, ReportedFinding};
use crate::validate::Level;

/// One suite with all cases. What could not be examined is an error, what was found to be wrong a failure.
pub(super) fn report(command: &str, examined: &[Examined]) -> String {
    let failed = |one: &&Examined| one.verdict == "failed";
    let failed_cases = examined.iter().filter(failed).count();
    let failures = examined.iter().filter(|one| !failed(one) && errors(one).next().is_some()).count();
    let counts = format!("tests=\"{}\" failures=\"{failures}\" errors=\"{failed_cases}\"", examined.len());
    let cases: String = examined.iter().map(|one| case(command, one)).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"skycube\" {counts}>\n  \
         <testsuite name=\"skycube {command}\" {counts}>\n{cases}  </testsuite>\n</testsuites>\n"
    )
}

/// What makes a case fail; a warning does not, as it leaves the exit code 0.
fn errors(one: &Examined) -> impl Iterator<Item = &ReportedFinding> {
    one.faults().filter(|fault| fault.level == Level::Error)
}

fn case(command: &str, one: &Examined) -> String {
    let head = format!("    <testcase classname=\"skycube.{command}\" name=\"{}\"", escaped(&one.name));
    let sentences: Vec<&str> = errors(one).map(|fault| fault.sentence.as_str()).collect();
    let Some(kind) = errors(one).next().map(|fault| fault.kind) else { return format!("{head}/>\n") };
    let element = if one.verdict == "failed" { "error" } else { "failure" };
    let (message, text) = (escaped(&one.said(sentences[0])), escaped(&sentences.join("\n")));
    format!("{head}>\n      <{element} type=\"{kind}\" message=\"{message}\">{text}</{element}>\n    </testcase>\n")
}

/// XML has no control characters, which names of files may hold.
fn escaped(text: &str) -> String {
    encode_double_quoted_attribute(&harmless(text)).into_owned()
}
