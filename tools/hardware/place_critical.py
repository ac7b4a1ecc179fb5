# SPDX-License-Identifier: Apache-2.0
# Run by nextpnr-ecp5 after it has routed: routes the connections of the longest paths again. Its router leaves them
# longer than necessary: it routes nets that need many wires first, not the late ones. Here a critical connection may
# take a wire from one that has slack, which then gets a detour.
#
# Each round analyses the paths with the delays as routed, gives the connections of those longer than its goal their
# fastest route, worst first, and then a new route to each connection that has lost a wire. The best complete routing is
# kept; nextpnr checks it and analyses it again. Effort is counted in wires, so that the result does not depend on the
# computer.

import heapq
import re
import sys

from place_routes import Routes

# The fraction by which a round shortens the longest path; after one that fails the next tries half of it.
STEP = 0.02
LEAST_STEP = 0.004
# A connection on a path longer than this fraction of the goal keeps its wires.
GUARD = 0.985
# Visited wires: in one search, for new routes in one round, and in all. A search counts for at least SEARCH_COST.
SEARCH_EFFORT = 60000
ROUND_EFFORT = 2000000
EFFORT = 8000000
SEARCH_COST = 100
# The least delay of one tile of distance, in ps.
TILE = 66
# The cost of taking a wire from another connection, in ps: for a critical connection, and at most; from a critical one,
# for which there may be no other route; and the extra cost each time that a wire is taken.
TAKE = 40
TAKE_MOST = 1000
TAKE_KEPT = 2000
TAKE_AGAIN = 300
# A connection with this slack, in ps, is searched for with a greedier estimate.
GREEDY = 1500
ANALYSE_AFTER = 50
FOREVER = 1 << 30

position = re.compile(r"X(\d+)/Y(\d+)/([ABCDM]\d)?")


