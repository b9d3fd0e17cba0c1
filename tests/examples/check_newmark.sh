#!/usr/bin/env bash
# The integrators of examples/c and examples/fortran agree with `microslip march` and with each other; the second where
# there is a gfortran.
# Usage: check_newmark.sh EXAMPLES HEADERS MODULE FOLDER_OF_THE_LIBRARY PROGRAM CC
set -euo pipefail
examples="$1" headers="$2" module="$3" library="$4" program="$5" cc="$6"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$work"
link=(-L"$library" -lmicroslip_c "-Wl,-rpath,$library")

# largest_difference FILE COLUMN FILE COLUMN: over the largest value of the second; columns from 1, rows alike.
largest_difference() {
  paste -d, <(grep -v '^#' "$1" | cut -d, -f"$2") <(grep -v '^#' "$3" | cut -d, -f"$4") | awk -F, '
    NR > 1 { d = $1 - $2; if (d < 0) d = -d; v = $2 < 0 ? -$2 : $2; if (d > most) most = d; if (v > peak) peak = v }
    END { if (NR < 20000 || peak == 0) exit 1; printf "%.3g\n", most / peak }'
}

# expect_below WHAT DIFFERENCE LIMIT
expect_below() {
  echo "$1: $2 of the largest displacement, at most $3"
  awk -v d="$2" -v limit="$3" 'BEGIN { exit !(d <= limit) }'
}

"$cc" -std=c99 -Wall -Wextra -pedantic -Werror -I"$headers" "$examples/c/newmark.c" -o newmark "${link[@]}" -lm
./newmark c.csv
if ./newmark nowhere/c.csv 2>message; then echo "a table that cannot be written is no error" >&2; exit 1; fi
grep -q '^nowhere/c.csv: ' message
"$program" march "$examples/one_mass/model.toml" --force-file c.csv --out march.csv --quiet
column="$(awk -F, '!/^#/ { for (i = 1; i <= NF; ++i) if ($i == "displacement [m]") print i; exit }' march.csv)"
# (2 pi/2000)^2/12 of each of ten periods is 5e-5.
expect_below "C and march" "$(largest_difference c.csv 3 march.csv "$column")" 1e-4

command -v gfortran >/dev/null || { echo "SKIPPED: no gfortran"; exit 0; }
gfortran -std=f2008 -O2 -Wall -Wextra -Werror "$module" "$examples/fortran/newmark.f90" -o newmark_fortran "${link[@]}"
./newmark_fortran fortran.csv
# The same operations; compilers may round them in another order, twenty thousand steps long.
expect_below "Fortran and C" "$(largest_difference fortran.csv 3 c.csv 3)" 1e-9
