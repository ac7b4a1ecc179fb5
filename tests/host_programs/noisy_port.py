#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A bad cable: a port between a host program and the printer that corrupts bytes, from a seed.

Faults hit single bytes in both directions: a flipped bit, another byte, a lost, doubled or inserted
one. Stalls stop everything for half a second. A disconnect is a plug that is out for a second: both ports stay
open, and what is said meanwhile is lost. Runs until it is ended by a signal, and then tells what it did.
"""
import argparse
import fcntl
import json
import os
import pty
import random
import select
import signal
import struct
import sys
import time
import tty

# struct termios2 of Linux: four words of flags, the line discipline, 19 characters, two speeds.
TERMIOS2 = "4IB19s2I"
TCGETS2, TCSETS2 = 0x802C542A, 0x402C542B
SPEED_MASK, SPEED_OTHER = 0o010017, 0o010000


def set_speed(port, baud):
    settings = list(struct.unpack(TERMIOS2, fcntl.ioctl(port, TCGETS2, bytes(struct.calcsize(TERMIOS2)))))
    settings[2] = settings[2] & ~SPEED_MASK | SPEED_OTHER
    settings[6] = settings[7] = baud
    fcntl.ioctl(port, TCSETS2, struct.pack(TERMIOS2, *settings))


class Noise:
    def __init__(self, share, seed, highest):
        self.share = share
        self.highest = highest
        self.random = random.Random(seed)
        self.faults = 0

    def corrupt(self, data):
        result = bytearray()
        for byte in data:
            if self.random.random() >= self.share:
                result.append(byte)
                continue
            self.faults += 1
            kind = self.random.randrange(5)
            if kind == 0:
                result.append((byte ^ 1 << self.random.randrange(8)) & self.highest)
            elif kind == 1:
                result.append(self.random.randrange(self.highest + 1))
            elif kind == 2:
                result += bytes([byte, byte])
            elif kind == 3:
                result += bytes([self.random.randrange(self.highest + 1), byte])
        return bytes(result)


class Cable:
    def __init__(self, arguments):
        self.arguments = arguments
        highest_up = 127 if arguments.ascii_up else 255
        self.noise = {"down": Noise(arguments.faults, arguments.seed, 255),
                      "up": Noise(arguments.faults, arguments.seed + 1, highest_up)}
        self.passed = 0
        self.stalls = self.disconnects = 0
        self.host, slave = pty.openpty()
        tty.setraw(slave)
        self.slave = slave  # stays open, so that hosts may come and go
        self.printer = self.open_printer()
        if os.path.islink(arguments.link):
            os.remove(arguments.link)
        os.symlink(os.ttyname(slave), arguments.link)

    def open_printer(self):
        port = os.open(self.arguments.port, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(port)
        set_speed(port, self.arguments.baud)
        return port

    def disconnect(self):
        self.disconnects += 1
        plugged_in = time.monotonic() + 1
        while (left := plugged_in - time.monotonic()) > 0:
            readable, _, _ = select.select([self.host, self.printer], [], [], left)
            for source in readable:
                os.read(source, 256)

    def carry(self):
        readable, _, _ = select.select([self.host, self.printer], [], [], 0.2)
        for source in readable:
            data = os.read(source, 256)
            direction, target = ("down", self.printer) if source == self.host else ("up", self.host)
            before = self.passed
            self.passed += len(data)
            os.write(target, self.noise[direction].corrupt(data))
            # Once in so many bytes, at a place that the seed decides.
            if self.due(self.arguments.stall_every, before):
                self.stalls += 1
                time.sleep(0.5)
            if self.due(self.arguments.disconnect_every, before):
                self.disconnect()
                break

    def due(self, every, before):
        return every > 0 and self.passed // every != before // every

    def report(self):
        os.remove(self.arguments.link)
        print(json.dumps({"bytes": self.passed, "faults_down": self.noise["down"].faults,
                          "faults_up": self.noise["up"].faults, "stalls": self.stalls,
                          "disconnects": self.disconnects}))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("port", help="the printer's")
    parser.add_argument("link", help="symlink to make, for the host program to open")
    parser.add_argument("--baud", type=int, default=250000)
    parser.add_argument("--faults", type=float, default=0.001, help="share of bytes")
    parser.add_argument("--ascii-up", action="store_true",
                        help="replies stay ASCII: printcore stops for ever at any other byte")
    parser.add_argument("--stall-every", type=int, default=0, help="bytes; 0 is never")
    parser.add_argument("--disconnect-every", type=int, default=0, help="bytes; 0 is never")
    parser.add_argument("--seed", type=int, default=1)
    cable = Cable(parser.parse_args())
    ended = []
    for name in (signal.SIGTERM, signal.SIGINT):
        signal.signal(name, lambda number, frame: ended.append(number))
    while not ended:
        cable.carry()
    cable.report()


if __name__ == "__main__":
    sys.exit(main())
