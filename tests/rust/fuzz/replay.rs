//! The inputs of a file, one per line in hexadecimal, and others made from them at random:
//! `replay TARGET FILE COUNT [SEED]`.

mod targets;

fn bytes(line: &str) -> Vec<u8> {
    let digits: Vec<u8> =
        line.bytes().map(|digit| (digit as char).to_digit(16).unwrap() as u8).collect();
    digits.chunks(2).map(|pair| pair[0] << 4 | pair[1]).collect()
}

/// Whether this program was compiled with overflow checks, without which it would find less.
fn checks_overflow() -> bool {
    std::panic::catch_unwind(|| std::hint::black_box(u8::MAX) + std::hint::black_box(1)).is_err()
}

fn main() {
    assert!(checks_overflow(), "compile it with -Cdebug-assertions");
    let arguments: Vec<String> = std::env::args().collect();
    let [_, name, file, count, seed @ ..] = &arguments[..] else { panic!("{arguments:?}") };
    let count: u64 = count.parse().unwrap();
    let (_, run) = targets::TARGETS.iter().find(|(target, _)| target == name).unwrap();
    let inputs: Vec<Vec<u8>> = std::fs::read_to_string(file).unwrap().lines().map(bytes).collect();
    let mut random: u64 = seed.first().map_or(1, |seed| seed.parse().unwrap());
    let mut below = |end: usize| {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (random >> 33) as usize % end.max(1)
    };
    let try_it = |input: &[u8]| {
        if std::panic::catch_unwind(|| run(input)).is_err() {
            let hex: String = input.iter().map(|byte| format!("{byte:02x}")).collect();
            panic!("{name}: {hex}");
        }
    };
    inputs.iter().for_each(|input| try_it(input));
    let mut input = Vec::new();
    for _ in 0..count {
        input.clone_from(&inputs[below(inputs.len())]);
        for _ in 0..=below(4) {
            let at = below(input.len());
            match below(5) {
                0 => input.truncate(at),
                1 => {
                    let other = &inputs[below(inputs.len())];
                    let end = at + below(input.len() - at + 1);
                    input.splice(at..end, other[below(other.len())..].iter().copied());
                }
                _ if input.is_empty() => {}
                2 => input[at] = below(256) as u8,
                3 => input[at] = below(8) as u8,
                _ => input[at] ^= 1 << below(8),
            }
        }
        input.truncate(1000);
        try_it(&input);
    }
    println!("{} inputs and {count} that were made from them", inputs.len());
}
