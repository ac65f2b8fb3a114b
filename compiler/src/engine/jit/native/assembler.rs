//! Instructions as bytes: the VEX forms of AVX, AVX2 and FMA over registers of 256 bits that the
//! generator needs, and the loop round them.
//!
//! Encodings are those of the Intel 64 and IA-32 Architectures Software Developer's Manual, volume 2.
//! A test reads every form back with a disassembler that others wrote.

/// One of the sixteen vector registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ymm(pub u8);

/// The registers that hold addresses. None of them needs a byte more than the others to be one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Base {
    /// Rows of spilled words.
    Rcx = 1,
    /// Rows of constants.
    Rdx = 2,
    /// The block.
    Rsi = 6,
    /// The uniform words.
    Rdi = 7,
}

/// Where the last operand of an instruction is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operand {
    /// In a register.
    Register(Ymm),
    /// In memory, so many bytes from a base.
    Memory(Base, i32),
}

impl From<Ymm> for Operand {
    fn from(register: Ymm) -> Self {
        Self::Register(register)
    }
}

/// The prefix byte an opcode stands for, as VEX spells it.
#[derive(Clone, Copy)]
enum Prefix {
    None = 0,
    X66 = 1,
    XF3 = 2,
}

/// The table an opcode stands in, as VEX spells it.
#[derive(Clone, Copy, PartialEq)]
enum Map {
    X0f = 1,
    X0f38 = 2,
    X0f3a = 3,
}

/// An instruction form: all that does not depend on its operands.
#[derive(Clone, Copy)]
pub struct Form(Prefix, Map, u8);

/// Declares the forms, and the list of them all.
macro_rules! forms {
    ($($name:ident $mnemonic:literal $prefix:ident $map:ident $opcode:literal;)+) => {
        impl Form {
            $(#[doc = $mnemonic] pub const $name: Self = Self(Prefix::$prefix, Map::$map, $opcode);)+
        }

        /// Every form with its mnemonic.
        #[cfg(test)]
        pub const FORMS: &[(Form, &str)] = &[$((Form::$name, $mnemonic),)+];
    };
}
forms! {
    MOVE "vmovaps" None X0f 0x28;
    ADD "vaddps" None X0f 0x58;
    SUB "vsubps" None X0f 0x5c;
    MUL "vmulps" None X0f 0x59;
    DIV "vdivps" None X0f 0x5e;
    MIN "vminps" None X0f 0x5d;
    MAX "vmaxps" None X0f 0x5f;
    SQRT "vsqrtps" None X0f 0x51;
    AND "vandps" None X0f 0x54;
    AND_NOT "vandnps" None X0f 0x55;
    OR "vorps" None X0f 0x56;
    XOR "vxorps" None X0f 0x57;
    COMPARE "vcmpps" None X0f 0xc2;
    TO_REAL "vcvtdq2ps" None X0f 0x5b;
    TO_INT "vcvttps2dq" XF3 X0f 0x5b;
    ROUND "vroundps" X66 X0f3a 0x08;
    BLEND "vblendvps" X66 X0f3a 0x4a;
    INT_ADD "vpaddd" X66 X0f 0xfe;
    INT_SUB "vpsubd" X66 X0f 0xfa;
    INT_MUL "vpmulld" X66 X0f38 0x40;
    INT_EQUAL "vpcmpeqd" X66 X0f 0x76;
    INT_GREATER "vpcmpgtd" X66 X0f 0x66;
    INT_MIN "vpminsd" X66 X0f38 0x39;
    INT_MAX "vpmaxsd" X66 X0f38 0x3d;
    MUL_ADD_132 "vfmadd132ps" X66 X0f38 0x98;
    MUL_ADD_213 "vfmadd213ps" X66 X0f38 0xa8;
    MUL_ADD_231 "vfmadd231ps" X66 X0f38 0xb8;
    MUL_SUB_132 "vfmsub132ps" X66 X0f38 0x9a;
    MUL_SUB_213 "vfmsub213ps" X66 X0f38 0xaa;
    MUL_SUB_231 "vfmsub231ps" X66 X0f38 0xba;
    NEG_MUL_ADD_132 "vfnmadd132ps" X66 X0f38 0x9c;
    NEG_MUL_ADD_213 "vfnmadd213ps" X66 X0f38 0xac;
    NEG_MUL_ADD_231 "vfnmadd231ps" X66 X0f38 0xbc;
    NEG_MUL_SUB_132 "vfnmsub132ps" X66 X0f38 0x9e;
    NEG_MUL_SUB_213 "vfnmsub213ps" X66 X0f38 0xae;
    NEG_MUL_SUB_231 "vfnmsub231ps" X66 X0f38 0xbe;
}

/// `vmovaps` to memory.
const STORE: Form = Form(Prefix::None, Map::X0f, 0x29);
/// `vgatherdps`.
const GATHER: Form = Form(Prefix::X66, Map::X0f38, 0x92);
/// `vmovmskps`.
const SIGNS: Form = Form(Prefix::None, Map::X0f, 0x50);
/// `vpslld`, `vpsrld` and `vpsrad` by a constant.
const SHIFT: Form = Form(Prefix::X66, Map::X0f, 0x72);

/// Which way a shift goes: the digit its opcode is extended by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shift {
    /// `vpsrld`.
    Right = 2,
    /// `vpsrad`.
    RightSigned = 4,
    /// `vpslld`.
    Left = 6,
}

