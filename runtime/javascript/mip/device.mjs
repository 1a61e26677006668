// A device at a port: commands, and data as it arrives.
//
// The callback `open` returns a port, an object with three methods: `bytes()` returns an async iterator of Uint8Arrays
// that ends when the port is lost; `write(bytes)` and `close()` may return promises. `tcp`, `serial` and `websocket`
// make ports.

import { AckCode, FunctionSelector } from "../protocol.mjs";
import { session } from "../session.mjs";
import { isSame, MipError } from "./bytes.mjs";
import { Client, checkSeconds } from "./client.mjs";
import { modelNumber } from "./naming.mjs";
import { stream } from "./streaming.mjs";

/** Seconds without a byte after which an incomplete packet, which may be noise, is searched, and discarded. */
const PAUSE = 0.1;
const SILENCE = 1;

const now = () => performance.now() / 1000;

export class Device {
    #open;
    #options;
    #port;
    #client;
    #end; // why no more bytes arrive
    #closed = false;
    #waiting = new Map(); // command -> the function to call with its outcome
    #settings = new Map(); // class of a command -> the setting that the device is known to have
    #model; // the device's id
    #named = false; // by the program
    #identified = false; // by its answer from this port, or by the program
    #packets = [];
    #readers = []; // functions to call with the next packets
    #timer;
    #heard = 0;
    #incomplete = false;

    dropped = 0;

    constructor(open, { timeout = 1, capacity = 10_000, onBytes, onSkipped, explain } = {}) {
        if (!(capacity >= 1)) throw new MipError("range", `capacity ${capacity}: must be at least 1 packet`);
        this.#open = open;
        this.#options = { capacity, onBytes, explain };
        this.#client = new Client({ timeout, onSkipped });
    }

    static async open(open, options = {}) {
        const device = new Device(open, options);
        await device.#begin();
        return device;
    }

