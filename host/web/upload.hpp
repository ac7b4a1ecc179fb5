// SPDX-License-Identifier: Apache-2.0
// A file, in a form or alone, written to the disk as it comes.
#pragma once

#include <map>
#include <string>

#include "host/queue/store.hpp"
#include "host/web/http.hpp"

namespace web {

struct UploadLimits {
  std::size_t bytes = std::size_t{1} << 30u;
};

// By the ending of its name.
bool is_gcode(const std::string& file_name);

struct UploadForm {
  std::string file_name;
  bool prints = true;  // field `print`; unchanged without one
  std::map<std::string, std::string> fields;  // all others, the last of a name
};

// Reads the fields of slicers in any order (`print`, `select`, `path`, `file`) and writes the file
// into `upload`. `response` has what httplib says of a broken body; `prints`: where no field says
// so. Throws HttpError: 400 no file or a broken form, 413 too long, 415 no G-code, 507 no space.
UploadForm read_form(const httplib::Request& request, const httplib::Response& response,
                     const httplib::ContentReader& read, queue::Store::Upload& upload,
                     std::uintmax_t free_bytes, const UploadLimits& limits = {},
                     bool prints = true);

// Writes a body that is the file itself into `upload`. Throws HttpError: 400 empty or ended early,
// 411 no length, 413 too long, 415 a form or no G-code by its name, 507 no space.
void read_file(const httplib::Request& request, const httplib::ContentReader& read,
               const std::string& file_name, queue::Store::Upload& upload,
               std::uintmax_t free_bytes, const UploadLimits& limits = {});

}  // namespace web
