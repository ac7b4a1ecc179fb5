# SPDX-License-Identifier: Apache-2.0
"""The routes of a design in nextpnr-ecp5."""

from __main__ import STRENGTH_WEAK, ctx

from place_timing import CLOCKS, Timing

# What drives or takes clocks.
CLOCK_CELLS = {"DCCA", "DCSC", "EHXPLLL", "OSCG", "CLKDIVF", "ECLKSYNCB", "ECLKBRIDGECS", "DDRDLLA", "DQSBUFM"}


def is_fixed(net):
    """Clocks and constants keep their routes."""
    if net.name.startswith(("$PACKER", "$glbnet$")) or net.driver.cell.type in CLOCK_CELLS:
        return True
    for user in net.users:
        if user.port in CLOCKS or user.cell.type in CLOCK_CELLS:
            return True
    return False


class Routes:
    """`wires[net]`: wire -> (pip, wire before it), None at the source. Each change is made in nextpnr too."""

    def __init__(self):
        kinds, bels = {}, {}
        for name, cell in ctx.cells:
            kinds[name], bels[name] = cell.type, cell.bel
        self.names, self.sources, self.wires, self.owner = [], [], [], {}
        self.sinks, self.sinks_at = [], []
        drivers, users = [], []
        for name, net in ctx.nets:
            driver = net.driver
            if driver.cell is None:
                continue
            fixed = is_fixed(net)
            number, wires = -1 if fixed else len(self.names), {}
            for wire, bound in net.wires:
                self.owner[wire] = number
                wires[wire] = (bound.pip, ctx.getPipSrcWire(bound.pip)) if bound.pip else None
            if fixed:
                continue
            ends, at = [], {}
            for user in net.users:
                end = user.cell.name, user.port
                wire = ctx.getBelPinWire(bels[end[0]], end[1])
                ends.append(end)
                # The two registers of a slice, for example, have one wire for their enables.
                at.setdefault(wire, []).append(len(self.sinks))
                self.sinks.append(wire)
            self.names.append(name)
            self.sources.append(ctx.getBelPinWire(bels[driver.cell.name], driver.port))
            self.wires.append(wires)
            self.sinks_at.append(at)
            drivers.append((driver.cell.name, driver.port))
            users.append(ends)
        self.timing = Timing(kinds, drivers, users)
        for net in range(len(self.names)):
            self.measure(net)

    def measure(self, net):
        """Takes the delays of a net's connections from its wires; returns the delay to each wire."""
        wires, delays = self.wires[net], {}
        for end in wires:
            way = []
            while end not in delays and wires[end] is not None:
                way.append(end)
                end = wires[end][1]
            delays.setdefault(end, 0)
            for wire in reversed(way):
                pip, earlier = wires[wire]
                delays[wire] = delays[earlier] + ctx.getPipDelay(pip).maxDelay()
        for wire, connections in self.sinks_at[net].items():
            if wire in delays:
                for connection in connections:
                    self.timing.delay[connection] = delays[wire]
        return delays

    def bind(self, net, wire, origin):
        if origin is None:
            ctx.bindWire(wire, ctx.nets[self.names[net]], STRENGTH_WEAK)
        else:
            ctx.bindPip(origin[0], ctx.nets[self.names[net]], STRENGTH_WEAK)
        self.wires[net][wire] = origin
        self.owner[wire] = net

    def unbind(self, net, wire):
        ctx.unbindWire(wire)
        del self.wires[net][wire]
        del self.owner[wire]

    def branches(self, net):
        branches = {}
        for wire, origin in self.wires[net].items():
            if origin:
                branches.setdefault(origin[1], []).append(wire)
        return branches

    def prune(self, net, wire, sink=None):
        """Removes a wire that leads nowhere, and those before it; returns them. The wire SINK may go too."""
        wires, branches, removed = self.wires[net], self.branches(net), []
        while wires.get(wire) and not branches.get(wire) and (wire == sink or wire not in self.sinks_at[net]):
            origin = wires[wire]
            removed.append((wire, origin))
            self.unbind(net, wire)
            branches[origin[1]].remove(wire)
            wire = origin[1]
        return removed

    def free(self, wire):
        """Removes a wire of a net and all behind it; returns the connections that are unrouted now."""
        net, lost, behind = self.owner[wire], [], [wire]
        branches, origin = self.branches(net), self.wires[net][wire]
        while behind:
            end = behind.pop()
            behind += branches.get(end, [])
            lost += self.sinks_at[net].get(end, [])
            self.unbind(net, end)
        if origin:
            self.prune(net, origin[1])
        self.measure(net)
        return lost

    def replace(self, net, way):
        """Binds a way, each wire of which is free or the net's own; what led to one of its own is removed."""
        wires, earlier = self.wires[net], []
        for wire, _ in way:
            if wire in wires:
                earlier.append(wires[wire][1])
                self.unbind(net, wire)
        if not wires:
            self.bind(net, self.sources[net], None)
        for wire, origin in way:
            self.bind(net, wire, origin)
        for wire in earlier:
            if wire in wires:
                self.prune(net, wire)
        self.measure(net)

    def copy(self):
        return [dict(wires) for wires in self.wires]

    def restore(self, copy):
        changed = [net for net, wires in enumerate(copy) if wires != self.wires[net]]
        for net in changed:
            for wire in list(self.wires[net]):
                self.unbind(net, wire)
        for net in changed:
            for wire, origin in copy[net].items():
                self.bind(net, wire, origin)
            self.measure(net)
