"""Writing, running and reading decks of CalculiX (ccx); scratch goes to a folder that is removed."""
import os
import subprocess
import tempfile


def nodes(f, points, offset=0):
    f.write("*NODE\n")
    for i, x in enumerate(points):
        f.write("%d,%.12g,%.12g,%.12g\n" % (i + 1 + offset, *x))


def cells(f, list_of_cells, name, offset=0, node_offset=0):
    f.write("*ELEMENT,TYPE=C3D8,ELSET=%s\n" % name)
    for i, cell in enumerate(list_of_cells):
        f.write("%d,%s\n" % (i + 1 + offset, ",".join(str(n + 1 + node_offset) for n in cell)))


def node_set(f, name, numbers):
    f.write("*NSET,NSET=%s\n" % name)
    for n in numbers:
        f.write("%d,\n" % n)


def run(write):
    """write(file) makes the deck. Iterations in all, and by increment (time, total reaction); fails if the job does."""
    with tempfile.TemporaryDirectory() as folder:
        with open(folder + "/job.inp", "w") as f:
            write(f)
        job = subprocess.run(["ccx", "-i", "job"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             env=dict(os.environ, CCX_NPROC_EQUATION_SOLVER="1", NUMBER_OF_CPUS="1"))
        if "Job finished" not in job.stdout:
            raise SystemExit("ccx: " + job.stdout[-400:])
        with open(folder + "/job.sta") as f:
            rows = [line.split() for line in f]
        with open(folder + "/job.dat") as f:
            forces = totals(f)
    return sum(int(row[3]) for row in rows if len(row) >= 7 and row[0].isdigit()), forces


def totals(lines):
    """The blocks "total force (...) for set TOP and time T", each with one row of three numbers."""
    found, time = [], None
    for line in lines:
        if line.strip().startswith("total force"):
            time = float(line.split()[-1])
        elif time is not None and line.split():
            found.append((time, [float(x) for x in line.split()]))
            time = None
    return found
