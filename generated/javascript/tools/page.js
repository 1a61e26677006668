// Starts the tool of a page; the addresses are those of the reference as a site, beside this folder.
// biome-ignore lint/correctness/noUnusedVariables: pages call it
function mipPage(tool, options) {
    const protocol = new mip.Protocol(mipModel);
    const reference = { fieldPage: "../fields/{set}/{field}/", erratumPage: "../errata/#erratum.{id}" };
    return tool(document.getElementById("tool"), protocol, { ...reference, ...options });
}
