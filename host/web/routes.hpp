// SPDX-License-Identifier: Apache-2.0
// What the server answers, in groups.
#pragma once

#include <atomic>
#include <string>

#include "host/spooler/spooler.hpp"
#include "host/web/http.hpp"
#include "host/web/upload.hpp"

namespace web {

// The page for people.
void add_page(httplib::Server& server);

// /api/v1: jobs and printers.
void add_rest_routes(httplib::Server& server, spooler::Spooler& spooler);

// What the page draws. Of /api/v1/jobs/ID: /path, /path/LAYER and /picture; of
// /api/v1/printers/NAME: /temperatures.
void add_picture_routes(httplib::Server& server, spooler::Spooler& spooler);

// /api/v1/events: the state of everything, again at each change (server-sent events).
struct Streams {
  std::atomic<bool>& ends;  // the server stops
  std::atomic<int>& streams;  // so many are open
};
void add_event_route(httplib::Server& server, spooler::Spooler& spooler, Streams streams);

// What slicers and clients of OctoPrint ask, for the first printer, or below /printers/NAME for
// that one.
void add_octoprint_routes(httplib::Server& server, spooler::Spooler& spooler);

// After all others: everything else is not found, and its body is not read.
void add_last_routes(httplib::Server& server);

// A route that takes a JSON object.
using JsonHandler =
    std::function<void(const httplib::Request&, httplib::Response&, const Json& body)>;
void post(httplib::Server& server, const std::string& pattern, JsonHandler handler);
// A route without a body.
using Handler = std::function<void(const httplib::Request&, httplib::Response&)>;
void get(httplib::Server& server, const std::string& pattern, Handler handler);

struct UploadedJob {
  queue::JobId id;
  UploadForm form;
};
// The form's file as a new job; `printer` may be empty.
UploadedJob take_upload(const httplib::Request& request, const httplib::Response& response,
                        const httplib::ContentReader& read, spooler::Spooler& spooler,
                        const std::string& printer);

}  // namespace web
