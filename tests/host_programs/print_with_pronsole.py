#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints a G-code file with Printrun's pronsole, typed into as by a person; writes a JSON summary.

Exit status 0 where pronsole said that the print has ended and no error was shown, 1 otherwise.
"""
import argparse
import json
import os
import queue
import subprocess
import sys
import tempfile
import threading
import time

PRONSOLE = (
    "import sys\n"
    "from printrun.pronsole import pronsole\n"
    "interpreter = pronsole()\n"
    "interpreter.parse_cmdline([])\n"
    "interpreter.cmdloop()\n"
)


class Pronsole:
    """The program with pipes at its keyboard and screen."""

    def __init__(self, home):
        environment = dict(os.environ, HOME=home, PYTHONUNBUFFERED="1")
        self.process = subprocess.Popen(
            [sys.executable, "-W", "ignore", "-c", PRONSOLE],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            env=environment, text=True, errors="replace", bufsize=1)
        self.lines = queue.Queue()
        self.shown = []
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        for line in self.process.stdout:
            self.lines.put(line.rstrip())

    def type(self, text):
        self.process.stdin.write(text + "\n")
        self.process.stdin.flush()

    def wait_for(self, text, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                line = self.lines.get(timeout=0.5)
            except queue.Empty:
                if self.process.poll() is not None:
                    return False
                continue
            self.shown.append(line)
            if text in line:
                return True
        return False


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file")
    parser.add_argument("port")
    parser.add_argument("--baud", type=int, default=250000)
    parser.add_argument("--timeout", type=float, default=3600, help="for the print, in seconds")
    parser.add_argument("--summary", required=True)
    arguments = parser.parse_args()

    with tempfile.TemporaryDirectory() as home:
        pronsole = Pronsole(home)
        pronsole.type(f"connect {arguments.port} {arguments.baud}")
        online = pronsole.wait_for("Printer is now online", 60)
        ended = False
        if online:
            pronsole.type(f"load {arguments.file}")
            pronsole.wait_for("Loaded ", 60)
            pronsole.type("print")
            ended = pronsole.wait_for("Print ended at", arguments.timeout)
            # M114 is answered when the moves before it are planned; M400 when they are made.
            pronsole.type("M400")
            pronsole.type("M114")
            pronsole.wait_for("Count", 60)
            time.sleep(1)
        pronsole.process.kill()
    # A warning of the desktop's message bus has "Error" in its middle.
    errors = [line for line in pronsole.shown
              if line.startswith("Error") or "[ERROR]" in line or "Resend" in line]
    with open(arguments.summary, "w", encoding="ascii", errors="replace") as file:
        json.dump({"online": online, "ended": ended, "errors": errors,
                   "shown": pronsole.shown[-40:]}, file, indent=1)
    return 0 if ended and not errors else 1


sys.exit(main())
