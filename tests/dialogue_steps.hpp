// SPDX-License-Identifier: Apache-2.0
// The notation of all dialogues: one step a line, of which each player knows the verbs that it can
// play.
//   -> N5 G1 X1*?    the host sends a line; "*?" becomes the right checksum, "*!" a wrong one
//   <- ok            the firmware's next line is this one
//   <* T:20          its next line contains this
//   # comment
// The other verbs are those of host_link/dialogue.hpp.
#pragma once

#include <istream>
#include <string>
#include <vector>

struct DialogueStep {
  int line{};
  std::string verb;
  std::string argument;

  std::string text() const { return argument.empty() ? verb : verb + " " + argument; }
};

inline DialogueStep dialogue_step(const std::string& text, int line) {
  const std::size_t blank = text.find(' ');
  return {line, text.substr(0, blank), blank == std::string::npos ? "" : text.substr(blank + 1)};
}

// Without comments and empty lines; blanks before a step do not count.
inline std::vector<DialogueStep> dialogue_steps(std::istream& stream) {
  std::vector<DialogueStep> steps;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    line.erase(0, line.find_first_not_of(' '));
    if (!line.empty() && line[0] != '#') steps.push_back(dialogue_step(line, number));
  }
  return steps;
}

// `text` with "*?" and "*!" at its end replaced by the right and by a wrong checksum.
inline std::string with_checksum(const std::string& text) {
  if (text.size() < 2 || text[text.size() - 2] != '*') return text;
  const char kind = text.back();
  if (kind != '?' && kind != '!') return text;
  const std::string framed = text.substr(0, text.size() - 2);
  unsigned sum = 0;
  for (const char c : framed) sum ^= static_cast<unsigned char>(c);
  return framed + "*" + std::to_string(kind == '?' ? sum : sum ^ 1u);
}
