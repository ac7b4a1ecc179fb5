// SPDX-License-Identifier: Apache-2.0
// M420 and M851 as M503 reports them, the mesh, and why probing has failed.
#pragma once

#include <cstddef>

#include "host_link/text_line.hpp"
#include "motion/levelling.hpp"

namespace application {

// Of M503.
inline constexpr std::size_t levelling_reports = 2;
host_link::TextLine levelling_report(std::size_t index, const motion::Levelling& levelling,
                                     bool inches);

// Line by line as Marlin's, which plug-ins of hosts read: a title, the columns' numbers, the rows.
inline constexpr std::size_t mesh_titles = 2;
host_link::TextLine mesh_line(std::size_t index, const motion::BedMesh& mesh);

// "Error:Probing Failed at X20.00 Y30.00: not triggered ..."
host_link::TextLine probing_failure(const motion::Probing& probing);

}  // namespace application
