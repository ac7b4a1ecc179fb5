#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the lines that the firmware took with those of the job, in order.

A line that differs is named. It may differ only where its checksum is right all the same (an XOR does not see
two faults that cancel each other). Exit status 1 where one differs in any other way, is missing, comes twice or
in another order.
"""
import argparse
import functools
import operator
import sys


def checksum(number, text):
    return functools.reduce(operator.xor, f"N{number} {text}".encode("ascii"), 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("taken", help="number, tab, text in each line")
    parser.add_argument("wanted", help="the same of the job")
    arguments = parser.parse_args()
    lines = []
    for name in (arguments.taken, arguments.wanted):
        with open(name, encoding="ascii") as file:
            lines.append([line.rstrip("\n").split("\t", 1) for line in file])
    taken, wanted = lines
    if [number for number, _ in taken] != [number for number, _ in wanted]:
        numbers = zip((number for number, _ in taken), (number for number, _ in wanted))
        place = next((pair for pair in numbers if pair[0] != pair[1]), (len(taken), len(wanted)))
        sys.exit(f"not each line once and in order: {len(taken)} for {len(wanted)}, "
                 f"first {place[0]} for {place[1]}")
    wrong = 0
    lying = 0
    for (number, got), (_, text) in zip(taken, wanted):
        if got == text:
            continue
        if checksum(number, got) == checksum(number, text):
            lying += 1
            print(f"line {number}: \"{got}\" for \"{text}\" has the right checksum")
        else:
            wrong += 1
            print(f"line {number}: \"{got}\" for \"{text}\"")
    print(f"{len(wanted)} lines, each taken once and in order; {lying} changed under the same checksum")
    if wrong:
        sys.exit(f"{wrong} lines are wrong")


main()
