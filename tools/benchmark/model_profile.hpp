// SPDX-License-Identifier: Apache-2.0
// Where the time of a simulation goes: by samples of its thread, and by counts of its clocks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/benchmark/model_runs.hpp"

namespace benchmarks {

struct ProfiledWork {
  std::string name;
  std::uint32_t clock_hz{};
  Measured measured;

  std::uint64_t samples() const;
  double share(sim::Activity activity) const;  // of the samples; 0 where there are none
};

// Each work once. Throws as the runs do, and std::system_error where the system takes no samples.
std::vector<ProfiledWork> profile_model(const ModelScope& scope,
                                        const std::function<void(const std::string&)>& say);

std::string to_json(const std::vector<ProfiledWork>& works);
std::string to_table(const std::vector<ProfiledWork>& works);

}  // namespace benchmarks