/// A place to jump to that is not known yet.
#[derive(Debug)]
#[must_use]
pub struct Jump(usize);

/// Bytes of instructions.
#[derive(Debug, Default)]
pub struct Assembler {
    bytes: Vec<u8>,
}

impl Assembler {
    /// Bytes so far.
    pub fn len(&self) -> usize {
        self.bytes.len()
    }

    /// Fills up with `int3`, which traps, to a multiple of `bytes`.
    pub fn align(&mut self, bytes: usize) {
        self.bytes.resize(self.bytes.len().next_multiple_of(bytes), 0xcc);
    }

    /// All of them.
    pub fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }

    /// `form to, from`.
    pub fn unary(&mut self, form: Form, to: Ymm, from: Operand) {
        self.instruction(form, to.0, Ymm(0), from);
    }

    /// `form to, first, second`.
    pub fn binary(&mut self, form: Form, to: Ymm, first: Ymm, second: Operand) {
        self.instruction(form, to.0, first, second);
    }

    /// `vcmpps to, first, second, condition`.
    pub fn compare(&mut self, condition: u8, to: Ymm, first: Ymm, second: Operand) {
        self.instruction(Form::COMPARE, to.0, first, second);
        self.bytes.push(condition);
    }

    /// `vroundps to, from, mode`.
    pub fn round(&mut self, mode: u8, to: Ymm, from: Operand) {
        self.instruction(Form::ROUND, to.0, Ymm(0), from);
        self.bytes.push(mode);
    }

    /// `vblendvps to, if_false, if_true, mask`.
    pub fn blend(&mut self, to: Ymm, if_false: Ymm, if_true: Operand, mask: Ymm) {
        self.instruction(Form::BLEND, to.0, if_false, if_true);
        self.bytes.push(mask.0 << 4);
    }

    /// A shift by a constant.
    pub fn shift(&mut self, shift: Shift, to: Ymm, from: Ymm, bits: u8) {
        self.instruction(SHIFT, shift as u8, to, from.into());
        self.bytes.push(bits);
    }

    /// `vmovaps` to memory.
    pub fn store(&mut self, base: Base, offset: i32, from: Ymm) {
        self.instruction(STORE, from.0, Ymm(0), Operand::Memory(base, offset));
    }

    /// `mov rax, address` and `vgatherdps to, [rax + index * 4], mask`: where the mask is set, which is
    /// cleared. The three registers differ.
    pub fn gather(&mut self, to: Ymm, address: u64, index: Ymm, mask: Ymm) {
        self.bytes.extend([0x48, 0xb8]);
        self.bytes.extend(address.to_le_bytes());
        self.vex(GATHER, to.0, index.0, 0, mask);
        // Mod 0 and a SIB byte: scale 4, the index, base rax.
        self.bytes.extend([GATHER.2, (to.0 & 7) << 3 | 4, 2 << 6 | (index.0 & 7) << 3]);
    }

    /// `vmovmskps eax, from`, `test eax, eax`, and a jump taken where no sign is set.
    pub fn jump_unless_any(&mut self, from: Ymm) -> Jump {
        self.instruction(SIGNS, 0, Ymm(0), from.into());
        self.bytes.extend([0x85, 0xc0, 0x0f, 0x84, 0, 0, 0, 0]);
        Jump(self.bytes.len())
    }

    /// Here is where it goes.
    pub fn land(&mut self, jump: Jump) {
        let distance = (self.bytes.len() - jump.0) as i32;
        self.bytes[jump.0 - 4..jump.0].copy_from_slice(&distance.to_le_bytes());
    }

    /// `add rsi, step`, `dec r8`, and back to `start` unless that gave 0; then the end of the function.
    pub fn next_block_or_return(&mut self, start: usize, step: i32) {
        self.bytes.extend([0x48, 0x81, 0xc6]);
        self.bytes.extend(step.to_le_bytes());
        self.bytes.extend([0x49, 0xff, 0xc8, 0x0f, 0x85]);
        let distance = start as i32 - (self.bytes.len() as i32 + 4);
        self.bytes.extend(distance.to_le_bytes());
        // vzeroupper, so that code with registers of 128 bits is not slowed down, and ret.
        self.bytes.extend([0xc5, 0xf8, 0x77, 0xc3]);
    }

    /// Any form of up to three operands; `register` may be a digit of the opcode.
    fn instruction(&mut self, form: Form, register: u8, first: Ymm, last: Operand) {
        let low = (register & 7) << 3;
        match last {
            Operand::Register(Ymm(last)) => {
                self.vex(form, register, 0, last, first);
                self.bytes.extend([form.2, 3 << 6 | low | last & 7]);
            }
            Operand::Memory(base, offset) => {
                self.vex(form, register, 0, 0, first);
                let place = low | base as u8;
                match i8::try_from(offset) {
                    Ok(0) => self.bytes.extend([form.2, place]),
                    Ok(short) => self.bytes.extend([form.2, 1 << 6 | place, short as u8]),
                    Err(_) => {
                        self.bytes.extend([form.2, 2 << 6 | place]);
                        self.bytes.extend(offset.to_le_bytes());
                    }
                }
            }
        }
    }

    /// The VEX prefix; `register`, `index` and `base` give their fourth bits. W is 0, the length 256.
    fn vex(&mut self, form: Form, register: u8, index: u8, base: u8, first: Ymm) {
        let Form(prefix, map, _) = form;
        let inverted = |register: u8, to: u8| (!register & 8) << (to - 3);
        let rest = (!first.0 & 15) << 3 | 1 << 2 | prefix as u8;
        if map == Map::X0f && index < 8 && base < 8 {
            self.bytes.extend([0xc5, inverted(register, 7) | rest]);
        } else {
            let extended = inverted(register, 7) | inverted(index, 6) | inverted(base, 5);
            self.bytes.extend([0xc4, extended | map as u8, rest]);
        }
    }
}

