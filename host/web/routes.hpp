// SPDX-License-Identifier: Apache-2.0
// What the server answers, in groups.
#pragma once

#include <atomic>
#include <string>

#include "host/spooler/spooler.hpp"
#include "host/web/http.hpp"
#include "host/web/listener.hpp"
#include "host/web/upload.hpp"

namespace web {

// The page for people, and the description of what all other routes take and answer (OpenAPI).
void add_page(Listener& server);

// /api/v1: jobs and printers.
void add_rest_routes(Listener& server, spooler::Spooler& spooler);

// What the page draws. Of /api/v1/jobs/ID: /path, /path/LAYER and /picture; of
// /api/v1/printers/NAME: /temperatures.
void add_picture_routes(Listener& server, spooler::Spooler& spooler);

// /api/v1/events: the state of everything, again at each change (server-sent events).
struct Streams {
  std::atomic<bool>& ends;  // the server stops
  std::atomic<int>& streams;  // so many are open
};
void add_event_route(Listener& server, spooler::Spooler& spooler, Streams streams);

// What slicers and clients of OctoPrint ask, for the first printer, or below /printers/NAME for
// that one.
void add_octoprint_routes(Listener& server, spooler::Spooler& spooler);

// What slicers and clients of PrusaLink ask, at the same places.
void add_prusalink_routes(Listener& server, spooler::Spooler& spooler);

// After all others: everything else is not found, and its body is not read.
void add_last_routes(Listener& server);

// A route that takes a JSON object.
using JsonHandler =
    std::function<void(const httplib::Request&, httplib::Response&, const Json& body)>;
void post(Listener& server, const std::string& pattern, JsonHandler handler);
// A route without a body.
using Handler = std::function<void(const httplib::Request&, httplib::Response&)>;
void get(Listener& server, const std::string& pattern, Handler handler);

// Routes of other servers are there twice: at the root, and below a printer's name.
inline constexpr const char* printer_prefix = "(?:/printers/([A-Za-z0-9_-]{1,32}))?";
// The printer that a request of such a route is for: the first match, or the first printer.
// Throws spooler::NoSuchPrinter.
std::string printer_of(const httplib::Request& request, const spooler::Spooler& spooler);

struct UploadedJob {
  queue::JobId id;
  UploadForm form;
};
// The form's file as a new job; `printer` may be empty.
UploadedJob take_upload(const httplib::Request& request, const httplib::Response& response,
                        const httplib::ContentReader& read, spooler::Spooler& spooler,
                        const std::string& printer);

}  // namespace web
