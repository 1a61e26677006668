// Starts the tool of a page.
function mipPage(tool, options) {
    return tool(document.getElementById("tool"), new mip.Protocol(mipModel), options);
}
