# SPDX-License-Identifier: Apache-2.0
# The brace rule: takes C++ in which every body has braces, and puts a body that is one statement, and fits, on the line
# of its if, for or while, without braces. An if with an else keeps them. Usage: awk -f braces.awk -v columns=100 FILE

function count(text, character) { return gsub("[" character "]", "", text) }
function balanced(text) {
  return count(text, "(") == count(text, ")") && count(text, "{") == count(text, "}")
}

# The whole of lines `at` to `at` + 2 on one line; empty where they must stay.
function joined(at,   indent, head, body) {
  if (line[at] !~ /^ *(if|for|while) .*\) \{$/ || line[at + 1] !~ /;$/ || line[at] line[at + 1] ~ /\/\//) return ""
  indent = line[at]
  sub(/[^ ].*/, "", indent)
  if (line[at + 2] != indent "}") return ""
  head = substr(line[at], 1, length(line[at]) - 2)
  body = line[at + 1]
  sub(/^ */, "", body)
  # googletest's macros hold an else of their own.
  if (head ~ /^ *if / && body ~ /^(EXPECT|ASSERT)_/) return ""
  if (body ~ /^(if|for|while|do|switch|case|default) *[^a-z_]/ || !balanced(head) || !balanced(body)) return ""
  return length(head) + 1 + length(body) <= columns ? head " " body : ""
}

{ line[NR] = $0 }

END {
  for (i = 1; i <= NR; ++i) {
    text = joined(i)
    print text == "" ? line[i] : text
    if (text != "") i += 2
  }
}
