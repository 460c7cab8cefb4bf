//! Tiles of stock on threads.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::{Mutex, PoisonError};
use std::thread;

use chordal::stock::{JobResult, TileJob};

/// Cuts tiles on as many threads as there are processors; what is found is in the order of the tiles.
pub fn on_threads(tiles: Vec<TileJob<'_>>) -> Vec<JobResult> {
    let threads = thread::available_parallelism().map_or(1, NonZero::get).min(tiles.len());
    if threads <= 1 {
        return tiles.into_iter().map(TileJob::run).collect();
    }
    let queue = Mutex::new(tiles.into_iter().enumerate());
    let work = || {
        let mut found = Vec::new();
        loop {
            let next = queue.lock().unwrap_or_else(PoisonError::into_inner).next();
            let Some((number, tile)) = next else { return found };
            found.push((number, tile.run()));
        }
    };
    let mut found: Vec<(usize, JobResult)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let join = |worker: thread::ScopedJoinHandle<'_, _>| {
            worker.join().unwrap_or_else(|panic| resume_unwind(panic))
        };
        workers.into_iter().flat_map(join).collect()
    });
    found.sort_by_key(|(number, _)| *number);
    found.into_iter().map(|(_, found)| found).collect()
}
