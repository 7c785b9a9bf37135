#!/usr/bin/python3
"""The slide in CalculiX: the same meshes, one cell thick, plane strain; contact by penalty, surface to surface, steps of its own
choice. Neo-Hookean alone: ccx 2.20 ends in *HYPERFOAM. calculix_slide.py N MU"""
import json
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "common"))
import calculix  # noqa: E402
from meshes import half_disc, on_arc, plate  # noqa: E402

N, mu = int(sys.argv[1]), float(sys.argv[2])
G, penalty = 10., 500.  # MPa, MPa/mm


def thick(nodes, quads):
    layers = [np.column_stack([nodes, np.full(len(nodes), z)]) for z in (0., 1.)]
    return np.vstack(layers), np.hstack([quads, quads + len(nodes)])


def faces(nodes, quads, wanted):
    """Cells and sides (S3 to S6 round the axis) of which an edge is wanted."""
    return [(e, k + 3) for e, c in enumerate(quads) for k in range(4) if wanted(nodes[[c[k], c[(k + 1) % 4]]])]


disc, slab = half_disc(N), plate(10 * N, N)
(P1, E1), (P2, E2) = thick(*disc), thick(*slab)
arc = faces(*disc, on_arc)
under = faces(*slab, lambda X: np.all(np.abs(X[:, 1] - 5) < 1e-9))


def write(f):
    calculix.nodes(f, P1)
    calculix.nodes(f, P2, len(P1))
    calculix.cells(f, E1, "DISC")
    calculix.cells(f, E2, "PLATE", len(E1), len(P1))
    calculix.node_set(f, "ALL", range(1, len(P1) + len(P2) + 1))
    calculix.node_set(f, "FLAT", 1 + np.where(P1[:, 1] < 1e-9)[0])
    calculix.node_set(f, "TOP", len(P1) + 1 + np.where(P2[:, 1] > 7 - 1e-9)[0])
    f.write("*SURFACE,NAME=SLAVE,TYPE=ELEMENT\n" + "".join("%d,S%d\n" % (e + 1, s) for e, s in arc))
    f.write("*SURFACE,NAME=MASTER,TYPE=ELEMENT\n" + "".join("%d,S%d\n" % (len(E1) + e + 1, s) for e, s in under))
    f.write("*MATERIAL,NAME=RUBBER\n*HYPERELASTIC,NEO HOOKE\n%.12g,%.12g\n" % (G / 2, 6 / (5 * G)))
    f.write("*SOLID SECTION,ELSET=DISC,MATERIAL=RUBBER\n*SOLID SECTION,ELSET=PLATE,MATERIAL=RUBBER\n")
    f.write("*SURFACE INTERACTION,NAME=SOLE\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR\n%g\n" % penalty)
    f.write("*FRICTION\n%g,%g\n" % (mu, penalty / 10))
    f.write("*CONTACT PAIR,INTERACTION=SOLE,TYPE=SURFACE TO SURFACE\nSLAVE,MASTER\n*BOUNDARY\nALL,3,3\nFLAT,1,2\n")
    for stage in range(2):
        step = 0.1 if stage == 0 else 0.025
        f.write("*STEP,NLGEOM,INC=2000\n*STATIC,SOLVER=SPOOLES\n%g,1.,1e-6,%g\n" % (step, step))
        f.write("*BOUNDARY\nTOP,1,1,%g\nTOP,2,2,-1.\n" % (4 * stage))
        f.write("*NODE PRINT,NSET=TOP,TOTALS=ONLY,FREQUENCY=1\nRF\n*END STEP\n")


iterations, forces = calculix.run(write)
pressed = [force for time, force in forces if time <= 1 + 1e-9][-1]
print("RESULT " + json.dumps({"unknowns": 2 * (len(disc[0]) + len(slab[0])), "iterations": iterations, "press": -pressed[1],
                              "drag": forces[-1][1][0], "normal": -forces[-1][1][1]}))
