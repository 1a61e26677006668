// The conformance driver for JavaScript: one JSON request per line in, one JSON answer per line out.
//
//     driver.mjs GENERATED_FOLDER
//
// Values have the names of the specification: classes read and write them in the plain form, which tools use, and members
// are renamed. Objects are checked for each field, too: they must encode to the bytes from which they were decoded.
import path from "node:path";
import readline from "node:readline";
import { pathToFileURL } from "node:url";

const folder = path.resolve(process.argv[2]);
const load = (name) => import(pathToFileURL(path.join(folder, name)));
const { Client, Command, fromHex, MipError, Packet, packetOf, Parser, toHex } = await load("mip/index.mjs");
const { encoded, Reader } = await load("mip/codec.mjs");
const { registry } = await load("registry.mjs");
const { memberName, nameIn, Protocol } = await load("mip/tools.mjs");
const { default: model } = await load("model.mjs");
const protocol = new Protocol(model); // for names only: what a field is called in one of several sets

class BadRequest extends Error {}

function check(condition) {
    if (!condition) throw new BadRequest();
}

const bytesOf = (text) => {
    check(typeof text === "string" && /^([0-9a-f]{2})*$/i.test(text));
    return fromHex(text);
};

const nameOf = (kind, set) => nameIn(protocol.field(kind.NAME), set);

/** Yields the names of all parameters within a field or a structure. */
function* namesIn({ parameters }) {
    for (const { name, type, cases = [] } of parameters) {
        const within = cases.flatMap(({ parameter }) => parameter ?? []);
        yield name;
        yield* namesIn({ parameters: within });
        if (protocol.types.get(type)?.kind === "struct") yield* namesIn(protocol.types.get(type));
    }
}

/** Returns values with the members as names, or the names as members. */
function renamed(kind, values, names) {
    const pairs = [...namesIn(protocol.field(kind.NAME))].map((name) => [name, memberName(name)]);
    const found = new Map(names ? pairs : pairs.map(([name, member]) => [member, name]));
    const walk = (value) => {
        if (Array.isArray(value)) return value.map(walk);
        if (typeof value !== "object" || value === null) return value;
        return Object.fromEntries(Object.entries(value).map(([key, inner]) => [found.get(key) ?? `no ${key}`, walk(inner)]));
    };
    return walk(values);
}

// ---------------------------------------------------------------------------------------------------- the codec

function parse({ stream, chunk }) {
    const bytes = bytesOf(stream);
    check(Number.isInteger(chunk) && chunk > 0);
    const parser = new Parser();
    const packets = [];
    for (let at = 0; at < bytes.length; at += chunk) packets.push(...parser.feed(bytes.subarray(at, at + chunk)));
    packets.push(...parser.flush());
    return { packets: packets.map((packet) => toHex(packet.bytes)), skipped: parser.skipped };
}

function decode({ packet }) {
    const found = Packet.from(bytesOf(packet));
    return { set: found.set, fields: fieldsOf(found) };
}

/** The fields of a packet; the last is the error of a wrong length. */
function fieldsOf(packet) {
    const shown = [];
    try {
        for (const raw of packet.fields()) shown.push(decoded(raw));
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        shown.push({ error: error.kind });
    }
    const listed = registry.decode(packet);
    if (listed.length !== shown.filter(({ descriptor }) => descriptor !== undefined).length) throw new Error("fields are missing");
    if (listed.some(({ set }) => set !== packet.set)) throw new Error("a field has another set");
    return shown;
}

function decoded({ set, descriptor, data }) {
    const kind = registry.typeOf(set, descriptor, data);
    if (!kind) return { descriptor, raw: toHex(data) };
    try {
        const reader = new Reader(data, { plain: true, floatBits: true });
        const values = renamed(kind, kind.layout.decode(reader, 0, data.length, set));
        const { field, trailing } = kind.decodeWithTrailing(data);
        const again = field.encode();
        if (trailing !== reader.left || toHex(again) !== toHex(data.subarray(0, again.length)) || again.length + trailing !== data.length)
            throw new Error(`${kind.NAME} is not the same again: ${toHex(data)} ${toHex(again)}`);
        return { descriptor, name: nameOf(kind, set), role: kind.ROLE, values, trailing };
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return { descriptor, error: error.kind, raw: toHex(data) };
    }
}

function encode({ set, fields }) {
    check(Number.isInteger(set) && set >= 0 && set < 256 && Array.isArray(fields));
    Packet.build(set, []); // of several mistakes, the first one is reported
    const parts = fields.map(({ descriptor, name, raw, values }) => {
        check(Number.isInteger(descriptor) && descriptor >= 0 && descriptor < 256);
        check(typeof raw === "string" || (typeof values === "object" && values !== null));
        return { descriptor, data: raw === undefined ? dataOf(kindOf(set, descriptor, name), values) : bytesOf(raw) };
    });
    return { packet: toHex(Packet.build(set, parts).bytes) };
}

function kindOf(set, descriptor, name) {
    const kind = registry.types(set, descriptor).find((one) => nameOf(one, set) === name);
    if (!kind) throw new MipError("unknown", name);
    return kind;
}

