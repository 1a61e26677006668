// Programs in C, Python and Rust that send a command, or read a data field: the same as on the pages of the reference.

import { cProgram } from "./c.mjs";
import { Names, refuseReserved } from "./common.mjs";
import { pythonProgram } from "./python.mjs";
import { rustProgram } from "./rust.mjs";

/** The languages, as programs name and as people call them. */
export const LANGUAGES = [
    ["c", "C"],
    ["python", "Python"],
    ["rust", "Rust"],
];

/**
 * A program that sends a command once with each of some values, or that reads a data field or a response. Raises a
 * MipError of the kind "program" if a language cannot write a value.
 */
export function programOf(protocol, language, field, values = []) {
    const writer = { c: cProgram, python: pythonProgram, rust: rustProgram }[language];
    if (field.role !== "command") return writer(new Names(protocol, language), field);
    for (const one of values) refuseReserved(protocol, field, one);
    return writer(new Names(protocol, language), field, values);
}
