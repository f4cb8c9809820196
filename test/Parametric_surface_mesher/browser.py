# This file is part of Parametric_surface_mesher, an extension package of CGAL.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A browser without a window, driven through a pipe by the Chrome DevTools protocol; and the pixels of its screenshots."""

import base64
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def find_browser():
    """The path of Chromium or Chrome, or None."""
    return next((path for path in map(shutil.which, NAMES) if path), None)


class Browser:
    """Shows pages of a given size. To be used in a `with` statement."""

    def __init__(self, width=1280, height=800, timeout=120):
        self.timeout = timeout
        self.folder = tempfile.mkdtemp(prefix="page_")
        to_browser, self.out = os.pipe()
        self.incoming, from_browser = os.pipe()
        # The descriptors 3 and 4 are those of the protocol.
        command = ("exec 3<&%d 4>&%d; exec \"$@\"" % (to_browser, from_browser), "sh", find_browser(),
                   "--headless=new", "--remote-debugging-pipe", "--user-data-dir=" + self.folder, "--no-first-run", "--hide-scrollbars",
                   "--disable-gpu-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                   "--force-device-scale-factor=1", "--window-size=%d,%d" % (width, height))
        if os.geteuid() == 0:
            command += ("--no-sandbox",)
        self.process = subprocess.Popen(("bash", "-c") + command, pass_fds=(to_browser, from_browser), stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.unread = b""
        self.number = 0
        self.session = None
        self.errors = []  # what pages wrote to the console as errors, and exceptions
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.call("Page.enable")
        self.call("Runtime.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        self.process.kill()
        self.process.wait()
        os.close(self.out)
        os.close(self.incoming)
        shutil.rmtree(self.folder, ignore_errors=True)

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.read()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(method + ": " + answer["error"]["message"])
                return answer["result"]

    def read(self):
        while b"\0" not in self.unread:
            received = os.read(self.incoming, 1 << 16)
            if not received:
                raise RuntimeError("the browser has ended")
            self.unread += received
        message, self.unread = self.unread.split(b"\0", 1)
        answer = json.loads(message)
        if answer.get("method") == "Runtime.exceptionThrown":
            details = answer["params"]["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description", details["text"]))
        if answer.get("method") == "Runtime.consoleAPICalled" and answer["params"]["type"] in ("error", "warning"):
            self.errors.append(" ".join(str(a.get("value", a.get("description"))) for a in answer["params"]["args"]))
        return answer

    def evaluate(self, expression):
        """The value of an expression; that of a promise when it is there."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(expression + ": " + str(result["exceptionDetails"].get("exception", {}).get("description")))
        return result["result"].get("value")

    def wait_for(self, expression):
        end = time.time() + self.timeout
        while not self.evaluate(expression):
            if time.time() > end:
                raise RuntimeError("it took too long: " + expression + "; " + "; ".join(self.errors))
            time.sleep(0.05)

    def open(self, path):
        self.errors.clear()
        self.call("Page.navigate", url="file://" + os.path.abspath(path))
        self.wait_for("document.readyState === 'complete'")

    def settle(self):
        """Waits for frames that show what has changed."""
        self.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done))))")

    def mouse(self, kind, x, y, button="none"):
        buttons = 0 if kind == "mouseMoved" and button == "none" else 1
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons=buttons, clickCount=0 if button == "none" else 1)

    def click(self, x, y):
        self.mouse("mouseMoved", x, y)
        self.mouse("mousePressed", x, y, "left")
        self.mouse("mouseReleased", x, y, "left")
        self.settle()

    def screenshot(self, left, top, width, height):
        """A rectangle of the page as a Picture."""
        self.settle()
        clip = {"x": left, "y": top, "width": width, "height": height, "scale": 1}
        return Picture(base64.b64decode(self.call("Page.captureScreenshot", format="png", clip=clip)["data"]))


class Picture:
    """The pixels of a PNG file with eight bits a channel: rows of bytes."""

    def __init__(self, data):
        self.width, self.height, depth, kind = struct.unpack(">IIBB", data[16:26])
        self.channels = {0: 1, 2: 3, 4: 2, 6: 4}[kind]
        assert depth == 8
        compressed, place = b"", 8
        while place < len(data):
            (length,) = struct.unpack(">I", data[place:place + 4])
            if data[place + 4:place + 8] == b"IDAT":
                compressed += data[place + 8:place + 8 + length]
            place += 12 + length
        self.rows = self.unfiltered(zlib.decompress(compressed))

    def unfiltered(self, data):
        step, n = self.width * self.channels, self.channels
        rows, above = [], bytearray(step)
        for y in range(self.height):
            kind, row = data[y * (step + 1)], bytearray(data[y * (step + 1) + 1:(y + 1) * (step + 1)])
            for i in range(step):
                left, up, corner = row[i - n] if i >= n else 0, above[i], above[i - n] if i >= n else 0
                if kind == 1:
                    row[i] = row[i] + left & 255
                elif kind == 2:
                    row[i] = row[i] + up & 255
                elif kind == 3:
                    row[i] = row[i] + (left + up) // 2 & 255
                elif kind == 4:
                    p = left + up - corner
                    distances = (abs(p - left), abs(p - up), abs(p - corner))
                    row[i] = row[i] + (left, up, corner)[distances.index(min(distances))] & 255
            rows.append(row)
            above = row
        return rows

    def pixel(self, x, y):
        return tuple(self.rows[y][self.channels * x:self.channels * (x + 1)])

    def colors(self):
        """The set of all colours."""
        return {self.pixel(x, y) for y in range(self.height) for x in range(self.width)}

    def difference(self, other):
        """The share of pixels that are not the same."""
        pixels = [(x, y) for y in range(self.height) for x in range(self.width)]
        return sum(self.pixel(x, y) != other.pixel(x, y) for x, y in pixels) / len(pixels)


class Browser_test(unittest.TestCase):
    """Tests that look at pages in one browser, `self.browser`, the size of whose window is that of the class."""

    WINDOW = (1100, 700)

    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(*cls.WINDOW)

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()


def run_tests():
    """Runs the tests of the main program, or says that they are skipped."""
    if not find_browser():
        print("Skipped: neither Chromium nor Chrome is installed")
        sys.exit(0)
    unittest.main(argv=sys.argv[:1], verbosity=2)
