// SPDX-License-Identifier: Apache-2.0
// The serial conversation with the host: bytes in become lines that are accepted once and in order,
// whole reply lines go out, and no host is left in silence.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "host_link/emergency.hpp"
#include "host_link/line_numbering.hpp"
#include "host_link/line_queue.hpp"
#include "host_link/line_receiver.hpp"
#include "host_link/text_line.hpp"
#include "host_link/transmit_queue.hpp"
#include "units/quantity.hpp"

namespace host_link {

// The firmware's present activity, for the busy messages.
enum class Activity : std::uint8_t { idle, processing, paused_for_user, paused_for_input };

// Counted since the start; for reports and tests.
struct Statistics {
  std::uint32_t accepted{};  // lines put into the queue
  std::uint32_t resends{};  // Resend lines sent, repetitions included
  std::uint32_t repeats{};  // accepted lines that the host sent again: answered, not run
  std::uint32_t dropped{};  // too new or broken while a resend was awaited
  std::uint32_t refused{};  // unnumbered lines refused with a notice
  std::uint32_t withdrawn{};  // accepted lines that are not executed, but requested again
};

class HostLink {
 public:
  // From the uart, so many at most. `now` is the time of the last of the bytes.
  static constexpr std::size_t most_bytes = 2048;
  void receive(std::span<const char> bytes, units::Milliseconds now);
  // Something was lost between the bytes received so far and the next, which is received right
  // after this call, at the same time: the line that it belongs to is broken.
  void receive_fault(units::Milliseconds now);
  // The host has disconnected, and the next byte is from another one: an incomplete line is
  // discarded, and no answer is due.
  void hang_up();

  // In place of receive() after a fault that has ended everything: whether M999 is among these
  // lines. Nothing else of them is acted on or answered.
  bool restart_requested(std::span<const char> bytes);

  // To the uart: the oldest bytes that lie in one piece; sent() drops the first `count` of them.
  std::span<const char> to_send() const { return transmit_.front(); }
  void sent(std::size_t count) { transmit_.drop(count); }

  // The oldest accepted line, if none is in hand. It stays in hand, and its text valid, until
  // finished(). The text may be empty (a numbered comment): only its ok is due.
  std::optional<AcceptedLine> next_line();

  // Sends the ok of the line in hand, followed by `report` (" T:20.00 ..." of M105). False if there
  // is no room yet: nothing is sent then, the line stays in hand, call again after the next update.
  bool finished(std::string_view report = {});

  // The line in hand is no command, though its checksum is right: it was damaged twice, or the host
  // means it so. A numbered one is requested again once, and so are the lines after it; it is then
  // no longer in hand and wants no ok. False where it is to be answered.
  bool ask_again();

  static constexpr std::size_t most_queries = 4;
  // That were owed and are sent at a time; others follow with the next update.
  static constexpr std::size_t most_oks = 2;
  // The code of the oldest query (M105, M114, M115) that is answered before the lines that wait:
  // each while the user is waited for, since its host may be one that has just come; and M105 from
  // a person in the middle of a job.
  std::optional<std::uint8_t> query() const;
  // For any of them, without which none is begun.
  bool has_room_for_answer() const { return transmit_.room() >= 2 * TextLine::capacity; }
  // Sends its ok; as finished().
  bool query_answered(std::string_view report = {});

  // Queues one reply line; the line end is added, bytes that a host cannot read become '?'. False
  // if there is no room yet: nothing is sent then.
  bool say(std::string_view line);

  // To be called often (every few milliseconds): time-outs, busy messages, replies that had
  // no room. True if replies were owed.
  bool update(units::Milliseconds now, Activity activity);

  // A command that must not wait in the queue, once for each reception. Its line is queued as well
  // (marked as acted on), since the host waits for its ok.
  std::optional<EmergencyCommand> emergency() { return emergencies_.next(); }

  // Motion is under way: if a job with numbered lines is, it lasts as long as that, and some
  // seconds longer.
  void work_goes_on();

