"""Headless Chromium, driven with the DevTools protocol over a pipe: pages from disk, scripts, screenshots."""

from __future__ import annotations

import base64
import json
import os
import select
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from support import PATIENCE, need, node_modules

FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync",
    "--disable-background-networking", "--disable-component-update", "--disable-extensions", "--remote-debugging-pipe",
)  # fmt: skip


class Page:
    """A tab. `complaints` are errors of its scripts and of the browser, `asked` the addresses that it has requested."""

    def __init__(self, browser: Browser, session: str) -> None:
        self.browser, self.session = browser, session
        self.complaints: list[str] = []
        self.asked: list[str] = []
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")

    def call(self, method: str, **parameters: Any) -> Any:
        return self.browser.call(method, self.session, **parameters)

    def open(self, url: str | Path) -> None:
        self.call("Page.navigate", url=url.as_uri() if isinstance(url, Path) else url)
        self.browser.wait_for("Page.loadEventFired")

    def run(self, script: str) -> Any:
        """The value of an expression; a promise is awaited."""
        done = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in done, done["exceptionDetails"]
        return done["result"].get("value")

    def size(self, width: int, height: int = 900) -> None:
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def screenshot(self, path: Path, whole: bool = True) -> None:
        """The whole page, or what the window shows."""
        path.write_bytes(base64.b64decode(self.call("Page.captureScreenshot", captureBeyondViewport=whole)["data"]))


class Browser:
    def __init__(self, process: subprocess.Popen[bytes], reading: int, writing: int) -> None:
        self.process, self.reading, self.writing = process, reading, writing
        self.received = bytearray()
        self.last = 0
        self.page: Page | None = None

    def call(self, method: str, session: str | None = None, **parameters: Any) -> Any:
        self.last += 1
        request = {
            "id": self.last,
            "method": method,
            "params": parameters,
            **({"sessionId": session} if session else {}),
        }
        os.write(self.writing, json.dumps(request).encode() + b"\0")
        while (message := self.message()).get("id") != self.last:
            pass
        assert "error" not in message, (method, message["error"])
        return message["result"]

    def wait_for(self, event: str) -> None:
        while self.message().get("method") != event:
            pass

    def message(self) -> Any:
        while (end := self.received.find(b"\0")) < 0:
            ready, _, _ = select.select([self.reading], [], [], PATIENCE)
            assert ready, f"chromium has said nothing for {PATIENCE} seconds"
            data = os.read(self.reading, 1 << 16)
            assert data, f"chromium has ended with status {self.process.wait()}"
            self.received += data
        message = json.loads(self.received[:end])
        del self.received[: end + 1]
        self.note(message)
        return message

    def note(self, message: Any) -> None:
        of, parameters = message.get("method"), message.get("params", {})
        if self.page is None:
            return
        if of == "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            self.page.complaints.append(details.get("exception", {}).get("description", details["text"]))
        elif of == "Log.entryAdded" and parameters["entry"]["level"] == "error":
            self.page.complaints.append(parameters["entry"]["text"] + " " + parameters["entry"].get("url", ""))
        elif of == "Network.requestWillBeSent":
            self.page.asked.append(parameters["request"]["url"])


@contextmanager
def page() -> Iterator[Page]:
    """A new tab of a new browser, which has a profile of its own."""
    to_browser, from_browser = os.pipe(), os.pipe()
    with tempfile.TemporaryDirectory() as profile:
        # The browser reads from descriptor 3 and writes to 4.
        command = f'exec "$0" "$@" 3<&{to_browser[0]} 4>&{from_browser[1]}'
        process = subprocess.Popen(
            ["bash", "-c", command, need("chromium"), *FLAGS, f"--user-data-dir={profile}", "about:blank"],
            pass_fds=(to_browser[0], from_browser[1]), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        os.close(to_browser[0])
        os.close(from_browser[1])
        browser = Browser(process, from_browser[0], to_browser[1])
        try:
            target = browser.call("Target.createTarget", url="about:blank")["targetId"]
            session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
            browser.page = Page(browser, session)
            yield browser.page
            browser.call("Browser.close")
        finally:
            os.close(to_browser[1])
            os.close(from_browser[0])
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def axe() -> str:
    """The script of axe-core, which looks for barriers to accessibility."""
    return (node_modules() / "axe-core/axe.min.js").read_text("utf-8")
