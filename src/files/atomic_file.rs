//! Atomic files: written whole or not at all.

use std::io::Write;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::error::{Error, Result};
use crate::standard_stream::{check_standard_output, is_standard_stream, write_to_standard_output};

/// Held while temporary files lie beside their targets.
static WRITING: Mutex<()> = Mutex::new(());

/// Calls `then` while nothing is being written: the place to end the process, which then leaves no temporary file.
pub fn between_writes<T>(then: impl FnOnce() -> T) -> T {
    let _guard = lock();
    then()
}

/// A thread that panicked while it wrote left nothing behind that the next one must know of.
fn lock() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Writes a file in one step: the bytes go to a temporary file beside the target, which then takes its name. At
/// every moment the target is the whole old file or the whole new one. The permissions are those of any new file (`umask`).
/// `-` is standard output.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<()> {
    if is_standard_stream(path) {
        return write_to_standard_output(bytes);
    }
    write_together([(path, bytes)])
}

/// Writes files that belong together: all of them lie beside their targets, whole, before the first takes its name. A full
/// disk leaves none of them.
pub fn write_together<'a>(files: impl IntoIterator<Item = (&'a Path, &'a [u8])>) -> Result<()> {
    let _guard = lock();
    let mut ready = Vec::new();
    for (path, bytes) in files {
        check_target(path)?;
        ready.push((path, temporary_beside(path, bytes).map_err(|error| cannot_write(path, &error))?));
    }
    for (path, file) in ready {
        file.persist(path).map_err(|error| cannot_write(path, &error.error))?;
    }
    Ok(())
}

/// An error if a file cannot be written at `path`: its folder is missing, or something else has that name. Worth asking
/// before hours of rendering.
pub fn check_target(path: &Path) -> Result<()> {
    if is_standard_stream(path) {
        return check_standard_output();
    }
    let folder = folder_of(path);
    if !folder.is_dir() {
        let problem = format!("cannot write: the folder {} does not exist", folder.display());
        return Err(Error::new(problem).in_file(path).help("create it, or choose another place"));
    }
    match std::fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(Error::new("cannot write: this is a folder").in_file(path)),
        Ok(found) if !found.is_file() => Err(Error::new("cannot write: this is not a plain file").in_file(path)),
        _ => Ok(()),
    }
}

/// An error if `folder` cannot be a folder: something else has that name.
pub fn check_folder_target(folder: &Path) -> Result<()> {
    match std::fs::metadata(folder) {
        Ok(found) if !found.is_dir() => {
            Err(Error::new("this is a file").in_file(folder).expected("a folder, or an unused name"))
        }
        _ => Ok(()),
    }
}

/// Makes a folder and those it lies in, unless it is there.
pub fn make_folder(folder: &Path) -> Result<()> {
    check_folder_target(folder)?;
    std::fs::create_dir_all(folder)
        .map_err(|error| Error::new(format!("cannot make the folder: {error}")).in_file(folder))
}

/// The folder that a path lies in; `.` for a bare name.
pub fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// As [`write_atomically`], but a file that is there stays as it is: then nothing is written, and false is given back.
pub fn write_if_absent(path: &Path, bytes: &[u8]) -> Result<bool> {
    let _guard = lock();
    let file = temporary_beside(path, bytes).map_err(|error| cannot_write(path, &error))?;
    match file.persist_noclobber(path) {
        Ok(_) => Ok(true),
        Err(error) if error.error.kind() == std::io::ErrorKind::AlreadyExists => Ok(false),
        Err(error) => Err(cannot_write(path, &error.error)),
    }
}

fn cannot_write(path: &Path, error: &std::io::Error) -> Error {
    Error::new(format!("cannot write: {error}")).in_file(path)
}

/// A temporary file in the same folder, which is gone unless it is kept.
fn temporary_beside(path: &Path, bytes: &[u8]) -> std::io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".skycube-").suffix(".partial");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // The system takes the bits of the umask away from these.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    // Errors of the crate name the temporary file, which says nothing to the user.
    let mut file = builder.tempfile_in(folder_of(path)).map_err(|error| std::io::Error::from(error.kind()))?;
    file.as_file_mut().write_all(bytes)?;
    // The name must not lead to a file whose content is still on its way when the power fails.
    file.as_file().sync_data()?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replaces_the_target_and_leaves_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("picture.png");
        write_atomically(&path, b"old").unwrap();
        write_atomically(&path, b"new").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"new");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn between_writes_no_temporary_file_lies_beside_a_target() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("picture.png");
        std::thread::scope(|scope| {
            let writer = scope.spawn(|| (0..300).for_each(|_| write_atomically(&path, &[7; 100_000]).unwrap()));
            while !writer.is_finished() {
                let files = between_writes(|| std::fs::read_dir(folder.path()).unwrap().count());
                assert!(files <= 1, "{files}");
            }
        });
    }

    #[test]
    fn of_files_that_belong_together_all_are_written_or_none() {
        let folder = tempfile::tempdir().unwrap();
        let [one, two, missing] = ["one", "two", "missing/three"].map(|name| folder.path().join(name));
        let bytes = &b"x"[..];
        assert!(write_together([(one.as_path(), bytes), (missing.as_path(), bytes)]).is_err());
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
        write_together([(one.as_path(), bytes), (two.as_path(), bytes)]).unwrap();
        assert!(one.is_file() && two.is_file());
    }

    #[cfg(unix)]
    #[test]
    fn has_the_permissions_of_any_new_file() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (ours, plain) = (folder.path().join("ours"), folder.path().join("plain"));
        write_atomically(&ours, b"x").unwrap();
        std::fs::write(&plain, b"x").unwrap();
        let mode = |path: &Path| std::fs::metadata(path).unwrap().permissions().mode();
        assert_eq!(mode(&ours), mode(&plain));
    }

    #[test]
    fn a_missing_folder_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let error = write_atomically(&folder.path().join("missing/picture.png"), b"x").unwrap_err();
        assert!(error.problem().contains("missing does not exist"), "{error}");
        let error = write_atomically(folder.path(), b"x").unwrap_err();
        assert!(error.problem().contains("this is a folder"), "{error}");
        let file = folder.path().join("file");
        std::fs::write(&file, b"x").unwrap();
        assert!(check_folder_target(&file).is_err());
        assert!(check_folder_target(folder.path()).is_ok() && check_folder_target(&folder.path().join("new")).is_ok());
    }
}
