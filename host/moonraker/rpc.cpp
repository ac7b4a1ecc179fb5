// SPDX-License-Identifier: Apache-2.0
// Messages are checked here, so that a method sees an object of parameters.
#include "host/moonraker/rpc.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <system_error>

#include "host/moonraker/connection.hpp"
#include "host/moonraker/method_tables.hpp"
#include "host/spooler/spooler.hpp"
#include "host/web/http.hpp"

namespace moonraker {

namespace {

constexpr std::size_t longest_batch = 20;

bool is_id(const Json& id) { return id.is_string() || id.is_number() || id.is_null(); }

}  // namespace

int status_of(const Error& error) {
  if (error.code >= 400 && error.code < 600) return error.code;
  if (error.code == unknown_method) return 404;
  return error.code == too_busy ? 503 : 400;
}

Error current_error() {
  try {
    throw;
  } catch (const Error& error) {
    return error;
  } catch (const web::HttpError& error) {
    return {error.status, error.what()};
  } catch (const queue::NoSuchJob& error) {
    return {404, error.what()};
  } catch (const spooler::NoSuchPrinter& error) {
    return {404, error.what()};
  } catch (const queue::NotPermitted& error) {
    return {400, error.what()};
  } catch (const spooler::Refused& error) {
    return {400, error.what()};
  } catch (const queue::Unavailable& error) {
    return {503, error.what()};
  } catch (const Json::exception&) {
    return {invalid_params, "a parameter has a wrong type"};
  } catch (const std::system_error& error) {
    const bool full = error.code().value() == ENOSPC || error.code().value() == EDQUOT;
    return {full ? 507 : 500, error.what()};
  } catch (const std::exception& error) {
    return {500, error.what()};
  }
}

Methods::Methods() {
  for (const auto& table :
       {access_methods(), database_methods(), file_methods(), history_methods(), machine_methods(),
        object_methods(), printer_methods(), queue_methods(), server_methods()}) {
    methods_.insert(methods_.end(), table.begin(), table.end());
  }
}

const Method* Methods::find(std::string_view name) const {
  const auto found = std::ranges::find(methods_, name, &Method::name);
  return found == methods_.end() ? nullptr : &*found;
}

bool Methods::is_open(std::string_view path) const {
  return std::ranges::any_of(methods_, [path](const Method& method) {
    return method.needs_no_key && !method.path.empty() && method.path == path;
  });
}

Json Methods::call(Core& core, const Method& method, const Json& params,
                   Connection* connection) const {
  if (connection != nullptr && !connection->is_authorised() && !method.needs_no_key) {
    throw Error(401, "Unauthorized: the key is missing (server.connection.identify)");
  }
  if (!params.is_object()) throw Error(invalid_params, "the parameters must be an object");
  try {
    return method.run(core, params, connection);
  } catch (...) {
    throw current_error();
  }
}

std::optional<Json> Methods::answer_to(Core& core, const Json& message,
                                       Connection* connection) const {
  if (!message.is_array()) return answer_to_one(core, message, connection);
  if (connection != nullptr && !connection->is_authorised()) {  // no list of keys
    return error_answer(nullptr, {401, "Unauthorized: a batch needs the key before"});
  }
  if (message.empty() || message.size() > longest_batch) {
    return error_answer(nullptr, {invalid_request, "a batch has 1 to 20 requests"});
  }
  Json answers = Json::array();
  for (const Json& each : message) {
    if (auto answer = answer_to_one(core, each, connection)) answers.push_back(*std::move(answer));
  }
  if (answers.empty()) return std::nullopt;
  return answers;
}

std::optional<Json> Methods::answer_to_one(Core& core, const Json& message,
                                           Connection* connection) const {
  Json id;
  bool is_answered = true;
  try {
    if (!message.is_object()) throw Error(invalid_request, "a request is an object");
    const bool has_id = message.contains("id");
    if (has_id && is_id(message.at("id"))) id = message.at("id");
    const auto method = message.find("method");
    const auto version = message.find("jsonrpc");
    if (version == message.end() || *version != "2.0" || method == message.end() ||
        !method->is_string() || (has_id && !is_id(message.at("id")))) {
      throw Error(invalid_request, "no request of JSON-RPC 2.0");
    }
    is_answered = has_id;
    const Method* found = find(method->get_ref<const std::string&>());
    if (found == nullptr) throw Error(unknown_method, "Method not found");
    const auto params = message.find("params");
    const bool has_none =
        params == message.end() || params->is_null() || (params->is_array() && params->empty());
    const Json result = call(core, *found, has_none ? Json::object() : *params, connection);
    if (!is_answered) return std::nullopt;
    return Json{{"jsonrpc", "2.0"}, {"result", result}, {"id", id}};
  } catch (const Error& error) {
    if (!is_answered) return std::nullopt;
    return error_answer(id, error);
  }
}

std::optional<Json> parsed(std::string_view text) {
  if (web::is_too_deep(text)) return std::nullopt;
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::nullopt;
  return json;
}

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json error_answer(const Json& id, const Error& error) {
  return {
      {"jsonrpc", "2.0"}, {"error", {{"code", error.code}, {"message", error.what()}}}, {"id", id}};
}

std::string notification(std::string_view method, const Json& params) {
  Json json{{"jsonrpc", "2.0"}, {"method", method}};
  if (!params.is_null()) json["params"] = params;
  return dumped(json);
}

std::string text_in(const Json& params, const char* name) {
  const auto found = params.find(name);
  if (found == params.end() || !found->is_string()) {
    throw Error(invalid_params, std::string("the parameter `") + name + "` must be a text");
  }
  return *found;
}

std::string text_in(const Json& params, const char* name, const std::string& otherwise) {
  const auto found = params.find(name);
  return found == params.end() || found->is_null() ? otherwise : text_in(params, name);
}

std::int64_t integer_in(const Json& params, const char* name, std::int64_t otherwise) {
  const auto found = params.find(name);
  if (found == params.end() || found->is_null()) return otherwise;
  if (found->is_number_integer()) return found->get<std::int64_t>();
  const std::string text = found->is_string() ? found->get<std::string>() : "";
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) {
    throw Error(invalid_params, std::string("the parameter `") + name + "` must be an integer");
  }
  return value;
}

bool flag_in(const Json& params, const char* name) {
  const auto found = params.find(name);
  if (found == params.end()) return false;
  if (found->is_boolean()) return *found;
  return found->is_string() && (*found == "true" || *found == "1");
}

}  // namespace moonraker
