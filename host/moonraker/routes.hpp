// SPDX-License-Identifier: Apache-2.0
// What Moonraker answers over HTTP.
#pragma once

#include <filesystem>
#include <string_view>

#include "host/moonraker/core.hpp"
#include "host/moonraker/rpc.hpp"
#include "host/web/http.hpp"

namespace moonraker {

// Below one of the API's names; every other path is the front end's and needs no key.
bool is_api_path(std::string_view path);

// {"error": {"code": …, "message": …}}, with the error's status.
void answer_error(httplib::Response& response, const Error& error);
// Runs `work`; what it throws becomes the answer.
void answer_errors_of(httplib::Response& response, const std::function<void()>& work);

// The HTTP form of each method, and /server/jsonrpc.
void add_routes(httplib::Server& server, Core& core, const Methods& methods);
// Uploads, downloads and removal.
void add_file_routes(httplib::Server& server, Core& core);
// After all others: the files of the folder. Throws std::runtime_error where it has no index.html.
void add_frontend(httplib::Server& server, const std::filesystem::path& folder);

}  // namespace moonraker
