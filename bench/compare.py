#!/usr/bin/env python3
"""Compares two files of `tessera bench --json`: what became faster or slower, beyond the spread of both.

    bench/compare.py before.json after.json

Prints a line per figure that both files have: medians in milliseconds, how many times faster the second is, and a
word where the change is beyond the spread, which is when the ranges between the quartiles do not meet. Exit code 1
where something became slower beyond the spread, 2 for files that cannot be compared.
"""
import json
import sys


def figures(path):
    with open(path, encoding="utf-8") as file:
        report = json.load(file)
    return report, {
        (f["workload"], f["contestant"]): f["seconds"] for f in report["figures"] if not f["rejected"]
    }


def verdict(before, after):
    if after["upper_quartile"] < before["lower_quartile"]:
        return "faster"
    if after["lower_quartile"] > before["upper_quartile"]:
        return "slower"
    return ""


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        (report_before, before), (report_after, after) = (figures(path) for path in arguments)
    except (OSError, ValueError, KeyError, TypeError) as error:
        print(f"compare.py: not a file of `tessera bench --json`: {error!r}", file=sys.stderr)
        return 2
    if report_before["quick"] != report_after["quick"]:
        print("compare.py: one file is of a quick run, the other is not; they measure other workloads.", file=sys.stderr)
        return 2
    for name in ("cpu", "threads"):
        if report_before["machine"][name] != report_after["machine"][name]:
            print(f"Not the same machine: {name} {report_before['machine'][name]}, {report_after['machine'][name]}")
    devices = [{d["id"]: d["name"] for d in report["devices"]} for report in (report_before, report_after)]
    for name in devices[0].keys() & devices[1].keys():
        if devices[0][name] != devices[1][name]:
            print(f"Not the same device: {name} is {devices[0][name]}, then {devices[1][name]}")
    slower = 0
    print(f"{'workload':<10}{'contestant':<42}{'before, ms':>12}{'after, ms':>12}{'times':>8}")
    for key in before:
        if key not in after:
            continue
        a, b = before[key], after[key]
        word = verdict(a, b)
        slower += word == "slower"
        ratio = a["median"] / b["median"] if b["median"] > 0 else float("inf")
        print(f"{key[0]:<10}{key[1]:<42}{a['median'] * 1e3:>12.4g}{b['median'] * 1e3:>12.4g}{ratio:>8.2f}  {word}")
    for key in sorted(before.keys() ^ after.keys()):
        print(f"{key[0]:<10}{key[1]:<42}only {'before' if key in before else 'after'}")
    return 1 if slower else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
