#!/usr/bin/env bash
# Presses the tabulator key, as it were: what bash would offer for words that are typed.
# Usage: check_bash_completion.sh PROGRAM SCRIPT
set -euo pipefail
export LC_ALL=C
program="$1"
[[ ${BASH_VERSINFO[0]} -ge 4 ]] || { echo "bash is too old" >&2; exit 77; }

# shellcheck disable=SC1090
source "$2"
[[ "$(complete -p microslip)" == "complete -F _microslip microslip" ]]

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir results 'two words'
touch levels.csv LOUD.CSV joint.json rig.toml test.uff test.mat test.h5 notes.txt 'my levels.csv' 'two words/deep.csv'

# offered WORD...: the last word is the one at the cursor. As in bash, = and : are words of their own.
offered() {
  COMP_WORDS=(microslip "$@")
  COMP_CWORD=$#
  _microslip
  printf '%s\n' "${COMPREPLY[@]}" | sort | paste -sd' '
}

failed=0
# expect OFFERED WORD...
expect() {
  local answer wanted="$1"
  shift
  answer="$(offered "$@")"
  [[ $answer == "$wanted" ]] && return
  echo "microslip $*<TAB>" >&2
  echo "  offers '$answer'" >&2
  echo "  not    '$wanted'" >&2
  failed=1
}

# Subcommands and options: all that the help shows, and nothing else.
sorted() { sort | paste -sd' '; }
subcommands="$("$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p')"
expect "$(sorted <<<"$subcommands")" ''
for subcommand in $subcommands; do
  options="$("$program" "$subcommand" --help | sed -n '/^Options:/,/^$/p' | grep -oE '^  -[^ ]+' |
    tr ', ' '\n\n' | grep -- -)"
  expect "$(sorted <<<"$options")" "$subcommand" -
done
expect 'identify' ide
expect '--help --version -h' -
expect '--density-csv' identify levels.csv --den
expect '' nonsense ''

# Enumerated values, separate or behind =.
expect 'differences inversion spline' identify --method ''
expect 'spline' identify --method s
expect 'inversion' identify --method = i
expect 'differences inversion spline' identify --method =

# Files by their ending, in capitals or not, and folders on the way to them.
expect 'joint.json results two words' loop ''
expect 'LOUD.CSV levels.csv my levels.csv results test.h5 test.mat test.uff two words' identify ''
expect 'my levels.csv' identify 'my\ '
expect 'my levels.csv' identify '"my '
expect 'two words/deep.csv' identify 'two\ words/'
expect 'levels.csv' dissipation joint.json --out le
expect 'levels.csv' dissipation joint.json --out = le
expect 'results two words' demo --out ''
expect 'results rig.toml two words' reduce ''
expect 'LOUD.CSV levels.csv my levels.csv results test.h5 test.mat test.uff two words' reduce rig.toml ''
expect 'test.h5 test.mat test.uff' reduce rig.toml --out levels.csv --no-vibrometer levels.csv te
expect 'notes.txt' identify no # none of the ending: what there is

# Values that are no files, and a colon within them, do not count as arguments.
expect '' identify levels.csv --stiffness ''
expect '' loop joint.json --amplitude 1um : ''
expect 'joint.json' dissipation --amplitude 1um : 300um : 50 j
expect '' dissipation joint.json '' # all arguments are there

exit $failed
