// Prints the sizes of programs, minified and without unused code, in bytes.
//
//     bundle.mjs NODE_MODULES PROGRAM...
import path from "node:path";
import { createRequire } from "node:module";

const [modules, ...programs] = process.argv.slice(2).map((one) => path.resolve(one));
const { build, stop } = createRequire(path.join(modules, "x.js"))("esbuild-wasm");
for (const program of programs) {
    const options = { bundle: true, minify: true, format: "esm", write: false, target: "es2022" };
    const { outputFiles } = await build({ ...options, entryPoints: [program] });
    console.log(outputFiles[0].contents.length);
}
await stop();
