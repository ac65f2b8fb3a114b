//! Functions compiled by Cranelift: made, owned, run and freed.
//!
//! What Cranelift 0.135 asks for:
//! * optimisation `speed` brings value numbering and loop-invariant motion;
//! * the verifier runs in debug builds only, NaN payloads are not canonicalised (1.6 to 2.2 times
//!   the run time, and NaNs compare as a class here);
//! * register allocation takes most of the compile time and is quadratic on huge functions:
//!   [`crate::ops::split`] keeps them short (faster code, too), and one that is still above
//!   [`SINGLE_PASS_ABOVE`] is allocated in a single pass;
//! * a dropped `JITModule` leaks its memory on purpose; [`CraneliftCode`] frees it;
//! * nothing may unwind through the code, and nothing does: it calls nothing.

use std::sync::{Arc, Mutex};

use cranelift_codegen::Context;
use cranelift_codegen::control::ControlPlane;
use cranelift_codegen::ir::UserFuncName;
use cranelift_codegen::isa::TargetIsa;
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::FunctionBuilderContext;
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Linkage, Module};

use super::lower::lower;
use crate::engine::jit::JitError;
use crate::ops::OpSegment;
use crate::storage::{FileShape, Lanes};

/// Functions of more operations are register-allocated in a single pass.
pub const SINGLE_PASS_ABOVE: usize = 2000;

/// A compiled segment: the file, how many bytes of it lie before the first block to run, and how many blocks
/// to run (at least one).
type Entry = unsafe extern "C" fn(file: *mut Lanes, before: i64, blocks: i64);

/// Machine code of segments.
pub struct CraneliftCode {
    /// Emptied by `drop` only; a mutex because the module is not `Sync`.
    module: Mutex<Option<JITModule>>,
    entries: Vec<Entry>,
    bytes: usize,
}

impl std::fmt::Debug for CraneliftCode {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("CraneliftCode")
            .field("functions", &self.entries.len())
            .field("bytes", &self.bytes)
            .finish_non_exhaustive()
    }
}

impl CraneliftCode {
    /// Compiles segments that are well formed for files of the shape.
    pub fn compile(segments: &[OpSegment], shape: FileShape) -> Result<Self, JitError> {
        let mut compiler = Compiler::new()?;
        let mut compiled = Ok(());
        for segment in segments {
            compiled = compiled.and_then(|()| compiler.add(segment, shape));
        }
        // From here the module belongs to a `CraneliftCode`, which frees it whatever happens.
        let Compiler { mut module, functions, code_bytes: bytes, .. } = compiler;
        let finished = compiled.and_then(|()| module.finalize_definitions().map_err(failed));
        let mut entries = Vec::new();
        if finished.is_ok() {
            entries.extend(functions.iter().map(|&id| {
                let address = module.get_finalized_function(id);
                // SAFETY: the function at `address` was compiled with this signature in the
                // platform's C calling convention, and lives until `drop` frees the module.
                unsafe { std::mem::transmute::<*const u8, Entry>(address) }
            }));
        }
        let code = Self { module: Mutex::new(Some(module)), entries, bytes };
        finished.map(|()| code)
    }

    /// Bytes of machine code, constants included.
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// Runs function `index` over `blocks` blocks that lie `before` bytes behind the start of the file, at least
    /// one.
    ///
    /// # Safety
    /// `file` holds the uniform words and, there, the blocks of a file of the shape it was compiled for, to be
    /// read and written.
    pub unsafe fn run(&self, index: usize, file: *mut Lanes, before: usize, blocks: usize) {
        // SAFETY: the code accesses what the caller vouches for; `Lanes` is aligned to 32 bytes, all bit patterns
        // are valid, and it calls nothing that could unwind or keep the pointer.
        unsafe { self.entries[index](file, before as i64, blocks as i64) };
    }
}

impl Drop for CraneliftCode {
    fn drop(&mut self) {
        let module = self.module.get_mut().unwrap_or_else(|poisoned| poisoned.into_inner());
        if let Some(module) = module.take() {
            // SAFETY: entries are called through `&self` only, so none is running, and they are
            // never handed out.
            unsafe { module.free_memory() };
        }
    }
}

/// What a function being compiled needs, kept between functions.
struct Compiler {
    module: JITModule,
    single_pass: Arc<dyn TargetIsa>,
    context: Context,
    builder: FunctionBuilderContext,
    functions: Vec<FuncId>,
    code_bytes: usize,
}

impl Compiler {
    fn new() -> Result<Self, JitError> {
        let isa = target("backtracking")?;
        let single_pass = target("single_pass")?;
        let builder = JITBuilder::with_isa(isa, cranelift_module::default_libcall_names());
        let module = JITModule::new(builder);
        let context = module.make_context();
        Ok(Self {
            module,
            single_pass,
            context,
            builder: FunctionBuilderContext::new(),
            functions: Vec::new(),
            code_bytes: 0,
        })
    }

    fn add(&mut self, segment: &OpSegment, shape: FileShape) -> Result<(), JitError> {
        let index = self.functions.len() as u32;
        let config = self.module.target_config();
        self.context.func.name = UserFuncName::user(0, index);
        lower(segment, shape, config, &mut self.context.func, &mut self.builder)
            .map_err(|what| JitError::Malformed { segment: index as usize, what })?;
        let id = self
            .module
            .declare_function(
                &format!("segment{index}"),
                Linkage::Local,
                &self.context.func.signature,
            )
            .map_err(failed)?;
        let isa = if segment.ops.len() > SINGLE_PASS_ABOVE {
            &*self.single_pass
        } else {
            self.module.isa()
        };
        let code = self
            .context
            .compile(isa, &mut ControlPlane::default())
            .map_err(|error| JitError::CodeGeneration(error.inner.to_string()))?;
        if !code.buffer.relocs().is_empty() {
            // Only calls relocate: a feature promised by `available` is missing in the target.
            return Err(JitError::CodeGeneration("an operation became a call".to_owned()));
        }
        let alignment = u64::from(code.buffer.alignment).max(isa.symbol_alignment());
        let bytes = code.code_buffer();
        self.code_bytes += bytes.len();
        self.module.define_function_bytes(id, alignment, bytes, &[]).map_err(failed)?;
        self.module.clear_context(&mut self.context);
        self.functions.push(id);
        Ok(())
    }
}

fn failed(error: impl std::fmt::Display) -> JitError {
    JitError::CodeGeneration(error.to_string())
}

/// The host, with the given register allocator.
pub(super) fn target(allocator: &str) -> Result<Arc<dyn TargetIsa>, JitError> {
    let mut flags = settings::builder();
    for (name, value) in [
        ("opt_level", "speed"),
        ("regalloc_algorithm", allocator),
        ("enable_verifier", if cfg!(debug_assertions) { "true" } else { "false" }),
        ("enable_nan_canonicalization", "false"),
        ("use_colocated_libcalls", "false"),
        ("is_pic", "false"),
        ("unwind_info", "false"),
        ("enable_probestack", "false"),
    ] {
        flags.set(name, value).map_err(failed)?;
    }
    let host = cranelift_native::builder().map_err(failed)?;
    host.finish(settings::Flags::new(flags)).map_err(failed)
}
