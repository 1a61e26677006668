// Answers of the modules to each line of standard input, as JSON: answers.mjs GENERATED_FOLDER TOPIC
//
//     json       the name and the data of a field: its data after JSON, its data after a structured clone, and the JSON
//     rejected   a case of tests/rejected.json: the field for which a device rejects the command
//     times      a packet and the id of a device, or `utc` and a GPS time: times and validity, with classes and with the model
import { readFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const load = (name) => import(pathToFileURL(path.resolve(process.argv[2], name)));
const { fromHex, Packet, toHex } = await load("mip/index.mjs");
const { registry } = await load("registry.mjs");
const { Clock, Times } = await load("time.mjs");
const tools = await load("mip/tools.mjs");
const { default: model } = await load("model.mjs");
const protocol = new tools.Protocol(model);
const modelled = tools.clocksIn(protocol);
const clocks = Object.values(Clock);
const [times, modelledTimes] = [new Times(), new tools.Times()];

const named = (all, timeOf) => Object.fromEntries(all.map((clock) => [clock.name, timeOf(clock)]).filter(([, time]) => time !== undefined));

/** The fields up to a malformed one. */
function fieldsOf(packet) {
    const fields = [];
    try {
        for (const raw of packet.fields()) fields.push(raw);
    } catch (error) {
        if (error.name !== "MipError") throw error;
    }
    return fields;
}

function values(packet, device) {
    const found = {};
    for (const raw of fieldsOf(packet)) {
        const kind = registry.typeOf(raw.set, raw.descriptor, raw.data);
        const field = protocol.choose(raw.set, raw.descriptor, raw.data);
        if (kind?.NAME !== field?.name || !kind?.VALID) continue;
        try {
            const [made, { values }] = [kind.decode(raw.data), tools.decodeData(protocol, field, raw.data)];
            for (const { name, length } of field.parameters) {
                const member = tools.memberName(name);
                if (!kind.layout.names.includes(member) || length === "counter") continue;
                const whole = [made.isValid(member, device), tools.isValid(protocol, field, values, name, device)];
                const elements = Array.isArray(made[member]) ? [...made[member].keys()] : [];
                const each = elements.map((i) => [
                    made.isValid(`${member}[${i}]`, device),
                    tools.isValid(protocol, field, values, `${name}[${i}]`, device),
                ]);
                found[`${field.name} ${name}`] = [...whole, ...each.flat()];
            }
        } catch (error) {
            if (error.name !== "MipError") throw error;
        }
    }
    return found;
}

const hexOf = (number) => toHex(Uint8Array.of(number)).toUpperCase();

const topics = {
    json(line) {
        const [name, data = ""] = line.split(" ");
        const kind = registry.field(name);
        const field = kind.decode(fromHex(data));
        const json = JSON.stringify(field);
        return [kind.fromJSON(JSON.parse(json)), new kind(structuredClone(field))].map((one) => toHex(one.encode())).concat(json);
    },

    async rejected(line) {
        const { cause } = await load("mip/rejected.mjs");
        const { command, data, device, descriptors } = JSON.parse(line);
        const [set, descriptor] = fromHex(command);
        const known = { device: model.devices.find((one) => one.id === device) };
        if (descriptors) known.descriptors = new Set(descriptors.split(" ").map((one) => Number.parseInt(one, 16)));
        const found = cause(protocol, { set, descriptor, data: fromHex(data) }, known);
        return found ? [found.index, hexOf(found.set), hexOf(found.descriptor), found.reason, found.text] : null;
    },

    times(line) {
        const [hex, device] = line.split(" ");
        if (hex === "utc") return { classes: Clock.GPS.utc(BigInt(device)), model: modelled[0].utc(BigInt(device)) };
        const packet = new Packet(fromHex(hex));
        return {
            classes: named(clocks, (clock) => packet.time(clock, device)),
            model: named(modelled, (clock) => packet.time(clock, device)),
            log: named(clocks, (clock) => times.time(packet, clock)),
            modelLog: named(modelled, (clock) => modelledTimes.time(packet, clock)),
            valid: values(packet, device),
        };
    },
};

const answers = [];
for (const line of readFileSync(0, "utf8").trimEnd().split("\n")) answers.push(await topics[process.argv[3]](line));
process.stdout.write(JSON.stringify(answers, (_, value) => (typeof value === "bigint" ? `${value}` : value)));
