# Splits a Markdown document into the steps of a user, one file per step, by the comments that stand
# before its code blocks, alone on their lines:
#
#   <!-- session -->        a ```sh block whose commands the reader types
#   <!-- session with FILE -->  the same, where FILE is there in the folder MICROSLIP_DATA_DIR; not run elsewhere
#   <!-- python -->         a ```python block that the reader types in one interpreter, after all commands
#   <!-- output -->         a ```text block with lines that the session or the Python block above prints
#   <!-- output exact -->   the same to the last digit
#   <!-- file NAME -->      a block that the reader saves as NAME
#   <!-- run COMMAND -->    no block: a command that only the test types
#   <!-- not run: WHY -->   a ```sh block that cannot run
#   <!-- needs PROGRAM -->  no block: the document is not run where that program is not installed
#
# Writes into the folder STEPS, with numbers in the order of the document: NNN.sh, NNN.py, NNN.file, NNN.expected,
# and to standard output one line per step: NNN KIND LINE NAME. Faults go to standard
# error, and the status is 1.

function fail(line, text) {
  printf "%s:%d: %s\n", DOCUMENT, line, text >"/dev/stderr"
  failed = 1
}

function begin_step(what, line, name) {
  file = sprintf("%s/%03d.%s", STEPS, ++steps, what)
  printf "" >file
  printf "%03d %s %d %s\n", steps, what, line, name
}

# The mark before a block is used up by it.
function open_block(language) {
  file = ""
  if (mark ~ /^session/ && language != "sh") fail(NR, "a session is a block ```sh, not ```" language)
  if (mark ~ /^python/ && language != "python") fail(NR, "python is a block ```python, not ```" language)
  if (mark ~ /^output/ && language != "text") fail(NR, "output is a block ```text, not ```" language)
  if (mark ~ /^session/) {
    begin_step("sh", NR, substr(mark, 14))
    has_session = 1
  } else if (mark == "python") {
    begin_step("py", NR, "")
    has_session = 1
  } else if (mark ~ /^output/) {
    if (!has_session) fail(NR, "output without a session above it")
    begin_step("expected", NR, mark == "output exact" ? "exact" : "rounded")
  } else if (mark ~ /^file /) {
    begin_step("file", NR, substr(mark, 6))
  } else if (language == "sh" && mark !~ /^not run: ./) {
    fail(NR, "a block of commands without <!-- session --> or <!-- not run: WHY --> before it")
  }
  mark = ""
}

function read_mark(text) {
  if (mark != "") fail(NR, "a mark follows the mark '" mark "': a block is missing")
  if (text ~ /^run ./) {
    begin_step("sh", NR, "")
    print substr(text, 5) >file
    close(file)
  } else if (text ~ /^needs [^ ]+$/) {
    begin_step("needs", NR, substr(text, 7))
  } else if (text ~ /^(session|python|output|output exact)$/ || text ~ /^(not run:|file|session with) ./) {
    mark = text
  } else if (text ~ /^(session|python|output|file|run|not run|needs)/) {
    fail(NR, "unknown mark <!-- " text " -->")
  }
}

/^ *```/ {
  if (inside) {
    inside = 0
    if (file != "") close(file)
    file = ""
  } else {
    inside = NR
    language = $0
    sub(/^ *```/, "", language)
    open_block(language)
  }
  next
}
inside {
  if (file != "") print >file
  next
}
/^<!-- .* -->$/ {
  read_mark(substr($0, 6, length($0) - 9))
  next
}
mark != "" && !/^[ \t]*$/ {
  fail(NR, "'" mark "' is not followed by a block")
  mark = ""
}
END {
  if (inside) fail(inside, "a block without end")
  if (mark != "") fail(NR, "'" mark "' is not followed by a block")
  exit failed
}
