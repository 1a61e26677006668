// Starts the tool of a page; the addresses are those of the reference as a site, beside this folder.
function mipPage(tool, options) {
    const protocol = new mip.Protocol(mipModel);
    const reference = { fieldPage: "../fields/{set}/{field}/", erratumPage: "../errata/#erratum.{id}" };
    return tool(document.getElementById("tool"), protocol, { ...reference, ...options });
}