#[cfg(test)]
mod tests {
    use iced_x86::{Decoder, DecoderOptions, Formatter, IntelFormatter};

    use super::*;

    /// The one instruction, as others read it.
    fn text(assemble: impl FnOnce(&mut Assembler)) -> String {
        let mut assembler = Assembler::default();
        assemble(&mut assembler);
        let bytes = assembler.into_bytes();
        let mut decoder = Decoder::new(64, &bytes, DecoderOptions::NONE);
        let mut formatter = IntelFormatter::new();
        let mut lines = Vec::new();
        for instruction in &mut decoder {
            assert!(!instruction.is_invalid(), "{bytes:02x?}");
            let mut line = String::new();
            formatter.format(&instruction, &mut line);
            lines.push(line.replace(" ptr ", " "));
        }
        lines.join("; ")
    }

    /// Both halves of the registers, and all lengths of an offset.
    const OPERANDS: &[(Operand, &str)] = &[
        (Operand::Register(Ymm(3)), "ymm3"),
        (Operand::Register(Ymm(12)), "ymm12"),
        (Operand::Memory(Base::Rdi, 0), "[rdi]"),
        (Operand::Memory(Base::Rsi, 96), "[rsi+60h]"),
        (Operand::Memory(Base::Rdx, -128), "[rdx-80h]"),
        (Operand::Memory(Base::Rcx, 128), "[rcx+80h]"),
        (Operand::Memory(Base::Rsi, 0x7fff_ffe0), "[rsi+7FFFFFE0h]"),
    ];