function dataOf(kind, values) {
    const required = kind.layout.required(Number(values.function));
    return encoded(kind.layout, kind.NAME, renamed(kind, values, true), { plain: true, required });
}

// ---------------------------------------------------------------------------------------------------- the client

function client({ steps }) {
    check(Array.isArray(steps));
    return { events: new Session().play(steps) };
}

/** A client, what it has sent, and what has happened. */
class Session {
    client = new Client();
    now = 0; // milliseconds
    sent = [];
    events = [];

    play(steps) {
        for (const step of steps) {
            check(["send", "receive", "time", "end"].includes(step?.step));
            this[step.step](step);
        }
        return this.events;
    }

    happens(event, what) {
        this.events.push({ event, ...what });
    }

    send({ set, fields }) {
        check(Number.isInteger(set) && set > 0 && set < 256 && Array.isArray(fields) && fields.length > 0);
        let commands;
        let bytes;
        try {
            commands = [];
            for (const entry of fields) {
                commands.push(commandOf(set, entry));
                packetOf(commands, set); // of several mistakes, the first one is reported
            }
            bytes = this.client.send(commands, this.now / 1000);
        } catch (error) {
            if (!(error instanceof MipError)) throw error;
            this.happens("not_sent", { error: error.kind });
            return;
        }
        const numbers = commands.map((command) => this.sent.push(command) - 1);
        this.happens("sent", { packet: toHex(bytes), commands: numbers });
        const { pending } = this.client;
        for (const number of numbers) if (!pending.includes(this.sent[number])) this.happens("silent", { command: number });
    }

    receive({ bytes, chunk }) {
        const data = bytesOf(bytes);
        check(chunk === undefined || (Number.isInteger(chunk) && chunk > 0));
        const size = chunk ?? (data.length || 1);
        for (let at = 0; at < data.length; at += size) this.show(this.client.receive(data.subarray(at, at + size), this.now / 1000));
    }

    time({ milliseconds }) {
        check(Number.isInteger(milliseconds) && milliseconds >= 0);
        this.now += milliseconds;
        this.show(this.client.poll(this.now / 1000));
    }

    end() {
        this.show(this.client.flush(this.now / 1000));
        const waiting = this.client.pending.map((command) => this.sent.indexOf(command));
        this.happens("end", { waiting, skipped: this.client.skipped });
    }

    show(events) {
        for (const event of events) {
            const command = this.sent.indexOf(event.command);
            if (event.type === "timedOut") this.happens("timed_out", { command });
            else if (event.type === "answer") this.answer(command, event);
            else {
                const fields = event.fields.map(decoded);
                if (event.error) fields.push({ error: event.error.kind });
                this.happens("received", { set: event.packet.set, fields });
            }
        }
    }

    answer(command, { accepted, code, error, raw }) {
        if (!accepted) this.happens("refused", { command, code });
        else if (error && !raw) this.happens(error.kind, { command });
        else if (!raw) this.happens("acknowledged", { command });
        else this.happens(error ? "undecodable" : "acknowledged", { command, response: decoded(raw) });
    }
}

/** A command from values with the names of the specification: its object is made from its bytes. */
function commandOf(set, { descriptor, name, values }) {
    check(typeof values === "object" && values !== null);
    const kind = registry.types(set, descriptor).find((one) => one.prototype instanceof Command && one.NAME === name);
    if (!kind) throw new MipError("unknown", name);
    return kind.decode(dataOf(kind, values));
}

// ---------------------------------------------------------------------------------------------------- requests

function answer(line) {
    try {
        const request = fromJson(line);
        const operation = { parse, decode, encode, client }[request?.op];
        check(operation);
        return operation(request);
    } catch (error) {
        if (error instanceof MipError) return { error: error.kind };
        if (error instanceof BadRequest || error instanceof SyntaxError) return { error: "request" };
        throw error;
    }
}
// JSON with integers of any size, and without characters that could end a line.
const STRING_OR_NUMBER = /"(?:[^"\\]|\\.)*"|-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?/g;

function fromJson(text) {
    const marked = text.replace(STRING_OR_NUMBER, (token) => (/^-?\d{16,}$/.test(token) ? `{"integer":"${token}"}` : token));
    return JSON.parse(marked, (_, value) => (typeof value?.integer === "string" ? BigInt(value.integer) : value));
}

const string = (text) => JSON.stringify(text).replace(/[\x7f-\uffff]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, "0")}`);

function toJson(value) {
    if (Array.isArray(value)) return `[${value.map(toJson).join(",")}]`;
    if (value && typeof value === "object") {
        return `{${Object.entries(value)
            .map(([key, inner]) => `${string(key)}:${toJson(inner)}`)
            .join(",")}}`;
    }
    return typeof value === "string" ? string(value) : String(value);
}

const lines = readline.createInterface({ input: process.stdin, crlfDelay: Infinity });
for await (const line of lines) process.stdout.write(`${toJson(answer(line))}\n`);
