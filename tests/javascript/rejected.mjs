// The fields for which devices reject commands, as JSON: rejected.mjs GENERATED_FOLDER < tests/rejected.json
import { readFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const load = (name) => import(pathToFileURL(path.resolve(process.argv[2], name)));
const { fromHex, Protocol, toHex } = await load("mip/tools.mjs");
const { cause } = await load("mip/rejected.mjs");
const { default: model } = await load("model.mjs");
const protocol = new Protocol(model);
const hex = (number) => toHex(Uint8Array.of(number)).toUpperCase();

const answers = JSON.parse(readFileSync(0, "utf8")).map(({ command, data, device, descriptors }) => {
    const [set, descriptor] = fromHex(command);
    const known = { device: model.devices.find((one) => one.id === device) };
    if (descriptors) known.descriptors = new Set(descriptors.split(" ").map((one) => Number.parseInt(one, 16)));
    const found = cause(protocol, { set, descriptor, data: fromHex(data) }, known);
    return found ? [found.index, hex(found.set), hex(found.descriptor), found.reason, found.text] : null;
});
process.stdout.write(JSON.stringify(answers));
