// SPDX-License-Identifier: Apache-2.0
// OctoPrint's routes, as far as slicers and small clients use them.
#include <cctype>
#include <cmath>
#include <string_view>

#include "host/web/octoprint_answers.hpp"
#include "host/web/routes.hpp"

namespace web {

namespace {

// Some clients join address and path with two slashes.
const std::string prefix = std::string(printer_prefix) + "//?api/";

octoprint::View view_of(const httplib::Request& request, spooler::Spooler& spooler) {
  return octoprint::view_of(spooler.snapshot()->json, printer_of(request, spooler));
}

// For a URL.
std::string encoded(const std::string& name) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '.' || c == '-' || c == '_') {
      text += c;
    } else {
      text += {'%', digits[byte >> 4u], digits[byte & 15u]};
    }
  }
  return text;
}

void answer_nothing(httplib::Response& response) { response.status = 204; }

void upload(const httplib::Request& request, httplib::Response& response,
            const httplib::ContentReader& read, spooler::Spooler& spooler) {
  const auto uploaded = take_upload(request, response, read, spooler, request.matches[1]);
  const std::string name = queue::cleaned_name(uploaded.form.file_name);
  const std::string location =
      "http://" + request.get_header_value("Host") + request.path + "/" + encoded(name);
  response.set_header("Location", location);
  answer(response,
         {{"files",
           {{"local",
             {{"name", name},
              {"path", name},
              {"origin", "local"},
              {"refs", {{"resource", location}}}}}}},
          {"done", true},
          {"effectiveSelect", uploaded.form.prints},
          {"effectivePrint", uploaded.form.prints},
          {"job", uploaded.id}},
         201);
}

void do_job_command(const std::string& printer, const Json& body, spooler::Spooler& spooler,
                    const octoprint::View& view) {
  const std::string command = text_of(body, "command");
  std::string wish = command;
  if (command == "pause") {
    wish = "toggle";
    if (body.contains("action")) wish = text_of(body, "action");
    if (wish == "toggle") wish = view.is_paused() ? "resume" : "pause";
  } else if (command != "cancel") {
    throw HttpError(409, "jobs start by themselves, in the order of the queue");
  }
  if (wish != "pause" && wish != "resume" && wish != "cancel") {
    throw HttpError(400, "no such action");
  }
  spooler.ask(printer, {{"do", wish}});
}

void do_printer_command(const std::string& printer, const Json& body, spooler::Spooler& spooler) {
  const Json lines =
      body.contains("commands") ? body.at("commands") : Json::array({text_of(body, "command")});
  for (const Json& line : lines) {
    spooler.ask(printer, {{"do", "send"}, {"line", line.get<std::string>()}});
  }
}

// In whole degrees; a target of 0 switches the heater off.
std::string target_line(const char* code, const Json& target) {
  constexpr double most = 500;  // the firmware knows its own limits
  if (!target.is_number() || !(target >= 0 && target <= most)) {
    throw HttpError(400, "the target must be 0 to 500 °C");
  }
  return code + (" S" + std::to_string(std::lround(target.get<double>())));
}

void set_target(const std::string& printer, const Json& body, spooler::Spooler& spooler,
                bool of_bed) {
  if (text_of(body, "command") != "target") throw HttpError(400, "the only command is `target`");
  std::string line;
  if (of_bed) {
    const Json offset = body.value("offset", Json(0));
    if (offset != 0) throw HttpError(400, "there are no offsets");
    line = target_line("M140", body.at("target"));
  } else {
    line = target_line("M104", body.at("targets").at("tool0"));
  }
  spooler.ask(printer, {{"do", "send"}, {"line", line}});
}

void add_heater_routes(Listener& server, spooler::Spooler& spooler) {
  for (const bool of_bed : {true, false}) {
    post(server, prefix + (of_bed ? "printer/bed" : "printer/tool"),
         [&spooler, of_bed](const auto& request, auto& response, const Json& body) {
           set_target(printer_of(request, spooler), body, spooler, of_bed);
           answer_nothing(response);
         });
  }
}

void add_answers(Listener& server) {
  for (const auto& [name, json] : octoprint::fixed_answers()) {
    get(server, prefix + name, [json](const auto&, auto& response) { answer(response, json); });
  }
  post(server, prefix + "login",
       [](const auto&, auto& response, const Json&) { answer(response, octoprint::user()); });
}

}  // namespace

void add_octoprint_routes(Listener& server, spooler::Spooler& spooler) {
  add_answers(server);
  server.Post(prefix + "files/local",
              [&spooler](const httplib::Request& request, httplib::Response& response,
                         const httplib::ContentReader& read) {
                answer_errors_of(response, [&] { upload(request, response, read, spooler); });
              });
  get(server, prefix + "files(?:/local)?", [&spooler](const auto&, auto& response) {
    answer(response, octoprint::files(spooler.jobs(), spooler.free_bytes()));
  });
  get(server, prefix + "job", [&spooler](const auto& request, auto& response) {
    answer(response, view_of(request, spooler).job());
  });
  get(server, prefix + "printer", [&spooler](const auto& request, auto& response) {
    const auto view = view_of(request, spooler);
    if (!view.is_operational()) throw HttpError(409, "Printer is not operational");
    answer(response, view.printer());
  });
  get(server, prefix + "connection", [&spooler](const auto& request, auto& response) {
    answer(response, view_of(request, spooler).connection());
  });
  post(server, prefix + "job", [&spooler](const auto& request, auto& response, const Json& body) {
    do_job_command(printer_of(request, spooler), body, spooler, view_of(request, spooler));
    answer_nothing(response);
  });
  post(server, prefix + "printer/command",
       [&spooler](const auto& request, auto& response, const Json& body) {
         do_printer_command(printer_of(request, spooler), body, spooler);
         answer_nothing(response);
       });
  add_heater_routes(server, spooler);
  post(server, prefix + "connection", [](const auto&, auto& response, const Json& body) {
    if (text_of(body, "command") != "connect") {
      throw HttpError(409, "the feeder keeps the connection");
    }
    answer_nothing(response);
  });
}

}  // namespace web
