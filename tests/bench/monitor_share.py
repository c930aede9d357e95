#!/usr/bin/env python3
"""What the monitor costs: its functions' share of a run's processor time, by sampling with Linux perf.

monitor_share.py PACKSTONE SCENE [run's options, such as --set dynamics.duration=0.1 --threads 1]

Counts a sample as the monitor's when the innermost function is one of class Monitor, or a loop made for one.
"""
import pathlib
import re
import subprocess
import sys
import tempfile


def symbols_of(samples):
    """(count, symbol) of perf report's lines "  12.3%  456  [.] symbol"."""
    for line in samples.splitlines():
        found = re.match(r"\s*[\d.]+%\s+(\d+)\s+\[.\]\s+(.*\S)", line)
        if found:
            yield int(found.group(1)), found.group(2)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    packstone, scene, *options = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        data = str(pathlib.Path(folder) / "perf.data")
        run = [packstone, "run", scene, "-o", str(pathlib.Path(folder) / "run"), "--quiet", *options]
        subprocess.run(["perf", "record", "-q", "-e", "cpu-clock", "-F", "1999", "-o", data, *run], check=True)
        report = subprocess.run(["perf", "report", "-i", data, "--stdio", "--no-children", "-F", "overhead,sample,symbol"],
                                check=True, capture_output=True, text=True).stdout
    everything = list(symbols_of(report))
    total = sum(count for count, _ in everything)
    watching = [(count, symbol) for count, symbol in everything if "Monitor::" in symbol]
    share = sum(count for count, _ in watching) / total
    print(f"{scene}: monitor {100 * share:.3f} % of {total} samples")
    for count, symbol in watching:
        print(f"  {100 * count / total:.3f} %  {symbol[:100]}")


if __name__ == "__main__":
    main()
