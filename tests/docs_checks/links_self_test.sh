#!/usr/bin/env bash
# check_links.sh and check_html_links.sh find what is wrong, name the line, and are silent on what is right.
source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

# The tree that the documents below lie in, as docs/test.md.
tree="$work/tree"
mkdir -p "$tree/docs" "$tree/src/a" "$tree/build"
printf '# Other\n\n## φ over A: the *density*\n\n## Twice\n\n## Twice\n\nUnderlined\n----------\n\n## `code.csv` [x](other.md), 1 – 2\n\n<a id="here"></a>\n' >"$tree/docs/other.md"
touch "$tree/docs/picture.svg" "$tree/docs/a b.md" "$tree/build/made.md"
printf 'one\ntwo\n' >"$tree/src/a/code.cpp"

markdown() { # <name> <pattern> <text>
  printf '%b' "$3" >"$tree/docs/test.md"
  expect "$1" "$2" bash "$here/check_links.sh" "$tree"
}

markdown file "" '[a](other.md) and ![b](picture.svg "title"), [c](../src/a), [d](<a%20b.md>)\n'
markdown missing_file "docs/test.md:3: is not there: none.md" 'Text\n\n[a](none.md)\n'
markdown missing_image "docs/test.md:1: is not there: none.svg" '![a](none.svg)\n'
markdown other_case "is not there: Other.md" '[a](Other.md)\n'
markdown second_of_a_line "docs/test.md:2: is not there: none.md" 'a\n[a](other.md) [b](none.md)\n'
markdown wrapped_text "docs/test.md:2: is not there: none.md" '[a\nb](none.md)\n'
markdown in_table "docs/test.md:3: is not there: none.md" '| a |\n|---|\n| [a](none.md) |\n'
markdown in_list "docs/test.md:3: is not there: none.md" '* item\n\n    [a](none.md)\n'
markdown after_comment "docs/test.md:1: is not there: none.md" '<!-- a --> [a](none.md)\n'
markdown anchor "" '# Own\n[a](#own) [b](other.md#φ-over-a-the-density) [c](other.md#twice-1) [d](other.md#underlined) [e](other.md#codecsv-x-1--2) [f](other.md#here)\n'
markdown missing_anchor "docs/test.md:1: no heading of docs/other.md is #twice-2" '[a](other.md#twice-2)\n'
markdown missing_own_anchor "docs/test.md:2: no heading of docs/test.md is #owns" '# Own\n[a](#owns)\n'
markdown heading_in_fence "no heading of docs/test.md is #own" '```\n# Own\n```\n[a](#own)\n'
markdown line_of_source "" '[a](../src/a/code.cpp#L2)\n'
markdown missing_line "no line of src/a/code.cpp is #L3" '[a](../src/a/code.cpp#L3)\n'
markdown code "" '`[a](none.md)` ``[b`](none.md)``\n\n```\n[c](none.md)\n```\n\n    [d](none.md)\n\n`code\n[e](none.md)`\n<!-- [f](none.md)\n[g](none.md) -->\n'
markdown after_fence "docs/test.md:4: is not there: none.md" '````\n```\n````\n[a](none.md)\n'
markdown definition "" '[a][it] [b](other.md)\n\n[it]: other.md\n'
markdown wrong_definition "docs/test.md:3: is not there: none.md" '[a][it]\n\n[it]: none.md\n'
markdown undefined "docs/test.md:1: [it] is not defined" '[a][it]\n'
markdown html "docs/test.md:1: is not there: none.svg" '<img src="none.svg" alt="a">\n'
markdown elsewhere "" '[a](https://example.org/none) <https://example.org> [b](mailto:a@example.org)\n'
markdown of_this_machine "docs/test.md:1: no link within the tree: /etc/passwd" '[a](/etc/passwd)\n'
markdown other_scheme "no link within the tree: file:other.md" '[a](file:other.md)\n'
markdown out_of_tree "leads out of the tree: ../../tree/docs" '[a](../../tree/docs)\n'
markdown built "is not there: ../build/made.md" '[a](../build/made.md)\n'
markdown without_target "docs/test.md:1: a link without a target" '[a]()\n'
markdown path "" '`src/a/code.cpp`, `docs/`, `src/<folder>/*.cpp`\n'
markdown missing_path "docs/test.md:2: is not there: src/a/none.cpp" 'a\n`src/a/none.cpp`\n'
printf '# see docs/other.md\n# see docs/none.md\n' >"$tree/src/a/code.py"
markdown cited_by_source "src/a/code.py:2: is not there: docs/none.md" 'a\n'
expect links_alone "" bash "$here/check_links.sh" "$tree" links
expect no_markdown "no Markdown file" bash "$here/check_links.sh" "$tree/src"

pages() { # <name> <pattern> <line of index.html>
  rm -rf "$work/pages"
  mkdir -p "$work/pages/search"
  printf '<a href="../index.html#top">\n<p id="there">\n' >"$work/pages/search/all.html"
  printf '<p id="top">\n%s\n' "$3" >"$work/pages/index.html"
  expect "$1" "$2" bash "$here/check_html_links.sh" "$work/pages"
}

pages html_right "" '<a class="el" href="search/all.html#there"><a href="#top"><a href="https://example.org">'
pages html_missing_page "index.html:2: is not there: none.html" '<a href="none.html">'
pages html_missing_image "index.html:2: is not there: none.svg" '<img src="none.svg">'
pages html_missing_anchor "index.html:2: no such anchor: search/all.html#here" '<a href="search/all.html#here">'
pages html_missing_own_anchor "index.html:2: no such anchor: index.html#here" '<a href="#here">'
mkdir "$work/empty"
expect html_no_page "no page in" bash "$here/check_html_links.sh" "$work/empty"

finish
