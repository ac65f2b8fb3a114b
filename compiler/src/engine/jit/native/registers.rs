//! Which words are in registers, and where the others are.
//!
//! One pass forward: a word is put into a register when an instruction makes it or cannot do without,
//! and leaves it for the word of the instruction at hand if its next use is farthest (Belady, "A study
//! of replacement algorithms for a virtual-storage computer", 1966). Words that are in memory anyway
//! (uniforms, slots, constants, results stored already) leave for nothing and are read from there.

use super::assembler::{Assembler, Base, Form, Operand, Ymm};
use super::constants::Constants;
use crate::ops::OpId;
use crate::storage::Lanes;

/// Bytes of a word of a block.
const ROW: i32 = size_of::<Lanes>() as i32;

/// Where a word lies in memory, by rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Home {
    /// A uniform word.
    Uniform(u32),
    /// A slot of the block.
    Slot(u32),
    /// A constant.
    Constant(u32),
    /// A row for words that found no register.
    Spilled(u32),
}

impl Home {
    /// Its address.
    pub fn place(self) -> (Base, i32) {
        match self {
            Self::Uniform(row) => (Base::Rdi, row as i32 * ROW),
            Self::Slot(row) => (Base::Rsi, row as i32 * ROW),
            Self::Constant(row) => (Base::Rdx, row as i32 * ROW),
            Self::Spilled(row) => (Base::Rcx, row as i32 * ROW),
        }
    }

    fn operand(self) -> Operand {
        let (base, offset) = self.place();
        Operand::Memory(base, offset)
    }
}

/// A word of the segment.
#[derive(Clone, Copy, Debug, Default)]
struct Word {
    register: Option<Ymm>,
    home: Option<Home>,
    /// Its uses to come, among all uses.
    next: usize,
    end: usize,
}

/// The words of a segment while its instructions are written.
pub struct Registers<'a> {
    /// Where the instructions go.
    pub assembler: &'a mut Assembler,
    /// The constants of the program.
    pub constants: &'a mut Constants,
    words: Vec<Word>,
    uses: Vec<usize>,
    /// What each register holds.
    holds: [Option<OpId>; 16],
    /// One bit a register: those that hold nothing, and those the instruction at hand needs.
    free: u16,
    pinned: u16,
    /// Rows of spilled words: free ones, those that the instruction at hand gives back, and their number.
    rows: Vec<u32>,
    left: Vec<u32>,
    count: u32,
}

impl<'a> Registers<'a> {
    /// Nothing is in the `count` registers; word `id` is used at positions `uses[id]`, which rise.
    pub fn new(
        assembler: &'a mut Assembler,
        constants: &'a mut Constants,
        uses: Uses,
        count: u32,
    ) -> Self {
        let Uses { starts, positions } = uses;
        let word = |window: &[usize]| Word { next: window[0], end: window[1], ..Word::default() };
        Self {
            assembler,
            constants,
            words: starts.windows(2).map(word).collect(),
            uses: positions,
            holds: [None; 16],
            free: ((1u32 << count) - 1) as u16,
            pinned: 0,
            rows: Vec::new(),
            left: Vec::new(),
            count: 0,
        }
    }

    /// Rows of spilled words that are needed.
    pub fn rows(&self) -> usize {
        self.count as usize
    }

    /// Says where a word lies in memory.
    pub fn settle(&mut self, id: OpId, home: Home) {
        self.words[id as usize].home = Some(home);
    }

    /// Where a word lies in memory, if it does.
    pub fn home(&self, id: OpId) -> Option<Home> {
        self.words[id as usize].home
    }

    /// Whether a word is in a register.
    pub fn has_register(&self, id: OpId) -> bool {
        self.words[id as usize].register.is_some()
    }

    /// Whether nothing after `position` uses the word.
    pub fn dies(&self, id: OpId, position: usize) -> bool {
        let Word { next, end, .. } = self.words[id as usize];
        next == end || self.uses[end - 1] <= position
    }

    /// The word where it is: in its register, or in memory.
    pub fn operand(&mut self, id: OpId) -> Operand {
        let Word { register, home, .. } = self.words[id as usize];
        match (register, home) {
            (Some(register), _) => {
                self.pinned |= 1 << register.0;
                register.into()
            }
            (None, Some(home)) => home.operand(),
            (None, None) => unreachable!("a word is used that was neither made nor kept"),
        }
    }

