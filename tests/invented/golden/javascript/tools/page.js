// Starts the tool of a page.
// biome-ignore lint/correctness/noUnusedVariables: pages call it
function mipPage(tool, options) {
    return tool(document.getElementById("tool"), new mip.Protocol(mipModel), { inspectorPage: "inspector.html#{packet}", ...options });
}
