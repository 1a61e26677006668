/** The specification, as in mip.json of the JSON target. */
declare const model: { readonly format: string; readonly [part: string]: any };
export default model;
