#!/usr/bin/env bash
# Runs an example in Python as a user does, with the folder of its pictures as argument. Fails where it prints
# nothing beside them or leaves no picture; ends with 77 where the module was not built or matplotlib is missing.
# Usage: run_python_example.sh PYTHON FOLDER_OF_THE_MODULE SCRIPT
set -euo pipefail
python="$1" module="$2" script="$3"

if ! compgen -G "$module/microslip/_core.*" >/dev/null; then
  echo "$script: not run, the Python module was not built" >&2
  exit 77
fi
for needed in matplotlib scipy; do # looked up, not imported, which takes a second
  "$python" -c "import importlib.util as u, sys; sys.exit(u.find_spec('$needed') is None)" && continue
  echo "$script: not run, $python has no $needed" >&2
  exit 77
done

pictures="$(mktemp -d)"
trap 'rm -rf "$pictures"' EXIT
printed="$(MPLBACKEND=Agg PYTHONPATH="$module" PYTHONDONTWRITEBYTECODE=1 "$python" "$script" "$pictures" 2>&1)"
echo "$printed"
if grep -q 'Warning:' <<<"$printed"; then
  echo "$script: a warning" >&2
  exit 1
fi
grep -qv '^picture: ' <<<"$printed" || { echo "$script: it says nothing of what it found" >&2; exit 1; }
for picture in "$pictures"/*.png; do
  [[ "$(head -c 4 "$picture" | tail -c 3)" == PNG ]] || { echo "$script: no picture" >&2; exit 1; }
done
