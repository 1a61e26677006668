// Pictures of live data: plots over time, and the attitude of a vehicle.

import { SPAN } from "./readings.mjs";

/** The CSS colours of a field's values. */
const COLOURS = ["--mip-plot-0", "--mip-plot-1", "--mip-plot-2", "--mip-plot-3", "--mip-plot-4", "--mip-plot-5"];

/** Returns the colour of a series for a style. */
export const colourOf = ({ number }) => `var(${COLOURS[number % COLOURS.length]})`;

// Pictures read them as colours of the scheme, not as the text of the style sheet.
for (const name of [...COLOURS, "--mip-line", "--mip-page", "--mip-body", "--mip-nose"]) {
    globalThis.CSS?.registerProperty({ name, syntax: "<color>", inherits: true, initialValue: "transparent" });
}

/** Clears a canvas and returns its context, scaled to screen pixels; undefined while the canvas is not shown. */
function begin(canvas) {
    const { clientWidth: width, clientHeight: height } = canvas;
    if (!width || !height) return undefined;
    const scale = globalThis.devicePixelRatio || 1;
    if (canvas.width !== Math.round(width * scale)) canvas.width = Math.round(width * scale);
    if (canvas.height !== Math.round(height * scale)) canvas.height = Math.round(height * scale);
    const context = canvas.getContext("2d");
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.clearRect(0, 0, width, height);
    const style = getComputedStyle(canvas);
    const colour = (name) => style.getPropertyValue(name);
    context.font = `12px ${style.fontFamily}`;
    return { context, width, height, colour, text: style.color };
}

/** Draws the last seconds of several series in one unit. `now` is the time of the device; `dated`: it is one of UTC. */
export function drawPlot(canvas, { unit, series }, now, dated) {
    const held = begin(canvas);
    if (!held) return;
    const { context, width, height, colour, text } = held;
    const shown = series.map(({ points }) => points.filter(([time]) => time > now - SPAN));
    const values = shown.flatMap((points) => points.map(([, value]) => value)).filter(Number.isFinite);
    if (!values.length) return;
    const least = values.reduce((a, b) => Math.min(a, b));
    const most = values.reduce((a, b) => Math.max(a, b));
    const room = Math.max(0.05 * (most - least), 0.5e-3 * Math.max(Math.abs(least), Math.abs(most), 1e-3));
    const { ticks, label } = axis(least - room, most + room, 4);
    const [low, high] = [ticks[0], ticks.at(-1)];
    const left = 10 + Math.max(...ticks.map((value) => context.measureText(label(value)).width), 24);
    const [top, bottom, right] = [22, height - 20, width - 8];
    const x = (time) => right - ((now - time) / SPAN) * (right - left);
    const y = (value) => bottom - ((value - low) / (high - low)) * (bottom - top);
    context.strokeStyle = colour("--mip-line");
    context.fillStyle = text;
    context.lineWidth = 1;
    context.textBaseline = "middle";
    context.textAlign = "right";
    for (const value of ticks) {
        line(context, [left, y(value)], [right, y(value)]);
        context.fillText(label(value), left - 6, y(value));
    }
    context.textAlign = "left";
    context.fillText(unit, 4, 8);
    context.textAlign = "center";
    const step = width < 320 ? 5 : 2;
    for (let time = Math.ceil((now - SPAN) / step) * step; time <= now; time += step) {
        line(context, [x(time), bottom], [x(time), bottom + 4]);
        const words = dated ? new Date(1000 * time).toISOString().slice(11, 19) : `${time} s`;
        const half = context.measureText(words).width / 2;
        if (x(time) - half > 0 && x(time) + half < width) context.fillText(words, x(time), height - 7);
    }
    context.lineWidth = 1.75;
    context.lineJoin = "round";
    context.save();
    context.beginPath();
    context.rect(left, 0, right - left, height);
    context.clip();
    for (const [i, points] of shown.entries()) {
        context.strokeStyle = colour(COLOURS[series[i].number % COLOURS.length]);
        line(context, ...thinned(points, width - left).map(([time, value]) => [x(time), y(value)]));
    }
    context.restore();
}

