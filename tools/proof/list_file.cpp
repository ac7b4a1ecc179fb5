// SPDX-License-Identifier: Apache-2.0
// The lists of proofs and mutations, read completely: an entry that is not read is an error.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <toml++/toml.hpp>

#include "tools/proof/list.hpp"

namespace proof {

namespace {

// One table of the file, which knows what was read of it.
class Entry {
 public:
  Entry(const std::filesystem::path& file, const toml::node& node) : file_(file) {
    if (!node.is_table()) fail("is not a table");
    table_ = node.as_table();
    name_ = text("name");
  }

  std::string text(const std::string& key) {
    const toml::node* found = find(key);
    const auto value = found == nullptr ? std::nullopt : found->value<std::string>();
    if (!value || value->empty()) fail(key + " must be a text");
    return *value;
  }

  int whole(const std::string& key, int fallback) {
    const toml::node* found = find(key);
    if (found == nullptr) return fallback;
    const auto value = found->value<std::int64_t>();
    constexpr std::int64_t most_clocks = 1000;
    if (!found->is_integer() || *value < 1 || *value > most_clocks) {
      fail(fmt::format("{} must be a whole number from 1 to {}", key, most_clocks));
    }
    return static_cast<int>(*value);
  }

  bool flag(const std::string& key) {
    const toml::node* found = find(key);
    if (found != nullptr && !found->is_boolean()) fail(key + " must be true or false");
    return found != nullptr && *found->value<bool>();
  }

  std::vector<std::string> texts(const std::string& key) {
    std::vector<std::string> values;
    const toml::node* found = find(key);
    if (found == nullptr) return values;
    if (!found->is_array()) fail(key + " must be an array of texts");
    for (const toml::node& element : *found->as_array()) {
      if (!element.is_string()) fail(key + " must be an array of texts");
      values.push_back(*element.value<std::string>());
    }
    return values;
  }

  std::map<std::string, std::string> generics() {
    std::map<std::string, std::string> values;
    const toml::node* found = find("generics");
    if (found == nullptr) return values;
    if (!found->is_table()) fail("generics must be a table");
    for (const auto& [key, value] : *found->as_table()) {
      if (!value.is_integer()) fail("generics must be whole numbers");
      values[std::string(key.str())] = std::to_string(*value.value<std::int64_t>());
    }
    return values;
  }

  const std::filesystem::path& file() const { return file_; }
  bool has(const std::string& key) const { return table_->contains(key); }

