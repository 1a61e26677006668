// Fields as JSON and as structured clones: json.mjs GENERATED_FOLDER < lines of NAME and data in hexadecimal
//
// Prints for each field its data after JSON, its data after a clone, and the JSON.
import { readFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const load = (name) => import(pathToFileURL(path.resolve(process.argv[2], name)));
const { fromHex, toHex } = await load("mip/index.mjs");
const { registry } = await load("registry.mjs");

const rows = readFileSync(0, "utf8").trimEnd().split("\n");
const results = rows.map((row) => {
    const [name, data = ""] = row.split(" ");
    const kind = registry.field(name);
    const field = kind.decode(fromHex(data));
    const json = JSON.stringify(field);
    return [kind.fromJSON(JSON.parse(json)), new kind(structuredClone(field))].map((one) => toHex(one.encode())).concat(json);
});
process.stdout.write(JSON.stringify(results));