    #[test]
    fn every_form_reads_as_meant() {
        let unary = ["vmovaps", "vsqrtps", "vcvtdq2ps", "vcvttps2dq", "vroundps"];
        for &(form, mnemonic) in FORMS {
            for &(operand, place) in OPERANDS {
                for to in [0, 5, 8, 15] {
                    for first in [1, 7, 9, 14] {
                        let (to, first) = (Ymm(to), Ymm(first));
                        let read = text(|assembler| match mnemonic {
                            "vcmpps" => assembler.compare(0x1d, to, first, operand),
                            "vroundps" => assembler.round(9, to, operand),
                            "vblendvps" => assembler.blend(to, first, operand, Ymm(13)),
                            _ if unary.contains(&mnemonic) => assembler.unary(form, to, operand),
                            _ => assembler.binary(form, to, first, operand),
                        });
                        let read = read.replace("ymmword ", "");
                        let (to, first) = (to.0, first.0);
                        let expected = match mnemonic {
                            "vcmpps" => format!("vcmpge_oqps ymm{to},ymm{first},{place}"),
                            "vroundps" => format!("vroundps ymm{to},{place},9"),
                            "vblendvps" => format!("vblendvps ymm{to},ymm{first},{place},ymm13"),
                            _ if unary.contains(&mnemonic) => format!("{mnemonic} ymm{to},{place}"),
                            _ => format!("{mnemonic} ymm{to},ymm{first},{place}"),
                        };
                        assert_eq!(read, expected);
                    }
                }
            }
        }
    }

    #[test]
    fn stores_shifts_gathers_and_jumps_read_as_meant() {
        for (register, base, offset, read) in [
            (3, Base::Rsi, 0, "vmovaps [rsi],ymm3"),
            (11, Base::Rcx, 0x1000, "vmovaps [rcx+1000h],ymm11"),
        ] {
            assert_eq!(text(|assembler| assembler.store(base, offset, Ymm(register))), read);
        }
        for (shift, to, from, read) in [
            (Shift::Left, 2, 9, "vpslld ymm2,ymm9,17h"),
            (Shift::Right, 15, 1, "vpsrld ymm15,ymm1,17h"),
            (Shift::RightSigned, 8, 8, "vpsrad ymm8,ymm8,17h"),
        ] {
            assert_eq!(text(|assembler| assembler.shift(shift, Ymm(to), Ymm(from), 23)), read);
        }
        for (to, index, mask) in [(1, 2, 3), (9, 10, 11), (0, 15, 4), (14, 3, 12)] {
            let read = text(|assembler| {
                assembler.gather(Ymm(to), 0x0123_4567_89ab_cdef, Ymm(index), Ymm(mask));
            });
            let expected = format!(
                "mov rax,123456789ABCDEFh; vgatherdps ymm{to},[rax+ymm{index}*4],ymm{mask}"
            );
            assert_eq!(read.replace("dword ", "").replace("ymmword ", ""), expected);
        }
        let read = text(|assembler| {
            let start = assembler.len();
            let jump = assembler.jump_unless_any(Ymm(10));
            assembler.binary(Form::ADD, Ymm(0), Ymm(1), Ymm(2).into());
            assembler.land(jump);
            assembler.next_block_or_return(start, 0x340);
        });
        let expected = "vmovmskps eax,ymm10; test eax,eax; je 0000000000000011h; \
             vaddps ymm0,ymm1,ymm2; add rsi,340h; dec r8; jne 0; vzeroupper; ret";
        assert_eq!(read, expected);
    }
}
