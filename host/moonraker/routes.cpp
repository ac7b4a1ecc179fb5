// SPDX-License-Identifier: Apache-2.0
// Parameters of query and body become those of a method.
#include "host/moonraker/routes.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "host/moonraker/versions.hpp"

namespace moonraker {

namespace {

constexpr std::array<std::string_view, 7> api_names{"/server", "/printer", "/machine",  "/access",
                                                    "/api",    "/debug",   "/websocket"};

// `name:int=5`: a text is what it says.
Json typed(const std::string& text, std::string_view type) {
  if (type == "int") return integer_in({{"value", text}}, "value", 0);
  if (type == "bool") return flag_in({{"value", text}}, "value");
  if (type == "json" || type == "float") {
    const auto value = parsed(text);
    if (!value || (type == "float" && !value->is_number())) {
      throw Error(invalid_params, "a parameter is not of its type");
    }
    return *value;
  }
  return text;
}

Json query_of(const httplib::Request& request) {
  Json params = Json::object();
  for (const auto& [name, value] : request.params) {
    if (name == "token" || name == "access_token") continue;
    const std::size_t colon = name.rfind(':');
    const std::string type = colon == std::string::npos ? "" : name.substr(colon + 1);
    params[name.substr(0, colon)] = typed(value, type);
  }
  return params;
}

// `?webhooks&print_stats=state,message`
Json objects_of(const httplib::Request& request) {
  Json objects = Json::object();
  for (const auto& [name, value] : request.params) {
    if (name == "connection_id" || name == "token") continue;
    Json fields = Json::array();
    for (std::size_t begin = 0; begin < value.size();) {
      const std::size_t end = std::min(value.find(',', begin), value.size());
      fields.push_back(value.substr(begin, end - begin));
      begin = end + 1;
    }
    objects[name] = fields.empty() ? Json() : fields;
  }
  return objects;
}

bool takes_objects(const Method& method) {
  return method.name == "printer.objects.query" || method.name == "printer.objects.subscribe";
}

Json params_of(const Method& method, const httplib::Request& request, Json body) {
  Json params;
  if (takes_objects(method)) {
    params["objects"] = objects_of(request);
    params["connection_id"] = request.get_param_value("connection_id");
  } else {
    params = query_of(request);
  }
  params.update(body);
  return params;
}

void add(httplib::Server& server, Core& core, const Methods& methods, const Method& method) {
  const std::string path(method.path);
  const auto run = [&core, &methods, &method](const httplib::Request& request,
                                              httplib::Response& response, const Json& body) {
    const Json params = params_of(method, request, body);
    web::answer(response, {{"result", methods.call(core, method, params, nullptr)}});
  };
  const auto with_body = [run](const httplib::Request& request, httplib::Response& response,
                               const httplib::ContentReader& read) {
    answer_errors_of(response, [&] { run(request, response, web::body_of(request, read)); });
  };
  if (method.verb == "POST") server.Post(path, with_body);
  if (method.verb == "DELETE") server.Delete(path, with_body);
  // A subscription changes what a connection gets: a page of another site may send GET only.
  if (method.verb == "GET" || method.name == "printer.objects.query") {
    server.Get(path, [run](const httplib::Request& request, httplib::Response& response) {
      answer_errors_of(response, [&] { run(request, response, Json::object()); });
    });
  }
}

}  // namespace

bool is_api_path(std::string_view path) {
  return std::ranges::any_of(api_names, [&](std::string_view name) {
    return path.starts_with(name) && (path.size() == name.size() || path[name.size()] == '/');
  });
}

void answer_error(httplib::Response& response, const Error& error) {
  const int status = status_of(error);
  web::answer(response,
              {{"error", {{"code", status}, {"message", error.what()}, {"traceback", ""}}}},
              status);
}

void answer_errors_of(httplib::Response& response, const std::function<void()>& work) {
  try {
    work();
  } catch (...) {
    answer_error(response, current_error());
  }
}

void add_routes(httplib::Server& server, Core& core, const Methods& methods) {
  for (const Method& method : methods.all()) {
    if (!method.path.empty()) add(server, core, methods, method);
  }
  server.Post("/server/jsonrpc",
              [&core, &methods](const httplib::Request& request, httplib::Response& response,
                                const httplib::ContentReader& read) {
                answer_errors_of(response, [&] {
                  const auto answer = methods.answer_to(core, web::body_of(request, read), nullptr);
                  web::answer(response, answer.value_or(Json::object()));
                });
              });
  // Slicers of host type OctoPrint ask this first.
  server.Get("/api/version", [](const httplib::Request&, httplib::Response& response) {
    web::answer(response,
                {{"api", "0.1"},
                 {"server", api_version_text},
                 {"text", std::string("OctoPrint (StepFabric ") + stepfabric_version + ")"}});
  });
}

}  // namespace moonraker
