//! A target for libFuzzer, which TARGET names when it is built.

#![no_main]

mod targets;

#[no_mangle]
extern "C" fn LLVMFuzzerTestOneInput(data: *const u8, size: usize) -> i32 {
    let (_, run) =
        targets::TARGETS.iter().find(|(name, _)| *name == env!("TARGET")).expect("a target");
    // SAFETY: libFuzzer passes an array of this size, which does not change until this returns.
    run(unsafe { std::slice::from_raw_parts(data, size) });
    0
}
