// SPDX-License-Identifier: Apache-2.0
// cpp-httplib, with the switches that Debian's library was built with, and answers in JSON.
#pragma once

#include <httplib.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "host/queue/job.hpp"

namespace web {

using Json = nlohmann::json;

// An answer other than success; its text is for people.
struct HttpError : std::runtime_error {
  HttpError(int code, const std::string& why) : std::runtime_error(why), status(code) {}
  int status;
};

// httplib would read a form by itself, and cuts names at a semicolon. So a form has its
// Content-Type in a header that no client can send; nothing where the request has no form.
void set_form_type(httplib::Request& request);
std::optional<std::string> form_type_of(const httplib::Request& request);

// No larger body is read but of an upload.
inline constexpr std::size_t largest_body = 64 * 1024;

// JSON that is nested deeper is not taken: the library visits values by recursion.
inline constexpr int deepest_json = 64;
bool is_too_deep(std::string_view json);

void answer(httplib::Response& response, const Json& json, int status = 200);
void answer_error(httplib::Response& response, int status, const std::string& why);

// Runs `work`; what it throws becomes the answer: 404 no such job or printer, 409 not now, 400 bad
// JSON, 507 no space left.
void answer_errors_of(httplib::Response& response, const std::function<void()>& work);

// The body as a JSON object, empty without a body. Throws HttpError 400, 413, 415.
Json body_of(const httplib::Request& request, const httplib::ContentReader& read);

// A field of the body, or an element of one. Throw HttpError 400, which names it.
bool bool_of(const Json& body, const char* name);
std::string text_of(const Json& body, const char* name);
// Null, or a number from 0 to `highest`.
std::optional<double> number_of(const Json& body, const char* name, double highest);
queue::JobId job_of(const Json& body, const char* name);  // 1 to the largest number of 63 bits

}  // namespace web
