// Writes the programs of the builder as JSON: for each command and data field, language by language.
//
//     programs.mjs GENERATED_FOLDER CALLS.json
//
// CALLS.json: the name of a field -> a list of function selectors, or null for a data field; or of whole values.
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const folder = path.resolve(process.argv[2]);
const load = (name) => import(pathToFileURL(path.join(folder, name)));
await load("model.js");
const { Protocol } = await load("mip/index.mjs");
const { programOf, typicalValues } = await load("tools/index.mjs");
const protocol = new Protocol(globalThis.mipModel);

const found = {};
for (const [name, calls] of Object.entries(JSON.parse(fs.readFileSync(process.argv[3], "utf8")))) {
    const field = protocol.field(name);
    const values = calls?.map((one) => (typeof one === "object" && one !== null ? one : typicalValues(protocol, field, one ?? undefined)));
    found[name] = Object.fromEntries(
        ["c", "python", "rust"].map((language) => {
            try {
                return [language, programOf(protocol, language, field, values)];
            } catch (error) {
                return [language, `${error.name} ${error.kind}: ${error.message}`];
            }
        }),
    );
}
process.stdout.write(JSON.stringify(found));
