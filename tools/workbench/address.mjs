// State that all tools share, and the address that contains it: `#device=3dm-cv7-ins&streams=sensor.scaled_accel@100`.

/** The keys of an address. Each value is a text that all tools share. */
const KEYS = ["device", "bytes", "find", "packet", "streams", "serve"];

/** The pages of the tools, which are in one folder. */
const PAGE = /(?:^|\/)(?:bandwidth|builder|finder|inspector|live)\.html$/;

/** Longer texts are left out, because nobody could send such an address. */
const LONGEST = 30_000;

/** Milliseconds between two changes of the address, because browsers limit their rate. */
const PAUSE = 400;

/** The part of the address after the #. */
export function fragment() {
    return location.hash.slice(1);
}

function decoded(text) {
    try {
        return decodeURIComponent(text);
    } catch {
        return text;
    }
}

/** Parses a fragment. `given` is a text in another form, which each tool interprets in its own way. */
export function stateOf(text) {
    const parts = text.split("&").map((part) => /^(\w+)=(.*)$/s.exec(part));
    if (!text || !parts.every((part) => part && KEYS.includes(part[1]))) return { given: decoded(text) };
    return Object.fromEntries(parts.map(([, key, value]) => [key, decoded(value)]));
}

/** Returns the fragment for a state. */
export function fragmentOf(state) {
    const held = KEYS.filter((key) => state[key] && state[key].length <= LONGEST);
    const readable = (value) => encodeURIComponent(value).replace(/%(?:2B|2C|40|3A|2F)/g, decodeURIComponent);
    return held.map((key) => `${key}=${readable(state[key])}`).join("&");
}

/**
 * The state of a tool, which begins with the fragment `start`. Without one, the address stays as it is. `device` is
 * that of a start that has none.  The links of the page to other tools lead there with the same state.
 */
export class State {
    #values;
    #follows;
    #last = Number.NEGATIVE_INFINITY;
    #timer;

    constructor(start, device) {
        this.#follows = start !== undefined;
        this.#values = { ...(device && { device }), ...stateOf(start ?? "") };
        this.#tellLinks();
    }

    /** Returns a text; "" if the state has none. */
    get(key) {
        return this.#values[key] ?? "";
    }

    /** Changes some texts, and the address. A text in another form is dropped. */
    set(changed) {
        this.adopt(changed);
        clearTimeout(this.#timer);
        const wait = this.#last + PAUSE - performance.now();
        if (wait > 0) this.#timer = setTimeout(() => this.#write(), wait);
        else this.#write();
    }

    /**
     * Stores what a tool has read from a text in another form. The address stays the same until something is changed.
     */
    adopt(read) {
        const { given, ...others } = this.#values;
        this.#values = { ...others, ...read };
        this.#tellLinks();
    }

    /** Returns the address of another tool, with the same state except for these changes. */
    link(page, changed = {}) {
        const text = fragmentOf({ ...this.#values, ...changed });
        return text ? `${page}#${text}` : page;
    }

    /** Is a text too long for an address? */
    static tooLong(text) {
        return text.length > LONGEST;
    }

    #write() {
        this.#last = performance.now();
        if (!this.#follows) return;
        const text = fragmentOf(this.#values);
        history.replaceState(history.state, "", text ? `#${text}` : location.pathname + location.search);
    }

    #tellLinks() {
        if (!this.#follows) return;
        const folder = location.pathname.replace(/[^/]*$/, "");
        for (const link of document.links) {
            const beside = link.pathname.startsWith(folder) && PAGE.test(link.pathname.slice(folder.length));
            const [page] = link.getAttribute("href").split("#"); // "" for a heading of this page
            if (beside && page && !link.closest(".mip-tool")) link.setAttribute("href", this.link(page));
        }
    }
}
