//! The journal of finished files of an archive: append-only shards, whose records have checksums.
//!
//! Each shard is written by one worker, each record with one write call, so that a killed process loses only the
//! files in progress. A power failure may also lose data that the system has not yet written to the disk, so shards
//! are synced every few seconds. What remains is complete records and perhaps an incomplete one or zeros at the end,
//! which are not read. A later run writes new shards next to the old ones, and so does a concurrent run: each reads
//! the shards that it has opened, and removes them at the end. The folder is removed when the table is complete and
//! no other run has a shard in it.
//!
//! A record is the length of its payload and the payload's CRC-32 (four bytes each, little-endian), then the payload.
//! Records can be in any order, so the payload contains the name of its file.

use std::collections::HashMap;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use chordal_export::OutputFormat;
use chordal_export::columns::ColumnFile;
use chordal_files::FileDraft;

use crate::columns::ArchiveColumns;
use crate::error::ArchiveError;
use crate::row::FileRecord;

/// The limit for the length of a record, bytes: a longer one means a damaged or foreign file.
const MAX_RECORD_BYTES: u32 = 1 << 30;

/// How often a shard is synced to the disk: the work that a power failure can lose.
const SYNCED_EVERY: Duration = Duration::from_secs(5);

/// The location of a record.
#[derive(Clone, Copy, Debug)]
struct RecordLocation {
    shard: u32,
    offset: u64,
    /// The first 64 bits of the record's key: enough to detect that the inputs have changed.
    key: u64,
}

/// The journal of one table.
#[derive(Debug)]
pub struct TableJournal {
    out: PathBuf,
    folder: PathBuf,
    /// The names of the files in the order of the table.
    names: Vec<String>,
    places: Mutex<Vec<Option<RecordLocation>>>,
    next_shard: Mutex<u32>,
    /// The shards that this run knows, open for reading, because another run may delete the files.
    readers: Mutex<HashMap<u32, File>>,
}

/// A shard that a worker writes.
#[derive(Debug)]
pub struct JournalShard {
    file: File,
    path: PathBuf,
    number: u32,
    offset: u64,
    synced: Instant,
}

impl JournalShard {
    /// Appends a record; returns its offset.
    fn append(&mut self, bytes: &[u8]) -> io::Result<u64> {
        let place = self.offset;
        if let Err(error) = self.file.write_all(bytes) {
            // Later records must follow the last complete record.
            self.file.set_len(place)?;
            self.file.seek(SeekFrom::Start(place))?;
            return Err(error);
        }
        self.offset += bytes.len() as u64;
        if self.synced.elapsed() >= SYNCED_EVERY {
            self.file.sync_data()?;
            self.synced = Instant::now();
        }
        Ok(place)
    }
}

/// Serializes a record, also for workers on other computers.
pub fn record_of(name: &str, record: &FileRecord) -> Vec<u8> {
    // The record has only texts and numbers, so serialization cannot fail.
    let payload = postcard::to_stdvec(&(name, record)).unwrap_or_default();
    let mut bytes = Vec::with_capacity(payload.len() + 8);
    bytes.extend_from_slice(&(payload.len() as u32).to_le_bytes());
    bytes.extend_from_slice(&crc32fast::hash(&payload).to_le_bytes());
    bytes.extend_from_slice(&payload);
    bytes
}

impl TableJournal {
    /// The folder of the journal, next to the table `out`.
    pub fn folder_of(out: &Path) -> PathBuf {
        let mut name = out.file_name().map_or_else(OsString::new, OsString::from);
        name.push(".journal");
        out.with_file_name(name)
    }

    /// Opens the journal of a table, with the records of earlier runs. `names` are the files of the archive in the
    /// order of the table; records of other files are ignored.
    ///
    /// # Errors The folder cannot be created or read.
    pub fn open(out: &Path, names: Vec<String>) -> Result<TableJournal, ArchiveError> {
        let folder = TableJournal::folder_of(out);
        fs::create_dir_all(&folder).map_err(ArchiveError::write(&folder))?;
        let mut shards = shards(&folder).map_err(ArchiveError::write(&folder))?;
        shards.sort_unstable();
        let next = shards.last().map_or(0, |last| last + 1);
        let mut places = vec![None; names.len()];
        let order: HashMap<&str, usize> =
            names.iter().enumerate().map(|(index, name)| (name.as_str(), index)).collect();
        let mut readers = HashMap::new();
        for shard in shards {
            // A shard that cannot be read is ignored: its files are checked again.
            let Ok(file) = File::open(shard_path(&folder, shard)) else { continue };
            let _ = each_record(&file, |offset, name, record| {
                if let Some(index) = order.get(name) {
                    places[*index] =
                        Some(RecordLocation { shard, offset, key: short(&record.key) });
                }
            });
            readers.insert(shard, file);
        }
        drop(order);
        Ok(TableJournal {
            out: out.to_path_buf(),
            folder,
            names,
            places: Mutex::new(places),
            next_shard: Mutex::new(next),
            readers: Mutex::new(readers),
        })
    }

