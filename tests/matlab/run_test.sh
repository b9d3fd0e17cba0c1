#!/usr/bin/env bash
# Runs one test of the package by Octave; without Octave, or what its pictures need, it ends with 77.
# Usage: run_test.sh TEST PACKAGE MEX_FOLDER LIBRARY_FOLDER PROGRAM REFERENCE EXAMPLES
set -euo pipefail
test="$1" package="$2" mex="$3" library="$4" program="$5" reference="$6" examples="$7"
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
lacks() { echo "skipped: no $1, scripts/setup installs it"; exit 77; }
command -v octave-cli >/dev/null || lacks octave-cli
[[ -f "$mex/microslip_mex.mex" ]] || lacks "mkoctfile when this was built"
if [[ "$test" == plot_test ]]; then
  command -v gnuplot >/dev/null || lacks gnuplot
  [[ -n "$(find /usr/share/fonts -name 'FreeSans.*' -print -quit)" ]] || lacks "font FreeSans"
fi

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
case "$test" in
  same_bits_test) "$reference" "$examples" "$work" ;;
  files_test)
    "$program" identify "$examples/brake_reuss_beam/levels.csv" --stiffness 1e7 --linear-damping fit --quiet \
      --out "$work/joint.json"
    "$program" loop "$examples/reference_joint/joint.json" --amplitude 1e-4 --points 50 --quiet --out "$work/loop.csv"
    ;;
esac
export LD_LIBRARY_PATH="$library${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
octave-cli --norc --quiet --eval "
  addpath('$package'); addpath('$mex'); addpath('$here');
  try
    $test('$examples', '${PICTURES:-$work}');
  catch e
    disp(e.message); for s = e.stack', printf('  %s:%d\n', s.name, s.line); end
    exit(1);
  end
  disp('$test: all is well');"