/** Metres per degree of latitude. */
const DEGREE = 111_195;

/** Draws a track from above, north up, with a grid in metres around the latest position. */
export function drawTrack(canvas, { track }) {
    const held = begin(canvas);
    if (!held) return;
    const { context, width, height, colour, text } = held;
    if (!track.length) {
        context.fillStyle = text;
        context.fillText("no valid position", 6, 14);
        return;
    }
    const { latitude, longitude } = track.at(-1);
    const across = DEGREE * Math.cos((latitude * Math.PI) / 180);
    const points = track.map((one) => [(one.longitude - longitude) * across, (one.latitude - latitude) * DEGREE]);
    const reach = (i) => points.map((point) => point[i]).reduce(([a, b], value) => [Math.min(a, value), Math.max(b, value)], [0, 0]);
    const [[west, east], [south, north]] = [reach(0), reach(1)];
    const scale = Math.min((width - 32) / Math.max(east - west, 2), (height - 32) / Math.max(north - south, 2)); // pixels per metre
    const middle = [(west + east) / 2, (south + north) / 2];
    const at = ([x, y]) => [width / 2 + (x - middle[0]) * scale, height / 2 - (y - middle[1]) * scale];
    const { step, label } = axis(0, height / scale, 4);
    context.lineWidth = 1;
    context.strokeStyle = colour("--mip-line");
    const first = (i, half) => Math.ceil((middle[i] - half / scale) / step) * step;
    for (let x = first(0, width / 2); at([x, 0])[0] < width; x += step) line(context, [at([x, 0])[0], 0], [at([x, 0])[0], height]);
    for (let y = first(1, height / 2); at([0, y])[1] > 0; y += step) line(context, [0, at([0, y])[1]], [width, at([0, y])[1]]);
    context.lineWidth = 2;
    context.lineJoin = "round";
    context.strokeStyle = colour(COLOURS[0]);
    line(context, ...points.map(at));
    context.fillStyle = colour("--mip-nose");
    context.beginPath();
    context.arc(...at([0, 0]), 5, 0, 2 * Math.PI);
    context.fill();
    context.fillStyle = text;
    context.textBaseline = "middle";
    context.textAlign = "left";
    context.fillText(`N ↑   grid ${label(step)} m`, 6, 10);
}

function line(context, ...points) {
    context.beginPath();
    for (const point of points) context.lineTo(...point);
    context.stroke();
}

/** Keeps only the lowest and the highest point of each pixel column, because more would not be visible. */
function thinned(points, columns) {
    const size = Math.ceil(points.length / columns);
    if (size < 3) return points;
    const kept = [];
    for (let at = 0; at < points.length; at += size) {
        const column = points.slice(at, at + size);
        const low = column.reduce((a, b) => (b[1] < a[1] ? b : a));
        const high = column.reduce((a, b) => (b[1] > a[1] ? b : a));
        kept.push(...(low[0] < high[0] ? [low, high] : [high, low]));
    }
    return kept;
}

/** Formats a number without a negative zero. */
export function fixed(value, decimals) {
    const text = value.toFixed(decimals);
    return text.replace(/^-(?=0(\.0*)?$)/, "").replace("-", "−");
}

/** Returns about `count` round numbers from below `low` to above `high`, their step, and a function that formats them. */
function axis(low, high, count) {
    const rough = (high - low) / count;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].find((factor) => factor * power >= rough * 0.999) * power;
    const first = Math.floor(low / step);
    const ticks = Array.from({ length: Math.ceil(high / step) - first + 1 }, (_, i) => (first + i) * step);
    const decimals = Math.min(Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), 12);
    return {
        ticks,
        step,
        label: (value) => fixed(value, decimals),
    };
}

