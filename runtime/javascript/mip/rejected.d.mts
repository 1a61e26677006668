// The field for which a device rejects a command.

import type { Command, Device, Port, Rejected } from "./index.mjs";
import type { Item, Protocol } from "./tools.mjs";

/**
 * Makes the option `explain` of a device: finds the field for which the device rejected a command, and asks the device once
 * what it is and what it sends.
 *
 * @param model the default export of model.mjs
 */
export declare function rejections(model: Item): (device: Device, command: Command, port: Port) => Promise<Rejected | undefined>;
/** What is known about a device: its profile in the model, and what it lists itself, as set * 256 + descriptor. */
export interface Known {
    device?: Item;
    descriptors?: ReadonlySet<number>;
}
/** Returns the field for which a device rejected a command; undefined if nothing shows it. */
export declare function cause(
    protocol: Protocol,
    command: { set: number; descriptor: number; data: Uint8Array },
    known: Known,
): Rejected | undefined;
