// The command client, without input or output: its caller transfers the bytes and states the time, in seconds of any
// clock that does not jump.

import { BARRIER } from "../protocol.mjs";
import { concatenated, MipError } from "./bytes.mjs";
import { Command, packetOf } from "./field.mjs";
import { FIRST_DATA_SET, Packet, RawField } from "./packet.mjs";
import { Parser } from "./parser.mjs";

/** Descriptor of the acknowledge in every command set; its data is the descriptor of the command, and a code. */
const ACKNOWLEDGE = 0xf1;

/** The number of barriers. They have 2 to 63 commands: the answer to each is one packet. */
const BARRIERS = 62;

/** Raises a MipError if this is not a time to wait. */
export function checkSeconds(timeout) {
    if (!(typeof timeout === "number" && timeout >= 0)) {
        throw new MipError("timeout", `timeout ${String(timeout)}: needs a number of seconds, 0 or more`);
    }
}

/**
 * Follows the commands that wait for an answer. Data between the answers is passed through.
 *
 * After a command without an answer, its answer may still arrive, and MIP has no mark that distinguishes it from that of
 * the next such command. `send` then begins with a barrier: a packet of several commands that change nothing. The device
 * answers in order, and the commands of one packet in one packet, whose size identifies the barrier. Until then, no answer
 * belongs to the commands after it, and from then on, none to those before it, which have timed out. A command whose
 * barrier is not answered times out, although the device may have carried it out.
 */
export class Client {
    #parser;
    #timeout;
    #waiting = []; // each with `behind`: the size of a barrier that must be answered first; 0: none
    #missed = 0; // commands without an answer, since a barrier was answered
    #behind = 0; // the size of the last barrier, until it is answered

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

    /** The number of received bytes that are part of no packet. */
    get skipped() {
        return this.#parser.skipped;
    }

    /** The time at which the next command times out; undefined if none waits. */
    get deadline() {
        return this.#waiting.length ? Math.min(...this.#waiting.map(({ deadline }) => deadline)) : undefined;
    }

    /**
     * The bytes to send: one packet with these commands, all of one set, behind a barrier if an earlier command was not
     * answered. Raises a MipError, and waits for no answer, if they do not fit into one packet.
     *
     * @param options.timeout seconds for these commands, in place of their usual time-outs
     * @param options.wait false if answers are not expected, and are events like data
     */
    send(commands, now, { timeout, wait = true } = {}) {
        if (timeout !== undefined) checkSeconds(timeout);
        if (commands.length === 0) throw new MipError("missing", "send needs at least one command");
        if (!commands.every((one) => one instanceof Command)) throw new MipError("set", "only commands are sent");
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
        this.#miss(this.#waiting.length); // they may be commands as in a barrier
        this.#behind = this.#missed + 1;
        return Packet.build(set, Array(this.#behind).fill({ descriptor, data: [] })).bytes;
    }

    #miss(count) {
        if (count) this.#missed = ((this.#missed + count - 1) % BARRIERS) + 1;
    }

    /** If the packet answers the last barrier, with any codes: the time-outs of all that was sent before it. */
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

    /** The events of these bytes and this time: answers, other packets, time-outs. */
    receive(bytes, now) {
        return [...this.#events(this.#parser.feed(bytes)), ...this.poll(now)];
    }

    /** Gives up an incomplete packet, for example at the end of a file, and searches after its beginning. */
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

    /**
     * Stops waiting for this command. A late answer to it does not answer another one.
     *
     * @param options.silent the device does not answer it
     */
    cancel(command, { silent = false } = {}) {
        const left = this.#waiting.filter((one) => one.command !== command);
        if (!silent) this.#miss(this.#waiting.length - left.length);
        this.#waiting = left;
    }

    /**
     * The connection was lost: gives up an incomplete packet, and the commands that wait time out. Replies that still arrive
     * over the next connection are not taken for answers to later commands.
     */
    interrupt() {
        const events = this.#events(this.#parser.flush());
        const given = this.#waiting.map(timedOut);
        this.#miss(given.length);
        this.#waiting = [];
        return [...events, ...given];
    }

    /**
     * The commands that have timed out. Noise that looks like the beginning of a long packet holds back what follows:
     * before a command is given up, the packets after such noise are processed. An incomplete packet is kept.
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

    /** The answers in a packet, and the packet itself if it has other fields. */
    #taken(packet) {
        const passed = this.#passed(packet);
        if (passed) return passed;
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
     * The answer by an acknowledge and the field after it, to the oldest such command. A response never answers a command
     * that does not ask for it, because it may be the late answer to another one; an acknowledge without a response first
     * answers commands that ask for none.
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

/** The response in a field, if it is one of those that are requested; or the reason why it cannot be decoded. */
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
