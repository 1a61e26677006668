// The live view: a device at a serial port or shared by `mip serve`, with its data and commands.

import { registry } from "mip-protocol/registry";
import { rejections } from "mip-protocol/rejected";
import { openSerial } from "mip-protocol/serial";
import { buildPacket, deviceWithNumber, MipError } from "mip-protocol/tools";
import { openWebSocket } from "mip-protocol/websocket";
import { State } from "./address.mjs";
import { builder } from "./builder.mjs";
import { count, deviceOf, element, links, profileNote } from "./dom.mjs";
import { colourOf, drawAttitude, drawPlot, drawTrack, fixed } from "./draw.mjs";
import { inspectBytes, inspectData } from "./inspect.mjs";
import { transaction } from "./inspector.mjs";
import { anglesOf, Readings } from "./readings.mjs";
import { needOf, needText } from "./stream.mjs";
import { presetOf, streamChooser } from "./streams.mjs";
import { flagText, hexByte } from "./words.mjs";

/** Milliseconds between two updates of the numbers. */
const TURN = 200;

/** Milliseconds between two pictures. */
const FRAME = 30;

/** Fields that are plotted from the start, if they can be. */
const PLOTS = 4;

/** Decimals of values by their unit: a float of four bytes has fewer, and other units have six significant digits. */
const DECIMALS = { deg: 8, rad: 5, "rad/s": 5, g: 5, "m/s^2": 4, gauss: 5, m: 3, "m/s": 3, s: 6, mbar: 2, degC: 2 };

const SERIAL =
    (globalThis.isSecureContext
        ? "This browser has no Web Serial, so it cannot open a serial port; Chrome, Edge and Opera on a computer can. "
        : "Browsers open serial ports only for pages from https://, from localhost or from disk. ") +
    "Run mip serve PORT and connect to the address that it prints.";

const LIMITS = [
    "Serial ports need Web Serial, which Chrome, Edge and Opera on a computer have. Other browsers connect to mip serve.",
    "A page cannot open TCP ports; mip serve HOST:PORT can.",
    "A recording is kept by the browser until you stop it, and then saved as a file. For hours of data, use mip record.",
    "In a hidden tab, data is still received and recorded, but plots are not updated.",
    "Baud rates, protocols of ports and the communication mode are not restored from a file, because the connection may end. " +
        "mip config push can do that with the same file.",
    "On a page from https://, Safari does not connect to mip serve; open the workbench from disk instead.",
];

/** Fills an element with the tool. `options` are those of `links`, and `start`, the fragment of an address. */
export function live(root, protocol, options = {}) {
    new Live(root, protocol, { ...options, target: "_blank" }); // another page in this tab would end the connection
}

class Live {
    #protocol;
    #to;
    #state;
    #parts;
    #device;
    #open; // opens the same port again
    #readings;
    #recording;
    #streaming = false;
    #shown = new Map(); // key of a field -> the elements that show it
    #chooser;
    #builder;

    constructor(root, protocol, options) {
        this.#protocol = protocol;
        this.#to = links(options);
        this.#state = options.state ?? new State(options.start, options.device);
        this.#readings = new Readings(protocol);
        this.#layOut(root, options);
    }

    // ------------------------------------------------------------------------------------------------ the page

