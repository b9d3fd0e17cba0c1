# Whether the lines that a document shows were printed. Usage:
#   awk -f compare_output.awk -v EXACT=0 EXPECTED PRINTED
#
# The lines shown are an excerpt: they stand one below the other in the output, anywhere. A line
# "…" stands for any number of lines, also none; "…" in a line for any text. Blanks count as one, those at the ends
# not at all. A number with a decimal point or an exponent may differ by one in its last digit shown, all other
# numbers are exact; with EXACT=1 all are.

BEGIN { kAny = "…" }

function clean(text) {
  gsub(/[ \t\r]+/, " ", text)
  sub(/^ /, "", text)
  sub(/ $/, "", text)
  return text
}

# The length of the number that a text begins with, 0 where it begins with none.
function number_length(text) {
  if (match(text, /^[0-9]+(\.[0-9]+)?([eE][-+]?[0-9]+)?/)) return RLENGTH
  return 0
}

# One in the last digit shown; 0 for a whole number.
function last_digit(number, parts, mantissa, exponent) {
  if (EXACT || number !~ /[.eE]/) return 0
  mantissa = number
  exponent = 0
  if (split(number, parts, /[eE]/) == 2) {
    mantissa = parts[1]
    exponent = parts[2] + 0
  }
  if (index(mantissa, ".")) exponent -= length(mantissa) - index(mantissa, ".")
  return 10 ^ exponent
}

function numbers_agree(shown, printed, difference) {
  if (shown == printed) return 1
  difference = shown - printed
  if (difference < 0) difference = -difference
  return difference <= 1.000001 * last_digit(shown)
}

# Whether a whole line agrees; both are clean.
function lines_agree(shown, printed, n, m, i) {
  while (shown != "") {
    if (index(shown, kAny) == 1) {
      shown = substr(shown, length(kAny) + 1)
      for (i = 1; i <= length(printed) + 1; ++i) {
        if (lines_agree(shown, substr(printed, i))) return 1
      }
      return 0
    }
    n = number_length(shown)
    m = number_length(printed)
    if (n > 0 && m > 0) {
      if (!numbers_agree(substr(shown, 1, n), substr(printed, 1, m))) return 0
    } else {
      n = m = 1
      if (substr(shown, 1, 1) != substr(printed, 1, 1)) return 0
    }
    shown = substr(shown, n + 1)
    printed = substr(printed, m + 1)
  }
  return printed == ""
}

# Lines `from` to `to` of those shown, at line `at` of those printed: how many agree.
function agreeing(from, to, at, i) {
  for (i = from; i <= to; ++i) {
    if (at + i - from > printed_lines || !lines_agree(shown[i], printed[at + i - from])) break
  }
  return i - from
}

# The first place at or after `at` where lines `from` to `to` stand; 0 where they do not.
function place(from, to, at, most, count) {
  most = -1
  missing = from
  for (; at <= printed_lines; ++at) {
    count = agreeing(from, to, at)
    if (count == to - from + 1) return at
    if (count > most) {
      most = count
      missing = from + count
      nearest = at + count
    }
  }
  return 0
}

FILENAME == ARGV[1] { shown[++shown_lines] = clean($0); next }
{ printed[++printed_lines] = clean($0) }

END {
  at = 1
  missing = 1
  for (from = 1; from <= shown_lines; from = to + 2) {
    for (to = from; to <= shown_lines && shown[to] != kAny; ++to);
    --to
    if (to < from) continue
    found = place(from, to, at)
    if (!found) {
      printf "line %d of it is not printed: '%s'\n", missing, shown[missing]
      if (missing > from) printf "printed there: '%s'\n", printed[nearest]
      exit 1
    }
    at = found + to - from + 1
  }
  if (shown_lines == 0) {
    print "it shows nothing"
    exit 1
  }
}
