#!/usr/bin/python3
"""Siconos' solvers on the dry problems in space below a folder: how many each answers, and in what multiple of the least time.
siconos_profile.py DIR [SECONDS of processor time that a solver may take]"""
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "friction_problems"))
from siconos_solvers import SOLVERS, attempt, load  # noqa: E402


def dry_in_space(path):
    try:
        return load(path) is not None
    except ValueError:
        return False


def main():
    limit = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    files = sorted(str(p) for p in pathlib.Path(sys.argv[1]).rglob("problems/*.h5") if dry_in_space(str(p)))
    found = {path: {name: attempt(path, name, limit) for name in SOLVERS} for path in files}
    print("%d problems, %d answered by at least one" % (len(files), sum(any(own.values()) for own in found.values())))
    for name in SOLVERS:
        ratios = []
        for own in found.values():
            if own[name]:
                ratios.append(own[name]["seconds"] / min(other["seconds"] for other in own.values() if other))
        print("%-12s %4d answered, median %.1f of the least time" % (name, len(ratios), statistics.median(ratios or [0])))


if __name__ == "__main__":
    main()
