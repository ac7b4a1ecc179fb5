// SPDX-License-Identifier: Apache-2.0
// Words that no register or field may have as its name, in VHDL-2008 or in C++.
#pragma once

#include <string>
#include <string_view>

namespace register_generator {

inline constexpr std::string_view reserved_words =
    " abs access after alias alignas alignof all and architecture array asm assert assume "
    "attribute auto begin block body bool break buffer bus case catch char class "
    "component concept configuration const constant context continue cover decltype "
    "default delete disconnect do double downto else elsif end entity enum exit explicit "
    "export extern fairness false file float for force friend function generate generic "
    "goto group guarded if impure in inertial inline inout int is label library linkage "
    "literal long loop map mod mutable namespace nand new next noexcept nor not null "
    "nullptr of on open operator or others out package parameter port postponed private "
    "procedure process property protected public pure range record register reject "
    "release rem report requires restrict return rol ror select sequence severity shared "
    "short signal signed sizeof sla sll sra srl static strong struct subtype switch "
    "template then this throw to transport true try type typedef typeid typename "
    "unaffected union units unsigned until use using variable virtual vmode void "
    "volatile vprop vunit wait when while with xnor xor ";

inline bool is_reserved(std::string_view word) {
  return reserved_words.contains(" " + std::string(word) + " ");
}

}  // namespace register_generator