class Router:
    """`lost`: unrouted connections, in order; `kept`: wires of critical connections; `effort`: visited wires."""

    def __init__(self, routes):
        self.routes, self.timing = routes, routes.timing
        self.lost, self.kept, self.effort = {}, set(), 0
        self.taken, self.ahead, self.places = {}, {}, {}

    def place(self, wire):
        """(x, y, input of logic or None)"""
        place = self.places.get(wire)
        if place is None:
            found = position.match(wire)
            place = self.places[wire] = (int(found[1]), int(found[2]), found[3]) if found else (-1, -1, None)
        return place

    def pips_from(self, wire):
        """The pips that lead on, and for each tile those into inputs of its logic; with the delays of the first look: a
        wire that leads to more wires later is a little slower."""
        found = self.ahead.get(wire)
        if found is None:
            on, into = [], {}
            for pip in ctx.getPipsDownhill(wire):
                # The inputs of a carry or of a RAM cannot be exchanged, those of other logic can.
                if not ctx.checkPipAvail(pip) and not ctx.getBoundPipNet(pip):
                    continue
                end = ctx.getPipDstWire(pip)
                x, y, pin = self.place(end)
                pips = into.setdefault((x, y), []) if pin else on
                pips.append((pip, end, ctx.getPipDelay(pip).maxDelay(), x, y))
            found = self.ahead[wire] = on, into
        return found

    def search(self, net, goal, limit, take, tile):
        """The fastest route (A*) from a net's wires to GOAL, as (wire, (pip, wire before it)); None if it is longer
        than LIMIT, in ps."""
        best, back, done = self.routes.measure(net), {}, set()
        if not best:
            best[self.routes.sources[net]] = 0
        goal_x, goal_y, _ = self.place(goal)
        heap = []
        for wire, delay in best.items():
            x, y, _ = self.place(wire)
            heap.append((delay + tile * max(0, abs(x - goal_x) + abs(y - goal_y) - 3), wire))
        heapq.heapify(heap)
        self.effort += len(heap) + SEARCH_COST
        owner, kept, taken = self.routes.owner, self.kept, self.taken
        while heap and len(done) < SEARCH_EFFORT:
            total, wire = heapq.heappop(heap)
            if wire in done:
                continue
            if total > limit:
                break
            if wire == goal:
                self.effort += len(done)
                way = []
                while wire in back:
                    way.append((wire, back[wire]))
                    wire = back[wire][1]
                return way[::-1]
            done.add(wire)
            delay = best[wire]
            on, into = self.pips_from(wire)
            for pip, end, more, x, y in on + into[goal_x, goal_y] if (goal_x, goal_y) in into else on:
                time, known = delay + more, best.get(end, FOREVER)
                if time >= known:
                    continue
                other = owner.get(end, net)
                if other < 0:
                    continue
                if other != net:
                    time += (TAKE_KEPT if end in kept else take) + taken.get(end, 0)
                if time < known:
                    best[end] = time
                    back[end] = pip, wire
                    away = abs(x - goal_x) + abs(y - goal_y) - 3
                    heapq.heappush(heap, (time + tile * away if away > 0 else time, end))
        self.effort += len(done)
        return None

    def connect(self, connection, take, tile):
        """Gives a connection its fastest route, if that is faster than the one that it has."""
        routes, goal, net = self.routes, self.routes.sinks[connection], self.timing.net_of[connection]
        has_way = goal in routes.wires[net]
        limit = self.timing.delay[connection] if has_way else FOREVER
        removed = routes.prune(net, goal, sink=goal) if has_way else []
        way = self.search(net, goal, limit, take, tile)
        if way is None:
            for wire, origin in reversed(removed):
                routes.bind(net, wire, origin)
            routes.measure(net)
            return
        for wire, _ in way:
            if routes.owner.get(wire, net) != net:
                self.taken[wire] = self.taken.get(wire, 0) + TAKE_AGAIN
                for other in routes.free(wire):
                    self.lost[other] = True
        routes.replace(net, way)
        for other in routes.sinks_at[net][goal]:
            self.lost.pop(other, None)

    def keep(self, connection):
        wires, wire = self.routes.wires[self.timing.net_of[connection]], self.routes.sinks[connection]
        while wire in wires and wire not in self.kept:
            self.kept.add(wire)
            wire = wires[wire][1] if wires[wire] else None

    def analyse(self, goal):
        longest = self.timing.analyse()
        self.kept = set()
        for connection, length in enumerate(self.timing.length):
            if length >= GUARD * goal:
                self.keep(connection)
        return longest

    def shorten(self, goal):
        self.analyse(goal)
        length = self.timing.length
        late = sorted((c for c in range(len(length)) if length[c] > goal), key=lambda c: -length[c])
        for count, connection in enumerate(late):
            if self.effort >= EFFORT:
                break
            if count % ANALYSE_AFTER == ANALYSE_AFTER - 1:
                self.analyse(goal)
            if length[connection] > goal:
                self.connect(connection, TAKE, TILE)
                self.keep(connection)

    def mend(self, goal):
        """A new route for each unrouted connection, without a wire of another one if it has slack."""
        self.analyse(goal)
        length, end, waiting = self.timing.length, self.effort + ROUND_EFFORT, []
        while self.lost and self.effort < end:
            if not waiting:
                waiting = sorted(self.lost, key=lambda c: length[c])
            connection = waiting.pop()
            if connection not in self.lost:
                continue
            slack = goal - length[connection]
            self.connect(connection, min(TAKE_MOST, max(TAKE, 0.3 * slack)), TILE if slack < GREEDY else 2 * TILE)
            if length[connection] >= GUARD * goal:
                self.keep(connection)
        return self.analyse(goal)


def improve():
    routes = Routes()
    router = Router(routes)
    longest = first = routes.timing.analyse()
    best, step = routes.copy(), STEP
    print("Longest path as routed: %d ps" % first)
    while step >= LEAST_STEP and router.effort < EFFORT:
        goal = (1 - step) * longest
        router.shorten(goal)
        now = router.mend(goal)
        print("Goal %d ps: %d ps, %d connections unrouted, %d wires visited" %
              (goal, now, len(router.lost), router.effort))
        sys.stdout.flush()
        if router.lost or now >= longest:
            step /= 2
            routes.restore(best)
            router.lost = {}
        else:
            longest, best = now, routes.copy()
    routes.restore(best)
    print("Longest path: %d ps, before %d ps" % (longest, first))
    sys.stdout.flush()
    if not ctx.route():
        raise SystemExit("nextpnr does not accept the new routes")


improve()
