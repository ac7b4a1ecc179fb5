# SPDX-License-Identifier: Apache-2.0
"""The longest path through each connection of a design on an ECP5 of speed grade 6.

Nets and connections have numbers. A connection leads from its net's driver to one input. Times are in ps; those of
the cells are from Project Trellis' database, the slowest of each three as in nextpnr. It has no I/O registers: theirs
are nextpnr's own. Multipliers and block RAM are taken for those without registers behind them.
"""

import json
import re

DATABASE = "/usr/share/trellis/database/ECP5/timing/speed_6/cells.json"
SLICE, SLICE_WITH_CARRY, SLICE_WITH_RAM = "SLOGICB", "SCCU2C", "SDPRAME"
MEMORY, MULTIPLIER, LOGIC, REGISTER = "DP16KD", "MULT18X18D", "TRELLIS_COMB", "TRELLIS_FF"
IO_REGISTERS = {"IOLOGIC", "SIOLOGIC"}
# Cells in which a path may end.
ENDS = {REGISTER, MEMORY, LOGIC, "TRELLIS_RAMW"} | IO_REGISTERS
CLOCKS = {"CLK", "WCK", "CLKA", "CLKB"}

with open(DATABASE, encoding="utf-8") as file:
    database = json.load(file)


def delay_of(cell, start, end):
    """From one pin of a cell of the database to another."""
    delays = [max(entry["rising"][2], entry["falling"][2]) for entry in database[cell]
              if entry["type"] == "IOPath" and entry["from_pin"] == start and entry["to_pin"] == end]
    if not delays:
        raise SystemExit("%s has no delay of %s from %s to %s" % (DATABASE, cell, start, end))
    return max(delays)


def setups_of(cell):
    """pin -> setup time"""
    setups = {}
    for entry in database[cell]:
        if entry["type"] == "SetupHold":
            setups[entry["pin"]] = max(entry["setup"][2], setups.get(entry["pin"], 0))
    return setups


MEMORY_CELL, MULTIPLIER_CELL = MEMORY + ":REGMODE_A=NOREG,REGMODE_B=NOREG", MULTIPLIER + ":REGS=NONE"
REGISTER_TO_OUTPUT = delay_of(SLICE, "CLK", "Q0")
IO_REGISTER_TO_OUTPUT, IO_REGISTER_SETUP = 500, 100
MEMORY_TO_OUTPUT = {port: delay_of(MEMORY_CELL, "CLK" + port, "DO" + port + "0") for port in "AB"}
MULTIPLY = delay_of(MULTIPLIER_CELL, "A", "P")
# From an input A to D, by the output.
FROM_LOGIC_INPUT = {
    "F": delay_of(SLICE, "A0", "F0"),
    "OFX": delay_of(SLICE, "A0", "OFX0"),
    "FCO": delay_of(SLICE_WITH_CARRY, "A0", "FCO"),
}
TO_WIDE_OUTPUT = {pin: delay_of(SLICE, pin, "OFX1") for pin in ("FXA", "FXB")} | {
    "M": delay_of(SLICE, "M0", "OFX0"),
    "F1": FROM_LOGIC_INPUT["OFX"] - FROM_LOGIC_INPUT["F"],
}
# From the carry input, for the first and the second half of a pair: nextpnr has the delay of the pair in the first.
CARRY = delay_of(SLICE_WITH_CARRY, "FCI", "FCO")
FROM_CARRY = (
    {"FCO": CARRY, "F": delay_of(SLICE_WITH_CARRY, "FCI", "F0")},
    {"FCO": 0, "F": delay_of(SLICE_WITH_CARRY, "FCI", "F1") - CARRY},
)
SETUP = {REGISTER: setups_of(SLICE), MEMORY: setups_of(MEMORY_CELL), LOGIC: setups_of(SLICE_WITH_RAM)}


