#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints a G-code file with Printrun's own printcore and writes what it noticed as JSON.

Exit status 0 where the whole file was sent and acknowledged, 1 otherwise.
"""
import argparse
import json
import sys
import threading
import time

from printrun import gcoder
from printrun.printcore import printcore


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file")
    parser.add_argument("port")
    parser.add_argument("--baud", type=int, default=250000)
    parser.add_argument("--timeout", type=float, default=60, help="longest silence, in seconds")
    parser.add_argument("--summary", required=True)
    arguments = parser.parse_args()

    seen = {"resends": 0, "errors": [], "replies": 0, "sent": 0, "online": False, "ended": False}
    heard_at = [time.monotonic()]
    online = threading.Event()
    ended = threading.Event()

    def hear(line):
        heard_at[0] = time.monotonic()
        seen["replies"] += 1
        if line.lower().startswith(("resend", "rs")):
            seen["resends"] += 1
        if line.startswith("Error"):
            seen["errors"].append(line.strip())

    def send(command, gline):
        seen["sent"] += 1

    core = printcore()
    core.recvcb = hear
    core.sendcb = send
    core.onlinecb = online.set
    core.endcb = ended.set
    core.connect(arguments.port, arguments.baud)
    seen["online"] = online.wait(arguments.timeout)
    if seen["online"]:
        with open(arguments.file, encoding="ascii") as file:
            job = gcoder.LightGCode([line.rstrip("\n") for line in file])
        core.startprint(job)
        while not ended.wait(0.2) and time.monotonic() - heard_at[0] < arguments.timeout:
            pass
        seen["ended"] = ended.is_set()
        # The last line has been sent, not yet answered, and moves may be under way.
        core.send_now("M400")
        replies = seen["replies"]
        while seen["replies"] == replies and time.monotonic() - heard_at[0] < arguments.timeout:
            time.sleep(0.2)
        time.sleep(1)
    core.disconnect()
    with open(arguments.summary, "w", encoding="ascii") as file:
        json.dump(seen, file, indent=1)
    return 0 if seen["ended"] and not seen["errors"] else 1


sys.exit(main())
