#!/usr/bin/python3
"""A friction problem by Siconos' solvers, each in a process of its own from r = 0 to 1e-8 of its own measure; the best is the one
with the least CPU time that gets below 20 times that. siconos_solvers.py FILE [SECONDS of processor time that a solver may take]"""
import json
import multiprocessing
import os
import resource
import sys
import time

import h5py
import numpy as np

TOLERANCE = 1e-8
SOLVERS = ("NSGS NSGS_POC NSN_AC NSN_AC_HYB NSN_FB NSN_NM ADMM PROX_NSN VI_EG VI_FPP TFP ACLMFP").split()
FLAT = "NSGS LEMKE".split()  # of problems in the plane


def load(path):
    """u = W r + q, components (n, t1, t2) or (n, t1) point by point; W symmetric, stored row by row from its diagonal on, or as a
    run leaves it, then scaled as the others are."""
    with h5py.File(path) as f:
        if "W" in f:
            points = f["points"][:]
            if f["dim"][0] < 2 or (points[:, 2] >= 0).any() or (f["friction"][:] >= 0).any() or "shift" in f:
                raise ValueError(path + " is not a dry problem with friction")
            W, q = f["W"][:].T, f["free"][:]
            return W / np.diag(W).mean(), q / np.abs(q).max(), points[:, 1]
        q, mu = f["q"][:], f["mu"][:]
        W = np.zeros((len(q), len(q)))
        W[np.triu_indices(len(q))] = f["W_upper_packed"][:]
    return W + np.triu(W, 1).T, q, mu


def project(x, mu):
    """On the cones |x_t| <= mu x_n."""
    x = x.reshape(len(mu), -1)
    n, t = x[:, 0], np.linalg.norm(x[:, 1:], axis=1)
    y = np.where((t <= mu * n)[:, None], x, 0.0)
    o = (t > mu * n) & (mu * t > -n)
    y[o, 0] = (mu[o] * t[o] + n[o]) / (1 + mu[o] ** 2)
    y[o, 1:] = (mu[o] * y[o, 0] / t[o])[:, None] * x[o, 1:]
    return y.ravel()


def error(W, q, mu, r):
    """|r - P(r - (u + mu |u_t| n))| / |q|, Siconos' own measure."""
    u = (W @ r + q).reshape(len(mu), -1)
    u[:, 0] += mu * np.linalg.norm(u[:, 1:], axis=1)
    return float(np.linalg.norm(r - project(r - u.ravel(), mu)) / np.linalg.norm(q))


def options(sn, name, dim):
    if dim == 2:
        o = sn.SolverOptions(getattr(sn, "SICONOS_FRICTION_2D_" + name))
        o.dparam[sn.SICONOS_DPARAM_TOL] = TOLERANCE
        o.iparam[sn.SICONOS_IPARAM_MAX_ITER] = 1000000
        return o
    kind = {"NSGS_POC": "NSGS", "NSN_AC_HYB": "NSN_AC", "PROX_NSN": "PROX"}.get(name, name)
    o = sn.SolverOptions(getattr(sn, "SICONOS_FRICTION_3D_" + kind))
    o.dparam[sn.SICONOS_DPARAM_TOL] = TOLERANCE
    most = {"NSN": 1000, "PROX": 10000, "TFP": 10000, "ACLMFP": 10000}
    o.iparam[sn.SICONOS_IPARAM_MAX_ITER] = most.get(name.split("_")[0], 1000000)
    if kind == "NSGS":
        o.iparam[sn.SICONOS_FRICTION_3D_IPARAM_ERROR_EVALUATION] = \
            sn.SICONOS_FRICTION_3D_NSGS_ERROR_EVALUATION_LIGHT_WITH_FULL_FINAL
    if name == "NSGS_POC":
        sn.solver_options_update_internal(o, 0, sn.SICONOS_FRICTION_3D_ONECONTACT_ProjectionOnConeWithLocalIteration)
    if name == "NSN_AC_HYB":
        o.iparam[sn.SICONOS_FRICTION_3D_NSN_HYBRID_STRATEGY] = sn.SICONOS_FRICTION_3D_NSN_HYBRID_STRATEGY_VI_EG_NSN
    return o


def solve(path, name, limit, pipe):
    """Sends what came out: the median time of up to three, or of a second."""
    resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
    quiet = os.open(os.devnull, os.O_WRONLY)
    os.dup2(quiet, 1)
    os.dup2(quiet, 2)
    import siconos.numerics as sn
    W, q, mu = load(path)
    dim = len(q) // len(mu)
    driver = sn.fc3d_driver if dim == 3 else sn.fc2d_driver
    times = []
    while len(times) < 3 and sum(times) < 1.0:
        problem = sn.FrictionContactProblem(dim, len(mu), np.asfortranarray(W), q.copy(), mu.copy())
        r, u, o = np.zeros(len(q)), np.zeros(len(q)), options(sn, name, dim)
        start = time.thread_time()
        driver(problem, r, u, o)
        times.append(time.thread_time() - start)
    moved = W @ r
    pipe.send({"solver": name, "seconds": float(np.median(times)), "iterations": int(o.iparam[sn.SICONOS_IPARAM_ITER_DONE]),
               "error": error(W, q, mu, r), "slip": float(np.linalg.norm(moved + q) / np.linalg.norm(q)),
               "energy": float(r @ moved / (q @ q)), "unknowns": len(q)})


def attempt(path, name, limit):
    """None where it died, took too long, or did not get there."""
    here, there = multiprocessing.Pipe()
    process = multiprocessing.Process(target=solve, args=(path, name, limit, there))
    process.start()
    there.close()
    try:
        found = here.recv()
    except EOFError:
        found = None
    process.join()
    return found if found and found["error"] < 20 * TOLERANCE else None


def main():
    limit = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    answers = {name: attempt(sys.argv[1], name, limit) for name in SOLVERS}
    for name, found in answers.items():
        print(name, "no answer" if found is None else "%(seconds).5f s, %(iterations)d iterations, error %(error).1e" % found)
    good = [found for found in answers.values() if found]
    if not good:
        raise SystemExit("no solver answers")
    best = min(good, key=lambda found: found["seconds"])
    print("RESULT " + json.dumps(dict(best, solved=len(good), tried=len(SOLVERS))))


if __name__ == "__main__":
    main()
