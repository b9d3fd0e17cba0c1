#!/usr/bin/env bash
# What zsh offers when the tabulator key is pressed in a terminal.
# Usage: check_zsh_completion.sh PROGRAM SCRIPT
set -euo pipefail
export LC_ALL=C
program="$1" script="$2"
command -v zsh >/dev/null || { echo "no zsh" >&2; exit 77; }

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/functions" "$folder/lab" "$folder/lab/results"
cp "$script" "$folder/functions/_microslip"
cd "$folder/lab"
touch levels.csv LOUD.CSV joint.json rig.toml test.uff notes.txt

# An interactive zsh that notes what its completion would add to the line, and ends after that.
cat >"$folder/setup" <<'END'
PROMPT=
fpath=($FUNCTIONS $fpath)
autoload -Uz compinit
compinit -C -u -d $DUMP # made by the first, read by the others
bindkey '^I' complete-word
zstyle ':completion:*' insert-tab false
compadd() {
  if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then
    builtin compadd "$@"
    return
  fi
  local -a hits
  builtin compadd -A hits "$@"
  [[ -z $hits ]] || print -rl -- $hits >>$ANSWER
  builtin compadd "$@"
}
comppostfuncs=(exit)
print ready
END
cat >"$folder/ask" <<'END'
zmodload zsh/zpty || exit 77
zpty terminal zsh -f -i
zpty -w terminal "source ${(q)SETUP}"
while zpty -r terminal line && [[ $line != ready* ]]; do :; done
zpty -wn terminal "$1"$'\t'
while zpty -r terminal line; do :; done
END
export DUMP="$folder/dump" FUNCTIONS="$folder/functions" SETUP="$folder/setup" ANSWER="$folder/answer"

failed=0
# expect OFFERED LINE
expect() {
  local answer
  : >"$ANSWER"
  timeout 60 zsh -f "$folder/ask" "$2" >/dev/null || true
  answer="$(sort -u "$ANSWER" | paste -sd' ')"
  [[ $answer == "$1" ]] && return
  echo "$2<TAB>" >&2
  echo "  offers '$answer'" >&2
  echo "  not    '$1'" >&2
  failed=1
}

subcommands="$("$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p')"
expect "$(sort <<<"$subcommands" | paste -sd' ')" 'microslip '
for subcommand in $subcommands; do
  options="$("$program" "$subcommand" --help | sed -n '/^Options:/,/^$/p' | grep -oE '^  -[^ ]+' |
    tr ', ' '\n\n' | grep -- --)"
  expect "$(sort <<<"$options" | paste -sd' ')" "microslip $subcommand --"
done
expect 'differences inversion spline' 'microslip identify --method '
expect 'differences inversion spline' 'microslip identify levels.csv --method='
expect 'joint.json results' 'microslip loop '
expect 'LOUD.CSV levels.csv results test.uff' 'microslip identify '
expect 'levels.csv' 'microslip dissipation joint.json --out l'
expect 'results' 'microslip demo --out '
expect 'LOUD.CSV levels.csv results test.uff' 'microslip reduce rig.toml '
expect 'LOUD.CSV levels.csv results test.uff' 'microslip reduce rig.toml levels.csv '
exit $failed
