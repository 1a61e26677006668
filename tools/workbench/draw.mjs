// Pictures of live data: plots over time, and the attitude of a vehicle.

import { SPAN } from "./readings.mjs";

/** The CSS colours of a field's values. */
const COLOURS = ["--mip-plot-0", "--mip-plot-1", "--mip-plot-2", "--mip-plot-3", "--mip-plot-4", "--mip-plot-5"];

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

/** Draws the last seconds of several series. */
export function drawPlot(canvas, series, now) {
    const held = begin(canvas);
    if (!held) return;
    const { context, width, height, colour, text } = held;
    const shown = series.map(({ points }) => points.filter(([time]) => time > now - SPAN));
    const values = shown.flatMap((points) => points.map(([, value]) => value)).filter(Number.isFinite);
    if (!values.length) return;
    const [low, high] = nice(
        values.reduce((a, b) => Math.min(a, b)),
        values.reduce((a, b) => Math.max(a, b)),
    );
    const left = 64;
    const [top, bottom] = [8, height - 20];
    const x = (time) => left + (1 - (now - time) / SPAN) * (width - left - 8);
    const y = (value) => bottom - ((value - low) / (high - low)) * (bottom - top);
    context.strokeStyle = colour("--mip-line");
    context.fillStyle = text;
    context.textBaseline = "middle";
    context.textAlign = "right";
    context.lineWidth = 1;
    for (const part of [0, 0.5, 1]) {
        const value = low + part * (high - low);
        context.beginPath();
        context.moveTo(left, y(value));
        context.lineTo(width - 8, y(value));
        context.stroke();
        context.fillText(`${Number(value.toPrecision(4))}`, left - 6, y(value));
    }
    context.textAlign = "center";
    for (const back of [SPAN, SPAN / 2, 0]) {
        context.fillText(back ? `−${back} s` : "now", Math.min(Math.max(x(now - back), left + 14), width - 20), height - 8);
    }
    context.lineWidth = 1.75;
    context.lineJoin = "round";
    for (const [i, points] of shown.entries()) {
        context.strokeStyle = colour(COLOURS[i % COLOURS.length]);
        context.beginPath();
        for (const [time, value] of thinned(points, width - left)) context.lineTo(x(time), y(value));
        context.stroke();
    }
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

/** Returns round limits around values; the range is never empty. */
function nice(low, high) {
    const least = Math.max(Math.abs(low), Math.abs(high), 1e-6) * 1e-3;
    const span = Math.max(high - low, least);
    const middle = (low + high) / 2;
    const step = 10 ** Math.floor(Math.log10(span));
    const from = Math.floor((middle - 0.55 * span) / (step / 2)) * (step / 2);
    const to = Math.ceil((middle + 0.55 * span) / (step / 2)) * (step / 2);
    return [from, to];
}

// A flat body with a nose, in the axes of the vehicle: forward, right, down.
const BODY = [
    {
        points: [
            [1.25, 0, 0],
            [0.75, 0.45, 0],
            [-1, 0.55, 0],
            [-1, -0.55, 0],
            [0.75, -0.45, 0],
        ],
        colour: "--mip-body",
    },
    {
        points: [
            [1.25, 0, 0],
            [0.75, 0.16, -0.02],
            [0.75, -0.16, -0.02],
        ],
        colour: "--mip-nose",
    },
    {
        points: [
            [-1, 0, 0],
            [-0.45, 0, 0],
            [-1, 0, -0.45],
        ],
        colour: "--mip-nose",
    },
]; // prettier-ignore

/** Draws a vehicle with the rotation from `rotationOf`, seen from behind and above, looking north. */
export function drawAttitude(canvas, rotation) {
    const held = begin(canvas);
    if (!held) return;
    const { context, width, height, colour, text } = held;
    const size = Math.min(width * 0.26, height * 0.34);
    const [cosine, sine] = [Math.cos(0.5), Math.sin(0.5)]; // how far the view looks down
    /** North, east, down -> the position on the canvas, and the depth. */
    const seen = ([n, e, d]) => {
        const depth = n * cosine - -d * sine;
        const up = -d * cosine + n * sine;
        const near = 6 / (6 + depth);
        return { x: width / 2 + e * size * near, y: height * 0.4 - up * size * near, depth };
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
    context.fillStyle = text;
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (const [letter, point] of Object.entries({ N: [1.7, 0, 0.7], E: [0, 1.7, 0.7], S: [-1.7, 0, 0.7], W: [0, -1.7, 0.7] })) {
        const { x, y } = seen(point);
        context.fillText(letter, x, y);
    }
    const turned = ([x, y, z]) => rotation.map((row) => row[0] * x + row[1] * y + row[2] * z);
    const faces = BODY.map(({ points, colour: name }) => {
        const placed = points.map(turned);
        return { placed, name, depth: placed.reduce((sum, point) => sum + seen(point).depth, 0) / placed.length };
    });
    for (const { placed, name } of faces.sort((a, b) => b.depth - a.depth)) {
        path(placed);
        context.closePath();
        context.fillStyle = colour(name);
        context.fill();
        context.strokeStyle = text;
        context.stroke();
    }
}
