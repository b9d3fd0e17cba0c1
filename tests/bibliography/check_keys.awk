# Reads the bibliography first, then the files that cite. Fails, naming the place, where a citation begins with a
# name that no key begins with, and where no file has the name of a key.
#
# A citation is what stands in brackets, or in parentheses around a year in parentheses, and begins with a name:
# [AR14 (7)], [Kim & Gu, J. R. Stat. Soc. B 66 (2004) 337], [Deuflhard], [Bardsley & Fox 2012; Everink et al.],
# (Portugal, Júdice & Vicente, Math. Comp. 63 (1994) 625). It may go over lines of a comment. Of programs only
# comments are read, of Markdown what is no code and no link.

# The name that it begins with: "G. H. Golub, V. Pereyra, SIAM …" -> "Golub".
function name_of(citation) {
  gsub(/^[ \t]+|[ \t]+$/, "", citation)
  while (sub(/^[A-Z]\.(-[A-Z]\.)?[ ]?/, "", citation)) { }
  sub(/(,| &| and | et al| \(| Fig\.| App\.| [12][0-9][0-9][0-9]$).*/, "", citation)
  return citation
}

# Begins with a name, and has a year or two names, or is a name alone; no sign of code.
function is_citation(text) {
  if (text ~ /[=<>_{}|*]|::|->/) return 0
  if (text ~ /^AR14/) return 1
  while (sub(/^[A-Z]\.(-[A-Z]\.)?[ ]?/, "", text)) { }
  if (text !~ /^[A-Z][A-Za-z\200-\377]+/) return 0
  return text ~ /(^|[^0-9])(19|20)[0-9][0-9]([^0-9]|$)/ || text ~ /^[A-Z][a-z\200-\377]+ & [A-Z]/ ||
         text ~ / et al\.?/ || text ~ /^[A-Z][a-z\200-\377][a-z\200-\377][a-z\200-\377]+$/
}

function check(citation,    parts, count, i, part) {
  count = split(citation, parts, ";")
  for (i = 1; i <= count; ++i) {
    part = parts[i]
    gsub(/^[ \t]+|[ \t]+$/, "", part)
    if (!is_citation(part) || name_of(part) in key_of) continue
    print file ":" first ": [" citation "] has no entry in the bibliography"
    failed = 1
  }
}

# The citations of the text that was gathered, and the names of keys in it.
function flush_text(    rest, found, after, name) {
  rest = text
  while (match(rest, /\[[^][]*\]|\([A-Z][^()]*\((19|20)[0-9][0-9]\)[^()]*\)/)) {
    found = substr(rest, RSTART + 1, RLENGTH - 2)
    after = substr(rest, RSTART + RLENGTH, 1)
    rest = substr(rest, RSTART + RLENGTH)
    if (after != "(") check(found)
  }
  for (name in key_of) {
    if (!(name in used) && index(text, name) && text ~ ("(^|[^A-Za-z])" name "([^A-Za-z]|$)")) used[name] = 1
  }
  text = ""
}

FILENAME == ARGV[1] {
  if (/^\| / && !/^\| key / && split($0, cells, "|") > 2) {
    gsub(/^ +| +$/, "", cells[2])
    if (name_of(cells[2]) in key_of) { print FILENAME ":" FNR ": " cells[2] " is there twice"; failed = 1 }
    key_of[name_of(cells[2])] = cells[2]
    keys++
  }
  next
}

FNR == 1 { flush_text(); file = FILENAME; markdown = file ~ /\.md$/; fenced = 0 }

markdown {
  if (/^[ >]*```/) { fenced = !fenced; flush_text(); next }
  if (fenced || /^    /) { flush_text(); next }
  gsub(/`[^`]*`/, "")
  sub(/^> ?/, "")
  if (/^[ \t]*$/ || /^\|/ || /^ *[*-] /) flush_text()
  if (text == "") first = FNR
  text = text " " $0
  next
}

{
  if (!match($0, /(^|[ \t])(\/\/+<?|#+|%)( |$)/)) { flush_text(); next }
  if (text == "") first = FNR
  text = text " " substr($0, RSTART + RLENGTH)
}

END {
  flush_text()
  if (keys == 0) { print ARGV[1] ": no keys found"; failed = 1 }
  for (name in key_of) {
    if (name in used) continue
    print ARGV[1] ": nothing cites " key_of[name]
    failed = 1
  }
  exit failed
}
