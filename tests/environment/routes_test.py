# SPDX-License-Identifier: Apache-2.0
"""tools/hardware/place_critical.py on small devices, with a stand-in for nextpnr that refuses what nextpnr refuses.

Usage: routes_test.py FOLDER_OF_THE_SCRIPT
"""

import io
import os
import random
import re
import subprocess
import sys
import unittest
from contextlib import redirect_stdout
from pathlib import Path

sys.dont_write_bytecode = True
scripts = Path(sys.argv.pop(1))
sys.path.insert(0, str(scripts))

# place_routes.py takes STRENGTH_WEAK and ctx from here, as from nextpnr.
from small_device import STRENGTH_WEAK, Device  # noqa: E402, F401


# Seed and tracks of a device whose nets find their routes.
ROUTABLE = 2, 11


def run_script(device, **constants):
    """Runs the script as nextpnr does, with other constants; returns what it says."""
    global ctx
    ctx = device
    for module in ("place_routes", "place_timing"):
        sys.modules.pop(module, None)
    source = (scripts / "place_critical.py").read_text()
    for name, value in constants.items():
        source, count = re.subn(r"(?m)^%s = .*" % name, "%s = %s" % (name, value), source)
        assert count == 1, name
    said = io.StringIO()
    with redirect_stdout(said):
        exec(compile(source, "place_critical.py", "exec"), {"ctx": device})
    return said.getvalue()


def random_device(seed, tracks):
    """Registers, three layers of gates, registers; a pair of registers in one tile with a common enable, and a wide
    multiplexer whose select is an input of one of them too; a clock and a constant. The nets are routed in an order by
    chance; None if one finds no route."""
    chance = random.Random(seed)
    width = height = 7
    device = Device(width, height, tracks, seed)
    places = [(x, y) for x in range(width) for y in range(height)]
    chance.shuffle(places)
    layers, names = [[], [], [], []], iter(range(10**6))
    for layer in range(4):
        for _ in range(9):
            name = "%s%d" % ("r" if layer == 0 else "g", next(names))
            device.cell(name, "TRELLIS_FF" if layer == 0 else "TRELLIS_COMB", *places.pop())
            layers[layer].append(name)
    users = {name: [] for layer in layers for name in layer}
    for layer in (1, 2, 3):
        for name in layers[layer]:
            for pin in chance.sample("ABCD", 2):
                users[chance.choice(layers[layer - 1] if pin == "A" else sum(layers[:layer], []))].append((name, pin))
    for index, name in enumerate(layers[0]):
        users[layers[3][index]].append((name, "DI"))
    pair = places.pop()
    for name in ("p0", "p1"):
        device.cell(name, "TRELLIS_FF", *pair)
        users[layers[3][0]].append((name, "CE"))
    device.cell("wide", "TRELLIS_COMB", *pair)
    users[layers[3][1]] += [("wide", "M"), ("p0", "M")]
    for name in ("clock", "one"):
        device.cell(name, "TRELLIS_COMB", *places.pop())
    for name, ends in users.items():
        if ends:
            device.net("n_" + name, (name, "Q" if name[0] == "r" else "F"), ends)
    device.net("n_wide", ("wide", "OFX"), [("p1", "DI"), (layers[0][8], "M")])
    device.net("c", ("clock", "F"), [(name, "CLK") for name in layers[0][:4]])
    device.cell("sink", "TRELLIS_FF", *places.pop())
    device.net("$PACKER_VCC", ("one", "F"), [("sink", "DI")])
    order = [name for name, _ in device.nets]
    chance.shuffle(order)
    return device if device.first_routes(order) else None


class Routes(unittest.TestCase):
    def check_run(self, seed, tracks, **constants):
        """Whether the longest path has become shorter; None where the device cannot be routed."""
        device = random_device(seed, tracks)
        if device is None:
            return None
        device.check(self)
        before, fixed = device.longest_path(), [device.state()[name] for name in ("c", "$PACKER_VCC")]
        said = run_script(device, **constants)
        device.check(self)
        after = device.longest_path()
        self.assertTrue(device.routed, "nextpnr has not seen the new routes")
        self.assertEqual([device.state()[name] for name in ("c", "$PACKER_VCC")], fixed)
        told = re.search(r"^Longest path: (\d+) ps, before (\d+) ps$", said, re.MULTILINE)
        self.assertEqual((int(told[1]), int(told[2])), (after, before), "seed %d" % seed)
        self.assertLessEqual(after, before, "seed %d" % seed)
        self.said = said
        return after < before

    def test_random_devices_stay_routed_and_become_no_slower(self):
        results = [self.check_run(seed, 8 + seed % 4) for seed in range(60)]
        self.assertGreater(results.count(True) + results.count(False), 20)
        self.assertGreater(results.count(True), 4 * results.count(False))

    def test_rounds_that_leave_connections_unrouted_are_taken_back(self):
        unrouted = 0
        for seed in range(30):
            if self.check_run(seed, 8 + seed % 4, ROUND_EFFORT=300) is not None:
                unrouted += " 0 connections" not in self.said
        self.assertGreater(unrouted, 3)

    def test_searches_that_are_given_up_change_nothing(self):
        for seed in range(30):
            self.check_run(seed, 8 + seed % 4, SEARCH_EFFORT=40)

    def test_effort_is_limited(self):
        self.check_run(*ROUTABLE, EFFORT=1)
        self.assertLessEqual(self.said.count("Goal"), 1)

    def test_attempts_that_gain_nothing_are_taken_back(self):
        device = random_device(*ROUTABLE)
        path, state = None, None
        for _ in range(10):
            if device.longest_path() == path:
                break
            path = device.longest_path()
            run_script(device)
            state, gained = device.state(), device.longest_path() < path
        self.assertFalse(gained)
        run_script(device)
        self.assertEqual(device.state(), state)

    def test_the_result_does_not_depend_on_the_run(self):
        states = set()
        for hash_seed in ("1", "2"):
            program = [sys.executable, __file__, str(scripts), "--state"]
            states.add(subprocess.run(program, env=os.environ | {"PYTHONHASHSEED": hash_seed}, check=True,
                                      capture_output=True, text=True).stdout)
        self.assertEqual(len(states), 1)


if __name__ == "__main__":
    if "--state" in sys.argv:
        changed = random_device(*ROUTABLE)
        run_script(changed)
        print(changed.state())
    else:
        unittest.main()
