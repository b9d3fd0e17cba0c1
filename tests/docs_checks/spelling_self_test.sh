#!/usr/bin/env bash
# check_spelling.sh finds what is misspelt, names the line, and is silent on what is no English.
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

tree="$work/tree"
mkdir -p "$tree/docs" "$tree/src"

check() { # <name> <pattern> <file> <text> [<word list>]
  rm -f "$tree/docs/test.md" "$tree/docs/bibliography.md" "$tree/src/test.hpp"
  printf '%b' "$4" >"$tree/$3"
  printf '%b' "${5:-}" >"$tree/docs/words.txt"
  expect "$1" "$2" bash "$here/check_spelling.sh" "$tree"
}
markdown() { check "$1" "$2" docs/test.md "${@:3}"; }
header() { check "$1" "$2" src/test.hpp "${@:3}"; }

markdown right "" '# Title\n\nThe colour of a normalised curve.\n'
markdown misspelt "docs/test.md:3: recieved" '# Title\n\nWhat was recieved.\n'
markdown american "docs/test.md:1: normalized" 'A normalized curve.\n'
markdown american_colour "docs/test.md:1: color" 'Its color.\n'
markdown in_heading "docs/test.md:1: Tilte" '# Tilte\n'
markdown in_table "docs/test.md:3: vlaue" '| one |\n|---|\n| vlaue |\n'
markdown in_link "docs/test.md:1: vlaue" '[the vlaue](none.md)\n'
markdown in_list "docs/test.md:3: vlaue" '* one\n* two\n  vlaue\n'
markdown capital "docs/test.md:1: Vlaue" 'Vlaue of it.\n'
markdown doubled "docs/test.md:1: the the" 'Of the the joint.\n'
markdown doubled_over_lines "docs/test.md:2: the the" 'Of the\nthe joint.\n'
markdown code "" 'A `vlaue`\n\n```sh\nvlaue\n```\n\n    vlaue\n\nkept_vlaue vlaueOf levels.csv vlaue() is `a` is [it](vlaue.md) 3dB <!-- vlaue -->\n'
markdown listed "" "The Masing rule; Masing's.\n" 'Masing\n'
markdown listed_for_capital "" 'Quantiles and quantiles.\n' '# words\nquantiles\n'
markdown unlisted "docs/test.md:1: Masing" 'The Masing rule.\n'
markdown unused "docs/words.txt: Masing is used nowhere" 'A rule.\n' 'Masing\n'
markdown unsorted "docs/words.txt: not sorted" 'Masing of Iwan.\n' 'Masing\nIwan\n'
markdown twice "docs/words.txt: not sorted, or a word twice" 'Masing.\n' 'Masing\nMasing\n'
header comment "src/test.hpp:2: vlaue" 'int a;\n/// The vlaue, N.\nint b;  ///< vlau\n'
header trailing "src/test.hpp:1: vlaue" 'int a;  ///< the vlaue\n'
header parameter "src/test.hpp:1: vlaue" '/// @param vlau  the vlaue\n'
header no_comment "" '#include "vlaue.hpp"\nint vlaue; // a value\nconst char* vlaues = "https://vlaue";\n}  // namespace vlaue\n'
header formula "" '/// The sum\n///\n///     vlaue = a + b\n///\n/// @param vlaue  one.\n/// @throws Vlaue  never. See `vlaue`.\n'
check american_title "" docs/bibliography.md '| key | Regularized behavior of a joint |\n'
check misspelt_title "docs/bibliography.md:1: Regularzed" docs/bibliography.md 'Regularzed behavior\n'

finish
