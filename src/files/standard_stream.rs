//! `-` in place of a file: standard input where one is read, standard output where one is written.

use std::io::{IsTerminal, Read, Write};
use std::path::Path;
use std::sync::OnceLock;

use crate::error::{Error, Result};

/// The most that is read from standard input: more is no picture, and a pipe may never end.
const MOST: u64 = 4 << 30;

/// True for `-`. A file of that name is `./-`.
pub fn is_standard_stream(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// All of standard input. It is read once, whoever asks how often.
pub fn standard_input() -> Result<&'static [u8]> {
    static INPUT: OnceLock<Result<Vec<u8>>> = OnceLock::new();
    INPUT.get_or_init(read).as_deref().map_err(Error::clone)
}

fn read() -> Result<Vec<u8>> {
    let stdin = std::io::stdin();
    if stdin.is_terminal() {
        return Err(Error::new("nothing is piped into the command").help("name a file in place of -"));
    }
    let mut bytes = Vec::new();
    let read = stdin.lock().take(MOST + 1).read_to_end(&mut bytes);
    read.map_err(|error| Error::new(format!("standard input cannot be read: {error}")))?;
    if bytes.is_empty() {
        return Err(Error::new("standard input is empty"));
    }
    if bytes.len() as u64 > MOST {
        return Err(Error::new(format!("standard input has more than {MOST} bytes")));
    }
    Ok(bytes)
}

/// An error if standard output is a terminal, where nobody wants the bytes of a picture.
pub(crate) fn check_standard_output() -> Result<()> {
    if std::io::stdout().is_terminal() {
        return Err(Error::new("a picture is not written to a terminal").help("redirect the output, or name a file"));
    }
    Ok(())
}

/// Writes a file to standard output. A reader that has gone is not an error.
pub(crate) fn write_to_standard_output(bytes: &[u8]) -> Result<()> {
    let mut stdout = std::io::stdout().lock();
    match stdout.write_all(bytes).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Error::new(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}
