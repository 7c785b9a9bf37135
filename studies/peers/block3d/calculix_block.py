#!/usr/bin/python3
"""The block in CalculiX: mortar contact (LINMORTAR) with a rigid block below, Newton with SPOOLES. calculix_block.py N"""
import json
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "common"))
import calculix  # noqa: E402
from meshes import hex_grid  # noqa: E402

N = int(sys.argv[1])
L, H, E, nu, mu, press, shear, steps = 40., 20., 5., .3, .3, .4, .25, 10  # mm, MPa
nodes, cells = hex_grid(np.linspace(0, L, N + 1), np.linspace(0, L, N + 1), np.linspace(0, H, N // 2 + 1))
floor, floor_cell = hex_grid(np.array([-20., 60.]), np.array([-20., 60.]), np.array([-10., 0.]))


def write(f):
    calculix.nodes(f, nodes)
    calculix.nodes(f, floor, len(nodes))
    calculix.cells(f, cells, "BLOCK")
    calculix.cells(f, floor_cell, "FLOOR", len(cells), len(nodes))
    calculix.node_set(f, "TOP", 1 + np.where(nodes[:, 2] > H - 1e-9)[0])
    calculix.node_set(f, "HELD", len(nodes) + 1 + np.arange(8))
    f.write("*SURFACE,NAME=SLAVE,TYPE=ELEMENT\n" + "".join("%d,S1\n" % (e + 1) for e in range(N * N)))
    f.write("*SURFACE,NAME=MASTER,TYPE=ELEMENT\n%d,S2\n" % (len(cells) + 1))
    f.write("*MATERIAL,NAME=RUBBER\n*ELASTIC\n%g,%g\n" % (E, nu))
    f.write("*SOLID SECTION,ELSET=BLOCK,MATERIAL=RUBBER\n*SOLID SECTION,ELSET=FLOOR,MATERIAL=RUBBER\n")
    f.write("*SURFACE INTERACTION,NAME=SOLE\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=HARD\n*FRICTION\n%g,250.\n" % mu)
    f.write("*CONTACT PAIR,INTERACTION=SOLE,TYPE=LINMORTAR\nSLAVE,MASTER\n*BOUNDARY\nHELD,1,3\n")
    for stage in range(2):
        f.write("*STEP,INC=1000\n*STATIC,DIRECT,SOLVER=SPOOLES\n%g,1.\n" % (1 if stage == 0 else 1 / steps))
        if stage == 0:
            f.write("*CONTROLS,PARAMETERS=FIELD\n1e-7,1e-6,,,1e-6,,,\n")
        f.write("*BOUNDARY\nTOP,1,1,%g\nTOP,2,2,0.\nTOP,3,3,%g\n" % (stage * shear, -press))
        f.write("*NODE PRINT,NSET=TOP,TOTALS=ONLY,FREQUENCY=1\nRF\n*END STEP\n")


iterations, forces = calculix.run(write)
print("RESULT " + json.dumps({"unknowns": 3 * len(nodes), "iterations": iterations, "press": -forces[0][1][2],
                              "drag": forces[-1][1][0], "normal": -forces[-1][1][2]}))
