#!/usr/bin/env bash
# Runs the blocks of README.md that follow a line "<!-- session -->", one after the other in an empty folder, with the
# repository beside it as the block expects. Usage: run_session.sh ROOT FOLDER_OF_THE_PROGRAM
set -euo pipefail
root="$1" programs="$2"
session="$(awk '/^<!-- session -->$/ {next_block = 1; next}
                /^```/ {inside = !inside && next_block; if (!inside) next_block = 0; next}
                inside' "$root/README.md")"
[[ -n "$session" ]] || { echo "README.md has no session block" >&2; exit 1; }
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
ln -s "$root" "$folder/microslip"
cd "$folder"
PATH="$programs:$PATH" bash -euxo pipefail -c "$session"
