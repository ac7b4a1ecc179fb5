// SPDX-License-Identifier: Apache-2.0
// Errors as statuses, bodies as JSON.
#include "host/web/http.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include "host/spooler/spooler.hpp"
#include "host/web/multipart.hpp"

namespace web {

namespace {

HttpError wrong(const char* name, const std::string& wanted) {
  return {400, std::string("the field `") + name + "` must be " + wanted};
}

constexpr const char* form_type = "Form-Content-Type";

const Json& field(const Json& body, const char* name) {
  const auto found = body.find(name);
  if (found == body.end()) throw HttpError(400, std::string("the field `") + name + "` is missing");
  return *found;
}

}  // namespace

// Where it is there twice, it is refused later.
void set_form_type(httplib::Request& request) {
  request.headers.erase(form_type);
  if (!request.is_multipart_form_data() || request.get_header_value_count("Content-Type") != 1) {
    return;
  }
  request.headers.emplace(form_type, request.get_header_value("Content-Type"));
  request.headers.erase("Content-Type");
}

std::optional<std::string> form_type_of(const httplib::Request& request) {
  if (!request.has_header(form_type)) return std::nullopt;
  return request.get_header_value(form_type);
}

bool is_too_deep(std::string_view json) {
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text && c == '\\') {
      ++i;
    } else if (c == '"') {
      in_text = !in_text;
    } else if (!in_text && (c == '[' || c == '{')) {
      if (++depth > deepest_json) return true;
    } else if (!in_text && (c == ']' || c == '}')) {
      --depth;
    }
  }
  return false;
}

void answer(httplib::Response& response, const Json& json, int status) {
  response.status = status;
  response.set_content(json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n",
                       "application/json");
}

void answer_error(httplib::Response& response, int status, const std::string& why) {
  answer(response, {{"error", why}}, status);
}

void answer_errors_of(httplib::Response& response, const std::function<void()>& work) {
  try {
    work();
  } catch (const HttpError& error) {
    answer_error(response, error.status, error.what());
  } catch (const MultipartError& error) {
    answer_error(response, 400, error.what());
  } catch (const queue::NoSuchJob& error) {
    answer_error(response, 404, error.what());
  } catch (const spooler::NoSuchPrinter& error) {
    answer_error(response, 404, error.what());
  } catch (const queue::NotPermitted& error) {
    answer_error(response, 409, error.what());
  } catch (const spooler::Refused& error) {
    answer_error(response, 409, error.what());
  } catch (const queue::Unavailable& error) {
    answer_error(response, 503, error.what());
  } catch (const nlohmann::json::exception& error) {
    answer_error(response, 400, "a field of the body has a wrong type");
  } catch (const std::system_error& error) {
    const bool full = error.code().value() == ENOSPC || error.code().value() == EDQUOT;
    answer_error(response, full ? 507 : 500, error.what());
  } catch (const std::exception& error) {
    answer_error(response, 500, error.what());
  }
}

Json body_of(const httplib::Request& request, const httplib::ContentReader& read) {
  // Such as `curl -X POST`: httplib would wait for the end of the connection.
  const bool has_body =
      request.has_header("Content-Length") || request.has_header("Transfer-Encoding");
  if (!has_body) return Json::object();
  if (form_type_of(request)) throw HttpError(415, "JSON is expected");
  std::string text;
  const bool whole = read([&text](const char* data, std::size_t size) {
    if (text.size() + size > largest_body) return false;
    text.append(data, size);
    return true;
  });
  if (!whole) throw HttpError(413, "more than 64 KiB, or the body ended early");
  if (text.find_first_not_of(" \r\n\t") == std::string::npos) return Json::object();
  if (is_too_deep(text)) throw HttpError(400, "the body is nested too deep");
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw HttpError(400, "the body is no JSON");
  if (!json.is_object()) throw HttpError(400, "a JSON object is expected");
  return json;
}

bool bool_of(const Json& body, const char* name) {
  const Json& value = field(body, name);
  if (!value.is_boolean()) throw wrong(name, "true or false");
  return value;
}

std::string text_of(const Json& body, const char* name) {
  const Json& value = field(body, name);
  if (!value.is_string()) throw wrong(name, "a text");
  return value;
}

std::optional<double> number_of(const Json& body, const char* name, double highest) {
  const Json& value = field(body, name);
  if (value.is_null()) return std::nullopt;
  const bool fits = value.is_number() && value >= 0 && value <= highest;
  if (!fits) throw wrong(name, "null, or a number that is not negative and not too large");
  return value.get<double>();
}

queue::JobId job_of(const Json& body, const char* name) {
  const Json& value = field(body, name);
  const bool fits = value.is_number_unsigned() && value.get<std::uint64_t>() > 0 &&
                    std::in_range<queue::JobId>(value.get<std::uint64_t>());
  if (!fits) throw wrong(name, "the number of a job");
  return value;
}

}  // namespace web
