// SPDX-License-Identifier: Apache-2.0
// A search as bytes (CBOR), since inputs are not always text.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/worst_inputs/search.hpp"

namespace worst_inputs {

namespace {

using nlohmann::json;

json to_json(const SerialInput& input) {
  json pieces = json::array();
  for (const Piece& piece : input) {
    const json::binary_t bytes({piece.bytes.begin(), piece.bytes.end()});
    pieces.push_back({piece.pause_us, piece.waits, json(bytes)});
  }
  return pieces;
}

SerialInput input_of(const json& pieces) {
  SerialInput input;
  for (const json& piece : pieces) {
    const auto& bytes = piece.at(2).get_binary();
    input.push_back({.pause_us = piece.at(0).get<std::uint32_t>(),
                     .bytes = std::string(bytes.begin(), bytes.end()),
                     .waits = piece.at(1).get<bool>()});
  }
  return input;
}

}  // namespace

std::string Search::state() const {
  json all{{"random", breeder_.state()}, {"next", next_}, {"inputs", inputs_}};
  for (const Population& population : populations_) {
    json pools = json::array();
    for (const Pool& pool : population.pools) {
      json& worst = pools.emplace_back(json::array());
      for (const Found& found : pool) worst.push_back({found.clocks, to_json(found.input)});
    }
    all["populations"].push_back({{"inputs", population.inputs}, {"pools", pools}});
  }
  std::string bytes;
  json::to_cbor(all, bytes);
  return bytes;
}

void Search::resume(const std::string& state) try {
  const json all = json::from_cbor(state);
  const json& populations = all.at("populations");
  if (populations.size() != populations_.size()) throw std::runtime_error("it has other starts");
  for (std::size_t start = 0; start < populations_.size(); ++start) {
    Population& population = populations_[start];
    population.inputs = populations[start].at("inputs").get<std::size_t>();
    for (std::size_t task = 0; task < population.pools.size(); ++task) {
      Pool& pool = population.pools[task];
      pool.clear();
      for (const json& found : populations[start].at("pools").at(task)) {
        pool.push_back({.clocks = found.at(0).get<std::uint32_t>(),
                        .start = start,
                        .input = input_of(found.at(1))});
      }
    }
  }
  next_ = all.at("next").get<std::size_t>() % populations_.size();
  inputs_ = all.at("inputs").get<std::uint64_t>();
  breeder_.resume(all.at("random").get<std::string>());
} catch (const json::exception& error) {
  throw std::runtime_error(fmt::format("it is not the state of a search: {}", error.what()));
}

}  // namespace worst_inputs
