/** The specification, as mip.json of the JSON target has it. */
declare const model: { readonly format: string; readonly [part: string]: any };
export default model;
