// SPDX-License-Identifier: Apache-2.0
// JSON-RPC 2.0: messages in, answers out. It knows no socket.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace moonraker {

using Json = nlohmann::json;
struct Core;
class Connection;

// Of JSON-RPC 2.0; other errors have the codes of HTTP, as Moonraker's.
inline constexpr int parse_error = -32700, invalid_request = -32600, unknown_method = -32601,
                     invalid_params = -32602, too_busy = -32000;

struct Error : std::runtime_error {
  Error(int number, const std::string& why) : std::runtime_error(why), code(number) {}
  int code;
};
// The status that the same error has over HTTP.
int status_of(const Error& error);
// What is being handled, as an error of this kind: 404 no such job or printer, 400 not now or wrong
// parameters, 507 no space, 500 all others. To be called in a catch block only.
Error current_error();

// `connection`: that asks; null over HTTP.
using Handler = Json (*)(Core&, const Json& params, Connection* connection);

struct Method {
  std::string_view name;
  std::string_view verb, path;  // over HTTP; empty: not at all
  Handler run;
  bool needs_no_key = false;
};

class Methods {
 public:
  Methods();
  const std::vector<Method>& all() const { return methods_; }
  const Method* find(std::string_view name) const;
  // Whether the path is one of a method that needs no key.
  bool is_open(std::string_view path) const;
  // The result. Throws Error.
  Json call(Core& core, const Method& method, const Json& params, Connection* connection) const;
  // The answer to a message, which may be a batch; nothing where it needs none. Throws nothing.
  std::optional<Json> answer_to(Core& core, const Json& message, Connection* connection) const;

 private:
  std::optional<Json> answer_to_one(Core& core, const Json& message, Connection* connection) const;
  std::vector<Method> methods_;
};

// Nothing where it is no JSON, or nested too deep.
std::optional<Json> parsed(std::string_view text);
std::string dumped(const Json& json);
Json error_answer(const Json& id, const Error& error);
// Without an answer: `params` are an array, as Moonraker's are.
std::string notification(std::string_view method, const Json& params = nullptr);

// Parameters; those of a query string are texts. Throw Error invalid_params.
std::string text_in(const Json& params, const char* name);
std::string text_in(const Json& params, const char* name, const std::string& otherwise);
std::int64_t integer_in(const Json& params, const char* name, std::int64_t otherwise);
bool flag_in(const Json& params, const char* name);  // false where it is missing

}  // namespace moonraker
