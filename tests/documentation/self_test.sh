#!/usr/bin/env bash
# The check of documents itself: a document that is right passes, and each thing that can be wrong in one
# is found, with its line. Usage: self_test.sh ROOT FOLDER_OF_THE_PROGRAM
set -euo pipefail
root="$1" programs="$2"
here="$(dirname "$(realpath "${BASH_SOURCE[0]}")")"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
mkdir "$work/docs"
ln -s "$(realpath "$root")/examples" "$work/examples"

run() {
  cat >"$work/docs/page.md"
  bash "$here/run_document.sh" "$work" "$work/docs/page.md" "$programs" >"$work/said" 2>&1
}

# passes <<document
passes() {
  echo >>"$work/checks" # in a pipe a variable would be lost
  if ! run; then
    printf 'refused, but right:\n%s\n' "$(cat "$work/docs/page.md")" >&2
    cat "$work/said" >&2
    exit 1
  fi
}

# fails LINE WORDS <<document
fails() {
  echo >>"$work/checks" # in a pipe a variable would be lost
  if run || ! grep -qF "docs/page.md:$1: " "$work/said" || ! grep -qF -- "$2" "$work/said"; then
    printf 'not refused at line %s by "%s":\n%s\n' "$1" "$2" "$(cat "$work/docs/page.md")" >&2
    cat "$work/said" >&2
    exit 1
  fi
}

# A session that prints what is given, to compare with what follows.
printing() {
  printf '<!-- session -->\n```sh\nprintf "%s"\n```\n<!-- output%s -->\n```text\n' "$1" "${2:-}"
  cat
  printf '```\n'
}

# ---- What is right. ----

passes <<'END'
<!-- session -->
```sh
export PATH="$PWD/microslip/build/release/bin:$PATH"
JOINT=microslip/examples/reference_joint/joint.json
microslip loop "$JOINT" --amplitude 1um --points 2 --out loop.csv
```
A reader has one terminal: variables and files are there in the next block.
<!-- session -->
```sh
microslip loop "$JOINT" --amplitude 1um --points 2 --out - | head -n 2
test -s loop.csv
```
<!-- output -->
```text
displacement [m],force [N]
0,0
```
<!-- file some/path.csv -->
```csv
displacement [um]
0
1
```
<!-- run microslip loop "$JOINT" --path some/path.csv --out path_loop.csv -->
<!-- not run: there is no such program -->
```sh
nothing_of_the_kind
```
A block in another language, and a comment that is no mark: <!-- session --> in a line.
```cpp
int main() {}
```
<!-- a comment -->
END
printing 'one 1.234e-05 N\ntwo  2.00\nthree\nfour 4\nfive 5 of 6 s\n' <<<$'one 1.235e-05 N\n two 1.99\n…\nfour 4\nfive … s' | passes
printing 'a 1\nb 2\na 1\nb 3\n' <<<$'a 1\nb 3' | passes
printing '9.99 10.00\n' <<<'10.00 9.99' | passes
printing 'x 1.50\n' ' exact' <<<'x 1.50' | passes

# What needs data is run where they are there, and only there.
mkdir "$work/data"
echo 1.5 >"$work/data/given.txt"
for data in "$work/data" /nonexistent; do
  MICROSLIP_DATA_DIR="$data" passes <<'END'
<!-- run true -->
<!-- session with given.txt -->
```sh
cat given.txt
```
<!-- output -->
```text
1.5
```
END
done

# A program that is needed and there changes nothing; one that is not there leaves the document out.
passes <<'END'
<!-- needs awk -->
<!-- run true -->
END
echo >>"$work/checks"
status=0
run <<<$'<!-- needs no_such_program -->\n<!-- run false -->' || status=$?
[[ "$status" == 77 ]] && grep -qF 'docs/page.md:1: not run, no_such_program' "$work/said" ||
  { echo "a program that is missing: status $status" >&2; exit 1; }

# Python blocks have one interpreter, where the module was built.
built() { compgen -G "$programs/../python/microslip/_core.*" >/dev/null; }
if built; then
  passes <<'END'
<!-- python -->
```python
import microslip
stiffness = microslip.Joint(1.5).stiffness
```
<!-- python -->
```python
print(stiffness)
```
<!-- output -->
```text
1.5
```
END
fi

# ---- What is wrong. ----

if built; then
  fails 2 'ended by an exception' <<'END'
<!-- python -->
```python
1 / 0
```
END
  fails 6 'other output than shown' <<'END'
