// SPDX-License-Identifier: Apache-2.0
// Serves the page for people, and the API's description for programs.
#include "host/web/page_files.hpp"
#include "host/web/routes.hpp"

namespace web {

void add_page(Listener& server) {
  const auto add = [&server](const char* path, std::string_view text, const char* type) {
    server.Get(path, [text, type](const httplib::Request&, httplib::Response& response) {
      response.set_content(std::string(text), type);
    });
  };
  add("/api/openapi.json", openapi, "application/json");
  add("/", page_html, "text/html; charset=utf-8");
  add("/page.css", page_style, "text/css; charset=utf-8");
  add("/page.js", page_script, "text/javascript; charset=utf-8");
}

}  // namespace web
