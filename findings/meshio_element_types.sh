#!/usr/bin/env bash
# meshio 5.0.0 (python3-meshio 7.0.0-3) reads a mesh of Abaqus or CalculiX and writes it again, also for Nastran.
#
# Guess: C3D8 stays C3D8, C3D10 stays C3D10; for Nastran they become CHEXA and CTETRA.
# Instead: C3D8 becomes C3D8RH, C3D20 becomes C3D20RH and C3D10 becomes C3D10MH: other elements of Abaqus, hybrid ones
#   with reduced integration or modified. Elements with nodes on their edges become CHEXA_ and CTETRA_ for Nastran,
#   which are no names of its cards. meshio keeps shapes, not types, and writes the last type of its list that has the
#   shape.
# Why it matters: in Abaqus the model runs on with other elements, one integration point in the place of eight, and
#   frequencies of bending change with a conversion that says nothing. CalculiX refuses C3D8RH.
# A way to live with it: replace the types in the file that was written (sed), and compare frequencies before and after.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-meshio=7.0.0-3 calculix-ccx=2.20-1

cat >convert.py <<'END'
import re
import sys

import meshio
import numpy as np

corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1.0]])
edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
tetrahedron = corners[[0, 1, 3, 4]]
points = {
    "C3D8": corners,
    "C3D20": np.vstack([corners, [corners[[i, j]].mean(axis=0) for i, j in edges]]),
    "C3D10": np.vstack([tetrahedron, [tetrahedron[[i, j]].mean(axis=0)
                                      for i, j in ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))]]),
}
for name, nodes in points.items():
    with open("mesh.inp", "w") as file:
        file.write("*NODE\n" + "".join(f"{i + 1}, {x}, {y}, {z}\n" for i, (x, y, z) in enumerate(nodes)))
        numbers = [str(i + 1) for i in range(len(nodes))]
        file.write(f"*ELEMENT, TYPE={name}, ELSET=ALL\n1, " + ", ".join(numbers[:10]))
        file.write((",\n" + ", ".join(numbers[10:]) if len(nodes) > 10 else "") + "\n")
    mesh = meshio.read("mesh.inp")
    mesh.write("again.inp")
    mesh.write("again.bdf")
    print(name, re.search(r"TYPE=(\w+)", open("again.inp").read()).group(1),
          re.search(r"^(C\w+)", open("again.bdf").read(), re.MULTILINE).group(1))
    if name == "C3D8":
        open("refused.inp", "w").write(open("again.inp").read())
END
python3 convert.py >types.txt 2>convert.log || fail "meshio: $(tail -n 1 convert.log)"
types="$(xargs <types.txt)"
[[ "$types" == "C3D8 C3D8RH CHEXA C3D20 C3D20RH CHEXA_ C3D10 C3D10MH CTETRA_" ]] || fail "the types are others: $types"
ccx refused >refused.log || true
grep -q "C3D8RH   is an unknown element type" refused.log || fail "CalculiX takes C3D8RH"
seen "each type, in Abaqus and in Nastran after it: $types"
