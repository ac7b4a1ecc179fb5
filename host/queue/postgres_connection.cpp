// SPDX-License-Identifier: Apache-2.0
// Connecting with limits of time, and errors as the queue has them.
#include "host/queue/postgres_connection.hpp"

#include <libpq-fe.h>

#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "host/queue/database.hpp"

namespace queue {

namespace {

constexpr std::chrono::milliseconds retry_interval{1000};

// Where the address says nothing else: how soon a dead network is known.
constexpr std::array<std::pair<const char*, const char*>, 7> defaults{
    {{"connect_timeout", "3"},
     {"tcp_user_timeout", "6000"},
     {"keepalives_idle", "3"},
     {"keepalives_interval", "2"},
     {"keepalives_count", "2"},
     {"client_encoding", "UTF8"},
     {"application_name", "stepfabric"}}};

// The server ends what this process does not end, as where it was stopped or is away: others wait
// for it no longer than they have patience.
constexpr const char* limits =
    "SET lock_timeout = '6s'; SET statement_timeout = '7s'; "
    "SET idle_in_transaction_session_timeout = '4s'";

std::string in_quotes(std::string_view value) {
  std::string text = "'";
  for (const char c : value) {
    if (c == '\'' || c == '\\') text += '\\';
    text += c;
  }
  return text + "'";
}

std::string whole_address(const std::string& address) {
  char* error = nullptr;
  const std::unique_ptr<PQconninfoOption, decltype(&PQconninfoFree)> options(
      PQconninfoParse(address.c_str(), &error), PQconninfoFree);
  if (!options) {
    const std::string why = error == nullptr ? "no memory" : error;
    PQfreemem(error);
    throw std::runtime_error("--database: " + why);
  }
  std::map<std::string, std::string> values(defaults.begin(), defaults.end());
  for (const PQconninfoOption* each = options.get(); each->keyword != nullptr; ++each) {
    if (each->val == nullptr) continue;
    const std::string_view keyword = each->keyword;
    if (keyword == "password" || keyword == "sslpassword") {
      throw std::runtime_error(
          "--database: no password here, where every user of this machine can read it; write it "
          "into ~/.pgpass, or a file that PGPASSFILE names");
    }
    values[each->keyword] = each->val;
  }
  std::string text;
  for (const auto& [keyword, value] : values) text += keyword + "=" + in_quotes(value) + " ";
  return text;
}

// Without the line feed and the further lines that libpq gives.
std::string first_line(std::string_view text) {
  return std::string(text.substr(0, text.find('\n')));
}

bool ends_connection(const std::string& sqlstate) {
  return sqlstate.starts_with("57P") || sqlstate.starts_with("08") || sqlstate == "25P03";
}

}  // namespace

PostgresConnection::PostgresConnection(const std::string& address)
    : address_(whole_address(address)) {}

void PostgresConnection::connect() {
  if (connection_) return;
  const auto now = std::chrono::steady_clock::now();
  if (!failure_.empty() && now - failed_at_ < retry_interval) throw Unavailable(failure_);
  try {
    connection_ = std::make_unique<pqxx::connection>(address_);
    connection_->set_verbosity(pqxx::error_verbosity::terse);
  } catch (const pqxx::failure& error) {
    failed_at_ = std::chrono::steady_clock::now();
    failure_ = "the queue's database is away: " + first_line(error.what());
    throw Unavailable(failure_);
  }
  try {
    check_settings();
  } catch (...) {
    connection_.reset();
    throw;
  }
  failure_.clear();
}

void PostgresConnection::check_settings() {
  const auto shown = [this](const char* name) {
    const pqxx::result value =
        call([&](auto& work) { return work.exec(std::string("SHOW ") + name); });
    return std::string(value[0][0].view());
  };
  const std::string remedy = ": a job that was acknowledged could be lost. Switch it on";
  for (const char* setting : {"synchronous_commit", "fsync", "full_page_writes"}) {
    if (shown(setting) == "off") {
      throw std::runtime_error(std::string("the PostgreSQL server has ") + setting + " off" +
                               remedy);
    }
  }
  if (shown("server_encoding") != "UTF8") {
    throw std::runtime_error("the PostgreSQL database has another encoding than UTF8");
  }
  execute(limits);
}

pqxx::result PostgresConnection::call(
    const std::function<pqxx::result(pqxx::nontransaction&)>& work) {
  if (!connection_) throw Unavailable("the queue's database is away");
  try {
    const CallLimit::Call call(limit_, connection_->sock());
    pqxx::nontransaction nothing(*connection_);
    return work(nothing);
  } catch (const pqxx::sql_error& error) {
    const std::string state = error.sqlstate();
    if (ends_connection(state) || !connection_->is_open()) {
      connection_.reset();
      throw Unavailable("the queue's database is away: " + first_line(error.what()));
    }
    if (state == "55P03" || state == "57014") {
      throw Unavailable("the queue's database is busy: " + first_line(error.what()));
    }
    throw std::runtime_error("job database: " + first_line(error.what()));
  } catch (const pqxx::broken_connection& error) {
    connection_.reset();
    throw Unavailable("the connection to the queue's database was lost: " +
                      first_line(error.what()));
  } catch (const pqxx::failure& error) {
    connection_.reset();  // in what state it is, is not known
    throw Unavailable("the queue's database: " + first_line(error.what()));
  }
}

void PostgresConnection::execute(const std::string& sql) {
  call([&](auto& work) { return work.exec(sql); });
}

}  // namespace queue
