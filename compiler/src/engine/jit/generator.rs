//! Who makes the machine code.

use super::JitError;

/// Who makes the machine code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Generator {
    /// Ours: for x86-64 with AVX2 and FMA, eight lanes at once.
    Native,
    /// Cranelift: four lanes at once.
    Cranelift,
}

impl Generator {
    /// All, the better first.
    pub const ALL: [Self; 2] = [Self::Native, Self::Cranelift];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Native => "native",
            Self::Cranelift => "cranelift",
        }
    }

    /// Whether its code can be generated for, and run on, this machine.
    ///
    /// # Errors
    /// [`JitError::UnsupportedTarget`] and [`JitError::MissingFeature`].
    pub fn available(self) -> Result<(), JitError> {
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::is_x86_feature_detected as has;
            let features = match self {
                Self::Native => [("AVX2", has!("avx2")), ("FMA", has!("fma"))],
                // Without the second Cranelift calls a library function per lane.
                Self::Cranelift => {
                    [("SSE4.1", has!("sse4.1")), ("FMA", has!("avx") && has!("fma"))]
                }
            };
            match features.iter().find(|(_, present)| !present) {
                Some((feature, _)) => {
                    let remedy = match self {
                        Self::Native => "`cranelift` may run here, and the batch engine does",
                        Self::Cranelift => "the batch engine runs everywhere",
                    };
                    Err(JitError::MissingFeature { generator: self.name(), feature, remedy })
                }
                None => Ok(()),
            }
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            Err(JitError::UnsupportedTarget)
        }
    }

    /// The one asked for, or else the best there is on this machine.
    ///
    /// # Errors
    /// As of [`Generator::available`].
    pub fn chosen(asked: Option<Self>) -> Result<Self, JitError> {
        match asked {
            Some(generator) => generator.available().map(|()| generator),
            None => match Self::Native.available() {
                Ok(()) => Ok(Self::Native),
                Err(_) => Self::Cranelift.available().map(|()| Self::Cranelift),
            },
        }
    }
}
