// SPDX-License-Identifier: Apache-2.0
// access: the key, and what stands for it. There are no users: any name will do.
#include "host/moonraker/core.hpp"
#include "host/moonraker/method_tables.hpp"

namespace moonraker {

namespace {

constexpr const char* source = "moonraker";
constexpr const char* usual_name = "stepfabric";

Json user(const std::string& name) {
  return {{"username", name}, {"source", source}, {"created_on", 0}};
}

Json info(Core& core, const Json&, Connection* connection) {
  const bool is_trusted =
      !core.access.needs_key() || (connection != nullptr && connection->is_authorised());
  return {{"default_source", source},
          {"available_sources", {source}},
          {"login_required", core.access.needs_key()},
          {"trusted", is_trusted}};
}

Json log_in(Core& core, const Json& params, Connection* connection) {
  const std::string name = text_in(params, "username");
  std::string token;
  try {
    token = core.access.log_in(text_in(params, "password"));
  } catch (const Error& error) {
    if (error.code == 401) refuse_key(core, connection, error.what());
    throw;
  }
  if (connection != nullptr) connection->authorise();
  return {{"username", name},
          {"token", token},
          {"refresh_token", token},
          {"action", "user_logged_in"},
          {"source", source}};
}

Json refresh(Core& core, const Json& params, Connection* connection) {
  const std::string token = text_in(params, "refresh_token");
  if (!core.access.is_good(token)) refuse_key(core, connection, "Unauthorized: log in again");
  return {{"username", usual_name},
          {"token", token},
          {"source", source},
          {"action", "user_jwt_refresh"}};
}

Json log_out(Core& core, const Json& params, Connection*) {
  core.access.log_out(text_in(params, "token", ""));
  return {{"username", usual_name}, {"action", "user_logged_out"}};
}

Json present_user(Core&, const Json&, Connection*) { return user(usual_name); }
Json users(Core&, const Json&, Connection*) { return {{"users", Json::array({user(usual_name)})}}; }
Json oneshot(Core& core, const Json&, Connection*) { return core.access.new_oneshot(); }

}  // namespace

void refuse_key(Core& core, const Connection* connection, const std::string& why) {
  if (connection != nullptr) core.guard.note_wrong_key(connection->client());
  throw Error(401, why);
}

std::vector<Method> access_methods() {
  return {{"access.info", "GET", "/access/info", info, true},
          {"access.login", "POST", "/access/login", log_in, true},
          {"access.refresh_jwt", "POST", "/access/refresh_jwt", refresh, true},
          {"access.logout", "POST", "/access/logout", log_out},
          {"access.get_user", "GET", "/access/user", present_user},
          {"access.users.list", "GET", "/access/users/list", users},
          {"access.oneshot_token", "GET", "/access/oneshot_token", oneshot}};
}

}  // namespace moonraker
