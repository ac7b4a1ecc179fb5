// SPDX-License-Identifier: Apache-2.0
// The project's own REST.
#include <charconv>

#include "host/spooler/snapshot.hpp"
#include "host/web/routes.hpp"

namespace web {

namespace {

const std::string jobs = "/api/v1/jobs";
const std::string one_job = jobs + "/([0-9]{1,15})";
const std::string one_printer = "/api/v1/printers/([A-Za-z0-9_-]{1,32})";

constexpr double longest_filament = 1e8;  // mm

queue::JobId id_of(const httplib::Request& request) {
  const std::string text = request.matches[1];
  queue::JobId id = 0;
  std::from_chars(text.data(), text.data() + text.size(), id);
  return id;
}

Json whole_job(spooler::Spooler& source, queue::JobId id) {
  const auto job = source.find(id);
  if (!job) throw queue::NoSuchJob(id);
  Json json = spooler::to_json(*job);
  json["check"] = Json::parse(job->check, nullptr, false);
  if (json["check"].is_discarded()) json["check"] = nullptr;
  json["history"] = Json::array();
  for (const queue::Change& change : source.history(id)) {
    json["history"].push_back({{"from", name_of(change.from)},
                               {"to", name_of(change.to)},
                               {"why", change.why},
                               {"time_ms", change.time_ms}});
  }
  return json;
}

void add_job_routes(Listener& server, spooler::Spooler& spooler) {
  server.Post(jobs, [&spooler](const httplib::Request& request, httplib::Response& response,
                               const httplib::ContentReader& read) {
    answer_errors_of(response, [&] {
      const auto uploaded =
          take_upload(request, response, read, spooler, request.get_param_value("printer"));
      response.set_header("Location", jobs + "/" + std::to_string(uploaded.id));
      answer(response, {{"id", uploaded.id}}, 201);
    });
  });
  get(server, one_job, [&spooler](const auto& request, auto& response) {
    answer(response, whole_job(spooler, id_of(request)));
  });
  server.Delete(one_job, [&spooler](const httplib::Request& request, httplib::Response& response,
                                    const httplib::ContentReader&) {
    answer_errors_of(response, [&] {
      spooler.remove(id_of(request));
      answer(response, Json::object());
    });
  });
  post(server, one_job + "/cancel", [&spooler](const auto& request, auto& response, const Json&) {
    spooler.cancel(id_of(request));
    answer(response, Json::object());
  });
  post(server, one_job + "/again", [&spooler](const auto& request, auto& response, const Json&) {
    answer(response, {{"id", spooler.print_again(id_of(request))}});
  });
  post(server, one_job + "/hold",
       [&spooler](const auto& request, auto& response, const Json& body) {
         spooler.set_held(id_of(request), bool_of(body, "held"));
         answer(response, Json::object());
       });
  post(
      server, one_job + "/move", [&spooler](const auto& request, auto& response, const Json& body) {
        const bool to_end = body.contains("before") && body.at("before").is_null();
        spooler.move(id_of(request), to_end ? std::nullopt : std::optional(job_of(body, "before")));
        answer(response, Json::object());
      });
}

}  // namespace

void add_rest_routes(Listener& server, spooler::Spooler& spooler) {
  get(server, "/api/v1/state", [&spooler](const auto&, auto& response) {
    response.set_content(spooler.snapshot()->text, "application/json");
  });
  add_job_routes(server, spooler);
  post(server, one_printer + "/(pause|resume|cancel|stop)",
       [&spooler](const auto& request, auto& response, const Json&) {
         spooler.ask(request.matches[1], {{"do", std::string(request.matches[2])}});
         answer(response, Json::object());
       });
  post(server, one_printer + "/send",
       [&spooler](const auto& request, auto& response, const Json& body) {
         spooler.ask(request.matches[1], {{"do", "send"}, {"line", text_of(body, "line")}});
         answer(response, Json::object());
       });
  post(server, one_printer + "/bed_clear",
       [&spooler](const auto& request, auto& response, const Json& body) {
         spooler.set_bed_clear(request.matches[1], bool_of(body, "clear"));
         answer(response, Json::object());
       });
  post(server, one_printer + "/filament",
       [&spooler](const auto& request, auto& response, const Json& body) {
         spooler.set_filament_left(request.matches[1], number_of(body, "mm", longest_filament));
         answer(response, Json::object());
       });
  post(server, one_printer + "/restart",
       [&spooler](const auto& request, auto& response, const Json&) {
         spooler.restart(request.matches[1]);
         answer(response, Json::object());
       });
}

}  // namespace web
