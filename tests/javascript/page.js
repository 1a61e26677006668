// What tests do on the pages of the workbench, on every page that is opened.
const all = (selector) => [...document.querySelectorAll(selector)];

/** Sets a control as a reader would; `enter` then presses Enter in its form. */
window.put = (selector, value) => {
    const control = document.querySelector(selector);
    if (control.type === "checkbox") control.checked = value;
    else control.value = value;
    for (const name of ["input", "change"]) control.dispatchEvent(new Event(name, { bubbles: true }));
};
window.enter = (selector, value) => {
    put(selector, value);
    document.querySelector(selector).form.requestSubmit();
};
window.press = (words) => {
    const found = all("button").find((one) => one.textContent === words && one.offsetParent);
    if (!found) throw new Error(`there is no button ${words}`);
    found.click();
};
window.text = (selector) => document.querySelector(selector)?.textContent ?? "";
window.texts = (selector) => all(selector).map((one) => one.textContent);
window.data = (selector, key) => all(selector).map((one) => one.dataset[key]);
window.until = async (condition, seconds = 30) => {
    for (const end = performance.now() + seconds * 1000; performance.now() < end; ) {
        const found = condition();
        if (found) return found;
        await new Promise((done) => setTimeout(done, 20));
    }
    throw new Error(`never: ${condition}`);
};
window.pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

/** Chooses fields of sets with the rates beside them: [set, field, Hz]. */
window.choose = (device, wanted) => {
    put("select", device);
    for (const box of all("[data-set] [type=checkbox]:checked")) box.click();
    for (const [set, field, rate] of wanted) {
        const [box, input] = all(`[data-set="${set}"] [data-field="${field}"] input`);
        input.value = rate;
        box.checked = true;
        box.dispatchEvent(new Event("input"));
    }
    return {
        need: document.querySelector(".mip-need")?.textContent ?? null,
        ports: Object.fromEntries(all("[data-port]").map((one) => [one.dataset.port, one.querySelector("span").textContent])),
    };
};

// Fills in the form of the builder by its labels, as a reader would; numbers are given as text.
window.fill = (() => {
    const own = (part) => part.querySelector(":scope > label, :scope > legend")?.textContent.trim();
    const at = (path) =>
        path.reduce((part, name) => {
            const found = [...part.children].find((child) => own(child) === name);
            if (!found) throw new Error(`there is no input ${path.join(" > ")}`);
            return found;
        }, document.querySelector(".mip-form"));
    const put = (control, value) => {
        if (control.type === "checkbox") control.checked = value !== "0";
        else control.value = value;
        if (control.tagName === "SELECT" && control.value !== value) throw new Error(`there is no choice ${value}`);
        control.dispatchEvent(new Event("input"));
    };
    const bits = (path, value) => {
        const type = mip.model.types.filter((one) => one.kind === "bitfield");
        const names = [...at(path).children].map(own).filter((name) => name && name !== path.at(-1) && name !== "value");
        const { bits: known } = type.find((one) => String(one.bits.map((b) => b.name)) === String(names));
        for (const { name, first, last } of known) {
            const held = (BigInt(value) >> BigInt(first)) & ((1n << BigInt(last - first + 1)) - 1n);
            put(at([...path, name]).querySelector("input"), String(held));
        }
        const whole = at([...path, "value"]).querySelector("input");
        if (BigInt(whole.value) !== BigInt(value)) put(whole, value);
    };
    const fill = (path, value) => {
        if (Array.isArray(value)) {
            if ([...at(path).children].some((child) => own(child) === "value")) {
                return bits(
                    path,
                    value.reduceRight((sum, byte) => (sum << 8n) | BigInt(byte), 0n),
                );
            }
            const add = at(path).querySelector(":scope > p > button");
            const count = () => [...at(path).children].filter((child) => child.matches("fieldset, p:has(> label)")).length;
            while (add && count() > value.length) at(path).querySelectorAll(":scope > p > button")[1].click();
            while (add && count() < value.length) at(path).querySelector(":scope > p > button").click();
            const names = [...at(path).children].filter((child) => child.matches("fieldset, p:has(> label)")).map(own);
            for (const [i, item] of value.entries()) fill([...path, names[i]], item);
        } else if (typeof value === "object") {
            for (const [name, inner] of Object.entries(value)) fill([...path, name], inner);
        } else if (at(path).matches("fieldset")) {
            bits(path, value);
        } else {
            put(at(path).querySelector("input, select"), value);
        }
    };
    return (name, set, selector, values) => {
        enter("#mip-field", name);
        if (selector !== null) put(at(["function"]).querySelector("select"), selector);
        if ([...document.querySelector(".mip-form").children].some((part) => own(part) === "set")) {
            put(at(["set"]).querySelector("select"), String(set));
        }
        for (const [key, value] of Object.entries(values)) fill([key], value);
        return {
            bytes: document.querySelector(".mip-packet-bytes")?.textContent ?? document.querySelector(".mip-wrong").textContent,
            answer: document.querySelector(".mip-answer")?.textContent ?? null,
            responses: data(".mip-output li", "field"),
            sources: Object.fromEntries(all("[data-language]").map((code) => [code.dataset.language, code.textContent])),
        };
    };
})();
