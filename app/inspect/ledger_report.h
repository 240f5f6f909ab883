// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/inspect/ledger_filter.h"

namespace hydroscope {

// The ledger and the life of a node, for people, for programs, and for spreadsheets.

/// Summary, patches with the reason of each, episodes; at most `most` lines of each
/// of the two tables (0: all). `name`: of the run.
std::string make_ledger_text(const Ledger& ledger, const std::vector<std::size_t>& chosen,
                             const std::string& name, int most);
std::string make_ledger_json(const Ledger& ledger, const std::vector<std::size_t>& chosen);
std::string make_ledger_csv(const Ledger& ledger, const std::vector<std::size_t>& chosen);

std::string make_life_text(const Ledger& ledger, int node, const std::string& name);
std::string make_life_json(const Ledger& ledger, int node);
std::string make_life_csv(const Ledger& ledger, int node);

}  // namespace hydroscope
