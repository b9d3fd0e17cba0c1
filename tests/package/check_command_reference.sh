#!/usr/bin/env bash
# Fails unless docs/commands.md is what the help of the program makes of it now.
# Usage: check_command_reference.sh MADE KEPT BUILD_FOLDER
set -euo pipefail
if ! diff -u "$2" "$1"; then
  echo "docs/commands.md is not what the program says. Run: cmake --build $3 --target command_reference" >&2
  exit 1
fi
