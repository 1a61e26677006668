// Writes the programs of the builder as JSON: for each command and data field, language by language.
//
//     programs.mjs WORKBENCH CALLS.json
//
// CALLS.json: the name of a field -> a list of function selectors, or null for a data field; or of whole values.
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

await import(pathToFileURL(path.resolve(process.argv[2], "workbench.js")));
const { Protocol, model, programOf, typicalValues } = globalThis.mip;
const protocol = new Protocol(model);

const found = {};
for (const [name, calls] of Object.entries(JSON.parse(fs.readFileSync(process.argv[3], "utf8")))) {
    const field = protocol.field(name);
    const values = calls?.map((one) => (typeof one === "object" && one !== null ? one : typicalValues(protocol, field, one ?? undefined)));
    found[name] = Object.fromEntries(
        ["c", "cpp", "python", "rust", "javascript"].map((language) => {
            try {
                return [language, programOf(protocol, language, field, values)];
            } catch (error) {
                return [language, `${error.name} ${error.kind}: ${error.message}`];
            }
        }),
    );
}
process.stdout.write(JSON.stringify(found));
