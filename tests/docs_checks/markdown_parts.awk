# The parts of Markdown that are checked, one a line, with tabs between kind, file, line and text:
#   link         target of a link or an image, with its title
#   definition   name of a link that is defined elsewhere, [name]: target
#   reference    use of such a name, [text][name]
#   heading      its text
#   html_link    src="… or href="… without the last quote
#   html_anchor  id="… or name="… in HTML
#   code         text between backticks
#   prose        a line without code, targets, addresses and HTML
# Fenced and indented code and comments in HTML have no parts. Any awk; bytes, whatever the encoding.

function part(kind, line, text) {
  gsub(/[\t\n]/, " ", text)
  print kind "\t" file "\t" line "\t" text
}

function newlines(text) { return gsub(/\n/, "\n", text) }

# A span of code is the text between two runs of the same number of backticks. It is taken out, but
# for its line breaks.
function without_code(text, line, kept, run, rest, end, inside) {
  while (match(text, /`+/)) {
    run = substr(text, RSTART, RLENGTH)
    kept = kept substr(text, 1, RSTART - 1)
    rest = substr(text, RSTART + RLENGTH)
    end = place_of_run(rest, length(run))
    if (!end) {
      kept = kept run
      text = rest
      continue
    }
    inside = substr(rest, 1, end - 1)
    part("code", line + newlines(kept), inside)
    gsub(/[^\n]/, "", inside)
    kept = kept " ~ " inside
    text = substr(rest, end + length(run))
  }
  return kept text
}

function place_of_run(text, size, before) {
  before = 0
  while (match(text, /`+/)) {
    if (RLENGTH == size) return before + RSTART
    before += RSTART + RLENGTH - 1
    text = substr(text, RSTART + RLENGTH)
  }
  return 0
}

# Parts of the kind where the pattern matches; what is matched is taken out but for its line breaks, or
# left in the text where `keep` is set. The target is what is left after `head` characters.
function take(text, pattern, kind, head, tail, line, kept, found, breaks) {
  while (match(text, pattern)) {
    kept = kept substr(text, 1, RSTART - 1)
    found = substr(text, RSTART, RLENGTH)
    text = substr(text, RSTART + RLENGTH)
    part(kind, line + newlines(kept), substr(found, head + 1, length(found) - head - tail))
    breaks = found
    gsub(/[^\n]/, "", breaks)
    kept = kept " ~ " breaks
  }
  return kept text
}

function end_of_block(text, lines, count, i) {
  if (block == "") return
  text = without_code(block, block_line)
  text = take(text, "\\]\\(([^()\n]|\n|\\([^()]*\\))*\\)", "link", 2, 1, block_line)
  text = take(text, "\\]\\[[^]\n]+\\]", "reference", 2, 1, block_line)
  text = take(text, "(src|href)=\"[^\"]*\"", "html_link", 0, 1, block_line)
  text = take(text, "(id|name)=\"[^\"]*\"", "html_anchor", 0, 1, block_line)
  gsub(/<?https?:\/\/[^ >\n]*>?/, " ", text)
  count = split(text, lines, "\n")
  for (i = 1; i <= count; ++i) {
    gsub(/<[^>]*>/, " ", lines[i])
    if (lines[i] ~ /[^ ]/) part("prose", block_line + i - 1, lines[i])
  }
  block = ""
}

function heading(line, text) {
  gsub(/!?\[|\]\([^)]*\)|\][[][^]]*\]/, "", text)
  gsub(/<[^>]*>/, "", text)
  gsub(/^[ \t]+|[ \t]+#*[ \t]*$/, "", text)
  part("heading", line, text)
}

FNR == 1 {
  end_of_block()
  file = FILENAME
  fence = ""
  in_comment = in_list = after_code = 0
  after_blank = 1
}

{ sub(/\r$/, "") }

# Fences.
fence != "" {
  closing = $0
  gsub(/^[ \t>]+|[ \t]+$/, "", closing)
  if (substr(closing, 1, length(fence)) == fence && closing ~ /^(`+|~+)$/) fence = ""
  next
}
!in_comment && match($0, /^[ \t>]*(````*|~~~~*)/) && $0 !~ /^[ \t>]*```[^`]*`/ {
  end_of_block()
  fence = substr($0, 1, RLENGTH)
  gsub(/[ \t>]/, "", fence)
  next
}

# Comments.
{
  while (in_comment || (open = index($0, "<!--"))) {
    if (in_comment) {
      close_at = index($0, "-->")
      $0 = close_at ? substr($0, close_at + 3) : ""
      in_comment = !close_at
      if (in_comment) break
    } else {
      rest = substr($0, open + 4)
      close_at = index(rest, "-->")
      $0 = substr($0, 1, open - 1) (close_at ? substr(rest, close_at + 3) : "")
      in_comment = !close_at
      if (in_comment) break
    }
  }
}

/^[ \t]*$/ {
  end_of_block()
  after_blank = 1
  next
}

# Indented code, unless the indent is that of a list.
/^(    |\t)/ && (after_blank || after_code) && !in_list {
  after_code = 1
  after_blank = 0
  next
}
{ after_code = 0 }
/^[ ]*([-*+]|[0-9]+[.)])[ \t]/ {
  end_of_block()
  in_list = 1
}
/^[^ \t]/ && after_blank && !/^([-*+]|[0-9]+[.)])[ \t]/ { in_list = 0 }
{ after_blank = 0 }

/^ ? ? ?#+[ \t]/ {
  end_of_block()
  block = $0
  block_line = FNR
  end_of_block()
  sub(/^ *#+/, "")
  heading(FNR, $0)
  after_blank = 1
  next
}
/^ ? ? ?(==*|--*)[ \t]*$/ && block != "" && newlines(block) == 0 {
  heading(block_line, block)
  end_of_block()
  next
}

block == "" && /^ ? ? ?\[[^]]+\]:[ \t]+[^ \t]+([ \t]+"[^"]*")?[ \t]*$/ {
  end = index($0, "]:")
  part("definition", FNR, substr($0, index($0, "[") + 1, end - index($0, "[") - 1))
  sub(/^[^]]*\]:[ \t]+/, "")
  sub(/[ \t].*/, "")
  part("link", FNR, $0)
  next
}

{
  if (block == "") block_line = FNR
  else block = block "\n"
  block = block $0
}

END { end_of_block() }
