// SPDX-License-Identifier: Apache-2.0
// Which name is most easily confused with another.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/proof/vhdl_text.hpp"

namespace proof {

class NameRelatives {
 public:
  // Of the names in the expressions of a text. `constants` of other files are relatives, but get
  // none themselves.
  NameRelatives(const VhdlText& text, const std::vector<std::string>& constants);

  // The nearest relative, of equals the next one in the alphabet; nullptr where there is none.
  // Fields of records are relatives of fields only.
  const std::string* find(const std::string& name, bool is_field) const;

 private:
  std::map<std::string, std::string> families_[2];
};

}  // namespace proof
