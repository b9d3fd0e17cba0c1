#!/usr/bin/env bash
# Fails where a citation in code or documentation has no entry in docs/bibliography.md, an entry has no citation, or
# the bibliography and CITATION.cff state another version than the project. Usage: check_keys.sh ROOT
set -euo pipefail
cd "$1"
export LC_ALL=C

mapfile -t files < <(
  find src apps tests bench examples docs cmake scripts README.md CONTRIBUTING.md -type f \
       \( -name '*.hpp' -o -name '*.cpp' -o -name '*.md' -o -name '*.csv' -o -name '*.toml' -o -name '*.py' \
          -o -name '*.sh' -o -name '*.m' \) \
       ! -path 'docs/bibliography.md' ! -path 'tests/bibliography/*' ! -path '*/node_modules/*' | sort)
failed=0
awk -f tests/bibliography/check_keys.awk docs/bibliography.md "${files[@]}" || failed=1

version="$(awk '$1 == "VERSION" { print $2; exit }' CMakeLists.txt)"
grep -qxF "version: $version" CITATION.cff ||
  { echo "CITATION.cff: the version is not that of CMakeLists.txt, $version"; failed=1; }
grep -qF "version = {$version}" docs/bibliography.md ||
  { echo "docs/bibliography.md: the version is not that of CMakeLists.txt, $version"; failed=1; }
exit $failed