    /// The files of the archive, in order.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The number of files with a record.
    pub fn done(&self) -> usize {
        self.places().iter().flatten().count()
    }

    /// The first 16 hexadecimal digits of the key of a file's record; `None` without a record.
    pub fn key(&self, index: usize) -> Option<String> {
        let place = self.places().get(index).copied().flatten();
        place.map(|place| format!("{:016x}", place.key))
    }

    /// Whether a file has a record with this key.
    pub fn has_key(&self, index: usize, key: &str) -> bool {
        self.places()[index].is_some_and(|place| place.key == short(key))
    }

    /// Creates a new shard for a worker.
    ///
    /// # Errors The file cannot be created.
    pub fn shard(&self) -> Result<JournalShard, ArchiveError> {
        let mut next = self.next_shard.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        loop {
            let number = *next;
            *next += 1;
            let path = shard_path(&self.folder, number);
            let made = OpenOptions::new().write(true).create_new(true).open(&path);
            match made {
                Ok(file) => {
                    let reader = File::open(&path).map_err(ArchiveError::write(&path))?;
                    self.readers().insert(number, reader);
                    return Ok(JournalShard {
                        file,
                        path,
                        number,
                        offset: 0,
                        synced: Instant::now(),
                    });
                }
                // A concurrent run for the same table has used this number, or has just removed the folder.
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) if error.kind() == io::ErrorKind::NotFound => {
                    fs::create_dir_all(&self.folder).map_err(ArchiveError::write(&self.folder))?;
                }
                Err(error) => return Err(ArchiveError::write(&path)(error)),
            }
        }
    }

    /// Writes the record of a file. It is rejected unless it is complete and names this file.
    ///
    /// # Errors The disk cannot be written, or the record is invalid.
    pub fn put(
        &self,
        shard: &mut JournalShard,
        index: usize,
        bytes: &[u8],
    ) -> Result<(), ArchiveError> {
        let Some(name) = self.names.get(index) else {
            return Err(self.missing(index));
        };
        let key = match whole(bytes) {
            Some((own, record)) if own == *name => short(&record.key),
            _ => return Err(self.missing(index)),
        };
        let offset = shard.append(bytes).map_err(ArchiveError::write(&shard.path))?;
        self.places()[index] = Some(RecordLocation { shard: shard.number, offset, key });
        Ok(())
    }

    /// Writes all records into the table, in order, moves it to its final path, and removes the journal. `see` is
    /// called with each record.
    ///
    /// # Errors A file has no record, or the disk cannot be written.
    pub fn finish(self, see: impl FnMut(&str, &FileRecord)) -> Result<(), ArchiveError> {
        self.write_table(see)?;
        for number in self.readers().keys() {
            // Fails when another run has already removed this shard.
            let _ = fs::remove_file(shard_path(&self.folder, *number));
        }
        match shards(&self.folder) {
            Ok(others) if !others.is_empty() => Ok(()),
            _ => match fs::remove_dir_all(&self.folder) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    Err(ArchiveError::write(&self.folder)(error))
                }
                _ => Ok(()),
            },
        }
    }

    fn write_table(&self, mut see: impl FnMut(&str, &FileRecord)) -> Result<(), ArchiveError> {
        let failed = ArchiveError::write(&self.out);
        let draft = FileDraft::open(&self.out).map_err(&failed)?;
        let columns = ArchiveColumns::new();
        let table = ColumnFile::new(draft, OutputFormat::Parquet, columns);
        let mut table = table.map_err(&failed)?;
        let mut readers = self.readers();
        let places = self.places();
        for (index, name) in self.names.iter().enumerate() {
            let place = places[index].ok_or_else(|| self.missing(index))?;
            let record = self.read(&mut readers, place).map_err(|_| self.missing(index))?;
            let (own, record) = record.ok_or_else(|| self.missing(index))?;
            if own != *name {
                return Err(self.missing(index));
            }
            see(name, &record);
            for row in &record.rows {
                let put = table.put(|columns| columns.push(name, &record, row));
                put.map_err(&failed)?;
            }
        }
        let mut draft = table.finish().map_err(&failed)?;
        draft.flush().map_err(&failed)?;
        if !chordal_files::is_regular(&self.out) {
            return draft.put().map_err(&failed);
        }
        draft.file().sync_all().map_err(&failed)?;
        draft.put().map_err(&failed)?;
        sync_folder_of(&self.out).map_err(&failed)
    }

    fn read(
        &self,
        readers: &mut HashMap<u32, File>,
        place: RecordLocation,
    ) -> io::Result<Option<(String, FileRecord)>> {
        let Some(file) = readers.get_mut(&place.shard) else { return Ok(None) };
        file.seek(SeekFrom::Start(place.offset))?;
        let mut bytes = vec![0; 8];
        file.read_exact(&mut bytes)?;
        let length = u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
        if length >= MAX_RECORD_BYTES {
            return Ok(None);
        }
        bytes.resize(8 + length as usize, 0);
        file.read_exact(&mut bytes[8..])?;
        Ok(whole(&bytes))
    }

    fn places(&self) -> std::sync::MutexGuard<'_, Vec<Option<RecordLocation>>> {
        self.places.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    fn readers(&self) -> std::sync::MutexGuard<'_, HashMap<u32, File>> {
        self.readers.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    fn missing(&self, index: usize) -> ArchiveError {
        let file = self.names.get(index).cloned().unwrap_or_default();
        ArchiveError::Journal { path: self.folder.clone(), file }
    }
}

