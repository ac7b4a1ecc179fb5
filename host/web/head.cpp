// SPDX-License-Identifier: Apache-2.0
// Headers that count, each once.
#include "host/web/head.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "host/web/ascii.hpp"

namespace web {

namespace {

constexpr std::array single_headers{"Host",         "X-Api-Key",      "Authorization",
                                    "Origin",       "Sec-Fetch-Site", "Content-Length",
                                    "Content-Type", "Expect",         "Transfer-Encoding"};
constexpr std::size_t most_digits = 18;
constexpr std::string_view bearer = "bearer ";

bool is_length(std::string_view text) {
  return !text.empty() && text.size() <= most_digits &&
         std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

std::optional<Refusal> fault_of(const httplib::Request& request) {
  for (const char* name : single_headers) {
    if (request.get_header_value_count(name) > 1) {
      return Refusal{.status = 400,
                     .why = std::string("the header ") + name + " is there more than once"};
    }
  }
  const bool has_length = request.has_header("Content-Length");
  const bool has_encoding = request.has_header("Transfer-Encoding");
  if (has_length && has_encoding) {
    return Refusal{.status = 400, .why = "Content-Length and Transfer-Encoding exclude each other"};
  }
  if (has_length && !is_length(request.get_header_value("Content-Length"))) {
    return Refusal{.status = 400, .why = "Content-Length is no number"};
  }
  if (has_encoding && lower(request.get_header_value("Transfer-Encoding")) != "chunked") {
    return Refusal{.status = 400, .why = "the only Transfer-Encoding is chunked"};
  }
  if (request.has_header("Expect") && lower(request.get_header_value("Expect")) != "100-continue") {
    return Refusal{.status = 417, .why = "the only Expect is 100-continue"};
  }
  return std::nullopt;
}

}  // namespace

RequestHead head_of(const httplib::Request& request) {
  const auto header = [&request](const char* name) -> std::optional<std::string> {
    if (!request.has_header(name)) return std::nullopt;
    return request.get_header_value(name);
  };
  std::string key = request.get_header_value("X-Api-Key");
  const std::string authorization = request.get_header_value("Authorization");
  if (key.empty() && lower(authorization.substr(0, bearer.size())) == bearer) {
    key = authorization.substr(
        std::min(authorization.find_first_not_of(' ', bearer.size()), authorization.size()));
  }
  return {.method = request.method,
          .path = request.path,
          .host = request.get_header_value("Host"),
          .origin = header("Origin"),
          .fetch_site = header("Sec-Fetch-Site"),
          .key = std::move(key),
          .token = request.get_param_value("token"),
          .fault = fault_of(request)};
}

}  // namespace web
