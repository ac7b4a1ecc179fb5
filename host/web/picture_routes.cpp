// SPDX-License-Identifier: Apache-2.0
// What the page draws: paths and pictures of jobs, courses of temperatures.
#include <charconv>

#include "host/web/routes.hpp"
#include "tools/files/file_text.hpp"
#include "tools/planning/path_file.hpp"

namespace web {

namespace {

const std::string one_job = "/api/v1/jobs/([0-9]{1,15})";

template <class Number>
Number number_of(const std::string& digits) {
  Number number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

queue::JobId id_of(const httplib::Request& request) {
  return number_of<queue::JobId>(request.matches[1]);
}

std::filesystem::path path_of(const httplib::Request& request, spooler::Spooler& spooler) {
  const auto file = spooler.path_of(id_of(request));
  if (!file) {
    throw HttpError(404, "the job has no path: it is not checked yet, or extrudes nothing");
  }
  return *file;
}

}  // namespace

void add_picture_routes(Listener& server, spooler::Spooler& spooler) {
  get(server, one_job + "/path", [&spooler](const auto& request, auto& response) {
    response.set_content(planning::read_path_head(path_of(request, spooler)), "application/json");
  });
  get(server, one_job + "/path/([0-9]{1,6})", [&spooler](const auto& request, auto& response) {
    const auto layer = number_of<std::size_t>(request.matches[2]);
    auto points = planning::read_path_layer(path_of(request, spooler), layer);
    if (!points) throw HttpError(404, "the path has no such layer");
    response.set_content(std::move(*points), "application/octet-stream");
  });
  get(server, one_job + "/picture", [&spooler](const auto& request, auto& response) {
    const auto file = spooler.picture_of(id_of(request));
    if (!file) {
      throw HttpError(404, "the job has no picture: it is not checked yet, or extrudes nothing");
    }
    response.set_content(files::text_of(*file), "image/png");
  });
  get(server, "/api/v1/printers/([A-Za-z0-9_-]{1,32})/temperatures",
      [&spooler](const auto& request, auto& response) {
        answer(response, spooler.temperatures(request.matches[1]));
      });
}

}  // namespace web