  // While a line waits the host hears something this often at least, until M113 sets another one:
  // a busy message, if nothing else. It comes such a part of that before its time, since passes of
  // the loop and the line take some.
  static constexpr units::Milliseconds longest_silence{2000};
  static constexpr std::int64_t busy_lead_part = 2;
  static constexpr units::Milliseconds busy_lead{longest_silence.count() / busy_lead_part};
  static constexpr std::size_t longest_busy_message = 28;  // with its end

  // M113. Zero turns the busy messages off.
  void set_busy_interval(units::Milliseconds interval) { busy_interval_ = interval; }
  // Accepted lines that are not yet answered, the one in hand included.
  std::size_t waiting_lines() const { return queue_.waiting(); }
  // "ok N<line> P<free planner places> B<free line places>" instead of "ok".
  void set_advanced_ok(bool on) { advanced_ok_ = on; }
  void set_planner_space(std::uint8_t free_places) { planner_space_ = free_places; }

  // When the last byte came from the host.
  units::Milliseconds last_heard() const { return last_heard_; }
  const Statistics& statistics() const { return statistics_; }
  // Of the lines counted as accepted, the last LineQueue::capacity.
  const LineQueue::Slot* accepted_lines() const { return queue_.slots(); }

 private:
  // Sent to the host about lines that are answered but not executed. They are counted, so that no
  // answer is lost while the transmit queue is full.
  enum class Notice : std::uint8_t { too_long, corrupted, unfinished, queue_full, awaiting_resend };
  static constexpr std::size_t notice_count = 5;
  static std::string_view describe(Notice notice);

  void handle(ReceivedLine line);
  void handle_plain(const ReceivedLine& line, bool emergency);
  void handle_framed(const ReceivedLine& line, bool emergency);
  void framed_line_has_come();
  void handle_framed_unfinished(const ReceivedLine& line);
  void accept(const ReceivedLine& line, bool emergency);
  bool answer_ahead(const ReceivedLine& line);
  bool in_numbered_session() const;
  bool comes_from_a_person(const ReceivedLine& line) const;
  bool job_under_way() const;

  void answer_ok(std::optional<LineNumber> number);
  void notify(Notice notice);
  void request_resend(LineError error);
  void drop_owed_resend();
  void drop_withdrawn();
  bool put_ok(std::optional<LineNumber> number, std::string_view report);
  bool put_notice(std::size_t index);
  bool put_resend();
  bool send_owed();

  void end_unfinished_line();
  void give_up_old_line(units::Milliseconds now);
  void rescue_waiting_host(Activity activity);
  void keep_alive(Activity activity);

  LineReceiver receiver_;
  LineNumbering numbering_;
  LineQueue queue_;
  TransmitQueue transmit_;
  EmergencyQueue emergencies_;
  Statistics statistics_;

  units::Milliseconds now_{};
  units::Milliseconds last_heard_{};
  units::Milliseconds last_framed_{};
  units::Milliseconds last_of_job_{};
  units::Milliseconds last_exchange_{};  // a byte in, or an ok or Resend out
  units::Milliseconds last_busy_{};
  units::Milliseconds busy_interval_{longest_silence};

  std::array<std::uint8_t, notice_count> notices_owed_{};
  std::uint8_t oks_owed_{};
  bool resend_owed_{};
  bool owes_{};  // any of these
  bool wait_for_room_{};  // that Resend is due to a full queue
  LineError error_owed_{LineError::none};
  std::uint8_t rescues_left_{};
  std::uint8_t planner_space_{};
  bool framed_seen_{};
  bool advanced_ok_{};
  bool paused_{};  // the user is waited for
  std::uint8_t query_count_{};
  std::array<std::uint8_t, most_queries> queries_{};  // their codes; more wait as other lines do
  bool in_hand_{};
};

static_assert(sizeof(HostLink) <= 4096, "all of the link's memory");

}  // namespace host_link
