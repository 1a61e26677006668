// The command client, without input or output: its caller transfers the bytes and tells the time, in seconds of any
// clock that does not jump.

import { MipError } from "./bytes.mjs";
import { Command, packetOf } from "./field.mjs";
import { FIRST_DATA_SET, RawField } from "./packet.mjs";
import { Parser } from "./parser.mjs";

/** Descriptor of the acknowledge in every command set; its data are the descriptor of the command, and a code. */
const ACKNOWLEDGE = 0xf1;

/** Raises a MipError if this is not a time to wait. */
export function checkSeconds(timeout) {
    if (!(typeof timeout === "number" && timeout >= 0)) {
        throw new MipError("timeout", `timeout ${String(timeout)}: needs a number of seconds, 0 or more`);
    }
}

/** Follows the commands that wait for an answer. Data between the answers is passed through. */
export class Client {
    #parser;
    #timeout;
    #waiting = [];

    /** @param options.timeout seconds until a command times out; longer for commands that take longer */
    constructor({ timeout = 1, onSkipped } = {}) {
        checkSeconds(timeout);
        this.#timeout = timeout;
        this.#parser = new Parser({ onSkipped });
    }

    /** The commands that wait for an answer, the oldest first. */
    get pending() {
        return this.#waiting.map(({ command }) => command);
    }

    /** How many bytes were received that are part of no packet. */
    get skipped() {
        return this.#parser.skipped;
    }

    /** When the next command times out; undefined if none waits. */
    get deadline() {
        return this.#waiting.length ? Math.min(...this.#waiting.map(({ deadline }) => deadline)) : undefined;
    }

    /**
     * The bytes to send: one packet with these commands, all of one set. Raises a MipError, and waits for no answer, if
     * they do not fit into one.
     *
     * @param options.timeout seconds for these commands, in place of their usual time-outs
     */
    send(commands, now, { timeout } = {}) {
        if (timeout !== undefined) checkSeconds(timeout);
        if (commands.length === 0) throw new MipError("missing", "send needs at least one command");
        if (!commands.every((one) => one instanceof Command)) throw new MipError("set", "only commands are sent");
        const { bytes } = packetOf(commands);
        for (const command of commands) {
            if (!command.answered) continue;
            const seconds = timeout ?? Math.max(this.#timeout, command.constructor.TIMEOUT ?? 0);
            this.#waiting.push({ command, wanted: command.replies, deadline: now + seconds });
        }
        return bytes;
    }

    /** The events of these bytes and this time: answers, other packets, time-outs. */
    receive(bytes, now) {
        return [...this.#events(this.#parser.feed(bytes)), ...this.poll(now)];
    }

    /** Gives up an incomplete packet, for example at the end of a file, and searches behind its beginning. */
    flush(now) {
        return [...this.#events(this.#parser.flush()), ...this.poll(now)];
    }

    /**
     * Gives up an incomplete packet only if whole packets follow its first bytes: it was noise. Call it when no bytes have
     * arrived for a while. A packet that arrives slowly is kept.
     */
    lookBehind(now) {
        const events = [];
        for (let packets = this.#parser.lookBehind(); packets.length; packets = this.#parser.lookBehind()) {
            events.push(...this.#events(packets));
        }
        return [...events, ...this.poll(now)];
    }

    /** Waits for this command no longer. */
    cancel(command) {
        this.#waiting = this.#waiting.filter((one) => one.command !== command);
    }

    /**
     * The commands that have timed out. Noise that looks like the beginning of a long packet holds back what follows:
     * before a command is given up, the packets behind such noise are taken. An incomplete packet is kept.
     */
    poll(now) {
        const events = [];
        const late = ({ deadline }) => deadline <= now;
        while (this.#waiting.some(late)) {
            const packets = this.#parser.lookBehind();
            if (packets.length === 0) break;
            events.push(...this.#events(packets));
        }
        const given = this.#waiting.filter(late).map(({ command }) => ({ type: "timedOut", command }));
        this.#waiting = this.#waiting.filter((one) => !late(one));
        return [...events, ...given];
    }

    #events(packets) {
        return packets.flatMap((packet) => this.#taken(packet));
    }

    /** The answers in a packet, and the packet itself if it has other fields. */
    #taken(packet) {
        const fields = [];
        const { bytes, set } = packet;
        const wrong = packet.walk((at, end) => {
            fields.push(new RawField(set, bytes[at + 1], bytes.subarray(at + 2, end), at));
        });
        if (set >= FIRST_DATA_SET || this.#waiting.length === 0) return [{ type: "received", packet, fields, error: wrong }];
        const answers = [];
        const others = [];
        for (let i = 0; i < fields.length; i++) {
            const answer = fields[i].descriptor === ACKNOWLEDGE ? this.#answer(fields[i], fields[i + 1]) : undefined;
            if (!answer) {
                others.push(fields[i]);
                continue;
            }
            answers.push(answer);
            if (answer.raw) i++;
        }
        if (answers.length && others.length === 0 && !wrong) return answers;
        return [...answers, { type: "received", packet, fields: others, error: wrong }];
    }

    /**
     * The answer by an acknowledge and the field behind it, to the oldest such command. A response never answers a command
     * that does not ask for it, because it may be the late answer to another one; an acknowledge without a response first
     * answers commands that ask for none.
     */
    #answer({ set, data }, behind) {
        if (data.length < 2) return undefined;
        const [descriptor, code] = data;
        const asked = this.#waiting.filter(({ command: { constructor: kind } }) => kind.SET === set && kind.DESCRIPTOR === descriptor);
        let alone;
        for (const one of asked) {
            if (code !== 0) return this.#done(one, { code });
            const { command, wanted } = one;
            if (!behind || command.constructor.RESPONSES.every((kind) => kind.DESCRIPTOR !== behind.descriptor)) {
                if (wanted.length === 0) return this.#done(one, { code });
                alone ??= one;
                continue;
            }
            const found = responseIn(behind, wanted);
            if (found) return this.#done(one, { code, raw: behind, ...found });
        }
        if (!alone) return undefined;
        const error = new MipError("missing_response", `${alone.command.constructor.NAME}: acknowledged without a response`);
        return this.#done(alone, { code, error });
    }

    #done(one, answer) {
        this.#waiting = this.#waiting.filter((other) => other !== one);
        return { type: "answer", command: one.command, accepted: answer.code === 0, ...answer };
    }
}

/** The response that a field is, if it is one of those that are asked for; or why it cannot be decoded. */
function responseIn({ descriptor, data }, wanted) {
    const kind = wanted.find((one) => one.DESCRIPTOR === descriptor && one.matches(data));
    if (!kind) return undefined;
    try {
        return { response: kind.decode(data) };
    } catch (error) {
        if (!(error instanceof MipError)) throw error;
        return error.kind === "constant" ? undefined : { error }; // a constant: another layout of the descriptor
    }
}
