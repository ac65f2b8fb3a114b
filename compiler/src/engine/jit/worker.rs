//! The thread that compiles in the background: one for the process, however many shaders wait.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, PoisonError};

type Job = Box<dyn FnOnce() + Send>;

static QUEUE: Mutex<Option<Sender<Job>>> = Mutex::new(None);

/// Runs `job` after those before it. Where the system grants no thread it is dropped.
pub fn enqueue(job: impl FnOnce() + Send + 'static) {
    let mut queue = QUEUE.lock().unwrap_or_else(PoisonError::into_inner);
    let refused = match &*queue {
        Some(worker) => worker.send(Box::new(job)).err().map(|refused| refused.0),
        None => Some(Box::new(job) as Job),
    };
    if let Some(job) = refused {
        *queue = start().filter(|worker| worker.send(job).is_ok());
    }
}

fn start() -> Option<Sender<Job>> {
    let (sender, jobs): (_, Receiver<Job>) = channel();
    // A job that panics is lost alone: a job shares nothing with the next that it could leave half done.
    let work = move || jobs.into_iter().for_each(|job| drop(catch_unwind(AssertUnwindSafe(job))));
    std::thread::Builder::new().name("jit".to_owned()).spawn(work).ok().map(|_| sender)
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc::channel;
    use std::thread;

    use super::enqueue;

    #[test]
    fn jobs_run_in_order_on_one_thread_and_a_panic_stops_none_after_it() {
        let (sender, ran) = channel();
        for number in 0..64 {
            let sender = sender.clone();
            enqueue(move || sender.send((number, thread::current().id())).unwrap());
        }
        let seen: Vec<_> = ran.iter().take(64).collect();
        assert!(seen.iter().enumerate().all(|(at, (number, _))| at == *number));
        assert!(seen.iter().all(|(_, thread)| *thread == seen[0].1));

        enqueue(|| panic!("a job that fails, on purpose"));
        enqueue(move || sender.send((64, thread::current().id())).unwrap());
        assert_eq!(ran.recv(), Ok((64, seen[0].1)));
    }
}
