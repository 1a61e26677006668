// The times of packets and the validity of values, with classes and with the model, as JSON:
//
//     times.mjs GENERATED_FOLDER < packets, one a line: hexadecimal, and the id of a device; or: utc, and a GPS time
import { readFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const load = (name) => import(pathToFileURL(path.resolve(process.argv[2], name)));
const { Packet } = await load("mip/index.mjs");
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

const answers = readFileSync(0, "utf8")
    .trimEnd()
    .split("\n")
    .map((line) => {
        const [hex, device] = line.split(" ");
        if (hex === "utc") return { classes: Clock.GPS.utc(BigInt(device)), model: modelled[0].utc(BigInt(device)) };
        const packet = new Packet(tools.fromHex(hex));
        return {
            classes: named(clocks, (clock) => packet.time(clock, device)),
            model: named(modelled, (clock) => packet.time(clock, device)),
            log: named(clocks, (clock) => times.time(packet, clock)),
            modelLog: named(modelled, (clock) => modelledTimes.time(packet, clock)),
            valid: values(packet, device),
        };
    });
process.stdout.write(JSON.stringify(answers, (_, value) => (typeof value === "bigint" ? `${value}` : value)));
