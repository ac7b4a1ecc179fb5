# SPDX-License-Identifier: Apache-2.0
"""A stand-in for nextpnr's `ctx` with a small device: it refuses what nextpnr refuses."""

import heapq
import random
from types import SimpleNamespace

STRENGTH_WEAK = 1
# Of Project Trellis, speed grade 6: register, gate, select of a wide multiplexer.
REGISTER, GATE, SELECT = 525, 236, 256
FANOUT = 5


class Bound:
    def __init__(self, pip):
        self.pip = pip


class Device:
    """A grid of tiles with `tracks` wires each that lead to their neighbours, and pins of one gate and one register."""

    def __init__(self, width, height, tracks, seed):
        chance = random.Random(seed)
        self.ends, self.delays, self.down, self.into = {}, {}, {}, {}
        for x in range(width):
            for y in range(height):
                at = "X%d/Y%d/" % (x, y)
                for track in range(tracks):
                    wire = at + "N%d" % track
                    for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
                        if 0 <= x + dx < width and 0 <= y + dy < height:
                            other = chance.randrange(tracks)
                            self.add(wire, "X%d/Y%d/N%d" % (x + dx, y + dy, track), chance.randint(70, 180))
                            self.add(wire, "X%d/Y%d/N%d" % (x + dx, y + dy, other), chance.randint(70, 180))
                    for output in ("F0", "Q0", "OFX0"):
                        self.add(at + output, wire, chance.randint(20, 60))
                    for pin in ("A0", "B0", "C0", "D0", "DI0", "CE0", "M0", "CLK0"):
                        self.add(wire, at + pin, chance.randint(20, 60))
        self.blocked = {pip for pip in self.ends if chance.random() < 0.02}
        self.wire_net, self.pip_net, self.users = {}, {}, {}
        self.nets, self.cells = Table(), Table()
        self.routed = False

    def add(self, start, end, delay):
        pip = start + ">" + end
        if pip not in self.ends:
            self.ends[pip] = start, end
            self.delays[pip] = delay
            self.down.setdefault(start, []).append(pip)

    # What nextpnr has.
    def getPipsDownhill(self, wire):
        return self.down.get(wire, [])

    def getPipSrcWire(self, pip):
        return self.ends[pip][0]

    def getPipDstWire(self, pip):
        return self.ends[pip][1]

    def getPipDelay(self, pip):
        delay = self.delays[pip] + FANOUT * self.users.get(self.ends[pip][0], 0)
        return SimpleNamespace(maxDelay=lambda: delay)

    def getBelPinWire(self, bel, port):
        return bel + port + "0"

    def checkPipAvail(self, pip):
        return pip not in self.pip_net and pip not in self.blocked

    def checkWireAvail(self, wire):
        return wire not in self.wire_net

    def getBoundPipNet(self, pip):
        return self.pip_net.get(pip)

    def bindWire(self, wire, net, strength):
        assert wire not in self.wire_net, wire + " is taken"
        self.wire_net[wire] = net
        net.bound[wire] = Bound(None)

    def bindPip(self, pip, net, strength):
        start, end = self.ends[pip]
        assert self.checkPipAvail(pip), pip + " is not free"
        self.bindWire(end, net, strength)
        self.pip_net[pip] = net
        net.bound[end] = Bound(pip)
        self.users[start] = self.users.get(start, 0) + 1

    def unbindWire(self, wire):
        pip = self.wire_net.pop(wire).bound.pop(wire).pip if wire in self.wire_net else self.fail(wire)
        if pip:
            del self.pip_net[pip]
            self.users[self.ends[pip][0]] -= 1

    def fail(self, wire):
        raise AssertionError(wire + " is bound to no net")

    def route(self):
        self.routed = True
        return True

    # The test's own.
    def cell(self, name, kind, x, y):
        self.cells[name] = SimpleNamespace(name=name, type=kind, bel="X%d/Y%d/" % (x, y))

    def net(self, name, driver, users):
        end = lambda pin: SimpleNamespace(cell=self.cells[pin[0]], port=pin[1])
        bound = Table()
        self.nets[name] = SimpleNamespace(name=name, driver=end(driver), users=[end(user) for user in users],
                                          bound=bound, wires=bound)

    def pin(self, end):
        return self.getBelPinWire(end.cell.bel, end.port)

    def first_routes(self, order):
        """Each net in turn through what is free; False if one finds no way."""
        for name in order:
            net = self.nets[name]
            self.bindWire(self.pin(net.driver), net, STRENGTH_WEAK)
            for user in net.users:
                if not self.first_way(net, self.pin(user)):
                    return False
        return True

    def first_way(self, net, goal):
        best, back = {wire: 0 for wire, _ in net.bound}, {}
        heap = [(0, wire) for wire in best]
        while heap:
            cost, wire = heapq.heappop(heap)
            if wire == goal:
                way = []
                while wire in back:
                    way.append(back[wire])
                    wire = self.ends[back[wire]][0]
                for pip in reversed(way):
                    self.bindPip(pip, net, STRENGTH_WEAK)
                return True
            for pip in self.down.get(wire, []):
                end = self.ends[pip][1]
                if self.checkPipAvail(pip) and self.checkWireAvail(end) and cost + 1 < best.get(end, 1e9):
                    best[end], back[end] = cost + 1, pip
                    heapq.heappush(heap, (cost + 1, end))
        return False

    def delay_to(self, net, wire):
        pip = net.bound[wire].pip
        return self.getPipDelay(pip).maxDelay() + self.delay_to(net, self.ends[pip][0]) if pip else 0

    def longest_path(self):
        """By recursion over all paths, from the routes that are bound."""
        found = {}

        def arrival(name):
            if name not in found:
                driver = self.nets[name].driver
                inputs, logic = ("M", SELECT) if driver.port == "OFX" else ("ABCD", GATE)
                found[name] = REGISTER if driver.port == "Q" else logic + max(
                    (reach(other, user) for other, net in self.nets for user in net.users
                     if user.cell is driver.cell and user.port in inputs), default=-10**9)
            return found[name]

        def reach(name, user):
            return arrival(name) + self.delay_to(self.nets[name], self.pin(user))

        return max(reach(name, user) for name, net in self.nets for user in net.users
                   if user.cell.type == "TRELLIS_FF" and user.port != "CLK")

    def check(self, test):
        """Each connection has a way of its net's own wires from its driver, and nothing else is bound."""
        for name, net in self.nets:
            needed = set()
            for user in net.users:
                wire = self.pin(user)
                while True:
                    test.assertIs(self.wire_net.get(wire), net, "%s at %s" % (name, wire))
                    needed.add(wire)
                    pip = net.bound[wire].pip
                    if pip is None:
                        break
                    test.assertNotIn(pip, self.blocked)
                    wire = self.ends[pip][0]
                test.assertEqual(wire, self.pin(net.driver))
            test.assertEqual(needed, {wire for wire, _ in net.bound}, name + " has wires that lead nowhere")

    def state(self):
        return {name: {wire: bound.pip for wire, bound in net.bound} for name, net in self.nets}


class Table(dict):
    """nextpnr's tables give pairs."""

    def __iter__(self):
        return iter(list(self.items()))

    def __contains__(self, key):
        return dict.__contains__(self, key)
