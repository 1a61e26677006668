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
        const search = document.querySelector("#mip-field");
        put(search, name);
        search.form.requestSubmit(); // as Enter does
        if (selector !== null) put(at(["function"]).querySelector("select"), selector);
        if ([...document.querySelector(".mip-form").children].some((part) => own(part) === "set")) {
            put(at(["set"]).querySelector("select"), String(set));
        }
        for (const [key, value] of Object.entries(values)) fill([key], value);
        return {
            bytes: document.querySelector(".mip-packet-bytes")?.textContent ?? document.querySelector(".mip-wrong").textContent,
            answer: document.querySelector(".mip-answer")?.textContent ?? null,
            responses: [...document.querySelectorAll(".mip-output li")].map((item) => item.dataset.field),
            sources: Object.fromEntries(
                [...document.querySelectorAll("[data-language]")].map((code) => [code.dataset.language, code.textContent]),
            ),
        };
    };
})();
