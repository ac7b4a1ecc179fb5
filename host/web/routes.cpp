// SPDX-License-Identifier: Apache-2.0
// What the groups of routes share.
#include "host/web/routes.hpp"

#include <algorithm>

namespace web {

void post(Listener& server, const std::string& pattern, JsonHandler handler) {
  server.Post(pattern, [handler = std::move(handler)](const httplib::Request& request,
                                                      httplib::Response& response,
                                                      const httplib::ContentReader& read) {
    answer_errors_of(response, [&] { handler(request, response, body_of(request, read)); });
  });
}

void get(Listener& server, const std::string& pattern, Handler handler) {
  server.Get(pattern, [handler = std::move(handler)](const httplib::Request& request,
                                                     httplib::Response& response) {
    answer_errors_of(response, [&] { handler(request, response); });
  });
}

std::string printer_of(const httplib::Request& request, const spooler::Spooler& spooler) {
  const auto names = spooler.printer_names();
  const std::string name = request.matches[1];
  if (name.empty()) {
    if (names.empty()) throw spooler::NoSuchPrinter("at all");
    return names.front();
  }
  if (!std::ranges::contains(names, name)) throw spooler::NoSuchPrinter(name);
  return name;
}

UploadedJob take_upload(const httplib::Request& request, const httplib::Response& response,
                        const httplib::ContentReader& read, spooler::Spooler& spooler,
                        const std::string& printer) {
  queue::Store::Upload upload(spooler.store());
  UploadForm form = read_form(request, response, read, upload, spooler.free_bytes());
  const queue::JobId id = spooler.add(upload, form.file_name, !form.prints, printer);
  return {.id = id, .form = std::move(form)};
}

namespace {

// Why httplib itself refuses a request.
const char* reason_of(int status) {
  switch (status) {
    case 400:
      return "the head of the request is broken, or its method is unknown";
    case 404:
      return "there is nothing of this name";
    case 413:
      return "the body is too long";
    case 414:
      return "the address is too long";
    case 416:
      return "there is no such range";
    default:
      return status >= 500 ? "the server has failed" : "the request cannot be answered";
  }
}

}  // namespace

void add_last_routes(Listener& server) {
  const auto not_found = [](const httplib::Request&, httplib::Response& response,
                            const httplib::ContentReader&) {
    answer_error(response, 404, reason_of(404));
  };
  server.Post(".*", not_found);
  server.Put(".*", not_found);
  server.Patch(".*", not_found);
  server.Delete(".*", not_found);
  server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
    if (response.body.empty()) answer_error(response, response.status, reason_of(response.status));
  });
}

}  // namespace web
