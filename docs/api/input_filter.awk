# What Doxygen reads in place of a file; no line is moved.
#   * A header and all in it join the group of its folder (main_page.dox).
#   * What is private is left out: Doxygen 1.9.4 links to it where it shows none of it.
#   * A citation, [KEY …], becomes a link to the bibliography where KEY is in its table. A full stop in
#     it ends no sentence, and so no summary.
#   * A range that begins a comment, > 0, is no quotation.
#   * A document in Markdown can be referred to by its name; what it links to in the tree is not there.
# Formulas, which are indented by four, are left as they stand.
# Argument: -v bibliography=docs/bibliography.md.

BEGIN {
  while ((getline line <bibliography) > 0) {
    if (split(line, cell, / *\| */) > 2 && cell[2] != "key" && cell[2] !~ /^-+$/) {
      keys[cell[2]]
    }
  }
}

# The text with each "[KEY" a link and no ". " between brackets.
function with_citations(text, done, end, cited, key) {
  while (match(text, /\[[A-Z]/)) {
    done = done substr(text, 1, RSTART)
    text = substr(text, RSTART + 1)
    end = index(text, "]")
    cited = end ? substr(text, 1, end) : text
    text = substr(text, length(cited) + 1)
    gsub(/\. /, ".\\ ", cited)
    for (key in keys) {
      if (index(cited, key) == 1 && substr(cited, length(key) + 1, 1) ~ /^[] ,;]?$/) {
        cited = "@ref bibliography \"" key "\"" substr(cited, length(key) + 1)
        break
      }
    }
    done = done cited
  }
  return done text
}

# The text without the targets of links but addresses.
function without_links(text, done, link) {
  while (match(text, /\[[^][]*\]\([^()]*\)/)) {
    link = substr(text, RSTART, RLENGTH)
    done = done substr(text, 1, RSTART - 1)
    text = substr(text, RSTART + RLENGTH)
    if (link !~ /\]\(https?:/) {
      sub(/\]\(.*/, "", link)
      link = substr(link, 2)
    }
    done = done link
  }
  return done text
}

FNR == 1 {
  parts = split(FILENAME, part, "/")
  group = part[parts - 1]
  markdown = sub(/\.md$/, "", part[parts])
  if (markdown) $0 = $0 " {#" part[parts] "}"
}
markdown { $0 = without_links($0) }

# The namespace itself is of no group.
/^\/\/ SPDX/ { $0 = "/** @addtogroup " group " */ /** @{ */"; open = 1 }
/^namespace microslip \{/ { $0 = "/** @} */ " $0 " /** @addtogroup " group " */ /** @{ */" }
/^\}  \/\/ namespace microslip/ { $0 = "/** @} */ " $0; open = 0 }

/\/\/\// && !/^ *\/\/\/     / {
  at = index($0, "///")
  comment = substr($0, at)
  if (match(comment, /^\/\/\/<? >/)) {
    comment = substr(comment, 1, RLENGTH - 1) "\\" substr(comment, RLENGTH)
  }
  $0 = substr($0, 1, at - 1) with_citations(comment)
}

/^ private:$/ { private = 1 }
/^};/ { private = 0 }
{ print private ? "" : $0 }

# A header that only includes another has no namespace, at whose end the group would end.
END { if (open) print "/** @} */" }