    #layOut(root, options) {
        const button = (words, onclick, more = {}) =>
            element("button", { type: "button", onclick: () => onclick.call(this), ...more }, words);
        const state = this.#state;
        const serve = element("input", {
            type: "url",
            id: "mip-serve",
            value: state.get("serve"),
            placeholder: "ws://127.0.0.1:5766/…",
            spellcheck: "false",
            autocomplete: "off",
        });
        const baud = element(
            "select",
            { id: "mip-baud" },
            element("option", { value: "" }, "detect the baud rate"),
            ratesOf(portsOf(this.#protocol)).map((rate) => element("option", { value: rate }, `${rate} Bd`)),
        );
        const parts = {
            serve,
            baud,
            serial: button("Open a serial port …", this.#openPort, { class: "mip-main", disabled: !navigator.serial }),
            open: element("button", "Connect"),
            status: element("p.mip-status", { role: "status" }, "Not connected."),
            actions: element("p.mip-actions"),
            identity: element("div"),
            connected: element("div", { hidden: true }),
            preset: element("input", { type: "checkbox", id: "mip-preset", checked: true }),
            start: button("Start", this.#start, { class: "mip-main" }),
            stop: button("Stop", this.#stop),
            need: element("span.mip-need"),
            outcome: element("p", { role: "status" }),
            data: element("div.mip-each"),
            attitude: element("canvas.mip-attitude", { role: "img", "aria-label": "Attitude" }),
            angles: element("p.mip-angles"),
            picture: element("section.mip-reading", { hidden: true }),
            counts: element("p.mip-note"),
            record: button("Record", this.#record),
            recorded: element("span", { role: "status" }),
        };
        parts.picture.append(element("h3", "Attitude"), parts.attitude, parts.angles);
        this.#parts = parts;
        this.#chooser = streamChooser(this.#protocol, state, this.#to, () => this.#tellNeed());
        const commands = element("div");
        const connect = element(
            "section.mip-connect",
            element("h2", "Connect"),
            element("p", parts.serial, " ", element("label", { for: "mip-baud" }, "at "), baud),
            !navigator.serial && element("p.mip-note", SERIAL),
            element(
                "form",
                {
                    onsubmit: (event) => {
                        event.preventDefault();
                        this.#openServe();
                    },
                },
                element("label", { for: "mip-serve" }, "or the address that mip serve prints "),
                serve,
                " ",
                parts.open,
            ),
            element("p", parts.preset, element("label", { for: "mip-preset" }, " Start inertial data, attitude and position at once")),
            element(
                "details",
                element("summary", "Limits of a browser"),
                element(
                    "ul",
                    LIMITS.map((text) => element("li", text)),
                ),
            ),
        );
        parts.connect = connect;
        parts.streams = folded("Streams", [this.#chooser.root], { open: true });
        parts.connected.append(
            element("div.mip-totals.mip-actions", parts.start, parts.stop, parts.record, parts.need, parts.recorded),
            parts.outcome,
            parts.streams,
            element("section.mip-section", element("h2", "Data"), parts.counts, element("div.mip-readings", parts.picture, parts.data)),
            folded("Commands", [commands]),
        );
        const bar = element("div.mip-bar", parts.status, parts.actions);
        root.replaceChildren(connect, bar, parts.identity, parts.connected);
        this.#builder = builder(commands, this.#protocol, {
            ...options,
            state,
            deviceElsewhere: true,
            send: (packet) => this.#send(packet),
        });
        this.#useDevice(deviceOf(this.#protocol, state.get("device")));
        const timer = setInterval(() => this.#show(), TURN);
        let drawn = 0;
        const frame = (time) => {
            if (!parts.status.isConnected) {
                clearInterval(timer);
                this.#disconnect(); // the tool was replaced
                return;
            }
            if (time - drawn >= FRAME) {
                drawn = time;
                this.#draw();
            }
            requestAnimationFrame(frame);
        };
        requestAnimationFrame(frame);
    }

    #say(...words) {
        this.#parts.status.replaceChildren(...words);
    }

    #useDevice(device) {
        this.#chooser.layOut(device);
        this.#builder.useDevice(device);
    }

    #tellNeed() {
        const problem = this.#chooser?.problem();
        const need = problem || !this.#chooser ? { bytes: 0 } : needOf(this.#chooser.chosen());
        this.#parts.start.disabled = !need.bytes || !this.#device;
        this.#parts.need.textContent = problem
            ? `${problem.field.title} needs ${problem.problem()}.`
            : need.bytes
              ? needText(need)
              : "Choose fields.";
    }

    // ------------------------------------------------------------------------------------------------ connection

    /** Sets the device, and enables the buttons that need one. */
    #use(device) {
        this.#device = device;
        this.#parts.stop.disabled = this.#parts.record.disabled = this.#builder.send.disabled = !device;
        this.#tellNeed();
    }

    async #openPort() {
        let port;
        try {
            port = await navigator.serial.requestPort();
        } catch {
            this.#say("No port was chosen.");
            return;
        }
        const baud = Number(this.#parts.baud.value) || undefined;
        const before = await navigator.serial.getPorts();
        const open = async (more) => {
            port = await present(port, before);
            return openSerial(port, { baud, ...more });
        };
        this.#streaming = false;
        await this.#connect(open, baud ? "" : " It may take some seconds to find the baud rate.");
    }

    async #openServe() {
        const url = this.#parts.serve.value.trim();
        if (!/^wss?:\/\/\S+$/.test(url)) {
            this.#say("An address begins with ws://, as mip serve prints it.");
            return;
        }
        this.#state.set({ serve: url });
        this.#streaming = false;
        await this.#connect((more) => openWebSocket(url, more));
    }

    /** Connects, one attempt at a time: a second one would leave the port of the first open. */
    async #connect(open, words = "") {
        const { serial, open: serve } = this.#parts;
        if (serve.disabled) return;
        serial.disabled = serve.disabled = true;
        this.#open = () => this.#connect(open, words);
        this.#say(`Connecting …${words}`);
        let device;
        try {
            await this.#disconnect();
            device = await open({ explain: rejections(this.#protocol.model), onBytes: (bytes) => this.#recording?.add(bytes) });
        } catch (error) {
            this.#say(wrong("Not connected", error));
            this.#offer("Try again");
            return;
        } finally {
            serial.disabled = !navigator.serial;
            serve.disabled = false;
        }
        if (!this.#parts.status.isConnected) return device.close(); // the tool was replaced
        this.#use(device);
        this.#readings = new Readings(this.#protocol);
        this.#shown.clear();
        this.#parts.data.replaceChildren();
        this.#read(device);
        this.#parts.connected.hidden = false;
        this.#parts.connect.hidden = true;
        this.#say("Connected; identifying the device …");
        await this.#identify(device);
    }

    async #identify(device) {
        let known;
        try {
            const response = await device.identify();
            const [part] = inspectBytes(this.#protocol, response.packet().bytes);
            const rows = part.fields[0].rows;
            const told = (name) => rows.find(({ path }) => path.endsWith(name))?.value ?? "";
            known = deviceWithNumber(this.#protocol, told("model_number"));
            this.#parts.identity.replaceChildren(identityList(rows, known), ...[profileNote(known)].filter(Boolean));
            this.#say(element("span.mip-right", `Connected to ${known?.title ?? "a device that is not known here"}.`));
        } catch (error) {
            if (!(error instanceof MipError)) throw error;
            if (device !== this.#device) return; // lost meanwhile
            this.#say(wrong("Connected, but the device was not identified", error));
        }
        if (device !== this.#device) return;
        this.#parts.actions.replaceChildren(element("button", { type: "button", onclick: () => this.#leave() }, "Disconnect"));
        this.#readings.device = known?.id;
        this.#state.set({ device: known?.id ?? "" });
        this.#parts.streams.open = true;
        if (known && this.#parts.preset.checked && !this.#state.get("streams")) {
            this.#state.set({ streams: presetOf(this.#protocol, known) });
            this.#useDevice(known);
            await this.#start();
        } else {
            this.#useDevice(known);
        }
    }

    async #read(device) {
        try {
            for await (const packet of device) this.#readings.take(packet);
        } catch (error) {
            if (device === this.#device) this.#lost(error);
        }
    }

    async #lost(error) {
        this.#say(wrong("The connection is lost", error.cause ?? error));
        await this.#disconnect(); // a serial port that is lost cannot be opened before it is closed
        this.#offer("Connect again");
        this.#parts.connect.hidden = false;
    }

    /** Creates a button that reconnects, and restarts the streams that were on. */
    #offer(words) {
        const again = async () => {
            const streaming = this.#streaming;
            await this.#open();
            if (streaming) await this.#start();
        };
        this.#parts.status.append(" ", element("button", { type: "button", onclick: again }, words));
    }

    async #leave() {
        await this.#stop();
        await this.#disconnect();
        this.#say("Not connected.");
        this.#parts.connect.hidden = false;
        this.#parts.connected.hidden = true;
        this.#parts.identity.replaceChildren();
    }

    async #disconnect() {
        const device = this.#device;
        this.#use(undefined);
        this.#endRecording();
        this.#parts.actions.replaceChildren();
        await device?.close().catch(() => {}); // it may be lost
    }

    // ------------------------------------------------------------------------------------------------ streams

    async #start() {
        const { outcome } = this.#parts;
        const device = this.#device;
        if (!device) return;
        const said = [];
        this.#readings.restart();
        try {
            for (const fields of this.#chooser.chosen().filter((some) => some.length)) {
                const set = fields[0].set.number;
                const rates = fields.map(({ field, rate }) => [registry.types(set, field.descriptor)[0], rate]);
                try {
                    await device.stream(rates, { set });
                } catch (error) {
                    if (error.kind !== "rate" || !error.nearest) throw error;
                    await device.stream([...error.nearest], { set });
                    said.push(`${error.message}; started at the nearest rates.`);
                }
            }
            this.#streaming = true;
            this.#parts.streams.open = false;
            outcome.replaceChildren(said.join(" ") || "Started.");
        } catch (error) {
            if (!(error instanceof MipError)) throw error;
            outcome.replaceChildren(wrong("Not started", error));
        }
    }

    async #stop() {
        if (!this.#device) return;
        try {
            await this.#device.identify(); // sets the device to idle
            this.#parts.outcome.replaceChildren("Stopped: the device is idle.");
        } catch (error) {
            if (!(error instanceof MipError)) throw error;
            this.#parts.outcome.replaceChildren(wrong("Not stopped", error));
        }
        this.#streaming = false;
    }

    // ------------------------------------------------------------------------------------------------ commands

    /**
     * Sends a packet, and returns the outcomes of its commands in the form of `inspect`: { command, answer, response,
     * error }.
     */
    async #exchange(packet) {
        const inspected = (bytes) => inspectBytes(this.#protocol, bytes, this.#readings.device)[0].fields;
        const sent = inspected(packet.bytes);
        const commands = [...packet.fields()].map(({ set, descriptor, data }) => registry.typeOf(set, descriptor, data).decode(data));
        const outcomes = await this.#device.exchange(commands);
        return outcomes.map((outcome, i) => {
            const command = sent[i];
            if (!outcome) return { command, error: "this command is not answered" };
            if (outcome.type !== "answer") return { command, error: outcome.type === "timedOut" ? "no answer" : outcome.message };
            const answered = inspected(acknowledged(this.#protocol, command, outcome.code))[0];
            const response = outcome.response && inspected(outcome.response.packet().bytes)[0];
            return { command, answer: answered, response, error: outcome.error?.message ?? outcome.rejected?.text };
        });
    }

    async #send(packet) {
        try {
            const found = await this.#exchange(packet);
            return found.map((one) =>
                element(
                    "div.mip-transaction",
                    one.answer ? transaction(one, this.#to) : element("p", wrong(one.command.field.title, { message: one.error })),
                    one.answer && one.error && element("p.mip-wrong", `${one.error}.`),
                ),
            );
        } catch (error) {
            if (!(error instanceof MipError)) throw error;
            return [element("p", wrong("Not sent", error))];
        }
    }

    // ------------------------------------------------------------------------------------------------ recording

    #record() {
        if (this.#recording) {
            this.#endRecording();
            return;
        }
        this.#recording = new Recording(this.#readings.device ?? "device");
        addEventListener("beforeunload", ask);
        this.#parts.record.textContent = "Stop and save";
    }

    #endRecording() {
        const recording = this.#recording;
        this.#recording = undefined;
        removeEventListener("beforeunload", ask);
        this.#parts.record.textContent = "Record";
        if (!recording) return;
        this.#parts.recorded.textContent = recording.size ? `${recording.size} bytes saved as ${recording.name}.` : "Nothing was received.";
        if (recording.size) download(recording.blob, recording.name);
    }

    // ------------------------------------------------------------------------------------------------ data

    /** Updates the numbers, several times per second. */
    #show() {
        if (!this.#device) return;
        const now = Date.now() / 1000;
        const { skipped, dropped } = this.#device;
        const { packets, lost } = this.#readings;
        const missing = lost && `${count(lost, "sample")} missing by the clock of the device`;
        const parts = [count(packets, "packet"), missing, skipped && `${skipped} bytes outside packets`, dropped && `${dropped} dropped`];
        this.#parts.counts.textContent = packets ? parts.filter(Boolean).join(", ") : "Nothing has arrived yet.";
        if (this.#recording) this.#parts.recorded.textContent = `${this.#recording.size} bytes`;
        for (const [key, reading] of this.#readings.fields) {
            let shown = this.#shown.get(key);
            if (!shown) {
                shown = this.#begin(reading);
                this.#shown.set(key, shown);
            }
            shown.update(now);
        }
    }

    #begin(reading) {
        const title = reading.field ? this.#to.field(reading.field) : `Unknown descriptor ${reading.descriptor}`;
        const rate = element("span.mip-note");
        const set = this.#protocol.sets.get(reading.set)?.title ?? hexByte(reading.set);
        const values = element("dl.mip-values");
        const plots = element("div.mip-plots", { hidden: true });
        const box = element("input", { type: "checkbox" });
        const plotted = [...this.#shown.values()].filter(({ reading: one }) => one.plotted).length;
        const choose = (on) => {
            box.checked = on;
            reading.plotted = on;
            plots.hidden = !on;
        };
        box.addEventListener("input", () => choose(box.checked));
        const isTime = this.#protocol.model.clocks.some(({ timestamps }) => timestamps.includes(reading.name ?? ""));
        if (reading.plottable) choose(plotted < PLOTS && !isTime);
        const root = element(
            "section",
            { class: `mip-reading${isTime ? " mip-last" : ""}`, "data-field": reading.name ?? "" },
            element("div.mip-bar", element("h3", title, " ", rate), reading.plottable && element("label.mip-note", box, " plot")),
            values,
            plots,
        );
        this.#parts.data.append(root);
        let cells = [];
        const update = (now) => {
            const late = reading.isLate(now);
            rate.textContent = `${set}, ${late ? "no longer sent" : `${Number(reading.rate(now).toPrecision(3))} Hz`}`;
            root.classList.toggle("mip-late", late);
            const rows = inspectData(this.#protocol, reading, reading.device);
            if (rows.length !== cells.length) {
                const made = rows.map(({ path }) => [element("dt", path), element("dd")]);
                values.replaceChildren(...made.flat());
                cells = made.map(([dt, dd]) => ({ dt, dd }));
            }
            for (const [i, row] of rows.entries()) {
                const { dt, dd } = cells[i];
                const line = plots.hidden ? undefined : reading.series.get(row.key);
                dt.style.setProperty("--mip-own", line ? colourOf(line) : "transparent");
                dt.textContent = row.path;
                dd.textContent = valueText(row);
            }
        };
        return { reading, plots, update };
    }

    /** Draws the pictures once per screen frame. */
    #draw() {
        const now = Date.now() / 1000;
        let attitude;
        for (const { reading, plots } of this.#shown.values()) {
            for (const [i, plot] of (reading.plotted ? reading.plots : []).entries()) {
                const what = plot.track ? "Track" : `Plot of ${reading.field.title} in ${plot.unit}`;
                const canvas = plots.children[i] ?? element("canvas.mip-plot", { role: "img" });
                if (!canvas.isConnected) plots.append(canvas);
                canvas.setAttribute("aria-label", what);
                if (plot.track) drawTrack(canvas, plot);
                else drawPlot(canvas, plot, reading.timeAt(now), reading.dated);
            }
            attitude ??= reading.isLate(now) ? undefined : reading.rotation;
        }
        this.#parts.picture.hidden = !attitude;
        if (!attitude) return;
        drawAttitude(this.#parts.attitude, attitude);
        const [roll, pitch, yaw] = anglesOf(attitude).map((angle) => Math.round(angle * 10) / 10);
        const text = `Roll ${fixed(roll, 1)}°, pitch ${fixed(pitch, 1)}°, heading ${fixed((yaw + 360) % 360, 1)}°`;
        this.#parts.angles.textContent = text;
        this.#parts.attitude.setAttribute("aria-label", `Attitude: ${text}`);
    }
}

/** Makes the browser ask before it leaves the page. */
function ask(event) {
    event.preventDefault();
}

/** Describes an error; the messages of browsers end with a period. */
function wrong(words, { message }) {
    return element("span.mip-wrong", `${words}: ${message.replace(/\.$/, "")}.`);
}

/** Returns a port, or the one that has replaced it, as its device was plugged in again: one that was not there `before`. */
async function present(port, before) {
    const ports = await navigator.serial.getPorts();
    const kind = (one) => JSON.stringify(one.getInfo());
    const others = ports.filter((one) => !before.includes(one) && kind(one) === kind(port));
    return ports.includes(port) || others.length !== 1 ? port : others[0];
}

/** Creates a collapsible part of the page. */
function folded(title, children, attributes = {}) {
    return element("details.mip-section", { ...attributes }, element("summary", element("h2", title)), children);
}

function portsOf(protocol) {
    return protocol.model.devices.flatMap((device) => device.ports ?? []);
}

function ratesOf(ports) {
    return [...new Set(ports.flatMap((port) => port.baud_rates))].sort((a, b) => a - b);
}

function identityList(rows, known) {
    const items = rows.map(({ path, text, meaning }) => {
        const name = path.split(".").at(-1).replaceAll("_", " ");
        const said = text.replace(/^"\s*|\s*"$/g, "");
        return said && element("div", element("dt", name), element("dd", said, meaning && ` (${meaning})`));
    });
    return element("dl.mip-identity", { "data-device": known?.id ?? "" }, items.filter(Boolean));
}

function acknowledged(protocol, command, code) {
    const [first, second] = protocol.acknowledge.operations.map((op) => op.member);
    const values = { [first]: command.descriptor, [second]: code };
    return buildPacket(protocol, command.set, [{ name: protocol.acknowledge.name, values }]).bytes;
}

function valueText({ text, value, unit, name, flags, float, bytes }) {
    const said = flags ? flags.map(flagText).join(", ") || "none set" : name;
    const short = float && Number.isFinite(value) ? floatText(value, unit, bytes.length) : text;
    return [said ?? short, !said && unit].filter(Boolean).join(" ");
}

function floatText(value, unit, size) {
    const decimals = DECIMALS[unit];
    if (decimals === undefined) return value.toPrecision(6);
    const before = Math.max(1, Math.floor(Math.log10(Math.abs(value) || 1)) + 1);
    return value.toFixed(size === 4 ? Math.max(0, Math.min(decimals, 7 - before)) : decimals);
}

/** Records bytes in the browser, which stores them on disk if there are many. */
class Recording {
    #parts = [];
    #kept = new Blob([]);
    size = 0;

    constructor(device) {
        const time = new Date().toISOString().slice(0, 19).replaceAll(":", "");
        this.name = `${device}-${time}.bin`;
    }

    add(bytes) {
        this.#parts.push(bytes.slice());
        this.size += bytes.length;
        if (this.#parts.length > 1000) this.#kept = this.blob;
    }

    get blob() {
        const whole = new Blob([this.#kept, ...this.#parts]);
        this.#kept = whole;
        this.#parts = [];
        return whole;
    }
}

function download(blob, name) {
    const link = element("a", { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
