// SPDX-License-Identifier: Apache-2.0
// PrusaLink's routes, as far as slicers and small clients use them. `api/version` is OctoPrint's.
#include <algorithm>
#include <charconv>

#include "host/web/prusalink_answers.hpp"
#include "host/web/routes.hpp"

namespace web {

namespace {

const std::string prefix = std::string(printer_prefix) + "/api/v1/";
const std::string one_job = prefix + "job/([0-9]{1,15})";

struct Now {
  Json printer, job;  // of the snapshot; job: null where none is printed
};

Now now_of(const httplib::Request& request, spooler::Spooler& spooler) {
  const std::string name = printer_of(request, spooler);
  const auto snapshot = spooler.snapshot();
  const auto named = [](const Json& all, const char* field, const Json& value) {
    const auto found =
        std::ranges::find_if(all, [&](const Json& each) { return each.at(field) == value; });
    return found == all.end() ? Json() : *found;
  };
  Json printer = named(snapshot->json.at("printers"), "name", name);
  Json job = named(snapshot->json.at("jobs"), "id", printer.at("job"));
  return {.printer = std::move(printer), .job = std::move(job)};
}

// A boolean of a structured header field (RFC 8941).
bool is_set(const httplib::Request& request, const char* header) {
  if (request.get_header_value_count(header) > 1) {
    throw HttpError(400, std::string("the header ") + header + " stands there twice");
  }
  const std::string value = request.get_header_value(header);
  if (value.empty() || value == "?0") return false;
  if (value == "?1") return true;
  throw HttpError(400, std::string("the header ") + header + " must be ?0 or ?1");
}

bool is_there(spooler::Spooler& spooler, const std::string& name) {
  return std::ranges::contains(spooler.jobs(), name, &queue::Job::name);
}

void upload(const httplib::Request& request, httplib::Response& response,
            const httplib::ContentReader& read, spooler::Spooler& spooler) {
  if (request.matches[2] != prusalink::storage_name) {
    throw HttpError(404, "the only storage is `" + std::string(prusalink::storage_name) + "`");
  }
  if (request.has_header("Content-Range")) {
    throw HttpError(400, "a part of a file is no job: send all of it, without Content-Range");
  }
  const bool prints = is_set(request, "Print-After-Upload");
  const std::string path = request.matches[3], name = queue::cleaned_name(path);
  if (!is_set(request, "Overwrite") && is_there(spooler, name)) {
    throw HttpError(409, "there is a file of this name, and no header `Overwrite: ?1`");
  }
  queue::Store::Upload file(spooler.store());
  read_file(request, read, path, file, spooler.free_bytes());
  const std::int64_t bytes = file.bytes();
  spooler.add(file, path, !prints, request.matches[1]);
  answer(response, prusalink::uploaded(name, bytes), 201);
}

// The job of the path, which its printer has. Throws HttpError 404.
queue::JobId job_of(const httplib::Request& request, const Now& now) {
  const std::string text = request.matches[2];
  queue::JobId id = 0;
  std::from_chars(text.data(), text.data() + text.size(), id);
  if (now.job.is_null() || now.job.at("id") != id) {
    throw HttpError(404, "the printer does not print this job");
  }
  return id;
}

void pause_or_resume(const httplib::Request& request, httplib::Response& response,
                     spooler::Spooler& spooler) {
  const Now now = now_of(request, spooler);
  job_of(request, now);
  spooler.ask(now.printer.at("name"), {{"do", std::string(request.matches[3])}});
  response.status = 204;
}

void cancel(const httplib::Request& request, httplib::Response& response,
            spooler::Spooler& spooler) {
  spooler.cancel(job_of(request, now_of(request, spooler)));
  response.status = 204;
}

void add_job_routes(Listener& server, spooler::Spooler& spooler) {
  get(server, prefix + "job", [&spooler](const auto& request, auto& response) {
    const Now now = now_of(request, spooler);
    if (now.job.is_null()) {
      response.status = 204;
      return;
    }
    answer(response, prusalink::job_of(now.printer, now.job));
  });
  server.Put(one_job + "/(pause|resume)",
             [&spooler](const httplib::Request& request, httplib::Response& response,
                        const httplib::ContentReader&) {
               answer_errors_of(response, [&] { pause_or_resume(request, response, spooler); });
             });
  server.Delete(one_job, [&spooler](const httplib::Request& request, httplib::Response& response,
                                    const httplib::ContentReader&) {
    answer_errors_of(response, [&] { cancel(request, response, spooler); });
  });
}

}  // namespace

void add_prusalink_routes(Listener& server, spooler::Spooler& spooler) {
  get(server, prefix + "storage", [&spooler](const auto& request, auto& response) {
    printer_of(request, spooler);
    answer(response, prusalink::storages(spooler.disk_space()));
  });
  get(server, prefix + "info", [&spooler](const auto& request, auto& response) {
    answer(response, prusalink::info(printer_of(request, spooler)));
  });
  get(server, prefix + "status", [&spooler](const auto& request, auto& response) {
    const Now now = now_of(request, spooler);
    answer(response, prusalink::status(now.printer, now.job));
  });
  // Slicers put a slash before the storage's name or leave it out, and one behind it.
  server.Put(prefix + "files/+([^/]+)/+(.+)",
             [&spooler](const httplib::Request& request, httplib::Response& response,
                        const httplib::ContentReader& read) {
               answer_errors_of(response, [&] { upload(request, response, read, spooler); });
             });
  add_job_routes(server, spooler);
}

}  // namespace web
