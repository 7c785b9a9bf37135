#!/usr/bin/python3
"""Siconos' solvers on the dry problems with friction below a folder: seconds of each that answers, as the table siconos.lua that
study.lua draws. siconos_profile.py DIR [SECONDS of processor time that a solver may take] > siconos.lua"""
import pathlib
import sys
import textwrap

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "friction_problems"))
from siconos_solvers import FLAT, SOLVERS, attempt, load  # noqa: E402


def solvers_for(path):
    """None where the problem is not one of theirs."""
    try:
        W, _, mu = load(path)
    except ValueError:
        return None
    return SOLVERS if len(W) == 3 * len(mu) else FLAT


def main():
    limit = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    top = pathlib.Path(sys.argv[1])
    print("-- Processor seconds of Siconos' solvers on those of the problems that they take, made by siconos_profile.py.")
    print("return {")
    for path in sorted(top.rglob("problems/*.h5")):
        names = solvers_for(str(path))
        if names is None:
            continue
        found = {name: attempt(str(path), name, limit) for name in names}
        own = ["%s = %.3g" % (name, found[name]["seconds"]) for name in names if found[name]]
        line = '["%s"] = { %s },' % (path.relative_to(top).with_suffix(""), ", ".join(own))
        print(textwrap.fill(line, 120, initial_indent="  ", subsequent_indent="    "), flush=True)
    print("}")


if __name__ == "__main__":
    main()
