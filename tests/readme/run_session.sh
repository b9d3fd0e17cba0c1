#!/usr/bin/env bash
# Runs the block of README.md that follows the line "<!-- session -->" in an empty folder, with the
# repository beside it as the block expects. Usage: run_session.sh ROOT FOLDER_OF_THE_PROGRAM
set -euo pipefail
root="$1" programs="$2"
session="$(sed -n '/^<!-- session -->$/,/^```$/p' "$root/README.md" | sed '1,2d;$d')"
[[ -n "$session" ]] || { echo "README.md has no session block" >&2; exit 1; }
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
ln -s "$root" "$folder/microslip"
cd "$folder"
PATH="$programs:$PATH" bash -euxo pipefail -c "$session"
