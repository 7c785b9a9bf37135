#!/usr/bin/python3
"""The block in GetFEM: integral contact by an augmented Lagrangian, semismooth Newton with MUMPS. getfem_block.py N"""
import json
import os
import sys

import getfem as gf
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "common"))
from meshes import getfem_mesh, hex_grid  # noqa: E402

N = int(sys.argv[1])
L, H, E, nu, mu, press, shear, steps = 40., 20., 5., .3, .3, .4, .25, 10  # mm, MPa
mesh = getfem_mesh(*hex_grid(np.linspace(0, L, N + 1), np.linspace(0, L, N + 1), np.linspace(0, H, N // 2 + 1)))
BOTTOM, TOP = 1, 2
mesh.set_region(BOTTOM, mesh.outer_faces_with_direction([0, 0, -1], .01))
mesh.set_region(TOP, mesh.outer_faces_with_direction([0, 0, 1], .01))
fields = [gf.MeshFem(mesh, components) for components in (3, 3, 1)]
for field in fields:
    field.set_classical_fem(1)
mfu, mfl, mfo = fields
mim = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(3,3)"))
md = gf.Model("real")
md.add_fem_variable("u", mfu)
md.add_filtered_fem_variable("lam", mfl, BOTTOM)
md.add_initialized_data("lambda", E * nu / (1 + nu) / (1 - 2 * nu))
md.add_initialized_data("G", E / 2 / (1 + nu))
md.add_isotropic_linearized_elasticity_brick(mim, "u", "lambda", "G")
md.add_initialized_data("driven", [0., 0., 0.])
md.add_Dirichlet_condition_with_simplification("u", TOP, "driven")
md.add_initialized_fem_data("obstacle", mfo, mfo.eval("z"))
md.add_initialized_data("r", E)
md.add_initialized_data("mu", mu)
md.add_initialized_data("alpha", 1.)
md.add_fem_data("before", mfu)
md.add_integral_contact_with_rigid_obstacle_brick(mim, "u", "lam", "obstacle", "r", "mu", BOTTOM, 1, "alpha", "before")
iterations, forces = 0, []
before = np.zeros(mfu.nbdof())
for step in range(steps + 1):
    md.set_variable("driven", [shear * step / steps, 0., -press])
    md.set_variable("before", before)
    count, converged = md.solve("max_res", 1e-8, "max_iter", 60, "lsolver", "mumps", "lsearch", "simplest")
    if not converged:
        raise SystemExit("step %d did not converge" % step)
    iterations += int(count)
    before = md.variable("u").copy()
    forces.append(gf.asm("generic", mim, 0, "lam", BOTTOM, md))
print("RESULT " + json.dumps({"unknowns": int(md.nbdof()), "iterations": iterations, "press": abs(float(forces[0][2])),
                              "drag": abs(float(forces[-1][0])), "normal": abs(float(forces[-1][2]))}))
