// SPDX-License-Identifier: Apache-2.0
// server.files: the root `gcodes`, without folders. Uploads and downloads are routes of their own.
#include "host/moonraker/files.hpp"
#include "host/moonraker/method_tables.hpp"

namespace moonraker {

namespace {

Json list(Core& core, const Json& params, Connection*) {
  const std::string wanted = text_in(params, "root", root);
  if (wanted != root) throw Error(404, "there is no root '" + wanted + "'");
  Json items = Json::array();
  for (const auto& [name, job] : files_of(core)) items.push_back(file_item(job));
  return items;
}

Json roots(Core&, const Json&, Connection*) {
  return Json::array({{{"name", root}, {"path", root}, {"permissions", permissions}}});
}

Json folder(Core& core, const Json& params, Connection*) {
  std::string path = text_in(params, "path", root);
  while (path.ends_with('/')) path.pop_back();
  if (path != root) throw Error(404, "there is no folder '" + path + "'");
  const bool is_extended = flag_in(params, "extended");
  Json files = Json::array();
  for (const auto& [name, job] : files_of(core)) {
    Json item = file_item(job);
    if (is_extended) item.update(metadata(core, job));
    files.push_back(std::move(item));
  }
  const auto space = core.spooler.disk_space();
  return {{"dirs", Json::array()},
          {"files", files},
          {"disk_usage",
           {{"total", space.capacity},
            {"used", space.capacity - space.free},
            {"free", space.available}}},
          {"root_info", {{"name", root}, {"permissions", permissions}}}};
}

Json metadata_of(Core& core, const Json& params, Connection*) {
  return metadata(core, file_named(core, text_in(params, "filename")));
}

Json thumbnails(Core& core, const Json& params, Connection*) {
  file_named(core, text_in(params, "filename"));
  return Json::array();
}

Json remove(Core& core, const Json& params, Connection*) {
  return remove_file(core, text_in(params, "path"));
}

Json move(Core& core, const Json& params, Connection*) {
  return move_file(core, text_in(params, "source"), text_in(params, "dest"));
}

Json no_folders(Core&, const Json&, Connection*) {
  throw Error(400, "files are those of jobs: they have no folders and no copies");
}

}  // namespace

std::vector<Method> file_methods() {
  return {{"server.files.list", "GET", "/server/files/list", list},
          {"server.files.roots", "GET", "/server/files/roots", roots},
          {"server.files.get_directory", "GET", "/server/files/directory", folder},
          {"server.files.post_directory", "POST", "/server/files/directory", no_folders},
          {"server.files.delete_directory", "DELETE", "/server/files/directory", no_folders},
          {"server.files.move", "POST", "/server/files/move", move},
          {"server.files.copy", "POST", "/server/files/copy", no_folders},
          {"server.files.zip", "POST", "/server/files/zip", no_folders},
          {"server.files.metadata", "GET", "/server/files/metadata", metadata_of},
          {"server.files.metascan", "POST", "/server/files/metascan", metadata_of},
          {"server.files.thumbnails", "GET", "/server/files/thumbnails", thumbnails},
          {"server.files.delete_file", "", "", remove}};
}

}  // namespace moonraker
