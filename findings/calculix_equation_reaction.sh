#!/usr/bin/env bash
# CalculiX 2.20 (calculix-ccx 2.20-1): a block is pulled by a node to which *EQUATION ties its face, and RF is printed.
#
# Guess: the node is moved, so its RF is the force that this takes, as Abaqus has it: E A u / L.
# Instead: RF of the node is 0. What the equations carry to it is in no reaction; it shows as RF of the nodes that the
#   equations take away, which nothing holds and where a reaction should be 0. Their total is the force.
# Why it matters: force-displacement loops of a joint or a specimen behind a reference node are read from that node;
#   they are 0, or the share of the elements that touch it directly, without a message.
# A way to live with it: *NODE PRINT, TOTALS=ONLY of the set of the tied nodes, or a stiff spring in front of the node.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian calculix-ccx=2.20-1

cat >pull.inp <<END
*NODE, NSET=ALL
1, 0., 0., 0.
2, 10., 0., 0.
3, 10., 10., 0.
4, 0., 10., 0.
5, 0., 0., 10.
6, 10., 0., 10.
7, 10., 10., 10.
8, 0., 10., 10.
*NODE, NSET=PULLED
9, 20., 0., 0.
*NSET, NSET=FACE
2, 3, 6, 7
*ELEMENT, TYPE=C3D8, ELSET=BLOCK
1, 1, 2, 3, 4, 5, 6, 7, 8
*MATERIAL, NAME=STEEL
*ELASTIC
2.1E5, 0.
*SOLID SECTION, ELSET=BLOCK, MATERIAL=STEEL
*EQUATION
2
2, 1, 1., 9, 1, -1.
*EQUATION
2
3, 1, 1., 9, 1, -1.
*EQUATION
2
6, 1, 1., 9, 1, -1.
*EQUATION
2
7, 1, 1., 9, 1, -1.
*BOUNDARY
1, 1, 3
4, 1, 1
4, 3, 3
5, 1, 2
8, 1, 1
9, 2, 3
*STEP
*STATIC
*BOUNDARY
9, 1, 1, 0.01
*NODE PRINT, NSET=PULLED
U, RF
*NODE PRINT, NSET=FACE, TOTALS=ONLY
RF
*END STEP
END
ccx pull >pull.log || fail "ccx: $(grep -A 2 ERROR pull.log)"

read -r moved node face < <(awk '/displacements/ { kind = "u" } /forces .*PULLED/ { kind = "rf" }
  /total force/ { kind = "total" }
  kind == "u" && $1 == 9 { moved = $2 } kind == "rf" && $1 == 9 { node = $2 }
  kind == "total" && NF == 3 { face = $1 }
  END { print moved, node + 0, face }' pull.dat)
holds "$moved == 0.01" "the node moves by $moved mm"
holds "$node > -1e-6 && $node < 1e-6" "RF of the node is $node N"
holds "$face > 20999 && $face < 21001" "the total of the tied nodes is $face N" # E A u / L = 2.1e5 100 0.01 / 10
seen "the node moves by $moved mm with RF $node N, while the nodes tied to it have $face N together"
