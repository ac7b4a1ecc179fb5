// SPDX-License-Identifier: Apache-2.0
// The parts of report.html, in the order of the page.
#pragma once

#include "sim/report/markup.hpp"
#include "sim/report/results.hpp"

namespace report {

// The summary at the top: good or not, why, and the main figures.
void add_verdict(Page& page, const Results& results);
void add_facts(Page& page, const Results& results);
// Refused lines, missed points and underruns, with links to their time and place.
void add_problems(Page& page, const Results& results, const Courses& courses);

void add_path(Page& page, const Results& results, const Courses& courses);
void add_courses(Page& page);

void add_heaters(Page& page, const Results& results);
void add_axes(Page& page, const Results& results);
void add_messages(Page& page, const Results& results);
void add_chip(Page& page, const Results& results);

}  // namespace report