def through(kind, cell, pin, output):
    """The delay from an input to an output that depends on it without a register between them, or None."""
    if kind == LOGIC:
        if pin == "FCI":
            return FROM_CARRY[0 if cell.endswith("0") else 1].get(output)
        if pin in ("A", "B", "C", "D"):
            return FROM_LOGIC_INPUT.get(output)
        return TO_WIDE_OUTPUT.get(pin) if output == "OFX" else None
    if kind == MULTIPLIER and output[0] == "P" and re.fullmatch(r"[AB]\d+", pin):
        return MULTIPLY
    return None


def setup(kind, pin):
    """The setup time of an input in which a path may end, otherwise None."""
    # Logic keeps only what is written into its RAM.
    if kind not in ENDS or pin in CLOCKS or (kind == LOGIC and pin[0] != "W"):
        return None
    return IO_REGISTER_SETUP if kind in IO_REGISTERS else SETUP.get(kind, {}).get(pin, 0)


class Timing:
    """`length[c]`: the longest path that connection c is on, 0 if it is on none between registers."""

    def __init__(self, kinds, drivers, users):
        """Takes the type of each cell, and for each net the (cell, port) of its driver and of its users."""
        nets = len(drivers)
        self.connections, self.net_of, inputs = [], [], {}
        for net, ends in enumerate(users):
            self.connections.append([])
            for cell, pin in ends:
                connection = len(self.net_of)
                self.connections[net].append(connection)
                self.net_of.append(net)
                inputs.setdefault(cell, []).append((connection, pin))
        self.delay, self.length = [0] * len(self.net_of), [0] * len(self.net_of)

        # The delay of the register that drives a net; the connections that another net depends on, with the delay
        # of the cell; the nets that depend on a connection; the setup time of a connection that ends a path.
        self.start, self.before = [None] * nets, [[] for _ in range(nets)]
        self.after, self.setup = [[] for _ in self.net_of], [None] * len(self.net_of)
        for net, (cell, port) in enumerate(drivers):
            kind = kinds[cell]
            if kind == MEMORY:
                self.start[net] = MEMORY_TO_OUTPUT[port[2]]
            elif kind == REGISTER:
                self.start[net] = REGISTER_TO_OUTPUT
            elif kind in IO_REGISTERS:
                self.start[net] = IO_REGISTER_TO_OUTPUT
            else:
                for connection, pin in inputs.get(cell, []):
                    delay = through(kind, cell, pin, port)
                    if delay is not None:
                        self.before[net].append((connection, delay))
                        self.after[connection].append((net, delay))
        for net, ends in enumerate(users):
            for connection, (cell, pin) in zip(self.connections[net], ends):
                if not self.after[connection]:
                    self.setup[connection] = setup(kinds[cell], pin)
        self.order = self.sorted_nets()
        if len(self.order) < nets:
            print("note: %d nets in loops of logic, or behind them, have no timing" % (nets - len(self.order)))

    def sorted_nets(self):
        """Each net after those that it depends on."""
        order, waiting = [], [len(before) for before in self.before]
        ready = [net for net, count in enumerate(waiting) if count == 0]
        while ready:
            net = ready.pop()
            order.append(net)
            for connection in self.connections[net]:
                for later, _ in self.after[connection]:
                    waiting[later] -= 1
                    if waiting[later] == 0:
                        ready.append(later)
        return order

    def analyse(self):
        """Sets `length` from `delay`; returns the longest path."""
        delay, arrival, rest = self.delay, [None] * len(self.before), [None] * len(self.before)
        for net in self.order:
            latest = self.start[net]
            for connection, logic in self.before[net]:
                earlier = arrival[self.net_of[connection]]
                if earlier is not None:
                    time = earlier + delay[connection] + logic
                    if latest is None or time > latest:
                        latest = time
            arrival[net] = latest
        for net in reversed(self.order):
            longest = None
            for connection in self.connections[net]:
                time = self.setup[connection]
                for later, logic in self.after[connection]:
                    if rest[later] is not None and (time is None or logic + rest[later] > time):
                        time = logic + rest[later]
                if time is not None:
                    time += delay[connection]
                    self.length[connection] = 0 if arrival[net] is None else arrival[net] + time
                    if longest is None or time > longest:
                        longest = time
            rest[net] = longest
        return max(self.length, default=0)
