# Mesh of the two leaves for CalculiX, in mm: bricks of 8 nodes with incompatible modes. The lower leaf has a pad
# under each bolt; there both leaves have nodes of their own at the same places, tied across the face and
# along y. What is left free, sliding along x, is the joint's.

function grid(values, from, to, step,   n) {
  for (n = 0; from + n*step <= to; ++n) values[n + 1] = from + n*step
  return n
}

# The node of a leaf at x[i], y[j], z[k]; written when it is first asked for.
function node(leaf, i, j, k,   place) {
  place = leaf " " x[i] " " y[j] " " z[k]
  if (!(place in number)) {
    number[place] = ++nodes
    print nodes ", " x[i] ", " y[j] ", " z[k]
  }
  return number[place]
}

function face(leaf, i, j, k) {
  return node(leaf, i, j, k) ", " node(leaf, i + 1, j, k) ", " node(leaf, i + 1, j + 1, k) ", " node(leaf, i, j + 1, k)
}

function block(leaf, x0, x1, z0, z1, height,   nx, ny, nz, i, j, k) {
  nx = grid(x, x0, x1, 10); ny = grid(y, 0, 30, 10); nz = grid(z, z0, z1, height)
  for (k = 1; k < nz; ++k)
    for (j = 1; j < ny; ++j)
      for (i = 1; i < nx; ++i) bricks[++elements] = face(leaf, i, j, k) ", " face(leaf, i, j, k + 1)
}

function set(name, leaf, x0, x1, z0, z1, step,   nx, ny, nz, i, j, k) {
  print "*NSET, NSET=" name
  nx = grid(x, x0, x1, 10); ny = grid(y, 0, 30, 10); nz = grid(z, z0, z1, step)
  for (i = 1; i <= nx; ++i)
    for (j = 1; j <= ny; ++j)
      for (k = 1; k <= nz; ++k) print node(leaf, i, j, k)
}

function bolt(name, x0, x1,   nx, ny, i, j, d) {
  set(name "_lower", "lower", x0, x1, 16, 16, 1)
  set(name "_upper", "upper", x0, x1, 16, 16, 1)
  nx = grid(x, x0, x1, 10); ny = grid(y, 0, 30, 10)
  for (i = 1; i <= nx; ++i)
    for (j = 1; j <= ny; ++j)
      for (d = 2; d <= 3; ++d)
        printf "*EQUATION\n2\n%d, %d, 1., %d, %d, -1.\n", node("upper", i, j, 1), d, node("lower", i, j, 1), d
}

BEGIN {
  print "*NODE"
  block("lower", 0, 480, 0, 12, 6)
  block("lower", 200, 230, 12, 16, 4)
  block("lower", 450, 480, 12, 16, 4)
  block("upper", 0, 480, 16, 28, 6)
  print "*ELEMENT, TYPE=C3D8I, ELSET=all"
  for (e = 1; e <= elements; ++e) print e ", " bricks[e]
  set("lower_root", "lower", 0, 0, 0, 12, 6)
  set("upper_root", "upper", 0, 0, 16, 28, 6)
  set("middle", "upper", 300, 300, 22, 22, 1)
  set("tip", "upper", 480, 480, 22, 22, 1)
  bolt("inner", 200, 230)
  bolt("outer", 450, 480)
}
