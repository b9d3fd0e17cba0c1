# For the tests of the checks: expect <name> <pattern> <command>...: the command fails and prints the
# pattern; with an empty pattern it succeeds. Sourced.
set -euo pipefail
export LC_ALL=C.UTF-8
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

expected=0
unmet=0
expect() {
  local name="$1" pattern="$2" said status=0
  shift 2
  said="$("$@" 2>&1)" || status=$?
  expected=$((expected + 1))
  if ((status == 77)); then
    echo "$said"
    exit 77
  elif [[ -z $pattern ]]; then
    ((status == 0)) && return
    printf '%s: must pass, but printed\n%s\n' "$name" "$said" >&2
  elif ((status == 0)); then
    echo "$name: must fail, but passed" >&2
  elif ! grep -qF -- "$pattern" <<<"$said"; then
    printf '%s: must print %s, but printed\n%s\n' "$name" "$pattern" "$said" >&2
  else
    return 0
  fi
  unmet=$((unmet + 1))
}

finish() {
  echo "$expected expectations, $unmet not met"
  ((unmet == 0))
}
