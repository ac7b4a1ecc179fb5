// SPDX-License-Identifier: Apache-2.0
// Text of addresses; the system reads the numbers.
#include "host/web/address.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "host/web/ascii.hpp"

namespace web {

namespace {

bool is_ipv4(const std::string& host) {
  in_addr address{};
  return inet_pton(AF_INET, host.c_str(), &address) == 1;
}

bool is_ipv6(const std::string& host) {
  in6_addr address{};
  return inet_pton(AF_INET6, host.c_str(), &address) == 1;
}

struct Parts {
  std::string host;
  std::string_view port;
  bool in_brackets = false;
};

// False where brackets are open, or something else than a port follows them.
bool split(std::string_view text, Parts& parts) {
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) return false;
    parts.host = text.substr(1, end - 1);
    parts.in_brackets = true;
    text.remove_prefix(end + 1);
    if (!text.empty() && text.front() != ':') return false;
  } else {
    const std::size_t colon = text.find(':');
    parts.host = text.substr(0, colon);
    text = colon == std::string_view::npos ? std::string_view() : text.substr(colon);
  }
  if (!text.empty()) {
    parts.port = text.substr(1);
    if (parts.port.empty()) return false;
  }
  return true;
}

bool read_port(std::string_view text, std::uint16_t& port) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

Address address_of(std::string_view text, std::uint16_t port) {
  Address address{.host = std::string(text), .port = port};
  if (is_ipv6(address.host)) return address;
  Parts parts;
  if (!split(text, parts) || (!parts.port.empty() && !read_port(parts.port, address.port))) {
    throw std::runtime_error("no address to listen on: " + std::string(text));
  }
  address.host = parts.host.empty() ? "127.0.0.1" : parts.host;
  return address;
}

bool is_loopback(std::string_view host) {
  const std::string text(host);
  return equal_names(host, "localhost") || text == "::1" ||
         (is_ipv4(text) && text.starts_with("127."));
}

std::string written(const Address& address) {
  const std::string host = is_ipv6(address.host) ? "[" + address.host + "]" : address.host;
  return host + ":" + std::to_string(address.port);
}

bool is_own_name(std::string_view host_header, const std::vector<std::string>& names) {
  Parts parts;
  std::uint16_t port = 0;
  if (!split(host_header, parts) || parts.host.empty()) return false;
  if (!parts.port.empty() && !read_port(parts.port, port)) return false;
  if (parts.in_brackets) return is_ipv6(parts.host);
  return is_ipv4(parts.host) || equal_names(parts.host, "localhost") ||
         std::ranges::any_of(
             names, [&](const std::string& name) { return equal_names(parts.host, name); });
}

}  // namespace web
