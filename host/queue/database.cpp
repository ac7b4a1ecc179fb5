// SPDX-License-Identifier: Apache-2.0
// What does not depend on the kind of database.
#include "host/queue/database.hpp"

namespace queue {

Statement& Statement::bind(std::int64_t value) {
  values_.emplace_back(value);
  return *this;
}

Statement& Statement::bind(double value) {
  values_.emplace_back(value);
  return *this;
}

Statement& Statement::bind(std::string_view text) {
  values_.emplace_back(std::string(text));
  return *this;
}

bool Statement::step() {
  if (next_ == 0) result_ = database_.run(sql_, values_);
  if (next_ >= result_.rows.size()) return false;
  ++next_;
  return true;
}

std::int64_t Statement::run() { return database_.run(sql_, values_).changes; }

std::int64_t Statement::integer(std::size_t column) const {
  return std::get<std::int64_t>(result_.rows.at(next_ - 1).at(column));
}

double Statement::real(std::size_t column) const {
  return std::get<double>(result_.rows.at(next_ - 1).at(column));
}

const std::string& Statement::text(std::size_t column) const {
  return std::get<std::string>(result_.rows.at(next_ - 1).at(column));
}

Transaction::Transaction(Database& database) : database_(database) { database_.begin(); }

Transaction::~Transaction() {
  if (!over_) database_.roll_back();
}

void Transaction::commit() {
  database_.commit();
  over_ = true;
}

}  // namespace queue
