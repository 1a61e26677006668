// Programs in each language that send a command, or read a data field: the same as on the pages of the reference.

import { cProgram } from "./c.mjs";
import { Names, refuseReserved } from "./common.mjs";
import { cppProgram } from "./cpp.mjs";
import { javascriptProgram } from "./javascript.mjs";
import { pythonProgram } from "./python.mjs";
import { rustProgram } from "./rust.mjs";

/** The languages, as programs name and as people call them. */
export const LANGUAGES = [
    ["c", "C"],
    ["cpp", "C++"],
    ["python", "Python"],
    ["rust", "Rust"],
    ["javascript", "JavaScript"],
];

const WRITERS = { c: cProgram, cpp: cppProgram, python: pythonProgram, rust: rustProgram, javascript: javascriptProgram };

/**
 * A program that sends a command once with each of some values, or that reads a data field or a response. Raises a
 * MipError of the kind "program" if a language cannot write a value.
 */
export function programOf(protocol, language, field, values = []) {
    const writer = WRITERS[language];
    if (field.role !== "command") return writer(new Names(protocol, language), field);
    for (const one of values) refuseReserved(protocol, field, one);
    return writer(new Names(protocol, language), field, values);
}
