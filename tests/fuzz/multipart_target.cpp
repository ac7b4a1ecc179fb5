// SPDX-License-Identifier: Apache-2.0
// Forms: read in one piece or in any pieces, the same parts with the same data, or a refusal; and
// what was written as a form comes out as it was.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/queue/store.hpp"
#include "host/web/multipart.hpp"
#include "tests/fuzz/property.hpp"

namespace {

struct Part {
  std::string name;
  std::optional<std::string> file_name;
  std::string data;
  bool operator==(const Part&) const = default;
};
struct Form {
  std::vector<Part> parts;
  bool is_whole = false;
  std::string refusal;
  bool operator==(const Form&) const = default;
};

// `cuts`: sizes of the pieces, again and again; empty: one piece.
Form read(std::string_view body, const std::string& boundary, std::string_view cuts) {
  Form form;
  web::MultipartReader reader(
      boundary,
      [&](const web::MultipartReader::Part& part) {
        form.parts.push_back({part.name, part.file_name, ""});
      },
      [&](std::string_view data) {
        fuzz::require(!form.parts.empty(), "data comes before a part");
        form.parts.back().data += data;
      });
  try {
    for (std::size_t at = 0, cut = 0; at < body.size(); ++cut) {
      const std::size_t size =
          cuts.empty() ? body.size()
                       : std::size_t{1} + static_cast<unsigned char>(cuts[cut % cuts.size()]) % 40u;
      // Of exactly this size, so that a byte beyond it is seen.
      reader.take(std::string(body.substr(at, size)));
      at += size;
    }
  } catch (const web::MultipartError& error) {
    form.refusal = error.what();
    form.parts.clear();  // how far it came depends on the pieces
  }
  form.is_whole = reader.is_whole() && form.refusal.empty();
  return form;
}

std::string in_quotes(std::string_view text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') all += '\\';
    all += c;
  }
  return all + "\"";
}

void require_the_same_again(const std::vector<Part>& parts, const std::string& boundary) {
  std::string body;
  for (const Part& part : parts) {
    // A line end in a name, or a boundary in the data, cannot be written.
    const std::string name = part.name + part.file_name.value_or("");
    if (name.contains('\r') || name.contains('\n') || name.size() > 2000 ||
        ("\r\n" + part.data + "\r\n").contains("\r\n--" + boundary)) {
      return;
    }
    body += "--" + boundary + "\r\nContent-Disposition: form-data; name=" + in_quotes(part.name);
    if (part.file_name) body += "; filename=" + in_quotes(*part.file_name);
    body += "\r\n\r\n" + part.data + "\r\n";
  }
  const Form again = read(body + "--" + boundary + "--", boundary, {});
  fuzz::require(again.refusal.empty() && again.is_whole && again.parts == parts,
                "a written form is read as another one: {}", again.refusal);
}

void require_a_harmless_name(const std::string& name) {
  const std::string cleaned = queue::cleaned_name(name);
  const bool is_harmless = !cleaned.empty() && cleaned.size() <= 120 && cleaned[0] != '.' &&
                           std::ranges::all_of(cleaned, [](char c) {
                             const auto byte = static_cast<unsigned char>(c);
                             return c != '/' && c != '\\' && byte >= 0x20 && byte != 0x7f;
                           });
  fuzz::require(is_harmless, "the name \"{}\" is cleaned to \"{}\"", name, cleaned);
}

}  // namespace

// The first line is the Content-Type, the second one says where the body is cut.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t first = std::min(input.find('\n'), size);
  const std::size_t second = std::min(input.find('\n', std::min(first + 1, size)), size);
  const std::string_view cuts = input.substr(std::min(first + 1, second), second - first);
  const std::string_view body = input.substr(std::min(second + 1, size));
  std::optional<std::string> boundary;
  try {
    boundary = web::boundary_of(input.substr(0, first));
  } catch (const web::MultipartError&) {
    return 0;
  }
  if (!boundary) return 0;
  const Form whole = read(body, *boundary, {});
  const Form cut = read(body, *boundary, cuts);
  fuzz::require(whole.refusal.empty() == cut.refusal.empty() && whole.parts == cut.parts &&
                    whole.is_whole == cut.is_whole,
                "in pieces it is another form: \"{}\", \"{}\"", whole.refusal, cut.refusal);
  if (whole.is_whole) require_the_same_again(whole.parts, *boundary);
  for (const Part& part : whole.parts) require_a_harmless_name(part.file_name.value_or(""));
  return 0;
}
