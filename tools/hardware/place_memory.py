# SPDX-License-Identifier: Apache-2.0
# Run by nextpnr-ecp5 before it places: gives each block RAM of the chip's memory its place, in the
# two rows of blocks that lie nearest to each other, around their middle, from the lowest bit of a
# byte to the highest: the same bits of a word's four bytes, of which a load chooses one, and of its
# half words, of which a fetch does, lie side by side. On a larger device the logic gets a region around
# the same middle, as large as a 25F's. The placer spreads it over the whole device otherwise, and the
# longest paths cross it.

import re

# How far the region reaches from its middle.
reach = 35, 22

rows = {}
size = 0, 0
for bel in ctx.getBels():
    location = ctx.getBelLocation(bel)
    size = max(size[0], location.x + 1), max(size[1], location.y + 1)
    if ctx.getBelType(bel) == "DP16KD":
        rows.setdefault(location.y, []).append((location.x, bel))
heights = sorted(rows)
upper, lower = min(zip(heights, heights[1:]), key=lambda pair: pair[1] - pair[0])
pairs = list(zip(sorted(rows[upper]), sorted(rows[lower])))

# A bank's lane has some blocks, of one or more bits each.
lanes = {}
for name, cell in ctx.cells:
    found = re.search(r"\.ram\.banks_n(\d+)_lanes_n(\d+)_bytes\.(\d+)\.(\d+)$", name)
    if found and cell.type == "DP16KD":
        bank, lane, column, row = map(int, found.groups())
        lanes.setdefault((bank, lane), []).append((column, row, cell))
if not lanes:
    raise SystemExit("the memory has other names than rtl/memory/README.md says")
blocks = []
for (bank, lane), cells in lanes.items():
    cells.sort(key=lambda block: block[:2])
    for index, (_, _, cell) in enumerate(cells):
        blocks.append(((index + 0.5) / len(cells), lane, bank, cell))
blocks.sort(key=lambda block: block[:3])

wide = (len(blocks) + 1) // 2
first = (len(pairs) - wide) // 2
if first >= 0:
    for index, (*_, cell) in enumerate(blocks):
        cell.setAttr("BEL", pairs[first + index // 2][index % 2][1])

    middle = (pairs[first][0][0] + pairs[first + wide - 1][0][0]) // 2, (upper + lower) // 2
    # Within the ring of pins.
    free = size[0] - 3 - 2 * reach[0], size[1] - 3 - 2 * reach[1]
    if min(free) > 0:
        left, top = (1 + max(0, min(middle[at] - reach[at] - 1, free[at])) for at in (0, 1))
        ctx.createRectangularRegion("chip", left, top, left + 2 * reach[0], top + 2 * reach[1])
        for name, cell in ctx.cells:
            # Block RAM and multipliers have places of their own.
            if cell.type in ("TRELLIS_COMB", "TRELLIS_FF"):
                ctx.constrainCellToRegion(name, "chip")
