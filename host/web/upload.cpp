// SPDX-License-Identifier: Apache-2.0
// The parts of a form, one after the other; or a body that is the file.
#include "host/web/upload.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>

#include "host/web/ascii.hpp"
#include "host/web/multipart.hpp"

namespace web {

namespace {

constexpr std::size_t longest_field = 4096;
constexpr std::size_t most_fields = 20;
constexpr std::uintmax_t space_to_leave = 64 * 1024 * 1024;

bool is_true(const std::string& value) { return value == "true" || value == "1" || value == "yes"; }

void require_gcode(const std::string& file_name) {
  if (is_gcode(file_name)) return;
  throw HttpError(415, "no G-code: the name `" + queue::cleaned_name(file_name) +
                           "` does not end with .gcode, .gco, .g or .nc");
}

class FormReader {
 public:
  FormReader(queue::Store::Upload& upload, const UploadLimits& limits)
      : upload_(upload), limits_(limits) {}

  // Throw HttpError.
  void begin_part(const MultipartReader::Part& part) {
    finish_part();
    if (++parts_ > most_fields) throw HttpError(400, "too many fields");
    name_ = part.name;
    is_file_ = name_ == "file" && part.file_name && !part.file_name->empty();
    if (!is_file_) return;
    if (!form.file_name.empty()) throw HttpError(400, "more than one file");
    form.file_name = *part.file_name;
    require_gcode(form.file_name);
  }
  void take(std::string_view data) {
    total_ += data.size();
    if (total_ > limits_.bytes) throw HttpError(413, "the file is too long");
    if (is_file_) return upload_.write(data);
    if (field_.size() + data.size() > longest_field) throw HttpError(400, "a field is too long");
    field_ += data;
  }
  void finish_part() {
    if (!is_file_ && name_ == "print") form.prints = is_true(field_);
    if (!is_file_ && !name_.empty() && name_ != "print") form.fields[name_] = field_;
    field_.clear();
    name_.clear();
  }
  std::size_t parts() const { return parts_; }
  const std::string& last_name() const { return name_; }

  UploadForm form;

 private:
  queue::Store::Upload& upload_;
  UploadLimits limits_;
  std::string name_, field_;
  bool is_file_ = false;
  std::size_t total_ = 0, parts_ = 0;
};

// Of the body that is announced. Throws HttpError.
void check_length(const httplib::Request& request, std::uintmax_t free_bytes,
                  const UploadLimits& limits) {
  const std::string text = request.get_header_value("Content-Length");
  std::uintmax_t length = 0;
  std::from_chars(text.data(), text.data() + text.size(), length);
  if (length > limits.bytes + 64 * 1024) throw HttpError(413, "the file is too long");
  if (free_bytes < length + space_to_leave) throw HttpError(507, "the disk has no room for it");
}

}  // namespace

bool is_gcode(const std::string& file_name) {
  const std::string name = lower(file_name);
  constexpr std::array<std::string_view, 4> endings{".gcode", ".gco", ".g", ".nc"};
  return std::ranges::any_of(endings, [&](std::string_view end) { return name.ends_with(end); });
}

UploadForm read_form(const httplib::Request& request, const httplib::Response& response,
                     const httplib::ContentReader& read, queue::Store::Upload& upload,
                     std::uintmax_t free_bytes, const UploadLimits& limits, bool prints) {
  const auto type = form_type_of(request);
  if (!type) throw HttpError(400, "a form with a file is expected");
  const auto boundary = boundary_of(*type);
  if (!boundary) throw HttpError(400, "the Content-Type has no boundary");
  check_length(request, free_bytes, limits);
  FormReader form(upload, limits);
  form.form.prints = prints;
  MultipartReader parts(
      *boundary, [&form](const MultipartReader::Part& part) { form.begin_part(part); },
      [&form](std::string_view data) { form.take(data); });
  std::exception_ptr fault;
  const bool is_read = read([&](const char* data, std::size_t size) {
    try {
      parts.take({data, size});
    } catch (...) {
      fault = std::current_exception();
    }
    return fault == nullptr;
  });
  if (fault) std::rethrow_exception(fault);
  if (!is_read && response.status == 413) throw HttpError(413, "the form is too long");
  if (!is_read || !parts.is_whole()) {
    throw HttpError(
        400, form.parts() == 0
                 ? "no part of the form can be read: it ended early, has another "
                   "boundary, or a broken chunk"
                 : "the form ended early, or has a broken chunk after `" + form.last_name() + "`");
  }
  form.finish_part();
  if (form.form.file_name.empty()) throw HttpError(400, "the form has no file");
  if (upload.bytes() == 0) throw HttpError(400, "the file is empty");
  return form.form;
}

void read_file(const httplib::Request& request, const httplib::ContentReader& read,
               const std::string& file_name, queue::Store::Upload& upload,
               std::uintmax_t free_bytes, const UploadLimits& limits) {
  if (form_type_of(request)) throw HttpError(415, "the file itself is expected, not a form");
  require_gcode(file_name);
  if (!request.has_header("Content-Length") && !request.has_header("Transfer-Encoding")) {
    throw HttpError(411, "the length of the file is missing");
  }
  check_length(request, free_bytes, limits);
  std::exception_ptr fault;
  std::size_t total = 0;
  const bool is_read = read([&](const char* data, std::size_t size) {
    try {
      total += size;
      if (total > limits.bytes) throw HttpError(413, "the file is too long");
      upload.write({data, size});
    } catch (...) {
      fault = std::current_exception();
    }
    return fault == nullptr;
  });
  if (fault) std::rethrow_exception(fault);
  if (!is_read) throw HttpError(400, "the file ended early, or has a broken chunk");
  if (upload.bytes() == 0) throw HttpError(400, "the file is empty");
}

}  // namespace web
