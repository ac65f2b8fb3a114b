//! Code made once for all that ask for the same.
//!
//! What is asked for is compared in full: a hash only says where to look. Code is kept as long as somebody
//! uses it, and not longer.

use std::hash::{Hash, Hasher};
use std::ops::Deref;
use std::sync::{Arc, Mutex, PoisonError, Weak};

use rustc_hash::{FxHashMap, FxHasher};

/// What was made for a key, shared by all that ask for an equal one.
#[derive(Debug)]
pub struct Shared<K, C> {
    key: K,
    made: C,
}

impl<K, C> Deref for Shared<K, C> {
    type Target = C;

    fn deref(&self) -> &C {
        &self.made
    }
}

/// What is in use, by the hashes of keys.
type InUse<K, C> = FxHashMap<u64, Vec<Weak<Shared<K, C>>>>;

/// All that is in use.
#[derive(Debug)]
pub struct Pool<K, C> {
    in_use: Mutex<InUse<K, C>>,
}

impl<K: Eq + Hash, C> Pool<K, C> {
    /// Nothing yet.
    pub const fn new() -> Self {
        Self { in_use: Mutex::new(FxHashMap::with_hasher(rustc_hash::FxBuildHasher)) }
    }

    /// What is there for an equal key, or else what `make` makes. Others are not kept waiting
    /// meanwhile; where two make the same at once, both get what was there first.
    ///
    /// # Errors
    /// It could not be made; nothing is kept then.
    pub fn get_or_make<E>(
        &self,
        key: K,
        make: impl FnOnce(&K) -> Result<C, E>,
    ) -> Result<Arc<Shared<K, C>>, E> {
        let hash = hash(&key);
        if let Some(known) = self.find(hash, &key) {
            return Ok(known);
        }
        let made = make(&key)?;
        let shared = Arc::new(Shared { key, made });
        let mut in_use = self.in_use.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = find(&in_use, hash, &shared.key) {
            return Ok(known);
        }
        // Those that are gone leave a weak pointer each, until something new is made.
        in_use.retain(|_, all| {
            all.retain(|one| one.strong_count() > 0);
            !all.is_empty()
        });
        in_use.entry(hash).or_default().push(Arc::downgrade(&shared));
        Ok(shared)
    }

    fn find(&self, hash: u64, key: &K) -> Option<Arc<Shared<K, C>>> {
        find(&self.in_use.lock().unwrap_or_else(PoisonError::into_inner), hash, key)
    }
}

fn find<K: Eq, C>(in_use: &InUse<K, C>, hash: u64, key: &K) -> Option<Arc<Shared<K, C>>> {
    in_use.get(&hash)?.iter().filter_map(Weak::upgrade).find(|one| one.key == *key)
}

fn hash(key: &impl Hash) -> u64 {
    let mut hasher = FxHasher::default();
    key.hash(&mut hasher);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    /// A key whose hash says nothing.
    #[derive(Debug, PartialEq, Eq)]
    struct Key(u32);

    impl Hash for Key {
        fn hash<H: Hasher>(&self, state: &mut H) {
            state.write_u8(0);
        }
    }

    #[test]
    fn equal_keys_share_what_is_made_once_and_others_do_not() {
        let pool = Pool::new();
        let made = Cell::new(0);
        let get = |key| {
            let make = |key: &Key| {
                made.set(made.get() + 1);
                Ok::<_, ()>(key.0 * 10)
            };
            pool.get_or_make(Key(key), make).unwrap()
        };
        let (one, two, again) = (get(1), get(2), get(1));
        assert_eq!((**one, **two, made.get()), (10, 20, 2));
        assert!(Arc::ptr_eq(&one, &again));
        drop((one, again));
        get(3);
        assert_eq!(made.get(), 3);
        // The last user of 1 is gone, and 1 with him; 2 is there still.
        assert_eq!((**get(1), **get(2), made.get()), (10, 20, 4));
    }

    #[test]
    fn what_cannot_be_made_is_tried_again_and_nothing_piles_up() {
        let pool = Pool::new();
        assert_eq!(
            pool.get_or_make(Key(1), |_| Err::<u32, _>("not today")).unwrap_err(),
            "not today"
        );
        for key in 0..100 {
            drop(pool.get_or_make(Key(key), |_| Ok::<_, ()>(key)));
        }
        let in_use = pool.in_use.lock().unwrap();
        assert_eq!(in_use.values().map(Vec::len).sum::<usize>(), 1);
    }
}