/// The first 64 bits of a key.
fn short(key: &str) -> u64 {
    key.get(..16).and_then(|digits| u64::from_str_radix(digits, 16).ok()).unwrap_or(0)
}

fn shard_path(folder: &Path, number: u32) -> PathBuf {
    folder.join(format!("shard-{number:06}"))
}

/// The numbers of the shards of a folder.
fn shards(folder: &Path) -> io::Result<Vec<u32>> {
    let mut numbers = Vec::new();
    for entry in fs::read_dir(folder)? {
        let name = entry?.file_name();
        let number =
            name.to_str().and_then(|name| name.strip_prefix("shard-")?.parse::<u32>().ok());
        numbers.extend(number);
    }
    Ok(numbers)
}

/// Syncs the folder of a file, so that the journal is removed only after the table's directory entry is on disk.
fn sync_folder_of(file: &Path) -> io::Result<()> {
    #[cfg(unix)]
    {
        let parent = file.parent().filter(|parent| !parent.as_os_str().is_empty());
        File::open(parent.unwrap_or(Path::new(".")))?.sync_all()?;
    }
    #[cfg(not(unix))]
    let _ = file;
    Ok(())
}

/// Decodes a record; `None` when its length, checksum or format is wrong.
fn whole(bytes: &[u8]) -> Option<(String, FileRecord)> {
    let (head, payload) = bytes.split_at_checked(8)?;
    let length = u32::from_le_bytes(head[..4].try_into().ok()?);
    let sum = u32::from_le_bytes(head[4..].try_into().ok()?);
    if length as usize != payload.len() || crc32fast::hash(payload) != sum {
        return None;
    }
    postcard::from_bytes(payload).ok()
}

/// Calls `take` with each record of a shard up to the first incomplete one.
fn each_record(file: &File, mut take: impl FnMut(u64, &str, &FileRecord)) -> io::Result<()> {
    let mut reader = BufReader::with_capacity(1 << 18, file);
    let mut offset = 0;
    let mut bytes = Vec::new();
    loop {
        let mut head = [0; 8];
        reader.read_exact(&mut head)?;
        let length = u32::from_le_bytes([head[0], head[1], head[2], head[3]]);
        if length >= MAX_RECORD_BYTES {
            return Ok(());
        }
        bytes.clear();
        bytes.extend_from_slice(&head);
        let read = reader.by_ref().take(u64::from(length)).read_to_end(&mut bytes)?;
        if read != length as usize {
            return Ok(());
        }
        let Some((name, record)) = whole(&bytes) else { return Ok(()) };
        take(offset, &name, &record);
        offset += bytes.len() as u64;
    }
}
