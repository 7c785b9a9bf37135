"""Structured meshes of the cases as numpy arrays, and as GetFEM's meshes; "meshes.py N" prints the half disc for gmsh's readers."""
import sys

import numpy as np


def hex_grid(xs, ys, zs):
    """Nodes, x fastest, and hexahedra: the lower face counter-clockwise, then the upper one."""
    Z, Y, X = np.meshgrid(zs, ys, xs, indexing="ij")
    nx, ny, nz = len(xs) - 1, len(ys) - 1, len(zs) - 1
    k, j, i = (a.ravel() for a in np.meshgrid(np.arange(nz), np.arange(ny), np.arange(nx), indexing="ij"))

    def at(a, b, c):
        return a + (nx + 1) * (b + (ny + 1) * c)

    face = [(0, 0), (1, 0), (1, 1), (0, 1)]
    cells = np.column_stack([at(i + a, j + b, k + c) for c in (0, 1) for a, b in face])
    return np.column_stack([X.ravel(), Y.ravel(), Z.ravel()]), cells


def half_disc(N, R=5.0):
    """Nodes and quadrilaterals of the upper half disc, flat side y = 0: an inner half square |x| <= R/2 of 2N x N cells, and
    round it N layers of 4N cells."""
    c, number, nodes, quads = R / 2, {}, [], []

    def add(x, y):
        key = (round(x, 9), round(y, 9))
        if key not in number:
            number[key] = len(nodes)
            nodes.append((x, y))
        return number[key]

    for j in range(N):
        for i in range(2 * N):
            corners = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
            quads.append([add(-c + c * a / N, c * b / N) for a, b in corners])
    outline = ([(c, c * i / N) for i in range(N)] + [(c - c * i / N, c) for i in range(2 * N)]
               + [(-c, c - c * i / N) for i in range(N + 1)])

    def point(k, m):
        s, angle = m / N, np.pi * k / (4 * N)
        return add((1 - s) * outline[k][0] + s * R * np.cos(angle), (1 - s) * outline[k][1] + s * R * np.sin(angle))

    for k in range(4 * N):
        for m in range(N):
            quads.append([point(k, m), point(k, m + 1), point(k + 1, m + 1), point(k + 1, m)])
    nodes = np.array(nodes)
    nodes[np.abs(nodes) < 1e-9] = 0.0
    return nodes, np.array(quads)


def on_arc(X, R=5.0):
    """Whether the points (rows) are an edge of the half disc's contact surface."""
    return bool(np.all(np.abs(np.hypot(X[:, 0], X[:, 1]) - R) < 1e-6) and X[:, 1].min() > 2.0)


def plate(nx, ny, length=20.0, height=2.0, x0=-12.0, y0=5.0):
    x, y = np.linspace(x0, x0 + length, nx + 1), np.linspace(y0, y0 + height, ny + 1)
    Y, X = np.meshgrid(y, x, indexing="ij")

    def at(i, j):
        return i + (nx + 1) * j

    quads = [[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)] for j in range(ny) for i in range(nx)]
    return np.column_stack([X.ravel(), Y.ravel()]), np.array(quads)


def getfem_mesh(nodes, cells):
    """GetFEM numbers the corners of a cell lexicographically."""
    import getfem
    dim = nodes.shape[1]
    order = [0, 1, 3, 2, 4, 5, 7, 6][:2 ** dim]
    mesh = getfem.Mesh("empty", dim)
    mesh.add_convex(getfem.GeoTrans("GT_QK(%d,1)" % dim), nodes[cells[:, order]].transpose(2, 1, 0))
    return mesh


def print_disc(N):
    nodes, quads = half_disc(N)
    lines = []
    for cell in quads:
        for a, b in zip(cell, np.roll(cell, -1)):
            X = nodes[[a, b]]
            if on_arc(X) or np.all(X[:, 1] < 1e-9):
                lines.append((2 if on_arc(X) else 1, a + 1, b + 1))
    print('$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 "flat"\n1 2 "arc"\n2 3 "disc"\n$EndPhysicalNames')
    print("$Nodes\n%d" % len(nodes))
    for i, (x, y) in enumerate(nodes):
        print("%d %.12g %.12g 0" % (i + 1, x, y))
    print("$EndNodes\n$Elements\n%d" % (len(lines) + len(quads)))
    for k, (tag, a, b) in enumerate(lines):
        print(k + 1, 1, 2, tag, tag, a, b)
    for k, cell in enumerate(quads):
        print(len(lines) + k + 1, 3, 2, 3, 3, *(cell + 1))
    print("$EndElements")


if __name__ == "__main__":
    print_disc(int(sys.argv[1]))
