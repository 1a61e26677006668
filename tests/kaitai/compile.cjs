"use strict";
// compile.cjs KSY LANGUAGE FOLDER: what the compiler makes of a file, and the file itself as mip.json for the drivers.
// KAITAI_MODULES is the folder above node_modules.
const fs = require("fs");
const path = require("path");
const { createRequire } = require("module");

const [ksy, language, folder] = process.argv.slice(2);
const installed = createRequire(path.join(process.env.KAITAI_MODULES, "package.json"));
const tree = installed("js-yaml").load(fs.readFileSync(ksy, "utf8"));

installed("kaitai-struct-compiler")
    .compile(language, tree, null, false)
    .then((files) => {
        for (const [name, text] of Object.entries({ ...files, "mip.json": JSON.stringify(tree) })) {
            const file = path.join(folder, name);
            fs.mkdirSync(path.dirname(file), { recursive: true });
            fs.writeFileSync(file, text);
        }
    })
    .catch((error) => {
        process.stderr.write(`${ksy}: ${(error && error.message) || error}\n`);
        process.exit(1);
    });
