# SPDX-License-Identifier: Apache-2.0
"""tools/hardware/place_timing.py: paths whose lengths follow from nextpnr-ecp5's delays of speed grade 6, written down here.

Usage: longest_path_test.py FOLDER_OF_THE_SCRIPT
"""

import random
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv.pop(1))

from place_timing import Timing  # noqa: E402

# type of the driver and its port, then for each cell on the way its type, name, input and output, then the end; length
FROM, FF, LUT = ("TRELLIS_FF", "Q"), ("TRELLIS_FF", "DI"), ("TRELLIS_COMB", "l")
FIRST, SECOND = ("TRELLIS_COMB", "l$CCU2_COMB0"), ("TRELLIS_COMB", "l$CCU2_COMB1")
PATHS = [
    (FROM, [], FF, 525),
    (FROM, [], ("TRELLIS_FF", "CE"), 525),
    (FROM, [], ("TRELLIS_FF", "LSR"), 525 + 424),
    (FROM, [], ("TRELLIS_FF", "M"), 525),
    (FROM, [], ("TRELLIS_FF", "CLK"), 0),
    (FROM, [], ("TRELLIS_COMB", "WRE"), 525 + 392),
    (FROM, [], ("TRELLIS_IO", "I"), 0),
    (FROM, [], ("DP16KD", "ADA3"), 525 + 251),
    (FROM, [], ("DP16KD", "ADB12"), 525 + 205),
    (FROM, [], ("DP16KD", "DIA17"), 525 + 218),
    (FROM, [], ("DP16KD", "RSTB"), 525 + 585),
    (FROM, [], ("DP16KD", "CEB"), 525 + 340),
    (FROM, [], ("SIOLOGIC", "TXDATA0"), 525 + 100),
    (("IOLOGIC", "RXDATA0"), [], FF, 500),
    (("TRELLIS_IO", "O"), [], FF, 0),
    (("DP16KD", "DOA3"), [], FF, 5609),
    (("DP16KD", "DOB0"), [(*LUT, "D", "F")], FF, 5830 + 236),
    (FROM, [("MULT18X18D", "m", "A16", "P6")], FF, 525 + 3927),
    (FROM, [("MULT18X18D", "m", "B0", "P35"), (*LUT, "A", "F")], FF, 525 + 3927 + 236),
    (FROM, [(*LUT, "B", "F"), (*LUT, "C", "OFX")], FF, 525 + 236 + 401),
    (FROM, [(*LUT, "A", "F"), (*LUT, "F1", "OFX")], FF, 525 + 236 + 165),
    (FROM, [(*LUT, "M", "OFX"), (*LUT, "FXB", "OFX")], FF, 525 + 256 + 242),
    (FROM, [(*LUT, "FXA", "OFX")], FF, 525 + 239),
    # A carry of two pairs from each half to each half.
    (FROM, [(*FIRST, "A", "FCO"), (*SECOND, "FCI", "F")], FF, 525 + 447 + 403),
    (FROM, [(*SECOND, "B", "FCO"), (*FIRST, "FCI", "F")], FF, 525 + 447 + 443),
    (FROM, [(*FIRST, "A", "FCO"), (*SECOND, "FCI", "FCO"), (*FIRST, "FCI", "F")], FF, 525 + 447 + 443),
    (FROM, [(*SECOND, "C", "FCO"), (*FIRST, "FCI", "FCO"), (*SECOND, "FCI", "F")], FF, 525 + 447 + 71 + 403),
    # Not a path: an output that does not depend on the input.
    (FROM, [(*LUT, "M", "F")], FF, 0),
    (FROM, [(*LUT, "CLK", "F")], FF, 0),
]


def timing_of(path, delay):
    """Nets with one user each along a path."""
    (kind, port), cells, (end, pin), _ = path
    kinds, drivers, users = {"start": kind, "end": end}, [("start", port)], []
    for index, (kind, name, start, output) in enumerate(cells):
        name = "%d%s" % (index, name)
        kinds[name] = kind
        users.append([(name, start)])
        drivers.append((name, output))
    users.append([("end", pin)])
    timing = Timing(kinds, drivers, users)
    timing.delay = [delay] * len(timing.delay)
    return timing


class LongestPath(unittest.TestCase):
    def test_has_the_delays_of_nextpnr(self):
        for path in PATHS:
            length = path[-1]
            self.assertEqual(timing_of(path, 0).analyse(), length, path)
            if length:
                timing = timing_of(path, 1000)
                longest = timing.analyse()
                self.assertEqual(longest, length + 1000 * len(timing.delay), path)
                self.assertEqual(set(timing.length), {longest}, path)

    def test_of_a_connection_is_the_longest_of_all_paths_through_it(self):
        chance = random.Random(1)
        for _ in range(50):
            names = ["r%d" % i for i in range(4)] + ["g%02d" % i for i in range(12)]
            kinds = {name: "TRELLIS_FF" if name[0] == "r" else "TRELLIS_COMB" for name in names}
            users = {name: [] for name in names}
            for index, name in enumerate(names[4:], 4):
                for pin in chance.sample("ABCD", chance.randint(1, 3)):
                    users[chance.choice(names[:index])].append((name, pin))
            for name in names[:4]:
                users[chance.choice(names[4:])].append((name, "DI"))
            timing = Timing(kinds, [(name, "Q" if name[0] == "r" else "F") for name in names], list(users.values()))
            timing.delay = [chance.randint(0, 900) for _ in timing.delay]
            longest = [0] * len(timing.delay)

            def follow(name, time, way):
                for connection, (user, pin) in zip(timing.connections[names.index(name)], users[name]):
                    then, passed = time + timing.delay[connection], way + [connection]
                    if pin == "DI":
                        for earlier in passed:
                            longest[earlier] = max(longest[earlier], then)
                    else:
                        follow(user, then + 236, passed)

            for name in names[:4]:
                follow(name, 525, [])
            self.assertEqual(timing.analyse(), max(longest))
            self.assertEqual(timing.length, longest)

    def test_of_nothing_is_zero(self):
        self.assertEqual(Timing({}, [], []).analyse(), 0)


if __name__ == "__main__":
    unittest.main()