    async #begin() {
        const port = await this.#open();
        if (this.#closed) {
            await port.close(); // nobody else would
            throw new MipError("closed", "the device was closed");
        }
        this.#port = port;
        this.#settings.clear();
        this.#identified = this.#named;
        this.#incomplete = false;
        this.#end = undefined;
        this.#read(this.#port);
    }

    get closed() {
        return this.#end !== undefined;
    }

    get skipped() {
        return this.#client.skipped;
    }

    get waiting() {
        return this.#packets.length;
    }

    get model() {
        return this.#model;
    }

    set model(id) {
        this.#model = id;
        this.#named = this.#identified = id !== undefined;
    }

    // ------------------------------------------------------------------------------------------------ commands

    async request(command, options) {
        const [response] = await this.requestAll([command], options);
        return response;
    }

    async requestAll(commands, options) {
        const outcomes = await this.exchange(commands, options);
        return outcomes.map((outcome, i) => responseOf(outcome, commands[i]));
    }

    async exchange(commands, options = {}) {
        for (const command of commands) await this.#askFor(command);
        const outcomes = await Promise.all(await this.#send(commands, options, true));
        for (const [i, outcome] of outcomes.entries()) {
            if (outcome?.type !== "answer" || outcome.accepted) continue;
            outcome.rejected = await this.#options.explain?.(this, commands[i], this.#port);
        }
        return outcomes;
    }

    async send(...commands) {
        await this.#send(commands, {}, false);
    }

    async #send(commands, options, wait) {
        // What has already arrived is taken in first, as data: the copy of an earlier reply, on a line that may repeat it, is
        // not matched to this command.
        await new Promise((done) => setTimeout(done));
        this.#mustBeOpen();
        const client = this.#client;
        const pending = client.pending; // the client distinguishes commands by their objects
        const sent = commands.map((one, i) => (pending.includes(one) || commands.indexOf(one) < i ? new one.constructor({ ...one }) : one));
        const bytes = client.send(sent, now(), { ...options, wait });
        const outcomes = sent.map((command) => {
            if (!client.pending.includes(command)) return undefined;
            if (this.#isSilenced(command)) {
                client.cancel(command, { silent: true });
                return undefined;
            }
            return new Promise((resolve) => this.#waiting.set(command, resolve));
        });
        this.#watch();
        await this.write(bytes);
        return outcomes;
    }

    async write(bytes) {
        this.#mustBeOpen();
        try {
            await this.#port.write(bytes);
        } catch (error) {
            this.#lose(error);
            this.#mustBeOpen();
        }
    }

    #mustBeOpen() {
        if (this.#end) throw new MipError("closed", this.#end.message, { cause: this.#end.cause });
    }

    /** Reads, once, the device setting that decides whether a command is acknowledged, if there is one. */
    async #askFor(command) {
        for (const [setting] of command?.constructor.SILENCED_BY ?? []) {
            const kind = setting();
            if (!command.answered || this.#settings.has(kind) || kind.layout.calls?.[FunctionSelector.READ] !== 0) continue;
            const [outcome] = await this.exchange([kind.read()]);
            if (outcome?.type === "answer" && !outcome.accepted) this.#settings.set(kind, undefined); // the device does not have the setting
        }
    }

    #isSilenced(command) {
        const holds = ([setting, name, value]) => isSame(this.#settings.get(setting())?.[name], value);
        return command.constructor.SILENCED_BY.some(holds);
    }

    /** Records what the device has reported, or a setting that it has accepted. */
    #learn({ command, response, accepted }) {
        const kind = command.constructor;
        if (!accepted || kind.SILENCED_BY.length) return;
        if (response && session && !this.#named && kind === session.identify().constructor) {
            // The serial number counts only if there is no model number, not if that of a newer model is not known.
            this.#model = session.models[session.modelNumbers(response).map(modelNumber).find(Boolean)];
            this.#identified = true;
        }
        const selector = kind.layout.calls ? Number(command.function) : null; // not undefined, as SAVE may be
        if (selector === FunctionSelector.READ) {
            if (response) this.#settings.set(kind, response);
        } else if (selector === FunctionSelector.WRITE) {
            this.#settings.set(kind, command);
        } else if (selector !== FunctionSelector.SAVE) {
            this.#settings.clear(); // it may have loaded others, or restarted
        }
    }

    /** Sets the device to idle and identifies it. */
    async identify() {
        await this.request(commands().idle());
        return this.request(session.identify());
    }

    async stream(rates, options = {}) {
        return stream(this, commands(), new Map(rates), options, this.#identified, (set) => {
            this.#packets = this.#packets.filter((packet) => packet.set !== set);
        });
    }

    // ------------------------------------------------------------------------------------------------ data

    async *[Symbol.asyncIterator]() {
        for (;;) {
            const packet = await this.next();
            if (!packet) return;
            yield packet;
        }
    }

    /**
     * Returns the next data packet, with its time of arrival (`time`, in seconds since 1970 by this computer's clock), or
     * undefined if none arrives within `timeout` seconds or the device is closed. Throws "closed" when the port is lost,
     * once all data that arrived before has been returned.
     */
    async next({ timeout } = {}) {
        if (timeout !== undefined) checkSeconds(timeout);
        if (this.#packets.length) return this.#packets.shift();
        if (this.#closed) return undefined;
        this.#mustBeOpen();
        return new Promise((resolve, reject) => {
            const reader = { resolve, reject };
            if (timeout !== undefined) {
                reader.timer = setTimeout(() => {
                    this.#readers = this.#readers.filter((one) => one !== reader);
                    resolve(undefined);
                }, timeout * 1000);
            }
            this.#readers.push(reader);
        });
    }

    async *fields(...kinds) {
        for await (const packet of this) for (const kind of kinds) yield* packet.findAll(kind);
    }

    clear() {
        this.#packets.length = 0;
    }

    async #read(port) {
        let cause;
        try {
            for await (const bytes of port.bytes()) {
                if (port !== this.#port || this.#end) return;
                this.#options.onBytes?.(bytes);
                this.#heard = now();
                this.#incomplete = true;
                this.#handle(this.#client.receive(bytes, now()));
            }
        } catch (error) {
            cause = error;
        }
        if (port === this.#port) this.#lose(cause);
    }

    #handle(events) {
        for (const event of events) {
            if (event.type === "received") this.#arrive(event.packet);
            else {
                if (event.type === "answer") this.#learn(event);
                this.#waiting.get(event.command)?.(event);
                this.#waiting.delete(event.command);
            }
        }
        this.#watch();
    }

    #arrive(packet) {
        packet.arrival = Date.now() / 1000;
        packet.model = this.#model;
        const reader = this.#readers.shift();
        if (reader) {
            clearTimeout(reader.timer);
            reader.resolve(packet);
            return;
        }
        if (this.#packets.length >= this.#options.capacity) {
            this.#packets.shift();
            this.dropped++;
        }
        this.#packets.push(packet);
    }

    /** Sets a timer for the next time-out, or for an idle line. */
    #watch() {
        clearTimeout(this.#timer);
        this.#timer = undefined;
        if (this.#end) return;
        const pause = now() - this.#heard;
        const times = [this.#client.deadline];
        if (this.#incomplete) times.push(this.#heard + (pause < PAUSE ? PAUSE : SILENCE));
        const next = Math.min(...times.filter((time) => time !== undefined));
        if (next === Infinity) return;
        this.#timer = setTimeout(() => this.#wake(), Math.min(Math.max((next - now()) * 1000, 0) + 1, 0x7fffffff));
    }

    #wake() {
        const silent = now() - this.#heard >= SILENCE;
        if (!this.#incomplete) {
            this.#handle(this.#client.poll(now()));
        } else if (silent) {
            this.#incomplete = false;
            this.#handle(this.#client.flush(now()));
        } else {
            this.#handle(this.#client.lookBehind(now()));
        }
    }

    // ------------------------------------------------------------------------------------------------ the port

    async close() {
        this.#closed = true;
        this.#lose(undefined, "the device was closed");
        await this.#port?.close();
    }

    async reopen({ within = 30 } = {}) {
        checkSeconds(within);
        const port = this.#port;
        this.#lose(undefined, "the port is being opened again");
        this.#closed = false;
        const end = now() + within;
        try {
            await port?.close();
        } catch {
            // it was lost
        }
        for (;;) {
            try {
                await this.#begin();
                return;
            } catch (error) {
                if (this.#closed || now() >= end) throw error;
                await new Promise((resolve) => setTimeout(resolve, 100));
            }
        }
    }

    #lose(cause, message = `the port is lost${cause ? `: ${cause.message ?? cause}` : ""}`) {
        if (this.#end) return;
        this.#end = { message, cause };
        clearTimeout(this.#timer);
        for (const event of this.#client.interrupt()) {
            if (event.type === "received") this.#arrive(event.packet);
            else this.#waiting.get(event.command)?.(event.type === "answer" ? event : { ...event, type: "closed", message });
        }
        this.#waiting.clear();
        for (const { resolve, reject, timer } of this.#readers.splice(0)) {
            clearTimeout(timer);
            if (this.#closed) resolve(undefined);
            else reject(new MipError("closed", message, { cause }));
        }
    }
}

function commands() {
    if (!session) throw new MipError("session", "this package's specification has no commands for it");
    return session;
}

/** Returns the device's response, or throws the error that explains its absence. */
function responseOf(outcome, command) {
    if (outcome === undefined) return undefined;
    const { NAME } = command.constructor;
    if (outcome.type === "timedOut") throw new MipError("timeout", `${NAME}: no answer`, { command });
    if (outcome.type === "closed") throw new MipError("closed", `${NAME}: ${outcome.message}`, { command });
    if (!outcome.accepted) {
        const { code, rejected } = outcome;
        const words = AckCode.nameOf(code)?.toLowerCase().replaceAll("_", " ") ?? `code ${code}`;
        const why = rejected ? `: ${rejected.text}` : "";
        throw new MipError("refused", `${NAME} rejected (${words})${why}`, { command, code, rejected });
    }
    if (outcome.error) throw outcome.error;
    return outcome.response;
}
