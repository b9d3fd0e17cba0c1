#!/usr/bin/env bash
# Each local link of the Markdown files below ROOT leads to a file or folder of the tree, and its #anchor
# to a heading there, as GitHub names them; no network. A path from a top folder between backticks,
# `docs/validation.md`, is there too, and so is a document that a source below src or apps cites, unless only
# links are asked for.
# Usage: check_links.sh ROOT [links]
set -euo pipefail
export LC_ALL=C.UTF-8 # letters of all alphabets
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
only="${2:-}"
cd "$1"

mapfile -t files < <(find . -mindepth 1 \( -name '.*' -o -path ./build -o -name node_modules \) -prune -o \
  -name '*.md' -type f -printf '%P\n' | sort)
[[ ${#files[@]} -gt 0 ]] || { echo "no Markdown file below $PWD" >&2; exit 1; }
parts="$(awk -f "$here/markdown_parts.awk" "${files[@]}")"
of_kind() { awk -F '\t' -v kind="$1" '$1 == kind { sub(/^[^\t]*\t/, ""); print }' <<<"$parts"; }

offences=0
offend() {
  echo "$1:$2: $3" >&2
  offences=$((offences + 1))
}

# The anchor of a heading: lower case, letters, digits, - and _ alone, - for a blank; the second of a name
# is name-1.
declare -A anchors=() used=()
while IFS=$'\t' read -r file slug; do
  count="${used["$file#$slug"]:-0}"
  used["$file#$slug"]=$((count + 1))
  ((count == 0)) || slug+="-$count"
  anchors["$file#$slug"]=1
done < <(paste <(of_kind heading | cut -f 1) \
  <(of_kind heading | cut -f 3- | sed -e 's/[^[:alnum:]_ -]//g' -e 's/.*/\L&/' -e 's/ /-/g'))
while IFS=$'\t' read -r file _ id; do anchors["$file#${id#*\"}"]=1; done < <(of_kind html_anchor)

# path_of(<file> <target>): the path from the root; fails where it leaves the tree, whatever that is called.
path_of() {
  local path
  path="$(realpath -ms -- "/-tree-/$(dirname "$1")/$2")"
  [[ $path/ == /-tree-/* ]] || return 1
  path="${path#/-tree-}"
  path="${path#/}"
  printf '%s' "${path:-.}"
}

links=0
check_link() {
  local file="$1" line="$2" target="$3" anchor="" path
  links=$((links + 1))
  [[ $target == "<"*">" ]] && target="${target:1:-1}"
  target="${target//%20/ }"
  case "$target" in
    https://?* | http://?* | mailto:?*) return ;;
    "") offend "$file" "$line" "a link without a target" && return ;;
    /* | [a-zA-Z]*:*) offend "$file" "$line" "no link within the tree: $target" && return ;;
  esac
  [[ $target != *"#"* ]] || anchor="${target#*#}"
  target="${target%%#*}"
  path="$file"
  if [[ -n $target ]]; then
    path="$(path_of "$file" "$target")" || { offend "$file" "$line" "leads out of the tree: $target" && return; }
    [[ -e $path && $path != build/* ]] || { offend "$file" "$line" "is not there: $target" && return; }
  fi
  [[ -n $anchor ]] || return 0
  if [[ $path == *.md ]]; then
    [[ -n ${anchors["$path#$anchor"]:-} ]] || offend "$file" "$line" "no heading of $path is #$anchor"
  elif [[ ! $anchor =~ ^L[0-9]+(-L[0-9]+)?$ ]] || ((${anchor##*L} > $(wc -l <"$path"))); then
    offend "$file" "$line" "no line of $path is #$anchor"
  fi
}

while IFS=$'\t' read -r file line target; do
  read -r target _ <<<"$target" || true # without the title
  check_link "$file" "$line" "$target"
done < <(of_kind link)
while IFS=$'\t' read -r file line target; do
  check_link "$file" "$line" "${target#*\"}"
done < <(of_kind html_link)

declare -A defined=()
while IFS=$'\t' read -r file _ name; do defined["$file#${name,,}"]=1; done < <(of_kind definition)
while IFS=$'\t' read -r file line name; do
  [[ -n ${defined["$file#${name,,}"]:-} ]] || offend "$file" "$line" "[$name] is not defined"
done < <(of_kind reference)

# The documents that sources cite, as of_kind prints them.
cited_by_sources() {
  grep -rnoE --binary-files=without-match --exclude-dir=__pycache__ '\<docs/[A-Za-z0-9_/]+\.md\>' src apps 2>/dev/null |
    tr ':' '\t'
}

paths=0
while IFS=$'\t' read -r file line path; do
  [[ $only != links && $path =~ ^(apps|bench|cmake|docs|examples|scripts|src|tests|third_party)/[A-Za-z0-9_./-]*$ ]] || continue
  paths=$((paths + 1))
  [[ -e $path ]] || offend "$file" "$line" "is not there: $path"
done < <(of_kind code; cited_by_sources)

echo "${#files[@]} files, $links links, ${#anchors[@]} anchors, $paths paths: $offences wrong"
((offences == 0))
