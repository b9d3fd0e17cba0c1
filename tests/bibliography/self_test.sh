#!/usr/bin/env bash
# check_keys.sh must pass a small tree that is right, and find each fault put into it. Usage: self_test.sh ROOT
set -euo pipefail
here="$1/tests/bibliography"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

make_tree() {
  rm -rf "${work:?}/tree"
  mkdir -p "$work"/tree/{src,apps,tests/bibliography,bench,examples,docs,cmake,scripts}
  cd "$work/tree"
  cp "$here"/check_keys.* tests/bibliography/
  printf 'project(\n  x\n  VERSION 1.2.3\n)\n' > CMakeLists.txt
  printf 'version: 1.2.3\n' > CITATION.cff
  printf '| key | source |\n|---|---|\n| AR14 | A |\n| Kim & Gu | B |\n| Reinsch | C |\n| Box & Jenkins | D |\n' \
    > docs/bibliography.md
  printf 'version = {1.2.3}\n' >> docs/bibliography.md
  printf '/// F(x) [AR14 (2)], an index a[i], [m/s^2] and a link over lines [Y.-J. Kim\n/// and C. Gu, 2004].\n' \
    > src/a.hpp
  printf 'int b;  // [C. H. Reinsch, Numer. Math. 10 (1967) 177; G. Box, 1970]\n' > src/b.cpp
  printf 'A [link](https://example.org) and `[Nobody 1999]` in code.\n' > README.md
  printf 'By [Kim & Gu].\n' > CONTRIBUTING.md
}

# expect FAULT: the check fails and says so.
expect() {
  local said
  if said="$(bash tests/bibliography/check_keys.sh "$PWD")"; then
    echo "not found: $1" >&2
    exit 1
  fi
  grep -qF "$1" <<< "$said" || { printf 'expected "%s", said:\n%s\n' "$1" "$said" >&2; exit 1; }
}

make_tree
bash tests/bibliography/check_keys.sh "$PWD"

make_tree; printf '// By two lines [Nobody &\n// Someone, J. Sound 1 (1999) 1]\n' > src/c.cpp
expect 'src/c.cpp:1: [Nobody & Someone, J. Sound 1 (1999) 1] has no entry'
make_tree; printf 'By [Reinsch; Nobody et al.].\n' > docs/d.md
expect 'docs/d.md:1: [Reinsch; Nobody et al.] has no entry'
make_tree; printf '// (Nobody, Math. Comp. 63 (1994) 625)\n' > src/e.hpp
expect 'src/e.hpp:1: [Nobody, Math. Comp. 63 (1994) 625] has no entry'
make_tree; rm src/b.cpp
expect 'docs/bibliography.md: nothing cites Reinsch'
make_tree; printf '| Reinsch | E |\n' >> docs/bibliography.md
expect 'Reinsch is there twice'
make_tree; printf 'version: 1.2.2\n' > CITATION.cff
expect 'CITATION.cff: the version is not'