<!-- python -->
```python
print(1.5)
```
<!-- output -->
```text
2.5
```
END
fi
fails 2 'python is a block ```python' <<'END'
<!-- python -->
```sh
true
```
END

fails 3 'ended with status 3' <<'END'

<!-- session -->
```sh
(exit 3)
```
END
fails 2 'ended with status 1' <<'END'
<!-- session -->
```sh
false | cat
```
END
fails 6 'ended with status 2' <<'END'
<!-- session -->
```sh
true
```
<!-- session -->
```sh
microslip identify none.csv --stiffness 1 --out joint.json
```
END
printing 'one 1.234\n' <<<'one 1.236' | fails 6 'other output than shown'
printing 'one 1.234\n' ' exact' <<<'one 1.235' | fails 6 'other output than shown'
printing 'level_05\n' <<<'level_06' | fails 6 "'level_06'"
printing 'one\ntwo\nthree\n' <<<$'one\nthree' | fails 6 "line 2 of it is not printed: 'three'"
printing 'one\ntwo\n' <<<$'two\n…\none' | fails 6 "'one'"
printing 'one two\n' <<<'one' | fails 6 'other output'
printing 'one\n' <<<'one two' | fails 6 'other output'
printing 'one two\n' <<<'one … three' | fails 6 'other output'
printing '1.5 N\n' <<<'1.5 kN' | fails 6 'other output'
printing '1.5\n' <<<'-1.5' | fails 6 'other output'
printing 'one\n' </dev/null | fails 6 'it shows nothing'
MICROSLIP_DATA_DIR="$work/data" fails 6 "other output than shown" <<'END'
<!-- session with given.txt -->
```sh
cat given.txt
```
<!-- output -->
```text
2.5
```
END
fails 2 'output without a session' <<'END'
<!-- output -->
```text
one
```
END
fails 1 'a block of commands without' <<'END'
```sh
true
```
END
fails 3 "not followed by a block" <<'END'
<!-- session -->

Text.
END
fails 2 'a session is a block ```sh' <<'END'
<!-- session -->
```text
true
```
END
fails 6 'output is a block ```text' <<'END'
<!-- session -->
```sh
true
```
<!-- output -->
```
true
```
END
fails 1 'unknown mark' <<<'<!-- sessions -->'
fails 1 'unknown mark' <<<'<!-- needs -->'
fails 2 'a block is missing' <<<$'<!-- session -->\n<!-- output -->'
fails 2 'a block without end' <<<$'<!-- session -->\n```sh\ntrue'
fails 2 'no command takes the file rig.toml' <<'END'
<!-- file rig.toml -->
```toml
schema = "microslip.rig/1"
```
<!-- run true -->
END
# A file that is not what it claims to be.
fails 7 'ended with status 2' <<'END'
<!-- file joint.json -->
```json
{"schema": "microslip.joint/1", "stiffness": 1.7e5, "density": []}
```


<!-- run microslip loop joint.json --amplitude 1um --out loop.csv -->
END
fails 1 'no session' <<<'Text.'

# ---- Names of columns and keys. ----

# names EXPECTED_STATUS DOCUMENT FILE
names() {
  echo >>"$work/checks"
  printf '%s\n' "$2" >"$work/names.md"
  local status=0
  bash "$here/check_names.sh" "$work/names.md" -e 's/_left /_NAME /' "$3" >"$work/said" 2>&1 || status=$?
  [[ "$status" == "$1" ]] || { echo "names of $3: status $status for $2" >&2; cat "$work/said" >&2; exit 1; }
}

printf '# made\nforce [N],amplitude_left [m]\n1,2\n' >"$work/table.csv"
names 0 '`force [N]`, `amplitude_NAME [m]`' "$work/table.csv"
names 1 '`force [N]`' "$work/table.csv"
names 1 '`force`, `amplitude_NAME [m]`' "$work/table.csv"
echo '{"schema": "x", "k_N_per_m": 1}' >"$work/object.json"
names 0 '`schema`, `k_N_per_m`' "$work/object.json"
names 1 '`schema`, `k`' "$work/object.json"
printf '[beam]\nlength_m = 1\n' >"$work/table.toml"
names 0 '`[beam]`, `length_m`' "$work/table.toml"
names 1 '`[beam]`' "$work/table.toml"
names 1 '`length_m`' "$work/table.toml"
: >"$work/empty.csv"
names 1 '' "$work/empty.csv"

echo "$(wc -l <"$work/checks") documents and files, each judged as it should be"
