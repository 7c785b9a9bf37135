#!/usr/bin/python3
"""The slide in GetFEM: large sliding by ray tracing, augmented Lagrangian, semismooth Newton with MUMPS; a step that fails is
halved. getfem_slide.py N MU blatz_ko|neo_hookean"""
import json
import os
import sys

import getfem as gf
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "common"))
from meshes import getfem_mesh, half_disc, on_arc, plate  # noqa: E402

gf.util_trace_level(1)
N, mu, material = int(sys.argv[1]), float(sys.argv[2]), sys.argv[3]
G = 10.0  # MPa
energy = {
    "blatz_ko": "0.5*G*(Norm_sqr(Id(2)+Grad_{0})/sqr(Det(Id(2)+Grad_{0}))+2*Det(Id(2)+Grad_{0})-4)",
    "neo_hookean": "0.5*G*(pow(Det(Id(2)+Grad_{0}),-2/3)*(Norm_sqr(Id(2)+Grad_{0})+1)-3)+(5/6)*G*sqr(Det(Id(2)+Grad_{0})-1)",
}[material]
m1, m2 = getfem_mesh(*half_disc(N)), getfem_mesh(*plate(10 * N, N))
ARC, FLAT, UNDER, TOP = 1, 2, 3, 4
faces = m1.outer_faces()
arc = np.array([on_arc(m1.pts(m1.pid_in_faces(faces[:, k:k + 1])).T) for k in range(faces.shape[1])])
m1.set_region(ARC, faces[:, arc])
m1.set_region(FLAT, m1.outer_faces_with_direction([0, -1], .01))
m2.set_region(UNDER, m2.outer_faces_with_direction([0, -1], .01))
m2.set_region(TOP, m2.outer_faces_with_direction([0, 1], .01))
mf1, mf2, mfl = gf.MeshFem(m1, 2), gf.MeshFem(m2, 2), gf.MeshFem(m1, 2)
for field in (mf1, mf2, mfl):
    field.set_classical_fem(1)
gauss = gf.Integ("IM_GAUSS_PARALLELEPIPED(2,3)")
mim1, mim2 = gf.MeshIm(m1, gauss), gf.MeshIm(m2, gauss)
mim_contact = gf.MeshIm(m1, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,5)"))
md = gf.Model("real")
md.add_fem_variable("u1", mf1)
md.add_fem_variable("u2", mf2)
md.add_filtered_fem_variable("lam", mfl, ARC)
for name, value in (("G", G), ("held", [0., 0.]), ("driven", [0., 0.]), ("r", G), ("mu", mu), ("alpha", 1.)):
    md.add_initialized_data(name, value)
md.add_nonlinear_term(mim1, energy.format("u1"))
md.add_nonlinear_term(mim2, energy.format("u2"))
md.add_Dirichlet_condition_with_simplification("u1", FLAT, "held")
md.add_Dirichlet_condition_with_simplification("u2", TOP, "driven")
md.add_fem_data("w1", mf1)
md.add_fem_data("w2", mf2)
brick = md.add_integral_large_sliding_contact_brick_raytracing("r", 1.8, "mu", "alpha", 0)
md.add_slave_contact_boundary_to_large_sliding_contact_brick(brick, mim_contact, ARC, "u1", "lam", "w1")
md.add_master_contact_boundary_to_large_sliding_contact_brick(brick, mim2, UNDER, "u2", "w2")
top = mf2.basic_dof_on_region(TOP)
iterations = 0


def reaction():
    force = gf.asm("generic", mim2, 1, energy.format("u2"), -1, md)
    first, count = md.interval_of_variable("u2")
    force = force[first:first + count]
    return float(force[top[0::2]].sum()), float(force[top[1::2]].sum())


def advance(start, end):
    """From one place of the plate's top to another."""
    global iterations
    ends, now, failures = [end], start, 0
    while ends:
        kept = {name: md.variable(name).copy() for name in ("u1", "u2", "lam")}
        md.set_variable("w1", kept["u1"])
        md.set_variable("w2", kept["u2"])
        md.set_variable("driven", ends[-1])
        try:
            count, converged = md.solve("max_res", 1e-7, "max_iter", 25, "lsolver", "mumps", "lsearch", "simplest",
                                        "alpha min", .4)
        except RuntimeError:
            count, converged = 25, False
        iterations += int(count)
        if converged:
            now = ends.pop()
            continue
        failures += 1
        if failures > 60 or len(ends) > 6:
            raise SystemExit("did not converge at %s" % ends[-1])
        for name, value in kept.items():
            md.set_variable(name, value)
        ends.append(0.5 * (now + ends[-1]))


path = [np.array([0., -(k + 1) / 10]) for k in range(10)] + [np.array([(k + 1) / 10, -1.]) for k in range(40)]
place, forces = np.zeros(2), []
for target in path:
    advance(place, target)
    place = target
    forces.append(reaction())
print("RESULT " + json.dumps({"unknowns": int(md.nbdof()), "iterations": iterations, "press": -forces[9][1],
                              "drag": forces[-1][0], "normal": -forces[-1][1]}))