    /// The word in a register, where it stays to the end of the instruction.
    pub fn register(&mut self, id: OpId) -> Ymm {
        match self.operand(id) {
            Operand::Register(register) => register,
            memory @ Operand::Memory(..) => {
                let register = self.temporary();
                self.assembler.unary(Form::MOVE, register, memory);
                self.hold(register, id);
                register
            }
        }
    }

    /// A register for the instruction at hand that holds no word; whoever is in it leaves.
    pub fn temporary(&mut self) -> Ymm {
        let register = match self.free {
            0 => self.evict(),
            free => Ymm(free.trailing_zeros() as u8),
        };
        self.free &= !(1 << register.0);
        self.pinned |= 1 << register.0;
        register
    }

    /// Says that these words were used at `position`. Registers of those that nothing uses any more are
    /// free, also for the result of the same instruction.
    pub fn used(&mut self, ids: &[OpId], position: usize) {
        for &id in ids {
            let word = &mut self.words[id as usize];
            while word.next < word.end && self.uses[word.next] <= position {
                word.next += 1;
            }
            if word.next < word.end {
                continue;
            }
            if let Some(register) = word.register.take() {
                self.release(register);
            }
            // A row is given back only after the instruction, which may read it.
            if let Some(Home::Spilled(row)) = self.words[id as usize].home.take() {
                self.left.push(row);
            }
        }
    }

    /// A register for the word of `id`.
    pub fn result(&mut self, id: OpId) -> Ymm {
        let register = self.temporary();
        self.hold(register, id);
        register
    }

    /// Says that the register holds the word of `id` from now on, whatever it held.
    pub fn hold(&mut self, register: Ymm, id: OpId) {
        self.free &= !(1 << register.0);
        self.pinned |= 1 << register.0;
        self.holds[register.0 as usize] = Some(id);
        self.words[id as usize].register = Some(register);
    }

    /// Gives a temporary register back.
    pub fn release(&mut self, register: Ymm) {
        self.holds[register.0 as usize] = None;
        self.free |= 1 << register.0;
    }

    /// Ends an instruction: no register is pinned, and what it gave back is free.
    pub fn end(&mut self) {
        self.pinned = 0;
        self.rows.append(&mut self.left);
    }

    /// Writes a word that is in a register to a row of its own, which is its home from now on.
    pub fn spill(&mut self, id: OpId) {
        let Some(register) = self.words[id as usize].register else { return };
        let row = self.rows.pop().unwrap_or_else(|| {
            self.count += 1;
            self.count - 1
        });
        let home = Home::Spilled(row);
        let (base, offset) = home.place();
        self.assembler.store(base, offset, register);
        self.settle(id, home);
    }

    /// Takes a register from the word that is used latest; one that is in memory already counts as if its
    /// use were four times as far away, for it costs no store.
    fn evict(&mut self) -> Ymm {
        let here = self.holds.iter().flatten().map(|&id| self.next_use(id)).min().unwrap_or(0);
        let mut farthest = None;
        for register in 0..16u8 {
            let Some(id) = self.holds[register as usize] else { continue };
            if self.pinned & 1 << register != 0 {
                continue;
            }
            let away = self.next_use(id) - here + 1;
            let weight = if self.words[id as usize].home.is_some() { 4 } else { 1 };
            if farthest.is_none_or(|(most, _)| away * weight > most) {
                farthest = Some((away * weight, (Ymm(register), id)));
            }
        }
        let Some((_, (register, id))) = farthest else {
            unreachable!("an instruction needs fewer registers than there are")
        };
        if self.words[id as usize].home.is_none() {
            self.spill(id);
        }
        self.words[id as usize].register = None;
        self.release(register);
        register
    }

    fn next_use(&self, id: OpId) -> usize {
        let Word { next, end, .. } = self.words[id as usize];
        if next < end { self.uses[next] } else { usize::MAX >> 4 }
    }
}

/// Where each word of a segment is used, word after word.
#[derive(Debug, Default)]
pub struct Uses {
    /// Where the uses of each word start; one more than there are words.
    starts: Vec<usize>,
    positions: Vec<usize>,
}

impl Uses {
    /// From calls of `each` with every use, position by position; it is called twice.
    pub fn of(words: usize, each: impl Fn(&mut dyn FnMut(OpId, usize))) -> Self {
        let mut starts = vec![0; words + 1];
        each(&mut |id, _| starts[id as usize + 1] += 1);
        for word in 0..words {
            starts[word + 1] += starts[word];
        }
        let mut positions = vec![0; starts[words]];
        let mut filled = starts.clone();
        each(&mut |id, position| {
            positions[filled[id as usize]] = position;
            filled[id as usize] += 1;
        });
        Self { starts, positions }
    }
}
