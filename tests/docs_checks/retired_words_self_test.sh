#!/usr/bin/env bash
# check_retired_words.py finds retired words in documents and messages, names the line and the better word, and is silent
# on good English, on code and on comments.
# Usage: retired_words_self_test.sh PYTHON
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"
python="$1"

tree="$work/tree"
package=src/microslip/bindings/python/microslip

check() { # <name> <pattern> <file> <text> [<list>]
  rm -rf "$tree"
  mkdir -p "$tree/docs" "$tree/$(dirname "$3")"
  echo 'An ordinary text.' >"$tree/docs/other.md"
  printf '%b' "$4" >"$tree/$3"
  if (($# > 4)); then printf '%b' "$5" >"$work/list"; fi
  expect "$1" "$2" "$python" "$here/check_retired_words.py" "$tree" ${5+"$work/list"}
}
markdown() { check "$1" "$2" docs/test.md "${@:3}"; }
cpp() { check "$1" "$2" src/microslip/io/test.cpp "${@:3}"; }

markdown right "" '# Title\n\nThe data determine the density; its band contains the truth.\n'
markdown told 'docs/test.md:3: "told"; better: available' '# Title\n\nThe share that is told.\n'
markdown capital 'docs/test.md:1: "Likewise"' 'Likewise of D.\n'
markdown over_lines 'docs/test.md:1: "held against"' 'A record is held\nagainst the joint.\n'
markdown two_paragraphs "" 'A record is held\n\nagainst the wall.\n'
markdown in_table 'docs/test.md:3: "either way"' '| one |\n|---|\n| either way |\n'
markdown shown_output 'docs/test.md:2: "%, held"' '```text\n  tested  0.1 % of k_eq, noise 0.04 %, held\n```\n'
markdown good_english "" 'As foretold, the joint holds; by the way, its band is told_apart, and the floor gives way.\n'
markdown code "" 'A `told` column.\n\n```sh\necho told\n```\n\n<!-- told --> [it](told.md)\n'
markdown rows 'docs/test.md:1: "one row a level"; better: per' 'It writes one row a level.\n'
markdown knots_of_a_step 'docs/test.md:1: "knots of a step"; better: breakpoints' 'The knots of a step.\n'
markdown knots_of_a_spline "" 'The knots of a spline.\n'
check readme 'README.md:1: "told"' README.md 'It is told.\n'
check example 'examples/a/README.md:1: "told"' examples/a/README.md 'It is told.\n'
check unreleased 'CHANGELOG.md:3: "told"' CHANGELOG.md '# Changes\n## [Unreleased]\nIt is told.\n'
check released "" CHANGELOG.md '# Changes\n## [Unreleased]\nNone.\n## [1.0]\nIt was told.\n'
cpp message 'src/microslip/io/test.cpp:2: "told"' 'int a;\nauto b = "it is told";\n'
cpp joined 'src/microslip/io/test.cpp:1: "slipped part carries"; better: total slip force' 'auto b = "slipped part "\n         "carries";\n'
cpp second_piece 'src/microslip/io/test.cpp:2: "told"' 'auto b = "a text "\n         "that is told";\n'
cpp after_includes 'src/microslip/io/test.cpp:4: "told"' '#include "a.hpp"\n\n#include "b.hpp"\nauto b = "it is told";\n'
cpp key "" '// It is told.\nauto b = table.at("told"); /* told here */ char c = \x27"\x27;\n'
check program 'apps/a/b.cpp:1: "likewise"' apps/a/b.cpp 'auto b = "of D likewise";\n'
check docstring "$package/a.py:4: \"told\"" $package/a.py 'def a():\n    """Short.\n\n    What is told.\n    """\n'
check python_message "$package/a.py:1: \"told\"" $package/a.py 'raise ValueError("it was told")\n'
check python_comment "" $package/a.py '# It is told.\na = {"told": 1}\n'
check attribute "" $package/a.py 'def a():\n    """Returns\n\n    told : ndarray\n    """\n'
check script 'src/microslip/report/web/a.js:2: "told"' src/microslip/report/web/a.js "// told\nconst a = 'it is told';\n"
markdown other_list 'docs/test.md:1: "odd word"; better: even word' 'An odd word.\n' 'odd word\teven word\n'
markdown allowed "" 'An odd word.\n' 'odd word\teven word\nallow\tdocs/*\tan odd word\tit is a name\n'
markdown allowed_elsewhere 'docs/test.md:1: "odd word"' 'An odd word.\n' 'odd word\teven word\nallow\tsrc/*\tan odd word\tit is a name\n'
markdown no_better_word "list:1: expected a pattern" 'A word.\n' 'odd word\n'
markdown no_reason "list:2: expected a pattern" 'A word.\n' 'odd word\teven\nallow\tdocs/*\todd\n'

finish
