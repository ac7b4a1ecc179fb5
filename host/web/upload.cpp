// SPDX-License-Identifier: Apache-2.0
// The parts of a form, one after the other.
#include "host/web/upload.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>

namespace web {

namespace {

constexpr std::size_t longest_field = 4096;
constexpr std::size_t most_fields = 20;
constexpr std::uintmax_t space_to_leave = 64 * 1024 * 1024;

bool is_gcode(std::string name) {
  std::ranges::transform(name, name.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  constexpr std::array<std::string_view, 4> endings{".gcode", ".gco", ".g", ".nc"};
  return std::ranges::any_of(endings, [&](std::string_view end) { return name.ends_with(end); });
}

bool is_true(const std::string& value) { return value == "true" || value == "1" || value == "yes"; }

class FormReader {
 public:
  FormReader(queue::Store::Upload& upload, const UploadLimits& limits)
      : upload_(upload), limits_(limits) {}

  bool begin_part(const httplib::MultipartFormData& part) {
    finish_part();
    if (++parts_ > most_fields) return fail(400, "too many fields");
    name_ = part.name;
    is_file_ = name_ == "file" && !part.filename.empty();
    if (!is_file_) return true;
    if (!form.file_name.empty()) return fail(400, "more than one file");
    form.file_name = part.filename;
    return is_gcode(form.file_name) ||
           fail(415,
                "no G-code: the name `" + queue::cleaned_name(form.file_name) +
                    "` does not end with .gcode, .gco, .g or .nc (a name ends at a semicolon)");
  }
  bool take(const char* data, std::size_t size) {
    total_ += size;
    if (total_ > limits_.bytes) return fail(413, "the file is too long");
    if (is_file_) {
      try {
        upload_.write({data, size});
      } catch (...) {
        error_ = std::current_exception();
        return false;
      }
      return true;
    }
    if (field_.size() + size > longest_field) return fail(400, "a field is too long");
    field_.append(data, size);
    return true;
  }
  void finish_part() {
    if (!is_file_ && name_ == "print") form.prints = is_true(field_);
    field_.clear();
    name_.clear();
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

  std::size_t parts() const { return parts_; }
  const std::string& last_name() const { return name_; }

  UploadForm form;

 private:
  bool fail(int status, const std::string& why) {
    error_ = std::make_exception_ptr(HttpError(status, why));
    return false;
  }

  queue::Store::Upload& upload_;
  UploadLimits limits_;
  std::exception_ptr error_;
  std::string name_, field_;
  bool is_file_ = false;
  std::size_t total_ = 0, parts_ = 0;
};

bool has_boundary(const std::string& type) {
  constexpr std::string_view word = "boundary=";
  const std::size_t at = type.find(word);
  if (at == std::string::npos) return false;
  std::string_view value = std::string_view(type).substr(at + word.size());
  if (value.starts_with('"')) value.remove_prefix(1);
  return !value.empty() && std::string_view("\"; ").find(value.front()) == std::string_view::npos;
}

std::uintmax_t announced_length(const httplib::Request& request) {
  const std::string text = request.get_header_value("Content-Length");
  std::uintmax_t length = 0;
  std::from_chars(text.data(), text.data() + text.size(), length);
  return length;
}

}  // namespace

UploadForm read_form(const httplib::Request& request, const httplib::Response& response,
                     const httplib::ContentReader& read, queue::Store::Upload& upload,
                     std::uintmax_t free_bytes, const UploadLimits& limits) {
  if (!request.is_multipart_form_data()) throw HttpError(400, "a form with a file is expected");
  if (!has_boundary(request.get_header_value("Content-Type"))) {
    throw HttpError(400, "the Content-Type has no boundary");
  }
  const std::uintmax_t length = announced_length(request);
  if (length > limits.bytes + 64 * 1024) throw HttpError(413, "the file is too long");
  if (free_bytes < length + space_to_leave) throw HttpError(507, "the disk has no room for it");
  FormReader form(upload, limits);
  const bool whole =
      read([&form](const httplib::MultipartFormData& part) { return form.begin_part(part); },
           [&form](const char* data, std::size_t size) { return form.take(data, size); });
  form.rethrow();
  if (!whole && response.status == 413) throw HttpError(413, "the form is too long");
  if (!whole) {
    throw HttpError(400, form.parts() == 0
                             ? "no part of the form can be read: it ended early, has another "
                               "boundary, or a broken chunk or header"
                             : "the form ended early, or has a broken chunk or header after `" +
                                   form.last_name() + "`");
  }
  form.finish_part();
  if (form.form.file_name.empty()) throw HttpError(400, "the form has no file");
  if (upload.bytes() == 0) throw HttpError(400, "the file is empty");
  return form.form;
}

}  // namespace web
