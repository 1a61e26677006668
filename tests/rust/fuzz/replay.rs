//! The inputs of a file, one per line in hexadecimal, and others made from them at random:
//! INPUTS=FILE TARGET=NAME COUNT=NUMBER.

mod targets;

use std::env::var;

fn bytes(line: &str) -> Vec<u8> {
    let digits: Vec<u8> =
        line.bytes().map(|digit| (digit as char).to_digit(16).unwrap() as u8).collect();
    digits.chunks(2).map(|pair| pair[0] << 4 | pair[1]).collect()
}

#[test]
fn nothing_fails() {
    let (name, file) = (var("TARGET").unwrap(), var("INPUTS").unwrap());
    let (_, run) = targets::TARGETS.iter().find(|(target, _)| *target == name).unwrap();
    let inputs: Vec<Vec<u8>> = std::fs::read_to_string(file).unwrap().lines().map(bytes).collect();
    let mut random = 1_u64;
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
    let count: usize = var("COUNT").unwrap().parse().unwrap();
    for _ in 0..count {
        let mut input = inputs[below(inputs.len())].clone();
        for _ in 0..=below(4) {
            let at = below(input.len());
            match below(4) {
                0 => input.truncate(at),
                1 => input.extend_from_slice(&inputs[below(inputs.len())]),
                _ if input.is_empty() => {}
                2 => input[at] = below(256) as u8,
                _ => input[at] ^= 1 << below(8),
            }
        }
        input.truncate(1000);
        try_it(&input);
    }
    println!("{} inputs and {count} that were made from them", inputs.len());
}
