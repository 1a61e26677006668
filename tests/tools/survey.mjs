// Prints what the workbench finds in a log, as JSON: survey.mjs WORKBENCH_SCRIPT LOG
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

await import(pathToFileURL(process.argv[2]));
const { model, Protocol, survey } = globalThis.mip;
const found = await survey(new Protocol(model), () => [readFileSync(process.argv[3])]);
const fields = found.fields.map(({ set, descriptor, count, valid, rhythm }) => ({ set, descriptor, count, valid, rate: rhythm.rate }));
console.log(JSON.stringify({ device: found.device, spans: found.spans, fields }));
