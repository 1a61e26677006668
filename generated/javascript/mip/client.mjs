// The command client, without input or output: the caller transfers the bytes and provides the time, in seconds by any
// clock that does not jump.

import { BARRIER } from "../protocol.mjs";
import { concatenated, MipError } from "./bytes.mjs";
import { Command, packetOf } from "./field.mjs";
import { FIRST_DATA_SET, Packet } from "./packet.mjs";
import { Parser } from "./parser.mjs";

/** Descriptor of the acknowledge in every command set; its data is the command's descriptor and a code. */
const ACKNOWLEDGE = 0xf1;

/** The number of different barriers. They have 2 to 63 commands, so that the replies to one fit into one packet. */
const BARRIERS = 62;

/** Throws a MipError if this is not a valid number of seconds to wait. */
export function checkSeconds(timeout) {
    if (!(typeof timeout === "number" && timeout >= 0)) {
        throw new MipError("timeout", `timeout ${String(timeout)}: must be a number of seconds, 0 or more`);
    }
}

/**
 * Matches replies to the commands that wait for them. Data between replies is passed through.
 *
 * The reply to a command that has timed out may still arrive, and nothing in MIP distinguishes it from the reply to the
 * next such command. `send` therefore first sends a barrier: a packet of several commands that change nothing. The device
 * replies in order, and to all commands of a packet in one packet, whose size identifies the barrier. Before the reply to
 * the barrier, no reply is matched to a command sent after it; after that, none is matched to a command sent before it,
 * which has timed out. If the barrier is not answered, the commands after it time out, although the device may have
 * carried them out.
 */
export class Client {
    #parser;
    #timeout;
    #waiting = []; // each with `behind`: the size of a barrier that must be answered first; 0: none
    #missed = 0; // commands without a reply since the last answered barrier
    #behind = 0; // the size of the last barrier, until it is answered

    constructor({ timeout = 1, onSkipped } = {}) {
        checkSeconds(timeout);
        this.#timeout = timeout;
        this.#parser = new Parser({ onSkipped });
    }

    get pending() {
        return this.#waiting.map(({ command }) => command);
    }

    get skipped() {
        return this.#parser.skipped;
    }

    get deadline() {
        return this.#waiting.length ? Math.min(...this.#waiting.map(({ deadline }) => deadline)) : undefined;
    }

    send(commands, now, { timeout, wait = true } = {}) {
        if (timeout !== undefined) checkSeconds(timeout);
        if (commands.length === 0) throw new MipError("missing", "send needs at least one command");
        if (!commands.every((one) => one instanceof Command)) throw new MipError("set", "only commands can be sent");
        const { bytes } = packetOf(commands);
        const answered = commands.filter((one) => one.answered);
        if (!wait) {
            this.#miss(answered.length);
            return bytes;
        }
        const barrier = this.#barrier();
        for (const command of answered) {
            const seconds = timeout ?? Math.max(this.#timeout, command.constructor.TIMEOUT ?? 0);
            this.#waiting.push({ command, wanted: command.replies, deadline: now + seconds, behind: this.#behind });
        }
        return concatenated(barrier, bytes);
    }

    #barrier() {
        const [set, descriptor] = BARRIER;
        if (!set || !this.#missed || this.#behind === this.#missed + 1) return [];
        this.#miss(this.#waiting.length); // they may be the same commands as in a barrier
        this.#behind = this.#missed + 1;
        return Packet.build(set, Array(this.#behind).fill({ descriptor, data: [] })).bytes;
    }

    #miss(count) {
        if (count) this.#missed = ((this.#missed + count - 1) % BARRIERS) + 1;
    }

    /** Returns the time-outs of all commands sent before the last barrier, if this packet answers it, with any codes. */
    #passed({ set, payload }) {
        const [number, descriptor] = BARRIER;
        const size = this.#behind;
        if (!size || set !== number || payload.length !== 4 * size) return undefined;
        const acknowledge = [4, ACKNOWLEDGE, descriptor];
        if (!payload.every((byte, i) => i % 4 === 3 || byte === acknowledge[i % 4])) return undefined;
        const before = this.#waiting.filter(({ behind }) => behind !== size);
        this.#waiting = this.#waiting.filter(({ behind }) => behind === size);
        for (const one of this.#waiting) one.behind = 0;
        if (size === this.#missed + 1) this.#missed = 0;
        this.#behind = 0;
        return before.map(timedOut);
    }

    receive(bytes, now) {
        return [...this.#events(this.#parser.feed(bytes)), ...this.poll(now)];
    }

    flush(now) {
        return [...this.#events(this.#parser.flush()), ...this.poll(now)];
    }

    lookBehind(now) {
        const events = [];
        for (let packets = this.#parser.lookBehind(); packets.length; packets = this.#parser.lookBehind()) {
            events.push(...this.#events(packets));
        }
        return [...events, ...this.poll(now)];
    }

    cancel(command, { silent = false } = {}) {
        const left = this.#waiting.filter((one) => one.command !== command);
        if (!silent) this.#miss(this.#waiting.length - left.length);
        this.#waiting = left;
    }

    interrupt() {
        const events = this.#events(this.#parser.flush());
        const given = this.#waiting.map(timedOut);
        this.#miss(given.length);
        this.#waiting = [];
        return [...events, ...given];
    }

    /**
     * Returns the commands that have timed out, and other events. Noise that looks like the beginning of a long packet
     * delays the packets after it; before a command times out, they are processed. An incomplete packet is kept.
     */
    poll(now) {
        const events = [];
        const late = ({ deadline }) => deadline <= now;
        while (this.#waiting.some(late)) {
            const packets = this.#parser.lookBehind();
            if (packets.length === 0) break;
            events.push(...this.#events(packets));
        }
        const given = this.#waiting.filter(late).map(timedOut);
        this.#waiting = this.#waiting.filter((one) => !late(one));
        this.#miss(given.length);
        return [...events, ...given];
    }

    #events(packets) {
        return packets.flatMap((packet) => this.#taken(packet));
    }

    /** Returns the answers in a packet, and the packet itself if it contains other fields. */
    #taken(packet) {
        const passed = this.#passed(packet);
        if (passed) return passed;
        const fields = [];
        const { set } = packet;
        const wrong = packet.walk((at, end) => {
            fields.push(packet.raw(at, end));
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
     * Returns the answer that an acknowledge and the field after it contain, for the oldest command that they match. A
     * response is never matched to a command that does not request one, because it may be the late reply to another
     * command. An acknowledge without a response is matched first to commands that request none.
     */
    #answer({ set, data }, behind) {
        if (data.length < 2) return undefined;
        const [descriptor, code] = data;
        const asked = this.#waiting.filter(
            ({ command: { constructor: kind }, behind: barrier }) => !barrier && kind.SET === set && kind.DESCRIPTOR === descriptor,
        );
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

const timedOut = ({ command }) => ({ type: "timedOut", command });

/** Returns the response in a field, if it is one of those requested, or the error if it cannot be decoded. */
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
