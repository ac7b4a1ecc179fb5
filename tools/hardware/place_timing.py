# SPDX-License-Identifier: Apache-2.0
"""The longest path through each connection of a design on an ECP5 of speed grade 6.

Nets and connections have numbers. A connection leads from its net's driver to one input. Delays are in ps, those
of the cells from Project Trellis' database (timing/speed_6/cells.json), its largest of each three.
"""

import re

MEMORY, MULTIPLIER, LOGIC = "DP16KD", "MULT18X18D", "TRELLIS_COMB"
REGISTER_TO_OUTPUT = 525
MEMORY_TO_OUTPUT = {"A": 5609, "B": 5830}
MULTIPLY = 3927
# From an input A to D, by the output; the other inputs by their names.
FROM_LOGIC_INPUT = {"F": 236, "FCO": 447, "OFX": 401}
FROM_WIDE_INPUT = {"FXA": 242, "FXB": 242, "M": 256, "F1": 256}
# From the carry input, for the two halves of a pair.
CARRY_TO_CARRY, CARRY_TO_LOGIC = (0, 71), (443, 403)
SETUP = {
    "TRELLIS_FF": {"LSR": 424},
    MEMORY: {"RSTA": 585, "RSTB": 585},
    LOGIC: {},
    "TRELLIS_RAMW": {},
    "IOLOGIC": {},
    "SIOLOGIC": {},
}
SETUP_OTHERWISE = {MEMORY: 205}
CLOCKS = {"CLK", "WCK", "CLKA", "CLKB"}


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
            elif kind == "TRELLIS_FF":
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
                if kind in SETUP and pin not in CLOCKS and not self.after[connection]:
                    self.setup[connection] = SETUP[kind].get(pin, SETUP_OTHERWISE.get(kind, 0))
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
