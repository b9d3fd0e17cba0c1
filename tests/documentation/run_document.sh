#!/usr/bin/env bash
# Follows a document as a user does: saves the files that it shows, types its commands, and compares
# the output with the output shown. The marks in documents are those of split_document.awk.
#
# The reader begins in an empty folder with the clone beside him as microslip/; with a document of
# examples/NAME, in a copy of that folder. Data that are not in the repository are taken from the folder
# MICROSLIP_DATA_DIR, and what needs them is left out, with a note, where they are not there. Ends with 77 where
# a program that the document needs is not installed.
# Python blocks run in the interpreter MICROSLIP_PYTHON, python3 without it, where the module was built.
# Usage: run_document.sh ROOT DOCUMENT FOLDER_OF_THE_PROGRAM [FOLDER_OF_THE_PYTHON_MODULE]
set -euo pipefail
export LC_ALL=C.UTF-8
root="$(realpath "$1")" document="$(realpath "$2")" programs="$(realpath "$3")"
here="$(dirname "$(realpath "${BASH_SOURCE[0]}")")"
module="$(realpath "${4:-$programs/../python}")"
name="${document#"$root"/}"

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
steps="$work/steps" folder="$work/folder"
mkdir "$steps" "$folder"

# The clone, with the program that is to be tested as the one that was built.
clone() {
  mkdir -p "$folder/microslip/build/release"
  local entry
  for entry in "$root"/*; do
    [[ "${entry##*/}" == build ]] || ln -s "$entry" "$folder/microslip/"
  done
  ln -s "$programs" "$folder/microslip/build/release/bin"
}

fail() {
  printf '%s:%s: %s\n' "$name" "$1" "$2" >&2
  exit 1
}

# with_data LINE FILE: puts the file into the folder; fails where it is not there.
with_data() {
  local data="${MICROSLIP_DATA_DIR:-none}/$2"
  if [[ ! -f "$data" ]]; then
    echo "$name:$1: not run, $2 is not in MICROSLIP_DATA_DIR" >&2
    return 1
  fi
  ln -sf "$(realpath "$data")" "$folder/"
}

# One shell for the whole document, as the reader has one terminal. What each block prints goes to its file.
write_script() {
  local number kind line rest
  while read -r number kind line rest; do
    case "$kind" in
      sh)
        [[ -z "$rest" ]] || with_data "$line" "$rest" || continue
        printf 'exec >"%s/%s.printed" 2>&1\n' "$steps" "$number"
        cat "$steps/$number.sh"
        ;;
      file)
        printf 'mkdir -p "$(dirname "%s")" && cp "%s/%s.file" "%s"\n' \
          "$rest" "$steps" "$number" "$rest"
        ;;
    esac
  done <"$work/list"
}

# A document that needs a missing program is skipped.
check_programs() {
  local number kind line rest
  while read -r number kind line rest; do
    [[ "$kind" == needs ]] || continue
    command -v "$rest" >/dev/null && continue
    echo "$name:$line: not run, $rest is not installed" >&2
    exit 77
  done <"$work/list"
}

# A file that no command takes, by its name or that of its folder, and no other file names, shows nothing.
check_files_are_used() {
  local number kind line rest
  while read -r number kind line rest; do
    [[ "$kind" == file ]] || continue
    grep -rqF --exclude="$number.file" --exclude='*.expected' -e "$rest" -e "${rest%/*}" "$steps" ||
      fail "$line" "no command takes the file $rest"
  done <"$work/list"
}

explain_failure() {
  local status="$1" last number kind line rest
  last="$(find "$steps" -name '*.printed' | sort | tail -n 1)"
  [[ -n "$last" ]] || fail 1 "no command could be started"
  number="$(basename "$last" .printed)"
  read -r number kind line rest < <(grep "^$number " "$work/list")
  tail -n 30 "$last" >&2
  fail "$line" "a command of this block ended with status $status"
}

# One interpreter for all Python blocks.
run_python() {
  local number kind line rest blocks=()
  while read -r number kind line rest; do
    [[ "$kind" == py ]] && blocks+=("$line" "$steps/$number.py" "$steps/$number.printed")
  done <"$work/list"
  ((${#blocks[@]})) || return 0
  if ! compgen -G "$module/microslip/_core.*" >/dev/null; then
    echo "$name: Python not run, the module was not built" >&2
    grep -q ' sh ' "$work/list" || exit 77
    return 0
  fi
  (cd "$folder" && MPLBACKEND=Agg PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$module" \
    "${MICROSLIP_PYTHON:-python3}" "$here/run_python.py" "$name" "${blocks[@]}") || exit 1
}

compare_outputs() {
  local number kind line rest printed="" exact
  while read -r number kind line rest; do
    [[ "$kind" == sh || "$kind" == py ]] && printed="$steps/$number.printed"
    [[ "$kind" == expected ]] || continue
    [[ -f "$printed" ]] || continue # what it needs is not there
    exact=0
    [[ "$rest" == exact ]] && exact=1
    if ! LC_ALL=C awk -v EXACT="$exact" -f "$here/compare_output.awk" "$steps/$number.expected" "$printed" \
      >"$work/difference"; then
      echo "---- printed:" >&2
      head -c 20000 "$printed" >&2
      echo "----" >&2
      fail "$line" "other output than shown: $(cat "$work/difference")"
    fi
  done <"$work/list"
}

LC_ALL=C awk -v STEPS="$steps" -v DOCUMENT="$name" -f "$here/split_document.awk" "$document" >"$work/list"
grep -Eq ' (sh|py) ' "$work/list" || fail 1 "no session"
check_programs
check_files_are_used
if [[ "$name" == examples/* ]]; then
  cp -r "$(dirname "$document")/." "$folder"
else
  clone
fi
write_script >"$work/script"
status=0
(cd "$folder" && PATH="$programs:$PATH" bash -euo pipefail "$work/script") || status=$?
((status == 0)) || explain_failure "$status"
run_python
compare_outputs
echo "$name: $(grep -c ' sh ' "$work/list" || true) blocks of commands, $(grep -c ' py ' "$work/list" || true) of Python, $(grep -c ' expected ' "$work/list" || true) outputs," \
  "$(grep -c ' file ' "$work/list" || true) files"
