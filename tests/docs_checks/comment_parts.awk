# The comments of C++ headers as prose, a line each, in the form of markdown_parts.awk. Without what
# stands between backticks, formulas (indented by four) and the names after @param, @throws and the like.

{
  at = match($0, /(^|[^:"])\/\/+[!\/]?<?/)
  if (!at) next
  text = substr($0, at + RLENGTH)
  if (text ~ /^     / || text ~ /^ namespace /) next
  gsub(/`[^`]*`/, "~", text)
  gsub(/@(param|throws|ref|see)(\[[a-z,]*\])? +[A-Za-z_]+(, *[A-Za-z_]+)* /, "~ ", text)
  # A comment behind code does not continue the comment above.
  if (at > 1 && $0 ~ /[^ ].*\/\//) text = "~ " text
  if (text ~ /[^ ]/) print "prose\t" FILENAME "\t" FNR "\t" text
}
