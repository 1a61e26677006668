// Prints what the workbench finds in a log, as JSON: survey.mjs WORKBENCH_SCRIPT LOG ...
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

await import(pathToFileURL(process.argv[2]));
const { model, Protocol, survey } = globalThis.mip;
for (const log of process.argv.slice(3)) {
    const { device, spans, read, fields: all } = await survey(new Protocol(model), () => [readFileSync(log)]);
    const fields = all.map(({ set, descriptor, count, valid, rhythm }) => ({ set, descriptor, count, valid, rate: rhythm.rate }));
    console.log(JSON.stringify({ device, spans, read, fields }));
}
