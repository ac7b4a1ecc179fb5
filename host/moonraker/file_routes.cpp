// SPDX-License-Identifier: Apache-2.0
// Files in and out, and those of the front end.
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "host/moonraker/files.hpp"
#include "host/moonraker/routes.hpp"
#include "host/web/upload.hpp"

namespace moonraker {

namespace {

const std::string one_file = "/server/files/gcodes/(.+)";

void upload(Core& core, const httplib::Request& request, httplib::Response& response,
            const httplib::ContentReader& read) {
  queue::Store::Upload file(core.spooler.store());
  const web::UploadForm form =
      web::read_form(request, response, read, file, core.spooler.free_bytes(), {}, false);
  const auto field = [&](const char* name) {
    const auto found = form.fields.find(name);
    return found == form.fields.end() ? std::string() : found->second;
  };
  if (!field("root").empty() && field("root") != root) {
    throw Error(400, "the only root is `gcodes`");
  }
  if (!field("checksum").empty()) throw Error(400, "checksums of uploads are not checked here");
  const queue::JobId id = core.spooler.add(file, form.file_name, !form.prints, core.printer);
  const std::string name = queue::cleaned_name(form.file_name);
  const auto job = core.spooler.find(id);
  response.set_header("Location", "http://" + request.get_header_value("Host") +
                                      "/server/files/gcodes/" +
                                      httplib::detail::encode_query_param(name));
  web::answer(response,
              {{"item", changed_item(name, file.bytes(), job ? job->uploaded_ms : 0)},
               {"print_started", false},
               {"print_queued", form.prints},
               {"action", "create_file"}},
              201);
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

void add_file_routes(httplib::Server& server, Core& core) {
  server.Post("/server/files/upload",
              [&core](const httplib::Request& request, httplib::Response& response,
                      const httplib::ContentReader& read) {
                answer_errors_of(response, [&] { upload(core, request, response, read); });
              });
  server.Get(one_file, [&core](const httplib::Request& request, httplib::Response& response) {
    answer_errors_of(response, [&] {
      const queue::Job job = file_named(core, request.matches[1]);
      response.set_header("Content-Disposition", "attachment");
      response.set_file_content(core.spooler.store().path_of(job.file), "text/x.gcode");
    });
  });
  server.Delete(one_file, [&core](const httplib::Request& request, httplib::Response& response,
                                  const httplib::ContentReader&) {
    answer_errors_of(response, [&] {
      web::answer(response, {{"result", remove_file(core, request.matches[1])}});
    });
  });
}

void add_frontend(httplib::Server& server, const std::filesystem::path& folder) {
  std::string index;
  if (!folder.empty()) {
    if (!std::filesystem::is_regular_file(folder / "index.html") ||
        !server.set_mount_point("/", folder.string())) {
      throw std::runtime_error(folder.string() + " has no index.html: no front end");
    }
    index = text_of(folder / "index.html");
  }
  // Pages of a front end have paths of their own, and are all its index.
  server.Get(".*", [index](const httplib::Request& request, httplib::Response& response) {
    const bool is_page = request.path.find('.') == std::string::npos && !is_api_path(request.path);
    if (is_page && !index.empty()) return response.set_content(index, "text/html; charset=utf-8");
    answer_error(response, {404, is_page ? "there is no front end: --frontend FOLDER"
                                         : "there is nothing of this name"});
  });
  const auto not_found = [](const httplib::Request&, httplib::Response& response,
                            const httplib::ContentReader&) {
    answer_error(response, {404, "there is nothing of this name"});
  };
  server.Post(".*", not_found);
  server.Put(".*", not_found);
  server.Patch(".*", not_found);
  server.Delete(".*", not_found);
  server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
    if (response.body.empty()) {
      answer_error(response, {response.status, "the request cannot be answered"});
    }
  });
}

}  // namespace moonraker
