#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2) and the Matrix package of R 1.5-3 (r-cran-matrix 1.5-3-1): a stiffness that
# scipy.io.hb_write writes in the format of Harwell and Boeing.
#
# Guess: the header names the format of the numbers, (3E25.16), and they stand in it: who reads fields of 25 columns, as
#   Fortran does, reads the matrix. hb_read gives it back, after all.
# Instead: each number takes 24 columns, one less than the header says, so that a reader that goes by the header cuts
#   the second and the third number of a line in the wrong place. readHB of R makes them NA, with a warning; of the same
#   file with a blank more before each number it reads all. hb_read does not notice, for it parts numbers at blanks.
# Why it matters: stiffness and mass go from one program to another in this format (HBMAT of Ansys has it).
# A way to live with it: scipy.io.mmwrite; or part the numbers of a line at blanks where their count is that of the
#   header.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2 r-cran-matrix=1.5-3-1 r-base-core=4.2.2.20221110-2

cat >write.py <<'END'
from scipy import sparse
from scipy.io import hb_read, hb_write

stiffness = sparse.diags([[-1e6, -2e6, -5e5], [3e6, 4e6, 3.5e6, 6e5], [-1e6, -2e6, -5e5]], [-1, 0, 1]).tocsc()
stiffness.sort_indices()
hb_write("stiffness.rua", stiffness)
assert abs(hb_read("stiffness.rua") - stiffness).max() == 0.0
lines = open("stiffness.rua").read().splitlines()
print(lines[3].split()[2], "but lines of", max(map(len, lines[6:])), "columns")
with open("wider.rua", "w") as file:
    for i, line in enumerate(lines):
        print("".join(f"{number:>25}" for number in line.split()) if i > 5 else line, file=file)
END
python3 write.py >widths.txt || fail "SciPy does not read what it wrote"
[[ "$(cat widths.txt)" == "(3E25.16) but lines of 72 columns" ]] || fail "$(cat widths.txt)"

numbers_by_r() { # FILE: how many entries R finds, their sum, how many are NA
  echo "library(Matrix); x <- readHB('$1')@x; cat(length(x), sum(x, na.rm = TRUE), sum(is.na(x)), '\n')" >read.R
  r read.R | tail -n 1
}
read -r wider < <(numbers_by_r wider.rua)
read -r as_written < <(numbers_by_r stiffness.rua)
[[ "$wider" == "10 4100000 0" ]] || fail "R reads the wider file as: $wider"
[[ "$as_written" == "10 "*" "[1-9]* ]] || fail "R reads the file as: $as_written"
seen "header $(cat widths.txt); R: entries, sum, NA: as written $as_written, one blank wider $wider"
