#!/usr/bin/env bash
# Doxygen with the settings of docs/Doxyfile.in, through its filter, reports each fault of a header by its
# line, and nothing about one that is right; check_api.sh passes on what it says.
# Usage: api_self_test.sh DOXYGEN DOXYFILE
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"
doxygen="$1" doxyfile="$2"

mkdir -p "$work/src/joint"
header="$work/src/joint/test.hpp"
page="$work/main_page.dox"
printf '/** @mainpage Test */\n/** @namespace microslip\nAll. */\n/** @defgroup joint joint\nOne. */\n' >"$page"
printf '# Bibliography\n\n[x](../x.md)\n\n| key | source |\n|---|---|\n| AR14 | A paper |\n' >"$work/bibliography.md"
{
  grep -vE '^(INPUT|  ".*\.(h|hpp|md)"|INPUT_FILTER|STRIP_)' "$doxyfile"
  printf 'INPUT = "%s" "%s" \\\n  "%s"\n' "$page" "$work/bibliography.md" "$header"
  grep '^INPUT_FILTER' "$doxyfile" | sed "s|bibliography='[^']*'|bibliography='$work/bibliography.md'|"
  printf 'STRIP_FROM_PATH = "%s"\n' "$work"
} >"$work/Doxyfile"

api() { # <name> <pattern> <comment of the function> [<more of the header>]
  printf '%b' "// SPDX-License-Identifier: MIT\n/// @file\n/// A test.\n\nnamespace microslip {\n\n$3\ndouble force(double x, double k);\n\n${4:-}\n}  // namespace microslip\n" >"$header"
  expect "$1" "$2" bash "$here/check_api.sh" "$doxygen" "$work/Doxyfile" "$work/out"
}

api right "" '/// kx, N [AR14 (1), App. B].\n/// @param x  m; > 0.\n/// @param k  N/m.\n/// @throws Never  as it is.'
grep -q '<dt>Parameters</dt>' "$work"/out/html/group__joint.html || { echo "right: no group of the folder" >&2; unmet=1; }
grep -qE '>AR14</a> \(1\), App\. B\]' "$work"/out/html/group__joint.html || { echo "right: no link of a citation" >&2; unmet=1; }
expect links "" bash "$here/check_html_links.sh" "$work/out/html"
api summary "" '/// kx, N.'
api undocumented "test.hpp:8: " '// kx, N.'
api wrong_parameter "argument 'y' of command @param is not found" '/// kx.\n/// @param x  m.\n/// @param y  N/m.\n/// @param k  N/m.'
api missing_parameter "parameter 'k'" '/// kx.\n/// @param x  m.'
api twice "has multiple @param documentation sections" '/// kx.\n/// @param x  m.\n/// @param x  m.\n/// @param k  N/m.'
api unknown_command "Found unknown command" '/// kx, @newtons.'
api unresolved "unable to resolve reference to 'nothing'" '/// kx, see @ref nothing.'
api member "Member stiffness (variable)" '/// kx.' '/// A joint.\nstruct Joint {\n  double stiffness;\n};\n'
api type "Compound microslip::Joint is not documented" '/// kx.' 'struct Joint {\n  double stiffness;  ///< k\n};\n'
api private "" '/// kx.' '/// A joint.\nclass Joint {\n public:\n  Joint();  ///< None.\n\n private:\n  double stiffness;\n};\n'
api path_of_this_machine "These pages hold the path" "/// kx, see $(cd "$here/../.." && pwd)/docs."
expect no_headers "names no header" bash "$here/check_api.sh" "$doxygen" <(grep -vE '\.(h|hpp)"' "$work/Doxyfile" | sed 's/\\$//') "$work/out"

finish