// An aeroplane, in the axes of the vehicle: forward, right, down.
const mirrored = (points) => [points, points.map(([x, y, z]) => [x, -y, z])];
const WING = [
    [0.4, 0.12, 0],
    [-0.2, 1.2, 0],
    [-0.45, 1.2, 0],
    [-0.3, 0.12, 0],
];
const TAIL = [
    [-0.85, 0.06, 0],
    [-1.05, 0.48, 0],
    [-1.2, 0.48, 0],
    [-1.15, 0.04, 0],
];
const BODY = [
    [1.3, 0, 0.02],
    [1, 0.13, 0],
    [-0.6, 0.13, 0],
    [-1.2, 0.04, 0],
    [-1.2, -0.04, 0],
    [-0.6, -0.13, 0],
    [1, -0.13, 0],
];
const SIDE = [
    [1.3, 0, 0.02],
    [0.95, 0, -0.13],
    [-0.5, 0, -0.15],
    [-1.2, 0, -0.05],
    [-1.2, 0, 0.03],
    [-0.4, 0, 0.14],
    [0.95, 0, 0.12],
];
const FIN = [
    [-0.75, 0, -0.12],
    [-1.1, 0, -0.55],
    [-1.3, 0, -0.55],
    [-1.2, 0, 0],
];
const FACES = [
    ...[...mirrored(WING), ...mirrored(TAIL), BODY, SIDE].map((points) => ({ points, colour: "--mip-body" })),
    { points: FIN, colour: "--mip-nose" },
    { points: [BODY[0], BODY[1], BODY.at(-1)], colour: "--mip-nose" },
];

/** Draws a vehicle with the rotation from `rotationOf`, seen from behind and above, looking north. */
export function drawAttitude(canvas, rotation) {
    const held = begin(canvas);
    if (!held) return;
    const { context, width, height, colour, text } = held;
    const size = Math.min(width * 0.26, height * 0.27);
    const [cosine, sine] = [Math.cos(0.65), Math.sin(0.65)]; // how far the view looks down
    /** North, east, down -> the position on the canvas, and the depth. */
    const seen = ([n, e, d]) => {
        const depth = n * cosine - -d * sine;
        const up = -d * cosine + n * sine;
        const near = 6 / (6 + depth);
        return { x: width / 2 + e * size * near, y: height * 0.44 - up * size * near, depth };
    };
    const path = (points) => {
        context.beginPath();
        for (const point of points) {
            const { x, y } = seen(point);
            context.lineTo(x, y);
        }
    };
    context.strokeStyle = colour("--mip-line");
    context.lineWidth = 1;
    path(Array.from({ length: 73 }, (_, i) => [1.5 * Math.cos((i * Math.PI) / 36), 1.5 * Math.sin((i * Math.PI) / 36), 0.7]));
    context.stroke();
    const turned = ([x, y, z]) => rotation.map((row) => row[0] * x + row[1] * y + row[2] * z);
    const faces = FACES.map(({ points, colour: name }) => {
        const placed = points.map(turned);
        return { placed, name, depth: placed.reduce((sum, point) => sum + seen(point).depth, 0) / placed.length };
    });
    for (const { placed, name } of faces.sort((a, b) => b.depth - a.depth)) {
        path(placed);
        context.closePath();
        context.fillStyle = colour(name);
        context.fill();
        context.strokeStyle = text;
        context.lineWidth = 1;
        context.stroke();
    }
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = text;
    context.strokeStyle = colour("--mip-page");
    context.lineWidth = 4;
    for (const [letter, point] of Object.entries({ N: [1.7, 0, 0.7], E: [0, 1.7, 0.7], S: [-1.7, 0, 0.7], W: [0, -1.7, 0.7] })) {
        const { x, y } = seen(point); // legible before the vehicle, too
        context.strokeText(letter, x, y);
        context.fillText(letter, x, y);
    }
}
