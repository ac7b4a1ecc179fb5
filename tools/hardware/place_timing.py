# SPDX-License-Identifier: Apache-2.0
"""The longest path through each connection of a design on an ECP5 of speed grade 6.

Nets and connections have numbers. A connection leads from its net's driver to one input. Times are in ps; those of
the cells are from Project Trellis' database, the largest of each three as in nextpnr.
"""

import json
import re

DATABASE = "/usr/share/trellis/database/ECP5/timing/speed_6/cells.json"
CELLS_OF_LOGIC, CELLS_WITH_CARRY = "SLOGICB", "SCCU2C"
MEMORY, MULTIPLIER, LOGIC, REGISTER = "DP16KD", "MULT18X18D", "TRELLIS_COMB", "TRELLIS_FF"
# Those registers within which a path may end.
ENDS = {REGISTER, MEMORY, LOGIC, "TRELLIS_RAMW", "IOLOGIC", "SIOLOGIC"}
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
    """pin -> what it needs before the clock."""
    setups = {}
    for entry in database[cell]:
        if entry["type"] == "SetupHold":
            setups[entry["pin"]] = max(entry["setup"][2], setups.get(entry["pin"], 0))
    return setups


# Neither cell has registers of its own behind it.
MEMORY_CELL, MULTIPLIER_CELL = MEMORY + ":REGMODE_A=NOREG,REGMODE_B=NOREG", MULTIPLIER + ":REGS=NONE"
REGISTER_TO_OUTPUT = delay_of(CELLS_OF_LOGIC, "CLK", "Q0")
MEMORY_TO_OUTPUT = {port: delay_of(MEMORY_CELL, "CLK" + port, "DO" + port + "0") for port in "AB"}
MULTIPLY = delay_of(MULTIPLIER_CELL, "A", "P")
# From an input A to D, by the output; the other inputs by their names.
FROM_LOGIC_INPUT = {
    "F": delay_of(CELLS_OF_LOGIC, "A0", "F0"),
    "OFX": delay_of(CELLS_OF_LOGIC, "A0", "OFX0"),
    "FCO": delay_of(CELLS_WITH_CARRY, "A0", "FCO"),
}
SELECT = delay_of(CELLS_OF_LOGIC, "M0", "OFX0")
FROM_WIDE_INPUT = {"M": SELECT, "F1": SELECT} | {pin: delay_of(CELLS_OF_LOGIC, pin, "OFX1") for pin in ("FXA", "FXB")}
# From the carry input, for the two halves of a pair: the first one's has no delay within the pair.
CARRY = delay_of(CELLS_WITH_CARRY, "FCI", "FCO")
CARRY_TO_CARRY = 0, CARRY
CARRY_TO_LOGIC = delay_of(CELLS_WITH_CARRY, "FCI", "F0"), delay_of(CELLS_WITH_CARRY, "FCI", "F1") - CARRY
SETUP = {REGISTER: setups_of(CELLS_OF_LOGIC), MEMORY: setups_of(MEMORY_CELL)}


def through(kind, cell, pin, output):
    """The delay from an input to an output that depends on it without a register between them, or None."""
    if kind == LOGIC:
        if pin == "FCI":
            half = 0 if cell.endswith("0") else 1
            return CARRY_TO_CARRY[half] if output == "FCO" else CARRY_TO_LOGIC[half]
        return FROM_LOGIC_INPUT.get(output) if pin in ("A", "B", "C", "D") else FROM_WIDE_INPUT.get(pin)
    if kind == MULTIPLIER and output[0] == "P" and re.fullmatch(r"[AB]\d+", pin):
        return MULTIPLY
    return None


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

        # When a net is valid that a register drives; on which connections it depends otherwise, and with which
        # delay in the cell; which nets depend on a connection; what it needs in front of a register.
        self.start, self.before = [None] * nets, [[] for _ in range(nets)]
        self.after, self.setup = [[] for _ in self.net_of], [None] * len(self.net_of)
        for net, (cell, port) in enumerate(drivers):
            kind = kinds[cell]
            if kind == MEMORY:
                self.start[net] = MEMORY_TO_OUTPUT[port[2]]
            elif kind == REGISTER:
                self.start[net] = REGISTER_TO_OUTPUT
            else:
                for connection, pin in inputs.get(cell, []):
                    delay = through(kind, cell, pin, port)
                    if delay is not None:
                        self.before[net].append((connection, delay))
                        self.after[connection].append((net, delay))
        for net, ends in enumerate(users):
            for connection, (cell, pin) in zip(self.connections[net], ends):
                kind = kinds[cell]
                if kind in ENDS and pin not in CLOCKS and not self.after[connection]:
                    self.setup[connection] = SETUP.get(kind, {}).get(pin, 0)
        self.order = self.sorted_nets()

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
        return max(self.length)