  void finish() const {
    for (const auto& [key, value] : *table_) {
      if (!used_.contains(std::string(key.str()))) {
        fail(fmt::format("{} is not an entry that this program knows", key.str()));
      }
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: {}: {}", file_.string(), name_, what));
  }

 private:
  const toml::node* find(const std::string& key) {
    used_.insert(key);
    return table_->get(key);
  }

  std::filesystem::path file_;
  const toml::table* table_ = nullptr;
  std::string name_ = "an entry without a name";
  std::set<std::string> used_;
};

Method method_of(Entry& entry) {
  const std::string text = entry.text("by");
  for (const Method method :
       {Method::induction, Method::bounded, Method::arithmetic, Method::sighting, Method::bench}) {
    if (text == name_of(method)) return method;
  }
  entry.fail("by must be induction, bounded, arithmetic, sighting or bench");
}

Proof proof_of(Entry& entry) {
  Proof proof;
  proof.name = entry.text("name");
  proof.says = entry.text("says");
  proof.method = method_of(entry);
  proof.quick = entry.flag("quick");
  if (proof.method == Method::arithmetic) {
    proof.lemma = entry.text("lemma");
  } else if (proof.method == Method::bench) {
    proof.entity = entry.text("entity");
  } else {
    proof.entity = entry.text("entity");
    proof.generics = entry.generics();
    proof.only = entry.texts("only");
    proof.except = entry.texts("except");
    proof.free = entry.texts("free");
    for (const std::string& file : entry.texts("stand_ins")) proof.stand_ins.emplace_back(file);
    proof.free_copies = entry.texts("free_copies");
    if (!entry.has("depth")) entry.fail("depth is missing");
    proof.depth = entry.whole("depth", 1);
    if (proof.method == Method::sighting) {
      proof.signals = entry.texts("signals");
      if (proof.signals.empty() || !entry.has("values")) {
        entry.fail("signals and values say what is to be sighted");
      }
      proof.values = entry.whole("values", 1);
    }
  }
  return proof;
}

Mutation mutation_of(Entry& entry) {
  constexpr int usual_depth = 20;
  Mutation mutation;
  mutation.name = entry.text("name");
  mutation.list = entry.file();
  mutation.file = entry.text("file");
  mutation.from = entry.text("from");
  mutation.to = entry.text("to");
  mutation.proof = entry.text("proof");
  if (entry.has("property")) mutation.property = entry.text("property");
  mutation.depth = entry.whole("depth", usual_depth);
  return mutation;
}

// Appends the entries of one file.
template <typename Item>
void read(const std::filesystem::path& file, const char* key, Item (*make)(Entry&),
          std::vector<Item>& items) {
  toml::table table;
  try {
    table = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(fmt::format("{}: line {}: {}", file.string(),
                                         error.source().begin.line, error.description()));
  }
  const toml::array* entries = table[key].as_array();
  if (entries == nullptr || table.size() != 1) {
    throw std::runtime_error(
        fmt::format("{}: must hold [[{}]] and nothing else", file.string(), key));
  }
  for (const toml::node& node : *entries) {
    Entry entry(file, node);
    items.push_back(make(entry));
    entry.finish();
    const auto is_same = [&items](const Item& other) { return other.name == items.back().name; };
    if (std::ranges::count_if(items, is_same) > 1) entry.fail("stands there twice");
  }
}

// The lists in the folders of this name within the folders of `folder`.
std::vector<std::filesystem::path> lists_in(const std::filesystem::path& folder, const char* name) {
  std::vector<std::filesystem::path> files;
  for (const auto& group : std::filesystem::directory_iterator(folder)) {
    if (!is_directory(group.path() / name)) continue;
    for (const auto& file : std::filesystem::directory_iterator(group.path() / name)) {
      if (file.path().extension() == ".toml") files.push_back(file.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

const char* name_of(Method method) {
  switch (method) {
    case Method::induction:
      return "induction";
    case Method::bounded:
      return "bounded";
    case Method::arithmetic:
      return "arithmetic";
    case Method::sighting:
      return "sighting";
    case Method::bench:
      return "bench";
  }
  return "";
}

List read_list(const std::filesystem::path& folder) {
  List list;
  for (const std::filesystem::path& file : lists_in(folder, "proofs")) {
    read(file, "proof", proof_of, list.proofs);
  }
  for (const std::filesystem::path& file : lists_in(folder, "mutations")) {
    read(file, "mutation", mutation_of, list.mutations);
  }
  for (const Mutation& mutation : list.mutations) {
    if (std::ranges::find(list.proofs, mutation.name, &Proof::name) != list.proofs.end()) {
      throw std::runtime_error(
          fmt::format("{}: {} is the name of a proof", mutation.list.string(), mutation.name));
    }
    const auto is_its_proof = [&mutation](const Proof& proof) {
      const bool has_properties =
          proof.method == Method::induction || proof.method == Method::bounded;
      return proof.name == mutation.proof && mutation.property.empty() != has_properties &&
             (proof.method != Method::arithmetic ||
              mutation.file.filename() == proof.lemma.filename());
    };
    if (std::ranges::none_of(list.proofs, is_its_proof)) {
      throw std::runtime_error(
          fmt::format("{}: {}: there is no proof {} of an entity with a property to break, "
                      "and no bench, sighting or lemma of this name without one",
                      mutation.list.string(), mutation.name, mutation.proof));
    }
  }
  return list;
}

}  // namespace proof
