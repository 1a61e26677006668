// Reads JSON and the YAML of settings files: mappings, lists and words, with their positions. Everything else is
// rejected.

import { MipError } from "mip-protocol/tools";

/**
 * Parses a text into nodes: { kind, at } with `entries` of a mapping ([{ key, value }, …], the key a scalar), `items`
 * of a sequence, `text` of a scalar. `placeOf(text, at)` returns the line and column.
 */
export function nodesOf(text) {
    return new Reader(text.replace(/^\uFEFF/, "").replaceAll("\r\n", "\n")).whole();
}

/** Returns line and column of a position in a text: "3:12". */
export function placeOf(text, at) {
    const before = text.replaceAll("\r\n", "\n").slice(0, at).split("\n");
    return `${before.length}:${before.at(-1).length + 1}`;
}

class Reader {
    #text;
    #at = 0;

    constructor(text) {
        this.#text = text;
    }

    whole() {
        this.#toNext();
        if (this.#text.startsWith("---", this.#at)) {
            this.#at += 3;
            this.#toNext();
        }
        const node = this.#at < this.#text.length ? this.#block(this.#column()) : this.#scalar("", this.#at);
        this.#toNext();
        if (this.#at < this.#text.length) this.#refuse("this does not belong to what precedes it; check the indentation");
        return node;
    }

    #refuse(why) {
        throw new MipError("format", `${placeOf(this.#text, this.#at)}: not YAML that is read here: ${why}`);
    }

    #column() {
        return this.#at - (this.#text.lastIndexOf("\n", this.#at - 1) + 1);
    }

    /** Moves to the next significant character, also on another line. */
    #toNext() {
        for (;;) {
            this.#at += /^[ \n]*/.exec(this.#text.slice(this.#at, this.#at + 4096))[0].length;
            const before = this.#text[this.#at - 1];
            if (this.#text[this.#at] === "#" && (before === undefined || /\s/.test(before))) {
                const end = this.#text.indexOf("\n", this.#at);
                this.#at = end < 0 ? this.#text.length : end;
            } else if (this.#text[this.#at] === " " || this.#text[this.#at] === "\n") {
            } else if (this.#text[this.#at] === "\t") {
                this.#refuse("a tab; indent with spaces");
            } else {
                return;
            }
        }
    }

    /** Reads the value that begins here, in lines of its own with this indentation. */
    #block(column) {
        const at = this.#at;
        if (/^-[ \n]/.test(this.#text.slice(at, at + 2))) return this.#list(column, at);
        if (!this.#isKey()) return this.#value(false);
        const entries = [];
        while (this.#at < this.#text.length && this.#column() === column) {
            if (!this.#isKey()) this.#refuse("a key with a colon is needed here");
            const key = this.#value(true);
            this.#at++; // the colon
            entries.push({ key, value: this.#inner(column) });
            this.#toNext();
        }
        return { kind: "mapping", at, entries };
    }

    #list(column, at) {
        const items = [];
        while (this.#column() === column && /^-[ \n]/.test(this.#text.slice(this.#at, this.#at + 2))) {
            this.#at++;
            items.push(this.#inner(column));
            this.#toNext();
        }
        return { kind: "sequence", at, items };
    }

    /** Reads the value after a key or a dash: on the same line, or on further ones with more indentation. */
    #inner(column) {
        const line = this.#text.indexOf("\n", this.#at);
        const from = this.#at;
        this.#toNext();
        const same = line < 0 || this.#at < line;
        if (this.#at >= this.#text.length) return this.#scalar("", from);
        if (same) return this.#text[from - 1] === "-" ? this.#block(this.#column()) : this.#value(false);
        const dash = this.#text[from - 1] === ":" && this.#column() === column && /^-[ \n]/.test(this.#text.slice(this.#at, this.#at + 2));
        if (this.#column() > column || dash) return this.#block(this.#column());
        return this.#scalar("", from);
    }

    /** Is there a key with a colon, before any other value? */
    #isKey() {
        return /^(?:"(?:[^"\\\n]|\\.)*"|'(?:[^'\n]|'')*'|[^\s"'#&*!|>%@`{}[\],?-][^\n#]*?|-[^\s][^\n#]*?) *:(?=[ \n]|$)/.test(
            this.#text.slice(this.#at, this.#at + 1000),
        );
    }

    #scalar(text, at) {
        return { kind: "scalar", at, text };
    }

    /** Reads a word, or a value in brackets. */
    #value(isKey, inFlow = false) {
        const at = this.#at;
        const first = this.#text[at];
        if (first === "{" || first === "[") return this.#flow(first === "{");
        if (first === '"') {
            const found = /^"(?:[^"\\\n]|\\.)*"/.exec(this.#text.slice(at));
            if (!found) this.#refuse("the quotation mark is not closed on its line");
            this.#at += found[0].length;
            return this.#scalar(this.#unquoted(found[0]), at);
        }
        if (first === "'") {
            const found = /^'(?:[^'\n]|'')*'/.exec(this.#text.slice(at));
            if (!found) this.#refuse("the quotation mark is not closed on its line");
            this.#at += found[0].length;
            return this.#scalar(found[0].slice(1, -1).replaceAll("''", "'"), at);
        }
        if (first === undefined || /[&*!|>%@`?]/.test(first))
            this.#refuse(`${first === undefined ? "the end" : `'${first}'`}; write a value`);
        const end = inFlow ? /^(?:(?![,\]}\n]|:[ \n,\]}]|:$| #).)*/ : isKey ? /^(?:(?!:[ \n]|:$).)*/ : /^(?:(?! #)[^\n])*/;
        const found = end.exec(this.#text.slice(at, this.#lineEnd()))[0];
        this.#at += found.length;
        return this.#scalar(found.trimEnd(), at);
    }

    #lineEnd() {
        const end = this.#text.indexOf("\n", this.#at);
        return end < 0 ? this.#text.length : end + 1;
    }

    #unquoted(text) {
        try {
            return JSON.parse(text);
        } catch {
            return this.#refuse("JSON does not have this escape sequence");
        }
    }

    #flow(isMapping) {
        const at = this.#at++;
        const [entries, items] = [[], []];
        const close = isMapping ? "}" : "]";
        for (;;) {
            this.#toNext();
            if (this.#text[this.#at] === close) break;
            const one = this.#value(isMapping, true);
            this.#toNext();
            if (isMapping) {
                if (this.#text[this.#at] !== ":") this.#refuse("a key needs a colon");
                this.#at++;
                this.#toNext();
                const empty = /[,}]/.test(this.#text[this.#at] ?? "");
                entries.push({ key: one, value: empty ? this.#scalar("", this.#at) : this.#value(false, true) });
                this.#toNext();
            } else {
                items.push(one);
            }
            if (this.#text[this.#at] === ",") this.#at++;
            else if (this.#text[this.#at] !== close) this.#refuse(`a comma or ${close} is needed here`);
        }
        this.#at++;
        return isMapping ? { kind: "mapping", at, entries } : { kind: "sequence", at, items };
    }
}
