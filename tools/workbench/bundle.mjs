// Builds the tools for the browser as pages that open from disk: `make workbench`.
//
//     NODE_PATH=NODE_MODULES node bundle.mjs PACKAGE FOLDER
//
// PACKAGE is a codec that mipgen generated, such as `generated/javascript`, of any specification. Browsers load no
// modules from disk, so the tools, the codec and the model become one classic script, `workbench.js`, which defines one
// global object, `mip`, with the exports of `index.mjs`. FOLDER gets that script, the style sheets, a page for each tool,
// and `fields.js`, which defines only what `fields.mjs` exports: pages without a tool search fields with it.
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const require = createRequire(import.meta.url); // unlike `import`, it reads NODE_PATH
const { build } = require("esbuild");
const { strToU8, zlibSync } = require("fflate");

/** The pages, by the function that fills them. */
const TOOLS = {
    bandwidth: "Bandwidth calculator",
    builder: "Packet builder",
    finder: "Field finder",
    inspector: "Packet inspector",
    live: "Live device",
};

const here = path.dirname(fileURLToPath(import.meta.url));
const [folder, output] = process.argv.slice(2).map((one) => path.resolve(one));
const manifest = path.join(folder, "package.json");
if (!fs.existsSync(manifest)) {
    console.error(`bundle.mjs: ${manifest} is missing; generate the target javascript first`);
    process.exit(1);
}
const { exports } = JSON.parse(fs.readFileSync(manifest, "utf8"));

const without = (names, of) => Object.fromEntries(Object.entries(of ?? {}).filter(([name]) => !names.includes(name)));

/** Returns a model without the largest parts that no tool reads. */
function read(model) {
    return {
        ...without(["guides", "named_devices", "manuals", "notes"], model),
        examples: model.examples.map((example) => without(["fields"], example)),
        simulation: without(["quantities", "effects"], model.simulation),
        fields: model.fields.map((field) => without(["notes", "uncertain", "affects", "may_affect"], field)),
        devices: model.devices?.map((device) => without(["notes", "uncertain", "hardware", "sources"], device)),
    };
}

const only = (names, of) => Object.fromEntries(Object.entries(of).filter(([name]) => names.includes(name)));

/** Returns what of a model the search reads. */
function searched(model) {
    const part = (parameter) => ({
        ...only(["name", "type", "description"], parameter),
        variants: parameter.variants?.map((variant) => only(["type"], variant)),
        cases: parameter.cases?.map((one) => ({ parameter: one.parameter && part(one.parameter) })),
    });
    const OF_FIELD = ["set", "name", "descriptor", "role", "title", "description", "responses", "command", "symbols"];
    const OF_DEVICE = ["id", "title", "also", "model_number", "supports", "refuses", "incomplete", "evidence"];
    return {
        ...without(["guides", "named_devices", "manuals", "notes", "examples", "errata", "simulation"], model),
        fields: model.fields.map((field) => ({
            ...only([...OF_FIELD, "also", "keywords", "deprecated", "occurrences"], field),
            parameters: field.parameters.map(part),
            sources: field.sources.map((source) => only(["section"], source)),
        })),
        devices: model.devices?.map((device) => ({
            ...only(OF_DEVICE, device),
            supports: device.supports?.map((one) => only(["field", "evidence"], one)),
            evidence: device.evidence?.map((one) => only(["answer", "sets"], one)),
        })),
    };
}

/** Finds the codec under the name by which the tools import it, and compresses the part of the model that is read. */
const codec = (partOf) => ({
    name: "codec",
    setup({ onResolve, onLoad }) {
        onResolve({ filter: /^mip-protocol(\/|$)/ }, ({ path: name }) => ({
            path: path.join(folder, exports[name.replace("mip-protocol", ".")].default),
            namespace: name.endsWith("/model") ? "model" : "file",
            sideEffects: false, // as its package.json states
        }));
        onLoad({ filter: /^/, namespace: "model" }, async ({ path: file }) => {
            const { default: model } = await import(pathToFileURL(file));
            return { contents: zlibSync(strToU8(JSON.stringify(partOf(model))), { level: 9 }), loader: "binary" };
        });
    },
});

const fflate = path.dirname(require.resolve("fflate/package.json"));
const licence = `fflate: ${fs.readFileSync(path.join(fflate, "LICENSE"), "utf8")}`;
for (const [entry, script, partOf] of [
    ["index.mjs", "workbench.js", read],
    ["fields.mjs", "fields.js", searched],
]) {
    await build({
        entryPoints: [path.join(here, entry)],
        outfile: path.join(output, script),
        bundle: true,
        minify: true,
        format: "iife",
        globalName: "mip",
        target: "es2022",
        banner: { js: "// The MIP workbench: tools, codec and model as one script. MIT licence; it contains fflate." },
        footer: { js: `globalThis.mip = mip; // also where a script is a module\n/*\n${licence}*/` },
        plugins: [codec(partOf)],
        nodePaths: process.env.NODE_PATH.split(path.delimiter),
    });
}

for (const style of ["page.css", "tools.css"]) fs.copyFileSync(path.join(here, style), path.join(output, style));
const page = fs.readFileSync(path.join(here, "page.html"), "utf8");
for (const [name, title] of Object.entries(TOOLS)) {
    const link = ([one, words]) => `            <a href="${one}.html"${one === name ? ' aria-current="page"' : ""}>${words}</a>`;
    const values = { name, title, links: Object.entries(TOOLS).map(link).join("\n") };
    fs.writeFileSync(
        path.join(output, `${name}.html`),
        page.replace(/\$(\w+)/g, (_, key) => values[key]),
    );
}
